/* Lesson 5, the given part: the pictures of README.md, and the program. */

/* ---- Scene: rows ---- */

/* The rows of pixels where parts of the picture begin, and their heights. */
enum {
    ROWS_PLANE_BOTTOM = 140, /* the segments in their plane, whose y is the depth: to the top */
    ROWS_PLANE = 500,
    ROWS_COLOR_BOTTOM = 80, /* what the row shows, and its depths */
    ROWS_DEPTH_BOTTOM = 20,
    ROWS_STRIP = 40
};

/* Draw the segment in its plane, three pixels thick. */
static void draw_plane_line(const struct segment *s, struct image *image) {
    for (int shift = -1; shift <= 1; shift++) {
        const int bottom = ROWS_PLANE_BOTTOM + shift;
        struct pixel a = {(int)floor(s->a.x), bottom + (int)floor(s->a.y)};
        struct pixel b = {(int)floor(s->b.x), bottom + (int)floor(s->b.y)};
        struct line_walk walk;
        bool more = line_begin(&walk, a, b, image->width, image->height);
        for (; more; more = line_next(&walk)) {
            image_set(image, walk.x, walk.y, s->color);
        }
    }
}

/* Draw one column of a strip, which shows a row of pixels many times, one above the other. */
static void draw_strip(struct image *image, int x, int bottom, struct color color) {
    for (int y = bottom; y < bottom + ROWS_STRIP; y++) {
        image_set(image, x, y, color);
    }
}

static void draw_segments(const struct segment *segments, size_t count, struct image *image,
                          double *depths) {
    for (size_t i = 0; i < count; i++) {
        draw_plane_line(&segments[i], image);
        draw_segment(&segments[i], image, ROWS_COLOR_BOTTOM, depths);
    }
    for (int x = 0; x < (int)image->width; x++) {
        draw_strip(image, x, ROWS_COLOR_BOTTOM, image_get(image, x, ROWS_COLOR_BOTTOM));
        draw_strip(image, x, ROWS_DEPTH_BOTTOM,
                   color_grey(level_from(depths[x] * 255.0 / ROWS_PLANE)));
    }
}

/* Three long segments that cross. Of the short ones two are far away, and one hides the other; the
 * rest reach beyond the sides. The last two are equally near, so the first of them is seen. */
static const struct segment rows_segments[] = {
    {{20.5, 34}, {744.5, 400}, {.r = 255, .a = 255}},
    {{120.7, 434}, {444.8, 400}, {.g = 255, .a = 255}},
    {{330, 463}, {594, 200}, {.b = 255, .a = 255}},
    {{748, -6}, {766, -6}, {.r = 200, .a = 255}},
    {{748, -16}, {766, -16}, {.r = 80, .g = 40, .a = 255}},
    {{-40, 150}, {8, 90}, {.b = 150, .g = 150, .r = 150, .a = 255}},
    {{770, 90}, {840, 150}, {.b = 150, .g = 150, .r = 150, .a = 255}},
    {{770, 90}, {840, 150}, {.b = 220, .g = 220, .r = 220, .a = 255}},
};

static bool draw_rows(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    draw_segments(rows_segments, sizeof rows_segments / sizeof rows_segments[0], image,
                  drawing->depth);
    return true;
}

/* ---- Scenes with a model ---- */

/* The corners of a face in the parallel view; z is the depth. False for a corner too far off the
 * image to draw. */
static bool place_face(const struct model *model, size_t face, const struct image *image,
                       struct vertex vertices[3]) {
    for (size_t i = 0; i < 3; i++) {
        struct vec3 world = model_position(model, face, i);
        vertices[i].depth = world.z;
        if (!screen_snap(parallel_view(world, image->width, image->height),
                         &vertices[i].position)) {
            return false;
        }
    }
    return true;
}

static void count_pixels(struct drawing *drawing, const struct canvas *canvas) {
    drawing_count(drawing, "pixels_tested", canvas->pixels_tested);
    drawing_count(drawing, "pixels_hidden", canvas->pixels_tested - canvas->pixels_written);
    drawing_count(drawing, "pixels_written", canvas->pixels_written);
}

/* All faces on which light falls, as in lesson 4. */
static bool draw_zbuffer(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct model *model = drawing->model;
    const struct vec3 light = vec3_normalized(drawing->light);
    struct canvas canvas = {.image = image, .depth = drawing->depth};
    for (size_t face = 0; face < model->face_count; face++) {
        struct vertex vertices[3];
        const double intensity = model_face_intensity(model, face, light);
        if (intensity > 0 && place_face(model, face, image, vertices)) {
            triangle(&canvas, vertices, color_grey(level_from(intensity * 255)));
        }
    }
    count_pixels(drawing, &canvas);
    return true;
}

static bool draw_depth(struct drawing *drawing, struct image *image, struct error *error) {
    bool done = draw_zbuffer(drawing, image, error);
    show_depths(image, drawing->depth);
    return done;
}

/* ---- Scene: hidden ---- */

/* How many pixels lines are lifted towards us: README.md derives it. */
enum { LINE_LIFT = 2 };

/* Draw the faces in the colour of the ground, then the sides of each, lifted by `lift` pixels. A
 * side of two faces is drawn twice, over itself. */
static void draw_hidden_lines(const struct model *model, double lift, struct canvas *canvas) {
    const struct image *image = canvas->image;
    const size_t shorter = image->width < image->height ? image->width : image->height;
    const double nearer = lift * 2 / (double)shorter; /* the image shows 2 of the model's units */
    struct vertex v[3];
    for (size_t face = 0; face < model->face_count; face++) {
        if (place_face(model, face, image, v)) {
            triangle(canvas, v, color_grey(0));
        }
    }
    for (size_t i = 0; i < 3 * model->face_count; i++) {
        if (place_face(model, i / 3, image, v)) {
            struct line_end end[2];
            for (size_t k = 0; k < 2; k++) {
                const struct vertex *corner = &v[(i + k) % 3];
                end[k].pixel.x = corner->position.x >> SUBPIXEL_BITS;
                end[k].pixel.y = corner->position.y >> SUBPIXEL_BITS;
                end[k].depth = corner->depth + nearer;
            }
            hidden_line(canvas, end[0], end[1], color_grey(255));
        }
    }
}

static bool draw_hidden(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    struct canvas canvas = {.image = image, .depth = drawing->depth};
    draw_hidden_lines(drawing->model, LINE_LIFT, &canvas);
    return true;
}

/* ---- Scene: cards ---- */

/* A rectangle that faces us: two of its corners, in pixels. */
struct card {
    struct vec2 low, high;
    double depth;
    struct color color;
};

static void draw_card(const struct card *card, struct canvas *canvas) {
    const struct vec2 low = card->low, high = card->high;
    const struct vec2 corners[] = {low, {high.x, low.y}, high, {low.x, high.y}};
    struct vertex v[4];
    for (int i = 0; i < 4; i++) {
        v[i].depth = card->depth;
        screen_snap(corners[i], &v[i].position);
    }
    triangle(canvas, (struct vertex[]){v[0], v[1], v[2]}, card->color);
    triangle(canvas, (struct vertex[]){v[0], v[2], v[3]}, card->color);
}

/* A grey card lies behind all others and is larger than the image. Blue is a thousandth behind red,
 * green exactly as near, yellow a thousandth nearer, and orange half a millionth. Elsewhere, purple
 * is far away and cyan very near. Last come white and, in the same place and equally near, black,
 * which stays hidden: no float is exactly their depth. */
static const struct card cards[] = {
    {{-40, -40}, {440, 440}, -7000, {.r = 70, .g = 70, .b = 70, .a = 255}},
    {{100, 120}, {260, 280}, 0, {.r = 220, .g = 60, .b = 50, .a = 255}},
    {{40, 200}, {180, 360}, -0.001, {.r = 60, .g = 90, .b = 220, .a = 255}},
    {{40, 40}, {180, 180}, 0, {.r = 60, .g = 170, .b = 70, .a = 255}},
    {{200, 60}, {360, 240}, 0.001, {.r = 230, .g = 190, .b = 40, .a = 255}},
    {{190, 246}, {250, 274}, 0.0000005, {.r = 250, .g = 150, .b = 90, .a = 255}},
    {{290, 280}, {390, 380}, -6000, {.r = 130, .g = 60, .b = 140, .a = 255}},
    {{320, 310}, {360, 350}, 7000, {.r = 120, .g = 210, .b = 220, .a = 255}},
    {{20, 370}, {240, 390}, 0.7, {.r = 235, .g = 235, .b = 235, .a = 255}},
    {{20, 370}, {240, 390}, 0.7, {.r = 20, .g = 20, .b = 20, .a = 255}},
};

static bool draw_cards(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    struct canvas canvas = {.image = image, .depth = drawing->depth};
    for (size_t i = 0; i < sizeof cards / sizeof cards[0]; i++) {
        draw_card(&cards[i], &canvas);
    }
    return true;
}

/* ---- The program ---- */

enum { MODEL_AND_DEPTH = NEEDS_MODEL | NEEDS_DEPTH };

/* `side` isn't square: a program that takes its height for its width mixes rows of depths. */
static const struct scene scenes[] = {
    {.name = "rows", .needs = NEEDS_DEPTH, .height = 640, .draw = draw_rows},
    {.name = "zbuffer", .needs = MODEL_AND_DEPTH, .draw = draw_zbuffer},
    {.name = "depth", .needs = MODEL_AND_DEPTH, .format = IMAGE_GREY, .draw = draw_depth},
    {.name = "knot", .needs = MODEL_AND_DEPTH, .model = "knot.off", .draw = draw_zbuffer},
    {.name = "side",
     .needs = MODEL_AND_DEPTH,
     .height = 600,
     .light = {1, 0, -1},
     .draw = draw_zbuffer},
    {.name = "cards", .needs = NEEDS_DEPTH, .width = 400, .height = 400, .draw = draw_cards},
    {.name = "hidden", .needs = MODEL_AND_DEPTH, .draw = draw_hidden},
};

static const struct program step05_zbuffer = {
    .name = "step05_zbuffer",
    .summary = "a depth for every pixel: the nearest triangle is seen",
    .takes_light = true,
    .defaults = {.width = 800, .height = 800, .light = {0, 0, -1}},
    .scenes = scenes,
    .scene_count = sizeof scenes / sizeof scenes[0],
};
