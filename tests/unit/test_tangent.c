/* The axes of tangent space. (What is read of a normal map with them: tests/lessons/board.h.) */
#include "tangent.h"

#include "oracle/oracle.h"
#include "unit/unit.h"

static bool near(struct vec3 a, struct vec3 b) {
    return vec3_length(vec3_sub(a, b)) < 1e-6;
}

/* A face whose picture was laid on it by a known matrix: u grows along `to_u`, v along `to_v`. */
struct patch {
    struct vec3 positions[3];
    float uvs[3][2], normals[1][3];
    struct face faces[2]; /* the second one counts */
    struct model model;
};

static void lay(struct patch *patch, double places[3][2], struct vec3 to_u, struct vec3 to_v,
                struct vec3 normal) {
    *patch = (struct patch){.normals = {{(float)normal.x, (float)normal.y, (float)normal.z}}};
    for (uint32_t i = 0; i < 3; i++) {
        double u = places[i][0], v = places[i][1];
        patch->uvs[i][0] = (float)u;
        patch->uvs[i][1] = (float)v;
        patch->positions[i] = vec3_add(vec3_scale(to_u, u), vec3_scale(to_v, v));
        patch->faces[0].corner[2 - i] = patch->faces[1].corner[i] = (struct corner){i, i, 0};
    }
    patch->model = (struct model){.positions = patch->positions,
                                  .position_count = 3,
                                  .uvs = patch->uvs,
                                  .uv_count = 3,
                                  .normals = patch->normals,
                                  .normal_count = 1,
                                  .faces = patch->faces,
                                  .face_count = 2};
}

/* Wherever the picture's corners lie, also where it is mirrored. */
static void test_axes(void) {
    static const struct vec3 x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1};
    struct random random = {80};
    for (int i = 0; i < 1000; i++) {
        double places[3][2], sign = i % 2 == 0 ? 1 : -1;
        for (int k = 0; k < 6; k++) {
            places[k / 2][k % 2] = (int)random_real(&random, -8, 8) / 4.0; /* exact as floats */
        }
        double area = (places[1][0] - places[0][0]) * (places[2][1] - places[0][1]) -
                      (places[2][0] - places[0][0]) * (places[1][1] - places[0][1]);
        struct patch patch;
        lay(&patch, places, vec3_scale(y, 0.5), vec3_scale(z, 3 * sign), vec3_scale(x, 4));
        for (size_t corner = 0; corner < 3; corner++) {
            struct tangent_axes axes = model_tangent_axes(&patch.model, 1, corner);
            CHECK(near(axes.normal, x));
            CHECK(near(vec3_cross(axes.u, axes.v), x) ||
                  near(vec3_cross(axes.u, axes.v), vec3_scale(x, -1)));
            CHECK(area == 0 || (near(axes.u, y) && near(axes.v, vec3_scale(z, sign))));
        }
    }
}

/* The normal of a corner leans, as it does where the mesh is round: the axes lean with it. */
static void test_leaning(void) {
    double places[3][2] = {{0, 0}, {1, 0}, {0, 1}};
    const struct vec3 x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1};
    struct patch patch;
    lay(&patch, places, x, y, (struct vec3){0.6, 0, 0.8});
    struct tangent_axes axes = model_tangent_axes(&patch.model, 1, 1);
    CHECK(near(axes.u, (struct vec3){0.8, 0, -0.6}) && near(axes.v, y));
    lay(&patch, places, (struct vec3){1e-7, 1e-11, 0}, z, x); /* a small part along the surface */
    CHECK(near(model_tangent_axes(&patch.model, 1, 1).u, y));
    const struct vec3 normals[] = {x, y, z, {sqrt(0.5), sqrt(0.5), 0}};
    for (int i = 0; i < 4; i++) { /* u says nothing here: any direction along the surface */
        lay(&patch, places, normals[i], normals[(i + 1) % 3], normals[i]);
        axes = model_tangent_axes(&patch.model, 1, 1);
        CHECK(fabs(fabs(vec3_dot(vec3_cross(axes.u, axes.v), normals[i])) - 1) < 1e-6);
    }
    patch.faces[1].corner[2].uv = MODEL_NONE;
    patch.faces[1].corner[1].uv = MODEL_NONE;
    axes = model_tangent_axes(&patch.model, 1, 0);
    CHECK(fabs(vec3_length(axes.u) - 1) < 1e-6 && fabs(vec3_length(axes.v) - 1) < 1e-6);
}

UNIT_MAIN(TEST(test_axes), TEST(test_leaning))
