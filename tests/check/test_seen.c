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

static struct color keep(int x, int y) {
    return shape_color(x, y);
}

static struct color blank(int x, int y) {
    (void)x, (void)y;
    return color_rgb(0, 0, 0);
}

static struct color one_color(int x, int y) {
    struct color c = shape_color(x, y);
    return c.r > 0 ? color_rgb(9, 8, 7) : c;
}

static struct color mirrored(int x, int y) {
    return shape_color(SIDE - 1 - x, y);
}

static struct color upside_down(int x, int y) {
    return shape_color(x, SIDE - 1 - y);
}

static struct color half_turn(int x, int y) {
    return shape_color(SIDE - 1 - x, SIDE - 1 - y);
}

static struct color exchanged(int x, int y) {
    return shape_color(y, x);
}

static struct color quarter_left(int x, int y) {
    return shape_color(y, SIDE - 1 - x);
}

static struct color moved(int x, int y) {
    return shape_color(x - 7, y - 5);
}

static struct color halved(int x, int y) {
    return shape_color(2 * x - 10, 2 * y - 10);
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

static bool draw(struct image *image, change_function *change) {
    struct error error;
    if (!CHECK(image_create(image, SIDE, SIDE, IMAGE_BGR, &error))) {
        return false;
    }
    for (int y = 0; y < SIDE; y++) {
        for (int x = 0; x < SIDE; x++) {
            image_set(image, x, y, change(x, y));
        }
    }
    return true;
}

static void test_changes(void) {
    const struct {
        change_function *change;
        const char *text;
    } cases[] = {
        {keep, ""},
        {blank, "nothing is drawn"},
        {one_color, "all that is drawn has one colour, 9,8,7"},
        {mirrored, "mirrored: left and right are exchanged"},
        {upside_down, "upside down"},
        {half_turn, "turned by half a turn"},
        {exchanged, "x and y are exchanged"},
        {quarter_left, "turned by a quarter to the left"},
        {moved, "moved by (7,5)"},
        {halved, "0.5 times as wide and 0.5 times as high"},
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
        struct image right, yours = {.pixels = NULL};
        if (draw(&right, keep) && draw(&yours, cases[i].change)) {
            CHECK_TEXT(seen_find(&right, &yours).text, cases[i].text);
        }
        image_free(&right);
        image_free(&yours);
    }
}

UNIT_MAIN(TEST(test_changes))
