/* The line_inside() of lesson 2. */
#define LESSON "../step02_wireframe/main.c"
#include "lesson.h"

#include "upkeep/stress/lessons.h"

uint64_t lesson02_line(struct image *image, struct pixel a, struct pixel b, struct color color) {
    return line_inside(image, a, b, color);
}
