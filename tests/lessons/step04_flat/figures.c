/* The pictures of lesson 4's README that are not references. */
#include "bench/figures.h"

#define LESSON "../step04_flat/main.c"
#include "lesson.h"

#include "../../../step04_flat/attempts.h"

#include <stdio.h>

static const struct vec3 front = {0, 0, 1}; /* to the light of scene flat */

/* draw_flat() with another intensity, lit from the front. */
static void draw_with(const struct model *model, intensity_function *find, struct image *image) {
    image_clear(image, color_grey(0));
    for (size_t face = 0; face < model->face_count; face++) {
        struct vertex vertices[3];
        double intensity = find(model_position(model, face, 0), model_position(model, face, 1),
                                model_position(model, face, 2), front);
        if (intensity > 0 && place_face(model, face, image, vertices)) {
            triangle(image, vertices, color_grey(level_from(intensity * 255)));
        }
    }
}

/* Attempt 1 as it is, and many times brighter, so that something can be seen. */
static double intensity_of_area(struct vec3 w0, struct vec3 w1, struct vec3 w2,
                                struct vec3 to_light) {
    return 100 * attempt_1_not_normalized(w0, w1, w2, to_light);
}

static void draw_not_normalized(const struct model *model) {
    static intensity_function *const shown[2] = {attempt_1_not_normalized, intensity_of_area};
    struct sheet sheet = {.width = 400, .height = 400, .columns = 2, .rows = 1, .gap = 4};
    sheet_create(&sheet);
    for (int i = 0; i < 2; i++) {
        draw_with(model, shown[i], &sheet.panel);
        sheet_add(&sheet);
    }
    figure_save(&sheet.image, "not_normalized");
}

/* What draw_flat() draws, with a pixel in magenta where it shows a face although another is nearer.
 * A depth for every pixel, as in lesson 5, finds the nearest one. */
static void draw_marked(const struct model *model, struct image *image) {
    double *nearest = figure_memory(image->width * image->height, sizeof *nearest);
    depth_clear(nearest, image->width * image->height);
    for (size_t face = 0; face < model->face_count; face++) {
        struct vertex v[3];
        struct edges edges;
        const double intensity = face_intensity(model, face, front);
        if (!(intensity > 0) || !place_face(model, face, image, v) ||
            !edges_setup(&edges, v[0].position, v[1].position, v[2].position, image->width,
                         image->height)) {
            continue;
        }
        for (int y = edges.y_begin; y < edges.y_end; y++) {
            struct span span = edges_span(&edges, y);
            for (int x = span.begin; x < span.end; x++) {
                double *kept = &nearest[(size_t)y * image->width + (size_t)x];
                double depth =
                    interpolate(edges_weights(&edges, x, y), model_position(model, face, 0).z,
                                model_position(model, face, 1).z, model_position(model, face, 2).z);
                image_set(image, x, y,
                          depth < *kept ? color_rgb(255, 0, 160)
                                        : color_grey(level_from(intensity * 255)));
                *kept = fmax(*kept, depth);
            }
        }
    }
}

/* What is still wrong: parts that lie behind others are painted over them. */
static void draw_faults(const struct model *model) {
    const struct detail ear = {490, 420, 110, 160, .zoom = 4};
    const struct detail head = {190, 200, 420, 600, .zoom = 1};
    struct image image = figure_image(800, 800), marked = figure_image(800, 800);
    struct drawing drawing = {.model = model, .light = {0, 0, -1}};
    figure_need(draw_flat(&drawing, &image, &figure_error));
    figure_save_detail(&image, ear, "detail_ear");
    draw_marked(model, &marked);
    figure_save_detail(&marked, head, "faults");
    printf("%zu pixels show a face that lies behind another\n", different_pixels(&image, &marked));
}

/* ---- Which faces show their front? ---- */

/* Does the triangle that three points make on the screen, in an image of 800 x 800, run
 * counterclockwise? */
static bool winds_to_us(const struct vec3 corner[3]) {
    struct fixed2 p[3];
    for (int i = 0; i < 3; i++) {
        figure_need(screen_snap(parallel_view(corner[i], 800, 800), &p[i]));
    }
    const int64_t area = ((int64_t)p[1].x - p[0].x) * ((int64_t)p[2].y - p[0].y) -
                         ((int64_t)p[1].y - p[0].y) * ((int64_t)p[2].x - p[0].x);
    return area > 0;
}

/* The fronts by n . v, and for how many faces the winding order on the screen says something else.
 * The eye is at (0, 0, distance), or infinitely far away; v is the same for all faces, or each
 * face's own. */
static void count_fronts(const struct model *model, double distance, bool own, const char *name) {
    int fronts = 0, differ = 0;
    for (size_t face = 0; face < model->face_count; face++) {
        struct vec3 w[3], screen[3];
        for (size_t i = 0; i < 3; i++) {
            w[i] = model_position(model, face, i);
            screen[i] = vec3_scale(w[i], 1 / (1 - w[i].z / distance));
        }
        const struct vec3 normal = vec3_cross(vec3_sub(w[1], w[0]), vec3_sub(w[2], w[0]));
        const struct vec3 to_eye = own ? vec3_sub((struct vec3){0, 0, distance}, w[0]) : front;
        const bool is_front = vec3_dot(normal, to_eye) > 0;
        fronts += is_front;
        differ += is_front != winds_to_us(screen);
    }
    printf("%-32s %d fronts; by winding %d faces differ\n", name, fronts, differ);
}

void draw_figures(struct model *bust) {
    count_fronts(bust, INFINITY, false, "parallel, v = (0, 0, 1):");
    count_fronts(bust, 2, false, "in perspective, v = (0, 0, 1):");
    count_fronts(bust, 2, true, "in perspective, v = C - w0:");
    draw_not_normalized(bust);
    draw_faults(bust);
}
