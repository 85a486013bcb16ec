/* The triangles of step 3. */
#define main step03_main
int step03_main(int argc, char **argv);
#include "../../step03_triangle/main.c"
#undef main

#include "lessons.h"

void lesson03_triangle(struct image *image, const struct fixed2 corner[3], struct color color) {
    struct canvas canvas = {.image = image, .skip = true};
    struct vertex v[3] = {{corner[0], color}, {corner[1], color}, {corner[2], color}};
    triangle(&canvas, v, color);
}
