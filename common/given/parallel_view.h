/*
 * From the world to the screen without a camera. You write this in lesson 2; it is given from
 * lesson 3 on.
 */
#ifndef COMMON_GIVEN_PARALLEL_VIEW_H
#define COMMON_GIVEN_PARALLEL_VIEW_H

#ifndef COMMON_GEOMETRY_H
#error "include geometry.h instead"
#endif

#include "given/later.h"

/* ---- The parallel view (taught in step02_wireframe) ---- */

/* The parallel view of lessons 2 to 7, on a screen of width x height pixels: x and y in -1..1 fill
 * it, z does not count. */
static inline struct vec2 parallel_view(struct vec3 world, size_t width, size_t height) {
    return (struct vec2){(world.x + 1) * (double)width / 2, (world.y + 1) * (double)height / 2};
}

#if COURSE_LESSON <= 2
#define parallel_view GIVEN_LATER(parallel_view, lesson 2, 3)
#endif /* COURSE_LESSON */

#endif
