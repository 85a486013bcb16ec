/*
 * The pixels of a triangle, and the weights of its corners. You write this in lesson 3; it is given
 * from lesson 4 on. The fill rule is IS_TOP_LEFT(): raster.c asks it of one edge, the pipeline of
 * several at once.
 */
#ifndef COMMON_GIVEN_TRIANGLES_H
#define COMMON_GIVEN_TRIANGLES_H

#ifndef COMMON_RASTER_H
#error "include raster.h instead"
#endif

#include "given/later.h"

/* ---- Triangles (taught in step03_triangle) ---- */

/* The top-left rule: does a centre exactly on this edge belong to the triangle? Seen
 * counterclockwise with y up, a left edge goes down and a top edge goes left. Of two triangles that
 * share an edge, exactly one gets the centres on it. The distances lead from the edge's beginning
 * to its end; they are numbers or, element by element, vectors of numbers. (Microsoft, "Direct3D
 * 11 Functional Specification".) */
#define IS_TOP_LEFT(x_distance, y_distance)                                                        \
    (((y_distance) < 0) | (((y_distance) == 0) & ((x_distance) < 0)))

/* Set up a triangle on an image of at most DRAW_LIMIT pixels a side. False when it certainly covers
 * no pixel: no area, off the image, or too small to reach a pixel centre.
 *
 * A pixel is covered when its centre is inside, or exactly on a left or top edge. So triangles that
 * share an edge neither overlap nor leave a gap, and the order of the corners does not matter. */
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
#undef IS_TOP_LEFT
#define edges_setup   GIVEN_LATER(edges_setup, lesson 3, 4)
#define edges_span    GIVEN_LATER(edges_span, lesson 3, 4)
#define edges_weights GIVEN_LATER(edges_weights, lesson 3, 4)
#endif /* COURSE_LESSON */

#endif
