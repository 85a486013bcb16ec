/* Polygons cut into triangles by their ears; see polygon.h. */
#include "files/polygon.h"

#include "base/array.h"
#include "geometry.h"

#include <assert.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#define NOTHING UINT32_MAX /* the end of a list */

/* A corner on the plane. Others are given by number. */
struct polygon_node {
    double x, y;             /* two of the corner's coordinates, not rounded */
    double turn;             /* orientation here: positive where the polygon is convex */
    uint32_t previous, next; /* around the polygon */
    uint32_t cell_next;      /* in the list of the same cell, or NOTHING */
    size_t queued;           /* its newest place in the queue */
    bool in_cell;            /* is in the list of its cell */
};

/* ---- Which way points turn ---- */

/* A sum or product of doubles without an error: rounded + rest. Exact as long as nothing over- or
 * underflows: numbers of 1e-120 to 1e120 in size, and 0. */
struct exact {
    double rounded, rest;
};

/* a + b (Knuth, "The Art of Computer Programming", volume 2, section 4.2.2, theorem B). */
static struct exact exact_sum(double a, double b) {
    double sum = a + b;
    double b_part = sum - a, a_part = sum - b_part;
    return (struct exact){sum, (a - a_part) + (b - b_part)};
}

/* a * b: fma() rounds only once, and what is left of the product takes no more bits than a double
 * has. */
static struct exact exact_product(double a, double b) {
    double product = a * b;
    return (struct exact){product, fma(a, b, -product)};
}

/* Six products, each of them the sum of two doubles. */
enum { TERMS = 12 };

/* The sign of a sum, exactly: the numbers are added to an expansion, a list of doubles whose sum is
 * exact (Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
 * Predicates", 1997, section 2.4). Its last component that is not 0 has the sign of the sum. */
static double exact_sign_of_sum(const double terms[TERMS]) {
    double expansion[TERMS];
    for (int count = 0; count < TERMS; count++) {
        double sum = terms[count];
        for (int i = 0; i < count; i++) {
            struct exact added = exact_sum(sum, expansion[i]);
            sum = added.rounded;
            expansion[i] = added.rest;
        }
        expansion[count] = sum;
    }
    int last = TERMS - 1;
    while (last > 0 && expansion[last] == 0) {
        last--;
    }
    return expansion[last];
}

/* The same as orientation(), without differences, which would be rounded. */
static double exact_orientation(const struct polygon_node *a, const struct polygon_node *b,
                                const struct polygon_node *c) {
    const struct exact products[TERMS / 2] = {
        exact_product(a->x, b->y),  exact_product(-a->y, b->x), exact_product(b->x, c->y),
        exact_product(-b->y, c->x), exact_product(c->x, a->y),  exact_product(-c->y, a->x),
    };
    double terms[TERMS];
    for (int i = 0; i < TERMS / 2; i++) {
        terms[2 * i] = products[i].rounded;
        terms[2 * i + 1] = products[i].rest;
    }
    return exact_sign_of_sum(terms);
}

/* Positive when a, b, c turn left, negative when they turn right, 0 when they lie on a line. Only
 * the sign counts. */
static double orientation(const struct polygon_node *a, const struct polygon_node *b,
                          const struct polygon_node *c) {
    double left = (b->x - a->x) * (c->y - a->y);
    double right = (b->y - a->y) * (c->x - a->x);
    if (left == 0 && right == 0) {
        return 0; /* on a line along x or y: no difference or product of them is rounded to 0 */
    }
    /* (3 + 16e)e with e = 2^-53, and some more. */
    double bound = 4e-16 * (fabs(left) + fabs(right));
    return fabs(left - right) > bound ? left - right : exact_orientation(a, b, c);
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
 * which it goes round counterclockwise. Dropping one coordinate keeps the other two exact, unlike a
 * rotation. */
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

/* A coordinate of the corner by its number. Very small ones become 0: then no product of two can be
 * so small that bits of it are lost. */
static double coordinate(struct vec3 corner, int axis) {
    double value = axis == 0 ? corner.x : (axis == 1 ? corner.y : corner.z);
    return fabs(value) < 1e-120 ? 0 : value;
}

static struct polygon_node node_on_plane(struct vec3 corner, struct plane plane) {
    return (struct polygon_node){.x = coordinate(corner, plane.across),
                                 .y = coordinate(corner, plane.up)};
}

/* Convex: it never turns right. One that turns straight back does not either; but there a triangle
 * of its fan, around `first`, is turned over. (A star that goes round several times may pass; but
 * no way of cutting one is right.) */
static bool is_convex(const struct vec3 *corners, size_t size, struct plane plane) {
    const struct polygon_node first = node_on_plane(corners[0], plane);
    struct polygon_node a = first, b = node_on_plane(corners[1], plane);
    for (size_t i = 2; i < size + 2; i++) {
        struct polygon_node c = node_on_plane(corners[i < size ? i : i - size], plane);
        if (orientation(&a, &b, &c) < 0 || orientation(&first, &b, &c) < 0) {
            return false;
        }
        a = b;
        b = c;
    }
    return true;
}

/* Is it right to cut the polygon as a fan? Where it has no area nothing will be seen of it. */
static bool fan_is_right(const struct vec3 *corners, size_t size, struct vec3 normal) {
    bool flat = normal.x == 0 && normal.y == 0 && normal.z == 0;
    return flat || is_convex(corners, size, plane_facing(normal));
}

/* ---- Cutting off ears ----
 *
 * An ear is a convex corner whose triangle with its two neighbours holds no other corner; it can be
 * cut off, which leaves a polygon with one corner less (Meisters, "Polygons have ears", 1975). Only
 * corners that are not convex need to be tested, and cutting an ear off changes only what is known
 * of its two neighbours (O'Rourke, "Computational Geometry in C", second edition, section 1.6). So
 * each cut makes at most two new tests, each of which looks into the cells of the grid around the
 * ear. */

/* What is in the queue before counts no more: others go first, so that ears stay small. */
static void queue_add(struct polygon_cutter *cutter, uint32_t index) {
    cutter->nodes[index].queued = cutter->queue_count;
    cutter->queue[cutter->queue_count++] = index;
}

/* The column or row of the grid. It never falls as the coordinate grows, so the cells of two ends
 * hold between them whatever lies between the ends. */
static size_t grid_place(const struct polygon_cutter *cutter, double coordinate, double first,
                         double scale) {
    size_t place = (size_t)((coordinate - first) * scale);
    return place < cutter->grid_size ? place : cutter->grid_size - 1;
}

static void cell_add(struct polygon_cutter *cutter, struct polygon_node *node) {
    size_t column = grid_place(cutter, node->x, cutter->left, cutter->x_scale);
    size_t row = grid_place(cutter, node->y, cutter->bottom, cutter->y_scale);
    uint32_t *cell = &cutter->cells[row * cutter->grid_size + column];
    node->in_cell = true;
    node->cell_next = *cell;
    *cell = (uint32_t)(node - cutter->nodes);
}

/* Find out how the polygon turns at a corner. */
static void find_turn(struct polygon_cutter *cutter, uint32_t index) {
    struct polygon_node *node = &cutter->nodes[index];
    node->turn = orientation(&cutter->nodes[node->previous], node, &cutter->nodes[node->next]);
}

/* After its neighbours changed. Only where the polygon crosses itself can a corner cease to be
 * convex. Others may stay in the list of their cell. */
static void update_corner(struct polygon_cutter *cutter, uint32_t index) {
    find_turn(cutter, index);
    if (cutter->nodes[index].turn <= 0 && !cutter->nodes[index].in_cell) {
        cell_add(cutter, &cutter->nodes[index]);
    }
    queue_add(cutter, index);
}

/* Does the polygon, where it comes back to the place of the corner `tip`, pass inside the corner's
 * angle? (A hole can touch the outline there.) */
static bool passes_inside(const struct polygon_cutter *cutter, const struct polygon_node *tip,
                          const struct polygon_node *other) {
    const struct polygon_node *previous = &cutter->nodes[tip->previous],
                              *next = &cutter->nodes[tip->next];
    const struct polygon_node *ends[2] = {&cutter->nodes[other->previous],
                                          &cutter->nodes[other->next]};
    for (int i = 0; i < 2; i++) {
        if (orientation(previous, tip, ends[i]) > 0 && orientation(tip, next, ends[i]) > 0) {
            return true;
        }
    }
    return false;
}

/* Does the corner `other` keep the ear at `tip` from being cut off? */
static bool blocks_ear(const struct polygon_cutter *cutter, const struct polygon_node *tip,
                       const struct polygon_node *other) {
    const struct polygon_node *previous = &cutter->nodes[tip->previous],
                              *next = &cutter->nodes[tip->next];
    if (other->turn > 0 || same_place(other, previous) || same_place(other, next)) {
        return false;
    }
    if (same_place(other, tip)) {
        return passes_inside(cutter, tip, other);
    }
    return orientation(previous, tip, other) >= 0 && orientation(tip, next, other) >= 0 &&
           orientation(next, previous, other) >= 0;
}

/* Does a corner of the list that starts at `first` keep the ear from being cut off? Adds the list
 * and those of its corners that are looked at to the work. */
static bool cell_blocks_ear(const struct polygon_cutter *cutter, uint32_t first,
                            const struct polygon_node *tip, uint64_t *work) {
    *work += 1;
    for (uint32_t i = first; i != NOTHING; i = cutter->nodes[i].cell_next) {
        *work += 1;
        if (blocks_ear(cutter, tip, &cutter->nodes[i])) {
            return true;
        }
    }
    return false;
}

/* A spike, where the polygon turns straight back, or a doubled point: it can always be cut off. */
static bool is_spike(const struct polygon_cutter *cutter, uint32_t index) {
    const struct polygon_node *tip = &cutter->nodes[index];
    const struct polygon_node *a = &cutter->nodes[tip->previous], *b = &cutter->nodes[tip->next];
    return tip->turn == 0 &&
           (a->x - tip->x) * (b->x - tip->x) + (a->y - tip->y) * (b->y - tip->y) >= 0;
}

/* Adds to the work that finding out takes. */
static bool is_ear(const struct polygon_cutter *cutter, uint32_t index, uint64_t *work) {
    const struct polygon_node *tip = &cutter->nodes[index];
    const struct polygon_node *a = &cutter->nodes[tip->previous], *b = &cutter->nodes[tip->next];
    if (tip->turn <= 0) { /* a point of a straight side stays */
        return is_spike(cutter, index);
    }
    double left = fmin(fmin(a->x, tip->x), b->x), right = fmax(fmax(a->x, tip->x), b->x);
    double bottom = fmin(fmin(a->y, tip->y), b->y), top = fmax(fmax(a->y, tip->y), b->y);
    size_t first_column = grid_place(cutter, left, cutter->left, cutter->x_scale);
    size_t last_column = grid_place(cutter, right, cutter->left, cutter->x_scale);
    size_t first_row = grid_place(cutter, bottom, cutter->bottom, cutter->y_scale);
    size_t last_row = grid_place(cutter, top, cutter->bottom, cutter->y_scale);
    for (size_t row = first_row; row <= last_row; row++) {
        for (size_t column = first_column; column <= last_column; column++) {
            uint32_t first = cutter->cells[row * cutter->grid_size + column];
            if (cell_blocks_ear(cutter, first, tip, work)) {
                return false;
            }
        }
    }
    return true;
}

/* When no ear is left the polygon crosses itself: a corner that turns left, or else any corner,
 * found from `start` on, goes next, so that every polygon of n corners becomes n - 2 triangles. */
static uint32_t any_node(const struct polygon_cutter *cutter, uint32_t start) {
    uint32_t index = start;
    do {
        if (cutter->nodes[index].turn >= 0) {
            return index;
        }
        index = cutter->nodes[index].next;
    } while (index != start);
    return start;
}

/* The corners are in the queue once at first, and each cut puts two there. */
static bool reserve_nodes(struct polygon_cutter *cutter, size_t size) {
    return array_extend(&cutter->nodes, &cutter->node_capacity, size, sizeof *cutter->nodes) &&
           array_extend(&cutter->cells, &cutter->cell_capacity, size, sizeof *cutter->cells) &&
           array_extend(&cutter->queue, &cutter->queue_capacity, 3 * size, sizeof *cutter->queue);
}

/* A rectangle around the polygon. */
static void find_bounds(struct polygon_cutter *cutter, size_t size) {
    double right = cutter->nodes[0].x, top = cutter->nodes[0].y;
    cutter->left = right;
    cutter->bottom = top;
    for (size_t i = 1; i < size; i++) {
        const struct polygon_node *node = &cutter->nodes[i];
        cutter->left = node->x < cutter->left ? node->x : cutter->left;
        right = node->x > right ? node->x : right;
        cutter->bottom = node->y < cutter->bottom ? node->y : cutter->bottom;
        top = node->y > top ? node->y : top;
    }
    cutter->width = right - cutter->left;
    cutter->height = top - cutter->bottom;
}

/* A grid with about as many cells as there are corners. While ears grow and corners become fewer,
 * it is made again, so that an ear reaches into as few cells as before. `start` is some corner that
 * is still there. */
static void make_grid(struct polygon_cutter *cutter, size_t size, uint32_t start) {
    uint32_t index = start;
    cutter->grid_size = (size_t)sqrt((double)size);
    /* Both are positive: a polygon without area on the plane is cut as a fan. */
    cutter->x_scale = (double)cutter->grid_size / cutter->width;
    cutter->y_scale = (double)cutter->grid_size / cutter->height;
    for (size_t i = 0; i < cutter->grid_size * cutter->grid_size; i++) {
        cutter->cells[i] = NOTHING;
    }
    do {
        struct polygon_node *node = &cutter->nodes[index];
        node->in_cell = false;
        if (node->turn <= 0) {
            cell_add(cutter, node);
        }
        index = node->next;
    } while (index != start);
}

/* Link the corners to a ring and put all of them into the queue. */
static void begin_ring(struct polygon_cutter *cutter, uint32_t size) {
    cutter->queue_count = 0;
    for (uint32_t i = 0; i < size; i++) {
        cutter->nodes[i].previous = i == 0 ? size - 1 : i - 1;
        cutter->nodes[i].next = i + 1 == size ? 0 : i + 1;
        find_turn(cutter, i);
        if (is_spike(cutter, i)) { /* first: without them, less can be mistaken for an ear */
            queue_add(cutter, i);
        }
    }
    for (uint32_t i = 1; i <= size; i++) {
        if (!is_spike(cutter, i % size)) {
            queue_add(cutter, i % size);
        }
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
    tip->queued = SIZE_MAX;
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
        index = is_spike(cutter, place) ? place : cutter->nodes[place].previous;
    } while (cutter->triangle_count < cuts && is_spike(cutter, index));
    return place;
}

/* False when that takes too long. */
static bool cut_ears(struct polygon_cutter *cutter, size_t size) {
    const size_t cuts = size - 3; /* a last triangle is left */
    const uint64_t work_limit = (uint64_t)size * POLYGON_WORK_LIMIT;
    uint32_t place = 0;    /* some corner that is still there */
    size_t gridded = size; /* corners when the grid was made */
    uint64_t work = 0;
    find_bounds(cutter, size);
    begin_ring(cutter, (uint32_t)size);
    make_grid(cutter, size, place);
    for (size_t i = 0; cutter->triangle_count < cuts && work <= work_limit;) {
        bool waiting = i < cutter->queue_count;
        uint32_t index = waiting ? cutter->queue[i] : any_node(cutter, place);
        bool current = cutter->nodes[index].queued == i;
        if (!waiting || (current && is_ear(cutter, index, &work))) {
            place = cut_ear(cutter, index, cuts);
        }
        i += waiting;
        if (size - cutter->triangle_count < gridded / 2) {
            gridded = size - cutter->triangle_count;
            make_grid(cutter, gridded, place);
        }
    }
    add_triangle(cutter, cutter->nodes[place].previous, place, cutter->nodes[place].next);
    return work <= work_limit;
}

/* ---- Polygons ---- */

static void cut_as_fan(struct polygon_cutter *cutter, size_t size) {
    for (uint32_t i = 2; i < size; i++) {
        add_triangle(cutter, 0, i - 1, i);
    }
}

enum polygon_result polygon_cut(struct polygon_cutter *cutter, const struct vec3 *corners,
                                size_t size) {
    assert(size >= 3 && size < UINT32_MAX);
    struct vec3 normal = size > 3 ? polygon_normal(corners, size) : (struct vec3){0, 0, 0};
    bool fan = fan_is_right(corners, size, normal);
    cutter->triangle_count = 0;
    if (!array_extend(&cutter->triangles, &cutter->triangle_capacity, size - 2,
                      sizeof *cutter->triangles) ||
        (!fan && !reserve_nodes(cutter, size))) {
        return POLYGON_OUT_OF_MEMORY;
    }
    if (fan) {
        cut_as_fan(cutter, size);
        return POLYGON_CUT;
    }
    struct plane plane = plane_facing(normal);
    for (size_t i = 0; i < size; i++) {
        cutter->nodes[i] = node_on_plane(corners[i], plane);
    }
    if (!cut_ears(cutter, size)) {
        cutter->triangle_count = 0;
        return POLYGON_TOO_INTRICATE;
    }
    return POLYGON_CUT;
}

void polygon_cutter_free(struct polygon_cutter *cutter) {
    free(cutter->triangles);
    free(cutter->nodes);
    free(cutter->cells);
    free(cutter->queue);
    *cutter = (struct polygon_cutter){0};
}
