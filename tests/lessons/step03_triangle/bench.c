/*
 * Lesson 3's benchmark: ways to fill a triangle, on a mesh of small ones and on a fan of large
 * ones that reach far beyond the image, and what it costs to snap corners. Every other side of the
 * fan goes through many pixel centres; the values at the rest need more digits than a float has.
 *
 * All versions write rows with image_fill_row(). Each triangle has a colour of its own, and each
 * version too: so the picture of the last run tells which triangle it shows at each pixel. The
 * error counts pixels that show another one than 128-bit integers say.
 */
#define main step03_main
int step03_main(int argc, char **argv);
#include "../../../step03_triangle/main.c"
#undef main

#include "../../../step03_triangle/attempts.h"

#include "bench/bench.h"
#include "oracle/oracle.h"

#include <stdlib.h>

enum {
    SIDE = 800,        /* of the image */
    LARGE_COUNT = 24,  /* triangles of the fan */
    LARGE_REACH = 4008 /* pixels from its middle to its rim, in x or in y */
};

/* ---- Meshes, and which triangle each pixel shows ---- */

struct filled {
    struct fixed2 snapped[3];
    struct vec2 corner[3]; /* pixels; where the mesh is not `snapped`, finer than 1/256 */
};

struct mesh {
    struct filled *triangles;
    size_t count;
    uint32_t *shown;    /* triangle + 1 at each pixel of the image, 0 for none */
    size_t pixel_count; /* that show one */
};

enum { SMALL, LARGE, UNSNAPPED, MESH_COUNT };

struct fill_bench {
    struct mesh meshes[MESH_COUNT];
    struct image image; /* IMAGE_BGR, as the scenes are */
};

/* A corner in units of 2^-46 pixel, which all corners here are whole numbers of. With images of 800
 * pixels and corners at most 2^13 away, products stay below 2^120. */
struct exact2 {
    int128 x, y;
};

enum { EXACT_BITS = 46 };

static struct exact2 exact_corner(struct vec2 p) {
    return (struct exact2){(int128)ldexp(p.x, EXACT_BITS), (int128)ldexp(p.y, EXACT_BITS)};
}

/* On which side of p-q a point is, once it is shifted by an infinitely small step to the right, and
 * a still smaller one down: 1 left, -1 right. */
static int exact_side(struct exact2 p, struct exact2 q, struct exact2 point) {
    int128 side = (q.x - p.x) * (point.y - p.y) - (q.y - p.y) * (point.x - p.x);
    if (side == 0) {
        side = q.y != p.y ? p.y - q.y : p.x - q.x;
    }
    return (side > 0) - (side < 0);
}

static bool exact_covers(const struct exact2 p[3], int x, int y) {
    const int128 pixel = (int128)1 << EXACT_BITS;
    struct exact2 center = {x * pixel + pixel / 2, y * pixel + pixel / 2};
    int side = exact_side(p[0], p[1], center);
    return side != 0 && exact_side(p[1], p[2], center) == side &&
           exact_side(p[2], p[0], center) == side;
}

/* Pixels that a coordinate may be in, and one more on either side. */
static struct span pixels_around(double a, double b, double c) {
    double begin = floor(fmin(a, fmin(b, c))) - 1, end = floor(fmax(a, fmax(b, c))) + 2;
    return (struct span){(int)fmin(fmax(begin, 0), SIDE), (int)fmin(fmax(end, 0), SIDE)};
}

/* The triangles in their order, each over those before it. */
static bool mesh_find_shown(struct mesh *mesh, struct error *error) {
    mesh->shown = calloc((size_t)SIDE * SIDE, sizeof *mesh->shown);
    if (mesh->shown == NULL || mesh->triangles == NULL) {
        return error_set(error, "out of memory for a picture");
    }
    for (size_t i = 0; i < mesh->count; i++) {
        const struct vec2 *p = mesh->triangles[i].corner;
        const struct exact2 corner[3] = {exact_corner(p[0]), exact_corner(p[1]),
                                         exact_corner(p[2])};
        struct span columns = pixels_around(p[0].x, p[1].x, p[2].x);
        struct span rows = pixels_around(p[0].y, p[1].y, p[2].y);
        for (int y = rows.begin; y < rows.end; y++) {
            for (int x = columns.begin; x < columns.end; x++) {
                if (exact_covers(corner, x, y)) {
                    mesh->shown[y * SIDE + x] = (uint32_t)i + 1;
                }
            }
        }
    }
    for (size_t i = 0; i < (size_t)SIDE * SIDE; i++) {
        mesh->pixel_count += mesh->shown[i] != 0;
    }
    return true;
}

static bool mesh_allocate(struct mesh *mesh, size_t limit, struct error *error) {
    mesh->triangles = calloc(limit + 1, sizeof *mesh->triangles);
    return mesh->triangles != NULL || error_set(error, "out of memory for %zu triangles", limit);
}

static void mesh_add_snapped(struct mesh *mesh, const struct fixed2 corner[3]) {
    struct filled *t = &mesh->triangles[mesh->count++];
    for (int i = 0; i < 3; i++) {
        t->snapped[i] = corner[i];
        t->corner[i] = in_pixels(corner[i]);
    }
}

/* The faces of the bust that are turned to us: snapped, or as near to where they are as a double
 * can say. */
static bool make_bust(struct mesh *mesh, bool snapped, const struct image *image,
                      struct error *error) {
    struct model model;
    bool done =
        bench_read_model(&model, "bust.obj", error) && mesh_allocate(mesh, model.face_count, error);
    for (size_t face = 0; done && face < model.face_count; face++) {
        struct fixed2 corner[3];
        uint64_t turned_away = 0;
        if (!place_face(&model, face, image, corner, &turned_away)) {
            continue;
        }
        mesh_add_snapped(mesh, corner);
        for (size_t i = 0; i < 3 && !snapped; i++) {
            struct vec2 p = parallel_view(model_position(&model, face, i), SIDE, SIDE);
            mesh->triangles[mesh->count - 1].corner[i] =
                (struct vec2){ldexp(floor(ldexp(p.x, EXACT_BITS)), -EXACT_BITS),
                              ldexp(floor(ldexp(p.y, EXACT_BITS)), -EXACT_BITS)};
        }
    }
    model_free(&model);
    return done && mesh_find_shown(mesh, error);
}

/* The middle of the fan is a pixel centre, and so is every other corner on its rim, which lies
 * some whole number of times as far as a pixel centre near by: then many centres lie on the side
 * between. The rim is a square walked counterclockwise. */
static struct fixed2 large_corner(int i, struct random *random) {
    const int side = LARGE_COUNT / 4, center = SIDE / 2 * SUBPIXELS + SUBPIXELS / 2;
    int along = i % side * 2 - side; /* -side .. side - 2 along each side of the rim */
    int x = side, y = along;
    for (int turns = i / side % 4; turns > 0; turns--) {
        int kept = x;
        x = -y;
        y = kept;
    }
    int32_t scale = LARGE_REACH / side * SUBPIXELS;
    int32_t stray = i % 2 != 0 ? 0 : (int32_t)random_between(random, 1, scale / 2);
    return (struct fixed2){center + x * scale + stray, center + y * scale - stray};
}

static bool make_fan(struct mesh *mesh, struct error *error) {
    struct random random = {3};
    const struct fixed2 middle = {SIDE / 2 * SUBPIXELS + SUBPIXELS / 2,
                                  SIDE / 2 * SUBPIXELS + SUBPIXELS / 2};
    const struct fixed2 first = large_corner(0, &random);
    struct fixed2 last = first;
    if (!mesh_allocate(mesh, LARGE_COUNT, error)) {
        return false;
    }
    for (int i = 1; i <= LARGE_COUNT; i++) {
        struct fixed2 next = i < LARGE_COUNT ? large_corner(i, &random) : first;
        mesh_add_snapped(mesh, (const struct fixed2[3]){middle, last, next});
        last = next;
    }
    return mesh_find_shown(mesh, error);
}

/* ---- Spans without a division a row ---- */

/* The end of the span at one edge, floor(a / b) + 1 for an `a` that changes by the same from row to
 * row: whole quotient and remainder are carried along (the lesson's question 7). */
struct carried {
    int64_t quotient, remainder, step, step_remainder, divisor;
    bool is_begin; /* of the span; else its end */
};

static inline struct carried carried_from(const struct edge *e, int y) {
    int64_t missing = e->least - (e->origin + e->dy * y), divisor = llabs(e->dx);
    int64_t start = e->dx > 0 ? missing - 1 : -missing, change = e->dx > 0 ? -e->dy : e->dy;
    int64_t quotient = floor_divide(start, divisor), step = floor_divide(change, divisor);
    return (struct carried){
        quotient, start - quotient * divisor, step, change - step * divisor, divisor, e->dx > 0};
}

static inline void carried_next(struct carried *c) {
    c->quotient += c->step;
    c->remainder += c->step_remainder;
    bool full = c->remainder >= c->divisor;
    c->quotient += full;
    c->remainder -= full ? c->divisor : 0;
}

/* A horizontal edge leaves rows out as a whole: exactly those below or above it. */
static inline void narrow_rows(struct edges *edges, const struct edge *e) {
    for (; edges->y_begin < edges->y_end && e->origin + e->dy * edges->y_begin < e->least;
         edges->y_begin++) {
    }
    for (; edges->y_begin < edges->y_end && e->origin + e->dy * (edges->y_end - 1) < e->least;
         edges->y_end--) {
    }
}

static void fill_carried(struct image *image, const struct fixed2 corner[3], struct color color) {
    struct edges edges;
    struct carried ends[3];
    int count = 0;
    if (!triangle_setup(&edges, corner[0], corner[1], corner[2], image->width, image->height)) {
        return;
    }
    for (int i = 0; i < 3; i++) {
        if (edges.edge[i].dx == 0) {
            narrow_rows(&edges, &edges.edge[i]);
        }
    }
    for (int i = 0; i < 3; i++) {
        if (edges.edge[i].dx != 0) {
            ends[count++] = carried_from(&edges.edge[i], edges.y_begin);
        }
    }
    for (int y = edges.y_begin; y < edges.y_end; y++) {
        int64_t begin = 0, end = edges.width;
        for (int i = 0; i < count; i++) {
            int64_t border = ends[i].quotient + 1;
            begin = ends[i].is_begin && border > begin ? border : begin;
            end = !ends[i].is_begin && border < end ? border : end;
            carried_next(&ends[i]);
        }
        if (begin < end) {
            image_fill_row(image, y, (int)begin, (int)end, color);
        }
    }
}

/* ---- The attempts ---- */

enum { HOUSE = 0, CARRIED = 9 }; /* choices 1 to 8 are the attempts */

static void fill(const struct filled *t, int choice, struct target *target, struct color color) {
    static void (*const attempts[])(struct target *, const struct vec2[3], struct color) = {
        NULL,
        attempt_1_sweep_whole,
        attempt_2_sweep_float,
        attempt_3_box_float,
        attempt_4_box_double,
        attempt_5_box_open,
        attempt_6_box_epsilon,
        attempt_7_edges_float,
        attempt_8_blocks,
    };
    if (choice == HOUSE) {
        triangle(target->image, t->snapped, color);
    } else if (choice == CARRIED) {
        fill_carried(target->image, t->snapped, color);
    } else {
        attempts[choice](target, t->corner, color);
    }
}

/* ---- Corners snapped to fractions of a pixel, in numbers of all kinds ---- */

/* A triangle whose corners are snapped to `unit` steps a pixel, counted from the pixel (x,y): small
 * numbers need few digits. */
struct placed {
    int x, y;
    double unit;
    double corner_x[3], corner_y[3]; /* whole numbers, unless nothing is snapped */
    struct span rows;                /* counted from y: the centres between the corners */
};

static inline double fast_floor(double value) {
    int64_t whole = (int64_t)value;
    return (double)(whole - (value < (double)whole));
}

/* `bits` after the point; -1: not snapped. */
static inline struct placed place(const struct vec2 corner[3], int bits) {
    struct placed p = {
        (int)corner[0].x, (int)corner[0].y, bits < 0 ? 1 : (double)(1 << bits), {0}, {0}, {0, 0}};
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < 3; i++) {
        double x = (corner[i].x - p.x) * p.unit, y = (corner[i].y - p.y) * p.unit;
        p.corner_x[i] = bits < 0 ? x : fast_floor(x + 0.5);
        p.corner_y[i] = bits < 0 ? y : fast_floor(y + 0.5);
        low = p.corner_y[i] < low ? p.corner_y[i] : low;
        high = p.corner_y[i] > high ? p.corner_y[i] : high;
    }
    int begin = (int)-fast_floor(0.5 - low / p.unit),
        end = (int)fast_floor(high / p.unit - 0.5) + 1;
    p.rows = span_overlap((struct span){begin, end}, (struct span){-p.y, SIDE - p.y});
    return p;
}

/* Where value + dx * x becomes positive (`closed`: not negative), dx being positive: the first such
 * x. And where it ends for a negative dx: one after the last such x. */
#define DEFINE_ENDS_WHOLE(name, number)                                                            \
    static inline number quotient_##name(number a, number b) {                                     \
        number quotient = a / b;                                                                   \
        return quotient - (a % b < 0);                                                             \
    }                                                                                              \
    static inline int64_t first_##name(number value, number dx, bool closed) {                     \
        return (int64_t)quotient_##name((number)(-(int64_t)value - closed), dx) + 1;               \
    }                                                                                              \
    static inline int64_t end_##name(number value, number dx, bool closed) {                       \
        return (int64_t)quotient_##name((number)((int64_t)value - !closed),                        \
                                        (number)(-(int64_t)dx)) +                                  \
               1;                                                                                  \
    }                                                                                              \
    static inline number product_##name(number a, number b) {                                      \
        return (number)((uint64_t)a * (uint64_t)b);                                                \
    }

DEFINE_ENDS_WHOLE(int32, int32_t)
DEFINE_ENDS_WHOLE(int64, int64_t)

/* Comparisons are added, not branched on: which way they go nobody can guess. */
#define DEFINE_ENDS_REAL(name, number)                                                             \
    static inline number limited_##name(number value) {                                            \
        const number limit = 1 << 20; /* far outside of every image, and an int */                 \
        number least = value > -limit ? value : -limit;                                            \
        return least < limit ? least : limit;                                                      \
    }                                                                                              \
    static inline int64_t first_##name(number value, number dx, bool closed) {                     \
        number quotient = limited_##name(-value / dx);                                             \
        int whole = (int)quotient;                                                                 \
        return whole + ((number)whole < quotient) + (((number)whole == quotient) & !closed);       \
    }                                                                                              \
    static inline int64_t end_##name(number value, number dx, bool closed) {                       \
        number quotient = limited_##name(value / -dx);                                             \
        int whole = (int)quotient;                                                                 \
        return whole + 1 - ((number)whole > quotient) - (((number)whole == quotient) & !closed);   \
    }                                                                                              \
    static inline number product_##name(number a, number b) {                                      \
        return a * b;                                                                              \
    }

DEFINE_ENDS_REAL(float, float)
DEFINE_ENDS_REAL(double, double)

/* The edge functions of lesson 3 in numbers of one kind. Lengths are counted in half units, so that
 * the centre of a pixel is a whole number even where a unit is a pixel. */
#define DEFINE_FILL(name, number)                                                                  \
    static inline void fill_##name(struct image *image, struct placed p, struct color color) {     \
        number x[3], y[3], value[3], dx[3], dy[3];                                                 \
        bool closed[3];                                                                            \
        for (int i = 0; i < 3; i++) {                                                              \
            x[i] = (number)(2 * p.corner_x[i]);                                                    \
            y[i] = (number)(2 * p.corner_y[i]);                                                    \
        }                                                                                          \
        number area =                                                                              \
            product_##name(x[1] - x[0], y[2] - y[0]) - product_##name(y[1] - y[0], x[2] - x[0]);   \
        number pixel = (number)(2 * p.unit), center = (number)p.unit;                              \
        for (int i = 0; i < 3; i++) {                                                              \
            int from = (i + 1) % 3, to = (i + 2) % 3;                                              \
            number right = area > 0 ? x[to] - x[from] : x[from] - x[to];                           \
            number up = area > 0 ? y[to] - y[from] : y[from] - y[to];                              \
            value[i] =                                                                             \
                product_##name(right, center - y[from]) - product_##name(up, center - x[from]);    \
            dx[i] = product_##name(-up, pixel);                                                    \
            dy[i] = product_##name(right, pixel);                                                  \
            closed[i] = up < 0 || (up == 0 && right < 0);                                          \
        }                                                                                          \
        for (int row = p.rows.begin; row < p.rows.end && area != 0; row++) {                       \
            int64_t begin = -p.x, end = SIDE - p.x;                                                \
            for (int i = 0; i < 3; i++) {                                                          \
                number here = value[i] + product_##name(dy[i], (number)row);                       \
                if (dx[i] > 0) {                                                                   \
                    int64_t first = first_##name(here, dx[i], closed[i]);                          \
                    begin = first > begin ? first : begin;                                         \
                } else if (dx[i] < 0) {                                                            \
                    int64_t last = end_##name(here, dx[i], closed[i]);                             \
                    end = last < end ? last : end;                                                 \
                } else if (!(here > 0 || (here == 0 && closed[i]))) {                              \
                    end = begin;                                                                   \
                }                                                                                  \
            }                                                                                      \
            if (begin < end) {                                                                     \
                image_fill_row(image, p.y + row, p.x + (int)begin, p.x + (int)end, color);         \
            }                                                                                      \
        }                                                                                          \
    }

DEFINE_FILL(int32, int32_t)
DEFINE_FILL(int64, int64_t)
DEFINE_FILL(float, float)
DEFINE_FILL(double, double)

/* A choice of this panel: a kind of number, and how many bits after the point. */
enum { INT32, INT64, FLOAT, DOUBLE, HOUSE_SNAPPED, KIND = 32 };

enum { NOT_SNAPPED = KIND - 1 };

static void fill_bits(struct image *image, const struct filled *t, int choice, struct color color) {
    int bits = choice % KIND == NOT_SNAPPED ? -1 : choice % KIND;
    struct fixed2 corner[3];
    switch (choice / KIND) {
    case INT32:
        fill_int32(image, place(t->corner, bits), color);
        break;
    case INT64:
        fill_int64(image, place(t->corner, bits), color);
        break;
    case FLOAT:
        fill_float(image, place(t->corner, bits), color);
        break;
    case DOUBLE:
        fill_double(image, place(t->corner, bits), color);
        break;
    default:
        if (screen_snap(t->corner[0], &corner[0]) && screen_snap(t->corner[1], &corner[1]) &&
            screen_snap(t->corner[2], &corner[2])) {
            triangle(image, corner, color);
        }
    }
}

static const char *kind_of_bits(int choice) {
    static const char *const kinds[] = {"int32", "int64", "float", "double", NULL};
    return kinds[choice / KIND];
}

/* ---- Running and judging ---- */

/* The number of a triangle in blue and green; red tells which version of which panel drew it. */
static struct color triangle_color(size_t i, int tag) {
    return (struct color){.b = (uint8_t)(i & 255), .g = (uint8_t)(i >> 8), .r = (uint8_t)tag};
}

static double count_wrong(const struct fill_bench *bench, const struct mesh *mesh, int tag) {
    size_t wrong = 0;
    for (size_t i = 0; i < (size_t)SIDE * SIDE; i++) {
        const uint8_t *pixel = bench->image.pixels + 3 * i;
        uint32_t shown = pixel[2] == tag ? (uint32_t)(pixel[0] + 256 * pixel[1]) + 1 : 0;
        wrong += shown != mesh->shown[i];
    }
    return (double)wrong / (double)mesh->pixel_count;
}

static int attempt_tag(size_t which, int choice) {
    return 1 + (int)which * 16 + choice;
}

/* Above those of the attempts. */
static int bits_tag(int choice) {
    return 64 + choice / KIND * KIND + choice % KIND;
}

static void run_attempt(struct fill_bench *bench, size_t which, int choice) {
    const struct mesh *mesh = &bench->meshes[which];
    struct target target = {.image = &bench->image};
    for (size_t i = 0; i < mesh->count; i++) {
        fill(&mesh->triangles[i], choice, &target, triangle_color(i, attempt_tag(which, choice)));
    }
}

static void run_small(void *state, int choice) {
    run_attempt(state, SMALL, choice);
}

static void run_large(void *state, int choice) {
    run_attempt(state, LARGE, choice);
}

static void run_bits(void *state, int choice) {
    struct fill_bench *bench = state;
    const struct mesh *mesh = &bench->meshes[UNSNAPPED];
    for (size_t i = 0; i < mesh->count; i++) {
        fill_bits(&bench->image, &mesh->triangles[i], choice, triangle_color(i, bits_tag(choice)));
    }
}

static double error_small(void *state, int choice) {
    const struct fill_bench *bench = state;
    return 1e3 * count_wrong(bench, &bench->meshes[SMALL], attempt_tag(SMALL, choice));
}

static double error_large(void *state, int choice) {
    const struct fill_bench *bench = state;
    return 1e3 * count_wrong(bench, &bench->meshes[LARGE], attempt_tag(LARGE, choice));
}

static double error_bits(void *state, int choice) {
    const struct fill_bench *bench = state;
    return 1e6 * count_wrong(bench, &bench->meshes[UNSNAPPED], bits_tag(choice));
}

/* ---- The lesson ---- */

static bool fill_setup(void **state, struct error *error) {
    struct fill_bench *bench = calloc(1, sizeof *bench);
    *state = bench;
    if (bench == NULL) {
        return error_set(error, "out of memory for triangles");
    }
    return image_create(&bench->image, SIDE, SIDE, IMAGE_BGR, error) &&
           make_bust(&bench->meshes[SMALL], true, &bench->image, error) &&
           make_fan(&bench->meshes[LARGE], error) &&
           make_bust(&bench->meshes[UNSNAPPED], false, &bench->image, error);
}

static void fill_teardown(void *state) {
    struct fill_bench *bench = state;
    for (size_t i = 0; bench != NULL && i < MESH_COUNT; i++) {
        free(bench->meshes[i].triangles);
        free(bench->meshes[i].shown);
    }
    if (bench != NULL) {
        image_free(&bench->image);
    }
    free(bench);
}

static double small_units(const void *state) {
    return (double)((const struct fill_bench *)state)->meshes[SMALL].pixel_count;
}

static double large_units(const void *state) {
    return (double)((const struct fill_bench *)state)->meshes[LARGE].pixel_count;
}

static double bits_units(const void *state) {
    return (double)((const struct fill_bench *)state)->meshes[UNSNAPPED].count;
}

static const struct bench_version small_versions[] = {
    {"1: sweep, whole numbers", 1, false, run_small, error_small},
    {"2: sweep in float", 2, false, run_small, error_small},
    {"3: box in float", 3, false, run_small, error_small},
    {"4: box in double", 4, false, run_small, error_small},
    {"5: box, open", 5, false, run_small, error_small},
    {"6: box, epsilon", 6, false, run_small, error_small},
    {"7: edges summed in float", 7, false, run_small, error_small},
    {"8: blocks, exact", 8, false, run_small, error_small},
    {"spans by remainders", CARRIED, false, run_small, error_small},
    {"spans, exact (main.c)", HOUSE, true, run_small, error_small},
};

static const struct bench_version large_versions[] = {
    {"1: sweep, whole numbers", 1, false, run_large, error_large},
    {"2: sweep in float", 2, false, run_large, error_large},
    {"3: box in float", 3, false, run_large, error_large},
    {"4: box in double", 4, false, run_large, error_large},
    {"5: box, open", 5, false, run_large, error_large},
    {"6: box, epsilon", 6, false, run_large, error_large},
    {"7: edges summed in float", 7, false, run_large, error_large},
    {"8: blocks, exact", 8, false, run_large, error_large},
    {"spans by remainders", CARRIED, false, run_large, error_large},
    {"spans, exact (main.c)", HOUSE, true, run_large, error_large},
};

#define BITS_0_TO_16(kind)                                                                         \
    {"0", (kind)*KIND, false, run_bits, error_bits},                                               \
        {"2", (kind)*KIND + 2, false, run_bits, error_bits},                                       \
        {"4", (kind)*KIND + 4, false, run_bits, error_bits},                                       \
        {"8", (kind)*KIND + 8, false, run_bits, error_bits},                                       \
        {"12", (kind)*KIND + 12, false, run_bits, error_bits},                                     \
        {"16", (kind)*KIND + 16, false, run_bits, error_bits},

static const struct bench_version bits_versions[] = {
    BITS_0_TO_16(INT32) BITS_0_TO_16(INT64)
        BITS_0_TO_16(FLOAT){"all", FLOAT *KIND + NOT_SNAPPED, false, run_bits, error_bits},
    BITS_0_TO_16(DOUBLE){"all", DOUBLE *KIND + NOT_SNAPPED, false, run_bits, error_bits},
    {"8 (main.c)", HOUSE_SNAPPED *KIND + 8, true, run_bits, error_bits},
};

static const struct bench_panel fill_panels[] = {
    {
        .title = "Small triangles: the faces of the bust, on 800x800 pixels",
        .error_label = "pixels that show the wrong triangle, per 1000",
        .time_label = "ns per pixel",
        .against = "128-bit integers",
        .house_within = BENCH_EXACT,
        .units = small_units,
        .versions = small_versions,
        .version_count = sizeof small_versions / sizeof small_versions[0],
    },
    {
        .title = "Large triangles: a fan of 24 that reaches far beyond the image",
        .error_label = "pixels that show the wrong triangle, per 1000",
        .time_label = "ns per pixel",
        .against = "128-bit integers",
        .house_within = BENCH_EXACT,
        .units = large_units,
        .versions = large_versions,
        .version_count = sizeof large_versions / sizeof large_versions[0],
        .budget = 2,
    },
    {
        .title = "Corners snapped to 0 to 16 bits after the point, or not at all: the bust again",
        .error_label = "pixels that show the wrong triangle, per million",
        .time_label = "ns per triangle",
        .against = "128-bit integers and corners that are not snapped",
        .units = bits_units,
        .versions = bits_versions,
        .version_count = sizeof bits_versions / sizeof bits_versions[0],
        .series = kind_of_bits,
    },
};

const struct bench_lesson bench_step03 = {
    .step = "step03_triangle",
    .title = "Step 3: a triangle",
    .setup = fill_setup,
    .teardown = fill_teardown,
    .panels = fill_panels,
    .panel_count = sizeof fill_panels / sizeof fill_panels[0],
};
