/* Lesson 5: triangles with depths, depths as levels. */
#define LESSON "../step05_zbuffer/main.c"
#include "lesson.h"

#include "upkeep/stress/lessons.h"
#include "upkeep/stress/stress.h"

#include <stdlib.h>
#include <string.h>

/* ---- Triangles ---- */

/* Returns what it did. */
static struct canvas draw_on(const struct layers *layers, struct image *image, double *depth) {
    struct canvas canvas = {.image = image};
    canvas.depth = depth;
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

/* ---- Lines with depths ---- */

enum { WIRED_WIDTH = 13, WIRED_HEIGHT = 11, WIRED = WIRED_WIDTH * WIRED_HEIGHT };

struct wired_case {
    struct line_case line;
    double depth_a, depth_b, before[WIRED];
};

static void make_wired(struct random *random, uint64_t index, void *made) {
    struct wired_case *c = made;
    double scale = ldexp(1, (int)random_between(random, -300, 300)), depth[2 + WIRED];
    make_any_line(random, random_bits(random), &c->line);
    for (int i = 0; i < 2 + WIRED; i++) {
        depth[i] = index % 3 == 0   ? (double)random_between(random, -2, 2)
                   : index % 3 == 1 ? scale * random_real(random, -1, 1)
                                    : 1000 + random_real(random, -1e-9, 1e-9);
    }
    c->depth_a = depth[0];
    c->depth_b = random_bits(random) % 8 == 0 ? depth[0] : depth[1];
    for (int i = 0; i < WIRED; i++) {
        c->before[i] = random_bits(random) % 8 == 0 ? -INFINITY : depth[2 + i];
    }
}

/* At a pixel: the mean of the depths at both ends, each weighed by the way to the other one. */
static long double wired_depth(const struct wired_case *c, int x, int y) {
    struct pixel a = c->line.a, b = c->line.b;
    bool along_x = labs((long)b.x - a.x) >= labs((long)b.y - a.y);
    long double from_a = along_x ? x - a.x : y - a.y, to_b = along_x ? b.x - x : b.y - y;
    return from_a + to_b == 0 ? (long double)c->depth_a
                              : (to_b * c->depth_a + from_a * c->depth_b) / (from_a + to_b);
}

static bool nearer_pixels_of_line_show(const void *tried) {
    const struct wired_case *c = tried;
    uint8_t pixels[WIRED] = {0};
    double depth[WIRED];
    struct image image = {WIRED_WIDTH, WIRED_HEIGHT, IMAGE_GREY, pixels};
    struct canvas canvas = {.image = &image, .depth = depth};
    memcpy(depth, c->before, sizeof depth);
    hidden_line(&canvas, (struct line_end){c->line.a, c->depth_a},
                (struct line_end){c->line.b, c->depth_b}, color_grey(1));
    bool right = true;
    for (int i = 0; i < WIRED && right; i++) {
        struct pixel p = {i % WIRED_WIDTH, i / WIRED_WIDTH};
        bool has = oracle_line_has(c->line.a, c->line.b, p), drawn = pixels[i] == 1;
        long double exact = has ? wired_depth(c, p.x, p.y) : (long double)-INFINITY;
        long double slack = 0x1p-50L * fmaxl(fabsl(c->depth_a), fabsl(c->depth_b));
        right = drawn ? has && is_near(depth[i], exact, slack) && exact >= c->before[i] - slack
                      : depth[i] == c->before[i] && !(exact > c->before[i] + slack);
    }
    return right;
}

const struct property lesson05_properties[] = {
    PROPERTY("lesson05: nearest triangle, depths", AGAINST_LONG_DOUBLE, 100000, struct layers,
             make_layers, .holds = nearest_triangle_shows),
    PROPERTY("lesson05: depths as levels", AGAINST_LONG_DOUBLE, 200000, struct depths_case,
             make_depths, .holds = depth_levels_are_right),
    PROPERTY("lesson05: nearer pixels of a line", AGAINST_LONG_DOUBLE, 200000, struct wired_case,
             make_wired, .holds = nearer_pixels_of_line_show),
    {.name = NULL},
};
