/* Files as other programs write them: what they lack, and what they hold beside the format's text,
 * keeps none from being read; what is something else is called by its name. */
#define _XOPEN_SOURCE 700 /* POSIX.1-2008 with mkdtemp() */

#include "files/model_file.h"
#include "files/normals.h"
#include "files/obj.h"
#include "model.h"
#include "unit/images.h"
#include "unit/place.h"

#include <math.h>
#include <stdlib.h>

static bool decode(struct model *model, const char *text, struct error *error) {
    size_t size = strlen(text);
    char *copy = exact_copy(text, size);
    bool done = model_decode(model, copy, size, error);
    free(copy);
    return done;
}

/* Read what is expected to be read; false, with the message, where it is not. */
static bool decode_right(struct model *model, const char *text) {
    struct error error = {0};
    bool done = decode(model, text, &error);
    if (!CHECK_ROW(done, text)) {
        fprintf(stderr, "    %s\n", error.message);
    }
    return done;
}

#define SQUARE  "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
#define CORNERS "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\nvn 0 0 1\nvn 0 0 1\nvn 0 0 1\n"

enum { NEITHER, UV = 1, NORMAL = 2, BOTH = UV | NORMAL };

/* ---- OBJ ---- */

/* What the second corner of the first face has, and the one line of a warning. */
static void test_corners(void) {
    static const struct {
        const char *text;
        int has;
        enum model_warning warning; /* where `line` is not 0 */
        size_t line;
    } rows[] = {
        {SQUARE CORNERS "f 1 2/2/2 3\n", BOTH, 0, 0},
        {SQUARE CORNERS "f 1 2// 3\n", NEITHER, 0, 0},
        {SQUARE CORNERS "f 1 2/ 3\n", NEITHER, 0, 0},
        {SQUARE CORNERS "f 1 2/1/ 3\n", UV, 0, 0},
        {SQUARE CORNERS "f 1 2/0/0 3\n", NEITHER, 0, 0},
        {SQUARE CORNERS "f 1 2/1/0 3\n", UV, 0, 0},
        {SQUARE CORNERS "f 1 2/0/1 3\n", NORMAL, 0, 0},
        {SQUARE CORNERS "f 1 2/-0/+1 3\n", NORMAL, 0, 0},
        {SQUARE "f 1// 2// 3// 4//", NEITHER, 0, 0},
        {SQUARE "vt 1 0 0 1\nvn 0 0 1 0\nf 1/1/1 2/1/1 3/1/1\n", BOTH, 0, 0},
        {SQUARE CORNERS "f 1 2/5/1 3\nf 1 2/6 3\n", NORMAL, MODEL_UVS_MISSING, 13},
        {SQUARE CORNERS "f 1 2/1/5 3\nf 1//7 2 3\n", UV, MODEL_NORMALS_MISSING, 13},
        {SQUARE CORNERS "f 1 2//-5 3\n", NEITHER, MODEL_NORMALS_MISSING, 13},
        {SQUARE CORNERS "f 1 2//99999999999999999999 3\n", NEITHER, MODEL_NORMALS_MISSING, 13},
        {SQUARE "f 1/1/1 2/2/1 3/3/1\nvt 0 0\nvt 1 0\nvt 1 1\n", UV, MODEL_NORMALS_MISSING, 5},
        {SQUARE "vn 0 0 1\nf 1 2//1 3\n", NORMAL, 0, 0},
        {SQUARE "\nvn 0 0 0\nf 1 2//1 3\n", NEITHER, MODEL_NORMALS_WRONG, 6},
        {SQUARE "vn 0 0 1\nvn nan nan nan\nf 1 2//2 3\n", NEITHER, MODEL_NORMALS_WRONG, 6},
        {SQUARE "vn -nan(ind) 0 1\nf 1 2//1 3\n", NEITHER, MODEL_NORMALS_WRONG, 5},
        {SQUARE "vn 0 1.#QNAN 1\nf 1 2//1 3\n", NEITHER, MODEL_NORMALS_WRONG, 5},
        {SQUARE "vn 0 1 -Inf\nf 1 2//1 3\n", NEITHER, MODEL_NORMALS_WRONG, 5},
        {SQUARE "vn 0 1e39 1\nf 1 2//1 3\n", NEITHER, MODEL_NORMALS_WRONG, 5},
        {SQUARE "vn 1e-60 0 0\nf 1 2//1 3\n", NEITHER, MODEL_NORMALS_WRONG, 5},
        {SQUARE "vn 1e-40 0 0\nf 1 2//1 3\n", NORMAL, 0, 0},
        {SQUARE "vn 0 0 0\nvn 0 0 1\nf 1 2//2 3\n", NORMAL, 0, 0}, /* no corner names it */
        {SQUARE "f 1 2\nf 1 2 3\nf 3\n", NEITHER, MODEL_SHORT_FACES, 5},
        {SQUARE "f\nf 1 2 3\n", NEITHER, MODEL_SHORT_FACES, 5},
        {SQUARE "vt nan nan\nf 1 2/1 3\n", UV, 0, 0},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct model m;
        if (!decode_right(&m, rows[i].text)) {
            continue;
        }
        const struct corner *corner = &m.faces[0].corner[1];
        CHECK_ROW(corner->position == 1, rows[i].text);
        CHECK_ROW((corner->uv != MODEL_NONE) == ((rows[i].has & UV) != 0), rows[i].text);
        CHECK_ROW((corner->normal != MODEL_NONE) == ((rows[i].has & NORMAL) != 0), rows[i].text);
        for (int k = 0; k < MODEL_WARNINGS; k++) {
            bool expected = rows[i].line > 0 && k == (int)rows[i].warning;
            CHECK_ROW(m.warning_line[k] == (expected ? rows[i].line : 0), rows[i].text);
            CHECK(strlen(model_warning_text((enum model_warning)k)) > 20);
        }
        model_free(&m);
    }
}

/* What is wrong in a part that is not asked for is not even seen. */
static void test_unused_parts(void) {
    static const char *const texts[] = {
        SQUARE "vt what\nvn 1\nf 1/1/1 2/9/9 3/-4/-4\n",
        SQUARE "f 1/1/1 2/2/2 3/3/3\n",
        SQUARE "l what\nf 1//0 2// 3/0/\n",
    };
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
        struct model m = {0};
        struct error error;
        CHECK_ROW(obj_decode(&m, texts[i], strlen(texts[i]), 0, &error), texts[i]);
        CHECK_ROW(m.face_count == 1 && m.faces[0].corner[1].uv == MODEL_NONE &&
                      m.faces[0].corner[1].normal == MODEL_NONE,
                  texts[i]);
        for (int k = 0; k < MODEL_WARNINGS; k++) {
            CHECK_ROW(m.warning_line[k] == 0, texts[i]);
        }
        model_free(&m);
    }
}

/* No direction is invented: a normal that is computed points as the face does. */
static void test_computed_normals(void) {
    static const char *const texts[] = {
        SQUARE "f 1//1 2//1 3//1\n",
        SQUARE "vn 0 0 0\nf 1//1 2//1 3//1\n",
        SQUARE "vn 1 0 0\nvn nan nan nan\nf 1//2 2//2 3//2\n",
        "NOFF\n3 1\n0 0 0 0 0 0\n1 0 0 nan nan nan\n0 1 0 -nan(ind) 0 0\n3 0 1 2\n",
    };
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
        struct model m;
        struct error error;
        if (decode_right(&m, texts[i])) {
            CHECK_ROW(model_need_normals(&m, &error), texts[i]);
            for (size_t k = 0; k < 3; k++) {
                struct vec3 normal = model_normal(&m, 0, k);
                CHECK_ROW(normal.x == 0 && normal.y == 0 && normal.z == 1, texts[i]);
            }
            model_free(&m);
        }
    }
}

/* Colours of the first three positions. */
static void test_colors(void) {
    static const struct {
        const char *text;
        float color[3][3];
    } rows[] = {
        {"v 0 0 0 1 0 0 1\nv 1 0 0 0 1 0 1\nv 0 1 0 0 0 1 0.5\nf 1 2 3\n",
         {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
        {"v 0 0 0 1 0 0 1 2 3 4 5 6 7 8 9 10\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
         {{1, 0, 0}, {1, 1, 1}, {1, 1, 1}}},
        {"v 0 0 0 102 51 0\nv 1 0 0 255 255 255\nv 0 1 0 0 0 3\nf 1 2 3\n",
         {{0.4F, 0.2F, 0}, {1, 1, 1}, {0, 0, 3 / 255.0F}}},
        {"v 0 0 0\nv 1 0 0 51.0 127.5 51\nv 0 1 0\nf 1 2 3\n", /* white stays white */
         {{1, 1, 1}, {0.2F, 0.5F, 0.2F}, {1, 1, 1}}},
        {"v 0 0 0 nan nan nan\nv 1 0 0 0 1 0\nv 0 1 0 1e39 inf 1\nf 1 2 3\n",
         {{1, 1, 1}, {0, 1, 0}, {1, 1, 1}}},
        {"v 0 0 0 1.001 0 0\nv 1 0 0 0 1.5 -1\nv 0 1 0 0.5 0 0\nf 1 2 3\n",
         {{1, 0, 0}, {0, 1, 0}, {0.5F, 0, 0}}},
        {"CSTOFF\n3 1 0\n0 0 0 255 0 0 255 0 0\n1 0 0 0 51 0 255 1 0\n0 1 0 0 0 255 255 1 1\n"
         "3 0 1 2\n",
         {{1, 0, 0}, {0, 0.2F, 0}, {0, 0, 1}}},
        {"NCOFF\n3 1 0\n0 0 0 0 0 1 1 0 0\n1 0 0 0 0 1 0 .2 0\n0 1 0 0 0 1 0 0 1\n3 0 1 2\n",
         {{1, 0, 0}, {0, 0.2F, 0}, {0, 0, 1}}},
        {"coff\n3 1 0\n0 0 0 1 0 0\n1 0 0 0 .2 0\n0 1 0 0 0 1\n3 0 1 2\n",
         {{1, 0, 0}, {0, 0.2F, 0}, {0, 0, 1}}},
        {"OFF\n3 1 0\n0 0 0 1 0 0\n1 0 0 0 .2 0\n0 1 0 0 0 1\n3 0 1 2\n", /* no C */
         {{1, 0, 0}, {0, 0.2F, 0}, {0, 0, 1}}},
        {"OFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 0 51 0 255\n0 1 0 0 0 255 255\n3 0 1 2\n",
         {{1, 0, 0}, {0, 0.2F, 0}, {0, 0, 1}}},
        {"NOFF\n3 1 0\n0 0 0 0 0 1 1 0 0\n1 0 0 0 0 1 0 .2 0\n0 1 0 0 0 1 0 0 1\n3 0 1 2\n",
         {{1, 0, 0}, {0, 0.2F, 0}, {0, 0, 1}}},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct model m;
        if (!decode_right(&m, rows[i].text)) {
            continue;
        }
        for (size_t k = 0; CHECK_ROW(m.colors != NULL, rows[i].text) && k < 3; k++) {
            CHECK_ROW(memcmp(m.colors[k], rows[i].color[k], sizeof m.colors[k]) == 0, rows[i].text);
        }
        CHECK_ROW(m.face_colors == NULL, rows[i].text);
        model_free(&m);
    }
}

/* Lines are read where they are asked for, and alone are a model only there. */
static void test_lines(void) {
    static const char *const texts[] = {
        "l 1 2 3 4 \\\n1\nl 2\nl 4 1\n" SQUARE,
        SQUARE "l 1/1 2/1 3/9 4// 1\nf 1 2 3\nl -1 1\n",
        "OFF\n4 6\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 1 9 9 9\n2 1 2\n1 3\n2 2 3\n2 3 0\n2 3 0",
    };
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
        const uint32_t expected[5][2] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {3, 0}};
        struct place place = place_create();
        struct model m = {0};
        struct error error = {0};
        const char *path = name_file(&place, "lines");
        if (CHECK(put_text(path, texts[i])) &&
            CHECK_ROW(model_read_parts(&m, path, MODEL_LINES, &error), texts[i])) {
            CHECK_ROW(m.face_count == (i == 1) && m.position_count == 4, texts[i]);
            CHECK_ROW(m.line_count == 5 && memcmp(m.lines, expected, sizeof expected) == 0,
                      texts[i]);
        }
        model_free(&m);
        CHECK(model_read(&m, path, &error) == (i == 1));
        CHECK_ROW(m.line_count == 0 && m.lines == NULL, texts[i]);
        model_free(&m);
        place_remove(&place, "lines");
    }
    struct model m;
    struct error error;
    CHECK(!decode(&m, SQUARE "p 1\nl 1 2 3\n", &error));
    CHECK_ERROR(error, "6: lines and no faces, which only lesson 2 draws");
    CHECK(!decode(&m, "l 1 5\n" SQUARE, &error)); /* where they are passed over */
    CHECK(!obj_decode(&m, "l 1 5\n" SQUARE, strlen("l 1 5\n" SQUARE), MODEL_LINES, &error));
    CHECK_ERROR(error, "1: face names vertex 5 of 4");
    model_free(&m);
}

/* ---- OFF ---- */

/* Positions of the first triangle: (0,0,0), (1,0,0), (0,1,0). */
static void test_off(void) {
    static const struct {
        const char *text;
        int has;
    } rows[] = {
        {"3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", NEITHER},
        {"# no word\n\n3 1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", NEITHER},
        {"off\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", NEITHER},
        {"Off 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", NEITHER},
        {"stoff\n3 1 0\n0 0 0 0 0\n1 0 0 1 0\n0 1 0 0 1\n3 0 1 2\n", UV},
        {"noff\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n", NORMAL},
        {"NSTOFF\n3 1 0\n0 0 0 0 0 1 0 0\n1 0 0 0 0 1 1 0\n0 1 0 0 0 1 0 1\n3 0 1 2\n", BOTH},
        {"4OFF\n3 1 0\n0 0 0 1\n2 0 0 2\n0 1 0 0\n3 0 1 2\n", NEITHER},
        {"4noff\n3 1 0\n0 0 0 1 0 0 1\n1 0 0 1 0 0 1\n0 .5 0 .5 0 0 1\n3 0 1 2\n", NORMAL},
        {"nOFF 3\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", NEITHER},
        {"nOFF\n3\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", NEITHER},
        {"NnOFF 3\n3 1\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n", NORMAL},
        {"4nOFF 3\n3 1 0\n0 0 0 1\n1 0 0 1\n0 1 0 1\n3 0 1 2\n", NEITHER},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct model m;
        if (!decode_right(&m, rows[i].text)) {
            continue;
        }
        for (size_t k = 0; k < 3; k++) {
            struct vec3 p = model_position(&m, 0, k), normal = model_normal(&m, 0, k);
            CHECK_ROW(p.x == (k == 1) && p.y == (k == 2) && p.z == 0, rows[i].text);
            CHECK_ROW(normal.z == ((rows[i].has & NORMAL) != 0), rows[i].text);
            struct vec2 uv = model_uv(&m, 0, k);
            bool has_uv = (rows[i].has & UV) != 0;
            CHECK_ROW(uv.x == (has_uv && k == 1) && uv.y == (has_uv && k == 2), rows[i].text);
        }
        CHECK_ROW(m.face_count == 1 && m.colors == NULL, rows[i].text);
        model_free(&m);
    }
}

/* ---- What is something else ---- */

#define EXPORT ": Blender, for one, exports it as OBJ"

static void test_messages(void) {
    static const struct {
        const char *text, *message;
    } rows[] = {
        {SQUARE "f 0 1 2\n", "5: face names vertex 0: the first is 1"},
        {SQUARE "f / 1 2\n", "5: face corner '/' is none of v, v/vt, v//vn, v/vt/vn"},
        {SQUARE "f 1/x 2 3\n", "5: face corner '1/x' is none of v, v/vt, v//vn, v/vt/vn"},
        {SQUARE "f 1/1/1/ 2 3\n", "5: face corner '1/1/1/' is none of v, v/vt, v//vn, v/vt/vn"},
        {SQUARE "f 1/- 2 3\n", "5: face corner '1/-' is none of v, v/vt, v//vn, v/vt/vn"},
        {SQUARE "f 1//1.5 2 3\n", "5: face corner '1//1.5' is none of v, v/vt, v//vn, v/vt/vn"},
        {"v nan 0 0\n", "1: 'nan' is not a number"},
        {SQUARE "vn nothing 0 1\n", "5: 'nothing' is not a number"},
        {SQUARE "vn - 0 1\n", "5: '-' is not a number"},
        {"OFF BINARY\n", "1: a binary OFF file: only text can be read"},
        {"\nCOFF BINARY # what\n", "1: a binary OFF file: only text can be read"},
        {"4OFF 1 1\n1 1 1 1e-320\n3 0 0 0\n", "2: the vertex is too far away"},
        {"nOFF\n4\n1 1\n0 0 0 0\n", "2: a space of 4 dimensions, not 3"},
        {"nOFF\n", "1: the number of dimensions is missing"},
        {"OFF\n2 1\n0 0 0 1 0 0 0 0\n0 0 0 1 0 0\n3 0 0 0\n",
         "4: the file goes on after 1 faces, none with 3 corners"},
        {"1.5 2 3\n", "begins with a number, as neither OBJ nor OFF does"},
        {"version https://git-lfs.github.com/spec/v1\noid sha256:3c\nsize 39043\n",
         "a Git LFS pointer, not an OBJ or OFF file: `git lfs pull` fetches the file itself"},
        {"ply\nformat ascii 1.0\n", "a PLY file, not an OBJ or OFF file" EXPORT},
        {"ply\r\nformat ascii 1.0\r\n", "a PLY file, not an OBJ or OFF file" EXPORT},
        {"solid cube\n facet normal 0 0 1\n", "an STL file, not an OBJ or OFF file" EXPORT},
        {"glTF\2", "a glTF file, not an OBJ or OFF file" EXPORT},
        {"{\"asset\": {}}", "JSON, perhaps a glTF file, not an OBJ or OFF file" EXPORT},
        {"<!DOCTYPE HTML><html>", "an HTML page, not an OBJ or OFF file: download the file itself"},
        {"solid\n" SQUARE "f 1 2 9\n", "an STL file, not an OBJ or OFF file" EXPORT},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct model m;
        struct error error = {0};
        CHECK_ROW(!decode(&m, rows[i].text, &error), rows[i].text);
        CHECK_ERROR(error, rows[i].message);
        CHECK(m.faces == NULL && m.positions == NULL);
    }
    struct model m;
    CHECK(decode_right(&m, "solid\n" SQUARE "f 1 2 3\n")); /* it can be read */
    model_free(&m);
}

/* Bytes that no text has. */
static void test_binary_messages(void) {
    uint8_t stl[84 + 2 * 50] = {[80] = 2};
    static const char off[] = "OFF BINARY\n\0\0\0\3";
    struct model m;
    struct error error;
    CHECK(!model_decode(&m, off, sizeof off, &error));
    CHECK_ERROR(error, "1: a binary OFF file: only text can be read");
    CHECK(!model_decode(&m, stl, sizeof stl, &error));
    CHECK_ERROR(error, "a binary STL file, not an OBJ or OFF file" EXPORT);
    stl[81] = 1;
    CHECK(!model_decode(&m, stl, sizeof stl, &error));
    CHECK_ERROR(error, "1: not a text file: it holds a zero byte");
}

UNIT_MAIN(TEST(test_corners), TEST(test_unused_parts), TEST(test_computed_normals),
          TEST(test_colors), TEST(test_lines), TEST(test_off), TEST(test_messages),
          TEST(test_binary_messages))
