/* Lesson 5's scenes that find wrong programs. */
#ifndef LESSON
#define LESSON "../step05_zbuffer/main.c"
#endif
#include "more_scenes.h"

/* ---- The lesson's scenes ---- */

/* With --no-skip the corners of faces without light are placed, too. */
static bool try_zbuffer(struct drawing *drawing, struct image *image, struct error *error) {
    const struct model *model = drawing->model;
    const struct vec3 light = vec3_normalized(drawing->light);
    struct canvas canvas = {.image = image, .depth = drawing->depth};
    for (size_t face = 0; !drawing->skip && face < model->face_count; face++) {
        struct vertex vertices[3];
        const bool placed = place_face(model, face, image, vertices);
        const double intensity = model_face_intensity(model, face, light);
        if (placed && intensity > 0) {
            triangle(&canvas, vertices, color_grey(level_from(intensity * 255)));
        }
    }
    return !drawing->skip || draw_zbuffer(drawing, image, error);
}

/* Nothing of this segment lies in an image half as wide: the row of depths behind that of the scene
 * stays as it is. It is shown at the bottom: black. */
static bool try_rows(struct drawing *drawing, struct image *image, struct error *error) {
    const bool done = draw_rows(drawing, image, error);
    const struct segment outside = {{770, 90}, {840, 150}, {.r = 255, .a = 255}};
    struct image narrow = *image;
    double *behind = drawing->depth + (image->height > 1 ? image->width : 0);
    narrow.width = image->width / 2;
    draw_segment(&outside, &narrow, 0, behind);
    for (int x = 0; x < (int)image->width; x++) {
        image_set(image, x, 0, color_grey(level_from(behind[x] * 255 / ROWS_PLANE)));
    }
    return done;
}

/* ---- Depths of all kinds ---- */

/* The depths of some rows, `more` added to all of them, as a separate picture. The depths of its
 * first and its last pixel are given. */
static void try_to_show(const struct image *image, size_t begin, size_t end, double *depth,
                        double first, double last, double more) {
    size_t start = begin * image->width, count = (end - begin) * image->width;
    if (count == 0) {
        return;
    }
    depth[start] = first;
    depth[start + count - 1] = last;
    for (size_t i = start; i < start + count; i++) {
        depth[i] += more;
    }
    struct image rows = {image->width, end - begin, image->format,
                         image->pixels + start * image->format};
    show_depths(&rows, depth + start);
}

/* The depth picture with other depths: in the lower half all of them are negative, and the first
 * pixel is the nearest one, the last one the farthest; in the upper half they are very large, and
 * it is the other way round. On top are rows in which they are almost equal. */
static bool try_deep(struct drawing *drawing, struct image *image, struct error *error) {
    bool done = draw_zbuffer(drawing, image, error);
    size_t middle = image->height / 2, even = image->height - image->height / 100;
    for (size_t i = even * image->width; i < image->height * image->width; i++) {
        drawing->depth[i] = 1e-9 * (double)(i % image->width);
    }
    try_to_show(image, 0, middle, drawing->depth, 0.7, -0.7, -3000);
    try_to_show(image, middle, even, drawing->depth, -0.7, 0.7, 3e9);
    try_to_show(image, even, image->height, drawing->depth, 0, 0, 0);
    return done;
}

/* ---- Small images ---- */

/* Pairs of cards in a row, each pair at another depth. The second card of a pair is a little
 * nearer, and covers the lower half of the first one. */
static bool try_pairs(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    enum { PAIRS = 23 };
    const double width = (double)image->width / PAIRS, height = (double)image->height;
    struct canvas canvas = {.image = image, .depth = drawing->depth};
    for (int i = 0; i < PAIRS; i++) {
        const double left = i * width, depth = 0.0011 * i;
        struct card card = {{left, -1}, {left + width, height + 1}, depth, {.a = 255}};
        card.color = color_rgb((uint8_t)(40 + 8 * i), 60, (uint8_t)(220 - 8 * i));
        draw_card(&card, &canvas);
        card.high.y = 0.55 * height;
        card.depth = depth + 0.006;
        card.color = color_rgb(230, 190, (uint8_t)(20 + 10 * i));
        draw_card(&card, &canvas);
    }
    return true;
}

/* Two cards as near as each other, which cover the first pixel and the last one. */
static bool try_single(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const double width = (double)image->width, height = (double)image->height;
    const struct card two[] = {
        {{0.2 * width, 0.3 * height}, {width + 1, height + 1}, 0, {.r = 255, .a = 255}},
        {{-1, -1}, {0.1 * width, 0.15 * height}, 0, {.r = 255, .a = 255}},
    };
    struct canvas canvas = {.image = image, .depth = drawing->depth};
    for (size_t i = 0; i < sizeof two / sizeof two[0]; i++) {
        draw_card(&two[i], &canvas);
    }
    show_depths(image, drawing->depth);
    return true;
}

/* ---- Lines ---- */

/* The ends are shares of the image's width and height. A point is as near as its first end; the
 * second is before all others. */
static const struct try_wire {
    struct vec2 a, b;
    double depth_a, depth_b;
    struct color color;
} try_wires[] = {
    {{0.05, 0.1}, {0.95, 0.3}, 0.93, 0.04, {.r = 255, .a = 255}},
    {{0.9, 0.15}, {0.1, 0.45}, 1.07, 0.11, {.g = 255, .a = 255}},
    {{0.12, 0.98}, {0.3, 0.02}, 0.71, 0.13, {.b = 255, .a = 255}},
    {{0.6, 0.05}, {0.8, 0.95}, 0.02, 1.17, {.r = 255, .g = 255, .a = 255}},
    {{-0.7, 0.6}, {1.1, 0.7}, 0.03, 1.21, {.g = 255, .b = 255, .a = 255}},
    {{1.9, 0.95}, {0.2, 0.5}, 1.83, 0.27, {.r = 255, .b = 255, .a = 255}},
    {{0.45, 1.8}, {0.35, -0.4}, 0.08, 1.37, {.r = 255, .g = 128, .a = 255}},
    {{0.5, -0.9}, {0.55, 1.2}, 1.43, -0.31, {.g = 128, .b = 255, .a = 255}},
    {{0.02, 0.85}, {0.98, 0.85}, 0.91, 0.09, {.r = 200, .g = 200, .b = 200, .a = 255}},
    {{0.88, 0.97}, {0.88, 0.03}, 1.01, 0.19, {.r = 200, .g = 120, .b = 200, .a = 255}},
    {{0.5, 0.55}, {0.5, 0.55}, 0.87, 7, {.r = 255, .g = 255, .b = 255, .a = 255}},
};

/* Over dark stripes, each nearer than the one at its left. */
static bool try_wiring(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const double width = (double)image->width, height = (double)image->height;
    struct canvas canvas = {.image = image, .depth = drawing->depth};
    for (size_t i = 0; i < image->width * image->height; i++) {
        const size_t stripe = i % image->width * 7 / image->width;
        drawing->depth[i] = 0.15 * (double)stripe;
        image_set(image, (int)(i % image->width), (int)(i / image->width),
                  color_grey((uint8_t)(20 + 8 * stripe)));
    }
    for (size_t i = 0; i < sizeof try_wires / sizeof try_wires[0]; i++) {
        const struct try_wire *w = &try_wires[i];
        const struct pixel a = {(int)floor(w->a.x * width), (int)floor(w->a.y * height)};
        const struct pixel b = {(int)floor(w->b.x * width), (int)floor(w->b.y * height)};
        hidden_line(&canvas, (struct line_end){a, w->depth_a}, (struct line_end){b, w->depth_b},
                    w->color);
    }
    return true;
}

/* ---- The scenes ---- */

static const struct scene trials[] = {
    {.name = "rows", .draw = try_rows},
    {.name = "zbuffer", .draw = try_zbuffer},
    {.name = "deep", .needs = MODEL_AND_DEPTH, .format = IMAGE_GREY, .draw = try_deep},
    {
        .name = "single",
        .needs = NEEDS_DEPTH,
        .width = 125,
        .height = 80,
        .format = IMAGE_GREY,
        .draw = try_single,
    },
    /* Not square, and odd: a square or a large picture hides some mistakes. */
    {.name = "wide", .needs = MODEL_AND_DEPTH, .width = 203, .height = 67, .draw = draw_zbuffer},
    {
        .name = "high",
        .needs = MODEL_AND_DEPTH,
        .model = "knot.off",
        .width = 61,
        .height = 181,
        .format = IMAGE_GREY,
        .draw = draw_depth,
    },
    {.name = "small", .needs = NEEDS_DEPTH, .width = 23, .height = 13, .draw = try_pairs},
    {
        .name = "one_pixel",
        .needs = NEEDS_DEPTH,
        .width = 1,
        .height = 1,
        .format = IMAGE_GREY,
        .draw = try_single,
    },
    {.name = "wires", .needs = NEEDS_DEPTH, .width = 131, .height = 83, .draw = try_wiring},
    {.name = "wires_high", .needs = NEEDS_DEPTH, .width = 17, .height = 67, .draw = try_wiring},
    {.name = "wires_pixel", .needs = NEEDS_DEPTH, .width = 1, .height = 1, .draw = try_wiring},
};

MAIN_WITH(trials)
