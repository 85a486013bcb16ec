/* The pictures of lesson 9's README that are not references. */
#include "../tests/bench/figures.h"

#define LESSON "../step09_shaders/main.c"
#include "../tests/lesson.h"

#include "files/model_file.h"

enum { PANEL = 400 };

struct figure {
    struct drawing drawing;
    struct pipeline pipeline;
    struct image image;
    struct uniforms uniforms;
};

/* All figures are drawn from the scenes' camera, with the light from the side. */
static void figure_begin(struct figure *figure, struct model *model, int panels) {
    size_t width = (size_t)(panels * PANEL);
    figure->drawing = (struct drawing){
        .model = model,
        .diffuse = model_texture(model, MODEL_DIFFUSE, &figure_error),
        .normal_map = model_texture(model, MODEL_NORMAL_MAP, &figure_error),
        .eye = {1, 0.5, 3},
        .up = {0, 1, 0},
        .light = {1, 0.2, 0},
        .skip = true,
    };
    figure->image = figure_image(width, PANEL);
    figure_need(figure->drawing.diffuse != NULL && figure->drawing.normal_map != NULL &&
                pipeline_create(&figure->pipeline, width, PANEL, &figure_error));
    figure->uniforms = make_uniforms(&figure->drawing, PANEL);
}

static struct draw_call figure_call(const struct figure *figure, int panels, int panel) {
    struct rectangle cell =
        grid_cell(figure->image.width, figure->image.height, panels, 1, panel, 0);
    return pipeline_call(&figure->drawing, cell, 0.85, CULL_BACK);
}

static void figure_draw(struct figure *figure, const struct draw_call *call,
                        const struct shader *shader) {
    figure_need(pipeline_draw(&figure->pipeline, call, shader, &figure->uniforms,
                              sizeof figure->uniforms, &figure_error));
}

static void figure_end(struct figure *figure, const char *name) {
    figure_need(pipeline_finish(&figure->pipeline, &figure->image, &figure_error));
    figure_save(&figure->image, name);
}

/* Left: culled by the camera. Right: by the light, over red, so that holes are seen. */
static void draw_culled_by_light(struct model *model) {
    struct figure f;
    figure_begin(&f, model, 2);
    struct draw_call right = figure_call(&f, 2, 0), wrong = figure_call(&f, 2, 1);
    image_clear(&f.image, color_rgb(160, 0, 0));
    wrong.cull = CULL_NONE;
    figure_draw(&f, &right, &flat);
    figure_draw(&f, &wrong, &culled_by_light);
    figure_end(&f, "culled_by_light");
}

/* Left: the normals of the mesh, as in lesson 8. Right: those of the map. */
static void draw_smooth(struct model *model) {
    struct figure f;
    figure_begin(&f, model, 2);
    struct draw_call left = figure_call(&f, 2, 0), right = figure_call(&f, 2, 1);
    figure_draw(&f, &left, &gouraud_textured);
    figure_draw(&f, &right, &normal_mapped);
    figure_end(&f, "smooth");
}

void draw_figures(struct model *bust) {
    draw_smooth(bust);
    draw_culled_by_light(bust);
}
