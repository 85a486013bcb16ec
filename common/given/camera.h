/*
 * Cameras, and weights in perspective. You write this in lesson 8; it is given from lesson 9 on.
 * mat4_lookat() and mat4_projection() are in geometry.c.
 */
#ifndef COMMON_GIVEN_CAMERA_H
#define COMMON_GIVEN_CAMERA_H

#ifndef COMMON_GEOMETRY_H
#error "include geometry.h instead"
#endif

#include "given/later.h"

/* ---- Cameras (taught in step08_projection) ---- */

/* World to view: a rigid change of frame. `center` becomes the origin, the direction from center to
 * eye becomes +z, and `up` appears upwards. Where up is parallel to the view direction (or zero)
 * the world axis most nearly perpendicular to it takes its place; where eye equals center, +z is
 * used. Orthonormal to 4 ulp for all finite arguments. */
struct mat4 mat4_lookat(struct vec3 eye, struct vec3 center, struct vec3 up);

/* View to clip for a camera at (0, 0, distance): w = 1 - z / distance; x, y and z are kept. What
 * lies at z = 0 keeps its size; depth z/w still grows towards the camera. An infinite distance
 * gives the parallel view. `distance` must not be 0. */
struct mat4 mat4_projection(double distance);

/* Barycentric weights in the plane of the triangle from those on the screen, for perspective: each
 * corner counts by its recip_w (Blinn, "Hyperbolic Interpolation", 1992). The weights on the screen
 * may have any common factor but 0, such as the area; the sum of the result is 1. */
static inline struct vec3 perspective_weights(struct vec3 screen, const double recip_w[3]) {
    double a = screen.x * recip_w[0], b = screen.y * recip_w[1], c = screen.z * recip_w[2];
    double scale = 1 / (a + b + c);
    return (struct vec3){a * scale, b * scale, c * scale};
}

#if COURSE_LESSON <= 8
#define mat4_lookat         GIVEN_LATER(mat4_lookat, lesson 8, 9)
#define mat4_projection     GIVEN_LATER(mat4_projection, lesson 8, 9)
#define perspective_weights GIVEN_LATER(perspective_weights, lesson 8, 9)
#endif /* COURSE_LESSON */

#endif
