/* Tangent space: see tangent.h. */
#include "tangent.h"

/* A direction along the surface, which is perpendicular to `normal`: the one given or, where that
 * has no part along it, any. */
static struct vec3 along_surface(struct vec3 direction, struct vec3 normal) {
    const double noise = 1e-6; /* far above what rounding leaves */
    direction = vec3_normalized(direction);
    struct vec3 along = vec3_sub(direction, vec3_scale(normal, vec3_dot(normal, direction)));
    if (vec3_length(along) < noise) {
        struct vec3 x = {1, 0, 0}, y = {0, 1, 0};
        along = vec3_cross(fabs(normal.x) < 0.5 ? x : y, normal);
    }
    return vec3_normalized(along);
}

struct tangent_axes model_tangent_axes(const struct model *model, size_t face, size_t corner) {
    struct vec3 p = model_position(model, face, 0), normal = model_normal(model, face, corner);
    struct vec3 side = vec3_sub(model_position(model, face, 1), p);
    struct vec3 other = vec3_sub(model_position(model, face, 2), p);
    struct vec2 a = model_uv(model, face, 0), b = model_uv(model, face, 1);
    struct vec2 c = model_uv(model, face, 2);
    double side_u = b.x - a.x, side_v = b.y - a.y, other_u = c.x - a.x, other_v = c.y - a.y;
    /* side = side_u * to_u + side_v * to_v, and so is other: solved for both, except for a factor
     * that is negative where the picture is mirrored on this face. */
    double mirrored = side_u * other_v - other_u * side_v < 0 ? -1 : 1;
    struct vec3 to_u = vec3_sub(vec3_scale(side, other_v), vec3_scale(other, side_v));
    struct vec3 to_v = vec3_sub(vec3_scale(other, side_u), vec3_scale(side, other_u));
    struct tangent_axes axes = {.normal = vec3_normalized(normal)};
    axes.u = along_surface(vec3_scale(to_u, mirrored), axes.normal);
    axes.v = vec3_cross(axes.normal, axes.u);
    if (vec3_dot(axes.v, to_v) * mirrored < 0) {
        axes.v = vec3_scale(axes.v, -1);
    }
    return axes;
}
