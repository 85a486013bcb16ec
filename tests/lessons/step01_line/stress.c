/* The line() and the line_list() of lesson 1. */
#define LESSON "../step01_line/main.c"
#include "lesson.h"

#include "upkeep/stress/lessons.h"

size_t lesson01_list(struct pixel a, struct pixel b, struct pixel *list) {
    line_list(a, b, list);
    return line_length(a, b);
}

void lesson01_line(struct image *image, struct pixel a, struct pixel b, struct color color) {
    line(image, a, b, color);
}
