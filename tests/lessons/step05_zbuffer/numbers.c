/* Lesson 5's functions called with numbers. */
#ifndef LESSON
#define LESSON "../step05_zbuffer/main.c"
#endif
#include "numbers.h"

/* What is drawn on: SIDE x SIDE pixels, or a row; and room where nothing should be written. */
enum { SIDE = 8, LONG_ROW = 800, ROOM = 1024 };
static uint8_t bytes[3 * ROOM];
static double depths[ROOM];
static struct image sheet;
static struct canvas canvas;

/* All black, and all of that depth. */
static void begin(size_t width, size_t height, double depth) {
    memset(bytes, 0, sizeof bytes);
    for (int i = 0; i < ROOM; i++) {
        depths[i] = depth;
    }
    sheet = (struct image){width, height, IMAGE_BGR, bytes};
    canvas = (struct canvas){.image = &sheet, .depth = depths};
}

/* ---- One row ---- */

static void draw(struct vec2 a, struct vec2 b, int red) {
    const struct segment segment = {a, b, rgb(red, 0, 0)};
    draw_segment(&segment, &sheet, 0, depths);
}

static struct shown depth_at(struct vec2 a, struct vec2 b, int column) {
    begin(LONG_ROW, 1, -INFINITY);
    draw(a, b, 1);
    return show("%.5g", depths[column]);
}

/* "-inf 10 20". */
static struct shown row_of_depths(struct vec2 a, struct vec2 b) {
    struct shown shown = {""};
    begin(SIDE, 1, -INFINITY);
    draw(a, b, 1);
    for (int x = 0; x < SIDE; x++) {
        shown = show("%.180s%s%.5g", shown.text, x > 0 ? " " : "", depths[x]);
    }
    return shown;
}

/* "2 1 0": which of two segments each column shows; 0 is none. */
static struct shown row_of_colors(struct vec2 a, struct vec2 b, struct vec2 c, struct vec2 d) {
    struct shown shown = {""};
    begin(SIDE, 1, -INFINITY);
    draw(a, b, 1);
    draw(c, d, 2);
    for (int x = 0; x < SIDE; x++) {
        shown = show("%.180s%s%d", shown.text, x > 0 ? " " : "", image_get(&sheet, x, 0).r);
    }
    return shown;
}

/* ---- Triangles ---- */

/* Lesson 3's example, whose corners lie on centres of pixels, with depths. */
static void draw_example(int red) {
    const struct vertex v[3] = {{{384, 384}, 0.6}, {{1408, 384}, 0}, {{384, 1152}, -0.3}};
    triangle(&canvas, v, rgb(red, 0, 0));
}

/* Pixel (2,2) where that depth is before: "color 1, depth 0.15". */
static struct shown drawn_over(double depth) {
    begin(SIDE, SIDE, depth);
    draw_example(1);
    return show("color %d, depth %.5g", image_get(&sheet, 2, 2).r, depths[2 * SIDE + 2]);
}

static int drawn_twice(void) {
    begin(SIDE, SIDE, -INFINITY);
    draw_example(1);
    draw_example(2);
    return image_get(&sheet, 2, 2).r;
}

/* ---- The depths as a picture ---- */

/* Those of an image of 3 x 2 pixels. */
static struct shown greys(double a, double b, double c, double d, double e, double f) {
    const double depth[6] = {a, b, c, d, e, f};
    uint8_t *v = bytes;
    sheet = (struct image){3, 2, IMAGE_GREY, bytes};
    show_depths(&sheet, depth);
    return show("%d %d %d %d %d %d", v[0], v[1], v[2], v[3], v[4], v[5]);
}

static void numbers(void) {
    const double none = -INFINITY;
    TEXT("5.1", "draw_segment() from (20.5, 34) to (744.5, 400): depth of column 480",
         depth_at(xy(20.5, 34), xy(744.5, 400), 480), "266.54");
    TEXT("5.1", "draw_segment() from (1.75, 10) to (5.75, 50): depths",
         row_of_depths(xy(1.75, 10), xy(5.75, 50)), "-inf -inf 17.5 27.5 37.5 47.5 -inf -inf");
    TEXT("5.1", "draw_segment() from (-1.5, 5) to (14.5, -11): depths",
         row_of_depths(xy(-1.5, 5), xy(14.5, -11)), "3 2 1 0 -1 -2 -3 -4");
    TEXT("5.1",
         "draw_segment() in 1 from (0.5, 30) to (4.5, 10), in 2 from (-1.5, 20) to (6.5, 20): "
         "colors",
         row_of_colors(xy(0.5, 30), xy(4.5, 10), xy(-1.5, 20), xy(6.5, 20)), "1 1 1 2 2 2 0 0");
    TEXT("5.2", "triangle() in color 1 over depth 0.1: pixel (2,2)", drawn_over(0.1),
         "color 1, depth 0.15");
    TEXT("5.2", "triangle() in color 1 over depth 0.2: pixel (2,2)", drawn_over(0.2),
         "color 0, depth 0.2");
    AS_WHOLE("5.2", "triangle() in color 1, again in 2: color of pixel (2,2)", drawn_twice(), 1);
    TEXT("5.3", "show_depths() of -0.238 0.566 0.2 -inf 0 0", greys(-0.238, 0.566, 0.2, none, 0, 0),
         "55 255 164 0 114 114");
    TEXT("5.3", "show_depths() of 7 7 7 -inf 7 7", greys(7, 7, 7, none, 7, 7), "55 55 55 0 55 55");
    TEXT("5.3", "show_depths() of -7e9 -8e9 -9e9 -9e9 -9e9 -9e9",
         greys(-7e9, -8e9, -9e9, -9e9, -9e9, -9e9), "255 155 55 55 55 55");
    TEXT("5.3", "show_depths() of -inf 0 1e-12 2e-12 0 0", greys(none, 0, 1e-12, 2e-12, 0, 0),
         "0 55 155 255 55 55");
}
