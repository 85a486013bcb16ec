/*
 * Step 3: filled triangles.
 *
 * A triangle is what lies on the inner side of all three of its edges. Corners are snapped to 1/256
 * pixel once; from there on whole numbers decide, so there is no rounding and no doubt: of all
 * triangles that share an edge, exactly one draws a pixel on it.
 *
 * Scenes: `outline` draws the sides only, `triangle` fills them, `gradient` mixes the colours of
 * the corners, `faces` fills the faces of a model, each in a colour of its own. A text scene draws
 * the triangles that it lists.
 *
 * The setup and the span below are those of common/raster.c, which later lessons use.
 */
#include "program.h"

#include <assert.h>

/* ---- One edge ---- */

/* The edge from p to q, with the triangle to its left when `sign` is 1 and to its right when -1. */
static struct edge make_edge(struct fixed2 p, struct fixed2 q, int sign) {
    int64_t x_distance = sign * ((int64_t)q.x - p.x), y_distance = sign * ((int64_t)q.y - p.y);
    const int64_t center = SUBPIXELS / 2;
    /* Seen counterclockwise with y up, a left edge goes down and a top edge goes left. */
    bool top_left = y_distance < 0 || (y_distance == 0 && x_distance < 0);
    return (struct edge){
        .origin = x_distance * (center - p.y) - y_distance * (center - p.x),
        .dx = -y_distance * SUBPIXELS,
        .dy = x_distance * SUBPIXELS,
        .least = top_left ? 0 : 1,
    };
}

/* ---- Setup: the box of rows, the area, the edges ---- */

/* Division rounded down; C's own division rounds towards zero. */
static inline int64_t floor_divide(int64_t a, int64_t b) {
    int64_t quotient = a / b;
    return quotient - (a % b != 0 && (a < 0) != (b < 0));
}

static inline int64_t ceil_divide(int64_t a, int64_t b) {
    return -floor_divide(-a, b);
}

static inline int32_t least_of(int32_t a, int32_t b, int32_t c) {
    int32_t least = a < b ? a : b;
    return least < c ? least : c;
}

static inline int32_t most_of(int32_t a, int32_t b, int32_t c) {
    int32_t most = a > b ? a : b;
    return most > c ? most : c;
}

/* The pixels whose centres lie in least..most (1/256 pixel), cut to 0..size. */
static struct span centers_between(int32_t least, int32_t most, size_t size) {
    int64_t begin = ceil_divide((int64_t)least - SUBPIXELS / 2, SUBPIXELS);
    int64_t end = floor_divide((int64_t)most - SUBPIXELS / 2, SUBPIXELS) + 1;
    return (struct span){(int)(begin > 0 ? begin : 0),
                         (int)(end < (int64_t)size ? end : (int64_t)size)};
}

/* False when the triangle certainly covers no pixel. The same as edges_setup(). */
static bool triangle_setup(struct edges *edges, struct fixed2 a, struct fixed2 b, struct fixed2 c,
                           size_t width, size_t height) {
    assert(width <= DRAW_LIMIT && height <= DRAW_LIMIT);
    struct span columns = centers_between(least_of(a.x, b.x, c.x), most_of(a.x, b.x, c.x), width);
    struct span rows = centers_between(least_of(a.y, b.y, c.y), most_of(a.y, b.y, c.y), height);
    if (columns.begin >= columns.end || rows.begin >= rows.end) {
        return false;
    }
    int64_t area =
        ((int64_t)b.x - a.x) * ((int64_t)c.y - a.y) - ((int64_t)b.y - a.y) * ((int64_t)c.x - a.x);
    if (area == 0) {
        return false;
    }
    int sign = area > 0 ? 1 : -1;
    *edges = (struct edges){
        .edge = {make_edge(b, c, sign), make_edge(c, a, sign), make_edge(a, b, sign)},
        .area = sign * area,
        .clockwise = area < 0,
        .y_begin = rows.begin,
        .y_end = rows.end,
        .width = (int)width,
    };
    return true;
}

/* ---- Spans ---- */

/* The covered pixels of row y: solve dx * x + (value at x = 0) >= least for x, edge by edge. The
 * same as edges_span(). */
static struct span triangle_span(const struct edges *edges, int y) {
    struct span span = {0, edges->width};
    for (int i = 0; i < 3; i++) {
        const struct edge *e = &edges->edge[i];
        int64_t missing = e->least - (e->origin + e->dy * y); /* inside where dx * x >= missing */
        if (e->dx > 0) {
            int64_t begin = ceil_divide(missing, e->dx);
            if (begin > span.begin) {
                span.begin = begin < span.end ? (int)begin : span.end;
            }
        } else if (e->dx < 0) {
            int64_t end = floor_divide(-missing, -e->dx) + 1;
            if (end < span.end) {
                span.end = end > span.begin ? (int)end : span.begin;
            }
        } else if (missing > 0) {
            span.end = span.begin;
        }
    }
    return span;
}

/* ---- Triangles ---- */

/* A corner of a triangle that is to be drawn. */
struct vertex {
    struct fixed2 position; /* on the screen */
    struct color color;     /* used where the colours of the corners are mixed */
};

/* What is drawn on, and the work done on it. */
struct canvas {
    struct image *image;    /* IMAGE_BGR */
    bool skip;              /* find spans instead of testing pixels */
    uint64_t pixels_tested; /* one by one, with the edge functions */
    uint64_t pixels_written;
};

/* Is the centre of the pixel inside? */
static bool covers(const struct edges *edges, int x, int y) {
    for (int i = 0; i < 3; i++) {
        const struct edge *e = &edges->edge[i];
        if (e->origin + e->dx * x + e->dy * y < e->least) {
            return false;
        }
    }
    return true;
}

/* The covered pixels of a row; without skipping every pixel of the row is asked. */
static struct span find_span(struct canvas *canvas, const struct edges *edges, int y) {
    if (canvas->skip) {
        return triangle_span(edges, y);
    }
    struct span span = {0, 0};
    for (int x = 0; x < edges->width; x++) {
        if (covers(edges, x, y)) {
            span.begin = span.end == 0 ? x : span.begin;
            span.end = x + 1;
        }
    }
    canvas->pixels_tested += (uint64_t)edges->width;
    return span;
}

/* The pixels of a span become `color`. */
static void fill_span(struct image *image, int y, struct span span, struct color color) {
    uint8_t *pixel = image->pixels + ((size_t)y * image->width + (size_t)span.begin) * 3;
    for (int x = span.begin; x < span.end; x++) {
        pixel[0] = color.b;
        pixel[1] = color.g;
        pixel[2] = color.r;
        pixel += 3;
    }
}

/* A triangle of one colour. False when no pixel centre can be inside. */
static bool triangle(struct canvas *canvas, const struct vertex v[3], struct color color) {
    struct image *image = canvas->image;
    struct edges edges;
    if (!triangle_setup(&edges, v[0].position, v[1].position, v[2].position, image->width,
                        image->height)) {
        return false;
    }
    for (int y = edges.y_begin; y < edges.y_end; y++) {
        struct span span = find_span(canvas, &edges, y);
        fill_span(image, y, span, color);
        canvas->pixels_written += (uint64_t)(span.end - span.begin);
    }
    return true;
}

/* The weights of the corners at the centre of a pixel: barycentric coordinates. The same as
 * edges_weights(). */
static struct vec3 triangle_weights(const struct edges *edges, int x, int y) {
    const struct edge *e = edges->edge;
    double scale = 1 / (double)edges->area;
    return (struct vec3){(double)(e[0].origin + e[0].dx * x + e[0].dy * y) * scale,
                         (double)(e[1].origin + e[1].dx * x + e[1].dy * y) * scale,
                         (double)(e[2].origin + e[2].dx * x + e[2].dy * y) * scale};
}

/* The mean of three colours, each with its weight. */
static struct color mix_colors(struct vec3 weight, struct color a, struct color b, struct color c) {
    return color_rgb(level_from(interpolate(weight, a.r, b.r, c.r)),
                     level_from(interpolate(weight, a.g, b.g, c.g)),
                     level_from(interpolate(weight, a.b, b.b, c.b)));
}

/* A triangle whose corners have colours of their own. */
static bool gradient_triangle(struct canvas *canvas, const struct vertex v[3]) {
    struct image *image = canvas->image;
    struct edges edges;
    if (!triangle_setup(&edges, v[0].position, v[1].position, v[2].position, image->width,
                        image->height)) {
        return false;
    }
    for (int y = edges.y_begin; y < edges.y_end; y++) {
        struct span span = find_span(canvas, &edges, y);
        for (int x = span.begin; x < span.end; x++) {
            struct vec3 weight = triangle_weights(&edges, x, y);
            image_set(image, x, y, mix_colors(weight, v[0].color, v[1].color, v[2].color));
        }
        canvas->pixels_written += (uint64_t)(span.end - span.begin);
    }
    return true;
}

/* ---- Scenes made of listed triangles ---- */

static bool same_color(struct color a, struct color b) {
    return a.r == b.r && a.g == b.g && a.b == b.b;
}

/* Draw triangles whose corners are given in pixels, (x,y) meaning the centre of pixel (x,y). */
static void draw_shapes(struct drawing *drawing, struct image *image,
                        const struct text_scene_shape *shapes, size_t shape_count) {
    struct canvas canvas = {.image = image, .skip = drawing->skip};
    uint64_t without_pixel = 0;
    for (size_t i = 0; i < shape_count; i++) {
        const struct text_scene_shape *shape = &shapes[i];
        struct vertex v[3];
        bool placed = true;
        for (int k = 0; k < 3; k++) {
            struct vec2 screen = {shape->x[k] + 0.5, shape->y[k] + 0.5};
            v[k].color = shape->color[k];
            placed = screen_snap(screen, &v[k].position) && placed;
        }
        bool one_color = same_color(v[0].color, v[1].color) && same_color(v[0].color, v[2].color);
        bool drawn = placed && (one_color && drawing->skip ? triangle(&canvas, v, v[0].color)
                                                           : gradient_triangle(&canvas, v));
        without_pixel += !drawn;
    }
    count(drawing, "triangles", shape_count);
    count(drawing, "triangles_without_pixel", without_pixel);
    count(drawing, "pixels_tested", canvas.pixels_tested);
    count(drawing, "pixels_written", canvas.pixels_written);
}

/* Blue, green, red, alpha, as struct color stores them. */
#define RED     0, 0, 255, 255
#define GREEN   0, 255, 0, 255
#define BLUE    255, 0, 0, 255
#define YELLOW  0, 255, 255, 255
#define CYAN    255, 255, 0, 255
#define MAGENTA 255, 0, 255, 255
#define WHITE   255, 255, 255, 255

static const struct text_scene_shape three_triangles[] = {
    {{10, 50, 70}, {70, 160, 80}, {{RED}, {RED}, {RED}}},
    {{180, 150, 70}, {50, 1, 180}, {{WHITE}, {WHITE}, {WHITE}}},
    {{180, 120, 130}, {150, 160, 180}, {{GREEN}, {GREEN}, {GREEN}}},
};

/* One triangle; a hexagon of six; a rectangle of two. */
static const struct text_scene_shape colored_triangles[] = {
    {{40, 380, 210}, {440, 440, 760}, {{RED}, {GREEN}, {BLUE}}},
    {{600, 770, 685}, {590, 590, 737}, {{WHITE}, {RED}, {YELLOW}}},
    {{600, 685, 515}, {590, 737, 737}, {{WHITE}, {YELLOW}, {GREEN}}},
    {{600, 515, 430}, {590, 737, 590}, {{WHITE}, {GREEN}, {CYAN}}},
    {{600, 430, 515}, {590, 590, 443}, {{WHITE}, {CYAN}, {BLUE}}},
    {{600, 515, 685}, {590, 443, 443}, {{WHITE}, {BLUE}, {MAGENTA}}},
    {{600, 685, 770}, {590, 443, 590}, {{WHITE}, {MAGENTA}, {RED}}},
    {{40, 760, 760}, {40, 40, 380}, {{BLUE}, {GREEN}, {YELLOW}}},
    {{40, 760, 40}, {40, 380, 380}, {{BLUE}, {YELLOW}, {RED}}},
};

static bool draw_triangle(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    draw_shapes(drawing, image, three_triangles,
                sizeof three_triangles / sizeof three_triangles[0]);
    return true;
}

static bool draw_gradient(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    draw_shapes(drawing, image, colored_triangles,
                sizeof colored_triangles / sizeof colored_triangles[0]);
    return true;
}

static bool draw_text(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    draw_shapes(drawing, image, drawing->text->shapes, drawing->text->shape_count);
    return true;
}

/* ---- Scene: outline ---- */

/* The line of lessons 1 and 2. Returns the number of pixels written. */
static uint64_t draw_line(struct image *image, struct pixel a, struct pixel b, struct color color) {
    struct line_walk walk;
    uint64_t written = 0;
    bool more = line_begin(&walk, a, b, image->width, image->height);
    for (; more; more = line_next(&walk)) {
        image_set(image, walk.x, walk.y, color);
        written++;
    }
    return written;
}

static bool draw_outline(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    size_t shape_count = sizeof three_triangles / sizeof three_triangles[0];
    for (size_t i = 0; i < shape_count; i++) {
        const struct text_scene_shape *shape = &three_triangles[i];
        for (int k = 0; k < 3; k++) {
            int next = (k + 1) % 3;
            struct pixel a = {(int)shape->x[k], (int)shape->y[k]};
            struct pixel b = {(int)shape->x[next], (int)shape->y[next]};
            count(drawing, "pixels_written", draw_line(image, a, b, shape->color[0]));
        }
    }
    count(drawing, "triangles", shape_count);
    return true;
}

/* ---- Scene: faces ---- */

/* A colour that looks random but depends on the number alone. The mixing of bits is the last step
 * of MurmurHash3 (Appleby, 2011). No channel is darker than 55. */
static struct color face_color(size_t face) {
    uint32_t h = (uint32_t)face + 1;
    h ^= h >> 16;
    h *= 0x85ebca6bU;
    h ^= h >> 13;
    h *= 0xc2b2ae35U;
    h ^= h >> 16;
    uint32_t r = h >> 16 & 255, g = h >> 8 & 255, b = h & 255;
    return color_rgb((uint8_t)(55 + r % 201), (uint8_t)(55 + g % 201), (uint8_t)(55 + b % 201));
}

/* Parallel view: x and y in -1..1 fill the image, z does not count. False for a corner too far off
 * the image to draw. */
static bool place_corner(const struct model *model, size_t face, size_t corner,
                         const struct image *image, struct vertex *vertex) {
    struct vec3 world = model_position(model, face, corner);
    struct vec2 screen = {(world.x + 1) * (double)image->width / 2,
                          (world.y + 1) * (double)image->height / 2};
    return screen_snap(screen, &vertex->position);
}

/* Seen from outside the corners of a face run counterclockwise. Where they run clockwise on the
 * screen we look at its back. */
static bool is_turned_away(const struct vertex v[3]) {
    struct fixed2 a = v[0].position, b = v[1].position, c = v[2].position;
    return ((int64_t)b.x - a.x) * ((int64_t)c.y - a.y) <
           ((int64_t)b.y - a.y) * ((int64_t)c.x - a.x);
}

static bool draw_faces(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct model *model = drawing->model;
    struct canvas canvas = {.image = image, .skip = drawing->skip};
    uint64_t off_limits = 0, turned_away = 0, without_pixel = 0;
    for (size_t face = 0; face < model->face_count; face++) {
        struct vertex v[3];
        if (!place_corner(model, face, 0, image, &v[0]) ||
            !place_corner(model, face, 1, image, &v[1]) ||
            !place_corner(model, face, 2, image, &v[2])) {
            off_limits++;
        } else if (is_turned_away(v)) {
            turned_away++;
        } else if (!triangle(&canvas, v, face_color(face))) {
            without_pixel++;
        }
    }
    count(drawing, "faces", model->face_count);
    count(drawing, "faces_off_limits", off_limits);
    count(drawing, "faces_turned_away", turned_away);
    count(drawing, "faces_without_pixel", without_pixel);
    count(drawing, "pixels_tested", canvas.pixels_tested);
    count(drawing, "pixels_written", canvas.pixels_written);
    return true;
}

/* ---- The program ---- */

int main(int argc, char **argv) {
    static const struct scene scenes[] = {
        {.name = "outline", .width = 200, .height = 200, .draw = draw_outline},
        {.name = "triangle", .width = 200, .height = 200, .draw = draw_triangle},
        {.name = "gradient", .width = 800, .height = 800, .draw = draw_gradient},
        {
            .name = "faces",
            .width = 800,
            .height = 800,
            .needs_model = true,
            .draw = draw_faces,
        },
    };
    static const struct program program = {
        .name = "step03_triangle",
        .summary = "filled triangles: exact edge functions, the top-left rule, spans",
        .text_kind = TEXT_SCENE_TRIANGLES,
        .text_scene = {.width = 200, .height = 200, .draw = draw_text},
        .scenes = scenes,
        .scene_count = sizeof scenes / sizeof scenes[0],
    };
    return program_main(&program, argc, argv);
}
