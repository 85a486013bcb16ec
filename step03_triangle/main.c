/*
 * Lesson 3: filled triangles.
 *
 * A point is in a triangle when it is on the inner side of all three edges. Part a asks this of
 * every pixel around the triangle, in floating point. Part b does it exactly: it snaps the corners
 * to 1/256 pixel once, and from there on whole numbers decide, so that exactly one of the triangles
 * that share an edge draws a pixel on it. Part c mixes the colours of the corners.
 */
#include "program.h"

#include <assert.h>

/* ==== Part a: three signs ==== */

/* The line of lessons 1 and 2. Returns the number of pixels written. */
static uint64_t draw_line(struct image *image, struct pixel a, struct pixel b, struct color color) {
    uint64_t written = 0;
    /* BEGIN SOLUTION 3a.1 outline */
    struct line_walk walk;
    bool more = line_begin(&walk, a, b, image->width, image->height);
    for (; more; more = line_next(&walk)) {
        image_set(image, walk.x, walk.y, color);
        written++;
    }
    /* STARTER
    (void)image, (void)a, (void)b, (void)color; // to do 3a.1: line_begin(), line_next()
    END SOLUTION */
    return written;
}

/* On which side of the line from p to q is the point? More than 0: on the left; less than 0: on the
 * right; 0: on the line. The value is twice the area of the triangle p, q, point. */
static double side_of(struct vec2 p, struct vec2 q, struct vec2 point) {
    /* BEGIN SOLUTION 3a.2 which side */
    return (q.x - p.x) * (point.y - p.y) - (q.y - p.y) * (point.x - p.x);
    /* STARTER
    (void)p, (void)q, (void)point;
    return 0; // to do 3a.2: the z of a cross product: (q - p) x (point - p)
    END SOLUTION */
}

/* The pixels of a row or column that two positions enclose, cut to 0..size. Given. */
static struct span pixels_between(double least, double most, size_t size) {
    return (struct span){(int)fmax(floor(least), 0), (int)fmin(floor(most) + 1, (double)size)};
}

/* A triangle by three signs, asked at every pixel of the box around it. Returns the number of
 * pixels written. Part b writes a better one, triangle(). */
static uint64_t box_triangle(struct image *image, const struct vec2 corner[3], struct color color) {
    struct vec2 a = corner[0], b = corner[1], c = corner[2];
    struct span columns =
        pixels_between(fmin(a.x, fmin(b.x, c.x)), fmax(a.x, fmax(b.x, c.x)), image->width);
    struct span rows =
        pixels_between(fmin(a.y, fmin(b.y, c.y)), fmax(a.y, fmax(b.y, c.y)), image->height);
    uint64_t written = 0;
    /* BEGIN SOLUTION 3a.3 three signs */
    double twice_area = side_of(a, b, c);
    if (twice_area == 0) {
        return 0; /* a line or a point */
    }
    /* Clockwise, the inside is on the right of every edge. */
    double sign = twice_area > 0 ? 1 : -1;
    for (int y = rows.begin; y < rows.end; y++) {
        for (int x = columns.begin; x < columns.end; x++) {
            struct vec2 center = {x + 0.5, y + 0.5};
            if (sign * side_of(b, c, center) >= 0 && sign * side_of(c, a, center) >= 0 &&
                sign * side_of(a, b, center) >= 0) {
                image_set(image, x, y, color);
                written++;
            }
        }
    }
    /* STARTER
    (void)rows, (void)columns, (void)color;
    // to do 3a.3: image_set() where the pixel's centre is on the inner side of all three edges
    END SOLUTION */
    return written;
}

/* Seen from outside, the corners of a face are counterclockwise. Where they are clockwise on the
 * screen, we look at its back. */
static bool is_turned_away(const struct vec2 corner[3]) {
    /* BEGIN SOLUTION 3a.4 turned away */
    return side_of(corner[0], corner[1], corner[2]) < 0;
    /* STARTER
    (void)corner, (void)side_of;
    return false; // to do 3a.4: true for a face that shows its back
    END SOLUTION */
}

/* ==== Part b: exact, and one span a row ==== */

/* The edge from p to q, with the triangle to its left when `sign` is 1 and to its right when -1. */
static struct edge make_edge(struct fixed2 p, struct fixed2 q, int sign) {
    /* BEGIN SOLUTION 3b.1 edge function */
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
    /* STARTER
    (void)p, (void)q, (void)sign; // to do 3b.1: origin, dx, dy, and least by the top-left rule
    return (struct edge){.origin = 0};
    END SOLUTION */
}

/* False when the triangle certainly covers no pixel. */
static bool triangle_setup(struct edges *edges, struct fixed2 a, struct fixed2 b, struct fixed2 c,
                           size_t width, size_t height) {
    assert(width <= DRAW_LIMIT && height <= DRAW_LIMIT);
    struct span columns = centers_between(least_of(a.x, b.x, c.x), most_of(a.x, b.x, c.x), width);
    struct span rows = centers_between(least_of(a.y, b.y, c.y), most_of(a.y, b.y, c.y), height);
    if (columns.begin >= columns.end || rows.begin >= rows.end) {
        return false;
    }
    /* BEGIN SOLUTION 3b.2 setup */
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
    /* STARTER
    // to do 3b.2: the area and its sign (no area: false), then all fields and all three edges
    *edges = (struct edges){.edge = {make_edge(b, c, 1)}, .width = (int)width};
    return false;
    END SOLUTION */
}

/* The covered pixels of row y: solve dx * x + (value at x = 0) >= least for x, edge by edge. */
static struct span triangle_span(const struct edges *edges, int y) {
    struct span span = {0, edges->width};
    /* BEGIN SOLUTION 3b.3 span */
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
    /* STARTER
    (void)y; // to do 3b.3: let each edge narrow the span; ceil_divide() and floor_divide() help
    END SOLUTION */
    return span;
}

/* A triangle of one colour. Returns the number of pixels written. */
static uint64_t triangle(struct image *image, const struct fixed2 corner[3], struct color color) {
    uint64_t written = 0;
    /* BEGIN SOLUTION 3b.4 triangle */
    struct edges edges;
    if (!triangle_setup(&edges, corner[0], corner[1], corner[2], image->width, image->height)) {
        return 0;
    }
    for (int y = edges.y_begin; y < edges.y_end; y++) {
        struct span span = triangle_span(&edges, y);
        image_fill_row(image, y, span.begin, span.end, color);
        written += (uint64_t)(span.end - span.begin);
    }
    /* STARTER
    (void)image, (void)corner, (void)color, (void)triangle_span;
    // to do 3b.4: triangle_setup(), then triangle_span() and image_fill_row() for each of its rows
    END SOLUTION */
    return written;
}

/* ==== Part c: colours ==== */

/* The weights of the corners at the centre of a pixel: barycentric coordinates. */
static struct vec3 triangle_weights(const struct edges *edges, int x, int y) {
    /* BEGIN SOLUTION 3c.1 weights */
    const struct edge *e = edges->edge;
    double scale = 1 / (double)edges->area;
    return (struct vec3){(double)(e[0].origin + e[0].dx * x + e[0].dy * y) * scale,
                         (double)(e[1].origin + e[1].dx * x + e[1].dy * y) * scale,
                         (double)(e[2].origin + e[2].dx * x + e[2].dy * y) * scale};
    /* STARTER
    (void)edges, (void)x, (void)y; // to do 3c.1: each corner's share of the area
    return (struct vec3){0, 0, 0};
    END SOLUTION */
}

/* A mixture of three colours, each with its weight. */
static struct color mix_colors(struct vec3 weight, const struct color color[3]) {
    /* BEGIN SOLUTION 3c.2 mixed colours */
    const struct color a = color[0], b = color[1], c = color[2];
    return color_rgb(level_from(interpolate(weight, a.r, b.r, c.r)),
                     level_from(interpolate(weight, a.g, b.g, c.g)),
                     level_from(interpolate(weight, a.b, b.b, c.b)));
    /* STARTER
    (void)weight, (void)color; // to do 3c.2: interpolate() each channel, level_from() rounds it
    return color_grey(0);
    END SOLUTION */
}

/* A triangle with a colour at each corner. Returns the number of pixels written. */
static uint64_t gradient_triangle(struct image *image, const struct fixed2 corner[3],
                                  const struct color color[3]) {
    uint64_t written = 0;
    /* BEGIN SOLUTION 3c.3 gradient */
    struct edges edges;
    if (!triangle_setup(&edges, corner[0], corner[1], corner[2], image->width, image->height)) {
        return 0;
    }
    for (int y = edges.y_begin; y < edges.y_end; y++) {
        struct span span = triangle_span(&edges, y);
        for (int x = span.begin; x < span.end; x++) {
            image_set(image, x, y, mix_colors(triangle_weights(&edges, x, y), color));
        }
        written += (uint64_t)(span.end - span.begin);
    }
    /* STARTER
    (void)image, (void)corner, (void)color, (void)triangle_weights, (void)mix_colors;
    // to do 3c.3: as triangle(), but pixel by pixel
    END SOLUTION */
    return written;
}

#include "scenes.h"

int main(int argc, char **argv) {
    return program_main(&step03_triangle, argc, argv);
}
