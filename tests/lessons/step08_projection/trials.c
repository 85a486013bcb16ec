/* Lesson 8's scenes that find wrong programs. */
#ifndef LESSON
#define LESSON "../step08_projection/main.c"
#endif
#include "more_scenes.h"

/* The house with w = 2 everywhere, which moves no point: w must be divided by. */
static bool try_house(struct drawing *drawing, struct image *image, struct error *error) {
    (void)drawing, (void)error;
    const struct plane plane = plane_in(image, whole_image(image));
    struct mat4 twice = mat4_scaling((struct vec3){2, 2, 2});
    twice.m[3][3] = 2;
    draw_mapped(&plane, twice);
    return true;
}

/* Two faces that must not be seen, on a screen far larger than the image: NDC 0 is pixel 0, and NDC
 * 1 is pixel 2^22. One corner is too far for the screen, one has no finite depth. */
static bool try_crossing(struct drawing *drawing, struct image *image, struct error *error) {
    const int side = 1 << 22;
    const double pixel = 1.0 / side;
    const struct rectangle area = {-side, -side, 2 * side, 2 * side};
    const struct quad nowhere[2] = {
        {{{600 * pixel, 100 * pixel, 0},
          {200 * pixel, 700 * pixel, 0},
          {-0.9, -0.9, 0},
          {-1, -1, 0}},
         {{0.4375, 0.0625}, {0.4375, 0.0625}, {0.4375, 0.0625}, {0.4375, 0.0625}}},
        {{{150 * pixel, 150 * pixel, 0},
          {650 * pixel, 150 * pixel, 0},
          {400 * pixel, 600 * pixel, 1e308},
          {200 * pixel, 600 * pixel, 1e308}},
         {{0.5625, 0.0625}, {0.5625, 0.0625}, {0.5625, 0.0625}, {0.5625, 0.0625}}},
    };
    struct canvas canvas = make_canvas(drawing, image, area, mat4_scaling((struct vec3){1, 1, 10}));
    canvas.affine = true;
    return draw_crossing(drawing, image, error) && draw_quads(&canvas, nowhere, 2, error);
}

/* With --no-skip faces beyond a side of the view are drawn, too, and all faces go through all
 * planes. */
static bool try_closeup(struct drawing *drawing, struct image *image, struct error *error) {
    struct canvas canvas = make_canvas(drawing, image, whole_image(image), camera_clip(drawing));
    for (size_t face = 0; !drawing->skip && face < drawing->model->face_count; face++) {
        struct face_corner corner[3];
        fetch_face(drawing->model, face, corner);
        struct polygon polygon = transform_face(&canvas, corner);
        for (int plane = 0; plane < CLIP_PLANES; plane++) {
            polygon = clip_at_plane(&polygon, plane);
        }
        draw_polygon(&canvas, corner, &polygon);
        drawing_count(drawing, "faces_cut_at_all_planes", 1);
    }
    return !drawing->skip || draw_view(drawing, image, error);
}

/* ---- The scenes ---- */

static const struct scene trials[] = {
    {.name = "house", .draw = try_house},
    {.name = "crossing", .draw = try_crossing},
    {.name = "closeup", .draw = try_closeup},
    /* Not square, and odd: a square or a large picture hides some mistakes. */
    {.name = "wide", .needs = NEEDS_VIEW, .width = 203, .height = 67, .draw = draw_viewport},
    {
        .name = "high",
        .needs = NEEDS_VIEW,
        .width = 61,
        .height = 181,
        .eye = {1, 1, 2},
        .draw = draw_view,
    },
    {
        .name = "small",
        .needs = NEEDS_VIEW,
        .width = 23,
        .height = 13,
        .eye = {0.03, 0.47, 0.46},
        .center = {0.03, -0.3, 0.4},
        .up = {0, 0, 1},
        .draw = draw_view,
    },
    {.name = "one_pixel", .needs = NEEDS_DEPTH, .width = 1, .height = 1, .draw = draw_wall},
};

MAIN_WITH(trials)
