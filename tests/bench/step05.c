/*
 * Lesson 5's benchmark: what decides which triangle is seen.
 *
 * The error counts the pixels that show another triangle than the nearest one; depths at the
 * corners are whole numbers / 2^23, and at the pixels they are compared as exact fractions. Where
 * two triangles are equally near, either is right. The second panel has thin sheets that pass
 * through each other within 0.002 of depth: there the bits of a depth buffer count.
 */
#define main step05_main
int step05_main(int argc, char **argv);
#include "../../step05_zbuffer/main.c"
#undef main

#include "../../step05_zbuffer/attempts.h"

#include "bench.h"
#include "oracle.h"

enum { SIDE = 800, SHEET_COUNT = 60, DEPTH_ONE = 1 << 23, NOTHING = 0 };

/* Triangles to draw. Triangle i has the colour i + 1, as blue + 256 * green + 65536 * red. */
struct pile {
    struct drawn *list;
    int64_t (*depths)[3]; /* the same depths as whole numbers, DEPTH_ONE being 1 */
    size_t count;
    uint32_t *nearest; /* the colour that each pixel should have, NOTHING for none */
    size_t seen;       /* pixels with a colour */
};

struct depth_bench {
    struct pile bust, sheets;
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
        pile->depths[i][k] = (int64_t)floor(v[k].depth * DEPTH_ONE + 0.5);
        d->v[k].position = v[k].position;
        d->v[k].depth = (double)pile->depths[i][k] / DEPTH_ONE;
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

static bool make_bust(struct pile *pile, const struct image *image, struct error *error) {
    struct model model;
    const struct vec3 light = {0, 0, -1};
    bool well =
        bench_read_model(&model, "bust.obj", error) && pile_allocate(pile, model.face_count, error);
    for (size_t face = 0; well && face < model.face_count; face++) {
        struct vertex v[3];
        if (model_face_intensity(&model, face, light) > 0 && place_face(&model, face, image, v)) {
            pile_add(pile, v);
        }
    }
    model_free(&model);
    return well;
}

static bool make_sheets(struct pile *pile, struct error *error) {
    struct random random = {5};
    if (!pile_allocate(pile, SHEET_COUNT, error)) {
        return false;
    }
    for (int i = 0; i < SHEET_COUNT; i++) {
        struct vertex v[3];
        for (int k = 0; k < 3; k++) {
            v[k].position.x = (int32_t)random_between(&random, 0, SIDE * SUBPIXELS);
            v[k].position.y = (int32_t)random_between(&random, 0, SIDE * SUBPIXELS);
            v[k].depth = random_real(&random, 0.4, 0.402);
        }
        pile_add(pile, v);
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

/* ---- The versions ---- */

enum { HOUSE = 0 }; /* choices 1 to 11 are the attempts */

static void draw_house(struct depth_bench *bench, const struct pile *pile) {
    struct canvas canvas = {.image = &bench->image, .depth = bench->buffer};
    depth_clear(bench->buffer, (size_t)SIDE * SIDE);
    for (size_t i = 0; i < pile->count; i++) {
        triangle(&canvas, pile->list[i].v, pile->list[i].color);
    }
}

static void draw_pile(struct depth_bench *bench, const struct pile *pile, int choice) {
    static void (*const with_buffer[])(struct image *, const struct drawn *, size_t, void *) = {
        attempt_3_mean_depth, attempt_4_cleared_to_0,     attempt_5_farthest,
        attempt_6_depth_8,    attempt_7_depth_16,         attempt_8_depth_24,
        attempt_9_float,      attempt_10_float_from_near, attempt_11_float_reversed,
    };
    struct image *image = &bench->image;
    memset(image->pixels, 0, (size_t)SIDE * SIDE * 3);
    if (choice == HOUSE) {
        draw_house(bench, pile);
    } else if (choice == 1) {
        attempt_1_file_order(image, pile->list, pile->count);
    } else if (choice == 2) {
        memcpy(bench->sorted, pile->list, pile->count * sizeof *pile->list);
        attempt_2_painter(image, bench->sorted, pile->count);
    } else {
        with_buffer[choice - 3](image, pile->list, pile->count, bench->buffer);
    }
}

static void run_bust(void *state, int choice) {
    struct depth_bench *bench = state;
    draw_pile(bench, &bench->bust, choice);
}

static void run_sheets(void *state, int choice) {
    struct depth_bench *bench = state;
    draw_pile(bench, &bench->sheets, choice);
}

/* ---- The errors ---- */

static double pile_error(struct depth_bench *bench, const struct pile *pile, int choice) {
    size_t wrong = 0;
    draw_pile(bench, pile, choice);
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

static double error_bust(void *state, int choice) {
    struct depth_bench *bench = state;
    return pile_error(bench, &bench->bust, choice);
}

static double error_sheets(void *state, int choice) {
    struct depth_bench *bench = state;
    return pile_error(bench, &bench->sheets, choice);
}

/* ---- The lesson ---- */

static bool depth_setup(void **state, struct error *error) {
    struct depth_bench *bench = calloc(1, sizeof *bench);
    *state = bench;
    if (bench == NULL) {
        return error_set(error, "out of memory for depths");
    }
    if (!image_create(&bench->image, SIDE, SIDE, IMAGE_BGR, error) ||
        !make_bust(&bench->bust, &bench->image, error) || !make_sheets(&bench->sheets, error)) {
        return false;
    }
    bench->sorted = calloc(bench->bust.count + SHEET_COUNT, sizeof *bench->sorted);
    bench->buffer = calloc((size_t)SIDE * SIDE, sizeof(double));
    if (bench->sorted == NULL || bench->buffer == NULL) {
        return error_set(error, "out of memory for a depth buffer");
    }
    pile_find_nearest(&bench->bust);
    pile_find_nearest(&bench->sheets);
    return true;
}

static void depth_teardown(void *state) {
    struct depth_bench *bench = state;
    if (bench != NULL) {
        pile_free(&bench->bust);
        pile_free(&bench->sheets);
        image_free(&bench->image);
        free(bench->sorted);
        free(bench->buffer);
    }
    free(bench);
}

static const struct bench_version bust_versions[] = {
    {"1: order of the file", 1, false, run_bust, error_bust},
    {"2: painter's order", 2, false, run_bust, error_bust},
    {"3: mean depth of a face", 3, false, run_bust, error_bust},
    {"4: cleared to 0", 4, false, run_bust, error_bust},
    {"5: farthest", 5, false, run_bust, error_bust},
    {"6: 8 bits", 6, false, run_bust, error_bust},
    {"7: 16 bits", 7, false, run_bust, error_bust},
    {"8: 24 bits", 8, false, run_bust, error_bust},
    {"9: float", 9, false, run_bust, error_bust},
    {"10: float, 1 - near/d", 10, false, run_bust, error_bust},
    {"11: float, near/d reversed", 11, false, run_bust, error_bust},
    {"double (main.c)", HOUSE, true, run_bust, error_bust},
};

static const struct bench_version sheet_versions[] = {
    {"2: painter's order", 2, false, run_sheets, error_sheets},
    {"3: mean depth of a face", 3, false, run_sheets, error_sheets},
    {"6: 8 bits", 6, false, run_sheets, error_sheets},
    {"7: 16 bits", 7, false, run_sheets, error_sheets},
    {"8: 24 bits", 8, false, run_sheets, error_sheets},
    {"9: float", 9, false, run_sheets, error_sheets},
    {"10: float, 1 - near/d", 10, false, run_sheets, error_sheets},
    {"11: float, near/d reversed", 11, false, run_sheets, error_sheets},
    {"double (main.c)", HOUSE, true, run_sheets, error_sheets},
};

static const struct bench_panel depth_panels[] = {
    {
        .title = "The lit faces of the bust, on 800x800 pixels",
        .error_label = "pixels showing the wrong triangle, per 1000",
        .time_label = "ms per frame",
        .against = "exact fractions",
        .versions = bust_versions,
        .version_count = sizeof bust_versions / sizeof bust_versions[0],
    },
    {
        .title = "60 thin sheets through each other, all within 0.002 of depth",
        .error_label = "pixels showing the wrong triangle, per 1000",
        .time_label = "ms per frame",
        .against = "exact fractions",
        .versions = sheet_versions,
        .version_count = sizeof sheet_versions / sizeof sheet_versions[0],
    },
};

const struct bench_lesson bench_step05 = {
    .step = "step05_zbuffer",
    .title = "Step 5: a depth buffer",
    .setup = depth_setup,
    .teardown = depth_teardown,
    .panels = depth_panels,
    .panel_count = sizeof depth_panels / sizeof depth_panels[0],
};
