/*
 * Lesson 10 with the maps and materials of other models: normal maps in tangent space (TANGENT.md)
 * or none, and what files of materials say of shine and ambient light (MORE.md).
 */
#include "extra_tangent.h"

#include <string.h>

/* The shader; for a model without normal map one that draws by the mesh's normals, and for a map in
 * tangent space one that reads it so. */
static const struct shader *drawn_by(const struct drawing *drawing, const struct shader *shader) {
    if (drawing->normal_map != NULL && drawing->normal_map->tangent_space) {
        return in_tangent_space(shader);
    }
    if (drawing->normal_map != NULL || shader == &plain) {
        return shader;
    }
    return shader == &mapped ? &plain : &textured;
}

/* What a part's own material says, instead of the lesson's. */
static struct material own_material(const struct drawing *drawing, struct material material) {
    const double most = 200;
    if (drawing->parts != NULL && drawing->specular_weight >= 0) {
        material.specular *= drawing->specular_weight;
    }
    if (drawing->parts != NULL && drawing->power > 0) {
        material.power = (int)fmax(1, fmin(drawing->power, most));
    }
    return material;
}

/* ---- Ambient light of a colour of its own ---- */

/* What a shader of the lesson reads, to draw without ambient light, and the light on top of it. */
struct ambient_uniforms {
    struct uniforms without;
    const struct shader *shader;
    const struct texture *colors;
    double weight;
};

static void ambient_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct ambient_uniforms *a = uniforms;
    memset(varyings, 0, (5 + TANGENT_VARYINGS) * sizeof *varyings);
    a->shader->vertex(&a->without, face, corner, varyings);
}

static lanes_mask ambient_fragment(const void *uniforms, const lanes *varyings,
                                   lanes_texel *color) {
    const struct ambient_uniforms *a = uniforms;
    const lanes weight = lanes_all((real)a->weight);
    struct lanes3 light = texture_lanes(a->colors, uv_of(varyings), a->without.diffuse_level);
    a->shader->fragment(&a->without, varyings, color);
    *color = lanes_rgb(lanes_from_int((lanes_int)(*color >> 16 & 255)) + weight * light.x,
                       lanes_from_int((lanes_int)(*color >> 8 & 255)) + weight * light.y,
                       lanes_from_int((lanes_int)(*color & 255)) + weight * light.z);
    return lanes_all_set();
}

static const struct shader own_ambient = {
    .varying_count = 5 + TANGENT_VARYINGS, .vertex = ambient_vertex, .fragment = ambient_fragment};

/* Record a call with a shader of the lesson, as the drawing's material and maps want it. */
static bool draw_part(struct drawing *drawing, const struct draw_call *call,
                      const struct shader *shader, const struct uniforms *u, struct error *error) {
    const struct shader *drawn = drawn_by(drawing, shader);
    if (drawing->ambient == NULL || shader == &plain || shader == &mapped) {
        return pipeline_draw(drawing->state, call, drawn, u, sizeof *u, error);
    }
    struct ambient_uniforms own = {*u, drawn, drawing->ambient, u->material.ambient};
    own.without.material.ambient = 0;
    return pipeline_draw(drawing->state, call, &own_ambient, &own, sizeof own, error);
}
