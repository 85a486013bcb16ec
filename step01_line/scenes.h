/*
 * Lesson 1, the given part: its scenes and the program.
 *
 * `pixel`; lines by line(): `line`, `octants`, `ties` and `far`, and `wide`, `high`, `small` and
 * `one_pixel` for images of other sizes; lines by line_list(): `list` and `gradient`; or the lines
 * of a text scene.
 */

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

/* ---- Lines that come half-way between two pixels ---- */

/* Two with slopes, 7 / 12 and 9 / 14, of which a double does not hit the multiples at a tie; then,
 * for scene `list` alone, a short diagonal in each direction, a long line with three ties, lines
 * downwards and to the left, and a point. */
static const struct pixel more_lines[][2] = {
    {{3, 104}, {15, 111}},  {{25, 104}, {53, 122}}, {{7, 65}, {11, 69}}, {{23, 65}, {19, 69}},
    {{31, 69}, {35, 65}},   {{47, 69}, {43, 65}},   {{3, 96}, {93, 99}}, {{64, 122}, {64, 104}},
    {{96, 110}, {74, 110}}, {{85, 118}, {85, 118}},
};
enum { SHORT_LINES = 64, TIE_LINES = SHORT_LINES + 2, TIES_WIDTH = 100, TIES_HEIGHT = 125 };
enum { LISTED_LINES = SHORT_LINES + sizeof more_lines / sizeof more_lines[0] };

/* Eight directions of eight lines, row by row from the bottom, all with ties; then the others. */
static void tie_line(int index, struct pixel *a, struct pixel *b) {
    if (index >= SHORT_LINES) {
        *a = more_lines[index - SHORT_LINES][0];
        *b = more_lines[index - SHORT_LINES][1];
        return;
    }
    static const int run[] = {10, 10, 10, 10, 10, 2, 4, 8}, rise[] = {1, 3, 5, 7, 9, 1, 3, 1};
    int direction = index % 8, kind = index / 8;
    bool steep = direction & 1;
    int width = steep ? rise[kind] : run[kind], height = steep ? run[kind] : rise[kind];
    int x = 3 + 12 * direction, y = 3 + 12 * kind;
    bool left = direction & 2, down = direction & 4;
    *a = (struct pixel){left ? x + width : x, down ? y + height : y};
    *b = (struct pixel){left ? x : x + width, down ? y : y + height};
}

/* Each from a to b in white, then from b to a in red: nothing white may be left. */
static bool draw_ties(struct drawing *drawing, struct image *image, struct error *error) {
    (void)drawing, (void)error;
    for (int i = 0; i < TIE_LINES; i++) {
        struct pixel a, b;
        tie_line(i, &a, &b);
        line(image, a, b, color_rgb(255, 255, 255));
        line(image, b, a, color_rgb(255, 0, 0));
    }
    return true;
}

/* The same lines and more as lists: in green, the first pixel of each in white. */
static bool draw_list(struct drawing *drawing, struct image *image, struct error *error) {
    (void)drawing;
    for (int i = 0; i < LISTED_LINES; i++) {
        struct pixel a, b;
        tie_line(i, &a, &b);
        size_t length = line_length(a, b);
        struct pixel *list = make_list(a, b, length, error);
        if (list == NULL) {
            return false;
        }
        for (size_t k = 0; k < length; k++) {
            struct color color = k == 0 ? color_rgb(255, 255, 255) : color_rgb(0, 255, 0);
            image_set(image, list[k].x, list[k].y, color);
        }
        free(list);
    }
    return true;
}

/* Lines that begin or end far outside the image, or never come in. */
static bool draw_far(struct drawing *drawing, struct image *image, struct error *error) {
    (void)drawing, (void)error;
    static const struct {
        struct pixel a, b;
        struct color color; /* blue, green, red, alpha */
    } lines[] = {
        {{-1000000, -250007}, {199, 60}, {255, 255, 255, 255}}, /* flat, up */
        {{1000000, -370935}, {-999000, 370701}, {0, 0, 255, 255}},
        {{-299983, 1000000}, {300071, -1000000}, {0, 255, 255, 255}}, /* steep */
        {{70, 99}, {-777777, -1000000}, {0, 255, 0, 255}},
        {{-1000000, 999989}, {1000000, -999853}, {255, 128, 0, 255}}, /* nearly diagonal */
        {{-1000000, -377011}, {999999, 377087}, {128, 255, 0, 255}},  /* a little above a tie */
        {{-1000000, -622949}, {999999, 622952}, {255, 0, 128, 255}},  /* a little below one */
        {{1000000, 96}, {-1000000, 96}, {0, 128, 255, 255}},
        {{3, 1000000}, {3, -1000000}, {255, 0, 255, 255}},
        {{-1000000, 50}, {-1, 50}, {255, 255, 255, 255}}, /* these three stay outside */
        {{100, 0}, {100, 99}, {255, 255, 255, 255}},
        {{-1000000, -1000000}, {-5, 90}, {255, 255, 255, 255}},
    };
    for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) {
        line(image, lines[i].a, lines[i].b, lines[i].color);
    }
    return true;
}

/* Lines from the middle of an image of any size to its border, every other one drawn inwards. */
static bool draw_spokes(struct drawing *drawing, struct image *image, struct error *error) {
    enum { SPOKES = 5 };
    (void)drawing, (void)error;
    const int right = (int)image->width - 1, top = (int)image->height - 1;
    const struct pixel middle = {right / 2, top / 2};
    for (int i = 0; i < SPOKES; i++) {
        int x = right * i / (SPOKES - 1), y = top * i / (SPOKES - 1);
        const struct pixel ends[] = {{x, 0}, {right, y}, {x, top}, {0, y}};
        for (int k = 0; k < 4; k++) {
            bool inwards = (i + k) % 2 != 0;
            line(image, inwards ? ends[k] : middle, inwards ? middle : ends[k],
                 inwards ? color_rgb(255, 0, 0) : color_rgb(255, 255, 255));
        }
    }
    return true;
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

/* ---- Text scenes ---- */

/* The attempts' helpers have names that a student's own may have, too. */
#define nearest_pixel attempts_nearest_pixel
#define transposed    attempts_transposed
#define make_flat     attempts_make_flat
#define set_flat      attempts_set_flat
#include "attempts.h"
#undef nearest_pixel
#undef transposed
#undef make_flat
#undef set_flat

static const struct scene_value text_values[] = {
    {"attempt",
     "0 line(), 1 a hundred steps, 2 ten steps, 3 a step for each column, 4 swapped, "
     "5 division outside, 6 added up, 7 in two parts, 8 by cases, 9 by runs",
     0, 9, 1, 0},
    {"reversed", "from the second end to the first", 0, 1, 1, 0},
    {"wrong", "red is wrong, blue is missing", 0, 1, 1, 0},
    {"steps", "share of the line that is drawn", 0, 1, 0.01, 1},
    {.name = NULL},
};

static struct pixel shape_end(const struct text_scene_shape *shape, int end) {
    return (struct pixel){(int)shape->x[end], (int)shape->y[end]};
}

/* By an attempt, or by line() where both ends have the same colour. */
static bool draw_shape(const struct drawing *drawing, struct image *image,
                       const struct text_scene_shape *shape, struct error *error) {
    const int first = (int)drawing_value(drawing, "reversed"), last = 1 - first;
    struct pixel a = shape_end(shape, first), b = shape_end(shape, last);
    int attempt = (int)drawing_value(drawing, "attempt");
    if (attempt > 0) {
        line_attempt(attempt - 1)(image, a, b, shape->color[0]);
    } else if (memcmp(&shape->color[0], &shape->color[1], sizeof shape->color[0]) == 0) {
        line(image, a, b, shape->color[0]);
    } else {
        return line_gradient(image, a, b, shape->color[first], shape->color[last], error);
    }
    return true;
}

/* Is the pixel among the first steps of a line, from its left or lower end on? */
static bool is_reached(const struct text_scene_shape *shape, double steps, int x, int y) {
    bool steep = fabs(shape->y[1] - shape->y[0]) > fabs(shape->x[1] - shape->x[0]);
    const double *u = steep ? shape->y : shape->x;
    return (steep ? y : x) <= fmin(u[0], u[1]) + steps * fabs(u[1] - u[0]);
}

/* Where the exact line is at the probed pixel's column, or at a steep line's row, and how far the
 * pixel is from it. */
static void note_line(struct drawing *drawing, const struct text_scene_shape *shape) {
    struct pixel a = shape_end(shape, 0), b = shape_end(shape, 1), p = drawing->probe;
    int run = b.x - a.x, rise = b.y - a.y;
    bool steep = abs(rise) > abs(run);
    int step = steep ? p.y - a.y : p.x - a.x, from = steep ? a.x : a.y;
    int length = steep ? rise : run, climb = steep ? run : rise;
    if (length != 0 && step / length == 0 && (step == 0 || (step < 0) == (length < 0))) {
        const double exact = from + (double)step * climb / length;
        drawing_note(drawing, "at %s = %d the line is at %s = %d + %d * %d/%d = %.3f, error %+.3f",
                     steep ? "y" : "x", steep ? p.y : p.x, steep ? "x" : "y", from, step, climb,
                     length, exact, (steep ? p.x : p.y) - exact);
    }
}

/* Is the pixel the line's nearest one in its column, or in its row where the line is steep? Of two
 * as near, the one towards the end at which a walk starts. */
static bool is_on_line(const struct text_scene_shape *shape, int x, int y) {
    const struct pixel ends[] = {shape_end(shape, 0), shape_end(shape, 1)};
    const int64_t dx = (int64_t)ends[1].x - ends[0].x, dy = (int64_t)ends[1].y - ends[0].y;
    const bool steep = llabs(dy) > llabs(dx);
    const int64_t run = llabs(steep ? dy : dx), rise = llabs(steep ? dx : dy);
    const struct pixel start = ends[(steep ? dy : dx) < 0];
    const int64_t along = steep ? y - start.y : x - start.x;
    const int64_t aside = (steep ? x - start.x : y - start.y) * ((dx < 0) == (dy < 0) ? 1 : -1);
    const int64_t off = 2 * (aside * run - along * rise); /* in parts of 1 / (2 run) pixels */
    return along >= 0 && along <= run && (run == 0 ? aside == 0 : off >= -run && off < run);
}

/* Draw the first steps of a line. */
static bool draw_steps(struct drawing *drawing, struct image *image,
                       const struct text_scene_shape *shape, struct error *error) {
    const double steps = drawing_value(drawing, "steps");
    struct image whole;
    if (!image_create(&whole, image->width, image->height, IMAGE_BGR, error)) {
        return false;
    }
    bool done = draw_shape(drawing, &whole, shape, error);
    for (int i = 0; i < (int)(image->width * image->height); i++) {
        int x = i % (int)image->width, y = i / (int)image->width;
        struct color color = image_get(&whole, x, y);
        if (color.r + color.g + color.b > 0 && is_reached(shape, steps, x, y)) {
            image_set(image, x, y, color);
        }
    }
    image_free(&whole);
    return done;
}

/* Is the pixel among those steps of one of the lines? */
static bool is_wanted(const struct drawing *drawing, double steps, int x, int y) {
    bool wanted = false;
    for (size_t i = 0; i < drawing->text->shape_count && !wanted; i++) {
        const struct text_scene_shape *shape = &drawing->text->shapes[i];
        wanted = is_on_line(shape, x, y) && is_reached(shape, steps, x, y);
    }
    return wanted;
}

/* Red: drawn, but on no line. Blue: missing. */
static void mark_wrong(struct drawing *drawing, struct image *image) {
    const double steps = drawing_value(drawing, "steps");
    uint64_t wrong = 0, missing = 0;
    for (int i = 0; i < (int)(image->width * image->height); i++) {
        int x = i % (int)image->width, y = i / (int)image->width;
        struct color now = image_get(image, x, y);
        bool drawn = now.r + now.g + now.b > 0, wanted = is_wanted(drawing, steps, x, y);
        wrong += drawn && !wanted;
        missing += !drawn && wanted;
        image_set(image, x, y,
                  drawn == wanted ? color_grey(drawn ? 160 : 0)
                                  : color_rgb(drawn ? 255 : 0, drawn ? 0 : 90, drawn ? 0 : 255));
    }
    drawing_count(drawing, "pixels_wrong", wrong);
    drawing_count(drawing, "pixels_missing", missing);
}

static bool draw_text(struct drawing *drawing, struct image *image, struct error *error) {
    bool done = true;
    for (size_t i = 0; done && i < drawing->text->shape_count; i++) {
        const struct text_scene_shape *shape = &drawing->text->shapes[i];
        done = drawing_value(drawing, "steps") == 1 ? draw_shape(drawing, image, shape, error)
                                                    : draw_steps(drawing, image, shape, error);
        if (drawing->probed) {
            note_line(drawing, shape);
        }
    }
    if (drawing_value(drawing, "wrong") != 0) {
        mark_wrong(drawing, image);
    }
    return done;
}

/* ---- The program ---- */

static const struct scene scenes[] = {
    {.name = "pixel", .draw = draw_pixel},
    {.name = "line", .draw = draw_line},
    {.name = "octants", .draw = draw_octants},
    {.name = "ties", .width = TIES_WIDTH, .height = TIES_HEIGHT, .draw = draw_ties},
    {.name = "far", .draw = draw_far},
    {.name = "list", .width = TIES_WIDTH, .height = TIES_HEIGHT, .draw = draw_list},
    {.name = "gradient", .draw = draw_gradient},
    {.name = "wide", .width = 203, .height = 67, .draw = draw_spokes},
    {.name = "high", .width = 61, .height = 181, .draw = draw_spokes},
    {.name = "small", .width = 23, .height = 13, .draw = draw_spokes},
    {.name = "one_pixel", .width = 1, .height = 1, .draw = draw_spokes},
};

static const struct program step01_line = {
    .name = "step01_line",
    .summary = "a pixel, lines, and lines whose colour changes",
    .defaults = {.width = 100, .height = 100},
    .draw_text = draw_text,
    .text_kind = TEXT_SCENE_LINES,
    .text_values = text_values,
    .text = "size 100 100\n"
            "line 13 20 80 40 255 255 255\n"
            "line 20 13 40 80 255 0 0\n",
    .scenes = scenes,
    .scene_count = sizeof scenes / sizeof scenes[0],
};
