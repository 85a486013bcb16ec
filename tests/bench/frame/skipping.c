/* What shortcuts are worth: see skipping.h. */
#define _DEFAULT_SOURCE /* clock_gettime */
#include "skipping.h"

#include "files/model_file.h"
#include "files/normals.h"
#include "options.h"
#include "pipeline.h"

#include "bench/timing.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifndef COURSE_BUILD
#define COURSE_BUILD "build"
#endif

enum { SIDE = 800, OBJECT_LIMIT = 400 };

static const struct rectangle everywhere = {0, 0, SIDE, SIDE};

/* ---- Shaders ---- */

struct uniforms {
    const struct model *model;
    size_t first_id; /* of its faces */
};

static void lit_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct uniforms *u = uniforms;
    struct vec3 normal = model_normal(u->model, face, corner);
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

/* Which face is visible: 1 + its number, in three bytes. */
enum { ID_LIMIT = 1 << 24 };

static void id_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct uniforms *u = uniforms;
    (void)corner;
    for (int i = 0; i < 3; i++) {
        varyings[i] = (double)((u->first_id + face + 1) >> 8 * i & 255);
    }
}

static lanes_mask id_fragment(const void *uniforms, const lanes *varyings, lanes_texel *color) {
    (void)uniforms;
    *color = lanes_rgb(varyings[0], varyings[1], varyings[2]);
    return lanes_all_set();
}

SHADER(id, .varying_count = 3, .flat = true, .vertex = id_vertex, .fragment = id_fragment);

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

static void begin_scene(struct scene *scene, const char *name, struct vec3 eye, double zoom) {
    static const struct vec3 center = {0, 0, 0}, up = {0, 1, 0};
    *scene = (struct scene){.name = name};
    scene->camera = camera_call(NULL, eye, center, up, zoom, everywhere, CULL_NONE).to_clip;
}

static void add_object(struct scene *scene, const struct model *model, struct vec3 place,
                       double size) {
    scene->objects[scene->count++] = (struct object){model, place, size};
}

static const struct vec3 origin = {0, 0, 0};

static void make_head(struct scene *scene, const struct model *head) {
    begin_scene(scene, "a head", (struct vec3){1, 1, 3}, 1);
    add_object(scene, head, origin, 1);
}

/* The wall is a large ball. */
static void make_behind(struct scene *scene, const struct model *head, const struct model *ball) {
    begin_scene(scene, "a head behind a ball", (struct vec3){0, 0, 4}, 1);
    add_object(scene, head, origin, 1);
    add_object(scene, ball, (struct vec3){0, 0, 1.5}, 1.2);
}

static void make_nested(struct scene *scene, const struct model *ball) {
    begin_scene(scene, "64 balls, one in the other", (struct vec3){1, 1, 3}, 1);
    for (int i = 1; i <= 64; i++) {
        add_object(scene, ball, origin, i / 64.0);
    }
}

/* Seen from above the first row; as many stand beside the view and behind the eye. */
static void make_crowd(struct scene *scene, const struct model *head) {
    begin_scene(scene, "a crowd of 400 heads", (struct vec3){0, 0.5, 3}, 1);
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

enum { WAYS = sizeof ways / sizeof ways[0], VERSIONS };

static bool draw(struct pipeline *pipeline, const struct scene *scene, const struct way *way,
                 const struct shader *shader, struct image *image, struct error *error) {
    size_t first_id = 0;
    pipeline->skip = way->skip;
    pipeline_clear(pipeline);
    memset(image->pixels, 0, SIDE * SIDE * (size_t)image->format);
    for (size_t i = 0; i < scene->count; i++) {
        const struct object *o = &scene->objects[i];
        struct mat4 to_world = mat4_mul(mat4_translation(o->place),
                                        mat4_scaling((struct vec3){o->size, o->size, o->size}));
        struct draw_call call = {o->model, mat4_mul(scene->camera, to_world), everywhere,
                                 way->cull};
        struct uniforms u = {o->model, first_id};
        if (!pipeline_draw(pipeline, &call, shader, &u, sizeof u, error)) {
            return false;
        }
        first_id += o->model->face_count;
    }
    return pipeline_finish(pipeline, image, error);
}

/* ---- The visible faces alone, as one model ---- */

static bool allocate_model(struct model *model, size_t face_count, struct error *error) {
    *model = (struct model){
        .face_count = face_count, .position_count = 3 * face_count, .normal_count = 3 * face_count};
    model->faces = calloc(face_count + 1, sizeof *model->faces);
    model->positions = calloc(3 * face_count + 1, sizeof *model->positions);
    model->normals = calloc(3 * face_count + 1, sizeof *model->normals);
    return (model->faces != NULL && model->positions != NULL && model->normals != NULL) ||
           error_out_of_memory(error);
}

static void copy_corner(struct model *to, size_t face, size_t corner, const struct object *object,
                        size_t from) {
    uint32_t i = (uint32_t)(3 * face + corner);
    const struct corner *given = &object->model->faces[from].corner[corner];
    struct vec3 p = object->model->positions[given->position];
    to->faces[face].corner[corner] = (struct corner){i, MODEL_NONE, i};
    to->positions[i] = vec3_add(vec3_scale(p, object->size), object->place);
    memcpy(to->normals[i], object->model->normals[given->normal], sizeof to->normals[i]);
}

static void copy_faces(struct model *to, const struct scene *scene, const bool *is_visible) {
    size_t number = 0, face = 0;
    for (size_t i = 0; i < scene->count; i++) {
        for (size_t from = 0; from < scene->objects[i].model->face_count; from++, number++) {
            for (size_t corner = 0; is_visible[number] && corner < 3; corner++) {
                copy_corner(to, face, corner, &scene->objects[i], from);
            }
            face += is_visible[number];
        }
    }
}

/* `image` shows the numbers of the faces. */
static bool find_visible(struct model *visible, const struct scene *scene,
                         const struct image *image, struct error *error) {
    size_t faces = 0, seen = 0;
    for (size_t i = 0; i < scene->count; i++) {
        faces += scene->objects[i].model->face_count;
    }
    bool *is_visible = calloc(faces + 1, sizeof *is_visible);
    if (is_visible == NULL) {
        return error_out_of_memory(error);
    }
    for (int i = 0; i < SIDE * SIDE; i++) {
        struct color c = image_get(image, i % SIDE, i / SIDE);
        size_t number = c.r | (size_t)c.g << 8 | (size_t)c.b << 16;
        if (number > 0) {
            seen += !is_visible[number - 1];
            is_visible[number - 1] = true;
        }
    }
    bool done = allocate_model(visible, seen, error);
    if (done) {
        copy_faces(visible, scene, is_visible);
    }
    free(is_visible);
    return done;
}

/* ---- Measuring ---- */

struct skipping {
    struct pipeline pipeline;
    struct image image;
    struct model head, ball, visible;
    struct scene scene, visible_scene;
    double seconds[VERSIONS][FRAMES_LIMIT];
};

/* The last version is the visible faces alone. */
static bool draw_version(struct skipping *s, size_t version, struct error *error) {
    bool is_way = version < WAYS;
    return draw(&s->pipeline, is_way ? &s->scene : &s->visible_scene,
                &ways[is_way ? version : WAYS - 1], &lit, &s->image, error);
}

static bool time_versions(struct skipping *s, size_t frames, struct error *error) {
    for (size_t i = 0; i < frames; i++) {
        for (size_t version = 0; version < VERSIONS; version++) {
            struct stopwatch start = stopwatch_start();
            if (!draw_version(s, version, error)) {
                return false;
            }
            s->seconds[version][i] = stopwatch_seconds(start);
        }
    }
    return true;
}

static bool measure_scene(struct skipping *s, size_t frames, struct error *error) {
    model_free(&s->visible);
    if (!draw(&s->pipeline, &s->scene, &ways[WAYS - 1], &id, &s->image, error) ||
        !find_visible(&s->visible, &s->scene, &s->image, error)) {
        return false;
    }
    s->visible_scene = (struct scene){.camera = s->scene.camera};
    add_object(&s->visible_scene, &s->visible, origin, 1);
    if (!time_versions(s, frames, error)) {
        return false;
    }
    printf("%-28s", s->scene.name);
    for (size_t version = 0; version < VERSIONS; version++) {
        sort_doubles(s->seconds[version], frames);
        printf(" %15.2f", 1e3 * quantile(s->seconds[version], frames, 0.5));
    }
    printf("\n");
    return true;
}

static bool read_model(struct model *model, const char *path, struct error *error) {
    return model_read(model, path, error) && model_need_normals(model, error);
}

static bool set_up(struct skipping *s, const char *path, struct error *error) {
    return read_model(&s->head, path, error) &&
           (OBJECT_LIMIT * s->head.face_count < ID_LIMIT ||
            error_set(error, "%s: too many faces to draw %d of it", path, OBJECT_LIMIT)) &&
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
    printf(" %15s\n", "visible faces");
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
    struct skipping *s = calloc(1, sizeof *s);
    if (s == NULL) {
        return error_out_of_memory(error);
    }
    bool done = set_up(s, model, error) && measure_scenes(s, frames, error);
    model_free(&s->head);
    model_free(&s->ball);
    model_free(&s->visible);
    image_free(&s->image);
    pipeline_free(&s->pipeline);
    free(s);
    return done;
}
