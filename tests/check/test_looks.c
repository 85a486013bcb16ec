/*
 * Tests of how known mistakes are recognised: a picture looks like the mistake that drew it, and
 * in doubt like none.
 */
#define _POSIX_C_SOURCE 200809L

#include "base/file.h"
#include "files/png.h"
#include "looks.h"
#include "unit/unit.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { SIZE = 64, PLACES = 128, ROWS = 3, MOST = 8 }; /* three pictures, in rows 2, 3 and 4 */

/* What was kept of a reference of one grey, and of three wrong pictures. */
struct fixture {
    struct image reference, yours;
    struct mistake named[MOST];
    struct mistake_list mistakes;
    struct looks looks;
};

/* Pixel number i of the places. */
static struct place place_of(size_t i) {
    return (struct place){i % SIZE, i / SIZE * 7};
}

/* The second picture is the first except for 40 pixels. */
static struct color color_of(size_t row, size_t i) {
    static const uint8_t levels[] = {0, 50, 90, 150, 200};
    return color_grey(i >= 64 ? 50 : row == 3 && i >= 40 ? levels[2] : levels[row]);
}

static void set_up(struct fixture *f) {
    static const char *const words[] = {"the first", "the second", "the third", "as the third"};
    static const size_t rows[] = {2, 3, 4, 4};
    struct error error;
    memset(f, 0, sizeof *f);
    CHECK(image_create(&f->reference, SIZE, SIZE, IMAGE_BGR, &error));
    CHECK(image_create(&f->yours, SIZE, SIZE, IMAGE_BGR, &error));
    CHECK(image_create(&f->looks.pixels, PLACES, 2 + ROWS, IMAGE_BGR, &error));
    image_clear(&f->reference, color_grey(50));
    for (size_t i = 0; i < PLACES; i++) {
        looks_set_place(&f->looks.pixels, i, place_of(i));
        for (size_t row = 1; row < 2 + ROWS; row++) {
            image_set(&f->looks.pixels, (int)i, (int)row, color_of(row, i));
        }
    }
    f->mistakes = (struct mistake_list){.list = f->named, .count = 4};
    f->looks.mistakes = &f->mistakes;
    f->looks.list = calloc(MOST, sizeof *f->looks.list);
    for (size_t i = 0; i < 4; i++) {
        f->looks.list[i] = (struct look){.row = rows[i], .apart = 1000};
        f->named[i] = (struct mistake){.task = {"5.2"}, .words = words[i]};
    }
    f->named[0].task.text[0] = '\0';
}

static void tear_down(struct fixture *f) {
    image_free(&f->reference);
    image_free(&f->yours);
    looks_free(&f->looks);
}

/* Pixel number i of yours. */
static void put(struct fixture *f, size_t i, struct color color) {
    struct place place = place_of(i);
    image_set(&f->yours, (int)place.x, (int)place.y, color);
}

/* Draw that row, with `other` of its wrong pixels in another colour. */
static void draw(struct fixture *f, size_t row, size_t other) {
    image_clear(&f->yours, color_grey(50));
    for (size_t i = 0; i < PLACES; i++) {
        put(f, i, i < other ? color_grey(255) : color_of(row, i));
    }
}

static size_t find(const struct fixture *f, uint64_t apart) {
    return looks_find(&f->looks, &f->reference, &f->yours, apart).row;
}

static void test_places(void) {
    struct image pixels;
    struct error error;
    CHECK(image_create(&pixels, 3, 1, IMAGE_BGR, &error));
    const struct place places[] = {{0, 0}, {4095, 4095}, {1234, 3021}};
    for (size_t i = 0; i < 3; i++) {
        looks_set_place(&pixels, i, places[i]);
        struct place found = looks_place(&pixels, i);
        CHECK(found.x == places[i].x && found.y == places[i].y);
    }
    image_free(&pixels);
}

static void test_what_is_told(void) {
    static const struct {
        const char *what;
        size_t row, other;
        uint64_t apart;
        size_t wanted;
    } cases[] = {
        {"itself", 2, 0, 1000, 2},          {"its neighbour", 3, 0, 1000, 3},
        {"the last", 4, 0, 1000, 4},        {"nearly", 4, 2, 1000, 4},
        {"not near enough", 4, 3, 1000, 0}, {"a quarter more is apart", 4, 1, 1250, 4},
        {"more than that", 4, 1, 1251, 0},  {"a quarter less", 4, 1, 750, 4},
        {"less than that", 4, 1, 749, 0},   {"the reference", 1, 0, 1000, 0},
    };
    struct fixture f;
    set_up(&f);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        draw(&f, cases[i].row, cases[i].other);
        CHECK_ROW(find(&f, cases[i].apart) == cases[i].wanted, cases[i].what);
    }
    tear_down(&f);
}

/* Between two pictures, neither is named. */
static void test_doubt(void) {
    struct fixture f;
    set_up(&f);
    draw(&f, 2, 0);
    for (size_t i = 0; i < 2; i++) { /* two of the forty pixels in which the second differs */
        put(&f, i, color_of(3, i));
    }
    CHECK(find(&f, 1000) == 2);
    for (size_t i = 2; i < 40; i++) { /* now the two differ in two only */
        image_set(&f.looks.pixels, (int)i, 3, color_of(2, i));
    }
    CHECK(find(&f, 1000) == 3);
    f.looks.list[1].row = 0; /* one without a name is still nearer */
    CHECK(find(&f, 1000) == 0);
    f.looks.list[1].row = 3;
    put(&f, 1, color_of(2, 1));
    CHECK(find(&f, 1000) == 0);
    tear_down(&f);
}

/* What is near everywhere is held against mistakes that are near, and must have their colours. */
static void test_near(void) {
    struct fixture f;
    set_up(&f);
    for (size_t i = 0; i < PLACES; i++) { /* the first is one too dark where it was wrong */
        image_set(&f.looks.pixels, (int)i, 2, color_grey(i < 64 ? 49 : 50));
    }
    f.looks.list[0].apart = 0;
    CHECK(find(&f, 0) == 0); /* black */
    image_clear(&f.yours, color_grey(49));
    CHECK(find(&f, 0) == 0); /* too dark elsewhere, too */
    for (size_t i = 0; i < PLACES; i++) {
        put(&f, i, color_grey(i < 64 ? 49 : 50));
    }
    CHECK(find(&f, 0) == 2);
    CHECK(find(&f, 1000) == 0); /* something is apart that is not seen here */
    f.looks.list[0].apart = 1000;
    CHECK(find(&f, 0) == 0);
    tear_down(&f);
}

static void test_small_pictures(void) {
    struct fixture f;
    set_up(&f);
    for (size_t i = 5; i < PLACES; i++) { /* five pixels are wrong at all */
        for (int row = 2; row < 2 + ROWS; row++) {
            image_set(&f.looks.pixels, (int)i, row, color_grey(50));
        }
    }
    image_clear(&f.yours, color_grey(50));
    for (size_t i = 0; i < 5; i++) {
        put(&f, i, color_of(4, i));
    }
    CHECK(find(&f, 1000) == 4);
    CHECK(find(&f, 1001) == 0);
    tear_down(&f);
}

/* Pictures that lack nearly everything are not known by what they lack. */
static void test_black(void) {
    struct fixture f;
    set_up(&f);
    draw(&f, 4, 0);
    for (size_t i = 0; i < 64; i++) {
        image_set(&f.looks.pixels, (int)i, 4, color_grey(i < 2 ? 200 : 0));
        put(&f, i, color_grey(0));
    }
    CHECK(find(&f, 1000) == 0);
    image_clear(&f.yours, color_grey(0));
    for (int i = 0; i < PLACES; i++) { /* a mistake that draws all nearly black */
        image_set(&f.looks.pixels, i, 4, color_grey(1));
    }
    CHECK(find(&f, 1000) == 0);
    tear_down(&f);
}

/* Another mistake draws the last picture. */
static void add(struct fixture *f) {
    f->named[f->mistakes.count] = f->named[3];
    f->looks.list[f->mistakes.count++] = f->looks.list[3];
}

/* At most four mistakes may draw the same. */
static void test_names(void) {
    struct fixture f;
    set_up(&f);
    draw(&f, 4, 0);
    add(&f);
    add(&f);
    CHECK(find(&f, 1000) == 4);
    CHECK(looks_mistakes(&f.looks, 4).count == 4 && looks_mistakes(&f.looks, 0).count == 0);
    CHECK(looks_mistakes(&f.looks, 3).list[0] == &f.named[1]);
    add(&f);
    CHECK(find(&f, 1000) == 0);
    for (size_t i = 0; i < f.mistakes.count; i++) {
        f.looks.list[i].row = 0;
    }
    CHECK(find(&f, 1000) == 0);
    tear_down(&f);
}

/* Of eight pixels that are wrong one may be so in another way. */
static void test_explained(void) {
    static const struct {
        size_t row, other;
        bool explains[ROWS];
    } cases[] = {
        {2, 0, {true, false, false}}, /* of 64 wrong pixels 24 are not the second's */
        {3, 0, {false, true, false}},
        {4, 8, {false, false, true}},
        {4, 9, {false, false, false}},
    };
    struct fixture f;
    set_up(&f);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        draw(&f, cases[i].row, cases[i].other);
        looks_compare(&f.looks, &f.yours);
        for (size_t row = 0; row < ROWS; row++) {
            CHECK(f.looks.explains[LOOKS_FIRST_ROW + row] == cases[i].explains[row]);
        }
        free(f.looks.explains);
    }
    f.looks.explains = NULL;
    free(f.looks.list); /* nothing is known */
    f.looks.list = NULL;
    looks_compare(&f.looks, &f.yours);
    CHECK(f.looks.explains == NULL);
    tear_down(&f);
}

/* Kept of another reference, or of a larger one. */
static void test_out_of_date(void) {
    struct fixture f;
    set_up(&f);
    draw(&f, 4, 0);
    image_set(&f.reference, 3, 0, color_grey(70));
    CHECK(find(&f, 1000) == 0);
    image_set(&f.reference, 3, 0, color_grey(50));
    CHECK(find(&f, 1000) == 4);
    looks_set_place(&f.looks.pixels, 100, (struct place){SIZE, 0}); /* where nothing is */
    image_set(&f.looks.pixels, 100, 1, color_grey(0));
    CHECK(find(&f, 1000) == 0);
    tear_down(&f);
}

/* What each of four mistakes makes of the scene `b`, as its signs say. */
static void test_signs(void) {
    static const struct {
        const char *signs[4];
        size_t rows[4];
        bool known;
    } cases[] = {
        {{"b:2:1000", "-", "bb:2:1000;b:3:99", "ab:3:7;b:rb-:a=5"}, {2, 0, 3, 0}, true},
        {{"b:0:7", "b:4:0", "b:2", "b:x:1"}, {0, 4, 0, 0}, true},
        {{"b:5:1000", "-", "-", "-"}, {0}, false}, /* no such row */
        {{"b:1:1000", "-", "-", "-"}, {0}, false}, /* the reference's */
    };
    char directory[] = "/tmp/test_looks.XXXXXX", path[64], command[80];
    struct fixture f;
    struct error error;
    struct looks looks;
    CHECK(mkdtemp(directory) != NULL);
    set_up(&f);
    snprintf(path, sizeof path, "%s/a/looks", directory);
    CHECK(directory_create(path, &error));
    snprintf(path, sizeof path, "%s/a/looks/b.png", directory);
    CHECK(png_write(&f.looks.pixels, path, &error));
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        for (size_t k = 0; k < 4; k++) {
            f.named[k].signs = cases[i].signs[k];
        }
        looks_read(&looks, &f.mistakes, directory, "a", "b");
        CHECK((looks.list != NULL) == cases[i].known);
        for (size_t k = 0; k < 4 && looks.list != NULL; k++) {
            CHECK_ROW(looks.list[k].row == cases[i].rows[k], cases[i].signs[k]);
        }
        CHECK(i > 0 || (looks.list[0].apart == 1000 && looks.list[2].apart == 99));
        CHECK(i != 1 || looks.list[0].apart == 7);
        looks_free(&looks);
    }
    f.named[0] = (struct mistake){.signs = "b:3:1000", .words = MISTAKE_STARTER};
    looks_read(&looks, &f.mistakes, directory, "a", "b");
    CHECK(looks.starter == 3 && looks.list[0].row == 0); /* no mistake, but known */
    looks_free(&looks);
    looks_read(&looks, &f.mistakes, directory, "a", "c");
    CHECK(looks.list == NULL && looks.pixels.pixels == NULL);
    snprintf(command, sizeof command, "rm -rf '%s'", directory);
    CHECK(system(command) == 0);
    tear_down(&f);
}

UNIT_MAIN(TEST(test_places), TEST(test_what_is_told), TEST(test_doubt), TEST(test_near),
          TEST(test_small_pictures), TEST(test_black), TEST(test_names), TEST(test_explained),
          TEST(test_out_of_date), TEST(test_signs))
