/* The pictures of lesson 2's README that are not references. */
#include "bench/figures.h"

#define LESSON "../step02_wireframe/main.c"
#include "lesson.h"

#include "../../../step02_wireframe/attempts.h"

#include <stdio.h>

static const struct color white = {255, 255, 255, 255};
static const struct color grey = {130, 130, 130, 255};

/* ---- The rounded cut ---- */

/* One line that reaches out of the image on both sides. */
static void draw_rounded_line(void) {
    const struct pixel a = {-17, -9}, b = {89, 31};
    struct comparison compared;
    comparison_create(&compared, 60, 24);
    attempt_line_ends_rounded(&compared.first, a, b, white);
    line(&compared.second, a, b, white);
    comparison_show(&compared, grey);
    printf("line (-17,-9)-(89,31) on 60x24: %zu pixels right, %zu wrong, %zu missing\n",
           compared.both, compared.only_first, compared.only_second);
    figure_save_detail(&compared.shown, detail_of_whole(&compared.shown, 12, 56), "rounded_line");
}

/* The scene `cut`, enlarged. */
static void draw_cut_lines(void) {
    struct image image = figure_image(CUT_WIDTH, CUT_HEIGHT);
    figure_need(draw_cut(NULL, &image, &figure_error));
    figure_save_detail(&image, detail_of_whole(&image, 4, 0), "cut_lines");
}

/* ---- Models ---- */

/* The square of the text as it is, 30,000 times as large, and over a corner of the image. */
static void draw_square(void) {
    static const struct view views[] = {
        {0, 0, 1}, {0.5 - 2e-5, 0.5 - 2.4e-5, 3e4}, {1.2836, 1.4869, 0.61}};
    struct vec3 corners[] = {{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}, {-0.5, 0.5, 0}};
    struct face faces[] = {{{{.position = 0}, {.position = 1}, {.position = 2}}},
                           {{{.position = 0}, {.position = 2}, {.position = 3}}}};
    const struct model square = {
        .positions = corners, .position_count = 4, .faces = faces, .face_count = 2};
    struct image image = figure_image(100, 100);
    struct drawing drawing = {0};
    for (size_t i = 0; i < sizeof views / sizeof views[0]; i++) {
        figure_need(draw_model(&drawing, &square, views[i], line, &image, &figure_error));
    }
    figure_save_detail(&image, detail_of_whole(&image, 4, 0), "square");
}

/* A quarter of the head, a mesh with a border: what is missing where a side is drawn in one
 * direction only. */
static void draw_one_direction(const struct model *bust) {
    const struct model part = quarter_of(bust);
    struct drawing drawing = {.model = bust};
    struct comparison compared;
    struct wireframe sides;
    comparison_create(&compared, 480, 360);
    figure_need(draw_border(&drawing, &compared.second, &figure_error));
    figure_need(wireframe_create(&sides, &part, &figure_error));
    sides.side_count = attempt_one_direction(&part, sides.sides);
    draw_sides(&drawing, &sides, part.positions, (struct view){0.26, 0.1, 2.4}, line,
               &compared.first);
    free(sides.sides);
    comparison_show(&compared, grey);
    figure_save_detail(&compared.shown, (struct detail){86, 30, 170, 100, .zoom = 4},
                       "one_direction");
}

void draw_figures(struct model *bust) {
    draw_rounded_line();
    draw_square();
    draw_cut_lines();
    draw_one_direction(bust);
}
