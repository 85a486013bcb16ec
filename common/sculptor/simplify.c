/*
 * Quadric edge collapse on the grid of a surface: see simplify.h.
 *
 * All the grid's triangles are the start. Again and again the cheapest edge is collapsed: one of
 * its ends moves onto the other one, and the two triangles at the edge vanish. A vertex
 * remembers, as a quadric form, the planes of all triangles that were merged into it; the price of
 * a collapse is the sum of squared distances to these planes, weighted by area and by how closely
 * people look at that part of the body. So flat parts become large triangles and the eyelids stay
 * fine.
 *
 * A vertex only ever moves onto another grid point, so every corner keeps its exact texture
 * coordinate. Ties are broken by vertex numbers: the result never hangs on chance.
 */
#include "sculptor/simplify.h"

#include "base/array.h"

#include <assert.h>
#include <stdlib.h>

enum { NONE = -1, VALENCE_LIMIT = 11, NEIGHBOUR_LIMIT = 64 };

/* x'Ax + 2b'x + c for a symmetric A: the weighted squared distances to a set of planes. */
enum { XX, XY, XZ, X, YY, YZ, Y, ZZ, Z, ONE, TERMS };

struct quadric {
    double term[TERMS];
};

/* A possible collapse of vertex `from` onto `to`; out of date when its price has changed since. */
struct collapse {
    double price;
    int from, to;
};

struct vertex {
    struct vec3 place;
    double importance;
    struct quadric quadric;
    int first_corner; /* 3 * triangle + 0..2, or NONE */
};

struct workshop {
    const struct surface *surface;
    struct vertex *vertices; /* one a grid point */
    struct grid_triangle *triangles;
    size_t triangle_count, alive_count;
    int *next_corner; /* the next corner at the same vertex, or NONE */
    struct collapse *heap;
    size_t heap_count, heap_capacity;
};

/* ---- The price ---- */

/* How closely people look here. */
static double importance(struct vec3 p) {
    double face = ramp(-0.30, -0.15, p.y) * fall(0.60, 0.72, p.y) * ramp(0.0, 0.25, p.z);
    double eye = hill(p, at(0.157, 0.36, 0.38), at(0.13, 0.09, 0.2));
    double pupil = hill(p, at(0.157, 0.35, 0.38), at(0.045, 0.045, 0.1));
    double mouth = hill(p, at(0, 0.06, 0.48), at(0.20, 0.20, 0.3));
    double ear = ramp(0.37, 0.39, p.x) * fall(0.42, 0.46, p.y) * ramp(0.05, 0.12, p.y);
    double fringe = ramp(0.62, 0.70, p.y) * ramp(0.0, 0.2, p.z);
    double crown = ramp(0.80, 0.92, p.y);
    return 0.16 + 0.3 * crown + 0.25 * fringe + 1.5 * face + 5 * eye + 30 * pupil + 3 * mouth +
           1.2 * ear;
}

static void quadric_add(struct quadric *sum, const struct quadric *added) {
    for (int i = 0; i < TERMS; i++) {
        sum->term[i] += added->term[i];
    }
}

static struct quadric quadric_of_plane(struct vec3 normal, double offset, double weight) {
    const double plane[4] = {normal.x, normal.y, normal.z, offset};
    struct quadric quadric = {{0}};
    for (int i = 0, term = 0; i < 4; i++) {
        for (int k = i; k < 4; k++) {
            quadric.term[term++] = weight * plane[i] * plane[k];
        }
    }
    return quadric;
}

static double quadric_at(const struct quadric *quadric, struct vec3 p) {
    const double *q = quadric->term;
    double a = q[XX] * p.x + 2 * (q[XY] * p.y + q[XZ] * p.z + q[X]);
    double b = q[YY] * p.y + 2 * (q[YZ] * p.z + q[Y]);
    return a * p.x + b * p.y + (q[ZZ] * p.z + 2 * q[Z]) * p.z + q[ONE];
}

static double price_of(const struct workshop *w, int from, int to) {
    const struct vertex *moved = &w->vertices[from], *target = &w->vertices[to];
    struct vec3 way = vec3_sub(moved->place, target->place);
    double price =
        quadric_at(&moved->quadric, target->place) + quadric_at(&target->quadric, target->place);
    /* On flat ground short edges go first. */
    return price + 2e-9 * vec3_dot(way, way) * target->importance;
}

/* ---- The heap of collapses, cheapest first ---- */

static bool cheaper(const struct collapse *a, const struct collapse *b) {
    if (a->price < b->price || a->price > b->price) {
        return a->price < b->price;
    }
    return a->from != b->from ? a->from < b->from : a->to < b->to;
}

static bool heap_push(struct workshop *w, struct collapse entry) {
    if (!array_extend(&w->heap, &w->heap_capacity, w->heap_count + 1, sizeof *w->heap)) {
        return false;
    }
    size_t i = w->heap_count++;
    while (i > 0 && cheaper(&entry, &w->heap[(i - 1) / 2])) {
        w->heap[i] = w->heap[(i - 1) / 2];
        i = (i - 1) / 2;
    }
    w->heap[i] = entry;
    return true;
}

static struct collapse heap_pop(struct workshop *w) {
    struct collapse top = w->heap[0], last = w->heap[--w->heap_count];
    size_t i = 0, child;
    for (; (child = 2 * i + 1) < w->heap_count; i = child) {
        if (child + 1 < w->heap_count && cheaper(&w->heap[child + 1], &w->heap[child])) {
            child++;
        }
        if (!cheaper(&w->heap[child], &last)) {
            break;
        }
        w->heap[i] = w->heap[child];
    }
    w->heap[i] = last;
    return top;
}

/* ---- What may collapse ---- */

static bool has_corner(const struct grid_triangle *t, int vertex) {
    return t->corner[0] == vertex || t->corner[1] == vertex || t->corner[2] == vertex;
}

static bool is_alive(const struct grid_triangle *t) {
    return t->corner[0] != NONE;
}

/* The vertices around one vertex, each once; returns their number. */
static int neighbours(const struct workshop *w, int vertex, int found[NEIGHBOUR_LIMIT]) {
    int count = 0;
    for (int c = w->vertices[vertex].first_corner; c != NONE; c = w->next_corner[c]) {
        const struct grid_triangle *t = &w->triangles[c / 3];
        if (!is_alive(t)) {
            continue;
        }
        for (int k = 1; k <= 2; k++) {
            int other = t->corner[(c % 3 + k) % 3], i = 0;
            while (i < count && found[i] != other) {
                i++;
            }
            if (i == count && count < NEIGHBOUR_LIMIT) {
                found[count++] = other;
            }
        }
    }
    return count;
}

static struct vec3 area_vector(const struct workshop *w, const struct grid_triangle *t) {
    const struct vertex *v = w->vertices;
    struct vec3 a = v[t->corner[0]].place;
    return vec3_cross(vec3_sub(v[t->corner[1]].place, a), vec3_sub(v[t->corner[2]].place, a));
}

/* Twice the area in the texture, in half grid cells. A pole is midway over its two partners. */
static int area_in_texture(const struct workshop *w, const struct grid_triangle *t) {
    int x[3], y[3];
    for (int k = 0; k < 3; k++) {
        x[k] = 2 * surface_column(w->surface, t->corner[k]);
        y[k] = surface_row(w->surface, t->corner[k]);
    }
    for (int k = 0; k < 3; k++) {
        if (surface_is_pole(w->surface, t->corner[k])) {
            x[k] = (x[(k + 1) % 3] + x[(k + 2) % 3]) / 2;
        }
    }
    return (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
}

/* 1 for an equilateral triangle, 0 for one without area. */
static double roundness(const struct workshop *w, const struct grid_triangle *t,
                        double twice_area) {
    double sum = 0;
    for (int k = 0; k < 3; k++) {
        struct vec3 edge =
            vec3_sub(w->vertices[t->corner[(k + 1) % 3]].place, w->vertices[t->corner[k]].place);
        sum += vec3_dot(edge, edge);
    }
    return 3.4641016151377544 * twice_area / sum;
}

/* Would the triangle stay fair when its corner `from` moves onto `to`? */
static bool stays_fair(const struct workshop *w, const struct grid_triangle *t, int from, int to) {
    struct grid_triangle moved = *t;
    for (int k = 0; k < 3; k++) {
        moved.corner[k] = moved.corner[k] == from ? to : moved.corner[k];
    }
    if (area_in_texture(w, &moved) < 2) {
        return false;
    }
    struct vec3 before = area_vector(w, t), after = area_vector(w, &moved);
    double length_before = vec3_length(before), length_after = vec3_length(after);
    if (vec3_dot(before, after) < 0.35 * length_before * length_after || length_after < 1e-12) {
        return false;
    }
    double round = roundness(w, &moved, length_after);
    return round > 0.22 || round > 0.8 * roundness(w, t, length_before);
}

static bool may_collapse(const struct workshop *w, int from, int to) {
    int around_from[NEIGHBOUR_LIMIT], around_to[NEIGHBOUR_LIMIT];
    int from_count = neighbours(w, from, around_from);
    int to_count = neighbours(w, to, around_to);
    int common = 0, shared = 0;
    for (int i = 0; i < from_count; i++) {
        for (int j = 0; j < to_count; j++) {
            common += around_from[i] == around_to[j];
        }
    }
    for (int c = w->vertices[from].first_corner; c != NONE; c = w->next_corner[c]) {
        const struct grid_triangle *t = &w->triangles[c / 3];
        if (!is_alive(t)) {
            continue;
        }
        if (has_corner(t, to)) {
            shared++;
        } else if (!stays_fair(w, t, from, to)) {
            return false;
        }
    }
    /* An edge in the mirror has one triangle on this side. Only the corners opposite the edge may
     * be neighbours of both ends: else sheets touch. */
    return shared > 0 && (shared == 1 || !surface_is_in_mirror(w->surface, from)) &&
           common == shared && from_count + to_count - 4 <= VALENCE_LIMIT;
}

/* A pole stays where it is, and what lies in the mirror stays there. */
static bool may_move(const struct workshop *w, int from, int to) {
    return !surface_is_pole(w->surface, from) &&
           (!surface_is_in_mirror(w->surface, from) || surface_is_in_mirror(w->surface, to));
}

/* Put an edge on the heap, to be collapsed in the cheaper direction of those allowed. */
static bool offer_edge(struct workshop *w, int a, int b) {
    bool a_stays = !may_move(w, a, b), b_stays = !may_move(w, b, a);
    struct collapse there = {price_of(w, a, b), a, b}, back = {price_of(w, b, a), b, a};
    if (a_stays && b_stays) {
        return true;
    }
    return heap_push(w, a_stays || (!b_stays && cheaper(&back, &there)) ? back : there);
}

static bool push_edges_of(struct workshop *w, int vertex) {
    int around[NEIGHBOUR_LIMIT];
    int count = neighbours(w, vertex, around);
    for (int i = 0; i < count; i++) {
        if (!offer_edge(w, vertex, around[i])) {
            return false;
        }
    }
    return true;
}

static bool do_collapse(struct workshop *w, int from, int to) {
    int c = w->vertices[from].first_corner;
    while (c != NONE) {
        int next = w->next_corner[c];
        struct grid_triangle *t = &w->triangles[c / 3];
        if (is_alive(t) && has_corner(t, to)) {
            t->corner[0] = NONE;
            w->alive_count--;
        } else if (is_alive(t)) {
            t->corner[c % 3] = to;
            w->next_corner[c] = w->vertices[to].first_corner;
            w->vertices[to].first_corner = c;
        }
        c = next;
    }
    w->vertices[from].first_corner = NONE;
    quadric_add(&w->vertices[to].quadric, &w->vertices[from].quadric);
    return push_edges_of(w, to);
}

/* ---- Setting up ---- */

static void add_triangle(struct workshop *w, int a, int b, int c) {
    int t = (int)w->triangle_count++;
    w->triangles[t] = (struct grid_triangle){{a, b, c}};
    for (int k = 0; k < 3; k++) {
        int vertex = w->triangles[t].corner[k];
        w->next_corner[3 * t + k] = w->vertices[vertex].first_corner;
        w->vertices[vertex].first_corner = 3 * t + k;
    }
}

static void add_grid(struct workshop *w) {
    const struct surface *s = w->surface;
    int south = surface_index(s, 0, 0), north = surface_index(s, 0, s->rows);
    for (int row = 0; row < s->rows; row++) {
        for (int column = 0; column < s->columns; column++) {
            int a = surface_index(s, column, row), b = a + 1;
            int d = surface_index(s, column, row + 1), c = d + 1;
            if (row == 0) {
                add_triangle(w, south, c, d);
            } else if (row == s->rows - 1) {
                add_triangle(w, a, b, north);
            } else {
                add_triangle(w, a, b, c);
                add_triangle(w, a, c, d);
            }
        }
    }
    w->alive_count = w->triangle_count;
}

static void measure_planes(struct workshop *w) {
    for (size_t i = 0; i < w->triangle_count; i++) {
        const struct grid_triangle *t = &w->triangles[i];
        struct vec3 normal = area_vector(w, t);
        double area = vec3_length(normal);
        normal = vec3_normalized(normal);
        const struct vertex *first = &w->vertices[t->corner[0]];
        struct quadric q =
            quadric_of_plane(normal, -vec3_dot(normal, first->place), area * first->importance);
        struct quadric image = q; /* of the triangle on the other side of the mirror */
        image.term[XY] = -q.term[XY];
        image.term[XZ] = -q.term[XZ];
        image.term[X] = -q.term[X];
        for (int k = 0; k < 3; k++) {
            quadric_add(&w->vertices[t->corner[k]].quadric, &q);
            if (surface_is_in_mirror(w->surface, t->corner[k])) {
                quadric_add(&w->vertices[t->corner[k]].quadric, &image);
            }
        }
    }
}

static bool workshop_create(struct workshop *w, const struct surface *surface) {
    size_t vertex_count = ((size_t)surface->columns + 1) * ((size_t)surface->rows + 1);
    size_t most = 2 * (size_t)surface->columns * (size_t)surface->rows;
    *w = (struct workshop){
        .surface = surface,
        .vertices = calloc(vertex_count, sizeof *w->vertices),
        .triangles = malloc(most * sizeof *w->triangles),
        .next_corner = malloc(3 * most * sizeof *w->next_corner),
    };
    if (w->vertices == NULL || w->triangles == NULL || w->next_corner == NULL) {
        return false;
    }
    for (size_t i = 0; i < vertex_count; i++) {
        struct vec3 place = surface->points[i].place;
        w->vertices[i] =
            (struct vertex){.place = place, .importance = importance(place), .first_corner = NONE};
    }
    add_grid(w);
    measure_planes(w);
    for (size_t i = 0; i < w->triangle_count; i++) {
        const int *corner = w->triangles[i].corner;
        for (int k = 0; k < 3; k++) {
            int a = corner[k], b = corner[(k + 1) % 3];
            bool once = a < b || (surface_is_in_mirror(w->surface, a) &&
                                  surface_is_in_mirror(w->surface, b));
            if (once && !offer_edge(w, a, b)) { /* the other triangle has the edge the other way */
                return false;
            }
        }
    }
    return true;
}

bool simplify(const struct surface *surface, size_t target, struct grid_triangle **triangles,
              size_t *count) {
    assert(surface->columns > 0 && surface->rows > 0);
    struct workshop w;
    bool done = workshop_create(&w, surface);
    while (done && w.alive_count > target && w.heap_count > 0) {
        struct collapse best = heap_pop(&w);
        if (price_of(&w, best.from, best.to) <= best.price &&
            may_collapse(&w, best.from, best.to)) {
            done = do_collapse(&w, best.from, best.to);
        }
    }
    *count = 0;
    for (size_t i = 0; done && i < w.triangle_count; i++) {
        if (is_alive(&w.triangles[i])) {
            w.triangles[(*count)++] = w.triangles[i];
        }
    }
    *triangles = w.triangles;
    free(w.vertices);
    free(w.next_corner);
    free(w.heap);
    return done;
}
