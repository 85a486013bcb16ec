/*
 * Lesson 5's benchmark: what decides which triangle is seen, and in what a depth is kept.
 *
 * The error counts the pixels that show another triangle than the nearest one; depths at the
 * corners are whole numbers of small steps, and at the pixels they are compared as exact fractions.
 * Where two triangles are equally near, either is right.
 *
 * The first panel draws a knot, and a board that cuts through it, in several ways. The second is a
 * view in perspective: sheets that pass through each other at all distances from near to far. What
 * is kept at a pixel there is near / distance, or something made of it, because that is straight on
 * the screen (lesson 8).
 */
#include "bench/bench.h"

#define LESSON "../step05_zbuffer/main.c"
#include "lesson.h"

typedef bool depth_test(void *buffer, size_t i, double depth);
struct drawn;
INLINED void attempt_triangle(struct image *image, const struct drawn *d, depth_test *test,
                              void *buffer);
#include "../../../step05_zbuffer/attempts.h"

#include "oracle/oracle.h"

/* Sheets fill the image in CELLS x CELLS cells: the lowest left one is the nearest, the uppermost
 * right one the farthest. */
enum { SIDE = 800, CELLS = 8, CELL_SIDE = SIDE / CELLS, SHEETS_IN_CELL = 4, NOTHING = 0 };
enum { PILE_KNOT, PILE_SHEETS, PILE_COUNT };
#define RATIO 1e6 /* of their distances, far : near */

/* Triangles to draw. Triangle i has the colour i + 1, as blue + 256 * green + 65536 * red. */
struct pile {
    struct drawn *list;
    int64_t (*depths)[3]; /* the same depths as whole numbers of steps */
    double steps;         /* in a depth of 1: a power of 2 */
    size_t count;
    uint32_t nearest[SIDE * SIDE]; /* the colour that each pixel should have, NOTHING for none */
    size_t seen;                   /* pixels with a colour */
};

static struct {
    struct pile piles[PILE_COUNT];
    struct image image;
    struct drawn *sorted; /* memory for a list that is sorted */
    void *buffer;         /* 8 bytes a pixel */
} bench;

/* ---- Triangles ---- */

/* Add a triangle whose depths are rounded to whole steps. */
static void pile_add(struct pile *pile, const struct vertex v[3]) {
    size_t i = pile->count++;
    struct drawn *d = &pile->list[i];
    uint32_t name = (uint32_t)i + 1;
    for (int k = 0; k < 3; k++) {
        pile->depths[i][k] = (int64_t)floor(v[k].depth * pile->steps + 0.5);
        d->v[k].position = v[k].position;
        d->v[k].depth = (double)pile->depths[i][k] / pile->steps;
    }
    d->color = color_rgb((uint8_t)(name >> 16), (uint8_t)(name >> 8), (uint8_t)name);
}

static void pile_allocate(struct pile *pile, size_t limit) {
    pile->list = bench_memory(limit, sizeof *pile->list);
    pile->depths = bench_memory(limit, sizeof *pile->depths);
}

/* A board of two triangles, which leans back and passes through the middle of the knot. */
static void add_board(struct pile *pile) {
    const int32_t least = SIDE / 10 * SUBPIXELS, most = SIDE * SUBPIXELS - least;
    const struct vertex a = {{least, least}, 0.4}, b = {{most, least}, 0.4};
    const struct vertex c = {{most, most}, -0.4}, d = {{least, most}, -0.4};
    const struct vertex lower[3] = {a, b, c}, upper[3] = {a, c, d};
    pile_add(pile, lower);
    pile_add(pile, upper);
}

/* What scene `knot` draws, the faces on which light from the viewer falls, and a board. */
static bool make_knot(struct pile *pile, const struct image *image, struct error *error) {
    struct model model;
    const struct vec3 light = {0, 0, -1};
    if (!model_read(&model, BENCH_MODEL("knot.off"), error)) {
        return false;
    }
    pile_allocate(pile, model.face_count + 2);
    pile->steps = 0x1p23;
    for (size_t face = 0; face < model.face_count; face++) {
        struct vertex v[3];
        if (model_face_intensity(&model, face, light) > 0 && place_face(&model, face, image, v)) {
            pile_add(pile, v);
        }
    }
    add_board(pile);
    model_free(&model);
    return true;
}

/* A sheet fills its cell; its depth is `depth` to about a thousandth. */
static void add_sheet(struct pile *pile, int column, int row, double depth, struct random *random) {
    double slope_x = random_real(random, -1e-3, 1e-3), slope_y = random_real(random, -1e-3, 1e-3);
    double middle = random_real(random, -2e-4, 2e-4);
    struct vertex corner[4];
    for (int k = 0; k < 4; k++) {
        int x = k == 1 || k == 2, y = k >= 2; /* counterclockwise */
        corner[k].position.x = (column + x) * CELL_SIDE * SUBPIXELS;
        corner[k].position.y = (row + y) * CELL_SIDE * SUBPIXELS;
        corner[k].depth = depth * (1 + middle + (x - 0.5) * slope_x + (y - 0.5) * slope_y);
    }
    const struct vertex lower[3] = {corner[0], corner[1], corner[2]};
    const struct vertex upper[3] = {corner[0], corner[2], corner[3]};
    pile_add(pile, lower);
    pile_add(pile, upper);
}

/* The far end is RATIO times as far as the near one; each cell is a little farther than the cell
 * before, always by the same factor. */
static void make_sheets(struct pile *pile) {
    struct random random = {5};
    int cells = CELLS * CELLS;
    pile_allocate(pile, (size_t)cells * SHEETS_IN_CELL * 2);
    pile->steps = 0x1p52;
    for (int i = 0; i < cells * SHEETS_IN_CELL; i++) {
        int cell = i / SHEETS_IN_CELL;
        double depth = pow(RATIO, -(cell + 0.5) / cells); /* near / distance */
        add_sheet(pile, cell % CELLS, cell / CELLS, depth, &random);
    }
}

/* ---- The exact picture ---- */

static void corners_of(const struct drawn *d, struct fixed2 corner[3]) {
    for (int k = 0; k < 3; k++) {
        corner[k] = d->v[k].position;
    }
}

/* Which of two triangles is nearer at a pixel? Positive for the first, 0 when equal. */
static int pile_compare(const struct pile *pile, size_t first, size_t second, int x, int y) {
    struct fixed2 p[3], q[3];
    corners_of(&pile->list[first], p);
    corners_of(&pile->list[second], q);
    return oracle_compare_depth(p, pile->depths[first], q, pile->depths[second], x, y);
}

static void pile_find_nearest(struct pile *pile) {
    for (size_t i = 0; i < pile->count; i++) {
        struct fixed2 c[3];
        corners_of(&pile->list[i], c);
        struct rectangle box = oracle_box(c, SIDE, SIDE);
        for (int y = box.y; y < box.y + box.height; y++) {
            for (int x = box.x; x < box.x + box.width; x++) {
                uint32_t *name = &pile->nearest[(size_t)y * SIDE + (size_t)x];
                if (oracle_covers(c[0], c[1], c[2], x, y) &&
                    (*name == NOTHING || pile_compare(pile, i, *name - 1, x, y) > 0)) {
                    *name = (uint32_t)i + 1;
                }
            }
        }
    }
    for (size_t i = 0; i < (size_t)SIDE * SIDE; i++) {
        pile->seen += pile->nearest[i] != NOTHING;
    }
}

/* ---- Several ways to decide ---- */

enum { DEPTH_BUFFER, FILE_ORDER, PAINTER };

static void run_knot(struct bench_choice choice) {
    const struct pile *pile = &bench.piles[PILE_KNOT];
    struct canvas canvas = {.image = &bench.image, .depth = bench.buffer};
    memset(bench.image.pixels, 0, (size_t)SIDE * SIDE * 3);
    if (choice.way == FILE_ORDER) {
        attempt_draw(&bench.image, pile->list, pile->count, NULL, NULL);
    } else if (choice.way == PAINTER) {
        memcpy(bench.sorted, pile->list, pile->count * sizeof *pile->list);
        attempt_2_painter(&bench.image, bench.sorted, pile->count);
    } else {
        depth_clear(canvas.depth, (size_t)SIDE * SIDE);
        for (size_t i = 0; i < pile->count; i++) {
            triangle(&canvas, pile->list[i].v, pile->list[i].color);
        }
    }
}

/* ---- Several numbers to keep a depth in ---- */

enum { FIXED_16, FIXED_24, FIXED_32, FLOAT, REVERSED, DOUBLE, KINDS };

/* The tests of attempts.h take a depth in -1..1; these take whole steps, 0 being "nothing here". */
ATTEMPT_KEEP(keep_16, uint16_t, >, depth)
ATTEMPT_KEEP(keep_32, uint32_t, >, depth)
ATTEMPT_KEEP(keep_smaller, float, <, depth)

static uint64_t tested, written;

/* attempts.h's triangle(), which counts as main.c's does, with each test as a part of its loop. */
#define KEPT_TRIANGLE(name, test)                                                                  \
    static inline bool test##_counted(void *buffer, size_t i, double depth) {                      \
        bool kept = test(buffer, i, depth);                                                        \
        tested++;                                                                                  \
        written += kept;                                                                           \
        return kept;                                                                               \
    }                                                                                              \
    static void name(const struct drawn *d) {                                                      \
        attempt_triangle(&bench.image, d, test##_counted, bench.buffer);                           \
    }

KEPT_TRIANGLE(triangle_16, keep_16)
KEPT_TRIANGLE(triangle_32, keep_32)
KEPT_TRIANGLE(triangle_float, keep_smaller)
KEPT_TRIANGLE(triangle_reversed, attempt_keep_float)

static void triangle_double(const struct drawn *d) {
    struct canvas canvas = {.image = &bench.image, .depth = bench.buffer};
    triangle(&canvas, d->v, d->color);
}

/* What a depth is kept in: offset + scale * depth. */
struct kind {
    void (*draw)(const struct drawn *d);
    size_t bytes;  /* a pixel */
    float nothing; /* what is there before the first triangle */
    double offset, scale;
};

/* The least whole step is 1 (far); so many follow, up to the nearest. Half a step is added: cutting
 * off then rounds. */
#define STEPS(count) .offset = 1.5 - (count) / (RATIO - 1), .scale = (count) / (1 - 1 / RATIO)

static const struct kind kinds[KINDS] = {
    [FIXED_16] = {triangle_16, 2, STEPS(0x1p16 - 2)},
    [FIXED_24] = {triangle_32, 4, STEPS(0x1p24 - 2)},
    [FIXED_32] = {triangle_32, 4, STEPS(0x1p32 - 2)},
    [FLOAT] = {triangle_float, 4, INFINITY, 1, -1}, /* smaller is nearer */
    [REVERSED] = {triangle_reversed, 4, -INFINITY, 0, 1},
    [DOUBLE] = {triangle_double, 8, -INFINITY, 0, 1},
};

static void clear_kept(const struct kind *kind) {
    const size_t pixels = (size_t)SIDE * SIDE;
    if (kind->bytes == sizeof(double)) {
        depth_clear(bench.buffer, pixels);
    } else if (kind->nothing == 0) {
        memset(bench.buffer, 0, pixels * kind->bytes);
    } else {
        attempt_fill_float(bench.buffer, pixels, kind->nothing);
    }
}

static void run_sheets(struct bench_choice choice) {
    const struct pile *pile = &bench.piles[PILE_SHEETS];
    const struct kind *kind = &kinds[choice.way];
    memset(bench.image.pixels, 0, (size_t)SIDE * SIDE * 3);
    clear_kept(kind);
    for (size_t i = 0; i < pile->count; i++) {
        struct drawn d = pile->list[i];
        for (int k = 0; k < 3; k++) {
            d.v[k].depth = kind->offset + kind->scale * d.v[k].depth;
        }
        kind->draw(&d);
    }
}

/* ---- The errors ---- */

/* Pixels of the image that show another triangle than the nearest, of 1000 that show one. */
static double error_of(struct bench_choice choice) {
    const struct pile *pile = &bench.piles[choice.on];
    size_t wrong = 0;
    for (int y = 0; y < SIDE; y++) {
        for (int x = 0; x < SIDE; x++) {
            uint32_t right = pile->nearest[(size_t)y * SIDE + (size_t)x];
            const uint8_t *p = bench.image.pixels + ((size_t)y * SIDE + (size_t)x) * 3;
            uint32_t shown = p[0] | (uint32_t)p[1] << 8 | (uint32_t)p[2] << 16;
            bool differs = shown != right;
            if (differs && shown != NOTHING && right != NOTHING) {
                differs = pile_compare(pile, shown - 1, right - 1, x, y) != 0;
            }
            wrong += differs;
        }
    }
    return 1000 * (double)wrong / (double)pile->seen;
}

/* ---- The lesson ---- */

static bool depth_setup(struct error *error) {
    struct pile *piles = bench.piles;
    if (!image_create(&bench.image, SIDE, SIDE, IMAGE_BGR, error) ||
        !make_knot(&piles[PILE_KNOT], &bench.image, error)) {
        return false;
    }
    make_sheets(&piles[PILE_SHEETS]);
    bench.buffer = bench_memory((size_t)SIDE * SIDE, sizeof(double));
    bench.sorted = bench_memory(piles[PILE_KNOT].count, sizeof *bench.sorted);
    for (int i = 0; i < PILE_COUNT; i++) {
        pile_find_nearest(&piles[i]);
    }
    return true;
}

static const struct bench_version knot_versions[] = {
    VERSION("1: order of the file", FILE_ORDER),
    VERSION("2: painter's order", PAINTER),
    HOUSE_VERSION("main.c", DEPTH_BUFFER),
};

static const struct bench_version sheets_versions[] = {
    VERSION("16 bits fixed", FIXED_16),   VERSION("24 bits fixed", FIXED_24),
    VERSION("32 bits fixed", FIXED_32),   VERSION("float", FLOAT),
    VERSION("float, reversed", REVERSED), HOUSE_VERSION("double (main.c)", DOUBLE),
};

#define DEPTH_PANEL(pile, heading, function, list)                                                 \
    {                                                                                              \
        .title = (heading), .error_label = "pixels showing the wrong triangle, per 1000",          \
        .time_label = "ms per frame", .against = "exact fractions", .house_within = BENCH_EXACT,   \
        .on = (pile), .run = (function), .error = error_of, BENCH_VERSIONS(list),                  \
    }

static const struct bench_panel depth_panels[] = {
    DEPTH_PANEL(PILE_KNOT, "Ways to decide: a knot, and a board through it, 800x800 pixels",
                run_knot, knot_versions),
    DEPTH_PANEL(PILE_SHEETS, "Sheets through each other, far : near = 1,000,000", run_sheets,
                sheets_versions),
};

const struct bench_lesson bench_step05 =
    BENCH_LESSON("step05_zbuffer", "Lesson 5: a depth buffer", depth_setup, depth_panels);
