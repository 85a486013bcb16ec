/* Triangles: coverage against 128-bit integers, and weights. */
#include "lessons.h"
#include "stress.h"

enum { WIDTH = SCREEN_WIDTH, HEIGHT = SCREEN_HEIGHT };

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

void random_triangle(struct random *random, uint64_t index, struct fixed2 c[3]) {
    static const int64_t reaches[] = {0, 512, 20000, 5000000};
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

static void make_triangle(struct random *random, uint64_t index, void *made) {
    random_triangle(random, index, ((struct triangle_case *)made)->corner);
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
    return !any || oracle_turn(c[0], c[1], c[2]) != 0;
}

typedef void draw_triangle(struct image *image, const struct fixed2 corner[3], struct color color);

static bool draws_exactly(const struct fixed2 c[3], draw_triangle *draw) {
    uint8_t pixels[HEIGHT * WIDTH * 3] = {0};
    struct image image = {WIDTH, HEIGHT, IMAGE_BGR, pixels};
    draw(&image, c, color_grey(255));
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        if ((pixels[3 * i] != 0) != oracle_covers(c[0], c[1], c[2], i % WIDTH, i / WIDTH)) {
            return false;
        }
    }
    return true;
}

static bool lesson03_is_exact(const void *tried) {
    return draws_exactly(((const struct triangle_case *)tried)->corner, lesson03_triangle);
}

static bool lesson04_is_exact(const void *tried) {
    return draws_exactly(((const struct triangle_case *)tried)->corner, lesson04_triangle);
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

const struct property triangle_properties[] = {
    PROPERTY("triangle: exact coverage", AGAINST_INTEGERS, 2000000, struct triangle_case,
             make_triangle, .holds = triangle_is_exact),
    PROPERTY("triangle: lesson 3, exact coverage", AGAINST_INTEGERS, 200000, struct triangle_case,
             make_triangle, .holds = lesson03_is_exact),
    PROPERTY("triangle: lesson 4, exact coverage", AGAINST_INTEGERS, 200000, struct triangle_case,
             make_triangle, .holds = lesson04_is_exact),
    PROPERTY("triangle: weights", AGAINST_BOUNDS, 500000, struct triangle_case, make_triangle,
             .error = weight_error, .limit = 4, .error_unit = "ulp of 1"),
    {.name = NULL},
};
