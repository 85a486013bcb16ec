/* Lesson 4, the given part: the pictures of README.md, and the program. */

/* ---- Scene: flat ---- */

/* The faces in the order of the file. One that gets no light is not drawn; with the light in the
 * viewer's direction that is a face that shows its back. What lies behind something else is still
 * painted over it: that is lesson 5. */
static bool draw_flat(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct model *model = drawing->model;
    const struct vec3 to_light = vec3_scale(vec3_normalized(drawing->light), -1);
    for (size_t face = 0; face < model->face_count; face++) {
        struct vertex vertices[3] = {{{0, 0}}};
        const double intensity = face_intensity(model, face, to_light);
        if (intensity > 0 && place_face(model, face, image, vertices)) {
            triangle(image, vertices, color_grey(level_from(intensity * 255)));
        }
    }
    return true;
}

/* ---- Scene: side ---- */

/* A model of one face. */
static struct model one_face(struct vec3 corners[3]) {
    static struct face face = {
        {{0, MODEL_NONE, MODEL_NONE}, {1, MODEL_NONE, MODEL_NONE}, {2, MODEL_NONE, MODEL_NONE}}};
    return (struct model){
        .positions = corners, .position_count = 3, .faces = &face, .face_count = 1};
}

typedef bool draw_function(struct drawing *drawing, struct image *image, struct error *error);

/* One face more, drawn by draw_flat() or in another way. */
static bool draw_face(struct drawing *drawing, struct image *image, struct vec3 corners[3],
                      draw_function *draw, struct error *error) {
    const struct model one = one_face(corners), *model = drawing->model;
    drawing->model = &one;
    bool done = draw(drawing, image, error);
    drawing->model = model;
    return done;
}

/* Faces smaller than a pixel, around the centres of a square of pixels: they are as bright as large
 * ones. */
static bool draw_tiny_faces(struct drawing *drawing, struct image *image, draw_function *draw,
                            struct error *error) {
    enum { SIDE = 36 };
    double width = 2 / (double)image->width, height = 2 / (double)image->height; /* of a pixel */
    bool done = true;
    for (int i = 0; done && i < SIDE * SIDE; i++) {
        double x = floor(1.82 / width) + i % SIDE, y = floor(1.55 / height) + i / SIDE;
        double left = (x + 0.4) * width - 1, low = (y + 0.4) * height - 1;
        struct vec3 corners[3] = {
            {left, low, 0}, {left + 0.3 * width, low, 0}, {left, low + 0.3 * height, 0}};
        done = draw_face(drawing, image, corners, draw, error);
    }
    return done;
}

/* Faces around the head: four leave the image, and one looks away and is lit from behind. The last
 * row of the image stays black. */
static bool draw_more_faces(struct drawing *drawing, struct image *image, draw_function *draw,
                            struct error *error) {
    struct vec3 corners[][3] = {
        {{-0.95, -0.3, 0}, {-0.7, 0.2, 0}, {-1.3, 0.45, 0.3}}, /* leave the image: left */
        {{0.7, 0.1, 0}, {1.3, -0.4, 0.2}, {1.3, 0.7, 0}},      /* right */
        {{-0.5, 0.97, 0}, {0.5, 0.97, 0}, {0, 1.4, -0.2}},     /* above */
        {{-0.9, -0.96, 0}, {0, -1.5, 0.3}, {0.9, -0.96, 0}},   /* below */
        {{-0.95, 0.95, 0}, {-0.75, 0.95, 0.1}, {-0.95, 0.75, 0}},
    };
    const struct vec3 light = drawing->light, from_behind = {0.2, 0.1, 1};
    struct image rows = *image;
    bool done = true;
    rows.height--;
    for (int i = 0; rows.height > 0 && done && i < 5; i++) {
        drawing->light = i < 4 ? light : from_behind;
        done = draw_face(drawing, &rows, corners[i], draw, error);
    }
    drawing->light = light;
    return done && (rows.height == 0 || draw_tiny_faces(drawing, &rows, draw, error));
}

static bool draw_side(struct drawing *drawing, struct image *image, struct error *error) {
    return draw_flat(drawing, image, error) && draw_more_faces(drawing, image, draw_flat, error);
}

/* ---- The program ---- */

/* The size of `side` is odd, and its width is not its height: halved or exchanged, it shows. */
static const struct scene scenes[] = {
    {.name = "flat", .needs = NEEDS_MODEL, .draw = draw_flat},
    {.name = "side",
     .needs = NEEDS_MODEL,
     .width = 719,
     .height = 797,
     .light = {0.4, -0.25, -1},
     .draw = draw_side},
};

static const struct program step04_flat = {
    .name = "step04_flat",
    .summary = "one grey for each face, from its normal and the light",
    .takes_light = true,
    .defaults = {.width = 800, .height = 800, .light = {0, 0, -1}},
    .scenes = scenes,
    .scene_count = sizeof scenes / sizeof scenes[0],
};
