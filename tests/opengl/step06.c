/* The triangles of step 6: see lesson.h. */
#include "include_lesson.h"

#include "../../step06_texture/main.c"

#include <string.h>

static const char *left_out(const char *scene) {
    (void)scene;
    return NULL;
}

static bool build_texture(struct drawing *drawing, struct image *image, struct picture *picture,
                          struct error *error) {
    const struct model *model = drawing->model;
    const struct vec3 light = vec3_normalized(drawing->light);
    struct batch settings = parallel_batch(
        LOOK_NEAREST, (struct rectangle){0, 0, (int)image->width, (int)image->height});
    settings.values.diffuse_map = drawing->diffuse;
    struct batch *batch = picture_add_batch(picture, &settings, error);
    for (size_t face = 0; batch != NULL && face < model->face_count; face++) {
        double intensity = model_face_intensity(model, face, light);
        struct vertex vertices[3];
        if (!(intensity > 0) || !place_face(model, face, image, vertices)) {
            continue;
        }
        struct corner_data corners[3];
        for (size_t i = 0; i < 3; i++) {
            corners[i] = (struct corner_data){
                .position = model_position(model, face, i),
                .placed = {vertices[i].position, parallel_depth(vertices[i].depth), 1},
                .varyings = {vertices[i].uv.x, vertices[i].uv.y, intensity},
            };
        }
        if (!batch_add_face(batch, face, corners, error)) {
            return false;
        }
    }
    return batch != NULL;
}

/* place_on_plane() as a matrix: from (side, distance, 0) to clip space, with w the distance. */
static struct mat4 plane_to_clip(void) {
    return (struct mat4){{{PLANE_COSINE, 0, 0, PLANE_SINE * PLANE_BELOW},
                          {PLANE_SINE, 0.5, 0, -PLANE_COSINE * PLANE_BELOW},
                          {0, 0, 0, NEAR_W},
                          {0, 1, 0, 0}}};
}

static bool build_checker(struct drawing *drawing, struct image *image, struct picture *picture,
                          struct error *error) {
    static const int triangles[2][3] = {{0, 1, 2}, {0, 2, 3}};
    const struct state *state = drawing->state;
    struct vertex plane[4];
    struct batch settings = {
        .look = LOOK_CHECKER,
        .values = {.diffuse_map = &state->checker},
        .viewport = {0, 0, (int)image->width, (int)image->height},
        .to_clip = plane_to_clip(),
    };
    struct batch *batch = picture_add_batch(picture, &settings, error);
    place_plane(image, plane);
    for (size_t t = 0; batch != NULL && t < 2; t++) {
        struct corner_data corners[3];
        for (int i = 0; i < 3; i++) {
            const struct vertex *v = &plane[triangles[t][i]];
            corners[i] = (struct corner_data){
                .position = {v->uv.x, v->uv.y, 0},
                .placed = {v->position, NEAR_W * v->recip_w, v->recip_w},
                .varyings = {v->uv.x, v->uv.y},
            };
        }
        if (!batch_add_face(batch, t, corners, error)) {
            return false;
        }
    }
    return batch != NULL;
}

static bool build(const char *scene, struct drawing *drawing, struct image *image,
                  struct picture *picture, struct error *error) {
    return strcmp(scene, "texture") == 0 ? build_texture(drawing, image, picture, error)
                                         : build_checker(drawing, image, picture, error);
}

lesson_function lesson_step06;
struct lesson lesson_step06(void) {
    const struct program *program = NULL;
    lesson_main(0, (char **)&program);
    return (struct lesson){program, 0, NULL, left_out, NULL, build, NULL};
}
