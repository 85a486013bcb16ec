/*
 * Textures: an image made ready for sampling, and its mip levels.
 *
 * Taught in step06_texture: read that first. Texture coordinates are (0,0) at the bottom-left
 * corner of the image and (1,1) at its top-right corner; texel (i,j) covers u in [i/width,
 * (i+1)/width), so its centre is at ((i+0.5)/width, (j+0.5)/height). Outside 0..1 the picture
 * repeats or, where it is clamped, its edge texels do; a coordinate that is not a number counts as
 * 0. All is the same on every machine: the mip levels are computed with whole numbers, sampling
 * (given/bilinear.h) with + - * of doubles.
 */
#ifndef COMMON_TEXTURE_H
#define COMMON_TEXTURE_H

#include "base/error.h"
#include "geometry.h"
#include "tgaimage.h"

#include <stddef.h>
#include <stdint.h>

enum {
    TEXTURE_LEVEL_LIMIT = 17,     /* 65535 = 2^16 - 1 halves 15 times down to 1 */
    TEXTURE_TEXEL_LIMIT = 1 << 30 /* of a level: where one is, in bytes, then takes 32 bits */
};

/* One size of the picture. A texel is blue | green << 8 | red << 16 | alpha << 24. */
struct texture_level {
    size_t width, height; /* 1..IMAGE_SIZE_LIMIT */
    size_t pitch;         /* texels from a row to the next one above it; see texture_pitch() */
    /* Bottom row first; see texture_texel(). Behind each row and above the last one the first texel
     * and the first row come again, so that the neighbours of every texel can be read. */
    uint32_t *texels;
    /* To sample with: both sizes; 1 over them, or 0 where the picture clamps; the last place
     * between texel centres on both axes. */
    float columns, rows, recip_columns, recip_rows, most_columns, most_rows;
    uint64_t kind; /* the same in levels of equal size that both repeat, or both clamp */
};

/* Texel (x,y), counted from the lower left; x is below `width`, y below `height`. */
static inline uint32_t texture_texel(const struct texture_level *level, size_t x, size_t y) {
    return level->texels[y * level->pitch + x];
}

/* All zero is a valid, empty texture (not to be sampled). */
struct texture {
    size_t level_count;                              /* at least 1 once created */
    struct texture_level level[TEXTURE_LEVEL_LIMIT]; /* 0 is the image, each next half of it */
    bool clamp; /* outside 0..1 the edge texels repeat, not the picture: texture_set_clamp() */
    bool tangent_space; /* of a normal map: see tangent.h; otherwise it is in object space */
    bool space_guessed; /* the normal map's looks, not its name, said in which space it is */
    uint32_t *texels;   /* of all levels, owned by the texture */
};

/* How far rows of that many texels, and one more, lie apart: 16 texels (the 64 bytes of a cache
 * line), an odd number of times. With a power of two, as widths mostly are, texels above each other
 * would compete for the same few lines of the cache, and push each other out. */
static inline size_t texture_pitch(size_t width) {
    return 16 * ((width + 16) / 16 | 1);
}

/* Make a texture of an image: 32-bit texels and its mip levels down to 1x1. Each level has half the
 * width and height of the one below, rounded down but at least 1; each texel is the mean of the
 * area of the level below that it covers (texels that are covered in part count in part), rounded
 * to the nearest level. Grey becomes three equal channels, a missing alpha 255. The caller frees
 * both. False when memory runs out, or of an image without pixels, and of one that has more than
 * TEXTURE_TEXEL_LIMIT in rows that lie texture_pitch() apart. */
bool texture_create(struct texture *texture, const struct image *image, struct error *error);

/* The same with at most `limit` levels, or all where this is 0: 1 is enough to sample level 0. */
bool texture_create_levels(struct texture *texture, const struct image *image, size_t limit,
                           struct error *error);

/* Clamp, or repeat as textures do at first. */
void texture_set_clamp(struct texture *texture, bool clamp);

/* Free the texels and leave an empty texture. */
void texture_free(struct texture *texture);

static inline struct color color_from_texel(uint32_t texel) {
    return (struct color){
        .b = (uint8_t)(texel & 255),
        .g = (uint8_t)(texel >> 8 & 255),
        .r = (uint8_t)(texel >> 16 & 255),
        .a = (uint8_t)(texel >> 24),
    };
}

/* Red, green, blue, alpha as x, y, z, w. */
static inline struct vec4 channels_from_texel(uint32_t texel) {
    struct color c = color_from_texel(texel);
    return (struct vec4){c.r, c.g, c.b, c.a};
}

/* A coordinate in texels brought into 0..last; NaN becomes 0. Written so that
 * compilers make two selects of it and no branch. */
static inline double texture_clamp(double texels, double last) {
    double positive = texels > 0 ? texels : 0;
    return positive < last ? positive : last;
}

/* from + (to - from) * fraction for each channel. */
static inline struct vec4 texture_mix(struct vec4 from, struct vec4 to, double fraction) {
    return (struct vec4){from.x + (to.x - from.x) * fraction, from.y + (to.y - from.y) * fraction,
                         from.z + (to.z - from.z) * fraction, from.w + (to.w - from.w) * fraction};
}

/* The mip level of a texture that is wrapped once around the model at which a texel is about as
 * large as a pixel: half of the texture's width is seen over `pixels` pixels. NULL has level 0. */
size_t texture_wrapped_level(const struct texture *texture, double pixels);

#include "given/bilinear.h"

#endif
