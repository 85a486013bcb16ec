/* The pictures of step 9's README that are not references. */
#include "../tests/figures.h"
#define main step_main
#include "main.c"
#undef main

#include "attempts.h"
#include "model_file.h"

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

/* Save the figure if it is `drawn`, and free it. */
static bool figure_end(struct figure *figure, const char *directory, const char *name, bool drawn,
                       struct error *error) {
    bool done = drawn && figure_save(&figure->image, directory, name, error);
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
        done = pipeline_draw(&f.pipeline, &right, &flat, &f.uniforms, &f.image, error) &&
               pipeline_draw(&f.pipeline, &wrong, &culled_by_light, &f.uniforms, &f.image, error);
    }
    return figure_end(&f, directory, "culled_by_light", done, error);
}

SHADER(not_shifted, .varying_count = 2, .vertex = uv_vertex,
       .fragment = attempt_4_normals_not_shifted);
SHADER(file_order, .varying_count = 2, .vertex = uv_vertex,
       .fragment = attempt_5_normals_in_file_order);

/* Right; levels as 0..1; x and z exchanged. */
static bool draw_wrong_normals(struct model *model, const char *directory, struct error *error) {
    struct figure f = {0};
    bool done = figure_begin(&f, model, 3, error);
    if (done) {
        struct draw_call right = figure_call(&f, 3, 0);
        struct draw_call second = figure_call(&f, 3, 1), third = figure_call(&f, 3, 2);
        done = pipeline_draw(&f.pipeline, &right, &normal_mapped, &f.uniforms, &f.image, error) &&
               pipeline_draw(&f.pipeline, &second, &not_shifted, &f.uniforms, &f.image, error) &&
               pipeline_draw(&f.pipeline, &third, &file_order, &f.uniforms, &f.image, error);
    }
    return figure_end(&f, directory, "wrong_normals", done, error);
}

/* ---- How often each pixel is shaded ---- */

struct counting {
    const struct model *model;
    struct draw_call call;
    struct image *times;
};

static void place_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct counting *u = uniforms;
    struct vec3 place = model_position(u->model, face, corner);
    varyings[0] = place.x;
    varyings[1] = place.y;
    varyings[2] = place.z;
}

/* Add 1 to the count of the pixel that shows this place. */
static bool count_fragment(const void *uniforms, const double *varyings, struct color *color) {
    const struct counting *u = uniforms;
    const struct rectangle *v = &u->call.viewport;
    struct vec3 place = {varyings[0], varyings[1], varyings[2]};
    struct vec4 clip = mat4_point(&u->call.to_clip, place);
    int x = v->x + (int)((clip.x / clip.w + 1) * v->width / 2);
    int y = v->y + (int)((clip.y / clip.w + 1) * v->height / 2);
    uint8_t times = image_get(u->times, x, y).b;
    image_set(u->times, x, y, color_grey((uint8_t)(times + 1)));
    *color = color_grey(0);
    return true;
}

SHADER(counting_shader, .varying_count = 3, .vertex = place_vertex, .fragment = count_fragment);

static bool draw_count(struct figure *f, int panel, bool skip, struct image *times,
                       struct error *error) {
    struct counting u = {f->drawing.model, figure_call(f, 2, panel), times};
    f->pipeline.skip = skip;
    return pipeline_draw(&f->pipeline, &u.call, &counting_shader, &u, &f->image, error);
}

/* Left: shaded at once. Right: only what is visible. Grey once, orange twice, red more often. */
static bool draw_overdraw(struct model *model, const char *directory, struct error *error) {
    struct figure f = {0};
    struct image times = {0};
    bool done = figure_begin(&f, model, 2, error) &&
                image_create(&times, f.image.width, f.image.height, IMAGE_GREY, error) &&
                draw_count(&f, 0, false, &times, error) && draw_count(&f, 1, true, &times, error);
    for (int y = 0; done && y < (int)times.height; y++) {
        for (int x = 0; x < (int)times.width; x++) {
            uint8_t n = image_get(&times, x, y).b;
            struct color color = n == 0   ? color_grey(0)
                                 : n == 1 ? color_grey(90)
                                 : n == 2 ? color_rgb(255, 170, 0)
                                          : color_rgb(255, 0, 0);
            image_set(&f.image, x, y, color);
        }
    }
    image_free(&times);
    return figure_end(&f, directory, "overdraw", done, error);
}

bool draw_figures(const char *directory, struct model *bust, struct error *error) {
    return draw_culled_by_light(bust, directory, error) &&
           draw_wrong_normals(bust, directory, error) && draw_overdraw(bust, directory, error);
}
