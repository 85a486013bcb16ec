/* Polygons cut into triangles, against exact areas and sides. */
#include "files/polygon.h"

#include "oracle/oracle.h"
#include "unit/images.h"

#include <time.h>

static struct random random_state = {1};

static int random_int(int least, int most) { /* both inclusive */
    return (int)random_between(&random_state, least, most);
}

/* ---- Polygons ---- */

enum { CORNER_LIMIT = 64 };

/* Whole-number corners, so that areas and sides are exact. */
struct polygon {
    size_t size;
    int64_t x[CORNER_LIMIT], y[CORNER_LIMIT];
};

static void polygon_add(struct polygon *p, int64_t x, int64_t y) {
    p->x[p->size] = x;
    p->y[p->size++] = y;
}

/* Twice the area of three corners; positive when counterclockwise. */
static int128 area_of(const struct polygon *p, size_t a, size_t b, size_t c) {
    int128 left = (int128)(p->x[b] - p->x[a]) * (p->y[c] - p->y[a]);
    return left - (int128)(p->y[b] - p->y[a]) * (p->x[c] - p->x[a]);
}

static int128 polygon_area(const struct polygon *p) {
    int128 area = 0;
    for (size_t i = 0; i < p->size; i++) {
        size_t next = (i + 1) % p->size;
        area += (int128)p->x[i] * p->y[next] - (int128)p->y[i] * p->x[next];
    }
    return area;
}

/* A square whose hole is reached from the lower side and touches the outline's last corner, often
 * along a side of the outline, even the whole of it. */
static void make_touched(struct polygon *p) {
    int x1, y1, x2, y2, along = random_int(0, 7);
    do {
        x1 = along == 1 ? 0 : random_int(1, 30);
        y1 = along == 1 ? 0 : random_int(1, 30);
        x2 = along == 0 ? 31 : random_int(1, 30);
        y2 = along == 0 ? 31 : random_int(y1, 31);
    } while (x1 * (y2 - 31) - (y1 - 31) * x2 <= 0); /* the hole must go round clockwise */
    *p = (struct polygon){0};
    polygon_add(p, 0, 0);
    polygon_add(p, 15, 0);
    polygon_add(p, x1, y1);
    polygon_add(p, 0, 31);
    polygon_add(p, x2, y2);
    polygon_add(p, x1, y1);
    polygon_add(p, 15, 0);
    polygon_add(p, 31, 0);
    polygon_add(p, 31, 31);
    polygon_add(p, 0, 31);
}

/* ---- Any polygon that touches itself: triangles glued together along some of their sides ---- */

enum { GRID = 5, GRID_TRIANGLES = 2 * GRID * GRID };

/* Whole-number points in rows and columns; each square is cut one way or the other. */
struct tiling {
    int64_t x[(GRID + 1) * (GRID + 1)], y[(GRID + 1) * (GRID + 1)];
    int corner[GRID_TRIANGLES][3]; /* counterclockwise */
};

static void make_tiling(struct tiling *t) {
    int shift = random_int(0, 3); /* 0: many corners on one line */
    for (int i = 0; i < (GRID + 1) * (GRID + 1); i++) {
        t->x[i] = 20 * (i % (GRID + 1)) + random_int(-shift, shift);
        t->y[i] = 20 * (i / (GRID + 1)) + random_int(-shift, shift);
    }
    for (int i = 0; i < GRID * GRID; i++) {
        int a = i / GRID * (GRID + 1) + i % GRID, b = a + 1, c = a + GRID + 2, d = a + GRID + 1;
        const int cuts[2][2][3] = {{{a, b, c}, {a, c, d}}, {{a, b, d}, {b, c, d}}};
        memcpy(t->corner[2 * i], cuts[random_int(0, 1)], sizeof cuts[0]);
    }
}

/* The triangle, not yet used, on the other side of the side from p to q; -1 where there is none. */
static int find_beyond_side(const struct tiling *t, const bool *used, int p, int q, int *third) {
    for (int i = 0; i < GRID_TRIANGLES; i++) {
        for (int k = 0; k < 3 && !used[i]; k++) {
            if (t->corner[i][k] == q && t->corner[i][(k + 1) % 3] == p) {
                *third = t->corner[i][(k + 2) % 3];
                return i;
            }
        }
    }
    return -1;
}

/* Begin with a triangle and glue others to sides of the polygon, anywhere: it comes back to corners
 * and along sides that it has already, has holes and slits, and never crosses itself. */
static void make_glued(struct polygon *p) {
    static struct tiling t;
    bool used[GRID_TRIANGLES] = {false};
    int point[CORNER_LIMIT];
    int first = random_int(0, GRID_TRIANGLES - 1), wanted = random_int(4, 45);
    make_tiling(&t);
    memcpy(point, t.corner[first], sizeof t.corner[first]);
    used[first] = true;
    int size = 3;
    for (int tries = 0; size < wanted && tries < 400; tries++) {
        int side = random_int(0, size - 1), third;
        int found = find_beyond_side(&t, used, point[side], point[(side + 1) % size], &third);
        if (found >= 0) {
            memmove(point + side + 2, point + side + 1, (size_t)(size - side - 1) * sizeof *point);
            point[side + 1] = third;
            used[found] = true;
            size++;
        }
    }
    *p = (struct polygon){0};
    for (int i = 0; i < size; i++) {
        polygon_add(p, (int)t.x[point[i]], (int)t.y[point[i]]);
    }
}

/* ---- Cutting them ---- */

/* A polygon laid into space: `corner` says which of its corners each place is. */
struct laid {
    size_t size;
    struct vec3 places[CORNER_LIMIT];
    size_t corner[CORNER_LIMIT];
};

/* By one of six permutations of the axes, on a slanted plane, with any corner first, and scaled by
 * a power of two; often drawn out to be thin, or far from the origin. */
static struct laid lay(const struct polygon *p, bool backwards) {
    static const int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                     {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    struct laid laid = {.size = p->size};
    const int *order = orders[random_int(0, 5)];
    int a = random_int(-1, 1), b = random_int(-1, 1), longer = 1 << 20 * random_int(0, 1);
    int64_t away = random_int(-1, 1) * ((int64_t)1 << 40);
    int exponent = random_int(0, 1) == 1 ? random_int(-390, 340) : 0;
    size_t first = (size_t)random_int(0, (int)p->size - 1);
    for (size_t i = 0; i < p->size; i++) {
        size_t k = (first + (backwards ? p->size - i : i)) % p->size;
        int64_t x = longer * p->x[k], y = p->y[k];
        const int64_t whole[3] = {x, y, a * x + b * y};
        double place[3];
        for (int axis = 0; axis < 3; axis++) {
            place[axis] = ldexp((double)(whole[order[axis]] + away), exponent);
        }
        laid.places[i] = (struct vec3){place[0], place[1], place[2]};
        laid.corner[i] = k;
    }
    return laid;
}

static enum polygon_result cut(struct polygon_cutter *cutter, const struct laid *laid) {
    return polygon_cut(cutter, laid->places, laid->size);
}

/* The triangles cover the polygon exactly once: they are joined along the polygon's own sides and
 * cuts that two of them share (so their signed areas always add up to the polygon's), and none is
 * turned over (so they cannot overlap). */
static bool covers_exactly(const struct polygon *p, const struct laid *laid,
                           const struct polygon_cutter *cutter, bool backwards) {
    static int sides[CORNER_LIMIT][CORNER_LIMIT];
    int128 total = 0;
    memset(sides, 0, sizeof sides);
    for (size_t i = 0; i < cutter->triangle_count; i++) {
        size_t corner[3];
        for (int j = 0; j < 3; j++) {
            corner[j] = laid->corner[cutter->triangles[i][backwards ? 2 - j : j]];
        }
        int128 area = area_of(p, corner[0], corner[1], corner[2]);
        if (area < 0) {
            return false;
        }
        total += area;
        for (int j = 0; j < 3; j++) {
            sides[corner[j]][corner[(j + 1) % 3]]++;
            sides[corner[(j + 1) % 3]][corner[j]]--;
        }
    }
    for (size_t i = 0; i < p->size; i++) {
        sides[i][(i + 1) % p->size]--;
        sides[(i + 1) % p->size][i]++;
    }
    for (size_t i = 0; i < p->size; i++) {
        for (size_t j = 0; j < p->size; j++) {
            if (sides[i][j] != 0) {
                return false;
            }
        }
    }
    return total == polygon_area(p);
}

static void check_polygon(struct polygon_cutter *cutter, const struct polygon *p,
                          const char *kind) {
    bool backwards = random_int(0, 1) == 1;
    struct laid laid = lay(p, backwards);
    if (!CHECK_ROW(cut(cutter, &laid) == POLYGON_CUT, kind)) {
        return;
    }
    CHECK_ROW(cutter->triangle_count == p->size - 2, kind);
    if (!CHECK_ROW(covers_exactly(p, &laid, cutter, backwards), kind)) {
        for (size_t i = 0; i < laid.size; i++) {
            struct vec3 place = laid.places[i];
            fprintf(stderr, "    %.17g %.17g %.17g\n", place.x, place.y, place.z);
        }
    }
}

static void test_polygons(void) {
    struct polygon_cutter cutter = {0};
    struct polygon p;
    for (int i = 0; i < 1000; i++) {
        make_touched(&p);
        check_polygon(&cutter, &p, "touched");
        make_glued(&p);
        check_polygon(&cutter, &p, "glued");
    }
    polygon_cutter_free(&cutter);
}

/* Polygons that cross themselves, turn back or stay where they are: any answer will do, but
 * n - 2 triangles of three different corners are, soon. */
static void test_wild_polygons(void) {
    struct polygon_cutter cutter = {0};
    for (int i = 0; i < 2000; i++) {
        struct polygon p = {0};
        int size = random_int(4, CORNER_LIMIT), range = random_int(0, 6);
        for (int k = 0; k < size; k++) {
            polygon_add(&p, random_int(0, range), random_int(0, range));
        }
        struct laid laid = lay(&p, false);
        for (size_t k = 0; i % 2 == 1 && k < laid.size; k++) { /* down to nothing */
            laid.places[k].x = ldexp(laid.places[k].x, random_int(0, 1) * random_int(-1100, 10));
            laid.places[k].z = ldexp(laid.places[k].z, random_int(0, 1) * random_int(-1100, 10));
        }
        CHECK(cut(&cutter, &laid) == POLYGON_CUT && cutter.triangle_count == p.size - 2);
        for (size_t k = 0; k < cutter.triangle_count; k++) {
            const uint32_t *c = cutter.triangles[k];
            CHECK(c[0] != c[1] && c[1] != c[2] && c[0] != c[2]);
            CHECK(c[0] < p.size && c[1] < p.size && c[2] < p.size);
        }
    }
    polygon_cutter_free(&cutter);
}

/* ---- Chosen ones ---- */

/* The triangles as text: "0 1 2, 0 2 3". */
static void describe(const struct polygon_cutter *cutter, char *out, size_t room) {
    size_t used = 0;
    out[0] = '\0';
    for (size_t i = 0; i < cutter->triangle_count; i++) {
        const uint32_t *c = cutter->triangles[i];
        used += (size_t)snprintf(out + used, room - used, "%s%" PRIu32 " %" PRIu32 " %" PRIu32,
                                 i > 0 ? ", " : "", c[0], c[1], c[2]);
    }
}

static void test_chosen_polygons(void) {
    static const struct {
        const char *name, *triangles;
        size_t size;
        struct vec3 corners[8];
    } rows[] = {
        {"triangle", "0 1 2", 3, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
        {"no triangle", "0 1 2", 3, {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}},
        {"square", "0 1 2, 0 2 3", 4, {{0, 0, 5}, {1, 0, 5}, {1, 1, 5}, {0, 1, 5}}},
        {"seen from behind", "0 1 2, 0 2 3", 4, {{0, 1, 5}, {1, 1, 5}, {1, 0, 5}, {0, 0, 5}}},
        {"arrow", "0 1 2, 0 2 3", 4, {{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}}},
        {"arrow from its inner corner",
         "0 1 2, 0 2 3",
         4,
         {{1, 1, 0}, {0, 4, 0}, {0, 0, 0}, {4, 0, 0}}},
        {"arrow from its tip", "1 2 3, 1 3 0", 4, {{4, 0, 0}, {1, 1, 0}, {0, 4, 0}, {0, 0, 0}}},
        {"dent of almost 0", "0 1 2, 0 2 3", 4, {{0, 0, 0}, {1, 1e-10, 0}, {2, 0, 0}, {1, 3, 0}}},
        {"dent", "1 2 3, 1 3 0", 4, {{0, 0, 0}, {1, 1e-8, 0}, {2, 0, 0}, {1, 3, 0}}},
        {"on a line", "0 1 2, 0 2 3", 4, {{0, 0, 0}, {2, 2, 2}, {1, 1, 1}, {3, 3, 3}}},
        /* Not flat, and seen from above it is convex; from the right it is not. */
        {"facing up", "0 1 2, 0 2 3", 4, {{1, 3, 3}, {2, 1, 3}, {1, 3, 1}, {0, 2, 2}}},
        /* An arrow with a spike in each half: once cut off, neither is in the way. */
        {"spikes inside",
         "1 2 3, 1 3 4, 5 6 7, 5 7 0, 4 5 0, 4 0 1",
         8,
         {{0, 0, 0}, {8, 0, 0}, {3, 1, 0}, {8, 0, 0}, {2, 2, 0}, {0, 8, 0}, {1, 3, 0}, {0, 8, 0}}},
        {"in one place",
         "0 1 2, 0 2 3, 0 3 4",
         5,
         {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}},
    };
    struct polygon_cutter cutter = {0};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        char triangles[100];
        CHECK_ROW(polygon_cut(&cutter, rows[i].corners, rows[i].size) == POLYGON_CUT, rows[i].name);
        describe(&cutter, triangles, sizeof triangles);
        CHECK_ROW(CHECK_TEXT(triangles, rows[i].triangles), rows[i].name);
    }
    polygon_cutter_free(&cutter);
    CHECK(cutter.triangles == NULL && cutter.triangle_count == 0 && cutter.nodes == NULL);
}

/* ---- Large ones ---- */

/* The areas of all triangles, which are more than the polygon's where one is turned over. */
static double sum_areas(const struct polygon_cutter *cutter, const struct vec3 *places) {
    double sum = 0;
    for (size_t i = 0; i < cutter->triangle_count; i++) {
        const uint32_t *c = cutter->triangles[i];
        struct vec3 a = places[c[0]], p = vec3_sub(places[c[1]], a), q = vec3_sub(places[c[2]], a);
        sum += fabs(p.x * q.y - p.y * q.x) / 2;
    }
    return sum;
}

/* With nine digits, as programs write them, of which half of the corners of a circle are dents. */
static struct vec3 on_circle(size_t i, size_t size, double radius) {
    double angle = 6.283185307179586 * (double)i / (double)size;
    return (struct vec3){floor(radius * cos(angle) * 1e9) / 1e9,
                         floor(radius * sin(angle) * 1e9) / 1e9, 0};
}

static struct vec3 cap(size_t i, size_t size) {
    return on_circle(i, size, 0.33);
}

static struct vec3 gear(size_t i, size_t size) {
    return on_circle(i, size, i / 4 % 2 == 0 ? 0.33 : 0.3);
}

/* Its teeth end on one line. */
static struct vec3 comb(size_t i, size_t size) {
    double x = 1 - (double)i / (double)(size - 2);
    return i + 2 < size ? (struct vec3){x, i % 4 < 2 ? 1 : 0.5, 0}
                        : (struct vec3){i + 1 < size ? 0 : 1, 0, 0};
}

/* Around a corner far above it, where each ear ends: all others may be in its way. */
static struct vec3 bowl(size_t i, size_t size) {
    double x = (double)i / (double)(size - 2);
    return i + 1 < size ? (struct vec3){x, x * (1 - x), 0} : (struct vec3){0.5, 10, 0};
}

/* Out and back: there are few ears at a time. */
static struct vec3 spiral(size_t i, size_t size) {
    bool out = i < size / 2;
    double angle = 2 + 120 * (double)(out ? i : size - 1 - i) / (double)size;
    double radius = out ? angle : angle - 1;
    return (struct vec3){radius * cos(angle), radius * sin(angle), 0};
}

/* Up to the limit polygons are cut before long; a cutter goes on after one that is too large. */
static void test_many_corners(void) {
    static const struct {
        struct vec3 (*corner)(size_t i, size_t size);
        size_t size;
        enum polygon_result result;
    } rows[] = {
        {cap, 200000, POLYGON_CUT},
        {gear, POLYGON_CORNER_LIMIT + 1, POLYGON_TOO_LARGE},
        {spiral, POLYGON_CORNER_LIMIT, POLYGON_CUT},
        {gear, 4000, POLYGON_CUT},
        {comb, 4000, POLYGON_CUT},
        {bowl, 4000, POLYGON_CUT},
    };
    struct vec3 *places = new_memory(rows[0].size * sizeof *places);
    struct polygon_cutter cutter = {0};
    for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++) {
        const size_t size = rows[k].size;
        bool done = rows[k].result == POLYGON_CUT;
        double area = 0;
        for (size_t i = 0; i < size; i++) {
            places[i] = rows[k].corner(i, size);
        }
        for (size_t i = 0; i < size; i++) {
            struct vec3 a = places[i], b = places[(i + 1) % size];
            area += (a.x * b.y - a.y * b.x) / 2;
        }
        clock_t start = clock();
        CHECK(polygon_cut(&cutter, places, size) == rows[k].result);
        CHECK(clock() - start < 15 * CLOCKS_PER_SEC); /* and is far below it */
        CHECK(cutter.triangle_count == (done ? size - 2 : 0));
        CHECK(!done || fabs(sum_areas(&cutter, places) / area - 1) < 1e-9);
    }
    polygon_cutter_free(&cutter);
    free(places);
}

UNIT_MAIN(TEST(test_polygons), TEST(test_wild_polygons), TEST(test_chosen_polygons),
          TEST(test_many_corners))
