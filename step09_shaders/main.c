/*
 * Step 9: shaders.
 *
 * Steps 4 to 8 repeated one loop over faces and one over pixels, and changed only what a corner
 * hands over and what a pixel makes of it. Here the loops are common/pipeline.h, and the two parts
 * that change are the functions of a `shader`. What a pixel makes of it is written as if for one
 * pixel, and run for sixteen at once: a `lanes` is a number for each of them (common/lanes.h).
 */
#include "pipeline_program.h"

/* What is the same for all pixels of a drawing. */
struct uniforms {
    const struct model *model;
    const struct texture *diffuse, *normal_map; /* NULL where the shader reads none */
    size_t diffuse_level, normal_level;         /* mip levels */
    struct vec3 to_light;                       /* of length 1 */
};

/* ---- Shared by the shaders ---- */

/* How much light a surface with this normal (of any length) gets: 0 when it is turned away. */
static double lambert(struct vec3 normal, struct vec3 to_light) {
    /* BEGIN SOLUTION 9.1 light on a surface */
    double intensity = vec3_dot(vec3_normalized(normal), to_light);
    return intensity > 0 ? intensity : 0;
    /* STARTER
    (void)normal, (void)to_light;
    return 0; // to do 9.1: normal of length 1 times to_light, but not below 0
    END SOLUTION */
}

/* Red, green, blue 0..255, times an intensity, as a pixel's colour. */
static lanes_texel shade(struct lanes3 rgb, lanes intensity) {
    /* BEGIN SOLUTION 9.2 a colour in that light */
    return lanes_rgb(rgb.x * intensity, rgb.y * intensity, rgb.z * intensity);
    /* STARTER
    (void)rgb, (void)intensity;
    return lanes_black(); // to do 9.2: each channel times the intensity, through lanes_rgb()
    END SOLUTION */
}

/* ---- Flat: one intensity for a face ---- */

static void flat_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct uniforms *u = uniforms;
    (void)corner;
    /* BEGIN SOLUTION 9.3 flat and Gouraud */
    varyings[0] = lambert(model_face_normal(u->model, face), u->to_light);
    /* STARTER
    (void)face;
    varyings[0] = lambert((struct vec3){0, 0, 0}, u->to_light); // to do 9.3: the face's normal
    END SOLUTION */
}

static lanes_mask white_fragment(const void *uniforms, const lanes *varyings, lanes_texel *color) {
    (void)uniforms;
    /* BEGIN SOLUTION 9.3 flat and Gouraud */
    static const struct vec3 white = {255, 255, 255};
    *color = shade(lanes3_all(white), varyings[0]);
    /* STARTER
    static const struct vec3 black = {0, 0, 0}; // to do 9.3: white
    *color = shade(lanes3_all(black), varyings[0]);
    END SOLUTION */
    return lanes_all_set();
}

SHADER(flat, .varying_count = 1, .flat = true, .vertex = flat_vertex, .fragment = white_fragment);

/* ---- Gouraud: an intensity for each corner ---- */

static void gouraud_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct uniforms *u = uniforms;
    /* BEGIN SOLUTION 9.3 flat and Gouraud */
    varyings[0] = lambert(model_normal(u->model, face, corner), u->to_light);
    /* STARTER
    (void)u, (void)face, (void)corner;
    varyings[0] = 0; // to do 9.3: the light on the corner's own normal
    END SOLUTION */
}

SHADER(gouraud, .varying_count = 1, .vertex = gouraud_vertex, .fragment = white_fragment);

/* ---- The same two with the texture's colours ---- */

static void uv_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct uniforms *u = uniforms;
    /* BEGIN SOLUTION 9.4 flat and Gouraud with the texture */
    struct vec2 uv = model_uv(u->model, face, corner);
    varyings[0] = uv.x;
    varyings[1] = uv.y;
    /* STARTER
    (void)u, (void)face, (void)corner;
    varyings[0] = varyings[1] = 0; // to do 9.4: u and v of the corner
    END SOLUTION */
}

static void flat_textured_vertex(const void *uniforms, size_t face, size_t corner,
                                 double *varyings) {
    uv_vertex(uniforms, face, corner, varyings);
    flat_vertex(uniforms, face, corner, varyings + 2);
}

static void gouraud_textured_vertex(const void *uniforms, size_t face, size_t corner,
                                    double *varyings) {
    uv_vertex(uniforms, face, corner, varyings);
    gouraud_vertex(uniforms, face, corner, varyings + 2);
}

static lanes_mask textured_fragment(const void *uniforms, const lanes *varyings,
                                    lanes_texel *color) {
    const struct uniforms *u = uniforms;
    struct lanes2 uv = {varyings[0], varyings[1]};
    /* BEGIN SOLUTION 9.4 flat and Gouraud with the texture */
    *color = shade(texture_lanes(u->diffuse, uv, u->diffuse_level), varyings[2]);
    /* STARTER
    (void)u, (void)uv;
    *color = lanes_black(); // to do 9.4: the texture's colour times varying 2
    END SOLUTION */
    return lanes_all_set();
}

SHADER(flat_textured, .varying_count = 3, .vertex = flat_textured_vertex,
       .fragment = textured_fragment);
SHADER(gouraud_textured, .varying_count = 3, .vertex = gouraud_textured_vertex,
       .fragment = textured_fragment);

/* ---- Toon: Gouraud in five levels ---- */

static lanes_mask toon_fragment(const void *uniforms, const lanes *varyings, lanes_texel *color) {
    (void)uniforms;
    /* BEGIN SOLUTION 9.5 toon */
    static const struct vec3 orange = {255, 155, 0};
    lanes step = lanes_min(lanes_floor(varyings[0] * 5), lanes_all(4));
    *color = shade(lanes3_all(orange), step / 4);
    /* STARTER
    (void)varyings;
    *color = lanes_black(); // to do 9.5: orange in five steps
    END SOLUTION */
    return lanes_all_set();
}

SHADER(toon, .varying_count = 1, .vertex = gouraud_vertex, .fragment = toon_fragment);

/* ---- Normals from the normal map, pixel by pixel ---- */

/* lambert() for sixteen pixels. */
static lanes lambert_lanes(struct lanes3 normal, struct vec3 to_light) {
    /* BEGIN SOLUTION 9.6 normals from a picture */
    lanes intensity = lanes3_dot(lanes3_normalized(normal), lanes3_all(to_light));
    return lanes_max(intensity, lanes_all(0));
    /* STARTER
    (void)normal, (void)to_light;
    return lanes_all(0); // to do 9.6: as lambert()
    END SOLUTION */
}

static lanes_mask normal_map_fragment(const void *uniforms, const lanes *varyings,
                                      lanes_texel *color) {
    const struct uniforms *u = uniforms;
    struct lanes2 uv = {varyings[0], varyings[1]};
    /* BEGIN SOLUTION 9.6 normals from a picture */
    struct lanes3 n = texture_lanes(u->normal_map, uv, u->normal_level);
    struct lanes3 normal = {n.x / 127.5f - 1, n.y / 127.5f - 1, n.z / 127.5f - 1};
    lanes intensity = lambert_lanes(normal, u->to_light);
    *color = shade(texture_lanes(u->diffuse, uv, u->diffuse_level), intensity);
    /* STARTER
    (void)uv;
    struct lanes3 normal = {lanes_all(0), lanes_all(0), lanes_all(1)}; // to do 9.6: the map's
    *color = shade(normal, lambert_lanes(normal, u->to_light)); // to do 9.6: the texture's colour
    END SOLUTION */
    return lanes_all_set();
}

SHADER(normal_mapped, .varying_count = 2, .vertex = uv_vertex, .fragment = normal_map_fragment);

/* ---- Two-sided: a face seen from behind is lit as if its normal pointed to that side ---- */

static void two_sided_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct uniforms *u = uniforms;
    (void)corner;
    /* BEGIN SOLUTION 9.7 two sides */
    struct vec3 normal = vec3_normalized(model_face_normal(u->model, face));
    varyings[0] = fabs(vec3_dot(normal, u->to_light));
    /* STARTER
    (void)u, (void)face;
    varyings[0] = 0; // to do 9.7: as flat, but as bright from behind
    END SOLUTION */
}

SHADER(two_sided, .varying_count = 1, .flat = true, .vertex = two_sided_vertex,
       .fragment = white_fragment);

/* ---- Culled by the light, as in steps 4 to 7: what gets no light is not drawn at all ---- */

/* Where the mask that it returns is not set, the pixel is discarded. */
static lanes_mask lit_only_fragment(const void *uniforms, const lanes *varyings,
                                    lanes_texel *color) {
    /* BEGIN SOLUTION 9.8 culled by the light */
    return white_fragment(uniforms, varyings, color) & (varyings[0] > 0);
    /* STARTER
    // to do 9.8: discard what gets no light
    return white_fragment(uniforms, varyings, color);
    END SOLUTION */
}

SHADER(culled_by_light, .varying_count = 1, .flat = true, .vertex = flat_vertex,
       .fragment = lit_only_fragment, .discards = true);

#include "scenes.h"
