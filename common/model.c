/*
 * Meshes; see model.h. In this file: reading numbers, cutting polygons, OBJ, OFF, normals,
 * textures.
 *
 * Formats: Wavefront Technologies, "Advanced Visualizer Manual", appendix B1 "Object Files (.obj)";
 * "OFF Files" in the Geomview manual (Geometry Center, University of Minnesota).
 */
#include "model.h"

#include "png.h"
#include "text.h"

#include <assert.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- Growing arrays ---- */

/* Room for `count` elements in an array that has room for `*capacity`. Returns the array, moved
 * perhaps, or NULL when memory runs out (the old array is then unchanged). Doubling keeps many
 * small steps linear. An element takes some bytes of the file, so the file's size bounds the
 * memory. */
static void *array_grown(void *array, size_t *capacity, size_t count, size_t element_size) {
    if (count <= *capacity) {
        return array;
    }
    size_t wanted = *capacity < 32 ? 64 : *capacity * 2;
    if (wanted < count) {
        wanted = count;
    }
    if (wanted > SIZE_MAX / element_size || wanted >= MODEL_NONE) {
        return NULL;
    }
    void *grown = realloc(array, wanted * element_size);
    if (grown != NULL) {
        *capacity = wanted;
    }
    return grown;
}

static bool out_of_memory(struct error *error) {
    return error_set(error, "not enough memory for the model");
}

/* ---- What the readers of both formats share ---- */

/* The corner of a polygon while it is cut. Neighbours are given by number. */
struct node {
    double x, y; /* on the plane of projection; exactly two of the position's coordinates */
    double turn; /* orientation at this corner: positive for a convex one */
    uint32_t previous, next;           /* around the polygon */
    uint32_t cell_previous, cell_next; /* in the list of the same cell, or MODEL_NONE */
    bool in_cell;                      /* not convex: stands in the list of its cell */
    bool waits;                        /* stands in the queue */
    bool gone;                         /* was cut off */
};

/* Working memory for cutting polygons, kept from one to the next. A grid of cells over the polygon
 * lists the corners that are not convex: only these can lie in the way of a cut. */
struct cutter {
    size_t node_capacity, cell_capacity, queue_capacity;
    struct node *nodes;
    uint32_t *cells; /* grid_size * grid_size: the first corner of each list, or MODEL_NONE */
    size_t grid_size;
    double left, bottom;     /* of the polygon */
    double x_scale, y_scale; /* cells per unit of length */
    uint32_t *queue;         /* a ring: corners of which it is not known whether they are ears */
    size_t queue_first, queue_count, queue_size;
};

/* A model being read. */
struct reader {
    struct text text;
    size_t line; /* where the current statement began, for messages */
    struct model *model;
    size_t position_capacity, uv_capacity, normal_capacity, face_capacity;
    struct corner *polygon; /* the corners of the current face */
    size_t polygon_size, polygon_capacity;
    struct cutter cutter;
    struct error *error;
};

enum {
    NUMBER_LIMIT = 12,      /* the most that a line of any format has: x y z, normal, colour, uv */
    CONCAVE_LIMIT = 1 << 17 /* corners of a face that is not convex: cutting may take n^2 steps */
};

/* The numbers up to the end of the line, all of them counted, the first NUMBER_LIMIT kept. Each
 * must be finite as a float. */
static bool read_numbers(struct reader *reader, float numbers[NUMBER_LIMIT], size_t *count) {
    *count = 0;
    for (;;) {
        struct word word = text_next_word(&reader->text);
        if (word.length == 0) {
            return true;
        }
        float number;
        if (!word_to_float(word, &number)) {
            return text_error(reader->error, reader->line, "'%s' is not a number",
                              word_show(word).text);
        }
        if (isinf(number)) {
            return text_error(reader->error, reader->line, "%s is too large", word_show(word).text);
        }
        if (*count < NUMBER_LIMIT) {
            numbers[*count] = number;
        }
        *count += 1;
    }
}

static bool add_position(struct reader *reader, const float position[3]) {
    struct model *model = reader->model;
    void *grown = array_grown(model->positions, &reader->position_capacity,
                              model->position_count + 1, sizeof *model->positions);
    if (grown == NULL) {
        return out_of_memory(reader->error);
    }
    model->positions = grown;
    memcpy(model->positions[model->position_count++], position, sizeof *model->positions);
    return true;
}

static bool add_uv(struct reader *reader, float u, float v) {
    struct model *model = reader->model;
    void *grown =
        array_grown(model->uvs, &reader->uv_capacity, model->uv_count + 1, sizeof *model->uvs);
    if (grown == NULL) {
        return out_of_memory(reader->error);
    }
    model->uvs = grown;
    model->uvs[model->uv_count][0] = u;
    model->uvs[model->uv_count++][1] = v;
    return true;
}

static bool add_normal(struct reader *reader, const float normal[3]) {
    struct model *model = reader->model;
    void *grown = array_grown(model->normals, &reader->normal_capacity, model->normal_count + 1,
                              sizeof *model->normals);
    if (grown == NULL) {
        return out_of_memory(reader->error);
    }
    model->normals = grown;
    memcpy(model->normals[model->normal_count++], normal, sizeof *model->normals);
    return true;
}

static bool add_corner(struct reader *reader, struct corner corner) {
    void *grown = array_grown(reader->polygon, &reader->polygon_capacity, reader->polygon_size + 1,
                              sizeof *reader->polygon);
    if (grown == NULL) {
        return out_of_memory(reader->error);
    }
    reader->polygon = grown;
    reader->polygon[reader->polygon_size++] = corner;
    return true;
}

/* Add a triangle of three of the polygon's corners; there is room. */
static void add_face(struct reader *reader, size_t a, size_t b, size_t c) {
    const struct corner *polygon = reader->polygon;
    reader->model->faces[reader->model->face_count++] =
        (struct face){{polygon[a], polygon[b], polygon[c]}};
}

static float clamped_to_one(float value) {
    return value > 0 ? (value < 1 ? value : 1) : 0;
}

static void free_reader(struct reader *reader) {
    free(reader->polygon);
    free(reader->cutter.nodes);
    free(reader->cutter.cells);
    free(reader->cutter.queue);
}

/* ---- Polygons: geometry ---- */

/* The sign of a sum of six numbers, exactly: they are added to an expansion, a list of doubles
 * whose sum is exact (Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust
 * Geometric Predicates", 1997, section 2.4). Its last component that is not 0 has the sign of the
 * sum. */
static double exact_sign_of_sum(const double terms[6]) {
    double expansion[6];
    for (int count = 0; count < 6; count++) {
        double sum = terms[count];
        for (int i = 0; i < count; i++) {
            double a = sum, b = expansion[i];
            sum = a + b;
            double b_part = sum - a, a_part = sum - b_part;
            expansion[i] = (a - a_part) + (b - b_part); /* what the addition rounded off */
        }
        expansion[count] = sum;
    }
    int last = 5;
    while (last > 0 && expansion[last] == 0) {
        last--;
    }
    return expansion[last];
}

/* Positive when a, b, c turn left, negative when they turn right, 0 when they lie on a line. Exact
 * for coordinates that are floats: their products are exact in double. */
static double orientation(const struct node *a, const struct node *b, const struct node *c) {
    double left = (b->x - a->x) * (c->y - a->y);
    double right = (b->y - a->y) * (c->x - a->x);
    double bound =
        4e-16 * (fabs(left) + fabs(right)); /* (3 + 16e)e with e = 2^-53, and some more */
    if (fabs(left - right) > bound) {
        return left - right;
    }
    return exact_sign_of_sum((const double[6]){a->x * b->y, -a->y * b->x, b->x * c->y, -b->y * c->x,
                                               c->x * a->y, -c->y * a->x});
}

static bool same_place(const struct node *a, const struct node *b) {
    return a->x == b->x && a->y == b->y;
}

/* Twice the polygon's area vector, relative to its first corner so that a place far from the origin
 * costs no accuracy (Newell's formula: Sutherland, Sproull and Schumacker, "A Characterization of
 * Ten Hidden-Surface Algorithms", 1974, attributed to M. Newell). */
static struct vec3 polygon_normal(const struct reader *reader) {
    const struct corner *polygon = reader->polygon;
    const float(*positions)[3] = (const float(*)[3])reader->model->positions;
    const float *first = positions[polygon[0].position];
    struct vec3 normal = {0, 0, 0};
    struct vec3 previous = {0, 0, 0};
    for (size_t i = 1; i < reader->polygon_size; i++) {
        const float *p = positions[polygon[i].position];
        struct vec3 current = {(double)p[0] - (double)first[0], (double)p[1] - (double)first[1],
                               (double)p[2] - (double)first[2]};
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

/* Corner `index` of the polygon (or, after the last, from the first on) as it lies on the plane. */
static struct node node_on_plane(const struct reader *reader, struct plane plane, size_t index) {
    size_t size = reader->polygon_size;
    const struct corner *corner = &reader->polygon[index < size ? index : index - size];
    const float *p = reader->model->positions[corner->position];
    return (struct node){.x = (double)p[plane.across], .y = (double)p[plane.up]};
}

/* Convex: it never turns right. (So does a star that goes round several times; but no way of
 * cutting one is right.) */
static bool polygon_is_convex(const struct reader *reader, struct plane plane) {
    struct node a = node_on_plane(reader, plane, 0), b = node_on_plane(reader, plane, 1);
    for (size_t i = 0; i < reader->polygon_size; i++) {
        struct node c = node_on_plane(reader, plane, i + 2);
        if (orientation(&a, &b, &c) < 0) {
            return false;
        }
        a = b;
        b = c;
    }
    return true;
}

/* ---- Polygons: cutting off ears ----
 *
 * An ear is a convex corner whose triangle with its two neighbours holds no other corner; it can be
 * cut off, which leaves a polygon with one corner less (Meisters, "Polygons have ears", 1975). Only
 * corners that are not convex need to be tested, and cutting an ear off changes only what is known
 * of its two neighbours (O'Rourke, "Computational Geometry in C", second edition, section 1.6). So
 * each cut makes at most two new tests, each of which looks into the cells of the grid around the
 * ear. */

static void queue_add(struct cutter *cutter, uint32_t index) {
    if (!cutter->nodes[index].waits) {
        cutter->nodes[index].waits = true;
        cutter->queue[(cutter->queue_first + cutter->queue_count) % cutter->queue_size] = index;
        cutter->queue_count++;
    }
}

static uint32_t queue_take(struct cutter *cutter) {
    uint32_t index = cutter->queue[cutter->queue_first];
    cutter->queue_first = (cutter->queue_first + 1) % cutter->queue_size;
    cutter->queue_count--;
    cutter->nodes[index].waits = false;
    return index;
}

/* The column or row of the grid. It never falls as the coordinate grows, so the cells of two ends
 * hold between them whatever lies between the ends. */
static size_t grid_place(const struct cutter *cutter, double coordinate, double first,
                         double scale) {
    size_t place = (size_t)((coordinate - first) * scale);
    return place < cutter->grid_size ? place : cutter->grid_size - 1;
}

static uint32_t *cell_of(struct cutter *cutter, const struct node *node) {
    size_t column = grid_place(cutter, node->x, cutter->left, cutter->x_scale);
    size_t row = grid_place(cutter, node->y, cutter->bottom, cutter->y_scale);
    return &cutter->cells[row * cutter->grid_size + column];
}

static void cell_add(struct cutter *cutter, uint32_t index) {
    struct node *node = &cutter->nodes[index];
    uint32_t *cell = cell_of(cutter, node);
    node->in_cell = true;
    node->cell_previous = MODEL_NONE;
    node->cell_next = *cell;
    if (*cell != MODEL_NONE) {
        cutter->nodes[*cell].cell_previous = index;
    }
    *cell = index;
}

static void cell_remove(struct cutter *cutter, uint32_t index) {
    struct node *node = &cutter->nodes[index];
    node->in_cell = false;
    if (node->cell_previous != MODEL_NONE) {
        cutter->nodes[node->cell_previous].cell_next = node->cell_next;
    } else {
        *cell_of(cutter, node) = node->cell_next;
    }
    if (node->cell_next != MODEL_NONE) {
        cutter->nodes[node->cell_next].cell_previous = node->cell_previous;
    }
}

/* Find out how the polygon turns at a corner, after its neighbours changed. */
static void update_turn(struct cutter *cutter, uint32_t index) {
    struct node *node = &cutter->nodes[index];
    node->turn = orientation(&cutter->nodes[node->previous], node, &cutter->nodes[node->next]);
    bool reflex = node->turn <= 0;
    if (reflex && !node->in_cell) {
        cell_add(cutter, index);
    } else if (!reflex && node->in_cell) {
        cell_remove(cutter, index);
    }
}

/* Does the polygon, where it comes back to the place of the corner `tip`, pass inside the corner's
 * angle? (A hole can touch the outline there.) */
static bool passes_inside(const struct cutter *cutter, const struct node *tip,
                          const struct node *other) {
    const struct node *previous = &cutter->nodes[tip->previous], *next = &cutter->nodes[tip->next];
    const struct node *ends[2] = {&cutter->nodes[other->previous], &cutter->nodes[other->next]};
    for (int i = 0; i < 2; i++) {
        if (orientation(previous, tip, ends[i]) > 0 && orientation(tip, next, ends[i]) > 0) {
            return true;
        }
    }
    return false;
}

/* Does the corner `other` keep the ear at `tip` from being cut off? */
static bool blocks_ear(const struct cutter *cutter, const struct node *tip,
                       const struct node *other) {
    const struct node *previous = &cutter->nodes[tip->previous], *next = &cutter->nodes[tip->next];
    if (same_place(other, previous) || same_place(other, next)) {
        return false;
    }
    if (same_place(other, tip)) {
        return passes_inside(cutter, tip, other);
    }
    return orientation(previous, tip, other) >= 0 && orientation(tip, next, other) >= 0 &&
           orientation(next, previous, other) >= 0;
}

/* Does a corner of the list that starts at `first` keep the ear from being cut off? */
static bool cell_blocks_ear(const struct cutter *cutter, uint32_t first, const struct node *tip) {
    for (uint32_t i = first; i != MODEL_NONE; i = cutter->nodes[i].cell_next) {
        if (blocks_ear(cutter, tip, &cutter->nodes[i])) {
            return true;
        }
    }
    return false;
}

static double least_of(double a, double b, double c) {
    double least = a < b ? a : b;
    return least < c ? least : c;
}

static double greatest_of(double a, double b, double c) {
    double greatest = a > b ? a : b;
    return greatest > c ? greatest : c;
}

/* A spike, where the polygon turns straight back, or a doubled point: it can always be cut off. */
static bool is_spike(const struct cutter *cutter, uint32_t index) {
    const struct node *tip = &cutter->nodes[index];
    const struct node *a = &cutter->nodes[tip->previous], *b = &cutter->nodes[tip->next];
    return tip->turn == 0 &&
           (a->x - tip->x) * (b->x - tip->x) + (a->y - tip->y) * (b->y - tip->y) >= 0;
}

static bool is_ear(const struct cutter *cutter, uint32_t index) {
    const struct node *tip = &cutter->nodes[index];
    const struct node *a = &cutter->nodes[tip->previous], *b = &cutter->nodes[tip->next];
    if (tip->turn <= 0) { /* a point of a straight side stays */
        return is_spike(cutter, index);
    }
    double left = least_of(a->x, tip->x, b->x), right = greatest_of(a->x, tip->x, b->x);
    double bottom = least_of(a->y, tip->y, b->y), top = greatest_of(a->y, tip->y, b->y);
    size_t first_column = grid_place(cutter, left, cutter->left, cutter->x_scale);
    size_t last_column = grid_place(cutter, right, cutter->left, cutter->x_scale);
    size_t first_row = grid_place(cutter, bottom, cutter->bottom, cutter->y_scale);
    size_t last_row = grid_place(cutter, top, cutter->bottom, cutter->y_scale);
    for (size_t row = first_row; row <= last_row; row++) {
        for (size_t column = first_column; column <= last_column; column++) {
            if (cell_blocks_ear(cutter, cutter->cells[row * cutter->grid_size + column], tip)) {
                return false;
            }
        }
    }
    return true;
}

/* When no ear is left the polygon crosses itself: a corner that turns left, or else any corner,
 * found from `start` on, goes next, so that every polygon of n corners becomes n - 2 triangles. */
static uint32_t any_corner(const struct cutter *cutter, uint32_t start) {
    uint32_t index = start;
    do {
        if (cutter->nodes[index].turn >= 0) {
            return index;
        }
        index = cutter->nodes[index].next;
    } while (index != start);
    return start;
}

static bool cutter_reserve(struct cutter *cutter, size_t size) {
    void *nodes = array_grown(cutter->nodes, &cutter->node_capacity, size, sizeof *cutter->nodes);
    cutter->nodes = nodes == NULL ? cutter->nodes : nodes;
    void *cells = array_grown(cutter->cells, &cutter->cell_capacity, size, sizeof *cutter->cells);
    cutter->cells = cells == NULL ? cutter->cells : cells;
    void *queue = array_grown(cutter->queue, &cutter->queue_capacity, size, sizeof *cutter->queue);
    cutter->queue = queue == NULL ? cutter->queue : queue;
    return nodes != NULL && cells != NULL && queue != NULL;
}

/* About as many cells as corners, over the rectangle around the polygon. */
static void grid_begin(struct cutter *cutter, size_t size) {
    double right = cutter->nodes[0].x, top = cutter->nodes[0].y;
    cutter->left = right;
    cutter->bottom = top;
    for (size_t i = 1; i < size; i++) {
        const struct node *node = &cutter->nodes[i];
        cutter->left = node->x < cutter->left ? node->x : cutter->left;
        right = node->x > right ? node->x : right;
        cutter->bottom = node->y < cutter->bottom ? node->y : cutter->bottom;
        top = node->y > top ? node->y : top;
    }
    cutter->grid_size = (size_t)sqrt((double)size);
    double width = right - cutter->left, height = top - cutter->bottom;
    /* Both are positive: a polygon without area on the plane is cut as a fan. */
    cutter->x_scale = (double)cutter->grid_size / width;
    cutter->y_scale = (double)cutter->grid_size / height;
    for (size_t i = 0; i < cutter->grid_size * cutter->grid_size; i++) {
        cutter->cells[i] = MODEL_NONE;
    }
}

/* Link the corners to a ring, list those that are not convex, put all into the queue. */
static void cutter_begin(struct cutter *cutter, uint32_t size) {
    grid_begin(cutter, size);
    cutter->queue_first = cutter->queue_count = 0;
    cutter->queue_size = size;
    for (uint32_t i = 0; i < size; i++) {
        struct node *node = &cutter->nodes[i];
        node->previous = i == 0 ? size - 1 : i - 1;
        node->next = i + 1 == size ? 0 : i + 1;
    }
    for (uint32_t i = 0; i < size; i++) {
        update_turn(cutter, i);
    }
    for (uint32_t i = 0; i < size; i++) {
        if (is_spike(cutter, i)) { /* first: without them, less can be mistaken for an ear */
            queue_add(cutter, i);
        }
    }
    for (uint32_t i = 1; i <= size; i++) {
        queue_add(cutter, i % size);
    }
}

/* Cut the corner off: its triangle becomes a face, its neighbours become neighbours. */
static void cut_off(struct reader *reader, uint32_t index) {
    struct cutter *cutter = &reader->cutter;
    struct node *tip = &cutter->nodes[index];
    add_face(reader, tip->previous, index, tip->next);
    if (tip->in_cell) {
        cell_remove(cutter, index);
    }
    tip->gone = true;
    cutter->nodes[tip->previous].next = tip->next;
    cutter->nodes[tip->next].previous = tip->previous;
    update_turn(cutter, tip->previous);
    update_turn(cutter, tip->next);
    queue_add(cutter, tip->previous);
    queue_add(cutter, tip->next);
}

static bool cut_ears(struct reader *reader, struct plane plane) {
    struct cutter *cutter = &reader->cutter;
    if (!cutter_reserve(cutter, reader->polygon_size)) {
        return out_of_memory(reader->error);
    }
    for (size_t i = 0; i < reader->polygon_size; i++) {
        cutter->nodes[i] = node_on_plane(reader, plane, i);
    }
    size_t left = reader->polygon_size;
    uint32_t place = 0; /* some corner that is still there */
    cutter_begin(cutter, (uint32_t)left);
    while (left > 3) {
        uint32_t index;
        if (cutter->queue_count > 0) {
            index = queue_take(cutter);
            if (cutter->nodes[index].gone || !is_ear(cutter, index)) {
                continue;
            }
        } else {
            index = any_corner(cutter, place);
        }
        do { /* and at once whatever that turns into spikes */
            place = cutter->nodes[index].next;
            cut_off(reader, index);
            left--;
            index = is_spike(cutter, place) ? place : cutter->nodes[place].previous;
        } while (left > 3 && is_spike(cutter, index));
    }
    add_face(reader, cutter->nodes[place].previous, place, cutter->nodes[place].next);
    return true;
}

/* Is it right to cut the polygon as a fan? It is where it has no area, too: nothing will be seen.
 */
static bool fan_is_right(const struct reader *reader, struct vec3 normal) {
    bool flat = normal.x == 0 && normal.y == 0 && normal.z == 0;
    return flat || polygon_is_convex(reader, plane_facing(normal));
}

/* Make faces of the polygon (at least 3 corners): a convex one is a fan around its first corner. */
static bool add_polygon(struct reader *reader) {
    struct model *model = reader->model;
    size_t size = reader->polygon_size;
    struct vec3 normal = size > 3 ? polygon_normal(reader) : (struct vec3){0, 0, 0};
    bool fan = size == 3 || fan_is_right(reader, normal);
    if (!fan && size > CONCAVE_LIMIT) {
        return text_error(reader->error, reader->line,
                          "face of %zu corners: one that is not convex may have %d", size,
                          CONCAVE_LIMIT);
    }
    void *grown = array_grown(model->faces, &reader->face_capacity, model->face_count + size - 2,
                              sizeof *model->faces);
    if (grown == NULL) {
        return out_of_memory(reader->error);
    }
    model->faces = grown;
    if (!fan) {
        return cut_ears(reader, plane_facing(normal));
    }
    for (size_t i = 2; i < size; i++) {
        add_face(reader, 0, i - 1, i);
    }
    return true;
}

/* ---- OBJ: positions, texture coordinates and normals ---- */

/* Keep the colour of the last position. Positions without one are white. */
static bool obj_add_color(struct reader *reader, size_t *capacity, const float color[3]) {
    struct model *model = reader->model;
    if (*capacity < reader->position_capacity) { /* grow together with the positions */
        void *grown = realloc(model->colors, reader->position_capacity * sizeof *model->colors);
        if (grown == NULL) {
            return out_of_memory(reader->error);
        }
        model->colors = grown;
        for (size_t i = *capacity; i < reader->position_capacity; i++) {
            model->colors[i][0] = model->colors[i][1] = model->colors[i][2] = 1;
        }
        *capacity = reader->position_capacity;
    }
    for (int i = 0; i < 3; i++) {
        model->colors[model->position_count - 1][i] = clamped_to_one(color[i]);
    }
    return true;
}

static bool obj_read_position(struct reader *reader, size_t *color_capacity) {
    float numbers[NUMBER_LIMIT];
    size_t count;
    if (!read_numbers(reader, numbers, &count)) {
        return false;
    }
    if (count != 3 && count != 4 && count != 6) { /* x y z, x y z w, x y z r g b */
        return text_error(reader->error, reader->line, "'v' takes 3, 4 or 6 numbers, not %zu",
                          count);
    }
    return add_position(reader, numbers) &&
           (count != 6 || obj_add_color(reader, color_capacity, numbers + 3));
}

static bool obj_read_uv(struct reader *reader) {
    float numbers[NUMBER_LIMIT];
    size_t count;
    if (!read_numbers(reader, numbers, &count)) {
        return false;
    }
    if (count < 1 || count > 3) { /* u, u v, u v w */
        return text_error(reader->error, reader->line, "'vt' takes 1 to 3 numbers, not %zu", count);
    }
    return add_uv(reader, numbers[0], count > 1 ? numbers[1] : 0);
}

static bool obj_read_normal(struct reader *reader) {
    float numbers[NUMBER_LIMIT];
    size_t count;
    if (!read_numbers(reader, numbers, &count)) {
        return false;
    }
    if (count != 3) {
        return text_error(reader->error, reader->line, "'vn' takes 3 numbers, not %zu", count);
    }
    return add_normal(reader, numbers);
}

/* Everything but the faces. Colours, where some positions have them, are kept for all. */
static bool obj_read_attributes(struct reader *reader) {
    struct model *model = reader->model;
    size_t color_capacity = 0;
    while (text_next_line(&reader->text)) {
        reader->line = reader->text.line;
        struct word keyword = text_next_word(&reader->text);
        bool done = true;
        if (word_is(keyword, "v")) {
            done = obj_read_position(reader, &color_capacity);
        } else if (word_is(keyword, "vt")) {
            done = obj_read_uv(reader);
        } else if (word_is(keyword, "vn")) {
            done = obj_read_normal(reader);
        }
        if (!done) {
            return false;
        }
    }
    if (color_capacity > 0 && color_capacity < model->position_count) {
        static const float white[3] = {1, 1, 1};
        return obj_add_color(reader, &color_capacity, white); /* positions after the last colour */
    }
    return true;
}

/* ---- OBJ: faces ---- */

/* What an index of a face counts. */
struct obj_list {
    const char *name;
    size_t so_far; /* elements above the face: what a negative index counts back from */
    size_t total;  /* elements in the file: a positive index may name one further down */
};

struct obj_lists {
    struct obj_list list[3]; /* positions, texture coordinates, normals */
};

/* An integer; one outside 64 bits becomes the nearest that fits, which no file can hold. */
static bool obj_parse_index(struct word field, int64_t *index) {
    if (word_to_integer(field, index)) {
        return true;
    }
    size_t sign = field.length > 0 && (field.start[0] == '-' || field.start[0] == '+');
    for (size_t i = sign; i < field.length; i++) {
        if (field.start[i] < '0' || field.start[i] > '9') {
            return false;
        }
    }
    *index = field.length > sign && field.start[0] == '-' ? INT64_MIN : INT64_MAX;
    return field.length > sign;
}

/* The index from 0 of what the field names. */
static bool obj_resolve(struct reader *reader, struct word field, const struct obj_list *list,
                        int64_t index, uint32_t *resolved) {
    if (index > 0 && (uint64_t)index <= list->total) {
        *resolved = (uint32_t)(index - 1);
        return true;
    }
    if (index < 0 && index >= -(int64_t)list->so_far) {
        *resolved = (uint32_t)((int64_t)list->so_far + index);
        return true;
    }
    if (index == 0) {
        return text_error(reader->error, reader->line, "face names %s 0: the first is 1",
                          list->name);
    }
    return text_error(reader->error, reader->line, "face names %s %s of %zu", list->name,
                      word_show(field).text, index > 0 ? list->total : list->so_far);
}

/* "v", "v/vt", "v//vn" or "v/vt/vn". */
static bool obj_read_corner(struct reader *reader, struct word word,
                            const struct obj_lists *lists) {
    uint32_t resolved[3] = {MODEL_NONE, MODEL_NONE, MODEL_NONE};
    const char *p = word.start, *end = word.start + word.length;
    bool well_formed = true;
    for (int i = 0; i < 3 && well_formed; i++) {
        struct word field = {p, 0};
        while (p < end && *p != '/') {
            p++;
        }
        field.length = (size_t)(p - field.start);
        bool left_out = i == 1 && field.length == 0 && p < end;
        int64_t index;
        if (!left_out) {
            well_formed = obj_parse_index(field, &index);
            if (well_formed && !obj_resolve(reader, field, &lists->list[i], index, &resolved[i])) {
                return false;
            }
        }
        if (p == end) {
            break;
        }
        well_formed = well_formed && i < 2; /* a third slash */
        p++;
    }
    if (!well_formed) {
        return text_error(reader->error, reader->line,
                          "face corner '%s' is none of v, v/vt, v//vn, v/vt/vn",
                          word_show(word).text);
    }
    return add_corner(reader, (struct corner){resolved[0], resolved[1], resolved[2]});
}

static bool obj_read_face(struct reader *reader, const struct obj_lists *lists) {
    reader->polygon_size = 0;
    for (;;) {
        struct word word = text_next_word(&reader->text);
        if (word.length == 0) {
            break;
        }
        if (!obj_read_corner(reader, word, lists)) {
            return false;
        }
    }
    if (reader->polygon_size < 3) {
        return text_error(reader->error, reader->line, "a face has at least 3 corners, not %zu",
                          reader->polygon_size);
    }
    return add_polygon(reader);
}

static bool obj_read_faces(struct reader *reader) {
    const struct model *model = reader->model;
    struct obj_lists lists = {{{"vertex", 0, model->position_count},
                               {"texture coordinate", 0, model->uv_count},
                               {"normal", 0, model->normal_count}}};
    while (text_next_line(&reader->text)) {
        reader->line = reader->text.line;
        struct word keyword = text_next_word(&reader->text);
        if (word_is(keyword, "f")) {
            if (!obj_read_face(reader, &lists)) {
                return false;
            }
        } else if (word_is(keyword, "v")) {
            lists.list[0].so_far++;
        } else if (word_is(keyword, "vt")) {
            lists.list[1].so_far++;
        } else if (word_is(keyword, "vn")) {
            lists.list[2].so_far++;
        }
    }
    return true;
}

/* Read twice: a face may name a vertex that comes further down, and cutting it needs the position.
 */
static bool obj_decode(struct reader *reader, const void *data, size_t size) {
    if (!text_begin(&reader->text, data, size, true, reader->error)) {
        return false;
    }
    struct text start = reader->text;
    if (!obj_read_attributes(reader)) {
        return false;
    }
    reader->text = start;
    return obj_read_faces(reader);
}

/* ---- OFF ---- */

/* The first word: [ST][C][N][4][n]OFF says what a vertex has beside x y z. */
struct off_kind {
    bool uv, color, normal;
    bool four, dimension; /* 4OFF and nOFF: positions of more than three coordinates */
    struct word rest;     /* what follows OFF in the same word: some writers leave out the blank */
};

static bool over_prefix(const char **p, const char *end, const char *prefix) {
    size_t length = strlen(prefix);
    if ((size_t)(end - *p) < length || memcmp(*p, prefix, length) != 0) {
        return false;
    }
    *p += length;
    return true;
}

static bool off_parse_keyword(struct word word, struct off_kind *kind) {
    *kind = (struct off_kind){0};
    if (word.length == 0) {
        return false;
    }
    const char *p = word.start, *end = word.start + word.length;
    kind->uv = over_prefix(&p, end, "ST");
    kind->color = over_prefix(&p, end, "C");
    kind->normal = over_prefix(&p, end, "N");
    kind->four = over_prefix(&p, end, "4");
    kind->dimension = over_prefix(&p, end, "n");
    if (!over_prefix(&p, end, "OFF")) {
        return false;
    }
    kind->rest = (struct word){p, (size_t)(end - p)};
    return p == end || (*p >= '0' && *p <= '9');
}

/* Go to the next line that is not empty; its first word. */
static bool off_next_line(struct reader *reader, struct word *word) {
    while (text_next_line(&reader->text)) {
        reader->line = reader->text.line;
        *word = text_next_word(&reader->text);
        if (word->length > 0) {
            return true;
        }
    }
    return false;
}

static bool off_read_count(struct reader *reader, struct word word, const char *what,
                           size_t *count) {
    int64_t value;
    if (!word_to_integer(word, &value) || value < 0 || (uint64_t)value >= MODEL_NONE) {
        return text_error(reader->error, reader->line, "'%s' is not a number of %s",
                          word_show(word).text, what);
    }
    *count = (size_t)value;
    return true;
}

/* "OFF" and the numbers of vertices, faces and (not used, may be missing) edges, on one line or
 * two. A vertex takes at least 6 bytes ("0 0 0" and a line's end), a face at least 2. */
static bool off_read_header(struct reader *reader, struct off_kind *kind, size_t *vertices,
                            size_t *faces) {
    struct word word;
    bool is_off = off_next_line(reader, &word) && off_parse_keyword(word, kind);
    assert(is_off); /* or it would have been read as OBJ */
    (void)is_off;
    if (kind->four || kind->dimension) {
        return text_error(reader->error, reader->line,
                          "%s: only positions of three coordinates can be read",
                          word_show(word).text);
    }
    word = kind->rest.length > 0 ? kind->rest : text_next_word(&reader->text);
    if (word_is(word, "BINARY")) {
        return text_error(reader->error, reader->line, "binary OFF files cannot be read");
    }
    if (word.length == 0 && !off_next_line(reader, &word)) {
        return text_error(reader->error, reader->line,
                          "the numbers of vertices and faces are missing");
    }
    if (!off_read_count(reader, word, "vertices", vertices)) {
        return false;
    }
    word = text_next_word(&reader->text);
    if (word.length == 0) {
        return text_error(reader->error, reader->line, "the number of faces is missing");
    }
    if (!off_read_count(reader, word, "faces", faces)) {
        return false;
    }
    uint64_t left = (uint64_t)(reader->text.end - reader->text.next) + 1;
    if (*vertices > left / 6 || *faces > left / 2) {
        return text_error(reader->error, reader->line,
                          "%zu vertices and %zu faces are more than the file can hold", *vertices,
                          *faces);
    }
    return true;
}

static bool off_read_vertex(struct reader *reader, const struct off_kind *kind, size_t number,
                            size_t total) {
    struct model *model = reader->model;
    float numbers[NUMBER_LIMIT];
    size_t count;
    struct word first;
    if (!off_next_line(reader, &first)) {
        return text_error(reader->error, reader->line, "the file ends after %zu of %zu vertices",
                          number, total);
    }
    reader->text.next = first.start; /* the first word is a number too */
    if (!read_numbers(reader, numbers, &count)) {
        return false;
    }
    size_t color_at = kind->normal ? 6 : 3;
    size_t least = color_at + (kind->color ? 3 : 0) + (kind->uv ? 2 : 0);
    bool alpha = kind->color && count == least + 1; /* read over */
    if (count != least && !alpha) {
        return text_error(reader->error, reader->line, "a vertex has %zu%s numbers here, not %zu",
                          least, kind->color ? " (with alpha one more)" : "", count);
    }
    if (kind->color) {
        memcpy(model->colors[model->position_count], numbers + color_at, sizeof *model->colors);
    }
    return add_position(reader, numbers) && (!kind->normal || add_normal(reader, numbers + 3)) &&
           (!kind->uv || add_uv(reader, numbers[count - 2], numbers[count - 1]));
}

/* Colours are 0..1, but many writers use levels 0..255: one value above 1 tells. */
static void off_scale_colors(struct model *model) {
    float scale = 1;
    for (size_t i = 0; i < model->position_count; i++) {
        for (int channel = 0; channel < 3; channel++) {
            scale = model->colors[i][channel] > 1 ? 255 : scale;
        }
    }
    for (size_t i = 0; i < model->position_count; i++) {
        for (int channel = 0; channel < 3; channel++) {
            model->colors[i][channel] = clamped_to_one(model->colors[i][channel] / scale);
        }
    }
}

static bool off_read_vertices(struct reader *reader, const struct off_kind *kind, size_t total) {
    struct model *model = reader->model;
    if (kind->color && total > 0) {
        model->colors = calloc(total, sizeof *model->colors);
        if (model->colors == NULL) {
            return out_of_memory(reader->error);
        }
    }
    for (size_t i = 0; i < total; i++) {
        if (!off_read_vertex(reader, kind, i, total)) {
            return false;
        }
    }
    if (model->colors != NULL) {
        off_scale_colors(model);
    }
    return true;
}

/* "n i1 ... in", then perhaps a colour, which is not used. */
static bool off_read_face(struct reader *reader, const struct off_kind *kind, size_t number,
                          size_t total) {
    size_t vertices = reader->model->position_count;
    struct word word;
    if (!off_next_line(reader, &word)) {
        return text_error(reader->error, reader->line, "the file ends after %zu of %zu faces",
                          number, total);
    }
    size_t size = 0;
    if (!off_read_count(reader, word, "corners", &size)) {
        return false;
    }
    reader->polygon_size = 0;
    for (size_t i = 0; i < size; i++) {
        int64_t index;
        word = text_next_word(&reader->text);
        if (word.length == 0) {
            return text_error(reader->error, reader->line, "face has %zu corners, not %zu", i,
                              size);
        }
        if (!obj_parse_index(word, &index)) {
            return text_error(reader->error, reader->line, "'%s' is not the number of a vertex",
                              word_show(word).text);
        }
        if (index < 0 || (uint64_t)index >= vertices) {
            return text_error(reader->error, reader->line, "face names vertex %s of %zu (from 0)",
                              word_show(word).text, vertices);
        }
        uint32_t i32 = (uint32_t)index;
        if (!add_corner(reader, (struct corner){i32, kind->uv ? i32 : MODEL_NONE,
                                                kind->normal ? i32 : MODEL_NONE})) {
            return false;
        }
    }
    return size < 3 || add_polygon(reader); /* points and lines are not drawn */
}

static bool off_decode(struct reader *reader, const void *data, size_t size) {
    struct off_kind kind = {0};
    size_t vertices = 0, faces = 0;
    if (!text_begin(&reader->text, data, size, false, reader->error) ||
        !off_read_header(reader, &kind, &vertices, &faces) ||
        !off_read_vertices(reader, &kind, vertices)) {
        return false;
    }
    for (size_t i = 0; i < faces; i++) {
        if (!off_read_face(reader, &kind, i, faces)) {
            return false;
        }
    }
    return true;
}

/* ---- Reading either ---- */

static bool is_off(const void *data, size_t size) {
    struct text text;
    struct error ignored;
    struct word word = {0};
    struct off_kind kind;
    if (!text_begin(&text, data, size, false, &ignored)) {
        return false;
    }
    while (word.length == 0 && text_next_line(&text)) {
        word = text_next_word(&text);
    }
    return off_parse_keyword(word, &kind);
}

bool model_decode(struct model *model, const void *data, size_t size, struct error *error) {
    struct reader reader = {.model = model, .error = error};
    *model = (struct model){0};
    bool done =
        is_off(data, size) ? off_decode(&reader, data, size) : obj_decode(&reader, data, size);
    if (done && model->face_count == 0) {
        done = error_set(error, "holds no faces");
    }
    free_reader(&reader);
    if (!done) {
        model_free(model);
    }
    return done;
}

bool model_read(struct model *model, const char *path, struct error *error) {
    struct bytes bytes;
    *model = (struct model){0};
    if (!file_read(path, &bytes, error)) {
        return false;
    }
    bool done = model_decode(model, bytes.data, bytes.size, error);
    bytes_free(&bytes);
    if (!done) {
        return text_name_file(error, path);
    }
    size_t path_size = strlen(path) + 1;
    model->path = malloc(path_size);
    if (model->path == NULL) {
        model_free(model);
        out_of_memory(error);
        return text_name_file(error, path);
    }
    memcpy(model->path, path, path_size);
    return true;
}

void model_free(struct model *model) {
    for (int i = 0; i < MODEL_TEXTURE_KINDS; i++) {
        texture_free(&model->textures[i]);
    }
    free(model->positions);
    free(model->uvs);
    free(model->normals);
    free(model->colors);
    free(model->faces);
    free(model->path);
    *model = (struct model){0};
}

/* ---- Normals ---- */

/* The angle whose tangent is y / x, for y and x that are not negative nor both 0: 0..pi/2. The
 * tangent is brought below tan(pi/32) by halving the angle three times, where nine terms of the
 * series of the arcus tangent leave less than 1e-19 (NIST Digital Library of Mathematical
 * Functions, 4.21(i) for the half angle, 4.24.3 for the series). */
static double angle_of_ratio(double y, double x) {
    const double half_pi = 1.57079632679489661923;
    bool swapped = y > x;
    double tangent = swapped ? x / y : y / x;
    for (int i = 0; i < 3; i++) {
        tangent = tangent / (1 + sqrt(1 + tangent * tangent));
    }
    double square = tangent * tangent, series = 0;
    for (int odd = 17; odd >= 1; odd -= 2) {
        series = 1.0 / odd - square * series;
    }
    double angle = 8 * tangent * series;
    return swapped ? half_pi - angle : angle;
}

double model_angle(struct vec3 a, struct vec3 b) {
    struct vec3 u = vec3_normalized(a), v = vec3_normalized(b);
    double apart = vec3_length(vec3_sub(u, v)), along = vec3_length(vec3_add(u, v));
    bool both = vec3_dot(u, u) > 0 && vec3_dot(v, v) > 0;
    return both ? 2 * angle_of_ratio(apart, along) : 0;
}

/* Add a face's normal to the sum at each of its positions, weighted by its angle there. */
static void add_face_normal(const struct model *model, size_t face, struct vec3 *sums) {
    struct vec3 p[3];
    for (size_t i = 0; i < 3; i++) {
        p[i] = model_position(model, face, i);
    }
    struct vec3 normal = vec3_normalized(vec3_cross(vec3_sub(p[1], p[0]), vec3_sub(p[2], p[0])));
    for (size_t i = 0; i < 3; i++) {
        double angle = model_angle(vec3_sub(p[(i + 1) % 3], p[i]), vec3_sub(p[(i + 2) % 3], p[i]));
        struct vec3 *sum = &sums[model->faces[face].corner[i].position];
        *sum = vec3_add(*sum, vec3_scale(normal, angle));
    }
}

/* Append the normal of a position to the model's, which has room for it. */
static uint32_t append_normal(struct model *model, struct vec3 sum) {
    const double noise = 1e-9; /* far above what rounding leaves of opposite normals */
    struct vec3 normal = vec3_length(sum) > noise ? vec3_normalized(sum) : (struct vec3){0, 0, 1};
    float *stored = model->normals[model->normal_count];
    stored[0] = (float)normal.x;
    stored[1] = (float)normal.y;
    stored[2] = (float)normal.z;
    return (uint32_t)model->normal_count++;
}

static size_t count_bare_corners(const struct model *model) {
    size_t count = 0;
    for (size_t i = 0; i < model->face_count; i++) {
        for (int j = 0; j < 3; j++) {
            count += model->faces[i].corner[j].normal == MODEL_NONE;
        }
    }
    return count;
}

bool model_need_normals(struct model *model, struct error *error) {
    size_t bare = count_bare_corners(model);
    if (bare == 0) {
        return true;
    }
    size_t most = bare < model->position_count ? bare : model->position_count; /* new normals */
    struct vec3 *sums = calloc(model->position_count, sizeof *sums);
    uint32_t *normal_of = malloc(model->position_count * sizeof *normal_of); /* a position's */
    bool fits = most < MODEL_NONE - model->normal_count &&
                most + model->normal_count <= SIZE_MAX / sizeof *model->normals;
    void *grown =
        fits ? realloc(model->normals, (model->normal_count + most) * sizeof *model->normals)
             : NULL;
    if (grown != NULL) {
        model->normals = grown;
    }
    if (sums == NULL || normal_of == NULL || grown == NULL) {
        out_of_memory(error);
        goto fail;
    }
    for (size_t i = 0; i < model->position_count; i++) {
        normal_of[i] = MODEL_NONE;
    }
    for (size_t i = 0; i < model->face_count; i++) {
        add_face_normal(model, i, sums);
    }
    for (size_t i = 0; i < model->face_count; i++) {
        for (int j = 0; j < 3; j++) {
            struct corner *corner = &model->faces[i].corner[j];
            if (corner->normal != MODEL_NONE) {
                continue;
            }
            if (normal_of[corner->position] == MODEL_NONE) {
                normal_of[corner->position] = append_normal(model, sums[corner->position]);
            }
            corner->normal = normal_of[corner->position];
        }
    }
    free(sums);
    free(normal_of);
    return true;
fail:
    free(sums);
    free(normal_of);
    return false;
}

bool model_colors_from_normals(struct model *model, struct error *error) {
    if (!model_need_normals(model, error)) {
        return false;
    }
    if (model->colors == NULL) {
        model->colors = calloc(model->position_count, sizeof *model->colors);
        if (model->colors == NULL) {
            return out_of_memory(error);
        }
    }
    for (size_t i = 0; i < model->position_count; i++) {
        model->colors[i][0] = model->colors[i][1] = model->colors[i][2] = 0.5F;
    }
    for (size_t i = model->face_count; i-- > 0;) { /* downwards: the first face has the last word */
        for (size_t j = 3; j-- > 0;) {
            struct vec3 normal = vec3_normalized(model_normal(model, i, j));
            float *color = model->colors[model->faces[i].corner[j].position];
            color[0] = clamped_to_one((float)((normal.x + 1) / 2));
            color[1] = clamped_to_one((float)((normal.y + 1) / 2));
            color[2] = clamped_to_one((float)((normal.z + 1) / 2));
        }
    }
    return true;
}

/* ---- Textures ---- */

/* "DIRECTORY/NAME" + suffix for a model at "DIRECTORY/NAME.obj"; the caller frees it. */
static char *texture_path(const char *model_path, const char *suffix) {
    const char *slash = strrchr(model_path, '/');
    const char *name = slash == NULL ? model_path : slash + 1;
    const char *dot = strrchr(name, '.');
    size_t length = dot == NULL || dot == name ? strlen(model_path) : (size_t)(dot - model_path);
    char *path = malloc(length + strlen(suffix) + 1);
    if (path != NULL) {
        memcpy(path, model_path, length);
        memcpy(path + length, suffix, strlen(suffix) + 1);
    }
    return path;
}

static bool file_is_missing(const char *path) {
    FILE *file = fopen(path, "rb");
    if (file == NULL) {
        return errno == ENOENT;
    }
    fclose(file);
    return false;
}

static bool read_texture_file(struct texture *texture, const char *path, bool png,
                              struct error *error) {
    struct image image;
    if (!(png ? png_read(&image, path, error) : tga_read(&image, path, error))) {
        return false;
    }
    bool done = texture_create(texture, &image, error) || error_name_file(error, path);
    image_free(&image);
    return done;
}

const struct texture *model_texture(struct model *model, enum model_texture_kind kind,
                                    struct error *error) {
    static const char *const tga_suffix[] = {"_diffuse.tga", "_nm.tga", "_spec.tga"};
    static const char *const png_suffix[] = {"_diffuse.png", "_nm.png", "_spec.png"};
    struct texture *texture = &model->textures[kind];
    if (texture->level_count > 0) {
        return texture;
    }
    if (model->path == NULL) {
        error_set(error, "a model that was not read from a file has no textures");
        return NULL;
    }
    char *tga_path = texture_path(model->path, tga_suffix[kind]);
    char *png_path = texture_path(model->path, png_suffix[kind]);
    bool done = false;
    if (tga_path == NULL || png_path == NULL) {
        out_of_memory(error);
    } else if (!file_is_missing(tga_path)) {
        done = read_texture_file(texture, tga_path, false, error);
    } else if (!file_is_missing(png_path)) {
        done = read_texture_file(texture, png_path, true, error);
    } else {
        error_set(error, "no such file, nor the same as .png");
        error_name_file(error, tga_path);
    }
    free(tga_path);
    free(png_path);
    return done ? texture : NULL;
}
