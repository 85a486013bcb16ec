/* Tests of the comparison: its rule, pixel by pixel, and its limits. */
#include "compare.h"

#include "legend.h"
#include "unit/unit.h"

#include <math.h>

static struct image make(size_t width, size_t height, enum image_format format) {
    struct image image;
    struct error error;
    CHECK(image_create(&image, width, height, format, &error));
    return image;
}

/* Each count of a comparison, and the first of its pixels. */
static void test_counts(void) {
    struct image a = make(4, 2, IMAGE_BGR), b = make(4, 2, IMAGE_BGR);
    image_set(&a, 1, 0, color_grey(50)); /* near */
    image_set(&b, 1, 0, color_grey(52));
    image_set(&a, 0, 1, color_grey(90));  /* missing */
    image_set(&a, 2, 1, color_grey(120)); /* moved */
    image_set(&b, 3, 1, color_grey(120));
    struct comparison c = compare_images(&a, &b);
    const struct {
        struct tally got, wanted;
    } cases[] = {
        {c.differing, {4, 1, 0}}, {c.near, {1, 1, 0}},     {c.apart, {3, 0, 1}},
        {c.wrong, {1, 0, 1}},     {c.coverage, {3, 0, 1}},
    };
    CHECK(c.drawn == 4);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        CHECK(cases[i].got.count == cases[i].wanted.count && cases[i].got.x == cases[i].wanted.x &&
              cases[i].got.y == cases[i].wanted.y);
    }
    struct image grey = make(4, 1, IMAGE_GREY), color = make(4, 1, IMAGE_BGR);
    image_set(&color, 2, 0, color_grey(9)); /* its first four bytes are those of the other one */
    CHECK(compare_images(&grey, &color).differing.count == 1);
    CHECK(!is_same_picture(&grey, &color) && !is_same_picture(&color, &a));
    image_free(&grey);
    image_free(&color);
    image_free(&a);
    image_free(&b);
}

static void test_levels_and_neighbours(void) {
    struct image a = make(5, 5, IMAGE_BGR), b = make(5, 5, IMAGE_BGR);
    static const struct {
        int x, y, level;
        uint64_t differing, apart, wrong;
    } cases[] = {
        {2, 2, 100, 0, 0, 0}, {2, 2, 104, 1, 0, 0}, {2, 2, 96, 1, 0, 0},  {2, 2, 105, 1, 1, 1},
        {2, 2, 95, 1, 1, 1},  {3, 3, 100, 2, 2, 0}, {1, 2, 104, 2, 2, 0}, {1, 3, 105, 2, 2, 2},
        {4, 2, 100, 2, 2, 2}, {0, 0, 100, 2, 2, 2},
    };
    image_set(&a, 2, 2, color_rgb(4, 1, 0)); /* so dark that background agrees with it */
    CHECK(compare_images(&a, &b).coverage.count == 0);
    image_set(&a, 2, 2, color_rgb(5, 1, 0));
    CHECK(compare_images(&a, &b).coverage.count == 1);
    image_set(&a, 2, 2, color_rgb(100, 50, 50));
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        image_clear(&b, color_grey(0));
        image_set(&b, cases[i].x, cases[i].y, color_rgb((uint8_t)cases[i].level, 50, 50));
        struct comparison c = compare_images(&a, &b);
        CHECK(c.differing.count == cases[i].differing && c.apart.count == cases[i].apart &&
              c.wrong.count == cases[i].wrong);
        c = compare_images(&b, &a); /* both sides count the same */
        CHECK(c.differing.count == cases[i].differing && c.apart.count == cases[i].apart &&
              c.wrong.count == cases[i].wrong);
    }
    image_free(&a);
    image_free(&b);
}

/* A channel that is too light on average, of the pixels that agree, however few. */
static void test_lightness(void) {
    static const struct {
        int r, g, b, count; /* so much is added to so many of 100 drawn pixels */
        double lighter;
        bool is_as_light;
    } cases[] = {
        {0, 0, 0, 100, 0, true},   {3, 3, 3, 100, 3, false},       {-3, -3, -3, 100, -3, false},
        {1, 1, 1, 100, 1, true},   {2, 2, 2, 100, 2, false},       {-1, -1, -1, 100, -1, true},
        {4, 4, 4, 31, 1.24, true}, {4, 4, 4, 32, 1.28, false},     {-4, -4, -4, 31, -1.24, true},
        {5, 5, 5, 50, 0, true},    {0, 2, 0, 100, 2, false},       {0, 1, -4, 40, -1.6, false},
        {4, 4, 9, 100, 0, true},   {-4, -4, -4, 32, -1.28, false},
    };
    struct image a = make(20, 10, IMAGE_BGR), b = make(20, 10, IMAGE_BGR);
    for (int i = 0; i < 100; i++) {
        image_set(&a, i % 20, i / 20, color_rgb(100, 110, 120));
    }
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        struct color other = color_rgb((uint8_t)(100 + cases[k].r), (uint8_t)(110 + cases[k].g),
                                       (uint8_t)(120 + cases[k].b));
        for (int i = 0; i < 100; i++) {
            image_set(&b, i % 20, i / 20, i < cases[k].count ? other : color_rgb(100, 110, 120));
        }
        struct comparison c = compare_images(&a, &b);
        CHECK(fabs(compare_lighter(&c) - cases[k].lighter) < 1e-12);
        CHECK(is_as_light(&c) == cases[k].is_as_light);
    }
    image_free(&a);
    image_free(&b);
}

static void test_blank_picture_is_all_wrong(void) {
    struct image a = make(4, 4, IMAGE_BGR), b = make(4, 4, IMAGE_BGR);
    image_set(&b, 0, 3, color_grey(1));
    CHECK(!image_is_blank(&b));
    image_set(&b, 0, 3, color_grey(0));
    CHECK(image_is_blank(&b));
    image_set(&a, 1, 1, color_grey(3)); /* nearly background, and yet a picture */
    CHECK(!image_is_blank(&a));
    struct comparison c = compare_images(&a, &b);
    CHECK(c.drawn == 1 && c.wrong.count == 1 && c.wrong.x == 1 && c.wrong.y == 1);
    image_free(&a);
    image_free(&b);
}

static void test_formats_with_equal_look(void) {
    struct image grey = make(3, 2, IMAGE_GREY), color = make(3, 2, IMAGE_BGR);
    struct image clear = make(3, 2, IMAGE_BGRA);
    for (int i = 0; i < 6; i++) {
        struct color c = color_grey((uint8_t)(40 * i));
        image_set(&grey, i % 3, i / 3, c);
        image_set(&color, i % 3, i / 3, c);
        c.a = (uint8_t)i;
        image_set(&clear, i % 3, i / 3, c);
    }
    CHECK(compare_images(&grey, &color).differing.count == 0 && is_same_picture(&grey, &color));
    CHECK(compare_images(&color, &clear).differing.count == 0 && is_same_picture(&color, &clear));
    CHECK(compare_images(&clear, &grey).drawn == 5);
    image_free(&grey);
    image_free(&color);
    image_free(&clear);
}

static void test_limit_and_its_text(void) {
    static const struct {
        uint64_t wrong, drawn;
        unsigned limit;
        bool within;
        const char *text;
    } cases[] = {
        {0, 100000, 1500, true, "0 %"},
        {1500, 100000, 1500, true, "1.5 %"},
        {1501, 100000, 1500, false, "1.501 %"},
        {15004, 1000000, 1500, false, "1.5004 %"},
        {1000000001, 66666666666, 1500, false, "1.500000002 %"},
        {1540, 100000, 1500, false, "1.54 %"},
        {1560, 100000, 1500, false, "1.6 %"},
        {4400, 100000, 1500, false, "4.4 %"},
        {1, 100000, 1500, true, "0.001 %"},
        {1, 100000, 0, false, "0.001 %"},
        {300, 100000, 200, false, "0.3 %"},
        {7, 7, 1500, false, "100.0 %"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        uint64_t wrong = cases[i].wrong, drawn = cases[i].drawn;
        CHECK_ROW(share_within(wrong, drawn, cases[i].limit) == cases[i].within, cases[i].text);
        CHECK_TEXT(share_show(wrong, drawn, cases[i].limit).text, cases[i].text);
    }
}

/* What counts as wrong is red, or blue where yours is background; what does not is green. */
static void test_difference_of_what_counts(void) {
    static const struct {
        enum compare_pixels wrong;
        const char *colors; /* of the pixels below */
    } cases[] = {
        {COMPARE_UNMATCHED, "gggg."},
        {COMPARE_COVERAGE, "rbgg."},
        {COMPARE_APART, "rbrg."},
        {COMPARE_DIFFERING, "rbrr."},
    };
    /* a line that lies a column too far to the left, another colour next to it, a level */
    static const uint8_t wanted[] = {0, 200, 100, 90, 60}, got[] = {200, 0, 90, 91, 60};
    struct image a = make(40, 1, IMAGE_BGR), b = make(40, 1, IMAGE_BGR), difference;
    struct error error;
    const int place[] = {1, 2, 10, 11, 20};
    for (int i = 0; i < 5; i++) {
        image_set(&a, place[i], 0, color_grey(wanted[i]));
        image_set(&b, place[i], 0, color_grey(got[i]));
    }
    image_set(&a, 9, 0, color_grey(90)); /* gives both colours of pixel 10 a match */
    image_set(&b, 9, 0, color_grey(100));
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        CHECK(compare_difference(&difference, &a, &b, cases[i].wrong, &error));
        char colors[6] = "";
        for (int k = 0; k < 5; k++) {
            struct color c = image_get(&difference, place[k], 0);
            bool red = c.r == 255 && c.g + c.b == 0, blue = c.b == 255 && c.r + c.g == 0;
            bool green = c.g == 96 && c.r + c.b == 0;
            colors[k] = ".rbg"[red ? 1 : blue ? 2 : green ? 3 : 0];
        }
        CHECK_TEXT(colors, cases[i].colors);
        image_free(&difference);
    }
    struct image small =
        make(1, 3, IMAGE_GREY); /* what it lacks is missing, what is too much is cut */
    CHECK(compare_difference(&difference, &a, &small, COMPARE_UNMATCHED, &error));
    CHECK(difference.width == 40 && difference.height == 1);
    CHECK(image_get(&difference, 20, 0).b == 255);
    image_free(&difference);
    image_free(&small);
    image_free(&a);
    image_free(&b);
}

/* How many white pixels there are in a part of the picture. */
static size_t count_white(const struct image *image, int x, int y, int width, int height) {
    size_t white = 0;
    for (int j = y; j < y + height; j++) {
        for (int i = x; i < x + width; i++) {
            struct color color = image_get(image, i, j);
            white += color.r == 255 && color.g == 255 && color.b == 255;
        }
    }
    return white;
}

/* Panels of 100 pixels are enlarged 4 times; words are above each and below all of them. */
static void test_legend(void) {
    struct image a = make(100, 110, IMAGE_BGR), b = make(90, 120, IMAGE_BGR), picture;
    struct error error;
    image_set(&a, 7, 3, color_rgb(10, 200, 30));
    image_set(&b, 7, 3, color_rgb(10, 200, 30));
    CHECK(legend_picture(&picture, &a, &b, COMPARE_UNMATCHED, &error));
    int height = (int)picture.height, bottom = height - 24 - 4 * 110;
    CHECK(picture.width == 4 * (3 * 100 + 2 * 8) && bottom == 2 * 24);
    for (int i = 0; i < 16; i++) {
        const int x = 4 * 7 + i % 4, y = bottom + 4 * 3 + i / 4;
        for (int panel = 0; panel < 3; panel++) { /* the difference is a quarter as light */
            struct color color = image_get(&picture, x + panel * 4 * 108, y);
            CHECK(color.g == (panel < 2 ? 200 : 50) && color.r == (panel < 2 ? 10 : 2));
        }
    }
    CHECK(image_get(&picture, 4 * 7 - 1, bottom + 4 * 3).g == 0);
    CHECK(image_get(&picture, 4 * 100, bottom).g == 128); /* between two panels */
    for (int i = 0; i < 3; i++) {
        CHECK(count_white(&picture, i * 4 * 108, height - 24, 400, 24) > 100);
    }
    CHECK(count_white(&picture, 0, 0, 4 * 316, bottom) > 1000);
    struct color red = image_get(&picture, 8, bottom - 12);
    CHECK(red.r == 255 && red.g == 0 && red.b == 0);
    image_free(&a);
    image_free(&b);
    image_free(&picture);
}

UNIT_MAIN(TEST(test_counts), TEST(test_levels_and_neighbours), TEST(test_lightness),
          TEST(test_blank_picture_is_all_wrong), TEST(test_formats_with_equal_look),
          TEST(test_limit_and_its_text), TEST(test_difference_of_what_counts), TEST(test_legend))
