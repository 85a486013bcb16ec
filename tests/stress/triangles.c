/* Coverage of triangles against 128-bit integers, depth against fractions. */
#include "lessons.h"
#include "stress.h"

#include <stdio.h>

enum { WIDTH = 12, HEIGHT = 9 }; /* pixels of the image that the triangles lie around */

static const int32_t limit = SCREEN_LIMIT * SUBPIXELS;

/* ---- Cases ---- */

struct triangle_case {
    struct fixed2 corner[3];
};

static int32_t coordinate(struct random *random, int64_t reach, int32_t grid) {
    int64_t least = -reach, most = (int64_t)WIDTH * SUBPIXELS + reach;
    int64_t value = random_between(random, least / grid, most / grid) * grid;
    return (int32_t)(value > limit ? limit : value < -limit ? -limit : value);
}

static struct fixed2 place(struct random *random, int64_t reach, int32_t grid) {
    return (struct fixed2){coordinate(random, reach, grid), coordinate(random, reach, grid)};
}

/* A point on the segment from a to b, moved by at most `off` steps. */
static struct fixed2 beside_segment(struct random *random, struct fixed2 a, struct fixed2 b,
                                    int off) {
    int64_t t = random_between(random, 0, 64);
    int64_t x = a.x + ((int64_t)b.x - a.x) * t / 64 + random_between(random, -off, off);
    int64_t y = a.y + ((int64_t)b.y - a.y) * t / 64 + random_between(random, -off, off);
    return (struct fixed2){(int32_t)(x > limit    ? limit
                                     : x < -limit ? -limit
                                                  : x),
                           (int32_t)(y > limit    ? limit
                                     : y < -limit ? -limit
                                                  : y)};
}

static void make_triangle(struct random *random, uint64_t index, void *made) {
    static const int64_t reaches[] = {0, 512, 20000, 5000000};
    struct fixed2 *c = ((struct triangle_case *)made)->corner;
    int64_t reach = reaches[index / 8 % 4];
    switch (index % 8) {
    case 0: /* anywhere */
        for (int i = 0; i < 3; i++) {
            c[i] = place(random, reach, 1);
        }
        break;
    case 1: /* corners on pixel centres and corners: centres lie on many edges */
        for (int i = 0; i < 3; i++) {
            c[i] = place(random, reach / 4, 128);
        }
        break;
    case 2: /* slivers */
        c[0] = place(random, reach, 1);
        c[1] = place(random, reach, 1);
        c[2] = beside_segment(random, c[0], c[1], 2);
        break;
    case 3: /* slivers between pixel centres */
        c[0] = place(random, reach / 4, 128);
        c[1] = place(random, reach / 4, 128);
        c[2] = beside_segment(random, c[0], c[1], 1);
        break;
    case 4: /* smaller than a pixel */
        c[0] = place(random, 0, 1);
        for (int i = 1; i < 3; i++) {
            c[i] = (struct fixed2){c[0].x + (int32_t)random_between(random, -200, 200),
                                   c[0].y + (int32_t)random_between(random, -200, 200)};
        }
        break;
    case 5: /* horizontal and vertical edges */
        for (int i = 0; i < 3; i++) {
            c[i] = place(random, reach, random_bits(random) % 2 ? 128 : 1);
        }
        c[1].y = c[0].y;
        if (random_bits(random) % 2) {
            c[2].x = c[0].x;
        }
        break;
    case 6: /* as far out as is allowed */
        for (int i = 0; i < 3; i++) {
            c[i] = place(random, limit, 1);
            if (random_bits(random) % 3 == 0) {
                c[i].x = random_bits(random) % 2 ? limit : -limit;
            }
            if (random_bits(random) % 3 == 0) {
                c[i].y = random_bits(random) % 2 ? limit : -limit;
            }
        }
        break;
    default: /* points and lines */
        c[0] = place(random, reach, 128);
        c[1] = random_bits(random) % 2 ? c[0] : place(random, reach, 128);
        c[2] = random_bits(random) % 2 ? c[1] : beside_segment(random, c[0], c[1], 0);
    }
}

static bool shrink_triangle(const void *failing, unsigned attempt, void *smaller) {
    struct fixed2 *c = ((struct triangle_case *)smaller)->corner;
    (void)failing;
    if (attempt >= 6 * 26) {
        return false;
    }
    int32_t *number = attempt % 2 ? &c[attempt / 2 % 3].y : &c[attempt / 2 % 3].x;
    unsigned bit = 25 - attempt / 6; /* take away large parts first */
    int32_t part = (int32_t)1 << bit;
    *number -= *number >= part ? part : *number <= -part ? -part : 0;
    return true;
}

/* As a text scene of step 3, whose whole coordinates are pixel centres. */
static void print_triangle(const void *failing) {
    const struct fixed2 *c = ((const struct triangle_case *)failing)->corner;
    printf("    size %d %d\n    triangle", WIDTH, HEIGHT);
    for (int i = 0; i < 3; i++) {
        printf(" %.8f %.8f", c[i].x / 256.0 - 0.5, c[i].y / 256.0 - 0.5);
    }
    printf(" 255 255 255\n");
}

/* ---- Coverage ---- */

static bool triangle_is_exact(const void *tried) {
    const struct fixed2 *c = ((const struct triangle_case *)tried)->corner;
    struct edges edges;
    bool any = edges_setup(&edges, c[0], c[1], c[2], WIDTH, HEIGHT);
    for (int y = 0; y < HEIGHT; y++) {
        struct span span = {0, 0};
        if (any && y >= edges.y_begin && y < edges.y_end) {
            span = edges_span(&edges, y);
        }
        if (span.begin < 0 || span.end > WIDTH) {
            return false;
        }
        for (int x = 0; x < WIDTH; x++) {
            if ((x >= span.begin && x < span.end) != oracle_covers(c[0], c[1], c[2], x, y)) {
                return false;
            }
        }
    }
    return true;
}

static bool lesson_triangle_is_exact(const void *tried) {
    const struct fixed2 *c = ((const struct triangle_case *)tried)->corner;
    uint8_t pixels[HEIGHT * WIDTH * 3] = {0};
    struct image image = {WIDTH, HEIGHT, IMAGE_BGR, pixels};
    lesson03_triangle(&image, c, color_grey(255));
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        if ((pixels[3 * i] != 0) != oracle_covers(c[0], c[1], c[2], i % WIDTH, i / WIDTH)) {
            return false;
        }
    }
    return true;
}

/* The weights at every covered pixel: none negative, sum 1. */
static double weight_error(const void *tried) {
    const struct fixed2 *c = ((const struct triangle_case *)tried)->corner;
    struct edges edges;
    double worst = 0;
    if (!edges_setup(&edges, c[0], c[1], c[2], WIDTH, HEIGHT)) {
        return 0;
    }
    for (int y = edges.y_begin; y < edges.y_end; y++) {
        struct span span = edges_span(&edges, y);
        for (int x = span.begin; x < span.end; x++) {
            struct vec3 w = edges_weights(&edges, x, y);
            worst = fmax(worst, fabs(w.x + w.y + w.z - 1));
            worst = fmax(worst, fmax(-w.x, fmax(-w.y, -w.z)));
        }
    }
    return worst * 0x1p52;
}

static bool weights_are_right(const void *tried) {
    return weight_error(tried) <= 4;
}

/* ---- Depth ---- */

struct depth_case {
    struct fixed2 corner[2][3];
    int64_t depth[2][3];
    int x, y;
};

/* Two triangles that cover a common pixel, in depths that are close or equal there. */
static void make_depths(struct random *random, uint64_t index, void *made) {
    struct depth_case *c = made;
    c->x = (int)random_between(random, 0, WIDTH - 1);
    c->y = (int)random_between(random, 0, HEIGHT - 1);
    for (int k = 0; k < 2; k++) {
        do {
            for (int i = 0; i < 3; i++) {
                c->corner[k][i] = place(random, index % 2 ? 512 : 100000, 1);
            }
        } while (!oracle_covers(c->corner[k][0], c->corner[k][1], c->corner[k][2], c->x, c->y));
        int64_t base = index % 3 ? 1000 : 0, spread = index % 5 ? 1000000 : 3;
        for (int i = 0; i < 3; i++) {
            c->depth[k][i] = base + random_between(random, -spread, spread);
        }
    }
}

static double depth_at(const struct fixed2 corner[3], const int64_t depth[3], int x, int y) {
    struct edges edges;
    if (!edges_setup(&edges, corner[0], corner[1], corner[2], WIDTH, HEIGHT)) {
        return NAN;
    }
    return interpolate(edges_weights(&edges, x, y), (double)depth[0], (double)depth[1],
                       (double)depth[2]);
}

/* The nearer triangle must show. Where the exact depths differ by less than the numbers' precision,
 * a tie may go either way. */
static bool nearer_one_shows(const void *tried) {
    const struct depth_case *c = tried;
    int exact =
        oracle_compare_depth(c->corner[0], c->depth[0], c->corner[1], c->depth[1], c->x, c->y);
    double first = depth_at(c->corner[0], c->depth[0], c->x, c->y);
    double second = depth_at(c->corner[1], c->depth[1], c->x, c->y);
    double largest = 1;
    for (int i = 0; i < 6; i++) {
        largest = fmax(largest, fabs((double)c->depth[i / 3][i % 3]));
    }
    if (fabs(first - second) <= largest * 0x1p-50) {
        return true;
    }
    return (first > second) == (exact > 0);
}

static void print_depths(const void *failing) {
    const struct depth_case *c = failing;
    for (int k = 0; k < 2; k++) {
        printf("    corners (1/256 pixel) and depths:");
        for (int i = 0; i < 3; i++) {
            printf(" (%d %d %lld)", (int)c->corner[k][i].x, (int)c->corner[k][i].y,
                   (long long)c->depth[k][i]);
        }
        printf("\n");
    }
    printf("    at pixel %d %d\n", c->x, c->y);
}

const struct property triangle_properties[] = {
    {.name = "triangle: exact coverage",
     .against = AGAINST_INTEGERS,
     .cases = 2000000,
     .case_size = sizeof(struct triangle_case),
     .make = make_triangle,
     .holds = triangle_is_exact,
     .shrink = shrink_triangle,
     .print = print_triangle},
    {.name = "triangle: lesson 3, exact coverage",
     .against = AGAINST_INTEGERS,
     .cases = 200000,
     .case_size = sizeof(struct triangle_case),
     .make = make_triangle,
     .holds = lesson_triangle_is_exact,
     .shrink = shrink_triangle,
     .print = print_triangle},
    {.name = "triangle: weights",
     .against = AGAINST_BOUNDS,
     .cases = 500000,
     .case_size = sizeof(struct triangle_case),
     .make = make_triangle,
     .holds = weights_are_right,
     .shrink = shrink_triangle,
     .print = print_triangle,
     .error_unit = "ulp of 1",
     .error = weight_error},
    {.name = "depth: the nearer one shows",
     .against = AGAINST_FRACTIONS,
     .cases = 300000,
     .case_size = sizeof(struct depth_case),
     .make = make_depths,
     .holds = nearer_one_shows,
     .print = print_depths},
    {.name = NULL},
};
