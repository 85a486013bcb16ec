/*
 * Lesson 7: flat, Gouraud, or a normal per pixel, on spheres of few and of many triangles.
 *
 * The exact answer is the true sphere in long double: its normal is the point itself. One panel has
 * diffuse light, n . l. The other has a highlight, (r . v)^8 as in scene lit, which changes faster.
 */
#include "bench/bench.h"
#include "geometry.h"

INLINED double corner_intensity(struct vec3 normal, struct vec3 to_light);
INLINED double integer_power(double base, int power);

#define LESSON "../step07_gouraud/main.c"
#include "lesson.h"

#include "../../../step07_gouraud/attempts.h"

enum { SIDE = 512, MESH_COUNT = 5, SHINE_POWER = 8 };
enum { DIFFUSE, HIGHLIGHT, LIGHT_COUNT };
enum { FLAT, GOURAUD, PER_PIXEL, WAY_COUNT };

/* The side of a sphere that faces the viewer. */
struct mesh {
    struct attempt_face *faces;
    size_t count;
};

static struct {
    struct image image;
    double depth[SIDE * SIDE];
    struct vec3 light; /* of length 1, towards the light */
    struct mesh meshes[MESH_COUNT];
    long double exact[LIGHT_COUNT][SIDE * SIDE]; /* levels of the sphere; negative off it */
    size_t pixels;                               /* of the sphere */
} work;

/* ---- Light ---- */

/* The highlight for a viewer far away at +z: main.c's specular part without its weight. */
INLINED double shine(struct vec3 normal, struct vec3 to_light) {
    double facing = vec3_dot(normal, to_light);
    double shining = 2 * facing * normal.z - to_light.z;
    return facing > 0 && shining > 0 ? integer_power(shining, SHINE_POWER) : 0;
}

INLINED double light_on(struct vec3 normal, struct vec3 to_light, int kind) {
    return kind == DIFFUSE ? corner_intensity(normal, to_light) : shine(normal, to_light);
}

/* ---- The versions ---- */

/* The intensity at a pixel; `way` and `kind` are constants where this is used. */
INLINED double intensity_at(struct vec3 weight, const struct vertex v[3], const struct vec3 n[3],
                            struct vec3 light, int way, int kind) {
    if (way == FLAT) {
        return v[0].intensity;
    }
    struct vec3 normal = vec3_renormalized(vec3_interpolate(weight, n[0], n[1], n[2]));
    return light_on(normal, light, kind);
}

/* triangle() of main.c, line by line, except for the intensity. */
INLINED void shaded_triangle(const struct canvas *canvas, const struct edges *edges,
                             const struct vertex v[3], const struct vec3 n[3], struct vec3 light,
                             int way, int kind) {
    for (int y = edges->y_begin; y < edges->y_end; y++) {
        struct span span = edges_span(edges, y);
        for (int x = span.begin; x < span.end; x++) {
            struct vec3 weight = edges_weights(edges, x, y);
            if (!depth_test(canvas, v, weight, x, y)) {
                continue;
            }
            double intensity = intensity_at(weight, v, n, light, way, kind);
            image_set(canvas->image, x, y, color_grey(level_from(intensity * 255)));
        }
    }
}

INLINED void shaded_mesh(const struct canvas *canvas, const struct mesh *mesh, struct vec3 light,
                         int way, int kind) {
    for (size_t i = 0; i < mesh->count; i++) {
        const struct attempt_face *face = &mesh->faces[i];
        struct vertex v[3] = {face->vertices[0], face->vertices[1], face->vertices[2]};
        struct edges edges;
        if (!edges_setup(&edges, v[0].position, v[1].position, v[2].position, SIDE, SIDE)) {
            continue;
        }
        for (int k = 0; k < 3 && way == GOURAUD; k++) {
            v[k].intensity = light_on(face->normals[k], light, kind);
        }
        if (way == GOURAUD) {
            triangle(canvas, &edges, v);
            continue;
        }
        if (way == FLAT) {
            v[0].intensity = light_on(face->face_normal, light, kind);
        }
        shaded_triangle(canvas, &edges, v, face->normals, light, way, kind);
    }
}

typedef void mesh_function(const struct canvas *canvas, const struct mesh *mesh, struct vec3 light);

#define WAY(name, way, kind)                                                                       \
    static void name(const struct canvas *canvas, const struct mesh *mesh, struct vec3 light) {    \
        shaded_mesh(canvas, mesh, light, way, kind);                                               \
    }
WAY(flat_diffuse, FLAT, DIFFUSE)
WAY(gouraud_diffuse, GOURAUD, DIFFUSE)
WAY(per_pixel_diffuse, PER_PIXEL, DIFFUSE)
WAY(flat_highlight, FLAT, HIGHLIGHT)
WAY(gouraud_highlight, GOURAUD, HIGHLIGHT)
WAY(per_pixel_highlight, PER_PIXEL, HIGHLIGHT)

static mesh_function *const ways[LIGHT_COUNT][WAY_COUNT] = {
    {flat_diffuse, gouraud_diffuse, per_pixel_diffuse},
    {flat_highlight, gouraud_highlight, per_pixel_highlight},
};

/* What is worked on: a kind of light, which the panel says, and a mesh. */
#define LIGHT(kind) ((kind)*MESH_COUNT)

static void run(struct bench_choice choice) {
    const struct canvas canvas = {
        .image = &work.image, .width = SIDE, .height = SIDE, .depth = work.depth};
    depth_clear(work.depth, (size_t)SIDE * SIDE);
    ways[choice.on / MESH_COUNT][choice.way](&canvas, &work.meshes[choice.on % MESH_COUNT],
                                             work.light);
}

/* Root of the mean squared error over the pixels that the sphere and its triangles share. */
static double error_of(struct bench_choice choice) {
    const long double *exact = work.exact[choice.on / MESH_COUNT];
    long double sum = 0, pixels = 0;
    for (size_t i = 0; i < (size_t)SIDE * SIDE; i++) {
        if (exact[i] >= 0 && work.depth[i] > -INFINITY) {
            long double error = work.image.pixels[i] - exact[i];
            sum += error * error;
            pixels++;
        }
    }
    return (double)sqrtl(sum / pixels);
}

/* ---- Spheres ---- */

/* A canvas, first, so that attempt_sphere() can hand it on, and where its faces are collected. */
struct collector {
    struct canvas canvas;
    struct mesh *mesh;
};

static void collect_face(const struct canvas *canvas, struct attempt_face *face,
                         struct vec3 light) {
    struct mesh *mesh = ((const struct collector *)canvas)->mesh;
    (void)light;
    mesh->faces[mesh->count++] = *face;
}

/* Of 128, 512, 2,048, 8,192 and 32,768 triangles; those that face the viewer are kept. */
static void make_meshes(void) {
    for (int i = 0; i < MESH_COUNT; i++) {
        struct mesh *mesh = &work.meshes[i];
        struct collector collector = {{.width = SIDE, .height = SIDE, .depth = work.depth}, mesh};
        mesh->faces = bench_memory(8U << 2 * (i + 2), sizeof *mesh->faces);
        attempt_sphere(&collector.canvas, i + 2, work.light, collect_face);
    }
}

/* ---- Setting up ---- */

/* The levels of the true sphere at the centre of a pixel; negative off the sphere. */
static void sphere_levels(int x, int y, struct vec3 light, long double levels[LIGHT_COUNT]) {
    long double nx = (2 * (x + 0.5L) / SIDE - 1) / ATTEMPT_RADIUS;
    long double ny = (2 * (y + 0.5L) / SIDE - 1) / ATTEMPT_RADIUS;
    long double square = 1 - nx * nx - ny * ny;
    if (square < 0) {
        levels[DIFFUSE] = levels[HIGHLIGHT] = -1;
        return;
    }
    long double nz = sqrtl(square), cosine = nx * light.x + ny * light.y + nz * light.z;
    long double mirrored = 2 * cosine * nz - light.z;
    levels[DIFFUSE] = cosine > 0 ? 255 * cosine : 0;
    levels[HIGHLIGHT] = cosine > 0 && mirrored > 0 ? 255 * powl(mirrored, SHINE_POWER) : 0;
}

static bool setup(struct error *error) {
    work.light = vec3_normalized((struct vec3){1, 2, 2});
    for (int i = 0; i < SIDE * SIDE; i++) {
        long double levels[LIGHT_COUNT];
        sphere_levels(i % SIDE, i / SIDE, work.light, levels);
        work.exact[DIFFUSE][i] = levels[DIFFUSE];
        work.exact[HIGHLIGHT][i] = levels[HIGHLIGHT];
        work.pixels += levels[DIFFUSE] >= 0;
    }
    make_meshes();
    return image_create(&work.image, SIDE, SIDE, IMAGE_GREY, error);
}

/* ---- The panels ---- */

#define MESHES(macro, series, way)                                                                 \
    macro(series, "128", way, 0), macro(series, "512", way, 1), macro(series, "2,048", way, 2),    \
        macro(series, "8,192", way, 3), macro(series, "32,768", way, 4)

static const struct bench_version sphere_versions[] = {
    MESHES(VERSION_OF, "flat", FLAT),
    MESHES(HOUSE_VERSION_OF, "Gouraud", GOURAUD),
    MESHES(VERSION_OF, "normal per pixel", PER_PIXEL),
};

#define SPHERES(heading, kind)                                                                     \
    {                                                                                              \
        .title = (heading), .error_label = "values, root mean square",                             \
        .time_label = "ns per pixel", .against = "the true sphere, long double", .run = run,       \
        .error = error_of, .units = &work.pixels, .on = LIGHT(kind),                               \
        BENCH_VERSIONS(sphere_versions),                                                           \
    }

static const struct bench_panel bench_panels[] = {
    SPHERES("Diffuse light on spheres of 128 to 32,768 triangles, 512x512", DIFFUSE),
    SPHERES("A highlight on the same spheres", HIGHLIGHT),
};

const struct bench_lesson bench_step07 =
    BENCH_LESSON("step07_gouraud", "Lesson 7: light on a round body", setup, bench_panels);
