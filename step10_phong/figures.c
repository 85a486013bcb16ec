/* Draws the figures of the lesson that are not references: figures DIRECTORY. */
#define main step_main
int step_main(int argc, char **argv);
#include "main.c"
#undef main

#include "attempts.h"
#include "png.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifndef COURSE_BUILD
#define COURSE_BUILD "build"
#endif

enum { PANEL = 320, TURN_SIZE = 128, TURN_DELAY_MS = 40 };

/* "DIRECTORY/NAME", to be freed; NULL when memory runs out. */
static char *join(const char *directory, const char *name) {
    size_t size = strlen(directory) + strlen(name) + 2;
    char *path = malloc(size);
    if (path != NULL) {
        snprintf(path, size, "%s/%s", directory, name);
    }
    return path;
}

static bool save_figure(const struct image *images, size_t count, const char *directory,
                        const char *name, struct error *error) {
    char *path = join(directory, name);
    if (path == NULL) {
        return error_set(error, "out of memory");
    }
    bool done = count > 1 ? apng_write(images, count, TURN_DELAY_MS, path, error)
                          : png_write(images, path, error);
    free(path);
    return done;
}

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
    bool (*fragment)(const void *uniforms, const double *varyings, struct color *color);
    struct material material;
};

static bool draw_panels(struct model *model, const struct panel *panels, int count,
                        struct vec3 light, const char *directory, const char *name,
                        struct error *error) {
    struct drawing drawing = make_drawing(model);
    struct pipeline pipeline = {0};
    struct image image = {0};
    struct uniforms u;
    drawing.light = light;
    size_t width = (size_t)(count * PANEL);
    bool done = image_create(&image, width, PANEL, IMAGE_BGR, error) &&
                pipeline_create(&pipeline, width, PANEL, error) &&
                make_uniforms(&drawing, NEEDS_NORMALS, PANEL, &u, error);
    for (int i = 0; done && i < count; i++) {
        struct shader shader = {
            .varying_count = 8, .vertex = vertex_with_normal, .fragment = panels[i].fragment};
        struct draw_call call =
            call_in_cell(&drawing, grid_cell(width, PANEL, count, 1, i, 0), 0.9);
        u.material = panels[i].material;
        done = pipeline_draw(&pipeline, &call, &shader, &u, &image, error);
    }
    done = done && save_figure(&image, 1, directory, name, error);
    image_free(&image);
    pipeline_free(&pipeline);
    return done;
}

/* The three parts and their sum. */
static bool draw_parts(struct model *model, const char *directory, struct error *error) {
    static const struct vec4 color = {255, 128, 255, 255};
    struct panel panels[] = {{plain_fragment, {0.1, 0, 0, 10, color}},
                             {plain_fragment, {0, 1, 0, 10, color}},
                             {plain_fragment, {0, 0, 0.5, 10, color}},
                             {plain_fragment, plain_material}};
    return draw_panels(model, panels, 4, (struct vec3){1, 1, 1}, directory, "parts.png", error);
}

/* Right; not normalised; not clamped; light reversed. */
static bool draw_wrong(struct model *model, const char *directory, struct error *error) {
    struct panel panels[] = {{plain_fragment, plain_material},
                             {attempt_5_not_normalized, plain_material},
                             {attempt_6_not_clamped, plain_material},
                             {attempt_7_light_reversed, plain_material}};
    return draw_panels(model, panels, 4, (struct vec3){-1, 0.6, -0.2}, directory, "wrong_light.png",
                       error);
}

static bool schlick_fragment(const void *uniforms, const double *varyings, struct color *color) {
    const struct uniforms *u = uniforms;
    struct vec3 normal = mesh_normal(varyings);
    struct vec3 to_eye = vec3_normalized(vec3_sub(u->eye, position_of(varyings)));
    double diffuse = vec3_dot(normal, u->to_light);
    double mirrored = vec3_dot(reflect(normal, u->to_light), to_eye);
    mirrored = diffuse > 0 && mirrored > 0 ? mirrored : 0;
    double specular = 255 * u->material.specular * attempt_4_schlick(mirrored, u->material.power);
    *color = color_grey(level_from(specular));
    return true;
}

static bool specular_fragment(const void *uniforms, const double *varyings, struct color *color) {
    const struct uniforms *u = uniforms;
    struct vec3 to_eye = vec3_normalized(vec3_sub(u->eye, position_of(varyings)));
    struct vec2 light = phong(mesh_normal(varyings), u->to_light, to_eye, u->material.power);
    *color = color_grey(level_from(255 * u->material.specular * light.y));
    return true;
}

/* The specular part alone: power 10, and Schlick's form of it. */
static bool draw_schlick(struct model *model, const char *directory, struct error *error) {
    static const struct material bright = {0, 0, 1, 10, {255, 255, 255, 255}};
    struct panel panels[] = {{specular_fragment, bright}, {schlick_fragment, bright}};
    return draw_panels(model, panels, 2, (struct vec3){1, 1, 1}, directory, "schlick.png", error);
}

/* The scene `turn` as a small animation. */
static bool draw_animation(struct model *model, const char *directory, struct error *error) {
    struct state state = {0};
    struct drawing drawing = make_drawing(model);
    drawing.state = &state;
    struct image *frames = calloc(TURN_FRAMES, sizeof *frames);
    if (frames == NULL) {
        return error_set(error, "out of memory");
    }
    bool done = pipeline_create(&state.pipeline, TURN_SIZE, TURN_SIZE, error);
    for (size_t i = 0; done && i < TURN_FRAMES; i++) {
        drawing.frame = i;
        done = image_create(&frames[i], TURN_SIZE, TURN_SIZE, IMAGE_BGR, error) &&
               draw_turn(&drawing, &frames[i], error);
    }
    done = done && save_figure(frames, TURN_FRAMES, directory, "turn.png", error);
    for (size_t i = 0; i < TURN_FRAMES; i++) {
        image_free(&frames[i]);
    }
    free(frames);
    pipeline_free(&state.pipeline);
    return done;
}

int main(int argc, char **argv) {
    struct error error;
    struct model model = {0};
    if (argc != 2) {
        fprintf(stderr, "usage: figures DIRECTORY\n");
        return 2;
    }
    bool done = model_read(&model, COURSE_BUILD "/models/bust.obj", &error) &&
                draw_parts(&model, argv[1], &error) && draw_wrong(&model, argv[1], &error) &&
                draw_schlick(&model, argv[1], &error) && draw_animation(&model, argv[1], &error);
    if (!done) {
        fprintf(stderr, "figures: %s\n", error.message);
    }
    model_free(&model);
    return done ? 0 : 1;
}
