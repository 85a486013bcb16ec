/*
 * Lesson 3's benchmark: ways to fill a triangle, on a mesh of small ones and on a fan of large
 * ones that reach far beyond the image. Every other side of the fan goes through many pixel
 * centres; the values at the rest need more digits than a float has.
 *
 * The error counts, triangle by triangle, the pixels drawn that the triangle does not own (on a
 * mesh: drawn twice) and those not drawn that it owns (holes), as 128-bit integers decide.
 */
#define main step03_main
int step03_main(int argc, char **argv);
#include "../../step03_triangle/main.c"
#undef main

#include "../../step03_triangle/attempts.h"

#include "bench.h"
#include "oracle.h"

#include <stdlib.h>
#include <string.h>

enum {
    SIDE = 800,      /* of the image */
    FAN_COUNT = 24,  /* triangles of the fan */
    FAN_REACH = 4008 /* pixels from its middle to its rim, in x or in y */
};

/* ---- Triangles and the pixels that they own ---- */

struct filled {
    struct fixed2 snapped[3];
    struct vec2 corner[3]; /* the same in pixels */
    int y_begin, y_end;
    struct span *rows; /* owned pixels of rows y_begin to y_end - 1, somewhere in mesh.rows */
};

struct mesh {
    struct filled *triangles;
    size_t count;
    struct span *rows; /* of all triangles */
    size_t pixel_count;
};

struct fill_bench {
    struct mesh small, large;
    struct image timed, drawn; /* IMAGE_BGR, as the scenes are */
    struct column *columns;    /* for the column scanline */
};

/* The pixels of a row or column of the image that may lie between three coordinates. */
static struct span pixels_between(int32_t a, int32_t b, int32_t c) {
    int begin = least_of(a, b, c) / SUBPIXELS - 1, end = most_of(a, b, c) / SUBPIXELS + 2;
    begin = begin > 0 ? begin : 0;
    end = end < SIDE ? end : SIDE;
    return (struct span){begin, end > begin ? end : begin};
}

static void mesh_add(struct mesh *mesh, const struct fixed2 corner[3]) {
    struct filled *t = &mesh->triangles[mesh->count++];
    for (int i = 0; i < 3; i++) {
        t->snapped[i] = corner[i];
        t->corner[i] =
            (struct vec2){(double)corner[i].x / SUBPIXELS, (double)corner[i].y / SUBPIXELS};
    }
    struct span rows = pixels_between(corner[0].y, corner[1].y, corner[2].y);
    t->y_begin = rows.begin;
    t->y_end = rows.end;
}

/* Ask the oracle for every pixel of a triangle's box. What a triangle owns in a row stands
 * together, because a triangle is convex. */
static void filled_find_rows(struct filled *t) {
    struct fixed2 a = t->snapped[0], b = t->snapped[1], c = t->snapped[2];
    struct span columns = pixels_between(a.x, b.x, c.x);
    for (int y = t->y_begin; y < t->y_end; y++) {
        struct span *row = &t->rows[y - t->y_begin];
        *row = (struct span){0, 0};
        for (int x = columns.begin; x < columns.end; x++) {
            if (oracle_covers(a, b, c, x, y)) {
                row->begin = row->end == 0 ? x : row->begin;
                row->end = x + 1;
            }
        }
    }
}

static bool mesh_find_rows(struct mesh *mesh, struct error *error) {
    size_t row_count = 0;
    for (size_t i = 0; i < mesh->count; i++) {
        row_count += (size_t)(mesh->triangles[i].y_end - mesh->triangles[i].y_begin);
    }
    mesh->rows = calloc(row_count + 1, sizeof *mesh->rows);
    if (mesh->rows == NULL) {
        return error_set(error, "out of memory for %zu rows", row_count);
    }
    struct span *next = mesh->rows;
    for (size_t i = 0; i < mesh->count; i++) {
        struct filled *t = &mesh->triangles[i];
        t->rows = next;
        filled_find_rows(t);
        next += t->y_end - t->y_begin;
    }
    for (const struct span *row = mesh->rows; row < next; row++) {
        mesh->pixel_count += (size_t)(row->end - row->begin);
    }
    return true;
}

static bool mesh_allocate(struct mesh *mesh, size_t limit, struct error *error) {
    mesh->triangles = calloc(limit + 1, sizeof *mesh->triangles);
    return mesh->triangles != NULL || error_set(error, "out of memory for %zu triangles", limit);
}

static void mesh_free(struct mesh *mesh) {
    free(mesh->triangles);
    free(mesh->rows);
}

/* The faces of the bust that are turned to us. */
static bool make_small(struct mesh *mesh, const struct image *image, struct error *error) {
    struct model model;
    bool well =
        bench_read_model(&model, "bust.obj", error) && mesh_allocate(mesh, model.face_count, error);
    for (size_t face = 0; well && face < model.face_count; face++) {
        struct fixed2 corner[3];
        if (place_face(&model, face, image, corner) && !is_turned_away(corner)) {
            mesh_add(mesh, corner);
        }
    }
    model_free(&model);
    return well && mesh_find_rows(mesh, error);
}

/* The middle of the fan is a pixel centre, and so is every other corner on its rim, which lies
 * some whole number of times as far as a pixel centre near by: then many centres lie on the side
 * between. The rim is a square walked counterclockwise. */
static struct fixed2 fan_corner(int i, struct random *random) {
    const int side = FAN_COUNT / 4, center = SIDE / 2 * SUBPIXELS + SUBPIXELS / 2;
    int along = i % side * 2 - side; /* -side .. side - 2 along each side of the rim */
    int x = side, y = along;
    for (int turns = i / side % 4; turns > 0; turns--) {
        int kept = x;
        x = -y;
        y = kept;
    }
    int32_t scale = FAN_REACH / side * SUBPIXELS;
    int32_t stray = i % 2 != 0 ? 0 : (int32_t)random_between(random, 1, scale / 2);
    return (struct fixed2){center + x * scale + stray, center + y * scale - stray};
}

static bool make_large(struct mesh *mesh, struct error *error) {
    struct random random = {3};
    const struct fixed2 middle = {SIDE / 2 * SUBPIXELS + SUBPIXELS / 2,
                                  SIDE / 2 * SUBPIXELS + SUBPIXELS / 2};
    const struct fixed2 first = fan_corner(0, &random);
    struct fixed2 last = first;
    if (!mesh_allocate(mesh, FAN_COUNT, error)) {
        return false;
    }
    for (int i = 1; i <= FAN_COUNT; i++) {
        struct fixed2 next = i < FAN_COUNT ? fan_corner(i, &random) : first;
        mesh_add(mesh, (const struct fixed2[3]){middle, last, next});
        last = next;
    }
    return mesh_find_rows(mesh, error);
}

/* ---- The versions ---- */

enum { HOUSE = 0, COLUMNS = 9 }; /* choices 1 to 9 are the attempts */

/* The scanline over columns takes corners that are pixels. */
static void fill_columns(struct target *target, const struct filled *t, struct color color,
                         struct column *columns) {
    struct pixel corner[3];
    for (int i = 0; i < 3; i++) {
        corner[i] = (struct pixel){(int)t->corner[i].x, (int)t->corner[i].y};
    }
    attempt_9_columns(target, corner, (const struct color[3]){color, color, color}, columns);
}

static void fill(const struct filled *t, int choice, struct target *target,
                 struct column *columns) {
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
    const struct color color = color_rgb(255, 255, 255);
    if (choice == HOUSE) {
        triangle(target->image, t->snapped, color);
    } else if (choice == COLUMNS) {
        fill_columns(target, t, color, columns);
    } else {
        attempts[choice](target, t->corner, color);
    }
}

static void fill_mesh(struct fill_bench *bench, const struct mesh *mesh, int choice) {
    struct target target = {.image = &bench->timed};
    for (size_t i = 0; i < mesh->count; i++) {
        fill(&mesh->triangles[i], choice, &target, bench->columns);
    }
}

static void run_small(void *state, int choice) {
    struct fill_bench *bench = state;
    fill_mesh(bench, &bench->small, choice);
}

static void run_large(void *state, int choice) {
    struct fill_bench *bench = state;
    fill_mesh(bench, &bench->large, choice);
}

/* ---- The errors ---- */

/* Compare what was drawn with what the triangle owns, and clear it. An attempt may stray a little
 * beyond the rows of the triangle. */
static size_t count_wrong(struct image *drawn, const struct filled *t) {
    enum { STRAY = 4 };
    int y_begin = t->y_begin > STRAY ? t->y_begin - STRAY : 0;
    int y_end = t->y_end + STRAY < SIDE ? t->y_end + STRAY : SIDE;
    size_t wrong = 0;
    for (int y = y_begin; y < y_end; y++) {
        uint8_t *pixels = drawn->pixels + (size_t)y * SIDE * 3;
        bool inside = y >= t->y_begin && y < t->y_end;
        struct span owned = inside ? t->rows[y - t->y_begin] : (struct span){0, 0};
        for (int x = 0; x < SIDE; x++) {
            bool owns = x >= owned.begin && x < owned.end;
            wrong += (pixels[3 * (size_t)x] != 0) != owns;
        }
        memset(pixels, 0, (size_t)SIDE * 3);
    }
    return wrong;
}

static double mesh_error(struct fill_bench *bench, const struct mesh *mesh, int choice) {
    struct target target = {.image = &bench->drawn};
    size_t wrong = 0;
    image_clear(&bench->drawn, color_rgb(0, 0, 0));
    for (size_t i = 0; i < mesh->count; i++) {
        fill(&mesh->triangles[i], choice, &target, bench->columns);
        wrong += count_wrong(&bench->drawn, &mesh->triangles[i]);
    }
    return 1000 * (double)wrong / (double)mesh->pixel_count;
}

static double error_small(void *state, int choice) {
    struct fill_bench *bench = state;
    return mesh_error(bench, &bench->small, choice);
}

static double error_large(void *state, int choice) {
    struct fill_bench *bench = state;
    return mesh_error(bench, &bench->large, choice);
}

/* ---- The lesson ---- */

static bool fill_setup(void **state, struct error *error) {
    struct fill_bench *bench = calloc(1, sizeof *bench);
    *state = bench;
    if (bench == NULL) {
        return error_set(error, "out of memory for triangles");
    }
    bench->columns = calloc(SIDE, sizeof *bench->columns);
    if (bench->columns == NULL) {
        return error_set(error, "out of memory for columns");
    }
    return image_create(&bench->timed, SIDE, SIDE, IMAGE_BGR, error) &&
           image_create(&bench->drawn, SIDE, SIDE, IMAGE_BGR, error) &&
           make_small(&bench->small, &bench->timed, error) && make_large(&bench->large, error);
}

static void fill_teardown(void *state) {
    struct fill_bench *bench = state;
    if (bench != NULL) {
        mesh_free(&bench->small);
        mesh_free(&bench->large);
        image_free(&bench->timed);
        image_free(&bench->drawn);
        free(bench->columns);
    }
    free(bench);
}

static double small_units(const void *state) {
    return (double)((const struct fill_bench *)state)->small.pixel_count;
}

static double large_units(const void *state) {
    return (double)((const struct fill_bench *)state)->large.pixel_count;
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
    {"9: columns", COLUMNS, false, run_small, error_small},
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
    {"spans, exact (main.c)", HOUSE, true, run_large, error_large},
};

static const struct bench_panel fill_panels[] = {
    {
        .title = "Small triangles: the faces of the bust, on 800x800 pixels",
        .error_label = "pixels drawn wrongly or left out, per 1000",
        .time_label = "ns per pixel",
        .against = "128-bit integers",
        .units = small_units,
        .versions = small_versions,
        .version_count = sizeof small_versions / sizeof small_versions[0],
    },
    {
        .title = "Large triangles: a fan of 24 that reaches far beyond the image",
        .error_label = "pixels drawn wrongly or left out, per 1000",
        .time_label = "ns per pixel",
        .against = "128-bit integers",
        .units = large_units,
        .versions = large_versions,
        .version_count = sizeof large_versions / sizeof large_versions[0],
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
