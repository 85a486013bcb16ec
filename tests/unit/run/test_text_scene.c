/* Text scenes: what is read, and the message for everything that is refused. */
#define _XOPEN_SOURCE 700 /* POSIX.1-2008 with mkdtemp() */

#include "run/text_scene.h"
#include "unit/place.h"

static bool decode(struct text_scene *scene, const char *text, enum text_scene_kind kind,
                   struct error *error) {
    return text_scene_decode(scene, text, strlen(text), kind, error);
}

/* As text: the size, and of each shape its corners, each with a colour. */
static void describe(const struct text_scene *scene, int corners, char *out, size_t room) {
    snprintf(out, room, "%zux%zu", scene->width, scene->height);
    for (size_t i = 0; i < scene->shape_count; i++) {
        const struct text_scene_shape *shape = &scene->shapes[i];
        for (int k = 0; k < corners; k++) {
            struct color c = shape->color[k];
            CHECK(c.a == 255);
            string_append(out, room, "%s %.7g,%.7g %d %d %d", k > 0 ? "" : ";", shape->x[k],
                          shape->y[k], c.r, c.g, c.b);
        }
    }
}

static void test_read(void) {
    static const struct {
        enum text_scene_kind kind;
        const char *text, *shapes;
    } rows[] = {
        {TEXT_SCENE_LINES, "", "0x0"},
        {TEXT_SCENE_TRIANGLES, "# nothing\n", "0x0"},
        {TEXT_SCENE_LINES, "size 1 16384\n", "1x16384"},
        {TEXT_SCENE_LINES, "size 16384 1\n", "16384x1"},
        {TEXT_SCENE_LINES,
         "\xEF\xBB\xBF# two lines\r\n\r\nsize 100 50 # wide\r\nline 13 20 80 40 255 0 7\r"
         "\tline -1000000 +1000000 0 0  1 2 3  4 5 6",
         "100x50; 13,20 255 0 7 80,40 255 0 7; -1000000,1000000 1 2 3 0,0 4 5 6"},
        {TEXT_SCENE_TRIANGLES,
         "triangle 0.5 .25 -1e2 5. 1000000 -1000000 9 8 7\n"
         "triangle 1 2 3 4 5 6 10 20 30 40 50 60 70 80 90\n",
         "0x0; 0.5,0.25 9 8 7 -100,5 9 8 7 1000000,-1000000 9 8 7"
         "; 1,2 10 20 30 3,4 40 50 60 5,6 70 80 90"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct text_scene scene;
        struct error error = {0};
        char got[300];
        if (CHECK_ROW(decode(&scene, rows[i].text, rows[i].kind, &error), error.message)) {
            describe(&scene, rows[i].kind == TEXT_SCENE_LINES ? 2 : 3, got, sizeof got);
            CHECK_TEXT(got, rows[i].shapes);
        }
        text_scene_free(&scene);
        CHECK(scene.shapes == NULL && scene.shape_count == 0 && scene.width == 0);
        text_scene_free(&scene);
    }
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
        {TEXT_SCENE_LINES, "size 5 0", "1: height 0 lies outside 1..16384"},
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
    CHECK(!text_scene_decode(&scene, "size 1 1\n\0 ", 11, TEXT_SCENE_LINES, &error));
    CHECK_ERROR(error, "2: not a text file: it holds a zero byte");
}

/* (Standard input: test_program.c.) */
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
    CHECK(put_text(path, "dot\n"));
    CHECK(freopen(path, "rb", stdin) != NULL);
    const char *model = name_file(&place, "cube.OBJ");
    CHECK(put_text(model, "v 0 0 0\n"));
    CHECK(!text_scene_read(&scene, model, TEXT_SCENE_TRIANGLES, &error));
    CHECK(strstr(error.message, "/cube.OBJ: a model, but this lesson draws text scenes") != NULL);
    CHECK(put_text(model, "size 9 8\n") &&
          text_scene_read(&scene, model, TEXT_SCENE_TRIANGLES, &error));
    text_scene_free(&scene);
    CHECK(unlink(model) == 0);
    CHECK(!text_scene_read(&scene, "-", TEXT_SCENE_LINES, &error));
    CHECK_TEXT(error.message, "standard input:1: 'dot' is not known: 'size' or 'line' is allowed");
    scene = (struct text_scene){.width = 7, .height = 7, .shape_count = 7};
    CHECK(!text_scene_read(&scene, place.directory, TEXT_SCENE_LINES, &error));
    CHECK(scene.shapes == NULL && scene.width == 0 && scene.height == 0 && scene.shape_count == 0);
    CHECK(strstr(error.message, "directory") != NULL);
    place_remove(&place, "scene.txt");
}

UNIT_MAIN(TEST(test_read), TEST(test_messages), TEST(test_files))
