/* Step 7: light at the corners, and what is interpolated between them. */
#define LESSON "../step07_gouraud/main.c"
#include "lesson.h"

#include "upkeep/stress/lessons.h"
#include "upkeep/stress/stress.h"

#include <stdio.h>
#include <string.h>

/* ---- Light at a corner ---- */

struct corner_case {
    struct vec3 position, normal, light, camera;
    struct material material;
};

/* Lights and cameras on all sides, now and then where the position is or in the mirror's way. */
static void make_corner(struct random *random, uint64_t index, void *made) {
    struct corner_case *c = made;
    c->position = random_vector(random, 1);
    c->normal = random_direction(random);
    c->light = index % 32 == 0 ? c->position : random_vector(random, 3);
    c->camera = index % 32 == 1 ? c->position : random_vector(random, 3);
    if (index % 4 == 2) { /* look into the mirrored light: the specular part is large */
        struct vec3 l = vec3_sub(c->light, c->position);
        struct vec3 s = vec3_sub(vec3_scale(c->normal, 2 * vec3_dot(c->normal, l)), l);
        c->camera = vec3_add(vec3_add(c->position, s), random_vector(random, 1));
    }
    c->material = (struct material){
        .ambient = random_real(random, 0, 1),
        .diffuse = random_real(random, 0, 1),
        .specular = random_real(random, 0, 1),
        .diffuse_power = (int)random_between(random, 0, 4),
        .specular_power = (int)random_between(random, 0, 80),
        .surface_color = {random_real(random, 0, 255), random_real(random, 0, 255),
                          random_real(random, 0, 255)},
        .light_color = {random_real(random, 0, 255), random_real(random, 0, 255),
                        random_real(random, 0, 255)},
    };
}

static long double exact_power(long double base, int power) {
    return power == 0 ? 1 : base * exact_power(base, power - 1);
}

/* In units of rounding; the clamped half must be 0 itself. */
static double intensity_error(const void *tried) {
    const struct corner_case *c = tried;
    struct vec3 to_light = vec3_normalized(c->light);
    double got = corner_intensity(c->normal, to_light);
    long double cosine = real3_dot(real3_from(c->normal), real3_unit(real3_from(c->light)));
    if (cosine < -1e-15L) {
        return got == 0 && !signbit(got) ? 0 : (double)INFINITY;
    }
    return (double)fabsl((cosine > 0 ? cosine : 0) - (long double)got) * 0x1p52;
}

/* The error of both parts, in units of rounding: each power may add one. */
static double parts_error(const void *tried) {
    const struct corner_case *c = tried;
    const struct material *m = &c->material;
    struct light_parts got = corner_light(c->position, c->normal, c->light, c->camera, m);
    struct real3 n = real3_from(c->normal), p = real3_from(c->position);
    struct real3 l = real3_unit(real3_sub(real3_from(c->light), p));
    struct real3 t = real3_unit(real3_sub(real3_from(c->camera), p));
    long double facing = real3_dot(n, l);
    long double shining = 2 * facing * real3_dot(n, t) - real3_dot(l, t);
    if (fabsl(facing) < 1e-14L || fabsl(shining) < 1e-14L) {
        /* Along the surface: rounding decides whether anything shines. */
        return isfinite(got.diffuse) && isfinite(got.specular) ? 0 : (double)INFINITY;
    }
    long double diffuse = 0, specular = 0;
    if (facing > 0) {
        diffuse = m->diffuse * exact_power(facing, m->diffuse_power);
        specular = m->specular * exact_power(fmaxl(shining, 0), m->specular_power);
    }
    long double first = fabsl(diffuse - (long double)got.diffuse) / (1 + m->diffuse_power);
    long double second = fabsl(specular - (long double)got.specular) / (1 + m->specular_power);
    return (double)(first + second) * 0x1p52;
}

/* The sum of the three kinds that each panel shows. */
static struct real3 exact_panel(int panel, long double diffuse, long double specular,
                                const struct material *m) {
    static const bool shown[4][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
    long double surface = shown[panel][0] ? m->ambient : 0;
    surface += shown[panel][1] ? diffuse : 0;
    return real3_add(real3_scale(real3_from(m->surface_color), surface), real3_from(m->light_color),
                     shown[panel][2] ? specular : 0);
}

static bool panels_are_right(const void *tried) {
    const struct corner_case *c = tried;
    struct light_parts parts = {fabs(c->normal.x), fabs(c->normal.y)};
    for (int i = 0; i < 4; i++) {
        struct color color = panel_color(&panels[i], parts, &c->material);
        if (!color_is_right(color, exact_panel(i, parts.diffuse, parts.specular, &c->material))) {
            return false;
        }
    }
    return true;
}

static void print_corner(const void *failing) {
    const struct corner_case *c = failing;
    const struct vec3 v[] = {c->position, c->normal, c->light, c->camera};
    static const char *const names[] = {"position", "normal", "light", "camera"};
    for (int i = 0; i < 4; i++) {
        printf("    %s %.17g %.17g %.17g\n", names[i], v[i].x, v[i].y, v[i].z);
    }
    printf("    weights %.17g %.17g %.17g, powers %d %d\n", c->material.ambient,
           c->material.diffuse, c->material.specular, c->material.diffuse_power,
           c->material.specular_power);
}

/* ---- Between the corners ---- */

struct smooth_case {
    struct layers layers;
    double value[LAYER_COUNT][3][3]; /* of a corner: up to three numbers */
};

static void make_smooth(struct random *random, uint64_t index, void *made) {
    struct smooth_case *c = made;
    make_layers(random, index, &c->layers);
    for (int i = 0; i < LAYER_COUNT * 9; i++) { /* also what no corner should have */
        bool beyond = random_bits(random) % 8 == 0;
        c->value[i / 9][i / 3 % 3][i % 3] =
            beyond ? random_real(random, -2, 2) : random_real(random, 0, 1);
    }
}

/* Number `which` of a layer at a pixel. */
static long double smooth_value(const struct smooth_case *c, int layer, int which, int x, int y) {
    const double value[3] = {c->value[layer][0][which], c->value[layer][1][which],
                             c->value[layer][2][which]};
    return layer_value(&c->layers, layer, value, x, y);
}

typedef void draw_smooth(struct canvas *canvas, const struct edges *edges,
                         const struct vertex v[3]);

/* Draw all layers into one picture, or the four of scene lit; returns the work done. */
static struct canvas draw_layers(const struct smooth_case *c, draw_smooth *draw, bool skip,
                                 struct image *image) {
    double depth[SCREEN_WIDTH * SCREEN_HEIGHT];
    struct canvas canvas = {.image = image,
                            .width = SCREEN_WIDTH,
                            .height = SCREEN_HEIGHT,
                            .depth = depth,
                            .material = &clay,
                            .skip = skip};
    depth_clear(depth, SCREEN_WIDTH * SCREEN_HEIGHT);
    for (int i = 0; i < LAYER_COUNT; i++) {
        const struct fixed2 *p = c->layers.corner[i];
        struct vertex v[3];
        for (int k = 0; k < 3; k++) {
            const double *value = c->value[i][k];
            v[k] = (struct vertex){p[k],
                                   c->layers.depth[i][k],
                                   value[0],
                                   {value[0], value[1], value[2]},
                                   {value[0], value[1]}};
        }
        struct edges edges;
        if (edges_setup(&edges, p[0], p[1], p[2], SCREEN_WIDTH, SCREEN_HEIGHT)) {
            draw(&canvas, &edges, v);
        }
    }
    return canvas;
}

/* Is this what the layer looks like at the pixel, in panel (column, row)? */
typedef bool is_smooth(const struct smooth_case *c, int layer, int panel, int x, int y,
                       struct color color);

static bool is_grey(const struct smooth_case *c, int layer, int panel, int x, int y,
                    struct color color) {
    long double level = 255 * smooth_value(c, layer, 0, x, y);
    (void)panel;
    return color_is_right(color, (struct real3){level, level, level});
}

static bool is_colored(const struct smooth_case *c, int layer, int panel, int x, int y,
                       struct color color) {
    (void)panel;
    return color_is_right(color, (struct real3){255 * smooth_value(c, layer, 0, x, y),
                                                255 * smooth_value(c, layer, 1, x, y),
                                                255 * smooth_value(c, layer, 2, x, y)});
}

/* The ambient part stands above left, the diffuse above right, the specular below left. */
static bool is_lit(const struct smooth_case *c, int layer, int panel, int x, int y,
                   struct color color) {
    return color_is_right(color, exact_panel(panel, smooth_value(c, layer, 0, x, y),
                                             smooth_value(c, layer, 1, x, y), &clay));
}

/* Every pixel shows one of the layers that may be seen there; where there is none it is black. */
static bool picture_is_right(const struct smooth_case *c, const struct image *image, int panel,
                             is_smooth *looks_right) {
    static const int column[4] = {0, 1, 0, 1}, row[4] = {1, 1, 0, 0};
    bool single = image->width == SCREEN_WIDTH;
    for (int i = 0; i < SCREEN_WIDTH * SCREEN_HEIGHT; i++) {
        int x = i % SCREEN_WIDTH, y = i / SCREEN_WIDTH;
        struct color color = image_get(image, x + (single ? 0 : column[panel] * SCREEN_WIDTH),
                                       y + (single ? 0 : row[panel] * SCREEN_HEIGHT));
        bool right = false, empty = true;
        for (int k = 0; k < LAYER_COUNT && !right; k++) {
            bool may_show = layer_may_show(&c->layers, k, x, y);
            empty = empty && !may_show;
            right = may_show && looks_right(c, k, panel, x, y, color);
        }
        if (empty ? (color.r | color.g | color.b) != 0 : !right) {
            return false;
        }
    }
    return true;
}

/* With and without what can be skipped. `side` pictures side by side and above one another. */
static bool smooth_is_right(const struct smooth_case *c, draw_smooth *draw, size_t side,
                            is_smooth *looks_right) {
    uint8_t pixels[4 * 3 * SCREEN_WIDTH * SCREEN_HEIGHT] = {0}, all_pixels[sizeof pixels] = {0};
    struct image image = {side * SCREEN_WIDTH, side * SCREEN_HEIGHT, IMAGE_BGR, pixels};
    struct image all_image = {side * SCREEN_WIDTH, side * SCREEN_HEIGHT, IMAGE_BGR, all_pixels};
    struct canvas canvas = draw_layers(c, draw, true, &image);
    struct canvas all = draw_layers(c, draw, false, &all_image);
    uint64_t covered = layers_pixel_count(&c->layers);
    bool right = memcmp(pixels, all_pixels, sizeof pixels) == 0 &&
                 canvas.pixels_tested == covered && all.pixels_tested == covered &&
                 all.pixels_shaded == covered && canvas.pixels_shaded <= covered;
    for (size_t i = 0; i < side * side && right; i++) {
        right = picture_is_right(c, &image, (int)i, looks_right);
    }
    return right;
}

static bool grey_is_right(const void *tried) {
    return smooth_is_right(tried, triangle, 1, is_grey);
}

static bool color_is_smooth(const void *tried) {
    return smooth_is_right(tried, color_triangle, 1, is_colored);
}

static bool lit_is_right(const void *tried) {
    return smooth_is_right(tried, lit_triangle, 2, is_lit);
}

static void print_smooth(const void *failing) {
    const struct smooth_case *c = failing;
    print_layers(&c->layers);
    for (int i = 0; i < LAYER_COUNT * 3; i++) {
        const double *value = c->value[i / 3][i % 3];
        printf("    corner %d of %d: %.17g %.17g %.17g\n", i % 3, i / 3, value[0], value[1],
               value[2]);
    }
}

static const struct case_kind corner_cases = {sizeof(struct corner_case), make_corner, print_corner,
                                              NULL};
static const struct case_kind smooth_cases = {sizeof(struct smooth_case), make_smooth, print_smooth,
                                              NULL};

const struct property lesson07_properties[] = {
    PROPERTY("lesson07: intensity at a corner", AGAINST_LONG_DOUBLE, 300000, corner_cases,
             .error = intensity_error, .limit = 4, .error_unit = "ulp of 1"),
    PROPERTY("lesson07: light at a corner", AGAINST_LONG_DOUBLE, 300000, corner_cases,
             .error = parts_error, .limit = 8, .error_unit = "ulp of 1 a factor"),
    PROPERTY("lesson07: three kinds of light", AGAINST_LONG_DOUBLE, 200000, corner_cases,
             .holds = panels_are_right),
    PROPERTY("lesson07: smooth intensity", AGAINST_LONG_DOUBLE, 50000, smooth_cases,
             .holds = grey_is_right),
    PROPERTY("lesson07: smooth colours", AGAINST_LONG_DOUBLE, 50000, smooth_cases,
             .holds = color_is_smooth),
    PROPERTY("lesson07: smooth light", AGAINST_LONG_DOUBLE, 30000, smooth_cases,
             .holds = lit_is_right),
    {.name = NULL},
};
