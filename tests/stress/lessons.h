/* What the lessons' own programs draw, for the properties: each lesson's main.c has a file here. */
#ifndef TESTS_LESSONS_H
#define TESTS_LESSONS_H

#include "raster.h"
#include "texture.h"
#include "tgaimage.h"

void lesson01_line(struct image *image, struct pixel a, struct pixel b, struct color color);
void lesson03_triangle(struct image *image, const struct fixed2 corner[3], struct color color);
struct color lesson06_nearest(const struct texture *texture, struct vec2 uv);
struct vec4 lesson06_bilinear(const struct texture *texture, struct vec2 uv, size_t level);
struct vec4 lesson06_trilinear(const struct texture *texture, struct vec2 uv, double level);
struct mat4 lesson08_viewport(size_t width, size_t height);

#endif
