/* Models: what is read of OBJ and OFF, the message for everything that is refused, polygons cut
 * into triangles against exact areas, normals against acosl(), textures beside the model. */
#define _POSIX_C_SOURCE 200809L /* mkdtemp */

#include "model.h"
#include "png.h"
#include "unit.h"

#include <math.h>
#include <stdlib.h>
#include <unistd.h>

#ifndef COURSE_BUILD /* where make builds: test files go there */
#define COURSE_BUILD "."
#endif

static uint64_t random_bits(void) { /* xorshift64: Marsaglia, "Xorshift RNGs", 2003 */
    static uint64_t state = UINT64_C(88172645463325252);
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return state;
}

static int random_int(int least, int greatest) {
    return least + (int)(random_bits() % (uint64_t)(greatest - least + 1));
}

static double random_unit(void) { /* -1..1 */
    return (double)(random_bits() >> 11) * 0x1p-52 - 1;
}

static bool decode(struct model *model, const char *text, struct error *error) {
    return model_decode(model, text, strlen(text), error);
}

/* ---- What is read ---- */

/* The faces as text: corners p/u/n counted from 0, '-' for none, faces parted by a blank. */
static void describe_faces(const struct model *model, char *out, size_t room) {
    size_t used = 0;
    out[0] = '\0';
    for (size_t i = 0; i < model->face_count; i++) {
        for (int j = 0; j < 3; j++) {
            const struct corner *c = &model->faces[i].corner[j];
            const uint32_t index[3] = {c->position, c->uv, c->normal};
            const char *before = j > 0 ? "," : (i > 0 ? " " : "");
            for (int k = 0; k < 3; k++) {
                const char *part = k > 0 ? "/" : before;
                if (index[k] == MODEL_NONE) {
                    used += (size_t)snprintf(out + used, room - used, "%s-", part);
                } else {
                    used += (size_t)snprintf(out + used, room - used, "%s%" PRIu32, part, index[k]);
                }
            }
        }
    }
}

#define SQUARE   "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
#define CORNERS  "vt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\nvn 0 1 0\n"
#define TRIANGLE "0/-/-,1/-/-,2/-/-"

static void test_obj_faces(void) {
    static const struct {
        const char *name, *text, *faces;
    } rows[] = {
        {"plain", SQUARE "f 1 2 3\n", TRIANGLE},
        {"no final newline", SQUARE "f 1 2 3", TRIANGLE},
        {"CRLF", "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n", TRIANGLE},
        {"CR only", "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r", TRIANGLE},
        {"byte-order mark", "\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3", TRIANGLE},
        {"v/vt", SQUARE CORNERS "f 1/1 2/2 3/3\n", "0/0/-,1/1/-,2/2/-"},
        {"v//vn", SQUARE CORNERS "f 1//1 2//2 3//1\n", "0/-/0,1/-/1,2/-/0"},
        {"v/vt/vn", SQUARE CORNERS "f 1/3/2 2/2/1 4/1/2\n", "0/2/1,1/1/0,3/0/1"},
        {"mixed in a face", SQUARE CORNERS "f 1 2/2 3//1\n", "0/-/-,1/1/-,2/-/0"},
        {"negative", SQUARE CORNERS "f -4/-3/-2 -3/-2/-1 -1/-1/-1\n", "0/0/0,1/1/1,3/2/1"},
        {"negative is from here", SQUARE "f -3 -2 -1\nv 5 5 5\nf -3 -2 -1\n",
         "1/-/-,2/-/-,3/-/- 2/-/-,3/-/-,4/-/-"},
        {"vertices further down", "f 1 2 3\n" SQUARE, TRIANGLE},
        {"attributes further down", SQUARE "f 1/1/1 2/2/2 3/3/1\n" CORNERS, "0/0/0,1/1/1,2/2/0"},
        {"plus sign, leading zeros", SQUARE "f +1 002 3\n", TRIANGLE},
        {"square", SQUARE "f 1 2 3 4\n", "0/-/-,1/-/-,2/-/- 0/-/-,2/-/-,3/-/-"},
        {"clockwise square", SQUARE "f 4 3 2 1\n", "3/-/-,2/-/-,1/-/- 3/-/-,1/-/-,0/-/-"},
        {"corners keep their attributes", SQUARE CORNERS "f 1/1/1 2/2/1 3/3/1 4/1/2\n",
         "0/0/0,1/1/0,2/2/0 0/0/0,2/2/0,3/0/1"},
        {"arrow: the inner corner 4 must be on the cut",
         "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 1 1 0\nf 1 2 4 3\n", "0/-/-,1/-/-,3/-/- 0/-/-,3/-/-,2/-/-"},
        {"the same from another first corner", "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 1 1 0\nf 2 4 3 1\n",
         "3/-/-,2/-/-,0/-/- 3/-/-,0/-/-,1/-/-"},
        {"all corners in one place", "v 1 1 1\nf 1 1 1 1 1\n",
         "0/-/-,0/-/-,0/-/- 0/-/-,0/-/-,0/-/- 0/-/-,0/-/-,0/-/-"},
        {"on a line", "v 0 0 0\nv 1 1 1\nv 2 2 2\nv 3 3 3\nf 1 3 2 4\n",
         "0/-/-,2/-/-,1/-/- 0/-/-,1/-/-,3/-/-"},
        {"polylines and points are no faces", SQUARE "l 1 2 3 4\np 1\nf 1 2 3\nl 1 2 3\n",
         TRIANGLE},
        {"unknown words",
         "mtllib a.mtl\no x\ng y z\ns off\nusemtl m\nvp 1 2\n" SQUARE
         "cstype bezier\nf 1 2 3\nfoo # bar\nfacet 1 2\nvv 1\n",
         TRIANGLE},
        {"comments", "# v 9 9 9\n" SQUARE "f 1 2 3 # 4\n#f 1 2 3\n", TRIANGLE},
        {"comment that ends in a backslash", "# c:\\models\\\n" SQUARE "f 1 2 3", TRIANGLE},
        {"continued face", SQUARE "f 1 \\\n2\\\n \\\r\n3\n", TRIANGLE},
        {"continued vertex", "v 0 0 \\\n 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", TRIANGLE},
        {"tabs and blanks", "\tv\t0 0  0 \n v 1 0 0\n  v 0 1 0\nf\t1  2\t3 \n", TRIANGLE},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct model model;
        struct error error = {{0}};
        char faces[512];
        if (!CHECK_ROW(decode(&model, rows[i].text, &error), rows[i].name)) {
            fprintf(stderr, "    %s\n", error.message);
            continue;
        }
        describe_faces(&model, faces, sizeof faces);
        if (!CHECK_TEXT(faces, rows[i].faces)) {
            fprintf(stderr, "    in row: %s\n", rows[i].name);
        }
        model_free(&model);
        CHECK(model.faces == NULL && model.face_count == 0 && model.positions == NULL);
    }
}

static bool same3(const float *a, float x, float y, float z) {
    return a[0] == x && a[1] == y && a[2] == z;
}

static void test_obj_numbers(void) {
    static const char text[] = "v 1 -2 .5\nv 1e2 5. -1E-2 7\nv 0.1 0.2 0.3 0.25 -1 300\n"
                               "v 16777217 1e-30 -0\nvt 0.5\nvt 2 -3\nvt 1 2 3\nvn 0 3 4\n"
                               "f 1 2 3\n";
    struct model m;
    struct error error;
    if (!CHECK(decode(&m, text, &error))) {
        return;
    }
    CHECK(m.position_count == 4 && m.uv_count == 3 && m.normal_count == 1 && m.face_count == 1);
    CHECK(same3(m.positions[0], 1, -2, 0.5F) && same3(m.positions[1], 100, 5, -0.01F));
    CHECK(same3(m.positions[2], 0.1F, 0.2F, 0.3F) && same3(m.positions[3], 16777216, 1e-30F, 0));
    CHECK(m.uvs[0][0] == 0.5F && m.uvs[0][1] == 0 && m.uvs[1][0] == 2 && m.uvs[1][1] == -3 &&
          m.uvs[2][1] == 2);
    CHECK(same3(m.normals[0], 0, 3, 4));
    /* Only the third position has a colour: the others are white, and not w. */
    if (CHECK(m.colors != NULL)) {
        CHECK(same3(m.colors[0], 1, 1, 1) && same3(m.colors[1], 1, 1, 1));
        CHECK(same3(m.colors[2], 0.25F, 0, 1) && same3(m.colors[3], 1, 1, 1));
    }
    CHECK(m.path == NULL);
    struct vec2 uv = model_uv(&m, 0, 0);
    CHECK(uv.x == 0 && uv.y == 0);
    model_free(&m);
    CHECK(decode(&m, SQUARE "v 1 2 3 4\nf 1 2 3\n", &error) && m.colors == NULL);
    model_free(&m);
}

/* Colours for many positions, from the middle on and not up to the end. */
static void test_obj_many_colors(void) {
    struct bytes bytes = {0};
    struct model m;
    struct error error;
    char line[64];
    for (int i = 0; i < 1000; i++) {
        bool colored = i >= 300 && i < 500;
        int length = snprintf(line, sizeof line, "v %d 0 0%s\n", i, colored ? " 0 0.5 0" : "");
        CHECK(bytes_append(&bytes, line, (size_t)length));
    }
    CHECK(bytes_append(&bytes, "f 1 2 3\n", 8));
    if (CHECK(model_decode(&m, bytes.data, bytes.size, &error)) && CHECK(m.colors != NULL)) {
        for (int i = 0; i < 1000; i++) {
            bool colored = i >= 300 && i < 500;
            CHECK(m.positions[i][0] == (float)i);
            CHECK(same3(m.colors[i], colored ? 0 : 1, colored ? 0.5F : 1, colored ? 0 : 1));
        }
    }
    model_free(&m);
    bytes_free(&bytes);
}

static void test_off(void) {
    static const struct {
        const char *name, *text, *faces;
    } rows[] = {
        {"plain", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n", TRIANGLE},
        {"counts on the first line", "OFF 3 1 3\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2", TRIANGLE},
        {"no blank after OFF", "OFF3 1 3\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2", TRIANGLE},
        {"no number of edges", "OFF\n3 1\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2", TRIANGLE},
        {"comments and empty lines",
         "# made by hand\n\nOFF # what\n\n# x\n3 1 0 # y\n0 0 0\n\n1 0 0 # z\n1 1 0\n\n#\n3 0 1 2 "
         "#\n",
         TRIANGLE},
        {"CRLF and a byte-order mark",
         "\xEF\xBB\xBFOFF\r\n3 1 0\r\n0 0 0\r\n1 0 0\r\n1 1 0\r\n3 0 1 2\r\n", TRIANGLE},
        {"face colours",
         "OFF\n3 2 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2 255 0 0\n3 0 1 2 0.5 0.5 0.5 1\n",
         TRIANGLE " " TRIANGLE},
        {"square", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n",
         "0/-/-,1/-/-,2/-/- 0/-/-,2/-/-,3/-/-"},
        {"points and lines are no faces", "OFF\n3 3 0\n0 0 0\n1 0 0\n1 1 0\n1 0\n2 0 1\n3 0 1 2\n",
         TRIANGLE},
        {"colours", "COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 0 51 0 9\n1 1 0 0 0 255 0\n3 0 1 2\n",
         TRIANGLE},
        {"normals", "NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 1 0\n1 1 0 1 0 0\n3 0 1 2\n",
         "0/-/0,1/-/1,2/-/2"},
        {"everything",
         "STCNOFF\n3 1 0\n0 0 0 0 0 1 1 0 0 1 0.5 0.25\n1 0 0 0 0 1 0 0.2 0 1 0 0\n"
         "1 1 0 0 0 1 0 0 1 1 1 1\n3 0 1 2\n",
         "0/0/0,1/1/1,2/2/2"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct model m;
        struct error error = {{0}};
        char faces[512];
        if (!CHECK_ROW(decode(&m, rows[i].text, &error), rows[i].name)) {
            fprintf(stderr, "    %s\n", error.message);
            continue;
        }
        describe_faces(&m, faces, sizeof faces);
        CHECK_TEXT(faces, rows[i].faces);
        CHECK_ROW(same3(m.positions[1], 1, 0, 0) && same3(m.positions[2], 1, 1, 0), rows[i].name);
        bool colored =
            strstr(rows[i].text, "COFF") != NULL || strstr(rows[i].text, "CNOFF") != NULL;
        CHECK_ROW(colored == (m.colors != NULL), rows[i].name);
        if (m.colors != NULL) {
            CHECK(same3(m.colors[0], 1, 0, 0) && same3(m.colors[1], 0, 0.2F, 0));
        }
        if (m.uv_count > 0) {
            CHECK(m.uvs[0][0] == 0.5F && m.uvs[0][1] == 0.25F);
        }
        model_free(&m);
    }
}

/* ---- What is refused ---- */

static void test_messages(void) {
    static const struct {
        const char *text, *message;
    } rows[] = {
        {"", "holds no faces"},
        {"\n# nothing\n", "holds no faces"},
        {SQUARE, "holds no faces"},
        {SQUARE "l 1 2 3 4\n", "holds no faces"},
        {"just some words\nand more of them", "holds no faces"},
        {SQUARE "\nf 1 2 0\n", "6: face names vertex 0: the first is 1"},
        {SQUARE "f 1 2 5\n", "5: face names vertex 5 of 4"},
        {SQUARE "f 1 2 4294967297\n", "5: face names vertex 4294967297 of 4"},
        {SQUARE "f 1 2 4294967296\n", "5: face names vertex 4294967296 of 4"},
        {SQUARE "f 1 2 -4294967295\n", "5: face names vertex -4294967295 of 4"},
        {SQUARE "f 1 2 18446744073709551617\n", "5: face names vertex 18446744073709551617 of 4"},
        {SQUARE "f 1 2 -99999999999999999999\n", "5: face names vertex -99999999999999999999 of 4"},
        {SQUARE "f 1 2 +99999999999999999999\n", "5: face names vertex +99999999999999999999 of 4"},
        {SQUARE "f 1 2 -5\n", "5: face names vertex -5 of 4"},
        {"v 0 0 0\nf -1 -1 -2\n" SQUARE, "2: face names vertex -2 of 1"},
        {SQUARE "f 1/1 2/1 3/1\n", "5: face names texture coordinate 1 of 0"},
        {SQUARE CORNERS "f 1/1 2/4 3/1\n", "10: face names texture coordinate 4 of 3"},
        {SQUARE CORNERS "f 1/1 2/0 3/1\n", "10: face names texture coordinate 0: the first is 1"},
        {SQUARE CORNERS "f 1//1 2//1 3//3\n", "10: face names normal 3 of 2"},
        {SQUARE CORNERS "f 1//1 2//1 3//-3\n", "10: face names normal -3 of 2"},
        {SQUARE "f 1 2\n", "5: a face has at least 3 corners, not 2"},
        {SQUARE "f\n", "5: a face has at least 3 corners, not 0"},
        {SQUARE "f 1 2 x\n", "5: face corner 'x' is none of v, v/vt, v//vn, v/vt/vn"},
        {SQUARE "f 1 2 3.0\n", "5: face corner '3.0' is none of v, v/vt, v//vn, v/vt/vn"},
        {SQUARE "f 1 2 /3\n", "5: face corner '/3' is none of v, v/vt, v//vn, v/vt/vn"},
        {SQUARE "f 1 2 3/\n", "5: face corner '3/' is none of v, v/vt, v//vn, v/vt/vn"},
        {SQUARE "f 1 2 3//\n", "5: face corner '3//' is none of v, v/vt, v//vn, v/vt/vn"},
        {SQUARE CORNERS "f 1 2 3/1/1/1\n",
         "10: face corner '3/1/1/1' is none of v, v/vt, v//vn, v/vt/vn"},
        {SQUARE CORNERS "f 1 2 3/1/1/\n",
         "10: face corner '3/1/1/' is none of v, v/vt, v//vn, v/vt/vn"},
        {SQUARE "f 1 \\\n 2 \\\n 9\n", "5: face names vertex 9 of 4"},
        {"v 1 2\n", "1: 'v' takes 3, 4 or 6 numbers, not 2"},
        {"\nv 1 2 3 4 5\n", "2: 'v' takes 3, 4 or 6 numbers, not 5"},
        {"v 1 2 3 4 5 6 7\n", "1: 'v' takes 3, 4 or 6 numbers, not 7"},
        {"v 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15\n", "1: 'v' takes 3, 4 or 6 numbers, not 15"},
        {"v\n", "1: 'v' takes 3, 4 or 6 numbers, not 0"},
        {"vt\n", "1: 'vt' takes 1 to 3 numbers, not 0"},
        {"vt 1 2 3 4\n", "1: 'vt' takes 1 to 3 numbers, not 4"},
        {"vn 1 2\n", "1: 'vn' takes 3 numbers, not 2"},
        {"v 1 2 nan\n", "1: 'nan' is not a number"},
        {"v 1 2 inf\n", "1: 'inf' is not a number"},
        {"v 1 2 -Infinity\n", "1: '-Infinity' is not a number"},
        {"v 1 2 1e39\n", "1: 1e39 is too large"},
        {"v 1 2 3 1 1 3.5e38\n", "1: 3.5e38 is too large"},
        {"vt 1e400\n", "1: 1e400 is too large"},
        {"vn 0 0 -1e39\n", "1: -1e39 is too large"},
        {"v 1,5 2 3\n", "1: '1,5' is not a number"},
        {"v 1 2 3x\n", "1: '3x' is not a number"},
        {"v 1 2 \x1b[31m\n", "1: '?[31m' is not a number"},
        {"OFF", "1: the numbers of vertices and faces are missing"},
        {"OFF\n\n", "2: the numbers of vertices and faces are missing"},
        {"OFF\n3\n", "2: the number of faces is missing"},
        {"OFF\nx 1 0\n", "2: 'x' is not a number of vertices"},
        {"OFF! 1 1\n", "holds no faces"}, /* not OFF, and nothing that OBJ knows */
        {"OFFs 1 1\n", "holds no faces"},
        {"OFF\n4294967295 1 0\n", "2: '4294967295' is not a number of vertices"},
        {"COFF\n0 0 0\n", "holds no faces"},
        {"OFF\n-1 1 0\n", "2: '-1' is not a number of vertices"},
        {"OFF\n1 1.5 0\n", "2: '1.5' is not a number of faces"},
        {"OFF\n4000000000 1 0\n0 0 0\n",
         "2: 4000000000 vertices and 1 faces are more than the file can hold"},
        {"OFF\n1 4000000000 0\n0 0 0\n",
         "2: 1 vertices and 4000000000 faces are more than the file can hold"},
        {"OFF\n99999999999999999999 1 0\n",
         "2: '99999999999999999999' is not a number of vertices"},
        {"OFF\n2 1 0\n0 0 0\n# end of it\n", "4: the file ends after 1 of 2 vertices"},
        {"OFF\n1 1 0\n0 0 0\n", "3: the file ends after 0 of 1 faces"},
        {"OFF\n1 1 0\n0 0\n3 0 0 0\n", "3: a vertex has 3 numbers here, not 2"},
        {"OFF\n1 1 0\n0 0 0 0\n3 0 0 0\n", "3: a vertex has 3 numbers here, not 4"},
        {"COFF\n1 1 0\n0 0 0\n3 0 0 0\n",
         "3: a vertex has 6 (with alpha one more) numbers here, not 3"},
        {"OFF\n1 1 0\n0 nan 0\n3 0 0 0\n", "3: 'nan' is not a number"},
        {"OFF\n1 1 0\n0 1e39 0\n3 0 0 0\n", "3: 1e39 is too large"},
        {"OFF\n1 1 0\n0 0 0\n3 0 0 1\n", "4: face names vertex 1 of 1 (from 0)"},
        {"OFF\n1 1 0\n0 0 0\n3 0 0 -1\n", "4: face names vertex -1 of 1 (from 0)"},
        {"OFF\n1 1 0\n0 0 0\n3 0 0 4294967296\n", "4: face names vertex 4294967296 of 1 (from 0)"},
        {"OFF\n1 1 0\n0 0 0\n3 0 0 x\n", "4: 'x' is not the number of a vertex"},
        {"OFF\n1 1 0\n0 0 0\n4 0 0 0\n", "4: face has 3 corners, not 4"},
        {"OFF\n1 1 0\n0 0 0\n4000000000 0 0 0\n", "4: face has 3 corners, not 4000000000"},
        {"OFF\n1 1 0\n0 0 0\n-3 0 0 0\n", "4: '-3' is not a number of corners"},
        {"OFF\n1 0 0\n0 0 0\n", "holds no faces"},
        {"OFF\n0 0 0\n", "holds no faces"},
        {"OFF BINARY\n", "1: binary OFF files cannot be read"},
        {"4OFF\n1 1 0\n", "1: 4OFF: only positions of three coordinates can be read"},
        {"nOFF 3\n1 1 0\n", "1: nOFF: only positions of three coordinates can be read"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct model model;
        struct error error = {{0}};
        CHECK_ROW(!decode(&model, rows[i].text, &error), rows[i].text);
        if (!CHECK_TEXT(error.message, rows[i].message)) {
            fprintf(stderr, "    in row: %s\n", rows[i].text);
        }
        CHECK(model.faces == NULL && model.positions == NULL && model.position_count == 0);
    }
    struct model model;
    struct error error;
    CHECK(!model_decode(&model, "v 1 2 3\nf\0", 10, &error));
    CHECK_TEXT(error.message, "2: not a text file: it holds a zero byte");
    CHECK(!model_decode(&model, NULL, 0, &error));
}

/* 1 MB of one character, alone and after each keyword: refused in linear time, or this never ends.
 */
static void test_long_lines(void) {
    static const char *const starts[] = {"",      "v ",   "f ",           SQUARE "f 1 ",
                                         "vt 1 ", "OFF ", "OFF\n1 1 0\n", "# "};
    const size_t size = 1 << 20;
    char *data = malloc(size);
    CHECK(data != NULL);
    if (data == NULL) {
        return;
    }
    for (size_t i = 0; i < sizeof starts / sizeof starts[0]; i++) {
        static const char fills[] = {'\0', 'a', ' ', '1', '\\', '/', '.', '\n'};
        for (size_t k = 0; k < sizeof fills; k++) {
            struct model model;
            struct error error;
            memset(data, fills[k], size);
            memcpy(data, starts[i], strlen(starts[i]));
            CHECK(!model_decode(&model, data, size, &error));
            CHECK(strlen(error.message) < 200);
        }
    }
    free(data);
}

/* A face on a line of more than 64 KB. */
static void test_long_face(void) {
    enum { CORNERS_OF_FACE = 30000 };
    struct bytes bytes = {0};
    struct model model;
    struct error error;
    CHECK(bytes_append(&bytes, SQUARE "f 1 2", strlen(SQUARE "f 1 2")));
    for (int i = 2; i < CORNERS_OF_FACE; i++) {
        CHECK(bytes_append(&bytes, i < CORNERS_OF_FACE - 1 ? " 3" : " 4", 2));
    }
    CHECK(model_decode(&model, bytes.data, bytes.size, &error));
    CHECK(model.face_count == CORNERS_OF_FACE - 2);
    CHECK(model.faces[CORNERS_OF_FACE - 3].corner[2].position == 3);
    model_free(&model);
    bytes_free(&bytes);
}

/* ---- Polygons ---- */

enum { POLYGON_LIMIT = 64 };

/* Whole-number corners, so that areas and sides are exact. */
struct polygon {
    size_t size;
    int64_t x[POLYGON_LIMIT], y[POLYGON_LIMIT];
};

static void polygon_add(struct polygon *p, int x, int y) {
    p->x[p->size] = x;
    p->y[p->size++] = y;
}

/* Twice the area of three corners; positive when counterclockwise. */
static int64_t area_of(const struct polygon *p, size_t a, size_t b, size_t c) {
    return (p->x[b] - p->x[a]) * (p->y[c] - p->y[a]) - (p->y[b] - p->y[a]) * (p->x[c] - p->x[a]);
}

static int64_t polygon_area(const struct polygon *p) {
    int64_t area = 0;
    for (size_t i = 0; i < p->size; i++) {
        size_t next = (i + 1) % p->size;
        area += p->x[i] * p->y[next] - p->y[i] * p->x[next];
    }
    return area;
}

/* Write the polygon as OBJ, laid into space by one of six permutations of the axes, on a slanted
 * plane, with its first corner anywhere, perhaps backwards. Position i is corner i. */
static void polygon_write(const struct polygon *p, struct bytes *bytes, bool backwards) {
    char line[128];
    int order = random_int(0, 5), a = random_int(-1, 1), b = random_int(-1, 1);
    bytes->size = 0;
    for (size_t i = 0; i < p->size; i++) {
        int64_t c[3] = {p->x[i], p->y[i], a * p->x[i] + b * p->y[i]};
        static const int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                         {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
        const int *o = orders[order];
        int length = snprintf(line, sizeof line, "v %" PRId64 " %" PRId64 " %" PRId64 "\n", c[o[0]],
                              c[o[1]], c[o[2]]);
        CHECK(bytes_append(bytes, line, (size_t)length));
    }
    CHECK(bytes_append(bytes, "f", 1));
    if (!CHECK(p->size > 0)) {
        return;
    }
    size_t first = random_bits() % p->size;
    for (size_t i = 0; i < p->size; i++) {
        size_t corner = (first + (backwards ? p->size - i : i)) % p->size;
        int length = snprintf(line, sizeof line, " %zu", corner + 1);
        CHECK(bytes_append(bytes, line, (size_t)length));
    }
}

/* The triangles cover the polygon exactly once: they are joined along the polygon's own sides and
 * cuts that two of them share (so their signed areas always add up to the polygon's), and none is
 * turned over (so they cannot overlap). Without `flat_ones`, none has area 0. */
static bool covers_exactly(const struct polygon *p, const struct model *m, bool backwards,
                           bool flat_ones) {
    static int sides[POLYGON_LIMIT][POLYGON_LIMIT];
    int64_t total = 0;
    memset(sides, 0, sizeof sides);
    for (size_t i = 0; i < m->face_count; i++) {
        size_t corner[3];
        for (int j = 0; j < 3; j++) {
            corner[j] = m->faces[i].corner[backwards ? 2 - j : j].position;
        }
        int64_t area = area_of(p, corner[0], corner[1], corner[2]);
        if (area < 0 || (area == 0 && !flat_ones)) {
            return false;
        }
        total += area;
        for (int j = 0; j < 3; j++) {
            sides[corner[j]][corner[(j + 1) % 3]]++;
            sides[corner[(j + 1) % 3]][corner[j]]--;
        }
    }
    for (size_t i = 0; i < p->size; i++) {
        sides[i][(i + 1) % p->size]--;
        sides[(i + 1) % p->size][i]++;
    }
    for (size_t i = 0; i < p->size; i++) {
        for (size_t j = 0; j < p->size; j++) {
            if (sides[i][j] != 0) {
                return false;
            }
        }
    }
    return total == polygon_area(p);
}

/* A row of points across, then one back above it: never crosses itself. */
static void make_monotone(struct polygon *p) {
    int count = random_int(2, 25);
    *p = (struct polygon){0};
    for (int i = 0; i < count; i++) {
        polygon_add(p, i * 10 + random_int(0, 9), random_int(-50, -1));
    }
    for (int i = count; i-- > 0;) {
        polygon_add(p, i * 10 + random_int(0, 9), random_int(1, 50));
    }
}

/* A frame with holes of three or four corners, each reached from the lower side by a cut that is
 * walked up to its lowest corner and down again. */
static void make_holes(struct polygon *p) {
    int holes = random_int(1, 6);
    *p = (struct polygon){0};
    polygon_add(p, 0, 0);
    for (int i = 0; i < holes; i++) {
        int left = 20 * i + random_int(1, 9), right = left + random_int(1, 9);
        int bottom = random_int(1, 50), top = bottom + random_int(1, 49);
        int base = random_int(20 * i + 1, 20 * i + 19), lean = random_int(0, top - bottom);
        bool square = random_int(0, 1) == 1;
        polygon_add(p, base, 0);
        polygon_add(p, left, bottom);
        polygon_add(p, left, top);
        if (square) {
            polygon_add(p, right, top);
        }
        polygon_add(p, right, bottom + (square ? 0 : lean));
        polygon_add(p, left, bottom);
        polygon_add(p, base, 0);
    }
    polygon_add(p, 20 * holes, 0);
    polygon_add(p, 20 * holes, 100);
    polygon_add(p, 0, 100);
}

/* A square whose outline comes back to its first corner and goes round a hole there. */
static void make_touching(struct polygon *p) {
    int x1, y1, x2, y2;
    do {
        x1 = random_int(1, 30);
        y1 = random_int(1, 30);
        x2 = random_int(1, 30);
        y2 = random_int(1, 30);
    } while (x1 * y2 - y1 * x2 >= 0);
    *p = (struct polygon){0};
    polygon_add(p, 0, 0);
    for (int i = random_int(0, 3); i > 0; i--) {
        polygon_add(p, 32 - 8 * i, random_int(-9, -1));
    }
    polygon_add(p, 31, 0);
    polygon_add(p, 31, 31);
    polygon_add(p, 0, 31);
    polygon_add(p, 0, 0);
    polygon_add(p, x1, y1);
    polygon_add(p, x2, y2);
}

/* A square with a hole that is reached from the lower side and touches the outline's last corner.
 */
static void make_touched(struct polygon *p) {
    int x1, y1, x2, y2;
    do {
        x1 = random_int(1, 30);
        y1 = random_int(1, 30);
        x2 = random_int(1, 30);
        y2 = random_int(y1, 30);
    } while (x1 * (y2 - 31) - (y1 - 31) * x2 <= 0); /* the hole must go round clockwise */
    *p = (struct polygon){0};
    polygon_add(p, 0, 0);
    polygon_add(p, 15, 0);
    polygon_add(p, x1, y1);
    polygon_add(p, 0, 31);
    polygon_add(p, x2, y2);
    polygon_add(p, x1, y1);
    polygon_add(p, 15, 0);
    polygon_add(p, 31, 0);
    polygon_add(p, 31, 31);
    polygon_add(p, 0, 31);
}

static int sign_of(int64_t value) {
    return (value > 0) - (value < 0);
}

static bool between(int64_t a, int64_t b, int64_t value) {
    return (a <= value && value <= b) || (b <= value && value <= a);
}

/* Do the sides from a and from b (not neighbours) share a point? */
static bool sides_meet(const struct polygon *p, size_t a, size_t b) {
    size_t a2 = (a + 1) % p->size, b2 = (b + 1) % p->size;
    int s1 = sign_of(area_of(p, a, a2, b)), s2 = sign_of(area_of(p, a, a2, b2));
    int s3 = sign_of(area_of(p, b, b2, a)), s4 = sign_of(area_of(p, b, b2, a2));
    if (s1 == 0 && s2 == 0) {
        return between(p->x[a], p->x[a2], p->x[b]) || between(p->x[a], p->x[a2], p->x[b2]) ||
               between(p->x[b], p->x[b2], p->x[a]);
    }
    return s1 * s2 <= 0 && s3 * s4 <= 0;
}

static void swap_corners(struct polygon *p, size_t a, size_t b) {
    int64_t x = p->x[a], y = p->y[a];
    p->x[a] = p->x[b];
    p->y[a] = p->y[b];
    p->x[b] = x;
    p->y[b] = y;
}

/* Two sides that meet, or false. */
static bool find_meeting(const struct polygon *p, size_t *a, size_t *b) {
    for (*a = 0; *a < p->size; ++*a) {
        for (*b = *a + 2; *b < p->size; ++*b) {
            if (!(*a == 0 && *b == p->size - 1) && sides_meet(p, *a, *b)) {
                return true;
            }
        }
    }
    return false;
}

/* Random points; where two sides cross, the way between them is turned round until none do. False
 * when that does not come to an end, or two corners meet. */
static bool make_uncrossed(struct polygon *p) {
    size_t size = (size_t)random_int(4, 16), a, b;
    int range = random_int(4, 40);
    *p = (struct polygon){0};
    for (size_t i = 0; i < size; i++) {
        polygon_add(p, random_int(0, range), random_int(0, range));
    }
    for (int tries = 0; tries < 300; tries++) {
        if (!find_meeting(p, &a, &b)) {
            for (size_t i = 0; i < size; i++) { /* no spikes: neighbours may overlap too */
                size_t next = (i + 1) % size, last = (i + 2) % size;
                if (area_of(p, i, next, last) == 0 &&
                    (p->x[i] - p->x[next]) * (p->x[last] - p->x[next]) +
                            (p->y[i] - p->y[next]) * (p->y[last] - p->y[next]) >=
                        0) {
                    return false;
                }
            }
            if (polygon_area(p) < 0) {
                for (size_t i = 0; i < size / 2; i++) {
                    swap_corners(p, i, size - 1 - i);
                }
            }
            return true;
        }
        for (size_t i = a + 1, j = b; i < j; i++, j--) {
            swap_corners(p, i, j);
        }
    }
    return false;
}

static void check_polygon(const struct polygon *p, bool flat_ones, const char *kind) {
    struct bytes bytes = {0};
    struct model m;
    struct error error;
    bool backwards = random_int(0, 1) == 1;
    polygon_write(p, &bytes, backwards);
    if (CHECK_ROW(model_decode(&m, bytes.data, bytes.size, &error), kind)) {
        CHECK_ROW(m.face_count == p->size - 2, kind);
        if (!CHECK_ROW(covers_exactly(p, &m, backwards, flat_ones), kind)) {
            fprintf(stderr, "%.*s\n", (int)bytes.size, (const char *)bytes.data);
        }
        model_free(&m);
    }
    bytes_free(&bytes);
}

/* The fan of a convex polygon may have triangles without area, where three corners lie on a line.
 */
static bool is_convex(const struct polygon *p) {
    for (size_t i = 0; i < p->size; i++) {
        if (area_of(p, i, (i + 1) % p->size, (i + 2) % p->size) < 0) {
            return false;
        }
    }
    return true;
}

static void test_polygons(void) {
    struct polygon p;
    int uncrossed = 0;
    for (int i = 0; i < 1000; i++) {
        make_monotone(&p);
        check_polygon(&p, is_convex(&p), "monotone");
        make_holes(&p);
        check_polygon(&p, true, "holes");
        make_touching(&p);
        check_polygon(&p, true, "touching");
        make_touched(&p);
        check_polygon(&p, true, "touched");
        if (make_uncrossed(&p)) {
            check_polygon(&p, is_convex(&p), "uncrossed");
            uncrossed++;
        }
    }
    CHECK(uncrossed > 300);
}

/* Polygons that cross themselves, turn back or stand still: no special answer is asked for, but
 * n - 2 triangles of their own corners are, soon. */
static void test_wild_polygons(void) {
    for (int i = 0; i < 2000; i++) {
        struct polygon p = {0};
        struct bytes bytes = {0};
        struct model m;
        struct error error;
        int size = random_int(4, POLYGON_LIMIT), range = random_int(0, 6);
        for (int k = 0; k < size; k++) {
            polygon_add(&p, random_int(0, range), random_int(0, range));
        }
        polygon_write(&p, &bytes, false);
        if (CHECK(model_decode(&m, bytes.data, bytes.size, &error))) {
            CHECK(m.face_count == p.size - 2);
            for (size_t k = 0; k < m.face_count; k++) {
                const struct corner *c = m.faces[k].corner;
                CHECK(c[0].position != c[1].position && c[1].position != c[2].position &&
                      c[0].position != c[2].position);
            }
            model_free(&m);
        }
        bytes_free(&bytes);
    }
}

/* A sawtooth of many corners: quick, and whole. The exact area is known. */
static void test_large_polygon(void) {
    enum { TEETH = 2500 };
    struct bytes bytes = {0};
    struct model m;
    struct error error;
    char line[64];
    for (int i = 0; i <= 2 * TEETH; i++) {
        int length = snprintf(line, sizeof line, "v %d %d 7\n", i, i % 2);
        CHECK(bytes_append(&bytes, line, (size_t)length));
    }
    int length = snprintf(line, sizeof line, "v %d -1 7\nv 0 -1 7\nf", 2 * TEETH);
    CHECK(bytes_append(&bytes, line, (size_t)length));
    for (int i = 2 * TEETH + 3; i > 0; i--) {
        length = snprintf(line, sizeof line, " %d", i);
        CHECK(bytes_append(&bytes, line, (size_t)length));
    }
    if (CHECK(model_decode(&m, bytes.data, bytes.size, &error))) {
        double area = 0, absolute = 0;
        for (size_t i = 0; i < m.face_count; i++) {
            struct vec3 a = model_position(&m, i, 0);
            double twice = vec3_cross(vec3_sub(model_position(&m, i, 1), a),
                                      vec3_sub(model_position(&m, i, 2), a))
                               .z;
            area += twice;
            absolute += fabs(twice);
        }
        CHECK(m.face_count == 2 * TEETH + 1);
        CHECK(area == absolute && area == 2.0 * (2 * TEETH + TEETH));
        model_free(&m);
    }
    bytes_free(&bytes);
}

/* ---- Normals ---- */

static void test_angles(void) {
    const long double pi = 3.14159265358979323846L;
    for (int i = 0; i < 20000; i++) {
        /* Angles of every size, also near 0 and pi: b is a, plus something large or tiny. */
        double size = pow(10, random_int(-12, 2)), sign = random_int(0, 1) == 0 ? 1 : -1;
        struct vec3 a = {random_unit(), random_unit(), random_unit()};
        struct vec3 b = {sign * a.x + size * random_unit(), sign * a.y + size * random_unit(),
                         sign * a.z + size * random_unit()};
        long double x = (long double)a.y * b.z - (long double)a.z * b.y;
        long double y = (long double)a.z * b.x - (long double)a.x * b.z;
        long double z = (long double)a.x * b.y - (long double)a.y * b.x;
        long double dot = (long double)a.x * b.x + (long double)a.y * b.y + (long double)a.z * b.z;
        long double expected = atan2l(sqrtl(x * x + y * y + z * z), dot);
        CHECK(fabsl((long double)model_angle(a, b) - expected) < 1e-15L * pi);
    }
    struct vec3 zero = {0, 0, 0}, across = {1, 0, 0}, back = {-3, 0, 0}, up = {0, 1e-300, 0};
    CHECK(model_angle(zero, across) == 0 && model_angle(zero, zero) == 0);
    CHECK(model_angle(across, across) == 0);
    CHECK(fabsl(model_angle(across, back) - pi) < 1e-15L * pi);
    CHECK(fabsl(model_angle(across, up) - pi / 2) < 1e-15L * pi);
}

/* The sum over the faces around a position of their unit normals times their angles, by acosl(). */
static void normal_by_definition(const struct model *m, uint32_t position, long double sum[3]) {
    sum[0] = sum[1] = sum[2] = 0;
    for (size_t i = 0; i < m->face_count; i++) {
        for (int j = 0; j < 3; j++) {
            if (m->faces[i].corner[j].position != position) {
                continue;
            }
            long double u[3], v[3], n[3], uu = 0, vv = 0, uv = 0, nn = 0;
            const float *at = m->positions[position];
            const float *to = m->positions[m->faces[i].corner[(j + 1) % 3].position];
            const float *from = m->positions[m->faces[i].corner[(j + 2) % 3].position];
            for (int k = 0; k < 3; k++) {
                u[k] = (long double)to[k] - at[k];
                v[k] = (long double)from[k] - at[k];
                uu += u[k] * u[k];
                vv += v[k] * v[k];
                uv += u[k] * v[k];
            }
            for (int k = 0; k < 3; k++) {
                n[k] = u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
                nn += n[k] * n[k];
            }
            if (nn > 0) {
                long double angle = acosl(fminl(1, fmaxl(-1, uv / sqrtl(uu * vv))));
                for (int k = 0; k < 3; k++) {
                    sum[k] += n[k] / sqrtl(nn) * angle;
                }
            }
        }
    }
}

static void test_normals(void) {
    for (int round = 0; round < 40; round++) {
        struct bytes bytes = {0};
        struct model m;
        struct error error;
        char line[128];
        double scale = pow(10, random_int(-10, 10));
        for (int i = 0; i < 20; i++) {
            int length = snprintf(line, sizeof line, "v %.9g %.9g %.9g\n", scale * random_unit(),
                                  scale * random_unit(), scale * random_unit());
            CHECK(bytes_append(&bytes, line, (size_t)length));
        }
        CHECK(bytes_append(&bytes, "vn 5 6 7\n", 9));
        for (int i = 0; i < 30; i++) { /* every tenth face brings a normal of its own */
            const char *own = i % 10 == 9 ? "//1" : "";
            int a = random_int(1, 20), b = random_int(1, 20), c = random_int(1, 20);
            int length = snprintf(line, sizeof line, "f %d%s %d%s %d%s\n", a, own, b, own, c, own);
            CHECK(bytes_append(&bytes, line, (size_t)length));
        }
        if (CHECK(model_decode(&m, bytes.data, bytes.size, &error)) &&
            CHECK(model_need_normals(&m, &error))) {
            size_t count = m.normal_count;
            CHECK(count > 1 && count <= 21 && same3(m.normals[0], 5, 6, 7));
            for (size_t i = 0; i < m.face_count; i++) {
                for (size_t j = 0; j < 3; j++) {
                    const struct corner *c = &m.faces[i].corner[j];
                    if (!CHECK(c->normal < m.normal_count) || i % 10 == 9) {
                        CHECK(c->normal == 0);
                        continue;
                    }
                    long double sum[3];
                    normal_by_definition(&m, c->position, sum);
                    long double length = sqrtl(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
                    const float *n = m.normals[c->normal];
                    if (length < 1e-3L) { /* nearly cancelled: its direction is mere noise */
                        CHECK(fabs((double)n[0] * n[0] + (double)n[1] * n[1] + (double)n[2] * n[2] -
                                   1) < 1e-6);
                        continue;
                    }
                    for (int k = 0; k < 3; k++) {
                        CHECK(fabsl(n[k] - sum[k] / length) < 1e-7L);
                    }
                }
            }
            CHECK(model_need_normals(&m, &error) && m.normal_count == count);
        }
        model_free(&m);
        bytes_free(&bytes);
    }
}

/* A corner of a cube made of three squares, one of them cut the other way: weighted by angle, its
 * normal is the diagonal however the squares are cut; weighted by area it would not be. */
static void test_cube_corner(void) {
    static const char text[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 1 0\nv 0 1 1\nv 1 0 1\n"
                               "f 1 3 5\nf 1 5 2\nf 4 6 1\nf 6 3 1\nf 1 2 7 4\n";
    struct model m;
    struct error error;
    if (CHECK(decode(&m, text, &error)) && CHECK(model_need_normals(&m, &error))) {
        struct vec3 n = model_normal(&m, 0, 0);
        double diagonal = -sqrt(1.0 / 3);
        CHECK(fabs(n.x - diagonal) < 1e-7 && fabs(n.y - diagonal) < 1e-7 &&
              fabs(n.z - diagonal) < 1e-7);
    }
    model_free(&m);
}

static void test_no_normal(void) {
    static const char text[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 3e38 3e38 3e38\nv -3e38 1e-45 3e38\n"
                               "v 2 0 0\nf 1 2 3\nf 1 3 2\nf 1 4 5\nf 2 6 2\n";
    struct model m;
    struct error error;
    if (!CHECK(decode(&m, text, &error)) || !CHECK(model_need_normals(&m, &error))) {
        return;
    }
    struct vec3 both_sides = model_normal(&m, 0, 2), degenerate = model_normal(&m, 3, 1);
    CHECK(both_sides.x == 0 && both_sides.y == 0 && both_sides.z == 1);
    CHECK(degenerate.x == 0 && degenerate.y == 0 && degenerate.z == 1);
    for (size_t i = 0; i < m.normal_count; i++) {
        CHECK(isfinite(m.normals[i][0]) && isfinite(m.normals[i][1]) && isfinite(m.normals[i][2]));
    }
    model_free(&m);
}

/* Two faces back to back: what rounding leaves of their normals is not taken for a direction. */
static void test_back_to_back(void) {
    for (int i = 0; i < 50; i++) {
        char text[400];
        struct model m;
        struct error error;
        size_t used = 0;
        for (int k = 0; k < 3; k++) {
            used += (size_t)snprintf(text + used, sizeof text - used, "v %.9g %.9g %.9g\n",
                                     random_unit(), random_unit(), random_unit());
        }
        snprintf(text + used, sizeof text - used, "f 1 2 3\nf 3 2 1\n");
        if (CHECK(decode(&m, text, &error)) && CHECK(model_need_normals(&m, &error))) {
            for (size_t k = 0; k < 3; k++) {
                struct vec3 n = model_normal(&m, 0, k);
                CHECK(n.x == 0 && n.y == 0 && n.z == 1);
            }
        }
        model_free(&m);
    }
}

static void test_colors_from_normals(void) {
    static const char text[] = SQUARE "v 9 9 9\nvn 0 0 -5\nvn 3 0 4\nvn 0 0 0\n"
                                      "f 1//1 2//2 3//3\nf 1//2 3//2 4\n";
    struct model m;
    struct error error;
    if (!CHECK(decode(&m, text, &error)) || !CHECK(model_colors_from_normals(&m, &error))) {
        return;
    }
    CHECK(same3(m.colors[0], 0.5F, 0.5F, 0)); /* the first face decides */
    CHECK(same3(m.colors[1], 0.8F, 0.5F, 0.9F));
    CHECK(same3(m.colors[2], 0.5F, 0.5F, 0.5F)); /* a normal without length */
    CHECK(same3(m.colors[3], 0.5F, 0.5F, 1));    /* computed */
    CHECK(same3(m.colors[4], 0.5F, 0.5F, 0.5F)); /* of no face */
    model_free(&m);
}

/* Colours that the file gives are replaced. */
static void test_colors_replaced(void) {
    struct model m;
    struct error error;
    if (CHECK(decode(&m, "v 0 0 0 1 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", &error))) {
        CHECK(same3(m.colors[0], 1, 0, 0));
        CHECK(model_colors_from_normals(&m, &error));
        CHECK(same3(m.colors[0], 0.5F, 0.5F, 1));
    }
    model_free(&m);
}

/* ---- Files ---- */

static bool write_text(const char *path, const char *text) {
    struct error error;
    return file_write(path, text, strlen(text), &error);
}

static bool write_image(const char *path, uint8_t level, bool png) {
    struct image image;
    struct error error;
    bool done = image_create(&image, 2, 2, IMAGE_GREY, &error);
    image_clear(&image, color_grey(level));
    done = done && (png ? png_write(&image, path, &error) : tga_write(&image, path, &error));
    image_free(&image);
    return done;
}

static void test_files(void) {
    char directory[] = COURSE_BUILD "/test_model.XXXXXX", path[400], expected[500];
    struct model m;
    struct error error;
    if (!CHECK(mkdtemp(directory) != NULL)) {
        return;
    }
    CHECK(!model_read(&m, directory, &error) && m.faces == NULL);
    snprintf(expected, sizeof expected, "%s: is a directory", directory);
    CHECK_TEXT(error.message, expected);
    snprintf(path, sizeof path, "%s/a.obj", directory);
    CHECK(!model_read(&m, path, &error) && strstr(error.message, "a.obj: ") != NULL);
    CHECK(write_text(path, SQUARE "f 1 2 99\n") && !model_read(&m, path, &error));
    snprintf(expected, sizeof expected, "%s:5: face names vertex 99 of 4", path);
    CHECK_TEXT(error.message, expected);
    CHECK(write_text(path, "") && !model_read(&m, path, &error));
    snprintf(expected, sizeof expected, "%s: holds no faces", path);
    CHECK_TEXT(error.message, expected);
    CHECK(write_text(path, SQUARE "f 1 2 3\n") && model_read(&m, path, &error));
    CHECK(m.path != NULL && m.path != path);
    if (m.path != NULL) {
        CHECK_TEXT(m.path, path);
    }
    model_free(&m);
    CHECK(unlink(path) == 0 && rmdir(directory) == 0);
}

/* Found beside the model as TGA before PNG, read once and only when asked for. */
static void test_textures(void) {
    char directory[] = COURSE_BUILD "/test_model.XXXXXX", path[400], tga[400], png[400],
         expected[500];
    struct model m;
    struct error error;
    if (!CHECK(mkdtemp(directory) != NULL)) {
        return;
    }
    snprintf(path, sizeof path, "%s/a.b.off", directory);
    snprintf(tga, sizeof tga, "%s/a.b_diffuse.tga", directory);
    snprintf(png, sizeof png, "%s/a.b_diffuse.png", directory);
    CHECK(write_text(path, "OFF 1 1 0\n0 0 0\n3 0 0 0\n"));
    CHECK(write_text(tga, "not an image"));
    CHECK(model_read(&m, path, &error)); /* textures are not looked at yet */
    CHECK(model_texture(&m, MODEL_DIFFUSE, &error) == NULL);
    CHECK(strncmp(error.message, tga, strlen(tga)) == 0);
    CHECK(write_image(tga, 10, false) && write_image(png, 20, true));
    const struct texture *texture = model_texture(&m, MODEL_DIFFUSE, &error);
    if (CHECK(texture != NULL)) {
        CHECK(texture->level[0].width == 2 && (texture->level[1].texels[0] & 0xFF) == 10);
    }
    CHECK(unlink(tga) == 0);
    CHECK(model_texture(&m, MODEL_DIFFUSE, &error) == texture); /* kept */
    CHECK(texture != NULL && (texture->level[1].texels[0] & 0xFF) == 10);
    model_free(&m);
    CHECK(m.textures[MODEL_DIFFUSE].level_count == 0);
    CHECK(model_read(&m, path, &error));
    texture = model_texture(&m, MODEL_DIFFUSE, &error);
    CHECK(texture != NULL && (texture->level[0].texels[0] & 0xFF) == 20);
    CHECK(model_texture(&m, MODEL_NORMAL_MAP, &error) == NULL);
    snprintf(expected, sizeof expected, "%s/a.b_nm.tga: no such file, nor the same as .png",
             directory);
    CHECK_TEXT(error.message, expected);
    CHECK(model_texture(&m, MODEL_SPECULAR, &error) == NULL);
    CHECK(strstr(error.message, "a.b_spec.tga") != NULL);
    model_free(&m);
    CHECK(unlink(png) == 0 && unlink(path) == 0 && rmdir(directory) == 0);
    CHECK(decode(&m, SQUARE "f 1 2 3", &error) && model_texture(&m, MODEL_DIFFUSE, &error) == NULL);
    model_free(&m);
}

/* The names of textures of a model without directory, without extension, and of a hidden file. */
static void test_texture_names(void) {
    static const char *const rows[][2] = {{"no_such_model.obj", "no_such_model_spec.tga"},
                                          {"no_such_model", "no_such_model_spec.tga"},
                                          {".no_such_model", ".no_such_model_spec.tga"}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct model m;
        struct error error;
        char expected[100];
        if (!CHECK(decode(&m, SQUARE "f 1 2 3", &error))) {
            return;
        }
        m.path = malloc(strlen(rows[i][0]) + 1);
        if (CHECK(m.path != NULL)) {
            strcpy(m.path, rows[i][0]);
            CHECK(model_texture(&m, MODEL_SPECULAR, &error) == NULL);
            snprintf(expected, sizeof expected, "%s: no such file, nor the same as .png",
                     rows[i][1]);
            CHECK_TEXT(error.message, expected);
        }
        model_free(&m);
    }
}

/* A corner that turns right by 2^-100, less than doubles can tell without exact arithmetic: cut as
 * if it were straight, there would be a face of these three corners, turned over. */
static void test_hardly_concave(void) {
    static const char text[] = "v 7.888609052210118e-31 0 0\nv 1 1 0\nv 2 2 0\nv 0 3 0\n";
    struct model m;
    struct error error;
    char with_face[200], faces[200];
    for (int first = 0; first < 4; first++) {
        snprintf(with_face, sizeof with_face, "%sf %d %d %d %d\n", text, first + 1,
                 (first + 1) % 4 + 1, (first + 2) % 4 + 1, (first + 3) % 4 + 1);
        if (CHECK(decode(&m, with_face, &error)) && CHECK(m.face_count == 2)) {
            describe_faces(&m, faces, sizeof faces);
            for (size_t i = 0; i < 2; i++) { /* both faces have the last corner, d, and b */
                bool has_b = false, has_d = false;
                for (int j = 0; j < 3; j++) {
                    has_b = has_b || m.faces[i].corner[j].position == 1;
                    has_d = has_d || m.faces[i].corner[j].position == 3;
                }
                CHECK_ROW(has_b && has_d, faces);
            }
        }
        model_free(&m);
    }
}

/* One corner more than a face that is not convex may have. */
static void test_too_many_corners(void) {
    enum { CORNERS_LIMIT = 131072 };
    static const char points[] = "v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\nf";
    struct bytes text = {0};
    struct model m;
    struct error error;
    CHECK(bytes_append(&text, points, strlen(points)));
    for (int i = 0; i <= CORNERS_LIMIT; i++) {
        const char corner[] = {' ', (char)('1' + i % 4)};
        if (!bytes_append(&text, corner, sizeof corner)) {
            break;
        }
    }
    CHECK(!model_decode(&m, text.data, text.size, &error));
    CHECK_TEXT(error.message, "5: face of 131073 corners: one that is not convex may have 131072");
    bytes_free(&text);
}

UNIT_MAIN(TEST(test_obj_faces), TEST(test_obj_numbers), TEST(test_obj_many_colors), TEST(test_off),
          TEST(test_messages), TEST(test_long_lines), TEST(test_long_face), TEST(test_polygons),
          TEST(test_wild_polygons), TEST(test_large_polygon), TEST(test_angles), TEST(test_normals),
          TEST(test_cube_corner), TEST(test_no_normal), TEST(test_back_to_back),
          TEST(test_colors_from_normals), TEST(test_files), TEST(test_textures),
          TEST(test_colors_replaced), TEST(test_texture_names), TEST(test_hardly_concave),
          TEST(test_too_many_corners))
