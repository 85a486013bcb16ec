/*
 * Other ways to compute Phong's light, for the benchmark and for the lesson's wrong pictures.
 *
 * Include after the technique and the shaders of main.c.
 */
#ifndef STEP10_ATTEMPTS_H
#define STEP10_ATTEMPTS_H

#include <math.h>

/* ---- The power: base 0..1 to a whole power 0..POWER_LIMIT ---- */

enum { POWER_LIMIT = 128, POWER_TABLE_LIMIT = 1024 };

/* 1. The library's pow(): made for any exponent, so it takes a logarithm and an exponential. Its
 * last bit differs from one C library to the next, and so would the picture. */
static inline double attempt_1_pow(double base, int power) {
    return pow(base, power);
}

/* 2. A multiplication for each unit of the power. */
static inline double attempt_2_repeated(double base, int power) {
    double result = 1;
    for (int i = 0; i < power; i++) {
        result *= base;
    }
    return result;
}

/* 3. A table of the power at places from 0 to 1, straight between them. One table serves one
 * power. */
struct power_table {
    int last; /* place of 1; the first, 0, is that of 0 */
    double value[POWER_TABLE_LIMIT];
};

/* `size` values, 2..POWER_TABLE_LIMIT. */
static inline struct power_table attempt_3_make_table(int size, int power) {
    struct power_table table = {.last = size - 1};
    for (int i = 0; i < size; i++) {
        table.value[i] = integer_power((double)i / table.last, power);
    }
    return table;
}

static inline double attempt_3_table(const struct power_table *table, double base) {
    double place = base * table->last;
    int index = (int)place < table->last ? (int)place : table->last - 1;
    double part = place - index;
    return table->value[index] + part * (table->value[index + 1] - table->value[index]);
}

/* 4. Schlick's form t / (n - n t + t): looks like a power and needs one division (Schlick, "A Fast
 * Alternative to Phong's Specular Model", Graphics Gems IV, 1994). The lights become wider. */
static inline double attempt_4_schlick(double base, int power) {
    return base / (power - power * base + base);
}

/* ---- The normal ---- */

/* 5. The interpolated normal as it is: between two corners it is shorter than 1, so that the lights
 * fade in the middle of each face. */
static inline bool attempt_5_not_normalized(const void *uniforms, const double *varyings,
                                            struct color *color) {
    const struct uniforms *u = uniforms;
    struct vec3 normal = {varyings[5], varyings[6], varyings[7]};
    *color = illuminate(u, &u->material, normal, position_of(varyings));
    return true;
}

/* ---- Wrong light ---- */

/* 6. No clamping: where the mirrored light points away from the eye its scalar product is negative,
 * and an even power makes that positive. Surfaces turned away from the light shine, too. */
static inline bool attempt_6_not_clamped(const void *uniforms, const double *varyings,
                                         struct color *color) {
    const struct uniforms *u = uniforms;
    struct vec3 normal = mesh_normal(varyings);
    struct vec3 to_eye = vec3_normalized(vec3_sub(u->eye, position_of(varyings)));
    double diffuse = vec3_dot(normal, u->to_light);
    double mirrored = vec3_dot(reflect(normal, u->to_light), to_eye);
    double specular = u->material.specular * integer_power(mirrored, u->material.power);
    double scattered = u->material.ambient + u->material.diffuse * diffuse;
    struct vec4 rgb = u->material.color;
    *color = color_rgb(level_from(rgb.x * scattered + 255 * specular),
                       level_from(rgb.y * scattered + 255 * specular),
                       level_from(rgb.z * scattered + 255 * specular));
    return true;
}

/* 7. The direction from the light instead of the one to it: the far side is lit. */
static inline bool attempt_7_light_reversed(const void *uniforms, const double *varyings,
                                            struct color *color) {
    struct uniforms u = *(const struct uniforms *)uniforms;
    u.to_light = vec3_scale(u.to_light, -1);
    *color = illuminate(&u, &u.material, mesh_normal(varyings), position_of(varyings));
    return true;
}

#endif
