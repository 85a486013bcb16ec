/*
 * pipeline/planes.h against plain answers, one piece at a time: edge functions in whole numbers,
 * and what the planes are at the corners.
 */
#include "oracle/oracle.h"
#include "pipeline.h"
#include "unit/unit.h"

enum { RUNS = 300 };

static struct random random_state = {23};

/* With a plane more than go into one four. */
static const struct shader shader = {.varying_count = 4};

static int any_int(int least, int most) {
    return (int)floor(random_real(&random_state, least, most + 1.0));
}

/* Edge i at the centre of a pixel, in 1/256 pixel squared. */
static int64_t plain_edge(const struct corners_together *of, size_t piece, int i, int x, int y) {
    int a = (i + 1) % 3, b = (i + 2) % 3;
    int64_t ax = of->x[a][piece], ay = of->y[a][piece];
    int64_t right = (int64_t)x * SUBPIXELS + SUBPIXELS / 2 - ax;
    int64_t up = (int64_t)y * SUBPIXELS + SUBPIXELS / 2 - ay;
    return (of->x[b][piece] - ax) * up - (of->y[b][piece] - ay) * right;
}

/* Corners up to `reach` from the first, in 1/256 pixel, clockwise or not. */
static struct corners_together any_corners(int reach) {
    struct corners_together corners;
    for (int i = 0; i < TOGETHER; i++) {
        int x = any_int(-(1 << 24), 1 << 24), y = any_int(-(1 << 24), 1 << 24);
        for (int c = 0; c < 3; c++) {
            corners.x[c][i] = x + (c > 0 ? any_int(-reach, reach) : 0);
            corners.y[c][i] = y + (c > 0 ? any_int(-reach, reach) : 0);
            corners.recip_w[c][i] = exp2(random_real(&random_state, -130, 7));
            for (int k = 0; k < VARYING_LIMIT; k++) {
                corners.varyings[c][k][i] = random_real(&random_state, -1, 1);
            }
        }
    }
    return corners;
}

static void test_edges(void) {
    for (int run = 0; run < RUNS; run++) {
        struct corners_together corners = any_corners(run % 2 ? 1 << 25 : 300);
        struct planes_together edge[3];
        ints x0, y0;
        find_edge_planes(&corners, &x0, &y0, edge);
        for (size_t i = 0; i < TOGETHER; i++) {
            int x = any_int(-1000, 1000), y = any_int(-1000, 1000);
            CHECK(x0[i] == (int)floor(corners.x[0][i] / 256.0));
            CHECK(y0[i] == (int)floor(corners.y[0][i] / 256.0));
            for (int e = 0; e < 3; e++) {
                double value = edge[e].origin[i] + edge[e].dx[i] * x + edge[e].dy[i] * y;
                CHECK(value == (double)plain_edge(&corners, i, e, x0[i] + x, y0[i] + y));
            }
        }
    }
}

static void test_units(void) {
    static const double numbers[] = {1, 1.5, 2, 0x1.fffffffffffffp-1, 128, 0x1p-900, 3e300};
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        doubles unit = units_of(doubles_all(numbers[i]));
        for (int lane = 0; lane < TOGETHER; lane++) {
            int exponent;
            CHECK(frexp(unit[lane], &exponent) == 0.5);
            CHECK(numbers[i] * unit[lane] >= 1 && numbers[i] * unit[lane] < 2);
        }
    }
    CHECK(units_of(doubles_all(0x1p-1074))[0] == 0x1p1022);
}

/* A plane on the screen over a piece, and a number of the piece's corners. */
struct varying_plane {
    real origin, dx, dy, corner;
};

static struct varying_plane varying_plane(const real *planes, size_t k) {
    return (struct varying_plane){plane_at(planes, k, PLANE_ORIGIN), plane_at(planes, k, PLANE_DX),
                                  plane_at(planes, k, PLANE_DY), plane_at(planes, k, PLANE_CORNER)};
}

/* A plane at a corner of its piece. */
static double at_corner(struct varying_plane plane, const real *planes,
                        const struct corners_together *of, size_t piece, int c) {
    double right = (of->x[c][piece] - 128) / 256.0 - planes[PLANES_X0 * TOGETHER];
    double up = (of->y[c][piece] - 128) / 256.0 - planes[PLANES_Y0 * TOGETHER];
    return plane.origin + plane.dx * right + plane.dy * up;
}

/* Some roundings of a number that is about 1. */
static const double few_roundings = sizeof(real) == sizeof(float) ? 1e-6 : 1e-14;

/* Planes are rounded, and in slivers far steeper than what they are at corners. */
static double rounding_of(struct varying_plane plane) {
    double steepest = fabs(plane.dx) > fabs(plane.dy) ? fabs(plane.dx) : fabs(plane.dy);
    return few_roundings * (fabs(plane.origin) + 2 * 300 / 256.0 * steepest);
}

static void check_piece(const struct corners_together *of, const real *planes, size_t i) {
    size_t n = shader.varying_count;
    const double *w[3] = {of->recip_w[0], of->recip_w[1], of->recip_w[2]};
    double most = fmax(fmax(w[0][i], w[1][i]), w[2][i]);
    double unit = exp2(-floor(log2(most))), least = fmin(fmin(w[0][i], w[1][i]), w[2][i]) * unit;
    struct varying_plane bottom = varying_plane(planes, n);
    CHECK(bottom.corner == (real)(least > 1e-30 ? least : 1e-30));
    for (int c = 0; c < 3; c++) {
        double below = at_corner(bottom, planes, of, i, c);
        CHECK(fabs(below - w[c][i] * unit) <= rounding_of(bottom) + few_roundings);
        for (size_t k = 0; k < n; k++) {
            double change = of->varyings[c][k][i] - of->varyings[0][k][i];
            struct varying_plane top = varying_plane(planes, k);
            double above = at_corner(top, planes, of, i, c);
            CHECK(top.corner == (real)of->varyings[0][k][i]);
            CHECK(fabs(above - change * w[c][i] * unit) <= rounding_of(top) + few_roundings);
        }
    }
}

static void test_planes(void) {
    for (int run = 0; run < RUNS; run++) {
        struct corners_together corners = any_corners(300);
        /* Behind other planes, so that it shows where they begin. */
        real found[3 * TOGETHER * PLANES_SIZE(VARYING_LIMIT)];
        size_t first = TOGETHER * (size_t)(run % 3);
        find_planes(&corners, &shader, found + first * PLANES_SIZE(shader.varying_count));
        for (size_t i = 0; i < TOGETHER; i++) {
            int64_t area = 0;
            for (int e = 0; e < 3; e++) {
                area += plain_edge(&corners, i, e, 0, 0);
            }
            if (area != 0) {
                check_piece(&corners, planes_of(found, &shader, first + i), i);
            }
        }
    }
}

UNIT_MAIN(TEST(test_edges), TEST(test_units), TEST(test_planes))
