/*
 * Normal maps in tangent space: their normals count from the surface, as most maps from elsewhere
 * do (taught in step10_phong/TANGENT.md).
 *
 * Such a map has three axes at each place: along the surface to where u grows, and to where v
 * grows, and away from it. They lie in the model's space, so that a shader adds the three values of
 * the map along them and has the normal that a map in object space would give it.
 */
#ifndef COMMON_TANGENT_H
#define COMMON_TANGENT_H

#include "lanes.h"
#include "model.h"

/* Each of length 1, each perpendicular to the others. */
struct tangent_axes {
    struct vec3 u, v, normal;
};

/* The axes at a corner. The normal is the corner's, which has one; u and v follow from the face:
 * its two sides are known in space and in (u, v). Where a face has no area in the picture, u is any
 * direction along the surface. (Eric Lengyel, "Computing Tangent Space Basis Vectors for an
 * Arbitrary Mesh", 2001; but without the mean of neighbouring faces.) */
struct tangent_axes model_tangent_axes(const struct model *model, size_t face, size_t corner);

enum { TANGENT_VARYINGS = 9 };

/* The axes at a corner, as numbers for the pixels. */
static inline void tangent_varyings(const struct model *model, size_t face, size_t corner,
                                    double varyings[TANGENT_VARYINGS]) {
    struct tangent_axes axes = model_tangent_axes(model, face, corner);
    const struct vec3 axis[3] = {axes.u, axes.v, axes.normal};
    for (int i = 0; i < 3; i++) {
        varyings[3 * i] = axis[i].x;
        varyings[3 * i + 1] = axis[i].y;
        varyings[3 * i + 2] = axis[i].z;
    }
}

#include "pipeline/tangent_lanes.h"

#endif
