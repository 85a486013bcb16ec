/*
 * Step 2, the given part: its scene and the program.
 *
 * `wireframe` draws the sides of a model, white on black.
 */

/* What is drawn: a list of sides, made before the drawing. */
struct wireframe {
    struct side *sides;
    size_t side_count;
};

static bool prepare(struct drawing *drawing, size_t width, size_t height, struct error *error) {
    (void)width, (void)height;
    struct wireframe *wireframe = drawing->state;
    size_t side_count = 3 * drawing->model->face_count;
    wireframe->sides = calloc(side_count, sizeof *wireframe->sides);
    if (wireframe->sides == NULL) {
        return error_set(error, "out of memory for %zu sides", side_count);
    }
    list_sides(drawing->model, wireframe->sides);
    wireframe->side_count =
        drawing->skip ? keep_one_of_each(wireframe->sides, side_count) : side_count;
    return true;
}

static void finish(struct drawing *drawing) {
    struct wireframe *wireframe = drawing->state;
    free(wireframe->sides);
}

static bool draw_wireframe(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct wireframe *wireframe = drawing->state;
    const struct model *model = drawing->model;
    uint64_t drawn = 0, off_image = 0, too_far = 0;
    for (size_t i = 0; i < wireframe->side_count; i++) {
        struct side side = wireframe->sides[i];
        struct vec3 from = model->positions[side.low];
        struct vec3 to = model->positions[side.high];
        struct pixel a, b;
        if (!to_pixel(from, image->width, image->height, &a) ||
            !to_pixel(to, image->width, image->height, &b)) {
            too_far++;
        } else if (line(image, a, b, color_rgb(255, 255, 255)) == 0) {
            off_image++;
        } else {
            drawn++;
        }
    }
    drawing_count(drawing, "lines_drawn", drawn);
    drawing_count(drawing, "lines_shared_skipped", 3 * model->face_count - wireframe->side_count);
    drawing_count(drawing, "lines_off_image", off_image);
    drawing_count(drawing, "lines_too_far", too_far);
    return true;
}

static const struct scene scenes[] = {
    {.name = "wireframe", .needs = NEEDS_MODEL, .draw = draw_wireframe},
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
