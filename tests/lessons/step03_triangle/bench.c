/*
 * Lesson 3's benchmark: ways to fill a triangle, on a mesh of small ones and on a fan of large
 * ones that reach far beyond the image, and what it costs to snap corners. Every other side of the
 * fan goes through many pixel centres; the values at the rest need more digits than a float has.
 *
 * All versions write rows with image_fill_row(). Each triangle has a colour of its own, and each
 * version too: so the picture of the last run tells which triangle it shows at each pixel. The
 * error counts pixels that show another one than 128-bit integers say.
 */
#define LESSON "../step03_triangle/main.c"
#include "lesson.h"

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

/* ---- Corners snapped to other fractions of a pixel ---- */

/* A triangle whose corners are snapped to a whole number of steps in a pixel, counted from the
 * pixel (x,y): small numbers need few digits. */
struct placed {
    int x, y;
    int64_t unit;         /* steps in a pixel */
    int64_t corner[3][2]; /* x, y */
    struct span rows;     /* counted from y: the centres between the corners */
};

static inline int64_t fast_floor(double value) {
    int64_t whole = (int64_t)value;
    return whole - (value < (double)whole);
}

static inline struct placed place(const struct vec2 corner[3], int bits) {
    struct placed p = {.x = (int)corner[0].x, .y = (int)corner[0].y, .unit = INT64_C(1) << bits};
    int64_t low = INT64_MAX, high = INT64_MIN;
    for (int i = 0; i < 3; i++) {
        p.corner[i][0] = fast_floor((corner[i].x - p.x) * (double)p.unit + 0.5);
        p.corner[i][1] = fast_floor((corner[i].y - p.y) * (double)p.unit + 0.5);
        low = p.corner[i][1] < low ? p.corner[i][1] : low;
        high = p.corner[i][1] > high ? p.corner[i][1] : high;
    }
    int begin = (int)((2 * low + p.unit - 1) >> (bits + 1));
    int end = (int)((2 * high - p.unit) >> (bits + 1)) + 1;
    p.rows = span_overlap((struct span){begin, end}, (struct span){-p.y, SIDE - p.y});
    return p;
}

/* An edge function of lesson 3: value + dx * column + dy * row is positive inside, and 0 on the
 * edge, which is `closed` where it belongs to the triangle. Lengths are counted in half steps, so
 * that the centre of a pixel is a whole number even where a step is a pixel. */
struct side {
    int64_t value, dx, dy;
    bool closed;
};

static inline struct side side_between(const struct placed *p, const int64_t from[2],
                                       const int64_t to[2], int turn) {
    int64_t right = 2 * turn * (to[0] - from[0]), up = 2 * turn * (to[1] - from[1]);
    return (struct side){
        .value = right * (p->unit - 2 * from[1]) - up * (p->unit - 2 * from[0]),
        .dx = -up * 2 * p->unit,
        .dy = right * 2 * p->unit,
        .closed = up < 0 || (up == 0 && right < 0),
    };
}

/* What one side leaves of a span. */
static inline void narrow(struct span *span, const struct side *side, int row) {
    int64_t here = side->value + side->dy * row;
    if (side->dx > 0) {
        int64_t first = floor_divide(-here - side->closed, side->dx) + 1;
        span->begin = first > span->begin ? (int)first : span->begin;
    } else if (side->dx < 0) {
        int64_t end = floor_divide(here - !side->closed, -side->dx) + 1;
        span->end = end < span->end ? (int)end : span->end;
    } else if (!(here > 0 || (here == 0 && side->closed))) {
        span->end = span->begin;
    }
}

static void fill_placed(struct image *image, struct placed p, struct color color) {
    const int64_t *a = p.corner[0], *b = p.corner[1], *c = p.corner[2];
    int64_t area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    int turn = area > 0 ? 1 : -1;
    const struct side sides[3] = {side_between(&p, b, c, turn), side_between(&p, c, a, turn),
                                  side_between(&p, a, b, turn)};
    for (int row = p.rows.begin; row < p.rows.end && area != 0; row++) {
        struct span span = {-p.x, SIDE - p.x};
        for (int i = 0; i < 3; i++) {
            narrow(&span, &sides[i], row);
        }
        if (span.begin < span.end) {
            image_fill_row(image, p.y + row, p.x + span.begin, p.x + span.end, color);
        }
    }
}

/* A choice of this panel: how many bits after the point. */
enum { HOUSE_SNAPPED = 32 };

static void fill_bits(struct image *image, const struct filled *t, int choice, struct color color) {
    struct fixed2 corner[3];
    if (choice != HOUSE_SNAPPED) {
        fill_placed(image, place(t->corner, choice), color);
    } else if (screen_snap(t->corner[0], &corner[0]) && screen_snap(t->corner[1], &corner[1]) &&
               screen_snap(t->corner[2], &corner[2])) {
        triangle(image, corner, color);
    }
}

static const char *series_of_bits(int choice) {
    return choice != HOUSE_SNAPPED ? "bits after the point" : NULL;
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

/* Choices of the attempts: so many for each mesh. They are at most 32, and those of bits() above
 * them. */
enum { ATTEMPTS = 16 };

static int attempt_tag(int choice) {
    return 1 + choice;
}

static int bits_tag(int choice) {
    return 64 + choice;
}

static void run_attempt(void *state, int choice) {
    struct fill_bench *bench = state;
    const struct mesh *mesh = &bench->meshes[choice / ATTEMPTS];
    struct target target = {.image = &bench->image};
    for (size_t i = 0; i < mesh->count; i++) {
        fill(&mesh->triangles[i], choice % ATTEMPTS, &target,
             triangle_color(i, attempt_tag(choice)));
    }
}

static double error_attempt(void *state, int choice) {
    const struct fill_bench *bench = state;
    return 1e3 * count_wrong(bench, &bench->meshes[choice / ATTEMPTS], attempt_tag(choice));
}

static double units_attempt(const void *state, int base) {
    return (double)((const struct fill_bench *)state)->meshes[base / ATTEMPTS].pixel_count;
}

static void run_bits(void *state, int choice) {
    struct fill_bench *bench = state;
    const struct mesh *mesh = &bench->meshes[UNSNAPPED];
    for (size_t i = 0; i < mesh->count; i++) {
        fill_bits(&bench->image, &mesh->triangles[i], choice, triangle_color(i, bits_tag(choice)));
    }
}

static double error_bits(void *state, int choice) {
    const struct fill_bench *bench = state;
    return 1e6 * count_wrong(bench, &bench->meshes[UNSNAPPED], bits_tag(choice));
}

static double units_bits(const void *state, int base) {
    (void)base;
    return (double)((const struct fill_bench *)state)->meshes[UNSNAPPED].count;
}

/* ---- The lesson ---- */

static bool fill_setup(void *state, struct error *error) {
    struct fill_bench *bench = state;
    return image_create(&bench->image, SIDE, SIDE, IMAGE_BGR, error) &&
           make_bust(&bench->meshes[SMALL], true, &bench->image, error) &&
           make_fan(&bench->meshes[LARGE], error) &&
           make_bust(&bench->meshes[UNSNAPPED], false, &bench->image, error);
}

static void fill_teardown(void *state) {
    struct fill_bench *bench = state;
    for (size_t i = 0; i < MESH_COUNT; i++) {
        free(bench->meshes[i].triangles);
        free(bench->meshes[i].shown);
    }
    image_free(&bench->image);
}

static const struct bench_version attempt_versions[] = {
    VERSION("1: sweep, whole numbers", 1),
    VERSION("2: sweep in float", 2),
    VERSION("3: box in float", 3),
    VERSION("4: box in double", 4),
    VERSION("5: box, open", 5),
    VERSION("6: box, epsilon", 6),
    VERSION("7: edges summed in float", 7),
    VERSION("8: blocks, exact", 8),
    VERSION("spans by remainders", CARRIED),
    HOUSE_VERSION("spans, exact (main.c)", HOUSE),
};

static const struct bench_version bits_versions[] = {
    VERSION("0", 0),
    VERSION("2", 2),
    VERSION("4", 4),
    VERSION("8", 8),
    VERSION("12", 12),
    VERSION("16", 16),
    HOUSE_VERSION("8 (main.c)", HOUSE_SNAPPED),
};

static const struct bench_panel fill_panels[] = {
    {
        .title = "Small triangles: the faces of the bust, on 800x800 pixels",
        .error_label = "pixels that show the wrong triangle, per 1000",
        .time_label = "ns per pixel",
        .against = "128-bit integers",
        .house_within = BENCH_EXACT,
        .base = SMALL * ATTEMPTS,
        .run = run_attempt,
        .error = error_attempt,
        .units = units_attempt,
        BENCH_VERSIONS(attempt_versions),
    },
    {
        .title = "Large triangles: a fan of 24 that reaches far beyond the image",
        .error_label = "pixels that show the wrong triangle, per 1000",
        .time_label = "ns per pixel",
        .against = "128-bit integers",
        .house_within = BENCH_EXACT,
        .base = LARGE * ATTEMPTS,
        .run = run_attempt,
        .error = error_attempt,
        .units = units_attempt,
        BENCH_VERSIONS(attempt_versions),
        .budget = 2,
    },
    {
        .title = "Corners snapped to 0 to 16 bits after the point: the bust again",
        .error_label = "pixels that show the wrong triangle, per million",
        .time_label = "ns per triangle",
        .against = "128-bit integers and corners that are not snapped",
        .run = run_bits,
        .error = error_bits,
        .units = units_bits,
        BENCH_VERSIONS(bits_versions),
        .series = series_of_bits,
    },
};

const struct bench_lesson bench_step03 = {
    .step = "step03_triangle",
    .title = "Step 3: a triangle",
    .state_size = sizeof(struct fill_bench),
    .setup = fill_setup,
    .teardown = fill_teardown,
    .panels = fill_panels,
    .panel_count = sizeof fill_panels / sizeof fill_panels[0],
};
