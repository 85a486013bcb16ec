/* The triangles of step 4. */
#define LESSON "../step04_flat/main.c"
#include "lesson.h"

#include "upkeep/stress/lessons.h"

void lesson04_triangle(struct image *image, const struct fixed2 corner[3], struct color color) {
    const struct vertex v[3] = {{corner[0]}, {corner[1]}, {corner[2]}};
    triangle(image, v, color);
}
