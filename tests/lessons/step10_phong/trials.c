/* Lesson 10's scenes that find wrong programs. */
#ifndef LESSON
#define LESSON "../step10_phong/main.c"
#endif
#include "more_scenes.h"

/* The model with normals a quarter, once and 4 times as long: a file may give them so. (Products
 * with these are exact: normalised, each is what it was.) Free its normals. */
static bool try_to_stretch(struct model *stretched, const struct model *model,
                           struct error *error) {
    static const float factor[] = {0.25f, 1, 4};
    *stretched = *model;
    stretched->normals = malloc(model->normal_count * sizeof *stretched->normals);
    if (stretched->normals == NULL) {
        return error_out_of_memory(error);
    }
    for (size_t i = 0; i < model->normal_count; i++) {
        for (size_t k = 0; k < 3; k++) {
            stretched->normals[i][k] = model->normals[i][k] * factor[i % 3];
        }
    }
    return true;
}

static bool try_matt(struct drawing *drawing, struct image *image, struct error *error) {
    struct model stretched;
    struct cell cell = matt_cell();
    if (!try_to_stretch(&stretched, drawing->model, error)) {
        return false;
    }
    cell.model = &stretched;
    bool done = draw_cells(drawing, image, &cell, 1, 1, 0.8, error);
    free(stretched.normals);
    return done;
}

/* For each frame the light is asked for another place first: it must not count how often it is
 * asked. */
static bool try_turn(struct drawing *drawing, struct image *image, struct error *error) {
    (void)turning_light(0.5);
    return draw_turn(drawing, image, error);
}

static const struct scene trials[] = {
    {.name = "matt", .draw = try_matt},
    {.name = "turn", .draw = try_turn},
    /* Not square, and odd: a square or a large picture hides some mistakes. */
    {.name = "wide", .needs = MAPPED_MESH, .width = 203, .height = 67, .draw = draw_heads},
    {.name = "high", .needs = MAPPED_MESH, .width = 61, .height = 181, .draw = draw_heads},
    {
        .name = "small",
        .needs = MESH,
        .width = 23,
        .height = 13,
        .light = {-1, 0.5, 0.4},
        .draw = try_matt,
    },
    {.name = "one_pixel", .needs = MESH, .width = 1, .height = 1, .draw = try_matt},
};

MAIN_WITH(trials)
