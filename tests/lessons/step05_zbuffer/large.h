/*
 * Lesson 5: large triangles that the painter cannot order, and how they look when they are cut into
 * smaller ones. Include attempts.h first.
 */
#ifndef TESTS_LESSONS_STEP05_ZBUFFER_LARGE_H
#define TESTS_LESSONS_STEP05_ZBUFFER_LARGE_H

enum {
    LARGE_WIDTH = 260, /* of one of the three pictures, in pixels */
    LARGE_HEIGHT = 250,
    LARGE_CUTS = 12, /* at most: a triangle becomes cuts * cuts */
    LARGE_COUNT = 4 * LARGE_CUTS * LARGE_CUTS
};

/* A corner at x, y and a depth, in pixels of the first picture. */
struct large_corner {
    double x, y, depth;
};

/* The triangles, and how to place them: `left` pixels to the right, everything `scale` as large. */
struct large {
    struct drawn list[LARGE_COUNT];
    size_t count;
    int cuts;
    double left, scale;
};

static struct vertex large_vertex(const struct large *large, struct large_corner corner) {
    struct vertex v = {.depth = corner.depth};
    const struct vec2 at = {(large->left + corner.x) * large->scale, corner.y * large->scale};
    screen_snap(at, &v.position); /* always within the limit here */
    return v;
}

/* The corner i of `cuts` steps from a to b, and j to c. */
static struct vertex large_between(const struct large *large, const struct large_corner t[3], int i,
                                   int j) {
    const double b = (double)i / large->cuts, c = (double)j / large->cuts;
    return large_vertex(
        large, (struct large_corner){t[0].x + b * (t[1].x - t[0].x) + c * (t[2].x - t[0].x),
                                     t[0].y + b * (t[1].y - t[0].y) + c * (t[2].y - t[0].y),
                                     t[0].depth + b * (t[1].depth - t[0].depth) +
                                         c * (t[2].depth - t[0].depth)});
}

static void large_add(struct large *large, struct vertex a, struct vertex b, struct vertex c,
                      struct color color) {
    large->list[large->count++] = (struct drawn){{a, b, c}, color};
}

/* Add a triangle, cut. */
static void large_cut(struct large *large, const struct large_corner t[3], struct color color) {
    for (int j = 0; j < large->cuts; j++) {
        for (int i = 0; i + j < large->cuts; i++) {
            const struct vertex right = large_between(large, t, i + 1, j),
                                up = large_between(large, t, i, j + 1);
            large_add(large, large_between(large, t, i, j), right, up, color);
            if (i + j + 1 < large->cuts) {
                large_add(large, right, large_between(large, t, i + 1, j + 1), up, color);
            }
        }
    }
}

/* Three bars, each over the next: the thick end is near, the point is far. */
static void large_bars(struct large *large) {
    static const struct vec2 corner[3] = {{-70, -10}, {-70, -70}, {130, -45}};
    static const double depth[3] = {0.5, 0.5, -0.5};
    static const double cosine[3] = {1, -0.5, -0.5};
    static const double sine[3] = {0, 0.8660254037844386, -0.8660254037844386};
    const struct color color[3] = {color_rgb(220, 60, 50), color_rgb(60, 170, 70),
                                   color_rgb(60, 90, 220)};
    large->count = 0;
    for (int i = 0; i < 3; i++) {
        struct large_corner t[3];
        for (int k = 0; k < 3; k++) {
            const struct vec2 c = corner[k];
            t[k] = (struct large_corner){118 + c.x * cosine[i] - c.y * sine[i],
                                         105 + c.x * sine[i] + c.y * cosine[i], depth[k]};
        }
        large_cut(large, t, color[i]);
    }
}

/* A floor seen from obliquely above, of two triangles: its depth falls from 0.9 at the bottom of
 * the picture to -0.9 at the top. The trees on it are upright, so each has one depth. */
static void large_trees(struct large *large) {
    static const struct vec2 foot[] = {{60, 150}, {130, 120}, {205, 140},
                                       {170, 85}, {90, 60},   {220, 40}};
    const struct large_corner a = {10, 10, 0.9}, b = {250, 10, 0.9};
    const struct large_corner c = {250, 190, -0.9}, d = {10, 190, -0.9};
    large->count = 0;
    large_cut(large, (struct large_corner[]){a, b, c}, color_rgb(170, 140, 100));
    large_cut(large, (struct large_corner[]){a, c, d}, color_rgb(190, 160, 120));
    for (size_t i = 0; i < sizeof foot / sizeof foot[0]; i++) {
        const double x = foot[i].x, y = foot[i].y, depth = 0.9 - 1.8 * (y - 10) / 180;
        large_add(large, large_vertex(large, (struct large_corner){x - 16, y, depth}),
                  large_vertex(large, (struct large_corner){x + 16, y, depth}),
                  large_vertex(large, (struct large_corner){x, y + 55, depth}),
                  color_rgb(30, (uint8_t)(110 + 20 * i), 60));
    }
}

/* The three pictures: with a depth buffer, by the painter, by mean depth. Sets how many pixels of
 * the latter two differ from the first. `depth` has room for a double for each pixel of the image,
 * all minus infinity. */
static void large_draw(void (*make)(struct large *), int cuts, struct image *image, double *depth,
                       size_t wrong[2]) {
    static struct large large;
    struct canvas canvas = {.image = image, .depth = depth};
    const size_t width = image->width / 3;
    large.cuts = cuts;
    large.scale = (double)image->height / LARGE_HEIGHT;
    for (int i = 0; i < 3; i++) {
        large.left = i * LARGE_WIDTH;
        make(&large);
        if (i == 0) {
            for (size_t k = 0; k < large.count; k++) {
                triangle(&canvas, large.list[k].v, large.list[k].color);
            }
        } else if (i == 1) {
            attempt_2_painter(image, large.list, large.count);
        } else {
            attempt_3_mean_depth(image, large.list, large.count, depth);
        }
    }
    for (size_t i = 0; i < 2; i++) {
        wrong[i] = 0;
        for (size_t k = 0; k < width * image->height; k++) {
            const int x = (int)(k % width), y = (int)(k / width);
            const struct color a = image_get(image, x, y),
                               b = image_get(image, x + (int)((i + 1) * width), y);
            wrong[i] += memcmp(&a, &b, sizeof a) != 0;
        }
    }
}

#endif
