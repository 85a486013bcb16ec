/* Models moved and scaled into view. */
#include "files/fit.h"

#include "oracle/oracle.h"
#include "oracle/shown.h"
#include "unit/unit.h"

enum { CORNERS = 12 };

struct cloud {
    struct model model;
    struct vec3 positions[CORNERS + 1];
    struct face faces[CORNERS / 3];
};

/* Corners in a box of that size around `middle`, and a position that no face names. */
static void make_cloud(struct cloud *cloud, struct vec3 middle, struct vec3 size,
                       struct random *random) {
    cloud->model = plain_model(cloud->positions, CORNERS + 1, cloud->faces, CORNERS / 3, NULL);
    for (size_t i = 0; i < CORNERS; i++) {
        struct vec3 p = random_vec3(random, 1);
        cloud->positions[i] = (struct vec3){middle.x + size.x * p.x, middle.y + size.y * p.y,
                                            middle.z + size.z * p.z};
    }
    cloud->positions[CORNERS] = (struct vec3){1e30, -1e30, 5};
}

/* Each side of the box is that of another corner, and no corner is left out. */
static void test_box(void) {
    struct random random = {70};
    for (uint32_t i = 0; i < CORNERS * 6; i++) {
        struct cloud cloud;
        make_cloud(&cloud, (struct vec3){0, 0, 0}, (struct vec3){0.5, 0.5, 0.5}, &random);
        struct box3 kept = model_box(&cloud.model);
        double far = i % 2 == 0 ? -1 : 1;
        struct vec3 *corner = &cloud.positions[i / 6];
        double *const coordinate[3] = {&corner->x, &corner->y, &corner->z};
        *coordinate[i / 2 % 3] = far;
        struct box3 box = model_box(&cloud.model);
        const double sides[6] = {box.least.x,    box.greatest.x, box.least.y,
                                 box.greatest.y, box.least.z,    box.greatest.z};
        CHECK(sides[i % 6] == far);
        CHECK(!box_reaches_out(kept) && !box_reaches_out(box));
    }
}

static double longest_side(struct box3 box) {
    struct vec3 size = vec3_sub(box.greatest, box.least);
    return fmax(size.x, fmax(size.y, size.z));
}

static double farthest(const struct cloud *cloud) {
    double result = 0;
    for (int i = 0; i < CORNERS; i++) {
        result = fmax(result, vec3_length(cloud->positions[i]));
    }
    return result;
}

/* The distance of two corners, as a part of that of two others, is kept. */
static double proportion(const struct cloud *cloud) {
    const struct vec3 *p = cloud->positions;
    return vec3_length(vec3_sub(p[0], p[1])) / vec3_length(vec3_sub(p[2], p[3]));
}

static void test_fit(void) {
    static const struct vec3 sizes[] = {{1, 1, 1},    {100, 1, 2},        {1, 50, 2},
                                        {0.1, 2, 30}, {1e-6, 1e-6, 1e-6}, {1e20, 1e20, 1e20}};
    static const struct vec3 middles[] = {{0, 0, 0}, {5, -7, 9}, {0, 1e3, 0}};
    struct random random = {71};
    for (size_t i = 0; i < 6 * 3 * 2; i++) {
        struct cloud cloud;
        bool all_around = i % 2 == 1;
        make_cloud(&cloud, middles[i / 2 % 3], sizes[i / 6], &random);
        double kept = proportion(&cloud);
        struct vec3 way = vec3_sub(cloud.positions[0], cloud.positions[1]);
        model_fit(&cloud.model, all_around);
        struct vec3 now = vec3_sub(cloud.positions[0], cloud.positions[1]);
        CHECK(vec3_dot(vec3_normalized(way), vec3_normalized(now)) > 1 - 1e-6); /* not mirrored */
        struct box3 box = model_box(&cloud.model);
        CHECK(!box_reaches_out(box));
        CHECK(fabs(proportion(&cloud) / kept - 1) < 1e-6);
        CHECK(vec3_length(vec3_add(box.least, box.greatest)) < 1e-6);
        CHECK(all_around ? fabs(farthest(&cloud) - 0.875) < 1e-12
                         : fabs(longest_side(box) - 1.9) < 1e-12);
    }
}

/* As the rotation matrices say, and nothing is rounded: positions, and normals of any length. */
static void test_turn(void) {
    static const struct vec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const struct vec3 v = {0.1, -1.0 / 3, 7e-9};
    for (int i = -64; i < 64; i++) {
        const int turns[3] = {i % 4, i / 4 % 4, i / 16};
        float normals[][3] = {{0.1F, -0.25F, 9}, {0.1F, -0.25F, 9}};
        struct vec3 positions[] = {v, v};
        struct model model = {
            .positions = positions, .position_count = 2, .normals = normals, .normal_count = 2};
        struct vec4 expected = {v.x, v.y, v.z, 1}, normal = {0.1F, -0.25F, 9, 0};
        for (int k = 0; k < 3; k++) {
            struct mat4 rotation = mat4_rotation(axes[k], turns[k] / 4.0);
            expected = mat4_apply(&rotation, expected);
            normal = mat4_apply(&rotation, normal);
        }
        model_turn(&model, turns);
        struct vec3 position = positions[i & 1];
        CHECK(position.x == expected.x && position.y == expected.y && position.z == expected.z);
        const float *n = normals[i & 1];
        CHECK((double)n[0] == normal.x && (double)n[1] == normal.y && (double)n[2] == normal.z);
        CHECK(memcmp(model.turns, turns, sizeof turns) == 0);
    }
}

/* Of size 0, or so small and large that a square would under- or overflow. */
static void test_odd_sizes(void) {
    static const double sizes[] = {0, 5e-324, 1e-200, 3e38};
    struct random random = {72};
    for (size_t i = 0; i < 8; i++) {
        struct cloud cloud;
        double size = sizes[i / 2];
        make_cloud(&cloud, (struct vec3){0, 0, 0}, (struct vec3){size, size, size}, &random);
        cloud.positions[0] = (struct vec3){-size, -size, -size};
        cloud.positions[1] = (struct vec3){size, size, size};
        model_fit(&cloud.model, i % 2 == 1);
        struct box3 box = model_box(&cloud.model);
        double reach = i % 2 == 1 ? 0.875 / sqrt(3) : 0.95;
        CHECK(fabs(longest_side(box) - (size > 0 ? 2 * reach : 0)) < 1e-12);
    }
}

static void test_reaching_out(void) {
    struct box3 box = {{-1, -1, -1}, {1, 1, 1}};
    double *const sides[6] = {&box.least.x,    &box.least.y,    &box.least.z,
                              &box.greatest.x, &box.greatest.y, &box.greatest.z};
    CHECK(!box_reaches_out(box));
    for (int i = 0; i < 6; i++) {
        double kept = *sides[i];
        *sides[i] *= 1.001;
        CHECK(box_reaches_out(box));
        *sides[i] = kept;
    }
}

/* Lines count as faces do, and a model may have nothing else. Each end may be the farthest. */
static void test_lines(void) {
    for (size_t i = 0; i < 8; i++) {
        struct vec3 positions[] = {{9, 9, 9}, {1, 0, 3}, {0, 1, 3}, {-1, 0, 3}, {0, -1, 3}};
        uint32_t lines[][2] = {{1, 2}, {3, 4}};
        struct model model = {
            .position_count = 5, .positions = positions, .line_count = 2, .lines = lines};
        struct vec3 *far = &positions[1 + i / 2];
        *far = (struct vec3){far->x == 0 ? 1 : far->x, far->y == 0 ? 1 : far->y, 3};
        struct box3 box = model_box(&model);
        CHECK(box.least.x == -1 && box.least.y == -1 && box.least.z == 3);
        CHECK(box.greatest.x == 1 && box.greatest.y == 1 && box.greatest.z == 3);
        model_fit(&model, i % 2 == 1);
        double reach = i % 2 == 1 ? vec3_length(*far) : longest_side(model_box(&model)) / 2;
        CHECK(fabs(reach - (i % 2 == 1 ? 0.875 : 0.95)) < 1e-12);
    }
}

static void test_tiny(void) {
    CHECK(box_is_tiny((struct box3){{5, 5, 5}, {5.3, 5.3, 5.3}}));
    CHECK(box_is_tiny((struct box3){{5, 5, 5}, {5, 5, 5}}));
    CHECK(!box_is_tiny((struct box3){{0, 0, 0}, {0, 0, 0.4}}));
    CHECK(!box_is_tiny((struct box3){{0, -0.3, 0}, {0, 0.3, 0}}));
}

UNIT_MAIN(TEST(test_turn), TEST(test_lines), TEST(test_tiny), TEST(test_box), TEST(test_fit),
          TEST(test_odd_sizes), TEST(test_reaching_out))
