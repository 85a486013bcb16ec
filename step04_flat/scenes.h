/*
 * Step 4, the given part: its scenes and the program.
 *
 * `flat` draws a model from the front, in the order of the file; `side` does the same with a light
 * that comes from the left and from above, in an image that is not square, and has two faces more:
 * one reaches too far for the screen, and nothing of it is drawn; one leaves the image. Faces on
 * which no light falls are not drawn. With the light in the viewer's direction these are the faces
 * that show their backs; what lies behind something else is still painted over it: that is lesson
 * 5.
 */

static bool draw_flat(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct model *model = drawing->model;
    const struct vec3 light = vec3_normalized(drawing->light);
    uint64_t unlit = 0, too_far = 0;
    for (size_t face = 0; face < model->face_count; face++) {
        struct vertex vertices[3] = {{{0, 0}}};
        double intensity = face_intensity(model, face, light);
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

static bool draw_side(struct drawing *drawing, struct image *image, struct error *error) {
    struct vec3 positions[] = {{-0.95, 0.5, 0},   {-0.6, 0.9, 0}, {-1e9, 0.9, 0},
                               {-0.95, -0.15, 0}, {-0.7, 0.2, 0}, {-1.3, 0.25, 0.3}};
    struct face faces[2] = {0};
    for (uint32_t i = 0; i < 6; i++) {
        faces[i / 3].corner[i % 3] = (struct corner){i, MODEL_NONE, MODEL_NONE};
    }
    const struct model beyond = {
        .positions = positions, .position_count = 6, .faces = faces, .face_count = 2};
    const struct model *model = drawing->model;
    bool done = draw_flat(drawing, image, error);
    drawing->model = &beyond;
    done = done && draw_flat(drawing, image, error);
    drawing->model = model;
    return done;
}

static const struct scene scenes[] = {
    {.name = "flat", .needs = NEEDS_MODEL, .draw = draw_flat},
    {.name = "side",
     .needs = NEEDS_MODEL,
     .width = 719, /* odd, and not the height: who halves or exchanges them sees it */
     .height = 797,
     .light = {0.4, -0.25, -1},
     .draw = draw_side},
};

int main(int argc, char **argv) {
    static const struct program program = {
        .name = "step04_flat",
        .summary = "one grey for each face, from its normal and the light",
        .takes_light = true,
        .defaults = {.width = 800, .height = 800, .light = {0, 0, -1}},
        .scenes = scenes,
        .scene_count = sizeof scenes / sizeof scenes[0],
    };
    return program_main(&program, argc, argv);
}
