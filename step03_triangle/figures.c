/* The pictures of step 3's README that are not references. */
#include "../tests/bench/figures.h"

#define LESSON "../step03_triangle/main.c"
#include "../tests/lesson.h"

#include "attempts.h"

enum { GRID = 60 }; /* grey level of the lines between enlarged pixels */

typedef void attempt_function(struct target *target, const struct vec2 corner[3],
                              struct color color);

/* The good version: spans. */
static void draw_spans(struct target *target, const struct vec2 corner[3], struct color color) {
    struct fixed2 snapped[3];
    if (snap_corners(corner, snapped)) {
        triangle(target->image, snapped, color);
    }
}

/* The faces of the bust that show their outside, their corners already snapped to 1/256, so that
 * all attempts get the same. */
static void draw_bust_by(attempt_function *draw, const struct model *model, struct image *image) {
    struct target target = {.image = image};
    image_clear(image, color_grey(0));
    for (size_t face = 0, drawn = 0; face < model->face_count; face++) {
        struct fixed2 corner[3];
        uint64_t turned_away = 0;
        if (place_face(model, face, image, corner, &turned_away)) {
            const struct vec2 screen[3] = {in_pixels(corner[0]), in_pixels(corner[1]),
                                           in_pixels(corner[2])};
            draw(&target, screen, face_color(drawn));
            drawn++;
        }
    }
}

/* ---- The pictures ---- */

/* Which of the three edge functions are positive (red, green, blue: edges 0, 1, 2); inside all
 * three the pixel is white. */
static bool draw_half_planes(const char *directory, struct error *error) {
    struct image image;
    struct edges edges = {0};
    const struct fixed2 a = {5 * 256 / 2, 5 * 256 / 2}, b = {43 * 256 / 2, 9 * 256 / 2};
    const struct fixed2 c = {17 * 256 / 2, 33 * 256 / 2};
    if (!image_create(&image, 24, 19, IMAGE_BGR, error)) {
        return false;
    }
    triangle_setup(&edges, a, b, c, image.width, image.height);
    for (int y = 0; y < (int)image.height; y++) {
        for (int x = 0; x < (int)image.width; x++) {
            uint8_t level[3];
            for (int i = 0; i < 3; i++) {
                const struct edge *e = &edges.edge[i];
                level[i] = e->origin + e->dx * x + e->dy * y >= e->least ? 255 : 70;
            }
            image_set(&image, x, y, color_rgb(level[0], level[1], level[2]));
        }
    }
    bool done = figure_save_detail(&image, detail_of_whole(&image, 20, GRID), directory,
                                   "half_planes", error);
    image_free(&image);
    return done;
}

/* A white ring, for the reader's eye. */
static void draw_ring(struct image *image, int x, int y, int radius) {
    for (int v = -radius; v <= radius; v++) {
        for (int u = -radius; u <= radius; u++) {
            if (fabs(hypot(u, v) - radius) < 0.5) {
                image_set(image, x + u, y + v, color_grey(255));
            }
        }
    }
}

/* The eye of the bust. The rings show where the versions differ most. */
static bool draw_eye(const struct model *bust, attempt_function *draw, struct image *image,
                     const char *directory, const char *name, struct error *error) {
    const struct detail eye = {300, 480, 130, 100, .zoom = 4};
    draw_bust_by(draw, bust, image);
    draw_ring(image, 339, 542, 12); /* the iris */
    draw_ring(image, 400, 500, 12); /* the ridge of the nose */
    return figure_save_detail(image, eye, directory, name, error);
}

/* Part of the bust in colours: whole-number sweep, and spans. */
static bool draw_bust_details(const struct model *bust, const char *directory,
                              struct error *error) {
    struct image image = {0};
    bool done =
        image_create(&image, 800, 800, IMAGE_BGR, error) &&
        draw_eye(bust, attempt_1_sweep_whole, &image, directory, "bust_sweep_whole", error) &&
        draw_eye(bust, draw_spans, &image, directory, "bust_spans", error);
    image_free(&image);
    return done;
}

bool draw_figures(const char *directory, struct model *bust, struct error *error) {
    return draw_half_planes(directory, error) && draw_bust_details(bust, directory, error);
}
