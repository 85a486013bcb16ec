/* Step 7: light at the corners. */
#define LESSON "../step07_gouraud/main.c"
#include "lesson.h"

#include "upkeep/stress/lessons.h"
#include "upkeep/stress/stress.h"

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

static const struct case_kind corner_cases = {.size = sizeof(struct corner_case),
                                              .make = make_corner};

const struct property lesson07_properties[] = {
    PROPERTY("lesson07: light at a corner", AGAINST_LONG_DOUBLE, 300000, corner_cases,
             .error = parts_error, .limit = 8, .error_unit = "ulp of 1 a factor"),
    {.name = NULL},
};
