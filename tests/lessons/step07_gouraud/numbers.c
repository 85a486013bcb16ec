/* Lesson 7's functions called with numbers. */
#ifndef LESSON
#define LESSON "../step07_gouraud/main.c"
#endif
#include "numbers.h"

/* What is drawn on: two rows of two panels. */
enum { CALLED_SIDE = 10, CALLED_PIXELS = CALLED_SIDE * CALLED_SIDE };
static uint8_t called_bytes[3 * 4 * CALLED_PIXELS];
static double called_depths[4 * CALLED_PIXELS];
static struct image called_sheet = {2 * CALLED_SIDE, 2 * CALLED_SIDE, IMAGE_BGR, called_bytes};
static struct canvas called_canvas = {.image = &called_sheet,
                                      .width = CALLED_SIDE,
                                      .height = CALLED_SIDE,
                                      .depth = called_depths,
                                      .material = &satin,
                                      .skip = true};

typedef void called_triangle_function(struct canvas *called_canvas, const struct edges *edges,
                                      const struct vertex v[3]);

/* Draw a triangle over that depth. At pixel (3,3) all weights are 1/3, at (2,1) they are 6/9, 2/9
 * and 1/9. */
static void called_draw(called_triangle_function *function, const struct vertex v[3],
                        double depth) {
    const struct fixed2 corner[3] = {{128, 128}, {2432, 128}, {128, 2432}};
    struct edges edges;
    memset(called_bytes, 0, sizeof called_bytes);
    for (int i = 0; i < 4 * CALLED_PIXELS; i++) {
        called_depths[i] = depth;
    }
    edges_setup(&edges, corner[0], corner[1], corner[2], CALLED_SIDE, CALLED_SIDE);
    function(&called_canvas, &edges, v);
}

/* Red of both pixels. */
static struct shown called_shaded(double a, double b, double c, double depth) {
    called_draw(triangle, (struct vertex[]){{.intensity = a}, {.intensity = b}, {.intensity = c}},
                depth);
    return show("%d %d", image_get(&called_sheet, 3, 3).r, image_get(&called_sheet, 2, 1).r);
}

static struct color called_colored(struct vec3 a, struct vec3 b, struct vec3 c) {
    called_draw(color_triangle, (struct vertex[]){{.color = a}, {.color = b}, {.color = c}}, -1);
    return image_get(&called_sheet, 2, 1);
}

/* Pixel (2,1) of all panels, from the first. */
static struct shown called_lit(struct light_parts a, struct light_parts b, struct light_parts c) {
    struct shown shown = {""};
    called_draw(lit_triangle, (struct vertex[]){{.parts = a}, {.parts = b}, {.parts = c}}, -1);
    for (int i = 0; i < PANEL_COUNT; i++) {
        int x = 2 + panels[i].column * CALLED_SIDE, y = 1 + panels[i].row * CALLED_SIDE;
        shown = show("%.150s%s%s", shown.text, i > 0 ? " " : "",
                     show_color(image_get(&called_sheet, x, y)).text);
    }
    return shown;
}

/* What corner_light() gives. */
static struct vec2 called_pair(struct light_parts called_parts) {
    return xy(called_parts.diffuse, called_parts.specular);
}

static struct light_parts called_parts(double diffuse, double specular) {
    return (struct light_parts){diffuse, specular};
}

#define LIGHT(call, right) AS_VECTOR("7b.2", #call, vec2, called_pair(call), right)
#define PANEL(i, d, s, material, right)                                                            \
    COLOR_AS("7b.3", "panel_color(&panels[" #i "], {" #d ", " #s "}, &" #material ")",             \
             panel_color(&panels[i], called_parts(d, s), &(material)), right)
#define COLOR_AS(task, text, call, right) TEXT(task, text, show_color(call), right)

static void numbers(void) {
    REAL("7a.1", corner_intensity(xyz(0, 0, 1), xyz(0.6, 0, 0.8)), 0.8);
    REAL("7a.1", corner_intensity(xyz(0, 0.6, -0.8), xyz(0, 0, 1)), 0);
    REAL("7a.1", corner_intensity(xyz(-0.6, 0.8, 0), xyz(0.6, 0, 0.8)), 0);
    TEXT("7a.2", "triangle(), intensities 0.9, 0.8, 0.71: pixels (3,3) (2,1)",
         called_shaded(0.9, 0.8, 0.71, -1), "205 218");
    TEXT("7a.2", "triangle(), intensities 0.9, 0.8, 0.71: behind another",
         called_shaded(0.9, 0.8, 0.71, 1), "0 0");
    COLOR_AS("7a.3", "color_triangle(), colors (0.61, 0, 1), (0, 0.91, 1), (0, 0.3, 0.71): (2,1)",
             called_colored(xyz(0.61, 0, 1), xyz(0, 0.91, 1), xyz(0, 0.3, 0.71)), "104,60,247");
    REAL("7b.1", integer_power(0.5, 3), 0.125);
    REAL("7b.1", integer_power(0.5, 1), 0.5);
    REAL("7b.1", integer_power(3, 0), 1);
    REAL("7b.1", integer_power(2, 16), 65536);
    LIGHT(corner_light(xyz(0, 0, 0), xyz(0, 0, 1), xyz(-2, 2, 3), xyz(0, 0, 3), &clay),
          xy(0.50932, 0.031422));
    LIGHT(corner_light(xyz(1, 0, 0), xyz(0, 0, 1), xyz(-1, 2, 3), xyz(1, 0, 3), &satin),
          xy(0.42353, 0.12236));
    LIGHT(corner_light(xyz(0, 0, 0), xyz(0, 0, 1), xyz(3, 0, 3), xyz(3, 0, 0), &clay),
          xy(0.49497, 0));
    LIGHT(corner_light(xyz(0, 0, 0), xyz(0, 0, 1), xyz(3, 0, -3), xyz(-3, 0, -3), &satin),
          xy(0, 0));
    LIGHT(corner_light(xyz(0, 0, 0), xyz(0, 0, 1), xyz(3, 0, 0), xyz(-3, 0, 0), &clay), xy(0, 0));
    PANEL(3, 0.5093, 0.0314, clay, "168,125,100");
    PANEL(0, 0.5093, 0.0314, clay, "45,33,26");
    PANEL(3, 0.6, 0.39, clay, "255,231,203");
    PANEL(3, 0.5, 0.2, satin, "105,132,172");
    TEXT("7b.3",
         "lit_triangle(), parts {0.9, 0.06}, {0.4, 0.03}, {0.24, 0}: pixel (2,1) of the panels",
         called_lit(called_parts(0.9, 0.06), called_parts(0.4, 0.03), called_parts(0.24, 0)),
         "9,14,22 64,100,157 12,11,9 85,125,189");
}
