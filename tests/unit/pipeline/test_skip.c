/*
 * What the pipeline skips: with `skip` on and off it draws the same bytes, in scenes where most of
 * the work is for nothing, and the counters say what was not done.
 */
#include "oracle/oracle.h"
#include "unit/frames.h"

enum { WIDTH = 96, HEIGHT = 72, OBJECT_LIMIT = 400, BANDS = (HEIGHT + 31) / 32 };

static const struct vec3 up = {0, 1, 0};

/* ---- Shaders: a colour that tells the object, the face and the place in it ---- */

struct uniforms {
    const struct model *model;
    double tint; /* the object's, 0.25..1 */
};

static void place_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct uniforms *u = uniforms;
    struct vec3 p = model_position(u->model, face, corner);
    double scale = 255 * u->tint / (1 + vec3_length(p));
    varyings[0] = scale * fabs(p.x) + 1;
    varyings[1] = scale * fabs(p.y) + 1;
    varyings[2] = (double)(face % 200) * u->tint + 1;
}

static lanes_mask place_fragment(const void *uniforms, const lanes *varyings, lanes_texel *color) {
    (void)uniforms;
    *color = lanes_rgb(varyings[0], varyings[1], varyings[2]);
    return lanes_all_set();
}

/* With holes. */
static lanes_mask hole_fragment(const void *uniforms, const lanes *varyings, lanes_texel *color) {
    place_fragment(uniforms, varyings, color);
    return varyings[0] > 20;
}

SHADER(smooth, .varying_count = 3, .vertex = place_vertex, .fragment = place_fragment);
SHADER(flat, .varying_count = 3, .vertex = place_vertex, .fragment = place_fragment, .flat = true);
SHADER(holes, .varying_count = 3, .vertex = place_vertex, .fragment = hole_fragment,
       .discards = true);

static const struct shader *const shaders[] = {&flat, &holes, &smooth};

/* ---- Scenes ---- */

struct object {
    const struct model *model;
    struct mat4 to_clip;
};

struct scene {
    const char *name;
    struct object objects[OBJECT_LIMIT];
    size_t count;
};

static void add_object(struct scene *scene, const struct model *model, struct mat4 camera,
                       struct vec3 place, double size) {
    struct mat4 to_world =
        mat4_mul(mat4_translation(place), mat4_scaling((struct vec3){size, size, size}));
    scene->objects[scene->count++] = (struct object){model, mat4_mul(camera, to_world)};
}

static struct mat4 camera_at(struct vec3 eye, struct vec3 center) {
    struct rectangle all = {0, 0, WIDTH, HEIGHT};
    return camera_call(NULL, eye, center, up, 0.9, all, CULL_NONE).to_clip;
}

static const struct vec3 origin = {0, 0, 0};

/* A square from -2 to 2, two faces. */
#define CORNER(number)                                                                             \
    { number, MODEL_NONE, MODEL_NONE }
static struct model wall = {
    .positions = (struct vec3[]){{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}},
    .position_count = 4,
    .faces =
        (struct face[]){{{CORNER(0), CORNER(1), CORNER(2)}}, {{CORNER(0), CORNER(2), CORNER(3)}}},
    .face_count = 2,
};

/* ---- Drawing ---- */

struct drawn {
    struct image image;
    uint64_t stats[PIPELINE_STATS];
};

/* What is drawn with skip on and off. */
struct trial {
    struct pipeline pipeline;
    struct drawn skip, all;
};

static bool trial_begin(struct trial *trial) {
    struct error error;
    *trial = (struct trial){.skip = {{0}, {0}}};
    return CHECK(image_create(&trial->skip.image, WIDTH, HEIGHT, IMAGE_BGR, &error)) &&
           CHECK(image_create(&trial->all.image, WIDTH, HEIGHT, IMAGE_BGR, &error)) &&
           CHECK(pipeline_create(&trial->pipeline, WIDTH, HEIGHT, &error));
}

static void trial_end(struct trial *trial) {
    image_free(&trial->skip.image);
    image_free(&trial->all.image);
    pipeline_free(&trial->pipeline);
}

static void draw_objects(struct pipeline *pipeline, const struct scene *scene, enum cull cull,
                         const struct shader *shader, struct drawn *drawn) {
    struct error error;
    pipeline_clear(pipeline);
    pipeline->counts_tests = true;
    image_clear(&drawn->image, color_grey(0));
    for (size_t i = 0; i < scene->count; i++) {
        const struct object *object = &scene->objects[i];
        struct uniforms u = {object->model, 0.25 + 0.75 * (double)(i % 16) / 15};
        struct draw_call call = {object->model, object->to_clip, {0, 0, WIDTH, HEIGHT}, cull};
        CHECK(pipeline_draw(pipeline, &call, shader, &u, sizeof u, &error));
    }
    CHECK(pipeline_finish(pipeline, &drawn->image, &error));
    memcpy(drawn->stats, pipeline->stats, sizeof drawn->stats);
}

/* Draws the scene with skip on and off; the image must be the same. Returns what was counted with
 * skip on. */
static const uint64_t *compare(struct trial *trial, const struct scene *scene, enum cull cull,
                               const struct shader *shader) {
    trial->pipeline.skip = true;
    draw_objects(&trial->pipeline, scene, cull, shader, &trial->skip);
    trial->pipeline.skip = false;
    draw_objects(&trial->pipeline, scene, cull, shader, &trial->all);
    CHECK_ROW(memcmp(trial->skip.image.pixels, trial->all.image.pixels, WIDTH * HEIGHT * 3) == 0,
              scene->name);
    return trial->skip.stats;
}

/* ---- Checks ---- */

static size_t count_vertices(const struct scene *scene) {
    size_t count = 0;
    for (size_t i = 0; i < scene->count; i++) {
        count += scene->objects[i].model->position_count;
    }
    return count;
}

/* Both ways count the same scene. Of what is hidden with its object or batch, which reach neither
 * the near plane nor the guard band, some faces may be outside. */
static void check_counters(const struct scene *scene, const uint64_t *skip, const uint64_t *all) {
    static const enum pipeline_stat same[] = {STAT_CALLS, STAT_FACES, STAT_FACES_CLIPPED};
    for (size_t i = 0; i < sizeof same / sizeof same[0]; i++) {
        CHECK_ROW(skip[same[i]] == all[same[i]], pipeline_stat_name[same[i]]);
    }
    uint64_t outside = skip[STAT_FACES_OUTSIDE], hidden = skip[STAT_FACES_HIDDEN];
    CHECK_ROW(outside <= all[STAT_FACES_OUTSIDE] && outside + hidden >= all[STAT_FACES_OUTSIDE],
              scene->name);
    CHECK_ROW(all[STAT_CALLS] == scene->count, scene->name);
    CHECK_ROW(all[STAT_CALLS_OUTSIDE] == 0 && all[STAT_CALLS_HIDDEN] == 0, scene->name);
    CHECK_ROW(skip[STAT_FACES_TURNED_AWAY] <= all[STAT_FACES_TURNED_AWAY], scene->name);
    CHECK_ROW(all[STAT_VERTICES_TRANSFORMED] == count_vertices(scene), scene->name);
    CHECK_ROW(skip[STAT_VERTICES_TRANSFORMED] <= all[STAT_VERTICES_TRANSFORMED], scene->name);
    CHECK_ROW(skip[STAT_PIXELS_COVERED] <= all[STAT_PIXELS_COVERED], scene->name);
    CHECK_ROW(skip[STAT_PIXELS_PASSED] <= skip[STAT_PIXELS_COVERED], scene->name);
    CHECK_ROW(all[STAT_PIXELS_PASSED] == all[STAT_PIXELS_SHADED], scene->name);
}

/* Draws the scene with skip on and off, whatever culled, with another shader
 * each time. `stats` are those of what was drawn last, with skip on: culled what is turned away,
 * and no shader that discards. */
static void check_scene(const struct scene *scene, uint64_t stats[PIPELINE_STATS]) {
    struct trial trial;
    CHECK(trial_begin(&trial));
    static const enum cull culls[] = {CULL_NONE, CULL_FRONT, CULL_BACK};
    for (size_t i = 0; i < 3; i++) {
        enum cull cull = culls[i];
        const struct shader *shader = shaders[i];
        const uint64_t *skip = compare(&trial, scene, cull, shader), *all = trial.all.stats;
        check_counters(scene, skip, all);
        memcpy(stats, skip, sizeof trial.skip.stats);
        CHECK_ROW(shader->discards || skip[STAT_ATTRIBUTE_SETS] <= all[STAT_ATTRIBUTE_SETS],
                  scene->name);
    }
    trial_end(&trial);
}

/* ---- Tests ---- */

static struct scene scene;

/* Points within roundings of one side of the view: a face is skipped with its object only if it
 * would be skipped alone. */
static void test_within_roundings_of_a_side(void) {
    enum { FACES = 10 };
    struct error error;
    struct target target;
    struct random random = {5};
    struct vec3 positions[3 * FACES];
    struct face faces[FACES];
    struct model model = plain_model(positions, 3 * FACES, faces, FACES, NULL);
    struct uniforms u = {&model, 1};
    size_t outside[2] = {0, 0}, whole = 0;
    CHECK(target_create(&target, WIDTH, HEIGHT, IMAGE_BGR));
    for (int i = 0; i < 8000; i++) {
        struct mat4 m = {{{0}}};
        double sign = i % 2 == 0 ? 1 : -1, spread = i / 4 % 2 == 0 ? 1 : 4e-15;
        for (int k = 0; k < 4; k++) { /* x or y is w, up to roundings and the sign */
            m.m[3][k] = random_real(&random, 0.1, 1);
            m.m[i / 2 % 2][k] = sign * m.m[3][k] * (1 + 1e-16 * random_real(&random, -4, 4));
        }
        for (int k = 0; k < 3 * FACES; k++) {
            positions[k] = (struct vec3){random_real(&random, 1, 1 + spread),
                                         random_real(&random, 1, 1 + spread),
                                         random_real(&random, 1, 1 + spread)};
        }
        struct draw_call call = {&model, m, {0, 0, WIDTH, HEIGHT}, CULL_NONE};
        for (int skip = 0; skip < 2; skip++) {
            target.pipeline.skip = skip;
            pipeline_clear(&target.pipeline);
            for (int k = 0; k < 2; k++) { /* of one call alone no box is found */
                CHECK(pipeline_draw(&target.pipeline, &call, &flat, &u, sizeof u, &error));
            }
            CHECK(pipeline_finish(&target.pipeline, &target.image, &error));
            outside[skip] += target.pipeline.stats[STAT_FACES_OUTSIDE];
        }
        whole += target.pipeline.stats[STAT_FACES_OUTSIDE] == 2 * FACES;
    }
    CHECK(whole > 200 && outside[1] == outside[0]);
    target_free(&target);
}

/* Two walls before a third one leave a column or a row between them, where that shows: each pixel
 * of a tile is asked for. */
static void test_narrow_gaps(void) {
    const struct mat4 nearer = mat4_translation((struct vec3){0, 0, 0.5});
    struct trial trial;
    CHECK(trial_begin(&trial));
    for (int i = 0; i < WIDTH + HEIGHT; i++) {
        struct vec3 along = {i < WIDTH, i >= WIDTH, 0};
        double size = i < WIDTH ? WIDTH : HEIGHT, begin = 2 * (i % WIDTH) / size - 1;
        scene = (struct scene){.name = "a gap of one pixel"};
        add_object(&scene, &wall, nearer, vec3_scale(along, begin - 2), 1);
        add_object(&scene, &wall, nearer, vec3_scale(along, begin + 2 / size + 2), 1);
        add_object(&scene, &wall, mat4_identity(), origin, 1);
        compare(&trial, &scene, CULL_NONE, &smooth);
    }
    trial_end(&trial);
}

/* ---- Rounds ---- */

/* Where the round ends in which the object at that place in the order comes: the first has four
 * objects, each one after it as many as all before; of fewer than 16 there is one round. */
static size_t end_of_round(size_t place, size_t count) {
    size_t end = 4;
    while (end <= place) {
        end *= 2;
    }
    return count < 16 || end > count ? count : end;
}

/* The wall as a square of 4x4 pixels, one of 24x18 that lie side by side. */
static struct mat4 small_square(size_t cell, double depth) {
    double x = (double)(cell % 24) * 4 + 2, y = (double)(cell / 24) * 4 + 2;
    return mat4_mul(mat4_translation((struct vec3){2 * x / WIDTH - 1, 2 * y / HEIGHT - 1, depth}),
                    mat4_scaling((struct vec3){2.0 / WIDTH, 2.0 / HEIGHT, 1}));
}

/* Squares one behind the other, all small but one, which covers the image. Those before it are seen
 * as a whole, of those behind it nothing: in its round they are transformed, later not even that.
 * So the counters tell which objects came in which round. */
static void check_rounds(size_t count, size_t wall_place) {
    uint64_t stats[PIPELINE_STATS] = {0};
    scene = (struct scene){.name = "squares, one of them large", .count = count};
    for (size_t i = 0; i < count; i++) {
        double depth = 0.5 - (double)i / 256;
        scene.objects[i * 7 % count] =
            (struct object){&wall, i == wall_place ? mat4_translation((struct vec3){0, 0, depth})
                                                   : small_square(i * 37 % (24 * 18), depth)};
    }
    check_scene(&scene, stats);
    size_t hidden = count - end_of_round(wall_place, count), behind = count - 1 - wall_place;
    CHECK(stats[STAT_CALLS_HIDDEN] == hidden);
    CHECK(stats[STAT_VERTICES_TRANSFORMED] == 4 * (count - hidden));
    CHECK(stats[STAT_FACES_HIDDEN] == 2 * behind && stats[STAT_FACES_BEHIND] == 2 * behind);
    CHECK(stats[STAT_ATTRIBUTE_SETS] == 2 * BANDS + 2 * wall_place);
    CHECK(stats[STAT_PIXELS_COVERED] == WIDTH * HEIGHT + 16 * wall_place);
}

static void test_rounds(void) {
    static const size_t counts[] = {2, 8, 9, 15, 16, 17, 31, 32, 33, 66, 80};
    static const size_t places[] = {0, 1, 2, 3, 4, 6, 7, 8, 14, 15, 16, 30, 31, 32, 63, 64, 65, 79};
    for (size_t i = 0; i < sizeof counts / sizeof counts[0]; i++) {
        for (size_t k = 0; k < sizeof places / sizeof places[0]; k++) {
            if (places[k] < counts[i]) {
                check_rounds(counts[i], places[k]);
            }
        }
    }
}

/* Walls and tetrahedra of any size, turned in any way, all around the camera: boxes that reach the
 * near plane or the guard band, or lie askew, say no more than is true of the model. */
static void test_askew(void) {
    static struct vec3 positions[] = {{-1, -1, -1}, {1.5, -0.7, -1}, {0, 1, -0.5}, {0.3, 0.2, 2}};
    static struct face faces[4];
    static const uint32_t corners[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    struct model tetrahedron = plain_model(positions, 4, faces, 4, corners);
    struct random random = {6};
    struct trial trial;
    uint64_t hidden = 0, clipped = 0, outside = 0;
    CHECK(trial_begin(&trial));
    for (int frame = 0; frame < 250; frame++) {
        struct mat4 camera = camera_at(random_vec3(&random, 3), random_vec3(&random, 1));
        scene = (struct scene){.name = "askew"};
        for (int i = 0; i < 80; i++) {
            double size = random_real(&random, 0.05, 1.2) * random_real(&random, 0.1, 1);
            add_object(&scene, i % 3 > 0 ? &tetrahedron : &wall, camera, random_vec3(&random, 3),
                       size);
            struct mat4 *to_clip = &scene.objects[i].to_clip;
            *to_clip = mat4_mul(*to_clip,
                                mat4_rotation(random_vec3(&random, 1), random_real(&random, 0, 1)));
        }
        const uint64_t *stats = compare(&trial, &scene, (enum cull)(frame % 3), shaders[frame % 3]);
        check_counters(&scene, stats, trial.all.stats);
        hidden += stats[STAT_CALLS_HIDDEN];
        clipped += stats[STAT_FACES_CLIPPED];
        outside += stats[STAT_CALLS_OUTSIDE];
    }
    CHECK(hidden > 1500 && clipped > 600);
    CHECK(outside >= 12435); /* all that are found: a side less makes it 12424 or fewer */
    trial_end(&trial);
}

/* A row of a matrix with `value` at the center, and near it something like that: though its terms
 * are large there. */
static void make_row(double row[4], struct vec3 step, struct vec3 center, double value) {
    row[0] = step.x, row[1] = step.y, row[2] = step.z;
    row[3] = value - vec3_dot(step, center);
}

/* Triangles far from the origin of their space, in the plane of a wall: their computed depths are
 * those of the wall up to large roundings. What of them is before the wall is seen, whatever their
 * box says. */
static void test_within_roundings_of_a_wall(void) {
    enum { TRIANGLES = 6 };
    static struct vec3 positions[TRIANGLES][3];
    struct face face;
    struct random random = {7};
    struct trial trial;
    CHECK(trial_begin(&trial));
    for (int frame = 0; frame < 500; frame++) {
        struct model models[TRIANGLES];
        double depth = random_real(&random, -1, 1);
        scene = (struct scene){.name = "within roundings of a wall"};
        add_object(&scene, &wall, mat4_identity(), (struct vec3){0, 0, depth}, 1);
        for (int i = 0; i < TRIANGLES; i++) {
            struct vec3 center = random_vec3(&random, 1e6);
            struct mat4 m = {{{0}}};
            make_row(m.m[0], (struct vec3){1, 0, 0}, center, 0);
            make_row(m.m[1], (struct vec3){0, 1, 0}, center, 0);
            make_row(m.m[3], random_vec3(&random, 0.3), center, 1);
            for (int k = 0; k < 4; k++) {
                m.m[2][k] = depth * m.m[3][k];
            }
            positions[i][0] = vec3_add(center, (struct vec3){-0.5, -0.5, 0});
            positions[i][1] = vec3_add(center, (struct vec3){0.5, -0.5, 0});
            positions[i][2] = vec3_add(center, (struct vec3){0, 0.5, 0});
            models[i] = plain_model(positions[i], 3, &face, 1, NULL);
            scene.objects[scene.count++] = (struct object){&models[i], m};
        }
        compare(&trial, &scene, CULL_NONE, &smooth);
    }
    trial_end(&trial);
}

/* A steep face whose upper edge, along the centres of pixels, is a little behind a wall; up to
 * roundings, which may bring pixels of the edge before it. Those are seen. The wall comes first,
 * since a face of its model is near. */
static void test_roundings_within_a_face(void) {
    struct vec3 flagged[] = {{-1, -1, 0}, {1, -1, 0},    {1, 1, 0},    {-1, 1, 0},
                             {0.8, 0, 1}, {0.9, 0.1, 1}, {0.8, 0.1, 1}};
    static const uint32_t corners[3][3] = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}};
    struct face faces[3];
    double top = 2 * 60.5 / HEIGHT - 1;
    struct vec3 steep[] = {{-0.1, -0.9, -1000}, {0.7, top, 0}, {-0.7, top, 0}};
    struct model models[] = {plain_model(flagged, 7, faces, 3, corners),
                             plain_model(steep, 3, faces, 1, corners)};
    struct random random = {8};
    struct trial trial;
    CHECK(trial_begin(&trial));
    for (int frame = 0; frame < 200; frame++) {
        double depth = random_real(&random, 0.1, 0.9);
        steep[1].z = steep[2].z = depth;
        double wall_depth = depth + random_real(&random, 0, 2e-13);
        for (int i = 0; i < 4; i++) {
            flagged[i].z = wall_depth;
        }
        scene = (struct scene){.name = "roundings within a face"};
        add_object(&scene, &models[0], mat4_identity(), origin, 1);
        add_object(&scene, &models[1], mat4_identity(), origin, 1);
        compare(&trial, &scene, CULL_NONE, &smooth);
    }
    trial_end(&trial);
}

UNIT_MAIN(TEST(test_within_roundings_of_a_side), TEST(test_narrow_gaps), TEST(test_rounds),
          TEST(test_askew), TEST(test_within_roundings_of_a_wall),
          TEST(test_roundings_within_a_face))
