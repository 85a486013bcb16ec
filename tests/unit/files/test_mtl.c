/* Materials: what OBJ files name, what is read of them, and what of it is drawn. */
#define _XOPEN_SOURCE 700 /* POSIX.1-2008 with mkdtemp() */

#include "files/mtl.h"
#include "unit/models.h"

#define TEXTURED SQUARE "vt 0 0\n"

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
        if (!decode_right(&m, rows[i].text)) {
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
            strcat(strcat(libraries, m.libraries[k].name), ";");
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
        CHECK(bytes_print(&text, "g x\nmtllib l\nusemtl m%d\nf 1 2 3\n", i));
    }
    if (CHECK(model_decode(&m, text.data, text.size, &error))) {
        CHECK(m.library_count == 1026 && m.libraries[0].line == 6 &&
              m.libraries[1025].line == 4106);
        CHECK(m.material_count == 1024 && m.face_materials[1023] == 1023);
        CHECK(m.face_materials[1024] == MODEL_NONE && m.face_materials[1025] == MODEL_NONE);
    }
    model_free(&m);
    bytes_free(&text);
}

static const char *name_or_none(const char *name) {
    return name != NULL ? name : "none";
}

/* What a file says of the material "a": colour and maps; shine, power, hidden (d) or transparent in
 * part (g), specular map, the options of the colour's map, and how steep bumps are. */
static void test_statements(void) {
#define PLAIN "-1 0 - none - 1 1 0 0 1"
    static const struct {
        const char *text, *look, *numbers;
    } rows[] = {
        {"", "1 1 1 none none unknown", PLAIN},
        {"newmtl b\nKd 0 0 0\nmap_Kd x.png\n", "1 1 1 none none unknown", PLAIN},
        {"Kd 0 0 0\nnewmtl a\n", "1 1 1 none none", PLAIN},
        {"newmtl a\nKd 0.25 0.5 1\nKdx 0 0 0\n", "0.25 0.5 1 none none", PLAIN},
        {"newmtl b\nKd 1 1 1\nnewmtl a \n\tKd 0.5\n", "0.5 0.5 0.5 none none", PLAIN},
        {"newmtl a\nKd 2 -1 nan\n", "1 0 0 none none", PLAIN},
        {"newmtl a\nKd 1.5 nan -0\n", "1 0 0 none none", PLAIN},
        {"newmtl a\nKd 0 0 0\nnewmtl a\nKd 0 1 0\n", "0 1 0 none none", PLAIN},
        {"newmtl a\nKd 2.55 0 1.02\nKd spectral x.rfl\nKd\n", "0.01 0 0.004 none none", PLAIN},
        /* Of ambient light, unless it is what programs write with every material. */
        {"newmtl a\nKa 0 1 0\n", "1 1 1 none none Ka 0 1 0", PLAIN},
        {"newmtl a\nKa 1 0 0\n", "1 1 1 none none Ka 1 0 0", PLAIN},
        {"newmtl a\nka 0.5\nKd 0 1 0\n", "0 1 0 none none Ka 0.5 0.5 0.5", PLAIN},
        {"newmtl a\nKa 0.2 0.2 0.25\n", "1 1 1 none none Ka 0.2 0.2 0.25", PLAIN},
        {"newmtl a\nKa 1 0 0\nKa 0 0 0\n", "1 1 1 none none", PLAIN},
        {"newmtl a\nKa 0.200000 0.200000 0.200000\n", "1 1 1 none none", PLAIN},
        {"newmtl a\nKa 1.0\n", "1 1 1 none none", PLAIN},
        {"newmtl a\nKa 20 20 20\n", "1 1 1 none none", PLAIN},
        {"newmtl a\nKa 0.5 0.5 -0.5\n", "1 1 1 none none", PLAIN},
        {"newmtl a\nKa 0.5 0.5 1.5\n", "1 1 1 none none", PLAIN},
        {"newmtl a\nKa spectral x.rfl\nKa 0.5 nan 0.5\nKa\n", "1 1 1 none none", PLAIN},
        {"newmtl a\nmap_Kd wood.png\n", "1 1 1 d/wood.png none", PLAIN},
        {"newmtl a\nmap_Kd  old oak.png \r\n", "1 1 1 d/old oak.png none", PLAIN},
        {"newmtl a\nmap_Kd \"old oak.png\"\n", "1 1 1 d/old oak.png none", PLAIN},
        {"newmtl a\nmap_Kd oak.png  # of the table\n", "1 1 1 d/oak.png none", PLAIN},
        {"newmtl a\nmap_Kd old - oak.png -clamp on # x\n", "1 1 1 d/old - oak.png none", PLAIN},
        {"newmtl a\nmap_Kd oak.png -c\nbump a -", "1 1 1 d/oak.png d/a -", PLAIN},
        {"newmtl a\nmap_Kd # none\nbump \"\"\n", "1 1 1 none d/", PLAIN},
        {"newmtl a\nmap_Kd C:\\maps\\oak.png\n", "1 1 1 d/C:/maps/oak.png none", PLAIN},
        {"newmtl a\nmap_Kd -mm 0 1 -bm 0.5 -t 1 2 2.png\n", "1 1 1 d/2.png none", PLAIN},
        {"newmtl a\nmap_Kd x.png\nmap_Kd - y.texture\n", "1 1 1 d/- y.texture none", PLAIN},
        {"newmtl a\nmap_Kd \"\nbump\n", "1 1 1 d/\" none", PLAIN},
        {"newmtl a\nmap_Kd -clamp\n", "1 1 1 none none", PLAIN},
        {"newmtl a\nmap_bumps x.png\nmap_Kd_ x.png\n", "1 1 1 none none", PLAIN},
        {"newmtl a\nKs 0.25 0.5 0.75\nNs 9\n", "1 1 1 none none", "0.5 9 - none - 1 1 0 0 1"},
        {"newmtl a\nKs x\nNs 0.5\nNs -1\nd 0.5\n", "1 1 1 none none", "0 0.5 g none - 1 1 0 0 1"},
        {"newmtl a\nNs 9\nNs 0\nNs 10000.5\nNs x\nd 0.0\nTr 0\n", "1 1 1 none none",
         "-1 0 d none - 1 1 0 0 1"},
        {"newmtl a\nNs 1e4\nd 0\nd 1\nTr 0\n", "1 1 1 none none", "-1 10000 - none - 1 1 0 0 1"},
        {"newmtl a\nTr 0.1\n", "1 1 1 none none", "-1 0 g none - 1 1 0 0 1"},
        {"newmtl a\nd 0.5\nd 0\n", "1 1 1 none none", "-1 0 d none - 1 1 0 0 1"},
        {"newmtl a\nmap_d leaf.png\n", "1 1 1 none none", "-1 0 g none - 1 1 0 0 1"},
        {"NEWMTL a\nKD 0 1 0\nmap_kd wood.png\n", "0 1 0 d/wood.png none", PLAIN},
        {"newmtl a\nmap_Ks -clamp on s.png\n", "1 1 1 none none", "-1 0 - d/s.png - 1 1 0 0 1"},
        {"newmtl a\nmap_Ks s.png\nmap_Ns t.png\n", "1 1 1 none none", "-1 0 - d/t.png - 1 1 0 0 1"},
        {"newmtl a\nmap_Kd -clamp on -o 0.5 -s 2 3 4 x.png\n", "1 1 1 d/x.png none",
         "-1 0 - none c 2 3 0.5 0 1"},
        {"newmtl a\nmap_Kd -clamp off -o -1e6 1e6 -s 1000001 -1000001 -t 7 7 7 8\n",
         "1 1 1 d/8 none", "-1 0 - none - 1 1 -1e+06 1e+06 1"},
        /* norm says more than the names of bumps, and may come before or after them. */
        {"newmtl a\nnorm n.png\n", "1 1 1 none d/n.png norm", PLAIN},
        {"newmtl a\nmap_Bump -bm 0.5 b.png\n", "1 1 1 none d/b.png", "-1 0 - none - 1 1 0 0 0.5"},
        {"newmtl a\nmap_bump -bm 100.5 b.png\n", "1 1 1 none d/b.png", PLAIN},
        {"newmtl a\nmap_bump -bm 0 b c.png\n", "1 1 1 none d/b c.png", PLAIN},
        {"newmtl a\nbump -imfchan l -clamp on -bm 100 b.png\n", "1 1 1 none d/b.png",
         "-1 0 - none - 1 1 0 0 100"},
        {"newmtl a\nbump a.png\nnorm -bm 3 n.png\nmap_Bump b.png\n", "1 1 1 none d/n.png norm",
         "-1 0 - none - 1 1 0 0 3"},
        {"newmtl a\nbump -bm 2 a.png\nmap_Bump b.png\n", "1 1 1 none d/b.png", PLAIN},
        {"newmtl a\nbump -bm 2 a.png\nmap_Kd -bm 3 c.png\nmap_Ks -bm 5 s.png\n",
         "1 1 1 d/c.png d/a.png", "-1 0 - d/s.png - 1 1 0 0 2"},
        {"newmtl a\nmap_Kn b.png\nnormal b.png\n", "1 1 1 none none", PLAIN},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct model m;
        struct error error;
        char look[200], numbers[200];
        if (!decode_right(&m, SQUARE "usemtl a\nf 1 2 3\n")) {
            return;
        }
        size_t size = strlen(rows[i].text);
        char *copy = exact_copy(rows[i].text, size);
        CHECK_ROW(mtl_decode(&m, copy, size, "d/", &error), rows[i].text);
        const struct model_material *a = &m.materials[0];
        snprintf(look, sizeof look, "%g %g %g %s %s%s%s", (double)a->color[0], (double)a->color[1],
                 (double)a->color[2], name_or_none(a->texture), name_or_none(a->bumps),
                 a->is_norm ? " norm" : "", a->known ? "" : " unknown");
        if (a->has_ambient) {
            size_t length = strlen(look);
            snprintf(look + length, sizeof look - length, " Ka %g %g %g", (double)a->ambient[0],
                     (double)a->ambient[1], (double)a->ambient[2]);
        }
        snprintf(numbers, sizeof numbers, "%g %g %s %s %s %g %g %g %g %g", (double)a->specular,
                 (double)a->power,
                 a->hidden   ? "d"
                 : a->glassy ? "g"
                             : "-",
                 name_or_none(a->shine), a->clamp ? "c" : "-", (double)a->scale[0],
                 (double)a->scale[1], (double)a->offset[0], (double)a->offset[1], (double)a->bump);
        CHECK_TEXT(look, rows[i].look);
        CHECK_TEXT(numbers, rows[i].numbers);
        free(copy);
        model_free(&m);
    }
    struct model m;
    struct error error;
    if (decode_right(&m, SQUARE "usemtl a\nf 1 2 3\n")) {
        CHECK(mtl_decode(&m, "newmtl a\n\0 ", 11, "", &error) && !m.materials[0].known);
        CHECK(!model_has_materials(&m));
        model_free(&m);
    }
}

/* Beside the model and in its file's directories. */
static void test_files(void) {
    struct place place = place_create();
    char path[128], red[128];
    struct model m;
    struct error error = {0};
    strcpy(path, name_file(&place, "m.obj"));
    CHECK(put_text(path,
                   "mtllib no.mtl m.MTL\nmtllib two names.mtl\n" TEXTURED
                   "usemtl red\nf 1/1 2/1 3/1\nusemtl blue\nf 1 2 4\nusemtl none\nf 1 2 3\n"));
    CHECK(put_text(name_file(&place, "m.mtl"), "newmtl blue\nKd 0 0 0.6\nd 0.5\n"));
    CHECK(
        put_text(name_file(&place, "two names.mtl"), "newmtl red\nmap_Kd C:\\maps\\red -b.PNG\n"));
    put_picture(&place, "red -b.png", color_rgb(200, 10, 20));
    put_picture(&place, "m_diffuse.png", color_rgb(1, 2, 3));
    if (CHECK_ROW(model_read(&m, path, &error), error.message)) {
        CHECK(m.material_count == 3 && m.warning_line[MODEL_LIBRARY_MISSING] == 0);
        CHECK(m.materials[1].color[2] == 0.6F && m.warning_line[MODEL_GLASSY] == 10);
        CHECK(model_has_materials(&m));
        CHECK_TEXT(m.materials[0].texture, name_file(&place, "red -b.png"));
    }
    model_free(&m);
    /* A texture; colours alone, which a texture next to the model outdoes; a file
     * that is not there. */
    strcpy(red, name_file(&place, "red -b.png"));
    CHECK(rename(red, name_file(&place, "red.JP2")) == 0);
    CHECK(put_text(name_file(&place, "two names.mtl"), "newmtl red\nmap_Kd red.Jp2\n"));
    CHECK(put_text(path,
                   "mtllib two names.mtl\n" TEXTURED "usemtl no\nf 1 2 3\nusemtl red\nf 1 2 3\n"));
    CHECK(model_read(&m, path, &error) && model_has_materials(&m));
    CHECK(strstr(m.materials[1].texture, "/red.JP2") != NULL);
    model_free(&m);
    CHECK(put_text(path, "mtllib m.mtl\n" TEXTURED "usemtl blue\nf 1 2 3\n"));
    CHECK(model_read(&m, path, &error) && !model_has_materials(&m));
    model_free(&m);
    CHECK(put_text(path, "\nmtllib no.mtl\n" TEXTURED "usemtl blue\nf 1 2 3\n"));
    CHECK(model_read(&m, path, &error) && m.warning_line[MODEL_LIBRARY_MISSING] == 2);
    CHECK_TEXT(m.warning_name[MODEL_LIBRARY_MISSING], "no.mtl");
    CHECK(!model_has_materials(&m));
    model_free(&m);
    CHECK(model_read_parts(&m, path, MODEL_NORMALS, &error)); /* no picture needs it */
    CHECK(m.warning_line[MODEL_LIBRARY_MISSING] == 0);
    model_free(&m);
    CHECK(put_text(path, "mtllib no.mtl\n" TEXTURED "f 1 2 3\n")); /* no face needs it */
    CHECK(model_read(&m, path, &error) && m.warning_line[MODEL_LIBRARY_MISSING] == 0);
    model_free(&m);
    place_remove(&place, "m.obj,m.mtl,two names.mtl,red.JP2,m_diffuse.png");
}

/* Which material of the model a name in its file of materials means, and what is said of those that
 * are missing. */
static void test_names(void) {
    static const struct {
        const char *model, *materials, *known, *missing;
        size_t glass; /* the line of the warning */
    } rows[] = {
        {"usemtl m\nf 1 2 3\n", "newmtl m\n", "1", NULL, 0},
        {"usemtl m\nf 1 2 3\nusemtl o\nf 1 2 3\n", "newmtl o\nd .5\nnewmtl m\nd 1\n", "11", NULL,
         11},
        {"usemtl m\nf 1 2 3\nusemtl o\nf 1 2 3\n", "newmtl m\nd .5\nnewmtl o\nd .1\n", "11", NULL,
         9},
        {"usemtl m\nf 1 2 3\n", "newmtl m\nd .5\nd 0\n", "1", NULL, 0},
        {"usemtl m # skin\nf 1 2 3\n", "newmtl m\n", "1", NULL, 0},
        {"usemtl m\nf 1 2 3\n", "newmtl m # skin\n", "1", NULL, 0},
        {"usemtl Material #25\nf 1 2 3\nusemtl Material #26\nf 1 2 3\n",
         "newmtl Material #26\nnewmtl Material #25\n", "11", NULL, 0},
        {"usemtl Material #25\nf 1 2 3\nusemtl Material #26\nf 1 2 3\n",
         "newmtl Material #25\nnewmtl Material #27\n", "10", "11: Material #26", 0},
        {"usemtl two words\nf 1 2 3\n", "newmtl two words \n", "1", NULL, 0},
        {"usemtl n\nf 1 2 3\nusemtl o\nf 1 2 3\n", "newmtl m\n", "00", "9: n", 0},
        {"usemtl m\nf 1 2 3\nusemtl o\nf 1 2 3\n", "newmtl m\n", "10", "11: o", 0},
        {"usemtl None\nf 1 2 3\nusemtl (null)\nf 1 2 3\nusemtl\nf 1 2 3\n", "newmtl m\n", "000",
         NULL, 0},
    };
    struct place place = place_create();
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        char text[300], known[10] = "", missing[60] = "";
        struct model m;
        struct error error = {0};
        snprintf(text, sizeof text, "mtllib M.MTL # all\n" TEXTURED "\n\n%s", rows[i].model);
        CHECK(put_text(name_file(&place, "m.mtl"), rows[i].materials));
        CHECK(put_text(name_file(&place, "m.obj"), text));
        if (CHECK_ROW(model_read(&m, place.path, &error), error.message)) {
            for (size_t k = 0; k < m.material_count; k++) {
                strcat(known, m.materials[k].known ? "1" : "0");
            }
            CHECK_TEXT(known, rows[i].known);
            CHECK(m.warning_line[MODEL_LIBRARY_MISSING] == 0);
            CHECK_ROW(m.warning_line[MODEL_GLASSY] == rows[i].glass, rows[i].materials);
            const size_t line = m.warning_line[MODEL_MATERIAL_MISSING];
            snprintf(missing, sizeof missing, "%zu: %s", line,
                     line > 0 ? m.warning_name[MODEL_MATERIAL_MISSING] : "");
            CHECK_ROW(rows[i].missing == NULL ? line == 0 : strcmp(missing, rows[i].missing) == 0,
                      missing);
        }
        model_free(&m);
    }
    place_remove(&place, "m.obj,m.mtl");
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

/* Model and materials in UTF-16; messages count their lines. */
static void test_utf16(void) {
    struct place place = place_create();
    struct model m;
    struct error error;
    CHECK(put_utf16(name_file(&place, "a.mtl"), "newmtl a\nKd 0 1 0\n"));
    CHECK(put_utf16(name_file(&place, "a.obj"), "mtllib a.mtl\r\nusemtl a\r\n" SQUARE "f 1 2 3\n"));
    CHECK(model_read(&m, place.path, &error) && m.face_count == 1 && m.positions[1].x == 1);
    CHECK(m.material_count == 1 && m.materials[0].color[0] == 0 && m.materials[0].color[1] == 1);
    model_free(&m);
    CHECK(put_utf16(place.path, "v 0 0 0\nf 1 2 3\n") && !model_read(&m, place.path, &error));
    CHECK(strstr(error.message, "/a.obj:2: face names vertex 2 of 1") != NULL);
    place_remove(&place, "a.obj,a.mtl");
}

UNIT_MAIN(TEST(test_utf16), TEST(test_faces), TEST(test_many_materials), TEST(test_statements),
          TEST(test_files), TEST(test_names))
