/* The triangles of step 5: see compared.h. */
#include "bench/opengl/compared.h"

#define LESSON "../step05_zbuffer/main.c"
#include "lesson.h"

#include <string.h>

static const char *left_out(const char *scene) {
    return strcmp(scene, "rows") == 0     ? "all of it: rows of pixels, no triangles"
           : strcmp(scene, "cards") == 0  ? "all of it: depths of one plane, no model"
           : strcmp(scene, "single") == 0 ? "all of it: pixels, no model"
           : strcmp(scene, "deep") == 0   ? "all of it: the depths of each half, and four more"
                                          : NULL;
}

static bool build(const char *scene, struct drawing *drawing, struct image *image,
                  struct picture *picture, struct error *error) {
    const struct model *model = drawing->model;
    const struct vec3 light = vec3_normalized(drawing->light);
    struct batch settings =
        parallel_batch(LOOK_WHITE, (struct rectangle){0, 0, (int)image->width, (int)image->height});
    picture->shows_depth = strcmp(scene, "depth") == 0 || strcmp(scene, "deep") == 0;
    struct batch *batch = picture_add_batch(picture, &settings, error);
    for (size_t face = 0; batch != NULL && face < model->face_count; face++) {
        double intensity = model_face_intensity(model, face, light);
        struct vertex vertices[3];
        if (!(intensity > 0) || !place_face(model, face, image, vertices)) {
            continue;
        }
        struct corner_data corners[3];
        for (size_t i = 0; i < 3; i++) {
            struct vec3 world = model_position(model, face, i);
            corners[i] = (struct corner_data){
                .position = world,
                .placed = {vertices[i].position, parallel_depth(vertices[i].depth), 1},
                .varyings = {intensity},
            };
        }
        if (!batch_add_face(batch, face, corners, error)) {
            return false;
        }
    }
    return batch != NULL;
}

/* The depth picture is drawn over everything, so that only the depth tells. */
static bool covered(const struct drawing *drawing, const struct image *image, size_t pixel) {
    (void)image;
    return drawing->depth[pixel] > -INFINITY;
}

const struct lesson lesson_step05 = {
    .program = &step05_zbuffer,
    .left_out = left_out,
    .build = build,
    .covered = covered,
};
