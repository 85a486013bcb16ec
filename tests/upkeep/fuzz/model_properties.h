/* What must hold of every model that a reader returns; shared by the fuzz targets of OBJ and
 * OFF. */
#ifndef TESTS_FUZZ_MODEL_PROPERTIES_H
#define TESTS_FUZZ_MODEL_PROPERTIES_H

#include "files/model_file.h"
#include "files/normals.h"
#include "fuzz.h"
#include "model.h"
#include "pipeline.h"
#include "run/parts.h"

#include <math.h>

enum { SIDE = 32 };         /* pixels of the image that models are drawn into */
enum { SLOW_FACES = 4096 }; /* larger models are only read */
/* Bytes of memory for each byte of a file: a polygon's corner takes two bytes of text. In memory it
 * takes a corner, a position, a node, a cell, a place in the queue, a triangle, a face and its
 * colour, each in an array that grows by half. */
enum { MODEL_GROWTH = 160 };

static inline void require_finite(const float *numbers, size_t count) {
    for (size_t i = 0; i < count; i++) {
        REQUIRE(isfinite(numbers[i]));
    }
}

static inline void require_colors(const float (*colors)[3], size_t count) {
    for (size_t i = 0; i < count; i++) {
        for (int channel = 0; channel < 3; channel++) {
            REQUIRE(colors[i][channel] >= 0 && colors[i][channel] <= 1);
        }
    }
}

static inline void require_valid_model(const struct model *model) {
    REQUIRE(model->face_count > 0 && model->position_count > 0);
    for (size_t i = 0; i < model->position_count; i++) {
        struct vec3 p = model->positions[i];
        REQUIRE(isfinite(p.x) && isfinite(p.y) && isfinite(p.z));
    }
    if (model->colors != NULL) {
        require_colors((const float(*)[3])model->colors, model->position_count);
    }
    if (model->face_colors != NULL) {
        require_colors((const float(*)[3])model->face_colors, model->face_count);
    }
    for (size_t i = 0; i < model->uv_count; i++) {
        require_finite(model->uvs[i], 2);
    }
    for (size_t i = 0; i < model->normal_count; i++) {
        require_finite(model->normals[i], 3);
    }
    for (size_t i = 0; i < model->face_count; i++) {
        for (int j = 0; j < 3; j++) {
            const struct corner *corner = &model->faces[i].corner[j];
            REQUIRE(corner->position < model->position_count);
            REQUIRE(corner->uv == MODEL_NONE || corner->uv < model->uv_count);
            REQUIRE(corner->normal == MODEL_NONE || corner->normal < model->normal_count);
        }
    }
}

typedef bool part_decoder(struct model *model, const void *data, size_t size, unsigned parts,
                          struct error *error);

/* Lines that are asked for join positions that exist. */
static inline void require_lines(const uint8_t *data, size_t size, part_decoder *decode) {
    struct model model = {0};
    struct error error = no_error();
    if (decode(&model, data, size, MODEL_LINES, &error)) {
        for (size_t i = 0; i < model.line_count; i++) {
            REQUIRE(model.lines[i][0] < model.position_count);
            REQUIRE(model.lines[i][1] < model.position_count);
        }
    }
    model_free(&model);
}

/* Faces know their materials, and may be drawn in their colours. */
static inline void require_materials(struct model *model) {
    struct error error = no_error();
    struct parts parts = {0};
    struct error missing = {0};
    for (size_t i = 0; model->face_materials != NULL && i < model->face_count; i++) {
        REQUIRE(model->face_materials[i] == MODEL_NONE ||
                model->face_materials[i] < model->material_count);
    }
    REQUIRE((model->face_materials != NULL) == (model->material_count > 0));
    if (model->material_count > 0) {
        size_t faces = 0;
        REQUIRE(parts_move_coordinates(model, &error));
        REQUIRE(parts_make(&parts, model, &missing, &error));
        for (size_t i = 0; i < parts.count; i++) {
            faces += parts.part[i].model.face_count;
        }
        REQUIRE(faces == model->face_count);
        parts_free(&parts);
        require_valid_model(model);
    }
}

/* After this every corner has a normal; those that were computed have length 1. */
static inline void require_normals(struct model *model) {
    struct error error = no_error();
    size_t given = model->normal_count;
    REQUIRE(model_need_normals(model, &error));
    for (size_t i = given; i < model->normal_count; i++) {
        const float *n = model->normals[i];
        struct vec3 normal = {n[0], n[1], n[2]};
        REQUIRE(fabs(vec3_length(normal) - 1) < 1e-6);
    }
    for (size_t i = 0; i < model->face_count; i++) {
        for (int j = 0; j < 3; j++) {
            REQUIRE(model->faces[i].corner[j].normal < model->normal_count);
        }
    }
}

/* ---- Drawing ---- */

/* Weights of the corners, the texture coordinate, the normal. */
enum { VARYINGS = 8 };

static void fetch(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct model *model = *(const struct model *const *)uniforms;
    struct vec2 uv = model_uv(model, face, corner);
    struct vec3 normal = model_normal(model, face, corner);
    for (size_t i = 0; i < 3; i++) {
        varyings[i] = i == corner;
    }
    varyings[3] = uv.x;
    varyings[4] = uv.y;
    varyings[5] = normal.x;
    varyings[6] = normal.y;
    varyings[7] = normal.z;
}

/* What reaches a pixel that is drawn is finite, and lies inside the triangle: such a pixel has a
 * blue of 255. (What is not drawn is computed too, and may be anything.) In floats a sliver may
 * lose everything that is asked for here; make stress judges how much each face may lose. */
static lanes_mask shade(const void *uniforms, const lanes *varyings, lanes_texel *color) {
    const real rounding = sizeof(real) == sizeof(float) ? (real)INFINITY : (real)1e-6;
    lanes_mask right = lanes_all_set();
    (void)uniforms;
    for (size_t i = 0; i < VARYINGS; i++) {
        right &= varyings[i] * 0 == 0; /* neither infinite nor no number */
    }
    for (size_t i = 0; i < 3; i++) {
        right &= (varyings[i] >= -rounding) & (varyings[i] <= 1 + rounding);
    }
    lanes off = varyings[0] + varyings[1] + varyings[2] - 1;
    right &= (off >= -rounding) & (off <= rounding);
    *color = lanes_rgb(varyings[0] * 255, varyings[5] * 255,
                       lanes_select(right, lanes_all(255), lanes_all(1)));
    return lanes_all_set();
}

/* Is one of the attributes so large that it need not reach a pixel as a number? See struct
 * shader. */
static inline bool has_huge_attribute(const struct model *model) {
    const float huge = 1e10f;
    bool found = false;
    for (size_t i = 0; i < model->uv_count; i++) {
        found |= fabsf(model->uvs[i][0]) > huge || fabsf(model->uvs[i][1]) > huge;
    }
    for (size_t i = 0; i < model->normal_count; i++) {
        const float *n = model->normals[i];
        found |= fabsf(n[0]) > huge || fabsf(n[1]) > huge || fabsf(n[2]) > huge;
    }
    return found;
}

/* A pixel is drawn and right, or it is black. */
static inline void require_pixels(const struct image *image) {
    for (size_t i = 0; i < image->width * image->height; i++) {
        const uint8_t *p = image->pixels + 3 * i;
        REQUIRE(p[0] == 255 || (p[0] == 0 && p[1] == 0 && p[2] == 0));
    }
}

static inline void draw(const struct model *model, double distance, bool skip,
                        struct image *image) {
    static const struct shader shader = {
        .varying_count = VARYINGS, .vertex = fetch, .fragment = shade};
    struct error error = no_error();
    struct pipeline pipeline;
    struct vec3 eye = {0.6 * distance, 0.3 * distance, distance};
    struct draw_call call =
        camera_call(model, eye, (struct vec3){0, 0, 0}, (struct vec3){0, 1, 0}, 0.8,
                    (struct rectangle){1, 2, SIDE - 2, SIDE - 3}, CULL_NONE);
    REQUIRE(image_create(image, SIDE, SIDE, IMAGE_BGR, &error));
    REQUIRE(pipeline_create(&pipeline, SIDE, SIDE, &error));
    pipeline.skip = skip;
    pipeline_clear(&pipeline);
    REQUIRE(pipeline_draw(&pipeline, &call, &shader, &model, sizeof(void *), &error));
    REQUIRE(pipeline_finish(&pipeline, image, &error));
    if (!has_huge_attribute(model)) {
        require_pixels(image);
    }
    REQUIRE(pipeline.stats[STAT_FACES] == model->face_count);
    pipeline_free(&pipeline);
}

/* From outside and from among the faces: the image is the same with and without skipping. */
static inline void require_drawing(const struct model *model) {
    static const double distances[] = {3, 0.25};
    for (size_t i = 0; i < sizeof distances / sizeof distances[0]; i++) {
        struct image skipped, full;
        draw(model, distances[i], true, &skipped);
        draw(model, distances[i], false, &full);
        REQUIRE(memcmp(skipped.pixels, full.pixels, (size_t)SIDE * SIDE * 3) == 0);
        image_free(&skipped);
        image_free(&full);
    }
}

/* Read the file, and try on the model whatever the steps do with one. */
static inline void require_model(const uint8_t *data, size_t size) {
    struct error error = no_error();
    struct model model;
    memory_begin();
    bool done = model_decode(&model, data, size, &error);
    require_memory(size, MODEL_GROWTH);
    if (!done) {
        REQUIRE(model.face_count == 0 && model.positions == NULL && model.faces == NULL);
        REQUIRE(model.colors == NULL && model.face_colors == NULL);
        require_message(&error);
        return;
    }
    require_valid_model(&model);
    if (model.face_count <= SLOW_FACES) {
        require_normals(&model);
        require_drawing(&model);
        REQUIRE(model_need_colors(&model, &error));
        require_valid_model(&model);
        REQUIRE(model.colors != NULL || model.face_colors != NULL);
    }
    require_materials(&model);
    model_free(&model);
}

#endif
