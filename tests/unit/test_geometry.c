/* Vectors, matrices and cameras, as far as `make stress` does not try them. */
#include "geometry.h"
#include "oracle/oracle.h"
#include "raster.h"
#include "unit.h"

#include <stdlib.h>

static bool near(double a, double b, double tolerance) {
    return fabs(a - b) <= tolerance;
}

/* ---- Vectors ---- */

static void test_vectors(void) {
    struct vec3 x = {1, 0, 0}, y = {0, 1, 0};
    struct vec3 z = vec3_cross(x, y);
    CHECK(z.x == 0 && z.y == 0 && z.z == 1);
    CHECK(vec3_dot((struct vec3){1, 2, 3}, (struct vec3){4, -5, 6}) == 12);
    CHECK(vec3_length((struct vec3){2, 3, 6}) == 7);
    struct vec3 mixed = vec3_interpolate((struct vec3){0.25, 0.5, 0.25}, (struct vec3){4, 0, 8},
                                         (struct vec3){0, 2, 0}, (struct vec3){0, 0, 4});
    CHECK(mixed.x == 1 && mixed.y == 1 && mixed.z == 3);
    struct vec2 flat = vec2_interpolate((struct vec3){0.25, 0.5, 0.25}, (struct vec2){4, 8},
                                        (struct vec2){2, 0}, (struct vec2){0, 4});
    CHECK(flat.x == 2 && flat.y == 3);
    struct vec2 corner = parallel_view((struct vec3){1, 1, 7}, 30, 20);
    struct vec2 other = parallel_view((struct vec3){-1, -0.5, 7}, 30, 20);
    CHECK(corner.x == 30 && corner.y == 20 && other.x == 0 && other.y == 5);
}

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
    static const double lengths[] = {5e-324, 1e-310, 1e-162, 1e162, 1.7e308};
    for (size_t i = 0; i < sizeof lengths / sizeof lengths[0]; i++) {
        struct vec3 x = vec3_normalized((struct vec3){lengths[i], 0, 0});
        struct vec3 y = vec3_normalized((struct vec3){0, -lengths[i], 0});
        struct vec3 z = vec3_normalized((struct vec3){0, 0, lengths[i]});
        CHECK(x.x == 1 && x.y == 0 && x.z == 0);
        CHECK(y.x == 0 && y.y == -1 && y.z == 0);
        CHECK(z.x == 0 && z.y == 0 && z.z == 1);
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
        struct vec3 v = {random_real(&random, -1, 1), random_real(&random, -1, 1),
                         random_real(&random, -1, 1)};
        struct vec3 nearly = vec3_scale(vec3_normalized(v), 1 + random_real(&random, -1e-9, 1e-9));
        CHECK(component_error(vec3_renormalized(nearly), v) <= 2);
    }
}

/* Three equal depths give this very depth, whatever rounding did to the weights. */
static void test_depth(void) {
    struct random random = {8};
    for (int i = 0; i < 1000; i++) {
        double y = random_real(&random, 0, 0.5), z = random_real(&random, 0, 0.5);
        double depth = random_real(&random, -1, 1);
        struct vec3 weight = {1 - y - z + 0x1p-53, y, z};
        CHECK(interpolate_depth(weight, depth, depth, depth) == depth);
        CHECK(fabs(interpolate_depth(weight, 1, depth, -3) - (weight.x + y * depth - 3 * z)) <
              1e-14);
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

static void test_turn_direction(void) {
    static const double exact[][3] = {{0, 1, 0},     {0.25, 0, 1}, {0.5, -1, 0},
                                      {0.75, 0, -1}, {1, 1, 0},    {-0.25, 0, -1}};
    for (size_t i = 0; i < sizeof exact / sizeof exact[0]; i++) {
        struct vec2 d = turn_direction(exact[i][0]);
        CHECK(d.x == exact[i][1] && d.y == exact[i][2]);
    }
}

/* ---- Matrices ---- */

static struct mat4 random_matrix(struct random *random) {
    struct mat4 a;
    for (int i = 0; i < 16; i++) {
        a.m[i / 4][i % 4] = random_real(random, -10, 10);
    }
    return a;
}

static void test_product_and_transpose(void) {
    struct mat4 move = mat4_translation((struct vec3){1, 2, 3});
    struct mat4 scale = mat4_scaling((struct vec3){2, 2, 2});
    struct mat4 scale_first = mat4_mul(move, scale), move_first = mat4_mul(scale, move);
    struct vec4 p = mat4_point(&scale_first, (struct vec3){1, 1, 1});
    CHECK(p.x == 3 && p.y == 4 && p.z == 5 && p.w == 1);
    p = mat4_point(&move_first, (struct vec3){1, 1, 1});
    CHECK(p.x == 4 && p.y == 6 && p.z == 8 && p.w == 1);
    struct vec3 d = mat4_direction(&move_first, (struct vec3){1, 0, 0});
    CHECK(d.x == 2 && d.y == 0 && d.z == 0);
    struct random random = {1};
    struct mat4 a = random_matrix(&random), b = random_matrix(&random);
    struct mat4 left = mat4_transpose(mat4_mul(a, b));
    struct mat4 right = mat4_mul(mat4_transpose(b), mat4_transpose(a));
    for (int i = 0; i < 16; i++) {
        CHECK(near(left.m[i / 4][i % 4], right.m[i / 4][i % 4], 1e-12));
    }
}

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

static void test_singular(void) {
    struct mat4 kept = mat4_translation((struct vec3){7, 8, 9}), inverse = kept;
    struct mat4 zero = {{{0}}};
    CHECK(!mat4_inverse(zero, &inverse));
    struct mat4 equal_rows = mat4_identity();
    equal_rows.m[1][0] = 1, equal_rows.m[1][1] = 0; /* rows 0 and 1 are equal */
    CHECK(!mat4_inverse(equal_rows, &inverse));
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

static double orthonormality_error(const struct mat4 *view) {
    double worst = 0;
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            double dot = 0;
            for (int j = 0; j < 3; j++) {
                dot += view->m[i][j] * view->m[k][j];
            }
            worst = fmax(worst, fabs(dot - (i == k)));
        }
    }
    return worst;
}

/* Eye and center so far apart that their difference is no number, and so near to zero that its
 * square is none: the direction between them is right, and up appears upwards. */
static void test_lookat_ends_of_range(void) {
    static const double sizes[] = {1.7e308, 1e300, 1e154, 1, 1e-154, 1e-300};
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        double s = sizes[i];
        struct vec3 eye = {0.5 * s, -0.25 * s, s}, center = {-0.5 * s, 0.25 * s, -s};
        struct mat4 view = mat4_lookat(eye, center, (struct vec3){0, s, 0});
        double length = sqrt(0.25 + 0.0625 + 1), across = sqrt(1.25);
        CHECK(near(view.m[2][0], 0.5 / length, 4e-16) && near(view.m[2][1], -0.25 / length, 4e-16));
        CHECK(near(view.m[2][2], 1 / length, 4e-16));
        CHECK(near(view.m[0][0], 1 / across, 4e-16) && near(view.m[0][1], 0, 4e-16));
        CHECK(near(view.m[0][2], -0.5 / across, 4e-16) && view.m[1][1] > 0.9);
        CHECK(orthonormality_error(&view) <= 4 * 2.3e-16);
    }
}

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

static void test_projection(void) {
    struct mat4 p = mat4_projection(2);
    struct vec4 clip = mat4_point(&p, (struct vec3){0.5, 0.25, 1});
    CHECK(clip.x == 0.5 && clip.y == 0.25 && clip.z == 1 && clip.w == 0.5);
    struct mat4 parallel = mat4_projection(INFINITY), identity = mat4_identity();
    for (int i = 0; i < 16; i++) {
        CHECK(parallel.m[i / 4][i % 4] == identity.m[i / 4][i % 4]);
    }
    struct vec3 w = perspective_weights((struct vec3){0.5, 0.5, 0}, (double[]){1, 0.5, 1});
    CHECK(near(w.x, 2 / 3.0, 1e-16) && near(w.y, 1 / 3.0, 1e-16) && w.z == 0);
    struct vec3 same = perspective_weights((struct vec3){512, 512, 0}, (double[]){1, 0.5, 1});
    CHECK(same.x == w.x && same.y == w.y && same.z == 0); /* a common factor does not count */
    struct vec3 three = perspective_weights((struct vec3){1, 2, 3}, (double[]){0.5, 0.25, 2});
    CHECK(near(three.x, 0.5 / 7, 1e-16) && near(three.y, 0.5 / 7, 1e-16));
    CHECK(near(three.z, 6.0 / 7, 2e-16));
}

/* ---- Triangles ---- */

static void test_depth_clear(void) {
    double depth[5] = {1, 2, NAN, -3, 0};
    depth_clear(depth, 4);
    CHECK(depth[0] == -INFINITY && depth[1] == -INFINITY && depth[2] == -INFINITY);
    CHECK(depth[3] == -INFINITY && depth[4] == 0);
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

/* A triangle without area is refused, because weights are divided by it; and one between
 * centres. */
static void test_no_area(void) {
    struct edges edges;
    struct fixed2 a = {0, 0}, b = {2560, 2560}, c = {1280, 1280}, left = {0, 2560}, low = {2560, 0};
    CHECK(!edges_setup(&edges, a, left, (struct fixed2){100, 1280}, 20, 20));
    CHECK(!edges_setup(&edges, a, low, (struct fixed2){1280, 100}, 20, 20));
    CHECK(!edges_setup(&edges, a, b, c, 20, 20) && !edges_setup(&edges, c, b, a, 20, 20));
}

UNIT_MAIN(TEST(test_vectors), TEST(test_normalized_components), TEST(test_renormalized),
          TEST(test_depth), TEST(test_level_from), TEST(test_turn_direction),
          TEST(test_product_and_transpose), TEST(test_inverse_nearly_singular), TEST(test_singular),
          TEST(test_rotation), TEST(test_lookat_ends_of_range), TEST(test_lookat_along_up),
          TEST(test_perpendicular_axis), TEST(test_inverse_overflow), TEST(test_projection),
          TEST(test_depth_clear), TEST(test_snap), TEST(test_no_area))
