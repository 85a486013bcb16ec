/* What the lessons' own programs draw, for the properties: each lesson's main.c in a file of its
 * own. */
#ifndef TESTS_LESSONS_H
#define TESTS_LESSONS_H

#include "raster.h"
#include "tgaimage.h"

void lesson01_line(struct image *image, struct pixel a, struct pixel b, struct color color);
void lesson03_triangle(struct image *image, const struct fixed2 corner[3], struct color color);

#endif
