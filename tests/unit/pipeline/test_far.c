/* The same scene at the origin and far from it: the model and the camera are moved together. */
#include "files/model_file.h"
#include "oracle/oracle.h"
#include "unit/frames.h"

#include <stdlib.h>

enum { SIDE = 128, FACES = 400 };

/* ---- The model, as text ---- */

/* Triangles in -1..1 at whole `steps` of length, all coordinates moved by a whole number. Written
 * exactly, so that whatever is lost is lost in reading. */
static bool make_model(struct model *model, int steps, const char *digits, int64_t offset) {
    struct random random = {61};
    struct bytes text = {0};
    struct error error;
    char line[120];
    bool done = true;
    for (int i = 0; i < 9 * FACES; i++) {
        int64_t place = random_between(&random, -steps, steps) + offset * steps;
        char number[40];
        snprintf(number, sizeof number, digits, (double)place / steps);
        int length = snprintf(line, sizeof line, "%s%s%s", i % 3 == 0 ? "v " : " ", number,
                              i % 3 == 2 ? "\n" : "");
        done = done && bytes_append(&text, line, (size_t)length);
    }
    for (int i = 0; i < FACES; i++) {
        int length = snprintf(line, sizeof line, "f %d %d %d\n", 3 * i + 1, 3 * i + 2, 3 * i + 3);
        done = done && bytes_append(&text, line, (size_t)length);
    }
    done = done && model_decode(model, text.data, text.size, &error);
    bytes_free(&text);
    return CHECK(done);
}

/* ---- Its picture ---- */

static void light_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct model *model = *(const struct model *const *)uniforms;
    (void)corner;
    varyings[0] = fabs(model_face_intensity(model, face, (struct vec3){0, 0, -1}));
    varyings[1] = (double)(face % 256);
}

static lanes_mask light_fragment(const void *uniforms, const lanes *varyings, lanes_texel *color) {
    (void)uniforms;
    *color = lanes_rgb(varyings[0] * 255, varyings[1], lanes_all(255));
    return lanes_all_set();
}

SHADER(light_shader, .varying_count = 2, .flat = true, .vertex = light_vertex,
       .fragment = light_fragment);

/* The camera stands at `eye` when the model is at the origin, and looks at its middle. */
static void draw(struct target *target, const struct model *model, struct vec3 eye,
                 int64_t offset) {
    const struct vec3 center = {(double)offset, (double)offset, (double)offset};
    struct draw_call call =
        camera_call(model, vec3_add(eye, center), center, (struct vec3){0, 1, 0}, 0.7,
                    (struct rectangle){0, 0, SIDE, SIDE}, CULL_NONE);
    struct error error;
    CHECK(target_create(target, SIDE, SIDE, IMAGE_BGR));
    CHECK(draw_frame(&target->pipeline, &call, &light_shader, &model, sizeof(void *),
                     &target->image, &error));
}

/* How many pixels differ when all is moved. */
static size_t count_changed(int steps, const char *digits, struct vec3 eye, int64_t offset) {
    struct model here, there;
    struct target place, moved;
    size_t changed = 0, drawn = 0;
    if (make_model(&here, steps, digits, 0) && make_model(&there, steps, digits, offset)) {
        draw(&place, &here, eye, 0);
        draw(&moved, &there, eye, offset);
        for (size_t i = 0; i < SIDE * SIDE; i++) {
            changed += memcmp(place.image.pixels + 3 * i, moved.image.pixels + 3 * i, 3) != 0;
            drawn += place.image.pixels[3 * i] != 0;
        }
        CHECK(drawn > SIDE * SIDE / 4);
        target_free(&place);
        target_free(&moved);
    }
    model_free(&here);
    model_free(&there);
    return changed;
}

static const int64_t offsets[] = {1000, 1024, 1000000, 1 << 20};

/* Coordinates of ten bits after the point, seen along an axis: nothing rounds, nothing changes. */
static void test_nothing_rounds(void) {
    for (int i = 0; i < 4; i++) {
        CHECK(count_changed(1024, "%.10f", (struct vec3){0, 0, 4}, offsets[i]) == 0);
        CHECK(count_changed(1024, "%.10f", (struct vec3){4, 0, 0}, offsets[i]) == 0);
    }
}

/* Decimal coordinates, seen from anywhere: rounded to 2^-53 of the distance from the origin. A
 * corner rarely gets another of 256 places within its pixel. */
static void test_few_pixels_change(void) {
    for (int i = 0; i < 4; i++) {
        CHECK(count_changed(1000, "%.3f", (struct vec3){1, 2, 3}, offsets[i]) <= 8);
    }
}

UNIT_MAIN(TEST(test_nothing_rounds), TEST(test_few_pixels_change))
