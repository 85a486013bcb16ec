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

/* ---- What is coloured in vain, and what is nearest ---- */

/* A colour for each number, the same in every picture. */
static struct color color_of(uint32_t number) {
    const uint32_t mixed = number * 2654435761U;
    return color_rgb((uint8_t)(60 + (mixed >> 24) % 196),
                     (uint8_t)(60 + (mixed >> 16 & 0xFF) % 196),
                     (uint8_t)(60 + (mixed >> 8 & 0xFF) % 196));
}

/* Left, how often simple_draw() colours a pixel of the four heads: black never, then blue, green,
 * yellow, red. Right, the visibility buffer of the same heads, a colour for each face. */
static void draw_visibility(struct model *model) {
    static const struct color often[] = {{.a = 255},
                                         {.r = 40, .g = 70, .b = 150, .a = 255},
                                         {.r = 50, .g = 160, .b = 80, .a = 255},
                                         {.r = 240, .g = 200, .b = 60, .a = 255},
                                         {.r = 230, .g = 70, .b = 50, .a = 255}};
    const struct drawing drawing = {.model = model, .eye = {1, 0.5, 3}, .up = {0, 1, 0}};
    const size_t pixels = (size_t)PANEL * PANEL;
    struct sheet sheet = {.width = PANEL, .height = PANEL, .columns = 2, .rows = 1, .gap = 6};
    sheet_create(&sheet);
    struct image *panel = &sheet.panel;
    struct band band = {{0, PANEL},
                        PANEL,
                        figure_memory(pixels, sizeof(double)),
                        figure_memory(pixels, sizeof(uint32_t))};
    struct kept_face *kept = figure_memory(model->face_count, sizeof *kept);
    unsigned char *times = figure_memory(pixels, 1);
    const struct canvas canvas = {panel, band.depth};
    struct draw_call calls[HEADS];
    make_head_calls(&drawing, panel, 0.68, calls);
    band_clear(&band);
    uint32_t number = 0;
    for (int head = 0; head < HEADS; head++) {
        const size_t count = keep_faces(&canvas, &calls[head], kept);
        for (size_t i = 0; i < count; i++) {
            cover_face(&band, &kept[i], ++number);
            const struct span rows = {kept[i].edges.y_begin, kept[i].edges.y_end};
            for (size_t at = (size_t)rows.begin * PANEL; at < (size_t)rows.end * PANEL; at++) {
                if (band.nearest[at] == number) {
                    times[at]++;
                }
            }
        }
    }
    for (int side = 0; side < 2; side++) {
        for (size_t at = 0; at < pixels; at++) {
            const uint32_t nearest = band.nearest[at];
            const size_t most = times[at] < 4 ? times[at] : 4;
            const struct color color = nearest == 0 ? often[0] : color_of(nearest);
            image_set(panel, (int)(at % PANEL), (int)(at / PANEL), side == 0 ? often[most] : color);
        }
        sheet_add(&sheet);
    }
    figure_save(&sheet.image, "visibility");
}

void draw_figures(struct model *bust) {
    /* The normals of the mesh, as in lesson 8, and those of the map. */
    static const struct cell smooth[] = {{&gouraud_textured, CULL_BACK},
                                         {&normal_mapped, CULL_BACK}};
    /* Culled by the camera, and by the light, over red, so that holes are seen. */
    static const struct cell culled[] = {{&flat, CULL_BACK}, {&culled_by_light, CULL_NONE}};
    draw_two(bust, smooth, color_grey(0), "smooth");
    draw_two(bust, culled, color_rgb(160, 0, 0), "culled_by_light");
    draw_visibility(bust);
}
