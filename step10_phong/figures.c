/* The pictures of step 10's README that are not references, one of them moving. */
#include "../tests/figures.h"
#define main step_main
#include "main.c"
#undef main

#include "attempts.h"
#include "model_file.h"
#include "normals.h"
#include "png.h"

#include <stdlib.h>

enum { PANEL = 320, TURN_SIZE = 128, TURN_DELAY_MS = 40 };

/* The camera of the scenes with the light from the left and behind the head's side. */
static struct drawing make_drawing(struct model *model) {
    return (struct drawing){.model = model,
                            .eye = {1, 0.5, 3},
                            .up = {0, 1, 0},
                            .light = {-1, 0.6, -0.2},
                            .skip = true};
}

/* A row of panels, each with the function that colours its pixels. */
struct panel {
    struct shader shader;
    struct material material;
};

/* A shader without loops of its own. */
#define PANEL_SHADER(function)                                                                     \
    { .varying_count = 8, .vertex = vertex_with_normal, .fragment = (function) }

static bool draw_panels(struct model *model, const struct panel *panels, int count,
                        struct vec3 light, const char *directory, const char *name,
                        struct error *error) {
    struct drawing drawing = make_drawing(model);
    struct pipeline pipeline = {0};
    struct image image = {0};
    drawing.light = light;
    size_t width = (size_t)(count * PANEL);
    bool done = image_create(&image, width, PANEL, IMAGE_BGR, error) &&
                pipeline_create(&pipeline, width, PANEL, error);
    for (int i = 0; done && i < count; i++) {
        struct draw_call call =
            pipeline_call(&drawing, grid_cell(width, PANEL, count, 1, i, 0), 0.9, CULL_BACK);
        struct uniforms u = make_uniforms(&drawing, PANEL, panels[i].material);
        done = pipeline_draw(&pipeline, &call, &panels[i].shader, &u, sizeof u, error);
    }
    done = done && pipeline_finish(&pipeline, &image, error) &&
           figure_save(&image, directory, name, error);
    image_free(&image);
    pipeline_free(&pipeline);
    return done;
}

/* The three parts and their sum. */
static bool draw_parts(struct model *model, const char *directory, struct error *error) {
    static const struct vec3 color = {255, 128, 255};
    struct panel panels[] = {{PANEL_SHADER(plain_fragment), {0.1, 0, 0, 10, color}},
                             {PANEL_SHADER(plain_fragment), {0, 1, 0, 10, color}},
                             {PANEL_SHADER(plain_fragment), {0, 0, 0.5, 10, color}},
                             {PANEL_SHADER(plain_fragment), plain_material}};
    return draw_panels(model, panels, 4, (struct vec3){1, 1, 1}, directory, "parts", error);
}

/* Right; not normalised; not clamped; light reversed. */
static bool draw_wrong(struct model *model, const char *directory, struct error *error) {
    struct panel panels[] = {{PANEL_SHADER(plain_fragment), plain_material},
                             {PANEL_SHADER(attempt_5_not_normalized), plain_material},
                             {PANEL_SHADER(attempt_6_not_clamped), plain_material},
                             {PANEL_SHADER(attempt_7_light_reversed), plain_material}};
    return draw_panels(model, panels, 4, (struct vec3){-1, 0.6, -0.2}, directory, "wrong_light",
                       error);
}

static lanes_mask schlick_fragment(const void *uniforms, const lanes *varyings,
                                   lanes_texel *color) {
    const struct uniforms *u = uniforms;
    struct surface surface = plain_surface(u, varyings);
    struct lanes3 normal = mesh_normal(varyings), to_light = lanes3_all(u->to_light);
    struct lanes3 to_eye = lanes3_normalized(surface.to_eye);
    lanes zero = lanes_all(0), diffuse = lanes3_dot(normal, to_light);
    lanes mirrored = lanes_max(lanes3_dot(reflect(normal, to_light), to_eye), zero);
    lanes shine = attempt_4_schlick(mirrored, u->material.power);
    lanes level = lanes_select(diffuse > 0, 255 * surface.specular * shine, zero);
    *color = lanes_rgb(level, level, level);
    return lanes_all_set();
}

static lanes_mask specular_fragment(const void *uniforms, const lanes *varyings,
                                    lanes_texel *color) {
    const struct uniforms *u = uniforms;
    struct surface surface = plain_surface(u, varyings);
    struct lanes2 light =
        phong(mesh_normal(varyings), lanes3_all(u->to_light), lanes3_normalized(surface.to_eye),
              surface.power, surface.largest_power);
    lanes level = 255 * surface.specular * light.y;
    *color = lanes_rgb(level, level, level);
    return lanes_all_set();
}

/* The specular part alone: power 10, and Schlick's form of it. */
static bool draw_schlick(struct model *model, const char *directory, struct error *error) {
    static const struct material bright = {0, 0, 1, 10, {255, 255, 255}};
    struct panel panels[] = {{PANEL_SHADER(specular_fragment), bright},
                             {PANEL_SHADER(schlick_fragment), bright}};
    return draw_panels(model, panels, 2, (struct vec3){1, 1, 1}, directory, "schlick", error);
}

/* The frames of scene `turn`, each an image of its own. */
static bool draw_frames(struct model *model, struct image frames[TURN_FRAMES],
                        struct error *error) {
    struct pipeline pipeline = {0};
    struct drawing drawing = make_drawing(model);
    drawing.diffuse = model_texture(model, MODEL_DIFFUSE, error);
    drawing.normal_map = model_texture(model, MODEL_NORMAL_MAP, error);
    drawing.specular = model_texture(model, MODEL_SPECULAR, error);
    drawing.state = &pipeline;
    bool done = drawing.diffuse != NULL && drawing.normal_map != NULL && drawing.specular != NULL &&
                pipeline_create(&pipeline, TURN_SIZE, TURN_SIZE, error);
    for (size_t i = 0; done && i < TURN_FRAMES; i++) {
        drawing.frame = i;
        done = image_create(&frames[i], TURN_SIZE, TURN_SIZE, IMAGE_BGR, error) &&
               draw_turn(&drawing, &frames[i], error);
    }
    pipeline_free(&pipeline);
    return done;
}

/* The scene `turn` as a small animation. */
static bool draw_animation(struct model *model, const char *directory, struct error *error) {
    struct image frames[TURN_FRAMES] = {{0}};
    char *path = figure_path(directory, "turn", error);
    bool done = path != NULL && draw_frames(model, frames, error) &&
                apng_write(frames, TURN_FRAMES, TURN_DELAY_MS, path, error);
    for (size_t i = 0; i < TURN_FRAMES; i++) {
        image_free(&frames[i]);
    }
    free(path);
    return done;
}

bool draw_figures(const char *directory, struct model *bust, struct error *error) {
    return model_need_normals(bust, error) && draw_parts(bust, directory, error) &&
           draw_wrong(bust, directory, error) && draw_schlick(bust, directory, error) &&
           draw_animation(bust, directory, error);
}
