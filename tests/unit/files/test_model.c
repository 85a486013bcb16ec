/* Models: what is read of OBJ and OFF as other programs write them, the message for everything that
 * is refused, textures next to the model. */
#define _XOPEN_SOURCE 700 /* POSIX.1-2008 with mkdtemp() */

#include "base/file.h"
#include "files/obj.h"
#include "unit/models.h"

#include <math.h>

/* ---- What is read ---- */

/* The faces as text: corners p/u/n counted from 0, '-' for none, faces parted by a blank; and the
 * lines of warnings. */
static void describe(const struct model *model, char *out, size_t room) {
    static const char *const warnings[MODEL_WARNINGS] = {
        [MODEL_SHORT_FACES] = "short face",
        [MODEL_UVS_MISSING] = "no uv",
        [MODEL_NORMALS_MISSING] = "no normal",
        [MODEL_NORMALS_WRONG] = "wrong normal",
        [MODEL_LIBRARY_MISSING] = "no library",
        [MODEL_MATERIAL_MISSING] = "no material",
        [MODEL_GLASSY] = "glass",
    };
    size_t used = 0;
    out[0] = '\0';
    for (size_t i = 0; i < 9 * model->face_count; i++) {
        const struct corner *c = &model->faces[i / 9].corner[i / 3 % 3];
        const uint32_t index[3] = {c->position, c->uv, c->normal};
        const char *before = i % 3 > 0 ? "/" : i % 9 > 0 ? "," : i > 0 ? " " : "";
        if (index[i % 3] == MODEL_NONE) {
            used += (size_t)snprintf(out + used, room - used, "%s-", before);
        } else {
            used += (size_t)snprintf(out + used, room - used, "%s%" PRIu32, before, index[i % 3]);
        }
    }
    for (int k = 0; k < MODEL_WARNINGS; k++) {
        CHECK(strlen(model_warning_text((enum model_warning)k)) > 20);
        if (model->warning_line[k] > 0) {
            used += (size_t)snprintf(out + used, room - used, " %zu: %s", model->warning_line[k],
                                     warnings[k]);
        }
    }
}

#define THREE    "0 0 0\n1 0 0\n1 1 0\n"
#define CORNERS  "vt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\nvn 0 1 0\n"
#define TRIANGLE "0/-/-,1/-/-,2/-/-"

static bool is_read(struct model *model, const char *text, const char *expected) {
    char got[512];
    if (!decode_right(model, text)) {
        return false;
    }
    describe(model, got, sizeof got);
    return CHECK_ROW(CHECK_TEXT(got, expected), text);
}

static void test_obj(void) {
    static const char *const rows[][2] = {
        {SQUARE "f 1 2 3\n", TRIANGLE},
        {"v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3", TRIANGLE},
        {"\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3", TRIANGLE},
        {SQUARE CORNERS "f 1 2/2 3//1\n", "0/-/-,1/1/-,2/-/0"},
        {SQUARE CORNERS "f 1/3/2 2/2/1 4/1/2\n", "0/2/1,1/1/0,3/0/1"},
        {SQUARE CORNERS "f -4/-3/-2 -3/-2/-1 -1/-1/-1\n", "0/0/0,1/1/1,3/2/1"},
        /* Negative numbers count from where they are, others also further down. */
        {SQUARE "f -3 -2 -1\nv 5 5 5\nf -3 -2 -1\n", "1/-/-,2/-/-,3/-/- 2/-/-,3/-/-,4/-/-"},
        {"f 1 2 3\n" SQUARE, TRIANGLE},
        {"v 9 9 9\nf 1 2 3\n" SQUARE "f -4 -3 -2\nv 7 7 7\n",
         "0/-/-,1/-/-,2/-/- 1/-/-,2/-/-,3/-/-"},
        {SQUARE "f 1/1/1 2/2/2 3/3/1\n" CORNERS, "0/0/0,1/1/1,2/2/0"},
        {SQUARE "f +1 002 3\n", TRIANGLE},
        {SQUARE CORNERS "f 1/1/1 2/2/1 3/3/1 4/1/2\n", "0/0/0,1/1/0,2/2/0 0/0/0,2/2/0,3/0/1"},
        {"v 0 0 0\nv 4 0 0\nv 0 4 0\nv 1 1 0\nf 2 4 3 1\n", /* an arrow, whose inner corner is 4 */
         "3/-/-,2/-/-,0/-/- 3/-/-,0/-/-,1/-/-"},
        {SQUARE "l 1 2 3 4\np 1\nf 1 2 3\nl 1 2 3\n", TRIANGLE},
        {"mtllib\no x\ng y z\ns off\nusemtl m\nvp 1 2\n" SQUARE
         "cstype bezier\nf 1 2 3\nfoo # bar\nfacet 1 2\nvv 1\n",
         TRIANGLE},
        {"# v 9 9 9\n" SQUARE "f 1 2 3 # 4\n#f 1 2 3\n", TRIANGLE},
        {"v 0 0 \\\n 0\nv 1 0 0\nv 0 1 0\nf 1 \\\n2\\\n \\\r\n3\n", TRIANGLE},
        {"solid\n" SQUARE "f 1 2 3\n", TRIANGLE}, /* no STL: it can be read */
        /* Corners without one or the other, or of which the file has none. */
        {SQUARE CORNERS "f 1// 2/ 3/0/0\n", TRIANGLE},
        {SQUARE CORNERS "f 1/1/ 2/1/0 3/-0/+1\n", "0/0/-,1/0/-,2/-/0"},
        {SQUARE CORNERS "f 1 2/4/1 3\nf 1 2/6 3\n", "0/-/-,1/-/0,2/-/- " TRIANGLE " 10: no uv"},
        {SQUARE CORNERS "f 1 2/1/3 3\nf 1//7 2 3\n",
         "0/-/-,1/0/-,2/-/- " TRIANGLE " 10: no normal"},
        {SQUARE CORNERS "f 1 2//-3 3\n", TRIANGLE " 10: no normal"},
        {SQUARE CORNERS "f 1 2//99999999999999999999 3\n", TRIANGLE " 10: no normal"},
        {SQUARE "f 1/1/1 2/2/1 3/3/1\nvt 0 0\nvt 1 0\nvt 1 1\n", "0/0/-,1/1/-,2/2/-"
                                                                 " 5: no normal"},
        {SQUARE "\nvn 0 0 0\nf 1 2//1 3\n", TRIANGLE " 6: wrong normal"},
        {SQUARE "vn 0 0 1\nvn nan nan nan\nf 1 2//2 3\n", TRIANGLE " 6: wrong normal"},
        {SQUARE "vn -nan(ind) 0 1\nf 1 2//1 3\n", TRIANGLE " 5: wrong normal"},
        {SQUARE "vn 0 1.#QNAN 1\nf 1 2//1 3\n", TRIANGLE " 5: wrong normal"},
        {SQUARE "vn 0 1 -Inf\nf 1 2//1 3\n", TRIANGLE " 5: wrong normal"},
        {SQUARE "vn 0 1 +nan\nvn 0 0 0\nf 1 2//1 3//2\n", TRIANGLE " 5: wrong normal"},
        {"vn 0 0 0\nvn 0 1 0\nvn 1 0 0\nvn 0 0 1\n" SQUARE "f 1//1 2//2 3//3\nf 1//4 2//4 3//1\n",
         "0/-/-,1/-/1,2/-/2 0/-/3,1/-/3,2/-/- 1: wrong normal"},
        {"v 0 0 3.4028234663852886e38\nv 1 0 0\nv 0 1 0\nvn 3.4028234663852886e38 0 0\n"
         "f 1 2//1 3\n",
         "0/-/-,1/-/0,2/-/-"},
        {SQUARE "vn 0 1e39 1\nf 1 2//1 3\n", TRIANGLE " 5: wrong normal"},
        {SQUARE "vn 1e-60 0 0\nf 1 2//1 3\n", TRIANGLE " 5: wrong normal"},
        {SQUARE "vn 0 0 0\nvn 1e-40 0 0\nf 1 2//2 3\n", "0/-/-,1/-/1,2/-/-"},
        {SQUARE "f 1 2\nf 1 2 3\nf 3\n", TRIANGLE " 5: short face"},
        {SQUARE "f\nf 1 2 3\n", TRIANGLE " 5: short face"},
        {SQUARE "vt nan nan\nf 1 2 3/1", "0/-/-,1/-/-,2/0/-"},
        {"OFF 1 1 0 0 0 0 .5 0 0\n3 0 0 0\n", "0/-/-,0/-/-,0/-/-"}, /* a vertex with a colour */
        {"V 0 0 0\nV 1 0 0\nV 1 1 0\nVT 0 0\nVN 0 0 1\nF 1/1/1 2/1/1 3/1/1\n", "0/0/0,1/0/0,2/0/0"},
        {SQUARE "f 1 2 \\ \t\n3\n", TRIANGLE},
        {SQUARE "fo 1 2 3\n", TRIANGLE}, /* as old files have it */
        {"v nan 0 0\nv 0 1e39 0\n" SQUARE "f 3 4 5\nf 3 4 5 6\n",
         "2/-/-,3/-/-,4/-/- 2/-/-,3/-/-,4/-/- 2/-/-,4/-/-,5/-/-"},
        {"OFF\n4 1 0\n" THREE "0 nan 0\n3 0 1 2\n", TRIANGLE},
        {SQUARE "vt 1 0 0 1\nvn 0 0 1 0\nf 1 2/1/1 3\n", "0/-/-,1/0/0,2/-/-"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct model model;
        if (is_read(&model, rows[i][0], rows[i][1])) {
            model_free(&model);
            CHECK(model.faces == NULL && model.face_count == 0 && model.positions == NULL);
        }
    }
}

/* What is not wanted is not read, and no corner has it. */
static void test_unwanted(void) {
    static const char text[] = SQUARE CORNERS "f 1/1/1 2/9/9 -2/-1/-1\n";
    static const char *const corners[] = {TRIANGLE, "0/0/-,1/-/-,2/2/- 10: no uv",
                                          "0/-/0,1/-/-,2/-/1 10: no normal"};
    for (unsigned parts = 0; parts < 3; parts++) { /* none, MODEL_UVS, MODEL_NORMALS */
        char got[512];
        struct model m = {0};
        struct error error;
        CHECK(obj_decode(&m, text, strlen(text), parts, &error));
        describe(&m, got, sizeof got);
        CHECK_TEXT(got, corners[parts]);
        CHECK(m.uv_count == (parts == 1 ? 3 : 0) && m.normal_count == (parts == 2 ? 2 : 0));
        model_free(&m);
    }
}

static bool at(const struct model *model, size_t position, double x, double y, double z) {
    struct vec3 p = model->positions[position];
    return p.x == x && p.y == y && p.z == z;
}

static void test_obj_numbers(void) {
    static const char text[] =
        "v 1 -2 .5\nv 1e2 5. -1E-2 2\nv 0.1 0.2 0.3 0.25 -1 1.5\n"
        "v 16777217 1e-30 -0\nvt 0.5\nvt 2 -3\nvt 1 2 3\nvt nan inf\nvn 0 3 4\n"
        "f 1 2 3\n";
    struct model m;
    if (!decode_right(&m, text)) {
        return;
    }
    CHECK(m.position_count == 4 && m.uv_count == 4 && m.normal_count == 1 && m.face_count == 1);
    CHECK(at(&m, 0, 1, -2, 0.5) && at(&m, 1, 50, 2.5, -0.005) && at(&m, 2, 0.1, 0.2, 0.3));
    CHECK(at(&m, 3, 16777217, 1e-30, 0)); /* the first is no float */
    CHECK(m.uvs[0][0] == 0.5F && m.uvs[0][1] == 0 && m.uvs[1][0] == 2 && m.uvs[1][1] == -3 &&
          m.uvs[2][1] == 2 && m.uvs[3][0] == 0 && m.uvs[3][1] == 0);
    CHECK(same3(m.normals[0], 0, 3, 4));
    /* Only the third position has a colour: the others are white, and not w. */
    if (CHECK(m.colors != NULL)) {
        CHECK(same3(m.colors[0], 1, 1, 1) && same3(m.colors[1], 1, 1, 1));
        CHECK(same3(m.colors[2], 0.25F, 0, 1) && same3(m.colors[3], 1, 1, 1));
    }
    CHECK(m.path == NULL);
    struct vec2 uv = model_uv(&m, 0, 0);
    CHECK(uv.x == 0 && uv.y == 0 && vec3_length(model_normal(&m, 0, 0)) == 0);
    model_free(&m);
    CHECK(decode_right(&m, SQUARE "v 1 2 3 4\nv 1 2 3 4 5\nf 1 2 3\n") && m.colors == NULL);
    model_free(&m);
}

/* Colour, normal and texture coordinates of the first position are the same in all rows. */
static void test_off(void) {
    static const char *const rows[][2] = {
        {"OFF\n4 1 0\n" THREE "0 1 0\n3 0 1 2\n", TRIANGLE},
        {"3 1 0\n" THREE "3 0 1 2\n", TRIANGLE},
        {"# no word\n\n3 1\n" THREE "3 0 1 2\n", TRIANGLE},
        {"Off 3 1 3\n" THREE "3 0 1 2", TRIANGLE},
        {"OFF03 1 3\n" THREE "3 0 1 2", TRIANGLE},
        {"OFF9 1 3\n" THREE THREE THREE "3 0 1 2", TRIANGLE},
        /* A number of edges, on the next line too, or none. */
        {"OFF\n3 2\n0\n" THREE "3 0 1 2\n3 0 1 2\n", TRIANGLE " " TRIANGLE},
        {"OFF\n3 1 #\n\n# edges\n5 # 5\n" THREE "3 0 1 2\n", TRIANGLE},
        {"OFF\n3 1\n3 0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n", TRIANGLE},
        {"OFF\n4 1\n\n3\n" THREE "0 1 3\n3 0 1 2\n", TRIANGLE}, /* looks like a face */
        {"OFF\n3 1\n0\n0\n0\n1\n0\n0\n1\n1\n0\n3\n0\n1\n2\n", TRIANGLE},
        {"OFF\n3\n1\n" THREE "3 0 1 2\n", TRIANGLE},
        {"OFF\n3\n1\n0\n0\n0\n0\n1\n0\n0\n1\n1\n0\n3\n0\n1\n2\n", TRIANGLE},
        {"OFF 3 1 0 0 0 0 1 0 0 1 1 0 3 0 1 2", TRIANGLE},
        {"OFF 3\n1 0 0 0\n0 1 0 0 1\n1 0 3 0\n1 2 0.5 0.5 0.5\n", TRIANGLE},
        {"COFF\n3 1 0\n0 0\n0 255 0 0 255\n1 0 0 0\n51 0\n1 1 0 0 0 255 0\n3 0\n1 2\n", TRIANGLE},
        {"# hand\n\nOFF # what\n\n# x\n3 1 0 # y\n0 0 0\n\n1 0 0 # z\n1 1 0\n\n#\n3 0 1 2 #\n",
         TRIANGLE},
        {"OFF\n3 2 0\n" THREE "3 0 1 2 255 0 0\n3 0 1 2 0.5 0.5 0.5 1\n", TRIANGLE " " TRIANGLE},
        {"OFF\n4 1 0\n" THREE "0 1 0\n4 0 1 2 3\n", "0/-/-,1/-/-,2/-/- 0/-/-,2/-/-,3/-/-"},
        {"OFF\n3 3 0\n" THREE "1 0\n2 0 1\n3 0 1 2\n", TRIANGLE},
        /* What positions have besides, and other dimensions. */
        {"COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 0 51 0 9\n1 1 0 0 0 255 0\n3 0 1 2\n", TRIANGLE},
        {"stoff\n3 1 0\n0 0 0 .5 .25\n1 0 0 1 0\n1 1 0 0 1\n3 0 1 2\n", "0/0/-,1/1/-,2/2/-"},
        {"noff\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 1 0\n1 1 0 1 0 0\n3 0 1 2\n", "0/-/0,1/-/1,2/-/2"},
        {"STCNOFF\n3 1 0\n0 0 0 0 0 1 1 0 0 1 0.5 0.25\n1 0 0 0 0 1 0 0.2 0 1 0 0\n"
         "1 1 0 0 0 1 0 0 1 1 1 1\n3 0 1 2\n",
         "0/0/0,1/1/1,2/2/2"},
        {"4OFF\n4 1 0\n0 0 0 1\n2 0 0 2\n1 1 0 0\n0 0 3.4028234663852886e38 1\n3 0 1 2\n",
         TRIANGLE},
        {"4noff\n3 1 0\n0 0 0 1 0 0 1\n1 0 0 1 0 0 1\n.5 .5 0 .5 0 0 1\n3 0 1 2\n",
         "0/-/0,1/-/1,2/-/2"},
        {"nOFF 3\n3 1 0\n" THREE "3 0 1 2\n", TRIANGLE},
        {"nOFF\n3\n3 1 0\n" THREE "3 0 1 2\n", TRIANGLE},
        {"NnOFF 3\n3 1\n0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0 0 0 1\n3 0 1 2\n", "0/-/0,1/-/1,2/-/2"},
        {"4nOFF 3\n3 1 0\n0 0 0 1\n1 0 0 1\n1 1 0 1\n3 0 1 2\n", TRIANGLE},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct model m;
        if (!is_read(&m, rows[i][0], rows[i][1])) {
            continue;
        }
        CHECK_ROW(at(&m, 0, 0, 0, 0) && at(&m, 1, 1, 0, 0) && at(&m, 2, 1, 1, 0), rows[i][0]);
        CHECK_ROW((m.colors != NULL) == (strchr(rows[i][0], 'C') != NULL), rows[i][0]);
        if (m.colors != NULL) {
            CHECK(same3(m.colors[0], 1, 0, 0) && same3(m.colors[1], 0, 0.2F, 0));
        }
        if (m.uv_count > 0) {
            CHECK(m.uvs[0][0] == 0.5F && m.uvs[0][1] == 0.25F);
        }
        CHECK(m.normal_count == 0 || same3(m.normals[0], 0, 0, 1));
        model_free(&m);
    }
}

/* As few bytes as vertices and faces can have are enough for the numbers in the first line. */
static void test_off_smallest(void) {
    char text[400] = "OFF 40 1 0\n";
    struct model m;
    for (int i = 0; i < 40; i++) {
        strcat(text, "0 0 0\n");
    }
    strcat(text, "3 0 1 2");
    CHECK(decode_right(&m, text) && m.position_count == 40 && m.face_count == 1);
    model_free(&m);
    strcpy(text, "OFF 3 81 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    for (int i = 0; i < 80; i++) {
        strcat(text, "0\n"); /* faces without corners */
    }
    CHECK(decode_right(&m, text) && m.position_count == 3 && m.face_count == 1);
    model_free(&m);
}

/* ---- Colours ---- */

#define RED "v 0 0 0 1 0 0\n"

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
        {"v 0 0 0\nv 1 0 0 0 0 51.0\nv 0 1 0\nf 1 2 3\n", /* white stays white */
         {{1, 1, 1}, {0, 0, 0.2F}, {1, 1, 1}}},
        {"v 0 0 0 2.55 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
         {{2.55F / 255, 0, 0}, {1, 1, 1}, {1, 1, 1}}},
        {"v 0 0 0 nan nan nan\nv 1 0 0 0 1 0\nv 0 1 0 1e39 inf 1\nf 1 2 3\n",
         {{1, 1, 1}, {0, 1, 0}, {1, 1, 1}}},
        {"v 0 0 0 2 0 0\nv 1 0 0 0 1.5 -1\nv 0 1 0 0.5 0 0\nf 1 2 3\n",
         {{1, 0, 0}, {0, 1, 0}, {0.5F, 0, 0}}},
        {RED RED RED RED RED RED RED RED RED RED RED RED RED RED RED RED "f 1 2 3\n",
         {{1, 0, 0}, {1, 0, 0}, {1, 0, 0}}},
        {"CSTOFF\n3 1 0\n0 0 0 255 0 0 255 0 0\n1 0 0 0 51 0 255 1 0\n0 1 0 0 0 255 255 1 1\n"
         "3 0 1 2\n",
         {{1, 0, 0}, {0, 0.2F, 0}, {0, 0, 1}}},
        {"NCOFF\n3 1 0\n0 0 0 0 0 1 1 0 0\n1 0 0 0 0 1 0 .2 0\n0 1 0 0 0 1 0 0 1\n3 0 1 2\n",
         {{1, 0, 0}, {0, 0.2F, 0}, {0, 0, 1}}},
        {"coff\n3 1 0\n0 0 0 1e39 0 0\n1 0 0 0 .2 0\n0 1 0 0 0 1\n3 0 1 2\n",
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

/* The colour of the second corner of each face: a polygon's is that of all its triangles, and hides
 * those of its corners; what has none is white. */
static void test_face_colors(void) {
    static const struct {
        const char *text, *colors;
        bool some; /* some faces have one */
    } rows[] = {
        {"OFF 4 7\n" THREE "0 1 0\n3 0 1 2\n4 0 1 2 3 255 0 255\n2 0 1 9 9 9\n3 0 1 2 7\n"
         "3 2 1 0 0.5 0.25 1 0.5 # and alpha\n3 0 1 2\n3 0 1 2\n",
         "1 1 1;1 0 1;1 0 1;1 1 1;0.5 0.25 1;1 1 1;1 1 1;", true},
        {"OFF 3 2\n" THREE "3 0 1 2\n3 2 1 0 5\n", "1 1 1;1 1 1;", false},
        {"COFF 3 2\n0 0 0 0 0 1\n1 0 0 0 1 0\n0 1 0 1 0 0\n3 0 1 2\n3 0 1 2 0.5 0.5 0.5\n",
         "1 1 1;0.5 0.5 0.5;", true},
        {"COFF 3 2\n0 0 0 0 0 1\n1 0 0 0 1 0\n0 1 0 1 0 0\n3 0 1 2\n3 2 0 1\n", "0 1 0;0 0 1;",
         false},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct model m;
        char colors[200] = "";
        if (!decode_right(&m, rows[i].text)) {
            continue;
        }
        for (size_t k = 0, used = 0; k < m.face_count; k++) {
            struct vec3 c = model_color(&m, k, 1);
            used +=
                (size_t)snprintf(colors + used, sizeof colors - used, "%g %g %g;", c.x, c.y, c.z);
        }
        CHECK_TEXT(colors, rows[i].colors);
        CHECK_ROW((m.face_colors != NULL) == rows[i].some, rows[i].text);
        model_free(&m);
        CHECK(m.face_colors == NULL);
    }
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
        char text[100];
        struct model m;
        snprintf(text, sizeof text, "OFF 3 1\n%s3 0 1 2 %s\n", THREE, rows[i].numbers);
        if (decode_right(&m, text) && CHECK_ROW(m.face_colors != NULL, rows[i].numbers)) {
            CHECK_ROW(same3(m.face_colors[0], rows[i].r, rows[i].g, rows[i].b), rows[i].numbers);
            CHECK_ROW(!signbit(m.face_colors[0][2]), rows[i].numbers);
        }
        model_free(&m);
    }
}

/* ---- What is refused ---- */

#define EXPORT ": Blender, for one, exports it as OBJ"

static void test_messages(void) {
    static const struct {
        const char *text, *message;
    } rows[] = {
        {"", "is empty"},
        {SQUARE, "holds no faces"},
        {"just some words\n1 2 3", "holds no faces"},
        {SQUARE "\nf 1 2 0\n", "6: face names vertex 0: the first is 1"},
        {SQUARE "f 1 2 5\n", "5: face names vertex 5 of 4"},
        {"f 1 2 3\n" SQUARE "f 1 2 5\n", "6: face names vertex 5 of 4"},
        {SQUARE "f 1 2 4294967296\n", "5: face names vertex 4294967296 of 4"},
        {SQUARE "f 1 2 -4294967295\n", "5: face names vertex -4294967295 of 4"},
        {SQUARE "f 1 2 18446744073709551617", "5: face names vertex 18446744073709551617 of 4"},
        {SQUARE "f 1 2 -99999999999999999999\nv 1 1 1\n", /* only those above count */
         "5: face names vertex -99999999999999999999 of 4"},
        {"f 1 2 3\nv 0 0 x\n", "2: 'x' is not a number"},
        {"f 1 2 3\nv 0 0 0\nf 1 1 -2\nv 1 0 0\nv 0 1 0\n", "3: face names vertex -2 of 1"},
        {SQUARE "vn 1 2\nf 1 2 3\n", "5: 'vn' takes 3 or more numbers, not 2"},
        {"\nf 3 1 x\n" SQUARE, "2: face corner 'x' is none of v, v/vt, v//vn, v/vt/vn"},
        {"v 0 0 0\nf -1 -1 -2\n" SQUARE, "2: face names vertex -2 of 1"},
        {SQUARE "f 1 2 +4\nf 1 2 x\nv 0 0 x\n", /* nothing makes it read ahead */
         "6: face corner 'x' is none of v, v/vt, v//vn, v/vt/vn"},
        {SQUARE "f 1 2 /3\n", "5: face corner '/3' is none of v, v/vt, v//vn, v/vt/vn"},
        {SQUARE "f 1 \\\n 2 \\\n 9\n", "5: face names vertex 9 of 4"},
        {"v 1 2\n", "1: 'v' takes 3 or more numbers, not 2"},
        {"\nvt\n", "2: 'vt' takes 1 or more numbers, not 0"},
        {"v 0 0 1\nv 1 2 nan\nf 1 1 2\n", "3: vertex 2 is not a number, or too large"},
        {"f 2 1 1\nv 0 0 1\nv 1e39 2 0\n", "1: vertex 2 is not a number, or too large"},
        {SQUARE "v 0 -1e39 0\nf 1 2 3 5\n", "6: vertex 5 is not a number, or too large"},
        {SQUARE "v 0 0 inf\nf 1 5 3\n", "6: vertex 5 is not a number, or too large"},
        {"v 1 2 3 1e-320\nf 1 1 1\n", "2: vertex 1 is not a number, or too large"},
        {"v 1 2 \x1b[31m\n", "1: '?[31m' is not a number"},
        {SQUARE "cstype bezier\ndeg 3\ncurv 0 1 1 2 3 4\nend\n",
         "5: curves or surfaces and no faces: export polygons"},
        {SQUARE "surf 0 1 0 1 1 2 3 4\n", "5: curves or surfaces and no faces: export polygons"},
        {SQUARE "p 1\np 2\n", "5: points and no faces, which no lesson draws"},
        {"f 1 2 :\n" SQUARE, "1: face corner ':' is none of v, v/vt, v//vn, v/vt/vn"},
        {"I\n800\nOBJ\n\nVT 0 0 0 0 1 0 0 0\n",
         "an OBJ file of X-Plane, which is another format, not an OBJ or OFF file" EXPORT},
        {"A\r\n800\r\nOBJ\r\n",
         "an OBJ file of X-Plane, which is another format, not an OBJ or OFF file" EXPORT},
        {"OFF\n4 1 0\n" THREE "4 0 1 2 3\n", "6: a face where vertex 4 of 4 is expected"},
        {"OFF\n4 2 0\n" THREE "3 0 1 2 \n\n3 0 2 3\n", "6: a face where vertex 4 of 4 is expected"},
        {"OFF\n4 1 0\n" THREE "4 0 1 2 4\n", "6: face names vertex 4 of 4 (from 0)"},
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
        {"OFF\n2 1 0\n0 0 0\n0 0", "2: 2 vertices and 1 faces are more than the file can hold"},
        {"OFF\n1 6 0\n0 0 0\n0 0", "2: 1 vertices and 6 faces are more than the file can hold"},
        {"OFF\n0 2 0\n0\n0", "holds no faces"}, /* though it can hold so many */
        {"OFF\n2 1 0\n0 0 0\n# end of it\n", "4: the file ends after 1 of 2 vertices"},
        {"OFF\n1 1 0\n0 0\n3 0 0 0\n", "4: the colour of a face has 3 or 4 numbers, not 2"},
        {"OFF\n1 1 0\n0 0 0 0\n3 0 0 0\n",
         "4: the file goes on after 1 faces, none with 3 corners"},
        {"OFF\n3 1 0\n0 0 0 1 0 0\n1 0 0 0 1 0\n0 1 0 0 0 1 9 3\n0 1 2\n", /* hardly colours */
         "4: the colour of a face has 3 or 4 numbers, not 2"},
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
        {"OFF\n1 1 0\n0 nan 0\n3 0 0 0\n", "4: vertex 1 is not a number, or too large"},
        {"OFF\n1 1 0\n0 0 0\n3 0 0 1\n", "4: face names vertex 1 of 1 (from 0)"},
        {"OFF\n1 1 0\n0 0 0\n3 0 0 -1\n", "4: face names vertex -1 of 1 (from 0)"},
        {"OFF\n1 1 0\n0 0 0\n3 0 0 4294967296\n", "4: face names vertex 4294967296 of 1 (from 0)"},
        {"OFF\n1 1 0\n0 0 0\n3 0 0 x\n", "4: 'x' is not the number of a vertex"},
        {"OFF\n1 1 0\n0 0 0\n4 0 0 0\n", "4: face has 3 corners, not 4"},
        {"OFF\n1 1 0\n0 0 0\n4000000000 0 0 0\n", "4: face has 3 corners, not 4000000000"},
        {"OFF\n1 1 0\n0 0 0\n-3 0 0 0\n", "4: '-3' is not a number of corners"},
        {"OFF\n1 2 0\n0 0 0\n3 0 0 0 0.5 0.5 0.5\n\n3 0 0 0 1 2 3 4 5\n",
         "6: the colour of a face has 3 or 4 numbers, not 5"},
        {"OFF\n1 1 0\n0 0 0\n1 0 1 2\n", "4: the colour of a face has 3 or 4 numbers, not 2"},
        {"OFF\n1 1 0\n0 0 0\n3 0 0 0 red\n", "4: 'red' is not a number"},
        {"OFF\n1 0 0\n0 0 0\n", "holds no faces"},
        {SQUARE "f / 1 2\n", "5: face corner '/' is none of v, v/vt, v//vn, v/vt/vn"},
        {SQUARE "f 1/x 2 3\n", "5: face corner '1/x' is none of v, v/vt, v//vn, v/vt/vn"},
        {SQUARE "f 1/1/1/ 2 3\n", "5: face corner '1/1/1/' is none of v, v/vt, v//vn, v/vt/vn"},
        {SQUARE "f 1/- 2 3\n", "5: face corner '1/-' is none of v, v/vt, v//vn, v/vt/vn"},
        {SQUARE "f 1//1.5 2 3\n", "5: face corner '1//1.5' is none of v, v/vt, v//vn, v/vt/vn"},
        {SQUARE "vn nothing 0 1\n", "5: 'nothing' is not a number"},
        {SQUARE "vn - 0 1\n", "5: '-' is not a number"},
        {SQUARE "vn 0 1 -na", "5: '-na' is not a number"},
        {"OFF BINARY\n", "1: a binary OFF file: only text can be read"},
        {"\nCOFF BINARY # what\n", "1: a binary OFF file: only text can be read"},
        {"4OFF 1 1\n0 0 1 1e-320\n3 0 0 0\n", "3: vertex 1 is not a number, or too large"},
        {"nOFF\n4\n1 1\n0 0 0 0\n", "2: a space of 4 dimensions, not 3"},
        {"nOFF\n", "1: the number of dimensions is missing"},
        {"OFF\n2 1\n0 0 0 1 0 0 0 0\n0 0 0 1 0 0\n3 0 0 0\n",
         "4: the file goes on after 1 faces, none with 3 corners"},
        {"OFF\n1 1 0\n0\n0 0 1 0 0\n3 0 0 0\n", /* no line of its own */
         "5: the file goes on after 1 faces, none with 3 corners"},
        {"\n1.5 2 3\n", "begins with a number, as neither OBJ nor OFF does"},
        {"version https://git-lfs.github.com/spec/v1\noid sha256:3c\nsize 39043\n",
         "a Git LFS pointer, not an OBJ or OFF file: `git lfs pull` fetches the file itself"},
        {"ply\nformat ascii 1.0\n", "a PLY file, not an OBJ or OFF file" EXPORT},
        {"ply\r\nformat ascii 1.0\r\n", "a PLY file, not an OBJ or OFF file" EXPORT},
        {"solid cube\n facet normal 0 0 1\n", "an STL file, not an OBJ or OFF file" EXPORT},
        {"glTF\2", "a glTF file, not an OBJ or OFF file" EXPORT},
        {"{\"asset\": {}}", "JSON, perhaps a glTF file, not an OBJ or OFF file" EXPORT},
        {"\xEF\xBB\xBF \n<!DOCTYPE HTML><html>",
         "an HTML page, not an OBJ or OFF file: download the file itself"},
        {"solid\n" SQUARE "f 1 2 9\n", "an STL file, not an OBJ or OFF file" EXPORT},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct model model;
        struct error error = {0};
        CHECK_ROW(!decode(&model, rows[i].text, &error), rows[i].text);
        CHECK_ROW(CHECK_ERROR(error, rows[i].message), rows[i].text);
        CHECK(model.faces == NULL && model.positions == NULL && model.position_count == 0);
    }
}

/* With bytes that no text has. */
static void test_binary_messages(void) {
    static const char stl[84 + 2 * 50] = {[80] = 2}, no_stl[84 + 2 * 50] = {[80] = 2, [81] = 1};
    static const struct {
        const char *bytes;
        size_t size;
        const char *message;
    } rows[] = {
        {"v 1 2 3\nf\0 ", 11, "2: not a text file: it holds a zero byte"},
        {"OFF\n\0\n", 6, "2: not a text file: it holds a zero byte"},
        {"OFF\n\0\0", 6, "1: the numbers of vertices and faces are missing"},
        {NULL, 0, "is empty"},
        {"COFF binary\n\0\0\0\3", 16, "1: a binary OFF file: only text can be read"},
        {"\x89PNG\r\n\x1a\n", 8, "a PNG file, not an OBJ or OFF file"}, /* nothing would help */
        {"OFF BINARY\n\0\0\0\3", 15, "1: a binary OFF file: only text can be read"},
        {stl, sizeof stl, "a binary STL file, not an OBJ or OFF file" EXPORT},
        {no_stl, sizeof no_stl, "1: not a text file: it holds a zero byte"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct model model;
        struct error error = {0};
        CHECK(!model_decode(&model, rows[i].bytes, rows[i].size, &error));
        CHECK_ERROR(error, rows[i].message);
    }
}

static void test_long_line(void) {
    struct place place = place_create();
    struct model m;
    struct error error;
    char text[600] = SQUARE "l 1";
    for (int i = 0; i < 60; i++) {
        strcat(text, " 2 1");
    }
    const char *path = name_file(&place, "lines");
    CHECK(put_text(path, text) && model_read_parts(&m, path, MODEL_LINES, &error));
    CHECK(m.line_count == 120 && m.lines[119][0] == 1 && m.lines[119][1] == 0);
    model_free(&m);
    place_remove(&place, "lines");
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

/* ---- Files ---- */

/* What the name promises, the first word must keep; an OBJ file may have any name. A message begins
 * with the path. */
static void test_refused_files(void) {
    static const char *const rows[][3] = {
        {"a.obj", SQUARE "f 1 2 99\n", ":5: face names vertex 99 of 4"},
        {"a.obj", "", ": is empty"},
        {"a.off", "OFFF\n1 1 0\n0 0 0\n3 0 0 0\n", ": does not begin with the word OFF"},
        {"a.OFF", "hello\n", ": does not begin with the word OFF"},
        {"a.off", "", ": is empty"},
        {"a.obj", SQUARE "p 1\nf 1 2\n", ":6: a face of fewer than 3 corners, and no other"},
        {"a.off", "1 1 0\n", ":1: 1 vertices and 1 faces are more than the file can hold"},
        {"a.off", "1.5 1 0\n", ": begins with a number, as neither OBJ nor OFF does"},
        {"a.off", "OFF\n1 0 0\n0 0 0\n", ": holds no faces"},
    };
    struct place place = place_create();
    struct model m;
    struct error error;
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        char expected[300];
        CHECK(put_text(name_file(&place, rows[i][0]), rows[i][1]));
        CHECK_ROW(!model_read(&m, place.path, &error) && m.faces == NULL, rows[i][1]);
        snprintf(expected, sizeof expected, "%s%s", place.path, rows[i][2]);
        CHECK_TEXT(error.message, expected);
    }
    CHECK(!model_read(&m, place.directory, &error) && m.faces == NULL);
    CHECK(strstr(error.message, ": is a directory") != NULL);
    CHECK(!model_read(&m, name_file(&place, "none.obj"), &error));
    CHECK(strstr(error.message, "none.obj: ") != NULL);
    CHECK(put_text(name_file(&place, "%%.off"), SQUARE "f 1 2 3\n"));
    CHECK(model_read(&m, place.path, &error) && m.path != place.path);
    CHECK_TEXT(m.path, place.path);
    model_free(&m);
    place_remove(&place, "a.obj,a.OFF,a.off,%%.off");
}

/* Found next to the model, read once and only when asked for. */
static void test_textures(void) {
    struct place place = place_create(), other = place;
    struct model m;
    struct error error;
    const char *tga = name_file(&other, "a.b_diffuse.tga"), *path = name_file(&place, "a.b.off");
    CHECK(put_text(path, "OFF 1 1 0\n0 0 0\n3 0 0 0\n"));
    CHECK(put_text(tga, "not an image"));
    CHECK(model_read(&m, path, &error)); /* textures are not looked at yet */
    CHECK(model_texture(&m, MODEL_DIFFUSE, &error) == NULL);
    CHECK(strncmp(error.message, tga, strlen(tga)) == 0);
    put_picture(&other, "a.b_diffuse.tga", color_rgb(160, 100, 10));
    const struct texture *texture = model_texture(&m, MODEL_DIFFUSE, &error);
    CHECK(unlink(tga) == 0);
    CHECK(model_texture(&m, MODEL_DIFFUSE, &error) == texture); /* kept */
    CHECK(texture != NULL && texture->level[0].width == 2 &&
          (texture->level[1].texels[0] & 0xFF) == 10);
    model_free(&m);
    CHECK(m.textures[MODEL_DIFFUSE].level_count == 0);
    place_remove(&place, "a.b.off");
    CHECK(decode_right(&m, SQUARE "f 1 2 3") && model_texture(&m, MODEL_DIFFUSE, &error) == NULL);
    CHECK_ERROR(error, "a model that was not read from a file has no textures");
    model_free(&m);
}

/* The names of textures of a model without directory, without extension, and of a hidden file. */
static void test_texture_names(void) {
    static const struct {
        const char *path, *texture;
        enum model_texture_kind kind;
    } rows[] = {
        {"no_such_model.obj", "no_such_model_spec.tga", MODEL_SPECULAR},
        {"no_such.model.off", "no_such.model_nm.tga", MODEL_NORMAL_MAP},
        {"no_such_model", "no_such_model_diffuse.tga", MODEL_DIFFUSE},
        {"no.such/.model", "no.such/.model_spec.tga", MODEL_SPECULAR},
        {".no_such_model", ".no_such_model_spec.tga", MODEL_SPECULAR},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        char path[40], expected[100];
        struct model m = {.path = path};
        struct error error;
        strcpy(path, rows[i].path);
        CHECK(model_texture(&m, rows[i].kind, &error) == NULL);
        snprintf(expected, sizeof expected, "%s: no such file, nor one of another usual name",
                 rows[i].texture);
        CHECK_TEXT(error.message, expected);
    }
}

/* Other usual names, and any that is given. The first one in the list counts. */
static void test_other_names(void) {
    static const struct {
        const char *name;
        enum model_texture_kind kind;
    } rows[] = {
        {"a_basecolor.PNG", MODEL_DIFFUSE},     {"a_basecolor.tga", MODEL_DIFFUSE},
        {"a_albedo.png", MODEL_DIFFUSE},        {"a_diffuse.PGM", MODEL_DIFFUSE},
        {"a_diffuse.ppm", MODEL_DIFFUSE},       {"a_diffuse.Png", MODEL_DIFFUSE},
        {"a_diffuse.TGA", MODEL_DIFFUSE},       {"a_normal_tangent.png", MODEL_NORMAL_MAP},
        {"a_nm_tangent.tga", MODEL_NORMAL_MAP}, {"a_normal.png", MODEL_NORMAL_MAP},
        {"a_nm.PNG", MODEL_NORMAL_MAP},         {"a_specular.TGA", MODEL_SPECULAR},
        {"a_spec.png", MODEL_SPECULAR},         {"100%%", MODEL_SPECULAR},
    };
    enum { COUNT = sizeof rows / sizeof rows[0] };
    struct place place = place_create();
    char model_path[128];
    strcpy(model_path, name_file(&place, "a.obj"));
    CHECK(put_text(model_path, SQUARE "f 1 2 3\n"));
    for (size_t i = 0; i < COUNT; i++) { /* each is looked for before those above it */
        struct model m;
        struct error error = {0};
        put_picture(&place, rows[i].name, color_rgb(160, 100, (uint8_t)(i + 1)));
        CHECK(model_read(&m, model_path, &error));
        m.texture_files[rows[i].kind] = strcmp(rows[i].name, "100%%") == 0 ? place.path : NULL;
        const struct texture *texture = model_texture(&m, rows[i].kind, &error);
        if (CHECK_ROW(texture != NULL, rows[i].name)) {
            CHECK_ROW((texture->level[0].texels[0] & 0xFF) == i + 1, rows[i].name);
        }
        CHECK(m.textures[MODEL_NORMAL_MAP].tangent_space == (i == 7 || i == 8));
        CHECK(model_textures_present(&m) == (i < 7 ? 1 : i < 11 ? 2 : 3));
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
    CHECK(strstr(error.message, "/a_spec.JPG: a JPEG file, not a PNG, TGA or PPM file: ") != NULL);
    m.texture_files[MODEL_NORMAL_MAP] = "grey.png";
    CHECK(model_texture(&m, MODEL_NORMAL_MAP, &error) == NULL);
    m.texture_files[MODEL_SPECULAR] = model_path; /* what is given is read, whatever it is */
    CHECK(model_texture(&m, MODEL_SPECULAR, &error) == NULL);
    CHECK(strstr(error.message, "/a.obj: neither a PNG or PPM nor a TGA") != NULL);
    model_free(&m);
    CHECK(unlink(name_file(&place, "a_spec.JPG")) == 0);
    put_picture(&place, "a_spec.tga", color_grey(1));
    CHECK(model_read(&m, model_path, &error) && model_textures_present(&m) == 1);
    CHECK(model_texture(&m, MODEL_NORMAL_MAP, &error) == NULL);
    model_free(&m);
    CHECK(unlink(name_file(&place, "a_spec.tga")) == 0);
    place_remove(&place, "a.obj");
}

/* What a picture is taken for: normals of an object, in tangent space, grey, or none, about the
 * means that are the limits. Every second pixel has the other colour; grey and black are
 * background, and of many pixels only every second one is looked at. */
static void test_looks_of_normals(void) {
    static const struct {
        int width, height;
        uint32_t one, other;
        char look;
    } rows[] = {
        {1, 1, 0x808080, 0, 'g'},         {2, 1, 0x808080, 0x8278FA, 't'},
        {1, 2, 0x8278FA, 0, 't'},         {1, 1, 0x8080EC, 0, 't'},
        {2, 1, 0x8080EA, 0x8080EA, 'n'},  {1, 1, 0xFF80C7, 0, 'o'},
        {1, 1, 0xFF80CB, 0, 'n'},         {2, 1, 0xD980DA, 0x2680DA, 't'},
        {2, 1, 0xD980D8, 0x2680D8, 'o'},  {1, 1, 0xA4A4F9, 0, 't'},
        {1, 1, 0x5880F9, 0, 'o'},         {1, 1, 0x80A7F9, 0, 'o'},
        {31, 1, 0x8278FA, 0xC81464, 'o'}, {32, 1, 0x8278FA, 0xC81464, 't'},
        {1, 31, 0x8278FA, 0xC81464, 'o'}, {1, 32, 0x8278FA, 0xC81464, 't'},
    };
    static const int turns[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}; /* a quarter about x, y, z */
    struct place place = place_create();
    struct error error = {0};
    CHECK(directory_create(name_file(&place, "_tangent."), &error)); /* only a file's name counts */
    const char *path = name_file(&place, "_tangent./n.png");
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct texture texture = {0};
        struct image image = new_image((size_t)rows[i].width, (size_t)rows[i].height, IMAGE_BGR);
        for (int k = 0; k < rows[i].width * rows[i].height; k++) {
            uint32_t c = k % 2 == 0 ? rows[i].one : rows[i].other;
            image_set(&image, k % rows[i].width, k / rows[i].width,
                      color_rgb((uint8_t)(c >> 16), (uint8_t)(c >> 8), (uint8_t)c));
        }
        CHECK(png_write(&image, path, &error));
        bool done = model_read_normal_map(&texture, path, turns[i % 3], &error);
        const int look = !done && strstr(error.message, "grey") != NULL ? 'g'
                         : !done                                        ? 'n'
                         : texture.tangent_space                        ? 't'
                                                                        : 'o';
        CHECK_ROW(look == rows[i].look, error.message);
        size_t last = rows[i].width > 1;
        const uint32_t c = last ? rows[i].other : rows[i].one, r = c >> 16, g = c >> 8 & 255,
                       b = c & 255;
        const uint32_t turned[] = {r << 16 | (255 - b) << 8 | g, b << 16 | g << 8 | (255 - r),
                                   (255 - g) << 16 | r << 8 | b};
        CHECK(!done ||
              (texture.level[0].texels[last] & 0xFFFFFF) == (look == 'o' ? turned[i % 3] : c));
        texture_free(&texture);
        image_free(&image);
    }
    CHECK(unlink(path) == 0 && rmdir(name_file(&place, "_tangent.")) == 0);
    place_remove(&place, NULL);
}

UNIT_MAIN(TEST(test_obj), TEST(test_unwanted), TEST(test_obj_numbers), TEST(test_off),
          TEST(test_off_smallest), TEST(test_colors), TEST(test_face_colors),
          TEST(test_face_color_values), TEST(test_messages), TEST(test_binary_messages),
          TEST(test_lines), TEST(test_long_line), TEST(test_refused_files), TEST(test_textures),
          TEST(test_texture_names), TEST(test_other_names), TEST(test_looks_of_normals))
