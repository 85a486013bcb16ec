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
#define LESSON "../step05_zbuffer/main.c"
#include "lesson.h"

#include "../../../step05_zbuffer/attempts.h"

#include "bench/bench.h"
#include "oracle/oracle.h"

/* Sheets fill the image in CELLS x CELLS cells: the lowest left one is the nearest, the uppermost
 * right one the farthest. */
enum { SIDE = 800, CELLS = 8, CELL_SIDE = SIDE / CELLS, SHEETS_IN_CELL = 4, NOTHING = 0 };
enum { PILE_KNOT, PILE_SHEETS, PILE_COUNT };

/* Triangles to draw. Triangle i has the colour i + 1, as blue + 256 * green + 65536 * red. */
struct pile {
    struct drawn *list;
    int64_t (*depths)[3]; /* the same depths as whole numbers of steps */
    double steps;         /* in a depth of 1: a power of 2 */
    double far;           /* least depth that can be kept; the greatest is 1 */
    size_t count;
    uint32_t *nearest; /* the colour that each pixel should have, NOTHING for none */
    size_t seen;       /* pixels with a colour */
};

struct depth_bench {
    struct pile piles[PILE_COUNT];
    struct image image;
    struct drawn *sorted; /* memory for a list that is sorted */
    void *buffer;         /* 8 bytes a pixel */
};

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

static bool pile_allocate(struct pile *pile, size_t limit, struct error *error) {
    pile->list = calloc(limit + 1, sizeof *pile->list);
    pile->depths = calloc(limit + 1, sizeof *pile->depths);
    pile->nearest = calloc((size_t)SIDE * SIDE, sizeof *pile->nearest);
    return (pile->list != NULL && pile->depths != NULL && pile->nearest != NULL) ||
           error_set(error, "out of memory for %zu triangles", limit);
}

static void pile_free(struct pile *pile) {
    free(pile->list);
    free(pile->depths);
    free(pile->nearest);
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
    bool done = bench_read_model(&model, "knot.off", error) &&
                pile_allocate(pile, model.face_count + 2, error);
    pile->steps = 0x1p23;
    for (size_t face = 0; done && face < model.face_count; face++) {
        struct vertex v[3];
        if (model_face_intensity(&model, face, light) > 0 && place_face(&model, face, image, v)) {
            pile_add(pile, v);
        }
    }
    if (done) {
        add_board(pile);
    }
    model_free(&model);
    return done;
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

/* The far end is `ratio` times as far as the near one; each cell is a little farther than the cell
 * before, always by the same factor. */
static bool make_sheets(struct pile *pile, double ratio, struct error *error) {
    struct random random = {5};
    int cells = CELLS * CELLS;
    if (!pile_allocate(pile, (size_t)cells * SHEETS_IN_CELL * 2, error)) {
        return false;
    }
    pile->steps = 0x1p52;
    pile->far = 1 / ratio;
    for (int i = 0; i < cells * SHEETS_IN_CELL; i++) {
        int cell = i / SHEETS_IN_CELL;
        double depth = pow(ratio, -(cell + 0.5) / cells); /* near / distance */
        add_sheet(pile, cell % CELLS, cell / CELLS, depth, &random);
    }
    return true;
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

/* Pixels of the image that a side from least to most (1/256 pixel) can reach. */
static struct span pixels_between(int32_t a, int32_t b, int32_t c) {
    int32_t least = a < b ? a : b, most = a > b ? a : b;
    least = least < c ? least : c;
    most = most > c ? most : c;
    int begin = least / SUBPIXELS - 1, end = most / SUBPIXELS + 2;
    return (struct span){begin > 0 ? begin : 0, end < SIDE ? end : SIDE};
}

static void pile_find_nearest(struct pile *pile) {
    for (size_t i = 0; i < pile->count; i++) {
        struct fixed2 c[3];
        corners_of(&pile->list[i], c);
        struct span columns = pixels_between(c[0].x, c[1].x, c[2].x);
        struct span rows = pixels_between(c[0].y, c[1].y, c[2].y);
        for (int y = rows.begin; y < rows.end; y++) {
            for (int x = columns.begin; x < columns.end; x++) {
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

enum { FILE_ORDER, PAINTER, HOUSE };

static void draw_house(struct canvas *canvas, const struct drawn *list, size_t count) {
    depth_clear(canvas->depth, (size_t)SIDE * SIDE);
    for (size_t i = 0; i < count; i++) {
        triangle(canvas, list[i].v, list[i].color);
    }
}

static void run_knot(void *state, int choice) {
    struct depth_bench *bench = state;
    const struct pile *pile = &bench->piles[PILE_KNOT];
    struct canvas canvas = {.image = &bench->image, .depth = bench->buffer};
    memset(bench->image.pixels, 0, (size_t)SIDE * SIDE * 3);
    if (choice == FILE_ORDER) {
        attempt_1_file_order(&bench->image, pile->list, pile->count);
    } else if (choice == PAINTER) {
        memcpy(bench->sorted, pile->list, pile->count * sizeof *pile->list);
        attempt_2_painter(&bench->image, bench->sorted, pile->count);
    } else {
        draw_house(&canvas, pile->list, pile->count);
    }
}

/* ---- Several numbers to keep a depth in ---- */

enum { FIXED_16, FIXED_24, FIXED_32, FLOAT, REVERSED, DOUBLE, KINDS };

/* The tests of attempts.h take a depth in -1..1; these take whole steps, 0 being "nothing here". */
#define KEEP_STEPS(name, type)                                                                     \
    static inline bool name(void *buffer, size_t i, double depth) {                                \
        type step = (type)depth;                                                                   \
        if (!(step > ((type *)buffer)[i])) {                                                       \
            return false;                                                                          \
        }                                                                                          \
        ((type *)buffer)[i] = step;                                                                \
        return true;                                                                               \
    }

KEEP_STEPS(keep_16, uint16_t)
KEEP_STEPS(keep_32, uint32_t)

/* triangle() of main.c, line by line, except for the number in which a depth is kept. `test` is a
 * constant wherever this is used, and becomes a part of the loop. */
INLINED void kept_triangle(struct canvas *canvas, const struct vertex v[3], struct color color,
                           void *buffer, depth_test *test) {
    struct image *image = canvas->image;
    struct edges edges;
    if (!edges_setup(&edges, v[0].position, v[1].position, v[2].position, image->width,
                     image->height)) {
        return;
    }
    for (int y = edges.y_begin; y < edges.y_end; y++) {
        struct span span = edges_span(&edges, y);
        size_t row = (size_t)y * image->width;
        for (int x = span.begin; x < span.end; x++) {
            struct vec3 weight = edges_weights(&edges, x, y);
            double depth = interpolate_depth(weight, v[0].depth, v[1].depth, v[2].depth);
            canvas->pixels_tested++;
            if (test(buffer, row + (size_t)x, depth)) {
                image_set(image, x, y, color);
                canvas->pixels_written++;
            }
        }
    }
}

#define KEPT_TRIANGLE(name, test)                                                                  \
    static void name(struct canvas *canvas, const struct vertex v[3], struct color color,          \
                     void *buffer) {                                                               \
        kept_triangle(canvas, v, color, buffer, test);                                             \
    }

KEPT_TRIANGLE(triangle_16, keep_16)
KEPT_TRIANGLE(triangle_32, keep_32)
KEPT_TRIANGLE(triangle_float, attempt_keep_farther)
KEPT_TRIANGLE(triangle_reversed, attempt_keep_float)

static void triangle_double(struct canvas *canvas, const struct vertex v[3], struct color color,
                            void *buffer) {
    (void)buffer; /* canvas->depth */
    triangle(canvas, v, color);
}

/* What a depth is kept in. */
struct kind {
    void (*draw)(struct canvas *canvas, const struct vertex v[3], struct color color, void *buffer);
    size_t bytes; /* a pixel */
    double most;  /* the greatest of whole steps; 0 for kinds that keep fractions */
};

static const struct kind kinds[KINDS] = {
    [FIXED_16] = {.draw = triangle_16, .bytes = 2, .most = 0x1p16 - 1},
    [FIXED_24] = {.draw = triangle_32, .bytes = 4, .most = 0x1p24 - 1},
    [FIXED_32] = {.draw = triangle_32, .bytes = 4, .most = 0x1p32 - 1},
    [FLOAT] = {.draw = triangle_float, .bytes = 4},
    [REVERSED] = {.draw = triangle_reversed, .bytes = 4},
    [DOUBLE] = {.draw = triangle_double, .bytes = 8},
};

static void clear_kept(void *buffer, int kind) {
    const size_t pixels = (size_t)SIDE * SIDE;
    switch (kind) {
    case FLOAT:
        attempt_fill_float(buffer, pixels, INFINITY);
        break;
    case REVERSED:
        attempt_fill_float(buffer, pixels, -INFINITY);
        break;
    case DOUBLE:
        depth_clear(buffer, pixels);
        break;
    default:
        memset(buffer, 0, pixels * kinds[kind].bytes);
    }
}

/* What is kept for a depth: offset + scale * depth. */
struct mapping {
    double offset, scale;
};

/* Whole steps go from 1 (far) to most (near), and half a step is added: cutting off then rounds. */
static struct mapping mapping_of(int kind, double far) {
    if (kind == FLOAT) {
        return (struct mapping){1, -1}; /* smaller is nearer */
    }
    if (kinds[kind].most == 0) {
        return (struct mapping){0, 1};
    }
    double scale = (kinds[kind].most - 1) / (1 - far);
    return (struct mapping){1.5 - scale * far, scale};
}

static void run_sheets(void *state, int choice) {
    struct depth_bench *bench = state;
    const struct pile *pile = &bench->piles[PILE_SHEETS];
    const struct kind *kind = &kinds[choice];
    struct mapping mapping = mapping_of(choice, pile->far);
    struct canvas canvas = {.image = &bench->image, .depth = bench->buffer};
    memset(bench->image.pixels, 0, (size_t)SIDE * SIDE * 3);
    clear_kept(bench->buffer, choice);
    for (size_t i = 0; i < pile->count; i++) {
        struct drawn d = pile->list[i];
        for (int k = 0; k < 3; k++) {
            d.v[k].depth = mapping.offset + mapping.scale * d.v[k].depth;
        }
        kind->draw(&canvas, d.v, d.color, bench->buffer);
    }
}

/* ---- The errors ---- */

/* Pixels of the image that show another triangle than the nearest, of 1000 that show one. */
static double pile_error(const struct depth_bench *bench, const struct pile *pile) {
    size_t wrong = 0;
    for (int y = 0; y < SIDE; y++) {
        for (int x = 0; x < SIDE; x++) {
            uint32_t right = pile->nearest[(size_t)y * SIDE + (size_t)x];
            const uint8_t *p = bench->image.pixels + ((size_t)y * SIDE + (size_t)x) * 3;
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

static double error_knot(void *state, int choice) {
    (void)choice;
    const struct depth_bench *bench = state;
    return pile_error(bench, &bench->piles[PILE_KNOT]);
}

static double error_sheets(void *state, int choice) {
    (void)choice;
    const struct depth_bench *bench = state;
    return pile_error(bench, &bench->piles[PILE_SHEETS]);
}

/* ---- The lesson ---- */

static bool depth_setup(void *state, struct error *error) {
    struct depth_bench *bench = state;
    struct pile *piles = bench->piles;
    if (!image_create(&bench->image, SIDE, SIDE, IMAGE_BGR, error) ||
        !make_knot(&piles[PILE_KNOT], &bench->image, error) ||
        !make_sheets(&piles[PILE_SHEETS], 1e6, error)) {
        return false;
    }
    bench->sorted = calloc(piles[PILE_KNOT].count, sizeof *bench->sorted);
    bench->buffer = calloc((size_t)SIDE * SIDE, sizeof(double));
    if (bench->sorted == NULL || bench->buffer == NULL) {
        return error_set(error, "out of memory for a depth buffer");
    }
    for (int i = 0; i < PILE_COUNT; i++) {
        pile_find_nearest(&piles[i]);
    }
    return true;
}

static void depth_teardown(void *state) {
    struct depth_bench *bench = state;
    for (int i = 0; i < PILE_COUNT; i++) {
        pile_free(&bench->piles[i]);
    }
    image_free(&bench->image);
    free(bench->sorted);
    free(bench->buffer);
}

static const struct bench_version knot_versions[] = {
    VERSION("1: order of the file", FILE_ORDER),
    VERSION("2: painter's order", PAINTER),
    HOUSE_VERSION("main.c", HOUSE),
};

static const struct bench_version sheets_versions[] = {
    VERSION("16 bits fixed", FIXED_16),   VERSION("24 bits fixed", FIXED_24),
    VERSION("32 bits fixed", FIXED_32),   VERSION("float", FLOAT),
    VERSION("float, reversed", REVERSED), HOUSE_VERSION("double (main.c)", DOUBLE),
};

static const struct bench_panel depth_panels[] = {
    {
        .title = "Ways to decide: a knot, and a board through it, 800x800 pixels",
        .error_label = "pixels showing the wrong triangle, per 1000",
        .time_label = "ms per frame",
        .against = "exact fractions",
        .house_within = BENCH_EXACT,
        .run = run_knot,
        .error = error_knot,
        BENCH_VERSIONS(knot_versions),
    },
    {
        .title = "Sheets through each other, far : near = 1,000,000",
        .error_label = "pixels showing the wrong triangle, per 1000",
        .time_label = "ms per frame",
        .against = "exact fractions",
        .house_within = BENCH_EXACT,
        .run = run_sheets,
        .error = error_sheets,
        BENCH_VERSIONS(sheets_versions),
    },
};

const struct bench_lesson bench_step05 =
    BENCH_LESSON("step05_zbuffer", "Step 5: a depth buffer", struct depth_bench, depth_setup,
                 depth_teardown, depth_panels);
