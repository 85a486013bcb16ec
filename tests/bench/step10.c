/*
 * Step 10: ways to compute the power, and details from a normal map or from a finer mesh.
 *
 * The exact answer is Phong's formula in long double: on the bust for what the pipeline
 * interpolated at the pixel, on the sphere for the point of the true surface that a ray through
 * the pixel hits.
 */
#define main step10_main
int step10_main(int argc, char **argv);
#include "../../step10_phong/main.c"
#undef main

#include "../../step10_phong/attempts.h"

#include "bench.h"

#include <stdlib.h>
#include <string.h>
#ifdef _OPENMP
#include <omp.h>
#endif

enum { SIDE = 600, SHARP_POWER = 80, MESHES = 4, COARSEST_ROWS = 16, MAP_HEIGHT = 512 };

static const struct vec3 light = {1, 1, 1};

/* Uniforms, and the table for attempt 3; shaders of main.c see only the former. */
struct lit {
    struct uniforms u;
    struct power_table table;
};

struct work {
    struct model bust;
    struct lit lit;
    struct model meshes[MESHES]; /* of the sphere, each of four times the triangles */
    struct texture ripples;      /* normal map of the sphere */
    struct uniforms sphere;      /* but for the model */
    struct pipeline pipeline;
    struct image image;
};

/* Draw a model with one thread. False when memory runs out. */
static bool draw(struct work *work, const struct model *model, struct vec3 eye,
                 const struct shader *shader, const void *uniforms) {
    struct error error;
    struct draw_call call = camera_call(model, eye, (struct vec3){0, 0, 0}, (struct vec3){0, 1, 0},
                                        0.8, (struct rectangle){0, 0, SIDE, SIDE}, CULL_BACK);
    pipeline_clear(&work->pipeline);
    memset(work->image.pixels, 0, (size_t)SIDE * SIDE * IMAGE_BGR);
#ifdef _OPENMP
    int threads = omp_get_max_threads();
    omp_set_num_threads(1);
#endif
    bool done = pipeline_draw(&work->pipeline, &call, shader, uniforms, &work->image, &error);
#ifdef _OPENMP
    omp_set_num_threads(threads);
#endif
    return done;
}

/* ---- Phong's formula in long double ---- */

struct real3 {
    long double x, y, z;
};

static struct real3 real_from(struct vec3 a) {
    return (struct real3){a.x, a.y, a.z};
}

static long double real_dot(struct real3 a, struct real3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/* a + factor * b */
static struct real3 real_add(struct real3 a, long double factor, struct real3 b) {
    return (struct real3){a.x + factor * b.x, a.y + factor * b.y, a.z + factor * b.z};
}

static struct real3 real_normalized(struct real3 a) {
    const struct real3 zero = {0, 0, 0};
    return real_add(zero, 1 / sqrtl(real_dot(a, a)), a);
}

/* The exact level, rounded to the nearest whole one, of a channel whose colour is `channel`. */
static int exact_level(const struct material *material, double channel, struct real3 normal,
                       struct real3 position, struct real3 eye) {
    struct real3 to_light = real_normalized(real_from(light));
    struct real3 to_eye = real_normalized(real_add(eye, -1, position));
    long double diffuse = real_dot(normal, to_light), power = 1;
    if (diffuse <= 0) {
        return (int)(channel * material->ambient + 0.5);
    }
    /* (2 (n . l) n - l) . v */
    long double mirrored = 2 * diffuse * real_dot(normal, to_eye) - real_dot(to_light, to_eye);
    for (int i = 0; i < material->power; i++) {
        power *= mirrored > 0 ? mirrored : 0;
    }
    long double level = channel * (material->ambient + material->diffuse * diffuse) +
                        255 * (long double)material->specular * power;
    return level >= 255 ? 255 : (int)(level + 0.5L);
}

static double squared_error(struct color color, const struct material *material,
                            struct real3 normal, struct real3 position, struct real3 eye) {
    const struct vec4 *c = &material->color;
    double r = color.r - exact_level(material, c->x, normal, position, eye);
    double g = color.g - exact_level(material, c->y, normal, position, eye);
    double b = color.b - exact_level(material, c->z, normal, position, eye);
    return (r * r + g * g + b * b) / 3;
}

/* ---- The power, on the bust ---- */

enum { POW, REPEATED, SQUARED, TABLE, SCHLICK, SHORT_NORMAL, POWERS };

/* plain_fragment() with another way to compute the power. */
static inline struct color light_by(int way, const struct lit *lit, const double *varyings) {
    const struct uniforms *u = &lit->u;
    struct vec3 normal = mesh_normal(varyings);
    struct vec3 to_eye = vec3_normalized(vec3_sub(u->eye, position_of(varyings)));
    double diffuse = vec3_dot(normal, u->to_light), specular = 0;
    if (diffuse > 0) {
        double mirrored = vec3_dot(reflect(normal, u->to_light), to_eye);
        mirrored = mirrored > 0 ? mirrored : 0;
        specular = way == POW        ? attempt_1_pow(mirrored, u->material.power)
                   : way == REPEATED ? attempt_2_repeated(mirrored, u->material.power)
                   : way == TABLE    ? attempt_3_table(&lit->table, mirrored)
                                     : attempt_4_schlick(mirrored, u->material.power);
    }
    double scattered = u->material.ambient + u->material.diffuse * (diffuse > 0 ? diffuse : 0);
    double shine = 255 * u->material.specular * specular;
    struct vec4 rgb = u->material.color;
    return color_rgb(level_from(rgb.x * scattered + shine), level_from(rgb.y * scattered + shine),
                     level_from(rgb.z * scattered + shine));
}

static bool pow_fragment(const void *uniforms, const double *varyings, struct color *color) {
    *color = light_by(POW, uniforms, varyings);
    return true;
}

static bool repeated_fragment(const void *uniforms, const double *varyings, struct color *color) {
    *color = light_by(REPEATED, uniforms, varyings);
    return true;
}

static bool table_fragment(const void *uniforms, const double *varyings, struct color *color) {
    *color = light_by(TABLE, uniforms, varyings);
    return true;
}

static bool schlick_fragment(const void *uniforms, const double *varyings, struct color *color) {
    *color = light_by(SCHLICK, uniforms, varyings);
    return true;
}

SHADER(pow_shader, .varying_count = 8, .vertex = vertex_with_normal, .fragment = pow_fragment);
SHADER(repeated_shader, .varying_count = 8, .vertex = vertex_with_normal,
       .fragment = repeated_fragment);
SHADER(squared_shader, .varying_count = 8, .vertex = vertex_with_normal,
       .fragment = plain_fragment);
SHADER(table_shader, .varying_count = 8, .vertex = vertex_with_normal, .fragment = table_fragment);
SHADER(schlick_shader, .varying_count = 8, .vertex = vertex_with_normal,
       .fragment = schlick_fragment);
SHADER(short_normal_shader, .varying_count = 8, .vertex = vertex_with_normal,
       .fragment = attempt_5_not_normalized);

static const struct shader *const power_shaders[POWERS] = {
    [POW] = &pow_shader,     [REPEATED] = &repeated_shader, [SQUARED] = &squared_shader,
    [TABLE] = &table_shader, [SCHLICK] = &schlick_shader,   [SHORT_NORMAL] = &short_normal_shader,
};

static const struct vec3 bust_eye = {1, 0.5, 3};

static void run_power(void *state, int choice) {
    struct work *work = state;
    draw(work, &work->bust, bust_eye, power_shaders[choice], &work->lit);
}

/* A shader around another one, which compares each of its colours with the exact one. */
struct measuring {
    const struct lit *lit;
    const struct shader *shader;
    double *sum, *pixels;
};

static void measuring_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    vertex_with_normal(((const struct measuring *)uniforms)->lit, face, corner, varyings);
}

static bool measuring_fragment(const void *uniforms, const double *varyings, struct color *color) {
    const struct measuring *m = uniforms;
    struct real3 normal = {varyings[5], varyings[6], varyings[7]};
    m->shader->fragment(m->lit, varyings, color);
    *m->sum += squared_error(*color, &m->lit->u.material, real_normalized(normal),
                             real_from(position_of(varyings)), real_from(m->lit->u.eye));
    ++*m->pixels;
    return true;
}

SHADER(measuring_shader, .varying_count = 8, .vertex = measuring_vertex,
       .fragment = measuring_fragment);

static double error_power(void *state, int choice) {
    struct work *work = state;
    double sum = 0, pixels = 0;
    struct measuring measuring = {&work->lit, power_shaders[choice], &sum, &pixels};
    bool done = draw(work, &work->bust, bust_eye, &measuring_shader, &measuring);
    return done ? sqrt(sum / pixels) : (double)INFINITY;
}

/* ---- Details: a sphere with ripples, which are in its normals only ---- */

/* The normal of the surface in direction d from the center: leaning away from where it rises. */
static struct real3 rippled_normal(struct real3 d) {
    const long double often = 40, slope = 0.35L;
    const struct real3 rise = {cosl(often * d.x), cosl(often * d.y), cosl(often * d.z)};
    struct real3 along = real_add(rise, -real_dot(rise, d), d);
    return real_normalized(real_add(d, -slope, along));
}

/* The direction of texture coordinate (u, v): v = 0 is the south pole, v = 1 the north pole. */
static struct real3 direction_at(long double u, long double v) {
    const long double pi = 3.14159265358979323846L;
    long double around = 2 * pi * u, up = pi * v;
    return (struct real3){sinl(up) * sinl(around), -cosl(up), sinl(up) * cosl(around)};
}

static bool make_ripples(struct texture *texture, struct error *error) {
    struct image image;
    if (!image_create(&image, 2 * MAP_HEIGHT, MAP_HEIGHT, IMAGE_BGR, error)) {
        return false;
    }
    for (int y = 0; y < MAP_HEIGHT; y++) {
        for (int x = 0; x < 2 * MAP_HEIGHT; x++) {
            struct real3 n = rippled_normal(
                direction_at((x + 0.5L) / (2 * MAP_HEIGHT), (y + 0.5L) / MAP_HEIGHT));
            image_set(&image, x, y,
                      color_rgb(level_from((double)(n.x + 1) * 127.5),
                                level_from((double)(n.y + 1) * 127.5),
                                level_from((double)(n.z + 1) * 127.5)));
        }
    }
    bool done = texture_create(texture, &image, error);
    image_free(&image);
    return done;
}

static void set_corner(struct model *model, size_t i, long double u, long double v) {
    struct real3 d = direction_at(u, v), n = rippled_normal(d);
    const float normal[3] = {(float)n.x, (float)n.y, (float)n.z};
    model->positions[i] = (struct vec3){(double)d.x, (double)d.y, (double)d.z};
    memcpy(model->normals[i], normal, sizeof normal);
    model->uvs[i][0] = (float)u;
    model->uvs[i][1] = (float)v;
}

static void add_face(struct model *model, size_t a, size_t b, size_t c) {
    struct corner corner[3] = {
        {.position = (uint32_t)a}, {.position = (uint32_t)b}, {.position = (uint32_t)c}};
    for (int i = 0; i < 3; i++) {
        corner[i].uv = corner[i].normal = corner[i].position;
        model->faces[model->face_count].corner[i] = corner[i];
    }
    model->face_count++;
}

/* A sphere of radius 1: `rows` rows of twice as many squares, cut in two; triangles at the
 * poles. */
static bool make_sphere(struct model *model, size_t rows, struct error *error) {
    size_t columns = 2 * rows, corners = (rows + 1) * (columns + 1);
    *model =
        (struct model){.position_count = corners, .uv_count = corners, .normal_count = corners};
    model->positions = calloc(corners, sizeof *model->positions);
    model->uvs = calloc(corners, sizeof *model->uvs);
    model->normals = calloc(corners, sizeof *model->normals);
    model->faces = calloc(2 * rows * columns, sizeof *model->faces);
    if (model->positions == NULL || model->uvs == NULL || model->normals == NULL ||
        model->faces == NULL) {
        return error_out_of_memory(error);
    }
    for (size_t row = 0; row <= rows; row++) {
        for (size_t column = 0; column <= columns; column++) {
            set_corner(model, row * (columns + 1) + column,
                       (long double)column / (long double)columns,
                       (long double)row / (long double)rows);
        }
    }
    for (size_t row = 0; row < rows; row++) {
        for (size_t column = 0; column < columns; column++) {
            size_t a = row * (columns + 1) + column, b = a + columns + 1;
            if (row > 0) {
                add_face(model, a, a + 1, b + 1);
            }
            if (row + 1 < rows) {
                add_face(model, a, b + 1, b);
            }
        }
    }
    return true;
}

/* The versions: a mesh, and where its normals come from. */
#define WITH_MAP MESHES

static const struct vec3 sphere_eye = {0, 0, 3};

static void run_detail(void *state, int choice) {
    struct work *work = state;
    struct uniforms u = work->sphere;
    u.model = &work->meshes[choice % MESHES];
    draw(work, u.model, sphere_eye, choice < WITH_MAP ? &plain : &mapped, &u);
}

/* Where the ray through the centre of a pixel meets the sphere. The camera of draw() shows what
 * lies in the plane z = 0 at 0.8 of its size; -1..1 fill the picture. */
static bool hit_sphere(int x, int y, struct real3 *hit) {
    const struct real3 eye = real_from(sphere_eye);
    struct real3 through = {((x + 0.5L) * 2 / SIDE - 1) / 0.8L, ((y + 0.5L) * 2 / SIDE - 1) / 0.8L,
                            0};
    struct real3 ray = real_normalized(real_add(through, -1, eye));
    long double nearest = -real_dot(eye, ray);
    long double square = 1 - (real_dot(eye, eye) - nearest * nearest);
    *hit = real_add(eye, nearest - sqrtl(square > 0 ? square : 0), ray);
    return square >= 0;
}

/* Over the pixels that the mesh covers; it lies within the sphere. */
static double error_detail(void *state, int choice) {
    struct work *work = state;
    double sum = 0, pixels = 0;
    run_detail(state, choice);
    for (int i = 0; i < SIDE * SIDE; i++) {
        struct real3 hit;
        struct color color = image_get(&work->image, i % SIDE, i / SIDE);
        if (color.r > 0 && hit_sphere(i % SIDE, i / SIDE, &hit)) { /* ambient light is everywhere */
            sum += squared_error(color, &work->sphere.material, rippled_normal(hit), hit,
                                 real_from(sphere_eye));
            pixels++;
        }
    }
    return sqrt(sum / pixels);
}

/* ---- Setting up ---- */

static bool make_lit(struct work *work, struct error *error) {
    work->lit.u = (struct uniforms){.model = &work->bust,
                                    .eye = bust_eye,
                                    .to_light = vec3_normalized(light),
                                    .material = plain_material};
    work->lit.u.material.power = SHARP_POWER;
    work->lit.table = attempt_3_make_table(SHARP_POWER);
    return bench_read_model(&work->bust, "bust.obj", error) &&
           model_need_normals(&work->bust, error);
}

static bool make_details(struct work *work, struct error *error) {
    bool done = make_ripples(&work->ripples, error);
    for (int i = 0; done && i < MESHES; i++) {
        done = make_sphere(&work->meshes[i], (size_t)COARSEST_ROWS << i, error);
    }
    if (done) {
        work->sphere = (struct uniforms){.eye = sphere_eye,
                                         .to_light = vec3_normalized(light),
                                         .material = plain_material,
                                         .normal_map = &work->ripples,
                                         .normal_level = wrapped_level(&work->ripples, 0.8 * SIDE)};
    }
    return done;
}

static bool setup(void **state, struct error *error) {
    struct work *work = calloc(1, sizeof *work);
    *state = work;
    if (work == NULL) {
        return error_out_of_memory(error);
    }
    return image_create(&work->image, SIDE, SIDE, IMAGE_BGR, error) &&
           pipeline_create(&work->pipeline, SIDE, SIDE, error) && make_lit(work, error) &&
           make_details(work, error);
}

static void teardown(void *state) {
    struct work *work = state;
    if (work != NULL) {
        model_free(&work->bust);
        for (int i = 0; i < MESHES; i++) {
            model_free(&work->meshes[i]);
        }
        texture_free(&work->ripples);
        image_free(&work->image);
        pipeline_free(&work->pipeline);
    }
    free(work);
}

/* ---- The panels ---- */

#define POWER(label, way, house)                                                                   \
    {                                                                                              \
        .name = (label), .choice = (way), .is_house = (house), .run = run_power,                   \
        .error = error_power                                                                       \
    }
#define DETAIL(label, number, house)                                                               \
    {                                                                                              \
        .name = (label), .choice = (number), .is_house = (house), .run = run_detail,               \
        .error = error_detail                                                                      \
    }

static const struct bench_version power_versions[] = {
    POWER("pow()", POW, false),
    POWER("80 multiplications", REPEATED, false),
    POWER("integer power, squaring", SQUARED, true),
    POWER("table of 257", TABLE, false),
    POWER("Schlick's form", SCHLICK, false),
    POWER("normal not renormalised", SHORT_NORMAL, false),
};

static const struct bench_version detail_versions[] = {
    DETAIL("960 triangles", 0, false),
    DETAIL("3,968 triangles", 1, false),
    DETAIL("16,128 triangles", 2, false),
    DETAIL("65,024 triangles", 3, false),
    DETAIL("960 and a normal map", WITH_MAP + 0, true),
    DETAIL("3,968 and a normal map", WITH_MAP + 1, true),
    DETAIL("16,128 and a normal map", WITH_MAP + 2, true),
};

static const struct bench_panel bench_panels[] = {
    {.title = "The bust, power 80, 600x600 pixels, 1 thread",
     .error_label = "levels, root mean square",
     .time_label = "ms per frame",
     .against = "Phong's formula, long double",
     .versions = power_versions,
     .version_count = sizeof power_versions / sizeof power_versions[0]},
    {.title = "A rippled sphere: a finer mesh or a normal map",
     .error_label = "levels, root mean square",
     .time_label = "ms per frame",
     .against = "the true surface, long double",
     .versions = detail_versions,
     .version_count = sizeof detail_versions / sizeof detail_versions[0]},
};

const struct bench_lesson bench_step10 = {
    .step = "step10_phong",
    .title = "Step 10: Phong's light",
    .setup = setup,
    .teardown = teardown,
    .panels = bench_panels,
    .panel_count = sizeof bench_panels / sizeof bench_panels[0],
};
