/* Vectors, matrices and cameras, as far as `make stress` does not try them. */
#include "geometry.h"
#include "oracle/oracle.h"
#include "raster.h"
#include "unit.h"

static bool near(double a, double b, double tolerance) {
    return fabs(a - b) <= tolerance;
}

/* ---- Vectors ---- */

/* How far a component is from that of the exact unit vector, in ulp of 1. */
static double component_error(struct vec3 n, struct vec3 v) {
    long double x = (long double)v.x, y = (long double)v.y, z = (long double)v.z;
    long double length = sqrtl(x * x + y * y + z * z);
    long double worst =
        fmaxl(fabsl((long double)n.x - x / length),
              fmaxl(fabsl((long double)n.y - y / length), fabsl((long double)n.z - z / length)));
    return (double)worst * 0x1p52;
}

/* Every component, at every size that a double has: also where the square of the length is 0,
 * subnormal or infinite, and where one component is far longer than the others. */
static void test_normalized_components(void) {
    struct random random = {6};
    for (int i = 0; i < 40000; i++) {
        int size = i % 2000 - 1022, spread = i / 2000 % 4 == 0 ? 40 : 2;
        double v[3];
        for (int k = 0; k < 3; k++) {
            v[k] =
                ldexp(random_real(&random, -1, 1), size - (int)random_between(&random, 0, spread));
        }
        struct vec3 a = {v[i % 3], v[(i + 1) % 3], v[(i + 2) % 3]};
        CHECK(component_error(vec3_normalized(a), a) <= 2);
        if (component_error(vec3_normalized(a), a) > 2) {
            return;
        }
    }
    struct vec3 zero = vec3_normalized((struct vec3){0, 0, 0});
    CHECK(zero.x == 0 && zero.y == 0 && zero.z == 0);
    struct vec3 infinite = vec3_normalized((struct vec3){INFINITY, 1, 0});
    CHECK(infinite.x == 0 && infinite.y == 0 && infinite.z == 0);
}

/* One step of Newton's method squares the error. */
static void test_renormalized(void) {
    struct random random = {7};
    for (int i = 0; i < 1000; i++) {
        struct vec3 v = random_vec3(&random, 1);
        struct vec3 nearly = vec3_scale(vec3_normalized(v), 1 + random_real(&random, -1e-9, 1e-9));
        CHECK(component_error(vec3_renormalized(nearly), v) <= 2);
    }
}

static void test_vec2(void) {
    struct vec2 a = {3, 5}, b = {1, -2}, sum = vec2_add(a, b), rest = vec2_sub(a, b);
    struct vec2 twice = vec2_scale(a, 2);
    CHECK(sum.x == 4 && sum.y == 3 && rest.x == 2 && rest.y == 7);
    CHECK(twice.x == 6 && twice.y == 10);
}

/* Three equal depths give this very depth, whatever rounding did to the weights. */
static void test_depth(void) {
    struct random random = {8};
    for (int i = 0; i < 1000; i++) {
        double y = random_real(&random, 0, 0.5), z = random_real(&random, 0, 0.5);
        double depth = random_real(&random, -1, 1);
        struct vec3 weight = {1 - y - z + 0x1p-53, y, z};
        CHECK(interpolate_depth(weight, depth, depth, depth) == depth);
    }
}

static void test_level_from(void) {
    static const struct {
        double value;
        int level;
    } rows[] = {{0, 0},      {0.49, 0}, {0.5, 1},   {254.49, 254},   {254.5, 255}, {255, 255},
                {1e30, 255}, {-1, 0},   {-1e30, 0}, {INFINITY, 255}, {255.5, 255}, {255.6, 255},
                {256, 255},  {NAN, 0},  {-0.0, 0},  {-INFINITY, 0},  {127.5, 128}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        CHECK(level_from(rows[i].value) == rows[i].level);
    }
}

/* ---- Matrices ---- */

/* Rows and columns of the 2 x 2 matrix that is nearly singular, (1 1; 1 1 + 2^-k), whose inverse is
 * known exactly. Scaled by rows its condition is about 2^(k+2). */
static void test_inverse_nearly_singular(void) {
    for (int k = 2; k <= 50; k++) {
        struct mat4 a = mat4_identity(), inverse;
        a.m[0][1] = a.m[1][0] = 1;
        a.m[1][1] = 1 + ldexp(1, -k);
        bool inverted = mat4_inverse(a, &inverse);
        if (k >= 49) {
            CHECK(!inverted);
        } else if (k <= 46 && CHECK(inverted)) { /* in between, either is right */
            double large = ldexp(1, k);
            CHECK(inverse.m[0][0] == large + 1 && inverse.m[0][1] == -large);
            CHECK(inverse.m[1][0] == -large && inverse.m[1][1] == large);
            CHECK(inverse.m[2][2] == 1 && inverse.m[2][3] == 0 && inverse.m[0][2] == 0);
        }
    }
}

/* The last row takes part in everything. */
static void test_last_row(void) {
    struct mat4 a, transpose, inverse, thin = mat4_identity();
    for (int i = 0; i < 16; i++) {
        a.m[i / 4][i % 4] = i;
    }
    transpose = mat4_transpose(a);
    for (int i = 0; i < 16; i++) {
        CHECK(transpose.m[i % 4][i / 4] == i);
    }
    thin.m[3][0] = 1;
    thin.m[3][3] = 0x1p-60; /* so that only the last row of the inverse is large */
    CHECK(!mat4_inverse(thin, &inverse));
}

static void test_not_finite(void) {
    struct mat4 kept = mat4_translation((struct vec3){7, 8, 9}), inverse = kept;
    struct mat4 infinite = mat4_identity();
    infinite.m[2][3] = INFINITY;
    CHECK(!mat4_inverse(infinite, &inverse));
    infinite.m[2][3] = NAN;
    CHECK(!mat4_inverse(infinite, &inverse));
    CHECK(memcmp(&inverse, &kept, sizeof inverse) == 0);
}

static void test_rotation(void) {
    struct mat4 quarter = mat4_rotation((struct vec3){0, 0, 5}, 0.25);
    struct vec4 p = mat4_point(&quarter, (struct vec3){1, 0, 3});
    CHECK(near(p.x, 0, 1e-16) && near(p.y, 1, 1e-16) && p.z == 3);
    struct mat4 full = mat4_mul(mat4_rotation((struct vec3){1, 2, 3}, 0.7),
                                mat4_rotation((struct vec3){1, 2, 3}, 0.3));
    struct mat4 identity = mat4_identity();
    for (int i = 0; i < 16; i++) {
        CHECK(near(full.m[i / 4][i % 4], identity.m[i / 4][i % 4], 1e-15));
    }
}

/* ---- Cameras ---- */

/* Of axes that are equally near to perpendicular y comes before x, and x before z. */
static void test_perpendicular_axis(void) {
    static const struct vec3 rows[][2] = {
        {{-3, 1, 2}, {0, 1, 0}}, {{1, -3, 2}, {1, 0, 0}}, {{3, 2, -1}, {0, 0, 1}},
        {{1, -1, 2}, {0, 1, 0}}, {{2, 1, -1}, {0, 1, 0}}, {{-1, 2, 1}, {1, 0, 0}},
        {{1, 1, 1}, {0, 1, 0}},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct vec3 axis = vec3_perpendicular_axis(rows[i][0]), right = rows[i][1];
        CHECK(axis.x == right.x && axis.y == right.y && axis.z == right.z);
    }
}

/* Where the camera looks along `up`, the axis most nearly perpendicular to it shows upwards. */
static void test_lookat_along_up(void) {
    static const struct vec3 rows[][2] = {
        {{2, 1, 0.5}, {0, 0, 1}}, {{0.5, 1, 2}, {1, 0, 0}}, {{2, 0.5, 1}, {0, 1, 0}}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct mat4 view = mat4_lookat(rows[i][0], (struct vec3){0, 0, 0}, rows[i][0]);
        struct vec3 up = mat4_direction(&view, rows[i][1]);
        struct vec3 eye = mat4_direction(&view, vec3_normalized(rows[i][0]));
        CHECK(up.y > 0.5 && near(up.x, 0, 1e-15));
        CHECK(near(eye.x, 0, 1e-15) && near(eye.y, 0, 1e-15) && near(eye.z, 1, 1e-15));
    }
}

/* Matrices whose inverse is too large for a double, for infinity and for infinity minus
 * infinity. */
static void test_inverse_overflow(void) {
    struct mat4 tiny = mat4_scaling((struct vec3){1e-310, 1e-310, 1e-310}), inverse = {{{7}}};
    CHECK(!mat4_inverse(tiny, &inverse) && inverse.m[0][0] == 7);
    for (int row = 0; row < 4; row++) {
        for (int column = 0; column < 4; column++) {
            tiny.m[row][column] = (row & column) == 1 || (row & column) == 2 ? -1e-310 : 1e-310;
        }
    }
    CHECK(!mat4_inverse(tiny, &inverse) && inverse.m[0][0] == 7);
}

static void test_snap(void) {
    struct fixed2 f = {7, 7};
    CHECK(screen_snap((struct vec2){0.5, -0.5}, &f) && f.x == 128 && f.y == -128);
    CHECK(screen_snap((struct vec2){0.5 / 256, -0.5 / 256}, &f) && f.x == 1 && f.y == 0);
    CHECK(screen_snap((struct vec2){SCREEN_LIMIT, -SCREEN_LIMIT}, &f));
    f = (struct fixed2){7, 7};
    CHECK(!screen_snap((struct vec2){NAN, 0}, &f));
    CHECK(!screen_snap((struct vec2){0, INFINITY}, &f));
    CHECK(!screen_snap((struct vec2){SCREEN_LIMIT + 1, 0}, &f));
    CHECK(f.x == 7 && f.y == 7);
}

UNIT_MAIN(TEST(test_normalized_components), TEST(test_renormalized), TEST(test_vec2),
          TEST(test_depth), TEST(test_level_from), TEST(test_inverse_nearly_singular),
          TEST(test_last_row), TEST(test_not_finite), TEST(test_rotation),
          TEST(test_lookat_along_up), TEST(test_perpendicular_axis), TEST(test_inverse_overflow),
          TEST(test_snap))
