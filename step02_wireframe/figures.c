/* The pictures of lesson 2's README that are not references. */
#include "../tests/bench/figures.h"

#define LESSON "../step02_wireframe/main.c"
#include "../tests/lesson.h"

#include "attempts.h"

#include <stdio.h>
#include <string.h>

static const struct color white = {255, 255, 255, 255};
static const struct color grey = {130, 130, 130, 255};

/* ---- The rounded cut ---- */

/* One line that reaches out of the image on both sides. */
static bool draw_rounded_line(const char *directory, struct error *error) {
    const struct pixel a = {-17, -9}, b = {89, 31};
    struct comparison compared;
    bool done = comparison_create(&compared, 60, 24, error);
    if (done) {
        attempt_line_ends_rounded(&compared.first, a, b, white);
        line(&compared.second, a, b, white);
        comparison_show(&compared, grey);
        printf("line (-17,-9)-(89,31) on 60x24: %zu pixels right, %zu wrong, %zu missing\n",
               compared.both, compared.only_first, compared.only_second);
        done = figure_save_detail(&compared.shown, detail_of_whole(&compared.shown, 12, 56),
                                  directory, "rounded_line", error);
    }
    comparison_free(&compared);
    return done;
}

/* Move and scale all positions; z is not used here. */
static void change_positions(struct model *model, double scale, double x, double y) {
    for (size_t i = 0; i < model->position_count; i++) {
        struct vec3 *p = &model->positions[i];
        *p = (struct vec3){(p->x - x) * scale, (p->y - y) * scale, p->z};
    }
}

/* A scene without a model, enlarged. */
static bool draw_small_scene(const char *directory, const char *name,
                             bool (*draw)(struct drawing *, struct image *, struct error *),
                             size_t width, size_t height, struct error *error) {
    struct image image;
    struct drawing drawing = {.skip = true};
    bool done = image_create(&image, width, height, IMAGE_BGR, error) &&
                draw(&drawing, &image, error) &&
                figure_save_detail(&image, detail_of_whole(&image, 4, 0), directory, name, error);
    image_free(&image);
    return done;
}

/* ---- A mesh with a border ---- */

/* The scene `border`: what is missing when a side is drawn in one direction only. Moves the
 * positions of `part`, which are its own. */
static bool compare_border(const char *directory, struct model *part, struct error *error) {
    part->faces += part->face_count / 8;
    part->face_count = (part->face_count + 3) / 4;
    change_positions(part, 2.4, 0.26, 0.1);
    struct comparison compared;
    bool done = comparison_create(&compared, 480, 360, error);
    if (done) {
        attempt_4_one_direction(&compared.first, part);
        attempt_1_every_side_tested(&compared.second, part);
        comparison_show(&compared, grey);
        done = figure_save_detail(&compared.shown, (struct detail){86, 30, 170, 100, .zoom = 4},
                                  directory, "one_direction", error);
    }
    comparison_free(&compared);
    return done;
}

static bool draw_one_direction(const char *directory, const struct model *model,
                               struct error *error) {
    struct model part = *model;
    size_t size = part.position_count * sizeof *part.positions;
    part.positions = malloc(size);
    if (part.positions == NULL) {
        return error_out_of_memory(error);
    }
    memcpy(part.positions, model->positions, size);
    bool done = compare_border(directory, &part, error);
    free(part.positions);
    return done;
}

bool draw_figures(const char *directory, struct model *bust, struct error *error) {
    return draw_rounded_line(directory, error) &&
           draw_small_scene(directory, "square", draw_square, 100, 100, error) &&
           draw_small_scene(directory, "cut_lines", draw_cut, CUT_WIDTH, CUT_HEIGHT, error) &&
           draw_one_direction(directory, bust, error);
}
