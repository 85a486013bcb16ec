/* What shortcuts are worth: see skipping.h. */
#define _DEFAULT_SOURCE /* clock_gettime */
#include "skipping.h"

#include "files/model_file.h"
#include "files/normals.h"
#include "ours.h"
#include "pipeline.h"

#include "bench/memory.h"
#include "bench/timing.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 800 };

static const struct rectangle everywhere = {0, 0, SIDE, SIDE};

/* ---- The shader ---- */

static void lit_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    struct vec3 normal = model_normal(*(const struct model *const *)uniforms, face, corner);
    varyings[0] = normal.x;
    varyings[1] = normal.y;
    varyings[2] = normal.z;
}

static lanes_mask lit_fragment(const void *uniforms, const lanes *varyings, lanes_texel *color) {
    static const struct vec3 to_light = {0.6, 0.48, 0.64};
    (void)uniforms;
    struct lanes3 normal =
        lanes3_normalized((struct lanes3){varyings[0], varyings[1], varyings[2]});
    lanes level = 255 * lanes_max(lanes3_dot(normal, lanes3_all(to_light)), lanes_all(0));
    *color = lanes_rgb(level, level, level);
    return lanes_all_set();
}

SHADER(lit, .varying_count = 3, .vertex = lit_vertex, .fragment = lit_fragment);

/* ---- Scenes ---- */

/* So many of the model, one in the other. */
struct scene {
    const char *name;
    const struct model *model;
    int count;
};

/* ---- Drawing ---- */

/* A way to draw. The models are closed: without culling the picture is the same. */
struct way {
    const char *name;
    bool skip;
    enum cull cull;
};

static const struct way ways[] = {
    {"nothing skipped", false, CULL_NONE},
    {"turned away", false, CULL_BACK},
    {"hidden", true, CULL_NONE},
    {"all", true, CULL_BACK},
};

enum { WAYS = sizeof ways / sizeof ways[0] };

struct skipping {
    struct pipeline pipeline;
    struct image image;
    struct model head, ball;
    double seconds[WAYS][FRAMES_LIMIT];
};

static bool draw(struct skipping *s, const struct scene *scene, const struct way *way,
                 struct error *error) {
    static const struct vec3 eye = {1, 1, 3}, center = {0, 0, 0}, up = {0, 1, 0};
    struct draw_call call = camera_call(scene->model, eye, center, up, 1, everywhere, way->cull);
    const struct mat4 camera = call.to_clip;
    s->pipeline.skip = way->skip;
    pipeline_clear(&s->pipeline);
    memset(s->image.pixels, 0, SIDE * SIDE * (size_t)s->image.format);
    for (int i = 1; i <= scene->count; i++) {
        const double size = (double)i / scene->count;
        call.to_clip = mat4_mul(camera, mat4_scaling((struct vec3){size, size, size}));
        if (!pipeline_draw(&s->pipeline, &call, &lit, &scene->model, sizeof(void *), error)) {
            return false;
        }
    }
    return pipeline_finish(&s->pipeline, &s->image, error);
}

/* ---- Measuring ---- */

/* The ways take turns. */
static bool measure_scene(struct skipping *s, const struct scene *scene, size_t frames,
                          struct error *error) {
    for (size_t i = 0; i < frames * WAYS; i++) {
        struct stopwatch start = stopwatch_start();
        if (!draw(s, scene, &ways[i % WAYS], error)) {
            return false;
        }
        s->seconds[i % WAYS][i / WAYS] = stopwatch_seconds(start);
    }
    printf("%-28s", scene->name);
    for (size_t way = 0; way < WAYS; way++) {
        sort_doubles(s->seconds[way], frames);
        printf(" %15.2f", 1e3 * quantile(s->seconds[way], frames, 0.5));
    }
    printf("\n");
    return true;
}

/* ---- Work and memory ---- */

static double model_bytes(const struct model *m) {
    return (double)(m->position_count * sizeof *m->positions + m->uv_count * sizeof *m->uvs +
                    m->normal_count * sizeof *m->normals + m->face_count * sizeof *m->faces);
}

/* Memory for positions, and for what one thread draws; but not the rest, some kilobytes. Of planes,
 * which have room for the most varyings, those of pieces that are visible. */
static double frame_bytes(const struct pipeline *pipeline) {
    const struct frame *f = pipeline->frame;
    const struct scratch *s = f->scratch;
    size_t sum = f->position_capacity * sizeof *f->positions +
                 f->recip_w_capacity * sizeof *f->recip_w + f->beyond_capacity +
                 f->start_capacity * sizeof *f->band_starts + f->chunk_capacity * sizeof *f->chunks;
    for (size_t i = 0; i < f->blocks_made; i++) {
        const struct block *b = &f->blocks[i];
        sum += sizeof *b + b->piece_capacity * sizeof *b->pieces +
               b->band_capacity * sizeof *b->bands + b->sorted_capacity * sizeof *b->sorted;
    }
    sum += s->piece_capacity * sizeof(struct piece *) +
           s->is_visible_capacity * sizeof *s->is_visible +
           s->visible_capacity * sizeof *s->visible + s->color_capacity * sizeof *s->colors +
           s->plane_place_capacity * sizeof *s->plane_place;
    return (double)sum + (double)pipeline->stats[STAT_ATTRIBUTE_SETS] *
                             (double)(PLANES_SIZE(3) * sizeof *s->planes);
}

/* Draw one frame of a head that is cut into ever more faces, and print what was done for it. */
static bool print_work(const char *path, struct error *error) {
    static const size_t triangles[] = {2500, 40000, 640000, 2560000};
    bool done = true;
    printf("\nWhat one frame of a head does, and the memory it takes, in MB\n"
           "%9s %9s %11s %9s %9s %9s %9s %9s %7s %9s\n",
           "faces", "positions", "turned away", "no pixel", "hidden", "fetched", "tested", "shaded",
           "model", "pipeline");
    for (size_t i = 0; done && i < sizeof triangles / sizeof triangles[0]; i++) {
        struct frame_model head = {0};
        struct ours ours = {0};
        done = frame_model_read(&head, path, triangles[i], error);
        bool textured = done && frame_look_is_possible(FRAME_GOURAUD, &head.model);
        const struct frame_scene scene =
            frame_scene(textured ? FRAME_GOURAUD : FRAME_FLAT, SIDE, SIDE, &head);
        done = done && ours_load(&ours, &scene, 1, error);
        ours.pipeline.counts_tests = true;
        done = done && ours_draw(&ours, error);
        const uint64_t *n = ours.pipeline.stats;
        if (done) {
            printf("%9zu %9zu %11zu %9zu %9zu %9zu %9zu %9zu %7.1f %9.1f\n", (size_t)n[STAT_FACES],
                   (size_t)n[STAT_VERTICES_TRANSFORMED], (size_t)n[STAT_FACES_TURNED_AWAY],
                   (size_t)n[STAT_FACES_WITHOUT_PIXEL], (size_t)n[STAT_FACES_HIDDEN],
                   (size_t)n[STAT_ATTRIBUTE_SETS], (size_t)n[STAT_PIXELS_COVERED],
                   (size_t)n[STAT_PIXELS_SHADED], 1e-6 * model_bytes(&head.model),
                   1e-6 * frame_bytes(&ours.pipeline));
        }
        ours_free(&ours);
        frame_model_free(&head);
    }
    return done;
}

/* ---- All of it ---- */

static bool read_model(struct model *model, const char *path, struct error *error) {
    return model_read(model, path, error) && model_need_normals(model, error);
}

static bool set_up(struct skipping *s, const char *path, struct error *error) {
    return read_model(&s->head, path, error) &&
           read_model(&s->ball, COURSE_BUILD "/models/sphere.obj", error) &&
           image_create(&s->image, SIDE, SIDE, IMAGE_BGRA, error) &&
           pipeline_create(&s->pipeline, SIDE, SIDE, error);
}

static void print_head(void) {
    printf("\nWhat shortcuts are worth, alone and together: ms a frame of %dx%d, one thread\n%-28s",
           SIDE, SIDE, "");
    for (size_t i = 0; i < WAYS; i++) {
        printf(" %15s", ways[i].name);
    }
    printf("\n");
}

bool skipping_measure(const char *model, size_t frames, struct error *error) {
    struct skipping *s = bench_memory(1, sizeof *s);
    bool done = set_up(s, model, error);
    if (done) {
        pipeline_use_threads(&s->pipeline, 1);
        print_head();
    }
    const struct scene head = {"a head", &s->head, 1};
    const struct scene balls = {"64 balls, one in the other", &s->ball, 64};
    done =
        done && measure_scene(s, &head, frames, error) && measure_scene(s, &balls, frames, error);
    model_free(&s->head);
    model_free(&s->ball);
    image_free(&s->image);
    pipeline_free(&s->pipeline);
    free(s);
    return done && print_work(model, error);
}
