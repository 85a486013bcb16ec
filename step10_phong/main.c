/*
 * Step 10: Phong's reflection model, at every pixel.
 *
 * The light that a pixel sends to the eye is the sum of three parts: ambient (from everywhere),
 * diffuse (scattered by the surface) and specular (mirrored towards the eye, more or less sharply).
 * The normal comes from the mesh or from the normal map, the colour from a constant or the texture.
 */
#include "pipeline_program.h"

/* How a surface answers to light. */
struct material {
    double ambient, diffuse, specular; /* weights of the three parts */
    int power;                         /* of the specular part: larger makes smaller lights */
    struct vec4 color;                 /* red, green, blue 0..255 */
};

/* What is the same for all pixels of a drawing. */
struct uniforms {
    const struct model *model;
    const struct texture *diffuse, *normal_map, *specular; /* NULL where none is used */
    size_t diffuse_level, normal_level, specular_level;    /* mip levels */
    struct vec3 eye;
    struct vec3 to_light;     /* of length 1 */
    struct material material; /* of the whole model, where no texture says otherwise */
};

/* ---- The technique ---- */

/* base to a small whole power, by multiplying: base^0 is 1. */
static double integer_power(double base, int power) {
    /* BEGIN SOLUTION 10.1 whole powers */
    double result = 1;
    for (; power > 0; power /= 2) {
        if (power % 2 == 1) {
            result *= base;
        }
        base *= base;
    }
    return result;
    /* STARTER
    (void)base, (void)power;
    return 0; // to do 10.1: square the base, halve the power
    END SOLUTION */
}

/* Where light from direction `to_light` goes after a mirror: r = 2 (n . l) n - l. */
static struct vec3 reflect(struct vec3 normal, struct vec3 to_light) {
    /* BEGIN SOLUTION 10.2 the mirrored light */
    return vec3_sub(vec3_scale(normal, 2 * vec3_dot(normal, to_light)), to_light);
    /* STARTER
    (void)normal, (void)to_light;
    return (struct vec3){0, 0, 0}; // to do 10.2: the formula for r
    END SOLUTION */
}

/* Diffuse and specular intensity of a point (Phong, "Illumination for Computer Generated Pictures",
 * CACM 18(6), 1975). All vectors of length 1. A surface turned away from the light gets neither. */
static struct vec2 phong(struct vec3 normal, struct vec3 to_light, struct vec3 to_eye, int power) {
    /* BEGIN SOLUTION 10.3 diffuse and specular */
    double diffuse = vec3_dot(normal, to_light);
    if (!(diffuse > 0)) {
        return (struct vec2){0, 0};
    }
    double mirrored = vec3_dot(reflect(normal, to_light), to_eye);
    return (struct vec2){diffuse, integer_power(mirrored > 0 ? mirrored : 0, power)};
    /* STARTER
    double diffuse = 0; // to do 10.3: n . l; where it is not above 0, both are 0
    double mirrored = vec3_dot(reflect(normal, to_light), to_eye); // to do 10.3: not below 0
    return (struct vec2){diffuse, integer_power(mirrored, power)};
    END SOLUTION */
}

/* Add up the three parts. The specular part has the colour of the light, which is white. */
static struct color illuminate(const struct uniforms *u, const struct material *material,
                               struct vec3 normal, struct vec3 position) {
    /* BEGIN SOLUTION 10.4 the sum of the three parts */
    struct vec3 to_eye = vec3_normalized(vec3_sub(u->eye, position));
    struct vec2 light = phong(normal, u->to_light, to_eye, material->power);
    double scattered = material->ambient + material->diffuse * light.x;
    double mirrored = 255 * material->specular * light.y;
    return color_rgb(level_from(material->color.x * scattered + mirrored),
                     level_from(material->color.y * scattered + mirrored),
                     level_from(material->color.z * scattered + mirrored));
    /* STARTER
    struct vec3 to_eye = {0, 0, 1}; // to do 10.4: from the position to the eye, of length 1
    struct vec2 light = phong(normal, u->to_light, to_eye, material->power);
    (void)position, (void)light;
    return color_grey(0); // to do 10.4: the three parts in each channel, through level_from()
    END SOLUTION */
}

/* ---- Varyings: position, texture coordinates, normal ---- */

static void vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct uniforms *u = uniforms;
    /* BEGIN SOLUTION 10.5 what a corner hands over */
    struct vec3 position = model_position(u->model, face, corner);
    struct vec2 uv = model_uv(u->model, face, corner);
    varyings[0] = position.x;
    varyings[1] = position.y;
    varyings[2] = position.z;
    varyings[3] = uv.x;
    varyings[4] = uv.y;
    /* STARTER
    (void)u, (void)face, (void)corner;
    for (int i = 0; i < 5; i++) {
        varyings[i] = 0; // to do 10.5: the position x, y, z, then u, v
    }
    END SOLUTION */
}

static void vertex_with_normal(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct uniforms *u = uniforms;
    vertex(uniforms, face, corner, varyings);
    /* BEGIN SOLUTION 10.5 what a corner hands over */
    struct vec3 normal = vec3_normalized(model_normal(u->model, face, corner));
    varyings[5] = normal.x;
    varyings[6] = normal.y;
    varyings[7] = normal.z;
    /* STARTER
    (void)u;
    varyings[5] = varyings[6] = varyings[7] = 0; // to do 10.5: the normal, of length 1
    END SOLUTION */
}

static struct vec3 position_of(const double *varyings) {
    return (struct vec3){varyings[0], varyings[1], varyings[2]};
}

static struct vec2 uv_of(const double *varyings) {
    return (struct vec2){varyings[3], varyings[4]};
}

/* The mean of unit vectors is shorter than 1: bring it back to length 1. */
static struct vec3 mesh_normal(const double *varyings) {
    /* BEGIN SOLUTION 10.6 normals of length 1 */
    return vec3_normalized((struct vec3){varyings[5], varyings[6], varyings[7]});
    /* STARTER
    (void)varyings;
    return (struct vec3){0, 0, 1}; // to do 10.6: varyings 5 to 7, of length 1
    END SOLUTION */
}

static struct vec3 mapped_normal(const struct uniforms *u, const double *varyings) {
    struct vec2 uv = uv_of(varyings);
    /* BEGIN SOLUTION 10.6 normals of length 1 */
    struct vec4 n = texture_bilinear(u->normal_map, uv, u->normal_level);
    return vec3_normalized((struct vec3){n.x / 127.5 - 1, n.y / 127.5 - 1, n.z / 127.5 - 1});
    /* STARTER
    (void)u, (void)uv;
    return (struct vec3){0, 0, 1}; // to do 10.6: sampled from the normal map, of length 1
    END SOLUTION */
}

/* ---- Shaders: the mesh's normal or the map's, one colour or the texture's ---- */

static bool plain_fragment(const void *uniforms, const double *varyings, struct color *color) {
    const struct uniforms *u = uniforms;
    *color = illuminate(u, &u->material, mesh_normal(varyings), position_of(varyings));
    return true;
}

static bool mapped_fragment(const void *uniforms, const double *varyings, struct color *color) {
    const struct uniforms *u = uniforms;
    *color = illuminate(u, &u->material, mapped_normal(u, varyings), position_of(varyings));
    return true;
}

/* The model's material with the colour that the texture has there. */
static struct material colored_material(const struct uniforms *u, const double *varyings) {
    struct material material = u->material;
    /* BEGIN SOLUTION 10.7 fragment functions */
    material.color = texture_bilinear(u->diffuse, uv_of(varyings), u->diffuse_level);
    /* STARTER
    (void)varyings; // to do 10.7: sample the colour
    END SOLUTION */
    return material;
}

static bool textured_fragment(const void *uniforms, const double *varyings, struct color *color) {
    const struct uniforms *u = uniforms;
    struct material material = colored_material(u, varyings);
    *color = illuminate(u, &material, mesh_normal(varyings), position_of(varyings));
    return true;
}

static bool full_fragment(const void *uniforms, const double *varyings, struct color *color) {
    /* BEGIN SOLUTION 10.7 fragment functions */
    const struct uniforms *u = uniforms;
    struct material material = colored_material(u, varyings);
    *color = illuminate(u, &material, mapped_normal(u, varyings), position_of(varyings));
    return true;
    /* STARTER
    return mapped_fragment(uniforms, varyings, color); // to do 10.7: with the texture's colour
    END SOLUTION */
}

/* The same with the weight of the specular part read from the specular map. */
static bool weight_map_fragment(const void *uniforms, const double *varyings, struct color *color) {
    /* BEGIN SOLUTION 10.7 fragment functions */
    const struct uniforms *u = uniforms;
    struct material material = colored_material(u, varyings);
    material.specular *= texture_bilinear(u->specular, uv_of(varyings), u->specular_level).x / 255;
    *color = illuminate(u, &material, mapped_normal(u, varyings), position_of(varyings));
    return true;
    /* STARTER
    return full_fragment(uniforms, varyings, color); // to do 10.7: the weight from the map
    END SOLUTION */
}

/* The same with the power read from it: 1 for level 0 to 32 for level 255. */
static bool power_map_fragment(const void *uniforms, const double *varyings, struct color *color) {
    /* BEGIN SOLUTION 10.7 fragment functions */
    const struct uniforms *u = uniforms;
    struct material material = colored_material(u, varyings);
    double level = texture_bilinear(u->specular, uv_of(varyings), u->specular_level).x;
    material.power = 1 + (int)level / 8;
    *color = illuminate(u, &material, mapped_normal(u, varyings), position_of(varyings));
    return true;
    /* STARTER
    return full_fragment(uniforms, varyings, color); // to do 10.7: the power from the map
    END SOLUTION */
}

SHADER(plain, .varying_count = 8, .vertex = vertex_with_normal, .fragment = plain_fragment);
SHADER(mapped, .varying_count = 5, .vertex = vertex, .fragment = mapped_fragment);
SHADER(textured, .varying_count = 8, .vertex = vertex_with_normal, .fragment = textured_fragment);
SHADER(full, .varying_count = 5, .vertex = vertex, .fragment = full_fragment);
SHADER(weight_mapped, .varying_count = 5, .vertex = vertex, .fragment = weight_map_fragment);
SHADER(power_mapped, .varying_count = 5, .vertex = vertex, .fragment = power_map_fragment);

/* ---- The turning light ---- */

/* Towards the light after so many whole turns around the head: (sin a, 0, cos a). */
static struct vec3 turning_light(double turns) {
    /* BEGIN SOLUTION 10.8 the turning light */
    struct vec2 direction = turn_direction(turns);
    return (struct vec3){direction.y, 0, direction.x};
    /* STARTER
    (void)turns;
    return (struct vec3){0, 0, 1}; // to do 10.8: turn_direction() gives cosine and sine
    END SOLUTION */
}

#include "scenes.h"
