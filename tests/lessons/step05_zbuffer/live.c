/* Lesson 5 under the mouse: ways to decide what is in front, and depths of fewer bits. */
#ifndef LESSON
#define LESSON "../step05_zbuffer/main.c"
#endif
#include "more_scenes.h"

#include "../../../step05_zbuffer/attempts.h"
#include "large.h"

/* Which attempt draws. */
enum { LIVE_BUFFER, LIVE_FILE_ORDER, LIVE_PAINTER, LIVE_MEAN_DEPTH };

/* ---- Scene: rows ---- */

/* An end of a segment is a point to drag: x from 0 to `right`, y from `bottom` to `top`. */
#define LIVE_POINT(name, right, bottom, top, x, y)                                                 \
    {name "_x", "end", 0, right, 0.1, x}, {                                                        \
        name "_y", "end", bottom, top, 0.1, y                                                      \
    }
static const struct scene_value live_rows_values[] = {
    LIVE_POINT("red", 800, -ROWS_PLANE_BOTTOM, ROWS_PLANE, 20.5, 34),
    LIVE_POINT("red_end", 800, -ROWS_PLANE_BOTTOM, ROWS_PLANE, 744.5, 400),
    LIVE_POINT("green", 800, -ROWS_PLANE_BOTTOM, ROWS_PLANE, 120.7, 434),
    LIVE_POINT("green_end", 800, -ROWS_PLANE_BOTTOM, ROWS_PLANE, 444.8, 400),
    LIVE_POINT("blue", 800, -ROWS_PLANE_BOTTOM, ROWS_PLANE, 330, 463),
    LIVE_POINT("blue_end", 800, -ROWS_PLANE_BOTTOM, ROWS_PLANE, 594, 200),
    {"attempt", "0 depth buffer, 1 in the order given, 2 the painter's order", 0, 2, 1, 0},
    {.name = NULL},
};

static int live_order(double a, double b) {
    return (a > b) - (a < b);
}

/* At equal depth the one that ends farther to the left comes first, or has less red: qsort() has no
 * choice. */
static int live_compare_segments(const void *a, const void *b) {
    const struct segment *s = a, *t = b;
    const int depths = live_order(s->a.y + s->b.y, t->a.y + t->b.y);
    const int ends = live_order(s->b.x, t->b.x);
    return depths != 0 ? depths : ends != 0 ? ends : live_order(s->color.r, t->color.r);
}

static bool live_rows(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    enum { COUNT = sizeof rows_segments / sizeof rows_segments[0] };
    static const char *const names[][2] = {
        {"red", "red_end"}, {"green", "green_end"}, {"blue", "blue_end"}};
    struct segment segments[COUNT];
    memcpy(segments, rows_segments, sizeof segments);
    for (int i = 0; i < 3; i++) {
        const struct vec2 a = drawing_point(drawing, names[i][0]);
        const struct vec2 b = drawing_point(drawing, names[i][1]);
        segments[i].a = a.x < b.x ? a : b;
        segments[i].b = a.x < b.x ? b : a;
    }
    const int attempt = (int)drawing_value(drawing, "attempt");
    if (attempt == LIVE_PAINTER) {
        qsort(segments, COUNT, sizeof segments[0], live_compare_segments);
    }
    if (attempt == LIVE_BUFFER) {
        draw_segments(segments, COUNT, image, drawing->depth);
        return true;
    }
    for (size_t i = 0; i < COUNT; i++) { /* each is drawn over those before */
        draw_segments(&segments[i], 1, image, drawing->depth);
        depth_clear(drawing->depth, image->width);
    }
    draw_segments(NULL, 0, image, drawing->depth);
    return true;
}

/* ---- Scenes with a model ---- */

static const struct scene_value live_model_values[] = {
    {"faces", "share of the faces that are drawn", 0, 1, 0.0002, 1},
    {"attempt", "0 depth buffer, 1 the file's order, 2 the painter's, 3 a depth for each face", 0,
     3, 1, 0},
    {"bits", "bits of a corner's depth", 1, 52, 1, 52},
    {.name = NULL},
};

/* A depth of -range..range in as many steps as the bits allow; all 52 leave it as it is. */
static double live_round(double depth, int bits, double range) {
    const double step = ldexp(range, 1 - bits);
    return bits < 52 ? floor(depth / step + 0.5) * step : depth;
}

struct live_painted {
    double depth; /* of the middle */
    size_t face;
};

static int live_compare_painted(const void *a, const void *b) {
    const struct live_painted *p = a, *q = b;
    const int depths = live_order(p->depth, q->depth);
    return depths != 0 ? depths : (p->face > q->face) - (p->face < q->face);
}

/* The painter's order of the faces, to be freed by the caller; NULL when memory runs out. */
static struct live_painted *live_painters_order(const struct model *model, struct error *error) {
    struct live_painted *order = calloc(model->face_count + 1, sizeof *order);
    for (size_t face = 0; order != NULL && face < model->face_count; face++) {
        order[face].face = face;
        for (size_t i = 0; i < 3; i++) {
            order[face].depth += model_position(model, face, i).z;
        }
    }
    if (order == NULL) {
        error_out_of_memory(error);
    } else {
        qsort(order, model->face_count, sizeof *order, live_compare_painted);
    }
    return order;
}

/* The depths of a face's corners in an attempt. What is painted over everything before gets the
 * number of its turn as depth, so that it is nearer. */
static void live_depths(struct vertex v[3], int attempt, size_t turn, int bits) {
    const double mean = (v[0].depth + v[1].depth + v[2].depth) / 3;
    for (int i = 0; i < 3; i++) {
        v[i].depth = attempt == LIVE_FILE_ORDER || attempt == LIVE_PAINTER
                         ? (double)turn
                         : live_round(attempt == LIVE_MEAN_DEPTH ? mean : v[i].depth, bits, 1);
    }
}

static bool live_zbuffer(struct drawing *drawing, struct image *image, struct error *error) {
    const struct model *model = drawing->model;
    const int attempt = (int)drawing_value(drawing, "attempt");
    struct live_painted *order = attempt == LIVE_PAINTER ? live_painters_order(model, error) : NULL;
    if (attempt == LIVE_PAINTER && order == NULL) {
        return false;
    }
    const struct vec3 light = vec3_normalized(drawing->light);
    struct canvas canvas = {.image = image, .depth = drawing->depth};
    const double share = drawing_value(drawing, "faces");
    const int bits = (int)drawing_value(drawing, "bits");
    for (size_t turn = 0; (double)turn < share * (double)model->face_count; turn++) {
        const size_t face = order != NULL ? order[turn].face : turn;
        struct vertex vertices[3];
        const double intensity = model_face_intensity(model, face, light);
        if (intensity > 0 && place_face(model, face, image, vertices)) {
            live_depths(vertices, attempt, turn, bits);
            triangle(&canvas, vertices, color_grey(level_from(intensity * 255)));
        }
    }
    free(order);
    count_pixels(drawing, &canvas);
    return true;
}

static bool live_depth(struct drawing *drawing, struct image *image, struct error *error) {
    bool done = live_zbuffer(drawing, image, error);
    show_depths(image, drawing->depth);
    return done;
}

/* ---- Scene: cards ---- */

static const struct scene_value live_cards_values[] = {
    {"bits", "bits of a card's depth", 1, 52, 1, 52},
    {.name = NULL},
};

static bool live_cards(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    struct canvas canvas = {.image = image, .depth = drawing->depth};
    const int bits = (int)drawing_value(drawing, "bits");
    for (size_t i = 0; i < sizeof cards / sizeof cards[0]; i++) {
        struct card card = cards[i];
        card.depth = live_round(card.depth, bits, 8192);
        draw_card(&card, &canvas);
    }
    return true;
}

/* ---- Scene: hidden ---- */

static const struct scene_value live_hidden_values[] = {
    {"lift", "pixels by which lines are nearer than their corners", 0, 100, 0.5, LINE_LIFT},
    {.name = NULL},
};

static bool live_hidden(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    struct canvas canvas = {.image = image, .depth = drawing->depth};
    draw_hidden_lines(drawing->model, drawing_value(drawing, "lift"), &canvas);
    return true;
}

/* ---- Scene columns: what each of ten columns keeps, segment by segment ---- */

enum {
    COLUMNS = 10,
    COLUMNS_SIDE = 40, /* of a column, and of a step of depth, in pixels */
    COLUMNS_WIDTH = COLUMNS * COLUMNS_SIDE,
    COLUMNS_PLANE_BOTTOM = 140, /* where the depth is 0; the rows are below */
    COLUMNS_HEIGHT = 360,
    COLUMNS_ROW = 40 /* from one row to the next, the last one at the bottom */
};

static const struct scene_value live_columns_values[] = {
    LIVE_POINT("orange", COLUMNS, -3.5, 5.5, 1, 1),
    LIVE_POINT("orange_end", COLUMNS, -3.5, 5.5, 9, 5),
    LIVE_POINT("green", COLUMNS, -3.5, 5.5, 2, 4.5),
    LIVE_POINT("green_end", COLUMNS, -3.5, 5.5, 6, 2.5),
    LIVE_POINT("blue", COLUMNS, -3.5, 5.5, 4, 5),
    LIVE_POINT("blue_end", COLUMNS, -3.5, 5.5, 9, 1),
    {.name = NULL},
};

static struct pixel live_columns_pixel(const struct image *image, struct vec2 point) {
    return (struct pixel){
        (int)floor(point.x / COLUMNS * (double)image->width),
        (int)floor((COLUMNS_PLANE_BOTTOM + point.y * COLUMNS_SIDE) / COLUMNS_HEIGHT *
                   (double)image->height),
    };
}

static void live_columns_line(struct image *image, struct vec2 a, struct vec2 b,
                              struct color color) {
    struct line_walk walk;
    for (int shift = 0; shift < 2; shift++) {
        struct pixel from = live_columns_pixel(image, a), to = live_columns_pixel(image, b);
        from.y += shift;
        to.y += shift;
        bool more = line_begin(&walk, from, to, image->width, image->height);
        for (; more; more = line_next(&walk)) {
            image_set(image, walk.x, walk.y, color);
        }
    }
}

/* What the columns show so far, as a row of boxes. */
static void live_columns_row(struct image *image, const struct image *row, int bottom) {
    const int side = (int)image->width / COLUMNS;
    const int low = bottom * (int)image->height / COLUMNS_HEIGHT;
    for (int i = 0; i < COLUMNS; i++) {
        for (int k = 0; k < (side - 4) * (side - 12); k++) {
            image_set(image, i * side + 2 + k % (side - 4), low + k / (side - 4),
                      image_get(row, i, 0));
        }
    }
}

static bool live_columns(struct drawing *drawing, struct image *image, struct error *error) {
    static const char *const names[][2] = {
        {"orange", "orange_end"}, {"green", "green_end"}, {"blue", "blue_end"}};
    const struct color colors[] = {color_rgb(235, 140, 40), color_rgb(70, 180, 80),
                                   color_rgb(80, 140, 255)};
    double depths[COLUMNS], kept[3] = {0};
    struct image row;
    if (!image_create(&row, COLUMNS, 1, IMAGE_BGR, error)) {
        return false;
    }
    const int probed = drawing->probe.x * COLUMNS / (int)image->width;
    depth_clear(depths, COLUMNS);
    image_clear(&row, color_grey(50));
    for (int i = 0; i <= COLUMNS; i++) {
        live_columns_line(image, (struct vec2){i, 0}, (struct vec2){i, 5.5}, color_grey(50));
    }
    for (int i = 0; i < 3; i++) {
        const struct vec2 p = drawing_point(drawing, names[i][0]),
                          q = drawing_point(drawing, names[i][1]);
        const struct segment segment = {p.x < q.x ? p : q, p.x < q.x ? q : p, colors[i]};
        live_columns_line(image, segment.a, segment.b, segment.color);
        draw_segment(&segment, &row, 0, depths);
        live_columns_row(image, &row, (2 - i) * COLUMNS_ROW + 8);
        kept[i] = probed >= 0 && probed < COLUMNS ? depths[probed] : 0;
    }
    if (drawing->probed) {
        drawing_note(drawing,
                     "column %d keeps %.2f after orange, %.2f after green, %.2f after blue", probed,
                     kept[0], kept[1], kept[2]);
    }
    image_free(&row);
    return true;
}

/* ---- Scenes trees and bars: are small triangles enough for the painter? ---- */

static const struct scene_value live_large_values[] = {
    {"cuts", "cuts of each side", 1, LARGE_CUTS, 1, 1},
    {.name = NULL},
};

static bool live_large(struct drawing *drawing, struct image *image, void (*make)(struct large *)) {
    size_t wrong[2];
    large_draw(make, (int)drawing_value(drawing, "cuts"), image, drawing->depth, wrong);
    drawing_count(drawing, "wrong_by_the_painter", wrong[0]);
    drawing_count(drawing, "wrong_by_mean_depth", wrong[1]);
    return true;
}

static bool live_trees(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    return live_large(drawing, image, large_trees);
}

static bool live_bars(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    return live_large(drawing, image, large_bars);
}

/* ---- The scenes ---- */

#define LIVE_LARGE                                                                                 \
    .needs = NEEDS_DEPTH, .width = 3 * LARGE_WIDTH, .height = LARGE_HEIGHT,                        \
    .values = live_large_values

static const struct scene live[] = {
    {.name = "rows", .values = live_rows_values, .draw = live_rows},
    {.name = "zbuffer", .values = live_model_values, .draw = live_zbuffer},
    {.name = "depth", .values = live_model_values, .draw = live_depth},
    {.name = "knot", .values = live_model_values, .draw = live_zbuffer},
    {.name = "side", .values = live_model_values, .draw = live_zbuffer},
    {.name = "cards", .values = live_cards_values, .draw = live_cards},
    {.name = "hidden", .values = live_hidden_values, .draw = live_hidden},
    {.name = "columns",
     .width = COLUMNS_WIDTH,
     .height = COLUMNS_HEIGHT,
     .values = live_columns_values,
     .draw = live_columns},
    {.name = "trees", LIVE_LARGE, .draw = live_trees},
    {.name = "bars", LIVE_LARGE, .draw = live_bars},
};

MAIN_WITH(live)
