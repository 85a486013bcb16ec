/*
 * Tests of what the known mistakes are told by: a picture looks like the mistake that drew it, and
 * in doubt like none.
 */
#define _POSIX_C_SOURCE 200809L

#include "base/file.h"
#include "files/image_file.h"
#include "files/png.h"
#include "looks.h"
#include "unit/unit.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { SIZE = 64, PLACES = 128, ROWS = 3 }; /* three pictures, in rows 2, 3 and 4 */

/* What was kept of a reference of one grey, and of three wrong pictures. */
struct fixture {
    struct image reference, yours;
    struct looks looks;
};

/* Pixel number i of the places. */
static struct place place_of(size_t i) {
    return (struct place){i % SIZE, i / SIZE * 7};
}

/* The second picture is the first but for 40 pixels. */
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
    f->looks.list = calloc(8, sizeof *f->looks.list);
    for (size_t i = 0; i < 4; i++) {
        struct look *look = &f->looks.list[f->looks.count++];
        look->row = rows[i];
        look->apart = 1000;
        strcpy(look->task.text, i == 0 ? "" : "5.2");
        strcpy(look->words, words[i]);
    }
}

static void tear_down(struct fixture *f) {
    image_free(&f->reference);
    image_free(&f->yours);
    looks_free(&f->looks);
}

/* Draw that row, with `other` of its wrong pixels in another colour. */
static void draw(struct fixture *f, size_t row, size_t other) {
    image_clear(&f->yours, color_grey(50));
    for (size_t i = 0; i < PLACES; i++) {
        struct place place = place_of(i);
        image_set(&f->yours, (int)place.x, (int)place.y,
                  i < other ? color_grey(255) : color_of(row, i));
    }
}

static size_t find(const struct fixture *f, uint64_t apart, size_t left_out) {
    return looks_find(&f->looks, &f->reference, &f->yours, apart, left_out).row;
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
        size_t left_out, wanted;
    } cases[] = {
        {"itself", 2, 0, 1000, 0, 2},          {"its neighbour", 3, 0, 1000, 0, 3},
        {"the last", 4, 0, 1000, 0, 4},        {"nearly", 4, 2, 1000, 0, 4},
        {"not near enough", 4, 3, 1000, 0, 0}, {"a quarter more is apart", 4, 1, 1250, 0, 4},
        {"more than that", 4, 1, 1251, 0, 0},  {"a quarter less", 4, 1, 750, 0, 4},
        {"less than that", 4, 1, 749, 0, 0},   {"the reference", 1, 0, 1000, 0, 0},
        {"unknown", 4, 0, 1000, 4, 0},
    };
    struct fixture f;
    set_up(&f);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        draw(&f, cases[i].row, cases[i].other);
        CHECK_ROW(find(&f, cases[i].apart, cases[i].left_out) == cases[i].wanted, cases[i].what);
    }
    tear_down(&f);
}

/* Between two pictures, neither is told. */
static void test_doubt(void) {
    struct fixture f;
    set_up(&f);
    draw(&f, 2, 0);
    for (int i = 0; i < 2; i++) { /* two of the forty pixels in which the second differs */
        struct place place = place_of((size_t)i);
        image_set(&f.yours, (int)place.x, (int)place.y, color_of(3, (size_t)i));
    }
    CHECK(find(&f, 1000, 0) == 2);
    for (size_t i = 2; i < 40; i++) { /* now the two differ in two only */
        image_set(&f.looks.pixels, (int)i, 3, color_of(2, i));
    }
    CHECK(find(&f, 1000, 0) == 3);
    f.looks.list[1].row = 0; /* one of which nothing is told is still nearer */
    CHECK(find(&f, 1000, 0) == 0);
    f.looks.list[1].row = 3;
    struct place place = place_of(1);
    image_set(&f.yours, (int)place.x, (int)place.y, color_of(2, 1));
    CHECK(find(&f, 1000, 0) == 0);
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
    CHECK(find(&f, 0, 0) == 0); /* black */
    image_clear(&f.yours, color_grey(49));
    CHECK(find(&f, 0, 0) == 0); /* too dark elsewhere, too */
    for (size_t i = 0; i < PLACES; i++) {
        struct place place = place_of(i);
        image_set(&f.yours, (int)place.x, (int)place.y, color_grey(i < 64 ? 49 : 50));
    }
    CHECK(find(&f, 0, 0) == 2);
    CHECK(find(&f, 0, 2) == 0);    /* no other one is near */
    CHECK(find(&f, 1000, 0) == 0); /* something is apart that is not seen here */
    f.looks.list[0].apart = 1000;
    CHECK(find(&f, 0, 0) == 0);
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
        struct place place = place_of(i);
        image_set(&f.yours, (int)place.x, (int)place.y, color_of(4, i));
    }
    CHECK(find(&f, 1000, 0) == 4);
    CHECK(find(&f, 1001, 0) == 0);
    tear_down(&f);
}

/* Pictures that lack nearly everything are not told by what they lack. */
static void test_black(void) {
    struct fixture f;
    set_up(&f);
    draw(&f, 4, 0);
    for (size_t i = 0; i < 64; i++) {
        struct place place = place_of(i);
        image_set(&f.looks.pixels, (int)i, 4, color_grey(i < 2 ? 200 : 0));
        image_set(&f.yours, (int)place.x, (int)place.y, color_grey(0));
    }
    CHECK(find(&f, 1000, 0) == 0);
    image_clear(&f.yours, color_grey(0));
    for (int i = 0; i < PLACES; i++) { /* a mistake that draws all nearly black */
        image_set(&f.looks.pixels, i, 4, color_grey(1));
    }
    CHECK(find(&f, 1000, 0) == 0);
    tear_down(&f);
}

/* At most four mistakes may draw the same. */
static void test_names(void) {
    struct fixture f;
    set_up(&f);
    draw(&f, 4, 0);
    f.looks.list[f.looks.count++] = f.looks.list[3];
    f.looks.list[f.looks.count++] = f.looks.list[3];
    CHECK(find(&f, 1000, 0) == 4);
    f.looks.list[f.looks.count++] = f.looks.list[3];
    CHECK(find(&f, 1000, 0) == 0);
    for (size_t i = 0; i < f.looks.count; i++) {
        f.looks.list[i].row = 0;
    }
    CHECK(find(&f, 1000, 0) == 0);
    tear_down(&f);
}

/* The context is the name of a task that is right, or the words of a mistake that cannot be; behind
 * a question mark those of one that is doubtful. */
static enum looks_doubt doubt_that(const void *context, const struct look *look) {
    const char *text = context;
    return text[0] == '?' && strcmp(text + 1, look->words) == 0 ? LOOKS_DOUBTFUL
           : strcmp(context, look->words) == 0                  ? LOOKS_IMPOSSIBLE
           : strcmp(context, look->task.text) == 0              ? LOOKS_UNLIKELY
                                                                : LOOKS_LIKELY;
}

/* What is told of a row with that doubt: `tasks` are those at fault. */
static void check_told(const struct fixture *f, size_t row, const char *right, const char *words,
                       const char *tasks) {
    struct item_result item = {.scene = "scene"};
    char told[LOOKS_NAME_LIMIT * TASK_NAME_LIMIT] = "";
    looks_tell(&item, &f->looks, row, right != NULL ? doubt_that : NULL, right);
    for (size_t i = 0; i < item.looks_task_count; i++) {
        strcat(strcat(told, i > 0 ? " " : ""), item.looks_tasks[i].text);
    }
    CHECK_TEXT(item.looks.text, words);
    CHECK_TEXT(told, tasks);
    CHECK_TEXT(result_likeness(&item),
               right != NULL && right[0] == '?' && row == 3 ? "may be" : "looks like");
}

static void test_told(void) {
    struct fixture f;
    set_up(&f);
    check_told(&f, 0, NULL, "", "");
    check_told(&f, 2, NULL, "\"the first\"", "");
    check_told(&f, 3, NULL, "\"the second\"", "5.2");
    check_told(&f, 4, NULL, "\"the third\" or \"as the third\"", "5.2");
    strcpy(f.looks.list[3].task.text, "5.3");
    check_told(&f, 4, NULL, "\"the third\" or \"as the third\"", "5.2 5.3");
    check_told(&f, 4, "5.2", "\"as the third\"", "5.3");
    check_told(&f, 4, "5.3", "\"the third\"", "5.2");
    check_told(&f, 3, "5.2", "\"the second\"", "5.2"); /* there is no other */
    check_told(&f, 4, "the third", "\"as the third\"", "5.3");
    check_told(&f, 3, "the second", "", "");
    check_told(&f, 3, "?the second", "\"the second\"", "5.2");
    check_told(&f, 4, "?the third", "\"as the third\"", "5.3"); /* which is not doubtful */
    f.looks.list[3].row = 0;
    check_told(&f, 0, NULL, "", "");
    tear_down(&f);
}

/* The figures of all mistakes that are told, each once; 0 stands for none. */
static void test_figures(void) {
    static const struct {
        unsigned figures[2];
        const char *right;
        size_t count;
        unsigned first;
    } cases[] = {
        {{4, 7}, NULL, 2, 4},        {{4, 4}, NULL, 1, 4}, {{0, 7}, NULL, 1, 7},
        {{0, 0}, NULL, 0, 0},        {{4, 0}, NULL, 1, 4}, {{4, 7}, "the third", 1, 7},
        {{4, 0}, "the third", 0, 0},
    };
    struct fixture f;
    set_up(&f);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct item_result item = {.scene = "scene"};
        f.looks.list[2].figure = cases[i].figures[0];
        f.looks.list[3].figure = cases[i].figures[1];
        looks_tell(&item, &f.looks, 4, cases[i].right != NULL ? doubt_that : NULL, cases[i].right);
        CHECK(item.looks_figure_count == cases[i].count);
        CHECK(item.looks_figures[0] == cases[i].first);
    }
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
    f.looks.count = 0; /* nothing is known */
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
    CHECK(find(&f, 1000, 0) == 0);
    image_set(&f.reference, 3, 0, color_grey(50));
    CHECK(find(&f, 1000, 0) == 4);
    looks_set_place(&f.looks.pixels, 100, (struct place){SIZE, 0}); /* where nothing is */
    image_set(&f.looks.pixels, 100, 1, color_grey(0));
    CHECK(find(&f, 1000, 0) == 0);
    tear_down(&f);
}

static void test_files(void) {
    static const struct {
        const char *list;
        size_t count, starter;
    } cases[] = {
        {"# words\n2 1000 - 0 the first\n0 0 5.2 0 nothing\n4 99 10b.12 14 a \"b\"\n", 3, 0},
        {"2 1000 - 0 the first\n3 1000 - 0 (the starter)\n", 1, 3},
        {"2 1000 - 0 the first\n0 0 - 0 (the starter)\n", 1, 0},
        {"2 1000 - 0 the first\n5 1000 - 0 (the starter)\n", 0, 0},
        {"", 0, 0},
        {"5 1000 - 0 no such row\n", 0, 0},
        {"1 1000 - 0 the reference\n", 0, 0},
        {"2 1000\n", 0, 0},
        {"2 1000 -\n", 0, 0},
        {"2 1000 - 4\n", 0, 0},
        {"2 1000 - the first\n", 0, 0},
        {"-3 1000 - 0 a\n", 0, 0},
        {"x 1000 - 0 a\n", 0, 0},
    };
    char directory[] = "/tmp/test_looks.XXXXXX", path[64], command[80];
    struct fixture f;
    struct looks looks;
    struct error error;
    CHECK(mkdtemp(directory) != NULL);
    set_up(&f);
    snprintf(path, sizeof path, "%s/a", directory);
    CHECK(directory_create(path, &error));
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        snprintf(path, sizeof path, "%s/a/b.png", directory);
        CHECK(png_write(&f.looks.pixels, path, &error));
        snprintf(path, sizeof path, "%s/a/b.txt", directory);
        CHECK(file_write(path, cases[i].list, strlen(cases[i].list), &error));
        looks_read(&looks, directory, "a", "b");
        CHECK_ROW(looks.count == cases[i].count && looks.starter == cases[i].starter,
                  cases[i].list);
        CHECK(i > 0 || (strcmp(looks.list[0].task.text, "") == 0 &&
                        strcmp(looks.list[2].task.text, "10b.12") == 0 &&
                        looks.list[0].figure == 0 && looks.list[2].figure == 14));
        looks_free(&looks);
    }
    looks_read(&looks, directory, "a", "c");
    CHECK(looks.count == 0 && looks.pixels.pixels == NULL);
    snprintf(command, sizeof command, "rm -rf '%s'", directory);
    CHECK(system(command) == 0);
    tear_down(&f);
}

/* A pixel that differs is seen in the small picture, which is found again among others. */
static void test_shrinking(void) {
    enum { WIDTH = 400, HEIGHT = 200, SMALL = LOOKS_SMALL_SIDE };
    char path[] = "/tmp/test_looks.XXXXXX";
    struct image reference, picture, small, sheet, found;
    struct error error;
    CHECK(close(mkstemp(path)) == 0);
    CHECK(image_create(&reference, WIDTH, HEIGHT, IMAGE_BGR, &error));
    CHECK(image_create(&picture, WIDTH, HEIGHT, IMAGE_BGRA, &error));
    image_clear(&reference, color_grey(255));
    image_clear(&picture, color_grey(255));
    image_set(&picture, 77, 33, color_rgb(100, 0, 0));
    CHECK(looks_shrink(&small, &picture, &reference, &error));
    CHECK(small.width == SMALL && small.height == SMALL / 2);
    for (int y = 0; y < SMALL / 2; y++) {
        for (int x = 0; x < SMALL; x++) {
            bool is_hole = x == 77 * SMALL / WIDTH && y == 33 * SMALL / WIDTH;
            struct color color = image_get(&small, x, y);
            CHECK(color.r == (is_hole ? 102 : 255) && color.g == (is_hole ? 0 : 255));
        }
    }
    CHECK(image_create(&sheet, (size_t)SMALL * 2, SMALL / 2, IMAGE_BGR, &error));
    image_set(&sheet, SMALL + 3, 5, color_rgb(1, 2, 3));
    CHECK(png_write(&sheet, path, &error));
    CHECK(looks_small(&found, path, LOOKS_FIRST_ROW + 1, &reference, &error));
    CHECK(found.width == SMALL && image_get(&found, 3, 5).b == 3);
    image_free(&found);
    CHECK(!looks_small(&found, path, LOOKS_FIRST_ROW + 2, &reference, &error));
    CHECK(!looks_small(&found, path, LOOKS_FIRST_ROW - 1, &reference, &error));
    CHECK(!looks_small(&found, path, LOOKS_FIRST_ROW, &sheet, &error) && found.width == 0);
    unlink(path);
    CHECK(!looks_small(&found, path, LOOKS_FIRST_ROW, &reference, &error) && found.width == 0);
    image_free(&reference);
    image_free(&picture);
    image_free(&small);
    image_free(&sheet);
}

UNIT_MAIN(TEST(test_places), TEST(test_what_is_told), TEST(test_doubt), TEST(test_near),
          TEST(test_small_pictures), TEST(test_black), TEST(test_shrinking), TEST(test_names),
          TEST(test_told), TEST(test_figures), TEST(test_explained), TEST(test_out_of_date),
          TEST(test_files))
