/* What is drawn: see scene.h. */
#include "scene.h"

#include "bench/memory.h"
#include "files/model_file.h"
#include "files/normals.h"
#include "pairs.h"

#include <stdlib.h>
#include <string.h>

const char *const frame_look_name[FRAME_LOOKS] = {"flat", "gouraud", "phong"};

/* ---- Models ---- */

static void set_unit(float unit[3], struct vec3 v) {
    v = vec3_normalized(v);
    unit[0] = (float)v.x;
    unit[1] = (float)v.y;
    unit[2] = (float)v.z;
}

/* llvmpipe's vertex shaders do not do it. */
static void make_normals_unit(const struct model *model) {
    for (size_t i = 0; i < model->normal_count; i++) {
        float *n = model->normals[i];
        set_unit(n, (struct vec3){n[0], n[1], n[2]});
    }
}

static void find_face_normals(struct frame_model *head) {
    const struct model *model = &head->model;
    head->face_normals = bench_memory(model->face_count, sizeof *head->face_normals);
    for (size_t i = 0; i < model->face_count; i++) {
        set_unit(head->face_normals[i], model_face_normal(model, i));
    }
}

void frame_model_free(struct frame_model *head) {
    model_free(&head->model);
    free(head->face_normals);
    head->face_normals = NULL;
}

/* ---- Subdivision ---- */

/* The edges of one attribute: the middle of each is a new element behind those that there are. */
struct middles {
    struct pairs edges;
    size_t old_count;
};

static uint32_t middle_of(struct middles *middles, uint32_t a, uint32_t b) {
    if (a == MODEL_NONE || b == MODEL_NONE) {
        return MODEL_NONE;
    }
    uint32_t number =
        a < b ? pairs_number(&middles->edges, a, b) : pairs_number(&middles->edges, b, a);
    return (uint32_t)middles->old_count + number;
}

enum { ATTRIBUTES = 3 }; /* position, texture coordinate, normal */

static struct corner middle_corner(struct middles middles[ATTRIBUTES], struct corner a,
                                   struct corner b) {
    return (struct corner){
        .position = middle_of(&middles[0], a.position, b.position),
        .uv = middle_of(&middles[1], a.uv, b.uv),
        .normal = middle_of(&middles[2], a.normal, b.normal),
    };
}

/* Three at the corners and one in the middle. */
static void cut_face(struct middles middles[ATTRIBUTES], const struct face *face,
                     struct face four[4]) {
    const struct corner *c = face->corner;
    struct corner middle[3];
    for (int i = 0; i < 3; i++) {
        middle[i] = middle_corner(middles, c[i], c[(i + 1) % 3]);
    }
    for (int i = 0; i < 3; i++) {
        four[i] = (struct face){{c[i], middle[i], middle[(i + 2) % 3]}};
    }
    four[3] = (struct face){{middle[0], middle[1], middle[2]}};
}

/* The `old_count` elements with place behind them for the middles of their edges. */
static void *longer_array(const void *old, const struct middles *middles, size_t element_size) {
    void *longer = bench_memory(middles->old_count + middles->edges.count + 1, element_size);
    if (middles->old_count > 0) {
        memcpy(longer, old, middles->old_count * element_size);
    }
    return longer;
}

/* Adds the middles of edges to elements of 2 or 3 numbers. */
#define ADD_MIDDLES(name, type)                                                                    \
    static void name(type longer[], const struct middles *middles, size_t numbers) {               \
        for (size_t i = 0; i < middles->edges.capacity; i++) {                                     \
            const uint64_t key = middles->edges.keys[i];                                           \
            const uint32_t number = middles->edges.numbers[i];                                     \
            for (size_t k = 0; number > 0 && k < numbers; k++) {                                   \
                longer[(middles->old_count + number - 1) * numbers + k] =                          \
                    (longer[(key >> 32) * numbers + k] +                                           \
                     longer[(key & UINT32_MAX) * numbers + k]) /                                   \
                    2;                                                                             \
            }                                                                                      \
        }                                                                                          \
    }

ADD_MIDDLES(add_middles, float)
ADD_MIDDLES(add_middle_positions, double)

/* The arrays of the finer model, once all of its faces are known. */
static void add_all_middles(struct model *fine, const struct model *coarse,
                            const struct middles middles[ATTRIBUTES]) {
    fine->position_count = coarse->position_count + middles[0].edges.count;
    fine->uv_count = coarse->uv_count + middles[1].edges.count;
    fine->normal_count = coarse->normal_count + middles[2].edges.count;
    fine->positions = longer_array(coarse->positions, &middles[0], sizeof *fine->positions);
    fine->uvs = longer_array(coarse->uvs, &middles[1], sizeof *fine->uvs);
    fine->normals = longer_array(coarse->normals, &middles[2], sizeof *fine->normals);
    add_middle_positions((double *)fine->positions, &middles[0], 3);
    add_middles((float *)fine->uvs, &middles[1], 2);
    add_middles((float *)fine->normals, &middles[2], 3);
}

/* Each face becomes four. */
static void subdivide(struct model *model) {
    const struct model coarse = *model;
    const size_t counts[ATTRIBUTES] = {coarse.position_count, coarse.uv_count, coarse.normal_count};
    struct middles middles[ATTRIBUTES];
    for (int i = 0; i < ATTRIBUTES; i++) {
        middles[i] = (struct middles){pairs_create(3 * coarse.face_count), counts[i]};
    }
    model->face_count = 4 * coarse.face_count;
    model->faces = bench_memory(model->face_count + 1, sizeof *model->faces);
    for (size_t i = 0; i < coarse.face_count; i++) {
        cut_face(middles, &coarse.faces[i], &model->faces[4 * i]);
    }
    add_all_middles(model, &coarse, middles);
    for (int i = 0; i < ATTRIBUTES; i++) {
        pairs_free(&middles[i].edges);
    }
    free(coarse.faces);
    free(coarse.positions);
    free(coarse.uvs);
    free(coarse.normals);
}

/* ---- Reading ---- */

bool frame_model_read(struct frame_model *head, const char *path, size_t triangles,
                      struct error *error) {
    struct model *model = &head->model;
    *head = (struct frame_model){0};
    if (!model_read(model, path, error) || !model_need_normals(model, error)) {
        return false;
    }
    for (int kind = 0; kind < MODEL_TEXTURE_KINDS; kind++) {
        struct error missing;
        (void)model_texture(model, (enum model_texture_kind)kind, &missing);
    }
    make_normals_unit(model);
    while (model->face_count > 0 && triangles > 2 * model->face_count) {
        subdivide(model);
    }
    make_normals_unit(model);
    find_face_normals(head);
    return true;
}

/* ---- Scenes ---- */

static const struct vec3 eye = {1, 1, 3}, center = {0, 0, 0}, up = {0, 1, 0}, light = {1, 1, 1};

/* As lesson 10 shows the head that fills its picture. */
static const double zoom = 0.85;

static struct rectangle square_in_the_middle(size_t width, size_t height) {
    int w = (int)width, h = (int)height, side = w < h ? w : h;
    return (struct rectangle){(w - side) / 2, (h - side) / 2, side, side};
}

static struct frame_texture texture_of(const struct model *model, enum model_texture_kind kind,
                                       double pixels) {
    const struct texture *texture = &model->textures[kind];
    if (texture->level_count == 0) {
        return (struct frame_texture){NULL, 0};
    }
    return (struct frame_texture){texture, texture_wrapped_level(texture, pixels)};
}

struct frame_scene frame_scene(enum frame_look look, size_t width, size_t height,
                               const struct frame_model *head) {
    struct rectangle viewport = square_in_the_middle(width, height);
    struct frame_scene scene = {
        .look = look,
        .width = width,
        .height = height,
        .head = head,
        .call = camera_call(&head->model, eye, center, up, zoom, viewport, CULL_BACK),
        .eye = eye,
        .to_light = vec3_normalized(light),
    };
    for (int kind = 0; kind < MODEL_TEXTURE_KINDS; kind++) {
        scene.textures[kind] =
            texture_of(&head->model, (enum model_texture_kind)kind, zoom * viewport.width);
    }
    return scene;
}

bool frame_look_is_possible(enum frame_look look, const struct model *textured) {
    bool has_diffuse = textured->textures[MODEL_DIFFUSE].level_count > 0;
    switch (look) {
    case FRAME_FLAT:
        return true;
    case FRAME_GOURAUD:
        return has_diffuse;
    default:
        return has_diffuse && textured->textures[MODEL_NORMAL_MAP].level_count > 0 &&
               textured->textures[MODEL_SPECULAR].level_count > 0;
    }
}
