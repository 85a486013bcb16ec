/*
 * Lesson 9's benchmark: from simple_draw() to the pipeline; how a shader is called, and by how many
 * threads.
 *
 * All versions draw the same four busts, one behind another, and are judged by the same exact
 * picture: what is visible decided by whole numbers and double, its colours found in long double.
 */
#define LESSON "../step09_shaders/main.c"
#include "lesson.h"

#include "bench/bench.h"
#include "files/normals.h"
#include "oracle/oracle.h"
#include "oracle/texels.h"

#include <stdlib.h>
#include <string.h>

enum { SIDE = 800, BUSTS = 4, VALUES = 3, INTENSITY = 2 /* of u, v, intensity */ };

static struct {
    struct model model;
    struct uniforms uniforms;
    struct draw_call call;
    struct image image, exact;    /* BGRA, black where nothing is */
    struct pipeline pipelines[2]; /* with one thread, and with two */
    /* What simple_draw() and visible_draw() draw with. */
    double depth[SIDE * SIDE];
    uint32_t nearest[SIDE * SIDE];
    struct kept_face *kept;
    bool drawn; /* by the last version, without running out of memory */
} work;

/* ---- The versions ---- */

/* A call for every few pixels: the shader without the loops that are compiled for it. Its functions
 * are called through pointers, and nothing of it can be kept in registers. */
static struct shader attempt_called(const struct shader *shader) {
    struct shader called = *shader;
    called.shade = NULL;
    return called;
}

/* simple_draw(); visible_draw() in one band, and in bands; the pipeline, which calls the shader for
 * several pixels, or doesn't. */
enum { SIMPLE, ONE_BAND, BANDS, CALLED, VISIBLE };

static bool draw_by_pipeline(int kind, struct pipeline *p) {
    struct error error;
    struct shader called = attempt_called(&gouraud_textured);
    const struct shader *shader = kind == CALLED ? &called : &gouraud_textured;
    pipeline_clear(p);
    return pipeline_draw(p, &work.call, shader, &work.uniforms, sizeof work.uniforms, &error) &&
           pipeline_finish(p, &work.image, &error);
}

static void run(struct bench_choice choice) {
    const size_t pixels = (size_t)SIDE * SIDE;
    const struct canvas canvas = {&work.image, work.depth};
    memset(work.image.pixels, 0, pixels * IMAGE_BGRA);
    if (choice.way > BANDS) {
        work.drawn = draw_by_pipeline(choice.way, &work.pipelines[choice.on]);
        return;
    }
    work.drawn = true;
    if (choice.way == SIMPLE) {
        depth_clear(work.depth, pixels);
        simple_draw(&canvas, &work.call, &simple_gouraud_textured, &work.uniforms);
        return;
    }
    const struct band band = {
        {0, choice.way == BANDS ? BAND_ROWS : SIDE}, SIDE, work.depth, work.nearest};
    size_t count = keep_faces(&canvas, &work.call, work.kept);
    visible_draw(&canvas, band, work.kept, (uint32_t)count, &simple_gouraud_textured,
                 &work.uniforms);
}

/* The mean difference of the channels of all pixels that either picture shows. */
static double error_of(struct bench_choice choice) {
    double sum = 0, count = 0;
    (void)choice;
    for (size_t i = 0; i < (size_t)SIDE * SIDE; i++) {
        const uint8_t *a = work.image.pixels + i * IMAGE_BGRA;
        const uint8_t *b = work.exact.pixels + i * IMAGE_BGRA;
        for (int k = 0; k < 3; k++) {
            sum += abs(a[k] - b[k]);
        }
        count += (a[0] | a[1] | a[2] | b[0] | b[1] | b[2]) != 0 ? 3 : 0;
    }
    return work.drawn ? sum / count : (double)INFINITY;
}

/* ---- The exact picture ---- */

/* A face on the screen, and what its corners hand over. */
struct seen {
    struct fixed2 corner[3];
    struct edges edges;
    double depth[3], recip_w[3], value[VALUES][3];
};

/* False where it is not seen from in front. */
static bool make_face(struct seen *seen, size_t face) {
    for (size_t i = 0; i < 3; i++) {
        struct vec4 clip = mat4_point(&work.call.to_clip, model_position(&work.model, face, i));
        double recip_w = 1 / clip.w, varyings[VALUES];
        struct vec2 screen = {(clip.x * recip_w + 1) * SIDE / 2, (clip.y * recip_w + 1) * SIDE / 2};
        gouraud_textured_vertex(&work.uniforms, face, i, varyings);
        for (int k = 0; k < VALUES; k++) {
            seen->value[k][i] = varyings[k];
        }
        seen->recip_w[i] = recip_w;
        seen->depth[i] = clip.z * recip_w;
        if (!(clip.w > 0) || !screen_snap(screen, &seen->corner[i])) {
            return false;
        }
    }
    return edges_setup(&seen->edges, seen->corner[0], seen->corner[1], seen->corner[2], SIDE,
                       SIDE) &&
           !seen->edges.clockwise;
}

/* The light of the face at a pixel. */
static void exact_pixel(const struct seen *face, int x, int y) {
    const struct texture_level *level = &work.uniforms.diffuse->level[work.uniforms.diffuse_level];
    long double at[VALUES];
    for (int k = 0; k < VALUES; k++) {
        at[k] = oracle_interpolate(face->corner, face->recip_w, face->value[k], x, y);
    }
    uint8_t *pixel = work.exact.pixels + IMAGE_BGRA * ((size_t)y * SIDE + (size_t)x);
    struct real3 rgb = real3_bilinear(level, at[0], at[1]);
    pixel[0] = level_from_real(rgb.z * at[INTENSITY]);
    pixel[1] = level_from_real(rgb.y * at[INTENSITY]);
    pixel[2] = level_from_real(rgb.x * at[INTENSITY]);
}

/* Each face over those that are farther. */
static void draw_exactly(void) {
    depth_clear(work.depth, (size_t)SIDE * SIDE);
    for (size_t i = 0; i < work.model.face_count; i++) {
        struct seen face;
        if (!make_face(&face, i)) {
            continue;
        }
        for (int y = face.edges.y_begin; y < face.edges.y_end; y++) {
            struct span span = edges_span(&face.edges, y);
            for (int x = span.begin; x < span.end; x++) {
                struct vec3 w = edges_weights(&face.edges, x, y);
                double depth = interpolate_depth(w, face.depth[0], face.depth[1], face.depth[2]);
                if (depth > work.depth[y * SIDE + x]) {
                    work.depth[y * SIDE + x] = depth;
                    exact_pixel(&face, x, y);
                }
            }
        }
    }
}

/* ---- Setting up ---- */

/* Make the model a row of `count` copies of itself, moved by `offset` each, the farthest first. */
static void repeat_model(struct model *model, size_t count, struct vec3 offset) {
    size_t positions = model->position_count, faces = model->face_count;
    struct vec3 *all = bench_memory(count * positions, sizeof *all);
    struct face *all_faces = bench_memory(count * faces, sizeof *all_faces);
    for (size_t i = 0; i < count * positions; i++) {
        struct vec3 by = vec3_scale(offset, (double)(count - 1 - i / positions));
        all[i] = vec3_add(model->positions[i % positions], by);
    }
    for (size_t i = 0; i < count * faces; i++) {
        all_faces[i] = model->faces[i % faces];
        for (int k = 0; k < 3; k++) {
            all_faces[i].corner[k].position += (uint32_t)(i / faces * positions);
        }
    }
    free(model->positions);
    free(model->faces);
    model->positions = all;
    model->faces = all_faces;
    model->position_count = count * positions;
    model->face_count = count * faces;
}

/* The scenes' camera. */
static bool make_busts(struct error *error) {
    static const struct vec3 backwards = {-0.35, -0.1, -0.9};
    struct model *model = &work.model;
    if (!model_read(model, BENCH_MODEL("bust.obj"), error)) {
        return false;
    }
    repeat_model(model, BUSTS, backwards);
    struct drawing drawing = {
        .model = model,
        .diffuse = model_texture(model, MODEL_DIFFUSE, error),
        .eye = {1, 0.5, 3},
        .up = {0, 1, 0},
        .light = {1, 1, 1},
    };
    if (drawing.diffuse == NULL || !model_need_normals(model, error)) {
        return false;
    }
    work.uniforms = make_uniforms(&drawing, SIDE);
    work.call = pipeline_call(&drawing, grid_cell(SIDE, SIDE, 1, 1, 0, 0), 0.85, CULL_BACK);
    return true;
}

static bool setup(struct error *error) {
    if (!make_busts(error) || !image_create(&work.image, SIDE, SIDE, IMAGE_BGRA, error) ||
        !image_create(&work.exact, SIDE, SIDE, IMAGE_BGRA, error)) {
        return false;
    }
    for (size_t i = 0; i < 2; i++) {
        if (!pipeline_create(&work.pipelines[i], SIDE, SIDE, error)) {
            return false;
        }
        pipeline_use_threads(&work.pipelines[i], i + 1);
    }
    work.kept = bench_memory(work.model.face_count, sizeof *work.kept);
    draw_exactly();
    return true;
}

/* ---- The panels ---- */

static const struct bench_version stage_versions[] = {
    VERSION("9a: simple_draw()", SIMPLE), VERSION("9d: visible first", ONE_BAND),
    VERSION("9d: in bands", BANDS),       VERSION("several pixels at once", CALLED),
    HOUSE_VERSION("no call", VISIBLE),    HOUSE_VERSION_OF(NULL, "2 threads", VISIBLE, 1),
};

/* The house's error: a level in a thousand that is not the nearest. */
static const struct bench_panel bench_panels[] = {
    {.title = "From your draw() to the pipeline: four busts one behind another, textured",
     .error_label = "values of 0..255, mean",
     .time_label = "ms per frame",
     .against = "long double",
     .run = run,
     .error = error_of,
     BENCH_VERSIONS(stage_versions),
     .house_within = 0.001},
};

const struct bench_lesson bench_step09 =
    BENCH_LESSON("step09_shaders", "Lesson 9: shaders", setup, bench_panels);
