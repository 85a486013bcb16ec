/* What is said of pictures that are wrong in simple ways: one without any symmetry, changed. */
#include "seen.h"

#include "compare.h"
#include "unit/unit.h"

enum { SIDE = 60 };

/* An L with a bar of another colour, in which each row and column has its own level. */
static struct color shape_color(int x, int y) {
    bool is_upright = x >= 10 && x < 20 && y >= 10 && y < 45;
    bool is_foot = x >= 20 && x < 35 && y >= 10 && y < 18;
    if (is_upright) {
        return color_rgb((uint8_t)(100 + 3 * x), 40, (uint8_t)(60 + 2 * y));
    }
    return is_foot ? color_rgb(20, (uint8_t)(90 + 2 * x), 200) : color_rgb(0, 0, 0);
}

/* Where yours takes the colour of pixel (x,y) from. */
typedef struct color change_function(int x, int y);

static struct color blank(int x, int y) {
    (void)x, (void)y;
    return color_rgb(0, 0, 0);
}

static struct color one_color(int x, int y) {
    struct color c = shape_color(x, y);
    return c.r > 0 ? color_rgb(9, 8, 7) : c;
}

static struct color blue_for_red(int x, int y) {
    struct color c = shape_color(x, y);
    return color_rgb(c.b, c.g, c.r);
}

static struct color without_foot(int x, int y) {
    return x < 20 ? shape_color(x, y) : color_rgb(0, 0, 0);
}

static struct color without_foot_but_a_pixel(int x, int y) {
    return x == 0 && y == 0 ? color_rgb(9, 9, 9) : without_foot(x, y);
}

static struct color with_bar(int x, int y) {
    return y >= 50 && y < 53 ? color_rgb(9, 9, 9) : shape_color(x, y);
}

static struct color darker(int x, int y) {
    struct color c = shape_color(x, y);
    return c.r > 0 ? color_rgb((uint8_t)(c.r - 10), (uint8_t)(c.g - 10), (uint8_t)(c.b - 10)) : c;
}

static struct color bluer(int x, int y) {
    struct color c = shape_color(x, y);
    return c.r > 0 && y < 30 ? color_rgb(c.r, c.g, (uint8_t)(c.b + 30)) : c;
}

static struct color all_ways(int x, int y) {
    struct color c = shape_color(x, y);
    if (y == 50 && c.r == 0) {
        return color_rgb(9, 9, 9);
    }
    return x == 10 || c.r == 0 ? color_rgb(0, 0, 0) : color_rgb(c.b, c.r, c.g);
}

static struct color noise(int x, int y) {
    struct color c = shape_color(x, y);
    int level = (x * 37 + y * 91) % 200;
    return c.r > 0 ? color_rgb((uint8_t)(level + 30), (uint8_t)level, c.g) : c;
}

/* Moved, turned, smaller: pixel (x,y) is that of the shape at (a x + b y + c, d x + e y + f). */
struct place {
    int a, b, c, d, e, f;
};

static struct image draw(change_function *change, struct place to) {
    struct image image;
    struct error error;
    CHECK(image_create(&image, SIDE, SIDE, IMAGE_BGR, &error));
    for (int y = 0; y < SIDE; y++) {
        for (int x = 0; x < SIDE; x++) {
            image_set(&image, x, y, change(to.a * x + to.b * y + to.c, to.d * x + to.e * y + to.f));
        }
    }
    return image;
}

static const struct place same = {1, 0, 0, 0, 1, 0};

static void check_seen(change_function *change, struct place from, struct place to,
                       const char *text) {
    struct image right = draw(shape_color, from), yours = draw(change, to);
    CHECK_TEXT(seen_find(&right, &yours).text, text);
    image_free(&right);
    image_free(&yours);
}

static void test_places(void) {
    enum { LAST = SIDE - 1 };
    static const struct {
        struct place to;
        const char *text;
    } cases[] = {
        {{1, 0, 0, 0, 1, 0}, ""},
        {{-1, 0, LAST, 0, 1, 0}, "mirrored: left and right are exchanged"},
        {{1, 0, 0, 0, -1, LAST}, "upside down"},
        {{-1, 0, LAST, 0, -1, LAST}, "turned by half a turn"},
        {{0, 1, 0, 1, 0, 0}, "x and y are exchanged"},
        {{0, 1, 0, -1, 0, LAST}, "turned by a quarter to the left"},
        {{0, -1, LAST, 1, 0, 0}, "turned by a quarter to the right"},
        {{1, 0, -7, 0, 1, -5}, "moved by (7,5)"},
        {{1, 0, 0, 0, 2, -10}, "1 times as wide and 0.5 times as high"},
        {{2, 0, -10, 0, 2, -10}, "0.5 times as wide and 0.5 times as high"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        check_seen(shape_color, same, cases[i].to, cases[i].text);
    }
    /* Where the left side is cut off in both. */
    check_seen(shape_color, (struct place){1, 0, 12, 0, 1, 0}, (struct place){1, 0, 11, 0, 1, 0},
               "moved by (1,0)");
}

static void test_colors(void) {
    const struct {
        change_function *change;
        const char *text;
    } cases[] = {
        {blank, "nothing is drawn"},
        {one_color, "all that is drawn has one colour, 9,8,7"},
        {blue_for_red, "red and blue are exchanged"},
        {without_foot, "25 % of the picture is missing, the rest is right"},
        {without_foot_but_a_pixel, "25 % of the picture is missing, nearly all the rest is right"},
        {with_bar, "27 % of what you draw should not be there, the rest is right"},
        {darker, "the right pixels are drawn, but too dark: where they differ, by 10 on average"},
        {bluer, "the right pixels are drawn, but too light: where they differ, by 10 on average"},
        {all_ways, "35 pixels are missing, 60 are too many, 435 have other colours"},
        {noise, "the right pixels are drawn, in other colours"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        check_seen(cases[i].change, same, same, cases[i].text);
    }
}

/* A background that is not black: of a panel. */
static struct color on_grey(int x, int y) {
    struct color c = shape_color(x, y);
    return c.r > 0 ? c : color_rgb(26, 26, 26);
}

static struct color on_grey_without_foot(int x, int y) {
    return x < 20 ? on_grey(x, y) : color_rgb(26, 26, 26);
}

static void test_background(void) {
    struct image right = draw(on_grey, same), yours = draw(on_grey_without_foot, same);
    CHECK_TEXT(seen_find(&right, &yours).text, "25 % of the picture is missing, the rest is right");
    image_free(&right);
    image_free(&yours);
}

UNIT_MAIN(TEST(test_places), TEST(test_colors), TEST(test_background))
