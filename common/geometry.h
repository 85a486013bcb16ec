/*
 * Vectors, matrices and cameras.
 *
 * Conventions of the whole course, stated here once:
 *
 *   World      right-handed, y up. A camera looks along its own -z.
 *   Matrices   m[row][column], applied to column vectors from the left:
 *              clip = projection * view * position.
 *   Image      pixel (0,0) is bottom-left. Pixel (x,y) covers x..x+1, y..y+1: its centre is at
 *              (x + 0.5, y + 0.5). Continuous positions on the image are called `screen`.
 *   Depth      larger is nearer; a cleared depth buffer holds minus infinity.
 *   Spaces     a name carries its space: world, view, clip (before the division by w), ndc (after
 *              it: -1..1 over the image), screen (pixels). `recip_w` is 1/w.
 *   Numbers    all vectors are double; positions on the screen are snapped once to 1/256 pixel
 *              (struct fixed2), and from there on integers decide what is covered.
 *
 * Only + - * / and sqrt, which IEEE 754 rounds in one way: every machine gets the same bytes.
 */
#ifndef COMMON_GEOMETRY_H
#define COMMON_GEOMETRY_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* ---- Vectors ---- */

struct vec2 {
    double x, y;
};

struct vec3 {
    double x, y, z;
};

/* A homogeneous position: it means (x/w, y/w, z/w); w = 0 is a direction. */
struct vec4 {
    double x, y, z, w;
};

static inline struct vec2 vec2_add(struct vec2 a, struct vec2 b) {
    return (struct vec2){a.x + b.x, a.y + b.y};
}

/* Nothing here calls it; solutions of lesson 6 may. */
static inline struct vec2 vec2_sub(struct vec2 a, struct vec2 b) {
    return (struct vec2){a.x - b.x, a.y - b.y};
}

static inline struct vec2 vec2_scale(struct vec2 a, double factor) {
    return (struct vec2){a.x * factor, a.y * factor};
}

static inline struct vec3 vec3_add(struct vec3 a, struct vec3 b) {
    return (struct vec3){a.x + b.x, a.y + b.y, a.z + b.z};
}

static inline struct vec3 vec3_sub(struct vec3 a, struct vec3 b) {
    return (struct vec3){a.x - b.x, a.y - b.y, a.z - b.z};
}

static inline struct vec3 vec3_scale(struct vec3 a, double factor) {
    return (struct vec3){a.x * factor, a.y * factor, a.z * factor};
}

static inline double vec3_dot(struct vec3 a, struct vec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/* Perpendicular to both, by the right-hand rule; its length is the area that they span. */
static inline struct vec3 vec3_cross(struct vec3 a, struct vec3 b) {
    return (struct vec3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static inline double vec3_length(struct vec3 a) {
    return sqrt(vec3_dot(a, a));
}

/* vec3_normalized() where the square of the length over- or underflows. */
struct vec3 vec3_normalized_slowly(struct vec3 a);

/* The vector of length 1 in the same direction, for any finite length; zero stays zero. */
static inline struct vec3 vec3_normalized(struct vec3 a) {
    double length_squared = vec3_dot(a, a);
    if (length_squared > 1e-280 && length_squared < 1e280) {
        return vec3_scale(a, 1 / sqrt(length_squared));
    }
    return vec3_normalized_slowly(a);
}

/* Bring a vector that is nearly of length 1 to the last bit or two: one step of Newton's method for
 * 1 / length. Zero stays zero. */
static inline struct vec3 vec3_renormalized(struct vec3 a) {
    return vec3_scale(a, 1.5 - 0.5 * vec3_dot(a, a));
}

/* Half the difference of two points: the difference itself could overflow. */
static inline struct vec3 vec3_half_difference(struct vec3 a, struct vec3 b) {
    return vec3_sub(vec3_scale(a, 0.5), vec3_scale(b, 0.5));
}

/* The world axis most nearly perpendicular to a direction: the one along which it is shortest. Of
 * equal ones y comes before x, and x before z. */
struct vec3 vec3_perpendicular_axis(struct vec3 direction);

/* All points between two corners. */
struct box3 {
    struct vec3 least, greatest;
};

/* A value inside a triangle from those at its corners. */
static inline double interpolate(struct vec3 weight, double a, double b, double c) {
    return weight.x * a + weight.y * b + weight.z * c;
}

/* A depth inside a triangle, explained in step05_zbuffer. The weights' sum may differ from 1 by a
 * rounding: written this way, three equal depths give this very depth all the same. No difference
 * of two depths may overflow. */
static inline double interpolate_depth(struct vec3 weight, double a, double b, double c) {
    return a + weight.y * (b - a) + weight.z * (c - a);
}

static inline struct vec2 vec2_interpolate(struct vec3 weight, struct vec2 a, struct vec2 b,
                                           struct vec2 c) {
    return (struct vec2){interpolate(weight, a.x, b.x, c.x), interpolate(weight, a.y, b.y, c.y)};
}

static inline struct vec3 vec3_interpolate(struct vec3 weight, struct vec3 a, struct vec3 b,
                                           struct vec3 c) {
    return (struct vec3){interpolate(weight, a.x, b.x, c.x), interpolate(weight, a.y, b.y, c.y),
                         interpolate(weight, a.z, b.z, c.z)};
}

/* The nearest level 0..255 (halves up, clamped; 0 for NaN). */
static inline uint8_t level_from(double value) {
    if (!(value > 0)) {
        return 0;
    }
    return value >= 255 ? 255 : (uint8_t)(value + 0.5);
}

/* (cos, sin) of an angle in whole turns: 0.25 is a right angle. Correct to 2 ulp of 1, the same on
 * every machine (unlike sin() of the C library), for |turns| up to 2^50. */
struct vec2 turn_direction(double turns);

/* ---- Matrices ---- */

struct mat4 {
    double m[4][4]; /* [row][column] */
};

struct mat4 mat4_identity(void);
struct mat4 mat4_mul(struct mat4 a, struct mat4 b); /* a * b: b is applied first */
struct mat4 mat4_transpose(struct mat4 a);

/* The inverse, by Gaussian elimination with row scaling and partial pivoting, then substitution
 * (Golub and Van Loan, "Matrix Computations"). False, with `inverse` unchanged, when the matrix is
 * not finite or singular to working precision: its condition number, after each row is scaled to
 * about 1, is 2^50 or more. */
bool mat4_inverse(struct mat4 a, struct mat4 *inverse);

struct mat4 mat4_translation(struct vec3 offset);
struct mat4 mat4_scaling(struct vec3 factor);

/* Rotation about an axis (of any length but 0) through the origin, counterclockwise when the axis
 * points at the viewer, in whole turns. */
struct mat4 mat4_rotation(struct vec3 axis, double turns);

static inline struct vec4 mat4_apply(const struct mat4 *a, struct vec4 p) {
    return (struct vec4){
        a->m[0][0] * p.x + a->m[0][1] * p.y + a->m[0][2] * p.z + a->m[0][3] * p.w,
        a->m[1][0] * p.x + a->m[1][1] * p.y + a->m[1][2] * p.z + a->m[1][3] * p.w,
        a->m[2][0] * p.x + a->m[2][1] * p.y + a->m[2][2] * p.z + a->m[2][3] * p.w,
        a->m[3][0] * p.x + a->m[3][1] * p.y + a->m[3][2] * p.z + a->m[3][3] * p.w,
    };
}

/* A point (w = 1), and a direction (w = 0: translation does not move it). */
static inline struct vec4 mat4_point(const struct mat4 *a, struct vec3 p) {
    return mat4_apply(a, (struct vec4){p.x, p.y, p.z, 1});
}

static inline struct vec3 mat4_direction(const struct mat4 *a, struct vec3 d) {
    struct vec4 r = mat4_apply(a, (struct vec4){d.x, d.y, d.z, 0});
    return (struct vec3){r.x, r.y, r.z};
}

#include "given/camera.h"
#include "given/parallel_view.h"

#endif
