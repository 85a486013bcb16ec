/*
 * Lesson 9 with the normal maps of other models: in tangent space, as most are (lesson 10 explains
 * them in TANGENT.md), or none at all.
 */
#include "tangent.h"

/* u, v, and the axes behind them. */
static void tangent_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct uniforms *u = uniforms;
    uv_vertex(uniforms, face, corner, varyings);
    tangent_varyings(u->model, face, corner, varyings + 2);
}

static bool tangent_pixel(const void *uniforms, const double *varyings, struct vec3 *rgb) {
    const struct uniforms *u = uniforms;
    const struct vec3 value = sample(u->normal_map, varyings, u->normal_level);
    const struct vec3 normal = tangent_normal_at(varyings + 2, value);
    const double textured[] = {varyings[0], varyings[1], lambert(normal, u->to_light)};
    return textured_pixel(uniforms, textured, rgb);
}

static lanes_mask tangent_fragment(const void *uniforms, const lanes *varyings,
                                   lanes_texel *color) {
    const struct uniforms *u = uniforms;
    const struct lanes2 uv = {varyings[0], varyings[1]};
    const struct lanes3 value = texture_lanes(u->normal_map, uv, u->normal_level);
    const struct lanes3 normal = tangent_normal(varyings + 2, value);
    const lanes textured[] = {uv.x, uv.y, lambert_lanes(normal, u->to_light)};
    return textured_fragment(uniforms, textured, color);
}

static const struct simple_shader simple_tangent_mapped = {2 + TANGENT_VARYINGS, tangent_vertex,
                                                           tangent_pixel};
/* Without its own loops, which take long to compile. */
static const struct shader tangent_mapped = {
    .varying_count = 2 + TANGENT_VARYINGS, .vertex = tangent_vertex, .fragment = tangent_fragment};

/* The shader that draws by the model's normal map, or by its normals where it has no map. */
static const struct shader *mapped_by(const struct texture *normal_map) {
    return normal_map == NULL          ? &gouraud_textured
           : normal_map->tangent_space ? &tangent_mapped
                                       : &normal_mapped;
}

static const struct simple_shader *simple_mapped_by(const struct texture *normal_map) {
    return normal_map == NULL          ? &simple_gouraud_textured
           : normal_map->tangent_space ? &simple_tangent_mapped
                                       : &simple_normal_mapped;
}
