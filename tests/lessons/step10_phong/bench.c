/*
 * Lesson 10: ways to compute the power, and details from a normal map or from a finer mesh.
 *
 * All are computed for sixteen pixels at once, as the lesson does. The exact answer is Phong's
 * formula in long double: on the bust for what the pipeline interpolated at the pixel, on the
 * sphere for the point of the true surface that a ray through the pixel hits.
 */
#define LESSON "../step10_phong/main.c"
#include "lesson.h"

#include "../../../step10_phong/attempts.h"

#include "bench/bench.h"
#include "files/normals.h"
#include "oracle/texels.h"

#include <stdlib.h>
#include <string.h>

enum { SIDE = 600, SHARP_POWER = 80, MESHES = 4, COARSEST_ROWS = 16, MAP_HEIGHT = 512 };

static const struct vec3 light = {1, 1, 1};

enum { TABLES = 3 };

/* What the ways to compute the power need. */
struct lit {
    struct uniforms u;
    struct power_table tables[TABLES];
};

enum { VARYINGS = 8 };

/* What the pipeline interpolated at LANES pixels. */
struct interpolated {
    real varyings[VARYINGS][LANES];
};

/* So many pixels of highlights, and their exact colours. */
struct lit_lanes {
    struct interpolated at;
    struct color exact[LANES];
};

static struct {
    struct model bust;
    struct lit lit;
    struct lit_lanes lit_lanes[SIDE * SIDE / LANES + 1];
    uint32_t colors[SIDE * SIDE + LANES]; /* what a version finds for them */
    size_t lit_count;            /* pixels; the last lanes may have some that do not count */
    struct model meshes[MESHES]; /* of the sphere, each of four times the triangles */
    struct texture ripples;      /* normal map of the sphere */
    struct uniforms sphere;      /* except for the model */
    struct pipeline pipeline;
    struct image image;
} work;

/* Draw a model with one thread. False when memory runs out. */
static bool draw(const struct model *model, struct vec3 eye, const struct shader *shader,
                 const void *uniforms, size_t size) {
    struct error error;
    struct draw_call call = camera_call(model, eye, (struct vec3){0, 0, 0}, (struct vec3){0, 1, 0},
                                        0.8, (struct rectangle){0, 0, SIDE, SIDE}, CULL_BACK);
    pipeline_clear(&work.pipeline);
    memset(work.image.pixels, 0, (size_t)SIDE * SIDE * IMAGE_BGR);
    pipeline_use_threads(&work.pipeline, 1);
    return pipeline_draw(&work.pipeline, &call, shader, uniforms, size, &error) &&
           pipeline_finish(&work.pipeline, &work.image, &error);
}

/* ---- Phong's formula in long double ---- */

/* The levels of the specular part; 0 where the surface is turned away from the light. */
static long double exact_shine(const struct material *material, struct real3 normal,
                               struct real3 towards_eye) {
    struct real3 to_light = real3_unit(real3_from(light));
    struct real3 to_eye = real3_unit(towards_eye);
    long double diffuse = real3_dot(normal, to_light), power = 1;
    /* (2 (n . l) n - l) . v */
    long double mirrored = 2 * diffuse * real3_dot(normal, to_eye) - real3_dot(to_light, to_eye);
    for (int i = 0; i < material->power; i++) {
        power *= mirrored > 0 ? mirrored : 0;
    }
    return diffuse > 0 ? 255 * (long double)material->specular * power : 0;
}

static struct color exact_color(const struct material *material, struct real3 normal,
                                struct real3 towards_eye) {
    long double shine = exact_shine(material, normal, towards_eye);
    long double diffuse = real3_dot(normal, real3_unit(real3_from(light)));
    long double scattered = material->ambient + material->diffuse * (diffuse > 0 ? diffuse : 0);
    const struct vec3 *c = &material->color;
    return color_rgb(level_from_real(c->x * scattered + shine),
                     level_from_real(c->y * scattered + shine),
                     level_from_real(c->z * scattered + shine));
}

static double squared_error(struct color a, struct color b) {
    return ((a.r - b.r) * (a.r - b.r) + (a.g - b.g) * (a.g - b.g) + (a.b - b.b) * (a.b - b.b)) /
           3.0;
}

/* ---- The power, in the highlights of the bust ---- */

enum power_way {
    POW,
    REPEATED,
    SQUARED,
    TABLE_64,
    TABLE_257,
    TABLE_1024,
    SCHLICK,
    SHORT_NORMAL,
    POWERS
};

/* base^power in one of the ways. */
static inline lanes power_by(enum power_way way, const struct lit *lit, lanes base) {
    int power = lit->u.material.power;
    switch (way) {
    case POW:
        return attempt_1_pow(base, power);
    case REPEATED:
        return attempt_2_repeated(base, power);
    case TABLE_64:
        return attempt_3_table(&lit->tables[0], base);
    case TABLE_257:
        return attempt_3_table(&lit->tables[1], base);
    case TABLE_1024:
        return attempt_3_table(&lit->tables[2], base);
    case SCHLICK:
        return attempt_4_schlick(base, power);
    default:
        return integer_power(base, lanes_all((real)power), power);
    }
}

static inline struct lanes3 normal_by(enum power_way way, const lanes *varyings) {
    struct lanes3 as_it_is = {varyings[5], varyings[6], varyings[7]};
    return way == SHORT_NORMAL ? as_it_is : mesh_normal(varyings);
}

/* plain_fragment() with another way to find the specular part. */
static inline lanes_texel light_by(enum power_way way, const struct lit *lit,
                                   const lanes *varyings) {
    const struct material *material = &lit->u.material;
    struct lanes3 normal = normal_by(way, varyings), to_light = lanes3_all(lit->u.to_light);
    struct lanes3 to_eye = {varyings[0], varyings[1], varyings[2]};
    lanes zero = lanes_all(0), diffuse = lanes3_dot(normal, to_light);
    lanes near = lanes_max(lanes3_dot(reflect(normal, to_light), lanes3_normalized(to_eye)), zero);
    lanes specular = lanes_select(diffuse > 0, power_by(way, lit, near), zero);
    lanes scattered = (real)material->ambient + (real)material->diffuse * lanes_max(diffuse, zero);
    lanes shine = 255 * (real)material->specular * specular;
    struct lanes3 rgb = lanes3_all(material->color);
    return lanes_rgb(rgb.x * scattered + shine, rgb.y * scattered + shine,
                     rgb.z * scattered + shine);
}

/* The loop over pixels in each of the ways. */
#define LIGHT_ALL(name, way)                                                                       \
    static FLATTEN void name(void) {                                                               \
        for (size_t i = 0; i * LANES < work.lit_count; i++) {                                      \
            lanes varyings[VARYINGS];                                                              \
            memcpy(varyings, work.lit_lanes[i].at.varyings, sizeof varyings);                      \
            lanes_texel color = light_by(way, &work.lit, varyings);                                \
            memcpy(work.colors + i * LANES, &color, sizeof color);                                 \
        }                                                                                          \
    }

LIGHT_ALL(light_by_pow, POW)
LIGHT_ALL(light_by_repeated, REPEATED)
LIGHT_ALL(light_by_squared, SQUARED)
LIGHT_ALL(light_by_table_64, TABLE_64)
LIGHT_ALL(light_by_table_257, TABLE_257)
LIGHT_ALL(light_by_table_1024, TABLE_1024)
LIGHT_ALL(light_by_schlick, SCHLICK)
LIGHT_ALL(light_by_short_normal, SHORT_NORMAL)

static void (*const lights[POWERS])(void) = {
    [POW] = light_by_pow,
    [REPEATED] = light_by_repeated,
    [SQUARED] = light_by_squared,
    [TABLE_64] = light_by_table_64,
    [TABLE_257] = light_by_table_257,
    [TABLE_1024] = light_by_table_1024,
    [SCHLICK] = light_by_schlick,
    [SHORT_NORMAL] = light_by_short_normal,
};

static void run_power(struct bench_choice choice) {
    lights[choice.way]();
}

/* Root of the mean squared error of a channel. */
static double error_power(struct bench_choice choice) {
    double sum = 0;
    (void)choice;
    for (size_t i = 0; i < work.lit_count; i++) {
        sum += squared_error(color_from_texel(work.colors[i]),
                             work.lit_lanes[i / LANES].exact[i % LANES]);
    }
    return sqrt(sum / (double)work.lit_count);
}

/* ---- Which pixels these are ---- */

static const struct vec3 bust_eye = {1, 0.5, 3};

/* A shader that keeps what it gets. The colour of a pixel says where: 1 + LANES * the call + lane.
 * So the calls may shade pixels that are not drawn. */
struct kept {
    struct interpolated *calls;
    size_t count, capacity;
};

struct keeping {
    const struct uniforms *u;
    struct kept *kept;
};

static void keeping_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    vertex_with_normal(((const struct keeping *)uniforms)->u, face, corner, varyings);
}

static lanes_mask keeping_fragment(const void *uniforms, const lanes *varyings,
                                   lanes_texel *color) {
    struct kept *kept = ((const struct keeping *)uniforms)->kept;
    *color = (lanes_texel)lanes_int_from((int)(1 + LANES * kept->count));
    if (kept->count < kept->capacity) {
        memcpy(kept->calls[kept->count++].varyings, varyings, VARYINGS * sizeof *varyings);
    }
    return lanes_all_set();
}

SHADER(keeping_shader, .varying_count = VARYINGS, .vertex = keeping_vertex,
       .fragment = keeping_fragment);

/* Where the light adds at least a level. */
static void keep_if_lit(const struct interpolated *call, size_t lane) {
    real v[VARYINGS];
    for (int k = 0; k < VARYINGS; k++) {
        v[k] = call->varyings[k][lane];
    }
    const struct material *material = &work.lit.u.material;
    struct real3 normal = real3_unit((struct real3){v[5], v[6], v[7]});
    struct real3 to_eye = {v[0], v[1], v[2]};
    if (exact_shine(material, normal, to_eye) < 1) {
        return;
    }
    struct lit_lanes *lit = &work.lit_lanes[work.lit_count / LANES];
    lane = work.lit_count++ % LANES;
    for (int k = 0; k < VARYINGS; k++) {
        lit->at.varyings[k][lane] = v[k];
    }
    lit->exact[lane] = exact_color(material, normal, to_eye);
}

static void keep_lit_pixels(const struct kept *kept) {
    for (int i = 0; i < SIDE * SIDE; i++) {
        struct color c = image_get(&work.image, i % SIDE, i / SIDE);
        size_t place = (size_t)c.b | (size_t)c.g << 8 | (size_t)c.r << 16;
        if (place > 0) {
            keep_if_lit(&kept->calls[(place - 1) / LANES], (place - 1) % LANES);
        }
    }
}

static bool find_highlights(struct error *error) {
    struct kept kept = {.capacity =
                            (size_t)SIDE * (SIDE + CHUNK_WIDTH) / LANES}; /* of a whole picture */
    struct keeping keeping = {&work.lit.u, &kept};
    kept.calls = bench_memory(kept.capacity, sizeof *kept.calls);
    bool done = draw(&work.bust, bust_eye, &keeping_shader, &keeping, sizeof keeping);
    if (done) {
        keep_lit_pixels(&kept);
    }
    free(kept.calls);
    return done || error_out_of_memory(error);
}

/* ---- Details: a sphere with ripples, which are in its normals only ---- */

/* The normal of the surface in direction d from the center: leaning away from where it rises. */
static struct real3 rippled_normal(struct real3 d) {
    const long double often = 40, slope = 0.35L;
    const struct real3 rise = {cosl(often * d.x), cosl(often * d.y), cosl(often * d.z)};
    struct real3 along = real3_add(rise, d, -real3_dot(rise, d));
    return real3_unit(real3_add(d, along, -slope));
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
    const long double normal[3] = {n.x, n.y, n.z};
    model->positions[i] = (struct vec3){(double)d.x, (double)d.y, (double)d.z};
    for (int k = 0; k < 3; k++) {
        model->normals[i][k] = (float)normal[k];
    }
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
static void make_sphere(struct model *model, size_t rows) {
    size_t columns = 2 * rows, corners = (rows + 1) * (columns + 1);
    *model =
        (struct model){.position_count = corners, .uv_count = corners, .normal_count = corners};
    model->positions = bench_memory(corners, sizeof *model->positions);
    model->uvs = bench_memory(corners, sizeof *model->uvs);
    model->normals = bench_memory(corners, sizeof *model->normals);
    model->faces = bench_memory(2 * rows * columns, sizeof *model->faces);
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
}

/* Where the normals come from. */
enum { OF_MESH, OF_MAP };

static const struct vec3 sphere_eye = {0, 0, 3};

static void run_detail(struct bench_choice choice) {
    struct uniforms u = work.sphere;
    u.model = &work.meshes[choice.on];
    draw(u.model, sphere_eye, choice.way == OF_MESH ? &plain : &mapped, &u, sizeof u);
}

/* Where the ray through the centre of a pixel meets the sphere. The camera of draw() shows what
 * lies in the plane z = 0 at 0.8 of its size; -1..1 fill the picture. */
static bool hit_sphere(int x, int y, struct real3 *hit) {
    const struct real3 eye = real3_from(sphere_eye);
    struct real3 through = {((x + 0.5L) * 2 / SIDE - 1) / 0.8L, ((y + 0.5L) * 2 / SIDE - 1) / 0.8L,
                            0};
    struct real3 ray = real3_unit(real3_sub(through, eye));
    long double nearest = -real3_dot(eye, ray);
    long double square = 1 - (real3_dot(eye, eye) - nearest * nearest);
    *hit = real3_add(eye, ray, nearest - sqrtl(square > 0 ? square : 0));
    return square >= 0;
}

/* Over the pixels that the mesh covers; it lies within the sphere. */
static double error_detail(struct bench_choice choice) {
    double sum = 0, pixels = 0;
    (void)choice;
    for (int i = 0; i < SIDE * SIDE; i++) {
        struct real3 hit;
        struct color color = image_get(&work.image, i % SIDE, i / SIDE);
        if (color.r > 0 && hit_sphere(i % SIDE, i / SIDE, &hit)) { /* ambient light is everywhere */
            sum += squared_error(color, exact_color(&work.sphere.material, rippled_normal(hit),
                                                    real3_sub(real3_from(sphere_eye), hit)));
            pixels++;
        }
    }
    return sqrt(sum / pixels);
}

/* ---- Setting up ---- */

static bool make_lit(struct error *error) {
    work.lit.u = (struct uniforms){.model = &work.bust,
                                   .eye = bust_eye,
                                   .to_light = vec3_normalized(light),
                                   .material = plain_material};
    work.lit.u.material.power = SHARP_POWER;
    work.lit.tables[0] = attempt_3_make_table(64, SHARP_POWER);
    work.lit.tables[1] = attempt_3_make_table(257, SHARP_POWER);
    work.lit.tables[2] = attempt_3_make_table(1024, SHARP_POWER);
    return model_read(&work.bust, BENCH_MODEL("bust.obj"), error) &&
           model_need_normals(&work.bust, error) && find_highlights(error);
}

static bool make_details(struct error *error) {
    for (int i = 0; i < MESHES; i++) {
        make_sphere(&work.meshes[i], (size_t)COARSEST_ROWS << i);
    }
    if (!make_ripples(&work.ripples, error)) {
        return false;
    }
    work.sphere =
        (struct uniforms){.eye = sphere_eye,
                          .to_light = vec3_normalized(light),
                          .material = plain_material,
                          .normal_map = &work.ripples,
                          .normal_level = texture_wrapped_level(&work.ripples, 0.8 * SIDE)};
    return true;
}

static bool setup(struct error *error) {
    return image_create(&work.image, SIDE, SIDE, IMAGE_BGR, error) &&
           pipeline_create(&work.pipeline, SIDE, SIDE, error) && make_lit(error) &&
           make_details(error);
}

/* ---- The panels ---- */

static const struct bench_version power_versions[] = {
    VERSION("pow()", POW),
    VERSION("80 multiplications", REPEATED),
    HOUSE_VERSION("integer power, squaring", SQUARED),
    VERSION_OF("table of", "64", TABLE_64, 0),
    VERSION_OF("table of", "257", TABLE_257, 0),
    VERSION_OF("table of", "1,024", TABLE_1024, 0),
    VERSION("Schlick's form", SCHLICK),
    VERSION("normal not renormalised", SHORT_NORMAL),
};

static const char mesh_series[] = "normals of the mesh, triangles";
static const char map_series[] = "normal map, triangles";

static const struct bench_version detail_versions[] = {
    VERSION_OF(mesh_series, "960", OF_MESH, 0),
    VERSION_OF(mesh_series, "3,968", OF_MESH, 1),
    VERSION_OF(mesh_series, "16,128", OF_MESH, 2),
    VERSION_OF(mesh_series, "65,024", OF_MESH, 3),
    HOUSE_VERSION_OF(map_series, "960", OF_MAP, 0),
    HOUSE_VERSION_OF(map_series, "3,968", OF_MAP, 1),
    HOUSE_VERSION_OF(map_series, "16,128", OF_MAP, 2),
};

static const struct bench_panel bench_panels[] = {
    {.title = "Pixels of the bust's highlights, power 80",
     .error_label = "values, root mean square",
     .time_label = "ns per pixel",
     .against = "Phong's formula, long double",
     .run = run_power,
     .error = error_power,
     .units = &work.lit_count,
     BENCH_VERSIONS(power_versions),
     .house_within = 0.05},
    {.title = "A rippled sphere: a finer mesh or a normal map",
     .error_label = "values, root mean square",
     .time_label = "ms per frame",
     .against = "the true surface, long double",
     .run = run_detail,
     .error = error_detail,
     BENCH_VERSIONS(detail_versions)},
};

const struct bench_lesson bench_step10 =
    BENCH_LESSON("step10_phong", "Lesson 10: Phong's light", setup, bench_panels);
