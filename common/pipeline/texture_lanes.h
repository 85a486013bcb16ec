/*
 * The bilinear sample that lesson 6 teaches, for LANES pixels at once: see lanes.h.
 *
 * A sample mixes the four texels around a place in a texture. Each lane has a place of its own, so
 * the texels of a sample may be anywhere in memory, and a processor waits long for those that are
 * not in its cache. So the sample comes in steps, and a shader can do a step for all its textures
 * before the next step: find the places, fetch the texels, mix them. texture_lanes() does all
 * three.
 */
#ifndef COMMON_PIPELINE_TEXTURE_LANES_H
#define COMMON_PIPELINE_TEXTURE_LANES_H

#include "pipeline/vectors.h"
#include "texture.h"

/* A place between texel centres along one axis: the lower of its two neighbours, and how far the
 * place is from this one towards the other, 0 to 1. */
struct lanes_place {
    lanes_int texel;
    lanes fraction;
};

/* Find the place of a texture coordinate along an axis of `size` texels. A texture that repeats has
 * `recip` = 1 / size, and whole repetitions are subtracted; one that clamps has 0, and the place
 * stays between 0 and `most`. Coordinates beyond 2^22, which have hardly a fraction left,
 * and NaN get some place in the picture. */
LANES_INLINE struct lanes_place lanes_find_texel(lanes coordinate, real size, real recip,
                                                 real most) {
    lanes place = coordinate * size - 0.5f;
    place -= lanes_floor_any(place * recip) * size;
    place = lanes_min(lanes_max(place, lanes_all(0)), lanes_all(most));
    lanes_int texel = lanes_to_int(place);
    return (struct lanes_place){texel, place - lanes_from_int(texel)};
}

/* Where each lane's four texels are in a level. Levels of one kind have the same size and edges, so
 * the place in one of them is the place in all. */
struct texel_place {
    uint64_t kind;       /* of the level; 0: no place is found yet */
    lanes_texel bytes;   /* from the level's first texel to the lower left one */
    lanes across, along; /* how far the place is from this one to the right and up, 0 to 1 */
};

/* The four texels, mixed by texels_mix(). */
struct texels {
    lanes_texel texel[4]; /* lower left, lower right, upper left, upper right */
    lanes weight[4];      /* sum 1 */
};

/* Find the places of texture coordinates in a level. */
LANES_INLINE struct texel_place texture_find(const struct texture_level *level, lanes u, lanes v) {
    struct lanes_place x =
        lanes_find_texel(u, level->columns, level->recip_columns, level->most_columns);
    struct lanes_place y = lanes_find_texel(v, level->rows, level->recip_rows, level->most_rows);
    lanes_texel texel = (lanes_texel)y.texel * (uint32_t)level->pitch + (lanes_texel)x.texel;
    return (struct texel_place){level->kind, texel * (uint32_t)sizeof *level->texels, x.fraction,
                                y.fraction};
}

/* Ask the memory for texels in two rows some way above these: the pixels above will need them or
 * their neighbours, and find them in the cache. (Beyond the texture this does nothing.) */
LANES_INLINE void texture_expect(const struct texture_level *level, const uint32_t *texels,
                                 lanes_texel bytes) {
    enum { ROWS_AHEAD = 10 };
    uintptr_t row = level->pitch * sizeof *texels;
    for (int i = 0; i < 3; i++) { /* the first, one in the middle, the last */
        uintptr_t ahead =
            (uintptr_t)texels + lanes_texel_at(bytes, i * (LANES - 1) / 2) + ROWS_AHEAD * row;
        __builtin_prefetch((const void *)ahead);
        __builtin_prefetch((const void *)(ahead + row));
    }
}

/* The level of that number, or else the last one. */
LANES_INLINE const struct texture_level *texture_level_of(const struct texture *texture,
                                                          size_t level) {
    size_t last_level = texture->level_count - 1;
    return &texture->level[level < last_level ? level : last_level];
}

/* Fetch the four texels of each lane, and find their weights. */
LANES_INLINE struct texels texels_fetch(const struct texture_level *level,
                                        const struct texel_place *place) {
    struct texels t;
    lanes_fetch_pairs(level->texels, place->bytes, &t.texel[0], &t.texel[1]);
    lanes_fetch_pairs(level->texels + level->pitch, place->bytes, &t.texel[2], &t.texel[3]);
    texture_expect(level, level->texels, place->bytes);
    t.weight[3] = place->across * place->along;
    t.weight[2] = place->along - t.weight[3];
    t.weight[1] = place->across - t.weight[3];
    t.weight[0] = 1 - place->across - t.weight[2];
    return t;
}

/* Find the place, unless `place` has it already, and fetch the texels from one level (or else the
 * last one). `place` is all zero or comes from the last fetch at the same uv: textures of one size
 * have the same places. Fetch from several textures first and mix later, so that the processor
 * waits for all of them at once. */
LANES_INLINE struct texels texture_fetch(const struct texture *texture, struct lanes2 uv,
                                         size_t level, struct texel_place *place) {
    const struct texture_level *l = texture_level_of(texture, level);
    if (place->kind != l->kind) {
        *place = texture_find(l, uv.x, uv.y);
    }
    return texels_fetch(l, place);
}

/* Mix one channel of the four texels, the bits of `mask`. They are not shifted down, so the result
 * is too large by the factor of the mask's lowest bit. */
LANES_INLINE lanes texels_mix_channel(const struct texels *t, uint32_t mask) {
    lanes channel[4];
    for (int i = 0; i < 4; i++) {
        channel[i] = lanes_from_int((lanes_int)(t->texel[i] & mask)) * t->weight[i];
    }
    return (channel[0] + channel[1]) + (channel[2] + channel[3]);
}

/* Mix the four texels: red, green, blue as x, y, z in levels 0..255, not rounded. The compiler
 * leaves out channels that the caller does not use: for a grey texture, take z alone. */
LANES_INLINE struct lanes3 texels_mix(const struct texels *t) {
    return (struct lanes3){texels_mix_channel(t, 0xFF0000) * (1 / 65536.0f),
                           texels_mix_channel(t, 0xFF00) * (1 / 256.0f),
                           texels_mix_channel(t, 0xFF)};
}

/* The bilinear sample, in one step. */
LANES_INLINE struct lanes3 texture_lanes(const struct texture *texture, struct lanes2 uv,
                                         size_t level) {
    struct texel_place place = {0};
    struct texels texels = texture_fetch(texture, uv, level, &place);
    return texels_mix(&texels);
}

#endif
