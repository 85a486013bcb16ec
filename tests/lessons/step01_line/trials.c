/* Lesson 1's scenes that find wrong programs. */
#ifndef LESSON
#define LESSON "../step01_line/main.c"
#endif
#include "more_scenes.h"

/* ---- Lines that come half-way between two pixels ---- */

/* Two with slopes, 7 / 12 and 9 / 14, of which a double does not hit the multiples at a tie; then,
 * for scene `list` alone, a short diagonal in each direction, a long line with three ties, lines
 * downwards and to the left, and a point. */
static const struct pixel try_lines[][2] = {
    {{3, 104}, {15, 111}},  {{25, 104}, {53, 122}}, {{7, 65}, {11, 69}}, {{23, 65}, {19, 69}},
    {{31, 69}, {35, 65}},   {{47, 69}, {43, 65}},   {{3, 96}, {93, 99}}, {{64, 122}, {64, 104}},
    {{96, 110}, {74, 110}}, {{85, 118}, {85, 118}},
};
enum {
    TRY_SHORT_LINES = 64, /* before those */
    TRY_TIE_LINES = TRY_SHORT_LINES + 2,
    TRY_LISTED_LINES = TRY_SHORT_LINES + sizeof try_lines / sizeof try_lines[0],
    TRY_TIES_WIDTH = 100, /* of the image */
    TRY_TIES_HEIGHT = 125
};

/* Eight directions of eight lines, row by row from the bottom, all with ties; then try_lines. */
static void try_tie_line(int index, struct pixel *a, struct pixel *b) {
    if (index >= TRY_SHORT_LINES) {
        *a = try_lines[index - TRY_SHORT_LINES][0];
        *b = try_lines[index - TRY_SHORT_LINES][1];
        return;
    }
    static const int run[] = {10, 10, 10, 10, 10, 2, 4, 8}, rise[] = {1, 3, 5, 7, 9, 1, 3, 1};
    int direction = index % 8, kind = index / 8;
    bool steep = direction & 1;
    int width = steep ? rise[kind] : run[kind], height = steep ? run[kind] : rise[kind];
    int x = 3 + 12 * direction, y = 3 + 12 * kind;
    bool left = direction & 2, down = direction & 4;
    *a = (struct pixel){left ? x + width : x, down ? y + height : y};
    *b = (struct pixel){left ? x : x + width, down ? y : y + height};
}

/* Each from a to b in white, then from b to a in red: nothing white may be left, as it is where the
 * ties of a walk depend on which end was given first. */
static bool try_ties(struct drawing *drawing, struct image *image, struct error *error) {
    (void)drawing, (void)error;
    for (int i = 0; i < TRY_TIE_LINES; i++) {
        struct pixel a, b;
        try_tie_line(i, &a, &b);
        line(image, a, b, color_rgb(255, 255, 255));
        line(image, b, a, color_rgb(255, 0, 0));
    }
    return true;
}

/* The same lines and more as lists: in green, the first pixel of each in white. Lists that are too
 * short, begin at the other end or have pixels that line() does not set look different. */
static bool try_list(struct drawing *drawing, struct image *image, struct error *error) {
    (void)drawing;
    for (int i = 0; i < TRY_LISTED_LINES; i++) {
        struct pixel a, b;
        try_tie_line(i, &a, &b);
        size_t length = line_length(a, b);
        struct pixel *list = make_list(a, b, length, error);
        if (list == NULL) {
            return false;
        }
        for (size_t k = 0; k < length; k++) {
            struct color color = k == 0 ? color_rgb(255, 255, 255) : color_rgb(0, 255, 0);
            image_set(image, list[k].x, list[k].y, color);
        }
        free(list);
    }
    return true;
}

/* ---- Long lines ---- */

/* Lines that begin or end far outside the image, or never come in: their slopes do not fit into a
 * float, nor products of their lengths into an int. */
static bool try_far(struct drawing *drawing, struct image *image, struct error *error) {
    (void)drawing, (void)error;
    static const struct {
        struct pixel a, b;
        struct color color; /* blue, green, red, alpha */
    } lines[] = {
        {{-1000000, -250007}, {199, 60}, {255, 255, 255, 255}}, /* flat, up */
        {{1000000, -370935}, {-999000, 370701}, {0, 0, 255, 255}},
        {{-299983, 1000000}, {300071, -1000000}, {0, 255, 255, 255}}, /* steep */
        {{70, 99}, {-777777, -1000000}, {0, 255, 0, 255}},
        {{-1000000, 999989}, {1000000, -999853}, {255, 128, 0, 255}}, /* nearly diagonal */
        {{-1000000, -377011}, {999999, 377087}, {128, 255, 0, 255}},  /* a little above a tie */
        {{-1000000, -622949}, {999999, 622952}, {255, 0, 128, 255}},  /* a little below one */
        {{1000000, 96}, {-1000000, 96}, {0, 128, 255, 255}},
        {{3, 1000000}, {3, -1000000}, {255, 0, 255, 255}},
        {{-1000000, 50}, {-1, 50}, {255, 255, 255, 255}}, /* these three stay outside */
        {{100, 0}, {100, 99}, {255, 255, 255, 255}},
        {{-1000000, -1000000}, {-5, 90}, {255, 255, 255, 255}},
    };
    for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) {
        line(image, lines[i].a, lines[i].b, lines[i].color);
    }
    return true;
}

/* ---- Images of other sizes ---- */

/* Lines from the middle of an image of any size to its border, every other one drawn inwards: who
 * takes the width for the height, or for 100, loses some of them. */
static bool try_spokes(struct drawing *drawing, struct image *image, struct error *error) {
    enum { SPOKES = 5 };
    (void)drawing, (void)error;
    const int right = (int)image->width - 1, top = (int)image->height - 1;
    const struct pixel middle = {right / 2, top / 2};
    for (int i = 0; i < SPOKES; i++) {
        int x = right * i / (SPOKES - 1), y = top * i / (SPOKES - 1);
        const struct pixel ends[] = {{x, 0}, {right, y}, {x, top}, {0, y}};
        for (int k = 0; k < 4; k++) {
            bool inwards = (i + k) % 2 != 0;
            line(image, inwards ? ends[k] : middle, inwards ? middle : ends[k],
                 inwards ? color_rgb(255, 0, 0) : color_rgb(255, 255, 255));
        }
    }
    return true;
}

/* ---- The scenes ---- */

static const struct scene trials[] = {
    {.name = "ties", .width = TRY_TIES_WIDTH, .height = TRY_TIES_HEIGHT, .draw = try_ties},
    {.name = "far", .draw = try_far},
    {.name = "list", .width = TRY_TIES_WIDTH, .height = TRY_TIES_HEIGHT, .draw = try_list},
    {.name = "wide", .width = 203, .height = 67, .draw = try_spokes},
    {.name = "high", .width = 61, .height = 181, .draw = try_spokes},
    {.name = "small", .width = 23, .height = 13, .draw = try_spokes},
    {.name = "one_pixel", .width = 1, .height = 1, .draw = try_spokes},
};

MAIN_WITH(trials)
