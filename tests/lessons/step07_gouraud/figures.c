/* The pictures of lesson 7's README that are not references, and the errors of the spheres. */
#include "bench/figures.h"

#define LESSON "../step07_gouraud/main.c"
#include "lesson.h"

#include "../../../step07_gouraud/attempts.h"
#include "files/normals.h"

#include <stdio.h>

enum { SIDE = 256, GAP = 8 }; /* pixels of a panel, and between two panels */

/* The panels of a figure, and a canvas on which each of them is drawn. */
static struct canvas figure_begin(struct sheet *sheet, size_t columns, size_t rows) {
    *sheet = (struct sheet){.width = SIDE,
                            .height = SIDE,
                            .columns = columns,
                            .rows = rows,
                            .gap = GAP,
                            .format = IMAGE_GREY};
    sheet_create(sheet);
    return (struct canvas){.image = &sheet->panel,
                           .width = SIDE,
                           .height = SIDE,
                           .depth = figure_memory(SIDE * SIDE, sizeof(double))};
}

/* ---- The sphere: three versions, three meshes ---- */

static void draw_spheres(void) {
    static const struct {
        const char *name;
        attempt_function *attempt;
    } versions[] = {
        {"flat", attempt_1_flat},
        {"Gouraud", attempt_2_gouraud},
        {"normal per pixel", attempt_3_normal},
    };
    const struct vec3 light = vec3_normalized((struct vec3){1, 2, 2});
    struct sheet sheet;
    struct canvas canvas = figure_begin(&sheet, 3, 3);
    for (size_t i = 0; i < sizeof versions / sizeof versions[0]; i++) {
        for (int times = 2; times <= 4; times++) {
            attempt_sphere(&canvas, times, light, versions[i].attempt);
            printf("%-36s %4d triangles: error %5.2f\n", versions[i].name, 8 << 2 * times,
                   attempt_sphere_error(&canvas, light));
            sheet_add(&sheet);
        }
    }
    figure_save(&sheet.image, "spheres");
}

/* ---- The bust ---- */

/* Light from the left: not clamped, clamped at the pixel, clamped at the corner. */
static void draw_clamps(struct model *bust) {
    static attempt_function *const attempts[] = {attempt_6_wrapped, attempt_5_late,
                                                 attempt_2_gouraud};
    const struct vec3 light = vec3_normalized((struct vec3){-1, 0.25, 0});
    struct sheet sheet;
    struct canvas canvas = figure_begin(&sheet, 3, 1);
    figure_need(model_need_normals(bust, &figure_error));
    for (size_t i = 0; i < 3; i++) {
        attempt_model(&canvas, bust, light, attempts[i]);
        sheet_add(&sheet);
    }
    figure_save(&sheet.image, "clamps");
}

void draw_figures(struct model *bust) {
    draw_spheres();
    draw_clamps(bust);
}
