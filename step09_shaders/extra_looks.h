/*
 * Lesson 9, looks that the lesson does not ask for: normal maps in tangent space, and toon in any
 * number of steps.
 */
#include "tangent.h"

/* ---- Normal maps in tangent space: lesson 10 explains them in TANGENT.md ---- */

static void tangent_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct uniforms *u = uniforms;
    uv_vertex(uniforms, face, corner, varyings);
    tangent_varyings(u->model, face, corner, varyings + 2);
}

static lanes_mask tangent_fragment(const void *uniforms, const lanes *varyings,
                                   lanes_texel *color) {
    const struct uniforms *u = uniforms;
    struct lanes2 uv = {varyings[0], varyings[1]};
    struct lanes3 value = texture_lanes(u->normal_map, uv, u->normal_level);
    lanes intensity = lambert_lanes(tangent_normal(varyings + 2, value), u->to_light);
    *color = shade(texture_lanes(u->diffuse, uv, u->diffuse_level), intensity);
    return lanes_all_set();
}

/* Without its own loops, which take long to compile. */
static const struct shader tangent_mapped = {
    .varying_count = 2 + TANGENT_VARYINGS, .vertex = tangent_vertex, .fragment = tangent_fragment};

/* The same for simple_draw(). */
static bool tangent_pixel(const void *uniforms, const double *varyings, struct vec3 *rgb) {
    const struct uniforms *u = uniforms;
    const double *axis = varyings + 2;
    struct vec3 value = sample(u->normal_map, varyings, u->normal_level);
    double n[3];
    for (int i = 0; i < 3; i++) {
        n[i] = (value.x - 127.5) * axis[i] + (value.y - 127.5) * axis[3 + i] +
               (value.z - 127.5) * axis[6 + i];
    }
    *rgb = vec3_scale(sample(u->diffuse, varyings, u->diffuse_level),
                      lambert((struct vec3){n[0], n[1], n[2]}, u->to_light));
    return true;
}

static const struct simple_shader simple_tangent_mapped = {2 + TANGENT_VARYINGS, tangent_vertex,
                                                           tangent_pixel};

/* ---- Toon ---- */

/* The light in another number of steps than five. */
struct steps {
    struct uniforms uniforms; /* for gouraud_vertex() */
    double steps;
};

static lanes_mask steps_fragment(const void *uniforms, const lanes *varyings, lanes_texel *color) {
    const struct steps *u = uniforms;
    const float most = (float)u->steps - 1;
    lanes step = lanes_min(lanes_floor(varyings[0] * (most + 1)), lanes_all(most));
    *color = shade(lanes3_all((struct vec3){255, 155, 0}), step / most);
    return lanes_all_set();
}

static const struct shader in_steps = {
    .varying_count = 1, .vertex = gouraud_vertex, .fragment = steps_fragment};
