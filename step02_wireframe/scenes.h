/* Lesson 2, the given part: the pictures of README.md, and the program. */

/* ---- Scene: points ---- */

/* Positions far outside an image of 256x128, but near enough to draw to; the last three are exactly
 * at LINE_LIMIT. */
enum { FAR_POSITIONS = 6, FAR_WIDTH = 256, FAR_HEIGHT = 128 };
static const struct vec3 far_positions[FAR_POSITIONS] = {
    {4e6, 0, 0},         {0, -5e6, 0},    {-4e6, 5e6, 0},
    {4194303.004, 0, 0}, {0, 8388607, 0}, {0, -8388609, 0},
};

/* One of the boxes at the top, 8x8 pixels. */
static void draw_box(struct image *image, int index, struct color color) {
    for (int i = 0; i < 8 * 8; i++) {
        image_set(image, 4 + 12 * index + i % 8, (int)image->height - 16 + i / 8, color);
    }
}

/* Draw a box for each far position that has a pixel, then the pixels of the model's positions. */
static bool draw_points(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    struct pixel p;
    for (int i = 0; i < FAR_POSITIONS; i++) {
        if (to_pixel(far_positions[i], FAR_WIDTH, FAR_HEIGHT, &p)) {
            draw_box(image, i, color_rgb(0, 255, 0));
        }
    }
    for (size_t i = 0; i < drawing->model->position_count; i++) {
        if (to_pixel(drawing->model->positions[i], image->width, image->height, &p)) {
            image_set(image, p.x, p.y, color_rgb(255, 255, 255));
        }
    }
    return true;
}

/* ---- Scenes with a model's sides ---- */

struct wireframe {
    struct side *sides;
    size_t side_count;
};

/* List all sides of a model, then the lines of its file. The list has room for one more, and the
 * caller frees it. */
static bool wireframe_create(struct wireframe *wireframe, const struct model *model,
                             struct error *error) {
    const size_t of_faces = 3 * model->face_count;
    wireframe->side_count = of_faces + model->line_count;
    wireframe->sides = calloc(wireframe->side_count + 1, sizeof *wireframe->sides);
    if (wireframe->sides == NULL) {
        return error_out_of_memory(error);
    }
    list_sides(model, wireframe->sides);
    for (size_t i = 0; i < model->line_count; i++) {
        uint32_t p = model->lines[i][0], q = model->lines[i][1];
        wireframe->sides[of_faces + i] = (struct side){p < q ? p : q, p < q ? q : p};
    }
    return true;
}

/* The model's point (x,y) comes to the middle of the image, `scale` times as large. */
struct view {
    double x, y, scale;
};

static bool pixel_in_view(struct vec3 p, struct view view, const struct image *image,
                          struct pixel *pixel) {
    const struct vec3 seen = {(p.x - view.x) * view.scale, (p.y - view.y) * view.scale, p.z};
    return to_pixel(seen, image->width, image->height, pixel);
}

/* line() or line_inside(): returns how many pixels it walked over. */
typedef uint64_t line_function(struct image *image, struct pixel a, struct pixel b,
                               struct color color);

static void draw_sides(struct drawing *drawing, const struct wireframe *wireframe,
                       const struct vec3 *positions, struct view view, line_function *draw,
                       struct image *image) {
    uint64_t lines = 0, pixels = 0;
    for (size_t i = 0; i < wireframe->side_count; i++) {
        const struct side side = wireframe->sides[i];
        struct pixel a, b;
        if (pixel_in_view(positions[side.low], view, image, &a) &&
            pixel_in_view(positions[side.high], view, image, &b)) {
            const uint64_t walked = draw(image, a, b, color_rgb(255, 255, 255));
            pixels += walked;
            lines += draw == line || walked > 0; /* line() draws whole lines */
        }
    }
    drawing_count(drawing, "pixels_walked", pixels);
    drawing_count(drawing, "lines_drawn", lines);
}

/* Draw each side once. Scenes of part a use line(), so that part b can't spoil their pictures. */
static bool draw_model(struct drawing *drawing, const struct model *model, struct view view,
                       line_function *draw, struct image *image, struct error *error) {
    struct wireframe wireframe;
    if (!wireframe_create(&wireframe, model, error)) {
        return false;
    }
    wireframe.side_count = keep_one_of_each(wireframe.sides, wireframe.side_count);
    draw_sides(drawing, &wireframe, model->positions, view, draw, image);
    free(wireframe.sides);
    return true;
}

static bool draw_wireframe(struct drawing *drawing, struct image *image, struct error *error) {
    return draw_model(drawing, drawing->model, (struct view){0, 0, 1}, line, image, error);
}

/* A quarter of the faces: a mesh with a border. */
static struct model quarter_of(const struct model *model) {
    struct model part = *model;
    part.faces += part.face_count / 8;
    part.face_count = (part.face_count + 3) / 4;
    part.line_count = 0;
    return part;
}

static bool draw_border(struct drawing *drawing, struct image *image, struct error *error) {
    const struct model part = quarter_of(drawing->model);
    return draw_model(drawing, &part, (struct view){0.26, 0.1, 2.4}, line, image, error);
}

/* ---- Scenes: cut and walked ---- */

enum { CUT_WIDTH = 160, CUT_HEIGHT = 100, RIGHT = CUT_WIDTH - 1, TOP = CUT_HEIGHT - 1 };
enum line_color { WHITE, RED, GREEN, BLUE };
static const struct color line_colors[] = {
    [WHITE] = {255, 255, 255, 255},
    [RED] = {0, 0, 255, 255},
    [GREEN] = {0, 255, 0, 255},
    [BLUE] = {255, 160, 96, 255},
};

/* The green lines run along the edges of the image. The others are drawn over them: they leave the
 * image on every side, end on its outermost pixels, enter it half-way between two pixels, or miss
 * it. The last two are in scene `walked` alone: one in an image of 300x3, and the longest line
 * allowed. */
static const struct cut_line {
    struct pixel a, b;
    enum line_color color;
} cut_lines[] = {
    {{-5, 0}, {RIGHT + 5, 0}, GREEN},
    {{RIGHT + 1000000, TOP}, {-1000000, TOP}, GREEN},
    {{0, TOP + 9}, {0, -9}, GREEN},
    {{RIGHT, -1000000}, {RIGHT, 1000000}, GREEN},
    {{0, 10}, {RIGHT, TOP - 10}, BLUE},
    {{0, TOP - 10}, {RIGHT, 10}, BLUE},
    {{30, TOP}, {50, 0}, BLUE},
    {{RIGHT - 30, 0}, {RIGHT - 50, TOP}, BLUE},
    {{-17, -9}, {RIGHT + 30, TOP + 22}, WHITE},
    {{RIGHT + 51, -14}, {-30, TOP + 29}, WHITE},
    {{RIGHT - 20, -40}, {33, TOP + 71}, WHITE},
    {{40, TOP + 90}, {RIGHT + 10, -301}, WHITE},
    {{-1000000, -612345}, {999999, 612421}, WHITE},
    {{-499979, 1000000}, {500121, -999901}, WHITE},
    {{80, 50}, {RIGHT + 1, 77}, RED},
    {{80, 50}, {-1, 20}, RED},
    {{80, 50}, {101, TOP + 200}, RED},
    {{80, 50}, {48, -150}, RED},
    {{-2, 60}, {18, 65}, BLUE},
    {{18, 70}, {-2, 75}, BLUE},
    {{20, -5}, {21, 5}, BLUE},
    {{100, 90}, {120, 100}, WHITE},
    {{100, -1}, {120, 9}, WHITE},
    {{10, -7}, {60, 0}, WHITE},
    {{RIGHT + 7, 90}, {RIGHT, 30}, WHITE},
    {{-9, -5}, {-1, TOP + 5}, WHITE},
    {{RIGHT + 1, -5}, {RIGHT + 1, TOP + 5}, WHITE},
    {{-5, TOP + 1}, {RIGHT + 9, TOP + 2}, WHITE},
    {{-5, -1}, {RIGHT + 9, -1}, WHITE},
    {{-70, 50}, {60, TOP + 80}, WHITE},
    {{RIGHT + 2, -1}, {RIGHT + 2, -1}, WHITE},
    {{24, 5}, {54, -10}, RED},
    {{RIGHT + 10, 14}, {RIGHT - 10, 64}, RED},
    {{10, 10}, {-10, 60}, RED},
    {{-2, 2}, {2, -2}, RED},
    {{RIGHT, 50}, {RIGHT + 31, 60}, RED},
    {{70, 30}, {70, 30}, RED},
    {{60, -1}, {63, 0}, RED},
    {{10, TOP + 2}, {30, TOP - 3}, RED},
    {{-2, 10}, {3, 30}, RED},
    {{-2, 0}, {301, 2}, RED},
    {{-LINE_LIMIT, -LINE_LIMIT / 2}, {LINE_LIMIT, LINE_LIMIT / 2 - 1}, GREEN},
};
enum { WALKED_LINES = sizeof cut_lines / sizeof cut_lines[0], CUT_LINES = WALKED_LINES - 2 };

static bool draw_cut(struct drawing *drawing, struct image *image, struct error *error) {
    (void)drawing, (void)error;
    for (int i = 0; i < CUT_LINES; i++) {
        line_inside(image, cut_lines[i].a, cut_lines[i].b, line_colors[cut_lines[i].color]);
    }
    return true;
}

/* Draw a bar for each line, from the top down, as long as the line's part in the image. */
static bool draw_walked(struct drawing *drawing, struct image *image, struct error *error) {
    (void)drawing, (void)error;
    for (int i = 0; i < WALKED_LINES; i++) {
        const struct cut_line *l = &cut_lines[i];
        const bool wide = i == CUT_LINES;
        const struct steps steps =
            steps_inside(l->a, l->b, wide ? 300 : CUT_WIDTH, wide ? 3 : CUT_HEIGHT);
        for (int x = 0; x < (int)image->width && x <= steps.last - steps.first; x++) {
            for (int y = 1; y < 4; y++) {
                image_set(image, x, 4 * (WALKED_LINES - 1 - i) + y, line_colors[l->color]);
            }
        }
    }
    return true;
}

/* ---- Scene: enlarged ---- */

/* One side of the face, six times as large: most of the model lies outside. */
static bool draw_enlarged(struct drawing *drawing, struct image *image, struct error *error) {
    return draw_model(drawing, drawing->model, (struct view){0.08, 0.42, 6}, line_inside, image,
                      error);
}

/* ---- The program ---- */

enum { MODEL_OR_LINES = NEEDS_MODEL | NEEDS_LINES };

static const struct scene scenes[] = {
    {.name = "points", .needs = MODEL_OR_LINES, .width = 241, .height = 201, .draw = draw_points},
    {.name = "wireframe", .needs = MODEL_OR_LINES, .draw = draw_wireframe},
    {.name = "border",
     .detail = true,
     .needs = NEEDS_MODEL,
     .width = 480,
     .height = 360,
     .draw = draw_border},
    {.name = "cut", .width = CUT_WIDTH, .height = CUT_HEIGHT, .draw = draw_cut},
    {.name = "walked", .width = 320, .height = 4 * WALKED_LINES, .draw = draw_walked},
    {.name = "enlarged",
     .detail = true,
     .needs = NEEDS_MODEL,
     .width = 480,
     .height = 360,
     .draw = draw_enlarged},
};

static const struct program step02_wireframe = {
    .name = "step02_wireframe",
    .summary = "the sides of a model's faces",
    .defaults = {.width = 800, .height = 800},
    .scenes = scenes,
    .scene_count = sizeof scenes / sizeof scenes[0],
};
