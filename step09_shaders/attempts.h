/*
 * Other ways to shade, for the benchmark and for the lesson's wrong pictures.
 *
 * Include after the shaders of main.c.
 */
#ifndef STEP09_ATTEMPTS_H
#define STEP09_ATTEMPTS_H

#include "pipeline.h"

/* ---- The same bytes, slower ---- */

/* 1. A call for every sixteen pixels: the shader without the loops that are compiled for it. Its
 * functions are called through pointers, and nothing of it can be kept in registers. */
static inline struct shader attempt_1_called(const struct shader *shader) {
    struct shader called = *shader;
    called.shade = NULL;
    return called;
}

/* 2. Shaded at once: every pixel that is nearest so far, though it may be hidden later. The loops
 * find the image in the uniforms, and write there what they should only decide. */
struct attempt_2_uniforms {
    struct uniforms u; /* first, so that the shader finds what it knows */
    struct image *image;
};

static inline void attempt_2_shade(const struct shading *shading) {
    if (shading->at_once) {
        const struct attempt_2_uniforms *uniforms = shading->uniforms;
        struct shading with_image = *shading;
        with_image.image = uniforms->image;
        gouraud_textured.shade(&with_image);
    }
}

/* (It says that it discards pixels, which are decided at once; but it never does.) */
static const struct shader attempt_2_at_once = {.varying_count = 3,
                                                .vertex = gouraud_textured_vertex,
                                                .fragment = textured_fragment,
                                                .discards = true,
                                                .shade = attempt_2_shade};

/* ---- Wrong pictures ---- */

/* The texture's colour in the light on a normal. */
static inline lanes_mask attempt_color(const struct uniforms *u, const lanes *varyings,
                                       struct lanes3 normal, lanes_texel *color) {
    struct lanes2 uv = {varyings[0], varyings[1]};
    struct lanes3 rgb = texture_lanes(u->diffuse, uv, u->diffuse_level);
    *color = shade(rgb, lambert_lanes(normal, u->to_light));
    return lanes_all_set();
}

/* 3. The levels of the normal map taken as coordinates 0..1: none points left, down or back. */
static inline lanes_mask attempt_3_normals_not_shifted(const void *uniforms, const lanes *varyings,
                                                       lanes_texel *color) {
    const struct uniforms *u = uniforms;
    struct lanes2 uv = {varyings[0], varyings[1]};
    struct lanes3 n = texture_lanes(u->normal_map, uv, u->normal_level);
    struct lanes3 normal = {n.x / 255, n.y / 255, n.z / 255};
    return attempt_color(u, varyings, normal, color);
}

/* 4. Blue, green, red taken as x, y, z, in the order in which the file stores them: x and z change
 * places. */
static inline lanes_mask
attempt_4_normals_in_file_order(const void *uniforms, const lanes *varyings, lanes_texel *color) {
    const struct uniforms *u = uniforms;
    struct lanes2 uv = {varyings[0], varyings[1]};
    struct lanes3 n = texture_lanes(u->normal_map, uv, u->normal_level);
    struct lanes3 normal = {n.z / 127.5f - 1, n.y / 127.5f - 1, n.x / 127.5f - 1};
    return attempt_color(u, varyings, normal, color);
}

#endif
