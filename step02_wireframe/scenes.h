/*
 * Step 2, the given part: its scenes and the program.
 *
 * `wireframe` draws the sides of a model, white on black. `border` draws a third of its faces in an
 * image that is not square, `enlarged` the model much larger than the image, `cut` single lines.
 */
#ifdef LINE_IS_MINE /* make LINE=mine: the line() of lesson 1 draws */
#include "mine.h"
#define line my_line
#endif

/* What is drawn: a list of sides, made before the drawing. */
struct wireframe {
    struct side *sides;
    size_t side_count;
};

/* With --no-skip, a side that two faces share stands in the list twice. */
static bool wireframe_create(struct wireframe *wireframe, const struct model *model, bool skip,
                             struct error *error) {
    size_t side_count = 3 * model->face_count;
    wireframe->sides = calloc(side_count + 1, sizeof *wireframe->sides);
    if (wireframe->sides == NULL) {
        return error_set(error, "out of memory for %zu sides", side_count);
    }
    list_sides(model, wireframe->sides);
    wireframe->side_count = skip ? keep_one_of_each(wireframe->sides, side_count) : side_count;
    return true;
}

static bool prepare(struct drawing *drawing, size_t width, size_t height, struct error *error) {
    (void)width, (void)height;
    return drawing->model == NULL || /* the scene `cut` */
           wireframe_create(drawing->state, drawing->model, drawing->skip, error);
}

static void finish(struct drawing *drawing) {
    struct wireframe *wireframe = drawing->state;
    free(wireframe->sides);
}

/* ---- Wireframes ---- */

/* What lies at (x,y) of the model comes to the middle of the image, `scale` times as large. */
struct view {
    double x, y, scale;
};

static struct vec3 seen(struct vec3 position, struct view view) {
    return (struct vec3){(position.x - view.x) * view.scale, (position.y - view.y) * view.scale,
                         position.z};
}

static void draw_sides(struct drawing *drawing, const struct wireframe *wireframe, struct view view,
                       struct image *image) {
    const struct vec3 *positions = drawing->model->positions;
    uint64_t drawn = 0, off_image = 0, too_far = 0;
    for (size_t i = 0; i < wireframe->side_count; i++) {
        struct side side = wireframe->sides[i];
        struct pixel a, b;
        if (!to_pixel(seen(positions[side.low], view), image->width, image->height, &a) ||
            !to_pixel(seen(positions[side.high], view), image->width, image->height, &b)) {
            too_far++;
            continue;
        }
        uint64_t walked = line(image, a, b, color_rgb(255, 255, 255));
        drawing_count(drawing, "pixels_walked", walked);
        off_image += walked == 0;
        drawn += walked > 0;
    }
    drawing_count(drawing, "lines_drawn", drawn);
    drawing_count(drawing, "lines_off_image", off_image);
    drawing_count(drawing, "lines_too_far", too_far);
}

static bool draw_wireframe(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct wireframe *wireframe = drawing->state;
    draw_sides(drawing, wireframe, (struct view){0, 0, 1}, image);
    drawing_count(drawing, "lines_shared_skipped",
                  3 * drawing->model->face_count - wireframe->side_count);
    return true;
}

/* A quarter of the faces: a mesh with a border. */
static bool draw_border(struct drawing *drawing, struct image *image, struct error *error) {
    struct model part = *drawing->model;
    part.faces += part.face_count / 8;
    part.face_count = (part.face_count + 3) / 4;
    struct wireframe wireframe = {0};
    bool made = wireframe_create(&wireframe, &part, drawing->skip, error);
    if (made) {
        draw_sides(drawing, &wireframe, (struct view){0.26, 0.1, 2.4}, image);
    }
    free(wireframe.sides);
    return made;
}

/* One side of the face, six times as large: most of the model lies outside. */
static bool draw_enlarged(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    draw_sides(drawing, drawing->state, (struct view){0.08, 0.42, 6}, image);
    return true;
}

/* ---- Single lines ---- */

/* Lines that leave the image on every side, end on its outermost pixels, run along its edges, or
 * never come in. The ones along the edges lie below the others. */
static bool draw_cut(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct color white = color_rgb(255, 255, 255), red = color_rgb(255, 0, 0);
    const struct color green = color_rgb(0, 255, 0), blue = color_rgb(96, 160, 255);
    const int right = (int)image->width - 1, top = (int)image->height - 1;
    const struct {
        struct pixel a, b;
        struct color color;
    } lines[] = {
        /* along the edges */
        {{-5, 0}, {right + 5, 0}, green},
        {{right + 1000000, top}, {-1000000, top}, green},
        {{0, top + 9}, {0, -9}, green},
        {{right, -1000000}, {right, 1000000}, green},
        /* across all of the image, to its outermost pixels */
        {{0, 10}, {right, top - 10}, blue},
        {{0, top - 10}, {right, 10}, blue},
        {{30, top}, {50, 0}, blue},
        {{right - 30, 0}, {right - 50, top}, blue},
        /* in on the left, the right, at the bottom, at the top */
        {{-17, -9}, {right + 30, top + 22}, white},
        {{right + 51, -14}, {-30, top + 29}, white},
        {{right - 20, -40}, {33, top + 71}, white},
        {{40, top + 90}, {right + 10, -301}, white},
        {{-1000000, -612345}, {999999, 612421}, white},
        {{-499979, 1000000}, {500121, -999901}, white},
        /* one end inside */
        {{80, 50}, {right + 100, 77}, red},
        {{80, 50}, {-111, 20}, red},
        {{80, 50}, {101, top + 200}, red},
        {{80, 50}, {48, -150}, red},
        /* outside: beside, above and below, past a corner */
        {{-9, -5}, {-1, top + 5}, white},
        {{right + 1, -5}, {right + 1, top + 5}, white},
        {{-5, top + 1}, {right + 9, top + 2}, white},
        {{-5, -1}, {right + 9, -1}, white},
        {{-70, 50}, {60, top + 80}, white},
        {{right + 2, -1}, {right + 2, -1}, white},
    };
    for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) {
        drawing_count(drawing, "pixels_walked",
                      line(image, lines[i].a, lines[i].b, lines[i].color));
    }
    return true;
}

/* ---- The program ---- */

static const struct scene scenes[] = {
    {.name = "wireframe", .needs = NEEDS_MODEL, .draw = draw_wireframe},
    {.name = "border", .needs = NEEDS_MODEL, .width = 480, .height = 360, .draw = draw_border},
    {.name = "enlarged", .needs = NEEDS_MODEL, .width = 480, .height = 360, .draw = draw_enlarged},
    {.name = "cut", .width = 160, .height = 100, .draw = draw_cut},
};

int main(int argc, char **argv) {
    static const struct program program = {
        .name = "step02_wireframe",
        .summary = "the sides of a model's faces",
        .defaults = {.width = 800, .height = 800},
        .scenes = scenes,
        .scene_count = sizeof scenes / sizeof scenes[0],
        .state_size = sizeof(struct wireframe),
        .prepare = prepare,
        .finish = finish,
    };
    return program_main(&program, argc, argv);
}
