/* What the properties of the lessons share. Each lesson's main.c is included in its own file,
 * tests/lessons/stepNN_name/stress.c, which has that lesson's properties or lends its functions to
 * others. */
#ifndef TESTS_UPKEEP_STRESS_LESSONS_H
#define TESTS_UPKEEP_STRESS_LESSONS_H

#include "lanes.h"
#include "model.h"
#include "oracle/oracle.h"
#include "oracle/reals.h"
#include "raster.h"
#include "texture.h"
#include "tgaimage.h"

/* ---- Functions of lessons that others hold against exact answers ---- */

size_t lesson01_list(struct pixel a, struct pixel b, struct pixel *list);
void lesson01_line(struct image *image, struct pixel a, struct pixel b, struct color color);
uint64_t lesson02_line(struct image *image, struct pixel a, struct pixel b, struct color color);
void lesson03_triangle(struct image *image, const struct fixed2 corner[3], struct color color);
void lesson04_triangle(struct image *image, const struct fixed2 corner[3], struct color color);
struct color lesson06_nearest(const struct texture *texture, struct vec2 uv);
struct vec4 lesson06_bilinear(const struct texture *texture, struct vec2 uv, size_t level);
struct vec4 lesson06_trilinear(const struct texture *texture, struct vec2 uv, double level);

/* ---- Numbers ---- */

/* Is the number within `slack` of the exact one? What is no number never is. */
bool is_near(double got, long double exact, long double slack);

/* Is it the nearest 1/256 pixel? Halfway between two either is right. */
bool is_snapped(int32_t position, long double pixels);

/* Is a level 0..255 the one nearest to this value, or one of two that are equally near except for
 * rounding? And is each channel of a colour; red, green, blue as x, y, z? */
bool level_is_right(uint8_t level, long double exact);
bool color_is_right(struct color color, struct real3 exact);

/* What so many roundings of numbers near 1 cost at most, where they are done in `real`. */
long double real_slack(long double roundings);

/* As color_is_right(), for a colour that was computed in `real` with so many roundings. */
bool color_is_near(struct color color, struct real3 exact, long double roundings);

/* What a fragment function makes of a pixel with these varyings, at most 8. */
struct pixel_color {
    struct color color;
    bool drawn;
};

typedef lanes_mask fragment_function(const void *uniforms, const lanes *varyings,
                                     lanes_texel *color);

struct pixel_color shade_pixel(fragment_function *fragment, const void *uniforms,
                               const double *varyings, size_t count);

/* base * base * ... */
long double exact_power(long double base, int power);

/* A direction of length 1, except for rounding. */
struct vec3 random_direction(struct random *random);

/* A vector of any length, from 2^-reach to 2^reach; now and then zero. */
struct vec3 random_vector(struct random *random, int reach);

/* ---- Lines ---- */

struct line_case {
    struct pixel a, b;
};

/* Make a struct line_case: of any length, most of them in or through an image of 13 x 11 pixels. */
void make_any_line(struct random *random, uint64_t index, void *made);

/* ---- Triangles over one another on a small screen ---- */

enum { LAYER_COUNT = 4 };

struct layers {
    struct fixed2 corner[LAYER_COUNT][3];
    double depth[LAYER_COUNT][3];
};

/* Make struct layers: hostile triangles in depths that are often close or equal; some are copies of
 * earlier ones. */
void make_layers(struct random *random, uint64_t index, void *made);

/* The value at a pixel of what is linear on the screen, from those at the corners of a layer. */
long double layer_value(const struct layers *layers, int layer, const double value[3], int x,
                        int y);

/* How a lesson draws the layers of a case. */
struct layered {
    const struct layers *layers;
    const void *tried;
    int side; /* so many pictures next to and above one another show the same layers */
    /* The depth has one number for each pixel of one picture. */
    void (*draw)(const void *tried, struct image *image, double *depth);
    /* Does the layer have this colour at this pixel, in a picture (from 0, below left)? */
    bool (*has_color)(const void *tried, int layer, int picture, int x, int y, struct color color);
};

/* Does each pixel show a layer that may be seen there: which covers it, in front of which none is
 * by more than rounding can hide, and which is no copy of an earlier one? With its colour and its
 * depth; and all must stay when the layers are drawn again. */
bool layers_are_right(const struct layered *layered);

/* How many pixels the layers cover, together. */
uint64_t layers_cover(const struct layers *layers);

/* ---- A model of one face ---- */

struct one_face {
    struct vec3 position[3];
    float uv[3][2], normal[3][3];
    struct face face;
};

/* Of any size, slivers too; now and then without area or with normals of length 0. */
void make_face(struct random *random, uint64_t index, struct one_face *face);

/* The model uses `face`: nothing to free. */
struct model model_of(struct one_face *face);

struct real3 face_normal(const struct one_face *face, size_t corner); /* of length 1, or 0 */

/* (b - a) x (c - a) of its positions, and how uncertain rounding makes its direction: the lengths
 * of these two sides over twice the area. */
struct real3 face_cross(const struct one_face *face, long double *uncertainty);

/* ---- Textures ---- */

/* A clamped texture of one level; it uses `texels`: nothing to free. The texels have to go on for a
 * row and a texel, which count for nothing. */
struct texture texture_from(uint32_t *texels, size_t width, size_t height);

enum { PICTURE_SIDE = 9 };

/* A small picture of any size, also of one texel, and a mip level of it. */
struct picture {
    size_t width, height, level;
    bool clamp;
    uint8_t channel[PICTURE_SIDE * PICTURE_SIDE][4]; /* blue, green, red, alpha */
};

void make_picture(struct random *random, struct picture *picture);

/* Where to look at pictures: also on texel borders and outside. */
struct vec2 random_uv(struct random *random);

/* A texture with all its mip levels, which the caller frees. */
bool texture_of_picture(const struct picture *picture, struct texture *texture);

/* Red, green, blue, alpha. */
struct sample {
    long double channel[4];
};

/* The mean of all texels of a level, each with its weight: a tent around its centre. */
struct sample exact_bilinear(const struct texture *texture, size_t number, double u, double v);

/* Red, green and blue of it. */
struct real3 exact_color(const struct texture *texture, size_t level, struct vec2 uv);

/* How many roundings of numbers of the size of the result it costs: mostly those of the
 * coordinates, which texels multiply. */
enum { TEXEL_ROUNDINGS = 32 };

/* The direction that this colour means in a normal map, of length 1, and its roundings: the
 * more, the shorter the normal was before. */
struct real3 exact_normal(const struct texture *texture, size_t level, struct vec2 uv,
                          long double *roundings);

#endif
