/*
 * Which way a face looks, and how much light falls on it. You write this in lesson 4; it is given
 * from lesson 5 on.
 */
#ifndef COMMON_GIVEN_FACES_H
#define COMMON_GIVEN_FACES_H

#ifndef COMMON_MODEL_H
#error "include model.h instead"
#endif

#include "given/later.h"

/* The normal of a face, pointing outwards; as long as twice the face's area. */
static inline struct vec3 model_face_normal(const struct model *model, size_t face) {
    struct vec3 a = model_position(model, face, 0);
    struct vec3 b = model_position(model, face, 1);
    struct vec3 c = model_position(model, face, 2);
    return vec3_cross(vec3_sub(b, a), vec3_sub(c, a));
}

/* ---- Light on a face (taught in step04_flat) ---- */

/* How directly light that travels in direction `light` (of length 1) falls on the outside of a
 * face: 1 straight, 0 along it, negative from behind. */
static inline double model_face_intensity(const struct model *model, size_t face,
                                          struct vec3 light) {
    return -vec3_dot(vec3_normalized(model_face_normal(model, face)), light);
}

#if COURSE_LESSON <= 4
#define model_face_normal    GIVEN_LATER(model_face_normal, lesson 4, 5)
#define model_face_intensity GIVEN_LATER(model_face_intensity, lesson 4, 5)
#endif /* COURSE_LESSON */

#endif
