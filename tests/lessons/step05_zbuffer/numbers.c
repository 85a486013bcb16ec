/* Lesson 5's functions called with numbers. */
#ifndef LESSON
#define LESSON "../step05_zbuffer/main.c"
#endif
#include "numbers.h"

/* What is drawn on: SIDE x SIDE pixels, or a row; and room where nothing should be written. */
enum { CALLED_SIDE = 8, CALLED_LONG_ROW = 800, CALLED_BEFORE = 16, CALLED_ROOM = 1024 };
static uint8_t called_bytes[3 * CALLED_ROOM];
static double called_all[CALLED_BEFORE + CALLED_ROOM], *const called_depths =
                                                           called_all + CALLED_BEFORE;
static struct image called_sheet;
static struct canvas called_canvas;

/* All black, and all of that depth. */
static void called_begin(size_t width, size_t height, double depth) {
    memset(called_bytes, 0, sizeof called_bytes);
    for (int i = 0; i < CALLED_BEFORE + CALLED_ROOM; i++) {
        called_all[i] = depth;
    }
    called_sheet = (struct image){width, height, IMAGE_BGR, called_bytes};
    called_canvas = (struct canvas){.image = &called_sheet, .depth = called_depths};
}

/* ---- One row ---- */

static void called_draw(struct vec2 a, struct vec2 b, int red) {
    const struct segment segment = {a, b, rgb(red, 0, 0)};
    draw_segment(&segment, &called_sheet, 0, called_depths);
}

/* The depth that a segment leaves in a row of that width, or before or behind it. */
static struct shown called_depth_at(struct vec2 a, struct vec2 b, size_t width, int column) {
    called_begin(width, 1, -INFINITY);
    called_draw(a, b, 1);
    return show("%.5g", called_depths[column]);
}

/* Draw one segment or two, from end to end, in a row. "-inf 10 20": its depths then, or "2 1 0":
 * which of the segments each column shows; 0 is none. */
static struct shown called_row(const struct vec2 *ends, int count, bool depths) {
    double reds[CALLED_SIDE];
    called_begin(CALLED_SIDE, 1, -INFINITY);
    for (int i = 0; i < count; i++) {
        called_draw(ends[2 * i], ends[2 * i + 1], i + 1);
    }
    for (int x = 0; x < CALLED_SIDE; x++) {
        reds[x] = image_get(&called_sheet, x, 0).r;
    }
    return show_joined(depths ? called_depths : reds, CALLED_SIDE, " ");
}

/* Columns 0 to 3 of rows 0 and 1, after a segment was drawn into row 1. */
static struct shown called_second_row(void) {
    const struct segment segment = {{0.5, 1}, {2.5, 1}, rgb(7, 0, 0)};
    struct shown shown = {""};
    called_begin(4, 2, -INFINITY);
    draw_segment(&segment, &called_sheet, 1, called_depths);
    for (int i = 0; i < 8; i++) {
        shown = show("%.90s%s%d", shown.text,
                     i == 0   ? ""
                     : i == 4 ? ", "
                              : " ",
                     image_get(&called_sheet, i % 4, i / 4).r);
    }
    return shown;
}

/* ---- Triangles ---- */

/* Lesson 3's example, whose corners lie on centres of pixels, with depths. */
static void called_draw_example(int red, double nearer) {
    const struct vertex v[3] = {
        {{384, 384}, nearer + 0.6}, {{1408, 384}, nearer}, {{384, 1152}, nearer - 0.3}};
    triangle(&called_canvas, v, rgb(red, 0, 0));
}

/* Pixel (2,2) where that depth is before: "color 1, depth 0.15"; or `nearer` by so much. */
static struct shown called_drawn_over(double depth, double nearer) {
    called_begin(CALLED_SIDE, CALLED_SIDE, depth);
    called_draw_example(1, nearer);
    return show("color %d, depth %.5g", image_get(&called_sheet, 2, 2).r,
                called_depths[2 * CALLED_SIDE + 2]);
}

static int called_drawn_twice(void) {
    called_begin(CALLED_SIDE, CALLED_SIDE, -INFINITY);
    called_draw_example(1, 0);
    called_draw_example(2, 0);
    return image_get(&called_sheet, 2, 2).r;
}

/* A triangle with six pixels, and that depth at all corners. */
static void called_draw_six(int red, double depth) {
    const struct vertex v[3] = {{{256, 256}, depth}, {{1280, 256}, depth}, {{256, 1024}, depth}};
    triangle(&called_canvas, v, rgb(red, 0, 0));
}

/* Draw it in colour 1, then again in 2. How many pixels show each? */
static struct shown called_six_twice(void) {
    int count[256] = {0};
    called_begin(CALLED_SIDE, CALLED_SIDE, -INFINITY);
    called_draw_six(1, 0.7);
    called_draw_six(2, 0.7);
    for (int i = 0; i < CALLED_SIDE * CALLED_SIDE; i++) {
        count[image_get(&called_sheet, i % CALLED_SIDE, i / CALLED_SIDE).r]++;
    }
    return show("%d in 1, %d in 2", count[1], count[2]);
}

static struct shown called_counted(void) {
    (void)called_six_twice();
    return show("%llu, %llu", (unsigned long long)called_canvas.pixels_tested,
                (unsigned long long)called_canvas.pixels_written);
}

/* The depths of 5 x 3 pixels under a triangle that is larger, row by row from the bottom. */
static struct shown called_wide(void) {
    const struct vertex v[3] = {{{-384, -384}, -21}, {{4736, -384}, -1}, {{-384, 4736}, 179}};
    called_begin(5, 3, -INFINITY);
    triangle(&called_canvas, v, rgb(1, 0, 0));
    return show("%.150s, behind %.5g", show_joined(called_depths, 15, " ").text, called_depths[15]);
}

/* How many different depths are there inside a triangle with this depth at all corners? */
static int called_depths_inside(double depth) {
    const struct vertex v[3] = {{{10, 20}, depth}, {{2000, 300}, depth}, {{700, 1990}, depth}};
    int count = 0;
    called_begin(CALLED_SIDE, CALLED_SIDE, -INFINITY);
    triangle(&called_canvas, v, rgb(1, 0, 0));
    for (int i = 0; i < CALLED_SIDE * CALLED_SIDE; i++) {
        bool is_new = called_depths[i] != -INFINITY;
        for (int k = 0; k < i; k++) {
            is_new = is_new && called_depths[k] != called_depths[i];
        }
        count += is_new;
    }
    return count;
}

/* ---- The depths as a picture ---- */

/* Those of an image of 3 x 2 pixels. */
static struct shown called_greys(double a, double b, double c, double d, double e, double f) {
    const double depth[6] = {a, b, c, d, e, f};
    uint8_t *v = called_bytes;
    called_sheet = (struct image){3, 2, IMAGE_GREY, called_bytes};
    show_depths(&called_sheet, depth);
    return show("%d %d %d %d %d %d", v[0], v[1], v[2], v[3], v[4], v[5]);
}

/* ---- Lines ---- */

/* Draw a line on 8 x 7 pixels of that depth: "(2,1) at 0.5 (3,1) at 0.75", the pixels that changed,
 * row by row from the bottom, with their depths. */
static struct shown called_line(struct line_end a, struct line_end b, double over) {
    struct shown shown = {""};
    called_begin(CALLED_SIDE, CALLED_SIDE - 1, over);
    hidden_line(&called_canvas, a, b, rgb(1, 0, 0));
    for (int i = 0; i < CALLED_SIDE * CALLED_SIDE; i++) {
        const int x = i % CALLED_SIDE, y = i / CALLED_SIDE;
        const bool colored = image_get(&called_sheet, x, y).r != 0;
        if (colored || called_depths[i] != over) {
            shown = show("%.180s%s(%d,%d) at %.5g%s", shown.text, shown.text[0] != '\0' ? " " : "",
                         x, y, called_depths[i], colored ? "" : " without color");
        }
    }
    return shown.text[0] != '\0' ? shown : show("none");
}

static void numbers(void) {
    const double none = -INFINITY;
    const struct vec2 rising[] = {{1.75, 10}, {5.75, 50}}, falling[] = {{-1.5, 5}, {14.5, -11}};
    const struct vec2 as_near[] = {{0.5, 0.7}, {4.5, 0.7}, {0.5, 0.7}, {6.5, 0.7}};
    const struct vec2 below_0[] = {{0.5, -3}, {4.5, -3}, {0.5, -5}, {6.5, -5}};
    const struct vec2 two[] = {{0.5, 30}, {4.5, 10}, {-1.5, 20}, {6.5, 20}};
    TEXT("5.1", "draw_segment() from (20.5, 34) to (744.5, 400): depth of column 480",
         called_depth_at(xy(20.5, 34), xy(744.5, 400), CALLED_LONG_ROW, 480), "266.54");
    TEXT("5.1", "draw_segment() from (1.75, 10) to (5.75, 50): depths", called_row(rising, 1, true),
         "-inf -inf 17.5 27.5 37.5 47.5 -inf -inf");
    TEXT("5.1", "draw_segment() from (-1.5, 5) to (14.5, -11): depths",
         called_row(falling, 1, true), "3 2 1 0 -1 -2 -3 -4");
    TEXT("5.1", "draw_segment() from (-1.5, 5) to (14.5, -11): what is behind the 8 depths",
         called_depth_at(falling[0], falling[1], CALLED_SIDE, CALLED_SIDE), "-inf");
    TEXT("5.1", "draw_segment() from (-1.5, 5) to (14.5, -11): what is before the 8 depths",
         called_depth_at(falling[0], falling[1], CALLED_SIDE, -1), "-inf");
    TEXT("5.1",
         "draw_segment() in 1 from (0.5, 30) to (4.5, 10), in 2 from (-1.5, 20) to (6.5, 20): "
         "colors",
         called_row(two, 2, false), "1 1 1 2 2 2 0 0");
    TEXT("5.1",
         "draw_segment() in 1 from (0.5, 30) to (4.5, 10), in 2 from (-1.5, 20) to (6.5, 20): "
         "depths",
         called_row(two, 2, true), "30 25 20 20 20 20 -inf -inf");
    TEXT("5.1",
         "draw_segment() in 1 from (0.5, 0.7) to (4.5, 0.7), in 2 as near, to (6.5, 0.7): colors",
         called_row(as_near, 2, false), "1 1 1 1 2 2 0 0");
    TEXT(
        "5.1",
        "draw_segment() in 1 from (0.5, -3) to (4.5, -3), in 2 from (0.5, -5) to (6.5, -5): colors",
        called_row(below_0, 2, false), "1 1 1 1 2 2 0 0");
    TEXT("5.1", "draw_segment() in 7 from (0.5, 1) to (2.5, 1), in row 1: colors of rows 0, 1",
         called_second_row(), "0 0 0 0, 7 7 0 0");
    TEXT("5.2", "triangle() in color 1 over depth 0.1: pixel (2,2)", called_drawn_over(0.1, 0),
         "color 1, depth 0.15");
    TEXT("5.2", "triangle() in color 1 over depth 0.2: pixel (2,2)", called_drawn_over(0.2, 0),
         "color 0, depth 0.2");
    TEXT("5.2", "triangle() in color 1 over depth 0.1499995: pixel (2,2)",
         called_drawn_over(0.1499995, 0), "color 1, depth 0.15");
    TEXT("5.2", "triangle() in color 1, 600 farther, over depth -inf: pixel (2,2)",
         called_drawn_over(none, -600), "color 1, depth -599.85");
    TEXT("5.2", "triangle() in color 1, 600 nearer, over depth 500: pixel (2,2)",
         called_drawn_over(500, 600), "color 1, depth 600.15");
    AS_WHOLE("5.2", "triangle() in color 1, again in 2: color of pixel (2,2)", called_drawn_twice(),
             1);
    TEXT("5.2", "triangle() with depth 0.7 at all corners in color 1, again in 2: pixels",
         called_six_twice(), "6 in 1, 0 in 2");
    TEXT("5.2", "triangle() with 6 pixels, and again: pixels_tested, pixels_written",
         called_counted(), "12, 6");
    TEXT("5.2", "triangle() over all of 5 x 3 pixels: their depths", called_wide(),
         "1 2 3 4 5 11 12 13 14 15 21 22 23 24 25, behind -inf");
    AS_WHOLE("5.2", "triangle() with depth 0.25 at all corners: different depths",
             called_depths_inside(0.25), 1);
    TEXT("5.3", "show_depths() of -0.238 0.566 0.2 -inf 0 0",
         called_greys(-0.238, 0.566, 0.2, none, 0, 0), "55 255 164 0 114 114");
    TEXT("5.3", "show_depths() of 7 7 7 -inf 7 7", called_greys(7, 7, 7, none, 7, 7),
         "55 55 55 0 55 55");
    TEXT("5.3", "show_depths() of -7e9 -8e9 -8e9 -8e9 -8e9 -9e9",
         called_greys(-7e9, -8e9, -8e9, -8e9, -8e9, -9e9), "255 155 155 155 155 55");
    TEXT("5.3", "show_depths() of -inf 0 1e-12 2e-12 0 0",
         called_greys(none, 0, 1e-12, 2e-12, 0, 0), "0 55 155 255 55 55");
    const struct line_end low = {{0, 0}, 0}, high = {{4, 2}, 1};
    TEXT("5.4", "hidden_line() from (0,0) at 0 to (4,2) at 1 over depth 0.4",
         called_line(low, high, 0.4), "(2,1) at 0.5 (3,1) at 0.75 (4,2) at 1");
    TEXT("5.4", "hidden_line() from (4,2) at 1 to (0,0) at 0 over depth 0.4",
         called_line(high, low, 0.4), "(2,1) at 0.5 (3,1) at 0.75 (4,2) at 1");
    TEXT("5.4", "hidden_line() from (1,6) at 3 to (3,0) at 0 over depth 1.2",
         called_line((struct line_end){{1, 6}, 3}, (struct line_end){{3, 0}, 0}, 1.2),
         "(2,3) at 1.5 (2,4) at 2 (1,5) at 2.5 (1,6) at 3");
    TEXT("5.4", "hidden_line() from (-8,3) at 0 to (8,3) at 4 over depth 3.1",
         called_line((struct line_end){{-8, 3}, 0}, (struct line_end){{8, 3}, 4}, 3.1),
         "(5,3) at 3.25 (6,3) at 3.5 (7,3) at 3.75");
    TEXT("5.4", "hidden_line() from (3,4) at 2 to (3,4) at 5 over depth 1",
         called_line((struct line_end){{3, 4}, 2}, (struct line_end){{3, 4}, 5}, 1), "(3,4) at 2");
    TEXT("5.4", "hidden_line() from (0,1) at 3 to (4,1) at 3 over depth 3",
         called_line((struct line_end){{0, 1}, 3}, (struct line_end){{4, 1}, 3}, 3), "none");
}
