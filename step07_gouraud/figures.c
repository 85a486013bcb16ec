/* The pictures of step 7's README that are not references, and its errors and normals. */
#include "../tests/bench/figures.h"

#define LESSON "../step07_gouraud/main.c"
#include "../tests/lesson.h"

#include "attempts.h"
#include "files/model_file.h"
#include "files/normals.h"

#include <stdio.h>
#include <stdlib.h>

enum { SIDE = 256, GAP = 8 }; /* pixels of a panel, and between two panels */

/* The panels of a figure, and a canvas on which the next one is drawn. */
struct figure {
    struct sheet sheet;
    struct canvas canvas;
};

static bool figure_begin(struct figure *figure, size_t columns, size_t rows, struct error *error) {
    *figure = (struct figure){.sheet = {.width = SIDE,
                                        .height = SIDE,
                                        .columns = columns,
                                        .rows = rows,
                                        .gap = GAP,
                                        .format = IMAGE_GREY}};
    figure->canvas = (struct canvas){.image = &figure->sheet.panel,
                                     .width = SIDE,
                                     .height = SIDE,
                                     .depth = malloc(SIDE * SIDE * sizeof(double)),
                                     .skip = true};
    if (figure->canvas.depth == NULL) {
        return error_out_of_memory(error);
    }
    return sheet_create(&figure->sheet, error);
}

static void figure_free(struct figure *figure) {
    free(figure->canvas.depth);
    sheet_free(&figure->sheet);
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
    struct figure figure;
    bool done = figure_begin(&figure, 3, 3, error);
    for (size_t i = 0; done && i < sizeof versions / sizeof versions[0]; i++) {
        for (int times = 2; times <= 4; times++) {
            attempt_sphere(&figure.canvas, times, light, versions[i].attempt);
            printf("%-36s %4d triangles: error %5.2f\n", versions[i].name, 8 << 2 * times,
                   sphere_error(&figure.canvas, light));
            if (versions[i].shown) {
                sheet_add(&figure.sheet);
            }
            image_clear(&figure.sheet.panel, color_grey(0));
        }
    }
    done = done && figure_save(&figure.sheet.image, directory, "spheres", error);
    figure_free(&figure);
    return done;
}

/* ---- The bust ---- */

struct picture {
    attempt_function *attempt;
    struct vec3 light;
};

static bool draw_pictures(const char *directory, const char *name, const struct model *model,
                          const struct picture *pictures, size_t picture_count,
                          struct error *error) {
    struct figure figure;
    bool done = figure_begin(&figure, picture_count, 1, error);
    for (size_t i = 0; done && i < picture_count; i++) {
        attempt_model(&figure.canvas, model, vec3_normalized(pictures[i].light),
                      pictures[i].attempt);
        sheet_add(&figure.sheet);
    }
    done = done && figure_save(&figure.sheet.image, directory, name, error);
    figure_free(&figure);
    return done;
}

static bool draw_bust(struct model *bust, const char *directory, struct error *error) {
    static const struct picture versions[] = {
        {attempt_1_flat, {0, 0, 1}},
        {attempt_2_gouraud, {0, 0, 1}},
        {attempt_3_normal, {0, 0, 1}},
    };
    static const struct picture clamps[] = {
        {attempt_6_wrapped, {-1, 0.25, 0}},
        {attempt_5_late, {-1, 0.25, 0}},
        {attempt_2_gouraud, {-1, 0.25, 0}},
    };
    return model_need_normals(bust, error) &&
           draw_pictures(directory, "versions", bust, versions, 3, error) &&
           draw_pictures(directory, "clamps", bust, clamps, 3, error);
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

/* Turned so that the box's corner (1,1,2) shows. */
static struct vec3 turned(struct vec3 v) {
    const struct vec3 right = vec3_normalized((struct vec3){-1, 1, 0});
    const struct vec3 out = vec3_normalized((struct vec3){1, 1, 1});
    const struct vec3 up = vec3_cross(out, right);
    return (struct vec3){vec3_dot(right, v), vec3_dot(up, v), vec3_dot(out, v)};
}

/* Turn and shrink the box, and turn its normals with it. */
static void turn_box(struct model *box) {
    for (size_t i = 0; i < box->position_count; i++) {
        box->positions[i] = vec3_scale(turned(box->positions[i]), 0.36);
    }
    for (size_t i = 0; i < box->normal_count; i++) {
        float *n = box->normals[i];
        struct vec3 normal = turned((struct vec3){n[0], n[1], n[2]});
        n[0] = (float)normal.x;
        n[1] = (float)normal.y;
        n[2] = (float)normal.z;
    }
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

static bool draw_box(struct figure *figure, int weight, struct error *error) {
    static const char *const names[] = {"unweighted", "by area", "by angle"};
    struct model box;
    if (!model_decode(&box, box_text, sizeof box_text - 1, error)) {
        return false;
    }
    bool done = model_need_normals(&box, error); /* by angle */
    if (done) {
        if (weight < WEIGHT_COUNT) {
            attempt_normals(&box, (enum normal_weight)weight);
        }
        const float *n = box.normals[normal_of_position(&box, BOX_CORNER)];
        printf("normal of the box's corner, %-11s (%.3f, %.3f, %.3f)\n", names[weight],
               (double)n[0], (double)n[1], (double)n[2]);
        turn_box(&box);
        attempt_model(&figure->canvas, &box, (struct vec3){0, 0, 1}, attempt_2_gouraud);
        sheet_add(&figure->sheet);
    }
    model_free(&box);
    return done;
}

static bool draw_weights(const char *directory, struct error *error) {
    struct figure figure;
    bool done = figure_begin(&figure, WEIGHT_COUNT + 1, 1, error);
    for (int weight = 0; done && weight <= WEIGHT_COUNT; weight++) {
        done = draw_box(&figure, weight, error);
    }
    done = done && figure_save(&figure.sheet.image, directory, "weights", error);
    figure_free(&figure);
    return done;
}

bool draw_figures(const char *directory, struct model *bust, struct error *error) {
    return draw_spheres(directory, error) && draw_weights(directory, error) &&
           draw_bust(bust, directory, error);
}
