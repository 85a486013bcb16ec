/* Lesson 3's scenes that find wrong programs. */
#ifndef LESSON
#define LESSON "../step03_triangle/main.c"
#endif
#include "more_scenes.h"

/* ---- Part a ---- */

/* Outlines that leave the image on all sides, and one outside it, which draws nothing. */
static bool try_leaving(struct drawing *drawing, struct image *image, struct error *error) {
    static const struct text_scene_shape leaving[] = {
        {{-30, 60, 100}, {30, -25, 55}, {{RED}}},
        {{130, 160, 40}, {20, 45, 75}, {{GREEN}}},
        {{-50, -20, -35}, {10, 30, 50}, {{WHITE}}},
    };
    (void)error;
    for (size_t i = 0; i < sizeof leaving / sizeof leaving[0]; i++) {
        draw_outline(drawing, image, &leaving[i]);
    }
    return true;
}

/* Two with an area of 0, a line and a point, through pixel centres: they draw nothing. */
static bool try_signs(struct drawing *drawing, struct image *image, struct error *error) {
    const struct text_scene_shape line = {{10, 70, 130}, {30, 30, 30}, {{YELLOW}}};
    const struct text_scene_shape point = {{60, 60, 60}, {20, 20, 20}, {{YELLOW}}};
    const bool done = draw_signs(drawing, image, error);
    draw_by_signs(drawing, image, &line);
    draw_by_signs(drawing, image, &point);
    return done;
}

/* ---- Part b ---- */

/* The triangles of `outline`, filled exactly. */
static bool try_triangle(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    for (int i = 0; i < 3; i++) {
        draw_shape(drawing, image, &few_triangles[i]);
    }
    return true;
}

/* The blue and the yellow one reach far out of the image and cover its lowest and its highest rows:
 * their long edges meet these rows at an x that does not fit in an int. The green, the red and the
 * cyan one have a corner in the image, but most of their rows miss it. The first white one and the
 * magenta one are very long and narrow, and the other white ones small: their edges pass through
 * pixel centres or 1/256 pixel past them, as the level edge of the cyan one does. */
static bool try_far(struct drawing *drawing, struct image *image, struct error *error) {
    static const struct text_scene_shape far[] = {
        {{-900000, 900000, 900000}, {-900000, 899999.96, 900000.04}, {{WHITE}, {WHITE}, {WHITE}}},
        {{1000000, -1000000, 0}, {7.00390625, 7, -1000000}, {{BLUE}, {BLUE}, {BLUE}}},
        {{220, 300, 300}, {40, 40, 150}, {{GREEN}, {GREEN}, {GREEN}}},
        {{20, -60, -60}, {120, 40, 130}, {{RED}, {RED}, {RED}}},
        {{-5, -3, 18}, {20, 36, 36}, {{CYAN}, {CYAN}, {CYAN}}},
        {{118, 122, 114}, {-60000, 60000, 0}, {{MAGENTA}, {MAGENTA}, {MAGENTA}}},
        {{59.61328125, 61.55078125, 57.26953125},
         {99.609375, 101.56640625, 101.56640625},
         {{WHITE}, {WHITE}, {WHITE}}},
        {{71, 71, 75}, {104, 101, 101}, {{WHITE}, {WHITE}, {WHITE}}},
        {{84.9921875, 85.0078125, 85},
         {101.9921875, 101.9921875, 102.0078125},
         {{WHITE}, {WHITE}, {WHITE}}},
        {{1000000, -1000000, 0}, {146.00390625, 146, 1000000}, {{YELLOW}, {YELLOW}, {YELLOW}}},
    };
    (void)error;
    for (size_t i = 0; i < sizeof far / sizeof far[0]; i++) {
        draw_shape(drawing, image, &far[i]);
    }
    return true;
}

/* ---- The scenes ---- */

static const struct scene trials[] = {
    {.name = "signs", .draw = try_signs},
    {.name = "leaving", .width = 120, .height = 60, .draw = try_leaving},
    {.name = "triangle", .draw = try_triangle},
    {.name = "far", .width = 240, .height = 160, .draw = try_far},
    /* Not square, and odd: a square or a large picture hides some mistakes. */
    {.name = "wide", .needs = NEEDS_MODEL, .width = 203, .height = 67, .draw = draw_faces},
    {.name = "high", .needs = NEEDS_MODEL, .width = 61, .height = 181, .draw = draw_faces},
    {.name = "small", .needs = NEEDS_MODEL, .width = 23, .height = 13, .draw = draw_faces},
    {.name = "one_pixel", .needs = NEEDS_MODEL, .width = 1, .height = 1, .draw = draw_faces},
};

MAIN_WITH(trials)
