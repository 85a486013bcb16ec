/*
 * Step 7: flat, Gouraud, or a normal per pixel, on spheres of few and of many triangles.
 *
 * The exact answer is the true sphere in long double: its normal is the point itself.
 */
#define main step07_main
int step07_main(int argc, char **argv);
#include "../../step07_gouraud/main.c"
#undef main

#include "../../step07_gouraud/attempts.h"

#include "bench.h"

#include <stdlib.h>

enum { SIDE = 512 };

struct work {
    struct image image;
    double *depth;
    struct vec3 light;  /* of length 1, towards the light */
    long double *exact; /* level of each pixel of the sphere; negative off the sphere */
    double pixels;      /* of the sphere */
};

/* ---- The versions: a way to shade, and how often the triangles are cut into four ---- */

enum { FLAT, GOURAUD, NORMAL, SHORT, LATE, WAYS };

static attempt_function *const ways[WAYS] = {
    [FLAT] = attempt_1_flat,   [GOURAUD] = attempt_2_gouraud, [NORMAL] = attempt_3_normal,
    [SHORT] = attempt_4_short, [LATE] = attempt_5_late,
};

#define CHOICE(way, times) ((way) + WAYS * (times))

static void run(void *state, int choice) {
    struct work *work = state;
    struct canvas canvas = {
        .image = &work->image, .width = SIDE, .height = SIDE, .depth = work->depth, .skip = true};
    attempt_sphere(&canvas, choice / WAYS, work->light, ways[choice % WAYS]);
}

/* Root of the mean squared error over the pixels that the sphere and its triangles share. */
static double error_of(void *state, int choice) {
    struct work *work = state;
    long double sum = 0, pixels = 0;
    run(state, choice);
    for (size_t i = 0; i < (size_t)SIDE * SIDE; i++) {
        if (work->exact[i] >= 0 && work->depth[i] > -INFINITY) {
            long double error = work->image.pixels[i] - work->exact[i];
            sum += error * error;
            pixels++;
        }
    }
    return (double)sqrtl(sum / pixels);
}

static double units(const void *state) {
    return ((const struct work *)state)->pixels;
}

/* ---- Setting up ---- */

/* The level of the true sphere at the centre of a pixel; negative off the sphere. */
static long double sphere_level(int x, int y, struct vec3 light) {
    long double nx = (2 * (x + 0.5L) / SIDE - 1) / SPHERE_RADIUS;
    long double ny = (2 * (y + 0.5L) / SIDE - 1) / SPHERE_RADIUS;
    long double square = 1 - nx * nx - ny * ny;
    if (square < 0) {
        return -1;
    }
    long double cosine = nx * light.x + ny * light.y + sqrtl(square) * light.z;
    return cosine > 0 ? 255 * cosine : 0;
}

static bool setup(void **state, struct error *error) {
    struct work *work = calloc(1, sizeof *work);
    *state = work;
    if (work == NULL) {
        return error_out_of_memory(error);
    }
    work->light = vec3_normalized((struct vec3){1, 2, 2});
    work->depth = malloc((size_t)SIDE * SIDE * sizeof *work->depth);
    work->exact = malloc((size_t)SIDE * SIDE * sizeof *work->exact);
    if (work->depth == NULL || work->exact == NULL) {
        return error_out_of_memory(error);
    }
    for (int i = 0; i < SIDE * SIDE; i++) {
        work->exact[i] = sphere_level(i % SIDE, i / SIDE, work->light);
        work->pixels += work->exact[i] >= 0;
    }
    return image_create(&work->image, SIDE, SIDE, IMAGE_GREY, error);
}

static void teardown(void *state) {
    struct work *work = state;
    if (work != NULL) {
        image_free(&work->image);
        free(work->depth);
        free(work->exact);
    }
    free(work);
}

/* ---- The panels ---- */

#define VERSION(label, way, times, house)                                                          \
    {                                                                                              \
        .name = (label), .choice = CHOICE(way, times), .is_house = (house), .run = run,            \
        .error = error_of                                                                          \
    }

static const struct bench_version mesh_versions[] = {
    VERSION("flat, 128 triangles", FLAT, 2, false),
    VERSION("flat, 512", FLAT, 3, false),
    VERSION("flat, 2048", FLAT, 4, false),
    VERSION("Gouraud, 128 triangles", GOURAUD, 2, true),
    VERSION("Gouraud, 512", GOURAUD, 3, true),
    VERSION("Gouraud, 2048", GOURAUD, 4, true),
    VERSION("normal, 128 triangles", NORMAL, 2, false),
    VERSION("normal, 512", NORMAL, 3, false),
    VERSION("normal, 2048", NORMAL, 4, false),
};

static const struct bench_version way_versions[] = {
    VERSION("flat", FLAT, 3, false),
    VERSION("Gouraud", GOURAUD, 3, true),
    VERSION("Gouraud, clamped late", LATE, 3, false),
    VERSION("normal, not renormalised", SHORT, 3, false),
    VERSION("normal per pixel", NORMAL, 3, false),
};

static const struct bench_panel bench_panels[] = {
    {.title = "A sphere of 1, 4 and 16 times the triangles, 512x512",
     .error_label = "levels, root mean square",
     .time_label = "ns per pixel of the sphere",
     .against = "the true sphere, long double",
     .units = units,
     .versions = mesh_versions,
     .version_count = sizeof mesh_versions / sizeof mesh_versions[0],
     .budget = 2},
    {.title = "All ways to shade, 512 triangles",
     .error_label = "levels, root mean square",
     .time_label = "ns per pixel of the sphere",
     .against = "the true sphere, long double",
     .units = units,
     .versions = way_versions,
     .version_count = sizeof way_versions / sizeof way_versions[0]},
};

const struct bench_lesson bench_step07 = {
    .step = "step07_gouraud",
    .title = "Step 7: light on a round body",
    .setup = setup,
    .teardown = teardown,
    .panels = bench_panels,
    .panel_count = sizeof bench_panels / sizeof bench_panels[0],
};
