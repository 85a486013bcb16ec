/* The triangles of step 4: see compared.h. */
#include "bench/opengl/compared.h"

#define LESSON "../step04_flat/main.c"
#include "lesson.h"

static const char *left_out(const char *scene) {
    return strcmp(scene, "side") == 0 ? "faces that are not the model's" : NULL;
}

static draw_function *rest(const char *scene) {
    (void)scene;
    return draw_flat;
}

static bool build(const char *scene, struct drawing *drawing, struct image *image,
                  struct picture *picture, struct error *error) {
    (void)scene;
    const struct model *model = drawing->model;
    const struct vec3 light = vec3_normalized(drawing->light);
    struct batch settings =
        parallel_batch(LOOK_WHITE, (struct rectangle){0, 0, (int)image->width, (int)image->height});
    settings.depth_test = false;
    struct batch *batch = picture_add_batch(picture, &settings, error);
    for (size_t face = 0; batch != NULL && face < model->face_count; face++) {
        double intensity = face_intensity(model, face, light);
        struct vertex vertices[3];
        if (!(intensity > 0) || !place_face(model, face, image, vertices)) {
            continue;
        }
        struct corner_data corners[3];
        for (size_t i = 0; i < 3; i++) {
            struct vec3 world = model_position(model, face, i);
            corners[i] = (struct corner_data){
                .position = world,
                .placed = {vertices[i].position, parallel_depth(world.z), 1},
                .varyings = {intensity},
            };
        }
        if (!batch_add_face(batch, face, corners, error)) {
            return false;
        }
    }
    return batch != NULL;
}

const struct lesson lesson_step04 = {
    .program = &step04_flat,
    .left_out = left_out,
    .rest = rest,
    .build = build,
};
