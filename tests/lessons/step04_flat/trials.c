/* Lesson 4's scenes that find wrong programs. */
#ifndef LESSON
#define LESSON "../step04_flat/main.c"
#endif
#include "more_scenes.h"

/* ---- The lesson's scenes ---- */

/* With --no-skip the corners of faces without light are placed, too. */
static bool try_flat(struct drawing *drawing, struct image *image, struct error *error) {
    const struct model *model = drawing->model;
    const struct vec3 to_light = vec3_scale(vec3_normalized(drawing->light), -1);
    for (size_t face = 0; !drawing->skip && face < model->face_count; face++) {
        struct vertex vertices[3] = {{{0, 0}}};
        const bool placed = place_face(model, face, image, vertices);
        const double intensity = face_intensity(model, face, to_light);
        if (placed && intensity > 0) {
            triangle(image, vertices, color_grey(level_from(intensity * 255)));
        }
    }
    return !drawing->skip || draw_flat(drawing, image, error);
}

/* Three more faces, each with a corner too far for the screen: nothing of them is drawn. Behind the
 * image's other rows nothing is drawn, either. */
static bool try_side(struct drawing *drawing, struct image *image, struct error *error) {
    struct vec3 corners[][3] = {
        {{-0.95, 0.5, 0}, {-0.6, 0.9, 0}, {-1e9, 0.9, 0}},  /* too far: corner 2 */
        {{1e9, 0.9, 0}, {0.6, 0.9, 0}, {0.95, 0.5, 0}},     /* corner 0 */
        {{0.6, -0.3, 0}, {0.8, -1e9, 0}, {0.95, -0.35, 0}}, /* corner 1 */
    };
    struct image rows = *image;
    bool done = try_flat(drawing, image, error);
    rows.height--;
    for (size_t i = 0; rows.height > 0 && done && i < sizeof corners / sizeof corners[0]; i++) {
        done = draw_face(drawing, &rows, corners[i], draw_flat, error);
    }
    return done && draw_more_faces(drawing, image, draw_flat, error);
}

/* ---- Small images ---- */

/* Three faces of a tent that is larger than the image. */
static bool try_tent(struct drawing *drawing, struct image *image, struct error *error) {
    const struct vec3 a = {-5, -4, 0}, b = {4, -5, 0}, c = {1, 6, 0}, top = {0.2, 0.1, 4};
    struct vec3 corners[][3] = {{a, b, top}, {b, c, top}, {c, a, top}};
    bool done = true;
    for (size_t i = 0; done && i < sizeof corners / sizeof corners[0]; i++) {
        done = draw_face(drawing, image, corners[i], draw_flat, error);
    }
    return done;
}

/* ---- The scenes ---- */

static const struct scene trials[] = {
    {.name = "flat", .draw = try_flat},
    {.name = "side", .draw = try_side},
    /* Not square, and odd: a square or a large picture hides some mistakes. */
    {.name = "wide", .needs = NEEDS_MODEL, .width = 203, .height = 67, .draw = try_flat},
    {.name = "high",
     .needs = NEEDS_MODEL,
     .model = "knot.off",
     .width = 61,
     .height = 181,
     .draw = try_flat},
    {.name = "small", .needs = NEEDS_MODEL, .width = 23, .height = 13, .draw = try_tent},
    {.name = "one_pixel", .needs = NEEDS_MODEL, .width = 1, .height = 1, .draw = try_tent},
};

MAIN_WITH(trials)
