/* Lesson 4 under the mouse: ways to find the light of a face. */
#ifndef LESSON
#define LESSON "../step04_flat/main.c"
#endif
#include "more_scenes.h"

#include "../../../step04_flat/attempts.h"

static const struct scene_value live_values[] = {
    {"attempt",
     "0 face_intensity(), 1 not normalized, 2 inward, 3 absolute, 4 in float, 5 a guessed root, "
     "6 one Newton step, 7 two",
     0, 7, 1, 0},
    {.name = NULL},
};

/* By an attempt, or by what the lesson writes. */
static double live_intensity(const struct model *model, size_t face, struct vec3 to_light,
                             int attempt) {
    static intensity_function *const attempts[] = {
        attempt_1_not_normalized, attempt_2_inward, attempt_3_absolute, attempt_4_float,
        attempt_5_root_0,         attempt_6_root_1, attempt_7_root_2,
    };
    return attempt == 0 ? face_intensity(model, face, to_light)
                        : attempts[attempt - 1](model_position(model, face, 0),
                                                model_position(model, face, 1),
                                                model_position(model, face, 2), to_light);
}

static bool live_flat(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct model *model = drawing->model;
    const struct vec3 to_light = vec3_scale(vec3_normalized(drawing->light), -1);
    const int attempt = (int)drawing_value(drawing, "attempt");
    uint64_t unlit = 0, too_far = 0;
    for (size_t face = 0; face < model->face_count; face++) {
        struct vertex vertices[3] = {{{0, 0}}};
        const double intensity = live_intensity(model, face, to_light, attempt);
        if (!(intensity > 0)) {
            unlit++;
        } else if (!place_face(model, face, image, vertices)) {
            too_far++;
        } else {
            triangle(image, vertices, color_grey(level_from(intensity * 255)));
        }
    }
    drawing_count(drawing, "faces", model->face_count);
    drawing_count(drawing, "faces_unlit", unlit);
    drawing_count(drawing, "faces_too_far", too_far);
    return true;
}

static bool live_side(struct drawing *drawing, struct image *image, struct error *error) {
    return live_flat(drawing, image, error) && draw_more_faces(drawing, image, live_flat, error);
}

static const struct scene live[] = {
    {.name = "flat", .values = live_values, .draw = live_flat},
    {.name = "side", .values = live_values, .draw = live_side},
};

MAIN_WITH(live)
