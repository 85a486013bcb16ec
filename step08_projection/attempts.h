/*
 * Lesson 8: the worse and the better versions, for the lesson's figures and the benchmark.
 *
 * Include main.c first: it has what these versions stand next to.
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

/* ---- Clipping: what is left of a face in clip space ---- */

typedef void attempt_clipping(struct polygon *face);

/* All of it, to be divided by any w: what is behind the camera comes to the front upside down. */
static inline void attempt_7_unclipped(struct polygon *face) {
    (void)face;
}

/* Nothing of a face that would have to be cut: holes right in front of the camera. */
static inline void attempt_8_left_out(struct polygon *face) {
    const unsigned beyond = find_beyond(face->corner[0].clip) | find_beyond(face->corner[1].clip) |
                            find_beyond(face->corner[2].clip);
    if ((beyond & (BEYOND_NEAR | BEYOND_GUARD_BAND)) != 0) {
        face->count = 0;
    } else {
        clip_face(face);
    }
}

/* ---- Normals ---- */

typedef struct vec3 attempt_normal(const struct mat4 *map, struct vec3 normal);

/* Sends a normal through the matrix of the points. It is no longer perpendicular to the surface
 * when the scale differs between directions. */
static inline struct vec3 attempt_4_same_matrix(const struct mat4 *map, struct vec3 normal) {
    return vec3_normalized(mat4_direction(map, normal));
}

/* ---- The inverse of a matrix ---- */

typedef bool attempt_inverse(struct mat4 a, struct mat4 *inverse);

/* By Cramer's rule: transposed cofactors, 16 minors, divided by the determinant. Subtracting nearly
 * equal products loses digits when the matrix is nearly singular, and the determinant of a well
 * behaved matrix may underflow to 0. A minor is the determinant without one row and one column. */
#define ATTEMPT_COFACTORS(name, real)                                                              \
    static inline real name##_minor(const struct mat4 *a, int without_row, int without_column) {   \
        real m[3][3];                                                                              \
        for (int i = 0; i < 9; i++) {                                                              \
            int row = i / 3 < without_row ? i / 3 : i / 3 + 1;                                     \
            int column = i % 3 < without_column ? i % 3 : i % 3 + 1;                               \
            m[i / 3][i % 3] = (real)a->m[row][column];                                             \
        }                                                                                          \
        real p = m[1][1] * m[2][2], q = m[1][2] * m[2][1], r = m[1][0] * m[2][2];                  \
        real s = m[1][2] * m[2][0], t = m[1][0] * m[2][1], u = m[1][1] * m[2][0];                  \
        return m[0][0] * (p - q) - m[0][1] * (r - s) + m[0][2] * (t - u);                          \
    }                                                                                              \
    static inline bool name(struct mat4 a, struct mat4 *inverse) {                                 \
        real cofactor[4][4], determinant = 0;                                                      \
        for (int i = 0; i < 16; i++) {                                                             \
            real minor = name##_minor(&a, i / 4, i % 4);                                           \
            cofactor[i / 4][i % 4] = (i / 4 + i) % 2 == 0 ? minor : -minor;                        \
        }                                                                                          \
        for (int column = 0; column < 4; column++) {                                               \
            determinant += (real)a.m[0][column] * cofactor[0][column];                             \
        }                                                                                          \
        for (int i = 0; i < 16 && determinant != 0; i++) {                                         \
            inverse->m[i % 4][i / 4] = cofactor[i / 4][i % 4] / determinant;                       \
        }                                                                                          \
        return determinant != 0;                                                                   \
    }

ATTEMPT_COFACTORS(attempt_11_cofactors, double)
ATTEMPT_COFACTORS(attempt_12_cofactors_float, float)

#endif
