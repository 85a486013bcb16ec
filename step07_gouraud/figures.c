/*
 * Step 7: the pictures of the lesson that are not references, and its numbers.
 *
 *     figures DIR    writes DIR/NAME.png and prints errors and normals
 */
#define main step_main
int step_main(int argc, char **argv);
#include "main.c"
#undef main

#include "attempts.h"
#include "png.h"

#include <stdio.h>
#include <string.h>

#ifndef COURSE_BUILD
#define COURSE_BUILD "build"
#endif

enum { GAP = 8, GAP_LEVEL = 255 }; /* white between the panels of a figure */
enum { SIDE = 256 };               /* pixels of a panel */

/* A canvas of one panel, and the figure that the panels are copied to. */
struct sheet {
    struct image panel, figure;
    struct canvas canvas;
    size_t columns, next;
};

static bool sheet_begin(struct sheet *sheet, size_t columns, size_t rows, struct error *error) {
    *sheet = (struct sheet){.columns = columns};
    double *depth = malloc(SIDE * SIDE * sizeof *depth);
    if (depth == NULL) {
        return error_set(error, "out of memory");
    }
    sheet->canvas =
        (struct canvas){.image = &sheet->panel, .width = SIDE, .height = SIDE, .depth = depth};
    sheet->canvas.skip = true;
    if (!image_create(&sheet->panel, SIDE, SIDE, IMAGE_GREY, error) ||
        !image_create(&sheet->figure, columns * (SIDE + GAP) - GAP, rows * (SIDE + GAP) - GAP,
                      IMAGE_GREY, error)) {
        return false;
    }
    image_clear(&sheet->figure, color_grey(GAP_LEVEL));
    return true;
}

/* The panel goes to the next place, the first one top left, and becomes black. */
static void sheet_next(struct sheet *sheet) {
    int left = (int)(sheet->next % sheet->columns) * (SIDE + GAP);
    int bottom =
        (int)sheet->figure.height - SIDE - (int)(sheet->next / sheet->columns) * (SIDE + GAP);
    for (int y = 0; y < SIDE; y++) {
        for (int x = 0; x < SIDE; x++) {
            image_set(&sheet->figure, left + x, bottom + y, image_get(&sheet->panel, x, y));
        }
    }
    image_clear(&sheet->panel, color_grey(0));
    sheet->next++;
}

static bool sheet_save(const struct sheet *sheet, const char *directory, const char *name,
                       struct error *error) {
    char path[1024];
    if (snprintf(path, sizeof path, "%s/%s.png", directory, name) >= (int)sizeof path) {
        return error_set(error, "the directory's name is too long");
    }
    return png_write(&sheet->figure, path, error);
}

static void sheet_free(struct sheet *sheet) {
    free(sheet->canvas.depth);
    image_free(&sheet->panel);
    image_free(&sheet->figure);
}

/* ---- The sphere: three versions, three meshes ---- */

static bool draw_spheres(const char *directory, struct error *error) {
    static const struct {
        const char *name;
        attempt_function *attempt;
        bool shown;
    } versions[] = {
        {"flat", attempt_1_flat, true},
        {"Gouraud", attempt_2_gouraud, true},
        {"normal per pixel", attempt_3_normal, true},
        {"normal per pixel, not renormalised", attempt_4_short, false},
        {"Gouraud, clamped after interpolation", attempt_5_late, false},
    };
    const struct vec3 light = vec3_normalized((struct vec3){1, 2, 2});
    struct sheet sheet;
    bool done = sheet_begin(&sheet, 3, 3, error);
    for (size_t i = 0; done && i < sizeof versions / sizeof versions[0]; i++) {
        for (int times = 2; times <= 4; times++) {
            attempt_sphere(&sheet.canvas, times, light, versions[i].attempt);
            printf("%-36s %4d triangles: error %5.2f levels\n", versions[i].name, 8 << 2 * times,
                   sphere_error(&sheet.canvas, light));
            if (versions[i].shown) {
                sheet_next(&sheet);
            }
            image_clear(&sheet.panel, color_grey(0));
        }
    }
    done = done && sheet_save(&sheet, directory, "spheres", error);
    sheet_free(&sheet);
    return done;
}

/* ---- The bust: versions and mistakes ---- */

struct picture {
    attempt_function *attempt;
    enum normal_mistake mistake;
    struct vec3 light;
};

static bool draw_pictures(const char *directory, const char *name, const struct model *model,
                          const struct picture *pictures, size_t picture_count,
                          struct error *error) {
    struct sheet sheet;
    bool done = sheet_begin(&sheet, picture_count, 1, error);
    for (size_t i = 0; done && i < picture_count; i++) {
        attempt_model(&sheet.canvas, model, vec3_normalized(pictures[i].light), pictures[i].attempt,
                      pictures[i].mistake);
        sheet_next(&sheet);
    }
    done = done && sheet_save(&sheet, directory, name, error);
    sheet_free(&sheet);
    return done;
}

/* As if the file had no normals. */
static void drop_normals(struct model *model) {
    model->normal_count = 0;
    for (size_t i = 0; i < model->face_count; i++) {
        for (size_t j = 0; j < 3; j++) {
            model->faces[i].corner[j].normal = MODEL_NONE;
        }
    }
}

/* The sums of the face normals, as they are: mistake "not normalised". */
static bool draw_unnormalised(const char *directory, struct model *model, struct error *error) {
    static const struct picture pictures[] = {
        {attempt_2_gouraud, NORMAL_INDEX, {0, 0, 1}},
        {attempt_2_gouraud, NORMAL_AS_READ, {0, 0, 1}},
    };
    struct sheet sheet;
    bool done = sheet_begin(&sheet, 2, 1, error);
    if (done) {
        attempt_model(&sheet.canvas, model, pictures[0].light, pictures[0].attempt,
                      pictures[0].mistake);
        sheet_next(&sheet);
        drop_normals(model);
        done = model_need_normals(model, error);
    }
    if (done) {
        attempt_normals(model, WEIGHT_NONE, false);
        attempt_model(&sheet.canvas, model, pictures[1].light, pictures[1].attempt,
                      pictures[1].mistake);
        sheet_next(&sheet);
        done = sheet_save(&sheet, directory, "mistakes", error);
    }
    sheet_free(&sheet);
    return done;
}

static bool draw_bust(const char *directory, struct error *error) {
    static const struct picture versions[] = {
        {attempt_1_flat, NORMAL_RIGHT, {0, 0, 1}},
        {attempt_2_gouraud, NORMAL_RIGHT, {0, 0, 1}},
        {attempt_3_normal, NORMAL_RIGHT, {0, 0, 1}},
    };
    static const struct picture clamps[] = {
        {attempt_2_gouraud, NORMAL_RIGHT, {-1, 0.25, 0}},
        {attempt_5_late, NORMAL_RIGHT, {-1, 0.25, 0}},
        {attempt_6_wrapped, NORMAL_RIGHT, {-1, 0.25, 0}},
    };
    struct model model = {0};
    bool done = model_read(&model, COURSE_BUILD "/models/bust.obj", error) &&
                model_need_normals(&model, error) &&
                draw_pictures(directory, "versions", &model, versions, 3, error) &&
                draw_pictures(directory, "clamps", &model, clamps, 3, error) &&
                draw_unnormalised(directory, &model, error);
    model_free(&model);
    return done;
}

/* ---- Weights: a box, each side cut into two triangles, seen on a corner ---- */

static const char box_text[] = "v -1 -1 -2\nv 1 -1 -2\nv 1 1 -2\nv -1 1 -2\n"
                               "v -1 -1 2\nv 1 -1 2\nv 1 1 2\nv -1 1 2\n"
                               "f 5 6 8\nf 6 7 8\n" /* z = 2: corner 7 is in one triangle */
                               "f 2 3 7\nf 2 7 6\n" /* x = 1: corner 7 is in two */
                               "f 3 4 8\nf 3 8 7\n" /* y = 1: corner 7 is in one */
                               "f 1 3 2\nf 1 4 3\n" /* the hidden sides */
                               "f 1 5 8\nf 1 8 4\n"
                               "f 1 2 6\nf 1 6 5\n";

enum { BOX_CORNER = 6 }; /* of the 8 positions: (1,1,2) */

/* Turn the box so that its corner (1,1,2) shows, and its normals with it. */
static void turn_vector(float vector[3], double scale) {
    const struct vec3 right = vec3_normalized((struct vec3){-1, 1, 0});
    const struct vec3 out = vec3_normalized((struct vec3){1, 1, 1});
    const struct vec3 up = vec3_cross(out, right);
    struct vec3 v = {vector[0], vector[1], vector[2]};
    vector[0] = (float)(vec3_dot(right, v) * scale);
    vector[1] = (float)(vec3_dot(up, v) * scale);
    vector[2] = (float)(vec3_dot(out, v) * scale);
}

static uint32_t normal_of_position(const struct model *model, uint32_t position) {
    for (size_t i = 0; i < model->face_count; i++) {
        for (size_t j = 0; j < 3; j++) {
            if (model->faces[i].corner[j].position == position) {
                return model->faces[i].corner[j].normal;
            }
        }
    }
    return 0;
}

static bool draw_box(struct sheet *sheet, int weight, struct error *error) {
    static const char *const names[] = {"unweighted", "by area", "by angle"};
    struct model box;
    if (!model_decode(&box, box_text, sizeof box_text - 1, error)) {
        return false;
    }
    bool done = model_need_normals(&box, error); /* by angle */
    if (done) {
        if (weight < WEIGHT_COUNT) {
            attempt_normals(&box, (enum normal_weight)weight, true);
        }
        const float *n = box.normals[normal_of_position(&box, BOX_CORNER)];
        printf("normal of the box's corner, %-11s (%.3f, %.3f, %.3f)\n", names[weight],
               (double)n[0], (double)n[1], (double)n[2]);
        for (size_t i = 0; i < box.position_count; i++) {
            turn_vector(box.positions[i], 0.36);
        }
        for (size_t i = 0; i < box.normal_count; i++) {
            turn_vector(box.normals[i], 1);
        }
        attempt_model(&sheet->canvas, &box, (struct vec3){0, 0, 1}, attempt_2_gouraud,
                      NORMAL_RIGHT);
        sheet_next(sheet);
    }
    model_free(&box);
    return done;
}

static bool draw_weights(const char *directory, struct error *error) {
    struct sheet sheet;
    bool done = sheet_begin(&sheet, WEIGHT_COUNT + 1, 1, error);
    for (int weight = 0; done && weight <= WEIGHT_COUNT; weight++) {
        done = draw_box(&sheet, weight, error);
    }
    done = done && sheet_save(&sheet, directory, "weights", error);
    sheet_free(&sheet);
    return done;
}

int main(int argc, char **argv) {
    struct error error = {0};
    if (argc != 2) {
        fprintf(stderr, "usage: figures DIR\n");
        return 2;
    }
    if (!draw_spheres(argv[1], &error) || !draw_weights(argv[1], &error) ||
        !draw_bust(argv[1], &error)) {
        fprintf(stderr, "figures: %s\n", error.message);
        return 1;
    }
    return 0;
}
