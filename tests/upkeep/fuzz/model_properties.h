/* What must hold of every model that a reader returns; shared by the fuzz targets of OBJ and
 * OFF. */
#ifndef TESTS_UPKEEP_FUZZ_MODEL_PROPERTIES_H
#define TESTS_UPKEEP_FUZZ_MODEL_PROPERTIES_H

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
 * takes a corner, a position, a node, a dent, a triangle, a face and its colour, each in an array
 * that grows by half. */
enum { MODEL_GROWTH = 140 };

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

/* Weights of the corners. */
static void fetch(const void *uniforms, size_t face, size_t corner, double *varyings) {
    (void)uniforms, (void)face;
    for (size_t i = 0; i < 3; i++) {
        varyings[i] = i == corner;
    }
}

static lanes_mask shade(const void *uniforms, const lanes *varyings, lanes_texel *color) {
    (void)uniforms;
    *color = lanes_rgb(varyings[0] * 255, varyings[1] * 255, varyings[2] * 255);
    return lanes_all_set();
}

static inline void draw(const struct model *model, double distance, bool skip,
                        struct image *image) {
    static const struct shader shader = {.varying_count = 3, .vertex = fetch, .fragment = shade};
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
    REQUIRE(pipeline_draw(&pipeline, &call, &shader, NULL, 0, &error));
    REQUIRE(pipeline_finish(&pipeline, image, &error));
    REQUIRE(pipeline.stats[STAT_FACES] == model->face_count);
    pipeline_free(&pipeline);
}

/* From outside and from among the faces: the image is the same with and without skipping. (make
 * stress judges what reaches a pixel.) */
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
