/*
 * Lesson 5: worse ways to decide what is seen, and depth buffers of fewer bits. Include main.c
 * first: struct vertex comes from there.
 *
 * Depths lie in -1..1, larger is nearer. All pictures are drawn from a list of triangles, so that
 * their order can be chosen. A buffer is memory for 4 bytes a pixel, from malloc.
 */
#ifndef STEP05_ATTEMPTS_H
#define STEP05_ATTEMPTS_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* A triangle to draw. */
struct drawn {
    struct vertex v[3];
    struct color color;
};

/* One step of a depth test: is `depth` nearer than what pixel i of the buffer holds? If so, it is
 * kept there. */
typedef bool depth_test(void *buffer, size_t i, double depth);

/* The triangle of main.c with any depth test; none (NULL) draws all. */
static inline void attempt_triangle(struct image *image, const struct drawn *d, depth_test *test,
                                    void *buffer) {
    struct edges edges;
    if (!edges_setup(&edges, d->v[0].position, d->v[1].position, d->v[2].position, image->width,
                     image->height)) {
        return;
    }
    for (int y = edges.y_begin; y < edges.y_end; y++) {
        struct span span = edges_span(&edges, y);
        for (int x = span.begin; x < span.end; x++) {
            struct vec3 weight = edges_weights(&edges, x, y);
            double depth = interpolate_depth(weight, d->v[0].depth, d->v[1].depth, d->v[2].depth);
            if (test == NULL || test(buffer, (size_t)y * image->width + (size_t)x, depth)) {
                image_set(image, x, y, d->color);
            }
        }
    }
}

/* Attempt 1, without a test: the order of the list, as in lesson 4. What comes last is seen. */
static inline void attempt_draw(struct image *image, const struct drawn *list, size_t count,
                                depth_test *test, void *buffer) {
    for (size_t i = 0; i < count; i++) {
        attempt_triangle(image, &list[i], test, buffer);
    }
}

/* ---- Without a depth for each pixel ---- */

static inline double attempt_mean_depth(const struct drawn *d) {
    return (d->v[0].depth + d->v[1].depth + d->v[2].depth) / 3;
}

/* At equal depth the one farther to the left comes first, so that qsort() has no choice. */
static inline int attempt_compare_depths(const void *a, const void *b) {
    double x = attempt_mean_depth(a), y = attempt_mean_depth(b);
    int32_t a_left = ((const struct drawn *)a)->v[0].position.x;
    int32_t b_left = ((const struct drawn *)b)->v[0].position.x;
    return x != y ? (x > y) - (x < y) : (a_left > b_left) - (a_left < b_left);
}

/* Attempt 2: painter's order: sorted by mean depth, the farthest first. The list is changed.
 * Wrong where a large triangle is next to a small one, where two pass through each other, and
 * where three lie over one another in a circle: then there is no order at all. Sorting costs more
 * with every triangle, and every hidden pixel is drawn. */
static inline void attempt_2_painter(struct image *image, struct drawn *list, size_t count) {
    qsort(list, count, sizeof *list, attempt_compare_depths);
    attempt_draw(image, list, count, NULL, NULL);
}

/* ---- With one ---- */

static inline void attempt_fill_float(void *buffer, size_t pixel_count, float value) {
    float *depths = buffer;
    for (size_t i = 0; i < pixel_count; i++) {
        depths[i] = value;
    }
}

/* A depth test that keeps `value`, an expression of `depth`, as a number of that type. */
#define ATTEMPT_KEEP(name, type, is_nearer, value)                                                 \
    static inline bool name(void *buffer, size_t i, double depth) {                                \
        type now = (type)(value), *kept = (type *)buffer + i;                                      \
        if (!(now is_nearer kept[0])) {                                                            \
            return false;                                                                          \
        }                                                                                          \
        kept[0] = now;                                                                             \
        return true;                                                                               \
    }

ATTEMPT_KEEP(attempt_keep_float, float, >, depth)

/* Attempt 3: a depth buffer, but one depth for the whole triangle: its mean. Triangles cut into
 * each other along their sides: as many faults as attempt 2 has, without the sorting. */
static inline void attempt_3_mean_depth(struct image *image, const struct drawn *list, size_t count,
                                        void *buffer) {
    attempt_fill_float(buffer, image->width * image->height, -INFINITY);
    for (size_t i = 0; i < count; i++) {
        struct drawn d = list[i];
        d.v[0].depth = d.v[1].depth = d.v[2].depth = attempt_mean_depth(&d);
        attempt_triangle(image, &d, attempt_keep_float, buffer);
    }
}

/* ---- Fewer bits ---- */

/* Depth -1..1 as a whole number 1..most; 0 is left for "nothing here". */
static inline uint32_t attempt_whole_depth(double depth, uint32_t most) {
    double inside = depth < -1 ? -1 : depth > 1 ? 1 : depth;
    return 1 + (uint32_t)((inside + 1) / 2 * (most - 1) + 0.5);
}

ATTEMPT_KEEP(attempt_keep_8, uint8_t, >, attempt_whole_depth(depth, 255))
ATTEMPT_KEEP(attempt_keep_16, uint16_t, >, attempt_whole_depth(depth, 65535))
/* of 32 bits: the others are often used for something else */
ATTEMPT_KEEP(attempt_keep_24, uint32_t, >, attempt_whole_depth(depth, 16777215))

/* Cameras with perspective (lesson 8) store near/distance or 1 - near/distance, because these are
 * straight on the screen. Here the eye is at depth 2, and nothing is nearer to it than 0.001. */
static inline double attempt_near_over_distance(double depth) {
    return 0.001 / (2 - depth);
}

ATTEMPT_KEEP(attempt_keep_from_near, float, <, 1 - attempt_near_over_distance(depth))
ATTEMPT_KEEP(attempt_keep_reversed, float, >, attempt_near_over_distance(depth))

/* Attempts 6 to 11: what a depth is kept in. */
struct attempt_buffer {
    const char *name;
    depth_test *test;
    float nothing; /* what is there before the first triangle; whole numbers begin with 0 */
};

static const struct attempt_buffer attempt_buffers[] = {
    /* Steps of 2/254. Surfaces nearer to each other than a step have equal depth, and then the
     * order of drawing decides again: stripes. */
    {"6 8 bits", attempt_keep_8, 0},
    /* Steps of 3.1e-5. Enough for one head, not for a landscape. */
    {"7 16 bits", attempt_keep_16, 0},
    /* Steps of 1.2e-7. */
    {"8 24 bits", attempt_keep_24, 0},
    /* Steps of 6e-8 near -1 and 1, and finer towards 0. */
    {"9 float", attempt_keep_float, -INFINITY},
    /* Smaller is nearer: all of the scene falls between 0.999 and 1, where a float has steps of
     * 6e-8: as coarse as 2.4e-4 of depth at distance 2. */
    {"10 float, 1 - near/distance", attempt_keep_from_near, INFINITY},
    /* Larger is nearer ("reversed" depth): the same scene falls near 0, where a float's steps are
     * fine. (Lapidous and Jiao, "Optimal Depth Buffer for Low-Cost Graphics Hardware", 1999.) */
    {"11 float, near/distance", attempt_keep_reversed, -INFINITY},
};
enum { ATTEMPT_BUFFERS = sizeof attempt_buffers / sizeof attempt_buffers[0] };

static inline void attempt_draw_with(const struct attempt_buffer *kind, struct image *image,
                                     const struct drawn *list, size_t count, void *buffer) {
    attempt_fill_float(buffer, image->width * image->height, kind->nothing);
    attempt_draw(image, list, count, kind->test, buffer);
}

#endif
