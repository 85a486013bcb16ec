/* The pictures of lesson 5's README that are not references, and the numbers of its tables. */
#include "bench/figures.h"

#define LESSON "../step05_zbuffer/main.c"
#include "lesson.h"

#include "../../../step05_zbuffer/attempts.h"
#include "files/model_file.h"

#include <stdio.h>
#include <string.h>

/* A depth for each pixel, or the painter's list, which is shorter. */
static void *memory;

/* What main.c draws: the depth in double. */
static void draw_right(struct image *image, const struct drawn *items, size_t count) {
    struct canvas canvas = {.image = image, .depth = memory};
    depth_clear(memory, image->width * image->height);
    for (size_t i = 0; i < count; i++) {
        triangle(&canvas, items[i].v, items[i].color);
    }
}

/* ---- What lesson 4 draws ---- */

enum { PAINTED_SIDE = 400 };

/* The triangles of lesson 4 are nearer the later they come. */
static void draw_in_order(const struct model *model, struct vec3 light, struct image *image) {
    struct canvas canvas = {.image = image, .depth = memory};
    depth_clear(memory, image->width * image->height);
    for (size_t face = 0; face < model->face_count; face++) {
        struct vertex v[3];
        const double intensity = model_face_intensity(model, face, vec3_normalized(light));
        if (intensity > 0 && place_face(model, face, image, v)) {
            v[0].depth = v[1].depth = v[2].depth = (double)face;
            triangle(&canvas, v, color_grey(level_from(intensity * 255)));
        }
    }
}

/* Two models as scenes show them, in the order of their files. */
static void draw_painted_over(const struct model *knot, const struct model *bust) {
    struct sheet sheet = {.width = PAINTED_SIDE,
                          .height = PAINTED_SIDE,
                          .columns = 2,
                          .rows = 1,
                          .gap = 8,
                          .format = IMAGE_GREY};
    sheet_create(&sheet);
    draw_in_order(knot, (struct vec3){0, 0, -1}, &sheet.panel);
    sheet_add(&sheet);
    draw_in_order(bust, (struct vec3){1, 0, -1}, &sheet.panel);
    sheet_add(&sheet);
    figure_save(&sheet.image, "painted_over");
}

/* ---- Three bars in a circle ---- */

static struct vertex place(double x, double y, double depth) {
    struct vertex v = {.depth = depth};
    screen_snap((struct vec2){x, y}, &v.position); /* always within the limit here */
    return v;
}

/* Three long triangles, each over the next: the thick end is near, the point is far. */
static void make_circle(struct drawn bars[3]) {
    static const struct vec2 corner[3] = {{-70, -10}, {-70, -70}, {130, -45}};
    static const double depth[3] = {0.5, 0.5, -0.5};
    static const double cosine[3] = {1, -0.5, -0.5};
    static const double sine[3] = {0, 0.8660254037844386, -0.8660254037844386};
    const struct color color[3] = {color_rgb(220, 60, 50), color_rgb(60, 170, 70),
                                   color_rgb(60, 90, 220)};
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            struct vec2 c = corner[k];
            bars[i].v[k] = place(118 + c.x * cosine[i] - c.y * sine[i],
                                 105 + c.x * sine[i] + c.y * cosine[i], depth[k]);
        }
        bars[i].color = color[i];
    }
}

/* ---- Small things on a large floor ---- */

enum { FLOOR_TREES = 6, FLOOR_COUNT = FLOOR_TREES + 2 };

/* A floor seen from obliquely above, of two triangles: its depth falls from 0.9 at the bottom of
 * the picture to -0.9 at the top. The trees on it are upright: one depth each. */
static void make_floor(struct drawn list[FLOOR_COUNT]) {
    static const struct vec2 foot[FLOOR_TREES] = {{60, 150}, {130, 120}, {205, 140},
                                                  {170, 85}, {90, 60},   {220, 40}};
    const struct vertex a = place(10, 10, 0.9), b = place(250, 10, 0.9);
    const struct vertex c = place(250, 190, -0.9), d = place(10, 190, -0.9);
    list[0] = (struct drawn){{a, b, c}, color_rgb(170, 140, 100)};
    list[1] = (struct drawn){{a, c, d}, color_rgb(190, 160, 120)};
    for (int i = 0; i < FLOOR_TREES; i++) {
        double depth = 0.9 - 1.8 * (foot[i].y - 10) / 180;
        list[i + 2] = (struct drawn){{place(foot[i].x - 16, foot[i].y, depth),
                                      place(foot[i].x + 16, foot[i].y, depth),
                                      place(foot[i].x, foot[i].y + 55, depth)},
                                     color_rgb(30, (uint8_t)(110 + 20 * i), 60)};
    }
}

/* ---- Large triangles ---- */

enum { LARGE_WIDTH = 260, LARGE_HEIGHT = 250 };

/* From left to right: with a depth buffer, by the painter, by mean depth. */
static void draw_large(const char *name, const struct drawn *list, size_t count) {
    struct sheet sheet = {.width = LARGE_WIDTH, .height = LARGE_HEIGHT, .columns = 3, .rows = 1};
    struct image right = figure_image(sheet.width, sheet.height);
    sheet_create(&sheet);
    draw_right(&right, list, count);
    sheet_add_detail(&sheet, &right, detail_of_whole(&right, 1, 0));
    for (int i = 0; i < 2; i++) {
        if (i == 0) { /* the painter sorts, so he gets a list of his own */
            memcpy(memory, list, count * sizeof *list);
            attempt_2_painter(&sheet.panel, memory, count);
        } else {
            attempt_3_mean_depth(&sheet.panel, list, count, memory);
        }
        printf("%-6s %-28s %6zu pixels wrong\n", name,
               i == 0 ? "2 painter's order" : "3 mean depth",
               different_pixels(&right, &sheet.panel));
        sheet_add(&sheet);
    }
    figure_save(&sheet.image, name);
}

/* ---- Two sheets close to each other ---- */

enum { SHEETS_WIDTH = 560, SHEETS_HEIGHT = 40 };

/* A blue sheet, and an orange one before it: nearer by 0 at the left end and by 1e-4 at the right
 * one. Both rise by 0.1 from bottom to top. The blue one comes first. */
static void make_sheets(struct drawn list[4]) {
    const double w = SHEETS_WIDTH, h = SHEETS_HEIGHT, low = 0.3, high = 0.4, gap = 1e-4;
    const struct color blue = color_rgb(70, 100, 190), orange = color_rgb(255, 150, 30);
    const struct vertex back[4] = {place(0, 0, low), place(w, 0, low), place(w, h, high),
                                   place(0, h, high)};
    const struct vertex front[4] = {place(0, 0, low), place(w, 0, low + gap),
                                    place(w, h, high + gap), place(0, h, high)};
    list[0] = (struct drawn){{back[0], back[1], back[2]}, blue};
    list[1] = (struct drawn){{back[0], back[2], back[3]}, blue};
    list[2] = (struct drawn){{front[0], front[1], front[2]}, orange};
    list[3] = (struct drawn){{front[0], front[2], front[3]}, orange};
}

static void draw_sheets(void) {
    struct sheet sheet = {.width = SHEETS_WIDTH,
                          .height = SHEETS_HEIGHT,
                          .columns = 1,
                          .rows = ATTEMPT_BUFFERS + 1,
                          .gap = 6};
    struct drawn list[4];
    struct image right = figure_image(SHEETS_WIDTH, SHEETS_HEIGHT);
    sheet_create(&sheet);
    make_sheets(list);
    image_clear(&right, list[2].color); /* the orange sheet is nowhere behind the blue one */
    for (int i = 0; i <= ATTEMPT_BUFFERS; i++) {
        const char *name = "double (main.c)";
        if (i < ATTEMPT_BUFFERS) {
            name = attempt_buffers[i].name;
            attempt_draw_with(&attempt_buffers[i], &sheet.panel, list, 4, memory);
        } else {
            draw_right(&sheet.panel, list, 4);
        }
        printf("sheets %-28s %6zu pixels wrong\n", name, different_pixels(&sheet.panel, &right));
        sheet_add(&sheet);
    }
    figure_save(&sheet.image, "sheets");
}

/* ---- Lines, lifted too little, enough, and too much ---- */

enum { LIFTED_SIDE = 800, LIFTED_DETAIL = 260 };

static void draw_lifted(const struct model *bust) {
    static const double lifts[] = {0, LINE_LIFT, 60};
    const struct detail detail = {215, 420, LIFTED_DETAIL, LIFTED_DETAIL, 1, 0};
    struct sheet sheet = {
        .width = LIFTED_DETAIL, .height = LIFTED_DETAIL, .columns = 3, .rows = 1, .gap = 8};
    sheet_create(&sheet);
    for (int i = 0; i < 3; i++) {
        struct image image = figure_image(LIFTED_SIDE, LIFTED_SIDE);
        struct image black = figure_image(LIFTED_SIDE, LIFTED_SIDE);
        struct canvas canvas = {.image = &image, .depth = memory};
        depth_clear(memory, LIFTED_SIDE * LIFTED_SIDE);
        draw_hidden_lines(bust, lifts[i], &canvas);
        printf("lifted by %.0f pixels %6zu pixels drawn\n", lifts[i],
               different_pixels(&image, &black));
        sheet_add_detail(&sheet, &image, detail);
    }
    figure_save(&sheet.image, "lifted");
}

void draw_figures(struct model *bust) {
    struct model knot;
    struct drawn bars[3], floor_list[FLOOR_COUNT];
    figure_need(model_read(&knot, COURSE_BUILD "/models/knot.off", &figure_error));
    memory = figure_memory(LIFTED_SIDE * LIFTED_SIDE, sizeof(double)); /* the largest picture */
    make_circle(bars);
    make_floor(floor_list);
    draw_painted_over(&knot, bust);
    draw_large("circle", bars, 3);
    draw_large("floor", floor_list, FLOOR_COUNT);
    draw_sheets();
    draw_lifted(bust);
}
