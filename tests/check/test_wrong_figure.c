/* Tests of the small pictures of mistakes: which part they show, how large, and what stays seen. */
#include "unit/unit.h"
#include "wrong_figure.h"

#include <string.h>

/* A reference and a wrong picture, both black so far, and what is made of them. */
struct fixture {
    struct image reference, wrong, figure;
};

static void set_up(struct fixture *f, size_t width, size_t height) {
    struct error error;
    memset(f, 0, sizeof *f);
    CHECK(image_create(&f->reference, width, height, IMAGE_BGR, &error));
    CHECK(image_create(&f->wrong, width, height, IMAGE_BGR, &error));
}

static void tear_down(struct fixture *f) {
    image_free(&f->reference);
    image_free(&f->wrong);
    image_free(&f->figure);
}

static const struct figure_area found_area = {.width = 0};

/* Make the figure of that part; `message` is what must be said instead, or NULL. */
static void make(struct fixture *f, struct figure_area area, const char *message) {
    struct error error;
    error.message[0] = 0;
    image_free(&f->figure);
    bool done = wrong_figure(&f->figure, &f->reference, &f->wrong, area, &error);
    CHECK(done == (message == NULL) && done == (f->figure.pixels != NULL));
    CHECK_TEXT(error.message, message != NULL ? message : "");
}

/* Is the figure two panels of that size? */
static void check_size(const struct fixture *f, size_t width, size_t height) {
    CHECK(f->figure.width == 2 * width + WRONG_FIGURE_GAP && f->figure.height == height);
}

/* The levels of red in both panels, at the same place. */
static void check_red(const struct fixture *f, int x, int y, int reference, int wrong) {
    int right = (int)(f->figure.width + WRONG_FIGURE_GAP) / 2;
    CHECK(image_get(&f->figure, x, y).r == reference);
    CHECK(image_get(&f->figure, right + x, y).r == wrong);
    CHECK(image_get(&f->figure, right - 1, y).b == 255);
}

static void test_areas(void) {
    static const struct {
        const char *text;
        bool is_read;
        struct figure_area area;
    } cases[] = {
        {"auto", true, {0, 0, 0, 0}},
        {"60x40+10+20", true, {10, 20, 60, 40}},
        {"1x1+0+0", true, {0, 0, 1, 1}},
        {"0x40+10+20", false, {0, 0, 0, 0}},
        {"60x0+1+2", false, {0, 0, 0, 0}},
        {"60x40", false, {0, 0, 0, 0}},
        {"", false, {0, 0, 0, 0}},
        {"60x40+10+20x", false, {0, 0, 0, 0}},
        {"60x40+-1+2", false, {0, 0, 0, 0}},
        {"60 x40+1+2", false, {0, 0, 0, 0}},
        {"123456x4+1+2", false, {0, 0, 0, 0}},
        {"automatic", false, {0, 0, 0, 0}},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct figure_area area;
        struct error error;
        bool is_read = figure_area_read(&area, cases[i].text, &error);
        CHECK_ROW(is_read == cases[i].is_read, cases[i].text);
        CHECK_ROW(!is_read ||
                      (area.x == cases[i].area.x && area.y == cases[i].area.y &&
                       area.width == cases[i].area.width && area.height == cases[i].area.height),
                  cases[i].text);
    }
}

/* The part around what is apart, somewhat larger; the whole picture where that is most of it. */
static void test_found_part(void) {
    struct fixture f;
    set_up(&f, 100, 80);
    image_set(&f.wrong, 50, 30, color_rgb(255, 0, 0));
    make(&f, found_area, NULL);
    CHECK(f.figure.format == IMAGE_BGR);
    check_size(&f, 200, 200); /* 40 pixels along each side, 5 times as large */
    check_red(&f, 19 * 5, 19 * 5, 0, 255);
    check_red(&f, 19 * 5 + 4, 19 * 5 + 4, 0, 255);
    check_red(&f, 18 * 5 + 4, 19 * 5, 0, 0);
    check_red(&f, 20 * 5, 19 * 5, 0, 0);
    image_set(&f.wrong, 50, 30, color_grey(0));
    image_set(&f.wrong, 99, 0,
              color_rgb(255, 0, 0)); /* in a corner: the part lies in the picture */
    make(&f, found_area, NULL);
    check_size(&f, 200, 200);
    check_red(&f, 199, 0, 0, 255);
    image_set(&f.wrong, 70, 0, color_rgb(77, 0, 0)); /* 30 apart: 7 more on each side */
    make(&f, found_area, NULL);
    check_size(&f, 176, 176);
    check_red(&f, 175, 0, 0, 255);
    check_red(&f, 176 - 30 * 4, 3, 0, 77);
    image_set(&f.wrong, 70, 0, color_grey(0));
    image_set(&f.wrong, 10, 60, color_rgb(255, 0, 0));
    make(&f, found_area, NULL);
    check_size(&f, 200, 160);
    image_set(&f.reference, 10, 60, color_rgb(252, 0, 0)); /* near, and not apart */
    make(&f, found_area, NULL);
    check_size(&f, 200, 200);
    tear_down(&f);
}

static void test_given_part(void) {
    struct fixture f;
    set_up(&f, 100, 80);
    image_set(&f.wrong, 50, 30, color_rgb(255, 0, 0));
    make(&f, (struct figure_area){50, 20, 30, 20}, NULL);
    check_size(&f, 180, 120);
    check_red(&f, 0, 60, 0, 255);
    check_red(&f, 5, 65, 0, 255);
    check_red(&f, 6, 60, 0, 0);
    make(&f, (struct figure_area){0, 0, 100, 80}, NULL);
    make(&f, (struct figure_area){1, 0, 100, 80}, "the part is not in a picture of 100x80 pixels");
    make(&f, (struct figure_area){0, 1, 1, 80}, "the part is not in a picture of 100x80 pixels");
    make(&f, (struct figure_area){100, 1, 1, 1}, "the part is not in a picture of 100x80 pixels");
    make(&f, (struct figure_area){51, 20, 30, 20}, "nothing wrong can be seen");
    tear_down(&f);
}

/* Large pictures: a mean of plain parts, but nothing that is thin is lost. */
static void test_smaller(void) {
    struct fixture f;
    set_up(&f, 800, 400);
    image_clear(&f.reference, color_grey(100));
    image_clear(&f.wrong, color_grey(100));
    for (int x = 0; x < 800; x++) {
        for (int y = 0; y < 200; y++) {
            image_set(&f.reference, x, y, color_grey((uint8_t)(x % 2 * 100 + 50)));
            image_set(&f.wrong, x, y, color_grey((uint8_t)(x % 2 * 100 + 50)));
        }
        for (int y = 100; y < 200; y++) { /* a line on black */
            image_set(&f.reference, x, y, color_grey(y == 133 ? 230 : 0));
            image_set(&f.wrong, x, y, color_grey(y == 133 ? 230 : 0));
        }
        image_set(&f.wrong, x, 5, color_grey((uint8_t)(x % 2 * 100 + 90)));
        for (int y = 300; y < 310; y++) { /* darker, and not plain */
            image_set(&f.wrong, x, y, color_grey((uint8_t)(x % 2 * 20 + 40)));
        }
    }
    image_set(&f.wrong, 12, 353, color_grey(0));      /* a hole */
    image_set(&f.reference, 403, 353, color_grey(0)); /* one that should be there */
    make(&f, found_area, NULL);
    check_size(&f, 160, 80);
    CHECK(f.figure.format == IMAGE_GREY);
    check_red(&f, 2, 2, 98, 98); /* not plain: the root of (3 50^2 + 2 150^2) / 5 is 102 */
    check_red(&f, 2, 26, 98, 98);
    check_red(&f, 2, 25, 0, 0);
    check_red(&f, 2, 60, 98, 49);
    check_red(&f, 2, 70, 98, 0);
    check_red(&f, 3, 70, 98, 98);
    check_red(&f, 80, 70, 0, 98);
    tear_down(&f);
}

/* What shows nothing is refused. */
static void test_nothing_to_see(void) {
    struct fixture f;
    set_up(&f, 100, 80);
    make(&f, found_area, "nothing wrong can be seen");
    image_clear(&f.wrong, color_grey(4));
    make(&f, found_area, "nothing wrong can be seen");
    image_clear(&f.reference, color_grey(100));
    make(&f, found_area, "all of it is black");
    image_clear(&f.wrong, color_grey(5));
    make(&f, found_area, NULL);
    image_free(&f.wrong);
    struct error error;
    CHECK(image_create(&f.wrong, 80, 100, IMAGE_BGR, &error));
    make(&f, found_area, "80x100 pixels, and the reference has 100x80");
    image_free(&f.wrong);
    CHECK(image_create(&f.wrong, 80, 80, IMAGE_BGR, &error));
    make(&f, found_area, "80x80 pixels, and the reference has 100x80");
    image_free(&f.wrong);
    CHECK(image_create(&f.wrong, 100, 100, IMAGE_BGR, &error));
    make(&f, found_area, "100x100 pixels, and the reference has 100x80");
    tear_down(&f);
}

UNIT_MAIN(TEST(test_areas), TEST(test_found_part), TEST(test_given_part), TEST(test_smaller),
          TEST(test_nothing_to_see))
