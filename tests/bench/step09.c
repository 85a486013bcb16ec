/*
 * Step 9: how a shader is called, what is shaded, and by how many threads.
 *
 * All versions must draw the same bytes. The error is the number of pixels that differ from a
 * picture drawn in the most patient way: one thread, everything shaded as it comes, a call
 * through a pointer for every pixel.
 */
#define main step09_main
int step09_main(int argc, char **argv);
#include "../../step09_shaders/main.c"
#undef main

#include "../../step09_shaders/attempts.h"

#include "bench.h"

#include <stdlib.h>
#include <string.h>
#ifdef _OPENMP
#include <omp.h>
#endif

enum { SIDE = 800, ROW_OF_BUSTS = 4 };

/* A model, and the patient picture of it. */
struct subject {
    struct model model;
    const struct shader *shader;
    struct uniforms uniforms;
    struct draw_call call;
    struct image right;
};

struct work {
    struct subject bust, row; /* of busts, the farthest first */
    struct pipeline pipeline;
    struct image image;
};

/* ---- The versions ---- */

enum way { CALL_PER_PIXEL, CALL_PER_RUN, SPECIALISED, AT_ONCE, VISIBLE, PATIENT, WAYS };

/* The bust is drawn by shader gouraud, which does little for a pixel, so that a call shows; the
 * row of busts by gouraud_textured. The picture was cleared before. */
static bool draw_in_way(struct work *work, const struct subject *subject, enum way way) {
    struct error error;
    struct pipeline *p = &work->pipeline;
    const struct draw_call *call = &subject->call;
    const struct uniforms *u = &subject->uniforms;
    struct image *image = &work->image;
    switch (way) {
    case CALL_PER_PIXEL:
        return attempt_1_call_per_pixel(p, call, &gouraud, u, image, &error);
    case CALL_PER_RUN:
        return attempt_2_call_per_run(p, call, &gouraud, u, image, &error);
    case SPECIALISED:
        return pipeline_draw(p, call, &gouraud, u, image, &error);
    case AT_ONCE:
        return attempt_3_shade_at_once(p, call, u, image, &error);
    case VISIBLE:
        return pipeline_draw(p, call, &gouraud_textured, u, image, &error);
    default:
        p->skip = false;
        bool done = attempt_1_call_per_pixel(p, call, subject->shader, u, image, &error);
        p->skip = true;
        return done;
    }
}

/* How many threads the frame of the benchmark has; then `wanted` of them until restored. */
static int set_threads(int wanted) {
#ifdef _OPENMP
    int before = omp_get_max_threads();
    omp_set_num_threads(wanted);
    return before;
#else
    return wanted;
#endif
}

#define CHOICE(way, threads) ((int)(way) + (int)WAYS * (threads))

/* Clear, and draw the whole subject. False when memory ran out. */
static bool draw_subject(struct work *work, const struct subject *subject, int choice) {
    int threads = set_threads(choice / WAYS);
    pipeline_clear(&work->pipeline);
    memset(work->image.pixels, 0, (size_t)SIDE * SIDE * IMAGE_BGR);
    bool done = draw_in_way(work, subject, (enum way)(choice % WAYS));
    set_threads(threads);
    return done;
}

static double subject_error(struct work *work, const struct subject *subject, int choice) {
    size_t different = 0;
    if (!draw_subject(work, subject, choice)) {
        return (double)INFINITY;
    }
    for (size_t i = 0; i < (size_t)SIDE * SIDE; i++) {
        different +=
            memcmp(work->image.pixels + 3 * i, subject->right.pixels + 3 * i, IMAGE_BGR) != 0;
    }
    return (double)different;
}

/* ---- Setting up ---- */

/* Make the model a row of `count` copies of itself, moved by `offset` each, the last copy first. */
static bool repeat_model(struct model *model, size_t count, struct vec3 offset,
                         struct error *error) {
    size_t positions = model->position_count, faces = model->face_count;
    struct vec3 *moved = malloc(count * positions * sizeof *moved);
    struct face *all = malloc(count * faces * sizeof *all);
    if (moved == NULL || all == NULL) {
        free(moved);
        free(all);
        return error_out_of_memory(error);
    }
    for (size_t copy = 0; copy < count; copy++) {
        struct vec3 by = vec3_scale(offset, (double)(count - 1 - copy));
        for (size_t i = 0; i < positions; i++) {
            moved[copy * positions + i] = vec3_add(model->positions[i], by);
        }
        for (size_t i = 0; i < faces; i++) {
            struct face face = model->faces[i];
            for (int k = 0; k < 3; k++) {
                face.corner[k].position += (uint32_t)(copy * positions);
            }
            all[copy * faces + i] = face;
        }
    }
    free(model->positions);
    free(model->faces);
    model->positions = moved;
    model->faces = all;
    model->position_count = count * positions;
    model->face_count = count * faces;
    return true;
}

/* The scenes' camera, and the patient picture. */
static bool prepare_subject(struct work *work, struct subject *subject, const struct shader *shader,
                            struct error *error) {
    struct drawing drawing = {
        .model = &subject->model,
        .diffuse = model_texture(&subject->model, MODEL_DIFFUSE, error),
        .eye = {1, 0.5, 3},
        .up = {0, 1, 0},
        .light = {1, 1, 1},
    };
    if (drawing.diffuse == NULL || !model_need_normals(&subject->model, error)) {
        return false;
    }
    subject->uniforms = make_uniforms(&drawing, SIDE);
    subject->shader = shader;
    subject->call = pipeline_call(&drawing, grid_cell(SIDE, SIDE, 1, 1, 0, 0), 0.85, CULL_BACK);
    if (!draw_subject(work, subject, CHOICE(PATIENT, 1))) {
        return error_out_of_memory(error);
    }
    return image_copy(&subject->right, &work->image, error);
}

static bool setup(void **state, struct error *error) {
    static const struct vec3 backwards = {-0.35, -0.1, -0.9};
    struct work *work = calloc(1, sizeof *work);
    *state = work;
    if (work == NULL) {
        return error_out_of_memory(error);
    }
    return image_create(&work->image, SIDE, SIDE, IMAGE_BGR, error) &&
           pipeline_create(&work->pipeline, SIDE, SIDE, error) &&
           bench_read_model(&work->bust.model, "bust.obj", error) &&
           bench_read_model(&work->row.model, "bust.obj", error) &&
           repeat_model(&work->row.model, ROW_OF_BUSTS, backwards, error) &&
           prepare_subject(work, &work->bust, &gouraud, error) &&
           prepare_subject(work, &work->row, &gouraud_textured, error);
}

static void teardown(void *state) {
    struct work *work = state;
    if (work != NULL) {
        model_free(&work->bust.model);
        model_free(&work->row.model);
        image_free(&work->bust.right);
        image_free(&work->row.right);
        image_free(&work->image);
        pipeline_free(&work->pipeline);
    }
    free(work);
}

/* ---- The panels ---- */

static void run_bust(void *state, int choice) {
    struct work *work = state;
    draw_subject(work, &work->bust, choice);
}

static double error_bust(void *state, int choice) {
    struct work *work = state;
    return subject_error(work, &work->bust, choice);
}

static void run_row(void *state, int choice) {
    struct work *work = state;
    draw_subject(work, &work->row, choice);
}

static double error_row(void *state, int choice) {
    struct work *work = state;
    return subject_error(work, &work->row, choice);
}

#define BUST(label, way, threads, house)                                                           \
    {                                                                                              \
        .name = (label), .choice = CHOICE(way, threads), .is_house = (house), .run = run_bust,     \
        .error = error_bust                                                                        \
    }
#define ROW(label, way, threads, house)                                                            \
    {                                                                                              \
        .name = (label), .choice = CHOICE(way, threads), .is_house = (house), .run = run_row,      \
        .error = error_row                                                                         \
    }

static const struct bench_version call_versions[] = {
    BUST("a call for every pixel", CALL_PER_PIXEL, 1, false),
    BUST("a call for every run", CALL_PER_RUN, 1, false),
    BUST("specialised: the pipeline", SPECIALISED, 1, true),
};

static const struct bench_version shade_versions[] = {
    ROW("shaded at once, 1 thread", AT_ONCE, 1, false),
    ROW("visible only, 1 thread", VISIBLE, 1, true),
#ifdef _OPENMP
    ROW("shaded at once, 2 threads", AT_ONCE, 2, false),
    ROW("visible only, 2 threads", VISIBLE, 2, true),
#endif
};

static const struct bench_panel bench_panels[] = {
    {.title = "The bust, Gouraud, 800x800 pixels, 1 thread",
     .error_label = "pixels that differ, of 640,000",
     .time_label = "ms per frame",
     .against = "the most patient drawing",
     .versions = call_versions,
     .version_count = sizeof call_versions / sizeof call_versions[0]},
    {.title = "Four busts in a row, the farthest first, textured",
     .error_label = "pixels that differ, of 640,000",
     .time_label = "ms per frame",
     .against = "the most patient drawing",
     .versions = shade_versions,
     .version_count = sizeof shade_versions / sizeof shade_versions[0]},
};

const struct bench_lesson bench_step09 = {
    .step = "step09_shaders",
    .title = "Step 9: shaders",
    .setup = setup,
    .teardown = teardown,
    .panels = bench_panels,
    .panel_count = sizeof bench_panels / sizeof bench_panels[0],
};
