/* The triangles of step 7. */
#define LESSON "../step07_gouraud/main.c"
#include "lesson.h"

#include "upkeep/stress/lessons.h"

uint64_t lesson07_triangle(const struct depth_image *on, const struct fixed2 corner[3],
                           const double depth[3], uint8_t level) {
    struct canvas canvas = {.image = on->image,
                            .width = on->image->width,
                            .height = on->image->height,
                            .depth = on->depth,
                            .skip = on->skip};
    struct vertex v[3];
    struct edges edges;
    for (int i = 0; i < 3; i++) {
        v[i] =
            (struct vertex){.position = corner[i], .depth = depth[i], .intensity = level / 255.0};
    }
    if (edges_setup(&edges, corner[0], corner[1], corner[2], canvas.width, canvas.height)) {
        triangle(&canvas, &edges, v);
    }
    return canvas.pixels_tested;
}
