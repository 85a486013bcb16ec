/*
 * Lesson 8: the worse and the better versions, for the lesson's figures and the benchmark.
 *
 * Include main.c first: these versions use its cameras, its faces and its triangle().
 */
#ifndef STEP08_ATTEMPTS_H
#define STEP08_ATTEMPTS_H

#include "geometry.h"
#include "model.h"

/* ---- Perspective ---- */

typedef struct vec2 attempt_perspective(struct vec3 view, double distance);

/* Larger when nearer, by a factor that grows evenly. The size is right at z = 0, but straight lines
 * bend. */
static inline struct vec2 attempt_1_evenly(struct vec3 view, double distance) {
    double factor = 1 + view.z / distance;
    return (struct vec2){view.x * factor, view.y * factor};
}

/* Divided by the distance from the camera. */
static inline struct vec2 attempt_14_divided(struct vec3 view, double distance) {
    double w = 1 - view.z / distance;
    return (struct vec2){view.x / w, view.y / w};
}

/* ---- Drawing the whole model: the same shape as draw_model() ---- */

typedef void attempt_draw(struct drawing *drawing, struct canvas *canvas,
                          const struct mat4 *to_clip);

/* The corners of a face as transform_positions() left them. */
static inline void attempt_corners(const struct drawing *drawing, size_t face,
                                   struct position *corner[3]) {
    const struct state *state = drawing->state;
    for (int i = 0; i < 3; i++) {
        corner[i] = &state->positions[drawing->model->faces[face].corner[i].position];
    }
}

/* Whether the whole face is in front of the near plane and within the guard band. */
static inline bool attempt_in_front(struct position *const corner[3]) {
    unsigned beyond = corner[0]->beyond | corner[1]->beyond | corner[2]->beyond;
    return (beyond & (BEYOND_NEAR | BEYOND_GUARD_BAND)) == 0;
}

/* Divides by w, whatever w is. A point behind the camera has a negative w, so it appears in front,
 * upside down, and a face with one such corner covers the wrong side of the picture. */
static inline void attempt_7_unclipped(struct drawing *drawing, struct canvas *canvas,
                                       const struct mat4 *to_clip) {
    transform_positions(drawing, to_clip);
    for (size_t i = 0; i < drawing->model->face_count; i++) {
        struct position *corner[3];
        struct vertex v[3];
        bool placed = true;
        attempt_corners(drawing, i, corner);
        for (int k = 0; k < 3; k++) {
            placed = placed && place(corner[k]->clip, &canvas->to_screen, &v[k]);
        }
        if (placed) {
            draw_part(drawing, canvas, i, v, whole_face);
        }
    }
}

/* Skips faces with a corner behind the near plane, which leaves holes where large faces pass under
 * the camera. */
static inline void attempt_8_left_out(struct drawing *drawing, struct canvas *canvas,
                                      const struct mat4 *to_clip) {
    transform_positions(drawing, to_clip);
    for (size_t i = 0; i < drawing->model->face_count; i++) {
        struct position *corner[3];
        attempt_corners(drawing, i, corner);
        if (attempt_in_front(corner)) {
            draw_whole(drawing, canvas, i, corner);
        }
    }
}

/* ---- Normals ---- */

typedef struct vec3 attempt_normal(const struct mat4 *map, struct vec3 normal);

/* Sends a normal through the matrix of the points. It is no longer perpendicular to the surface
 * when the scale differs between directions. */
static inline struct vec3 attempt_4_same_matrix(const struct mat4 *map, struct vec3 normal) {
    return vec3_normalized(mat4_direction(map, normal));
}

/* By the transpose of the inverse. A map without an inverse keeps the normal. */
static inline struct vec3 attempt_13_inverse_transpose(const struct mat4 *map, struct vec3 normal) {
    struct mat4 inverse = mat4_identity();
    mat4_inverse(*map, &inverse);
    struct mat4 transpose = mat4_transpose(inverse);
    return vec3_normalized(mat4_direction(&transpose, normal));
}

/* ---- The inverse of a matrix ---- */

typedef bool attempt_inverse(struct mat4 a, struct mat4 *inverse);

/* The determinant of a without one row and one column. */
static inline double attempt_minor(const struct mat4 *a, int without_row, int without_column) {
    int r[3], c[3];
    for (int i = 0; i < 3; i++) {
        r[i] = i < without_row ? i : i + 1;
        c[i] = i < without_column ? i : i + 1;
    }
    return a->m[r[0]][c[0]] *
               (a->m[r[1]][c[1]] * a->m[r[2]][c[2]] - a->m[r[1]][c[2]] * a->m[r[2]][c[1]]) -
           a->m[r[0]][c[1]] *
               (a->m[r[1]][c[0]] * a->m[r[2]][c[2]] - a->m[r[1]][c[2]] * a->m[r[2]][c[0]]) +
           a->m[r[0]][c[2]] *
               (a->m[r[1]][c[0]] * a->m[r[2]][c[1]] - a->m[r[1]][c[1]] * a->m[r[2]][c[0]]);
}

/* By Cramer's rule: transposed cofactors, 16 minors, divided by the determinant. Subtracting nearly
 * equal products loses digits when the matrix is nearly singular, and the determinant of a well
 * behaved matrix may underflow to 0. */
static inline bool attempt_11_cofactors(struct mat4 a, struct mat4 *inverse) {
    struct mat4 result;
    double determinant = 0;
    for (int row = 0; row < 4; row++) {
        for (int column = 0; column < 4; column++) {
            double sign = (row + column) % 2 == 0 ? 1 : -1;
            result.m[column][row] = sign * attempt_minor(&a, row, column);
        }
    }
    for (int column = 0; column < 4; column++) {
        determinant += a.m[0][column] * result.m[column][0];
    }
    if (determinant == 0) {
        return false;
    }
    for (int row = 0; row < 4; row++) {
        for (int column = 0; column < 4; column++) {
            result.m[row][column] /= determinant;
        }
    }
    *inverse = result;
    return true;
}

static inline float attempt_minor_float(const float a[4][4], int without_row, int without_column) {
    float m[3][3];
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            m[i][k] = a[i < without_row ? i : i + 1][k < without_column ? k : k + 1];
        }
    }
    float p = m[1][1] * m[2][2], q = m[1][2] * m[2][1], r = m[1][0] * m[2][2];
    float s = m[1][2] * m[2][0], t = m[1][0] * m[2][1], u = m[1][1] * m[2][0];
    float first = m[0][0] * (p - q), second = m[0][1] * (r - s), third = m[0][2] * (t - u);
    return first - second + third;
}

/* The same in float. */
static inline bool attempt_12_cofactors_float(struct mat4 a, struct mat4 *inverse) {
    float m[4][4], cofactor[4][4], determinant = 0;
    for (int i = 0; i < 16; i++) {
        m[i / 4][i % 4] = (float)a.m[i / 4][i % 4];
    }
    for (int row = 0; row < 4; row++) {
        for (int column = 0; column < 4; column++) {
            float minor = attempt_minor_float((const float(*)[4])m, row, column);
            cofactor[row][column] = (row + column) % 2 == 0 ? minor : -minor;
        }
    }
    for (int column = 0; column < 4; column++) {
        float product = m[0][column] * cofactor[0][column];
        determinant = determinant + product;
    }
    if (determinant == 0) {
        return false;
    }
    for (int row = 0; row < 4; row++) {
        for (int column = 0; column < 4; column++) {
            inverse->m[column][row] = cofactor[row][column] / determinant;
        }
    }
    return true;
}

#endif
