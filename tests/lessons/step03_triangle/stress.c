/* The triangles of step 3. */
#define main step03_main
int step03_main(int argc, char **argv);
#include "../../../step03_triangle/main.c"
#undef main

#include "upkeep/stress/lessons.h"

void lesson03_triangle(struct image *image, const struct fixed2 corner[3], struct color color) {
    triangle(image, corner, color);
}
