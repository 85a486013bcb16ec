/* A stage reads of a model only what a scene needs, and once for all scenes of a run: stage.h. */
#include "run/stage.h"

#include "base/file.h"
#include "files/model_file.h"
#include "unit/unit.h"

static bool draw_nothing(struct drawing *drawing, struct image *image, struct error *error) {
    (void)drawing, (void)image, (void)error;
    return true;
}

static const struct program program = {.name = "test",
                                       .defaults = {.width = 8, .height = 8, .draw = draw_nothing}};

/* Puts a scene of these needs on the stage and takes it off; what is loaded is in the run. */
static void stage_once(struct run *run, unsigned needs) {
    const struct scene given = {.name = "scene", .needs = needs, .draw = draw_nothing};
    const struct scene scene = scene_complete(&program, &given);
    struct stage stage;
    struct error error;
    CHECK(stage_begin(&stage, run, &scene, 8, 8, &error));
    stage_end(&stage);
}

static void test_only_what_is_needed(void) {
    uint64_t model_size = file_size(default_model_path);
    CHECK(model_size > 0);
    const struct options none = {.input = NULL};
    struct run run = {.program = &program, .options = &none, .asked = &none};
    stage_once(&run, NEEDS_MODEL);
    CHECK(run.model.uv_count == 0 && run.model.normal_count == 0 && run.model.face_count > 0);
    CHECK(run_loaded(&run).bytes == model_size && run_loaded(&run).textures_read == 0);
    CHECK(run_loaded(&run).textures_present == 3);
    stage_once(&run, NEEDS_MODEL | NEEDS_NORMALS); /* more than was asked for: read again */
    CHECK(run.model.uv_count == 0 && run.model.normal_count > 0);
    CHECK(run_loaded(&run).bytes == 2 * model_size);
    stage_once(&run, NEEDS_MODEL); /* less: it is there */
    CHECK(run.model.normal_count > 0 && run_loaded(&run).bytes == 2 * model_size);
    run_free(&run);
}

static bool same(struct vec3 v, struct vec3 expected) {
    return v.x == expected.x && v.y == expected.y && v.z == expected.z;
}

/* What a scene leaves at zero is the program's; what it says itself is its own. */
static void test_left_at_zero(void) {
    static const struct scene defaults = {.width = 8,
                                          .height = 9,
                                          .eye = {1, 2, 3},
                                          .center = {4, 5, 6},
                                          .up = {7, 8, 9},
                                          .light = {10, 11, 12}};
    static const struct scene own = {.model = "own.obj",
                                     .width = 1,
                                     .height = 2,
                                     .format = IMAGE_GREY,
                                     .frames = 3,
                                     .eye = {0, 0, -1},
                                     .center = {0, -2, 0},
                                     .up = {-3, 0, 0},
                                     .light = {0, 0, -4}};
    const struct program given = {.name = "test", .defaults = defaults};
    const struct scene empty = {.name = "empty"};
    struct scene s = scene_complete(&given, &empty);
    CHECK(s.width == 8 && s.height == 9 && s.format == IMAGE_BGR && s.frames == 1);
    CHECK(same(s.eye, defaults.eye) && same(s.center, defaults.center));
    CHECK(same(s.up, defaults.up) && same(s.light, defaults.light) && s.model != NULL);
    s = scene_complete(&given, &own);
    CHECK(s.width == 1 && s.height == 2 && s.format == IMAGE_GREY && s.frames == 3);
    CHECK(same(s.eye, own.eye) && same(s.center, own.center) && same(s.up, own.up));
    CHECK(same(s.light, own.light) && s.model == own.model);
}

UNIT_MAIN(TEST(test_only_what_is_needed), TEST(test_left_at_zero))
