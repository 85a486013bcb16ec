/* The pictures of lesson 9's README that are not references. */
#include "bench/figures.h"

#define LESSON "../step09_shaders/main.c"
#include "lesson.h"

#include "files/model_file.h"

enum { PANEL = 400 };

/* Two cells side by side, over a colour, from the scenes' camera, with the light from the side. */
static void draw_two(struct model *model, const struct cell cells[2], struct color background,
                     const char *name) {
    struct pipeline pipeline;
    struct image image = figure_image(2 * PANEL, PANEL);
    struct drawing drawing = {
        .model = model,
        .diffuse = model_texture(model, MODEL_DIFFUSE, &figure_error),
        .normal_map = model_texture(model, MODEL_NORMAL_MAP, &figure_error),
        .eye = {1, 0.5, 3},
        .up = {0, 1, 0},
        .light = {1, 0.2, 0},
        .skip = true,
    };
    image_clear(&image, background);
    figure_need(drawing.diffuse != NULL && drawing.normal_map != NULL &&
                pipeline_create(&pipeline, image.width, image.height, &figure_error));
    const struct uniforms u = make_uniforms(&drawing, PANEL);
    for (int i = 0; i < 2; i++) {
        struct rectangle place = grid_cell(image.width, image.height, 2, 1, i);
        struct draw_call call = pipeline_call(&drawing, place, 0.85, cells[i].cull);
        figure_need(pipeline_draw(&pipeline, &call, cells[i].shader, &u, sizeof u, &figure_error));
    }
    figure_need(pipeline_finish(&pipeline, &image, &figure_error));
    figure_save(&image, name);
}

void draw_figures(struct model *bust) {
    /* The normals of the mesh, as in lesson 8, and those of the map. */
    static const struct cell smooth[] = {{&gouraud_textured, CULL_BACK},
                                         {&normal_mapped, CULL_BACK}};
    /* Culled by the camera, and by the light, over red, so that holes are seen. */
    static const struct cell culled[] = {{&flat, CULL_BACK}, {&culled_by_light, CULL_NONE}};
    draw_two(bust, smooth, color_grey(0), "smooth");
    draw_two(bust, culled, color_rgb(160, 0, 0), "culled_by_light");
}
