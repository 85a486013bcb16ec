/* Pixels and texels in long double. */
#ifndef TESTS_ORACLE_TEXELS_H
#define TESTS_ORACLE_TEXELS_H

#include "oracle/reals.h"
#include "texture.h"

static inline long double real_clamped(long double value, long double most) {
    return value < 0 ? 0 : value > most ? most : value;
}

/* The nearest value of a channel. */
static inline uint8_t level_from_real(long double value) {
    return (uint8_t)(real_clamped(value, 255) + 0.5L);
}

/* Red, green, blue of a texel. */
static inline struct real3 real3_from_texel(const struct texture_level *level, size_t x, size_t y) {
    uint32_t t = texture_texel(level, x, y);
    return (struct real3){t >> 16 & 255, t >> 8 & 255, t & 255};
}

/* Red, green, blue, linear between the four nearest texel centres; clamped. */
static inline struct real3 real3_bilinear(const struct texture_level *level, long double u,
                                          long double v) {
    size_t last_x = level->width - 1, last_y = level->height - 1;
    u = real_clamped(u * (long double)level->width - 0.5L, (long double)last_x);
    v = real_clamped(v * (long double)level->height - 0.5L, (long double)last_y);
    size_t x = (size_t)u, y = (size_t)v;
    size_t right = x < last_x ? x + 1 : x, up = y < last_y ? y + 1 : y;
    struct real3 corner = real3_from_texel(level, x, y);
    struct real3 across = real3_sub(real3_from_texel(level, right, y), corner);
    struct real3 below = real3_add(corner, across, u - (long double)x);
    corner = real3_from_texel(level, x, up);
    across = real3_sub(real3_from_texel(level, right, up), corner);
    struct real3 above = real3_add(corner, across, u - (long double)x);
    return real3_add(below, real3_sub(above, below), v - (long double)y);
}

#endif
