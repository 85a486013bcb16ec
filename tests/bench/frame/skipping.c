/* What shortcuts are worth: see skipping.h. */
#define _DEFAULT_SOURCE /* clock_gettime */
#include "skipping.h"

#include "files/model_file.h"
#include "files/normals.h"
#include "options.h"
#include "pipeline.h"

#include "bench/memory.h"
#include "bench/timing.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifndef COURSE_BUILD
#define COURSE_BUILD "build"
#endif

enum { SIDE = 800, OBJECT_LIMIT = 400 };

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

struct object {
    const struct model *model;
    struct vec3 place;
    double size;
};

struct scene {
    const char *name;
    struct mat4 camera;
    struct object objects[OBJECT_LIMIT];
    size_t count;
};

static void begin_scene(struct scene *scene, const char *name, struct vec3 eye) {
    static const struct vec3 center = {0, 0, 0}, up = {0, 1, 0};
    *scene = (struct scene){.name = name};
    scene->camera = camera_call(NULL, eye, center, up, 1, everywhere, CULL_NONE).to_clip;
}

static void add_object(struct scene *scene, const struct model *model, struct vec3 place,
                       double size) {
    scene->objects[scene->count++] = (struct object){model, place, size};
}

static const struct vec3 origin = {0, 0, 0};

static void make_head(struct scene *scene, const struct model *head) {
    begin_scene(scene, "a head", (struct vec3){1, 1, 3});
    add_object(scene, head, origin, 1);
}

/* The wall is a large ball. */
static void make_behind(struct scene *scene, const struct model *head, const struct model *ball) {
    begin_scene(scene, "a head behind a ball", (struct vec3){0, 0, 4});
    add_object(scene, head, origin, 1);
    add_object(scene, ball, (struct vec3){0, 0, 1.5}, 1.2);
}

static void make_nested(struct scene *scene, const struct model *ball) {
    begin_scene(scene, "64 balls, one in the other", (struct vec3){1, 1, 3});
    for (int i = 1; i <= 64; i++) {
        add_object(scene, ball, origin, i / 64.0);
    }
}

/* Seen from above the first row; as many are outside the view and behind the eye. */
static void make_crowd(struct scene *scene, const struct model *head) {
    begin_scene(scene, "a crowd of 400 heads", (struct vec3){0, 0.5, 3});
    for (int i = 0; i < 400; i++) {
        struct vec3 place = {i % 20 - 9.5, 0, i / 20 - 14.0};
        add_object(scene, head, place, 0.6);
    }
}

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

static bool draw(struct pipeline *pipeline, const struct scene *scene, const struct way *way,
                 struct image *image, struct error *error) {
    pipeline->skip = way->skip;
    pipeline_clear(pipeline);
    memset(image->pixels, 0, SIDE * SIDE * (size_t)image->format);
    for (size_t i = 0; i < scene->count; i++) {
        const struct object *o = &scene->objects[i];
        struct mat4 to_world = mat4_mul(mat4_translation(o->place),
                                        mat4_scaling((struct vec3){o->size, o->size, o->size}));
        struct draw_call call = {o->model, mat4_mul(scene->camera, to_world), everywhere,
                                 way->cull};
        if (!pipeline_draw(pipeline, &call, &lit, &o->model, sizeof(void *), error)) {
            return false;
        }
    }
    return pipeline_finish(pipeline, image, error);
}

/* ---- Measuring ---- */

struct skipping {
    struct pipeline pipeline;
    struct image image;
    struct model head, ball;
    struct scene scene;
    double seconds[WAYS][FRAMES_LIMIT];
};

/* The ways take turns. */
static bool measure_scene(struct skipping *s, size_t frames, struct error *error) {
    for (size_t i = 0; i < frames * WAYS; i++) {
        struct stopwatch start = stopwatch_start();
        if (!draw(&s->pipeline, &s->scene, &ways[i % WAYS], &s->image, error)) {
            return false;
        }
        s->seconds[i % WAYS][i / WAYS] = stopwatch_seconds(start);
    }
    printf("%-28s", s->scene.name);
    for (size_t way = 0; way < WAYS; way++) {
        sort_doubles(s->seconds[way], frames);
        printf(" %15.2f", 1e3 * quantile(s->seconds[way], frames, 0.5));
    }
    printf("\n");
    return true;
}

static bool read_model(struct model *model, const char *path, struct error *error) {
    return model_read(model, path, error) && model_need_normals(model, error);
}

static bool set_up(struct skipping *s, const char *path, struct error *error) {
    return read_model(&s->head, path, error) &&
           read_model(&s->ball, COURSE_BUILD "/models/sphere.obj", error) &&
           image_create(&s->image, SIDE, SIDE, IMAGE_BGRA, error) &&
           pipeline_create(&s->pipeline, SIDE, SIDE, error);
}

static bool measure_scenes(struct skipping *s, size_t frames, struct error *error) {
    pipeline_use_threads(&s->pipeline, 1);
    printf("\nWhat shortcuts are worth, alone and together: ms a frame of %dx%d, one thread\n%-28s",
           SIDE, SIDE, "");
    for (size_t i = 0; i < WAYS; i++) {
        printf(" %15s", ways[i].name);
    }
    printf("\n");
    make_head(&s->scene, &s->head);
    bool done = measure_scene(s, frames, error);
    make_behind(&s->scene, &s->head, &s->ball);
    done = done && measure_scene(s, frames, error);
    make_nested(&s->scene, &s->ball);
    done = done && measure_scene(s, frames, error);
    make_crowd(&s->scene, &s->head);
    return done && measure_scene(s, frames, error);
}

bool skipping_measure(const char *model, size_t frames, struct error *error) {
    struct skipping *s = bench_memory(1, sizeof *s);
    bool done = set_up(s, model, error) && measure_scenes(s, frames, error);
    model_free(&s->head);
    model_free(&s->ball);
    image_free(&s->image);
    pipeline_free(&s->pipeline);
    free(s);
    return done;
}
