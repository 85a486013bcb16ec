/* The pipeline against independent answers: perspective, clipping, what is left out, and how.
 * (Which face shows at which pixel, and each pixel once: test_borders.c.) */
#define _XOPEN_SOURCE 700 /* place.h */
#include "oracle/oracle.h"
#include "unit/frames.h"
#include "unit/images.h"
#include "unit/place.h"

#include <time.h>

enum { SIZE = 32, FACES = 24, MESH_LIMIT = 3 * FACES };

/* ---- Small models ---- */

struct mesh {
    struct model model;
    struct vec3 positions[MESH_LIMIT];
    struct face faces[MESH_LIMIT];
};

static void mesh_begin(struct mesh *mesh) {
    mesh->model = plain_model(mesh->positions, 0, mesh->faces, 0, NULL);
}

static uint32_t mesh_vertex(struct mesh *mesh, double x, double y, double z) {
    mesh->positions[mesh->model.position_count] = (struct vec3){x, y, z};
    return (uint32_t)mesh->model.position_count++;
}

static void mesh_face(struct mesh *mesh, uint32_t a, uint32_t b, uint32_t c) {
    set_corners(&mesh->faces[mesh->model.face_count++], a, b, c);
}

/* Faces anywhere in the view, and a little beyond. */
static void make_soup(struct mesh *mesh, struct random *random) {
    mesh_begin(mesh);
    for (int i = 0; i < FACES; i++) {
        uint32_t v[3];
        for (int k = 0; k < 3; k++) {
            v[k] = mesh_vertex(mesh, random_real(random, -1.3, 1.3), random_real(random, -1.3, 1.3),
                               random_real(random, -1, 1));
        }
        mesh_face(mesh, v[0], v[1], v[2]);
    }
}

/* ---- Frames: a face shows its number, counted on from call to call ---- */

struct uniforms {
    const struct model *model;
    size_t first_face;
};

static void number_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct uniforms *u = uniforms;
    (void)corner;
    varyings[0] = (double)(u->first_face + face + 1);
}

static lanes_mask number_fragment(const void *uniforms, const lanes *varyings, lanes_texel *color) {
    (void)uniforms;
    *color = lanes_rgb(varyings[0], varyings[0], varyings[0]);
    return lanes_all_set();
}

SHADER(number_shader, .varying_count = 1, .vertex = number_vertex, .fragment = number_fragment);
SHADER(discarding_shader, .varying_count = 1, .vertex = number_vertex, .fragment = number_fragment,
       .discards = true);

/* Visible pixels only; skip off; a shader that may discard: the last two shade at once. */
enum { WAYS = 3 };

static struct target target;
static size_t faces_drawn; /* so far */

static bool frame_begin(int way) {
    faces_drawn = 0;
    bool done = target_create(&target, SIZE, SIZE, IMAGE_BGR);
    target.pipeline.skip = way != 1;
    target.pipeline.keep_depth = true;
    target.pipeline.counts_tests = true;
    return done;
}

static void frame_draw(const struct mesh *mesh, struct mat4 to_clip, const struct shader *shader) {
    struct error error;
    struct uniforms uniforms = {&mesh->model, faces_drawn};
    struct draw_call call = {
        .model = &mesh->model, .to_clip = to_clip, .viewport = {0, 0, SIZE, SIZE}};
    CHECK(pipeline_draw(&target.pipeline, &call, shader, &uniforms, sizeof uniforms, &error));
    faces_drawn += mesh->model.face_count;
}

static void frame_finish(void) {
    struct error error;
    CHECK(pipeline_finish(&target.pipeline, &target.image, &error));
}

/* How many pixels show that face, from 1; 0 asks for those without any. */
static size_t frame_count(size_t face) {
    size_t count = 0;
    for (int i = 0; i < SIZE * SIZE; i++) {
        count += image_get(&target.image, i % SIZE, i / SIZE).r == face;
    }
    return count;
}

/* Draw one frame of one model. Counts are there until the next one. */
static void draw_alone(const struct mesh *mesh, struct mat4 to_clip, const struct shader *shader,
                       int way) {
    if (frame_begin(way)) {
        frame_draw(mesh, to_clip, shader);
        frame_finish();
    }
}

/* Positions are x, y and w of clip space; z is 1, so that depth is 1/w. */
static const struct mat4 place_is_xyw = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, 1}, {0, 0, 1, 0}}};

/* Add a triangle that covers all of the view at one depth. */
static void add_cover(struct mesh *mesh, double w) {
    uint32_t first = mesh_vertex(mesh, -4 * w, -4 * w, w);
    mesh_vertex(mesh, 9 * w, -4 * w, w);
    mesh_vertex(mesh, -4 * w, 9 * w, w);
    mesh_face(mesh, first, first + 1, first + 2);
}

static void make_cover(struct mesh *mesh, double w) {
    mesh_begin(mesh);
    add_cover(mesh, w);
}

/* ---- What is outside ---- */

/* A face that passes a corner of the view, far off: no side has all of its corners beyond it, and
 * clipping leaves nothing of it. It counts as outside all the same. */
static void test_face_past_a_corner(void) {
    static struct mesh mesh;
    mesh_begin(&mesh);
    mesh_face(&mesh, mesh_vertex(&mesh, 0, 200, 0), mesh_vertex(&mesh, 200, 200, 0),
              mesh_vertex(&mesh, 200, 0, 0));
    draw_alone(&mesh, mat4_identity(), &number_shader, 0);
    CHECK(target.pipeline.stats[STAT_FACES_OUTSIDE] == 1);
    CHECK(target.pipeline.stats[STAT_FACES_CLIPPED] == 0);
    target_free(&target);
    for (int way = 0; way < 2; way++) { /* left of the view, beyond no other side */
        const struct mat4 left = {{{0.01, 0, 0, -4}, {0, 0.001, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
        draw_alone(&mesh, left, &number_shader, way);
        CHECK(target.pipeline.stats[STAT_FACES_OUTSIDE] == 1);
        CHECK(target.pipeline.stats[STAT_CALLS_OUTSIDE] == (way == 0));
        target_free(&target);
    }
}

/* Of an object so large that the corners of its box are no numbers nothing is known: what of it is
 * in view is drawn. */
static void test_object_too_large_to_judge(void) {
    static struct mesh mesh;
    enum { BESIDE = 12 };
    const struct mat4 to_clip = {
        {{1e300, 1e300, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 0}, {-1e300, 1e300, 0, 1}}};
    mesh_begin(&mesh);
    for (int i = 0; i < BESIDE; i++) {
        mesh_vertex(&mesh, -3e-300, -3e-300, 0); /* at x = -6, y = 0, w = 1 */
    }
    /* What is looked at first, every second position, is to the left of the view. */
    mesh.positions[1] = (struct vec3){1e10, 1e10, 0};
    mesh.positions[3] = (struct vec3){-1e10, -1e10, 0};
    mesh.positions[5] = (struct vec3){-4e-301, -4e-301, -0.8}; /* at x = -0.8 */
    mesh.positions[7] = (struct vec3){4e-301, 4e-301, -0.8};
    mesh.positions[9] = (struct vec3){4e-301, 4e-301, 0.8};
    mesh_face(&mesh, 5, 7, 9);
    draw_alone(&mesh, to_clip, &number_shader, 0);
    CHECK(target.pipeline.stats[STAT_CALLS_OUTSIDE] == 0);
    CHECK(frame_count(1) > 100);
    target_free(&target);
}

/* ---- Varyings ---- */

static void byte_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    (void)face, (void)corner;
    varyings[0] = *(const uint8_t *)uniforms;
}

SHADER(byte_shader, .varying_count = 1, .vertex = byte_vertex, .fragment = number_fragment);

/* Each draw call has its own uniforms, though they are a byte; or none, where nothing asks. */
static void test_uniforms_of_a_byte(void) {
    static struct mesh mesh;
    struct error error;
    make_cover(&mesh, 1);
    CHECK(frame_begin(0));
    for (uint8_t i = 0; i < 3; i++) {
        struct rectangle part = {16 * (i / 2), 0, 8 * i, SIZE};
        struct draw_call call = {&mesh.model, place_is_xyw, part, CULL_NONE};
        const void *own = i > 0 ? &i : NULL;
        CHECK(pipeline_draw(&target.pipeline, &call, &byte_shader, own, i > 0, &error));
    }
    frame_finish();
    CHECK(frame_count(1) == 8 * SIZE && frame_count(2) == 16 * SIZE);
    target_free(&target);
}

/* Of a place, what is smaller than a level. */
static void place_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct uniforms *u = uniforms;
    struct vec3 p = model_position(u->model, face, corner);
    varyings[0] = p.x;
    varyings[1] = p.y;
    varyings[2] = p.z;
}

static lanes_mask place_fragment(const void *uniforms, const lanes *varyings, lanes_texel *color) {
    lanes level[3];
    (void)uniforms;
    for (int i = 0; i < 3; i++) {
        lanes fine = varyings[i] * 4096;
        level[i] = (fine - lanes_floor(fine)) * 254 + 1;
    }
    *color = lanes_rgb(level[0], level[1], level[2]);
    return lanes_all_set();
}

SHADER(place_shader, .varying_count = 3, .vertex = place_vertex, .fragment = place_fragment);

/* ---- Clipping ---- */

/* Clip space has no unit: times 2^700 it is the same to the last bit, though no float holds 1/w. */
static void test_scale_of_clip_space(void) {
    static struct mesh mesh;
    struct random random = {19};
    for (int i = 0; i < 20; i++) {
        make_soup(&mesh, &random);
        struct mat4 to_clip = mat4_projection(2), larger = to_clip;
        for (int k = 0; k < 16; k++) {
            larger.m[k / 4][k % 4] *= 0x1p700;
        }
        draw_alone(&mesh, to_clip, &place_shader, 0);
        struct target seen = target;
        draw_alone(&mesh, larger, &place_shader, 0);
        CHECK(same_image(&seen.image, &target.image) && frame_count(0) < SIZE * SIZE);
        target_free(&seen);
        target_free(&target);
    }
}

/* Two faces share an edge that is cut at the near plane, in the middle between two steps of 1/256
 * pixel, where the last bit decides which of them it becomes. Pixel centres of a column lie on the
 * edge or 1/256 pixel off it: were the cut not the same from both ends, the whole column would
 * be drawn twice or not at all. */
static void test_cut_from_both_ends(void) {
    static struct mesh mesh;
    const double column = 10.5 * 2 / SIZE - 1, nearest_w = 1.0 / 128;
    for (int i = 0; i < 80; i++) {
        double half_step = (i % 2 ? 1 : -1) * 1.0 / (256 * SIZE), beyond = (i / 2 + 1) / 16.0;
        struct vec3 p = {column, -0.875, 1};
        struct vec3 cut = {(column + half_step) * nearest_w, 0.875 * nearest_w, nearest_w};
        struct vec3 q = vec3_add(cut, vec3_scale(vec3_sub(cut, p), beyond));
        mesh_begin(&mesh);
        mesh_vertex(&mesh, p.x, p.y, p.z);
        mesh_vertex(&mesh, q.x, q.y, q.z);
        mesh_vertex(&mesh, -0.9, 0, 1);
        mesh_vertex(&mesh, 0.9, 0, 1);
        mesh_face(&mesh, 0, 1, 2);
        mesh_face(&mesh, 1, 0, 3);
        draw_alone(&mesh, place_is_xyw, &number_shader, 0);
        for (int y = 4; y < 28; y++) {
            CHECK(image_get(&target.image, 10, y).r != 0);
        }
        CHECK(target.pipeline.stats[STAT_PIXELS_COVERED] == SIZE * SIZE - frame_count(0));
        CHECK(target.pipeline.stats[STAT_FACES_CLIPPED] == 2);
        target_free(&target);
    }
}

/* A face that is cut is the same to the last bit, whichever of its corners comes first; also where
 * corners differ only in x, in depth or in w. */
static void test_cut_from_any_corner(void) {
    static const double places[] = {-0.7, 0.4, 1.3};
    static struct mesh mesh;
    struct random random = {20};
    size_t cut = 0;
    for (int i = 0; i < 300; i++) {
        struct mat4 to_clip = place_is_xyw;
        struct target seen[3];
        double p[9];
        to_clip.m[2][2] = i % 3 - 1;
        for (int k = 0; k < 9; k++) {
            p[k] = places[random_bits(&random) % 3];
        }
        for (int k = 0; k < 3; k++) {
            mesh_begin(&mesh);
            for (int c = k; c < k + 3; c++) {
                mesh_vertex(&mesh, p[c % 3], p[3 + c % 3], p[6 + c % 3]);
            }
            mesh_face(&mesh, 0, 1, 2);
            draw_alone(&mesh, to_clip, &place_shader, 0);
            seen[k] = target;
        }
        CHECK(same_image(&seen[0].image, &seen[1].image) &&
              same_image(&seen[0].image, &seen[2].image));
        cut += target.pipeline.stats[STAT_FACES_CLIPPED] > 0 && frame_count(0) < SIZE * SIZE;
        for (int k = 0; k < 3; k++) {
            target_free(&seen[k]);
        }
    }
    CHECK(cut > 50);
}

/* Nothing nearer than w = 1/128 is drawn, and everything else is. */
static void test_nearest_w(void) {
    static struct mesh mesh;
    static const struct {
        double w;
        bool drawn;
    } rows[] = {{1.0 / 64, true},    {1.0 / 128, true}, {1.0 / 128 - 0x1p-30, false},
                {1.0 / 1000, false}, {1e-30, false},    {0, false},
                {-1, false}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        make_cover(&mesh, rows[i].w);
        for (int way = 0; way < WAYS; way++) {
            draw_alone(&mesh, place_is_xyw, way == 2 ? &discarding_shader : &number_shader, way);
            CHECK(frame_count(1) == (rows[i].drawn ? (size_t)SIZE * SIZE : 0));
            target_free(&target);
        }
    }
}

/* A face whose depth z/w is larger than all numbers, at a corner or where it is cut, is left out
 * there and hides nothing. */
static void test_depth_overflows(void) {
    static struct mesh mesh, cover;
    struct mat4 to_clip = place_is_xyw;
    /* z grows to the right; or it is large at the left, but no larger than is allowed. */
    static const double slopes[] = {1e308, 1e290, -1e280};
    for (int i = 0; i < 6 * WAYS; i++) {
        to_clip.m[2][0] = slopes[i / (2 * WAYS)];
        bool is_cut = i / WAYS % 2 == 1;
        mesh_begin(&mesh);
        mesh_vertex(&mesh, -0.9, -0.9, 1);
        mesh_vertex(&mesh, is_cut ? 0.8 : 0.0625, 0.05, is_cut ? -0.5 : 1.0 / 128);
        mesh_vertex(&mesh, -0.9, 0.9, 1);
        mesh_face(&mesh, 0, 1, 2);
        make_cover(&cover, 1);
        const struct shader *shader = i % WAYS == 2 ? &discarding_shader : &number_shader;
        if (frame_begin(i % WAYS)) {
            frame_draw(&mesh, to_clip, shader);
            frame_draw(&cover, place_is_xyw, shader);
            frame_finish();
            bool finite = true;
            for (int k = 0; k < SIZE * SIZE; k++) {
                finite = finite && isfinite(target.pipeline.depth[k]);
            }
            CHECK(finite && (is_cut || frame_count(2) == (size_t)SIZE * SIZE));
        }
        target_free(&target);
    }
}

/* ---- Limits and errors ---- */

static void test_grid_cell(void) {
    int total = 0;
    for (int cell = 0; cell < 12; cell++) {
        struct rectangle r = grid_cell(10, 7, 4, 3, cell);
        total += r.width * r.height;
    }
    CHECK(total == 70);
    struct rectangle top_left = grid_cell(10, 10, 2, 2, 0),
                     right_of_it = grid_cell(10, 10, 2, 2, 1);
    CHECK(top_left.x == 0 && top_left.y == 5 && top_left.width == 5 && top_left.height == 5);
    CHECK(right_of_it.x == 5 && right_of_it.y == 5);
}

/* Not a number and infinity anywhere: nothing may trap. */
static void test_not_finite(void) {
    static const double bad[] = {NAN, INFINITY, -INFINITY, 1e308, 1e-308, 0};
    static struct mesh mesh;
    struct random random = {15};
    make_soup(&mesh, &random);
    for (int i = 0; i < 16 * 6; i++) {
        struct mat4 to_clip = mat4_projection(2);
        to_clip.m[i / 6 / 4][i / 6 % 4] = bad[i % 6];
        draw_alone(&mesh, to_clip, &place_shader, i % 2);
        CHECK(target.pipeline.stats[STAT_FACES] == FACES);
        target_free(&target);
    }
}

/* Half of a texture of 64 texels over so many pixels: each level halves the texels, and the
 * level is the one at which a pixel has at most one and a half. */
static void test_wrapped_level(void) {
    struct error error;
    struct image image;
    struct texture texture;
    if (!CHECK(image_create(&image, 64, 2, IMAGE_GREY, &error)) ||
        !CHECK(texture_create(&texture, &image, &error))) {
        return;
    }
    CHECK(texture_wrapped_level(&texture, 1000) == 0);
    CHECK(texture_wrapped_level(&texture, 32) == 0 && texture_wrapped_level(&texture, 22) == 0);
    CHECK(texture_wrapped_level(&texture, 21) == 1 && texture_wrapped_level(&texture, 8) == 2);
    CHECK(texture_wrapped_level(&texture, 0) ==
          texture.level_count - 1); /* there is none smaller */
    CHECK(texture_wrapped_level(NULL, 1000) == 0);
    texture_free(&texture);
    image_free(&image);
}

/* Corners so far apart that the points where edges are cut are rounded by whole worlds: the
 * polygon is no longer convex, and gains more than one corner at a plane. Found by the stress
 * run. */
static void test_far_apart(void) {
    static struct mesh mesh;
    mesh_begin(&mesh);
    mesh_vertex(&mesh, 4928.8335F, 4.61168602e+18F, -0.854364634F);
    mesh_vertex(&mesh, 4194305, 0.897210062F, -0.363833278F);
    mesh_vertex(&mesh, -2.04636595e+09F, 0.767012835F, 0.909459114F);
    mesh_vertex(&mesh, 3.51105126e+09F, 2519.08057F, -6.03685957e+31F);
    mesh_face(&mesh, 0, 1, 2);
    mesh_face(&mesh, 0, 3, 1);
    mesh_face(&mesh, 1, 3, 2);
    mesh_face(&mesh, 2, 3, 0);
    struct draw_call call =
        camera_call(&mesh.model, (struct vec3){4, 915.93352021695864, 3.4198894997934702e-07},
                    (struct vec3){-0.21980669537238295, 0.14137829568848437, -0.59670343606009446},
                    (struct vec3){-2.2334146758896427, -0.8648555399337059, -0.22691162591673497},
                    1.0074003975707959, (struct rectangle){0, 0, SIZE, SIZE}, CULL_NONE);
    draw_alone(&mesh, call.to_clip, &place_shader, 0);
    CHECK(target.pipeline.stats[STAT_FACES] == 4 && target.pipeline.stats[STAT_FACES_CLIPPED] > 0);
    target_free(&target);
}

/* Threads end with their pipeline, soon. (Where none are listed, nothing is counted.) */
static void test_threads_end(void) {
    static struct mesh mesh;
    const struct place threads = {.directory = "/proc/self/task"};
    const struct timespec pause = {.tv_nsec = 1000000};
    size_t before = place_count(&threads);
    make_cover(&mesh, 1);
    if (frame_begin(0)) {
        pipeline_use_threads(&target.pipeline, 4);
        frame_draw(&mesh, place_is_xyw, &number_shader);
        frame_finish();
    }
    target_free(&target);
    for (int i = 0; i < 1000 && place_count(&threads) > before; i++) {
        nanosleep(&pause, NULL);
    }
    CHECK(place_count(&threads) <= before);
}

static void test_errors(void) {
    struct error error;
    struct pipeline pipeline;
    CHECK(!pipeline_create(&pipeline, 0, 10, &error));
    CHECK_TEXT(error.message, "cannot draw 0x10 pixels: a side has 1 to 16384");
    CHECK(!pipeline_create(&pipeline, 10, DRAW_LIMIT + 1, &error));
    CHECK(!pipeline_create(&pipeline, DRAW_LIMIT + 1, 10, &error));
    CHECK(!pipeline_create(&pipeline, 10, 0, &error));
    pipeline_free(&pipeline);
}

UNIT_MAIN(TEST(test_face_past_a_corner), TEST(test_object_too_large_to_judge),
          TEST(test_uniforms_of_a_byte), TEST(test_cut_from_any_corner),
          TEST(test_cut_from_both_ends), TEST(test_nearest_w), TEST(test_depth_overflows),
          TEST(test_scale_of_clip_space), TEST(test_grid_cell), TEST(test_not_finite),
          TEST(test_wrapped_level), TEST(test_far_apart), TEST(test_threads_end), TEST(test_errors))
