/*
 * Fewer triangles, put where the shape needs them.
 *
 * After Garland and Heckbert, "Surface Simplification Using Quadric Error Metrics", SIGGRAPH 1997.
 */
#ifndef COMMON_SCULPTOR_SIMPLIFY_H
#define COMMON_SCULPTOR_SIMPLIFY_H

#include "sculptor/surface.h"

#include <stddef.h>

/* A triangle of grid points (surface_index()), counterclockwise seen from outside. All points of
 * row 0 are one point, the one in column 0; so are those of the last row. */
struct grid_triangle {
    int corner[3];
};

/* Cover the surface (its half, x >= 0) with about `target` triangles. The edge in the mirror stays
 * in the mirror; no triangle is folded or empty, on the body or in the texture. `*triangles` is the
 * caller's to free. False when memory runs out. */
bool simplify(const struct surface *surface, size_t target, struct grid_triangle **triangles,
              size_t *count);

#endif
