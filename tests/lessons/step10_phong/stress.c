/* Step 10: powers, mirrored light, the sum of the three parts, and its six fragment functions. */
#define LESSON "../step10_phong/main.c"
#include "lesson.h"

#include "upkeep/stress/lessons.h"
#include "upkeep/stress/stress.h"

#include <stdio.h>

enum { MOST_POWER = 80 };

/* ---- Powers ---- */

struct power_case {
    double base;
    int power;
};

static void make_power(struct random *random, uint64_t index, void *made) {
    static const double special[] = {0, 1, -1, 0.5, 1e-200, -0.0};
    struct power_case *c = made;
    c->base = index % 8 == 0 ? special[random_bits(random) % 6] : random_real(random, -1, 1);
    c->power = (int)(index / 8 % (MOST_POWER + 1));
}

static long double exact_power(long double base, int power) {
    long double product = 1;
    for (int i = 0; i < power; i++) {
        product *= base;
    }
    return product;
}

/* In ulp for each factor, when powers are at most `largest`. */
static double power_error_among(const struct power_case *c, int largest) {
    real base = (real)c->base;
    long double exact = exact_power((long double)base, c->power);
    lanes power = integer_power(lanes_holding((double)base), lanes_holding(c->power), largest);
    long double error = fabsl(exact - (long double)lane_of(power));
    if (error <= (sizeof(real) == sizeof(float) ? 0x1p-126L : 0x1p-1022L)) {
        return 0; /* too small for full precision */
    }
    return (double)(error / (fabsl(exact) * (1 + c->power) * 2 * real_ulp));
}

static double power_error(const void *tried) {
    const struct power_case *c = tried;
    return fmax(power_error_among(c, c->power), power_error_among(c, MOST_POWER));
}

static void print_power(const void *failing) {
    const struct power_case *c = failing;
    printf("    %.17g to the power of %d\n", c->base, c->power);
}

/* ---- Light ---- */

struct phong_case {
    struct mesh_data mesh;
    struct vec3 normal, to_light, eye, position;
    struct material material;
    struct picture_data diffuse, normal_map, specular;
    size_t diffuse_level, normal_level, specular_level;
    struct vec2 uv;
    double turns;
};

static void make_phong(struct random *random, uint64_t index, void *made) {
    struct phong_case *c = made;
    for (int i = 0; i < 3; i++) {
        c->mesh.position[i] = random_vector(random, 2);
        mesh_set(c->mesh.normal[i], random_vector(random, index % 2 ? 1 : 60));
        c->mesh.uv[i][0] = (float)random_real(random, -1, 2);
        c->mesh.uv[i][1] = (float)random_real(random, -1, 2);
    }
    c->normal = vec3_scale(random_direction(random), random_real(random, 0.5, 1));
    c->to_light = random_direction(random);
    c->position = random_vector(random, 1);
    c->eye = random_vector(random, 3);
    if (index % 2) { /* look into the mirrored light */
        struct vec3 n = vec3_normalized(c->normal), l = c->to_light;
        struct vec3 r = vec3_sub(vec3_scale(n, 2 * vec3_dot(n, l)), l);
        c->eye = vec3_add(vec3_add(c->position, vec3_scale(r, 5)), random_vector(random, 1));
    }
    c->material =
        (struct material){.ambient = random_real(random, 0, 0.3),
                          .diffuse = random_real(random, 0, 1),
                          .specular = random_real(random, 0, 1),
                          .power = (int)random_between(random, 0, MOST_POWER),
                          .color = {random_real(random, 0, 255), random_real(random, 0, 255),
                                    random_real(random, 0, 255)}};
    make_picture(random, &c->diffuse);
    make_picture(random, &c->normal_map);
    make_picture(random, &c->specular);
    c->diffuse_level = (size_t)random_between(random, 0, PICTURE_LEVELS - 1);
    c->normal_level = (size_t)random_between(random, 0, PICTURE_LEVELS - 1);
    c->specular_level = (size_t)random_between(random, 0, PICTURE_LEVELS - 1);
    c->uv = (struct vec2){random_real(random, -0.2, 1.2), random_real(random, -0.2, 1.2)};
    c->turns =
        index % 4 == 0 ? (double)random_between(random, 0, 8) / 8 : random_real(random, 0, 1);
}

/* <r,e>, with r the mirrored light and e the direction to the eye; n, l, e of length 1. */
static long double exact_mirrored(struct real3 n, struct real3 l, struct real3 e) {
    return 2 * real3_dot(n, l) * real3_dot(n, e) - real3_dot(l, e);
}

static struct lanes3 lanes3_holding(struct vec3 v) {
    return (struct lanes3){lanes_holding(v.x), lanes_holding(v.y), lanes_holding(v.z)};
}

static struct real3 lane3_of(struct lanes3 v) {
    return (struct real3){(long double)lane_of(v.x), (long double)lane_of(v.y),
                          (long double)lane_of(v.z)};
}

/* In ulp of 1. */
static double mirror_error(const void *tried) {
    const struct phong_case *c = tried;
    struct lanes3 normal = lanes3_holding(vec3_normalized(c->normal));
    struct lanes3 to_light = lanes3_holding(c->to_light);
    struct real3 n = lane3_of(normal), l = lane3_of(to_light);
    struct real3 got = lane3_of(reflect(normal, to_light));
    struct real3 exact = real3_sub(real3_scale(n, 2 * real3_dot(n, l)), l);
    return (double)(real3_length(real3_sub(got, exact)) / (2 * real_ulp));
}

/* Along the surface or across the mirrored light rounding decides what shines. */
static bool is_undecided(struct real3 n, struct real3 l, struct real3 e, long double roundings) {
    long double slack = real_slack(roundings, 1e-13L);
    return fabsl(real3_dot(n, l)) < slack || fabsl(exact_mirrored(n, l, e)) < slack;
}

/* Diffuse and specular intensity. */
struct real_light {
    long double diffuse, specular;
};

static struct real_light exact_light(struct real3 n, struct real3 l, struct real3 e, int power) {
    long double diffuse = real3_dot(n, l), mirrored = exact_mirrored(n, l, e);
    if (diffuse <= 0) {
        return (struct real_light){0, 0};
    }
    return (struct real_light){diffuse, exact_power(mirrored > 0 ? mirrored : 0, power)};
}

/* Of both parts together, in ulp of 1; the specular part for each factor. */
static double light_error(const void *tried) {
    const struct phong_case *c = tried;
    struct lanes3 normal = lanes3_holding(vec3_normalized(c->normal));
    struct lanes3 to_light = lanes3_holding(c->to_light);
    struct lanes3 to_eye = lanes3_holding(vec3_normalized(vec3_sub(c->eye, c->position)));
    struct real3 n = lane3_of(normal), l = lane3_of(to_light), e = lane3_of(to_eye);
    int power = c->material.power;
    struct lanes2 got = phong(normal, to_light, to_eye, lanes_holding(power), power);
    if (is_undecided(n, l, e, 16)) {
        return 0;
    }
    struct real_light exact = exact_light(n, l, e, power);
    long double first = fabsl(exact.diffuse - (long double)lane_of(got.x));
    long double second = fabsl(exact.specular - (long double)lane_of(got.y)) / (1 + power);
    return (double)((first + second) / (2 * real_ulp));
}

/* (sin a, 0, cos a) */
static bool turn_is_right(const void *tried) {
    double turns = ((const struct phong_case *)tried)->turns;
    struct vec3 got = turning_light(turns);
    long double angle = 2 * acosl(-1) * (long double)turns;
    return fabsl(sinl(angle) - (long double)got.x) <= 0x1p-51L && got.y == 0 &&
           fabsl(cosl(angle) - (long double)got.z) <= 0x1p-51L;
}

/* ---- At the corners ---- */

/* Towards the eye, texture coordinates, normal of length 1. */
static bool corners_are_right(const void *tried) {
    struct phong_case c = *(const struct phong_case *)tried;
    struct mesh mesh;
    mesh_from(&mesh, &c.mesh, 1);
    const struct uniforms u = {.model = &mesh.model, .eye = c.eye};
    for (size_t i = 0; i < 3; i++) {
        double without[8] = {0}, v[8] = {0};
        vertex(&u, 0, i, without);
        vertex_with_normal(&u, 0, i, v);
        struct real3 p = real3_sub(real3_from(c.eye), real3_from(c.mesh.position[i]));
        struct real3 n = real3_unit(mesh_get(c.mesh.normal[i]));
        const long double slack = 0x1p-53L * (1 + real3_length(p));
        const long double exact[8] = {
            p.x, p.y, p.z, (long double)c.mesh.uv[i][0], (long double)c.mesh.uv[i][1],
            n.x, n.y, n.z};
        for (int k = 0; k < 8; k++) {
            if (!(fabsl(exact[k] - (long double)v[k]) <= (k < 3   ? slack
                                                          : k < 5 ? 0
                                                                  : 0x1p-51L)) ||
                (k < 5 && without[k] != v[k])) {
                return false;
            }
        }
    }
    return true;
}

/* ---- At the pixels ---- */

struct pictures {
    struct texture diffuse, normal_map, specular;
};

/* What a fragment function reads, and how. */
struct fragment {
    lanes_mask (*draw)(const void *uniforms, const lanes *varyings, lanes_texel *color);
    bool mapped;   /* the normal comes from the map */
    bool textured; /* the colour comes from the texture */
    bool weight_from_map,
        power_from_map; /* so does the weight, or the power, of the mirrored part */
};

static const struct fragment fragments[] = {
    {plain_fragment, false, false, false, false},   {mapped_fragment, true, false, false, false},
    {textured_fragment, false, true, false, false}, {full_fragment, true, true, false, false},
    {weight_map_fragment, true, true, true, false}, {power_map_fragment, true, true, false, true},
};

static bool fragment_is_right(const struct phong_case *c, const struct pictures *pictures,
                              const struct fragment *f) {
    const struct uniforms u = {.diffuse = &pictures->diffuse,
                               .normal_map = &pictures->normal_map,
                               .specular = &pictures->specular,
                               .diffuse_level = c->diffuse_level,
                               .normal_level = c->normal_level,
                               .specular_level = c->specular_level,
                               .eye = c->eye,
                               .to_light = c->to_light,
                               .material = c->material};
    struct vec3 to_eye = vec3_sub(c->eye, c->position);
    const double varyings[8] = {to_eye.x, to_eye.y,    to_eye.z,    c->uv.x,
                                c->uv.y,  c->normal.x, c->normal.y, c->normal.z};
    struct pixel_color pixel = shade_pixel(f->draw, &u, varyings, 8);
    struct real3 n = f->mapped ? exact_normal(&pictures->normal_map, c->normal_level, c->uv)
                               : real3_unit(real3_from(c->normal));
    struct real3 l = real3_from(c->to_light);
    struct real3 e = real3_unit(real3_sub(real3_from(c->eye), real3_from(c->position)));
    struct real3 surface = {c->material.color.x, c->material.color.y, c->material.color.z};
    surface = f->textured ? exact_color(&pictures->diffuse, c->diffuse_level, c->uv) : surface;
    long double shine = exact_color(&pictures->specular, c->specular_level, c->uv).z;
    long double weight = c->material.specular * (f->weight_from_map ? shine / 255 : 1);
    int power = f->power_from_map ? 1 + (int)shine / 8 : c->material.power;
    /* What the directions cost, and then what lies in the light that they mirror. */
    long double roundings = 16;
    if (f->mapped) {
        roundings += 4 * normal_roundings(&pictures->normal_map, c->normal_level, c->uv);
    }
    /* On the border of two powers rounding decides. */
    bool undecided =
        is_undecided(n, l, e, roundings) ||
        fabsl(shine / 8 - roundl(shine / 8)) < real_slack(32 * TEXEL_ROUNDINGS, 1e-13L);
    struct real_light light = exact_light(n, l, e, power);
    long double scattered = c->material.ambient + c->material.diffuse * light.diffuse;
    long double mirrored = 255 * weight * light.specular;
    struct real3 exact = real3_scale(surface, scattered);
    exact = real3_add(exact, (struct real3){1, 1, 1}, mirrored);
    roundings = 2 * TEXEL_ROUNDINGS + roundings * (2 + power);
    return pixel.drawn && (undecided || color_is_near(pixel.color, exact, roundings));
}

static bool pixels_are_right(const void *tried) {
    const struct phong_case *c = tried;
    struct pictures pictures = {.diffuse = {0}};
    bool right = texture_of_picture(&c->diffuse, &pictures.diffuse) &&
                 texture_of_picture(&c->normal_map, &pictures.normal_map) &&
                 texture_of_picture(&c->specular, &pictures.specular);
    for (size_t i = 0; right && i < sizeof fragments / sizeof fragments[0]; i++) {
        right = fragment_is_right(c, &pictures, &fragments[i]);
    }
    texture_free(&pictures.diffuse);
    texture_free(&pictures.normal_map);
    texture_free(&pictures.specular);
    return right;
}

static void print_phong(const void *failing) {
    const struct phong_case *c = failing;
    const struct vec3 v[] = {c->normal, c->to_light, c->eye, c->position};
    static const char *const names[] = {"normal", "to light", "eye", "position"};
    for (int i = 0; i < 4; i++) {
        printf("    %s %.17g %.17g %.17g\n", names[i], v[i].x, v[i].y, v[i].z);
    }
    printf("    weights %.17g %.17g %.17g, power %d, uv %.17g %.17g, turns %.17g\n",
           c->material.ambient, c->material.diffuse, c->material.specular, c->material.power,
           c->uv.x, c->uv.y, c->turns);
}

static const struct case_kind power_cases = {sizeof(struct power_case), make_power, print_power,
                                             NULL};
static const struct case_kind phong_cases = {sizeof(struct phong_case), make_phong, print_phong,
                                             NULL};

const struct property lesson10_properties[] = {
    PROPERTY("lesson10: whole powers", AGAINST_LONG_DOUBLE, 300000, power_cases,
             .error = power_error, .limit = 1, .error_unit = "ulp a factor"),
    PROPERTY("lesson10: the mirrored light", AGAINST_LONG_DOUBLE, 100000, phong_cases,
             .error = mirror_error, .limit = 4, .error_unit = "ulp of 1"),
    PROPERTY("lesson10: diffuse and specular", AGAINST_LONG_DOUBLE, 200000, phong_cases,
             .error = light_error, .limit = 8, .error_unit = "ulp of 1 a factor"),
    PROPERTY("lesson10: the turning light", AGAINST_LONG_DOUBLE, 50000, phong_cases,
             .holds = turn_is_right),
    PROPERTY("lesson10: at the corners", AGAINST_LONG_DOUBLE, 100000, phong_cases,
             .holds = corners_are_right),
    PROPERTY("lesson10: at the pixels", AGAINST_LONG_DOUBLE, 200000, phong_cases,
             .holds = pixels_are_right),
    {.name = NULL},
};
