/* The pictures of lesson 2's README that are not references. */
#include "../tests/bench/figures.h"

#define LESSON "../step02_wireframe/main.c"
#include "../tests/lesson.h"

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

/* Move and scale all positions; z is not used here. */
static void change_positions(struct model *model, double scale, double x, double y) {
    for (size_t i = 0; i < model->position_count; i++) {
        struct vec3 *p = &model->positions[i];
        *p = (struct vec3){(p->x - x) * scale, (p->y - y) * scale, p->z};
    }
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
static void draw_one_direction(struct model *model) {
    struct comparison compared;
    model->faces += model->face_count / 8;
    model->face_count = (model->face_count + 3) / 4;
    change_positions(model, 2.4, 0.26, 0.1);
    comparison_create(&compared, 480, 360);
    struct side *sides = figure_memory(3 * model->face_count, sizeof *sides);
    size_t count = attempt_one_direction(model, sides);
    attempt_draw(&compared.first, model, sides, count, line);
    list_sides(model, sides);
    attempt_draw(&compared.second, model, sides, 3 * model->face_count, line);
    free(sides);
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
