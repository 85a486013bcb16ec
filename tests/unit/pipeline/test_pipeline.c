/* The pipeline against independent answers: perspective, clipping, what is left out, and how.
 * (Which face shows at which pixel, and each pixel once: test_borders.c.) */
#include "base/workers.h"
#include "oracle/oracle.h"
#include "unit/frames.h"

#include <stdlib.h>

enum { SIZE = 32, FACES = 24, MESH_LIMIT = 15000 };

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
    size_t first_face, varying_count;
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
    return done;
}

static void frame_draw(const struct mesh *mesh, struct mat4 to_clip, const struct shader *shader) {
    struct error error;
    struct uniforms uniforms = {&mesh->model, faces_drawn, shader->varying_count};
    struct draw_call call = {
        .model = &mesh->model, .to_clip = to_clip, .viewport = {0, 0, SIZE, SIZE}};
    CHECK(pipeline_draw(&target.pipeline, &call, shader, &uniforms, sizeof uniforms, &error));
    faces_drawn += mesh->model.face_count;
}

static void frame_finish(void) {
    struct error error;
    CHECK(pipeline_finish(&target.pipeline, &target.image, &error));
}

/* The next frame of the same pipeline, on a black image. */
static void frame_next(void) {
    pipeline_clear(&target.pipeline);
    image_clear(&target.image, color_grey(0));
    faces_drawn = 0;
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
}

/* Objects are left out when all of their positions are beyond one side: not when most of them are,
 * and not because another object was, or the same one in another frame. */
static void test_object_partly_in_view(void) {
    static struct mesh mesh, outside;
    enum { POSITIONS = 80 };
    mesh_begin(&outside);
    for (int i = 0; i < POSITIONS; i++) {
        mesh_vertex(&outside, -4 + 0.01 * i, 0.3 * (i % 3), 0);
    }
    mesh_face(&outside, 0, 1, 2);
    for (uint32_t first = 0; frame_begin(0) && first + 2 < POSITIONS; first++) {
        mesh_begin(&mesh);
        memcpy(mesh.positions, outside.positions, POSITIONS * sizeof mesh.positions[0]);
        mesh.model.position_count = POSITIONS;
        mesh_face(&mesh, first, first + 1, first + 2);
        frame_draw(&outside, mat4_identity(), &number_shader);
        frame_draw(&mesh, mat4_identity(), &number_shader);
        frame_finish();
        CHECK(frame_count(0) == (size_t)SIZE * SIZE);
        for (uint32_t i = 0; i < 3; i++) {
            mesh.positions[first + i] = (struct vec3){i == 1 ? 0.5 : -0.5, i == 2 ? 0.5 : -0.5, 0};
        }
        frame_next();
        frame_draw(&mesh, mat4_identity(), &number_shader);
        frame_finish();
        CHECK(frame_count(1) > 50);
        frame_next();
        frame_draw(&outside, mat4_identity(), &number_shader);
        frame_draw(&mesh, mat4_identity(), &number_shader);
        frame_finish();
        CHECK(frame_count(2) > 50);
        CHECK(target.pipeline.stats[STAT_FACES_OUTSIDE] == 1);
        target_free(&target);
    }
    target_free(&target);
}

/* A model without positions has no box: it is beyond no side, and nothing of it is seen; nor does
 * it disturb others, which are held against each other by their boxes. */
static void test_object_without_positions(void) {
    static struct mesh mesh, seen;
    draw_alone(&mesh, mat4_identity(), &number_shader, 0);
    CHECK(frame_count(0) == (size_t)SIZE * SIZE);
    CHECK(target.pipeline.stats[STAT_CALLS] == 1);
    CHECK(target.pipeline.stats[STAT_CALLS_OUTSIDE] == 0);
    make_cover(&seen, 1);
    frame_next();
    for (int i = 0; i < 20; i++) {
        frame_draw(i % 2 == 0 ? &mesh : &seen, place_is_xyw, &number_shader);
    }
    frame_finish();
    CHECK(frame_count(1) == (size_t)SIZE * SIZE);
    target_free(&target);
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

/* Varying k is k + 1 times varying 0, and k more: at corners and so everywhere. */
static void many_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct uniforms *u = uniforms;
    struct vec3 p = model_position(u->model, face, corner);
    for (size_t k = 0; k < u->varying_count; k++) {
        varyings[k] = ((double)k + 1) * (p.x + 2 * p.y) + (double)k;
    }
}

static lanes_mask many_fragment(const void *uniforms, const lanes *varyings, lanes_texel *color) {
    const struct uniforms *u = uniforms;
    lanes off = lanes_all(0);
    for (size_t k = 0; k < u->varying_count; k++) {
        lanes difference = varyings[k] - (((real)k + 1) * varyings[0] + (real)k);
        off = lanes_max(off, lanes_max(difference, -difference));
    }
    lanes level = lanes_select(off < 0.01f, lanes_all(200), lanes_all(100));
    *color = lanes_rgb(level, level, level);
    return lanes_all_set();
}

static void test_each_number_of_varyings(void) {
    static struct mesh mesh;
    struct random random = {41};
    make_soup(&mesh, &random);
    for (size_t n = 1; n <= VARYING_LIMIT; n++) {
        const struct shader shader = {
            .varying_count = n, .vertex = many_vertex, .fragment = many_fragment};
        draw_alone(&mesh, place_is_xyw, &shader, 0);
        CHECK(frame_count(200) > 100);
        CHECK(frame_count(200) + frame_count(0) == SIZE * SIZE);
        target_free(&target);
    }
}

/* What is prepared is so once, whichever way the pixels are shaded. */
static void add_five(const void *uniforms, lanes *varyings) {
    (void)uniforms;
    varyings[1] = 2 * varyings[0];
    varyings[0] += 5;
}

static lanes_mask prepared_fragment(const void *uniforms, const lanes *varyings,
                                    lanes_texel *color) {
    (void)uniforms;
    *color = lanes_rgb(varyings[0], varyings[1], lanes_all(7));
    return lanes_all_set();
}

SHADER(prepared, .varying_count = 1, .vertex = number_vertex, .prepare = add_five,
       .fragment = prepared_fragment);
SHADER(prepared_flat, .varying_count = 1, .flat = true, .vertex = number_vertex,
       .prepare = add_five, .fragment = prepared_fragment);
SHADER(prepared_discarding, .varying_count = 1, .vertex = number_vertex, .prepare = add_five,
       .fragment = prepared_fragment, .discards = true);

static void test_prepared(void) {
    static struct mesh mesh;
    static const struct shader *const shaders[] = {&prepared, &prepared_flat, &prepared_discarding};
    make_cover(&mesh, 1);
    for (int i = 0; i < 6; i++) {
        size_t wrong = 0;
        draw_alone(&mesh, place_is_xyw, shaders[i / 2], i % 2);
        for (int pixel = 0; pixel < SIZE * SIZE; pixel++) {
            struct color c = image_get(&target.image, pixel % SIZE, pixel / SIZE);
            wrong += c.r != 6 || c.g != 2 || c.b != 7;
        }
        CHECK(wrong == 0);
        target_free(&target);
    }
}

/* The first face has holes everywhere. */
static lanes_mask hole_fragment(const void *uniforms, const lanes *varyings, lanes_texel *color) {
    return number_fragment(uniforms, varyings, color) & (varyings[0] > 1.5f);
}

SHADER(hole_shader, .varying_count = 1, .vertex = number_vertex, .fragment = hole_fragment,
       .discards = true);

/* A discarded pixel hides nothing, although it was the nearest. */
static void test_discarded_hides_nothing(void) {
    static struct mesh mesh;
    make_cover(&mesh, 1);
    add_cover(&mesh, 2);
    draw_alone(&mesh, place_is_xyw, &hole_shader, 0);
    CHECK(frame_count(2) == (size_t)SIZE * SIZE);
    target_free(&target);
}

/* ---- Perspective ---- */

static void place_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct uniforms *u = uniforms;
    struct vec3 p = model_position(u->model, face, corner);
    varyings[0] = p.x;
    varyings[1] = p.y;
    varyings[2] = p.z;
}

/* The place that shows at each pixel, and whether one does. */
struct seen {
    struct vec3 place[SIZE][SIZE];
    bool drawn[SIZE][SIZE];
    size_t count; /* pixels that are drawn */
};

struct seen_uniforms {
    struct uniforms base; /* first: place_vertex reads it */
    size_t varying, part; /* that is shown; the fourth varying is 1 everywhere */
};

static lanes_mask see_fragment(const void *uniforms, const lanes *varyings, lanes_texel *color) {
    const struct seen_uniforms *u = uniforms;
    *color = show_part(u->varying < 3 ? varyings[u->varying] : lanes_all(1), u->part);
    return lanes_all_set();
}

SHADER(see_shader, .varying_count = 3, .vertex = place_vertex, .fragment = see_fragment);

/* One varying at every pixel. */
static void see_varying(struct pipeline *pipeline, const struct draw_call *call, size_t varying,
                        double values[SIZE * SIZE]) {
    struct image parts[REAL_PARTS] = {{0}};
    struct error error;
    for (size_t part = 0; part < REAL_PARTS; part++) {
        struct seen_uniforms uniforms = {{.model = call->model}, varying, part};
        CHECK(image_create(&parts[part], SIZE, SIZE, IMAGE_BGRA, &error));
        CHECK(draw_frame(pipeline, call, &see_shader, &uniforms, sizeof uniforms, &parts[part],
                         &error));
    }
    for (size_t i = 0; i < SIZE * SIZE; i++) {
        values[i] = shown_real(parts, i);
    }
    for (size_t part = 0; part < REAL_PARTS; part++) {
        image_free(&parts[part]);
    }
}

static void see(const struct mesh *mesh, struct mat4 to_clip, struct seen *seen,
                uint64_t stats[PIPELINE_STATS]) {
    static double values[4][SIZE * SIZE];
    struct error error;
    struct pipeline pipeline;
    struct draw_call call = {
        .model = &mesh->model, .to_clip = to_clip, .viewport = {0, 0, SIZE, SIZE}};
    *seen = (struct seen){.count = 0};
    if (!CHECK(pipeline_create(&pipeline, SIZE, SIZE, &error))) {
        return;
    }
    pipeline_use_threads(&pipeline, 1); /* too many small frames to start threads for each */
    pipeline.counts_tests = true;
    for (size_t i = 0; i < 4; i++) {
        see_varying(&pipeline, &call, i, values[i]);
    }
    memcpy(stats, pipeline.stats, sizeof pipeline.stats);
    pipeline_free(&pipeline);
    for (size_t i = 0; i < SIZE * SIZE; i++) {
        seen->place[i / SIZE][i % SIZE] = (struct vec3){values[0][i], values[1][i], values[2][i]};
        seen->drawn[i / SIZE][i % SIZE] = values[3][i] == 1;
        seen->count += values[3][i] == 1;
    }
}

/* A plane of 2 * n * n triangles at y = -0.4, from far before the camera to far behind it. */
static void make_ground(struct mesh *mesh, int n, double half, struct random *random) {
    mesh_begin(mesh);
    for (int i = 0; i <= n; i++) {
        for (int k = 0; k <= n; k++) {
            bool inner = i > 0 && i < n && k > 0 && k < n;
            double shift = inner ? random_real(random, -0.2, 0.2) : 0; /* more would fold */
            mesh_vertex(mesh, half * (2 * (i + shift) / n - 1), -0.4,
                        half * (2 * (k - shift) / n - 1));
        }
    }
    for (int i = 0; i < n; i++) {
        for (int k = 0; k < n; k++) {
            uint32_t a = (uint32_t)(i * (n + 1) + k), b = a + 1, c = a + (uint32_t)n + 1, d = c + 1;
            if (random_bits(random) % 2 == 0) {
                mesh_face(mesh, a, b, d);
                mesh_face(mesh, a, d, c);
            } else {
                mesh_face(mesh, a, b, c);
                mesh_face(mesh, c, b, d);
            }
        }
    }
}

/* The camera stands on the ground: half of the mesh is behind it, and much of it crosses the near
 * plane or leaves the guard band. Every pixel below the horizon must be drawn exactly once. */
static void test_ground_without_gaps(void) {
    static struct mesh mesh;
    static struct seen seen;
    struct random random = {13};
    static const double halves[] = {4, 40, 1000, 1e6};
    uint64_t clipped = 0;
    for (int i = 0; i < 108; i++) {
        make_ground(&mesh, 1 + i % 27, halves[i % 4], &random);
        struct mat4 to_clip = mat4_projection(2);
        uint64_t stats[PIPELINE_STATS] = {0};
        see(&mesh, to_clip, &seen, stats);
        clipped += stats[STAT_FACES_CLIPPED];
        CHECK(stats[STAT_PIXELS_COVERED] == seen.count); /* or one is drawn twice */
        for (int y = 0; y < SIZE; y++) {
            for (int x = 0; x < SIZE; x++) {
                /* w = 1 - z/2 where the ray through the pixel meets the ground. */
                double ndc_y = (y + 0.5) * 2 / SIZE - 1, ndc_x = (x + 0.5) * 2 / SIZE - 1;
                double w = -0.4 / ndc_y, z = 2 * (1 - w);
                bool hit = ndc_y < 0 && fabs(z) < halves[i % 4] && fabs(ndc_x * w) < halves[i % 4];
                bool edge =
                    fabs(fabs(z) - halves[i % 4]) < 1 || fabs(fabs(ndc_x * w) - halves[i % 4]) < 1;
                if (!edge && seen.drawn[y][x] != hit) {
                    fprintf(stderr, "ground %d: pixel %d %d drawn: %d\n", i, x, y,
                            seen.drawn[y][x]);
                    CHECK(seen.drawn[y][x] == hit);
                    return;
                }
                /* Snapping moves a corner by up to 1/512 pixel, 1/8192 of NDC; on the ground
                 * that is w * w / 0.4 times as much in w, and twice that in z: 0.0006 w * w. */
                if (hit && !edge && halves[i % 4] < 100) {
                    CHECK(fabs(seen.place[y][x].z - z) < 0.002 * w * w);
                    CHECK(fabs(seen.place[y][x].x - ndc_x * w) < 0.002 * w * w);
                }
            }
        }
    }
    CHECK(clipped > 200); /* or the test would say little */
}

/* Faces that reach behind the eye, in one half of the view: at its right, or at its left. */
static void add_clipped_faces(struct mesh *mesh, size_t count, double side, struct random *random) {
    for (size_t i = 0; i < count; i++) {
        uint32_t corner[3];
        for (int k = 0; k < 3; k++) {
            corner[k] =
                mesh_vertex(mesh, side * random_real(random, 0.05, 2), random_real(random, -2, 2),
                            k == 0 ? random_real(random, -1, -0.1) : random_real(random, 0.3, 2));
        }
        mesh_face(mesh, corner[0], corner[1], corner[2]);
    }
}

/* What a face is cut into is its own, also in a later block of faces: those at the right look the
 * same when thousands of others come before them. */
static void test_clipped_in_every_block(void) {
    enum { BEFORE = 4500, FACES_SEEN = 40 };
    static struct mesh few, many;
    static struct seen seen, seen_among;
    struct random random = {18};
    uint64_t stats[PIPELINE_STATS] = {0};
    mesh_begin(&few);
    add_clipped_faces(&few, FACES_SEEN, 1, &random);
    struct random again = {18};
    mesh_begin(&many);
    add_clipped_faces(&many, BEFORE, -1, &random);
    add_clipped_faces(&many, FACES_SEEN, 1, &again);
    see(&few, place_is_xyw, &seen, stats);
    CHECK(stats[STAT_FACES_CLIPPED] > FACES_SEEN / 2 && seen.count > 100);
    see(&many, place_is_xyw, &seen_among, stats);
    CHECK(stats[STAT_FACES_CLIPPED] > BEFORE / 2);
    for (int y = 0; y < SIZE; y++) {
        CHECK(memcmp(&seen.place[y][SIZE / 2], &seen_among.place[y][SIZE / 2],
                     SIZE / 2 * sizeof seen.place[0][0]) == 0);
    }
}

/* Clip space has no unit: times 2^140 it is the same to the last bit, though no float holds 1/w. */
static void test_scale_of_clip_space(void) {
    static struct mesh mesh;
    static struct seen seen, scaled;
    struct random random = {19};
    uint64_t stats[PIPELINE_STATS] = {0};
    for (int i = 0; i < 20; i++) {
        mesh_begin(&mesh);
        for (int k = 0; k < 12; k++) {
            mesh_vertex(&mesh, random_real(&random, -1, 1), random_real(&random, -1, 1),
                        random_real(&random, -3, 1.5));
        }
        for (uint32_t k = 0; k < 12; k += 3) {
            mesh_face(&mesh, k, k + 1, k + 2);
        }
        struct mat4 to_clip = mat4_projection(2), larger = to_clip;
        for (int k = 0; k < 16; k++) {
            larger.m[k / 4][k % 4] *= 0x1p140;
        }
        see(&mesh, to_clip, &seen, stats);
        see(&mesh, larger, &scaled, stats);
        CHECK(seen.count > 0 && memcmp(&seen, &scaled, sizeof seen) == 0);
    }
}

/* A triangle from near to far that reaches over both halves of the view. */
static void make_slope(struct mesh *mesh, double near, double far) {
    mesh_begin(mesh);
    mesh_vertex(mesh, -3, -3, near);
    mesh_vertex(mesh, 3, -3, far);
    mesh_vertex(mesh, 0, 3, far);
    mesh_face(mesh, 0, 1, 2);
}

/* Record it in the left half of the view, 0, or in the right one, 1. */
static void record_slope(struct pipeline *pipeline, const struct mesh *mesh, int half) {
    struct draw_call call = {.model = &mesh->model,
                             .to_clip = mat4_projection(2),
                             .viewport = {half * SIZE / 2, 0, SIZE / 2, SIZE}};
    struct seen_uniforms uniforms = {{.model = call.model}, 2, 0};
    struct error error;
    CHECK(pipeline_draw(pipeline, &call, &see_shader, &uniforms, sizeof uniforms, &error));
}

/* Two calls in one frame, side by side, and in a frame of its own each: the same image, though the
 * corners lie at other distances from the eye. */
static void test_each_call_has_its_perspective(void) {
    static struct mesh mesh[2];
    struct pipeline pipeline;
    struct error error;
    struct image together, alone;
    make_slope(&mesh[0], 1.5, -1);
    make_slope(&mesh[1], -6, 1);
    CHECK(pipeline_create(&pipeline, SIZE, SIZE, &error));
    CHECK(image_create(&together, SIZE, SIZE, IMAGE_BGRA, &error));
    CHECK(image_create(&alone, SIZE, SIZE, IMAGE_BGRA, &error));
    for (int half = 0; half < 2; half++) {
        pipeline_clear(&pipeline);
        record_slope(&pipeline, &mesh[half], half);
        CHECK(pipeline_finish(&pipeline, &alone, &error));
        CHECK(pipeline.stats[STAT_PIXELS_SHADED] > SIZE * SIZE / 8);
    }
    pipeline_clear(&pipeline);
    record_slope(&pipeline, &mesh[0], 0);
    record_slope(&pipeline, &mesh[1], 1);
    CHECK(pipeline_finish(&pipeline, &together, &error));
    CHECK(memcmp(together.pixels, alone.pixels, (size_t)SIZE * SIZE * IMAGE_BGRA) == 0);
    pipeline_free(&pipeline);
    image_free(&together);
    image_free(&alone);
}

/* ---- The same from another first corner, to the last bit ---- */

static void turn_corners(struct mesh *mesh) {
    for (size_t i = 0; i < mesh->model.face_count; i++) {
        struct corner *c = mesh->faces[i].corner, first = c[0];
        c[0] = c[1];
        c[1] = c[2];
        c[2] = first;
    }
}

static void test_corner_order(void) {
    static struct mesh mesh;
    static struct seen seen, seen_turned;
    struct random random = {12};
    uint64_t stats[PIPELINE_STATS] = {0};
    for (int i = 0; i < 20; i++) {
        make_ground(&mesh, 3 + i, 4, &random);
        see(&mesh, mat4_projection(2.5), &seen, stats);
        turn_corners(&mesh);
        see(&mesh, mat4_projection(2.5), &seen_turned, stats);
        CHECK(memcmp(seen.place, seen_turned.place, sizeof seen.place) == 0);
    }
    for (int i = 0; i < 20; i++) { /* of two corners that are lowest the one at the left is first */
        double low = random_real(&random, -1, -0.5), z = random_real(&random, -1, 1);
        mesh_begin(&mesh);
        mesh_vertex(&mesh, random_real(&random, -1, 0), low, z);
        mesh_vertex(&mesh, random_real(&random, 0, 1), low, z);
        mesh_vertex(&mesh, random_real(&random, -1, 1), random_real(&random, 0, 1), -z);
        mesh_face(&mesh, 0, 1, 2);
        see(&mesh, mat4_projection(2.5), &seen, stats);
        for (int turn = 0; turn < 2; turn++) {
            turn_corners(&mesh);
            see(&mesh, mat4_projection(2.5), &seen_turned, stats);
            CHECK(memcmp(seen.place, seen_turned.place, sizeof seen.place) == 0);
        }
    }
}

/* Perspective interpolation at each pixel, in long double, from the same snapped corners. */
static void test_interpolation(void) {
    static struct mesh mesh;
    static struct seen seen;
    struct random random = {14};
    double worst = 0, mean = 0;
    for (int i = 0; i < 300; i++) {
        struct fixed2 corner[3] = {{0, 0}};
        double recip_w[3], value[3];
        mesh_begin(&mesh);
        struct mat4 to_clip = mat4_projection(2);
        for (int k = 0; k < 3; k++) {
            mesh_vertex(&mesh, random_real(&random, -1, 1), random_real(&random, -1, 1),
                        random_real(&random, -3, 1.5));
            struct vec4 clip = mat4_point(&to_clip, mesh.positions[k]);
            recip_w[k] = 1 / clip.w;
            value[k] = mesh.positions[k].z;
            CHECK(screen_snap((struct vec2){(clip.x * recip_w[k] + 1) * (SIZE / 2.0),
                                            (clip.y * recip_w[k] + 1) * (SIZE / 2.0)},
                              &corner[k]));
        }
        mesh_face(&mesh, 0, 1, 2);
        uint64_t stats[PIPELINE_STATS] = {0};
        see(&mesh, to_clip, &seen, stats);
        for (int y = 0; y < SIZE; y++) {
            for (int x = 0; x < SIZE; x++) {
                bool covered = oracle_covers(corner[0], corner[1], corner[2], x, y);
                CHECK(seen.drawn[y][x] == covered);
                if (!covered) {
                    continue;
                }
                long double exact = oracle_interpolate(corner, recip_w, value, x, y);
                long double scale = oracle_rounding_scale(corner, recip_w, value, x, y);
                double error = (double)fabsl((long double)seen.place[y][x].z - exact);
                worst = fmax(worst, error / (double)scale);
                mean += error / (300.0 * SIZE * SIZE);
            }
        }
    }
    /* Some roundings of what is added up. Seldom is that much more than the value. */
    double ulp = sizeof(real) == sizeof(float) ? 0x1p-24 : 0x1p-53;
    CHECK(worst < 8 * ulp && mean < 4 * ulp);
}

/* ---- Near the eye ---- */

/* Two faces share an edge that is cut at the near plane, in the middle between two steps of 1/256
 * pixel, where the last bit decides which of them it becomes. Pixel centres of a column lie on the
 * edge or 1/256 pixel beside it: were the cut not the same from both ends, the whole column would
 * be drawn twice or not at all. */
static void test_cut_from_both_ends(void) {
    static struct mesh mesh;
    static struct seen seen;
    const double column = 10.5 * 2 / SIZE - 1, nearest_w = 1.0 / 128;
    for (int i = 0; i < 80; i++) {
        double half_step = (i % 2 ? 1 : -1) * 1.0 / (256 * SIZE), beyond = (i / 2 + 1) / 16.0;
        struct vec3 p = {column, -0.875, 1};
        struct vec3 cut = {(column + half_step) * nearest_w, 0.875 * nearest_w, nearest_w};
        struct vec3 q = vec3_add(cut, vec3_scale(vec3_sub(cut, p), beyond));
        uint64_t stats[PIPELINE_STATS] = {0};
        mesh_begin(&mesh);
        mesh_vertex(&mesh, p.x, p.y, p.z);
        mesh_vertex(&mesh, q.x, q.y, q.z);
        mesh_vertex(&mesh, -0.9, 0, 1);
        mesh_vertex(&mesh, 0.9, 0, 1);
        mesh_face(&mesh, 0, 1, 2);
        mesh_face(&mesh, 1, 0, 3);
        see(&mesh, place_is_xyw, &seen, stats);
        bool once = true;
        for (int y = 4; y < 28; y++) {
            once = once && seen.drawn[y][10];
        }
        CHECK(once && stats[STAT_PIXELS_COVERED] == seen.count && stats[STAT_FACES_CLIPPED] == 2);
    }
}

/* Nothing nearer than w = 1/128 is drawn, and all that is not nearer. */
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
    double nearest = 0; /* 1/w; of a face that goes through the near plane, next to the eye */
    mesh_begin(&mesh);
    mesh_face(&mesh, mesh_vertex(&mesh, -1, 0.5, 1), mesh_vertex(&mesh, 1, 0.5, 1),
              mesh_vertex(&mesh, 0, -0.498, -1));
    draw_alone(&mesh, place_is_xyw, &number_shader, 0);
    for (int i = 0; i < SIZE * SIZE; i++) {
        nearest = fmax(nearest, target.pipeline.depth[i]);
    }
    CHECK(nearest > 90 && nearest <= 128 + 1e-9);
    target_free(&target);
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
    for (int row = 0; row < 3; row++) {
        for (int column = 0; column < 4; column++) {
            struct rectangle r = grid_cell(10, 7, 4, 3, column, row);
            total += r.width * r.height;
        }
    }
    CHECK(total == 70);
    struct rectangle top_left = grid_cell(10, 10, 2, 2, 0, 0);
    CHECK(top_left.x == 0 && top_left.y == 5 && top_left.width == 5 && top_left.height == 5);
}

/* Not a number and infinity anywhere: nothing wrong may be drawn, and nothing may trap. */
static void test_not_finite(void) {
    static struct mesh mesh;
    static struct seen seen;
    struct random random = {15};
    make_soup(&mesh, &random);
    static const double bad[] = {NAN, INFINITY, -INFINITY, 1e308, 1e-308, 0};
    for (int i = 0; i < 16 * 6; i++) {
        struct mat4 to_clip = mat4_projection(2);
        to_clip.m[i / 6 / 4][i / 6 % 4] = bad[i % 6];
        uint64_t stats[PIPELINE_STATS] = {0};
        see(&mesh, to_clip, &seen, stats);
        for (int k = 0; k < SIZE * SIZE; k++) {
            struct vec3 p = seen.place[k / SIZE][k % SIZE];
            if (!isfinite(p.x) || !isfinite(p.y) || !isfinite(p.z)) {
                CHECK(isfinite(p.x) && isfinite(p.y) && isfinite(p.z));
                return;
            }
        }
        CHECK(stats[STAT_FACES] == FACES);
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
    static struct seen seen;
    uint64_t stats[PIPELINE_STATS] = {0};
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
    see(&mesh, call.to_clip, &seen, stats);
    CHECK(stats[STAT_FACES] == 4 && stats[STAT_FACES_CLIPPED] > 0);
}

/* Drawing allocates nothing once all is large enough: the same frame again takes no more room. */
static void test_frames_keep_their_memory(void) {
    static struct mesh mesh;
    struct random random = {17};
    make_soup(&mesh, &random);
    if (frame_begin(0)) {
        const struct frame *f = target.pipeline.frame;
        const size_t *capacities[] = {
            &f->call_capacity,       &f->uniforms_capacity, &f->order_capacity,
            &f->position_capacity,   &f->beyond_capacity,   &f->block_capacity,
            &f->blocks_made,         &f->start_capacity,    &f->band_capacity,
            &f->visibility_capacity, &f->scratch_capacity,  &f->touched_capacity};
        enum { CAPACITIES = sizeof capacities / sizeof capacities[0] };
        size_t capacity[CAPACITIES] = {0}, pieces = 0;
        for (int i = 0; i < 20; i++) {
            frame_next();
            for (int call = 0; call < 20; call++) {
                frame_draw(&mesh, mat4_identity(), &number_shader);
            }
            frame_finish();
            for (size_t k = 0; k < CAPACITIES; k++) {
                CHECK(i == 0 || capacity[k] == *capacities[k]);
                capacity[k] = *capacities[k];
            }
            size_t sum = f->scratch[0].piece_capacity + f->scratch[0].plane_capacity;
            for (size_t k = 0; k < f->blocks_made; k++) {
                sum += f->blocks[k].piece_capacity + f->blocks[k].sorted_capacity;
            }
            CHECK(sum > 0 && (i == 0 || sum == pieces));
            pieces = sum;
        }
    }
    target_free(&target);
}

/* A pipeline that drew without threads gets those that are asked for later. */
static void test_threads_later(void) {
    static struct mesh mesh;
    struct random random = {18};
    struct workers *three = workers_create(3); /* fewer on a system without threads */
    make_soup(&mesh, &random);
    if (frame_begin(0)) {
        for (size_t threads = 1; threads <= 3; threads += 2) {
            pipeline_use_threads(&target.pipeline, threads);
            frame_next();
            for (int call = 0; call < 20; call++) { /* more than one part */
                frame_draw(&mesh, mat4_identity(), &number_shader);
            }
            frame_finish();
            CHECK(workers_count(target.pipeline.frame->workers) ==
                  (threads == 1 ? 1 : workers_count(three)));
        }
    }
    target_free(&target);
    workers_free(three);
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

UNIT_MAIN(TEST(test_face_past_a_corner), TEST(test_object_partly_in_view),
          TEST(test_object_without_positions), TEST(test_object_too_large_to_judge),
          TEST(test_each_number_of_varyings), TEST(test_prepared),
          TEST(test_discarded_hides_nothing), TEST(test_cut_from_both_ends), TEST(test_nearest_w),
          TEST(test_depth_overflows), TEST(test_clipped_in_every_block),
          TEST(test_scale_of_clip_space), TEST(test_each_call_has_its_perspective),
          TEST(test_corner_order), TEST(test_ground_without_gaps), TEST(test_interpolation),
          TEST(test_grid_cell), TEST(test_not_finite), TEST(test_wrapped_level),
          TEST(test_far_apart), TEST(test_frames_keep_their_memory), TEST(test_threads_later),
          TEST(test_errors))
