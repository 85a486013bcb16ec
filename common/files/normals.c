/* Normals and colours computed from faces; see normals.h. */
#include "files/normals.h"

#include "base/array.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- Angles ---- */

/* The angle whose tangent is y / x, for y and x that are not negative nor both 0: 0..pi/2. The
 * tangent is brought below tan(pi/32) by halving the angle three times, where nine terms of the
 * series of the arcus tangent leave less than 1e-19 (NIST Digital Library of Mathematical
 * Functions, 4.21(iii) for the half angle, 4.24.3 for the series). */
static double angle_of_ratio(double y, double x) {
    const double half_pi = 1.57079632679489661923;
    bool swapped = y > x;
    double tangent = swapped ? x / y : y / x;
    for (int i = 0; i < 3; i++) {
        tangent = tangent / (1 + sqrt(1 + tangent * tangent));
    }
    double square = tangent * tangent, series = 0;
    for (int odd = 17; odd >= 1; odd -= 2) {
        series = 1.0 / odd - square * series;
    }
    double angle = 8 * tangent * series;
    return swapped ? half_pi - angle : angle;
}

double model_angle(struct vec3 a, struct vec3 b) {
    struct vec3 u = vec3_normalized(a), v = vec3_normalized(b);
    double apart = vec3_length(vec3_sub(u, v)), along = vec3_length(vec3_add(u, v));
    bool both = vec3_dot(u, u) > 0 && vec3_dot(v, v) > 0;
    return both ? 2 * angle_of_ratio(apart, along) : 0;
}

/* ---- Normals ---- */

/* Add a face's normal to the sum at each of its positions, weighted by its angle there. */
static void add_face_normal(const struct model *model, size_t face, struct vec3 *sums) {
    struct vec3 p[3];
    for (size_t i = 0; i < 3; i++) {
        p[i] = model_position(model, face, i);
    }
    struct vec3 normal = vec3_normalized(vec3_cross(vec3_sub(p[1], p[0]), vec3_sub(p[2], p[0])));
    for (size_t i = 0; i < 3; i++) {
        double angle = model_angle(vec3_sub(p[(i + 1) % 3], p[i]), vec3_sub(p[(i + 2) % 3], p[i]));
        struct vec3 *sum = &sums[model->faces[face].corner[i].position];
        *sum = vec3_add(*sum, vec3_scale(normal, angle));
    }
}

/* Append the normal of a position to the model's, which has room for it. */
static uint32_t append_normal(struct model *model, struct vec3 sum) {
    const double noise = 1e-9; /* far above what rounding leaves of opposite normals */
    struct vec3 normal = vec3_length(sum) > noise ? vec3_normalized(sum) : (struct vec3){0, 0, 1};
    float *stored = model->normals[model->normal_count];
    stored[0] = (float)normal.x;
    stored[1] = (float)normal.y;
    stored[2] = (float)normal.z;
    return (uint32_t)model->normal_count++;
}

static size_t count_bare_corners(const struct model *model) {
    size_t count = 0;
    for (size_t i = 0; i < model->face_count; i++) {
        for (int j = 0; j < 3; j++) {
            count += model->faces[i].corner[j].normal == MODEL_NONE;
        }
    }
    return count;
}

/* Room for `more` normals. */
static bool reserve_normals(struct model *model, size_t more) {
    size_t capacity = model->normal_count;
    return more < MODEL_NONE - model->normal_count &&
           array_extend(&model->normals, &capacity, model->normal_count + more,
                        sizeof *model->normals);
}

/* Give bare corners the normal of their position, which is made for the first of them. `normal_of`
 * holds MODEL_NONE for every position. */
static void give_normals(struct model *model, const struct vec3 *sums, uint32_t *normal_of) {
    for (size_t i = 0; i < model->face_count; i++) {
        for (int j = 0; j < 3; j++) {
            struct corner *corner = &model->faces[i].corner[j];
            if (corner->normal != MODEL_NONE) {
                continue;
            }
            if (normal_of[corner->position] == MODEL_NONE) {
                normal_of[corner->position] = append_normal(model, sums[corner->position]);
            }
            corner->normal = normal_of[corner->position];
        }
    }
}

bool model_need_normals(struct model *model, struct error *error) {
    size_t bare = count_bare_corners(model), positions = model->position_count;
    if (bare == 0) {
        return true;
    }
    struct vec3 *sums = calloc(positions, sizeof *sums);
    uint32_t *normal_of = malloc(positions * sizeof *normal_of); /* of a position */
    bool done = sums != NULL && normal_of != NULL &&
                reserve_normals(model, bare < positions ? bare : positions);
    if (done) {
        for (size_t i = 0; i < positions; i++) {
            normal_of[i] = MODEL_NONE;
        }
        for (size_t i = 0; i < model->face_count; i++) {
            add_face_normal(model, i, sums);
        }
        give_normals(model, sums, normal_of);
    }
    free(sums);
    free(normal_of);
    return done || error_out_of_memory(error);
}

/* ---- Colours ---- */

/* -1..1 becomes 0..1. */
static float level_of(double coordinate) {
    return (float)((coordinate + 1) / 2);
}

static void fill_with_grey(struct model *model) {
    for (size_t i = 0; i < model->position_count; i++) {
        model->colors[i][0] = model->colors[i][1] = model->colors[i][2] = 0.5F;
    }
}

static bool has_colorful_material(const struct model *model) {
    for (size_t i = 0; i < model->material_count; i++) {
        const float *color = model->materials[i].color;
        if (color[0] != color[1] || color[1] != color[2]) {
            return true;
        }
    }
    return false;
}

static bool take_colors_of_materials(struct model *model, struct error *error) {
    static const float white[3] = {1, 1, 1};
    model->face_colors = malloc(model->face_count * sizeof *model->face_colors);
    if (model->face_colors == NULL) {
        return error_out_of_memory(error);
    }
    for (size_t i = 0; i < model->face_count; i++) {
        uint32_t material = model->face_materials[i];
        memcpy(model->face_colors[i],
               material == MODEL_NONE ? white : model->materials[material].color, sizeof white);
    }
    return true;
}

bool model_need_colors(struct model *model, struct error *error) {
    if (model->face_colors != NULL || model->colors != NULL) {
        return true;
    }
    if (has_colorful_material(model)) {
        return take_colors_of_materials(model, error);
    }
    if (!model_need_normals(model, error)) {
        return false;
    }
    model->colors = malloc(model->position_count * sizeof *model->colors);
    if (model->colors == NULL) {
        return error_out_of_memory(error);
    }
    fill_with_grey(model);
    for (size_t i = model->face_count; i-- > 0;) { /* downwards: the first face has the last word */
        for (size_t j = 3; j-- > 0;) {
            struct vec3 normal = vec3_normalized(model_normal(model, i, j));
            float *color = model->colors[model->faces[i].corner[j].position];
            color[0] = level_of(normal.x);
            color[1] = level_of(normal.y);
            color[2] = level_of(normal.z);
        }
    }
    return true;
}
