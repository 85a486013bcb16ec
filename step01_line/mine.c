/* For `make LINE=mine`: the line() of this lesson's main.c draws in the next two lessons. */
#define main step01_main
int step01_main(int argc, char **argv);
#include "main.c"
#undef main

#include "run/mine.h"

uint64_t my_line(struct image *image, struct pixel a, struct pixel b, struct color color) {
    line(image, a, b, color);
    return line_length(a, b);
}
