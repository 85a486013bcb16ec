/*
 * The sculptor's clay: points, round solids that melt into each other, smooth bumps and noise.
 *
 * A solid is a function of a point: its (approximate) distance to the surface, negative inside. The
 * minimum of two distances is the union of two solids; a minimum that is rounded where the two are
 * nearly equal presses two lumps of clay together (Inigo Quilez, "Smooth minimum", articles on
 * signed distance functions).
 *
 * Every function here uses sums, products, quotients, square roots and floor only. All of these are
 * rounded the same way on every machine, so every machine sculpts the same bytes.
 */
#ifndef COMMON_SCULPTOR_CLAY_H
#define COMMON_SCULPTOR_CLAY_H

#include "geometry.h"

#include <math.h>
#include <stdint.h>

/* The number of elements of an array. */
#define COUNT(array) ((int)(sizeof(array) / sizeof((array)[0])))

/* A point or a direction: x to the sitter's left, y up, z out of the face. */
static inline struct vec3 at(double x, double y, double z) {
    return (struct vec3){x, y, z};
}

/* a at t = 0, b at t = 1. */
static inline double mix(double a, double b, double t) {
    return a + (b - a) * t;
}

static inline struct vec3 vec3_mix(struct vec3 a, struct vec3 b, double t) {
    return (struct vec3){mix(a.x, b.x, t), mix(a.y, b.y, t), mix(a.z, b.z, t)};
}

static inline double clamp(double x, double low, double high) {
    return x < low ? low : x > high ? high : x;
}

/* 0 up to `low`, 1 from `high` on, a smooth S between (low < high). */
static inline double ramp(double low, double high, double x) {
    double t = clamp((x - low) / (high - low), 0, 1);
    return t * t * (3 - 2 * t);
}

/* The other way round: 1 up to `low`, 0 from `high` on. */
static inline double fall(double low, double high, double x) {
    return 1 - ramp(low, high, x);
}

/* A smooth hill: 1 at q = 0, 0 from q = 1 on. `q` is a squared distance over a squared radius. */
static inline double hump(double q) {
    if (q >= 1) {
        return 0;
    }
    return (1 - q) * (1 - q) * (1 - q);
}

static inline double square(double x) {
    return x * x;
}

/* A smooth ridge across x: 1 at 0, 0 from -1 down and from 1 up. */
static inline double ridge(double x) {
    return hump(x * x);
}

/* A hill at `center` that reaches `radius` along each axis. */
static inline double hill(struct vec3 p, struct vec3 center, struct vec3 radius) {
    return hump(square((p.x - center.x) / radius.x) + square((p.y - center.y) / radius.y) +
                square((p.z - center.z) / radius.z));
}

/* Union with a seam rounded over `k`, the range of distances in which both solids give way. */
static inline double join(double a, double b, double k) {
    double h = k - fabs(a - b);
    double least = a < b ? a : b;
    return h > 0 ? least - h * h / (4 * k) : least;
}

/* a without b, the cut's edge rounded over `k`. */
static inline double carve(double a, double b, double k) {
    return -join(-a, b, k);
}

/* About the distance to an ellipsoid with half-axes `radius` (exact for a sphere). */
static inline double ellipsoid(struct vec3 p, struct vec3 center, struct vec3 radius) {
    struct vec3 q = {(p.x - center.x) / radius.x, (p.y - center.y) / radius.y,
                     (p.z - center.z) / radius.z};
    double k0 = vec3_length(q);
    double k1 = vec3_length((struct vec3){q.x / radius.x, q.y / radius.y, q.z / radius.z});
    return k1 > 1e-9 ? k0 * (k0 - 1) / k1 : -radius.x;
}

static inline double ball(struct vec3 p, struct vec3 center, double radius) {
    return vec3_length(vec3_sub(p, center)) - radius;
}

/* A rod from a to b with round ends, its radius going from ra to rb. */
static inline double rod(struct vec3 p, struct vec3 a, struct vec3 b, double ra, double rb) {
    struct vec3 axis = vec3_sub(b, a), from_a = vec3_sub(p, a);
    double t = clamp(vec3_dot(from_a, axis) / vec3_dot(axis, axis), 0, 1);
    return vec3_length(vec3_sub(from_a, vec3_scale(axis, t))) - mix(ra, rb, t);
}

/* Smooth noise in -1..1 whose hills are about 1 wide; `seed` chooses the pattern. */
double noise(struct vec3 p, uint32_t seed);

/* A curve y(x) through `count` knots of ascending x, smooth between them and without overshoot
 * (Fritsch and Butland, "A method for constructing local monotone piecewise cubic interpolants",
 * 1984); constant outside. */
double curve(const double (*knots)[2], int count, double x);

#endif
