/* Lesson 10 under the mouse: weights and power, one shader alone, and the vectors at a pixel. */
#ifndef LESSON
#define LESSON "../step10_phong/main.c"
#endif
#include "more_scenes.h"

#if __has_include("told.h")
#include "told.h"
#else /* the formulas would be answers: a hand-out says nothing of a pixel */
static void told_note(struct drawing *drawing, const struct image *image,
                      const struct draw_call *call, const struct uniforms *u) {
    (void)drawing, (void)image, (void)call, (void)u;
}
#endif

/* Say of the cells of a picture what there is to say about the probed pixel. */
static void live_notes(struct drawing *drawing, const struct image *image, const struct cell *cells,
                       int columns, int rows, double zoom) {
    for (int i = 0; drawing->probed && i < columns * rows; i++) {
        struct rectangle place = grid_cell(image->width, image->height, columns, rows, i);
        for (size_t part = 0; drawing_take_part(drawing, part); part++) {
            struct draw_call call = pipeline_call(drawing, place, zoom, CULL_BACK);
            struct uniforms u = cell_uniforms(drawing, &cells[i], zoom * place.width);
            call.model = u.model;
            told_note(drawing, image, &call, &u);
        }
    }
}

/* ---- Scenes ---- */

static bool live_heads(struct drawing *drawing, struct image *image, struct error *error) {
    struct cell cells[4];
    make_heads[drawing->number](cells);
    live_notes(drawing, image, cells, 2, 2, 0.8);
    return draw_heads(drawing, image, error);
}

static const struct scene_value live_four_values[] = {
    {"shader", "0 all four, 1 plain, 2 normal map, 3 texture, 4 both", 0, 4, 1, 0},
    {"ambient", "weight of the ambient light", 0, 1, 0.01, 0.1},
    {"diffuse", "weight of the diffuse light", 0, 2, 0.01, 1},
    {"specular", "times as much specular light", 0, 3, 0.01, 1},
    {"power", "power of the specular light", 0, 200, 1, 10},
    {.name = NULL},
};

static bool live_four(struct drawing *drawing, struct image *image, struct error *error) {
    const int one = (int)drawing_value(drawing, "shader"), side = one > 0 ? 1 : 2;
    struct cell cells[4];
    make_four(cells);
    for (int i = 0; i < 4; i++) {
        struct material *material = &cells[i].material;
        material->ambient = drawing_value(drawing, "ambient");
        material->diffuse = drawing_value(drawing, "diffuse");
        material->specular *= drawing_value(drawing, "specular");
        material->power = (int)drawing_value(drawing, "power");
    }
    const struct cell *first = one > 0 ? &cells[one - 1] : cells;
    live_notes(drawing, image, first, side, side, 0.8);
    return draw_cells(drawing, image, first, side, side, 0.8, error);
}

static bool live_near(struct drawing *drawing, struct image *image, struct error *error) {
    struct cell cells[4];
    make_near(cells, NULL, NULL);
    live_notes(drawing, image, cells, 4, 1, 2.5);
    return draw_large_faces(drawing, image, error);
}

static const struct scene live[] = {
    {.name = "parts", .draw = live_heads},
    {.name = "shine", .draw = live_heads},
    {.name = "four", .values = live_four_values, .draw = live_four},
    {.name = "behind", .values = live_four_values, .draw = live_four},
    {.name = "near", .draw = live_near},
};

MAIN_WITH(live)
