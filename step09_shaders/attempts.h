/*
 * Other ways to call a shader, for the benchmark; the pictures are the same to the byte.
 *
 * Include after the shaders of main.c.
 */
#ifndef STEP09_ATTEMPTS_H
#define STEP09_ATTEMPTS_H

#include "pipeline.h"

/* 1. A call for every pixel: the shader without the loops that are compiled for it. Each pixel
 * costs a call through a pointer, and nothing of the shader can be kept in registers from pixel
 * to pixel. */
static inline bool attempt_1_call_per_pixel(struct pipeline *pipeline, const struct draw_call *call,
                                            const struct shader *shader, const void *uniforms,
                                            struct image *image, struct error *error) {
    struct shader called = *shader;
    called.band = NULL;
    return pipeline_draw(pipeline, call, &called, uniforms, image, error);
}

/* 2. A call for every run of pixels: the loop over the run knows its shader, what calls it does
 * not. (For the shaders gouraud and gouraud_textured.) */
typedef uint64_t run_shader(const struct piece *piece, const double *corners, const void *uniforms,
                            struct image *image, struct span run, int y);

static inline uint64_t attempt_2_gouraud_textured_run(const struct piece *piece,
                                                      const double *corners, const void *uniforms,
                                                      struct image *image, struct span run, int y) {
    return shade_run(piece, corners, &gouraud_textured, uniforms, image, run, y, NULL);
}

static inline uint64_t attempt_2_gouraud_run(const struct piece *piece, const double *corners,
                                             const void *uniforms, struct image *image,
                                             struct span run, int y) {
    return shade_run(piece, corners, &gouraud, uniforms, image, run, y, NULL);
}

static inline uint64_t attempt_2_row(const struct pipeline *p, size_t stride,
                                     run_shader *shade_piece, const void *uniforms,
                                     struct image *image, int y) {
    const uint32_t *number = p->number + (size_t)y * p->width;
    uint64_t shaded = 0;
    for (int x = p->viewport.x, end = x + p->viewport.width; x < end;) {
        struct span run = {x, x + 1};
        while (run.end < end && number[run.end] == number[x]) {
            run.end++;
        }
        if (number[x] >= p->first_number) {
            const struct piece *piece = &p->pieces[number[x] - p->first_number];
            shaded += shade_piece(piece, p->attributes + piece->attributes * stride, uniforms,
                                  image, run, y);
        }
        x = run.end;
    }
    return shaded;
}

static inline bool attempt_2_call_per_run(struct pipeline *pipeline, const struct draw_call *call,
                                          const struct shader *shader, const void *uniforms,
                                          struct image *image, struct error *error) {
    run_shader *volatile hidden =
        shader == &gouraud ? attempt_2_gouraud_run : attempt_2_gouraud_textured_run;
    size_t stride = 3 * shader->varying_count;
    if (!pipeline_assemble(pipeline, call, error)) {
        return false;
    }
    pipeline_cover(pipeline);
    if (!pipeline_fetch_visible(pipeline, shader, uniforms, error)) {
        return false;
    }
    for (int y = 0; y < pipeline->viewport.height; y++) {
        pipeline->stats[STAT_PIXELS_SHADED] +=
            attempt_2_row(pipeline, stride, hidden, uniforms, image, pipeline->viewport.y + y);
    }
    return true;
}

/* 3. Specialised, but shaded at once: every pixel that is nearest so far, though it may be hidden
 * later. So it is for shaders that may discard pixels; this one says so and never does. */
SHADER(attempt_3_eager, .varying_count = 3, .vertex = gouraud_textured_vertex,
       .fragment = textured_fragment, .discards = true);

static inline bool attempt_3_shade_at_once(struct pipeline *pipeline, const struct draw_call *call,
                                           const void *uniforms, struct image *image,
                                           struct error *error) {
    return pipeline_draw(pipeline, call, &attempt_3_eager, uniforms, image, error);
}

/* ---- Wrong pictures ---- */

/* The levels of the normal map taken as coordinates 0..1: no normal points left, down or back. */
static inline bool attempt_4_normals_not_shifted(const void *uniforms, const double *varyings,
                                                 struct color *color) {
    const struct uniforms *u = uniforms;
    struct vec2 uv = {varyings[0], varyings[1]};
    struct vec4 n = texture_bilinear(u->normal_map, uv, u->normal_level);
    struct vec3 normal = {n.x / 255, n.y / 255, n.z / 255};
    *color =
        shade(texture_bilinear(u->diffuse, uv, u->diffuse_level), lambert(normal, u->to_light));
    return true;
}

/* Blue, green, red taken as x, y, z, in the order in which the file stores them: x and z change
 * places. */
static inline bool attempt_5_normals_in_file_order(const void *uniforms, const double *varyings,
                                                   struct color *color) {
    const struct uniforms *u = uniforms;
    struct vec2 uv = {varyings[0], varyings[1]};
    struct vec4 n = texture_bilinear(u->normal_map, uv, u->normal_level);
    struct vec3 normal = {n.z / 127.5 - 1, n.y / 127.5 - 1, n.x / 127.5 - 1};
    *color =
        shade(texture_bilinear(u->diffuse, uv, u->diffuse_level), lambert(normal, u->to_light));
    return true;
}

#endif
