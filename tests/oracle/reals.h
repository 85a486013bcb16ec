/* Vectors of long double, for exact enough answers. */
#ifndef TESTS_ORACLE_REALS_H
#define TESTS_ORACLE_REALS_H

#include "geometry.h"

#include <math.h>

struct real3 {
    long double x, y, z;
};

static inline struct real3 real3_from(struct vec3 v) {
    return (struct real3){v.x, v.y, v.z};
}

static inline struct real3 real3_scale(struct real3 a, long double factor) {
    return (struct real3){a.x * factor, a.y * factor, a.z * factor};
}

/* a + b * factor */
static inline struct real3 real3_add(struct real3 a, struct real3 b, long double factor) {
    return (struct real3){a.x + b.x * factor, a.y + b.y * factor, a.z + b.z * factor};
}

static inline struct real3 real3_sub(struct real3 a, struct real3 b) {
    return real3_add(a, b, -1);
}

static inline long double real3_dot(struct real3 a, struct real3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline struct real3 real3_cross(struct real3 a, struct real3 b) {
    return (struct real3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static inline long double real3_length(struct real3 a) {
    return sqrtl(real3_dot(a, a));
}

/* Of length 1; zero stays zero. */
static inline struct real3 real3_unit(struct real3 a) {
    long double length = real3_length(a);
    return length > 0 ? real3_scale(a, 1 / length) : a;
}

#endif
