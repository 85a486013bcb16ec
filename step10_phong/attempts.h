/*
 * Other ways to compute Phong's light, for the benchmark and for the lesson's figures.
 *
 * Include after the technique and the shaders of main.c.
 */
#ifndef STEP10_ATTEMPTS_H
#define STEP10_ATTEMPTS_H

#include <math.h>

/* ---- The power: base 0..1 to a whole power 0..POWER_LIMIT, for several pixels ---- */

enum { POWER_LIMIT = 128, POWER_TABLE_LIMIT = 1024 };

/* 1. The library's pow(): made for any exponent, so it takes a logarithm and an exponential, and
 * for one pixel at a time. Its last bit differs from one C library to the next, and so would the
 * picture. */
static inline lanes attempt_1_pow(lanes base, int power) {
    real value[LANES];
    memcpy(value, &base, sizeof value);
    for (int i = 0; i < LANES; i++) {
        value[i] = (real)pow((double)value[i], power);
    }
    memcpy(&base, value, sizeof value);
    return base;
}

/* 2. A multiplication for each unit of the power. */
static inline lanes attempt_2_repeated(lanes base, int power) {
    lanes result = lanes_all(1);
    for (int i = 0; i < power; i++) {
        result *= base;
    }
    return result;
}

/* 3. A table of the power at places from 0 to 1, straight between them. One table serves one
 * power. */
struct power_table {
    int last; /* place of 1; the first, 0, is that of 0 */
    real value[POWER_TABLE_LIMIT];
};

/* `size` values, 2..POWER_TABLE_LIMIT. */
static inline struct power_table attempt_3_make_table(int size, int power) {
    struct power_table table = {.last = size - 1};
    for (int i = 0; i < size; i++) {
        table.value[i] = (real)pow((double)i / table.last, power);
    }
    return table;
}

static inline lanes attempt_3_table(const struct power_table *table, lanes base) {
    lanes place = base * (real)table->last;
    lanes_int index = lanes_to_int(lanes_min(place, lanes_all((real)(table->last - 1))));
    int32_t at[LANES];
    real lower[LANES], upper[LANES];
    memcpy(at, &index, sizeof at);
    for (int i = 0; i < LANES; i++) {
        lower[i] = table->value[at[i]];
        upper[i] = table->value[at[i] + 1];
    }
    lanes from, to;
    memcpy(&from, lower, sizeof from);
    memcpy(&to, upper, sizeof to);
    return from + (place - lanes_from_int(index)) * (to - from);
}

/* 4. Schlick's form t / (n - n t + t): looks like a power and needs one division (Schlick, "A Fast
 * Alternative to Phong's Specular Model", Graphics Gems IV, 1994). The lights become wider. */
static inline lanes attempt_4_schlick(lanes base, int power) {
    return base / ((real)power - (real)power * base + base);
}

/* ---- The normal ---- */

/* 5. The interpolated normal as it is: between two corners it is shorter than 1, so that the lights
 * fade in the middle of each face. */
static inline lanes_mask attempt_5_not_normalized(const void *uniforms, const lanes *varyings,
                                                  lanes_texel *color) {
    const struct uniforms *u = uniforms;
    struct surface surface = plain_surface(u, varyings);
    surface.normal = (struct lanes3){varyings[5], varyings[6], varyings[7]};
    *color = illuminate(u, &surface);
    return lanes_all_set();
}

#endif
