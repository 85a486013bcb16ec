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

/* ---- Sets ---- */

size_t sets_find(size_t *lower, size_t number) {
    while (lower[number] != number) {
        lower[number] = lower[lower[number]];
        number = lower[number];
    }
    return number;
}

void sets_join(size_t *lower, size_t a, size_t b) {
    size_t least = sets_find(lower, a), other = sets_find(lower, b);
    lower[least > other ? least : other] = least < other ? least : other;
}

/* ---- Normals ----
 *
 * Around a position the faces are a fan, or several: those that one reaches from each other over
 * soft edges. Each fan has one normal. */

enum {
    HARD_DEGREES = 60, /* as in three.js; the sides of a column of six are soft, a cube's hard */
    NEIGHBOURS = 8     /* looked at where so many faces meet in an edge that it means nothing */
};

/* A corner at the position, the first of its fan for all of them. */
struct leaf {
    struct vec3 face_normal; /* of length 1 or 0 */
    struct vec3 sum;         /* of the fan's normals */
    uint32_t normal;         /* MODEL_NONE: none yet */
    size_t earlier[2];       /* for each spoke, the last one before it that leads there too; or 0 */
};

/* Of a position. A leaf has two spokes, the edges of its face that meet there; they are numbered
 * from 1 through the whole model. */
struct fans {
    struct model *model;
    double least;           /* cosine of the angle between faces from which on an edge is hard */
    bool all;               /* none is */
    const uint32_t *corner; /* 3 * face + 0, 1 or 2 */
    size_t count;
    size_t spokes; /* of positions before */
    size_t *last;  /* the last spoke to each position, from this one or from one before */
    /* Room for as many corners as any position has. */
    struct leaf *leaves;
    size_t *lower; /* see sets_join() */
};

/* Is the edge between these two corners' faces soft? The file's smoothing groups say so, or the
 * angle. A face without area says nothing. */
static bool is_soft(const struct fans *fans, size_t a, size_t b) {
    const struct model *model = fans->model;
    struct vec3 u = fans->leaves[a].face_normal, v = fans->leaves[b].face_normal;
    if (model->face_groups != NULL && !model->hard_given) {
        uint32_t one = model->face_groups[fans->corner[a] / 3];
        uint32_t other = model->face_groups[fans->corner[b] / 3];
        if (one != MODEL_NONE || other != MODEL_NONE) {
            return one == other && one != 0;
        }
    }
    return vec3_dot(u, v) >= fans->least || vec3_dot(u, u) == 0 || vec3_dot(v, v) == 0;
}

/* Leaf `i` joins the fans of those before it to which it has soft edges. */
static void add_leaf(const struct fans *fans, size_t i) {
    const size_t face = fans->corner[i] / 3, at = fans->corner[i] % 3;
    struct leaf *leaf = &fans->leaves[i];
    *leaf = (struct leaf){.face_normal = vec3_normalized(model_face_normal(fans->model, face)),
                          .normal = MODEL_NONE};
    fans->lower[i] = fans->all ? 0 : i;
    for (size_t k = 0; k < 2; k++) {
        size_t *last = &fans->last[fans->model->faces[face].corner[(at + 1 + k) % 3].position];
        size_t other = *last > fans->spokes ? *last - fans->spokes : 0;
        leaf->earlier[k] = other;
        *last = fans->spokes + 2 * i + k + 1;
        for (int looked = 0; looked < NEIGHBOURS && other > 0; looked++) {
            if (is_soft(fans, i, (other - 1) / 2)) {
                sets_join(fans->lower, i, (other - 1) / 2);
            }
            other = fans->leaves[(other - 1) / 2].earlier[(other - 1) % 2];
        }
    }
}

/* Give the bare corners of the position the normal of their fan: the sum of those of its faces,
 * weighted by the angle of each there. False when memory runs out. */
static bool give_normals(const struct fans *fans, size_t *capacity) {
    struct model *model = fans->model;
    for (size_t i = 0; i < fans->count; i++) {
        add_leaf(fans, i);
    }
    for (size_t i = 0; i < fans->count; i++) {
        const size_t face = fans->corner[i] / 3, at = fans->corner[i] % 3;
        struct vec3 p = model_position(model, face, at);
        double angle = model_angle(vec3_sub(model_position(model, face, (at + 1) % 3), p),
                                   vec3_sub(model_position(model, face, (at + 2) % 3), p));
        struct vec3 *sum = &fans->leaves[sets_find(fans->lower, i)].sum;
        *sum = vec3_add(*sum, vec3_scale(fans->leaves[i].face_normal, angle));
    }
    for (size_t i = 0; i < fans->count; i++) {
        uint32_t *normal = &model->faces[fans->corner[i] / 3].corner[fans->corner[i] % 3].normal;
        struct leaf *fan = &fans->leaves[sets_find(fans->lower, i)];
        if (*normal == MODEL_NONE && fan->normal == MODEL_NONE) {
            if (model->normal_count == MODEL_NONE ||
                !array_extend(&model->normals, capacity, model->normal_count + 1,
                              sizeof *model->normals)) {
                return false;
            }
            const double noise = 1e-9; /* far above what rounding leaves of opposite normals */
            const struct vec3 n =
                vec3_length(fan->sum) > noise ? vec3_normalized(fan->sum) : (struct vec3){0, 0, 1};
            const float rounded[3] = {(float)n.x, (float)n.y, (float)n.z};
            memcpy(model->normals[model->normal_count], rounded, sizeof rounded);
            fan->normal = (uint32_t)model->normal_count++;
        }
        *normal = *normal == MODEL_NONE ? fan->normal : *normal;
    }
    return true;
}

/* The corners of all faces sorted by their positions, and where in this list those of each position
 * end; the most that one has. */
static size_t sort_corners(const struct model *model, uint32_t *corners, uint32_t *ends) {
    uint32_t most = 0, sum = 0;
    for (size_t i = 0; i < 3 * model->face_count; i++) {
        ends[model->faces[i / 3].corner[i % 3].position]++;
    }
    for (size_t i = 0; i < model->position_count; i++) {
        uint32_t count = ends[i];
        most = count > most ? count : most;
        ends[i] = sum; /* the begin, at first */
        sum += count;
    }
    for (uint32_t i = 0; i < 3 * model->face_count; i++) {
        corners[ends[model->faces[i / 3].corner[i % 3].position]++] = i;
    }
    return most;
}

bool model_need_normals(struct model *model, struct error *error) {
    const double degrees = model->hard_given ? model->hard_degrees : HARD_DEGREES;
    const double rounding = 0.1; /* of positions in files */
    size_t bare = 0;             /* the first corner that is */
    while (bare < 3 * model->face_count &&
           model->faces[bare / 3].corner[bare % 3].normal != MODEL_NONE) {
        bare++;
    }
    if (bare == 3 * model->face_count) {
        return true;
    }
    const size_t limit = model->face_count <= UINT32_MAX / 3 ? 3 * model->face_count : SIZE_MAX;
    uint32_t *corners = calloc(limit, sizeof *corners);
    uint32_t *ends = calloc(model->position_count, sizeof *ends);
    bool done = corners != NULL && ends != NULL;
    size_t most = done ? sort_corners(model, corners, ends) : 0, capacity = model->normal_count;
    struct fans fans = {
        .model = model,
        .least = turn_direction((degrees + rounding) / 360).x,
        .all = degrees >= 180,
        .last = calloc(model->position_count, sizeof *fans.last),
        .leaves = calloc(most + 1, sizeof *fans.leaves),
        .lower = calloc(most + 1, sizeof *fans.lower),
    };
    done = done && fans.last != NULL && fans.leaves != NULL && fans.lower != NULL;
    for (size_t i = 0, begin = 0; done && i < model->position_count; begin = ends[i++]) {
        fans.corner = corners + begin;
        fans.count = ends[i] - begin;
        fans.spokes = 2 * begin;
        done = give_normals(&fans, &capacity);
    }
    free(fans.last);
    free(fans.leaves);
    free(fans.lower);
    free(corners);
    free(ends);
    return done || error_out_of_memory(error);
}

/* ---- Colours ---- */

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
    model->colors_computed = true;
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
    for (size_t i = 0; i < 3 * model->position_count; i++) {
        model->colors[i / 3][i % 3] = 0.5F; /* grey */
    }
    for (size_t i = model->face_count; i-- > 0;) { /* downwards: the first face has the last word */
        for (size_t j = 3; j-- > 0;) {
            struct vec3 normal = vec3_normalized(model_normal(model, i, j));
            float *color = model->colors[model->faces[i].corner[j].position];
            color[0] = (float)((normal.x + 1) / 2);
            color[1] = (float)((normal.y + 1) / 2);
            color[2] = (float)((normal.z + 1) / 2);
        }
    }
    return true;
}
