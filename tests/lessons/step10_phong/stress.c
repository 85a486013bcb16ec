/* Lesson 10: what it hands over at a corner, and its six fragment functions. */
#define LESSON "../step10_phong/main.c"
#include "lesson.h"

#include "upkeep/stress/lessons.h"
#include "upkeep/stress/stress.h"

struct phong_case {
    struct one_face face;
    struct vec3 normal, to_light, eye, position;
    struct material material;
    struct picture diffuse, normal_map, specular;
    struct vec2 uv;
};

static void make_phong(struct random *random, uint64_t index, void *made) {
    struct phong_case *c = made;
    make_face(random, index, &c->face);
    make_picture(random, &c->diffuse);
    make_picture(random, &c->normal_map);
    make_picture(random, &c->specular);
    c->normal = vec3_scale(random_direction(random), random_real(random, 0.5, 1));
    c->to_light = random_direction(random);
    c->position = random_vector(random, 1);
    c->eye = index % 32 == 0 ? c->position : random_vector(random, 3);
    c->uv = random_uv(random);
    if (index % 2) { /* look into the mirrored light */
        struct vec3 n = vec3_normalized(c->normal), l = c->to_light;
        struct vec3 r = vec3_sub(vec3_scale(n, 2 * vec3_dot(n, l)), l);
        c->eye = vec3_add(vec3_add(c->position, vec3_scale(r, 5)), random_vector(random, 1));
    }
    if (index % 32 == 2) {
        c->normal = (struct vec3){0, 0, 0};
    }
    c->material =
        (struct material){.ambient = random_real(random, 0, 0.3),
                          .diffuse = random_real(random, 0, 1),
                          .specular = random_real(random, 0, 1),
                          .power = (int)random_between(random, 0, 80),
                          .color = {random_real(random, 0, 255), random_real(random, 0, 255),
                                    random_real(random, 0, 255)}};
}

/* ---- At the corners ---- */

/* Towards the eye, texture coordinates, normal of length 1. */
static bool corners_are_right(const void *tried) {
    struct phong_case c = *(const struct phong_case *)tried;
    struct model model = model_of(&c.face);
    const struct uniforms u = {.model = &model, .eye = c.eye};
    bool right = true;
    for (size_t i = 0; i < 3; i++) {
        double without[8] = {0}, v[8] = {0};
        vertex(&u, 0, i, without);
        vertex_with_normal(&u, 0, i, v);
        struct real3 p = real3_sub(real3_from(c.eye), real3_from(c.face.position[i]));
        struct real3 n = face_normal(&c.face, i);
        const long double exact[8] = {
            p.x, p.y, p.z, (long double)c.face.uv[i][0], (long double)c.face.uv[i][1],
            n.x, n.y, n.z};
        for (int k = 0; k < 8; k++) {
            long double slack = k < 3 ? 0x1p-53L * (1 + real3_length(p)) : k < 5 ? 0 : 0x1p-51L;
            right = right && is_near(v[k], exact[k], slack) && (k >= 5 || without[k] == v[k]);
        }
    }
    return right;
}

/* ---- At the pixels ---- */

/* Textures of diffuse, normal map and specular map. */
struct textures {
    struct texture diffuse, normal_map, specular;
};

/* A fragment function, and what it reads from textures. */
struct fragment {
    fragment_function *draw;
    bool normal, color; /* instead of the mesh's, of the material's */
    bool weight, power; /* of the mirrored part */
};

static const struct fragment fragments[] = {
    {plain_fragment, false, false, false, false},   {mapped_fragment, true, false, false, false},
    {textured_fragment, false, true, false, false}, {full_fragment, true, true, false, false},
    {weight_map_fragment, true, true, true, false}, {power_map_fragment, true, true, false, true},
};

/* Is it 0 itself, as where there is no normal, or clearly something else? */
static bool is_certain(long double number, long double slack) {
    return number == 0 || fabsl(number) >= slack;
}

/* Diffuse and specular intensity; n, l, e of length 1 or 0. False along the surface or across the
 * mirrored light, where rounding decides what shines. */
static bool exact_light(struct real3 n, struct real3 l, struct real3 e, int power,
                        long double roundings, long double *diffuse, long double *specular) {
    long double slack = fmaxl(1e-13L, real_slack(roundings)), facing = real3_dot(n, l);
    long double mirrored = 2 * facing * real3_dot(n, e) - real3_dot(l, e);
    *diffuse = fmaxl(facing, 0);
    *specular = facing > 0 ? exact_power(fmaxl(mirrored, 0), power) : 0;
    return is_certain(facing, slack) && is_certain(mirrored, slack);
}

static bool fragment_is_right(const struct phong_case *c, const struct textures *textures,
                              const struct fragment *f) {
    const struct uniforms u = {.diffuse = &textures->diffuse,
                               .normal_map = &textures->normal_map,
                               .specular = &textures->specular,
                               .diffuse_level = c->diffuse.level,
                               .normal_level = c->normal_map.level,
                               .specular_level = c->specular.level,
                               .eye = c->eye,
                               .to_light = c->to_light,
                               .material = c->material};
    struct vec3 to_eye = vec3_sub(c->eye, c->position);
    const double varyings[8] = {to_eye.x, to_eye.y,    to_eye.z,    c->uv.x,
                                c->uv.y,  c->normal.x, c->normal.y, c->normal.z};
    struct pixel_color pixel = shade_pixel(f->draw, &u, varyings, 8);
    /* What the directions cost, and then what lies in the light that they mirror. */
    long double mapping, roundings = 16, diffuse, specular;
    struct real3 map_normal =
        exact_normal(&textures->normal_map, c->normal_map.level, c->uv, &mapping);
    struct real3 n = f->normal ? map_normal : real3_unit(real3_from(c->normal));
    struct real3 e = real3_unit(real3_from(to_eye));
    struct real3 texel = exact_color(&textures->diffuse, c->diffuse.level, c->uv);
    struct real3 surface = f->color ? texel : real3_from(c->material.color);
    long double shine = exact_color(&textures->specular, c->specular.level, c->uv).z;
    long double weight = c->material.specular * (f->weight ? shine / 255 : 1);
    int power = f->power ? 1 + (int)shine / 8 : c->material.power;
    roundings += f->normal ? 4 * mapping : 0;
    /* On the border of two powers rounding decides, too. */
    bool decided =
        exact_light(n, real3_from(c->to_light), e, power, roundings, &diffuse, &specular) &&
        fabsl(shine / 8 - roundl(shine / 8)) >= fmaxl(1e-13L, real_slack(32 * TEXEL_ROUNDINGS));
    struct real3 exact = real3_scale(surface, c->material.ambient + c->material.diffuse * diffuse);
    exact = real3_add(exact, (struct real3){255, 255, 255}, weight * specular);
    roundings = 2 * TEXEL_ROUNDINGS + roundings * (2 + power);
    return pixel.drawn && (!decided || color_is_near(pixel.color, exact, roundings));
}

static bool pixels_are_right(const void *tried) {
    const struct phong_case *c = tried;
    struct textures textures = {.diffuse = {0}};
    bool right = texture_of_picture(&c->diffuse, &textures.diffuse) &&
                 texture_of_picture(&c->normal_map, &textures.normal_map) &&
                 texture_of_picture(&c->specular, &textures.specular);
    for (size_t i = 0; right && i < sizeof fragments / sizeof fragments[0]; i++) {
        right = fragment_is_right(c, &textures, &fragments[i]);
    }
    texture_free(&textures.diffuse);
    texture_free(&textures.normal_map);
    texture_free(&textures.specular);
    return right;
}

const struct property lesson10_properties[] = {
    PROPERTY("lesson10: at the corners", AGAINST_LONG_DOUBLE, 100000, struct phong_case, make_phong,
             .holds = corners_are_right),
    PROPERTY("lesson10: at the pixels", AGAINST_LONG_DOUBLE, 200000, struct phong_case, make_phong,
             .holds = pixels_are_right),
    {.name = NULL},
};
