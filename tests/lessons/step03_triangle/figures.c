/* The pictures of lesson 3's README that are not references. */
#include "bench/figures.h"

#define LESSON "../step03_triangle/main.c"
#include "lesson.h"

#include "../../../step03_triangle/attempts.h"

#include <stdio.h>
#include <stdlib.h>

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

/* The eye by an attempt, and which of its pixels are wrong. */
static void draw_eye(fill_function *draw, const char *words, const struct model *bust,
                     const char *name, const char *wrong_name) {
    struct image drawn = figure_image(800, 800), right = figure_image(800, 800);
    draw_bust_by(draw, bust, &drawn);
    draw_bust_by(draw_spans, bust, &right);
    printf("%s: %zu pixels of the head are wrong\n", words, different_pixels(&drawn, &right));
    figure_save_detail(&drawn, eye, name);
    show_wrong(&drawn, &right);
    figure_save_detail(&drawn, eye, wrong_name);
}

/* ---- By three borders ---- */

static const struct vec2 bordered[3] = {{2.5, 3.5}, {32.5, 9.5}, {11.5, 22.5}};

static void draw_border(struct image *image, struct attempt_border border, struct color color) {
    for (; border.k <= border.run; attempt_border_next(&border)) {
        image_set(image, border.now.x, border.now.y, color);
    }
}

/* The borders in white, green and red; filled up to the middle corner; filled. */
static void draw_borders(void) {
    const struct color white[3] = {{WHITE}, {WHITE}, {WHITE}}, green = {GREEN}, red = {RED};
    const struct color blue[3] = {{200, 90, 40, 255}, {200, 90, 40, 255}, {200, 90, 40, 255}};
    struct sheet sheet = {.width = 35 * 8, .height = 26 * 8, .columns = 3, .rows = 1, .gap = 6};
    sheet_create(&sheet);
    for (int last = 0; last < 3; last++) {
        struct image image = figure_image(35, 26);
        struct attempt_corner corner[3];
        struct attempt_border border[3];
        attempt_sort_by_x(bordered, white, corner);
        attempt_three_borders(corner, border);
        if (last > 0) {
            attempt_by_columns(&image, bordered, blue, last);
        }
        draw_border(&image, border[1], green);
        draw_border(&image, border[2], red);
        draw_border(&image, border[0], white[0]);
        sheet_add_detail(&sheet, &image, detail_of_whole(&image, 8, GRID));
    }
    figure_save(&sheet.image, "borders");
}

static int most_apart(struct color a, struct color b) {
    int apart = abs(a.r - b.r);
    apart = abs(a.g - b.g) > apart ? abs(a.g - b.g) : apart;
    return abs(a.b - b.b) > apart ? abs(a.b - b.b) : apart;
}

/* Colours by two interpolations, and next to them what is wrong: in grey 24 times the error of the
 * value that is most wrong, in orange the pixels that are not the triangle's. */
static void draw_border_colors(void) {
    const struct color color[3] = {{RED}, {GREEN}, {BLUE}};
    struct sheet sheet = {.width = 35 * 8, .height = 26 * 8, .columns = 2, .rows = 1, .gap = 6};
    struct image drawn = figure_image(35, 26), right = figure_image(35, 26);
    struct fixed2 snapped[3];
    int inside = 0, outside = 0, differ = 0, most = 0;
    figure_need(snap_corners(bordered, snapped));
    gradient_triangle(&right, snapped, color);
    attempt_by_columns(&drawn, bordered, color, 2);
    sheet_create(&sheet);
    sheet_add_detail(&sheet, &drawn, detail_of_whole(&drawn, 8, GRID));
    for (int y = 0; y < (int)drawn.height; y++) {
        for (int x = 0; x < (int)drawn.width; x++) {
            struct color is = image_get(&drawn, x, y), wanted = image_get(&right, x, y);
            int apart = most_apart(is, wanted);
            if (is.r + is.g + is.b == 0) {
                continue;
            }
            if (wanted.r + wanted.g + wanted.b == 0) {
                outside++;
                image_set(&drawn, x, y, color_rgb(255, 150, 0));
                continue;
            }
            inside++;
            differ += apart > 1;
            most = apart > most ? apart : most;
            image_set(&drawn, x, y, color_grey((uint8_t)(30 + 24 * apart)));
        }
    }
    sheet_add_detail(&sheet, &drawn, detail_of_whole(&drawn, 8, GRID));
    figure_save(&sheet.image, "border_colors");
    printf("two interpolations: %d pixels too many; of %d pixels inside, %d are wrong by more than "
           "1, by up to %d\n",
           outside, inside, differ, most);
}

void draw_figures(struct model *bust) {
    draw_half_planes();
    draw_few();
    draw_eye(attempt_1_sweep_whole, "1 sort and sweep", bust, "sweep", "sweep_wrong");
    draw_eye(attempt_by_borders, "by three borders", bust, "by_borders", "by_borders_wrong");
    draw_borders();
    draw_border_colors();
}
