/* The pictures of lesson 1's README that are not references. */
#include "bench/figures.h"

#define LESSON "../step01_line/main.c"
#include "lesson.h"

#include "../../../step01_line/attempts.h"

static const struct color white = {255, 255, 255, 255};
static const struct color red = {0, 0, 255, 255};
static const struct color orange = {0, 150, 255, 255};

enum { GRID = 56 }; /* grey level of the lines between enlarged pixels */

/* ---- Pictures ---- */

/* The lesson's three lines; the last one goes leftwards over the first. */
static void draw_three_lines(struct image *image, attempt_function *draw) {
    draw(image, (struct pixel){13, 20}, (struct pixel){80, 40}, white);
    draw(image, (struct pixel){20, 13}, (struct pixel){40, 80}, red);
    draw(image, (struct pixel){80, 40}, (struct pixel){13, 20}, red);
}

/* The scenes line, octants and gradient, side by side. */
static void draw_made(void) {
    struct sheet sheet = {.width = 300, .height = 300, .columns = 3, .rows = 1, .gap = 6};
    bool (*const draw[])(struct drawing *, struct image *,
                         struct error *) = {draw_line, draw_octants, draw_gradient};
    sheet_create(&sheet);
    for (int i = 0; i < 3; i++) {
        struct image image = figure_image(100, 100);
        figure_need(draw[i](NULL, &image, &figure_error));
        sheet_add_detail(&sheet, &image, detail_of_whole(&image, 3, 0));
    }
    figure_save(&sheet.image, "made");
}

static void draw_attempts(void) {
    static const char *const names[] = {"attempt_1", "attempt_2", "attempt_3", "attempt_4"};
    for (int i = 0; i < 4; i++) {
        struct image image = figure_image(100, 100);
        draw_three_lines(&image, attempt_at(i));
        figure_save_detail(&image, detail_of_whole(&image, 3, 0), names[i]);
    }
}

/* The first attempt on a line of more than a hundred columns. */
static void draw_holes(void) {
    struct image image = figure_image(400, 40);
    attempt_1_hundred_steps(&image, (struct pixel){5, 5}, (struct pixel){394, 34}, white);
    figure_save_detail(&image, detail_of_whole(&image, 2, 0), "holes");
}

/* One line each, for the walk by hand and for ties. */
static void draw_steps(void) {
    struct image image = figure_image(6, 3);
    line(&image, (struct pixel){0, 0}, (struct pixel){5, 2}, white);
    figure_save_detail(&image, detail_of_whole(&image, 64, 0), "walk");
    image = figure_image(21, 12);
    attempt_by_cases(&image, (struct pixel){1, 1}, (struct pixel){19, 10}, white);
    figure_save_detail(&image, detail_of_whole(&image, 16, 0), "tie");
}

/* A line as two versions draw it. */
struct line_pair {
    const char *name;
    attempt_function *first_draw, *second_draw;
    struct pixel a, b;
    bool backwards;       /* the second one draws from b to a */
    size_t width, height; /* of the image that both are drawn into */
    struct detail shown;
};

static void draw_pair(const struct line_pair *pair) {
    struct comparison compared;
    comparison_create(&compared, pair->width, pair->height);
    const struct pixel a = pair->a, b = pair->b;
    pair->first_draw(&compared.first, a, b, white);
    pair->second_draw(&compared.second, pair->backwards ? b : a, pair->backwards ? a : b, white);
    comparison_show(&compared, white);
    figure_save_detail(&compared.shown, pair->shown, pair->name);
}

static void draw_pairs(void) {
    static const struct line_pair pairs[] = {
        {.name = "cut",
         .first_draw = attempt_1_hundred_steps,
         .second_draw = line,
         .a = {13, 20},
         .b = {80, 40},
         .width = 100,
         .height = 100,
         .shown = {12, 19, 70, 23, .zoom = 10, .grid = GRID}},
        {.name = "ties",
         .first_draw = attempt_by_cases,
         .second_draw = attempt_by_cases,
         .a = {1, 1},
         .b = {19, 10},
         .backwards = true,
         .width = 21,
         .height = 12,
         .shown = {0, 0, 21, 12, .zoom = 16, .grid = GRID}},
        {.name = "drift",
         .first_draw = attempt_7_two_parts,
         .second_draw = line,
         .a = {-1000000, -250007}, /* a million columns, of which the image holds the last ones */
         .b = {199, 60},
         .width = 200,
         .height = 64,
         .shown = {100, 32, 80, 24, .zoom = 10, .grid = GRID}},
    };
    for (size_t i = 0; i < sizeof pairs / sizeof pairs[0]; i++) {
        draw_pair(&pairs[i]);
    }
}

/* Point, horizontal, vertical, diagonal, oblique and steep: one function draws them all. */
static void draw_cases(void) {
    static const struct {
        struct pixel a, b;
    } lines[] = {
        {{2, 6}, {2, 6}},    {{5, 6}, {13, 6}},  {{16, 2}, {16, 10}},
        {{19, 2}, {27, 10}}, {{30, 4}, {40, 8}}, {{44, 1}, {48, 11}},
    };
    struct image image = figure_image(51, 13);
    for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) {
        line(&image, lines[i].a, lines[i].b, i % 2 ? white : orange);
    }
    figure_save_detail(&image, detail_of_whole(&image, 14, GRID), "cases");
}

void draw_figures(struct model *bust) {
    (void)bust;
    draw_made();
    draw_attempts();
    draw_holes();
    draw_steps();
    draw_pairs();
    draw_cases();
}
