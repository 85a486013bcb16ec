/*
 * Lesson 10: Phong's reflection model, at every pixel.
 *
 * The light that a pixel sends to the eye is the sum of three parts: ambient (from everywhere),
 * diffuse (scattered by the surface) and specular (mirrored towards the eye, more or less sharply).
 * The normal comes from the mesh or from the normal map, the colour from a constant or the texture.
 * All of it is computed for several pixels at once (common/lanes.h).
 */
#include "pipeline_program.h"

/* How a surface answers to light. */
struct material {
    double ambient, diffuse, specular; /* weights of the three parts */
    int power;         /* of the specular part: larger makes smaller lights; -1: nothing shines */
    struct vec3 color; /* red, green, blue 0..255 */
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

/* base to a whole power 0..`largest_power`, which may differ from pixel to pixel, by multiplying.
 * base^0 is 1. Where nothing shines, `largest_power` is below 0, and the result 0. */
static lanes integer_power(lanes base, lanes power, int largest_power) {
    if (largest_power < 0) {
        return lanes_all(0);
    }
    /* BEGIN SOLUTION 10b.1 whole powers */
    lanes result = lanes_all(1);
    for (int left = largest_power; left > 0; left /= 2) {
        lanes half = lanes_floor(power * 0.5f);
        result = lanes_select(power > 2 * half, result * base, result); /* where it is odd */
        base *= base;
        power = half;
    }
    return result;
    /* STARTER
    (void)base, (void)power, (void)largest_power;
    return lanes_all(0); // to do 10b.1: square the base, halve the power
    END SOLUTION */
}

/* Where a mirror with this normal sends the light: r, which makes the same angle with the normal as
 * `to_light`, on the other side of it and in one plane with both. All point away from the mirror
 * and have length 1. */
static struct lanes3 reflect(struct lanes3 normal, struct lanes3 to_light) {
    /* BEGIN SOLUTION 10b.2 the mirrored light */
    return lanes3_sub(lanes3_scale(normal, 2 * lanes3_dot(normal, to_light)), to_light);
    /* STARTER
    (void)normal, (void)to_light;
    return lanes3_all((struct vec3){0, 0, 0}); // to do 10b.2: l mirrored at n
    END SOLUTION */
}

/* Diffuse and specular intensity of a point (Phong, "Illumination for Computer Generated Pictures",
 * CACM 18(6), 1975). All vectors of length 1. A surface turned away from the light gets neither. */
static struct lanes2 phong(struct lanes3 normal, struct lanes3 to_light, struct lanes3 to_eye,
                           lanes power, int largest_power) {
    lanes zero = lanes_all(0);
    /* BEGIN SOLUTION 10a.1 diffuse light */
    lanes diffuse = lanes_max(lanes3_dot(normal, to_light), zero);
    /* STARTER
    lanes diffuse = zero; // to do 10a.1: n . l, where it is above 0
    END SOLUTION */
    /* BEGIN SOLUTION 10b.3 specular light */
    lanes mirrored = lanes_max(lanes3_dot(reflect(normal, to_light), to_eye), zero);
    lanes specular = integer_power(mirrored, power, largest_power);
    specular = lanes_select(diffuse > 0, specular, zero);
    /* STARTER
    lanes mirrored = lanes3_dot(reflect(normal, to_light), to_eye); // to do 10b.3: not below 0
    lanes specular = integer_power(mirrored, power, largest_power);
    // to do 10b.3: specular is 0 where diffuse is 0
    END SOLUTION */
    return (struct lanes2){diffuse, specular};
}

/* What lies at a pixel. */
struct surface {
    struct lanes3 color;  /* red, green, blue 0..255 */
    struct lanes3 normal; /* of length 1 */
    struct lanes3 to_eye; /* of any length */
    lanes specular;       /* weight */
    lanes power;          /* 0..`largest_power` */
    int largest_power;
};

/* Add up the three parts. The specular part has the colour of the light, which is white. */
static lanes_texel illuminate(const struct uniforms *u, const struct surface *surface) {
    /* BEGIN SOLUTION 10a.2 the sum of the three parts */
    const struct material *material = &u->material;
    struct lanes3 to_eye = lanes3_normalized(surface->to_eye), color = surface->color;
    struct lanes2 light = phong(surface->normal, lanes3_all(u->to_light), to_eye, surface->power,
                                surface->largest_power);
    lanes scattered = (real)material->ambient + (real)material->diffuse * light.x;
    lanes mirrored = 255 * surface->specular * light.y;
    return lanes_rgb(color.x * scattered + mirrored, color.y * scattered + mirrored,
                     color.z * scattered + mirrored);
    /* STARTER
    struct lanes3 to_eye = lanes3_all((struct vec3){0, 0, 1}); // to do 10a.2: of length 1
    // to do 10a.2: the surface's
    int largest_power = 32;
    struct lanes2 light =
        phong(surface->normal, lanes3_all(u->to_light), to_eye, surface->power, largest_power);
    (void)light;
    return lanes_black(); // to do 10a.2: the three parts in each channel, through lanes_rgb()
    END SOLUTION */
}

/* ---- Varyings: towards the eye, texture coordinates, normal ---- */

static void vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct uniforms *u = uniforms;
    /* BEGIN SOLUTION 10b.4 where the eye is */
    struct vec3 to_eye = vec3_sub(u->eye, model_position(u->model, face, corner));
    struct vec2 uv = model_uv(u->model, face, corner);
    varyings[0] = to_eye.x;
    varyings[1] = to_eye.y;
    varyings[2] = to_eye.z;
    varyings[3] = uv.x;
    varyings[4] = uv.y;
    /* STARTER
    (void)u, (void)face, (void)corner;
    for (int i = 0; i < 5; i++) {
        varyings[i] = 0; // to do 10b.4: from the position to the eye x, y, z, then u, v
    }
    END SOLUTION */
}

static void vertex_with_normal(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct uniforms *u = uniforms;
    vertex(uniforms, face, corner, varyings);
    /* BEGIN SOLUTION 10a.3 the normal of a corner */
    struct vec3 normal = vec3_normalized(model_normal(u->model, face, corner));
    varyings[5] = normal.x;
    varyings[6] = normal.y;
    varyings[7] = normal.z;
    /* STARTER
    (void)u;
    varyings[5] = varyings[6] = varyings[7] = 0; // to do 10a.3: the normal, of length 1
    END SOLUTION */
}

static struct lanes2 uv_of(const lanes *varyings) {
    return (struct lanes2){varyings[3], varyings[4]};
}

/* The mean of unit vectors is shorter than 1: bring it back to length 1. */
static struct lanes3 mesh_normal(const lanes *varyings) {
    /* BEGIN SOLUTION 10a.4 normals of the mesh */
    return lanes3_normalized((struct lanes3){varyings[5], varyings[6], varyings[7]});
    /* STARTER
    (void)varyings;
    return lanes3_all((struct vec3){0, 0, 1}); // to do 10a.4: varyings 5 to 7, of length 1
    END SOLUTION */
}

/* From the values 0..255 of a normal map, which mean -1..1. */
static struct lanes3 normal_from_values(struct lanes3 value) {
    /* BEGIN SOLUTION 10c.1 normals of the map */
    struct lanes3 n = {value.x - 127.5f, value.y - 127.5f, value.z - 127.5f};
    return lanes3_normalized(n); /* of any length before: no need to divide by 127.5 */
    /* STARTER
    (void)value;
    return lanes3_all((struct vec3){0, 0, 1}); // to do 10c.1: from the values, of length 1
    END SOLUTION */
}

static struct lanes3 mapped_normal(const struct uniforms *u, const lanes *varyings) {
    return normal_from_values(texture_lanes(u->normal_map, uv_of(varyings), u->normal_level));
}

/* ---- Shaders: the mesh's normal or the map's, one colour or the texture's ---- */

/* The surface of the model's material, without its normal. */
static struct surface plain_surface(const struct uniforms *u, const lanes *varyings) {
    return (struct surface){
        .color = lanes3_all(u->material.color),
        .to_eye = {varyings[0], varyings[1], varyings[2]},
        .specular = lanes_all((real)u->material.specular),
        .power = lanes_all((real)u->material.power),
        .largest_power = u->material.power,
    };
}

/* The same with the colour that the texture has there. */
static struct surface textured_surface(const struct uniforms *u, const lanes *varyings) {
    struct surface surface = plain_surface(u, varyings);
    /* BEGIN SOLUTION 10c.2 the texture's colours */
    surface.color = texture_lanes(u->diffuse, uv_of(varyings), u->diffuse_level);
    /* STARTER
    (void)varyings; // to do 10c.2: sample the colour
    END SOLUTION */
    return surface;
}

static lanes_mask plain_fragment(const void *uniforms, const lanes *varyings, lanes_texel *color) {
    const struct uniforms *u = uniforms;
    struct surface surface = plain_surface(u, varyings);
    surface.normal = mesh_normal(varyings);
    *color = illuminate(u, &surface);
    return lanes_all_set();
}

static lanes_mask mapped_fragment(const void *uniforms, const lanes *varyings, lanes_texel *color) {
    const struct uniforms *u = uniforms;
    struct surface surface = plain_surface(u, varyings);
    surface.normal = mapped_normal(u, varyings);
    *color = illuminate(u, &surface);
    return lanes_all_set();
}

static lanes_mask textured_fragment(const void *uniforms, const lanes *varyings,
                                    lanes_texel *color) {
    const struct uniforms *u = uniforms;
    struct surface surface = textured_surface(u, varyings);
    surface.normal = mesh_normal(varyings);
    *color = illuminate(u, &surface);
    return lanes_all_set();
}

static lanes_mask full_fragment(const void *uniforms, const lanes *varyings, lanes_texel *color) {
    /* BEGIN SOLUTION 10c.2 the texture's colours */
    const struct uniforms *u = uniforms;
    struct surface surface = textured_surface(u, varyings);
    surface.normal = mapped_normal(u, varyings);
    *color = illuminate(u, &surface);
    return lanes_all_set();
    /* STARTER
    return mapped_fragment(uniforms, varyings, color); // to do 10c.2: with the texture's colour
    END SOLUTION */
}

/* Colour, normal and the weight of the specular part come from their maps. */
static lanes_mask weight_map_fragment(const void *uniforms, const lanes *varyings,
                                      lanes_texel *color) {
    /* BEGIN SOLUTION 10c.3 the specular map */
    const struct uniforms *u = uniforms;
    struct lanes2 uv = uv_of(varyings);
    /* All are fetched before any is used, so that we wait for memory once and not three times. */
    struct texel_place place = {0};
    struct texels colors = texture_fetch(u->diffuse, uv, u->diffuse_level, &place);
    struct texels normals = texture_fetch(u->normal_map, uv, u->normal_level, &place);
    struct texels weights = texture_fetch(u->specular, uv, u->specular_level, &place);
    struct surface surface = plain_surface(u, varyings);
    surface.color = texels_mix(&colors);
    surface.normal = normal_from_values(texels_mix(&normals));
    surface.specular *= texels_mix(&weights).z * (1 / 255.0f);
    *color = illuminate(u, &surface);
    return lanes_all_set();
    /* STARTER
    const struct uniforms *u = uniforms;
    struct surface surface = textured_surface(u, varyings);
    surface.normal = mapped_normal(u, varyings);
    // to do 10c.3: the weight from the map
    *color = illuminate(u, &surface);
    return lanes_all_set();
    END SOLUTION */
}

/* The same with the power read from the specular map: 1 for value 0 to 32 for value 255. */
static lanes_mask power_map_fragment(const void *uniforms, const lanes *varyings,
                                     lanes_texel *color) {
    /* BEGIN SOLUTION 10c.3 the specular map */
    const struct uniforms *u = uniforms;
    struct surface surface = textured_surface(u, varyings);
    surface.normal = mapped_normal(u, varyings);
    lanes value = texture_lanes(u->specular, uv_of(varyings), u->specular_level).z;
    surface.power = 1 + lanes_floor(value * 0.125f);
    surface.largest_power = 32;
    *color = illuminate(u, &surface);
    return lanes_all_set();
    /* STARTER
    const struct uniforms *u = uniforms;
    struct surface surface = textured_surface(u, varyings);
    surface.normal = mapped_normal(u, varyings);
    // to do 10c.3: the power from the map
    *color = illuminate(u, &surface);
    return lanes_all_set();
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
    /* BEGIN SOLUTION 10c.4 the turning light */
    struct vec2 direction = turn_direction(turns);
    return (struct vec3){direction.y, 0, direction.x};
    /* STARTER
    (void)turns;
    return (struct vec3){0, 0, 1}; // to do 10c.4: turn_direction() gives cosine and sine
    END SOLUTION */
}

#include "scenes.h"

int main(int argc, char **argv) {
    return program_main(&step10_phong, argc, argv);
}
