/*
 * For tests of the pipeline: a frame of one draw call, and pictures that show a varying to the last
 * bit, as the bits of its `real` in the four bytes of a pixel (or of two pixels, for doubles).
 */
#ifndef TESTS_SHOWN_H
#define TESTS_SHOWN_H

#include "pipeline.h"

#include <string.h>

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

static inline bool draw_frame(struct pipeline *pipeline, const struct draw_call *call,
                              const struct shader *shader, const void *uniforms, size_t size,
                              struct image *image, struct error *error) {
    pipeline_clear(pipeline);
    return pipeline_draw(pipeline, call, shader, uniforms, size, error) &&
           pipeline_finish(pipeline, image, error);
}

#endif
