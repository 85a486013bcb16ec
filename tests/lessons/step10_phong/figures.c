/* The pictures of lesson 10's README that are not references, one of them moving. */
#include "bench/figures.h"

#define LESSON "../step10_phong/main.c"
#include "lesson.h"

#include "../../../step10_phong/attempts.h"
#include "files/model_file.h"
#include "files/normals.h"
#include "files/png.h"

/* Of the small animation: the light swings from the left to the right and back, in whole frames of
 * scene `turn`. */
enum { PANEL = 320, SWING_SIZE = 240, SWING_FRAMES = 32, SWING_DELAY_MS = 80 };

/* The camera of the scenes. */
static struct drawing make_drawing(struct model *model) {
    return (struct drawing){
        .model = model, .eye = {1, 0.5, 3}, .up = {0, 1, 0}, .light = {1, 1, 1}, .skip = true};
}

static struct drawing make_textured(struct model *model) {
    struct drawing drawing = make_drawing(model);
    drawing.diffuse = model_texture(model, MODEL_DIFFUSE, &figure_error);
    drawing.normal_map = model_texture(model, MODEL_NORMAL_MAP, &figure_error);
    drawing.specular = model_texture(model, MODEL_SPECULAR, &figure_error);
    figure_need(drawing.diffuse != NULL && drawing.normal_map != NULL && drawing.specular != NULL);
    return drawing;
}

static struct pipeline make_pipeline(size_t width, size_t height) {
    struct pipeline pipeline;
    figure_need(pipeline_create(&pipeline, width, height, &figure_error));
    return pipeline;
}

/* A shader without its own loops. */
#define PANEL_SHADER(name, function)                                                               \
    static const struct shader name = {                                                            \
        .varying_count = 8, .vertex = vertex_with_normal, .fragment = (function)}

/* How many panels, and what is seen in each: -1..1 around `center`, in `zoom` of the panel. */
struct view {
    int columns, rows;
    struct vec3 center, light;
    double zoom;
};

static void draw_panels(struct model *model, const struct view *view, const struct cell *panels,
                        const char *name) {
    size_t width = (size_t)(view->columns * PANEL), height = (size_t)(view->rows * PANEL);
    struct drawing drawing = make_textured(model);
    struct pipeline pipeline = make_pipeline(width, height);
    struct image image = figure_image(width, height);
    drawing.light = view->light;
    drawing.center = view->center;
    drawing.state = &pipeline;
    figure_need(
        draw_cells(&drawing, &image, panels, view->columns, view->rows, view->zoom, &figure_error));
    figure_save(&image, name);
}

/* Left: the light of lesson 9. Right: that of this one. */
static void draw_chalk(struct model *model) {
    static const struct material chalk = {0, 1, 0, 10, {255, 255, 255}};
    const struct view view = {2, 1, {0, 0, 0}, {1, 0.6, -0.1}, 0.9};
    PANEL_SHADER(before, full_fragment);
    PANEL_SHADER(now, weight_map_fragment);
    const struct cell panels[] = {{&before, chalk, NULL, NULL},
                                  {&now, textured_material, NULL, NULL}};
    draw_panels(model, &view, panels, "chalk");
}

/* Where the light of the scenes makes the largest spots, from near. */
static const struct vec3 shoulder = {0.35, -0.45, 0.1};

/* The specular part alone, from near: six powers. */
static void draw_near(struct model *model) {
    static const int powers[] = {1, 3, 5, 10, 20, 80};
    const struct view view = {3, 2, shoulder, {1, 1, 1}, 2};
    struct cell panels[6];
    for (int i = 0; i < 6; i++) {
        panels[i] = (struct cell){&plain, {0, 0, 1, powers[i], {255, 255, 255}}, NULL, NULL};
    }
    draw_panels(model, &view, panels, "powers_near");
}

/* The specular part computed at the corners, as in lesson 7: the only varying. */
static void corner_light_vertex(const void *uniforms, size_t face, size_t corner,
                                double *varyings) {
    const struct uniforms *u = uniforms;
    struct vec3 normal = vec3_normalized(model_normal(u->model, face, corner));
    struct vec3 to_eye = vec3_normalized(vec3_sub(u->eye, model_position(u->model, face, corner)));
    double facing = vec3_dot(normal, u->to_light);
    struct vec3 mirrored = vec3_sub(vec3_scale(normal, 2 * facing), u->to_light);
    varyings[0] = facing > 0 ? pow(fmax(vec3_dot(mirrored, to_eye), 0), u->material.power) : 0;
}

static lanes_mask corner_light_fragment(const void *uniforms, const lanes *varyings,
                                        lanes_texel *color) {
    (void)uniforms;
    *color = lanes_rgb(255 * varyings[0], 255 * varyings[0], 255 * varyings[0]);
    return lanes_all_set();
}

/* From near, where a high power makes a small difference large: light at the corners, light at each
 * pixel with normals as they are interpolated, and with normals of length 1. */
static void draw_lost_highlight(struct model *model) {
    static const struct material bright = {0, 0, 1, 40, {255, 255, 255}};
    const struct view view = {3, 1, shoulder, {1, 1, 1}, 2};
    static const struct shader at_corners = {
        .varying_count = 1, .vertex = corner_light_vertex, .fragment = corner_light_fragment};
    PANEL_SHADER(not_normalized, attempt_5_not_normalized);
    const struct cell panels[] = {{&at_corners, bright, NULL, NULL},
                                  {&not_normalized, bright, NULL, NULL},
                                  {&plain, bright, NULL, NULL}};
    draw_panels(model, &view, panels, "lost_highlight");
}

static void draw_animation(struct model *model) {
    struct image frames[SWING_FRAMES];
    struct pipeline pipeline = make_pipeline(SWING_SIZE, SWING_SIZE);
    struct drawing drawing = make_textured(model);
    drawing.state = &pipeline;
    for (size_t i = 0; i < SWING_FRAMES; i++) {
        double swing = 22 * turn_direction((double)i / SWING_FRAMES).y; /* frames of `turn` */
        drawing.frame = (size_t)(TURN_FRAMES + lround(swing)) % TURN_FRAMES;
        frames[i] = figure_image(SWING_SIZE, SWING_SIZE);
        figure_need(draw_turn(&drawing, &frames[i], &figure_error));
    }
    figure_need(
        apng_write(frames, SWING_FRAMES, SWING_DELAY_MS, figure_path("turn"), &figure_error));
}

/* ---- The figures of BEYOND.md ---- */

/* Face and shoulder in the light of the scene `shadow`, with biases of 0, 0.01 and 0.1. */
static void draw_shadow_figure(struct model *model) {
    static const double biases[] = {0, 0.01, 0.1};
    const struct detail detail = {.x = 240, .y = 170, .width = 360, .height = 420, .zoom = 1};
    struct sheet sheet = {.width = 360, .height = 420, .columns = 3, .rows = 1, .gap = 4};
    struct drawing drawing = make_textured(model);
    struct pipeline pipeline = make_pipeline(800, 800);
    struct image image = figure_image(800, 800);
    sheet_create(&sheet);
    drawing.light = (struct vec3){-1, 1, 1};
    drawing.state = &pipeline;
    pipeline.keep_depth = true;
    for (int i = 0; i < 3; i++) {
        image_clear(&image, (struct color){0, 0, 0, 0});
        figure_need(draw_with_map(&drawing, &image, 1024, biases[i], &shadowed, &figure_error));
        sheet_add_detail(&sheet, &image, detail);
    }
    figure_save(&sheet.image, "shadow");
}

/* A piece of the shoulder, enlarged. Above 1, 4 and 16 samples; below 256, and 4 and 16 of which
 * the values were averaged. */
static void draw_samples_figure(struct model *model) {
    static const int sides[] = {1, 2, 4, 16, 2, 4};
    const struct rectangle whole = {0, 0, 200, 200};
    const struct detail detail = {.x = 132, .y = 36, .width = 40, .height = 40, .zoom = 8};
    struct sheet sheet = {.width = 320, .height = 320, .columns = 3, .rows = 2, .gap = 4};
    struct drawing drawing = make_textured(model);
    struct image image = figure_image(200, 200);
    sheet_create(&sheet);
    for (int i = 0; i < 6; i++) {
        enum averaging averaging = i < 4 ? MEAN_OF_LIGHT : MEAN_OF_VALUES;
        figure_need(draw_sampled(&drawing, &image, whole, sides[i], averaging, &figure_error));
        sheet_add_detail(&sheet, &image, detail);
    }
    figure_save(&sheet.image, "samples");
}

/* ---- The figure of TANGENT.md ---- */

enum { STUD = 30, STUDS = 16, BALL = 240 };

/* Half of a ball on each square of a board: normals that count from the board. `up` is -1 where
 * green grows downwards. */
static struct image draw_studs(double up) {
    struct image image = figure_image(STUDS * STUD, STUDS * STUD / 2);
    for (int y = 0; y < (int)image.height; y++) {
        for (int x = 0; x < (int)image.width; x++) {
            double u = (x % STUD + 0.5) / STUD * 2 - 1, v = (y % STUD + 0.5) / STUD * 2 - 1;
            double rest = 1 - (u * u + v * v) / 0.6;
            struct vec3 n = {u / sqrt(0.6), v / sqrt(0.6) * up, sqrt(fmax(rest, 0))};
            struct color c = color_rgb(level_from(127.5 * (n.x + 1)), level_from(127.5 * (n.y + 1)),
                                       level_from(127.5 * (n.z + 1)));
            image_set(&image, x, y, rest > 0 ? c : color_rgb(128, 128, 255));
        }
    }
    return image;
}

/* The ball with a map on it, as a panel of the sheet. */
static void add_ball(struct sheet *sheet, struct model *ball, const struct image *normals,
                     const struct shader *shader) {
    struct drawing drawing = make_drawing(ball);
    struct pipeline pipeline = make_pipeline(BALL, BALL);
    struct texture map;
    figure_need(texture_create(&map, normals, &figure_error));
    drawing.normal_map = &map;
    drawing.eye = (struct vec3){0, 0, 3};
    drawing.light = (struct vec3){1, 1, 0.5};
    struct draw_call call =
        pipeline_call(&drawing, (struct rectangle){0, 0, BALL, BALL}, 0.85, CULL_BACK);
    struct uniforms u = make_uniforms(&drawing, BALL, plain_material);
    figure_need(pipeline_draw(&pipeline, &call, shader, &u, sizeof u, &figure_error) &&
                pipeline_finish(&pipeline, &sheet->panel, &figure_error));
    sheet_add(sheet);
}

/* A part of the map; read in tangent space; read in object space; read with green downwards. */
static void draw_tangent_figure(void) {
    const struct detail part = {.x = 0, .y = 0, .width = BALL, .height = BALL, .zoom = 1};
    struct sheet sheet = {.width = BALL, .height = BALL, .columns = 4, .rows = 1, .gap = 4};
    const struct image studs = draw_studs(1), turned = draw_studs(-1);
    struct model ball;
    figure_need(model_read(&ball, COURSE_BUILD "/models/sphere.obj", &figure_error));
    sheet_create(&sheet);
    sheet_add_detail(&sheet, &studs, part);
    add_ball(&sheet, &ball, &studs, &tangent_mapped);
    add_ball(&sheet, &ball, &studs, &mapped);
    add_ball(&sheet, &ball, &turned, &tangent_mapped);
    figure_save(&sheet.image, "tangent");
}

void draw_figures(struct model *bust) {
    figure_need(model_need_normals(bust, &figure_error));
    draw_chalk(bust);
    draw_near(bust);
    draw_lost_highlight(bust);
    draw_animation(bust);
    draw_shadow_figure(bust);
    draw_samples_figure(bust);
    draw_tangent_figure();
}
