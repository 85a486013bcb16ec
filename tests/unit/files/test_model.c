/* Models: what is read of OBJ and OFF, the message for everything that is refused, textures beside
 * the model. */
#define _XOPEN_SOURCE 700 /* POSIX.1-2008 with mkdtemp() */

#include "base/file.h"
#include "files/model_file.h"
#include "files/obj.h"
#include "files/png.h"
#include "model.h"
#include "unit/images.h"
#include "unit/place.h"

#include <math.h>
#include <stdlib.h>
#include <unistd.h>

/* Read the text, from memory of just its size. */
static bool decode(struct model *model, const char *text, struct error *error) {
    size_t size = strlen(text);
    char *copy = exact_copy(text, size);
    bool done = model_decode(model, copy, size, error);
    free(copy);
    return done;
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
        {"byte-order mark", "\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3", TRIANGLE},
        {"v/vt", SQUARE CORNERS "f 1/1 2/2 3/3\n", "0/0/-,1/1/-,2/2/-"},
        {"v//vn", SQUARE CORNERS "f 1//1 2//2 3//1\n", "0/-/0,1/-/1,2/-/0"},
        {"v/vt/vn", SQUARE CORNERS "f 1/3/2 2/2/1 4/1/2\n", "0/2/1,1/1/0,3/0/1"},
        {"mixed in a face", SQUARE CORNERS "f 1 2/2 3//1\n", "0/-/-,1/1/-,2/-/0"},
        {"negative", SQUARE CORNERS "f -4/-3/-2 -3/-2/-1 -1/-1/-1\n", "0/0/0,1/1/1,3/2/1"},
        {"negative is from here", SQUARE "f -3 -2 -1\nv 5 5 5\nf -3 -2 -1\n",
         "1/-/-,2/-/-,3/-/- 2/-/-,3/-/-,4/-/-"},
        {"vertices further down", "f 1 2 3\n" SQUARE, TRIANGLE},
        {"vertices further down, then negative",
         "v 9 9 9\nf 1 2 3\n" SQUARE "f -4 -3 -2\nv 7 7 7\n",
         "0/-/-,1/-/-,2/-/- 1/-/-,2/-/-,3/-/-"},
        {"attributes further down", SQUARE "f 1/1/1 2/2/2 3/3/1\n" CORNERS, "0/0/0,1/1/1,2/2/0"},
        {"plus sign, leading zeros", SQUARE "f +1 002 3\n", TRIANGLE},
        {"square", SQUARE "f 1 2 3 4\n", "0/-/-,1/-/-,2/-/- 0/-/-,2/-/-,3/-/-"},
        {"corners keep their attributes", SQUARE CORNERS "f 1/1/1 2/2/1 3/3/1 4/1/2\n",
         "0/0/0,1/1/0,2/2/0 0/0/0,2/2/0,3/0/1"},
        {"arrow: the inner corner 4 must be on the cut",
         "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 1 1 0\nf 1 2 4 3\n", "0/-/-,1/-/-,3/-/- 0/-/-,3/-/-,2/-/-"},
        {"polylines and points are no faces", SQUARE "l 1 2 3 4\np 1\nf 1 2 3\nl 1 2 3\n",
         TRIANGLE},
        {"unknown words",
         "mtllib a.mtl\no x\ng y z\ns off\nusemtl m\nvp 1 2\n" SQUARE
         "cstype bezier\nf 1 2 3\nfoo # bar\nfacet 1 2\nvv 1\n",
         TRIANGLE},
        {"comments", "# v 9 9 9\n" SQUARE "f 1 2 3 # 4\n#f 1 2 3\n", TRIANGLE},
        {"continued face", SQUARE "f 1 \\\n2\\\n \\\r\n3\n", TRIANGLE},
        {"continued vertex", "v 0 0 \\\n 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", TRIANGLE},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct model model;
        struct error error = {0};
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
    return a != NULL && a[0] == x && a[1] == y && a[2] == z;
}

static bool at(const struct model *model, size_t position, double x, double y, double z) {
    struct vec3 p = model->positions[position];
    return p.x == x && p.y == y && p.z == z;
}

static void test_obj_numbers(void) {
    static const char text[] = "v 1 -2 .5\nv 1e2 5. -1E-2 7\nv 0.1 0.2 0.3 0.25 -1 1.5\n"
                               "v 16777217 1e-30 -0\nvt 0.5\nvt 2 -3\nvt 1 2 3\nvn 0 3 4\n"
                               "f 1 2 3\n";
    struct model m;
    struct error error;
    if (!CHECK(decode(&m, text, &error))) {
        return;
    }
    CHECK(m.position_count == 4 && m.uv_count == 3 && m.normal_count == 1 && m.face_count == 1);
    CHECK(at(&m, 0, 1, -2, 0.5) && at(&m, 1, 100, 5, -0.01) && at(&m, 2, 0.1, 0.2, 0.3));
    CHECK(at(&m, 3, 16777217, 1e-30, 0)); /* the first is no float */
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
    CHECK(decode(&m, SQUARE "v 1 2 3 4\nv 1 2 3 4 5\nf 1 2 3\n", &error) && m.colors == NULL);
    model_free(&m);
}

static void test_off(void) {
    static const struct {
        const char *name, *text, *faces;
    } rows[] = {
        {"plain", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n", TRIANGLE},
        {"counts on the first line", "OFF 3 1 3\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2", TRIANGLE},
        {"no blank after OFF", "OFF3 1 3\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2", TRIANGLE},
        {"no number of edges", "OFF\n3 1\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2", TRIANGLE},
        {"number of edges on the next line", "OFF\n3 2\n0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n3 0 1 2\n",
         TRIANGLE " " TRIANGLE},
        {"number of edges on the next line that is not empty",
         "OFF\n3 1 #\n\n# edges\n5 # 5\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n", TRIANGLE},
        {"number of edges before the first vertex", "OFF\n3 1\n3 0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n",
         TRIANGLE},
        {"number of edges, and a vertex that looks like a face",
         "OFF\n4 1\n3\n0 0 0\n1 0 0\n1 1 0\n0 1 3\n3 0 1 2\n", TRIANGLE},
        {"no number of edges, a word on each line",
         "OFF\n3 1\n0\n0\n0\n1\n0\n0\n1\n1\n0\n3\n0\n1\n2\n", TRIANGLE},
        {"numbers on two lines, none of edges", "OFF\n3\n1\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n",
         TRIANGLE},
        {"a word on each line", "OFF\n3\n1\n0\n0\n0\n0\n1\n0\n0\n1\n1\n0\n3\n0\n1\n2\n", TRIANGLE},
        {"all on one line", "OFF 3 1 0 0 0 0 1 0 0 1 1 0 3 0 1 2", TRIANGLE},
        {"lines that end anywhere", "OFF 3\n1 0 0 0\n0 1 0 0 1\n1 0 3 0\n1 2 0.5 0.5 0.5\n",
         TRIANGLE},
        {"colours, lines that end anywhere",
         "COFF\n3 1 0\n0 0\n0 255 0 0 255\n1 0 0 0\n51 0\n1 1 0 0 0 255 0\n3 0\n1 2\n", TRIANGLE},
        {"comments and empty lines",
         "# made by hand\n\nOFF # what\n\n# x\n3 1 0 # y\n0 0 0\n\n1 0 0 # z\n1 1 0\n\n#\n3 0 1 2 "
         "#\n",
         TRIANGLE},
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
        struct error error = {0};
        char faces[512];
        if (!CHECK_ROW(decode(&m, rows[i].text, &error), rows[i].name)) {
            fprintf(stderr, "    %s\n", error.message);
            continue;
        }
        describe_faces(&m, faces, sizeof faces);
        CHECK_TEXT(faces, rows[i].faces);
        CHECK_ROW(at(&m, 1, 1, 0, 0) && at(&m, 2, 1, 1, 0), rows[i].name);
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

/* ---- Colours of OFF faces ---- */

/* Triangles in a row over three vertices, each line of `faces` one of them. */
static bool decode_off_faces(struct model *model, const char *faces, struct error *error) {
    char text[600];
    size_t count = 0;
    for (const char *p = faces; *p != '\0'; p++) {
        count += *p == '\n';
    }
    snprintf(text, sizeof text, "OFF %zu %zu\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n%s", (size_t)4, count,
             faces);
    return decode(model, text, error);
}

/* As few bytes as vertices and faces can have are enough for the numbers in the first line. */
static void test_off_smallest(void) {
    char text[400] = "OFF 40 1 0\n";
    struct model m;
    struct error error;
    for (int i = 0; i < 40; i++) {
        strcat(text, "0 0 0\n");
    }
    strcat(text, "3 0 1 2");
    CHECK(decode(&m, text, &error) && m.position_count == 40 && m.face_count == 1);
    model_free(&m);
    strcpy(text, "OFF 3 81 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    for (int i = 0; i < 80; i++) {
        strcat(text, "0\n"); /* faces without corners */
    }
    CHECK(decode(&m, text, &error) && m.position_count == 3 && m.face_count == 1);
    model_free(&m);
}

/* A polygon's colour is that of all its triangles; what has none is white, wherever it stands. */
static void test_face_colors(void) {
    struct model m;
    struct error error = {0};
    if (!CHECK(decode_off_faces(&m,
                                "3 0 1 2\n4 0 1 2 3 255 0 51\n2 0 1 9 9 9\n3 0 1 2 7\n"
                                "3 2 1 0 0.5 0.25 1 0.5 # and alpha\n3 0 1 2\n3 0 1 2\n",
                                &error))) {
        fprintf(stderr, "    %s\n", error.message);
        return;
    }
    CHECK(m.face_count == 7 && m.colors == NULL);
    if (CHECK(m.face_colors != NULL)) {
        CHECK(same3(m.face_colors[0], 1, 1, 1));
        CHECK(same3(m.face_colors[1], 1, 0, 0.2F) && same3(m.face_colors[2], 1, 0, 0.2F));
        CHECK(same3(m.face_colors[3], 1, 1, 1)); /* an index is not used */
        CHECK(same3(m.face_colors[4], 0.5F, 0.25F, 1));
        CHECK(same3(m.face_colors[5], 1, 1, 1) && same3(m.face_colors[6], 1, 1, 1));
    }
    model_free(&m);
    CHECK(m.face_colors == NULL);
    CHECK(decode_off_faces(&m, "3 0 1 2\n3 2 1 0 5\n", &error) && m.face_colors == NULL);
    struct vec3 color = model_color(&m, 1, 2);
    CHECK(color.x == 1 && color.y == 1 && color.z == 1);
    model_free(&m);
}

/* Whole numbers are levels, fractions are not; whatever they are, 0..1 comes out. */
static void test_face_color_values(void) {
    static const struct {
        const char *numbers;
        float r, g, b;
    } rows[] = {
        {"0 128 255", 0, 128.0F / 255, 1},
        {"1 1 1", 1.0F / 255, 1.0F / 255, 1.0F / 255},
        {"+051 0 0 255", 0.2F, 0, 0},
        {"1.0 1 0", 1, 1, 0},
        {"1 0 1 0.5", 1, 0, 1}, /* the alpha tells that all are fractions */
        {"1e0 0 0", 1, 0, 0},
        {"256 -1 -0", 1, 0, 0},
        {"99999999999999999999 51 -99999999999999999999", 1, 0.2F, 0},
        {"1.5 -0.5 3e38", 1, 0, 1},
        {"1e-45 1e-400 -1e-400", 1e-45F, 0, 0},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        char line[100];
        struct model m;
        struct error error = {0};
        snprintf(line, sizeof line, "3 0 1 2 %s\n", rows[i].numbers);
        if (CHECK_ROW(decode_off_faces(&m, line, &error), rows[i].numbers) &&
            CHECK_ROW(m.face_colors != NULL, rows[i].numbers)) {
            CHECK_ROW(same3(m.face_colors[0], rows[i].r, rows[i].g, rows[i].b), rows[i].numbers);
            CHECK_ROW(!signbit(m.face_colors[0][2]), rows[i].numbers);
        }
        model_free(&m);
    }
}

/* The colour of a face hides those of its corners. */
static void test_colors_of_both(void) {
    static const char text[] = "COFF 3 2\n0 0 0 0 0 1\n1 0 0 0 1 0\n0 1 0 1 0 0\n";
    char both[200];
    struct model m;
    struct error error;
    snprintf(both, sizeof both, "%s3 0 1 2\n3 0 1 2 0.5 0.5 0.5\n", text);
    if (CHECK(decode(&m, both, &error)) && CHECK(m.colors != NULL)) {
        struct vec3 bare = model_color(&m, 0, 1), colored = model_color(&m, 1, 1);
        CHECK(bare.x == 1 && bare.y == 1 && bare.z == 1);
        CHECK(colored.x == 0.5 && colored.y == 0.5 && colored.z == 0.5);
        CHECK(same3(m.colors[1], 0, 1, 0));
    }
    model_free(&m);
    snprintf(both, sizeof both, "%s3 0 1 2\n3 2 1 0\n", text);
    if (CHECK(decode(&m, both, &error)) && CHECK(m.face_colors == NULL)) {
        struct vec3 color = model_color(&m, 1, 0);
        CHECK(color.x == 1 && color.y == 0 && color.z == 0);
    }
    model_free(&m);
}

/* ---- What is refused ---- */

static void test_messages(void) {
    static const struct {
        const char *text, *message;
    } rows[] = {
        {"", "holds no faces"},
        {"\n# nothing\n", "holds no faces"},
        {SQUARE, "holds no faces"},
        {"just some words\nand more of them", "holds no faces"},
        {SQUARE "\nf 1 2 0\n", "6: face names vertex 0: the first is 1"},
        {SQUARE "f 1 2 5\n", "5: face names vertex 5 of 4"},
        {SQUARE "f 1 2 4294967296\n", "5: face names vertex 4294967296 of 4"},
        {SQUARE "f 1 2 -4294967295\n", "5: face names vertex -4294967295 of 4"},
        {SQUARE "f 1 2 18446744073709551617\n", "5: face names vertex 18446744073709551617 of 4"},
        {SQUARE "f 1 2 -99999999999999999999\n", "5: face names vertex -99999999999999999999 of 4"},
        {SQUARE "f 1 2 -99999999999999999999\nv 1 1 1\n", /* only those above count */
         "5: face names vertex -99999999999999999999 of 4"},
        {"f 1 2 3\nv 0 0 x\n", "2: 'x' is not a number"},
        {"f 1 2 3\nv 0 0 0\nf 1 1 -2\nv 1 0 0\nv 0 1 0\n", "3: face names vertex -2 of 1"},
        {SQUARE "vn 1 2\nf 1 2 3\n", "5: 'vn' takes 3 or more numbers, not 2"},
        {"\nf 3 1 x\n" SQUARE, "2: face corner 'x' is none of v, v/vt, v//vn, v/vt/vn"},
        {"v 0 0 0\nf -1 -1 -2\n" SQUARE, "2: face names vertex -2 of 1"},
        {SQUARE "f 1 2 x\n", "5: face corner 'x' is none of v, v/vt, v//vn, v/vt/vn"},
        {SQUARE "f 1 2 /3\n", "5: face corner '/3' is none of v, v/vt, v//vn, v/vt/vn"},
        {SQUARE CORNERS "f 1 2 3/1/1/1\n",
         "10: face corner '3/1/1/1' is none of v, v/vt, v//vn, v/vt/vn"},
        {SQUARE CORNERS "f 1 2 3/1/1/\n",
         "10: face corner '3/1/1/' is none of v, v/vt, v//vn, v/vt/vn"},
        {SQUARE "f 1 \\\n 2 \\\n 9\n", "5: face names vertex 9 of 4"},
        {"v 1 2\n", "1: 'v' takes 3 or more numbers, not 2"},
        {"vt\n", "1: 'vt' takes 1 or more numbers, not 0"},
        {"v 1 2 nan\n", "1: 'nan' is not a number"},
        {"v 1 2 1e39\n", "1: 1e39 is too large"},
        {"v 1 2 \x1b[31m\n", "1: '?[31m' is not a number"},
        {"OFF", "1: the numbers of vertices and faces are missing"},
        {"OFF\n\n", "2: the numbers of vertices and faces are missing"},
        {"OFF\n3\n", "2: the number of faces is missing"},
        {"OFF\nx 1 0\n", "2: 'x' is not a number of vertices"},
        {"OFF! 1 1\n", "holds no faces"}, /* not OFF, and nothing that OBJ knows */
        {"OFF\n4294967295 1 0\n", "2: '4294967295' is not a number of vertices"},
        {"COFF\n0 0 0\n", "holds no faces"},
        {"OFF\n1 1.5 0\n", "2: '1.5' is not a number of faces"},
        {"OFF\n4000000000 1 0\n0 0 0\n",
         "2: 4000000000 vertices and 1 faces are more than the file can hold"},
        {"OFF\n1 4000000000 0\n0 0 0\n",
         "2: 1 vertices and 4000000000 faces are more than the file can hold"},
        {"OFF\n99999999999999999999 1 0\n",
         "2: '99999999999999999999' is not a number of vertices"},
        {"OFF\n2 1 0\n0 0 0\n# end of it\n", "4: the file ends after 1 of 2 vertices"},
        {"OFF\n1 1 0\n0 0 0\n", "3: the file ends after 0 of 1 faces"},
        {"OFF\n1 1 0\n0 0\n3 0 0 0\n", "4: the colour of a face has 3 or 4 numbers, not 2"},
        {"OFF\n1 1 0\n0 0 0 0\n3 0 0 0\n",
         "4: the file goes on after 1 faces, none with 3 corners"},
        {"OFF\n1 1 0\n0 0 0\n3 0 0 0\n3 0 0 0\n", "5: the file goes on after 1 faces"},
        {"OFF\n1 1\n0 0 0\n3 0 0 0\n\nend\n", "6: the file goes on after 1 faces"},
        {"OFF 1 2 0 0 0 0 3 0 0 0 3 0 0 0\n", "1: the file ends after 1 of 2 faces"},
        /* Wrong in a face, and as a number of edges the 0 of the first vertex would fit. */
        {"OFF\n4 1\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 9\n",
         "7: face names vertex 9 of 4 (from 0)"},
        {"COFF\n1 1 0\n0 0 0\n3 0 0 0\n", "4: the file ends after 0 of 1 faces"},
        {"COFF\n1 1 0\n0 0 0 1 1\n", "3: the file ends after 0 of 1 vertices"},
        {"OFF 1 1 x\n0 0 0\n3 0 0 0\n", "1: 'x' is not a number of edges"},
        {"OFF 1\n1\nx\n0 0 0\n3 0 0 0\n", "3: 'x' is not a number of edges"},
        {"OFF\n1 1 0\n0 nan 0\n3 0 0 0\n", "3: 'nan' is not a number"},
        {"OFF\n1 1 0\n0 0 0\n3 0 0 1\n", "4: face names vertex 1 of 1 (from 0)"},
        {"OFF\n1 1 0\n0 0 0\n3 0 0 -1\n", "4: face names vertex -1 of 1 (from 0)"},
        {"OFF\n1 1 0\n0 0 0\n3 0 0 4294967296\n", "4: face names vertex 4294967296 of 1 (from 0)"},
        {"OFF\n1 1 0\n0 0 0\n3 0 0 x\n", "4: 'x' is not the number of a vertex"},
        {"OFF\n1 1 0\n0 0 0\n4 0 0 0\n", "4: face has 3 corners, not 4"},
        {"OFF\n1 1 0\n0 0 0\n4000000000 0 0 0\n", "4: face has 3 corners, not 4000000000"},
        {"OFF\n1 1 0\n0 0 0\n-3 0 0 0\n", "4: '-3' is not a number of corners"},
        {"OFF\n1 1 0\n0 0 0\n3 0 0 0 5 5\n", "4: the colour of a face has 3 or 4 numbers, not 2"},
        {"OFF\n1 2 0\n0 0 0\n3 0 0 0 0.5 0.5 0.5\n\n3 0 0 0 1 2 3 4 5\n",
         "6: the colour of a face has 3 or 4 numbers, not 5"},
        {"OFF\n1 1 0\n0 0 0\n1 0 1 2\n", "4: the colour of a face has 3 or 4 numbers, not 2"},
        {"OFF\n1 1 0\n0 0 0\n3 0 0 0 red\n", "4: 'red' is not a number"},
        {"OFF\n1 0 0\n0 0 0\n", "holds no faces"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct model model;
        struct error error = {0};
        CHECK_ROW(!decode(&model, rows[i].text, &error), rows[i].text);
        if (!CHECK_ERROR(error, rows[i].message)) {
            fprintf(stderr, "    in row: %s\n", rows[i].text);
        }
        CHECK(model.faces == NULL && model.positions == NULL && model.position_count == 0);
    }
    struct model model;
    struct error error;
    CHECK(!model_decode(&model, "v 1 2 3\nf\0", 10, &error));
    CHECK_ERROR(error, "2: not a text file: it holds a zero byte");
    CHECK(!model_decode(&model, "OFF\n\0", 5, &error));
    CHECK_ERROR(error, "2: not a text file: it holds a zero byte");
    CHECK(!model_decode(&model, NULL, 0, &error));
}

/* ---- Files ---- */

static bool write_image(const char *path, uint8_t level, bool png) {
    struct image image = new_image(2, 2, IMAGE_BGR);
    struct error error;
    image_clear(&image, color_rgb(160, 100, level));
    bool done = png ? png_write(&image, path, &error) : tga_write(&image, path, &error);
    image_free(&image);
    return done;
}

/* The file `name` with this text cannot be read: the message is its path and this. */
static void check_not_read(struct place *place, const char *name, const char *text,
                           const char *message) {
    struct model m;
    struct error error = {0};
    char expected[300];
    CHECK(put_text(name_file(place, name), text));
    CHECK_ROW(!model_read(&m, place->path, &error) && m.faces == NULL, text);
    snprintf(expected, sizeof expected, "%s%s", place->path, message);
    CHECK_TEXT(error.message, expected);
}

static void test_files(void) {
    struct place place = place_create();
    struct model m;
    struct error error;
    CHECK(!model_read(&m, place.directory, &error) && m.faces == NULL);
    CHECK(strstr(error.message, ": is a directory") != NULL);
    const char *path = name_file(&place, "a.obj");
    CHECK(!model_read(&m, path, &error) && strstr(error.message, "a.obj: ") != NULL);
    check_not_read(&place, "a.obj", SQUARE "f 1 2 99\n", ":5: face names vertex 99 of 4");
    check_not_read(&place, "a.obj", "", ": holds no faces");
    CHECK(put_text(path, SQUARE "f 1 2 3\n") && model_read(&m, path, &error));
    if (CHECK(m.path != NULL && m.path != path)) {
        CHECK_TEXT(m.path, path);
    }
    model_free(&m);
    place_remove(&place, "a.obj");
}

/* What the name promises, the first word must keep; an OBJ file may have any name. */
static void test_named_off(void) {
    static const char *const rows[][2] = {
        {"OFFF\n1 1 0\n0 0 0\n3 0 0 0\n", ": does not begin with the word OFF"},
        {"hello\n", ": does not begin with the word OFF"},
        {"", ": does not begin with the word OFF"},
        {"1 1 0\n", ":1: 1 vertices and 1 faces are more than the file can hold"},
        {"1.5 1 0\n", ": begins with a number, as neither OBJ nor OFF does"},
        {"OFF\n1 0 0\n0 0 0\n", ": holds no faces"},
    };
    struct place place = place_create();
    struct model m;
    struct error error;
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        check_not_read(&place, "a.off", rows[i][0], rows[i][1]);
    }
    CHECK(put_text(place.path, SQUARE "f 1 2 3\n") && model_read(&m, place.path, &error));
    model_free(&m);
    place_remove(&place, "a.off");
}

/* Found beside the model as TGA before PNG, read once and only when asked for. */
static void test_textures(void) {
    struct place place = place_create();
    char tga[128], png[128];
    struct model m;
    struct error error;
    strcpy(tga, name_file(&place, "a.b_diffuse.tga"));
    strcpy(png, name_file(&place, "a.b_diffuse.png"));
    const char *path = name_file(&place, "a.b.off");
    CHECK(put_text(path, "OFF 1 1 0\n0 0 0\n3 0 0 0\n"));
    CHECK(put_text(tga, "not an image"));
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
    CHECK(strstr(error.message, "/a.b_nm.tga: no such file, nor one of another usual name") !=
          NULL);
    CHECK(model_texture(&m, MODEL_SPECULAR, &error) == NULL);
    CHECK(strstr(error.message, "a.b_spec.tga") != NULL);
    model_free(&m);
    CHECK(unlink(png) == 0);
    place_remove(&place, "a.b.off");
    CHECK(decode(&m, SQUARE "f 1 2 3", &error) && model_texture(&m, MODEL_DIFFUSE, &error) == NULL);
    model_free(&m);
}

/* The names of textures of a model without directory, without extension, and of a hidden file. */
static void test_texture_names(void) {
    static const char *const rows[][2] = {{"no_such_model.obj", "no_such_model_spec.tga"},
                                          {"no_such_model", "no_such_model_spec.tga"},
                                          {"no.such/model", "no.such/model_spec.tga"},
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
            snprintf(expected, sizeof expected, "%s: no such file, nor one of another usual name",
                     rows[i][1]);
            CHECK_TEXT(error.message, expected);
        }
        model_free(&m);
    }
}

/* Other usual names, and any that is given. The first one in the list counts. */
static void test_other_names(void) {
    static const struct {
        const char *name;
        enum model_texture_kind kind;
    } rows[] = {
        {"a_basecolor.PNG", MODEL_DIFFUSE},     {"a_basecolor.tga", MODEL_DIFFUSE},
        {"a_albedo.png", MODEL_DIFFUSE},        {"a_diffuse.Png", MODEL_DIFFUSE},
        {"a_diffuse.TGA", MODEL_DIFFUSE},       {"a_normal_tangent.png", MODEL_NORMAL_MAP},
        {"a_nm_tangent.tga", MODEL_NORMAL_MAP}, {"a_normal.png", MODEL_NORMAL_MAP},
        {"a_nm.PNG", MODEL_NORMAL_MAP},         {"a_specular.TGA", MODEL_SPECULAR},
        {"a_spec.png", MODEL_SPECULAR},         {"given", MODEL_SPECULAR},
    };
    enum { COUNT = sizeof rows / sizeof rows[0] };
    struct place place = place_create();
    char model_path[128];
    strcpy(model_path, name_file(&place, "a.obj"));
    CHECK(put_text(model_path, SQUARE "f 1 2 3\n"));
    for (size_t i = 0; i < COUNT; i++) { /* each is looked for before those above it */
        struct model m;
        struct error error = {0};
        CHECK(write_image(name_file(&place, rows[i].name), (uint8_t)(i + 1), true));
        CHECK(model_read(&m, model_path, &error));
        m.texture_files[rows[i].kind] = strcmp(rows[i].name, "given") == 0 ? place.path : NULL;
        const struct texture *texture = model_texture(&m, rows[i].kind, &error);
        if (CHECK_ROW(texture != NULL, rows[i].name)) {
            CHECK_ROW((texture->level[0].texels[0] & 0xFF) == i + 1, rows[i].name);
        }
        CHECK(m.textures[MODEL_NORMAL_MAP].tangent_space == (i == 5 || i == 6));
        CHECK(model_textures_present(&m) == (i < 5 ? 1 : i < 9 ? 2 : 3));
        model_free(&m);
    }
    for (size_t i = 0; i < COUNT; i++) {
        CHECK(unlink(name_file(&place, rows[i].name)) == 0);
    }
    struct model m;
    struct error error;
    CHECK(put_text(name_file(&place, "a_spec.JPG"), "\xFF\xD8\xFF\xE0"));
    CHECK(model_read(&m, model_path, &error));
    CHECK(model_texture(&m, MODEL_SPECULAR, &error) == NULL);
    CHECK(strstr(error.message, "/a_spec.JPG: a JPEG file, not a PNG or TGA file: ") != NULL);
    m.texture_files[MODEL_NORMAL_MAP] = "grey.png";
    CHECK(model_texture(&m, MODEL_NORMAL_MAP, &error) == NULL);
    m.texture_files[MODEL_SPECULAR] = model_path; /* what is given is read, whatever it is */
    CHECK(model_texture(&m, MODEL_SPECULAR, &error) == NULL);
    CHECK(strstr(error.message, "/a.obj: neither a PNG nor a TGA") != NULL);
    model_free(&m);
    CHECK(unlink(place.path) == 0);
    place_remove(&place, "a.obj");
}

/* What is not asked for is counted and not read, in the quick way and in the careful one. */
static void test_parts(void) {
    static const char *const texts[] = {
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 1\nvt 1 1\nvn 0 0 1\nf 1/1/1 2/2/-1 3/-1/1\n",
        "v 0 0 0\nv 1 0 \\\n0\nv 0 1 0\nf 1/1/1 2/2/1 3/2/1\nvt 0 1\nvt 1 1\nvn 0 0 1\n",
    };
    for (size_t i = 0; i < 2; i++) {
        for (unsigned parts = 0; parts <= MODEL_ALL_PARTS; parts++) {
            bool uvs = (parts & MODEL_UVS) != 0, normals = (parts & MODEL_NORMALS) != 0;
            struct model m = {0};
            struct error error = {0};
            CHECK(obj_decode(&m, texts[i], strlen(texts[i]), parts, &error));
            CHECK(m.position_count == 3 && m.face_count == 1);
            CHECK(m.uv_count == (uvs ? 2 : 0) && m.normal_count == (normals ? 1 : 0));
            CHECK(m.faces[0].corner[1].uv == (uvs ? 1 : MODEL_NONE));
            CHECK(m.faces[0].corner[1].normal == (normals ? 0 : MODEL_NONE));
            CHECK(model_normal(&m, 0, 1).z == (normals ? 1 : 0));
            model_free(&m);
        }
    }
}

static void test_errors_in_parts(void) {
    static const struct {
        const char *text;
        unsigned parts;
        bool is_read;
    } rows[] = {
        {SQUARE "vt what\nf 1/1 2 3\n", MODEL_NORMALS, true},
        {SQUARE "vt what\nf 1/1 2 3\n", MODEL_UVS, false},
        {SQUARE "vn 1\nf 1//1 2 3\n", MODEL_UVS, true},
        {SQUARE "vn 1\nf 1//1 2 3\n", MODEL_NORMALS, false},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct model m = {0};
        struct error error = {0};
        bool is_read = obj_decode(&m, rows[i].text, strlen(rows[i].text), rows[i].parts, &error);
        CHECK_ROW(is_read == rows[i].is_read, rows[i].text);
        model_free(&m);
    }
}

UNIT_MAIN(TEST(test_parts), TEST(test_errors_in_parts), TEST(test_obj_faces),
          TEST(test_obj_numbers), TEST(test_off), TEST(test_off_smallest), TEST(test_face_colors),
          TEST(test_face_color_values), TEST(test_colors_of_both), TEST(test_messages),
          TEST(test_files), TEST(test_named_off), TEST(test_textures), TEST(test_texture_names),
          TEST(test_other_names))
