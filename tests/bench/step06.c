/*
 * Step 6: samplers, and texture coordinates in perspective.
 *
 * The exact answer is the mean of 256 samples a pixel of what the texture is a picture of: a
 * hill of colours, given by a formula, or the tiles of scene checker, hit by rays. No triangle
 * and no texture takes part in it.
 */
#define main step06_main
int step06_main(int argc, char **argv);
#include "../../step06_texture/main.c"
#undef main

#include "../../step06_texture/attempts.h"

#include "bench.h"

#include <stdlib.h>

enum { HILL_SIDE = 512, HILL_TEXELS = 16, PLANE_SIZE = 800 };

/* A picture to draw, and its exact colours. */
struct target {
    struct image image;
    struct vertex corners[4];
    struct texture texture;
    struct vec3 *exact; /* red, green, blue of each pixel; red is negative where there is none */
    double pixels;      /* that are drawn */
};

struct work {
    struct target hill, plane;
};

/* ---- The versions ---- */

typedef void draw_function(struct image *image, const struct vertex v[3],
                           const struct texture *texture);

static void draw_house(struct image *image, const struct vertex v[3],
                       const struct texture *texture) {
    struct canvas canvas = {.image = image, .skip = true};
    perspective_triangle(&canvas, v, texture);
}

enum { ROUNDED, NEAREST, UNSHIFTED, BILINEAR, AFFINE, EVERY_16, EVERY_8, HOUSE };

static draw_function *const draws[] = {
    [ROUNDED] = attempt_1_rounded,      [NEAREST] = attempt_2_nearest,
    [UNSHIFTED] = attempt_3_unshifted,  [BILINEAR] = attempt_4_no_levels,
    [AFFINE] = attempt_8_affine_levels, [EVERY_16] = attempt_6_every_16,
    [EVERY_8] = attempt_7_every_8,      [HOUSE] = draw_house,
};

static void draw_target(struct target *target, int choice) {
    const struct vertex *c = target->corners;
    const struct vertex first[3] = {c[0], c[1], c[2]}, second[3] = {c[0], c[2], c[3]};
    draws[choice](&target->image, first, &target->texture);
    draws[choice](&target->image, second, &target->texture);
}

/* Root of the mean squared error of the three channels. */
static double target_error(struct target *target, int choice) {
    double sum = 0, pixels = 0;
    image_clear(&target->image, color_grey(0));
    draw_target(target, choice);
    for (size_t i = 0; i < target->image.width * target->image.height; i++) {
        const uint8_t *p = target->image.pixels + 3 * i;
        if (target->exact[i].x >= 0) {
            struct vec3 error = vec3_sub((struct vec3){p[2], p[1], p[0]}, target->exact[i]);
            sum += vec3_dot(error, error) / 3;
            pixels++;
        }
    }
    return sqrt(sum / pixels);
}

/* ---- The hill: smooth, so that its texels are much larger than what is to be seen ---- */

static struct vec3 hill_color(double u, double v) {
    double hill = 16 * u * (1 - u) * v * (1 - v);
    return (struct vec3){255 * hill, 255 * u, 255 * v * v};
}

/* The mean colour of one cell, when the hill is cut into side x side cells: 256 samples. */
static struct vec3 hill_mean(size_t column, size_t row, size_t side) {
    struct vec3 sum = {0, 0, 0};
    for (int i = 0; i < EXACT_SIDE * EXACT_SIDE; i++) {
        int across = i % EXACT_SIDE, up = i / EXACT_SIDE;
        double u = (double)column + (across + 0.5) / EXACT_SIDE;
        double v = (double)row + (up + 0.5) / EXACT_SIDE;
        sum = vec3_add(sum, hill_color(u / (double)side, v / (double)side));
    }
    return vec3_scale(sum, 1.0 / (EXACT_SIDE * EXACT_SIDE));
}

static bool make_hill_texture(struct texture *texture, struct error *error) {
    struct image image;
    if (!image_create(&image, HILL_TEXELS, HILL_TEXELS, IMAGE_BGR, error)) {
        return false;
    }
    for (size_t y = 0; y < HILL_TEXELS; y++) {
        for (size_t x = 0; x < HILL_TEXELS; x++) {
            struct vec3 c = hill_mean(x, y, HILL_TEXELS);
            image_set(&image, (int)x, (int)y,
                      color_rgb(level_from(c.x), level_from(c.y), level_from(c.z)));
        }
    }
    bool done = texture_create(texture, &image, error);
    image_free(&image);
    return done;
}

/* ---- Setting up ---- */

static bool target_create(struct target *target, size_t side, struct error *error) {
    target->exact = malloc(side * side * sizeof *target->exact);
    if (target->exact == NULL) {
        return error_out_of_memory(error);
    }
    return image_create(&target->image, side, side, IMAGE_BGR, error);
}

static void target_free(struct target *target) {
    image_free(&target->image);
    texture_free(&target->texture);
    free(target->exact);
}

static bool make_hill(struct target *hill, struct error *error) {
    if (!target_create(hill, HILL_SIDE, error) || !make_hill_texture(&hill->texture, error)) {
        return false;
    }
    const int32_t end = HILL_SIDE * SUBPIXELS;
    hill->corners[0] = (struct vertex){.position = {0, 0}, .uv = {0, 0}, .recip_w = 1};
    hill->corners[1] = (struct vertex){.position = {end, 0}, .uv = {1, 0}, .recip_w = 1};
    hill->corners[2] = (struct vertex){.position = {end, end}, .uv = {1, 1}, .recip_w = 1};
    hill->corners[3] = (struct vertex){.position = {0, end}, .uv = {0, 1}, .recip_w = 1};
    for (size_t i = 0; i < (size_t)HILL_SIDE * HILL_SIDE; i++) {
        hill->exact[i] = hill_mean(i % HILL_SIDE, i / HILL_SIDE, HILL_SIDE);
    }
    hill->pixels = (double)HILL_SIDE * HILL_SIDE;
    return true;
}

static bool make_plane(struct target *plane, struct error *error) {
    if (!target_create(plane, PLANE_SIZE, error) || !make_checker(&plane->texture, error)) {
        return false;
    }
    place_plane(&plane->image, plane->corners);
#ifdef _OPENMP
#pragma omp parallel for schedule(dynamic)
#endif
    for (int y = 0; y < PLANE_SIZE; y++) {
        for (int x = 0; x < PLANE_SIZE; x++) {
            struct vec3 *exact = &plane->exact[y * PLANE_SIZE + x];
            if (!exact_checker((size_t)x, (size_t)y, PLANE_SIZE, PLANE_SIZE, exact)) {
                *exact = (struct vec3){-1, -1, -1};
            }
        }
    }
    draw_target(plane, HOUSE);
    for (size_t i = 0; i < (size_t)PLANE_SIZE * PLANE_SIZE; i++) {
        plane->pixels += plane->image.pixels[3 * i] != 0; /* no colour of a tile has blue 0 */
    }
    return true;
}

static bool setup(void **state, struct error *error) {
    struct work *work = calloc(1, sizeof *work);
    *state = work;
    if (work == NULL) {
        return error_out_of_memory(error);
    }
    return make_hill(&work->hill, error) && make_plane(&work->plane, error);
}

static void teardown(void *state) {
    struct work *work = state;
    if (work != NULL) {
        target_free(&work->hill);
        target_free(&work->plane);
    }
    free(work);
}

/* ---- The panels ---- */

static void run_hill(void *state, int choice) {
    draw_target(&((struct work *)state)->hill, choice);
}

static double error_hill(void *state, int choice) {
    return target_error(&((struct work *)state)->hill, choice);
}

static double units_hill(const void *state) {
    return ((const struct work *)state)->hill.pixels;
}

static void run_plane(void *state, int choice) {
    draw_target(&((struct work *)state)->plane, choice);
}

static double error_plane(void *state, int choice) {
    return target_error(&((struct work *)state)->plane, choice);
}

static double units_plane(const void *state) {
    return ((const struct work *)state)->plane.pixels;
}

#define HILL(label, number)                                                                        \
    { .name = (label), .choice = (number), .run = run_hill, .error = error_hill }
#define PLANE(label, number)                                                                       \
    { .name = (label), .choice = (number), .run = run_plane, .error = error_plane }
#define HOUSE_OF(of)                                                                               \
    {                                                                                              \
        .name = "mip levels", .choice = HOUSE, .is_house = true, .run = run_##of,                  \
        .error = error_##of                                                                        \
    }

static const struct bench_version near_versions[] = {
    HILL("nearest, rounding", ROUNDED),
    HILL("nearest, floor", NEAREST),
    HILL("bilinear, half texel off", UNSHIFTED),
    HILL("bilinear", BILINEAR),
    HOUSE_OF(hill),
};

static const struct bench_version far_versions[] = {
    PLANE("nearest, rounding", ROUNDED),
    PLANE("nearest, floor", NEAREST),
    PLANE("bilinear, half texel off", UNSHIFTED),
    PLANE("bilinear", BILINEAR),
    HOUSE_OF(plane),
};

static const struct bench_version perspective_versions[] = {
    PLANE("affine", AFFINE),
    PLANE("divided every 16 pixels", EVERY_16),
    PLANE("divided every 8 pixels", EVERY_8),
    {.name = "divided at every pixel",
     .choice = HOUSE,
     .is_house = true,
     .run = run_plane,
     .error = error_plane},
};

static const struct bench_panel bench_panels[] = {
    {.title = "Near: 16x16 texels, enlarged to 512x512 pixels",
     .error_label = "levels, root mean square",
     .time_label = "ns per pixel",
     .against = "256 samples a pixel",
     .units = units_hill,
     .versions = near_versions,
     .version_count = sizeof near_versions / sizeof near_versions[0]},
    {.title = "Far: tiles towards the horizon, 800x800 pixels",
     .error_label = "levels, root mean square",
     .time_label = "ns per pixel",
     .against = "256 rays a pixel",
     .units = units_plane,
     .versions = far_versions,
     .version_count = sizeof far_versions / sizeof far_versions[0],
     .budget = 2},
    {.title = "Perspective: the same tiles, all with mip levels",
     .error_label = "levels, root mean square",
     .time_label = "ns per pixel",
     .against = "256 rays a pixel",
     .units = units_plane,
     .versions = perspective_versions,
     .version_count = sizeof perspective_versions / sizeof perspective_versions[0],
     .budget = 2},
};

const struct bench_lesson bench_step06 = {
    .step = "step06_texture",
    .title = "Step 6: textures",
    .setup = setup,
    .teardown = teardown,
    .panels = bench_panels,
    .panel_count = sizeof bench_panels / sizeof bench_panels[0],
};
