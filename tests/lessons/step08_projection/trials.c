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

/* ---- Part b: viewport and crossing ---- */

/* Panes, in eighths of the image, and their backgrounds. */
static const struct try_pane {
    int left, bottom, right, top;
    struct color color;
} try_panes[4] = {
    {0, 3, 5, 8, {.r = 34, .g = 44, .b = 62, .a = 255}},
    {5, 3, 8, 8, {.r = 62, .g = 40, .b = 34, .a = 255}},
    {0, 0, 5, 3, {.r = 36, .g = 56, .b = 40, .a = 255}},
    {5, 0, 8, 3, {.r = 54, .g = 50, .b = 30, .a = 255}},
};

/* The same view in each pane, without perspective: only the viewport differs. */
static bool try_viewport(struct drawing *drawing, struct image *image, struct error *error) {
    const int width = (int)image->width, height = (int)image->height;
    (void)error;
    for (const struct try_pane *pane = try_panes; pane < try_panes + 4; pane++) {
        const int x = width * pane->left / 8, y = height * pane->bottom / 8;
        const struct rectangle area = {x, y, width * pane->right / 8 - x,
                                       height * pane->top / 8 - y};
        struct canvas canvas = make_canvas(drawing, image, area, camera_view(drawing));
        canvas.affine = true;
        fill_area(image, area, pane->color);
        draw_model(drawing, &canvas, false);
    }
    return true;
}

/* Planes that cross, each of the colour of one tile. */
static const struct quad try_planes[3] = {
    {{{-0.7, -0.6, 0.2}, {0.7, -0.6, 0.2}, {0.7, 0.6, 0.2}, {-0.7, 0.6, 0.2}},
     {{0.0625, 0.0625}, {0.0625, 0.0625}, {0.0625, 0.0625}, {0.0625, 0.0625}}},
    {{{-0.4, -0.3, 1.3}, {1.6, -0.9, -2}, {1.6, 0.9, -2}, {-0.4, 0.3, 1.3}},
     {{0.8125, 0.0625}, {0.8125, 0.0625}, {0.8125, 0.0625}, {0.8125, 0.0625}}},
    {{{-0.3, -0.4, 1.3}, {0.3, -0.4, 1.3}, {1.2, 1.4, -3}, {-1.2, 1.4, -3}},
     {{0.3125, 0.9375}, {0.3125, 0.9375}, {0.3125, 0.9375}, {0.3125, 0.9375}}},
};

/* Then two faces that must not be seen, on a screen far larger than the image: NDC 0 is pixel 0,
 * and NDC 1 is pixel 2^22. One corner is too far for the screen, one has no finite depth. */
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
    struct canvas canvas = make_canvas(drawing, image, whole_image(image), camera_clip(drawing));
    struct canvas large = make_canvas(drawing, image, area, mat4_scaling((struct vec3){1, 1, 10}));
    canvas.affine = large.affine = true;
    return draw_quads(&canvas, try_planes, 3, error) && draw_quads(&large, nowhere, 2, error);
}

/* ---- Parts d and e: above and closeup ---- */

/* In a corner `up` points against a view that is aslant: the axis nearest to perpendicular is not
 * that of the large view, nor that of the eye's place. In the next it is 9 degrees off the view. In
 * the third it is almost along the view, but still far enough from it to count; in the last, from
 * the same eye, far from it. */
static bool try_above(struct drawing *drawing, struct image *image, struct error *error) {
    static const struct {
        struct vec3 from_center, up;
    } small[4] = {
        {{1.5, 1.35, 1.9}, {-1.5, -1.35, -1.9}},
        {{1.2, 1.8, 1.5}, {0.5, 1, 1}},
        {{0, 2.5, 0}, {2e-10, 1, 1e-10}},
        {{0, 2.5, 0}, {0, 0, -1}},
    };
    draw_view(drawing, image, error);
    for (int i = 0; i < 4; i++) {
        struct drawing other = *drawing;
        other.eye = vec3_add(drawing->center, small[i].from_center);
        other.up = small[i].up;
        struct canvas canvas =
            make_canvas(&other, image, small_area(image, i % 2, i / 2), camera_clip(&other));
        draw_model(&other, &canvas, false);
    }
    return true;
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
    {.name = "viewport", .needs = NEEDS_VIEW, .draw = try_viewport},
    {.name = "crossing", .needs = NEEDS_DEPTH, .draw = try_crossing},
    {
        .name = "tilted",
        .needs = NEEDS_VIEW,
        .eye = {-2, 0.5, 0.8},
        .up = {0, 2, 1},
        .light = {-2, 1, 1},
        .draw = draw_view,
    },
    {
        .name = "above",
        .needs = NEEDS_VIEW,
        .eye = {0.1, 2.3, 0.2}, /* looks along `up`, as near as it matters */
        .center = {0.1, 0.3, 0.2},
        .up = {0, 1, 1e-12},
        .light = {1, 3, 2},
        .draw = try_above,
    },
    {.name = "closeup", .draw = try_closeup},
    /* Not square, and odd: a square or a large picture hides some mistakes. */
    {.name = "wide", .needs = NEEDS_VIEW, .width = 203, .height = 67, .draw = try_viewport},
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
