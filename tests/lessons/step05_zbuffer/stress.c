/* Step 5: triangles with depths, depths as levels. */
#define LESSON "../step05_zbuffer/main.c"
#include "lesson.h"

#include "oracle/oracle.h"
#include "upkeep/stress/lessons.h"
#include "upkeep/stress/stress.h"

#include <string.h>

/* ---- Triangles over one another on a small screen ---- */

enum { LAYER_COUNT = 4, PIXELS = SCREEN_WIDTH * SCREEN_HEIGHT };

struct layers {
    struct fixed2 corner[LAYER_COUNT][3];
    double depth[LAYER_COUNT][3];
};

static double any_depth(struct random *random, uint64_t kind) {
    switch (kind) {
    case 0: /* many ties */
        return (double)random_between(random, -2, 2);
    case 1: /* close together, far from zero */
        return 1000 + random_real(random, -1e-9, 1e-9);
    case 2:
        return ldexp(random_real(random, -1, 1), (int)random_between(random, -300, 300));
    default:
        return random_real(random, -1, 1);
    }
}

/* Hostile triangles in depths that are often close or equal; some are copies of earlier ones. */
static void make_layers(struct random *random, uint64_t index, void *made) {
    struct layers *layers = made;
    for (int i = 0; i < LAYER_COUNT; i++) {
        random_triangle(random, random_bits(random), layers->corner[i]);
        for (int k = 0; k < 3; k++) {
            layers->depth[i][k] = any_depth(random, index % 8);
        }
        if (i > 0 && random_bits(random) % 4 == 0) {
            int earlier = (int)random_between(random, 0, i - 1);
            memcpy(layers->corner[i], layers->corner[earlier], sizeof layers->corner[i]);
            memcpy(layers->depth[i], layers->depth[earlier], sizeof layers->depth[i]);
        }
    }
}

static long double layer_depth(const struct layers *layers, int layer, int x, int y) {
    static const double no_perspective[3] = {1, 1, 1};
    return oracle_interpolate(layers->corner[layer], no_perspective, layers->depth[layer], x, y);
}

/* How far a depth of a layer may be off. */
static double depth_tolerance(const struct layers *layers, int layer) {
    const double *depth = layers->depth[layer];
    return fmax(fabs(depth[0]), fmax(fabs(depth[1]), fabs(depth[2]))) * 0x1p-49;
}

static bool layer_covers(const struct layers *layers, int layer, int x, int y) {
    const struct fixed2 *c = layers->corner[layer];
    return oracle_covers(c[0], c[1], c[2], x, y);
}

static bool is_copy(const struct layers *layers, int layer, int earlier) {
    return memcmp(layers->corner[layer], layers->corner[earlier], sizeof layers->corner[0]) == 0 &&
           memcmp(layers->depth[layer], layers->depth[earlier], sizeof layers->depth[0]) == 0;
}

static bool hides(const struct layers *layers, int front, int behind, int x, int y) {
    if (front == behind || !layer_covers(layers, front, x, y)) {
        return false;
    }
    if (front < behind && is_copy(layers, behind, front)) {
        return true;
    }
    long double front_depth = layer_depth(layers, front, x, y);
    long double behind_depth = layer_depth(layers, behind, x, y);
    long double tolerance = depth_tolerance(layers, front) + depth_tolerance(layers, behind);
    return front_depth > behind_depth + tolerance;
}

static bool may_show(const struct layers *layers, int layer, int x, int y) {
    bool shows = layer_covers(layers, layer, x, y);
    for (int i = 0; i < LAYER_COUNT && shows; i++) {
        shows = !hides(layers, i, layer, x, y);
    }
    return shows;
}

static uint64_t covered_pixels(const struct layers *layers) {
    uint64_t count = 0;
    for (int i = 0; i < LAYER_COUNT * PIXELS; i++) {
        int pixel = i % PIXELS;
        count += layer_covers(layers, i / PIXELS, pixel % SCREEN_WIDTH, pixel / SCREEN_WIDTH);
    }
    return count;
}

/* Does the pixel show this layer, or none where it is -1? Layer i is drawn in level i + 1. */
static bool shows_layer(const struct layers *layers, int layer, int x, int y,
                        const struct image *image, double depth) {
    struct color color = image_get(image, x, y);
    bool right = layer < 0 ? depth == -INFINITY
                           : is_near(depth, layer_depth(layers, layer, x, y),
                                     (long double)depth_tolerance(layers, layer));
    return right && color.r == layer + 1 && color.g == color.r && color.b == color.r;
}

static bool pixel_is_right(const struct layers *layers, int x, int y, const struct image *image,
                           double depth) {
    bool right = false, empty = true;
    for (int i = 0; i < LAYER_COUNT && !right; i++) {
        bool may = may_show(layers, i, x, y);
        empty = empty && !may;
        right = may && shows_layer(layers, i, x, y, image, depth);
    }
    return right || (empty && shows_layer(layers, -1, x, y, image, depth));
}

static void draw_layers(const struct layers *layers, struct canvas *canvas) {
    for (int i = 0; i < LAYER_COUNT; i++) {
        struct vertex v[3];
        for (int k = 0; k < 3; k++) {
            v[k] = (struct vertex){layers->corner[i][k], layers->depth[i][k]};
        }
        triangle(canvas, v, color_grey((uint8_t)(i + 1)));
    }
}

/* Does each pixel show a layer that may be seen there: which covers it, in front of which none is
 * by more than rounding can hide, and which is no copy of an earlier one? With its colour and its
 * depth; and all must stay when the layers are drawn again. */
static bool nearest_triangle_shows(const void *tried) {
    const struct layers *layers = tried;
    uint8_t pixels[3 * PIXELS] = {0}, once[sizeof pixels];
    double depth[PIXELS];
    struct image image = {SCREEN_WIDTH, SCREEN_HEIGHT, IMAGE_BGR, pixels};
    for (int i = 0; i < PIXELS; i++) {
        depth[i] = -INFINITY;
    }
    uint64_t covered = covered_pixels(layers);
    struct canvas canvas = {.image = &image, .depth = depth}, again = canvas;
    draw_layers(layers, &canvas);
    memcpy(once, pixels, sizeof once);
    draw_layers(layers, &again);
    bool right = memcmp(pixels, once, sizeof once) == 0 && canvas.pixels_tested == covered &&
                 again.pixels_tested == covered && again.pixels_written == 0;
    for (int i = 0; i < PIXELS && right; i++) {
        right = pixel_is_right(layers, i % SCREEN_WIDTH, i / SCREEN_WIDTH, &image, depth[i]);
    }
    return right;
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

static const struct case_kind layers_cases = {.size = sizeof(struct layers), .make = make_layers};
static const struct case_kind depths_cases = {.size = sizeof(struct depths_case),
                                              .make = make_depths};

const struct property lesson05_properties[] = {
    PROPERTY("lesson05: nearest triangle, depths", AGAINST_LONG_DOUBLE, 100000, layers_cases,
             .holds = nearest_triangle_shows),
    PROPERTY("lesson05: depths as levels", AGAINST_LONG_DOUBLE, 200000, depths_cases,
             .holds = depth_levels_are_right),
    {.name = NULL},
};
