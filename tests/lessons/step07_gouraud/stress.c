/* Lesson 7: light at the corners, and what is interpolated between them. */
#define LESSON "../step07_gouraud/main.c"
#include "lesson.h"

#include "upkeep/stress/lessons.h"
#include "upkeep/stress/stress.h"

/* ---- Light at a corner ---- */

struct corner_case {
    struct vec3 position, normal, light, camera;
    struct material material;
};

/* Lights and cameras on all sides, now and then where the position is or in the mirror's way;
 * sometimes there is no normal. */
static void make_corner(struct random *random, uint64_t index, void *made) {
    struct corner_case *c = made;
    c->position = random_vector(random, 1);
    c->normal = vec3_scale(random_direction(random), index % 32 == 3 ? 0 : 1);
    c->light = index % 32 == 0 ? c->position : random_vector(random, 3);
    c->camera = index % 32 == 1 ? c->position : random_vector(random, 3);
    if (index % 4 == 2) { /* look into the mirrored light: the specular part is large */
        struct vec3 l = vec3_sub(c->light, c->position);
        struct vec3 s = vec3_sub(vec3_scale(c->normal, 2 * vec3_dot(c->normal, l)), l);
        c->camera = vec3_add(vec3_add(c->position, s), random_vector(random, 1));
    }
    c->material.diffuse = random_real(random, 0, 1);
    c->material.specular = random_real(random, 0, 1);
    c->material.diffuse_power = (int)random_between(random, 0, 4);
    c->material.specular_power = (int)random_between(random, 0, 80);
}

/* The error of the intensity and of both parts, in units of rounding: each power may add one. */
static double parts_error(const void *tried) {
    const struct corner_case *c = tried;
    const struct material *m = &c->material;
    struct light_parts got = corner_light(c->position, c->normal, c->light, c->camera, m);
    struct real3 n = real3_from(c->normal), p = real3_from(c->position);
    struct real3 l = real3_unit(real3_sub(real3_from(c->light), p));
    struct real3 t = real3_unit(real3_sub(real3_from(c->camera), p));
    long double facing = real3_dot(n, l);
    long double shining = 2 * facing * real3_dot(n, t) - real3_dot(l, t);
    double intensity =
        corner_intensity(c->normal, vec3_normalized(vec3_sub(c->light, c->position)));
    if ((facing != 0 && fabsl(facing) < 1e-14L) || (shining != 0 && fabsl(shining) < 1e-14L)) {
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
    long double third = fabsl(fmaxl(facing, 0) - (long double)intensity);
    return (double)(first + second + third) * 0x1p52;
}

/* ---- Between the corners ---- */

/* What is interpolated: an intensity, a colour, or the two parts of the light. */
enum kind { GREY, COLORED, LIT, KINDS };

typedef void draw_smooth(const struct canvas *canvas, const struct edges *edges,
                         const struct vertex v[3]);

static draw_smooth *const smooth[KINDS] = {triangle, color_triangle, lit_triangle};

struct smooth_case {
    struct layers layers;
    double value[LAYER_COUNT][3][3]; /* of a corner: up to three numbers */
    uint64_t kind;
};

static void make_smooth(struct random *random, uint64_t index, void *made) {
    struct smooth_case *c = made;
    make_layers(random, index, &c->layers);
    c->kind = random_bits(random) % KINDS;
    for (int i = 0; i < LAYER_COUNT * 9; i++) { /* also what no corner should have */
        bool beyond = random_bits(random) % 8 == 0;
        c->value[i / 9][i / 3 % 3][i % 3] =
            beyond ? random_real(random, -2, 2) : random_real(random, 0, 1);
    }
}

static void draw_layers(const void *tried, struct image *image, double *depth) {
    const struct smooth_case *c = tried;
    struct canvas canvas = {
        .image = image, .width = SCREEN_WIDTH, .height = SCREEN_HEIGHT, .material = &clay};
    canvas.depth = depth;
    for (int i = 0; i < LAYER_COUNT; i++) {
        const struct fixed2 *p = c->layers.corner[i];
        struct vertex v[3];
        struct edges edges;
        for (int k = 0; k < 3; k++) {
            const double *a = c->value[i][k];
            v[k] = (struct vertex){
                p[k], c->layers.depth[i][k], a[0], {a[0], a[1], a[2]}, {a[0], a[1]}};
        }
        if (edges_setup(&edges, p[0], p[1], p[2], SCREEN_WIDTH, SCREEN_HEIGHT)) {
            smooth[c->kind](&canvas, &edges, v);
        }
    }
}

/* Ambient above left, diffuse above right, specular below left, all below right. */
static struct real3 exact_light(int picture, long double diffuse, long double specular) {
    static const bool shown[4][3] = {{0, 0, 1}, {1, 1, 1}, {1, 0, 0}, {0, 1, 0}};
    long double surface = shown[picture][0] ? clay.ambient : 0;
    surface += shown[picture][1] ? diffuse : 0;
    return real3_add(real3_scale(real3_from(clay.surface_color), surface),
                     real3_from(clay.light_color), shown[picture][2] ? specular : 0);
}

static bool is_smooth(const void *tried, int layer, int picture, int x, int y, struct color color) {
    const struct smooth_case *c = tried;
    long double a[3];
    for (int i = 0; i < 3; i++) {
        int which = c->kind == GREY ? 0 : i;
        const double value[3] = {c->value[layer][0][which], c->value[layer][1][which],
                                 c->value[layer][2][which]};
        a[i] = layer_value(&c->layers, layer, value, x, y);
    }
    struct real3 plain = {255 * a[0], 255 * a[1], 255 * a[2]};
    return color_is_right(color, c->kind == LIT ? exact_light(picture, a[0], a[1]) : plain);
}

static bool smooth_is_right(const void *tried) {
    const struct smooth_case *c = tried;
    const struct layered layered = {&c->layers, c, c->kind == LIT ? 2 : 1, draw_layers, is_smooth};
    return layers_are_right(&layered);
}

const struct property lesson07_properties[] = {
    PROPERTY("lesson07: light at a corner", AGAINST_LONG_DOUBLE, 300000, struct corner_case,
             make_corner, .error = parts_error, .limit = 8, .error_unit = "ulp of 1 a factor"),
    PROPERTY("lesson07: smooth between corners", AGAINST_LONG_DOUBLE, 100000, struct smooth_case,
             make_smooth, .holds = smooth_is_right),
    {.name = NULL},
};
