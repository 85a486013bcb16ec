/*
 * Lines and triangles, with whole numbers only: see raster.h.
 *
 * A line knows at which step it enters the image and at which it leaves, so no step outside is
 * taken. A triangle is three edge functions, exact in 64 bits; in each row they give one span of
 * covered pixels, so no pixel outside is tested.
 */
#include "raster.h"

#include <assert.h>
#include <stdlib.h>

/* ---- Parts of an image ---- */

struct rectangle grid_cell(size_t width, size_t height, int columns, int rows, int cell) {
    int w = (int)width, h = (int)height, column = cell % columns, row = cell / columns;
    int left = w * column / columns, right = w * (column + 1) / columns;
    int bottom = h * (rows - 1 - row) / rows, top = h * (rows - row) / rows;
    return (struct rectangle){left, bottom, right - left, top - bottom};
}

/* ---- Lines (taught in step02_wireframe) ---- */

static bool within_line_limit(struct pixel p) {
    return p.x >= -LINE_LIMIT && p.x <= LINE_LIMIT && p.y >= -LINE_LIMIT && p.y <= LINE_LIMIT;
}

/* Let u be the axis along which the line is longer, and v the other one. After k steps in u the
 * line has moved in v by k * rise / run, rounded, halves down:
 *     floor((2 * k * rise + run - 1) / (2 * run)).
 * Solving this for k gives the steps that are in the image. */
bool line_begin(struct line_walk *walk, struct pixel a, struct pixel b, size_t width,
                size_t height) {
    assert(within_line_limit(a) && within_line_limit(b));
    assert(width <= DRAW_LIMIT && height <= DRAW_LIMIT);
    int64_t x_distance = (int64_t)b.x - a.x, y_distance = (int64_t)b.y - a.y;
    bool steep = llabs(y_distance) > llabs(x_distance);
    if (steep ? y_distance < 0 : x_distance < 0) {
        struct pixel kept = a;
        a = b;
        b = kept;
    }
    int64_t u = steep ? a.y : a.x, v = steep ? a.x : a.y;
    int64_t run = (steep ? b.y : b.x) - u;
    int64_t v_distance = (steep ? b.x : b.y) - v;
    int64_t rise = llabs(v_distance);
    int64_t u_size = (int64_t)(steep ? height : width), v_size = (int64_t)(steep ? width : height);

    /* Steps at which u is in the image, and the moves in v that lead into it. */
    int64_t first = u < 0 ? -u : 0;
    int64_t last = u + run < u_size ? run : u_size - 1 - u;
    int64_t least_move = v_distance >= 0 ? -v : v - (v_size - 1);
    int64_t most_move = v_distance >= 0 ? v_size - 1 - v : v;
    if (most_move < 0 || least_move > rise) {
        return false;
    }
    if (least_move > 0) {
        int64_t enters = ceil_divide(2 * run * least_move - run + 1, 2 * rise);
        first = enters > first ? enters : first;
    }
    if (most_move < rise) {
        int64_t leaves = floor_divide(2 * run * (most_move + 1) - run, 2 * rise);
        last = leaves < last ? leaves : last;
    }
    if (first > last) {
        return false;
    }
    int64_t divisor = run > 0 ? 2 * run : 1;
    int64_t moved = run > 0 ? 2 * first * rise + run - 1 : 0;
    int minor_step = v_distance < 0 ? -1 : 1;
    int major = (int)(u + first), minor = (int)(v + minor_step * (moved / divisor));
    *walk = (struct line_walk){
        .x = steep ? minor : major,
        .y = steep ? major : minor,
        .steep = steep,
        .minor_step = minor_step,
        .left = (size_t)(last - first),
        .remainder = moved % divisor,
        .rise = 2 * rise,
        .divisor = divisor,
    };
    return true;
}

/* ---- Triangles (taught in step03_triangle) ---- */

/* The edge from p to q, with the triangle to its left when `sign` is 1 and to its right when -1. */
static struct edge make_edge(struct fixed2 p, struct fixed2 q, int sign) {
    int64_t x_distance = sign * ((int64_t)q.x - p.x), y_distance = sign * ((int64_t)q.y - p.y);
    const int64_t center = SUBPIXELS / 2;
    bool top_left = IS_TOP_LEFT(x_distance, y_distance);
    return (struct edge){
        .origin = x_distance * (center - p.y) - y_distance * (center - p.x),
        .dx = -y_distance * SUBPIXELS,
        .dy = x_distance * SUBPIXELS,
        .least = top_left ? 0 : 1,
    };
}

bool edges_setup(struct edges *edges, struct fixed2 a, struct fixed2 b, struct fixed2 c,
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

struct span edges_span(const struct edges *edges, int y) {
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

/* ---- Depth ---- */

void depth_clear(double *depth, size_t pixel_count) {
    for (size_t i = 0; i < pixel_count; i++) {
        depth[i] = -INFINITY;
    }
}
