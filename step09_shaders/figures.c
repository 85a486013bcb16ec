/* The pictures of lesson 9's README that are not references. */
#include "../tests/bench/figures.h"

#define LESSON "../step09_shaders/main.c"
#include "../tests/lesson.h"

#include "files/model_file.h"

#include <stdlib.h>

enum { PANEL = 400 };

/* Where all figures are drawn from: the scenes' camera, with the light from the side. */
static bool make_drawing(struct drawing *drawing, struct model *model, struct error *error) {
    *drawing = (struct drawing){
        .model = model,
        .diffuse = model_texture(model, MODEL_DIFFUSE, error),
        .normal_map = model_texture(model, MODEL_NORMAL_MAP, error),
        .eye = {1, 0.5, 3},
        .up = {0, 1, 0},
        .light = {1, 0.2, 0},
        .skip = true,
    };
    return drawing->diffuse != NULL && drawing->normal_map != NULL;
}

struct figure {
    struct drawing drawing;
    struct pipeline pipeline;
    struct image image;
    struct uniforms uniforms;
};

static bool figure_begin(struct figure *figure, struct model *model, int panels,
                         struct error *error) {
    size_t width = (size_t)(panels * PANEL);
    bool done = make_drawing(&figure->drawing, model, error) &&
                image_create(&figure->image, width, PANEL, IMAGE_BGR, error) &&
                pipeline_create(&figure->pipeline, width, PANEL, error);
    figure->uniforms = make_uniforms(&figure->drawing, PANEL);
    return done;
}

static struct draw_call figure_call(const struct figure *figure, int panels, int panel) {
    struct rectangle cell =
        grid_cell(figure->image.width, figure->image.height, panels, 1, panel, 0);
    return pipeline_call(&figure->drawing, cell, 0.85, CULL_BACK);
}

static bool figure_draw(struct figure *figure, const struct draw_call *call,
                        const struct shader *shader, struct error *error) {
    return pipeline_draw(&figure->pipeline, call, shader, &figure->uniforms,
                         sizeof figure->uniforms, error);
}

/* Finish the figure and save it, if all of it was `recorded`; free it. */
static bool figure_end(struct figure *figure, const char *directory, const char *name,
                       bool recorded, struct error *error) {
    bool done = recorded && pipeline_finish(&figure->pipeline, &figure->image, error) &&
                figure_save(&figure->image, directory, name, error);
    image_free(&figure->image);
    pipeline_free(&figure->pipeline);
    return done;
}

/* Left: culled by the camera. Right: by the light, over red, so that holes are seen. */
static bool draw_culled_by_light(struct model *model, const char *directory, struct error *error) {
    struct figure f = {0};
    bool done = figure_begin(&f, model, 2, error);
    if (done) {
        image_clear(&f.image, color_rgb(160, 0, 0));
        struct draw_call right = figure_call(&f, 2, 0), wrong = figure_call(&f, 2, 1);
        wrong.cull = CULL_NONE;
        done = figure_draw(&f, &right, &flat, error) &&
               figure_draw(&f, &wrong, &culled_by_light, error);
    }
    return figure_end(&f, directory, "culled_by_light", done, error);
}

/* Left: the normals of the mesh, as in lesson 8. Right: those of the map. */
static bool draw_smooth(struct model *model, const char *directory, struct error *error) {
    struct figure f = {0};
    bool done = figure_begin(&f, model, 2, error);
    if (done) {
        struct draw_call left = figure_call(&f, 2, 0), right = figure_call(&f, 2, 1);
        done = figure_draw(&f, &left, &gouraud_textured, error) &&
               figure_draw(&f, &right, &normal_mapped, error);
    }
    return figure_end(&f, directory, "smooth", done, error);
}

bool draw_figures(const char *directory, struct model *bust, struct error *error) {
    return draw_smooth(bust, directory, error) && draw_culled_by_light(bust, directory, error);
}
