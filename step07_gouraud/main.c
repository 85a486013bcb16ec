/*
 * Lesson 7: light at the corners, smooth between them.
 *
 * A flat face shows that it is flat. Where the light is computed at the corners, from a normal that
 * all faces around a corner share, and interpolated in between, the same mesh looks round (Gouraud,
 * "Continuous shading of curved surfaces", 1971).
 */
#include "program.h"

#include <math.h>

/* ---- One intensity at each corner ---- */

/* How much light a surface takes. `normal` and `to_light` have length 1; the result is the cosine
 * of the angle between them, and 0 where the surface looks away from the light. */
static double corner_intensity(struct vec3 normal, struct vec3 to_light) {
    /* BEGIN SOLUTION 7a.1 intensity at a corner */
    double cosine = vec3_dot(normal, to_light);
    return cosine > 0 ? cosine : 0;
    /* STARTER
    (void)normal, (void)to_light; // to do 7a.1: n . l, and 0 where it is negative
    return 0;
    END SOLUTION */
}

/* A surface and its light. */
struct material {
    double ambient, diffuse, specular;      /* weights of the three kinds of light: aa, ad, as */
    int diffuse_power, specular_power;      /* the exponents kd and ks */
    struct vec3 surface_color, light_color; /* c and cl: red, green, blue 0..255 */
};

/* Of scene lit. */
static const struct material clay = {
    .ambient = 0.2,
    .diffuse = 0.7,
    .specular = 0.4,
    .diffuse_power = 1,
    .specular_power = 8,
    .surface_color = {225, 165, 130},
    .light_color = {255, 255, 255},
};

/* Of scene behind. */
static const struct material satin = {
    .ambient = 0.1,
    .diffuse = 0.8,
    .specular = 0.6,
    .diffuse_power = 2,
    .specular_power = 5,
    .surface_color = {90, 140, 220},
    .light_color = {255, 240, 200},
};

/* What differs from corner to corner of the three kinds of light; the ambient part does not. */
struct light_parts {
    double diffuse, specular; /* ad * (n . l)^kd and as * (r . v)^ks */
};

/* A corner of a triangle that is to be drawn. */
struct vertex {
    struct fixed2 position;   /* on the screen */
    double depth;             /* larger is nearer */
    double intensity;         /* scene gouraud: 0..1 */
    struct vec3 color;        /* scene colors: red, green, blue 0..1 */
    struct light_parts parts; /* scene lit */
};

/* What is drawn on. */
struct canvas {
    struct image *image;
    size_t width, height;            /* pixels of the image, or of one of the four pictures in it */
    double *depth;                   /* width * height, row by row from the bottom */
    const struct material *material; /* in scenes with three kinds of light */
};

/* The depth test of lesson 5: is the pixel nearer than what is there? Then its depth is kept. */
static bool depth_test(const struct canvas *canvas, const struct vertex v[3], struct vec3 weight,
                       int x, int y) {
    double *there = &canvas->depth[(size_t)y * canvas->width + (size_t)x];
    double depth = interpolate_depth(weight, v[0].depth, v[1].depth, v[2].depth);
    if (!(depth > *there)) {
        return false;
    }
    *there = depth;
    return true;
}

/* The triangle of lesson 5 with an intensity at each corner, interpolated in between. */
static void triangle(const struct canvas *canvas, const struct edges *edges,
                     const struct vertex v[3]) {
    for (int y = edges->y_begin; y < edges->y_end; y++) {
        struct span span = edges_span(edges, y);
        /* BEGIN SOLUTION 7a.2 intensity inside a triangle */
        for (int x = span.begin; x < span.end; x++) {
            struct vec3 weight = edges_weights(edges, x, y);
            if (!depth_test(canvas, v, weight, x, y)) {
                continue; /* what is hidden needs no colour */
            }
            double intensity = interpolate(weight, v[0].intensity, v[1].intensity, v[2].intensity);
            image_set(canvas->image, x, y, color_grey(level_from(intensity * 255)));
        }
        /* STARTER
        // to do 7a.2: for each pixel that passes the depth test interpolate the intensity
        (void)canvas, (void)v, (void)span, (void)depth_test;
        END SOLUTION */
    }
}

/* The same with a colour at each corner: three channels, each interpolated like the intensity. */
static void color_triangle(const struct canvas *canvas, const struct edges *edges,
                           const struct vertex v[3]) {
    for (int y = edges->y_begin; y < edges->y_end; y++) {
        struct span span = edges_span(edges, y);
        /* BEGIN SOLUTION 7a.3 colour inside a triangle */
        for (int x = span.begin; x < span.end; x++) {
            struct vec3 weight = edges_weights(edges, x, y);
            if (!depth_test(canvas, v, weight, x, y)) {
                continue;
            }
            struct vec3 c = vec3_interpolate(weight, v[0].color, v[1].color, v[2].color);
            struct color color =
                color_rgb(level_from(c.x * 255), level_from(c.y * 255), level_from(c.z * 255));
            image_set(canvas->image, x, y, color);
        }
        /* STARTER
        (void)canvas, (void)v, (void)span; // to do 7a.3: as in 7a.2, with red, green and blue
        END SOLUTION */
    }
}

/* ---- Three kinds of light ---- */

/* 1 * base * base * ... * base, `power` times. pow() of the C library may round differently on
 * another machine; a product never does. */
static double integer_power(double base, int power) {
    /* BEGIN SOLUTION 7b.1 power */
    double product = 1;
    for (int i = 0; i < power; i++) {
        product *= base;
    }
    return product;
    /* STARTER
    (void)power; // to do 7b.1: multiply
    return base;
    END SOLUTION */
}

/* The light that a point sends to the camera (Phong, "Illumination for computer generated
 * pictures", 1975). n is the normal, l the direction to the light, r the reflection vector, and v
 * the direction to the camera. A negative product counts as 0, and what looks away from the light
 * does not shine. */
static struct light_parts corner_light(struct vec3 position, struct vec3 normal, struct vec3 light,
                                       struct vec3 camera, const struct material *material) {
    struct light_parts parts = {0, 0};
    /* BEGIN SOLUTION 7b.2 light at a point */
    struct vec3 to_light = vec3_normalized(vec3_sub(light, position));
    struct vec3 to_camera = vec3_normalized(vec3_sub(camera, position));
    double facing = vec3_dot(normal, to_light);
    if (!(facing > 0)) {
        return parts;
    }
    parts.diffuse = material->diffuse * integer_power(facing, material->diffuse_power);
    struct vec3 mirrored = vec3_sub(vec3_scale(normal, 2 * facing), to_light);
    double shining = fmax(vec3_dot(mirrored, to_camera), 0);
    parts.specular = material->specular * integer_power(shining, material->specular_power);
    /* STARTER
    // to do 7b.2: find l, v, n . l, r and r . v, then both parts
    (void)position, (void)normal, (void)light, (void)camera, (void)material, (void)integer_power;
    END SOLUTION */
    return parts;
}

/* The four pictures of scene lit, and which parts each of them shows. */
enum { PANEL_COUNT = 4 };

static const struct panel {
    int column, row;                   /* 0 is left, 0 is below */
    double ambient, diffuse, specular; /* 1 or 0: shown or not */
} panels[PANEL_COUNT] = {
    {.column = 0, .row = 1, .ambient = 1},
    {.column = 1, .row = 1, .diffuse = 1},
    {.column = 0, .row = 0, .specular = 1},
    {.column = 1, .row = 0, .ambient = 1, .diffuse = 1, .specular = 1},
};

/* For each channel (panel->ambient * aa + panel->diffuse * diffuse part) * c + panel->specular *
 * specular part * cl. */
static struct color panel_color(const struct panel *panel, struct light_parts parts,
                                const struct material *material) {
    /* BEGIN SOLUTION 7b.3 light inside a triangle */
    struct vec3 c = material->surface_color, cl = material->light_color;
    double surface = panel->ambient * material->ambient + panel->diffuse * parts.diffuse;
    double shine = panel->specular * parts.specular;
    return color_rgb(level_from(surface * c.x + shine * cl.x),
                     level_from(surface * c.y + shine * cl.y),
                     level_from(surface * c.z + shine * cl.z));
    /* STARTER
    (void)panel, (void)parts, (void)material; // to do 7b.3: the sum
    return color_grey(0);
    END SOLUTION */
}

/* The triangle with the two parts interpolated. The panels show the same triangles, so one depth
 * test serves them all. */
static void lit_triangle(const struct canvas *canvas, const struct edges *edges,
                         const struct vertex v[3]) {
    for (int y = edges->y_begin; y < edges->y_end; y++) {
        struct span span = edges_span(edges, y);
        /* BEGIN SOLUTION 7b.3 light inside a triangle */
        for (int x = span.begin; x < span.end; x++) {
            struct vec3 weight = edges_weights(edges, x, y);
            if (!depth_test(canvas, v, weight, x, y)) {
                continue;
            }
            struct light_parts parts = {
                interpolate(weight, v[0].parts.diffuse, v[1].parts.diffuse, v[2].parts.diffuse),
                interpolate(weight, v[0].parts.specular, v[1].parts.specular, v[2].parts.specular),
            };
            for (size_t i = 0; i < PANEL_COUNT; i++) {
                image_set(canvas->image, x + panels[i].column * (int)canvas->width,
                          y + panels[i].row * (int)canvas->height,
                          panel_color(&panels[i], parts, canvas->material));
            }
        }
        /* STARTER
        // to do 7b.3: as in 7a.2, with both parts; each pixel that is seen is set in all panels
        (void)canvas, (void)v, (void)span, (void)panels, (void)panel_color;
        END SOLUTION */
    }
}

#include "scenes.h"

int main(int argc, char **argv) {
    return program_main(&step07_gouraud, argc, argv);
}
