/*
 * The pipeline at its seams, against exact answers at every pixel: bands of rows, chunks of a row,
 * blocks of faces, sides of viewports, draw calls and frames that follow each other; images of any
 * width, in both formats, with one thread to eight.
 */
#include "oracle/oracle.h"
#include "unit/frames.h"

#include <stdatomic.h>
#include <stdlib.h>

enum { FACE_LIMIT = 5000, CALL_LIMIT = 3 };

/* ---- Scenes ---- */

/* A face as it lies on the screen, in 1/256 pixel and in depth. */
struct placed {
    struct fixed2 corner[3];
    int64_t depth[3];
};

enum { DEPTH_STEPS = 64 }; /* of a depth, in 1 */

/* What one draw call draws: faces with corners of their own. */
struct part {
    struct placed placed[FACE_LIMIT];
    struct vec3 positions[3 * FACE_LIMIT];
    struct face faces[FACE_LIMIT];
    struct model model;
    struct draw_call call;
    const struct shader *shader;
    uint32_t first_number; /* of the face that is listed first */
};

struct scene {
    struct part part[CALL_LIMIT];
    size_t count;
    size_t width, height;
    size_t faces_a_call; /* a part is drawn in calls of so many faces; 0: in one */
};

static void add_face(struct part *part, const struct placed *placed) {
    uint32_t n = (uint32_t)part->model.face_count++;
    const struct rectangle *v = &part->call.viewport;
    part->placed[n] = *placed;
    for (uint32_t i = 0; i < 3; i++) {
        struct fixed2 c = placed->corner[i];
        part->positions[3 * n + i] = (struct vec3){(c.x / 256.0 - v->x) * 2 / v->width - 1,
                                                   (c.y / 256.0 - v->y) * 2 / v->height - 1,
                                                   (double)placed->depth[i] / DEPTH_STEPS};
    }
    set_corners(&part->faces[n], 3 * n, 3 * n + 1, 3 * n + 2);
    part->model.position_count += 3;
}

static void part_begin(struct part *part, struct rectangle viewport) {
    part->model = (struct model){.positions = part->positions, .faces = part->faces};
    part->call =
        (struct draw_call){.model = &part->model, .to_clip = mat4_identity(), .viewport = viewport};
}

/* ---- Shaders: a face shows its number ---- */

enum { ALPHA = 200 };

struct number_uniforms {
    uint32_t first_number;
    atomic_size_t *vertex_calls;
};

static void number_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct number_uniforms *u = uniforms;
    size_t number = u->first_number + face;
    (void)corner;
    varyings[0] = (double)(number % 256);
    varyings[1] = (double)(number / 256);
    atomic_fetch_add(u->vertex_calls, 1);
}

/* Of a flat face corner 0 counts, and only that. */
static void flat_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    number_vertex(uniforms, face, corner, varyings);
    varyings[0] += 7 * (double)corner;
}

static lanes_mask number_fragment(const void *uniforms, const lanes *varyings, lanes_texel *color) {
    (void)uniforms;
    *color = lanes_rgb(lanes_all(1), varyings[1], varyings[0]);
    *color = (*color & 0xFFFFFF) | (uint32_t)ALPHA << 24;
    return lanes_all_set();
}

SHADER(number_shader, .varying_count = 2, .vertex = number_vertex, .fragment = number_fragment);
SHADER(flat_shader, .varying_count = 2, .flat = true, .vertex = flat_vertex,
       .fragment = number_fragment);
SHADER(discarding_shader, .varying_count = 2, .vertex = number_vertex, .fragment = number_fragment,
       .discards = true);
SHADER(flat_discarding_shader, .varying_count = 2, .flat = true, .vertex = flat_vertex,
       .fragment = number_fragment, .discards = true);

/* Without its own loops. */
static const struct shader called_shader = {
    .varying_count = 2, .vertex = number_vertex, .fragment = number_fragment};

static const struct shader *const shaders[] = {&number_shader, &flat_shader, &discarding_shader,
                                               &flat_discarding_shader, &called_shader};
enum { SHADERS = sizeof shaders / sizeof shaders[0] };

/* ---- The exact answer ---- */

struct answer {
    uint32_t number; /* of the face that shows, from 1 on; 0 where nothing is drawn */
    const struct placed *placed;
};

static bool is_left_out(const struct placed *p, enum cull cull) {
    const struct fixed2 *c = p->corner;
    int64_t area = (int64_t)(c[1].x - c[0].x) * (c[2].y - c[0].y) -
                   (int64_t)(c[1].y - c[0].y) * (c[2].x - c[0].x);
    return (cull == CULL_BACK && area < 0) || (cull == CULL_FRONT && area > 0);
}

static int first_pixel(int32_t a, int32_t b, int32_t c) {
    int32_t least = a < b ? a : b;
    least = c < least ? c : least;
    return (int)floor(least / 256.0);
}

static int last_pixel(int32_t a, int32_t b, int32_t c) {
    int32_t most = a > b ? a : b;
    most = c > most ? c : most;
    return (int)floor(most / 256.0);
}

static int limit(int value, int least, int most) {
    return value < least ? least : value > most ? most : value;
}

/* How much work it is to draw every face, one after the other. */
struct work {
    uint64_t covered; /* pixels */
    uint64_t nearest; /* pixels where the face is nearest so far */
    uint64_t missed;  /* faces over at most 2 x 2 pixels, some in the viewport, that cover none */
};

/* One face over what was drawn before it: of equal depths the first stays. */
static void answer_face(const struct placed *placed, const struct rectangle *v, uint32_t number,
                        size_t width, struct answer *answers, struct work *work) {
    const struct fixed2 *c = placed->corner;
    uint64_t covered_before = work->covered;
    int left = first_pixel(c[0].x, c[1].x, c[2].x), right = last_pixel(c[0].x, c[1].x, c[2].x) + 1;
    int bottom = first_pixel(c[0].y, c[1].y, c[2].y), top = last_pixel(c[0].y, c[1].y, c[2].y) + 1;
    bool small = right - left <= 2 && top - bottom <= 2;
    left = limit(left, v->x, v->x + v->width);
    right = limit(right, v->x, v->x + v->width);
    bottom = limit(bottom, v->y, v->y + v->height);
    top = limit(top, v->y, v->y + v->height);
    for (int y = bottom; y < top; y++) {
        for (int x = left; x < right; x++) {
            struct answer *a = &answers[(size_t)y * width + (size_t)x];
            bool covered = oracle_covers(c[0], c[1], c[2], x, y);
            work->covered += covered;
            if (covered &&
                (a->number == 0 || oracle_compare_depth(c, placed->depth, a->placed->corner,
                                                        a->placed->depth, x, y) > 0)) {
                *a = (struct answer){number, placed};
                work->nearest++;
            }
        }
    }
    work->missed += small && left < right && bottom < top && work->covered == covered_before;
}

static struct answer *answer(const struct scene *scene, struct work *work) {
    struct answer *answers = calloc(scene->width * scene->height, sizeof *answers);
    *work = (struct work){0};
    for (size_t i = 0; answers != NULL && i < scene->count; i++) {
        const struct part *part = &scene->part[i];
        for (size_t k = 0; k < part->model.face_count; k++) {
            if (!is_left_out(&part->placed[k], part->call.cull)) {
                answer_face(&part->placed[k], &part->call.viewport,
                            part->first_number + (uint32_t)k, scene->width, answers, work);
            }
        }
    }
    return answers;
}

/* ---- Drawing and judging ---- */

enum { UNTOUCHED = 0x77 };

static void scribble(struct image *image) {
    memset(image->pixels, UNTOUCHED, image->width * image->height * image->format);
}

/* Some faces of a part, as a model of their own that must stay until the frame is finished. (The
 * corners of face n are the positions from 3 n on.) */
static bool draw_faces(struct pipeline *pipeline, const struct part *part, size_t first,
                       size_t count, struct model *model, atomic_size_t *vertex_calls) {
    struct error error;
    struct number_uniforms uniforms = {part->first_number + (uint32_t)first, vertex_calls};
    struct draw_call call = part->call;
    *model = part->model;
    model->positions += 3 * first;
    model->position_count = 3 * count;
    model->face_count = count;
    call.model = model;
    return pipeline_draw(pipeline, &call, part->shader, &uniforms, sizeof uniforms, &error);
}

/* Depth tests are counted in every other frame. */
static bool draw_on_top(struct pipeline *pipeline, const struct scene *scene, struct image *image,
                        size_t *vertex_calls) {
    static struct model models[CALL_LIMIT * FACE_LIMIT];
    struct error error;
    atomic_size_t calls = 0;
    size_t model = 0;
    bool done = true;
    pipeline_clear(pipeline);
    pipeline->counts_tests = !pipeline->counts_tests;
    for (size_t i = 0; i < scene->count; i++) {
        size_t faces = scene->part[i].model.face_count, first = 0;
        do {
            size_t left = faces - first, limit = scene->faces_a_call;
            size_t count = limit > 0 && limit < left ? limit : left;
            done = done &&
                   draw_faces(pipeline, &scene->part[i], first, count, &models[model++], &calls);
            first += count;
        } while (first < faces);
    }
    done = done && pipeline_finish(pipeline, image, &error);
    *vertex_calls = calls;
    return CHECK(done);
}

/* Frugal: in each band a face that shows there is asked once for its corners, or for one of them
 * where it is flat; others never. */
static size_t calls_needed(const struct scene *scene, const struct answer *answers) {
    size_t calls = 0;
    for (size_t y = 0; y < scene->height; y += BAND_HEIGHT) {
        static bool seen[CALL_LIMIT * FACE_LIMIT + 1];
        memset(seen, 0, sizeof seen);
        seen[0] = true; /* nothing */
        for (size_t i = y * scene->width;
             i < (y + BAND_HEIGHT) * scene->width && i < scene->height * scene->width; i++) {
            uint32_t number = answers[i].number;
            const struct part *part = scene->part;
            while (!seen[number] && number >= part->first_number + part->model.face_count) {
                part++;
            }
            calls += seen[number] ? 0 : part->shader->flat ? 1 : 3;
            seen[number] = true;
        }
    }
    return calls;
}

static bool discards(const struct part *part) {
    return part->shader->discards;
}

static bool culls(const struct part *part) {
    return part->call.cull != CULL_NONE;
}

static bool has(const struct scene *scene, bool (*kind)(const struct part *)) {
    bool found = false;
    for (size_t i = 0; i < scene->count; i++) {
        found = found || kind(&scene->part[i]);
    }
    return found;
}

static bool pixel_is_right(const struct image *image, size_t pixel, uint32_t number,
                           bool is_cleared) {
    const uint8_t *p = image->pixels + pixel * image->format;
    if (number == 0) {
        uint8_t left = is_cleared ? 0 : UNTOUCHED;
        return p[0] == left && p[1] == left && p[2] == left && p[image->format - 1] == left;
    }
    return p[0] == number % 256 && p[1] == number / 256 && p[2] == 1 &&
           (image->format == IMAGE_BGR || p[3] == ALPHA);
}

/* The depth of a face that is level must be just that; of others a few roundings are lost. */
static bool depth_is_right(const struct pipeline *pipeline, size_t pixel, const struct answer *a) {
    static const int64_t parallel[3] = {1, 1, 1};
    double depth = pipeline->depth[pixel];
    if (a->number == 0) {
        return depth == (double)-INFINITY;
    }
    const int64_t *z = a->placed->depth;
    long double exact =
        oracle_perspective_depth(a->placed->corner, z, parallel, (int)(pixel % pipeline->width),
                                 (int)(pixel / pipeline->width)) /
        DEPTH_STEPS;
    bool level = z[0] == z[1] && z[1] == z[2];
    return fabsl((long double)depth - exact) <= (level ? 0 : 0x1p-49L);
}

static bool frame_is_right(const struct pipeline *pipeline, const struct image *image,
                           const struct answer *answers) {
    for (size_t i = 0; i < image->width * image->height; i++) {
        if (!pixel_is_right(image, i, answers[i].number, pipeline->clears_image) ||
            (pipeline->keep_depth && !depth_is_right(pipeline, i, &answers[i]))) {
            const uint8_t *p = image->pixels + i * image->format;
            fprintf(stderr, "    %zux%zu: pixel %zu %zu should show %u, shows %d\n", image->width,
                    image->height, i % image->width, i / image->width, (unsigned)answers[i].number,
                    p[0] + 256 * p[1]);
            return false;
        }
    }
    return true;
}

/* ---- Random scenes of any size ---- */

static uint64_t count_drawn(const struct scene *scene, const struct answer *answers) {
    uint64_t drawn = 0;
    for (size_t i = 0; i < scene->width * scene->height; i++) {
        drawn += answers[i].number != 0;
    }
    return drawn;
}

/* Every pixel that a face covers is tested, except of faces that are dropped behind others; and it
 * passes wherever the face is nearest so far, unless the order is another one. */
static bool tests_are_right(const struct pipeline *pipeline, uint64_t drawn,
                            const struct work *work) {
    uint64_t covered = pipeline->stats[STAT_PIXELS_COVERED];
    uint64_t passed = pipeline->stats[STAT_PIXELS_PASSED];
    if (!pipeline->counts_tests) {
        return covered == 0 && passed == 0;
    }
    bool some_behind = pipeline->stats[STAT_FACES_BEHIND] > 0;
    return covered >= drawn && covered <= work->covered &&
           (some_behind || covered == work->covered) && passed >= drawn && passed <= covered &&
           (pipeline->frame->reordered || passed == work->nearest);
}

/* What was counted while a frame was drawn, of faces none of which is culled. Each pixel is shaded
 * once; with skip off, and to find what a shader discards, wherever a face is nearest so far. */
static bool counts_are_right(const struct pipeline *pipeline, const struct scene *scene,
                             const struct answer *answers, const struct work *work) {
    uint64_t drawn = count_drawn(scene, answers), least = pipeline->skip ? drawn : work->nearest;
    uint64_t most = has(scene, discards) ? drawn + work->nearest : least;
    uint64_t shaded = pipeline->stats[STAT_PIXELS_SHADED];
    return tests_are_right(pipeline, drawn, work) && shaded >= least &&
           shaded <= (pipeline->skip ? most : least);
}

/* What is neither seen nor shaded is counted by the reason for it; of small faces between centres
 * it is found before they are drawn. */
static bool faces_are_counted(const struct pipeline *pipeline, const struct scene *scene,
                              const struct answer *answers, const struct work *work) {
    static bool shown[CALL_LIMIT * FACE_LIMIT + 1];
    const uint64_t *stats = pipeline->stats;
    uint64_t count = 0;
    memset(shown, 0, sizeof shown);
    for (size_t i = 0; i < scene->width * scene->height; i++) {
        count += answers[i].number != 0 && !shown[answers[i].number];
        shown[answers[i].number] = true;
    }
    uint64_t left_out =
        stats[STAT_FACES_OUTSIDE] + stats[STAT_FACES_TURNED_AWAY] + stats[STAT_FACES_WITHOUT_PIXEL];
    return count == stats[STAT_FACES] - left_out - stats[STAT_FACES_HIDDEN] &&
           (stats[STAT_FACES_BEHIND] > 0 || stats[STAT_FACES_WITHOUT_PIXEL] >= work->missed);
}

/* Draw the scene over what is in the image, and judge it. */
static void check_frame(struct target *target, const struct scene *scene,
                        const struct answer *answers, const struct work *work) {
    struct pipeline *pipeline = &target->pipeline;
    bool exact = pipeline->skip && !has(scene, discards);
    size_t calls;
    if (draw_on_top(pipeline, scene, &target->image, &calls)) {
        CHECK(frame_is_right(pipeline, &target->image, answers));
        CHECK(!exact || calls == calls_needed(scene, answers));
        CHECK(!exact || faces_are_counted(pipeline, scene, answers, work));
        CHECK(has(scene, culls) || counts_are_right(pipeline, scene, answers, work));
        CHECK((pipeline->depth != NULL) == pipeline->keep_depth);
    }
}

/* Draw the scene on an image that is not empty, and check the frame. */
static void check_scene(struct target *target, const struct scene *scene) {
    struct work work;
    struct answer *answers = answer(scene, &work);
    if (CHECK(answers != NULL)) {
        scribble(&target->image);
        check_frame(target, scene, answers, &work);
    }
    free(answers);
}

/* Now and then at a multiple of 8 pixels, where bands and chunks begin, or half a pixel from it. */
static int32_t any_place(struct random *random, int size) {
    if (random_bits(random) % 4 == 0) {
        return (int32_t)random_between(random, -1, size / 8 + 1) * 8 * 256 +
               (int32_t)random_between(random, 0, 2) * 128;
    }
    return (int32_t)random_between(random, -20 * 256, (size + 20) * 256);
}

/* Let the side between corners 0 and 1 pass a place by as near as can be, on either side: their
 * cross product around it is 1. */
static void pass_by(struct random *random, struct fixed2 place, int reach, struct fixed2 *corner) {
    int32_t k = (int32_t)random_between(random, -reach, reach),
            j = (int32_t)random_between(random, 0, 1);
    bool first = random_bits(random) % 2 != 0;
    corner[first] = (struct fixed2){place.x - k, place.y - 1};
    corner[!first] = (struct fixed2){place.x + k * j + 1, place.y + j};
}

static struct fixed2 any_center(struct random *random, const struct scene *scene) {
    return (struct fixed2){(int32_t)random_between(random, 0, (int)scene->width) * 256 + 128,
                           (int32_t)random_between(random, 0, (int)scene->height) * 256 + 128};
}

static void any_face(struct random *random, const struct scene *scene, struct placed *placed) {
    bool small = random_bits(random) % 2 == 0, level = random_bits(random) % 2 == 0;
    struct fixed2 near = {any_place(random, (int)scene->width),
                          any_place(random, (int)scene->height)};
    bool flat_top = random_bits(random) % 4 == 0; /* or bottom, on pixel centres */
    near.y = flat_top ? near.y / 256 * 256 + 128 : near.y;
    for (int i = 0; i < 3; i++) {
        placed->corner[i] =
            small ? (struct fixed2){near.x + (int32_t)random_between(random, -1500, 1500),
                                    near.y + (int32_t)random_between(random, -1500, 1500)}
                  : (struct fixed2){any_place(random, (int)scene->width),
                                    any_place(random, (int)scene->height)};
        placed->corner[i].y = flat_top && i < 2 ? near.y : placed->corner[i].y;
        placed->depth[i] = random_between(random, -3, 3) * (level ? 16 : 1);
        if (level) {
            placed->depth[i] = i > 0 ? placed->depth[0] : placed->depth[i];
        } else {
            placed->depth[i] += random_between(random, -40, 40);
        }
    }
    if (random_bits(random) % 8 == 0) {
        pass_by(random, any_center(random, scene), 20 * 256, placed->corner);
    }
}

/* So wide or high, at least, that no face has to be clipped: that would move its edges a little. */
enum { LEAST_SIDE = 6 };

static struct span any_side(struct random *random, int size) {
    int least = size < LEAST_SIDE ? size : LEAST_SIDE;
    int begin = (int)random_between(random, 0, size - least);
    return (struct span){begin, begin + (int)random_between(random, least, size - begin)};
}

/* Part of the image, with its sides in the middle of bands and chunks; seldom all of it. */
static struct rectangle any_viewport(struct random *random, const struct scene *scene) {
    int width = (int)scene->width, height = (int)scene->height;
    if (random_bits(random) % 4 == 0) {
        return (struct rectangle){0, 0, width, height};
    }
    struct span x = any_side(random, width), y = any_side(random, height);
    return (struct rectangle){x.begin, y.begin, x.end - x.begin, y.end - y.begin};
}

static void make_scene(struct random *random, struct scene *scene, size_t faces, bool culled) {
    uint32_t number = 1;
    scene->count = random_bits(random) % (CALL_LIMIT + 1);
    for (size_t i = 0; i < scene->count; i++) {
        struct part *part = &scene->part[i];
        part_begin(part, any_viewport(random, scene));
        part->call.cull = (enum cull)(culled ? random_bits(random) % 3 : CULL_NONE);
        part->shader = shaders[random_bits(random) % SHADERS];
        part->first_number = number;
        for (size_t k = 0; k < faces; k++) {
            struct placed placed;
            any_face(random, scene, &placed);
            add_face(part, &placed);
        }
        number += (uint32_t)faces;
    }
}

/* Several frames of one pipeline, on two images: what one has left behind must not show in the
 * next. Before each of them check_scene() scribbles on the image. */
static void check_size(struct random *random, size_t width, size_t height) {
    static struct scene scene;
    struct target target;
    struct image images[2] = {{0}};
    struct error error;
    enum image_format format = random_bits(random) % 2 ? IMAGE_BGR : IMAGE_BGRA;
    CHECK(target_create(&target, width, height, format));
    images[0] = target.image;
    CHECK(image_create(&images[1], width, height, IMAGE_BGRA, &error));
    scene.width = width;
    scene.height = height;
    for (int frame = 0; frame < 6; frame++) {
        struct pipeline *pipeline = &target.pipeline;
        struct image *image = &images[random_bits(random) % 4 == 0];
        images[1].format = random_bits(random) % 2 ? IMAGE_BGR : IMAGE_BGRA; /* the same memory */
        pipeline->clears_image = random_bits(random) % 2 != 0;
        make_scene(random, &scene, 1 + random_bits(random) % 12, frame % 2 == 0);
        pipeline->skip = random_bits(random) % 3 != 0;
        pipeline->keep_depth = random_bits(random) % 2 == 0;
        pipeline_use_threads(pipeline, 1 + random_bits(random) % 8 * (frame == 2));
        target.image = *image;
        check_scene(&target, &scene);
    }
    pipeline_free(&target.pipeline);
    image_free(&images[0]);
    image_free(&images[1]);
}

static void test_images_of_all_sizes(void) {
    static const size_t sides[] = {1, 2, 7, 8, 9, 15, 16, 17, 31, 32, 33, 47, 64, 65, 129};
    enum { SIDES = sizeof sides / sizeof sides[0] };
    struct random random = {71};
    for (size_t i = 0; i < SIDES; i++) {
        for (size_t k = 0; k < SIDES; k++) {
            check_size(&random, sides[i], sides[k]);
        }
    }
}

/* ---- More faces than a block has ---- */

/* Thousands of them all over a small image, many at equal depths. */
static void test_many_faces(void) {
    static struct scene scene;
    struct random random = {72};
    struct target target;
    struct work work;
    scene.width = 100, scene.height = 90;
    make_scene(&random, &scene, 5000, false);
    struct answer *answers = answer(&scene, &work);
    CHECK(target_create(&target, scene.width, scene.height, IMAGE_BGR));
    CHECK(answers != NULL && scene.count > 1);
    for (size_t threads = 1; answers != NULL && threads <= 8; threads++) {
        for (size_t i = 0; i < 3; i++) {
            target.pipeline.skip = i < 2;
            scene.part[1].shader = i == 0 ? &flat_shader : &discarding_shader;
            pipeline_use_threads(&target.pipeline, threads);
            scribble(&target.image);
            check_frame(&target, &scene, answers, &work);
        }
    }
    free(answers);
    target_free(&target);
}

/* Sides of 2^17 steps, whose products have more than 32 bits; and of faces with an area of 1/131072
 * pixel, which cover a pixel at most: the one on whose centre a corner lies. */
static void test_long_faces(void) {
    static struct scene scene = {.count = 1, .width = 600, .height = 16, .faces_a_call = 2};
    struct part *part = &scene.part[0];
    struct random random = {73};
    struct target target;
    part_begin(part, (struct rectangle){0, 0, 600, 16});
    part->shader = &number_shader;
    part->first_number = 1;
    add_face(part, &(struct placed){{{-256 * 512, 0}, {0, 0}, {0, 256 * 512}}, {-9, -9, -9}});
    add_face(part, &(struct placed){{{0, 0}, {256 * 512, 0}, {0, 256 * 512}}, {-9, -9, -9}});
    for (int i = 0; i < 300; i++) {
        struct placed placed = {.depth = {i, i, i}};
        placed.corner[2] = any_center(&random, &scene);
        pass_by(&random, placed.corner[2], 140000, placed.corner);
        add_face(part, &placed);
    }
    for (int i = 0; i < 16; i++) { /* upright along the centres of each column of a chunk */
        int32_t x = 17 * 256 * i + 128;
        add_face(part, &(struct placed){{{x, -999}, {x + 999, -999}, {x, 9999}}, {99, 99, 99}});
    }
    if (CHECK(target_create(&target, scene.width, scene.height, IMAGE_BGR))) {
        check_scene(&target, &scene);
    }
    target_free(&target);
}

/* A level face around a place, of any size. */
static void add_level_face(struct part *part, int32_t x, int32_t y, int32_t size, int64_t depth) {
    add_face(part, &(struct placed){{{x - size, y - size}, {x + size, y - size}, {x, y + size}},
                                    {depth, depth, depth}});
}

/* Up to 300 draw calls of one to three faces each, before and behind a few that cover most of the
 * image, and one without a face, or a viewport; many at equal depths. They come in rounds, not in
 * their order, and some are hidden by the rounds before as a whole, others in part. */
static void test_many_calls(void) {
    static struct scene scene;
    struct random random = {76};
    struct target target;
    uint64_t hidden = 0, all = 0;
    scene.count = 2, scene.width = 90, scene.height = 70;
    scene.part[1].shader = &number_shader;
    CHECK(target_create(&target, 90, 70, IMAGE_BGR));
    for (int frame = 0; frame < 120; frame++) {
        struct part *part = &scene.part[0];
        part_begin(part, frame % 3 == 0 ? any_viewport(&random, &scene)
                                        : (struct rectangle){0, 0, 90, 70});
        part->shader = frame % 2 == 0 ? &number_shader : &flat_shader;
        part->first_number = 1;
        part->call.cull = (enum cull)(frame / 2 % 3);
        part_begin(&scene.part[1],
                   (struct rectangle){7, 7, frame / 4 % 2 * 30, frame / 8 % 2 * 40});
        scene.faces_a_call = (size_t)(1 + frame % 3);
        size_t faces = (size_t)random_between(&random, 10, 300);
        while (part->model.face_count < faces) {
            struct placed placed;
            any_face(&random, &scene, &placed);
            add_face(part, &placed);
            if (random_bits(&random) % 64 == 0) {
                add_level_face(part, 256 * (int32_t)random_between(&random, 0, 90),
                               256 * (int32_t)random_between(&random, 0, 40), 60 * 256,
                               16 * random_between(&random, 0, 3));
            }
        }
        target.pipeline.skip = frame % 8 != 7;
        target.pipeline.keep_depth = frame % 4 == 0;
        pipeline_use_threads(&target.pipeline, (size_t)(1 + frame / 10 % 4));
        check_scene(&target, &scene);
        hidden += target.pipeline.stats[STAT_CALLS_HIDDEN];
        all += target.pipeline.stats[STAT_CALLS];
    }
    CHECK(hidden > 650 && hidden < all);
    target_free(&target);
}

UNIT_MAIN(TEST(test_images_of_all_sizes), TEST(test_many_faces), TEST(test_long_faces),
          TEST(test_many_calls))
