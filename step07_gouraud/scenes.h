/* Lesson 7, the given part: the pictures of README.md, and the program. */

/* Place the corners of a face in the parallel view, with z as the depth, and find its edges. False
 * when there is nothing to draw: a corner is too far off the picture, the face covers no pixel
 * centre, or its corners run clockwise on the screen, so that we look at its inside. */
static bool begin_face(const struct model *model, size_t face, const struct canvas *canvas,
                       struct vertex v[3], struct edges *edges) {
    for (size_t i = 0; i < 3; i++) {
        const struct vec3 world = model_position(model, face, i);
        v[i] = (struct vertex){.depth = world.z};
        if (!screen_snap(parallel_view(world, canvas->width, canvas->height), &v[i].position)) {
            return false;
        }
    }
    return edges_setup(edges, v[0].position, v[1].position, v[2].position, canvas->width,
                       canvas->height) &&
           !edges->clockwise;
}

/* ---- Scene: gouraud ---- */

static bool draw_gouraud(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct model *model = drawing->model;
    const struct vec3 light = vec3_normalized(drawing->light);
    const struct canvas canvas = {image, image->width, image->height, drawing->depth, NULL};
    for (size_t face = 0; face < model->face_count; face++) {
        struct vertex v[3];
        struct edges edges;
        if (begin_face(model, face, &canvas, v, &edges)) {
            for (size_t i = 0; i < 3; i++) {
                const struct vec3 normal = vec3_normalized(model_normal(model, face, i));
                v[i].intensity = corner_intensity(normal, light);
                v[i].color = vec3_scale(model_color(model, face, i), v[i].intensity);
            }
            if (model_has_colors(model)) { /* which the head has not */
                color_triangle(&canvas, &edges, v);
            } else {
                triangle(&canvas, &edges, v);
            }
        }
    }
    return true;
}

/* ---- Scene: colors ---- */

static bool draw_colors(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct model *model = drawing->model;
    const struct canvas canvas = {image, image->width, image->height, drawing->depth, NULL};
    for (size_t face = 0; face < model->face_count; face++) {
        struct vertex v[3];
        struct edges edges;
        if (begin_face(model, face, &canvas, v, &edges)) {
            for (size_t i = 0; i < 3; i++) {
                v[i].color = model_color(model, face, i);
            }
            color_triangle(&canvas, &edges, v);
        }
    }
    return true;
}

/* ---- Scenes: lit and behind ---- */

/* Four pictures in one. The light and the camera are points here. */
static void draw_material(struct drawing *drawing, struct image *image,
                          const struct material *material) {
    const struct model *model = drawing->model;
    const struct vec3 light = drawing->light, camera = drawing->eye;
    const struct canvas canvas = {image, image->width / 2, image->height / 2, drawing->depth,
                                  material};
    for (size_t face = 0; face < model->face_count; face++) {
        struct vertex v[3];
        struct edges edges;
        if (begin_face(model, face, &canvas, v, &edges)) {
            for (size_t i = 0; i < 3; i++) {
                const struct vec3 position = model_position(model, face, i);
                const struct vec3 normal = vec3_normalized(model_normal(model, face, i));
                v[i].parts = corner_light(position, normal, light, camera, material);
            }
            lit_triangle(&canvas, &edges, v);
        }
    }
}

/* In the lower left corner the powers 0 to 31 of 0.9, row by row from below. */
static void draw_powers(struct image *image) {
    enum { COLUMNS = 8, ROWS = 4 };
    const int side = (int)image->width / 40;
    for (int y = 0; y < ROWS * side && y < (int)image->height; y++) {
        for (int column = 0; column < COLUMNS; column++) {
            const double product = integer_power(0.9, y / side * COLUMNS + column);
            image_fill_row(image, y, column * side, (column + 1) * side,
                           color_grey(level_from(255 * product)));
        }
    }
}

static bool draw_lit(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    draw_material(drawing, image, &clay);
    draw_powers(image);
    return true;
}

static bool draw_behind(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    draw_material(drawing, image, &satin);
    return true;
}

/* ---- The program ---- */

enum {
    MODEL_AND_NORMALS = NEEDS_MODEL | NEEDS_NORMALS | NEEDS_DEPTH,
    MODEL_AND_COLORS = NEEDS_MODEL | NEEDS_COLORS | NEEDS_DEPTH
};

static const struct scene scenes[] = {
    {.name = "gouraud", .needs = MODEL_AND_NORMALS, .draw = draw_gouraud},
    {.name = "colors", .needs = MODEL_AND_COLORS, .model = "knot.off", .draw = draw_colors},
    {
        .name = "lit",
        .needs = MODEL_AND_NORMALS,
        .light = {-2, 2, 3},
        .eye = {0, 0, 3},
        .draw = draw_lit,
    },
    {
        .name = "behind",
        .needs = MODEL_AND_NORMALS,
        .height = 720,
        .light = {-2, 2, -3},
        .eye = {1.2, -0.6, 2.5},
        .draw = draw_behind,
    },
};

static const struct program step07_gouraud = {
    .name = "step07_gouraud",
    .summary = "light at the corners, smooth between them",
    .takes_light = true,
    .defaults = {.width = 800, .height = 800, .light = {0, 0, 1}},
    .scenes = scenes,
    .scene_count = sizeof scenes / sizeof scenes[0],
};
