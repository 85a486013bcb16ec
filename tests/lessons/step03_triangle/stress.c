/* The triangles of lesson 3. */
#define LESSON "../step03_triangle/main.c"
#include "lesson.h"

#include "upkeep/stress/lessons.h"

void lesson03_triangle(struct image *image, const struct fixed2 corner[3], struct color color) {
    triangle(image, corner, color);
}
