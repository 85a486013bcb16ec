/* Polygons cut into triangles by their ears; see polygon.h. */
#include "files/polygon.h"

#include "base/array.h"
#include "geometry.h"

#include <assert.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

/* A corner on the plane. Others are given by number. */
struct polygon_node {
    int64_t x, y;            /* 0..2^GRID_BITS */
    int64_t turn;            /* orientation here: positive where the polygon is convex */
    uint32_t previous, next; /* around the polygon */
    bool waiting;            /* it is not known whether it is an ear */
    bool is_listed;          /* among the cutter's dents */
};

/* ---- On the plane ---- */

/* So many that orientation() is exact in 64 bits. */
enum { GRID_BITS = 30 };

/* Positive when a, b, c turn left, negative when they turn right, 0 when they lie on a line. */
static int64_t orientation(const struct polygon_node *a, const struct polygon_node *b,
                           const struct polygon_node *c) {
    return (b->x - a->x) * (c->y - a->y) - (b->y - a->y) * (c->x - a->x);
}

static bool same_place(const struct polygon_node *a, const struct polygon_node *b) {
    return a->x == b->x && a->y == b->y;
}

/* Twice the polygon's area vector, relative to its first corner so that a place far from the origin
 * costs no accuracy (Newell's formula: Sutherland, Sproull and Schumacker, "A Characterization of
 * Ten Hidden-Surface Algorithms", 1974, attributed to M. Newell). */
static struct vec3 polygon_normal(const struct vec3 *corners, size_t size) {
    struct vec3 normal = {0, 0, 0};
    struct vec3 previous = {0, 0, 0};
    for (size_t i = 1; i < size; i++) {
        struct vec3 current = vec3_sub(corners[i], corners[0]);
        normal = vec3_add(normal, vec3_cross(previous, current));
        previous = current;
    }
    return normal;
}

/* The coordinate plane that a polygon is most nearly parallel to: it is seen from the side from
 * which it goes round counterclockwise. */
struct plane {
    int across, up; /* 0, 1, 2 for x, y, z */
};

static struct plane plane_facing(struct vec3 normal) {
    double x = fabs(normal.x), y = fabs(normal.y), z = fabs(normal.z);
    int drop = x > y && x > z ? 0 : (y > z ? 1 : 2);
    double facing = drop == 0 ? normal.x : (drop == 1 ? normal.y : normal.z);
    int first = (drop + 1) % 3, second = (drop + 2) % 3;
    return facing > 0 ? (struct plane){first, second} : (struct plane){second, first};
}

static double coordinate(struct vec3 corner, int axis) {
    return axis == 0 ? corner.x : (axis == 1 ? corner.y : corner.z);
}

/* From the lower left of a rectangle around them, scaled by a power of two. */
static void lay_on_plane(struct polygon_node *nodes, const struct vec3 *corners, size_t size) {
    struct plane plane = plane_facing(polygon_normal(corners, size));
    double left = coordinate(corners[0], plane.across), right = left;
    double bottom = coordinate(corners[0], plane.up), top = bottom;
    for (size_t i = 1; i < size; i++) {
        double x = coordinate(corners[i], plane.across), y = coordinate(corners[i], plane.up);
        left = x < left ? x : left;
        right = x > right ? x : right;
        bottom = y < bottom ? y : bottom;
        top = y > top ? y : top;
    }
    int exponent;
    frexp(fmax(fmax(right - left, top - bottom), 1e-200), &exponent);
    double scale = ldexp(1, GRID_BITS - exponent);
    for (size_t i = 0; i < size; i++) {
        nodes[i].x = (int64_t)((coordinate(corners[i], plane.across) - left) * scale);
        nodes[i].y = (int64_t)((coordinate(corners[i], plane.up) - bottom) * scale);
    }
}

/* ---- Cutting off ears ----
 *
 * An ear is a convex corner whose triangle with its two neighbours holds no other corner; it can be
 * cut off, which leaves a polygon with one corner less (Meisters, "Polygons have ears", 1975). Only
 * corners that are not convex need to be tested, and cutting an ear off changes only what is known
 * of its two neighbours (O'Rourke, "Computational Geometry in C", second edition, section 1.6). So
 * each cut makes at most two new tests. */

/* Does the polygon, where it comes back to the place of the corner `tip`, pass inside the corner's
 * angle? (A hole can touch the outline there.) */
static bool passes_inside(const struct polygon_node *nodes, const struct polygon_node *tip,
                          const struct polygon_node *other) {
    const struct polygon_node *previous = &nodes[tip->previous], *next = &nodes[tip->next];
    const struct polygon_node *ends[2] = {&nodes[other->previous], &nodes[other->next]};
    for (int i = 0; i < 2; i++) {
        if (orientation(previous, tip, ends[i]) > 0 && orientation(tip, next, ends[i]) > 0) {
            return true;
        }
    }
    return false;
}

/* Does the corner `other`, which is not convex and on the triangle of `tip`, leave it an ear? */
static bool leaves_ear(const struct polygon_node *nodes, const struct polygon_node *tip,
                       const struct polygon_node *other) {
    return same_place(other, &nodes[tip->previous]) || same_place(other, &nodes[tip->next]) ||
           (same_place(other, tip) && !passes_inside(nodes, tip, other));
}

/* A spike, where the polygon turns straight back, or a doubled point: it can always be cut off. */
static bool is_spike(const struct polygon_node *nodes, uint32_t index) {
    const struct polygon_node *tip = &nodes[index];
    const struct polygon_node *a = &nodes[tip->previous], *b = &nodes[tip->next];
    return tip->turn == 0 &&
           (a->x - tip->x) * (b->x - tip->x) + (a->y - tip->y) * (b->y - tip->y) >= 0;
}

static bool is_ear(const struct polygon_cutter *cutter, uint32_t index) {
    const struct polygon_node *nodes = cutter->nodes, *b = &nodes[index];
    const struct polygon_node *a = &nodes[b->previous], *c = &nodes[b->next];
    if (b->turn <= 0) { /* a point of a straight side stays */
        return is_spike(nodes, index);
    }
    for (size_t i = 0; i < cutter->dent_count; i++) {
        const struct polygon_node *p = &nodes[cutter->dents[i]];
        if (p->turn <= 0 && orientation(a, b, p) >= 0 && orientation(b, c, p) >= 0 &&
            orientation(c, a, p) >= 0 && !leaves_ear(nodes, b, p)) {
            return false;
        }
    }
    return true;
}

/* After its neighbours changed. (Where two corners are in one place, a convex one can become a
 * dent.) */
static void update_corner(struct polygon_cutter *cutter, uint32_t index) {
    struct polygon_node *node = &cutter->nodes[index];
    node->turn = orientation(&cutter->nodes[node->previous], node, &cutter->nodes[node->next]);
    node->waiting = true;
    if (node->turn <= 0 && !node->is_listed) {
        node->is_listed = true;
        cutter->dents[cutter->dent_count++] = index;
    }
}

/* Link the corners to a ring. */
static void begin_ring(struct polygon_cutter *cutter, uint32_t size) {
    cutter->dent_count = 0;
    for (uint32_t i = 0; i < size; i++) {
        struct polygon_node *node = &cutter->nodes[i];
        node->previous = i == 0 ? size - 1 : i - 1;
        node->next = i + 1 == size ? 0 : i + 1;
        node->is_listed = false;
        update_corner(cutter, i);
    }
}

/* Add a triangle of three of the polygon's corners; there is room. */
static void add_triangle(struct polygon_cutter *cutter, uint32_t a, uint32_t b, uint32_t c) {
    uint32_t *triangle = cutter->triangles[cutter->triangle_count++];
    triangle[0] = a;
    triangle[1] = b;
    triangle[2] = c;
}

/* Cut the corner off with a triangle: its neighbours become neighbours. */
static void cut_off(struct polygon_cutter *cutter, uint32_t index) {
    struct polygon_node *tip = &cutter->nodes[index];
    add_triangle(cutter, tip->previous, index, tip->next);
    tip->turn = 1; /* in nobody's way */
    cutter->nodes[tip->previous].next = tip->next;
    cutter->nodes[tip->next].previous = tip->previous;
    update_corner(cutter, tip->previous);
    update_corner(cutter, tip->next);
}

/* Cut the ear off, and at once whatever that turns into spikes, up to `cuts` triangles in all.
 * Returns a corner that is still there. */
static uint32_t cut_ear(struct polygon_cutter *cutter, uint32_t index, size_t cuts) {
    uint32_t place;
    do {
        place = cutter->nodes[index].next;
        cut_off(cutter, index);
        index = is_spike(cutter->nodes, place) ? place : cutter->nodes[place].previous;
    } while (cutter->triangle_count < cuts && is_spike(cutter->nodes, index));
    return place;
}

/* When no ear is left the polygon crosses itself: a corner that turns left, or else any corner,
 * found from `start` on, goes next, so that every polygon of n corners becomes n - 2 triangles. */
static uint32_t any_node(const struct polygon_node *nodes, uint32_t start) {
    uint32_t index = start;
    do {
        if (nodes[index].turn >= 0) {
            return index;
        }
        index = nodes[index].next;
    } while (index != start);
    return start;
}

/* Cut off ears round after round, never two neighbours in one, so that they stay small; first all
 * spikes, since without them less can be mistaken for an ear. */
static void cut_ears(struct polygon_cutter *cutter, size_t size) {
    const size_t cuts = size - 3; /* a last triangle is left */
    struct polygon_node *nodes = cutter->nodes;
    uint32_t index = 1;
    begin_ring(cutter, (uint32_t)size);
    for (size_t i = 0; i < size && cutter->triangle_count < cuts; i++) {
        index = is_spike(nodes, index) ? cut_ear(cutter, index, cuts) : nodes[index].next;
    }
    for (size_t idle = 0; cutter->triangle_count < cuts; index = nodes[index].next) {
        bool waiting = nodes[index].waiting, none_left = idle >= size - cutter->triangle_count;
        nodes[index].waiting = false;
        idle++;
        if (none_left || (waiting && is_ear(cutter, index))) {
            index = cut_ear(cutter, none_left ? any_node(nodes, index) : index, cuts);
            idle = 0;
        }
    }
    add_triangle(cutter, nodes[index].next, nodes[index].previous, index);
}

/* ---- Polygons ---- */

/* Does a fan around the first corner cover the polygon, and next to nothing else? */
static bool fan_is_right(const struct polygon_node *nodes, size_t size) {
    double turned_over = 0, sum = 0;
    for (size_t i = 2; i < size; i++) {
        double area = (double)orientation(&nodes[0], &nodes[i - 1], &nodes[i]);
        turned_over -= fmin(area, 0);
        sum += area;
    }
    return turned_over <= 1e-9 * sum;
}

static bool reserve(struct polygon_cutter *c, size_t size) {
    return array_extend(&c->triangles, &c->triangle_capacity, size - 2, sizeof *c->triangles) &&
           array_extend(&c->nodes, &c->node_capacity, size, sizeof *c->nodes) &&
           array_extend(&c->dents, &c->dent_capacity, size, sizeof *c->dents);
}

enum polygon_result polygon_cut(struct polygon_cutter *cutter, const struct vec3 *corners,
                                size_t size) {
    assert(size >= 3 && size < UINT32_MAX);
    cutter->triangle_count = 0;
    if (!reserve(cutter, size)) {
        return POLYGON_OUT_OF_MEMORY;
    }
    lay_on_plane(cutter->nodes, corners, size);
    if (fan_is_right(cutter->nodes, size)) {
        for (uint32_t i = 2; i < size; i++) {
            add_triangle(cutter, 0, i - 1, i);
        }
    } else if (size <= POLYGON_CORNER_LIMIT) {
        cut_ears(cutter, size);
    } else {
        return POLYGON_TOO_LARGE;
    }
    return POLYGON_CUT;
}

void polygon_cutter_free(struct polygon_cutter *cutter) {
    free(cutter->triangles);
    free(cutter->nodes);
    free(cutter->dents);
    *cutter = (struct polygon_cutter){0};
}
