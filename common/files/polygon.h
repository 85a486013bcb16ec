/*
 * Cutting polygons into triangles: geometry alone, which knows nothing of files or models.
 *
 * A polygon is a list of corners in space, in order around it. Laid on the coordinate plane that it
 * is most nearly parallel to, it may be concave, touch itself and have holes that a cut leads to.
 * What is finer than a billionth of its extent counts for nothing. The triangles go round as the
 * polygon does and cover it exactly once; one that crosses itself is cut somehow. Corners on one
 * line, or in one place, are kept, so that n corners always make n - 2 triangles.
 *
 *     struct polygon_cutter cutter = {0};
 *     if (polygon_cut(&cutter, corners, size) == POLYGON_CUT) {
 *         ...cutter.triangles[0] to cutter.triangles[size - 3]...
 *     }
 *     polygon_cutter_free(&cutter);
 */
#ifndef COMMON_FILES_POLYGON_H
#define COMMON_FILES_POLYGON_H

#include "geometry.h"

#include <stddef.h>
#include <stdint.h>

/* The most corners of a polygon that is no fan (see below), since the time that cutting takes grows
 * with their square. Programs write some hundreds. */
enum { POLYGON_CORNER_LIMIT = 20000 };

enum polygon_result { POLYGON_CUT, POLYGON_TOO_LARGE, POLYGON_OUT_OF_MEMORY };

struct polygon_node; /* a corner while the polygon is cut; see polygon.c */

/* The triangles, and memory kept from one polygon to the next. All zero is ready for use. */
struct polygon_cutter {
    uint32_t (*triangles)[3]; /* of the last polygon: numbers of its corners, from 0 */
    size_t triangle_count;    /* 2 less than its corners */

    /* Private. */
    size_t triangle_capacity, node_capacity, dent_capacity;
    struct polygon_node *nodes;
    uint32_t *dents; /* corners where the polygon is not convex, and some where it was not */
    size_t dent_count;
};

/* Cut the polygon of `size` corners (3 or more, below UINT32_MAX), with coordinates of -1e120 to
 * 1e120. The triangles belong to the cutter and stay valid up to the next polygon. A polygon that
 * its first corner sees all of, as every convex one, becomes a fan around it; where rounded corners
 * leave a dent, what the fan covers too much is less than a billionth of its area. */
enum polygon_result polygon_cut(struct polygon_cutter *cutter, const struct vec3 *corners,
                                size_t size);

/* Free the memory and leave a cutter that can be used again. */
void polygon_cutter_free(struct polygon_cutter *cutter);

#endif
