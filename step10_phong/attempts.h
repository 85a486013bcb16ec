/*
 * Other ways to compute Phong's light, for the benchmark and for the lesson's wrong pictures.
 *
 * Include after the technique and the shaders of main.c.
 */
#ifndef STEP10_ATTEMPTS_H
#define STEP10_ATTEMPTS_H

#include <math.h>

/* ---- The power: base 0..1 to a whole power 0..POWER_LIMIT, for sixteen pixels ---- */

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

/* ---- Wrong light ---- */

/* 6. No clamping: where the mirrored light points away from the eye its scalar product is negative,
 * and an even power makes that positive. Surfaces turned away from the light shine, too. */
static inline lanes_mask attempt_6_not_clamped(const void *uniforms, const lanes *varyings,
                                               lanes_texel *color) {
    const struct uniforms *u = uniforms;
    struct surface surface = plain_surface(u, varyings);
    struct lanes3 normal = mesh_normal(varyings), to_light = lanes3_all(u->to_light);
    struct lanes3 to_eye = lanes3_normalized(surface.to_eye);
    lanes mirrored = lanes3_dot(reflect(normal, to_light), to_eye);
    lanes power = integer_power(mirrored, surface.power, surface.largest_power);
    lanes shine = 255 * surface.specular * power;
    lanes scattered =
        (real)u->material.ambient + (real)u->material.diffuse * lanes3_dot(normal, to_light);
    *color = lanes_rgb(surface.color.x * scattered + shine, surface.color.y * scattered + shine,
                       surface.color.z * scattered + shine);
    return lanes_all_set();
}

/* 7. The direction from the light instead of the one to it: the far side is lit. */
static inline lanes_mask attempt_7_light_reversed(const void *uniforms, const lanes *varyings,
                                                  lanes_texel *color) {
    struct uniforms u = *(const struct uniforms *)uniforms;
    u.to_light = vec3_scale(u.to_light, -1);
    return plain_fragment(&u, varyings, color);
}

/* 8. r = l - 2 (n . l) n: points into the surface, so that no eye is near it. */
static inline lanes_mask attempt_8_wrong_sign(const void *uniforms, const lanes *varyings,
                                              lanes_texel *color) {
    struct uniforms u = *(const struct uniforms *)uniforms;
    struct lanes3 to_light = lanes3_all(u.to_light), normal = mesh_normal(varyings);
    struct lanes3 to_eye = {varyings[0], varyings[1], varyings[2]}, r = reflect(normal, to_light);
    lanes zero = lanes_all(0), diffuse = lanes_max(lanes3_dot(normal, to_light), zero);
    lanes mirrored = lanes_max(-lanes3_dot(r, lanes3_normalized(to_eye)), zero);
    lanes power = integer_power(mirrored, lanes_all((real)u.material.power), u.material.power);
    lanes shine = lanes_select(diffuse > 0, 255 * (real)u.material.specular * power, zero);
    lanes scattered = (real)u.material.ambient + (real)u.material.diffuse * diffuse;
    *color = lanes_rgb((real)u.material.color.x * scattered + shine,
                       (real)u.material.color.y * scattered + shine,
                       (real)u.material.color.z * scattered + shine);
    return lanes_all_set();
}

/* 9. Blue, green, red of the normal map taken as x, y, z, in the order of the file. */
static inline lanes_mask attempt_9_file_order(const void *uniforms, const lanes *varyings,
                                              lanes_texel *color) {
    const struct uniforms *u = uniforms;
    struct surface surface = plain_surface(u, varyings);
    struct lanes3 n = mapped_normal(u, varyings);
    surface.normal = (struct lanes3){n.z, n.y, n.x};
    *color = illuminate(u, &surface);
    return lanes_all_set();
}

#endif
