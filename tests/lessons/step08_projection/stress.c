/* The viewport and the camera of step 8. */
#define LESSON "../step08_projection/main.c"
#include "lesson.h"

#include "upkeep/stress/lessons.h"

struct mat4 lesson08_viewport(size_t width, size_t height) {
    return viewport(width, height);
}

struct mat4 lesson08_lookat(struct vec3 eye, struct vec3 center, struct vec3 up) {
    return lookat(eye, center, up);
}
