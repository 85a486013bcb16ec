/*
 * The pixels of a triangle, and the weights of its corners. You write this in lesson 3; it is given
 * from lesson 4 on. The fill rule is in raster.c, make_edge().
 */
#ifndef COMMON_GIVEN_TRIANGLES_H
#define COMMON_GIVEN_TRIANGLES_H

#ifndef COMMON_RASTER_H
#error "include raster.h instead"
#endif

#include "given/later.h"

/* ---- Triangles (taught in step03_triangle) ---- */

/* Set up a triangle on an image of at most DRAW_LIMIT pixels a side. False when it certainly covers
 * no pixel: no area, off the image, or too small to reach a pixel centre.
 *
 * A pixel is covered when its centre is inside; a centre exactly on an edge belongs to the triangle
 * whose left or top edge this is. So triangles that share an edge neither overlap nor leave a gap,
 * and the order of the corners does not matter. (The top-left rule: Microsoft, "Direct3D 11
 * Functional Specification".) */
bool edges_setup(struct edges *edges, struct fixed2 a, struct fixed2 b, struct fixed2 c,
                 size_t width, size_t height);

/* The covered pixels of row y (y_begin <= y < y_end), found with one exact division per edge. */
struct span edges_span(const struct edges *edges, int y);

/* The weights of corners a, b and c at the centre of a pixel: their sum is 1 (except for rounding),
 * and inside the triangle none is negative. Each is the exact edge value divided by the area, so
 * nothing drifts along a row. */
static inline struct vec3 edges_weights(const struct edges *edges, int x, int y) {
    const struct edge *e = edges->edge;
    double scale = 1 / (double)edges->area;
    return (struct vec3){(double)(e[0].origin + e[0].dx * x + e[0].dy * y) * scale,
                         (double)(e[1].origin + e[1].dx * x + e[1].dy * y) * scale,
                         (double)(e[2].origin + e[2].dx * x + e[2].dy * y) * scale};
}

#if COURSE_LESSON <= 3
#define edges_setup   GIVEN_LATER(edges_setup, lesson 3, 4)
#define edges_span    GIVEN_LATER(edges_span, lesson 3, 4)
#define edges_weights GIVEN_LATER(edges_weights, lesson 3, 4)
#endif /* COURSE_LESSON */

#endif
