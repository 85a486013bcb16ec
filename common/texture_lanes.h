/*
 * The bilinear sample of texture.h for sixteen pixels at once: see lanes.h.
 */
#ifndef COMMON_TEXTURE_LANES_H
#define COMMON_TEXTURE_LANES_H

#include "lanes.h"
#include "texture.h"
#ifndef PREFETCH_STEP
#define PREFETCH_STEP 5
#endif

/* One channel of the four texels around each place, mixed. */
LANES_INLINE lanes lanes_mix_channel(const lanes_texel texel[4], int shift, lanes across,
                                     lanes along) {
    lanes channel[4];
    for (int i = 0; i < 4; i++) {
        channel[i] = lanes_from_int((lanes_int)(texel[i] >> shift & 0xFF));
    }
    lanes lower = channel[0] + (channel[1] - channel[0]) * across;
    lanes upper = channel[2] + (channel[3] - channel[2]) * across;
    return lower + (upper - lower) * along;
}

/* A place between texel centres along one axis: the lower one of its two neighbours, and how far it
 * lies towards the other, 0..1. */
struct lanes_place {
    lanes_int texel;
    lanes fraction;
};

LANES_INLINE struct lanes_place lanes_find_texel(lanes coordinate, size_t size) {
    real last = (real)(uint32_t)(size - 1), last_lower = size > 1 ? last - 1 : 0;
    lanes place = coordinate * (last + 1) - 0.5f;
    place = lanes_min(lanes_max(place, lanes_all(0)), lanes_all(last));
    lanes_int texel = lanes_to_int(lanes_min(place, lanes_all(last_lower)));
    return (struct lanes_place){texel, place - lanes_from_int(texel)};
}

/* Two neighbours of a row in one word. (The last texel of a texture is followed by one more.) */
static inline uint64_t texel_pair(const uint32_t *texels) {
    return texels[0] | (uint64_t)texels[1] << 32;
}

/* Where the lower left of the four texels around each pixel's place is, and how far the place lies
 * between them. */
struct texel_place {
    uint32_t index[LANES];
    lanes across, along;
    size_t up; /* from a texel to the one above */
    const uint32_t *texels;
};

LANES_INLINE struct texel_place texture_place(const struct texture *texture, struct lanes2 uv,
                                              size_t level) {
    size_t last_level = texture->level_count - 1;
    const struct texture_level *l = &texture->level[level < last_level ? level : last_level];
    struct lanes_place x = lanes_find_texel(uv.x, l->width), y = lanes_find_texel(uv.y, l->height);
    lanes_texel index = (lanes_texel)y.texel * (uint32_t)l->width + (lanes_texel)x.texel;
    struct texel_place place = {.across = x.fraction,
                                .along = y.fraction,
                                .up = l->height > 1 ? l->width : 0,
                                .texels = l->texels};
    memcpy(place.index, &index, sizeof place.index);
    return place;
}

LANES_INLINE void texture_prefetch(const struct texture *texture, struct lanes2 uv, size_t level) {
    struct texel_place place = texture_place(texture, uv, level);
    for (int i = 0; i < LANES; i += PREFETCH_STEP) {
        __builtin_prefetch(place.texels + place.index[i]);
        __builtin_prefetch(place.texels + place.index[i] + place.up);
    }
}

/* The four texels around each pixel's place, and how far it lies between them. */
struct texels {
    lanes_texel texel[4]; /* lower left, lower right, upper left, upper right */
    lanes across, along;  /* 0..1 */
};

/* Fetch from one level (clamped to the last one). Memory is slow: fetch what is needed from several
 * textures first, and mix then, so that the processor waits for all of it at once. */
LANES_INLINE struct texels texture_fetch(const struct texture *texture, struct lanes2 uv,
                                         size_t level) {
    struct texel_place place = texture_place(texture, uv, level);
    uint64_t lower[LANES], upper[LANES];
    for (int i = 0; i < LANES; i++) {
        lower[i] = texel_pair(place.texels + place.index[i]);
        upper[i] = texel_pair(place.texels + place.index[i] + place.up);
    }
    struct texels texels = {.across = place.across, .along = place.along};
    lanes_split(lower, &texels.texel[0], &texels.texel[1]);
    lanes_split(upper, &texels.texel[2], &texels.texel[3]);
    return texels;
}

/* Linear between the texels: red, green, blue as x, y, z in levels 0..255, not rounded. What is not
 * used of it is not computed: of a grey texture, take x. */
LANES_INLINE struct lanes3 texels_mix(const struct texels *t) {
    return (struct lanes3){lanes_mix_channel(t->texel, 16, t->across, t->along),
                           lanes_mix_channel(t->texel, 8, t->across, t->along),
                           lanes_mix_channel(t->texel, 0, t->across, t->along)};
}

/* Both: the bilinear sample. */
LANES_INLINE struct lanes3 texture_lanes(const struct texture *texture, struct lanes2 uv,
                                         size_t level) {
    struct texels texels = texture_fetch(texture, uv, level);
    return texels_mix(&texels);
}

#endif
