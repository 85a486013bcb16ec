/* Materials: what OBJ files name, what is read of them, and what of it is drawn. */
#define _XOPEN_SOURCE 700 /* POSIX.1-2008 with mkdtemp() */

#include "files/model_file.h"
#include "files/mtl.h"
#include "files/png.h"
#include "unit/images.h"
#include "unit/place.h"

#include <math.h>

#define SQUARE "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\n"

static bool decode(struct model *model, const char *text) {
    struct error error = {0};
    bool done = CHECK_ROW(model_decode(model, text, strlen(text), &error), error.message);
    return done;
}

/* Which material each face has, by its number, '-' for none. */
static void test_faces(void) {
    static const struct {
        const char *text, *materials, *names, *libraries;
    } rows[] = {
        {SQUARE "f 1 2 3\n", "", "", ""},
        {SQUARE "usemtl a\nf 1 2 3\nusemtl b c \nf 1 2 3 4\nusemtl a\nf 1 2 4\n", "0110", "a;b c;",
         ""},
        {SQUARE "f 1 2 3\nusemtl x # the first\nf 1 2 3\n", "-0", "x # the first;", ""},
        {"mtllib a.mtl\nusemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\n" SQUARE, "01", "a;b;", "a.mtl;"},
        {"mtllib one two.mtl\nmtllib three.mtl\n" SQUARE "f 1 2 3\nusemtl\n", "-", ";",
         "one two.mtl;three.mtl;"},
        {SQUARE "usemtl a\nusemtl b\nf 1 2 3\n", "1", "a;b;", ""},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct model m;
        char materials[20] = "", names[100] = "", libraries[100] = "";
        if (!decode(&m, rows[i].text)) {
            continue;
        }
        for (size_t k = 0; m.face_materials != NULL && k < m.face_count; k++) {
            uint32_t index = m.face_materials[k];
            materials[k] = "0123456789-"[index == MODEL_NONE ? 10 : index];
        }
        for (size_t k = 0; k < m.material_count; k++) {
            strcat(strcat(names, m.materials[k].name), ";");
        }
        for (size_t k = 0; k < m.library_count; k++) {
            strcat(strcat(libraries, m.libraries[k]), ";");
        }
        CHECK_TEXT(materials, rows[i].materials);
        CHECK_TEXT(names, rows[i].names);
        CHECK_TEXT(libraries, rows[i].libraries);
        model_free(&m);
        CHECK(m.materials == NULL && m.libraries == NULL && m.face_materials == NULL);
    }
}

/* More names than are known apart: faces of those have none. */
static void test_many_materials(void) {
    struct bytes text = {0};
    struct model m;
    struct error error;
    CHECK(bytes_append(&text, SQUARE, strlen(SQUARE)));
    for (int i = 0; i < 1026; i++) {
        CHECK(bytes_print(&text, "usemtl m%d\nf 1 2 3\n", i));
    }
    if (CHECK(model_decode(&m, text.data, text.size, &error))) {
        CHECK(m.material_count == 1024 && m.face_materials[1023] == 1023);
        CHECK(m.face_materials[1024] == MODEL_NONE && m.face_materials[1025] == MODEL_NONE);
    }
    model_free(&m);
    bytes_free(&text);
}

/* What a file says of the material "a". */
static void test_statements(void) {
    static const struct {
        const char *text;
        float color[3];
        const char *texture;
        bool known;
    } rows[] = {
        {"", {1, 1, 1}, NULL, false},
        {"newmtl b\nKd 0 0 0\nmap_Kd x.png\n", {1, 1, 1}, NULL, false},
        {"Kd 0 0 0\nnewmtl a\n", {1, 1, 1}, NULL, true},
        {"newmtl a\nKd 0.25 0.5 1\nKs 1 1 1\nKdx 0 0 0\n", {0.25F, 0.5F, 1}, NULL, true},
        {"newmtl b\nKd 1 1 1\nnewmtl a \n\tKd 0.5\n", {0.5F, 0.5F, 0.5F}, NULL, true},
        {"newmtl a\nKd 2 -1 nan\n", {1, 0, 0}, NULL, true},
        {"newmtl a\nKd 0 0 0\nnewmtl a\nKd 0 1 0\n", {0, 1, 0}, NULL, true},
        {"newmtl a\nmap_Kd wood.png\n", {1, 1, 1}, "d/wood.png", true},
        {"NEWMTL a\nKD 0 1 0\nmap_kd wood.png\n", {0, 1, 0}, "d/wood.png", true},
        {"newmtl a\nmap_Kd  old oak.png \r\n", {1, 1, 1}, "d/old oak.png", true},
        {"newmtl a\nmap_Kd C:\\maps\\oak.png\n", {1, 1, 1}, "d/C:/maps/oak.png", true},
        {"newmtl a\nmap_Kd -clamp on -bm 0.5 x.png\n", {1, 1, 1}, "d/x.png", true},
        {"newmtl a\nmap_Kd -s 2 2 2 -o 0.5 x.png\n", {1, 1, 1}, "d/x.png", true},
        {"newmtl a\nmap_Kd -mm 0 1 -t 1 2 2.png\n", {1, 1, 1}, "d/2.png", true},
        {"newmtl a\nmap_Kd x.png\nmap_Kd y.png\n", {1, 1, 1}, "d/y.png", true},
        {"newmtl a\nmap_Kd\n", {1, 1, 1}, NULL, true},
        {"newmtl a\nmap_Kd -clamp\n", {1, 1, 1}, NULL, true},
        {"newmtl a\nmap_bump x.png\nmap_Kd_ x.png\n", {1, 1, 1}, NULL, true},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct model m;
        struct error error;
        if (!decode(&m, SQUARE "usemtl a\nf 1 2 3\n")) {
            return;
        }
        size_t size = strlen(rows[i].text);
        char *copy = exact_copy(rows[i].text, size);
        CHECK_ROW(mtl_decode(&m, copy, size, "d/", &error), rows[i].text);
        const struct model_material *a = &m.materials[0];
        CHECK_ROW(memcmp(a->color, rows[i].color, sizeof a->color) == 0, rows[i].text);
        CHECK_ROW(a->known == rows[i].known, rows[i].text);
        CHECK_TEXT(a->texture != NULL ? a->texture : "none",
                   rows[i].texture != NULL ? rows[i].texture : "none");
        free(copy);
        model_free(&m);
    }
    struct model m;
    struct error error;
    if (decode(&m, SQUARE "usemtl a\nf 1 2 3\n")) {
        CHECK(mtl_decode(&m, "newmtl a\n\0", 10, "", &error) && !m.materials[0].known);
        CHECK(!model_has_materials(&m));
        model_free(&m);
    }
}

/* The other numbers of the material "a": shine, power, hidden (d) or transparent in
 * part (g and the line that the warning names), the map's options. */
static void test_numbers(void) {
    static const struct {
        const char *text, *expected;
    } rows[] = {
        {"", "-1 0 - none - 1 1 0 0"},
        {"Ks 0.25 0.5 0.75\nNs 30\n", "0.5 30 - none - 1 1 0 0"},
        {"Ks 0\nNs -1\nd 0.5\n", "0 0 g4 none - 1 1 0 0"},
        {"Ns 2e4\nNs x\nd 0.0\nTr 0\n", "-1 0 d none - 1 1 0 0"},
        {"d 0\nd 1\nTr 1\n", "-1 0 - none - 1 1 0 0"},
        {"Tr 0.1\n", "-1 0 g4 none - 1 1 0 0"},
        {"d 0.5\nd 0\n", "-1 0 d none - 1 1 0 0"},
        {"map_d leaf.png\n", "-1 0 g4 none - 1 1 0 0"},
        {"map_Ks -clamp on s.png\n", "-1 0 - s.png - 1 1 0 0"},
        {"map_Ks s.png\nmap_Ns t.png\n", "-1 0 - t.png - 1 1 0 0"},
        {"map_Kd -clamp on -s 2 3 4 -o 0.5 x.png\n", "-1 0 - none c 2 3 0.5 0"},
        {"map_Kd -clamp off -o -1 2 -t 7 7 7 -s 9e9 x.png\n", "-1 0 - none - 1 1 -1 2"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct model m;
        struct error error;
        char text[200], got[200], clear[30] = "-";
        snprintf(text, sizeof text, "newmtl a\n%s", rows[i].text);
        if (!decode(&m, "usemtl b\nusemtl c\n\nusemtl a\n" SQUARE "f 1 2 3\n")) {
            return;
        }
        CHECK(mtl_decode(&m, text, strlen(text), "", &error));
        const struct model_material *a = &m.materials[2];
        if (m.warning_line[MODEL_GLASSY] > 0) {
            snprintf(clear, sizeof clear, "g%zu", m.warning_line[MODEL_GLASSY]);
        }
        snprintf(got, sizeof got, "%g %g %s %s %s %g %g %g %g", (double)a->specular,
                 (double)a->power, a->hidden ? "d" : clear, a->shine == NULL ? "none" : a->shine,
                 a->clamp ? "c" : "-", (double)a->scale[0], (double)a->scale[1],
                 (double)a->offset[0], (double)a->offset[1]);
        CHECK_TEXT(got, rows[i].expected);
        model_free(&m);
    }
}

/* norm says more than the names of bumps, and may come before or after them. */
static void test_bumps(void) {
    static const struct {
        const char *text, *bumps;
        bool is_norm;
        float bump;
    } rows[] = {
        {"norm n.png\n", "n.png", true, 1},
        {"map_Bump -bm 0.5 b.png\n", "b.png", false, 0.5F},
        {"map_bump -bm -2 b c.png\n", "b c.png", false, 1},
        {"bump -imfchan l -clamp on -bm 4 b.png\n", "b.png", false, 4},
        {"bump a.png\nnorm -bm 3 n.png\nmap_Bump b.png\n", "n.png", true, 3},
        {"bump -bm 2 a.png\nmap_Bump b.png\n", "b.png", false, 1},
        {"bump -bm 2 a.png\nmap_Kd -bm 3 c.png\nmap_Ks -bm 5 s.png\n", "a.png", false, 2},
        {"map_Kn b.png\nnormal b.png\n", "", false, 1},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct model m;
        struct error error;
        char text[200];
        snprintf(text, sizeof text, "newmtl a\n%s", rows[i].text);
        if (!decode(&m, SQUARE "usemtl a\nf 1 2 3\n")) {
            return;
        }
        CHECK(mtl_decode(&m, text, strlen(text), "", &error));
        const struct model_material *a = &m.materials[0];
        CHECK_TEXT(a->bumps == NULL ? "" : a->bumps, rows[i].bumps);
        CHECK_ROW(a->is_norm == rows[i].is_norm && !a->clamp, rows[i].text);
        CHECK_ROW(a->bump == rows[i].bump, rows[i].text);
        model_free(&m);
    }
}

static void put_picture(struct place *place, const char *name, struct color color) {
    struct image image = new_image(2, 2, IMAGE_BGR);
    struct error error;
    image_clear(&image, color);
    CHECK(png_write(&image, name_file(place, name), &error));
    image_free(&image);
}

/* Beside the model and in its file's directories. */
static void test_files(void) {
    static const char *const names[] = {"m.obj", "m.mtl", "two names.mtl", "red.png",
                                        "m_diffuse.png"};
    struct place place = place_create();
    char path[128];
    struct model m;
    struct error error = {0};
    strcpy(path, name_file(&place, "m.obj"));
    CHECK(put_text(path,
                   "mtllib no.mtl m.mtl\nmtllib two names.mtl\n" SQUARE
                   "usemtl red\nf 1/1 2/1 3/1\nusemtl blue\nf 1 2 4\nusemtl none\nf 1 2 3\n"));
    CHECK(put_text(name_file(&place, "m.mtl"), "newmtl blue\nKd 0 0 0.6\n"));
    CHECK(put_text(name_file(&place, "two names.mtl"), "newmtl red\nmap_Kd maps/red.png\n"));
    put_picture(&place, "red.png", color_rgb(200, 10, 20));
    put_picture(&place, "m_diffuse.png", color_rgb(1, 2, 3));
    if (CHECK_ROW(model_read(&m, path, &error), error.message)) {
        CHECK(m.material_count == 3 && m.warning_line[MODEL_MATERIALS_MISSING] == 0);
        CHECK(model_has_materials(&m) && strstr(m.materials[0].texture, "/red.png") != NULL);
        CHECK(m.bytes_read == file_size(path) + file_size(name_file(&place, "m.mtl")) +
                                  file_size(name_file(&place, "two names.mtl")));
    }
    model_free(&m);
    /* A texture; colours alone, which a texture beside the model outdoes; a file
     * that is not there. */
    CHECK(put_text(path, "mtllib two names.mtl\n" SQUARE "usemtl red\nf 1 2 3\n"));
    CHECK(model_read(&m, path, &error) && model_has_materials(&m));
    model_free(&m);
    CHECK(put_text(path, "mtllib m.mtl\n" SQUARE "usemtl blue\nf 1 2 3\n"));
    CHECK(model_read(&m, path, &error) && !model_has_materials(&m));
    model_free(&m);
    CHECK(put_text(path, "\nmtllib no.mtl\n" SQUARE "usemtl blue\nf 1 2 3\n"));
    CHECK(model_read(&m, path, &error) && m.warning_line[MODEL_MATERIALS_MISSING] == 2);
    CHECK(!model_has_materials(&m));
    model_free(&m);
    CHECK(model_read_parts(&m, path, MODEL_NORMALS, &error)); /* no picture needs it */
    CHECK(m.warning_line[MODEL_MATERIALS_MISSING] == 0);
    model_free(&m);
    CHECK(put_text(path, "mtllib no.mtl\n" SQUARE "f 1 2 3\n")); /* no face needs it */
    CHECK(model_read(&m, path, &error) && m.warning_line[MODEL_MATERIALS_MISSING] == 0);
    model_free(&m);
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        CHECK(unlink(name_file(&place, names[i])) == 0);
    }
    place_remove(&place, NULL);
}

/* Write ASCII as Windows writes "Unicode". */
static bool put_utf16(const char *path, const char *text) {
    struct bytes bytes = {0};
    struct error error;
    bool done = bytes_append(&bytes, "\xFF\xFE", 2);
    for (; done && *text != '\0'; text++) {
        const char unit[2] = {*text, 0};
        done = bytes_append(&bytes, unit, 2);
    }
    done = done && file_write(path, bytes.data, bytes.size, &error);
    bytes_free(&bytes);
    return done;
}

/* Model and materials in UTF-16; messages count their lines, and --stats their bytes. */
static void test_utf16(void) {
    struct place place = place_create();
    struct model m;
    struct error error;
    CHECK(put_utf16(name_file(&place, "a.mtl"), "newmtl a\nKd 0 1 0\n"));
    CHECK(put_utf16(name_file(&place, "a.obj"), "mtllib a.mtl\r\nusemtl a\r\n" SQUARE "f 1 2 3\n"));
    CHECK(model_read(&m, place.path, &error) && m.face_count == 1 && m.positions[1].x == 1);
    CHECK(m.material_count == 1 && m.materials[0].color[0] == 0 && m.materials[0].color[1] == 1);
    CHECK(m.bytes_read == file_size(place.path) + 2 + 2 * strlen("newmtl a\nKd 0 1 0\n"));
    model_free(&m);
    CHECK(put_utf16(place.path, "v 0 0 0\nf 1 2 3\n") && !model_read(&m, place.path, &error));
    CHECK(strstr(error.message, "/a.obj:2: face names vertex 2 of 1") != NULL);
    CHECK(unlink(name_file(&place, "a.obj")) == 0);
    place_remove(&place, "a.mtl");
}

UNIT_MAIN(TEST(test_utf16), TEST(test_faces), TEST(test_many_materials), TEST(test_statements),
          TEST(test_numbers), TEST(test_bumps), TEST(test_files))
