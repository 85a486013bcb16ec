/* The triangles of step 7: see compared.h. */
#include "bench/opengl/compared.h"

#define LESSON "../step07_gouraud/main.c"
#include "lesson.h"

#include <string.h>

static const char *left_out(const char *scene) {
    return strcmp(scene, "lit") == 0 ? "the powers in the corner" : NULL;
}

static bool draw_clay(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    draw_lit_as(drawing, image, &clay);
    return true;
}

static draw_function *rest(const char *scene) {
    (void)scene;
    return draw_clay;
}

/* What is interpolated from a corner; without lighting its colour. */
static void set_varyings(const struct model *model, size_t face, size_t corner,
                         const struct lighting *lighting, double varyings[3]) {
    if (lighting == NULL) {
        struct vec3 color = model_color(model, face, corner);
        varyings[0] = color.x;
        varyings[1] = color.y;
        varyings[2] = color.z;
        return;
    }
    struct known_corner known = {0};
    light_corner(model, face, corner, lighting, &known);
    varyings[0] = lighting->at_points ? known.parts.diffuse : known.intensity;
    varyings[1] = known.parts.specular;
}

/* All faces, drawn into the batch's viewport. */
static bool add_faces(struct batch *batch, const struct model *model,
                      const struct lighting *lighting, struct error *error) {
    const struct rectangle *panel = &batch->viewport;
    const struct canvas canvas = {.width = (size_t)panel->width, .height = (size_t)panel->height};
    for (size_t face = 0; face < model->face_count; face++) {
        struct vertex vertices[3];
        struct corner_data corners[3];
        if (!place_face(model, face, &canvas, vertices)) {
            continue;
        }
        for (size_t i = 0; i < 3; i++) {
            struct fixed2 screen = vertices[i].position;
            corners[i] = (struct corner_data){
                .position = model_position(model, face, i),
                .placed = {{screen.x + panel->x * SUBPIXELS, screen.y + panel->y * SUBPIXELS},
                           parallel_depth(vertices[i].depth),
                           1},
            };
            set_varyings(model, face, i, lighting, corners[i].varyings);
        }
        if (!batch_add_face(batch, face, corners, error)) {
            return false;
        }
    }
    return true;
}

/* All faces over the whole image. */
static bool build_whole(enum look look, const struct lighting *lighting,
                        const struct drawing *drawing, const struct image *image,
                        struct picture *picture, struct error *error) {
    struct batch settings =
        parallel_batch(look, (struct rectangle){0, 0, (int)image->width, (int)image->height});
    settings.cull = CULL_BACK;
    struct batch *batch = picture_add_batch(picture, &settings, error);
    return batch != NULL && add_faces(batch, drawing->model, lighting, error);
}

static bool build_lit(struct drawing *drawing, const struct material *material, struct image *image,
                      struct picture *picture, struct error *error) {
    const struct lighting lighting = {
        .at_points = true, .light = drawing->light, .camera = drawing->eye, .material = material};
    int width = (int)image->width / 2, height = (int)image->height / 2;
    for (size_t i = 0; i < PANEL_COUNT; i++) {
        const struct panel *panel = &panels[i];
        struct batch settings =
            parallel_batch(LOOK_LIT, (struct rectangle){panel->column * width, panel->row * height,
                                                        width, height});
        settings.cull = CULL_BACK;
        settings.values = (struct look_values){
            .ambient = panel->ambient * material->ambient,
            .diffuse = panel->diffuse,
            .specular = panel->specular,
            .color = material->surface_color,
            .light_color = material->light_color,
        };
        struct batch *batch = picture_add_batch(picture, &settings, error);
        if (batch == NULL || !add_faces(batch, drawing->model, &lighting, error)) {
            return false;
        }
    }
    return true;
}

static bool build(const char *scene, struct drawing *drawing, struct image *image,
                  struct picture *picture, struct error *error) {
    const struct lighting lighting = {.light = vec3_normalized(drawing->light)};
    if (strcmp(scene, "lit") == 0 || strcmp(scene, "behind") == 0) {
        const struct material *material = strcmp(scene, "lit") == 0 ? &clay : &satin;
        return build_lit(drawing, material, image, picture, error);
    }
    return strcmp(scene, "colors") == 0
               ? build_whole(LOOK_COLORS, NULL, drawing, image, picture, error)
               : build_whole(LOOK_WHITE, &lighting, drawing, image, picture, error);
}

const struct lesson lesson_step07 = {
    .program = &step07_gouraud,
    .left_out = left_out,
    .rest = rest,
    .build = build,
};
