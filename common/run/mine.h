/*
 * What was written in lessons 1 and 3, for the lessons that follow: `make LINE=mine`. Each lesson's
 * mine.c gives its functions these names. The house versions are those of raster.h.
 */
#ifndef COMMON_RUN_MINE_H
#define COMMON_RUN_MINE_H

#include "raster.h"
#include "tgaimage.h"

/* Draw a line with line() of step01_line/main.c; returns line_length(). */
uint64_t my_line(struct image *image, struct pixel a, struct pixel b, struct color color);

/* triangle_setup() and triangle_span() of step03_triangle/main.c. */
bool my_triangle_setup(struct edges *edges, struct fixed2 a, struct fixed2 b, struct fixed2 c,
                       size_t width, size_t height);
struct span my_triangle_span(const struct edges *edges, int y);

#endif
