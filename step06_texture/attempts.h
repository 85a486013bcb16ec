/*
 * Lesson 6: the worse versions, for the lesson's figures and the benchmark.
 *
 * Include main.c first: these versions use its vertices and its samplers. Each attempt draws one
 * triangle in perspective, as perspective_triangle() does, on an image without a depth test.
 */
#ifndef STEP06_ATTEMPTS_H
#define STEP06_ATTEMPTS_H

#include "geometry.h"
#include "model.h"
#include "texture.h"

/* ---- Samplers ---- */

typedef struct color attempt_sampler(const struct texture *texture, struct vec2 uv);

/* Wrong: rounds instead of truncating. The whole picture is shifted by half a texel: the first row
 * and column of texels are half as wide as they should be, the last ones 1.5 times. */
static inline struct color attempt_sample_rounded(const struct texture *texture, struct vec2 uv) {
    const struct texture_level *level = &texture->level[0];
    double right = (double)(level->width - 1), top = (double)(level->height - 1);
    uv = place_in(texture, uv);
    size_t x = (size_t)texture_clamp(floor(uv.x * (double)level->width + 0.5), right);
    size_t y = (size_t)texture_clamp(floor(uv.y * (double)level->height + 0.5), top);
    return color_from_texel(texture_texel(level, x, y));
}

static inline struct color attempt_round_channels(struct vec4 c) {
    return color_rgb(level_from(c.x), level_from(c.y), level_from(c.z));
}

/* Wrong: takes the corner of a texel for its centre. Smooth, but shifted by half a texel, too. */
static inline struct color attempt_sample_unshifted(const struct texture *texture, struct vec2 uv) {
    const struct texture_level *level = &texture->level[0];
    struct vec2 further = {uv.x + 0.5 / (double)level->width, uv.y + 0.5 / (double)level->height};
    return attempt_round_channels(sample_bilinear(texture, further, 0));
}

/* Right near the camera. Far away a pixel covers many texels, and this sees only four of them. */
static inline struct color attempt_sample_bilinear(const struct texture *texture, struct vec2 uv) {
    return attempt_round_channels(sample_bilinear(texture, uv, 0));
}

/* ---- Triangles ---- */

typedef void attempt_function(struct image *image, const struct vertex v[3],
                              const struct texture *texture);

/* Exact coordinates and a sampler that knows nothing of mip levels. */
static inline void attempt_perspective(struct image *image, const struct vertex *v,
                                       const struct texture *texture, attempt_sampler *sampler) {
    struct quotients plane;
    if (!plane_begin(&plane, image, v)) {
        return;
    }
    for (int y = plane.edges.y_begin; y < plane.edges.y_end; y++) {
        struct span span = edges_span(&plane.edges, y);
        for (int x = span.begin; x < span.end; x++) {
            double w;
            struct vec2 uv = plane_uv(&plane, x, y, &w);
            image_set(image, x, y, sampler(texture, uv));
        }
    }
}

/* Nearest texel, by rounding: see attempt_sample_rounded(). */
static inline void attempt_1_rounded(struct image *image, const struct vertex v[3],
                                     const struct texture *texture) {
    attempt_perspective(image, v, texture, attempt_sample_rounded);
}

/* Nearest texel, done right. Still, every texel is a square near the camera and noise far away. */
static inline void attempt_2_nearest(struct image *image, const struct vertex v[3],
                                     const struct texture *texture) {
    attempt_perspective(image, v, texture, sample_nearest);
}

/* Bilinear without the half texel: see attempt_sample_unshifted(). */
static inline void attempt_3_unshifted(struct image *image, const struct vertex v[3],
                                       const struct texture *texture) {
    attempt_perspective(image, v, texture, attempt_sample_unshifted);
}

/* Bilinear, right, without mip levels: moire towards the horizon, which shimmers when the camera
 * moves. */
static inline void attempt_4_no_levels(struct image *image, const struct vertex v[3],
                                       const struct texture *texture) {
    attempt_perspective(image, v, texture, attempt_sample_bilinear);
}

/* Wrong: u and v linear on the screen. Lines break at the diagonal between two triangles and tiles
 * do not become smaller with distance. */
static inline void attempt_5_affine(struct image *image, const struct vertex v[3],
                                    const struct texture *texture) {
    struct vertex flat[3] = {v[0], v[1], v[2]};
    flat[0].recip_w = flat[1].recip_w = flat[2].recip_w = 1;
    attempt_4_no_levels(image, flat, texture);
}

/* The lesson's own: with mip levels. */
static inline void attempt_6_levels(struct image *image, const struct vertex v[3],
                                    const struct texture *texture) {
    struct canvas canvas = {.image = image, .sampler = SAMPLE_TRILINEAR};
    perspective_triangle(&canvas, v, texture);
}

/* Two triangles, by any version. */
static inline void attempt_quad(struct image *image, const struct vertex c[4],
                                const struct texture *texture, attempt_function *attempt) {
    attempt(image, (const struct vertex[]){c[0], c[1], c[2]}, texture);
    attempt(image, (const struct vertex[]){c[0], c[2], c[3]}, texture);
}

/* A square of `side` pixels, on which is all of the picture. */
static inline void attempt_square(struct vertex corners[4], int side) {
    const int32_t end = side * SUBPIXELS;
    corners[0] = (struct vertex){.position = {0, 0}, .uv = {0, 0}, .recip_w = 1};
    corners[1] = (struct vertex){.position = {end, 0}, .uv = {1, 0}, .recip_w = 1};
    corners[2] = (struct vertex){.position = {end, end}, .uv = {1, 1}, .recip_w = 1};
    corners[3] = (struct vertex){.position = {0, end}, .uv = {0, 1}, .recip_w = 1};
}

/* ---- The levels as colours ---- */

/* A texel, made lighter and then multiplied by a colour, so that its own colour stays visible. */
static inline uint32_t attempt_tinted(uint32_t texel, uint32_t color) {
    uint32_t result = 0xFF000000;
    for (int shift = 0; shift < 24; shift += 8) {
        uint32_t part = texel >> shift & 255, of = color >> shift & 255;
        result |= ((part + 255) / 2 * of / 255) << shift;
    }
    return result;
}

/* Give each of up to 9 levels its own colour: white, yellow, light blue, green, orange... */
static inline void attempt_color_levels(struct texture *texture) {
    static const uint32_t colors[] = {0xFFFFFF, 0xF0E442, 0x56B4E9, 0x009E73, 0xE69F00,
                                      0xD55E00, 0xCC79A7, 0x0072B2, 0x404040};
    const size_t color_count = sizeof colors / sizeof colors[0];
    for (size_t i = 0; i < texture->level_count && i < color_count; i++) {
        const struct texture_level *level = &texture->level[i];
        for (size_t k = 0; k < level->pitch * level->height; k++) {
            level->texels[k] = attempt_tinted(level->texels[k], colors[i]);
        }
    }
}

#endif
