/* The line() of step 1. */
#define LESSON "../step01_line/main.c"
#include "lesson.h"

#include "upkeep/stress/lessons.h"

void lesson01_line(struct image *image, struct pixel a, struct pixel b, struct color color) {
    line(image, a, b, color);
}
