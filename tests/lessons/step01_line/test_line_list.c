/* Lesson 1's list of a line's pixels against the walk of common, which is held against exact
 * answers elsewhere: the same pixels, in the same order. */
#define LESSON "../step01_line/main.c"
#include "lesson.h"

#include "oracle/oracle.h"
#include "raster.h"
#include "unit/unit.h"

enum { SIZE = 40 };

static void check_list(struct pixel a, struct pixel b) {
    struct pixel list[SIZE] = {{0}};
    struct line_walk walk;
    size_t length = line_length(a, b);
    if (!CHECK(length >= 1 && length <= SIZE)) {
        return;
    }
    line_list(a, b, list);
    bool more = line_begin(&walk, a, b, SIZE, SIZE);
    for (size_t i = 0; i < length; i++) {
        CHECK(more && list[i].x == walk.x && list[i].y == walk.y);
        more = more && line_next(&walk);
    }
    CHECK(!more);
}

static int random_place(struct random *random) {
    return (int)random_between(random, 0, SIZE - 1);
}

static void test_any_line(void) {
    struct random random = {91};
    for (int i = 0; i < 5000; i++) {
        check_list((struct pixel){random_place(&random), random_place(&random)},
                   (struct pixel){random_place(&random), random_place(&random)});
    }
}

/* Points, horizontal, vertical and diagonal lines in every direction. */
static void test_special_lines(void) {
    for (int dx = -1; dx <= 1; dx++) {
        for (int dy = -1; dy <= 1; dy++) {
            for (int length = 0; length < 20; length++) {
                check_list((struct pixel){20, 20},
                           (struct pixel){20 + dx * length, 20 + dy * length});
            }
        }
    }
}

/* Half way between two colours a half rounds up; each end has its own colour, from both ends. */
static void test_colors_along(void) {
    struct color from = color_rgb(0, 255, 10), to = color_rgb(255, 0, 11);
    static const struct pixel ends[][2] = {
        {{3, 3}, {7, 3}}, {{3, 3}, {3, 7}}, {{7, 5}, {3, 3}}, {{3, 7}, {4, 3}}};
    for (size_t i = 0; i < sizeof ends / sizeof ends[0]; i++) {
        struct pixel a = ends[i][0], b = ends[i][1];
        struct pixel middle = {(a.x + b.x) / 2, (a.y + b.y) / 2};
        struct color c = color_along(a, b, from, to, middle);
        CHECK(c.r == 128 && c.g == 128 && c.b == 11);
        c = color_along(a, b, from, to, a);
        CHECK(c.r == 0 && c.g == 255 && c.b == 10);
        c = color_along(a, b, from, to, b);
        CHECK(c.r == 255 && c.g == 0 && c.b == 11);
    }
    struct color point =
        color_along((struct pixel){1, 1}, (struct pixel){1, 1}, from, to, (struct pixel){1, 1});
    CHECK(point.r == 0 && point.g == 255 && point.b == 10);
}

UNIT_MAIN(TEST(test_any_line), TEST(test_special_lines), TEST(test_colors_along))
