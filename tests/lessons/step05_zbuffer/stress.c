/* The triangles of step 5. */
#define LESSON "../step05_zbuffer/main.c"
#include "lesson.h"

#include "upkeep/stress/lessons.h"

uint64_t lesson05_triangle(const struct depth_image *on, const struct fixed2 corner[3],
                           const double depth[3], uint8_t level) {
    struct canvas canvas = {.image = on->image, .depth = on->depth};
    struct vertex v[3];
    for (int i = 0; i < 3; i++) {
        v[i] = (struct vertex){corner[i], depth[i]};
    }
    triangle(&canvas, v, color_grey(level));
    return canvas.pixels_tested;
}
