/* Lesson 7 under the mouse: attempts at light, and a sphere of few or many triangles. */
#ifndef LESSON
#define LESSON "../step07_gouraud/main.c"
#endif
#include "more_scenes.h"

#include "../step07_gouraud/attempts.h"

/* ---- Scene: gouraud ---- */

static const struct scene_value live_gouraud_values[] = {
    {"attempt",
     "0 triangle(), 1 flat, 2 a normal for each pixel, 3 clamped at the pixel, 4 not clamped", 0, 4,
     1, 0},
    {.name = NULL},
};

static bool live_gouraud(struct drawing *drawing, struct image *image, struct error *error) {
    static attempt_function *const attempts[] = {attempt_1_flat, attempt_3_normal, attempt_5_late,
                                                 attempt_6_wrapped};
    const int attempt = (int)drawing_value(drawing, "attempt");
    const struct canvas canvas = {image, image->width, image->height, drawing->depth, NULL};
    if (attempt == 0) {
        return draw_gouraud(drawing, image, error);
    }
    attempt_model(&canvas, drawing->model, vec3_normalized(drawing->light), attempts[attempt - 1]);
    return true;
}

/* ---- Scene sphere: how many triangles are enough? ---- */

static const struct scene_value live_sphere_values[] = {
    {"cuts", "how often each face is cut into four", 0, 6, 1, 2},
    {"look", "0 flat, 1 light at the corners, 2 a normal at each pixel", 0, 2, 1, 1},
    {.name = NULL},
};

static bool live_sphere(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    static attempt_function *const looks[] = {attempt_1_flat, attempt_2_gouraud, attempt_3_normal};
    const int cuts = (int)drawing_value(drawing, "cuts");
    const struct vec3 light = vec3_normalized(drawing->light);
    const struct canvas canvas = {image, image->width, image->height, drawing->depth, NULL};
    attempt_sphere(&canvas, cuts, light, looks[(int)drawing_value(drawing, "look")]);
    drawing_count(drawing, "triangles", UINT64_C(8) << 2 * cuts);
    drawing_count(drawing, "error_in_thousandths",
                  (uint64_t)(1000 * attempt_sphere_error(&canvas, light)));
    return true;
}

/* ---- The scenes ---- */

static const struct scene live[] = {
    {.name = "gouraud", .values = live_gouraud_values, .draw = live_gouraud},
    {
        .name = "sphere",
        .extra = true,
        .needs = NEEDS_DEPTH,
        .light = {1, 2, 2},
        .values = live_sphere_values,
        .draw = live_sphere,
    },
};

MAIN_WITH(live)
