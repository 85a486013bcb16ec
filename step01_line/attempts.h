/*
 * Lesson 1's earlier versions of line(), from the first idea to the last but one, and four more:
 * one with a case for every kind of line, a faster one, and two that add to t.
 *
 * All have the signature of line() in main.c, so that the figures and the benchmark can loop over
 * them. Attempts 5 to 7 compute in `float` on purpose: with 24 bits one can watch the errors grow.
 * Coordinates lie within LINE_LIMIT.
 */
#ifndef STEP01_ATTEMPTS_H
#define STEP01_ATTEMPTS_H

#include "geometry.h"
#include "tgaimage.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

typedef void attempt_function(struct image *image, struct pixel a, struct pixel b,
                              struct color color);

/* The whole number nearest to a coordinate, halves up. What is not a number, or lies too far away,
 * becomes -1 (outside every image): C leaves the conversion of such a value undefined. */
static inline int attempt_nearest_pixel(double coordinate) {
    return fabs(coordinate) <= LINE_LIMIT ? (int)floor(coordinate + 0.5) : -1;
}

static inline struct pixel attempt_transposed(struct pixel p) {
    return (struct pixel){p.y, p.x};
}

/* Exchange the axes of a steep line, then the ends of one that goes to the left. Afterwards the
 * line goes to the right, and at most as far up or down. Says whether the axes were exchanged. */
static inline bool attempt_make_flat(struct pixel *a, struct pixel *b) {
    bool steep = abs(b->y - a->y) > abs(b->x - a->x);
    if (steep) {
        *a = attempt_transposed(*a);
        *b = attempt_transposed(*b);
    }
    if (a->x > b->x) {
        struct pixel kept = *a;
        *a = *b;
        *b = kept;
    }
    return steep;
}

/* Set pixel (x,y), or (y,x) where the axes were exchanged. */
static inline void attempt_set_flat(struct image *image, bool steep, int x, int y,
                                    struct color color) {
    image_set(image, steep ? y : x, steep ? x : y, color);
}

/* t goes from 0 to 1 in a hundred steps, and the point at t is cut down to whole numbers.
 * Wrong: a long line has holes and a short one is drawn over again and again; the last pixel is
 * missing; cutting instead of rounding puts about half of the pixels one too low. */
static inline void attempt_1_hundred_steps(struct image *image, struct pixel a, struct pixel b,
                                           struct color color) {
    for (double t = 0; t < 1; t += 0.01) {
        int x = (int)(a.x + (b.x - a.x) * t);
        int y = (int)(a.y + (b.y - a.y) * t);
        image_set(image, x, y, color);
    }
}

/* The same with fewer steps, to do less work. Wrong: a row of dots. */
static inline void attempt_2_ten_steps(struct image *image, struct pixel a, struct pixel b,
                                       struct color color) {
    for (double t = 0; t < 1; t += 0.1) {
        int x = (int)(a.x + (b.x - a.x) * t);
        int y = (int)(a.y + (b.y - a.y) * t);
        image_set(image, x, y, color);
    }
}

/* As many steps as columns: t grows by 1 / (x1 - x0). Wrong: a line to the left is missing, a steep
 * line has holes, and for a vertical one t is 0 / 0. */
static inline void attempt_3_step_per_column(struct image *image, struct pixel a, struct pixel b,
                                             struct color color) {
    for (int x = a.x; x <= b.x; x++) {
        double t = (double)(x - a.x) / (b.x - a.x);
        image_set(image, x, attempt_nearest_pixel(a.y + (b.y - a.y) * t), color);
    }
}

/* Axes and ends exchanged where needed. The picture is right now. What is left to mend: a division
 * for every pixel; and where two pixels are equally near, this always takes the upper one. */
static inline void attempt_4_swapped(struct image *image, struct pixel a, struct pixel b,
                                     struct color color) {
    bool steep = attempt_make_flat(&a, &b);
    for (int x = a.x; x <= b.x; x++) {
        double t = b.x > a.x ? (double)(x - a.x) / (b.x - a.x) : 0;
        attempt_set_flat(image, steep, x, attempt_nearest_pixel(a.y + (b.y - a.y) * t), color);
    }
}

/* The division does not depend on x, so it is done once, before the loop. Wrong now and then: the
 * slope is rounded, so near a tie the wrong pixel wins, more often on longer lines. */
static inline void attempt_5_division_outside(struct image *image, struct pixel a, struct pixel b,
                                              struct color color) {
    bool steep = attempt_make_flat(&a, &b);
    float slope = b.x > a.x ? (float)(b.y - a.y) / (float)(b.x - a.x) : 0;
    for (int x = a.x; x <= b.x; x++) {
        float climbed = slope * (float)(x - a.x);
        float y = (float)a.y + climbed;
        attempt_set_flat(image, steep, x, attempt_nearest_pixel(y), color);
    }
}

/* No multiplication either: y grows by the slope. Wrong on long lines: every addition rounds, and
 * the errors add up. */
static inline void attempt_6_accumulated(struct image *image, struct pixel a, struct pixel b,
                                         struct color color) {
    bool steep = attempt_make_flat(&a, &b);
    float slope = b.x > a.x ? (float)(b.y - a.y) / (float)(b.x - a.x) : 0;
    float y = (float)a.y;
    for (int x = a.x; x <= b.x; x++) {
        attempt_set_flat(image, steep, x, attempt_nearest_pixel(y), color);
        y += slope;
    }
}

/* y in two parts: a whole number, and how far the line has left it. A small number is rounded less
 * than a large one, and no conversion to int is needed. Still wrong on long lines, but later. */
static inline void attempt_7_two_parts(struct image *image, struct pixel a, struct pixel b,
                                       struct color color) {
    bool steep = attempt_make_flat(&a, &b);
    float slope = b.x > a.x ? (float)abs(b.y - a.y) / (float)(b.x - a.x) : 0;
    int y_step = b.y > a.y ? 1 : -1;
    int y = a.y;
    float beyond = 0;
    for (int x = a.x; x <= b.x; x++) {
        attempt_set_flat(image, steep, x, y, color);
        beyond += slope;
        if (beyond > 0.5f) {
            y += y_step;
            beyond -= 1;
        }
    }
}

/* ---- Four more ---- */

/* A case for every kind of line, and all eight octants mirrored from the first one. Each case is
 * simple, but there are many. Wrong: mirroring starts at a, and so do the ties; from b to a it may
 * set other pixels than from a to b. */
static inline void attempt_by_cases(struct image *image, struct pixel a, struct pixel b,
                                    struct color color) {
    int dx = abs(b.x - a.x), dy = abs(b.y - a.y);
    int x_sign = b.x < a.x ? -1 : 1, y_sign = b.y < a.y ? -1 : 1;
    if (dx == 0 && dy == 0) { /* a point */
        image_set(image, a.x, a.y, color);
    } else if (dy == 0) { /* horizontal */
        for (int i = 0; i <= dx; i++) {
            image_set(image, a.x + x_sign * i, a.y, color);
        }
    } else if (dx == 0) { /* vertical */
        for (int i = 0; i <= dy; i++) {
            image_set(image, a.x, a.y + y_sign * i, color);
        }
    } else if (dx == dy) { /* diagonal */
        for (int i = 0; i <= dx; i++) {
            image_set(image, a.x + x_sign * i, a.y + y_sign * i, color);
        }
    } else { /* oblique: (i,j) walks the first octant and is mirrored into the line's own */
        bool steep = dy > dx;
        int64_t run = steep ? dy : dx, rise = steep ? dx : dy, error = -run;
        for (int i = 0, j = 0; i <= run; i++) {
            image_set(image, a.x + x_sign * (steep ? j : i), a.y + y_sign * (steep ? i : j), color);
            error += 2 * rise;
            if (error > 0) {
                j++;
                error -= 2 * run;
            }
        }
    }
}

/* Pixels u_begin (inclusive) to u_end (exclusive) of row v, or of column v of a steep line. The
 * test against the image's borders is done once for all of them. */
static inline void attempt_draw_run(struct image *image, bool steep, int64_t u_begin, int64_t u_end,
                                    int64_t v, struct color color) {
    int64_t u_size = (int64_t)(steep ? image->height : image->width);
    int64_t v_size = (int64_t)(steep ? image->width : image->height);
    u_begin = u_begin > 0 ? u_begin : 0;
    u_end = u_end < u_size ? u_end : u_size;
    if (v < 0 || v >= v_size || u_begin >= u_end) {
        return;
    }
    size_t pixel_size = image->format, row_size = image->width * pixel_size;
    size_t u_stride = steep ? row_size : pixel_size, v_stride = steep ? pixel_size : row_size;
    uint8_t *target = image->pixels + (size_t)v * v_stride + (size_t)u_begin * u_stride;
    for (int64_t u = u_begin; u < u_end; u++) {
        target[0] = color.b;
        if (pixel_size >= 3) {
            target[1] = color.g;
            target[2] = color.r;
        }
        if (pixel_size == 4) {
            target[3] = color.a;
        }
        target += u_stride;
    }
}

/* Bresenham by runs: where v has moved m times, u ends at ceil((2 * m * run + run + 1) / (2 *
 * rise)). From one m to the next that is a whole number of steps plus a fraction, which is carried
 * as a remainder. The same pixels as line(), with work per run instead of per pixel. (The idea:
 * Bresenham, "Run length slice algorithm for incremental lines", 1985.) */
static inline void attempt_by_runs(struct image *image, struct pixel a, struct pixel b,
                                   struct color color) {
    bool steep = attempt_make_flat(&a, &b);
    int64_t run = (int64_t)b.x - a.x, rise = llabs((int64_t)b.y - a.y);
    int v_step = b.y < a.y ? -1 : 1;
    if (rise == 0) {
        attempt_draw_run(image, steep, a.x, (int64_t)b.x + 1, a.y, color);
        return;
    }
    int64_t divisor = 2 * rise;
    int64_t end = (run + divisor) / divisor, remainder = (run + divisor) % divisor;
    const int64_t length = 2 * run / divisor, length_remainder = 2 * run % divisor;
    int64_t begin = 0;
    for (int64_t m = 0; m < rise; m++) {
        attempt_draw_run(image, steep, a.x + begin, a.x + end, a.y + v_step * m, color);
        begin = end;
        end += length;
        remainder += length_remainder;
        if (remainder >= divisor) {
            remainder -= divisor;
            end++;
        }
    }
    attempt_draw_run(image, steep, a.x + begin, (int64_t)b.x + 1, b.y, color);
}

/* t grows by just as much as this line needs. Wrong: every addition rounds. t may pass 1 too early,
 * and the last pixel is missing; on a long line all pixels drift. (`i` ends a line so long that t
 * stops growing.) */
static inline void attempt_t_added(struct image *image, struct pixel a, struct pixel b,
                                   struct color color) {
    bool steep = attempt_make_flat(&a, &b);
    int run = b.x - a.x, rise = b.y - a.y;
    float t = 0, dt = run > 0 ? 1 / (float)run : 1;
    for (int i = 0; i <= run && t <= 1; i++) {
        attempt_set_flat(image, steep, attempt_nearest_pixel(a.x + (double)t * run),
                         attempt_nearest_pixel(a.y + (double)t * rise), color);
        t += dt;
    }
}

/* The same in whole numbers: t counts how far v has moved, in parts of 1 / (2 * run). Exact, with
 * the ties of line(). What is left to mend: a division for every pixel. */
static inline void attempt_t_whole(struct image *image, struct pixel a, struct pixel b,
                                   struct color color) {
    bool steep = attempt_make_flat(&a, &b);
    int64_t run = (int64_t)b.x - a.x, rise = llabs((int64_t)b.y - a.y), t = 0;
    int v_step = b.y < a.y ? -1 : 1;
    for (int x = a.x; x <= b.x; x++) {
        int moved = run > 0 ? (int)((t + run - 1) / (2 * run)) : 0;
        attempt_set_flat(image, steep, x, a.y + v_step * moved, color);
        t += 2 * rise;
    }
}

/* ---- The table ---- */

enum { ATTEMPT_COUNT = 11 };

static inline attempt_function *attempt_at(int index) {
    static attempt_function *const attempts[ATTEMPT_COUNT] = {
        attempt_1_hundred_steps,
        attempt_2_ten_steps,
        attempt_3_step_per_column,
        attempt_4_swapped,
        attempt_5_division_outside,
        attempt_6_accumulated,
        attempt_7_two_parts,
        attempt_by_cases,
        attempt_by_runs,
        attempt_t_added,
        attempt_t_whole,
    };
    return attempts[index];
}

#endif
