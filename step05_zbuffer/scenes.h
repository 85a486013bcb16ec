/*
 * Lesson 5, the given part: its scenes and the program.
 *
 * `rows` shows the idea in one dimension: three segments of a plane, seen from above, in one row of
 * pixels, and short ones that leave it at its sides. `zbuffer` is lesson 4 with a depth buffer,
 * `depth` shows its depths, `deep` the same ones far away below and very near above; `knot` is a
 * body that winds around itself. In `side` the light comes from the side, and falls on faces that
 * look away from us too. The cards of `cards` lie almost, or exactly, in one plane, or far apart;
 * `single` shows the depths of two cards, which are all the same. `wide`, `high`
 * and `one_pixel` draw the same in images of other shapes, and `small` pairs of cards.
 */
#include <stdlib.h>

/* Which attempt draws. */
enum { DEPTH_BUFFER, FILE_ORDER, PAINTER, MEAN_DEPTH };

/* ---- Scene: rows ---- */

/* In pixels of a picture of the usual size: the plane on top, then as strips the row of colours and
 * the row of depths. */
enum {
    ROWS_WIDTH = 800,
    ROWS_HEIGHT = 640,
    ROWS_PLANE = 500, /* height of the plane; its y is the depth */
    ROWS_PLANE_BOTTOM = 140,
    ROWS_COLOR_BOTTOM = 80,
    ROWS_DEPTH_BOTTOM = 20,
    ROWS_STRIP = 40 /* height of a strip */
};

/* The segment itself, three pixels thick. */
static void draw_plane_line(const struct segment *s, struct image *image, int bottom) {
    for (int shift = -1; shift <= 1; shift++) {
        struct pixel a = {(int)floor(s->a.x), bottom + (int)floor(s->a.y) + shift};
        struct pixel b = {(int)floor(s->b.x), bottom + (int)floor(s->b.y) + shift};
        struct line_walk walk;
        bool more = line_begin(&walk, a, b, image->width, image->height);
        for (; more; more = line_next(&walk)) {
            image_set(image, walk.x, walk.y, s->color);
        }
    }
}

/* A pixel `height` times, one above the other, so that a row can be seen. */
static void draw_column(struct image *image, int x, int bottom, int height, struct color color) {
    for (int y = bottom; y < bottom + height; y++) {
        image_set(image, x, y, color);
    }
}

/* The ends of the first three segments are points to drag. */
#define ROWS_POINT(name, x, y)                                                                     \
    {name "_x", "end", 0, ROWS_WIDTH, 0.1, x}, {                                                   \
        name "_y", "end", -ROWS_PLANE_BOTTOM, ROWS_PLANE, 0.1, y                                   \
    }
static const struct scene_value rows_values[] = {
    ROWS_POINT("red", 20.5, 34),
    ROWS_POINT("red_end", 744.5, 400),
    ROWS_POINT("green", 120.7, 434),
    ROWS_POINT("green_end", 444.8, 400),
    ROWS_POINT("blue", 330, 463),
    ROWS_POINT("blue_end", 594, 200),
    {"attempt", "0 depth buffer, 1 in the order given, 2 the painter's order", 0, 2, 1, 0},
    {.name = NULL},
};

/* The segment between two of them, from left to right. */
static struct segment dragged_segment(const struct drawing *drawing, const char *from,
                                      const char *to, struct color color) {
    const struct vec2 a = drawing_point(drawing, from), b = drawing_point(drawing, to);
    return (struct segment){a.x < b.x ? a : b, a.x < b.x ? b : a, color};
}

static int compare_segments(const void *a, const void *b) {
    const struct segment *s = a, *t = b;
    const double depth = s->a.y + s->b.y, other = t->a.y + t->b.y;
    return (depth > other) - (depth < other);
}

static bool draw_rows(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    struct segment segments[] = {
        dragged_segment(drawing, "red", "red_end", color_rgb(255, 0, 0)),
        dragged_segment(drawing, "green", "green_end", color_rgb(0, 255, 0)),
        dragged_segment(drawing, "blue", "blue_end", color_rgb(0, 0, 255)),
        {{748, -6}, {766, -6}, {.r = 200, .a = 255}},                    /* below 0: so far away */
        {{748, -16}, {766, -16}, {.r = 80, .g = 40, .a = 255}},          /* farther still: hidden */
        {{-40, 150}, {8, 90}, {.b = 150, .g = 150, .r = 150, .a = 255}}, /* beyond the sides */
        {{770, 90}, {840, 150}, {.b = 150, .g = 150, .r = 150, .a = 255}},
        {{770, 90}, {840, 150}, {.b = 220, .g = 220, .r = 220, .a = 255}}, /* as near: hidden */
    };
    const int attempt = (int)drawing_value(drawing, "attempt");
    if (attempt == PAINTER) {
        qsort(segments, sizeof segments / sizeof segments[0], sizeof segments[0], compare_segments);
    }
    /* Another size than the usual one shows the same picture, smaller or larger. */
    double across = (double)image->width / ROWS_WIDTH, up = (double)image->height / ROWS_HEIGHT;
    int strip = (int)(ROWS_STRIP * up), color_bottom = (int)(ROWS_COLOR_BOTTOM * up);
    for (size_t i = 0; i < sizeof segments / sizeof segments[0]; i++) {
        struct segment s = segments[i];
        s.a = (struct vec2){s.a.x * across, s.a.y * up};
        s.b = (struct vec2){s.b.x * across, s.b.y * up};
        draw_plane_line(&s, image, (int)(ROWS_PLANE_BOTTOM * up));
        draw_segment(&s, image, color_bottom, drawing->depth);
        if (attempt != DEPTH_BUFFER) {
            depth_clear(drawing->depth, image->width); /* the next one is drawn over it */
        }
    }
    double levels = 255 / (ROWS_PLANE * up);
    double *behind = drawing->depth + (image->height > 1 ? image->width : 0); /* the row */
    /* Nothing of this segment lies in an image half as wide: `behind` stays as it is. */
    const struct segment outside = {{770 * across, 90}, {840 * across, 150}, {.r = 255, .a = 255}};
    struct image narrow = *image;
    narrow.width = image->width / 2;
    draw_segment(&outside, &narrow, 0, behind);
    for (int x = 0; x < (int)image->width; x++) {
        draw_column(image, x, color_bottom, strip, image_get(image, x, color_bottom));
        draw_column(image, x, (int)(ROWS_DEPTH_BOTTOM * up), strip,
                    color_grey(level_from(drawing->depth[x] * levels)));
        image_set(image, x, 0, color_grey(level_from(behind[x] * levels))); /* black */
    }
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

static const struct scene_value model_values[] = {
    {"faces", "share of the faces that are drawn", 0, 1, 0.0002, 1},
    {"attempt", "0 depth buffer, 1 the file's order, 2 the painter's, 3 a depth for each face", 0,
     3, 1, 0},
    {"bits", "bits of a corner's depth", 1, 52, 1, 52},
    {.name = NULL},
};

/* A depth of -range..range in as many steps as the bits allow; all 52 leave it as it is. */
static double round_depth(double depth, int bits, double range) {
    const double step = ldexp(range, 1 - bits);
    return bits < 52 ? floor(depth / step + 0.5) * step : depth;
}

struct painted {
    double depth; /* of the middle */
    size_t face;
};

static int compare_painted(const void *a, const void *b) {
    const struct painted *p = a, *q = b;
    return (p->depth > q->depth) - (p->depth < q->depth);
}

/* The painter's order of the faces, to be freed by the caller; NULL when memory runs out. */
static struct painted *painters_order(const struct model *model, struct error *error) {
    struct painted *order = calloc(model->face_count + 1, sizeof *order);
    for (size_t face = 0; order != NULL && face < model->face_count; face++) {
        order[face].face = face;
        for (size_t i = 0; i < 3; i++) {
            order[face].depth += model_position(model, face, i).z;
        }
    }
    if (order == NULL) {
        error_out_of_memory(error);
    } else {
        qsort(order, model->face_count, sizeof *order, compare_painted);
    }
    return order;
}

/* The depths of a face's corners in an attempt. What is painted over everything before gets the
 * number of its turn as depth, so that it is nearer. */
static void choose_depths(struct vertex v[3], int attempt, size_t turn, int bits) {
    const double mean = (v[0].depth + v[1].depth + v[2].depth) / 3;
    for (int i = 0; i < 3; i++) {
        v[i].depth = attempt == FILE_ORDER || attempt == PAINTER
                         ? (double)turn
                         : round_depth(attempt == MEAN_DEPTH ? mean : v[i].depth, bits, 1);
    }
}

/* All faces on which light falls, as in lesson 4. */
static bool draw_zbuffer(struct drawing *drawing, struct image *image, struct error *error) {
    const struct model *model = drawing->model;
    const int attempt = (int)drawing_value(drawing, "attempt");
    struct painted *order = attempt == PAINTER ? painters_order(model, error) : NULL;
    if (attempt == PAINTER && order == NULL) {
        return false;
    }
    const struct vec3 light = vec3_normalized(drawing->light);
    struct canvas canvas = {.image = image, .depth = drawing->depth};
    const double share = drawing_value(drawing, "faces");
    const int bits = (int)drawing_value(drawing, "bits");
    for (size_t turn = 0; (double)turn < share * (double)model->face_count; turn++) {
        const size_t face = order != NULL ? order[turn].face : turn;
        struct vertex vertices[3];
        double intensity = model_face_intensity(model, face, light);
        bool lit = intensity > 0;
        if (!lit && drawing->skip) {
            continue; /* it will not be drawn: where it lies does not matter */
        }
        if (place_face(model, face, image, vertices) && lit) {
            choose_depths(vertices, attempt, turn, bits);
            triangle(&canvas, vertices, color_grey(level_from(intensity * 255)));
        }
    }
    free(order);
    drawing_count(drawing, "pixels_tested", canvas.pixels_tested);
    drawing_count(drawing, "pixels_hidden", canvas.pixels_tested - canvas.pixels_written);
    drawing_count(drawing, "pixels_written", canvas.pixels_written);
    return true;
}

static bool draw_depth(struct drawing *drawing, struct image *image, struct error *error) {
    bool done = draw_zbuffer(drawing, image, error);
    show_depths(image, drawing->depth);
    return done;
}

/* The depths of some rows, `more` added to all of them, as a separate picture. The depths of its
 * first and its last pixel are given. */
static void show_rows(const struct image *image, size_t begin, size_t end, double *depth,
                      double first, double last, double more) {
    size_t start = begin * image->width, count = (end - begin) * image->width;
    if (count == 0) {
        return;
    }
    depth[start] = first;
    depth[start + count - 1] = last;
    for (size_t i = start; i < start + count; i++) {
        depth[i] += more;
    }
    struct image rows = {image->width, end - begin, image->format,
                         image->pixels + start * image->format};
    show_depths(&rows, depth + start);
}

/* The same depths: in the lower half all of them are negative, and the first pixel is the nearest
 * one, the last one the farthest; in the upper half they are very large, and it is the other way
 * round. On top are rows in which they are almost equal. */
static bool draw_deep(struct drawing *drawing, struct image *image, struct error *error) {
    bool done = draw_zbuffer(drawing, image, error);
    size_t middle = image->height / 2, even = image->height - image->height / 100;
    for (size_t i = even * image->width; i < image->height * image->width; i++) {
        drawing->depth[i] = 1e-9 * (double)(i % image->width);
    }
    show_rows(image, 0, middle, drawing->depth, 0.7, -0.7, -3000);
    show_rows(image, middle, even, drawing->depth, -0.7, 0.7, 3e9);
    show_rows(image, even, image->height, drawing->depth, 0, 0, 0);
    return done;
}

/* ---- Scenes: cards, single ---- */

/* A rectangle that faces us, in the parallel view. */
struct card {
    struct vec2 low, high;
    double depth;
    struct color color;
};

static void draw_card(const struct card *card, struct canvas *canvas) {
    const struct image *image = canvas->image;
    struct vec2 low = card->low, high = card->high;
    const struct vec3 corners[4] = {
        {low.x, low.y, 0}, {high.x, low.y, 0}, {high.x, high.y, 0}, {low.x, high.y, 0}};
    struct vertex v[4];
    for (int i = 0; i < 4; i++) {
        v[i].depth = card->depth;
        screen_snap(parallel_view(corners[i], image->width, image->height), &v[i].position);
    }
    triangle(canvas, (struct vertex[]){v[0], v[1], v[2]}, card->color);
    triangle(canvas, (struct vertex[]){v[0], v[2], v[3]}, card->color);
}

/* Grey behind all, and on all sides larger than the image. Red; blue is a thousandth behind it,
 * green exactly as near, yellow a thousandth nearer, orange half a millionth. Apart from them
 * purple far away, and cyan very near; and white, with black in the same place and as near, which
 * stays hidden: their depth is not one of those that a float can hold. */
static bool draw_cards(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    static const struct card cards[] = {
        {{-1.2, -1.2}, {1.2, 1.2}, -7000, {.r = 70, .g = 70, .b = 70, .a = 255}},
        {{-0.5, -0.4}, {0.3, 0.4}, 0, {.r = 220, .g = 60, .b = 50, .a = 255}},
        {{-0.8, 0}, {-0.1, 0.8}, -0.001, {.r = 60, .g = 90, .b = 220, .a = 255}},
        {{-0.8, -0.8}, {-0.1, -0.1}, 0, {.r = 60, .g = 170, .b = 70, .a = 255}},
        {{0, -0.7}, {0.8, 0.2}, 0.001, {.r = 230, .g = 190, .b = 40, .a = 255}},
        {{-0.05, 0.23}, {0.25, 0.37}, 0.0000005, {.r = 250, .g = 150, .b = 90, .a = 255}},
        {{0.45, 0.4}, {0.95, 0.9}, -6000, {.r = 130, .g = 60, .b = 140, .a = 255}},
        {{0.6, 0.55}, {0.8, 0.75}, 7000, {.r = 120, .g = 210, .b = 220, .a = 255}},
        {{-0.9, 0.85}, {0.2, 0.95}, 0.7, {.r = 235, .g = 235, .b = 235, .a = 255}},
        {{-0.9, 0.85}, {0.2, 0.95}, 0.7, {.r = 20, .g = 20, .b = 20, .a = 255}},
    };
    struct canvas canvas = {.image = image, .depth = drawing->depth};
    const int bits = (int)drawing_value(drawing, "bits");
    for (size_t i = 0; i < sizeof cards / sizeof cards[0]; i++) {
        struct card card = cards[i];
        card.depth = round_depth(card.depth, bits, 8192);
        draw_card(&card, &canvas);
    }
    return true;
}

/* Pairs of cards in a row, each pair at another depth. The second card of a pair is a little
 * nearer, and covers the lower half of the first one. */
static bool draw_pairs(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    enum { PAIRS = 23 };
    struct canvas canvas = {.image = image, .depth = drawing->depth};
    for (int i = 0; i < PAIRS; i++) {
        const double left = 2.0 * i / PAIRS - 1, depth = 0.0011 * i;
        struct card card = {{left, -1.2}, {left + 2.0 / PAIRS, 1.2}, depth, {.a = 255}};
        card.color = color_rgb((uint8_t)(40 + 8 * i), 60, (uint8_t)(220 - 8 * i));
        draw_card(&card, &canvas);
        card.high.y = 0.1;
        card.depth = depth + 0.006;
        card.color = color_rgb(230, 190, (uint8_t)(20 + 10 * i));
        draw_card(&card, &canvas);
    }
    return true;
}

/* Two cards as near as each other, which cover the first pixel and the last one. */
static bool draw_single(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    static const struct card cards[] = {
        {{-0.6, -0.4}, {1.2, 1.2}, 0, {.r = 255, .a = 255}},
        {{-1.2, -1.2}, {-0.8, -0.7}, 0, {.r = 255, .a = 255}},
    };
    struct canvas canvas = {.image = image, .depth = drawing->depth};
    for (size_t i = 0; i < sizeof cards / sizeof cards[0]; i++) {
        draw_card(&cards[i], &canvas);
    }
    show_depths(image, drawing->depth);
    return true;
}

/* ---- The program ---- */

static const struct scene_value cards_values[] = {
    {"bits", "bits of a card's depth", 1, 52, 1, 52},
    {.name = NULL},
};

static const struct scene scenes[] = {
    {
        .name = "rows",
        .needs = NEEDS_DEPTH,
        .width = ROWS_WIDTH,
        .height = ROWS_HEIGHT,
        .values = rows_values,
        .draw = draw_rows,
    },
    {
        .name = "zbuffer",
        .needs = NEEDS_MODEL | NEEDS_DEPTH,
        .values = model_values,
        .draw = draw_zbuffer,
    },
    {
        .name = "depth",
        .needs = NEEDS_MODEL | NEEDS_DEPTH,
        .format = IMAGE_GREY,
        .values = model_values,
        .draw = draw_depth,
    },
    {
        .name = "deep",
        .needs = NEEDS_MODEL | NEEDS_DEPTH,
        .format = IMAGE_GREY,
        .values = model_values,
        .draw = draw_deep,
    },
    {
        .name = "knot",
        .needs = NEEDS_MODEL | NEEDS_DEPTH,
        .model = "knot.off",
        .values = model_values,
        .draw = draw_zbuffer,
    },
    {
        .name = "side",
        .needs = NEEDS_MODEL | NEEDS_DEPTH,
        .width = 800,
        .height = 600, /* less than the width: taken for it, rows of depths mix */
        .light = {1, 0, -1},
        .values = model_values,
        .draw = draw_zbuffer,
    },
    {
        .name = "cards",
        .needs = NEEDS_DEPTH,
        .width = 400,
        .height = 400,
        .values = cards_values,
        .draw = draw_cards,
    },
    {
        .name = "single",
        .needs = NEEDS_DEPTH,
        .width = 125,
        .height = 80,
        .format = IMAGE_GREY,
        .draw = draw_single,
    },
    /* Not square, and odd: a square or a large picture hides some mistakes. */
    {
        .name = "wide",
        .detail = true,
        .needs = NEEDS_MODEL | NEEDS_DEPTH,
        .width = 203,
        .height = 67,
        .values = model_values,
        .draw = draw_zbuffer,
    },
    {
        .name = "high",
        .detail = true,
        .needs = NEEDS_MODEL | NEEDS_DEPTH,
        .model = "knot.off",
        .width = 61,
        .height = 181,
        .format = IMAGE_GREY,
        .values = model_values,
        .draw = draw_depth,
    },
    {
        .name = "small",
        .detail = true,
        .needs = NEEDS_DEPTH,
        .width = 23,
        .height = 13,
        .draw = draw_pairs,
    },
    {
        .name = "one_pixel",
        .detail = true,
        .needs = NEEDS_DEPTH,
        .width = 1,
        .height = 1,
        .format = IMAGE_GREY,
        .draw = draw_single,
    },
};

static const struct program step05_zbuffer = {
    .name = "step05_zbuffer",
    .summary = "a depth for every pixel: the nearest triangle is seen",
    .takes_light = true,
    .defaults = {.width = 800, .height = 800, .light = {0, 0, -1}},
    .scenes = scenes,
    .scene_count = sizeof scenes / sizeof scenes[0],
};
