/*
 * Lesson 4, the given part: its scenes and the program.
 *
 * `flat` draws a model from the front, in the order of the file; `side` does the same with a light
 * that comes from the left and from above, in an image that is not square, and has more faces:
 * three reach too far for the screen, and nothing of them is drawn; four leave the image, one looks
 * away and is lit from behind, and many are smaller than a pixel. Faces on which no light falls are
 * not drawn. With the light in the viewer's direction these are the faces that show their backs;
 * what lies behind something else is still painted over it: that is lesson 5. `wide` and `high`
 * draw models in images of other shapes, `small` and `one_pixel` faces that cover all of theirs.
 */

#include "attempts.h"

static const struct scene_value flat_values[] = {
    {"attempt",
     "0 face_intensity(), 1 not normalized, 2 inward, 3 absolute, 4 in float, 5 a guessed root, "
     "6 one Newton step, 7 two",
     0, 7, 1, 0},
    {.name = NULL},
};

/* By an attempt, or by what the lesson writes. */
static double intensity_of(const struct model *model, size_t face, struct vec3 to_light,
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

static bool draw_flat(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct model *model = drawing->model;
    const struct vec3 to_light = vec3_scale(vec3_normalized(drawing->light), -1);
    const int attempt = (int)drawing_value(drawing, "attempt");
    uint64_t unlit = 0, too_far = 0;
    for (size_t face = 0; face < model->face_count; face++) {
        struct vertex vertices[3] = {{{0, 0}}};
        double intensity = intensity_of(model, face, to_light, attempt);
        bool lit = intensity > 0;
        unlit += !lit;
        if (!lit && drawing->skip) {
            continue; /* it will not be drawn: where it lies does not matter */
        }
        bool placed = place_face(model, face, image, vertices);
        too_far += lit && !placed;
        if (placed && lit) {
            triangle(image, vertices, color_grey(level_from(intensity * 255)));
        }
    }
    drawing_count(drawing, "faces", model->face_count);
    drawing_count(drawing, "faces_unlit", unlit);
    drawing_count(drawing, "faces_too_far", too_far);
    return true;
}

/* A model of one face. */
static struct model one_face(struct vec3 corners[3]) {
    static struct face face = {
        {{0, MODEL_NONE, MODEL_NONE}, {1, MODEL_NONE, MODEL_NONE}, {2, MODEL_NONE, MODEL_NONE}}};
    return (struct model){
        .positions = corners, .position_count = 3, .faces = &face, .face_count = 1};
}

static bool draw_face(struct drawing *drawing, struct image *image, struct vec3 corners[3],
                      struct error *error) {
    const struct model one = one_face(corners), *model = drawing->model;
    drawing->model = &one;
    bool done = draw_flat(drawing, image, error);
    drawing->model = model;
    return done;
}

/* It looks away from us, and light that comes from behind falls on it. */
static bool draw_face_lit_from_behind(struct drawing *drawing, struct image *image,
                                      struct error *error) {
    struct vec3 corners[3] = {{-0.95, 0.95, 0}, {-0.75, 0.95, 0.1}, {-0.95, 0.75, 0}};
    const struct vec3 light = drawing->light;
    drawing->light = (struct vec3){0.2, 0.1, 1};
    bool done = draw_face(drawing, image, corners, error);
    drawing->light = light;
    return done;
}

enum { TINY_SIDE = 36 }; /* of a square of pixels, each with its own face */

/* Faces smaller than a pixel, around the centres of pixels: they are as bright as large ones. */
static bool draw_tiny_faces(struct drawing *drawing, struct image *image, struct error *error) {
    double width = 2 / (double)image->width, height = 2 / (double)image->height; /* of a pixel */
    bool done = true;
    for (int i = 0; done && i < TINY_SIDE * TINY_SIDE; i++) {
        double x = floor(1.82 / width) + i % TINY_SIDE, y = floor(1.55 / height) + i / TINY_SIDE;
        double left = (x + 0.4) * width - 1, low = (y + 0.4) * height - 1;
        struct vec3 corners[3] = {
            {left, low, 0}, {left + 0.3 * width, low, 0}, {left, low + 0.3 * height, 0}};
        done = draw_face(drawing, image, corners, error);
    }
    return done;
}

/* The faces that are not the model's are drawn into all rows but the last one: nothing may be
 * drawn behind the image. */
static bool draw_side(struct drawing *drawing, struct image *image, struct error *error) {
    struct vec3 corners[][3] = {
        {{-0.95, 0.5, 0}, {-0.6, 0.9, 0}, {-1e9, 0.9, 0}},     /* too far: corner 2 */
        {{1e9, 0.9, 0}, {0.6, 0.9, 0}, {0.95, 0.5, 0}},        /* corner 0 */
        {{0.6, -0.3, 0}, {0.8, -1e9, 0}, {0.95, -0.35, 0}},    /* corner 1 */
        {{-0.95, -0.3, 0}, {-0.7, 0.2, 0}, {-1.3, 0.45, 0.3}}, /* leave the image: left */
        {{0.7, 0.1, 0}, {1.3, -0.4, 0.2}, {1.3, 0.7, 0}},      /* right */
        {{-0.5, 0.97, 0}, {0.5, 0.97, 0}, {0, 1.4, -0.2}},     /* above */
        {{-0.9, -0.96, 0}, {0, -1.5, 0.3}, {0.9, -0.96, 0}},   /* below */
    };
    struct image rows = *image;
    rows.height--;
    bool done = draw_flat(drawing, image, error);
    for (size_t i = 0; rows.height > 0 && done && i < sizeof corners / sizeof corners[0]; i++) {
        done = draw_face(drawing, &rows, corners[i], error);
    }
    return done && (rows.height == 0 || (draw_face_lit_from_behind(drawing, &rows, error) &&
                                         draw_tiny_faces(drawing, &rows, error)));
}

/* Three faces of a tent that is larger than the image. */
static bool draw_tent(struct drawing *drawing, struct image *image, struct error *error) {
    const struct vec3 a = {-5, -4, 0}, b = {4, -5, 0}, c = {1, 6, 0}, top = {0.2, 0.1, 4};
    struct vec3 corners[][3] = {{a, b, top}, {b, c, top}, {c, a, top}};
    bool done = true;
    for (size_t i = 0; done && i < sizeof corners / sizeof corners[0]; i++) {
        done = draw_face(drawing, image, corners[i], error);
    }
    return done;
}

static const struct scene scenes[] = {
    {.name = "flat", .needs = NEEDS_MODEL, .values = flat_values, .draw = draw_flat},
    {.name = "side",
     .needs = NEEDS_MODEL,
     .width = 719, /* odd, and not the height: halved or exchanged, it shows */
     .height = 797,
     .light = {0.4, -0.25, -1},
     .values = flat_values,
     .draw = draw_side},
    /* Not square, and odd: a square or a large picture hides some mistakes. */
    {.name = "wide",
     .detail = true,
     .needs = NEEDS_MODEL,
     .width = 203,
     .height = 67,
     .draw = draw_flat},
    {.name = "high",
     .detail = true,
     .needs = NEEDS_MODEL,
     .model = "knot.off",
     .width = 61,
     .height = 181,
     .draw = draw_flat},
    {.name = "small",
     .detail = true,
     .needs = NEEDS_MODEL,
     .width = 23,
     .height = 13,
     .draw = draw_tent},
    {.name = "one_pixel",
     .detail = true,
     .needs = NEEDS_MODEL,
     .width = 1,
     .height = 1,
     .draw = draw_tent},
};

static const struct program step04_flat = {
    .name = "step04_flat",
    .summary = "one grey for each face, from its normal and the light",
    .takes_light = true,
    .defaults = {.width = 800, .height = 800, .light = {0, 0, -1}},
    .scenes = scenes,
    .scene_count = sizeof scenes / sizeof scenes[0],
};
