/* The pictures of lesson 5's README that are not references, and the numbers of its tables. */
#include "bench/figures.h"

#define LESSON "../step05_zbuffer/main.c"
#include "lesson.h"

#include "../../../step05_zbuffer/attempts.h"
#include "files/model_file.h"
#include "large.h"

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

/* ---- Large triangles ---- */

static void draw_large(const char *name, void (*make)(struct large *)) {
    struct image image = figure_image(3 * LARGE_WIDTH, LARGE_HEIGHT);
    size_t wrong[2];
    depth_clear(memory, image.width * image.height);
    large_draw(make, 1, &image, memory, wrong);
    printf("%-6s %-28s %6zu pixels wrong\n", name, "2 painter's order", wrong[0]);
    printf("%-6s %-28s %6zu pixels wrong\n", name, "3 mean depth", wrong[1]);
    figure_save(&image, name);
}

/* ---- Two sheets close to each other ---- */

enum { SHEETS_WIDTH = 560, SHEETS_HEIGHT = 40 };

static struct vertex place(double x, double y, double depth) {
    struct vertex v = {.depth = depth};
    screen_snap((struct vec2){x, y}, &v.position); /* always within the limit here */
    return v;
}

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
    figure_need(model_read(&knot, COURSE_BUILD "/models/knot.off", &figure_error));
    memory = figure_memory(LIFTED_SIDE * LIFTED_SIDE, sizeof(double)); /* the largest picture */
    draw_painted_over(&knot, bust);
    draw_large("circle", large_bars);
    draw_large("floor", large_trees);
    draw_sheets();
    draw_lifted(bust);
}
