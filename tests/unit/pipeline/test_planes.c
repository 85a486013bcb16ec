/* pipeline/planes.h against plain answers: edge functions in whole numbers, and what the planes are
 * at the corners. */
#include "oracle/oracle.h"
#include "pipeline.h"
#include "unit/unit.h"

enum { RUNS = 300 };

static struct random random_state = {23};

static const struct shader shader = {.varying_count = 4};

static int any_int(int least, int most) {
    return (int)floor(random_real(&random_state, least, most + 1.0));
}

/* What a piece's corners are and hand over. */
struct corners {
    struct fixed2 at[3];
    struct corner_values value[3];
};

/* Edge i at the centre of a pixel, in 1/256 pixel squared. */
static int64_t plain_edge(const struct corners *of, int i, int x, int y) {
    struct fixed2 a = of->at[(i + 1) % 3], b = of->at[(i + 2) % 3];
    int64_t right = (int64_t)x * SUBPIXELS + SUBPIXELS / 2 - a.x;
    int64_t up = (int64_t)y * SUBPIXELS + SUBPIXELS / 2 - a.y;
    return ((int64_t)b.x - a.x) * up - ((int64_t)b.y - a.y) * right;
}

/* Corners up to `reach` from the first, in 1/256 pixel, clockwise or not. */
static struct corners any_corners(int reach) {
    struct corners corners;
    int x = any_int(-(1 << 24), 1 << 24), y = any_int(-(1 << 24), 1 << 24);
    for (int c = 0; c < 3; c++) {
        corners.at[c].x = x + (c > 0 ? any_int(-reach, reach) : 0);
        corners.at[c].y = y + (c > 0 ? any_int(-reach, reach) : 0);
        corners.value[c].recip_w = exp2(random_real(&random_state, -130, 7));
        for (int k = 0; k < VARYING_LIMIT; k++) {
            corners.value[c].varyings[k] = random_real(&random_state, -1, 1);
        }
    }
    return corners;
}

static void test_edges(void) {
    for (int run = 0; run < RUNS * 8; run++) {
        int reach = run % 2 ? 1 << 25 : 300;
        int64_t a[2] = {any_int(-reach, reach), any_int(-reach, reach)};
        int64_t b[2] = {any_int(-reach, reach), any_int(-reach, reach)};
        int x = any_int(-1000, 1000), y = any_int(-1000, 1000);
        double4 edge = edge_plane((double[2]){(double)a[0], (double)a[1]},
                                  (double[2]){(double)b[0], (double)b[1]});
        int64_t right = x * (int64_t)SUBPIXELS - a[0], up = y * (int64_t)SUBPIXELS - a[1];
        int64_t expected = (b[0] - a[0]) * up - (b[1] - a[1]) * right;
        CHECK(edge[0] + edge[1] * x + edge[2] * y == (double)expected && edge[3] == 0);
    }
}

static void test_units(void) {
    static const double numbers[] = {1, 1.5, 2, 0x1.fffffffffffffp-1, 128, 0x1p-900, 3e300};
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        int exponent;
        double unit = unit_of(numbers[i]);
        CHECK(frexp(unit, &exponent) == 0.5);
        CHECK(numbers[i] * unit >= 1 && numbers[i] * unit < 2);
    }
    CHECK(unit_of(0x1p-1074) == 0x1p1022);
}

/* A plane at a corner of its piece. */
static double at_corner(const struct plane *plane, const struct planes *planes, struct fixed2 at) {
    double right = (at.x - 128) / 256.0 - planes->x0, up = (at.y - 128) / 256.0 - planes->y0;
    return plane->origin + plane->dx * right + plane->dy * up;
}

/* Some roundings of a number that is about 1. */
static const double few_roundings = sizeof(real) == sizeof(float) ? 1e-6 : 1e-14;

/* Planes are rounded, and in slivers far steeper than what they are at corners. */
static double rounding_of(const struct plane *plane) {
    double steepest = fabs(plane->dx) > fabs(plane->dy) ? fabs(plane->dx) : fabs(plane->dy);
    return few_roundings * (fabs(plane->origin) + 2 * 300 / 256.0 * steepest);
}

static void check_piece(const struct corners *of, const struct planes *planes) {
    size_t n = shader.varying_count;
    const double w[3] = {of->value[0].recip_w, of->value[1].recip_w, of->value[2].recip_w};
    double unit = exp2(-floor(log2(fmax(fmax(w[0], w[1]), w[2]))));
    double least = fmin(fmin(w[0], w[1]), w[2]) * unit;
    const struct plane *bottom = &planes->plane[n];
    CHECK(planes->x0 == (real)floor(of->at[0].x / 256.0));
    CHECK(planes->y0 == (real)floor(of->at[0].y / 256.0));
    CHECK(bottom->corner == (real)(least > 1e-30 ? least : 1e-30));
    for (int c = 0; c < 3; c++) {
        double below = at_corner(bottom, planes, of->at[c]);
        CHECK(fabs(below - w[c] * unit) <= rounding_of(bottom) + few_roundings);
        for (size_t k = 0; k < n; k++) {
            double change = of->value[c].varyings[k] - of->value[0].varyings[k];
            const struct plane *top = &planes->plane[k];
            double above = at_corner(top, planes, of->at[c]);
            CHECK(top->corner == (real)of->value[0].varyings[k]);
            CHECK(fabs(above - change * w[c] * unit) <= rounding_of(top) + few_roundings);
        }
    }
}

static void test_planes(void) {
    _Alignas(struct planes) char memory[sizeof(struct planes) + 5 * sizeof(struct plane)];
    struct planes *planes = (void *)memory;
    CHECK(sizeof memory == planes_size(&shader));
    for (int run = 0; run < RUNS * 8; run++) {
        struct corners corners = any_corners(300);
        int64_t area = 0;
        for (int e = 0; e < 3; e++) {
            area += plain_edge(&corners, e, 0, 0);
        }
        find_planes(corners.at, corners.value, &shader, planes);
        if (area != 0) {
            check_piece(&corners, planes);
        }
    }
}

UNIT_MAIN(TEST(test_edges), TEST(test_units), TEST(test_planes))
