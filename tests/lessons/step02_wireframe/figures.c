/* The pictures of lesson 2's README that are not references. */
#include "bench/figures.h"

#define LESSON "../step02_wireframe/main.c"
#include "lesson.h"

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

/* A scene without a model, enlarged. */
static void draw_small_scene(const char *name,
                             bool (*draw)(struct drawing *, struct image *, struct error *),
                             size_t width, size_t height) {
    struct image image = figure_image(width, height);
    struct drawing drawing = {.skip = true};
    figure_need(draw(&drawing, &image, &figure_error));
    figure_save_detail(&image, detail_of_whole(&image, 4, 0), name);
}

/* ---- A mesh with a border ---- */

/* The scene `border`: what is missing when a side is drawn in one direction only. */
static void draw_one_direction(const struct model *bust) {
    struct drawing drawing = {.model = bust, .skip = true, .values = border_values};
    struct comparison compared;
    comparison_create(&compared, 480, 360);
    figure_need(draw_border(&drawing, &compared.second, &figure_error));
    drawing.value[0] = 1;
    figure_need(draw_border(&drawing, &compared.first, &figure_error));
    comparison_show(&compared, grey);
    figure_save_detail(&compared.shown, (struct detail){86, 30, 170, 100, .zoom = 4},
                       "one_direction");
}

void draw_figures(struct model *bust) {
    draw_rounded_line();
    draw_small_scene("square", draw_square, 100, 100);
    draw_small_scene("cut_lines", draw_cut, CUT_WIDTH, CUT_HEIGHT);
    draw_one_direction(bust);
}
