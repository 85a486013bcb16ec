/* The pictures of lesson 1's README that are not references. */
#include "../tests/bench/figures.h"

#define LESSON "../step01_line/main.c"
#include "../tests/lesson.h"

#include "attempts.h"

static const struct color background = {0, 0, 0, 255};
static const struct color white = {255, 255, 255, 255};
static const struct color red = {0, 0, 255, 255};
static const struct color orange = {0, 150, 255, 255};

enum { GRID = 56 }; /* grey level of the lines between enlarged pixels */

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

/* The scenes line, octants and gradient, side by side. */
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
    image_free(&image);
    return sheet_end(&sheet, done, directory, "made", error);
}

static bool draw_attempts(const char *directory, struct error *error) {
    static const char *const names[] = {"attempt_1", "attempt_2", "attempt_3", "attempt_4"};
    bool done = true;
    for (int i = 0; done && i < 4; i++) {
        struct image image;
        if (!image_create(&image, 100, 100, IMAGE_BGR, error)) {
            return false;
        }
        draw_three_lines(&image, line_attempt(i));
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
    struct pixel a, b;
    bool backwards;       /* the second one draws from b to a */
    size_t width, height; /* of the image that both are drawn into */
    struct detail shown;
};

static bool draw_pair(const char *directory, const struct line_pair *pair, struct error *error) {
    struct comparison compared;
    bool done = comparison_create(&compared, pair->width, pair->height, error);
    if (done) {
        const struct pixel a = pair->a, b = pair->b;
        pair->first_draw(&compared.first, a, b, white);
        pair->second_draw(&compared.second, pair->backwards ? b : a, pair->backwards ? a : b,
                          white);
        comparison_show(&compared, white);
        done = figure_save_detail(&compared.shown, pair->shown, directory, pair->name, error);
    }
    comparison_free(&compared);
    return done;
}

static bool draw_pairs(const char *directory, struct error *error) {
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

bool draw_figures(const char *directory, struct model *bust, struct error *error) {
    (void)bust;
    return draw_made(directory, error) && draw_attempts(directory, error) &&
           draw_holes(directory, error) && draw_pairs(directory, error) &&
           draw_cases(directory, error);
}
