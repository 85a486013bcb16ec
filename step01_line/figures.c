/* The pictures of step 1's README that are not references, and its table of errors. */
#include "../tests/bench/figures.h"

#define LESSON "../step01_line/main.c"
#include "../tests/lesson.h"

#include "attempts.h"

#include <stdio.h>
#include <string.h>

static const struct color background = {0, 0, 0, 255};
static const struct color white = {255, 255, 255, 255};
static const struct color red = {0, 0, 255, 255};
static const struct color orange = {0, 150, 255, 255};

enum { GRID = 56 }; /* grey level of the lines between enlarged pixels */

/* A line of a million columns, of which the image holds the last ones. */
enum { LONG_WIDTH = 200, LONG_HEIGHT = 64 };
static const struct pixel long_a = {-1000000, -250007}, long_b = {199, 60};

/* ---- Pictures ---- */

/* Save an image of 100x100 pixels large enough to see them. */
static bool save_enlarged(const struct image *image, const char *directory, const char *name,
                          struct error *error) {
    return figure_save_detail(image, detail_of_whole(image, 3, 0), directory, name, error);
}

/* The lesson's three lines; the last one goes leftwards over the first. */
static void draw_three_lines(struct image *image, line_function *draw) {
    draw(image, (struct pixel){13, 20}, (struct pixel){80, 40}, white);
    draw(image, (struct pixel){20, 13}, (struct pixel){40, 80}, red);
    draw(image, (struct pixel){80, 40}, (struct pixel){13, 20}, red);
}

/* The scenes line, octants and gradient, side by side; and pixel and far. */
static bool draw_made(const char *directory, struct error *error) {
    struct sheet sheet = {.width = 300, .height = 300, .columns = 3, .rows = 1, .gap = 6};
    struct image image = {0};
    bool (*const draw[])(struct drawing *, struct image *,
                         struct error *) = {draw_line, draw_octants, draw_gradient};
    bool done = sheet_create(&sheet, error) && image_create(&image, 100, 100, IMAGE_BGR, error);
    for (int i = 0; done && i < 3; i++) {
        image_clear(&image, background);
        done = draw[i](NULL, &image, error);
        sheet_add_detail(&sheet, &image, detail_of_whole(&image, 3, 0));
    }
    done = done && figure_save(&sheet.image, directory, "made", error);
    if (done) {
        image_clear(&image, background);
        done = draw_pixel(NULL, &image, error) && save_enlarged(&image, directory, "pixel", error);
    }
    if (done) {
        image_clear(&image, background);
        struct drawing drawing = {0};
        done = draw_far(&drawing, &image, error) && save_enlarged(&image, directory, "far", error);
    }
    image_free(&image);
    sheet_free(&sheet);
    return done;
}

static bool draw_attempts(const char *directory, struct error *error) {
    static const char *const names[] = {"attempt_1", "attempt_2", "attempt_3", "attempt_4"};
    bool done = true;
    for (int i = 0; done && i < 4; i++) {
        struct image image;
        if (!image_create(&image, 100, 100, IMAGE_BGR, error)) {
            return false;
        }
        draw_three_lines(&image, line_attempt(i).draw);
        done = save_enlarged(&image, directory, names[i], error);
        image_free(&image);
    }
    return done;
}

/* The first attempt on a line of more than a hundred columns. */
static bool draw_holes(const char *directory, struct error *error) {
    struct image image;
    if (!image_create(&image, 400, 40, IMAGE_BGR, error)) {
        return false;
    }
    attempt_1_hundred_steps(&image, (struct pixel){5, 5}, (struct pixel){394, 34}, white);
    bool done =
        figure_save_detail(&image, detail_of_whole(&image, 2, 0), directory, "holes", error);
    image_free(&image);
    return done;
}

/* A line as two versions draw it. */
struct line_pair {
    const char *name;
    line_function *first_draw, *second_draw;
    struct pixel first_a, first_b, second_a, second_b;
    size_t width, height; /* of the image that both are drawn into */
    struct detail shown;
};

static bool draw_pair(const char *directory, const struct line_pair *pair, struct error *error) {
    struct comparison compared;
    bool done = comparison_create(&compared, pair->width, pair->height, error);
    if (done) {
        pair->first_draw(&compared.first, pair->first_a, pair->first_b, white);
        pair->second_draw(&compared.second, pair->second_a, pair->second_b, white);
        comparison_show(&compared, white);
        done = figure_save_detail(&compared.shown, pair->shown, directory, pair->name, error);
    }
    comparison_free(&compared);
    return done;
}

static bool draw_pairs(const char *directory, struct error *error) {
    const struct pixel a = {13, 20}, b = {80, 40}, low = {1, 1}, high = {19, 10};
    const struct line_pair pairs[] = {
        {.name = "cut",
         .first_draw = attempt_1_hundred_steps,
         .second_draw = line,
         .first_a = a,
         .first_b = b,
         .second_a = a,
         .second_b = b,
         .width = 100,
         .height = 100,
         .shown = {12, 19, 70, 23, .zoom = 10, .grid = GRID}},
        {.name = "ties",
         .first_draw = attempt_by_cases,
         .second_draw = attempt_by_cases,
         .first_a = low,
         .first_b = high,
         .second_a = high,
         .second_b = low,
         .width = 21,
         .height = 12,
         .shown = {0, 0, 21, 12, .zoom = 16, .grid = GRID}},
        {.name = "drift",
         .first_draw = attempt_7_two_parts,
         .second_draw = line,
         .first_a = long_a,
         .first_b = long_b,
         .second_a = long_a,
         .second_b = long_b,
         .width = LONG_WIDTH,
         .height = LONG_HEIGHT,
         .shown = {100, 32, 80, 24, .zoom = 10, .grid = GRID}},
    };
    bool done = true;
    for (size_t i = 0; done && i < sizeof pairs / sizeof pairs[0]; i++) {
        done = draw_pair(directory, &pairs[i], error);
    }
    return done;
}

/* Point, horizontal, vertical, diagonal, oblique and steep: one function draws them all. */
static bool draw_cases(const char *directory, struct error *error) {
    static const struct {
        struct pixel a, b;
    } lines[] = {
        {{2, 6}, {2, 6}},    {{5, 6}, {13, 6}},  {{16, 2}, {16, 10}},
        {{19, 2}, {27, 10}}, {{30, 4}, {40, 8}}, {{44, 1}, {48, 11}},
    };
    struct image image;
    if (!image_create(&image, 51, 13, IMAGE_BGR, error)) {
        return false;
    }
    for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) {
        line(&image, lines[i].a, lines[i].b, i % 2 ? white : orange);
    }
    bool done =
        figure_save_detail(&image, detail_of_whole(&image, 14, GRID), directory, "cases", error);
    image_free(&image);
    return done;
}

/* ---- The table of errors ---- */

struct tally {
    unsigned long columns;     /* steps along u, of all lines together */
    unsigned long empty;       /* of them: no pixel */
    unsigned long not_nearest; /* pixels farther from the ideal line than another of their column */
    unsigned long one_sided;   /* lines that set other pixels from b to a than from a to b */
};

/* Is no other pixel of the same column (steep: row) nearer to the ideal line than p? Exactly, in
 * integers: twice the distance along v, times the run. */
static bool is_nearest(struct pixel a, struct pixel b, struct pixel p) {
    bool steep = llabs((int64_t)b.y - a.y) > llabs((int64_t)b.x - a.x);
    int64_t u_a = steep ? a.y : a.x, v_a = steep ? a.x : a.y;
    int64_t run = (steep ? b.y : b.x) - u_a, rise = (steep ? b.x : b.y) - v_a;
    int64_t u = (steep ? p.y : p.x) - u_a, v = (steep ? p.x : p.y) - v_a;
    if (run == 0) {
        return u == 0 && v == 0;
    }
    return 2 * llabs(v * run - u * rise) <= llabs(run);
}

/* Add what one drawn line did. `u_size` columns (steep: rows) of the image are looked at. */
static void tally_line(struct tally *tally, const struct image *image, struct pixel a,
                       struct pixel b) {
    bool steep = llabs((int64_t)b.y - a.y) > llabs((int64_t)b.x - a.x);
    int u_first = steep ? (a.y < b.y ? a.y : b.y) : (a.x < b.x ? a.x : b.x);
    u_first = u_first > 0 ? u_first : 0;
    int u_last = steep ? (a.y < b.y ? b.y : a.y) : (a.x < b.x ? b.x : a.x);
    int v_size = (int)(steep ? image->width : image->height);
    for (int u = u_first; u <= u_last; u++) {
        bool found = false;
        for (int v = 0; v < v_size; v++) {
            struct pixel p = steep ? (struct pixel){v, u} : (struct pixel){u, v};
            if (image_get(image, p.x, p.y).g != 0) {
                found = true;
                tally->not_nearest += !is_nearest(a, b, p);
            }
        }
        tally->columns++;
        tally->empty += !found;
    }
}

/* All lines from the middle of a small image to each of its pixels, in both directions. */
static bool tally_short_lines(struct tally *tally, line_function *draw, struct error *error) {
    enum { SIZE = 41, MIDDLE = SIZE / 2 };
    struct image there = {0}, back = {0};
    bool done = image_create(&there, SIZE, SIZE, IMAGE_GREY, error) &&
                image_create(&back, SIZE, SIZE, IMAGE_GREY, error);
    for (int i = 0; done && i < SIZE * SIZE; i++) {
        struct pixel a = {MIDDLE, MIDDLE}, b = {i % SIZE, i / SIZE};
        image_clear(&there, background);
        image_clear(&back, background);
        draw(&there, a, b, white);
        draw(&back, b, a, white);
        tally_line(tally, &there, a, b);
        tally->one_sided += memcmp(there.pixels, back.pixels, SIZE * SIZE) != 0;
    }
    image_free(&there);
    image_free(&back);
    return done;
}

static bool tally_long_line(struct tally *tally, line_function *draw, struct error *error) {
    struct image image;
    if (!image_create(&image, LONG_WIDTH, LONG_HEIGHT, IMAGE_GREY, error)) {
        return false;
    }
    draw(&image, long_a, long_b, white);
    tally_line(tally, &image, long_a, long_b);
    image_free(&image);
    return true;
}

static bool print_table(struct error *error) {
    printf("step01_line: every line from the middle of 41x41 pixels,\n             and the last "
           "200 columns of (-1000000,-250007)-(199,60)\n");
    printf("%-20s %8s %8s %12s %10s %12s\n", "version", "columns", "empty", "not nearest",
           "one-sided", "long: wrong");
    for (int i = 0; i <= LINE_ATTEMPT_COUNT; i++) {
        struct line_attempt version = {"line()", line};
        if (i < LINE_ATTEMPT_COUNT) {
            version = line_attempt(i);
        }
        struct tally all = {0}, one = {0};
        if (!tally_short_lines(&all, version.draw, error) ||
            !tally_long_line(&one, version.draw, error)) {
            return false;
        }
        printf("%-20s %8lu %8lu %12lu %10lu %12lu\n", version.name, all.columns, all.empty,
               all.not_nearest, all.one_sided, one.empty + one.not_nearest);
    }
    return true;
}

bool draw_figures(const char *directory, struct model *bust, struct error *error) {
    (void)bust;
    return draw_made(directory, error) && draw_attempts(directory, error) &&
           draw_holes(directory, error) && draw_pairs(directory, error) &&
           draw_cases(directory, error) && print_table(error);
}
