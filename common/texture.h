/*
 * Textures: an image made ready for sampling, and the ways to sample it.
 *
 * Taught in step06_texture: read that first. Texture coordinates are (0,0) at the bottom-left
 * corner of the image and (1,1) at its top-right corner; texel (i,j) covers u in [i/width,
 * (i+1)/width), so its centre is at ((i+0.5)/width, (j+0.5)/height). Outside 0..1 the edge texel is
 * repeated; a coordinate that is not a number counts as 0.
 */
#ifndef COMMON_TEXTURE_H
#define COMMON_TEXTURE_H

#include "file.h"
#include "geometry.h"
#include "tgaimage.h"

#include <stddef.h>
#include <stdint.h>

enum { TEXTURE_LEVEL_LIMIT = 17 }; /* 65535 = 2^16 - 1 halves 15 times down to 1 */

/* One size of the picture. A texel is blue | green << 8 | red << 16 | alpha << 24. */
struct texture_level {
    size_t width, height;
    uint32_t *texels; /* height * width, bottom row first */
};

/* All zero is a valid, empty texture (not to be sampled). */
struct texture {
    size_t level_count; /* at least 1 once created */
    struct texture_level
        level[TEXTURE_LEVEL_LIMIT]; /* level 0 is the image, each next half of it */
    uint32_t *texels;               /* of all levels, owned by the texture */
};

/* Make a texture of an image: 32-bit texels and its mip levels down to 1x1, each texel the mean of
 * the area that it covers. The caller frees both. */
bool texture_create(struct texture *texture, const struct image *image, struct error *error);

/* Free the texels and leave an empty texture. */
void texture_free(struct texture *texture);

/* The texel that holds the point. */
struct color texture_nearest(const struct texture *texture, struct vec2 uv);

/* Linear between the four nearest texel centres of one level (clamped to the last one). The result
 * is red, green, blue, alpha as x, y, z, w in levels 0..255, not rounded. */
struct vec4 texture_bilinear(const struct texture *texture, struct vec2 uv, size_t level);

/* Linear between the two nearest mip levels; `level` 0 is full size, 1 half, and so on. */
struct vec4 texture_trilinear(const struct texture *texture, struct vec2 uv, double level);

#endif
