/* The pipeline: equal depths, within a draw call and between two, visible only and all at once. */
#include "unit/frames.h"
#include "unit/ties.h"

enum { TRIANGLE_LIMIT = 2 };

static void level_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct level_triangle *triangles = *(const struct level_triangle *const *)uniforms;
    (void)corner;
    varyings[0] = triangles[face].level;
}

static lanes_mask level_fragment(const void *uniforms, const lanes *varyings, lanes_texel *color) {
    (void)uniforms;
    *color = lanes_rgb(varyings[0], varyings[0], varyings[0]);
    return lanes_all_set();
}

SHADER(level_shader, .varying_count = 1, .vertex = level_vertex, .fragment = level_fragment);
SHADER(discarding_shader, .varying_count = 1, .vertex = level_vertex, .fragment = level_fragment,
       .discards = true);

/* What a draw call draws, kept until the frame is finished. */
struct level_model {
    struct vec3 positions[3 * TRIANGLE_LIMIT];
    struct face faces[TRIANGLE_LIMIT];
    struct model model;
};

/* Draw the triangles in one call. At w = 2 the place in NDC, and the depth, are half of the
 * coordinates. */
static void draw_levels_at(struct pipeline *pipeline, struct level_model *m,
                           const struct shader *shader, const struct level_triangle *triangles,
                           size_t count) {
    m->model = plain_model(m->positions, 3 * count, m->faces, count, NULL);
    struct draw_call call = {.model = &m->model,
                             .to_clip = mat4_identity(),
                             .viewport = {0, 0, TIES_SIDE, TIES_SIDE},
                             .cull = CULL_NONE};
    struct error error;
    call.to_clip.m[3][3] = 2;
    for (uint32_t i = 0; i < 3 * count; i++) {
        const struct level_triangle *t = &triangles[i / 3];
        struct fixed2 p = t->corner[i % 3];
        m->positions[i] = (struct vec3){2 * (p.x / (128.0 * TIES_SIDE) - 1),
                                        2 * (p.y / (128.0 * TIES_SIDE) - 1), 2 * t->depth};
    }
    CHECK(pipeline_draw(pipeline, &call, shader, &triangles, sizeof(void *), &error));
}

/* Call i has shader i, where there are several calls. */
static void draw(struct image *image, const struct level_triangle *triangles, size_t count,
                 bool skip, bool one_by_one, const struct shader *const shaders[2]) {
    struct level_model models[TRIANGLE_LIMIT];
    struct pipeline pipeline;
    struct error error;
    image_clear(image, color_grey(0));
    if (!CHECK(pipeline_create(&pipeline, TIES_SIDE, TIES_SIDE, &error))) {
        return;
    }
    pipeline.skip = skip;
    size_t step = one_by_one ? 1 : count;
    for (size_t i = 0; i < count; i += step) {
        draw_levels_at(&pipeline, &models[i], shaders[i], &triangles[i], step);
    }
    CHECK(pipeline_finish(&pipeline, image, &error));
    pipeline_free(&pipeline);
}

static const struct shader *const both_visible[2] = {&level_shader, &level_shader};

static const struct shader *const discarding_first[2] = {&discarding_shader, &level_shader};
static const struct shader *const discarding_last[2] = {&level_shader, &discarding_shader};

static void draw_visible(struct image *image, const struct level_triangle *triangles,
                         size_t count) {
    draw(image, triangles, count, true, false, both_visible);
}

static void draw_at_once(struct image *image, const struct level_triangle *triangles,
                         size_t count) {
    draw(image, triangles, count, false, false, both_visible);
}

static void draw_two_calls(struct image *image, const struct level_triangle *triangles,
                           size_t count) {
    draw(image, triangles, count, true, true, both_visible);
}

/* The depths of a shader that may discard are found elsewhere than those of one that may not. */
static void draw_discarding_first(struct image *image, const struct level_triangle *triangles,
                                  size_t count) {
    draw(image, triangles, count, true, true, discarding_first);
}

static void draw_discarding_last(struct image *image, const struct level_triangle *triangles,
                                 size_t count) {
    draw(image, triangles, count, true, true, discarding_last);
}

/* Depths whose differences overflow: what is not finite must not get into the depth buffer. */
static void test_huge_depths(void) {
    static const struct level_triangle triangle = {
        .corner = {{-999, -999}, {19999, 0}, {0, 19999}}};
    struct vec3 positions[3] = {{-1, -1, -1.7}, {3, -1, 1.7}, {-1, 3, 1.7}};
    struct face face;
    struct model model = plain_model(positions, 3, &face, 1, NULL);
    for (int exponent = 0; exponent < 1024; exponent++) {
        struct draw_call call = {.model = &model,
                                 .to_clip = mat4_scaling((struct vec3){1, 1, ldexp(1, exponent)}),
                                 .viewport = {0, 0, TIES_SIDE, TIES_SIDE}};
        const struct level_triangle *uniforms = &triangle;
        struct target target;
        struct error error;
        size_t drawn = 0, wrong = 0;
        CHECK(target_create(&target, TIES_SIDE, TIES_SIDE, IMAGE_BGR));
        target.pipeline.keep_depth = true;
        CHECK(draw_frame(&target.pipeline, &call, &level_shader, &uniforms, sizeof(void *),
                         &target.image, &error));
        for (size_t i = 0; i < (size_t)TIES_SIDE * TIES_SIDE; i++) {
            drawn += target.pipeline.depth[i] > -INFINITY;
            wrong += !isfinite(target.pipeline.depth[i]) && target.pipeline.depth[i] != -INFINITY;
        }
        CHECK(wrong == 0 && drawn == (exponent < 930 ? (size_t)TIES_SIDE * TIES_SIDE : 0));
        target_free(&target);
    }
}

static void test_visible(void) {
    check_ties(draw_visible);
}

static void test_at_once(void) {
    check_ties(draw_at_once);
}

static void test_two_calls(void) {
    check_ties(draw_two_calls);
    check_ties(draw_discarding_first);
    check_ties(draw_discarding_last);
}

UNIT_MAIN(TEST(test_huge_depths), TEST(test_visible), TEST(test_at_once), TEST(test_two_calls))
