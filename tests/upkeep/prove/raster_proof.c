/*
 * What `make prove` shows of raster.c, for every input there is: see prove.sh. Frama-C's Eva takes
 * each number below as an interval, and each `assert` as what must hold for all of it.
 */
#include "__fc_builtin.h"

#include <math.h>

/* Eva's own fabs() tells nothing of its argument. */
#define fabs(x) ((x) < 0 ? -(x) : (x))
#include "raster.c"

static size_t any_size(void) {
    return (size_t)Frama_C_interval(0, DRAW_LIMIT);
}

static int any_pixel(void) {
    return Frama_C_interval(0, DRAW_LIMIT - 1);
}

/* A corner that lies at most that far from (0,0), in 1/256 pixel. */
static struct fixed2 any_corner(int limit) {
    return (struct fixed2){Frama_C_interval(-limit, limit), Frama_C_interval(-limit, limit)};
}

/* Any triangle that screen_snap() can give, in any image, at any row and any pixel. */
void prove_triangles(void) {
    const int limit = SCREEN_LIMIT * SUBPIXELS;
    const struct fixed2 a = any_corner(limit), b = any_corner(limit), c = any_corner(limit);
    const size_t width = any_size(), height = any_size();
    struct edges edges = {0};
    if (edges_setup(&edges, a, b, c, width, height)) {
        //@ assert 0 <= edges.y_begin && edges.y_end <= DRAW_LIMIT;
        const struct span span = edges_span(&edges, any_pixel());
        //@ assert 0 <= span.begin <= DRAW_LIMIT && 0 <= span.end <= DRAW_LIMIT;
        edges_cover(&edges, any_pixel(), any_pixel());
    }
}

/* Inside the pipeline's guard band, 2^16 pixels from the middle of an image, a double holds every
 * value of an edge function, and of the sums on the way to it. */
void prove_guard_band(void) {
    const int limit = ((1 << 16) + DRAW_LIMIT) * SUBPIXELS;
    const struct fixed2 p = any_corner(limit), q = any_corner(limit);
    const struct edge e = make_edge(p, q, Frama_C_interval(0, 1) ? 1 : -1);
    const int64_t along = e.dx * any_pixel(), up = e.dy * any_pixel();
    //@ assert -(1LL << 53) <= e.origin <= 1LL << 53;
    //@ assert -(1LL << 53) <= e.origin + along + up <= 1LL << 53;
}

static struct pixel any_end(void) {
    return (struct pixel){Frama_C_interval(-LINE_LIMIT, LINE_LIMIT),
                          Frama_C_interval(-LINE_LIMIT, LINE_LIMIT)};
}

/* Any line, in any image. */
void prove_lines(void) {
    struct line_walk walk = {0};
    const struct pixel a = any_end(), b = any_end();
    if (line_begin(&walk, a, b, any_size(), any_size())) {
        //@ assert walk.left < DRAW_LIMIT;
        //@ assert 0 <= walk.remainder && 0 < walk.divisor;
        walk.x = any_pixel(); /* `make stress` shows that it begins in the image */
        walk.y = any_pixel();
        line_next(&walk);
    }
}

void prove_numbers(void) {
    const int limit = SCREEN_LIMIT * SUBPIXELS;
    const struct span centers = centers_between(Frama_C_interval(-limit, limit),
                                                Frama_C_interval(-limit, limit), any_size());
    //@ assert 0 <= centers.begin && centers.end <= DRAW_LIMIT;
    struct fixed2 snapped = {0, 0};
    screen_snap((struct vec2){Frama_C_double_interval(-1e308, 1e308),
                              Frama_C_double_interval(-1e308, 1e308)},
                &snapped);
    //@ assert -(1 << 29) <= snapped.x <= 1 << 29 && -(1 << 29) <= snapped.y <= 1 << 29;
    grid_cell(any_size(), any_size(), 3, 3, Frama_C_interval(0, 8));
}
