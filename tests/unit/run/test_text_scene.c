/* Text scenes: what is read, and the message for everything that is refused. */
#define _XOPEN_SOURCE 700 /* POSIX.1-2008 with mkdtemp() */

#include "run/text_scene.h"
#include "unit/place.h"

static bool decode(struct text_scene *scene, const char *text, enum text_scene_kind kind,
                   struct error *error) {
    return text_scene_decode(scene, text, strlen(text), kind, error);
}

static bool same_color(struct color color, unsigned r, unsigned g, unsigned b) {
    return color.r == r && color.g == g && color.b == b && color.a == 255;
}

static void test_lines(void) {
    static const char text[] = "\xEF\xBB\xBF# two lines\r\n\r\nsize 100 50 # wide\r\n"
                               "line 13 20 80 40 255 0 7\r"
                               "\tline -1000000 +1000000 0 0  1 2 3  4 5 6";
    struct text_scene scene;
    struct error error;
    if (!CHECK(decode(&scene, text, TEXT_SCENE_LINES, &error))) {
        return;
    }
    CHECK(scene.width == 100 && scene.height == 50 && scene.shape_count == 2);
    const struct text_scene_shape *line = scene.shapes;
    CHECK(line->x[0] == 13 && line->y[0] == 20 && line->x[1] == 80 && line->y[1] == 40);
    CHECK(same_color(line->color[0], 255, 0, 7) && same_color(line->color[1], 255, 0, 7));
    line++;
    CHECK(line->x[0] == -1e6 && line->y[0] == 1e6 && line->x[1] == 0 && line->y[1] == 0);
    CHECK(same_color(line->color[0], 1, 2, 3) && same_color(line->color[1], 4, 5, 6));
    text_scene_free(&scene);
    CHECK(scene.shapes == NULL && scene.shape_count == 0 && scene.width == 0);
    text_scene_free(&scene);
}

static void test_triangles(void) {
    static const char text[] = "triangle 0.5 .25 -1e2 5. 1000000 -1000000 9 8 7\n"
                               "triangle 1 2 3 4 5 6 10 20 30 40 50 60 70 80 90\n";
    struct text_scene scene;
    struct error error;
    if (!CHECK(decode(&scene, text, TEXT_SCENE_TRIANGLES, &error))) {
        return;
    }
    CHECK(scene.width == 0 && scene.height == 0 && scene.shape_count == 2);
    const struct text_scene_shape *t = scene.shapes;
    CHECK(t->x[0] == 0.5 && t->y[0] == 0.25 && t->x[1] == -100 && t->y[1] == 5);
    CHECK(t->x[2] == 1e6 && t->y[2] == -1e6);
    CHECK(same_color(t->color[0], 9, 8, 7) && same_color(t->color[2], 9, 8, 7));
    t++;
    CHECK(t->x[0] == 1 && t->y[0] == 2 && t->x[1] == 3 && t->y[1] == 4 && t->x[2] == 5 &&
          t->y[2] == 6);
    CHECK(same_color(t->color[0], 10, 20, 30) && same_color(t->color[1], 40, 50, 60) &&
          same_color(t->color[2], 70, 80, 90));
    text_scene_free(&scene);
}

static void test_empty(void) {
    struct text_scene scene;
    struct error error;
    CHECK(text_scene_decode(&scene, NULL, 0, TEXT_SCENE_LINES, &error));
    CHECK(scene.shape_count == 0 && scene.width == 0);
    CHECK(decode(&scene, "# nothing\n", TEXT_SCENE_TRIANGLES, &error) && scene.shape_count == 0);
    CHECK(decode(&scene, "size 1 16384\n", TEXT_SCENE_LINES, &error));
    CHECK(scene.width == 1 && scene.height == 16384);
}

static void test_messages(void) {
    static const struct {
        enum text_scene_kind kind;
        const char *text, *message;
    } rows[] = {
        {TEXT_SCENE_LINES, "\n# x\nline 1 2 3 4 5\n", "3: 'line' takes 7 or 10 numbers, not 5"},
        {TEXT_SCENE_LINES, "line 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0",
         "1: 'line' takes 7 or 10 numbers, not 20"},
        {TEXT_SCENE_TRIANGLES, "triangle 1 2 3 4 5 6 7 8 9 0",
         "1: 'triangle' takes 9 or 15 numbers, not 10"},
        {TEXT_SCENE_LINES, "triangle 1 2 3 4 5 6 7 8 9",
         "1: 'triangle' is not known: 'size' or 'line' is allowed"},
        {TEXT_SCENE_TRIANGLES, "size 1 1\rline 1 2 3 4 5 6 7",
         "2: 'line' is not known: 'size' or 'triangle' is allowed"},
        {TEXT_SCENE_LINES, "line 1.5 2 3 4 5 6 7", "1: coordinate '1.5' is not a whole number"},
        {TEXT_SCENE_LINES, "line 1 2 nan 4 5 6 7", "1: coordinate 'nan' is not a whole number"},
        {TEXT_SCENE_LINES, "line 1 2 3 1000001 5 6 7",
         "1: coordinate 1000001 lies outside -1000000..1000000"},
        {TEXT_SCENE_LINES, "line -1000001 2 3 4 5 6 7",
         "1: coordinate -1000001 lies outside -1000000..1000000"},
        {TEXT_SCENE_LINES, "line 99999999999999999999999 2 3 4 5 6 7",
         "1: coordinate 99999999999999999999999 lies outside -1000000..1000000"},
        {TEXT_SCENE_TRIANGLES, "triangle 1 2 3 4 5 1000000.5 7 8 9",
         "1: coordinate 1000000.5 lies outside -1000000..1000000"},
        {TEXT_SCENE_TRIANGLES, "triangle 1 2 3 4 5 -1e400 7 8 9",
         "1: coordinate -1e400 lies outside -1000000..1000000"},
        {TEXT_SCENE_LINES, "line 1 2 3 4 256 6 7", "1: colour level 256 lies outside 0..255"},
        {TEXT_SCENE_LINES, "line 1 2 3 4 5 6 7 8 9 -1", "1: colour level -1 lies outside 0..255"},
        {TEXT_SCENE_TRIANGLES, "triangle 1 2 3 4 5 6 7 8 0.5",
         "1: colour level '0.5' is not a whole number"},
        {TEXT_SCENE_LINES, "size 0 5", "1: width 0 lies outside 1..16384"},
        {TEXT_SCENE_LINES, "size 5 16385", "1: height 16385 lies outside 1..16384"},
        {TEXT_SCENE_LINES, "size 5", "1: 'size' takes 2 numbers, not 1"},
        {TEXT_SCENE_LINES, "size 5 5 5", "1: 'size' takes 2 numbers, not 3"},
        {TEXT_SCENE_LINES, "size 5 5\nsize 5 5", "2: a second 'size'"},
        {TEXT_SCENE_LINES, "line 1 2 3 4 5 6 7\nsize 5 5", "2: 'size' must come before 'line'"},
        {TEXT_SCENE_LINES, "line 1 2 3 4 5 6 7\\\n 8 9 0",
         "1: colour level '7\\' is not a whole number"},
        {TEXT_SCENE_LINES, "li\x1bne 1", "1: 'li?ne' is not known: 'size' or 'line' is allowed"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct text_scene scene;
        struct error error = {0};
        CHECK_ROW(!decode(&scene, rows[i].text, rows[i].kind, &error), rows[i].text);
        CHECK_ERROR(error, rows[i].message);
        CHECK(scene.shapes == NULL && scene.shape_count == 0 && scene.width == 0);
    }
    struct text_scene scene;
    struct error error;
    CHECK(!text_scene_decode(&scene, "size 1 1\n\0", 10, TEXT_SCENE_LINES, &error));
    CHECK_ERROR(error, "2: not a text file: it holds a zero byte");
}

static void test_files(void) {
    struct place place = place_create();
    char expected[200];
    struct text_scene scene;
    struct error error;
    const char *path = name_file(&place, "scene.txt");
    snprintf(expected, sizeof expected, "%s:2: 'size' takes 2 numbers, not 1", path);
    CHECK(put_text(path, "\nsize 3\n"));
    CHECK(!text_scene_read(&scene, path, TEXT_SCENE_LINES, &error));
    CHECK_TEXT(error.message, expected);
    CHECK(put_text(path, "size 3 4\n"));
    CHECK(text_scene_read(&scene, path, TEXT_SCENE_LINES, &error) && scene.height == 4);
    text_scene_free(&scene);
    CHECK(freopen(path, "rb", stdin) != NULL);
    CHECK(text_scene_read(&scene, "-", TEXT_SCENE_LINES, &error) && scene.width == 3);
    text_scene_free(&scene);
    CHECK(put_text(path, "dot\n"));
    CHECK(freopen(path, "rb", stdin) != NULL);
    CHECK(!text_scene_read(&scene, "-", TEXT_SCENE_LINES, &error));
    CHECK_TEXT(error.message, "standard input:1: 'dot' is not known: 'size' or 'line' is allowed");
    CHECK(unlink(path) == 0);
    scene = (struct text_scene){.width = 7, .height = 7, .shape_count = 7};
    CHECK(!text_scene_read(&scene, path, TEXT_SCENE_LINES, &error) && scene.shapes == NULL);
    CHECK(scene.width == 0 && scene.height == 0 && scene.shape_count == 0);
    CHECK(strstr(error.message, "scene.txt: ") != NULL);
    CHECK(!text_scene_read(&scene, place.directory, TEXT_SCENE_LINES, &error));
    CHECK(strstr(error.message, "directory") != NULL);
    place_remove(&place, NULL);
}

UNIT_MAIN(TEST(test_lines), TEST(test_triangles), TEST(test_empty), TEST(test_messages),
          TEST(test_files))
