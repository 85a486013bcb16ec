/*
 * For tests of the pipeline: small models made in memory, and pictures that show a varying to the
 * last bit, as the bits of its `real` in the four bytes of a pixel (or of two pixels, for doubles).
 */
#ifndef TESTS_ORACLE_SHOWN_H
#define TESTS_ORACLE_SHOWN_H

#include "pipeline.h"

#include <string.h>

static inline void set_corners(struct face *face, uint32_t a, uint32_t b, uint32_t c) {
    *face = (struct face){
        {{a, MODEL_NONE, MODEL_NONE}, {b, MODEL_NONE, MODEL_NONE}, {c, MODEL_NONE, MODEL_NONE}}};
}

/* A model of positions and faces alone. `corners` are the positions of each face; NULL: those of
 * face i are 3 i to 3 i + 2. */
static inline struct model plain_model(struct vec3 *positions, size_t position_count,
                                       struct face *faces, size_t face_count,
                                       const uint32_t (*corners)[3]) {
    for (uint32_t i = 0; i < face_count; i++) {
        if (corners != NULL) {
            set_corners(&faces[i], corners[i][0], corners[i][1], corners[i][2]);
        } else {
            set_corners(&faces[i], 3 * i, 3 * i + 1, 3 * i + 2);
        }
    }
    return (struct model){.positions = positions,
                          .position_count = position_count,
                          .faces = faces,
                          .face_count = face_count};
}

/* How many pixels it takes to show the bits of a number. */
enum { REAL_PARTS = sizeof(real) / sizeof(uint32_t) };

/* As a colour: the bits of one part, 0..REAL_PARTS-1. */
static inline lanes_texel show_part(lanes value, size_t part) {
    uint32_t words[LANES * REAL_PARTS], texels[LANES];
    lanes_texel color;
    memcpy(words, &value, sizeof words);
    for (size_t i = 0; i < LANES; i++) {
        texels[i] = words[i * REAL_PARTS + part];
    }
    memcpy(&color, texels, sizeof color);
    return color;
}

/* The four bytes of a pixel of a BGRA image, as a texel has them. */
static inline uint32_t texel_at(const struct image *image, size_t pixel) {
    const uint8_t *p = image->pixels + 4 * pixel;
    return p[0] | (uint32_t)p[1] << 8 | (uint32_t)p[2] << 16 | (uint32_t)p[3] << 24;
}

/* The number whose parts those images show at a pixel. */
static inline double shown_real(const struct image parts[REAL_PARTS], size_t pixel) {
    uint32_t words[REAL_PARTS];
    real value;
    for (size_t i = 0; i < REAL_PARTS; i++) {
        words[i] = texel_at(&parts[i], pixel);
    }
    memcpy(&value, words, sizeof value);
    return (double)value;
}

#endif
