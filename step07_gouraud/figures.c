/* The pictures of lesson 7's README that are not references, and the errors of the spheres. */
#include "../tests/bench/figures.h"

#define LESSON "../step07_gouraud/main.c"
#include "../tests/lesson.h"

#include "attempts.h"
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
    } versions[] = {
        {"flat", attempt_1_flat},
        {"Gouraud", attempt_2_gouraud},
        {"normal per pixel", attempt_3_normal},
    };
    const struct vec3 light = vec3_normalized((struct vec3){1, 2, 2});
    struct figure figure;
    bool done = figure_begin(&figure, 3, 3, error);
    for (size_t i = 0; done && i < sizeof versions / sizeof versions[0]; i++) {
        for (int times = 2; times <= 4; times++) {
            attempt_sphere(&figure.canvas, times, light, versions[i].attempt);
            printf("%-36s %4d triangles: error %5.2f\n", versions[i].name, 8 << 2 * times,
                   sphere_error(&figure.canvas, light));
            sheet_add(&figure.sheet);
        }
    }
    done = done && figure_save(&figure.sheet.image, directory, "spheres", error);
    figure_free(&figure);
    return done;
}

/* ---- The bust ---- */

/* Light from the left: not clamped, clamped at the pixel, clamped at the corner. */
static bool draw_clamps(struct model *bust, const char *directory, struct error *error) {
    static attempt_function *const attempts[] = {attempt_6_wrapped, attempt_5_late,
                                                 attempt_2_gouraud};
    const struct vec3 light = vec3_normalized((struct vec3){-1, 0.25, 0});
    struct figure figure;
    bool done = figure_begin(&figure, 3, 1, error) && model_need_normals(bust, error);
    for (size_t i = 0; done && i < 3; i++) {
        attempt_model(&figure.canvas, bust, light, attempts[i]);
        sheet_add(&figure.sheet);
    }
    done = done && figure_save(&figure.sheet.image, directory, "clamps", error);
    figure_free(&figure);
    return done;
}

bool draw_figures(const char *directory, struct model *bust, struct error *error) {
    return draw_spheres(directory, error) && draw_clamps(bust, directory, error);
}
