/*
 * Lesson 4: worse ways to find the intensity of a face. All take the three corners of a face
 * (counterclockwise as seen from outside) and the direction to the light, of length 1. They return
 * what face_intensity() of main.c returns, or nearly.
 */
#ifndef STEP04_ATTEMPTS_H
#define STEP04_ATTEMPTS_H

#include "geometry.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

typedef double intensity_function(struct vec3 w0, struct vec3 w1, struct vec3 w2,
                                  struct vec3 to_light);

/* Attempt 1: the cross product as it is. Its length is twice the area of the face, so large faces
 * are bright and small ones dark: a fine mesh is nearly black. */
static inline double attempt_1_not_normalized(struct vec3 w0, struct vec3 w1, struct vec3 w2,
                                              struct vec3 to_light) {
    return vec3_dot(vec3_cross(vec3_sub(w1, w0), vec3_sub(w2, w0)), to_light);
}

/* Attempt 2: the factors of the cross product exchanged, so that the normal points into the
 * model. Every sign is wrong: what faces the light is not drawn, what faces away is. We look at the
 * inside of the back. */
static inline double attempt_2_inward(struct vec3 w0, struct vec3 w1, struct vec3 w2,
                                      struct vec3 to_light) {
    return vec3_dot(vec3_normalized(vec3_cross(vec3_sub(w2, w0), vec3_sub(w1, w0))), to_light);
}

/* Attempt 3: the sign thrown away. Now the backs are drawn too, as bright as fronts, and without a
 * depth buffer the last face of the file wins. */
static inline double attempt_3_absolute(struct vec3 w0, struct vec3 w1, struct vec3 w2,
                                        struct vec3 to_light) {
    return fabs(attempt_2_inward(w0, w1, w2, to_light));
}

/* The cross product in float. */
struct attempt_vec3 {
    float x, y, z;
};

static inline struct attempt_vec3 attempt_normal(struct vec3 w0, struct vec3 w1, struct vec3 w2) {
    float ax = (float)w1.x - (float)w0.x, ay = (float)w1.y - (float)w0.y;
    float az = (float)w1.z - (float)w0.z;
    float bx = (float)w2.x - (float)w0.x, by = (float)w2.y - (float)w0.y;
    float bz = (float)w2.z - (float)w0.z;
    return (struct attempt_vec3){ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx};
}

static inline float attempt_dot(struct attempt_vec3 n, struct vec3 to_light) {
    return n.x * (float)to_light.x + n.y * (float)to_light.y + n.z * (float)to_light.z;
}

static inline float attempt_square(struct attempt_vec3 n) {
    return n.x * n.x + n.y * n.y + n.z * n.z;
}

/* Attempt 4: everything in float. Good to about seven digits, so a grey value is wrong only where
 * the exact one lies at the limit between two. (Fewer digits where a face is as thin as a needle:
 * its cross product is made of differences of nearly equal numbers.) But the square of the length
 * of a normal is the fourth power of the size of the model: in float it becomes 0 below 1e-45,
 * which a model of size 1e-11 is enough for. */
static inline double attempt_4_float(struct vec3 w0, struct vec3 w1, struct vec3 w2,
                                     struct vec3 to_light) {
    struct attempt_vec3 n = attempt_normal(w0, w1, w2);
    float square = attempt_square(n);
    return square > 0 ? (double)(attempt_dot(n, to_light) / (float)sqrt((double)square)) : 0;
}

/* 1 / sqrt(square) without a root and a division: the bits of a float, read as a whole number, are
 * nearly its logarithm. Halving and negating that is nearly the root's reciprocal; each Newton step
 * doubles the number of right digits. (Lomont, "Fast Inverse Square Root", 2003.) */
static inline float attempt_reciprocal_root(float square, int newton_steps) {
    uint32_t bits;
    float root;
    memcpy(&bits, &square, sizeof bits);
    bits = 0x5f3759dfU - (bits >> 1);
    memcpy(&root, &bits, sizeof root);
    for (int i = 0; i < newton_steps; i++) {
        root = root * (1.5F - 0.5F * square * root * root);
    }
    return root;
}

static inline double attempt_by_root(struct vec3 w0, struct vec3 w1, struct vec3 w2,
                                     struct vec3 to_light, int newton_steps) {
    struct attempt_vec3 n = attempt_normal(w0, w1, w2);
    float root = attempt_reciprocal_root(attempt_square(n), newton_steps);
    return (double)(attempt_dot(n, to_light) * root);
}

/* Attempt 5: the guess alone: up to 3.5 % wrong, several grey values; faces that should be equal
 * differ. */
static inline double attempt_5_root_0(struct vec3 w0, struct vec3 w1, struct vec3 w2,
                                      struct vec3 to_light) {
    return attempt_by_root(w0, w1, w2, to_light, 0);
}

/* Attempt 6: one Newton step: up to 0.18 % wrong, never more than one grey value. */
static inline double attempt_6_root_1(struct vec3 w0, struct vec3 w1, struct vec3 w2,
                                      struct vec3 to_light) {
    return attempt_by_root(w0, w1, w2, to_light, 1);
}

/* Attempt 7: two Newton steps: as good as attempt 4, nearly. */
static inline double attempt_7_root_2(struct vec3 w0, struct vec3 w1, struct vec3 w2,
                                      struct vec3 to_light) {
    return attempt_by_root(w0, w1, w2, to_light, 2);
}

#endif
