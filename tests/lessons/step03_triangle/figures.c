/* The pictures of lesson 3's README that are not references. */
#include "bench/figures.h"

#define LESSON "../step03_triangle/main.c"
#include "lesson.h"

#include "../../../step03_triangle/attempts.h"

enum { GRID = 60 }; /* grey level of the lines between enlarged pixels */

/* The good version: spans. */
static void draw_spans(struct image *image, const struct vec2 corner[3], struct color color) {
    struct fixed2 snapped[3];
    if (snap_corners(corner, snapped)) {
        triangle(image, snapped, color);
    }
}

/* The faces of the bust that show their outside, their corners already snapped to 1/256, so that
 * all attempts get the same. */
static void draw_bust_by(fill_function *draw, const struct model *model, struct image *image) {
    image_clear(image, color_grey(0));
    for (size_t face = 0, drawn = 0; face < model->face_count; face++) {
        struct vec2 screen[3];
        struct fixed2 corner[3];
        face_on_screen(model, face, image, screen);
        if (snap_corners(screen, corner)) {
            for (int i = 0; i < 3; i++) {
                screen[i] =
                    (struct vec2){(double)corner[i].x / SUBPIXELS, (double)corner[i].y / SUBPIXELS};
            }
            if (!is_turned_away(screen)) {
                draw(image, screen, face_color(drawn));
                drawn++;
            }
        }
    }
}

/* ---- The pictures ---- */

/* Where the edge functions of the example are 0 or more (red, green, blue: edges 0, 1, 2): white
 * where all three are. */
static void draw_half_planes(void) {
    struct image image;
    struct edges edges = {0};
    const struct fixed2 a = {384, 384}, b = {1408, 384}, c = {384, 1152};
    image = figure_image(8, 6);
    triangle_setup(&edges, a, b, c, image.width, image.height);
    for (int y = 0; y < (int)image.height; y++) {
        for (int x = 0; x < (int)image.width; x++) {
            uint8_t level[3];
            for (int i = 0; i < 3; i++) {
                const struct edge *e = &edges.edge[i];
                level[i] = e->origin + e->dx * x + e->dy * y >= 0 ? 255 : 70;
            }
            image_set(&image, x, y, color_rgb(level[0], level[1], level[2]));
        }
    }
    figure_save_detail(&image, detail_of_whole(&image, 60, GRID), "half_planes");
}

/* The triangle by hand, of five pixels; and two that share an edge. */
static void draw_few(void) {
    const struct vec2 by_hand[3] = {{1.5, 1.5}, {5.5, 1.5}, {1.5, 4.5}};
    const struct vec2 two[2][3] = {{{4.5, 4.5}, {30.5, 10.5}, {14.5, 34.5}},
                                   {{30.5, 10.5}, {36.5, 36.5}, {14.5, 34.5}}};
    struct image image = figure_image(7, 6);
    draw_spans(&image, by_hand, color_grey(255));
    figure_save_detail(&image, detail_of_whole(&image, 64, 0), "by_hand");
    image = figure_image(40, 40);
    draw_spans(&image, two[0], color_rgb(255, 140, 0));
    draw_spans(&image, two[1], color_rgb(80, 80, 255));
    figure_save_detail(&image, detail_of_whole(&image, 12, 0), "neighbours");
}

/* The eye of the bust, enlarged. */
static const struct detail eye = {308, 512, 80, 60, .zoom = 6};

static bool same_color(struct color a, struct color b) {
    return a.r == b.r && a.g == b.g && a.b == b.b;
}

/* The pixels of the second image in grey, and in orange where the first one differs. */
static void show_wrong(struct image *wrong, const struct image *right) {
    for (int y = 0; y < (int)wrong->height; y++) {
        for (int x = 0; x < (int)wrong->width; x++) {
            struct color is = image_get(wrong, x, y), wanted = image_get(right, x, y);
            uint8_t grey = (uint8_t)((wanted.r + wanted.g + wanted.b) / 6);
            image_set(wrong, x, y,
                      same_color(is, wanted) ? color_grey(grey) : color_rgb(255, 150, 0));
        }
    }
}

/* The eye by the whole-number sweep, and which of its pixels are wrong. */
static void draw_sweep(const struct model *bust) {
    struct image sweep = figure_image(800, 800), right = figure_image(800, 800);
    draw_bust_by(attempt_1_sweep_whole, bust, &sweep);
    draw_bust_by(draw_spans, bust, &right);
    figure_save_detail(&sweep, eye, "sweep");
    show_wrong(&sweep, &right);
    figure_save_detail(&sweep, eye, "sweep_wrong");
}

void draw_figures(struct model *bust) {
    draw_half_planes();
    draw_few();
    draw_sweep(bust);
}
