/* Lesson 9's scenes that find wrong programs. */
#ifndef LESSON
#define LESSON "../step09_shaders/main.c"
#endif
#include "more_scenes.h"

/* ---- Scenes of simple_draw() ---- */

/* The colours of the corners in the last three of as many varyings as there may be. Where only the
 * first ones are interpolated, all is black. */
static void try_corner_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    (void)uniforms, (void)face;
    for (size_t i = 0; i < VARYING_LIMIT; i++) {
        varyings[i] = 0;
    }
    varyings[corner] = varyings[VARYING_LIMIT - 3 + corner] = 255;
}

static bool try_corner_pixel(const void *uniforms, const double *varyings, struct vec3 *rgb) {
    return corner_pixel(uniforms, varyings + VARYING_LIMIT - 3, rgb);
}

static const struct simple_shader try_corners = {VARYING_LIMIT, try_corner_vertex,
                                                 try_corner_pixel};

/* A corner of each of these is too far for the screen: nothing of them is drawn. */
static const struct model try_too_far =
    TWO_FACES({1, -1, 0}, {-1, 1, 0}, {-1, -1e9, 0}, {1e9, 1, 0}, {-1, 1, 0}, {1, -1, 0});

/* Other colours for the crossing triangles, no nearer than those that are there, stay hidden. */
static bool try_loops(struct drawing *drawing, struct image *image, struct error *error) {
    const struct canvas canvas = {image, drawing->depth};
    const struct rectangle first = corner_of(image, 2, 0, false);
    const struct rectangle second = corner_of(image, 2, 1, false);
    const bool done = draw_loops_by(&try_corners, drawing, image);
    (void)error;
    draw_beside(&canvas, near_call(&crossing, first), &simple_normals, 1);
    draw_beside(&canvas, flat_call(&try_too_far, second), &simple_corners, 1);
    return done;
}

/* A square nearer than the full one, and to its right: half of that is covered. Its intensity is
 * not 0, but so small that it is rounded to black. */
static struct draw_call try_dim_call(struct rectangle place) {
    struct draw_call call = flat_call(&full_square, place);
    call.to_clip = mat4_translation((struct vec3){1, 0, 0.5});
    for (int i = 0; i < 16; i++) { /* the same places, with a w of 0.5: nearer by that, too */
        call.to_clip.m[i / 4][i % 4] *= 0.5;
    }
    return call;
}

static const double try_dim = 0.001;

/* Next to the last head a bright square is covered by a dark one, which is not without light. Just
 * before, a bright face is drawn once more: its light must not be kept for the next drawing. */
static bool try_more_looks(struct drawing *drawing, struct image *image, struct error *error) {
    const struct canvas canvas = {image, drawing->depth};
    const struct rectangle third = corner_of(image, 2, 2, false);
    const struct rectangle last = corner_of(image, 2, 3, false);
    const bool done = draw_more_looks(drawing, image, error);
    draw_beside(&canvas, flat_call(&full_square, last), &simple_toon, 1);
    draw_beside(&canvas, flat_call(&lone_triangle, third), &simple_flat, 1);
    draw_beside(&canvas, try_dim_call(last), &simple_lit_only, try_dim);
    return done;
}

/* ---- Scenes of the pipeline ---- */

/* The same two squares, in a second frame over the first. */
static bool try_culling(struct drawing *drawing, struct image *image, struct error *error) {
    const struct rectangle place = corner_of(image, 2, 3, false);
    const struct draw_call dim_call = try_dim_call(place);
    const struct uniforms dim = {.model = dim_call.model, .to_light = {0, 0, try_dim}};
    bool done = draw_culling(drawing, image, error);
    pipeline_begin(drawing);
    done = done && record_beside(drawing, flat_call(&full_square, place), &two_sided, error) &&
           pipeline_draw(drawing->state, &dim_call, &culled_by_light, &dim, sizeof dim, error);
    return pipeline_end(drawing, done, image, error);
}

/* ---- The scenes ---- */

static const struct scene trials[] = {
    {.name = "loops", .draw = try_loops},
    {.name = "more_looks", .draw = try_more_looks},
    {.name = "culling", .draw = try_culling},
    /* Not square, and odd: a square or a large picture hides some mistakes. */
    {.name = "wide", .needs = MESH | NEEDS_DEPTH, .width = 203, .height = 67, .draw = try_loops},
    {.name = "high", .needs = MESH | NEEDS_DEPTH, .width = 61, .height = 181, .draw = try_loops},
    /* No band is as high: the first one is the last, and cut. */
    {
        .name = "small",
        .needs = TEXTURED_MESH | NEEDS_DEPTH,
        .width = 23,
        .height = 13,
        .values = way_value,
        .draw = draw_heads,
    },
    {
        .name = "one_pixel",
        .needs = TEXTURED_MESH | NEEDS_DEPTH,
        .width = 1,
        .height = 1,
        .values = way_value,
        .draw = draw_heads,
    },
};

MAIN_WITH(trials)
