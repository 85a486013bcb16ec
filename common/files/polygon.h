/*
 * Cutting polygons into triangles: geometry alone, which knows nothing of files or models.
 *
 * A polygon is a list of corners in space, in order around it. Laid on the coordinate plane that it
 * is most nearly parallel to, it may be concave, touch itself and have holes that a cut leads to.
 * Which way three corners turn is decided exactly; for that, a coordinate nearer to 0 than 1e-120
 * counts as 0. The triangles go round as the polygon does and cover it exactly once; one that
 * crosses itself is cut somehow. Corners on one line, or in one place, are kept, so that n corners
 * always make n - 2 triangles.
 *
 *     struct polygon_cutter cutter = {0};
 *     if (polygon_cut(&cutter, corners, size) == POLYGON_CUT) {
 *         ...cutter.triangles[0] to cutter.triangles[size - 3]...
 *     }
 *     polygon_cutter_free(&cutter);
 */
#ifndef COMMON_POLYGON_H
#define COMMON_POLYGON_H

#include "geometry.h"

#include <stddef.h>
#include <stdint.h>

/* How many corners, and cells of the grid below, cutting may look at for each corner of a polygon
 * that is not convex. Caps, gears and coasts of 200,000 corners take less than a hundred; what
 * takes most is a wide arc before a far corner, which may have 30,000. */
enum { POLYGON_WORK_LIMIT = 1 << 13 };

enum polygon_result {
    POLYGON_CUT,
    POLYGON_TOO_INTRICATE, /* takes more than POLYGON_WORK_LIMIT */
    POLYGON_OUT_OF_MEMORY
};

struct polygon_node; /* a corner while the polygon is cut; see polygon.c */

/* The triangles, and working memory kept from one polygon to the next. All zero is ready for use.
 * A grid of cells over the polygon lists the corners where it is not convex: only these can lie in
 * the way of a cut. Its cells grow as corners become fewer. */
struct polygon_cutter {
    uint32_t (*triangles)[3]; /* of the last polygon: numbers of its corners, from 0 */
    size_t triangle_count;    /* 2 less than its corners */

    /* Private. */
    size_t triangle_capacity, node_capacity, cell_capacity, queue_capacity;
    struct polygon_node *nodes;
    uint32_t *cells; /* grid_size * grid_size: the first corner of each list */
    size_t grid_size;
    double left, bottom;     /* of the polygon on its plane */
    double width, height;    /* likewise */
    double x_scale, y_scale; /* cells per unit of length */
    uint32_t *queue;         /* corners of which it is not known whether they are ears */
    size_t queue_count;
};

/* Cut the polygon of `size` corners (3 or more, below UINT32_MAX), with coordinates of -1e120 to
 * 1e120. The triangles belong to the cutter and stay valid up to the next polygon. A convex polygon
 * becomes a fan around its first corner. One without area on its plane does, too; nothing of it is
 * seen. */
enum polygon_result polygon_cut(struct polygon_cutter *cutter, const struct vec3 *corners,
                                size_t size);

/* Free the memory and leave a cutter that can be used again. */
void polygon_cutter_free(struct polygon_cutter *cutter);

#endif
