/* The pictures of step 9's README that are not references. */
#include "../tests/bench/figures.h"

#define LESSON "../step09_shaders/main.c"
#include "../tests/lesson.h"

#include "attempts.h"
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

/* A mip level of a texture as it is, a quarter of its width and height. */
static bool draw_texture(const struct texture *texture, const char *directory, const char *name,
                         struct error *error) {
    const struct texture_level *level = &texture->level[2];
    struct image image = {0};
    bool done = image_create(&image, level->width, level->height, IMAGE_BGR, error);
    for (size_t i = 0; done && i < level->width * level->height; i++) {
        uint32_t texel = texture_texel(level, i % level->width, i / level->width);
        image_set(&image, (int)(i % level->width), (int)(i / level->width),
                  color_rgb((uint8_t)(texel >> 16), (uint8_t)(texel >> 8), (uint8_t)texel));
    }
    done = done && figure_save(&image, directory, name, error);
    image_free(&image);
    return done;
}

static bool draw_textures(struct model *model, const char *directory, struct error *error) {
    struct drawing drawing;
    return make_drawing(&drawing, model, error) &&
           draw_texture(drawing.diffuse, directory, "texture_colors", error) &&
           draw_texture(drawing.normal_map, directory, "texture_normals", error);
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

/* ---- How often each pixel is shaded ---- */

/* The corners of a face on the screen. */
struct on_screen {
    struct fixed2 corner[3];
    double depth[3];
};

static bool face_on_screen(const struct draw_call *call, size_t face, struct on_screen *seen) {
    const struct rectangle *v = &call->viewport;
    bool done = true;
    for (size_t i = 0; i < 3; i++) {
        struct vec4 clip = mat4_point(&call->to_clip, model_position(call->model, face, i));
        struct vec2 screen = {v->x + (clip.x / clip.w + 1) * v->width / 2,
                              v->y + (clip.y / clip.w + 1) * v->height / 2};
        seen->depth[i] = clip.z / clip.w;
        done = screen_snap(screen, &seen->corner[i]) && done;
    }
    return done;
}

/* Add 1 where the face is nearest so far: there it would be shaded, if all were shaded at once. */
static void count_face(const struct on_screen *seen, double *depths, struct image *times) {
    const struct fixed2 *c = seen->corner;
    const double *z = seen->depth;
    struct edges edges;
    if (!edges_setup(&edges, c[0], c[1], c[2], times->width, times->height) || edges.clockwise) {
        return;
    }
    for (int y = edges.y_begin; y < edges.y_end; y++) {
        struct span span = edges_span(&edges, y);
        for (int x = span.begin; x < span.end; x++) {
            double *nearest = &depths[(size_t)y * times->width + (size_t)x];
            double depth = interpolate_depth(edges_weights(&edges, x, y), z[0], z[1], z[2]);
            if (depth > *nearest) {
                *nearest = depth;
                image_set(times, x, y, color_grey((uint8_t)(image_get(times, x, y).g + 1)));
            }
        }
    }
}

static bool count_at_once(const struct draw_call *call, struct image *times, struct error *error) {
    size_t pixels = times->width * times->height;
    double *depths = malloc(pixels * sizeof *depths);
    if (depths == NULL) {
        return error_out_of_memory(error);
    }
    depth_clear(depths, pixels);
    for (size_t i = 0; i < call->model->face_count; i++) {
        struct on_screen seen;
        if (face_on_screen(call, i, &seen)) {
            count_face(&seen, depths, times);
        }
    }
    free(depths);
    return true;
}

/* Shaded once. */
static void once_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    (void)uniforms, (void)face, (void)corner;
    varyings[0] = 90;
}

static lanes_mask once_fragment(const void *uniforms, const lanes *varyings, lanes_texel *color) {
    (void)uniforms;
    *color = lanes_rgb(varyings[0], varyings[0], varyings[0]);
    return lanes_all_set();
}

SHADER(once, .varying_count = 1, .flat = true, .vertex = once_vertex, .fragment = once_fragment);

static struct color color_of_count(int times) {
    return times == 0   ? color_grey(0)
           : times == 1 ? color_grey(90)
           : times == 2 ? color_rgb(255, 170, 0)
                        : color_rgb(255, 0, 0);
}

static void show_counts(const struct image *times, struct image *image) {
    for (int y = 0; y < (int)times->height; y++) {
        for (int x = 0; x < (int)times->width; x++) {
            image_set(image, x, y, color_of_count(image_get(times, x, y).g));
        }
    }
}

/* Left: shaded at once. Right: only what is visible. Grey once, orange twice, red more often. */
static bool draw_overdraw(struct model *model, const char *directory, struct error *error) {
    struct figure f = {0};
    struct image times = {0};
    bool done = figure_begin(&f, model, 2, error) &&
                image_create(&times, f.image.width, f.image.height, IMAGE_GREY, error);
    if (done) {
        struct draw_call left = figure_call(&f, 2, 0), right = figure_call(&f, 2, 1);
        done = count_at_once(&left, &times, error) && figure_draw(&f, &right, &once, error);
        show_counts(&times, &f.image);
    }
    image_free(&times);
    return figure_end(&f, directory, "overdraw", done, error);
}

bool draw_figures(const char *directory, struct model *bust, struct error *error) {
    return draw_textures(bust, directory, error) && draw_smooth(bust, directory, error) &&
           draw_culled_by_light(bust, directory, error) && draw_overdraw(bust, directory, error);
}
