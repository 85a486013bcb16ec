/* Lesson 10 with normal maps in tangent space: see TANGENT.md. */
#include "tangent.h"

/* The lesson's varyings, and the axes behind them. */
static void tangent_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct uniforms *u = uniforms;
    vertex(uniforms, face, corner, varyings);
    tangent_varyings(u->model, face, corner, varyings + 5);
}

/* Light on a surface that has all but its normal. */
static lanes_mask tangent_light(const struct uniforms *u, struct surface surface,
                                const lanes *varyings, lanes_texel *color) {
    struct lanes3 value = texture_lanes(u->normal_map, uv_of(varyings), u->normal_level);
    surface.normal = lanes3_normalized(tangent_normal(varyings + 5, value));
    *color = illuminate(u, &surface);
    return lanes_all_set();
}

static lanes_mask tangent_mapped_fragment(const void *uniforms, const lanes *varyings,
                                          lanes_texel *color) {
    return tangent_light(uniforms, plain_surface(uniforms, varyings), varyings, color);
}

static lanes_mask tangent_full_fragment(const void *uniforms, const lanes *varyings,
                                        lanes_texel *color) {
    return tangent_light(uniforms, textured_surface(uniforms, varyings), varyings, color);
}

static lanes_mask tangent_weight_fragment(const void *uniforms, const lanes *varyings,
                                          lanes_texel *color) {
    const struct uniforms *u = uniforms;
    struct surface surface = textured_surface(u, varyings);
    lanes value = texture_lanes(u->specular, uv_of(varyings), u->specular_level).z;
    surface.specular *= value * (1 / 255.0f);
    return tangent_light(u, surface, varyings, color);
}

static lanes_mask tangent_power_fragment(const void *uniforms, const lanes *varyings,
                                         lanes_texel *color) {
    const struct uniforms *u = uniforms;
    struct surface surface = textured_surface(u, varyings);
    lanes value = texture_lanes(u->specular, uv_of(varyings), u->specular_level).z;
    surface.power = 1 + lanes_floor(value * 0.125f);
    surface.largest_power = 32;
    return tangent_light(u, surface, varyings, color);
}

/* Without their own loops, which take long to compile. */
#define TANGENT_SHADER(function)                                                                   \
    { .varying_count = 5 + TANGENT_VARYINGS, .vertex = tangent_vertex, .fragment = (function) }
static const struct shader tangent_mapped = TANGENT_SHADER(tangent_mapped_fragment);
static const struct shader tangent_full = TANGENT_SHADER(tangent_full_fragment);
static const struct shader tangent_weight = TANGENT_SHADER(tangent_weight_fragment);
static const struct shader tangent_power = TANGENT_SHADER(tangent_power_fragment);

/* The one that does in tangent space what the lesson's shader does in object space. */
static const struct shader *in_tangent_space(const struct shader *shader) {
    return shader == &mapped          ? &tangent_mapped
           : shader == &full          ? &tangent_full
           : shader == &weight_mapped ? &tangent_weight
           : shader == &power_mapped  ? &tangent_power
                                      : shader;
}
