/* The pictures of lesson 1's README that are not references. */
#include "bench/figures.h"

#define LESSON "../step01_line/main.c"
#include "lesson.h"

#include "../../../step01_line/attempts.h"

#include <stdio.h>

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
        {.name = "added",
         .first_draw = attempt_t_added,
         .second_draw = line,
         .a = {-20000, -5007},
         .b = {199, 60},
         .width = 200,
         .height = 64,
         .shown = {120, 38, 80, 24, .zoom = 10, .grid = GRID}},
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

/* Every kind of line by four attempts: point, horizontal, vertical, diagonal, and four oblique
 * ones, of which two go to the left. White is correct, orange wrong, blue missing. */
static void draw_kinds(void) {
    static const struct {
        struct pixel a, b;
    } lines[] = {
        {{2, 6}, {2, 6}},   {{5, 6}, {13, 6}},   {{16, 2}, {16, 10}}, {{19, 2}, {27, 10}},
        {{30, 4}, {42, 9}}, {{45, 0}, {50, 12}}, {{65, 4}, {53, 9}},  {{73, 0}, {68, 12}},
    };
    attempt_function *const attempts[] = {attempt_1_hundred_steps, attempt_3_step_per_column,
                                          attempt_by_cases, attempt_t_added};
    struct sheet sheet = {.width = 76 * 10, .height = 13 * 10, .columns = 1, .rows = 4, .gap = 6};
    sheet_create(&sheet);
    for (int i = 0; i < 4; i++) {
        struct comparison compared;
        comparison_create(&compared, 76, 13);
        for (size_t k = 0; k < sizeof lines / sizeof lines[0]; k++) {
            attempts[i](&compared.first, lines[k].a, lines[k].b, white);
            line(&compared.second, lines[k].a, lines[k].b, white);
        }
        comparison_show(&compared, white);
        sheet_add_detail(&sheet, &compared.shown, detail_of_whole(&compared.shown, 10, GRID));
    }
    figure_save(&sheet.image, "kinds");
}

/* One stored line, drawn eight times: axes exchanged, mirrored in x, mirrored in y. Where line()
 * sets another pixel, that one is blue and the stored one orange. */
static void draw_mirrored(void) {
    const struct pixel end = {12, 5};
    struct pixel list[13];
    struct comparison compared;
    comparison_create(&compared, 27, 27);
    line_list((struct pixel){0, 0}, end, list);
    for (int octant = 0; octant < 8; octant++) {
        const int x_sign = octant & 1 ? -1 : 1, y_sign = octant & 2 ? -1 : 1;
        for (size_t i = 0; i < 13; i++) {
            const struct pixel p = octant & 4 ? attempt_transposed(list[i]) : list[i];
            image_set(&compared.first, 13 + x_sign * p.x, 13 + y_sign * p.y, white);
        }
        const struct pixel p = octant & 4 ? attempt_transposed(end) : end;
        line(&compared.second, (struct pixel){13, 13},
             (struct pixel){13 + x_sign * p.x, 13 + y_sign * p.y}, white);
    }
    comparison_show(&compared, white);
    figure_save_detail(&compared.shown, detail_of_whole(&compared.shown, 14, GRID), "mirrored");
}

/* How many lines of 2 to `most` columns lack their last pixel by `t += dt`. */
static void count_unended(int most) {
    struct image image = figure_image((size_t)most, 1);
    int unended = 0;
    for (int x = 1; x < most; x++) {
        image_clear(&image, color_grey(0));
        attempt_t_added(&image, (struct pixel){0, 0}, (struct pixel){x, 0}, white);
        unended += image_get(&image, x, 0).r == 0;
    }
    printf("t += dt: of %d lines, %d lack the last pixel\n", most - 1, unended);
}

/* From black to white by the quotient of two lengths, instead of by steps along u: all lines from
 * (0,0) to the right and up, not steep, of 2 to `most` columns. */
static void count_by_lengths(int most) {
    int pixels = 0, differ = 0, worst = 0;
    struct pixel *list = figure_memory((size_t)most, sizeof *list), worst_at = {0}, worst_end = {0};
    for (int i = 0; i < most * most; i++) {
        const struct pixel a = {0, 0}, b = {i % most, i / most};
        for (int k = 0; b.x > 0 && b.y <= b.x && k <= b.x; k++) {
            line_list(a, b, list);
            const struct pixel p = list[k];
            const double alpha = sqrt((double)(p.x * p.x + p.y * p.y) / (b.x * b.x + b.y * b.y));
            const int ours = color_along(a, b, color_grey(0), color_grey(255), p).r;
            const int apart = abs(level_from(255 * alpha) - ours);
            pixels++;
            differ += apart > 0;
            if (apart > worst) {
                worst = apart;
                worst_at = p;
                worst_end = b;
            }
        }
    }
    printf("by lengths: %d of %d pixels differ, by up to %d: at (%d,%d) of the line to (%d,%d)\n",
           differ, pixels, worst, worst_at.x, worst_at.y, worst_end.x, worst_end.y);
}

void draw_figures(struct model *bust) {
    (void)bust;
    draw_made();
    draw_attempts();
    draw_holes();
    draw_steps();
    draw_pairs();
    draw_cases();
    draw_kinds();
    draw_mirrored();
    count_unended(256);
    count_by_lengths(21);
}
