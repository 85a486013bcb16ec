/* The pictures of step 10's README that are not references, one of them moving. */
#define _POSIX_C_SOURCE 200809L /* clock_gettime */
#include "../tests/bench/figures.h"

#define LESSON "../step10_phong/main.c"
#include "../tests/lesson.h"

#include "attempts.h"
#include "files/model_file.h"
#include "files/normals.h"
#include "files/png.h"

#include <stdlib.h>

enum { PANEL = 320, TURN_SIZE = 128, TURN_DELAY_MS = 40 };

/* The camera of the scenes. */
static struct drawing make_drawing(struct model *model) {
    return (struct drawing){
        .model = model, .eye = {1, 0.5, 3}, .up = {0, 1, 0}, .light = {1, 1, 1}, .skip = true};
}

static bool load_textures(struct drawing *drawing, struct model *model, struct error *error) {
    drawing->diffuse = model_texture(model, MODEL_DIFFUSE, error);
    drawing->normal_map = model_texture(model, MODEL_NORMAL_MAP, error);
    drawing->specular = model_texture(model, MODEL_SPECULAR, error);
    return drawing->diffuse != NULL && drawing->normal_map != NULL && drawing->specular != NULL;
}

/* The function that colours a panel's pixels, and its material. */
struct panel {
    struct shader shader;
    struct material material;
};

/* A shader without loops of its own. */
#define PANEL_SHADER(function)                                                                     \
    { .varying_count = 8, .vertex = vertex_with_normal, .fragment = (function) }

/* How many panels, and what is seen in each: -1..1 around `center`, in `zoom` of the panel. */
struct view {
    int columns, rows;
    struct vec3 center, light;
    double zoom;
};

static bool record_panels(struct pipeline *pipeline, struct drawing *drawing,
                          const struct view *view, const struct panel *panels,
                          struct error *error) {
    bool done = true;
    drawing->light = view->light;
    drawing->center = view->center;
    for (int i = 0; done && i < view->columns * view->rows; i++) {
        struct rectangle cell = grid_cell(pipeline->width, pipeline->height, view->columns,
                                          view->rows, i % view->columns, i / view->columns);
        struct draw_call call = pipeline_call(drawing, cell, view->zoom, CULL_BACK);
        struct uniforms u = make_uniforms(drawing, view->zoom * PANEL, panels[i].material);
        done = pipeline_draw(pipeline, &call, &panels[i].shader, &u, sizeof u, error);
    }
    return done;
}

static bool draw_panels(struct model *model, const struct view *view, const struct panel *panels,
                        const char *directory, const char *name, struct error *error) {
    struct drawing drawing = make_drawing(model);
    struct pipeline pipeline = {0};
    struct image image = {0};
    size_t width = (size_t)(view->columns * PANEL), height = (size_t)(view->rows * PANEL);
    bool done = load_textures(&drawing, model, error) &&
                image_create(&image, width, height, IMAGE_BGR, error) &&
                pipeline_create(&pipeline, width, height, error) &&
                record_panels(&pipeline, &drawing, view, panels, error) &&
                pipeline_finish(&pipeline, &image, error) &&
                figure_save(&image, directory, name, error);
    image_free(&image);
    pipeline_free(&pipeline);
    return done;
}

/* Left: the light of lesson 9. Right: that of this one. */
static bool draw_chalk(struct model *model, const char *directory, struct error *error) {
    static const struct material chalk = {0, 1, 0, 10, {255, 255, 255}};
    const struct view view = {2, 1, {0, 0, 0}, {1, 0.6, -0.1}, 0.9};
    const struct panel panels[] = {{PANEL_SHADER(full_fragment), chalk},
                                   {PANEL_SHADER(weight_map_fragment), textured_material}};
    return draw_panels(model, &view, panels, directory, "chalk", error);
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

/* Where the light of the scenes makes the largest spots, from near. */
static const struct vec3 shoulder = {0.35, -0.45, 0.1};

/* The specular part alone: power 10, and Schlick's form of it. */
static bool draw_schlick(struct model *model, const char *directory, struct error *error) {
    static const struct material bright = {0, 0, 1, 10, {255, 255, 255}};
    const struct view view = {2, 1, {0, 0, 0}, {1, 1, 1}, 0.9};
    const struct panel panels[] = {{PANEL_SHADER(plain_fragment), bright},
                                   {PANEL_SHADER(schlick_fragment), bright}};
    return draw_panels(model, &view, panels, directory, "schlick", error);
}

/* The specular part alone, from near: six powers. */
static bool draw_near(struct model *model, const char *directory, struct error *error) {
    static const int powers[] = {1, 3, 5, 10, 20, 80};
    const struct view view = {3, 2, shoulder, {1, 1, 1}, 2};
    struct panel panels[6];
    for (int i = 0; i < 6; i++) {
        panels[i] =
            (struct panel){PANEL_SHADER(plain_fragment), {0, 0, 1, powers[i], {255, 255, 255}}};
    }
    return draw_panels(model, &view, panels, directory, "powers_near", error);
}

/* Normalised or not, from near, where a high power makes a small difference large. */
static bool draw_normals(struct model *model, const char *directory, struct error *error) {
    static const struct material bright = {0, 0, 1, 40, {255, 255, 255}};
    const struct view view = {2, 1, shoulder, {1, 1, 1}, 2};
    const struct panel panels[] = {{PANEL_SHADER(plain_fragment), bright},
                                   {PANEL_SHADER(attempt_5_not_normalized), bright}};
    return draw_panels(model, &view, panels, directory, "not_normalized", error);
}

/* The three textures of the model, an eighth of their size. */
static bool draw_textures(struct model *model, const char *directory, struct error *error) {
    static const enum model_texture_kind kinds[] = {MODEL_DIFFUSE, MODEL_NORMAL_MAP,
                                                    MODEL_SPECULAR};
    struct image image = {0};
    bool done = image_create(&image, 3 * 256, 256, IMAGE_BGR, error);
    for (int k = 0; done && k < 3; k++) {
        const struct texture *texture = model_texture(model, kinds[k], error);
        done = texture != NULL;
        for (int i = 0; done && i < 256 * 256; i++) {
            uint32_t texel = texture_texel(&texture->level[2], (size_t)i % 256, (size_t)i / 256);
            image_set(&image, 256 * k + i % 256, i / 256,
                      color_rgb((uint8_t)(texel >> 16), (uint8_t)(texel >> 8), (uint8_t)texel));
        }
    }
    done = done && figure_save(&image, directory, "textures", error);
    image_free(&image);
    return done;
}

/* The frames of scene `turn`, each an image of its own. */
static bool draw_frames(struct model *model, struct image frames[TURN_FRAMES],
                        struct error *error) {
    struct pipeline pipeline = {0};
    struct drawing drawing = make_drawing(model);
    drawing.state = &pipeline;
    bool done = load_textures(&drawing, model, error) &&
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

#include "figures_extra.h"

bool draw_figures(const char *directory, struct model *bust, struct error *error) {
    return model_need_normals(bust, error) && draw_textures(bust, directory, error) &&
           draw_chalk(bust, directory, error) && draw_near(bust, directory, error) &&
           draw_normals(bust, directory, error) && draw_schlick(bust, directory, error) &&
           draw_animation(bust, directory, error) && draw_shadow_figure(bust, directory, error) &&
           print_shadow_table(bust, error) && show_samples(bust, directory, error);
}
