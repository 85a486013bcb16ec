/*
 * Lesson 3: worse ways to fill a triangle. All take corners in pixels (continuous positions on the
 * screen: the centre of pixel (x,y) is (x + 0.5, y + 0.5)) and cut the triangle to the image.
 */
#ifndef STEP03_ATTEMPTS_H
#define STEP03_ATTEMPTS_H

#include "geometry.h"
#include "raster.h"
#include "tgaimage.h"

#include <limits.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

typedef void fill_function(struct image *image, const struct vec2 corner[3], struct color color);

/* For attempts that test pixel after pixel of a row: this writes neighbouring pixels at once.
 * `begin` is where they began, -1 while there are none; after the last pixel comes one more call
 * that is not `inside`. */
static inline void attempt_test(struct image *image, int *begin, int x, int y, bool inside,
                                struct color color) {
    if (inside && *begin < 0) {
        *begin = x;
    } else if (!inside && *begin >= 0) {
        image_fill_row(image, y, *begin, x, color);
        *begin = -1;
    }
}

static inline double attempt_clamp(double value, double least, double most) {
    return value < least ? least : value > most ? most : value;
}

/* Put three corners in order of their y. */
static inline void attempt_sort_by_y(struct vec2 p[3]) {
    for (int i = 0; i < 3; i++) {
        int other = i == 1 ? 1 : 0; /* compare 0-1, 1-2, 0-1 */
        if (p[other].y > p[other + 1].y) {
            struct vec2 kept = p[other];
            p[other] = p[other + 1];
            p[other + 1] = kept;
        }
    }
}

/* The side from a to b at height y, rounded towards a by the division. */
static inline int64_t attempt_side_at(struct pixel a, struct pixel b, int y) {
    if (a.y == b.y) {
        return b.x;
    }
    return a.x + ((int64_t)b.x - a.x) * ((int64_t)y - a.y) / ((int64_t)b.y - a.y);
}

/* Attempt 1: sort by y, then sweep the lower and the upper half with whole numbers.
 * Wrong: corners lose their fractions; both end rows and both end pixels are drawn, so neighbours
 * overlap everywhere; rounding towards a corner leaves notches. Looks ragged, and colours of later
 * triangles eat into those of earlier ones. */
static inline void attempt_1_sweep_whole(struct image *image, const struct vec2 corner[3],
                                         struct color color) {
    struct vec2 sorted[3] = {corner[0], corner[1], corner[2]};
    struct pixel p[3];
    attempt_sort_by_y(sorted);
    for (int i = 0; i < 3; i++) {
        p[i] = (struct pixel){(int)sorted[i].x, (int)sorted[i].y};
    }
    int top = (int)image->height - 1, right_most = (int)image->width - 1;
    for (int y = p[0].y > 0 ? p[0].y : 0; y <= p[2].y && y <= top; y++) {
        int64_t left = attempt_side_at(p[0], p[2], y);
        int64_t right =
            y < p[1].y ? attempt_side_at(p[0], p[1], y) : attempt_side_at(p[1], p[2], y);
        if (left > right) {
            int64_t kept = left;
            left = right;
            right = kept;
        }
        image_fill_row(image, y, (int)(left > 0 ? left : 0),
                       (int)(right < right_most ? right : right_most) + 1, color);
    }
}

/* Attempt 2: the sweep with fractions kept, in float, one addition a row and edge.
 * Nearly right: but the sums drift, and an edge that is one piece for this triangle is swept in two
 * pieces by its neighbour, which then rounds differently. Looks right, with single pixels missing
 * or drawn twice along the edges. */
static inline void attempt_2_sweep_float(struct image *image, const struct vec2 corner[3],
                                         struct color color) {
    struct vec2 p[3] = {corner[0], corner[1], corner[2]};
    attempt_sort_by_y(p);
    float width = (float)image->width;
    for (int half = 0; half < 2; half++) {
        struct vec2 low = p[half], high = p[half + 1]; /* the short side of this half */
        double height = (double)image->height;
        int y_begin = (int)attempt_clamp(floor(low.y - 0.5) + 1, 0, height);
        int y_end = (int)attempt_clamp(floor(high.y - 0.5) + 1, 0, height);
        if (y_begin >= y_end) {
            continue;
        }
        float center = (float)y_begin + 0.5F;
        float short_step = (float)(high.x - low.x) / (float)(high.y - low.y);
        float long_step = (float)(p[2].x - p[0].x) / (float)(p[2].y - p[0].y);
        float short_x = (float)low.x + short_step * (center - (float)low.y);
        float long_x = (float)p[0].x + long_step * (center - (float)p[0].y);
        for (int y = y_begin; y < y_end; y++) {
            float left = short_x < long_x ? short_x : long_x;
            float right = short_x < long_x ? long_x : short_x;
            int begin = (int)attempt_clamp(ceil(left - 0.5F), 0, width);
            int end = (int)attempt_clamp(ceil(right - 0.5F), 0, width);
            image_fill_row(image, y, begin, end, color);
            short_x += short_step;
            long_x += long_step;
        }
    }
}

/* The pixels that a triangle can reach: its bounding box, cut to the image. */
struct attempt_box {
    int x_begin, x_end, y_begin, y_end; /* begin inclusive, end exclusive */
};

static inline struct attempt_box attempt_box(const struct image *image, const struct vec2 p[3]) {
    double width = (double)image->width, height = (double)image->height;
    return (struct attempt_box){
        .x_begin = (int)attempt_clamp(floor(fmin(p[0].x, fmin(p[1].x, p[2].x))), 0, width),
        .x_end = (int)attempt_clamp(floor(fmax(p[0].x, fmax(p[1].x, p[2].x))) + 1, 0, width),
        .y_begin = (int)attempt_clamp(floor(fmin(p[0].y, fmin(p[1].y, p[2].y))), 0, height),
        .y_end = (int)attempt_clamp(floor(fmax(p[0].y, fmax(p[1].y, p[2].y))) + 1, 0, height),
    };
}

/* Attempt 3: every pixel of the bounding box, barycentric coordinates in float, none negative.
 * Wrong: a pixel centre on a shared edge is inside both triangles, and rounding moves centres that
 * are near an edge across it, differently for the two neighbours. At least half of the tested
 * pixels are outside. Looks right; the count of draws shows the edges. */
static inline void attempt_3_box_float(struct image *image, const struct vec2 p[3],
                                       struct color color) {
    struct attempt_box box = attempt_box(image, p);
    float ax = (float)p[0].x, ay = (float)p[0].y;
    float abx = (float)p[1].x - ax, aby = (float)p[1].y - ay;
    float acx = (float)p[2].x - ax, acy = (float)p[2].y - ay;
    float area = abx * acy - aby * acx;
    for (int y = box.y_begin; y < box.y_end && area != 0; y++) {
        int begin = -1;
        for (int x = box.x_begin; x < box.x_end; x++) {
            float dx = (float)x + 0.5F - ax, dy = (float)y + 0.5F - ay;
            float b = (dx * acy - dy * acx) / area;
            float c = (abx * dy - aby * dx) / area;
            bool inside = b >= 0 && c >= 0 && 1 - b - c >= 0;
            attempt_test(image, &begin, x, y, inside, color);
        }
        attempt_test(image, &begin, box.x_end, y, false, color);
    }
}

/* Barycentric coordinates in double: the weights of the three corners at a point. */
static inline struct vec3 attempt_weights(const struct vec2 p[3], double area, double x, double y) {
    double a = (p[2].x - p[1].x) * (y - p[1].y) - (p[2].y - p[1].y) * (x - p[1].x);
    double b = (p[0].x - p[2].x) * (y - p[2].y) - (p[0].y - p[2].y) * (x - p[2].x);
    double c = (p[1].x - p[0].x) * (y - p[0].y) - (p[1].y - p[0].y) * (x - p[0].x);
    return (struct vec3){a / area, b / area, c / area};
}

/* A pixel is drawn when no weight is less than `least` (when `open`: when all are more). */
static inline void attempt_box_double(struct image *image, const struct vec2 p[3],
                                      struct color color, double least, bool open) {
    struct attempt_box box = attempt_box(image, p);
    double area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
    for (int y = box.y_begin; y < box.y_end && area != 0; y++) {
        int begin = -1;
        for (int x = box.x_begin; x < box.x_end; x++) {
            struct vec3 weight = attempt_weights(p, area, x + 0.5, y + 0.5);
            double smallest = fmin(weight.x, fmin(weight.y, weight.z));
            bool inside = open ? smallest > least : smallest >= least;
            attempt_test(image, &begin, x, y, inside, color);
        }
        attempt_test(image, &begin, box.x_end, y, false, color);
    }
}

/* Attempt 4: the same in double. Fewer roundings, the same fault: both neighbours draw the centres
 * on their edge. Slower. */
static inline void attempt_4_box_double(struct image *image, const struct vec2 p[3],
                                        struct color color) {
    attempt_box_double(image, p, color, 0, false);
}

/* Attempt 5: all weights must be positive. Now neither draws a centre on a shared edge: holes in
 * the surface. */
static inline void attempt_5_box_open(struct image *image, const struct vec2 p[3],
                                      struct color color) {
    attempt_box_double(image, p, color, 0, true);
}

/* Attempt 6: a small tolerance, "so that there are no holes". There are none; but now more pixels
 * are drawn twice, and how many depends on the size of the triangle. */
static inline void attempt_6_box_epsilon(struct image *image, const struct vec2 p[3],
                                         struct color color) {
    attempt_box_double(image, p, color, -1e-3, false);
}

/* Attempt 7: edge functions in float, one addition a pixel and a row, with the top-left rule. Fast,
 * and the rule is right, but the values need more digits than a float has: the sums drift, most on
 * large triangles. Looks right for small triangles; a long edge becomes wavy, and the two sides of
 * a seam don't fit. */
static inline void attempt_7_edges_float(struct image *image, const struct vec2 p[3],
                                         struct color color) {
    struct attempt_box box = attempt_box(image, p);
    double area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
    float row[3], right[3], up[3];
    bool closed[3];
    for (int i = 0; i < 3; i++) {
        struct vec2 a = p[(i + 1) % 3], b = p[(i + 2) % 3];
        float sign = area > 0 ? 1 : -1;
        right[i] = -sign * (float)(b.y - a.y);
        up[i] = sign * (float)(b.x - a.x);
        row[i] = right[i] * ((float)box.x_begin + 0.5F - (float)a.x) +
                 up[i] * ((float)box.y_begin + 0.5F - (float)a.y);
        closed[i] = right[i] > 0 || (right[i] == 0 && up[i] < 0); /* a left or a top side */
    }
    for (int y = box.y_begin; y < box.y_end && area != 0; y++) {
        float value[3] = {row[0], row[1], row[2]};
        int begin = -1;
        for (int x = box.x_begin; x < box.x_end; x++) {
            bool inside = true;
            for (int i = 0; i < 3; i++) {
                inside = inside && (value[i] > 0 || (value[i] == 0 && closed[i]));
                value[i] += right[i];
            }
            attempt_test(image, &begin, x, y, inside, color);
        }
        attempt_test(image, &begin, box.x_end, y, false, color);
        for (int i = 0; i < 3; i++) {
            row[i] += up[i];
        }
    }
}

/* ---- By three borders ---- */

/* A corner in whole pixels. */
struct attempt_corner {
    struct pixel at;
    struct color color;
};

/* The pixels of lesson 1's line, one after the other, from the left end to the right one. */
struct attempt_border {
    struct pixel now;
    int64_t k, run, rise, error; /* steps so far; the others as in lesson 1 */
    int y_step;
    bool steep;
    struct color from, to;
};

/* `a` is left of `b`, or below it. Lesson 1 begins a steep line at its lower end. Where we walk it
 * downwards, a tie goes to the pixel nearer to the end of the walk, so `error` begins 1 higher. */
static inline struct attempt_border attempt_border(struct attempt_corner a,
                                                   struct attempt_corner b) {
    int64_t width = (int64_t)b.at.x - a.at.x, height = llabs((int64_t)b.at.y - a.at.y);
    bool steep = height > width, down = b.at.y < a.at.y;
    int64_t run = steep ? height : width;
    return (struct attempt_border){
        .now = a.at,
        .run = run,
        .rise = steep ? width : height,
        .error = (steep && down) - run,
        .y_step = down ? -1 : 1,
        .steep = steep,
        .from = a.color,
        .to = b.color,
    };
}

static inline void attempt_border_next(struct attempt_border *border) {
    border->k++;
    border->error += 2 * border->rise;
    bool moves = border->error > 0;
    border->error -= moves ? 2 * border->run : 0;
    border->now.x += !border->steep || moves;
    border->now.y += border->steep || moves ? border->y_step : 0;
}

static inline struct color attempt_mix(struct color a, struct color b, int64_t k, int64_t n) {
    double share = n > 0 ? (double)k / (double)n : 0;
    return color_rgb(level_from(a.r + (b.r - a.r) * share), level_from(a.g + (b.g - a.g) * share),
                     level_from(a.b + (b.b - a.b) * share));
}

/* The pixels of a column that the borders enclose: from the lowest pixel that a border has in it to
 * the highest one. Each is given by its border and the steps to it. */
struct attempt_end {
    int y;
    const struct attempt_border *border;
    int64_t k;
};

struct attempt_column {
    struct attempt_end low, high;
};

/* Walk a border through column x, which grows by the border's pixels there. */
static inline void attempt_border_cross(struct attempt_border *border, int x,
                                        struct attempt_column *column) {
    for (; border->k <= border->run && border->now.x == x; attempt_border_next(border)) {
        struct attempt_end end = {border->now.y, border, border->k};
        if (end.y < column->low.y) {
            column->low = end;
        }
        if (end.y > column->high.y) {
            column->high = end;
        }
    }
}

/* Two interpolations: along the borders, for the colours at both ends, then across the column. */
static inline void attempt_fill_column(struct image *image, int x, struct attempt_column column,
                                       bool one_color) {
    const struct attempt_border *below = column.low.border, *above = column.high.border;
    int low = column.low.y, high = column.high.y, top = (int)image->height - 1;
    struct color from = below->from, to = from;
    if (!one_color) {
        from = attempt_mix(below->from, below->to, column.low.k, below->run);
        to = attempt_mix(above->from, above->to, column.high.k, above->run);
    }
    for (int y = low > 0 ? low : 0; y <= high && y <= top; y++) {
        image_set(image, x, y, one_color ? from : attempt_mix(from, to, y - low, high - low));
    }
}

/* Sort by x, then by y, in whole pixels. */
static inline void attempt_sort_by_x(const struct vec2 corner[3], const struct color color[3],
                                     struct attempt_corner sorted[3]) {
    for (int i = 0; i < 3; i++) {
        struct pixel p = {(int)floor(corner[i].x), (int)floor(corner[i].y)};
        int place = i;
        for (; place > 0; place--) {
            struct attempt_corner before = sorted[place - 1];
            if (before.at.x < p.x || (before.at.x == p.x && before.at.y <= p.y)) {
                break;
            }
            sorted[place] = before;
        }
        sorted[place] = (struct attempt_corner){p, color[i]};
    }
}

/* The long border, then the two short ones. */
static inline void attempt_three_borders(const struct attempt_corner sorted[3],
                                         struct attempt_border border[3]) {
    border[0] = attempt_border(sorted[0], sorted[2]);
    border[1] = attempt_border(sorted[0], sorted[1]);
    border[2] = attempt_border(sorted[1], sorted[2]);
}

/* Draw three borders as lesson 1 draws lines, and fill column after column between them, up to the
 * middle corner (`last` is 1) or to the right one (2). Each corner has its colour.
 * Wrong: as in attempt 1, the corners lose their fractions; and both neighbours draw the whole
 * border between them. */
static inline void attempt_by_columns(struct image *image, const struct vec2 corner[3],
                                      const struct color color[3], int last) {
    bool one_color = memcmp(&color[0], &color[1], 2 * sizeof color[0]) == 0;
    struct attempt_corner p[3];
    struct attempt_border border[3];
    attempt_sort_by_x(corner, color, p);
    attempt_three_borders(p, border);
    for (int x = p[0].at.x; x <= p[last].at.x && x < (int)image->width; x++) {
        struct attempt_column column = {.low.y = INT_MAX, .high.y = INT_MIN};
        for (int i = 0; i < 3; i++) {
            attempt_border_cross(&border[i], x, &column);
        }
        if (x >= 0) {
            attempt_fill_column(image, x, column, one_color);
        }
    }
}

static inline void attempt_by_borders(struct image *image, const struct vec2 corner[3],
                                      struct color color) {
    attempt_by_columns(image, corner, (const struct color[3]){color, color, color}, 2);
}

/* ---- The table ---- */

static inline fill_function *attempt_fill(int number) {
    static fill_function *const attempts[] = {
        attempt_1_sweep_whole, attempt_2_sweep_float, attempt_3_box_float,   attempt_4_box_double,
        attempt_5_box_open,    attempt_6_box_epsilon, attempt_7_edges_float, attempt_by_borders,
    };
    return attempts[number - 1];
}

#endif
