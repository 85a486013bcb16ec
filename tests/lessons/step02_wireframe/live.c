/* Lesson 2 under the mouse: ways to list sides and to cut lines, and a window over the model. */
#ifndef LESSON
#define LESSON "../step02_wireframe/main.c"
#endif
#include "more_scenes.h"

#include "../../../step02_wireframe/attempts.h"

/* ---- Lines cut to the image ---- */

#define LIVE_LINE_ATTEMPT                                                                          \
    { "attempt", "0 line_inside(), 1 every pixel tested, 2 ends rounded", 0, 2, 1, 0 }

static line_function *live_line(const struct drawing *drawing) {
    static line_function *const lines[] = {line_inside, line, attempt_line_ends_rounded};
    return lines[(int)drawing_value(drawing, "attempt")];
}

/* The middle of the window is a point to drag over the model. */
static const struct scene_value live_window_values[] = {
    {"middle_x", "middle of the window", -1, 1, 0.01, 0.08},
    {"middle_y", "middle of the window", -1, 1, 0.01, 0.42},
    {"larger", "times as large", 1, 40, 0.5, 6},
    LIVE_LINE_ATTEMPT,
    {.name = NULL},
};

static bool live_enlarged(struct drawing *drawing, struct image *image, struct error *error) {
    const struct vec2 middle = drawing_point(drawing, "middle");
    const struct view view = {middle.x, middle.y, drawing_value(drawing, "larger")};
    return draw_model(drawing, drawing->model, view, live_line(drawing), image, error);
}

static const struct scene_value live_cut_values[] = {
    LIVE_LINE_ATTEMPT,
    {.name = NULL},
};

static bool live_cut(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    for (int i = 0; i < CUT_LINES; i++) {
        const struct cut_line *l = &cut_lines[i];
        drawing_count(drawing, "pixels_walked",
                      live_line(drawing)(image, l->a, l->b, line_colors[l->color]));
    }
    return true;
}

/* ---- A mesh with a border ---- */

static const struct scene_value live_border_values[] = {
    {"attempt", "0 each side once, 1 sides in one direction", 0, 1, 1, 0},
    {.name = NULL},
};

static bool live_border(struct drawing *drawing, struct image *image, struct error *error) {
    const struct model part = quarter_of(drawing->model);
    struct wireframe wireframe;
    if (drawing_value(drawing, "attempt") == 0) {
        return draw_border(drawing, image, error);
    }
    if (!wireframe_create(&wireframe, &part, error)) {
        return false;
    }
    wireframe.side_count = attempt_one_direction(&part, wireframe.sides);
    draw_sides(drawing, &wireframe, part.positions, (struct view){0.26, 0.1, 2.4}, line, image);
    free(wireframe.sides);
    return true;
}

/* ---- The scenes ---- */

static const struct scene live[] = {
    {.name = "enlarged", .values = live_window_values, .draw = live_enlarged},
    {.name = "cut", .values = live_cut_values, .draw = live_cut},
    {.name = "border", .values = live_border_values, .draw = live_border},
};

MAIN_WITH(live)
