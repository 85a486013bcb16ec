/*
 * Step 1, the given part: its scenes and the program.
 *
 * `pixel`, `line`, `gradient`, or the lines of a text scene.
 */

/* Draw a line whose colour runs from color_a at a to color_b at b. */
static bool line_gradient(struct image *image, struct pixel a, struct pixel b, struct color color_a,
                          struct color color_b, struct error *error) {
    size_t length = line_length(a, b);
    struct pixel *list = calloc(length, sizeof *list);
    if (list == NULL) {
        return error_set(error, "out of memory for a line of %zu pixels", length);
    }
    line_list(a, b, list);
    for (size_t i = 0; i < length; i++) {
        image_set(image, list[i].x, list[i].y, color_along(a, b, color_a, color_b, list[i]));
    }
    free(list);
    return true;
}

/* ---- Scenes ---- */

static bool draw_pixel(struct drawing *drawing, struct image *image, struct error *error) {
    (void)drawing, (void)error;
    first_pixel(image);
    return true;
}

static bool draw_line(struct drawing *drawing, struct image *image, struct error *error) {
    (void)drawing, (void)error;
    line(image, (struct pixel){13, 20}, (struct pixel){80, 40}, color_rgb(255, 255, 255));
    line(image, (struct pixel){20, 13}, (struct pixel){40, 80}, color_rgb(255, 0, 0));
    return true;
}

/* A star: the four axes, the four diagonals, a line in each of the eight octants, and a point. */
static bool draw_gradient(struct drawing *drawing, struct image *image, struct error *error) {
    (void)drawing;
    const struct color red = color_rgb(255, 0, 0), yellow = color_rgb(255, 255, 0);
    const struct color green = color_rgb(0, 255, 0), blue = color_rgb(0, 0, 255);
    const struct color white = color_rgb(255, 255, 255), dark = color_rgb(32, 32, 32);
    const struct {
        struct pixel a, b;
        struct color color_a, color_b;
    } lines[] = {
        {{58, 50}, {97, 50}, red, yellow}, {{50, 58}, {50, 97}, red, yellow},
        {{42, 50}, {3, 50}, red, yellow},  {{50, 42}, {50, 3}, red, yellow},
        {{56, 56}, {84, 84}, white, dark}, {{44, 56}, {16, 84}, white, dark},
        {{44, 44}, {16, 16}, white, dark}, {{56, 44}, {84, 16}, white, dark},
        {{58, 53}, {95, 68}, green, blue}, {{53, 58}, {68, 95}, green, blue},
        {{47, 58}, {32, 95}, green, blue}, {{42, 53}, {5, 68}, green, blue},
        {{5, 32}, {42, 47}, green, blue},  {{32, 5}, {47, 42}, green, blue},
        {{68, 5}, {53, 42}, green, blue},  {{95, 32}, {58, 47}, green, blue},
        {{50, 50}, {50, 50}, green, blue},
    };
    for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) {
        if (!line_gradient(image, lines[i].a, lines[i].b, lines[i].color_a, lines[i].color_b,
                           error)) {
            return false;
        }
    }
    return true;
}

/* Only the pixels inside the image: the house version, line_begin() and line_next(), leaps over the
 * others. Step 2 shows how. Returns how many there are. */
static size_t draw_visible(struct image *image, struct pixel a, struct pixel b,
                           struct color color_a, struct color color_b) {
    struct line_walk walk;
    size_t visible = 0;
    bool more = line_begin(&walk, a, b, image->width, image->height);
    for (; more; more = line_next(&walk)) {
        struct pixel p = {walk.x, walk.y};
        image_set(image, p.x, p.y, color_along(a, b, color_a, color_b, p));
        visible++;
    }
    return visible;
}

/* Draw the lines of a text scene. They may be far longer than the image: what lies outside is
 * skipped, or with --no-skip walked over pixel by pixel. */
static bool draw_text(struct drawing *drawing, struct image *image, struct error *error) {
    for (size_t i = 0; i < drawing->text->shape_count; i++) {
        const struct text_scene_shape *shape = &drawing->text->shapes[i];
        struct pixel a = {(int)shape->x[0], (int)shape->y[0]};
        struct pixel b = {(int)shape->x[1], (int)shape->y[1]};
        size_t length = line_length(a, b), walked = length;
        if (drawing->skip) {
            walked = draw_visible(image, a, b, shape->color[0], shape->color[1]);
        } else if (!line_gradient(image, a, b, shape->color[0], shape->color[1], error)) {
            return false;
        }
        drawing_count(drawing, "pixels_walked", walked);
        drawing_count(drawing, "pixels_skipped", length - walked);
    }
    return true;
}

/* ---- The program ---- */

static const struct scene scenes[] = {
    {.name = "pixel", .draw = draw_pixel},
    {.name = "line", .draw = draw_line},
    {.name = "gradient", .draw = draw_gradient},
};

int main(int argc, char **argv) {
    static const struct program program = {
        .name = "step01_line",
        .summary = "a pixel, lines, and lines whose colour changes",
        .defaults = {.width = 100, .height = 100},
        .draw_text = draw_text,
        .text_kind = TEXT_SCENE_LINES,
        .scenes = scenes,
        .scene_count = sizeof scenes / sizeof scenes[0],
    };
    return program_main(&program, argc, argv);
}
