/* Functions of lessons that the properties hold against exact answers. Each lesson's main.c is
 * included in a file of its own, tests/lessons/stepNN_name/stress.c. */
#ifndef TESTS_LESSONS_H
#define TESTS_LESSONS_H

#include "raster.h"
#include "texture.h"
#include "tgaimage.h"

/* What triangles with depths are drawn on. */
struct depth_image {
    struct image *image;
    double *depth; /* one a pixel */
    bool skip;     /* no colour for what is hidden */
};

void lesson01_line(struct image *image, struct pixel a, struct pixel b, struct color color);
uint64_t lesson02_line(struct image *image, struct pixel a, struct pixel b, struct color color);
void lesson03_triangle(struct image *image, const struct fixed2 corner[3], struct color color);
void lesson04_triangle(struct image *image, const struct fixed2 corner[3], struct color color);

/* Draw a triangle in one level of grey; they return how many pixels were tested. */
typedef uint64_t depth_triangle(const struct depth_image *on, const struct fixed2 corner[3],
                                const double depth[3], uint8_t level);
depth_triangle lesson05_triangle, lesson06_triangle, lesson07_triangle;

struct color lesson06_nearest(const struct texture *texture, struct vec2 uv);
struct vec4 lesson06_bilinear(const struct texture *texture, struct vec2 uv, size_t level);
struct vec4 lesson06_trilinear(const struct texture *texture, struct vec2 uv, double level);
struct mat4 lesson08_viewport(size_t width, size_t height);
struct mat4 lesson08_lookat(struct vec3 eye, struct vec3 center, struct vec3 up);

#endif
