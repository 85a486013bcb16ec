/*
 * Other ways to draw and to shade, for the benchmark and for the lesson's figures.
 *
 * Include after the shaders of main.c.
 */
#ifndef STEP09_ATTEMPTS_H
#define STEP09_ATTEMPTS_H

#include "pipeline.h"

/* ---- simple_draw(), better and better: the same bytes ---- */

/* A position of the model on the screen. */
struct attempt_position {
    struct fixed2 position;
    double depth, recip_w;
    bool placed;
};

/* What the attempts keep in memory. */
struct attempt_memory {
    struct attempt_position *positions; /* one a position of the model */
    uint32_t *nearest;                  /* one a pixel: 1 + the face that is nearest; 0 for none */
};

static inline struct attempt_position attempt_place(const struct draw_call *call,
                                                    struct vec3 position) {
    const struct rectangle *view = &call->viewport;
    struct vec4 clip = mat4_point(&call->to_clip, position);
    struct vec2 screen = {view->x + (clip.x / clip.w + 1) * view->width / 2,
                          view->y + (clip.y / clip.w + 1) * view->height / 2};
    struct attempt_position placed = {.depth = clip.z / clip.w, .recip_w = 1 / clip.w};
    placed.placed = clip.w > 0 && screen_snap(screen, &placed.position);
    return placed;
}

/* Each position once, however many faces share it. */
static inline void attempt_place_all(const struct draw_call *call,
                                     struct attempt_position *positions) {
    for (size_t i = 0; i < call->model->position_count; i++) {
        positions[i] = attempt_place(call, call->model->positions[i]);
    }
}

/* As place_face(), edges_setup() and the culling of simple_draw(). */
static inline bool attempt_look_up(const struct canvas *canvas, const struct draw_call *call,
                                   const struct attempt_position *positions, size_t face,
                                   struct placed_face *placed, struct edges *edges) {
    for (size_t i = 0; i < 3; i++) {
        const struct attempt_position *p = &positions[call->model->faces[face].corner[i].position];
        if (!p->placed) {
            return false;
        }
        placed->position[i] = p->position;
        placed->depth[i] = p->depth;
        placed->recip_w[i] = p->recip_w;
    }
    const struct fixed2 *c = placed->position;
    return edges_setup(edges, c[0], c[1], c[2], canvas->image->width, canvas->image->height) &&
           call->cull != (edges->clockwise ? CULL_BACK : CULL_FRONT);
}

/* 1. Positions once. A face looks up where its corners are. */
static inline void attempt_1_positions_once(const struct canvas *canvas,
                                            const struct draw_call *call,
                                            const struct simple_shader *shader,
                                            const void *uniforms,
                                            const struct attempt_memory *memory) {
    attempt_place_all(call, memory->positions);
    for (size_t face = 0; face < call->model->face_count; face++) {
        struct placed_face placed;
        struct edges edges;
        if (attempt_look_up(canvas, call, memory->positions, face, &placed, &edges)) {
            for (size_t i = 0; i < 3; i++) {
                shader->vertex(uniforms, face, i, placed.varyings[i]);
            }
            draw_pixels(canvas, &call->viewport, &edges, &placed, shader, uniforms);
        }
    }
}

/* Depth, and the number of the face, where it is nearest so far. */
static inline void attempt_2_cover(const struct canvas *canvas, const struct edges *edges,
                                   const struct placed_face *placed, uint32_t number,
                                   uint32_t *nearest) {
    const double *z = placed->depth;
    for (int y = edges->y_begin; y < edges->y_end; y++) {
        size_t row = (size_t)y * canvas->image->width;
        struct span span = edges_span(edges, y);
        for (int x = span.begin; x < span.end; x++) {
            double depth = interpolate_depth(edges_weights(edges, x, y), z[0], z[1], z[2]);
            if (depth > canvas->depth[row + (size_t)x]) {
                canvas->depth[row + (size_t)x] = depth;
                nearest[row + (size_t)x] = number;
            }
        }
    }
}

/* The pixels of one face that are its own; its corners are asked when the first one is found. */
static inline void attempt_2_shade(const struct canvas *canvas, const struct edges *edges,
                                   struct placed_face *placed, const struct simple_shader *shader,
                                   const void *uniforms, uint32_t number, const uint32_t *nearest) {
    double(*corner)[VARYING_LIMIT] = placed->varyings;
    bool asked = false;
    for (int y = edges->y_begin; y < edges->y_end; y++) {
        struct span span = edges_span(edges, y);
        for (int x = span.begin; x < span.end; x++) {
            if (nearest[(size_t)y * canvas->image->width + (size_t)x] != number) {
                continue;
            }
            for (size_t i = 0; !asked && i < 3; i++) {
                shader->vertex(uniforms, number - 1, i, placed->varyings[i]);
            }
            asked = true;
            struct vec3 rgb,
                weight = perspective_weights(edges_weights(edges, x, y), placed->recip_w);
            double varyings[VARYING_LIMIT];
            for (size_t k = 0; k < shader->varying_count; k++) {
                varyings[k] = interpolate(weight, corner[0][k], corner[1][k], corner[2][k]);
            }
            shader->pixel(uniforms, varyings, &rgb);
            image_set(canvas->image, x, y,
                      color_rgb(level_from(rgb.x), level_from(rgb.y), level_from(rgb.z)));
        }
    }
}

/* 2. Visibility before shading: first all depths, then the colours of what is visible. `nearest` is
 * all 0 before. The viewport is the whole image, and nothing is discarded. */
static inline void attempt_2_visible_first(const struct canvas *canvas,
                                           const struct draw_call *call,
                                           const struct simple_shader *shader, const void *uniforms,
                                           const struct attempt_memory *memory) {
    attempt_place_all(call, memory->positions);
    for (int pass = 0; pass < 2; pass++) {
        for (uint32_t face = 0; face < call->model->face_count; face++) {
            struct placed_face placed;
            struct edges edges;
            if (!attempt_look_up(canvas, call, memory->positions, face, &placed, &edges)) {
                continue;
            }
            if (pass == 0) {
                attempt_2_cover(canvas, &edges, &placed, face + 1, memory->nearest);
            } else {
                attempt_2_shade(canvas, &edges, &placed, shader, uniforms, face + 1,
                                memory->nearest);
            }
        }
    }
}

/* ---- The pipeline's bytes, slower ---- */

/* 3. A call for every sixteen pixels: the shader without the loops that are compiled for it. Its
 * functions are called through pointers, and nothing of it can be kept in registers. */
static inline struct shader attempt_3_called(const struct shader *shader) {
    struct shader called = *shader;
    called.shade = NULL;
    return called;
}

/* 4. Shaded at once: every pixel that is nearest so far, though it may be hidden later. The
 * pipeline does so without SHORTCUT_VISIBLE. (It says that it discards pixels, for then SHADER()
 * has loops for it that shade at once; but it never does.) */
SHADER(attempt_4_at_once, .varying_count = 3, .vertex = gouraud_textured_vertex,
       .fragment = textured_fragment, .discards = true);

#endif
