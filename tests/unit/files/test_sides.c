/* Faces that are seen from both sides. */
#include "files/sides.h"

#include "files/model_file.h"
#include "files/normals.h"
#include "unit/images.h"

#define OCTAHEDRON "v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\n"

static struct model decode(const char *text) {
    struct model model = {0};
    struct error error = {0};
    if (!CHECK(model_decode(&model, text, strlen(text), &error))) {
        fprintf(stderr, "    %s\n", error.message);
        exit(1);
    }
    return model;
}

static bool same_corner(struct corner a, struct corner b) {
    return a.position == b.position && a.uv == b.uv;
}

/* The two sides of face i have the same corners, the other way round, and opposite normals, which
 * point to where each side looks. */
static void check_sides(const struct model *model, size_t i) {
    const struct face *a = &model->faces[2 * i], *b = &model->faces[2 * i + 1];
    CHECK(same_corner(a->corner[0], b->corner[0]) && same_corner(a->corner[1], b->corner[2]) &&
          same_corner(a->corner[2], b->corner[1]));
    for (size_t k = 0; k < 3; k++) {
        struct vec3 n = model_normal(model, 2 * i, k);
        struct vec3 other = model_normal(model, 2 * i + 1, (3 - k) % 3);
        CHECK(n.x == -other.x && n.y == -other.y && n.z == -other.z);
        CHECK(vec3_dot(n, model_face_normal(model, 2 * i)) > 0);
        CHECK(vec3_dot(other, model_face_normal(model, 2 * i + 1)) > 0);
    }
}

/* However its faces are wound, the computed normals of a solid point away from its middle on the
 * outside. */
static void test_mixed_winding(void) {
    for (unsigned wound = 0; wound < 256; wound++) {
        char text[512] = OCTAHEDRON;
        for (unsigned k = 0; k < 8; k++) { /* in many orders */
            unsigned i = (k * 3 + wound) % 8 ^ wound >> 5;
            unsigned x = 1 + (i & 1), y = 3 + (i >> 1 & 1), z = 5 + (i >> 2);
            bool turned = (wound >> i & 1) != 0;
            snprintf(text + strlen(text), sizeof text - strlen(text), "f %u %u %u\n", x,
                     turned ? y : z, turned ? z : y);
        }
        struct model model = decode(text);
        struct error error;
        model.hard_given = true;
        model.hard_degrees = 180;
        CHECK(model_add_other_sides(&model, true, &error) && model.face_count == 16);
        for (size_t i = 0; i < 8; i++) {
            check_sides(&model, i);
        }
        for (size_t i = 0; i < 48; i++) {
            struct vec3 p = model_position(&model, i / 3, i % 3);
            double along = vec3_dot(model_normal(&model, i / 3, i % 3), p);
            bool outside = vec3_dot(model_face_normal(&model, i / 3), p) > 0;
            CHECK(outside ? along > 0.999999 : along < -0.999999);
        }
        model_free(&model);
    }
}

/* Normals of the file count, whatever the winding; what belongs to faces follows them. */
static void test_kept(void) {
    struct model model = decode("OFF\n4 3\n0 0 0\n1 0 0\n1 1 0\n0 1 5\n"
                                "3 0 1 2 255 0 0\n3 2 1 3 0 255 0\n3 0 2 3 0 0 255\n");
    const float expected[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    struct error error;
    CHECK(model_add_other_sides(&model, false, &error) && model.face_count == 6);
    for (size_t i = 0; i < 18; i++) {
        CHECK(model.faces[i / 3].corner[i % 3].normal == MODEL_NONE);
        CHECK(model.face_colors[i / 3][i % 3] == expected[i / 6][i % 3]);
    }
    model_free(&model);
    model =
        decode("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0.5 0 2\nvn 0 0 -9\nvt 0 0\nvt 1 0\n"
               "usemtl a\nf 1/1/1 2/2/1 3/1/1\nusemtl b\nf 1/1/2 2/2/2 3/2/2\nf 1//1 3//1 2//1\n");
    CHECK(model_add_other_sides(&model, true, &error) && model.face_count == 6);
    CHECK(model.normal_count == 2 * 2);
    for (size_t i = 0; i < 3; i++) {
        check_sides(&model, i);
    }
    for (size_t i = 0; i < 6; i++) {
        CHECK(model.face_materials[i] == (i < 2 ? 0 : 1));
    }
    model_free(&model);
    model = decode("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 1 1 0\nf 1//1 2//1 3\n");
    CHECK(model_add_other_sides(&model, false, &error));
    CHECK(model.faces[0].corner[2].normal == MODEL_NONE && model.faces[0].corner[0].normal == 0);
    CHECK(model.faces[1].corner[1].normal == MODEL_NONE && model.faces[1].corner[0].normal == 1);
    model_free(&model);
}

/* Each of a face's normals counts: one that points inside outweighs two that hardly point
 * outside. */
static void test_each_normal_counts(void) {
    for (unsigned inside = 1; inside <= 3; inside++) {
        char text[200];
        struct error error;
        snprintf(text, sizeof text,
                 "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 -1\nvn 0.99 0 0.14\nf 1//%u 2//%u 3//%u\n",
                 inside == 1 ? 1U : 2U, inside == 2 ? 1U : 2U, inside == 3 ? 1U : 2U);
        struct model model = decode(text);
        CHECK(model_add_other_sides(&model, true, &error) && model.face_count == 2);
        struct vec3 outside = model_face_normal(&model, 0);
        double sum = 0;
        for (size_t k = 0; k < 3; k++) {
            sum += vec3_dot(model_normal(&model, 0, k), outside);
        }
        CHECK(sum > 0); /* its side looks where most of them do */
        model_free(&model);
    }
}

/* Where three faces meet, none decides how another is wound, and a Moebius strip has one side: the
 * faces stay as they are. */
static void test_undecided(void) {
    static const char *const texts[] = {
        "v 0 0 0\nv 0 1 0\nv 1 0 0\nv -1 0 1\nv -1 0 -1\nf 1 2 3\nf 1 2 4\nf 1 2 5\n",
        "v 0 0 0\nv 0 1 0\nv 1 0 0\nv -1 0 1\nv -1 0 -1\n"
        "f 1 2 3\nf 3 2 4\nf 3 4 5\nf 5 4 1\nf 5 1 2\n",
    };
    for (size_t k = 0; k < 2; k++) {
        struct model model = decode(texts[k]), kept = decode(texts[k]);
        struct error error;
        CHECK(model_add_other_sides(&model, true, &error));
        for (size_t i = 0; i < 3 * kept.face_count; i++) {
            CHECK(
                same_corner(model.faces[i / 3 * 2].corner[i % 3], kept.faces[i / 3].corner[i % 3]));
        }
        model_free(&model);
        model_free(&kept);
    }
}

/* More faces than the least arrays have room for, which are small. */
static void test_many(void) {
    struct bytes text = {0};
    struct model model;
    struct error error;
    for (int i = 0; i < 42; i++) {
        CHECK(bytes_print(&text, "v %g %g 0\nvn 0 0 1\n", i / 1e3, i * i / 1e5));
    }
    CHECK(bytes_print(&text, "usemtl a\nf"));
    for (int i = 1; i <= 42; i++) {
        CHECK(bytes_print(&text, " %d//%d", i, i));
    }
    CHECK(model_decode(&model, text.data, text.size, &error));
    model.materials[0].color[0] = 0.5F;
    CHECK(model_need_colors(&model, &error) && model_add_other_sides(&model, true, &error));
    CHECK(model.face_count == 80 && model.normal_count == 84);
    for (size_t i = 0; i < 40; i++) {
        check_sides(&model, i);
    }
    for (size_t i = 0; i < 80; i++) {
        const float *color = model.face_colors[i];
        CHECK(color[0] == 0.5F && color[1] == 1 && model.face_materials[i] == 0);
    }
    model_free(&model);
    bytes_free(&text);
}

UNIT_MAIN(TEST(test_mixed_winding), TEST(test_kept), TEST(test_each_normal_counts),
          TEST(test_undecided), TEST(test_many))
