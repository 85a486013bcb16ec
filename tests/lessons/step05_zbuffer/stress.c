/* Step 5: segments in one row, triangles with depths, depths as levels. */
#define LESSON "../step05_zbuffer/main.c"
#include "lesson.h"

#include "upkeep/stress/lessons.h"
#include "upkeep/stress/stress.h"

#include <stdio.h>
#include <string.h>

/* ---- One row: depths as fractions ---- */

enum { SEGMENTS = 5 };

/* In quarters of a pixel along the row and whole depths. */
struct row_case {
    struct {
        int left, right; /* left < right */
        int left_depth, right_depth;
    } segment[SEGMENTS];
};

static void make_row(struct random *random, uint64_t index, void *made) {
    struct row_case *c = made;
    int64_t reach = index % 3 == 0 ? 1000000 : 20, spread = index % 2 ? 3 : 1000000;
    for (int i = 0; i < SEGMENTS; i++) {
        int left = (int)random_between(random, -reach, 4 * SCREEN_WIDTH - 1);
        c->segment[i].left = left;
        c->segment[i].right = (int)random_between(random, left + 1, 4 * SCREEN_WIDTH + reach);
        c->segment[i].left_depth = (int)random_between(random, -spread, spread);
        c->segment[i].right_depth = random_bits(random) % 2
                                        ? c->segment[i].left_depth
                                        : (int)random_between(random, -spread, spread);
        if (i > 0 && random_bits(random) % 4 == 0) {
            c->segment[i] = c->segment[random_between(random, 0, i - 1)];
        }
    }
}

/* Is pixel x covered? Its centre is at 4 x + 2 quarters. */
static bool row_covers(const struct row_case *c, int i, int x) {
    return c->segment[i].left <= 4 * x + 2 && 4 * x + 2 < c->segment[i].right;
}

/* Depth at the centre of pixel x, times `length`. */
struct fraction {
    int64_t depth, length;
};

static struct fraction row_depth(const struct row_case *c, int i, int x) {
    int64_t from_left = 4 * (int64_t)x + 2 - c->segment[i].left;
    int64_t length = (int64_t)c->segment[i].right - c->segment[i].left;
    int64_t rise = (int64_t)c->segment[i].right_depth - c->segment[i].left_depth;
    return (struct fraction){c->segment[i].left_depth * length + rise * from_left, length};
}

/* The first of those that are nearest. */
static int exact_nearest(const struct row_case *c, int x) {
    int nearest = -1;
    for (int i = 0; i < SEGMENTS; i++) {
        if (!row_covers(c, i, x)) {
            continue;
        }
        struct fraction here = row_depth(c, i, x), best = {0, 1};
        if (nearest >= 0) {
            best = row_depth(c, nearest, x);
        }
        if (nearest < 0 || here.depth * best.length > best.depth * here.length) {
            nearest = i;
        }
    }
    return nearest;
}

static long double real_depth(const struct row_case *c, int i, int x) {
    struct fraction f = row_depth(c, i, x);
    return (long double)f.depth / (long double)f.length;
}

static const long double row_tolerance = 0x1p-50L * 1000000; /* what rounding may do to a depth */

/* Of two sloping segments that meet in a pixel rounding decides; level ones are exact in doubles
 * too, and so are equal ones: there the first stays. */
static bool may_be_seen(const struct row_case *c, int seen, int nearest, int x) {
    bool level = c->segment[seen].left_depth == c->segment[seen].right_depth &&
                 c->segment[nearest].left_depth == c->segment[nearest].right_depth;
    bool copy = memcmp(&c->segment[seen], &c->segment[nearest], sizeof c->segment[0]) == 0;
    long double behind = real_depth(c, nearest, x) - real_depth(c, seen, x);
    return seen == nearest || (!level && !copy && behind <= 2 * row_tolerance);
}

static bool row_is_right(const void *tried) {
    const struct row_case *c = tried;
    uint8_t pixels[3 * 3 * SCREEN_WIDTH] = {0};
    struct image image = {SCREEN_WIDTH, 3, IMAGE_BGR, pixels};
    double depths[SCREEN_WIDTH];
    depth_clear(depths, SCREEN_WIDTH);
    for (int i = 0; i < SEGMENTS; i++) {
        struct segment s = {.a = {c->segment[i].left / 4.0, c->segment[i].left_depth},
                            .b = {c->segment[i].right / 4.0, c->segment[i].right_depth},
                            .color = color_grey((uint8_t)(i + 1))};
        draw_segment(&s, &image, 1, depths);
    }
    for (int x = 0; x < SCREEN_WIDTH; x++) {
        int seen = image_get(&image, x, 1).g - 1, nearest = exact_nearest(c, x);
        bool beside = image_get(&image, x, 0).g != 0 || image_get(&image, x, 2).g != 0;
        if (beside || (seen < 0) != (nearest < 0)) {
            return false;
        }
        if (nearest < 0) {
            if (depths[x] != -INFINITY) {
                return false;
            }
            continue;
        }
        long double error = real_depth(c, nearest, x) - (long double)depths[x];
        if (!may_be_seen(c, seen, nearest, x) || !(fabsl(error) <= 2 * row_tolerance)) {
            return false;
        }
    }
    return true;
}

static void print_row(const void *failing) {
    const struct row_case *c = failing;
    for (int i = 0; i < SEGMENTS; i++) {
        printf("    segment (%g %d) to (%g %d)\n", c->segment[i].left / 4.0,
               c->segment[i].left_depth, c->segment[i].right / 4.0, c->segment[i].right_depth);
    }
}

/* ---- Triangles ---- */

static void make_layers_case(struct random *random, uint64_t index, void *made) {
    make_layers(random, index, made);
}

static void print_layers_case(const void *failing) {
    print_layers(failing);
}

/* What one pixel shows and its depth. */
static bool pixel_is_right(const struct layers *layers, int x, int y, int seen, double depth) {
    if (seen >= 0) {
        long double exact = layer_value(layers, seen, layers->depth[seen], x, y);
        return layer_may_show(layers, seen, x, y) &&
               fabsl(exact - (long double)depth) <= (long double)layer_tolerance(layers, seen);
    }
    for (int i = 0; i < LAYER_COUNT; i++) {
        if (layer_may_show(layers, i, x, y)) {
            return false;
        }
    }
    return depth == -INFINITY;
}

static bool nearest_triangle_shows(const void *tried) {
    const struct layers *layers = tried;
    enum { PIXELS = SCREEN_WIDTH * SCREEN_HEIGHT };
    uint8_t pixels[3 * PIXELS] = {0};
    double depth[PIXELS];
    struct image image = {SCREEN_WIDTH, SCREEN_HEIGHT, IMAGE_BGR, pixels};
    struct canvas canvas = {.image = &image, .depth = depth};
    depth_clear(depth, PIXELS);
    for (int i = 0; i < LAYER_COUNT; i++) {
        struct vertex v[3];
        for (int k = 0; k < 3; k++) {
            v[k] = (struct vertex){layers->corner[i][k], layers->depth[i][k]};
        }
        triangle(&canvas, v, color_grey((uint8_t)(i + 1)));
    }
    uint64_t shown = 0;
    for (int i = 0; i < PIXELS; i++) {
        shown += pixels[3 * i] != 0;
        if (!pixel_is_right(layers, i % SCREEN_WIDTH, i / SCREEN_WIDTH, pixels[3 * i] - 1,
                            depth[i])) {
            return false;
        }
    }
    return canvas.pixels_tested == layers_pixel_count(layers) && canvas.pixels_written >= shown &&
           canvas.pixels_written <= canvas.pixels_tested;
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
    memset(pixels, 99, sizeof pixels);
    show_depths(&image, c->depth);
    for (int i = 0; i < DEPTHS; i++) {
        long double far = c->depth[i], near = c->depth[i];
        for (int k = 0; k < DEPTHS; k++) {
            if (c->depth[k] != -INFINITY) {
                far = fminl(far, c->depth[k]);
                near = fmaxl(near, c->depth[k]);
            }
        }
        long double share = near > far ? ((long double)c->depth[i] - far) / (near - far) : 0;
        if (c->depth[i] == -INFINITY ? pixels[i] != 0
                                     : !level_is_right(pixels[i], 55 + 200 * share)) {
            return false;
        }
    }
    return true;
}

static void print_depths(const void *failing) {
    const struct depths_case *c = failing;
    for (int i = 0; i < DEPTHS; i++) {
        printf(i % DEPTHS_WIDTH == DEPTHS_WIDTH - 1 ? " %.17g\n" : "    %.17g", c->depth[i]);
    }
}

static const struct case_kind row_cases = {sizeof(struct row_case), make_row, print_row, NULL};
static const struct case_kind layers_cases = {sizeof(struct layers), make_layers_case,
                                              print_layers_case, NULL};
static const struct case_kind depths_cases = {sizeof(struct depths_case), make_depths, print_depths,
                                              NULL};

const struct property lesson05_properties[] = {
    PROPERTY("lesson05: one row of depths", AGAINST_FRACTIONS, 300000, row_cases,
             .holds = row_is_right),
    PROPERTY("lesson05: nearest triangle, depths", AGAINST_LONG_DOUBLE, 100000, layers_cases,
             .holds = nearest_triangle_shows),
    PROPERTY("lesson05: depths as levels", AGAINST_LONG_DOUBLE, 200000, depths_cases,
             .holds = depth_levels_are_right),
    {.name = NULL},
};
