/* The bust's surface as a fine grid over the texture: every (u, v) has its point and normal. */
#ifndef COMMON_SCULPTOR_SURFACE_H
#define COMMON_SCULPTOR_SURFACE_H

#include "sculptor/clay.h"

#include <stdbool.h>

/* A point of the surface, on the grid or between its points. */
struct surface_point {
    struct vec3 place, normal; /* the normal of length 1, outwards */
    double ear;                /* how far the ear sticks out here */
    double cavity;             /* -1..1: how deep the point lies among those around it */
};

/* Half of the surface, x >= 0: column 0 runs down the middle of the face (u = 1/2), the last one
 * down the back (u = 1, where the texture's seam is); row 0 is the middle of the base (v = 0), the
 * last row the crown (v = 1). All zero is a valid, empty surface. */
struct surface {
    int columns, rows;            /* steps; there is one more grid line than steps each way */
    struct surface_point *points; /* (rows + 1) * (columns + 1) */
};

enum { SURFACE_BASE_ROWS = 8 }; /* the first rows cover the flat base */

/* Sculpt; false when memory runs out. */
bool surface_create(struct surface *surface, int columns, int rows);
void surface_free(struct surface *surface);

static inline int surface_index(const struct surface *surface, int column, int row) {
    return row * (surface->columns + 1) + column;
}

static inline int surface_column(const struct surface *surface, int index) {
    return index % (surface->columns + 1);
}

static inline int surface_row(const struct surface *surface, int index) {
    return index / (surface->columns + 1);
}

/* Is it the middle of the base or the crown? */
static inline bool surface_is_pole(const struct surface *surface, int index) {
    return surface_row(surface, index) % surface->rows == 0;
}

/* Does it lie in the plane between the two halves? */
static inline bool surface_is_in_mirror(const struct surface *surface, int index) {
    return surface_column(surface, index) % surface->columns == 0 ||
           surface_is_pole(surface, index);
}

/* At (u, v) in 0..1, on either half. */
struct surface_point surface_at(const struct surface *surface, double u, double v);

#endif
