/* Lesson 7's functions called with numbers. */
#ifndef LESSON
#define LESSON "../step07_gouraud/main.c"
#endif
#include "numbers.h"

/* What is drawn on: two rows of two panels, which are not square, and a row and a column that
 * belong to none. */
enum { CALLED_WIDTH = 12, CALLED_HEIGHT = 10 };
enum { CALLED_COLUMNS = 2 * CALLED_WIDTH + 1, CALLED_ROWS = 2 * CALLED_HEIGHT + 1 };
static uint8_t called_bytes[3 * CALLED_COLUMNS * CALLED_ROWS];
static double called_depths[CALLED_COLUMNS * CALLED_ROWS];
static struct image called_sheet = {CALLED_COLUMNS, CALLED_ROWS, IMAGE_BGR, called_bytes};
static struct canvas called_canvas = {.image = &called_sheet,
                                      .width = CALLED_WIDTH,
                                      .height = CALLED_HEIGHT,
                                      .depth = called_depths,
                                      .material = &satin};

/* The corners that the texts of calls name. */
static const struct vertex called_grey[3] = {
    {.intensity = 0.9}, {.intensity = 0.8}, {.intensity = 0.71}};
static const struct vertex called_colors[3] = {
    {.color = {0.61, 0, 1}}, {.color = {0, 0.91, 1}}, {.color = {0, 0.3, 0.71}}};
static const struct vertex called_lights[3] = {
    {.parts = {0.9, 0.06}}, {.parts = {0.4, 0.03}}, {.parts = {0.24, 0}}};

typedef void called_triangle_function(const struct canvas *called_canvas, const struct edges *edges,
                                      const struct vertex v[3]);

static void called_clear(void) {
    memset(called_bytes, 0, sizeof called_bytes);
    for (int i = 0; i < CALLED_COLUMNS * CALLED_ROWS; i++) {
        called_depths[i] = -INFINITY;
    }
}

/* At pixel (3,3) all weights are 1/3, at (2,1) they are 6/9, 2/9 and 1/9. */
static void called_draw(called_triangle_function *function, const struct vertex v[3]) {
    const struct fixed2 corner[3] = {{128, 128}, {2432, 128}, {128, 2432}};
    struct edges edges;
    edges_setup(&edges, corner[0], corner[1], corner[2], CALLED_WIDTH, CALLED_HEIGHT);
    function(&called_canvas, &edges, v);
}

/* Draw a triangle where pixel (2,1) shows something nearer, and a black one behind it: how many
 * pixels are not black in the whole image, then pixels (2,1) and (1,2). */
static struct shown called_between(called_triangle_function *function, const struct vertex v[3]) {
    const struct vertex black[3] = {{.depth = -0.5}, {.depth = -0.5}, {.depth = -0.5}};
    int drawn = 0;
    called_clear();
    called_depths[1 * CALLED_WIDTH + 2] = 1;
    called_draw(function, v);
    called_draw(function, black);
    for (int i = 0; i < CALLED_COLUMNS * CALLED_ROWS; i++) {
        const struct color c = image_get(&called_sheet, i % CALLED_COLUMNS, i / CALLED_COLUMNS);
        drawn += c.r + c.g + c.b > 0;
    }
    return show("%d %s %s", drawn, show_color(image_get(&called_sheet, 2, 1)).text,
                show_color(image_get(&called_sheet, 1, 2)).text);
}

/* Red of both pixels. */
static struct shown called_shaded(void) {
    called_clear();
    called_draw(triangle, called_grey);
    return show("%d %d", image_get(&called_sheet, 3, 3).r, image_get(&called_sheet, 2, 1).r);
}

static struct color called_colored(void) {
    called_clear();
    called_draw(color_triangle, called_colors);
    return image_get(&called_sheet, 2, 1);
}

/* Pixel (2,1) of all panels, from the first. */
static struct shown called_lit(void) {
    struct shown shown = {""};
    called_clear();
    called_draw(lit_triangle, called_lights);
    for (int i = 0; i < PANEL_COUNT; i++) {
        int x = 2 + panels[i].column * CALLED_WIDTH, y = 1 + panels[i].row * CALLED_HEIGHT;
        shown = show("%.150s%s%s", shown.text, i > 0 ? " " : "",
                     show_color(image_get(&called_sheet, x, y)).text);
    }
    return shown;
}

static struct light_parts called_parts(double diffuse, double specular) {
    return (struct light_parts){diffuse, specular};
}

/* What corner_light() must give with the student's integer_power(). */
static struct light_parts called_with_her_power(struct vec3 position, struct vec3 normal,
                                                struct vec3 light, struct vec3 camera,
                                                const struct material *material) {
    const struct vec3 l = vec3_normalized(vec3_sub(light, position));
    const struct vec3 v = vec3_normalized(vec3_sub(camera, position));
    const double facing = vec3_dot(normal, l);
    const double shining = 2 * facing * vec3_dot(normal, v) - vec3_dot(l, v);
    if (facing <= 0) {
        return called_parts(0, 0);
    }
    return called_parts(material->diffuse * integer_power(facing, material->diffuse_power),
                        material->specular *
                            integer_power(fmax(shining, 0), material->specular_power));
}

static struct shown called_pair(struct light_parts parts) {
    return show_reals((const double[]){parts.diffuse, parts.specular}, 2);
}

static bool called_alike(struct light_parts a, struct light_parts b) {
    return is_near(a.diffuse, b.diffuse) && is_near(a.specular, b.specular);
}

#define LIGHT(arguments, right)                                                                    \
    do {                                                                                           \
        if (number_begin("7b.2", "corner_light" #arguments, called_pair(right))) {                 \
            const struct light_parts yours = corner_light arguments;                               \
            number_end(called_pair(yours),                                                         \
                       called_alike(yours, right) ||                                               \
                           (called_alike(yours, called_with_her_power arguments) &&                \
                            !says_nothing(called_pair(yours).text)));                              \
        }                                                                                          \
    } while (0)
#define PANEL(i, d, s, material, right)                                                            \
    COLOR_AS("7b.3", "panel_color(&panels[" #i "], {" #d ", " #s "}, &" #material ")",             \
             panel_color(&panels[i], called_parts(d, s), &(material)), right)
#define BETWEEN(call)                                                                              \
    call ", the same, but something nearer at (2,1), then a black one behind it: pixels drawn, "   \
         "(2,1), (1,2)"
#define COLOR_AS(task, text, call, right) TEXT(task, text, show_color(call), right)

static void numbers(void) {
    REAL("7a.1", corner_intensity(xyz(0, 0, 1), xyz(0.6, 0, 0.8)), 0.8);
    REAL("7a.1", corner_intensity(xyz(0, 0.6, -0.8), xyz(0, 0, 1)), 0);
    REAL("7a.1", corner_intensity(xyz(-0.6, 0.8, 0), xyz(0.6, 0, 0.8)), 0);
    TEXT("7a.2", "triangle(), intensities 0.9, 0.8, 0.71: pixels (3,3) (2,1)", called_shaded(),
         "205 218");
    TEXT("7a.2", BETWEEN("triangle()"), called_between(triangle, called_grey),
         "35 0,0,0 216,216,216");
    COLOR_AS("7a.3", "color_triangle(), colors (0.61, 0, 1), (0, 0.91, 1), (0, 0.3, 0.71): (2,1)",
             called_colored(), "104,60,247");
    TEXT("7a.3", BETWEEN("color_triangle()"), called_between(color_triangle, called_colors),
         "35 0,0,0 104,43,239");
    REAL("7b.1", integer_power(0.5, 3), 0.125);
    REAL("7b.1", integer_power(0.5, 1), 0.5);
    REAL("7b.1", integer_power(3, 0), 1);
    REAL("7b.1", integer_power(2, 16), 65536);
    REAL("7b.1", integer_power(-2, 3), -8);
    REAL("7b.1", integer_power(0, 0), 1);
    LIGHT((xyz(0, 0, 0), xyz(0, 0, 1), xyz(-2, 2, 3), xyz(0, 0, 3), &clay),
          called_parts(0.50932, 0.031422));
    LIGHT((xyz(1, 0, 0), xyz(0, 0, 1), xyz(-1, 2, 3), xyz(1, 0, 3), &satin),
          called_parts(0.42353, 0.12236));
    LIGHT((xyz(0, 0, 0), xyz(0, 0, 1), xyz(3, 0, 3), xyz(3, 0, 0), &clay),
          called_parts(0.49497, 0));
    LIGHT((xyz(0, 0, 0), xyz(0, 0, 1), xyz(3, 0, 0.015), xyz(-3, 0, 0.015), &clay),
          called_parts(0.0035, 0.4));
    LIGHT((xyz(0, 0, 0), xyz(0, 0, 1), xyz(3, 0, -3), xyz(-3, 0, -3), &satin), called_parts(0, 0));
    LIGHT((xyz(0, 0, 0), xyz(0, 0, 1), xyz(3, 0, 0), xyz(-3, 0, 0), &clay), called_parts(0, 0));
    PANEL(3, 0.5093, 0.0314, clay, "168,125,100");
    PANEL(0, 0.5093, 0.0314, clay, "45,33,26");
    PANEL(3, 0.6, 0.39, clay, "255,231,203");
    PANEL(3, 0.5, 0.2, satin, "105,132,172");
    TEXT("7b.3",
         "lit_triangle(), parts {0.9, 0.06}, {0.4, 0.03}, {0.24, 0}: pixel (2,1) of the panels",
         called_lit(), "9,14,22 64,100,157 12,11,9 85,125,189");
    TEXT("7b.3", BETWEEN("lit_triangle()"), called_between(lit_triangle, called_lights),
         "140 0,0,0 11,10,9");
}
