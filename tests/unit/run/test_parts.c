/* Parts of a model with materials: which faces and coordinates they have, and which textures. */
#define _XOPEN_SOURCE 700 /* POSIX.1-2008 with mkdtemp() */

#include "run/parts.h"
#include "unit/models.h"

#include <math.h>

#define TEXTURED SQUARE "vt 0 0\nvt 1 0\nvt 1 0.5\n"

/* Faces by their first positions, and the colour of the texture. */
static void describe(const struct parts *parts, size_t i, char *text, size_t size) {
    const struct drawing_part *part = &parts->part[i];
    const struct texture *colors = &part->diffuse; /* of one colour, also from far away */
    const struct texture_level *l = colors->level;
    CHECK(*l->texels == *l[colors->level_count - 1].texels && *l->texels >> 24 == 255);
    CHECK(*l->texels == l->texels[l->pitch * l->height]);
    for (size_t face = 0; face < part->model.face_count; face++) {
        string_append(text, size, "%u", part->model.faces[face].corner[0].position);
    }
    CHECK(part->model.face_colors == NULL && (part->repeats == 1) == (part->model.uv_count == 0));
    string_append(text, size, "%s %06X%s", part->specular.level_count > 0 ? " Ks" : "",
                  part->diffuse.level[0].texels[0] & 0xFFFFFF, part->diffuse.clamp ? " c" : "");
    if (part->ambient.level_count > 0) {
        string_append(text, size, " Ka %06X%s", part->ambient.level[0].texels[0] & 0xFFFFFF,
                      part->ambient.clamp ? " c" : "");
    }
    string_append(text, size, ";");
}

/* Read a model of these faces and materials; CHECK what its parts are. */
static bool read_parts(struct place *place, struct model *model, struct parts *parts,
                       struct error *missing, const char *faces, const char *materials) {
    struct bytes text = {0};
    struct error error = {0};
    *parts = (struct parts){0};
    *missing = (struct error){0};
    bool done =
        CHECK(put_text(name_file(place, "m.mtl"), materials)) &&
        CHECK(bytes_print(&text, "mtllib m.mtl\n%s%s", faces[0] == 'v' ? "" : TEXTURED, faces)) &&
        CHECK(file_write(name_file(place, "m.obj"), text.data, text.size, &error)) &&
        CHECK_ROW(model_read(model, name_file(place, "m.obj"), &error), error.message) &&
        CHECK(parts_move_coordinates(model, &error)) &&
        CHECK(parts_make(parts, model, missing, &error));
    bytes_free(&text);
    return done;
}

static void test_parts(void) {
    static const struct {
        const char *faces, *materials, *parts, *missing;
    } rows[] = {
        {"f 1 2 3\nusemtl a\nf 2 3 4\nf 3 4 1\nusemtl b\nf 4 1 2\nusemtl a\nf 1 2 4\n",
         "newmtl a\nKd 1 0 0\nnewmtl b\nKd 0 0 0.6\n", "120 FF0000;3 000099;0 FFFFFF;", ""},
        {"usemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 2/1 3/2 4/3\nusemtl c\nf 3 4 1\n",
         "newmtl a\nmap_Kd red.png\nKs 0\nNs 5\nmap_Ks red.png\nnewmtl b\nKs 0.5\nmap_Kd -clamp on "
         "red.png\nnewmtl c\nKd 0 1 0\n",
         "0 Ks C80A14;1 C80A14 c;2 00FF00;", ""},
        {SQUARE "usemtl a\nf 1 2 3\n", "newmtl a\nKd 0 1 0\nmap_Kd red.png\nmap_Ks red.png\n",
         "0 00FF00;", ""}, /* without places in a picture */
        {SQUARE "vt 0 0\nusemtl a\nf 1/1 2/1 3/1\n", "newmtl a\nmap_Kd red.png\nmap_Ks red.png\n",
         "0 Ks C80A14;", ""},
        {"usemtl a\nf 1 2 3\nusemtl b\nf 2 3 4\nusemtl c\nf 3 4 1\n",
         "newmtl a\nKd 0 0 1\nmap_Kd no.png\nnewmtl b\nmap_Kd no.png\nnewmtl c\nmap_Kd no2.png\n",
         "0 0000FF;1 FFFFFF;2 FFFFFF;", "no.png: No such file"},
        {"usemtl a\nf 1 2 3\nusemtl b\nf 2 3 4\n", "newmtl a\nd 0\nnewmtl b\nd 0.5\n", "1 FFFFFF;",
         ""},
        {"usemtl a\nf 1 2 3\n", "newmtl a\nd 0\n", "", ""},
        /* A colour tints the picture, and is read again for it; a grey one does not. */
        {"usemtl a\nf 1 2 3\nusemtl b\nf 2 3 4\nusemtl c\nf 3 4 1\nusemtl d\nf 1 2 3\n",
         "newmtl d\nKd 1 0.5 1\nmap_Kd red.png\nnewmtl a\nKd 0 0 0\nmap_Kd red.png\nnewmtl b\nKd "
         "0.5 1 1\nmap_Kd red.png\n"
         "newmtl c\nKd 0.8 0.8 0.8\nmap_Kd red.png\n",
         "0 C80A14;1 640A14;2 C80A14;0 C80514;", ""},
        /* A colour of ambient light likewise, and alone where there is no picture. */
        {"usemtl a\nf 1 2 3\nusemtl b\nf 2 3 4\nusemtl c\nf 3 4 1\n",
         "newmtl a\nKd 0 0 1\nKa 1 0 0\nnewmtl b\nKa 1 1 0.25\nmap_Kd -clamp on red.png\n"
         "newmtl c\nKd 0 1 0\nKa 0 0.6 0.6\nmap_Kd no.png\n",
         "0 0000FF Ka FF0000;1 C80A14 c Ka C80A05 c;2 00FF00 Ka 009999;", "no.png: No such file"},
    };
    struct place place = place_create();
    put_picture(&place, "red.png", color_rgb(200, 10, 20));
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct model model;
        struct parts parts;
        struct error missing, error;
        char text[200] = "", again[200] = "";
        if (read_parts(&place, &model, &parts, &missing, rows[i].faces, rows[i].materials)) {
            for (size_t k = 0; k < parts.count; k++) {
                describe(&parts, k, text, sizeof text);
            }
            CHECK_TEXT(text, rows[i].parts);
            CHECK(parts.part[parts.count].diffuse.level_count > 0); /* also where all are hidden */
            CHECK(parts.part[parts.count].model.face_count == model.face_count);
            CHECK(strstr(missing.message, rows[i].missing) != NULL);
            CHECK((missing.message[0] == '\0') == (rows[i].missing[0] == '\0'));
            /* Made again, they are the same, and no file is read twice. */
            const struct drawing_part *first = &parts.part[0], *second = &parts.part[1];
            CHECK(i != 1 || (first->specular.texels == first->diffuse.texels && /* read once */
                             first->diffuse.texels == second->diffuse.texels &&
                             first->specular_weight == -1 && first->power == 5 &&
                             second->specular.level_count == 0 && second->specular_weight == 0.5));
            CHECK(i != 0 || (parts.part[2].power == 0 && parts.part[2].specular_weight == -1));
            size_t pictures = parts.picture_count;
            CHECK(parts_make(&parts, &model, &missing, &error) && parts.picture_count == pictures);
            for (size_t k = 0; k < parts.count; k++) {
                describe(&parts, k, again, sizeof again);
            }
            CHECK_TEXT(again, rows[i].parts);
        }
        parts_free(&parts);
        model_free(&model);
    }
    place_remove(&place, "red.png,m.mtl,m.obj");
}

/* Normal maps of materials: in which space each is, and what is said. */
static void test_normal_maps(void) {
    static const struct {
        const char *materials, *spaces, *note; /* of a and b: tangent, object or none */
    } rows[] = {
        {"newmtl a\nbump blue.png\nnewmtl b\nmap_Bump red.png\n", "to",
         "/blue.png: blue, so it is read as a normal map in tangent space"},
        {"newmtl a\nnorm blue.png\nnewmtl b\nnorm red.png\n", "tt", ""},
        {"newmtl a\nnorm -bm 0.5 blue.png\nnewmtl b\nnorm -bm 2 blue.png\n", "tt", ""},
        {"newmtl a\nnorm no.png\nnewmtl b\nKd 1 0 0\n", "--",
         "/no.png: No such file or directory; the mesh's normals instead (--normal-map)"},
        {"newmtl a\nmap_Kd red.png\nbump red.png\nnewmtl b\nbump red.png\n", "oo", ""},
        {"newmtl a\nbump grey.png\nnewmtl b\n", "--",
         "/grey.png: grey values: perhaps heights, but not normals; the mesh's normals instead "
         "(--normal-map)"},
        {"newmtl a\nbump blue.png\nnewmtl b\nbump pale.png\n", "t-",
         "/pale.png: no normals, whose values would have length 1; the mesh's normals instead"},
    };
    struct place place = place_create();
    put_picture(&place, "blue.png", color_rgb(130, 120, 250));
    put_picture(&place, "red.png", color_rgb(200, 20, 100));
    put_picture(&place, "pale.png", color_rgb(191, 192, 247));
    put_picture(&place, "grey.png", color_rgb(128, 128, 128));
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct model model;
        struct parts parts;
        struct error missing, error;
        char spaces[3] = "";
        if (!read_parts(&place, &model, &parts, &missing,
                        "usemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 2/1 3/2 4/3\n", rows[i].materials)) {
            continue;
        }
        CHECK(parts.part[0].normal_map.level_count == 0 && parts.note.message[0] == '\0');
        parts.with_normal_maps = true;
        CHECK(parts_make(&parts, &model, &missing, &error));
        for (size_t k = 0; k < 2; k++) {
            const struct texture *map = &parts.part[k].normal_map;
            spaces[k] = "-ot"[map->level_count == 0 ? 0 : 1 + map->tangent_space];
        }
        CHECK_TEXT(spaces, rows[i].spaces);
        CHECK_ROW(strstr(parts.note.message, rows[i].note) != NULL, parts.note.message);
        CHECK((parts.note.message[0] == '\0') == (rows[i].note[0] == '\0'));
        CHECK(i != 4 || parts.picture_count == 3); /* as colour, as map, and white */
        /* Half as steep: (2.5, -7.5, 122.5) becomes (1.25, -3.75, 122.5); or twice. */
        if (i == 2) {
            struct texture *half = &parts.part[0].normal_map, *twice = &parts.part[1].normal_map;
            CHECK((half->level[0].texels[0] & 0xFFFFFF) == (129 << 16 | 124 << 8 | 250));
            CHECK((twice->level[0].texels[0] & 0xFFFFFF) == (130 << 16 | 120 << 8 | 189));
        }
        parts_free(&parts);
        model_free(&model);
    }
    place_remove(&place, "blue.png,red.png,grey.png,pale.png,m.mtl,m.obj");
}

/* Some materials scale, some move, and one has the coordinates as they are. */
static void test_coordinates(void) {
    static const struct vec2 moved[] = {{1, 0.5}, {2, 0.5}, {1, 2}, {1.5, 0.5}, {1, -0.5}, {3, 0}};
    struct place place = place_create();
    struct model model;
    struct parts parts;
    struct error missing;
    if (read_parts(&place, &model, &parts, &missing,
                   "usemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 1/1 2/2 3/3\nusemtl c\nf 1/1 2/2 3/3\n"
                   "usemtl d\nf 1/1 2/2 3/3\nusemtl e\nf 1/1 2/2 3/3\n"
                   "usemtl f\nf 1/1 2/2 3/3\nf 1 2/2 3\n",
                   "newmtl a\nKd 1 1 1\nnewmtl b\nmap_Kd -s 2 1 1 no.png\n"
                   "newmtl c\nmap_Kd -s 1 4 1 no.png\nnewmtl d\nmap_Kd -o 0.5 0 no.png\n"
                   "newmtl e\nmap_Kd -o 0 -1 no.png\nnewmtl f\nmap_Kd -s 2 4 1 -o 1 -2 no.png\n") &&
        CHECK(parts.count == 6 && model.uv_count == 18)) {
        for (size_t i = 0; i < 6; i++) {
            struct vec2 uv = model_uv(&parts.part[i].model, 0, 2);
            CHECK(uv.x == moved[i].x && uv.y == moved[i].y);
        }
        CHECK(parts.part[5].model.faces[1].corner[0].uv == MODEL_NONE);
    }
    parts_free(&parts);
    model_free(&model);
    place_remove(&place, "m.mtl,m.obj");
}

/* The square has 2 x 4 pictures on half of the surface, the other half none of them. */
static void test_repeats(void) {
    struct model model, part;
    struct error error;
    static const char text[] =
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 3 1\nvt 5 1\nvt 5 -3\nvt 3 -3\n"
        "f 1/1 2/2 3/3 4/4\nf 1/1 2/1 3/1 4/1\n";
    if (!CHECK(model_decode(&model, text, sizeof text - 1, &error))) {
        return;
    }
    part = model;
    CHECK(fabs(parts_repeats(&model, &model, false) - sqrt(8)) < 1e-9);
    CHECK(fabs(parts_repeats(&model, &model, true) - sqrt(4)) < 1e-9);
    part.face_count = 2;
    CHECK(fabs(parts_repeats(&part, &model, false) - sqrt(16)) < 1e-9);
    part.face_count = 0;
    CHECK(isnan(parts_repeats(&part, &model, false)));
    model_free(&model);
}

/* Faces keep their own colours, wherever they are sorted to. */
static void test_face_colors(void) {
    static float colors[3][3] = {{0.1F, 0, 0}, {0.2F, 0, 0}, {0.3F, 0, 0}};
    static uint32_t materials[3] = {1, MODEL_NONE, 0};
    static struct face faces[3] = {{{{0, 0, 0}}}, {{{1, 0, 0}}}, {{{2, 0, 0}}}};
    struct model_material named[2] = {{.specular = -1}, {.specular = -1}};
    struct vec3 position[3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    struct model model = {.faces = faces,
                          .positions = position,
                          .position_count = 3,
                          .face_count = 3,
                          .face_colors = colors,
                          .face_materials = materials,
                          .materials = named,
                          .material_count = 2};
    static const float reds[] = {0.3F, 0.1F, 0.2F};
    static const uint32_t positions[] = {2, 0, 1};
    struct parts parts = {0};
    struct error missing = {0}, error;
    CHECK(parts_make(&parts, &model, &missing, &error) && parts.count == 3);
    for (size_t i = 0; i < parts.count; i++) {
        CHECK(parts.part[i].model.face_colors[0][0] == reds[i]);
        CHECK(parts.part[i].model.faces[0].corner[0].position == positions[i]);
    }
    free(model.uvs);
    parts_free(&parts);
}

UNIT_MAIN(TEST(test_parts), TEST(test_normal_maps), TEST(test_coordinates), TEST(test_repeats),
          TEST(test_face_colors))
