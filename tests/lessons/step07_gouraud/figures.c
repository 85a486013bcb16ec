/* The pictures of lesson 7's README that are not references, and the errors of the spheres. */
#include "bench/figures.h"

#define LESSON "../step07_gouraud/main.c"
#include "lesson.h"

#include "../../../step07_gouraud/attempts.h"
#include "files/model_file.h"
#include "files/normals.h"

#include <stdio.h>

enum { SIDE = 256, GAP = 8 }; /* pixels of a panel, and between two panels */

/* The panels of a figure, and a canvas on which each of them is drawn. */
static struct canvas figure_begin(struct sheet *sheet, size_t columns, size_t rows) {
    *sheet = (struct sheet){.width = SIDE,
                            .height = SIDE,
                            .columns = columns,
                            .rows = rows,
                            .gap = GAP,
                            .format = IMAGE_GREY};
    sheet_create(sheet);
    return (struct canvas){.image = &sheet->panel,
                           .width = SIDE,
                           .height = SIDE,
                           .depth = figure_memory(SIDE * SIDE, sizeof(double))};
}

/* ---- The sphere: three versions, three meshes ---- */

static void draw_spheres(void) {
    static const struct {
        const char *name;
        attempt_function *attempt;
    } versions[] = {
        {"flat", attempt_1_flat},
        {"Gouraud", attempt_2_gouraud},
        {"normal per pixel", attempt_3_normal},
    };
    const struct vec3 light = vec3_normalized((struct vec3){1, 2, 2});
    struct sheet sheet;
    struct canvas canvas = figure_begin(&sheet, 3, 3);
    for (size_t i = 0; i < sizeof versions / sizeof versions[0]; i++) {
        for (int times = 2; times <= 4; times++) {
            attempt_sphere(&canvas, times, light, versions[i].attempt);
            printf("%-36s %4d triangles: error %5.2f\n", versions[i].name, 8 << 2 * times,
                   attempt_sphere_error(&canvas, light));
            sheet_add(&sheet);
        }
    }
    figure_save(&sheet.image, "spheres");
}

/* ---- The bust ---- */

/* Light from the left: not clamped, clamped at the pixel, clamped at the corner. */
static void draw_clamps(struct model *bust) {
    static attempt_function *const attempts[] = {attempt_6_wrapped, attempt_5_late,
                                                 attempt_2_gouraud};
    const struct vec3 light = vec3_normalized((struct vec3){-1, 0.25, 0});
    struct sheet sheet;
    struct canvas canvas = figure_begin(&sheet, 3, 1);
    figure_need(model_need_normals(bust, &figure_error));
    for (size_t i = 0; i < 3; i++) {
        attempt_model(&canvas, bust, light, attempts[i]);
        sheet_add(&sheet);
    }
    figure_save(&sheet.image, "clamps");
}

/* ---- The exercise ---- */

/* color_triangle() with u, v and the intensity instead of red, green and blue. */
static void textured_triangle(const struct canvas *canvas, const struct edges *edges,
                              const struct vertex v[3], const struct texture *texture) {
    for (int y = edges->y_begin; y < edges->y_end; y++) {
        struct span span = edges_span(edges, y);
        for (int x = span.begin; x < span.end; x++) {
            struct vec3 weight = edges_weights(edges, x, y);
            if (depth_test(canvas, v, weight, x, y)) {
                struct vec3 c = vec3_interpolate(weight, v[0].color, v[1].color, v[2].color);
                struct vec4 t = texture_bilinear(texture, (struct vec2){c.x, c.y}, 0);
                image_set(
                    canvas->image, x, y,
                    color_rgb(level_from(t.x * c.z), level_from(t.y * c.z), level_from(t.z * c.z)));
            }
        }
    }
}

/* Textured Gouraud, in half the size of the exercise's scene. */
static void draw_textured(struct model *bust) {
    struct image image = figure_image(400, 400);
    double *depth = figure_memory(image.width * image.height, sizeof *depth);
    const struct canvas canvas = {
        .image = &image, .width = image.width, .height = image.height, .depth = depth};
    const struct vec3 front = {0, 0, 1}; /* to the light of scene gouraud */
    const struct texture *skin = model_texture(bust, MODEL_DIFFUSE, &figure_error);
    figure_need(skin != NULL);
    depth_clear(depth, image.width * image.height);
    for (size_t face = 0; face < bust->face_count; face++) {
        struct vertex v[3];
        struct edges edges;
        if (begin_face(bust, face, &canvas, v, &edges)) {
            for (size_t i = 0; i < 3; i++) {
                struct vec2 uv = model_uv(bust, face, i);
                struct vec3 normal = vec3_normalized(model_normal(bust, face, i));
                v[i].color = (struct vec3){uv.x, uv.y, corner_intensity(normal, front)};
            }
            textured_triangle(&canvas, &edges, v, skin);
        }
    }
    figure_save(&image, "textured");
}

void draw_figures(struct model *bust) {
    draw_spheres();
    draw_clamps(bust);
    draw_textured(bust);
}
