/* Lesson 1, the given part: the pictures of README.md, and the program. */

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

/* Lines from the middle in all octants, every other one drawn inwards (red); a frame, drawn
 * leftwards and downwards; a point in each corner of the image. None comes half-way between two
 * pixels: 47 is odd. */
static bool draw_octants(struct drawing *drawing, struct image *image, struct error *error) {
    (void)drawing, (void)error;
    const struct color white = color_rgb(255, 255, 255), red = color_rgb(255, 0, 0);
    const struct pixel middle = {50, 50};
    static const int other[] = {0, 13, 29, 47, -13, -29};
    for (int i = 0; i < 4 * 6; i++) {
        int u = i % 2 ? -47 : 47, v = other[i / 4];
        bool steep = i / 2 % 2;
        struct pixel end = {50 + (steep ? v : u), 50 + (steep ? u : v)};
        if ((i / 4 + i) % 2) {
            line(image, end, middle, red);
        } else {
            line(image, middle, end, white);
        }
    }
    static const struct pixel corners[] = {{1, 1}, {98, 1}, {98, 98}, {1, 98}};
    for (int i = 0; i < 4; i++) {
        struct pixel p = corners[i], point = {p.x > 50 ? 99 : 0, p.y > 50 ? 99 : 0};
        line(image, p, corners[(i + 1) % 4], color_rgb(0, 255, 255));
        line(image, point, point, color_rgb(255, 255, 0));
    }
    return true;
}

/* The pixels of a line, to be freed by the caller; NULL when memory runs out. */
static struct pixel *make_list(struct pixel a, struct pixel b, size_t length, struct error *error) {
    struct pixel *list = calloc(length, sizeof *list);
    if (list == NULL) {
        error_set(error, "out of memory for a line of %zu pixels", length);
        return NULL;
    }
    line_list(a, b, list);
    return list;
}

/* Draw a line whose colour runs from color_a at a to color_b at b. */
static bool line_gradient(struct image *image, struct pixel a, struct pixel b, struct color color_a,
                          struct color color_b, struct error *error) {
    size_t length = line_length(a, b);
    struct pixel *list = make_list(a, b, length, error);
    for (size_t i = 0; list != NULL && i < length; i++) {
        image_set(image, list[i].x, list[i].y, color_along(a, b, color_a, color_b, list[i]));
    }
    bool done = list != NULL;
    free(list);
    return done;
}

/* A star: the four axes, the four diagonals, a line in each of the eight octants, a point, and
 * in two corners a line that is nearly diagonal. Two more lines begin where the one before begins,
 * and end where the one before ends. */
static bool draw_gradient(struct drawing *drawing, struct image *image, struct error *error) {
    (void)drawing;
    const struct color red = color_rgb(255, 0, 0), yellow = color_rgb(255, 255, 0);
    const struct color green = color_rgb(0, 255, 0), blue = color_rgb(0, 0, 255);
    /* three different values at each end: none may be mixed with another's */
    const struct color leaf = color_rgb(10, 200, 90), rose = color_rgb(240, 60, 130);
    const struct {
        struct pixel a, b;
        struct color color_a, color_b;
    } lines[] = {
        {{58, 50}, {97, 50}, red, yellow}, {{50, 58}, {50, 97}, red, yellow},
        {{42, 50}, {3, 50}, red, yellow},  {{50, 42}, {50, 3}, red, yellow},
        {{56, 56}, {84, 84}, leaf, rose},  {{44, 56}, {16, 84}, leaf, rose},
        {{44, 44}, {16, 16}, leaf, rose},  {{56, 44}, {84, 16}, leaf, rose},
        {{58, 53}, {95, 68}, green, blue}, {{53, 58}, {68, 95}, green, blue},
        {{47, 58}, {32, 95}, green, blue}, {{42, 53}, {5, 68}, green, blue},
        {{5, 32}, {42, 47}, green, blue},  {{32, 5}, {47, 42}, green, blue},
        {{68, 5}, {53, 42}, green, blue},  {{95, 32}, {58, 47}, green, blue},
        {{50, 50}, {50, 50}, green, blue}, {{70, 2}, {98, 20}, rose, leaf},
        {{70, 2}, {84, 2}, rose, leaf},    {{98, 2}, {84, 2}, rose, leaf},
        {{2, 80}, {30, 98}, red, blue},
    };
    for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) {
        if (!line_gradient(image, lines[i].a, lines[i].b, lines[i].color_a, lines[i].color_b,
                           error)) {
            return false;
        }
    }
    return true;
}

/* ---- Lines of a text scene ---- */

/* By line() where both ends have the same colour. */
static bool draw_ends(struct image *image, struct pixel a, struct pixel b, struct color color_a,
                      struct color color_b, struct error *error) {
    if (memcmp(&color_a, &color_b, sizeof color_a) != 0) {
        return line_gradient(image, a, b, color_a, color_b, error);
    }
    line(image, a, b, color_a);
    return true;
}

static bool draw_text(struct drawing *drawing, struct image *image, struct error *error) {
    bool done = true;
    for (size_t i = 0; done && i < drawing->text->shape_count; i++) {
        const struct text_scene_shape *s = &drawing->text->shapes[i];
        const struct pixel a = {(int)s->x[0], (int)s->y[0]}, b = {(int)s->x[1], (int)s->y[1]};
        done = draw_ends(image, a, b, s->color[0], s->color[1], error);
    }
    return done;
}

/* ---- The program ---- */

static const struct scene scenes[] = {
    {.name = "pixel", .draw = draw_pixel},
    {.name = "line", .draw = draw_line},
    {.name = "octants", .draw = draw_octants},
    {.name = "gradient", .draw = draw_gradient},
};

static const struct program step01_line = {
    .name = "step01_line",
    .summary = "a pixel, lines, and lines whose colour changes",
    .defaults = {.width = 100, .height = 100},
    .draw_text = draw_text,
    .text_kind = TEXT_SCENE_LINES,
    .text = "size 100 100\n"
            "line 13 20 80 40 255 255 255\n"
            "line 20 13 40 80 255 0 0\n",
    .scenes = scenes,
    .scene_count = sizeof scenes / sizeof scenes[0],
};
