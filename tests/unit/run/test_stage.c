/* What a scene finds on its stage: what is read for its needs, in parts, and of which files. */
#define _XOPEN_SOURCE 700 /* POSIX.1-2008 with mkdtemp() */

#include "run/atlas.h"
#include "run/stage.h"
#include "unit/models.h"

#define CORNERS "vt 0 0\nvt 2 0\nvt 0 2\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nl 1 2\n"
#define FACE    "f 1/1/1 2/2/1 3/3/1\n"

enum { TEXTURES = NEEDS_DIFFUSE | NEEDS_NORMAL_MAP | NEEDS_SPECULAR, SIGHT = 400 };

static const struct scene all_needs = {.name = "all", .needs = 0xFF};
static const struct program program = {
    .takes_camera = true,
    .takes_models = true,
    .defaults = {.width = 5, .height = 4, .up = {0, 1, 0}, .eye = {0, 0, 5}, .center = {2, 0, 0}},
    .scenes = &all_needs,
    .scene_count = 1,
    .state_size = 1,
};

/* How much there is of each model; then of each part and of the whole how many faces, the red of
 * its textures, and its numbers. */
static void describe(struct drawing *drawing, char *text) {
    for (size_t i = 0; i < drawing->model_count; i++) {
        const struct model *m = drawing->models[i];
        bool known = m->material_count > 0 && m->materials->known;
        string_append(text, SIGHT, "vt%zu vn%zu l%zu%s%s", m->uv_count, m->normal_count,
                      m->line_count, known ? " mtl" : "", m->face_colors != NULL ? " Kd" : "");
    }
    for (size_t i = 0; drawing->diffuse != NULL && i <= drawing->part_count; i++) {
        CHECK(drawing_take_part(drawing, i) ==
              (i < drawing->part_count + (drawing->parts == NULL)));
        const struct texture *textures[] = {drawing->diffuse, drawing->normal_map,
                                            drawing->specular, drawing->ambient};
        string_append(text, SIGHT, "; %zu", drawing->model->face_count);
        for (size_t k = 0; k < 4; k++) {
            string_append(text, SIGHT, textures[k] != NULL ? " %X" : " -",
                          textures[k] != NULL ? *textures[k]->texels >> 16 & 0xFF : 0);
        }
        string_append(text, SIGHT, " %g %g %.2g", drawing->specular_weight, drawing->power,
                      drawing->repeats);
    }
}

/* From the name of the file on; it is said once. */
static void add_message(char *text, struct error *error) {
    const char *slash = strrchr(error->message, '/');
    string_append(text, SIGHT, "%s%.40s", error->message[0] != '\0' ? "; " : "",
                  slash != NULL ? slash + 1 : error->message);
    error->message[0] = '\0';
}

/* Begin the scene with options that have blanks between them; what is there, and what is said. */
static void begin(struct run *run, struct stage *stage, const struct scene *given,
                  const char *options, char *sight) {
    static char arguments[100];
    char *argv[16] = {(char *)"probe"};
    int argc = 1;
    struct error error = {0};
    snprintf(arguments, sizeof arguments, "%s", options);
    for (char *word = strtok(arguments, " "); word != NULL; word = strtok(NULL, " ")) {
        argv[argc++] = word;
    }
    run->asked = &run->options;
    CHECK_ROW(options_parse(&run->options, &program, argc, argv, &error), error.message);
    const struct scene scene = scene_complete(&run->options, given);
    sight[0] = '\0';
    if (stage_begin(stage, run, &scene, scene.width, scene.height, &error)) {
        describe(&stage->drawing, sight);
    }
    add_message(sight, &error);
    for (int kind = 0; kind < MODEL_TEXTURE_KINDS; kind++) {
        add_message(sight, &run->replaced[kind]);
    }
}

/* Each row is a run, but those of the course's own files are scenes of one run. */
static void test_needs(void) {
    static const struct {
        const char *own, *options;
        unsigned needs, all; /* of this scene; of all of the run, where that is known */
        const char *sight;
    } rows[] = {
        {"", "--two-sided m.obj bare.obj", NEEDS_MODEL, 0, "vt0 vn0 l0vt0 vn0 l0"},
        {"", "--two-sided m.obj bare.obj", NEEDS_NORMALS, 0, "vt0 vn2 l0vt0 vn8 l0"},
        {"", "m.obj", NEEDS_COLORS, 0, "vt0 vn1 l0 mtl Kd"},
        {"", "m.obj", NEEDS_NORMAL_MAP, 0,
         "vt3 vn1 l0 mtl; m.obj: no m_nm.tga next to it, nor other"},
        {"", "m.obj", TEXTURES, 0,
         "vt3 vn1 l0 mtl; 1 C8 64 64 - -1 5 2; 1 0 - 1 33 0.5 0 2; 2 C8 64 64 - -1 5 2"},
        {"", "--two-sided --normal-map blue.png --specular red.png m.obj", TEXTURES, 0,
         "vt3 vn2 l0 mtl; 2 C8 82 64 - -1 5 2; 2 0 82 C8 33 0.5 0 2; 4 C8 82 64 - -1 5 2"
         "; m.obj: the normal map is blue, so it is "},
        {"", "--two-sided --texture red.png m.obj", TEXTURES, 0,
         "vt3 vn2 l0 mtl; 4 C8 - 1 - 0 0 2; m.obj: no m_nm.tga next to it, nor other"},
        {"", "bare.obj", TEXTURES, 0, "vt0 vn4 l0; 2 FF - 40 - 0 0 1"},
        {"bare.obj", "", NEEDS_MODEL, 0, "vt0 vn0 l0"},
        {"m.obj", "", NEEDS_DIFFUSE, TEXTURES,
         "vt3 vn0 l0 mtl; 1 C8 - 64 - -1 5 2; 1 0 - - 33 0.5 0 2; 2 C8 - 64 - -1 5 2"},
        {"one.obj", "", NEEDS_DIFFUSE, TEXTURES,
         "vt3 vn0 l0; 1 FF - - - 0 0 1.4; one.obj: no one_diffuse.tga, one_spec.tg"},
        {"one.obj", "", TEXTURES, TEXTURES, "vt3 vn0 l0; 1 FF 64 40 - 0 0 1.4"},
        {"lost.obj", "", TEXTURES, 0,
         "vt3 vn3 l0 mtl; 1 FF - 40 - -1 0 1.4; 1 FF - 40 - -1 0 1.4"
         "; no.png: No such file or directory; the m; no2.png: No such file or directory; the "},
        {"lost.obj", "", TEXTURES, 0, "vt3 vn3 l0 mtl; 1 FF - 40 - -1 0 1.4; 1 FF - 40 - -1 0 1.4"},
        {"no.obj", "", NEEDS_MODEL, 0, "; no.obj: no such file; `make` sculpts it"},
        {"m.obj", "one.obj", NEEDS_DIFFUSE, 0,
         "vt3 vn0 l0; 1 FF - - - 0 0 1.4; one.obj: no one_diffuse.tga next to it, "},
        {"bare.obj", "one.obj", NEEDS_DIFFUSE, 0, "vt3 vn0 l0; 1 FF - - - 0 0 1.4"},
        {"one.obj", "", NEEDS_LINES, 0, "vt0 vn0 l1"}, /* read again, for more of it */
    };
    static const char *const pictures[] = {"red.png", "blue.png", "one_nm.png", "m_spec.png"};
    static uint8_t colors[][3] = {{100, 20, 200}, {250, 120, 130}, {20, 200, 100}, {3, 2, 1}};
    static char paths[sizeof rows / sizeof rows[0]][100];
    struct place place = place_create();
    struct run run = {.needs = 0};
    struct error error;
    char home[1000], sight[SIGHT];
    CHECK(getcwd(home, sizeof home) != NULL && chdir(place.directory) == 0);
    for (size_t i = 0; i < 4; i++) {
        const struct image texel = {1, 1, IMAGE_BGR, colors[i]};
        CHECK(png_write(&texel, pictures[i], &error));
    }
    CHECK(put_text("m.mtl", "newmtl a\nmap_Kd red.png\nbump one_nm.png\nmap_Ks one_nm.png\nNs 5\n"
                            "newmtl b\nKd 0 0 1\nKs 0.5\nKa 0.2 1 0\n") &&
          put_text("m.obj", "mtllib m.mtl\n" CORNERS "usemtl a\n" FACE "usemtl b\n" FACE) &&
          put_text("lost.mtl", "newmtl a\nmap_Kd no.png\nbump no2.png\n") &&
          put_text("lost.obj", "mtllib lost.mtl\n" CORNERS "usemtl a\n" FACE) &&
          put_text("m_diffuse.png", "not looked at") && put_text("one.obj", CORNERS FACE) &&
          put_text("bare.obj", SQUARE "f 1 2 3 4\n"));
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        const struct scene scene = {.model = paths[i], .needs = rows[i].needs};
        struct stage stage;
        if (rows[i].own[0] == '\0') {
            run_free(&run);
        }
        run.needs = rows[i].all;
        snprintf(paths[i], sizeof paths[i], "../../../../../../../../../../../..%s/%s",
                 place.directory, rows[i].own);
        begin(&run, &stage, &scene, rows[i].options, sight);
        CHECK_TEXT(sight, rows[i].sight);
        stage_end(&stage);
    }
    const struct loaded loaded = run_loaded(&run);
    CHECK(loaded.textures_present == 7 && loaded.textures_read == 3); /* one.obj is read thrice */
    run_free(&run);
    CHECK(chdir(home) == 0);
    place_remove(&place, "red.png,blue.png,one_nm.png,m_diffuse.png,m_spec.png,m.mtl,lost.mtl,m."
                         "obj,lost.obj,one.obj,"
                         "bare.obj");
}

/* Textures have the levels that a scene of the run needs, so far: one after the other. */
static void test_levels(void) {
    static const struct {
        const char *options;
        unsigned needs, all;
        size_t levels;
    } rows[] = {{"one.obj", NEEDS_PICTURE, 0, 1}, {"one.obj", NEEDS_DIFFUSE, 0, 2},
                {"one.obj", NEEDS_PICTURE, 0, 2}, {"m.obj", NEEDS_PICTURE, 0, 1},
                {"m.obj", NEEDS_DIFFUSE, 0, 2},   {"m.obj", NEEDS_PICTURE, NEEDS_SPECULAR, 2}};
    struct place place = place_create();
    struct run run = {.needs = 0};
    char home[1000], sight[SIGHT];
    CHECK(getcwd(home, sizeof home) != NULL && chdir(place.directory) == 0);
    put_picture(&place, "one_diffuse.png", color_grey(5));
    CHECK(put_text("one.obj", CORNERS FACE) &&
          put_text("m.mtl", "newmtl a\nmap_Kd one_diffuse.png\n") &&
          put_text("m.obj", "mtllib m.mtl\n" CORNERS "usemtl a\n" FACE));
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        const struct scene scene = {.needs = rows[i].needs};
        struct stage stage;
        if (i > 0 && (strcmp(rows[i].options, rows[i - 1].options) != 0 || rows[i].all != 0)) {
            run_free(&run);
        }
        run.needs = rows[i].all;
        begin(&run, &stage, &scene, rows[i].options, sight);
        CHECK_ROW(stage.drawing.diffuse->level_count == rows[i].levels, sight);
        stage_end(&stage);
    }
    run_free(&run);
    CHECK(chdir(home) == 0);
    place_remove(&place, "one_diffuse.png,one.obj,m.mtl,m.obj");
}

/* The colours of a face, of each corner and of the middle, as scenes sample them. */
static void describe_face(const struct drawing *drawing, size_t face, char *text) {
    struct vec2 uv[4];
    for (size_t i = 0; i < 3; i++) {
        uv[i] = model_uv(drawing->model, face, i);
    }
    const struct vec3 third = {1.0 / 3, 1.0 / 3, 1.0 / 3};
    uv[3] = vec2_interpolate(third, uv[0], uv[1], uv[2]);
    for (size_t i = 0; i < 4; i++) {
        const struct vec4 c = texture_bilinear(drawing->diffuse, uv[i], 0);
        string_append(text, SIGHT, "%02X%02X%02X%s", (unsigned)(c.x + 0.5), (unsigned)(c.y + 0.5),
                      (unsigned)(c.z + 0.5), i < 3 ? " " : "; ");
    }
}

/* A model without pictures shows the colours of its positions or faces. */
static void test_own_colors(void) {
#define COLORED "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\n"
    static const struct {
        const char *model, *materials, *options, *sight, *said;
    } rows[] = {
        {COLORED "f 1 2 3\n", "", "m.obj", "FF0000 00FF00 0000FF 555555; ", ""},
        {COLORED "f 1 2 3\nf 3 2 1\n", "", "m.obj",
         "FF0000 00FF00 0000FF 555555; 0000FF 00FF00 FF0000 555555; ", ""},
        {COLORED "f 1 2 3\n", "", "--two-sided m.obj",
         "FF0000 00FF00 0000FF 555555; FF0000 0000FF 00FF00 555555; ", ""},
        {"OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 51\n3 2 1 0\n", "", "m.obj",
         "FF0033 FF0033 FF0033 FF0033; FFFFFF FFFFFF FFFFFF FFFFFF; ", ""},
        {COLORED "vt 0 0\nf 1/1 2/1 3/1\n", "", "m.obj", "FF0000 00FF00 0000FF 555555; ",
         "m.obj: no m_diffuse.tga next to it, nor other usual names; its own colours instead "
         "(--texture)"},
        /* Of a material: grey does not count, and other colours tint. */
        {"mtllib m.mtl\n" COLORED "usemtl a\nf 1 2 3\nusemtl b\nf 3 2 1\n",
         "newmtl a\nKd 0.8 0.8 0.8\nnewmtl b\nKd 1 0.6 1\n", "m.obj",
         "FF0000 00FF00 0000FF 555555; 0000FF 009900 FF0000 553355; ", ""},
        {"mtllib m.mtl\n" COLORED "vt 0 0\nusemtl a\nf 1/1 2/1 3/1\nusemtl b\nf 3/1 2/1 1/1\n",
         "newmtl a\nmap_Kd grey.png\nnewmtl b\n", "m.obj",
         "050505 050505 050505 050505; 0000FF 00FF00 FF0000 555555; ", ""},
        {"mtllib m.mtl\n" COLORED "vt 0 0\nusemtl a\nf 1/1 2/1 3/1\n",
         "newmtl a\nmap_Kd none.png\n", "m.obj", "FF0000 00FF00 0000FF 555555; ",
         "none.png: No such file or directory; the material's colour instead (--texture)"},
        {"mtllib m.mtl\n" COLORED "vt 0 0\nusemtl a\nf 1/1 2/1 3/1\n",
         "newmtl a\nKd 0 1 1\nmap_Ks grey.png\n", "m.obj", "00FFFF 00FFFF 00FFFF 00FFFF; ", ""},
        /* A picture counts before them. */
        {COLORED "vt 0 0\nf 1/1 2/1 3/1\n", "", "--texture grey.png m.obj",
         "050505 050505 050505 050505; ", ""},
        {COLORED "vt 0 0\nf 1/1 2/1 3/1\n", "", "--specular grey.png m.obj",
         "FFFFFF FFFFFF FFFFFF FFFFFF; ",
         "m.obj: no m_diffuse.tga next to it, nor other usual names; white instead (--texture)"},
    };
    struct place place = place_create();
    char home[1000], sight[SIGHT];
    CHECK(getcwd(home, sizeof home) != NULL && chdir(place.directory) == 0);
    put_picture(&place, "grey.png", color_grey(5));
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        const struct scene scene = {.needs = NEEDS_DIFFUSE};
        struct run run = {.needs = 0};
        CHECK(put_text("m.obj", rows[i].model) && put_text("m.mtl", rows[i].materials));
        for (int round = 0; round < 2; round++) { /* made once, and shown again */
            struct stage stage;
            char said[SIGHT] = "", again[SIGHT] = "";
            begin(&run, &stage, &scene, rows[i].options, sight);
            struct drawing *drawing = &stage.drawing;
            for (size_t part = 0; drawing_take_part(drawing, part); part++) {
                for (size_t face = 0; face < drawing->model->face_count; face++) {
                    describe_face(drawing, face, again);
                }
            }
            CHECK_ROW(CHECK_TEXT(again, rows[i].sight), rows[i].model);
            snprintf(said, sizeof said, "; %.40s", rows[i].said);
            bool silent = round > 0 || rows[i].said[0] == '\0';
            CHECK_ROW(silent ? strstr(sight, "instead") == NULL : strstr(sight, said) != NULL,
                      sight);
            stage_end(&stage);
        }
        run_free(&run);
    }
    CHECK(chdir(home) == 0);
    place_remove(&place, "grey.png,m.obj,m.mtl");
}

/* Many faces have small places, and each keeps its own colour. */
static void test_many_colors(void) {
    enum { COUNT = 200000 };
    struct model m = {0};
    struct texture atlas = {0};
    struct bytes text = {0};
    struct error error = {0};
    CHECK(bytes_print(&text, "OFF\n3 %d 0\n0 0 0\n1 0 0\n0 1 0\n", COUNT));
    for (int i = 0; i < COUNT; i++) {
        CHECK(bytes_print(&text, "3 0 1 2 %d %d %d\n", i & 255, i >> 8 & 255, i >> 16));
    }
    if (CHECK(model_decode(&m, text.data, text.size, &error)) &&
        CHECK(atlas_make(&atlas, &m, NULL, &error))) {
        CHECK(atlas.level_count == 1 && m.uv_count == 3 * COUNT);
        bool right = true;
        for (size_t i = 0; i < 3 * COUNT; i++) {
            const struct vec4 c = texture_bilinear(&atlas, model_uv(&m, i / 3, i % 3), 0);
            right = right && fabs(c.x - (double)(i / 3 & 255)) < 0.5 &&
                    fabs(c.y - (double)(i / 3 >> 8 & 255)) < 0.5 &&
                    fabs(c.z - (double)(i / 3 >> 16)) < 0.5;
        }
        CHECK(right);
    }
    texture_free(&atlas);
    model_free(&m);
    bytes_free(&text);
}

static bool draw_depth(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    for (size_t i = 0; i < image->width * image->height; i++) {
        CHECK(drawing->depth[i] == -INFINITY);
        drawing->depth[i] = (double)drawing->frame;
    }
    return true;
}

/* What a draw function gets, whatever it draws. */
static void test_drawing(void) {
    const struct scene scene = {.needs = NEEDS_DEPTH,
                                .number = 7,
                                .up = {0, 0, 1},
                                .eye = {0, 0, 6},
                                .center = {1, 0, 0},
                                .draw = draw_depth};
    struct image image = new_image(5, 4, IMAGE_BGR);
    struct text_scene text = {.width = 5};
    struct run run = {.text = &text};
    struct stage stage;
    struct error error;
    char sight[SIGHT];
    begin(&run, &stage, &scene, "--stats --probe 3,1", sight);
    const struct drawing *d = &stage.drawing;
    CHECK(sight[0] == '\0' && d->number == 7 && d->stats && d->skip && d->text == &text);
    CHECK(d->probed && d->probe.x == 3 && d->probe.y == 1 && d->up.z == 1 && d->eye.z == 6 &&
          d->up.y == 0 && d->center.x == 1);
    CHECK(*(const char *)d->state == 0);
    for (size_t frame = 1; frame < 3; frame++) {
        CHECK(stage_draw(&stage, &image, frame, &error) && d->depth[19] == (double)frame);
    }
    stage_end(&stage);
    CHECK(stage.program == NULL && stage.drawing.depth == NULL);
    run_free(&run);
    image_free(&image);
}

UNIT_MAIN(TEST(test_needs), TEST(test_levels), TEST(test_own_colors), TEST(test_many_colors),
          TEST(test_drawing))
