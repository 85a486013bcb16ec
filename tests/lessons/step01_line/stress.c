/* The line() of step 1. */
#define main step01_main
int step01_main(int argc, char **argv);
#include "../../../step01_line/main.c"
#undef main

#include "upkeep/stress/lessons.h"

void lesson01_line(struct image *image, struct pixel a, struct pixel b, struct color color) {
    line(image, a, b, color);
}
