/* Lesson 5: triangles with depths, depths as levels. */
#define LESSON "../step05_zbuffer/main.c"
#include "lesson.h"

#include "upkeep/stress/lessons.h"
#include "upkeep/stress/stress.h"

#include <string.h>

/* ---- Triangles ---- */

/* Returns what it did. */
static struct canvas draw_on(const struct layers *layers, struct image *image, double *depth) {
    struct canvas canvas = {.image = image, .depth = depth};
    for (int i = 0; i < LAYER_COUNT; i++) {
        struct vertex v[3];
        for (int k = 0; k < 3; k++) {
            v[k] = (struct vertex){layers->corner[i][k], layers->depth[i][k]};
        }
        triangle(&canvas, v, color_grey((uint8_t)(i + 1)));
    }
    return canvas;
}

static void draw_layers(const void *tried, struct image *image, double *depth) {
    draw_on(tried, image, depth);
}

static bool is_level(const void *tried, int layer, int picture, int x, int y, struct color color) {
    (void)tried, (void)picture, (void)x, (void)y;
    return color.r == layer + 1 && color.g == color.r && color.b == color.r;
}

/* Each covered pixel is tested once for each triangle, and drawn again none is written. */
static bool counts_are_right(const struct layers *layers) {
    uint8_t pixels[3 * SCREEN_WIDTH * SCREEN_HEIGHT] = {0};
    double depth[SCREEN_WIDTH * SCREEN_HEIGHT];
    struct image image = {SCREEN_WIDTH, SCREEN_HEIGHT, IMAGE_BGR, pixels};
    depth_clear(depth, SCREEN_WIDTH * SCREEN_HEIGHT);
    const struct canvas first = draw_on(layers, &image, depth);
    const struct canvas again = draw_on(layers, &image, depth);
    return first.pixels_tested == layers_cover(layers) &&
           again.pixels_tested == first.pixels_tested && again.pixels_written == 0;
}

static bool nearest_triangle_shows(const void *tried) {
    const struct layered layered = {tried, tried, 1, draw_layers, is_level};
    return layers_are_right(&layered) && counts_are_right(tried);
}

/* ---- Depths as levels ---- */

enum { DEPTHS_WIDTH = 5, DEPTHS_HEIGHT = 3, DEPTHS = DEPTHS_WIDTH * DEPTHS_HEIGHT };

struct depths_case {
    double depth[DEPTHS];
};

static void make_depths(struct random *random, uint64_t index, void *made) {
    struct depths_case *c = made;
    int exponent = (int)random_between(random, -900, 900);
    double base = random_real(random, -1, 1);
    for (int i = 0; i < DEPTHS; i++) {
        double depth = index % 3 == 0   ? random_real(random, -1, 1)
                       : index % 3 == 1 ? ldexp(random_real(random, -1, 1), exponent)
                                        : base;
        bool nothing = random_bits(random) % 4 == 0 || index % 64 == 0;
        c->depth[i] = nothing ? -INFINITY : depth;
    }
}

static bool depth_levels_are_right(const void *tried) {
    const struct depths_case *c = tried;
    uint8_t pixels[DEPTHS];
    struct image image = {DEPTHS_WIDTH, DEPTHS_HEIGHT, IMAGE_GREY, pixels};
    long double far = (long double)INFINITY, near = (long double)-INFINITY;
    for (int i = 0; i < DEPTHS; i++) {
        far = c->depth[i] != -INFINITY ? fminl(far, c->depth[i]) : far;
        near = fmaxl(near, c->depth[i]);
    }
    memset(pixels, 99, sizeof pixels);
    show_depths(&image, c->depth);
    bool right = true;
    for (int i = 0; i < DEPTHS; i++) {
        long double share = near > far ? ((long double)c->depth[i] - far) / (near - far) : 0;
        right = right && (c->depth[i] == -INFINITY ? pixels[i] == 0
                                                   : level_is_right(pixels[i], 55 + 200 * share));
    }
    return right;
}

const struct property lesson05_properties[] = {
    PROPERTY("lesson05: nearest triangle, depths", AGAINST_LONG_DOUBLE, 100000, struct layers,
             make_layers, .holds = nearest_triangle_shows),
    PROPERTY("lesson05: depths as levels", AGAINST_LONG_DOUBLE, 200000, struct depths_case,
             make_depths, .holds = depth_levels_are_right),
    {.name = NULL},
};
