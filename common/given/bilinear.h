/* The bilinear sample. You write this in lesson 6; it is given from lesson 7 on. */
#ifndef COMMON_GIVEN_BILINEAR_H
#define COMMON_GIVEN_BILINEAR_H

#ifndef COMMON_TEXTURE_H
#error "include texture.h instead"
#endif

#include "given/later.h"

#include <math.h>

/* ---- The bilinear sample (taught in step06_texture) ---- */

/* texture_mix() of the channels of two texels. */
static inline struct vec4 texture_mix_texels(uint32_t from, uint32_t to, double fraction) {
    int r = (int)(from >> 16 & 0xFF), g = (int)(from >> 8 & 0xFF), b = (int)(from & 0xFF);
    int a = (int)(from >> 24);
    return (struct vec4){
        r + ((int)(to >> 16 & 0xFF) - r) * fraction, g + ((int)(to >> 8 & 0xFF) - g) * fraction,
        b + ((int)(to & 0xFF) - b) * fraction, a + ((int)(to >> 24) - a) * fraction};
}

/* Where a coordinate lies on an axis of `size` texels: 0 at the centre of the first one, 1 at that
 * of the second. Behind the last one comes the first again, at `size`; not where it clamps. */
static inline double texture_place(double coordinate, double size, bool clamp) {
    if (clamp) {
        return texture_clamp(coordinate * size - 0.5, size - 1);
    }
    double place = texture_clamp(coordinate - floor(coordinate), 1) * size - 0.5;
    return place < 0 ? place + size : place;
}

/* Linear between the four nearest texel centres of one level (clamped to the last one). The result
 * is red, green, blue, alpha as x, y, z, w in values 0..255, not rounded. */
static inline struct vec4 texture_bilinear(const struct texture *texture, struct vec2 uv,
                                           size_t level) {
    size_t last_level = texture->level_count - 1;
    const struct texture_level *l = &texture->level[level < last_level ? level : last_level];
    double u = texture_place(uv.x, (double)(uint32_t)l->width, texture->clamp);
    double v = texture_place(uv.y, (double)(uint32_t)l->height, texture->clamp);
    uint32_t x = (uint32_t)u, y = (uint32_t)v;
    const uint32_t *lower = l->texels + y * l->pitch + x, *upper = lower + l->pitch;
    double across = u - x, along = v - y;
    return texture_mix(texture_mix_texels(lower[0], lower[1], across),
                       texture_mix_texels(upper[0], upper[1], across), along);
}

#if COURSE_LESSON <= 6
#define texture_mix_texels GIVEN_LATER(texture_mix_texels, lesson 6, 7)
#define texture_place      GIVEN_LATER(texture_place, lesson 6, 7)
#define texture_bilinear   GIVEN_LATER(texture_bilinear, lesson 6, 7)
#endif /* COURSE_LESSON */

#endif
