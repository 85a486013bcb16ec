/* What the properties of the lessons share. Each lesson's main.c is included in a file of its own,
 * lessonNN.c, which has that lesson's properties or lends its functions to others. */
#ifndef TESTS_LESSONS_H
#define TESTS_LESSONS_H

#include "lanes.h"
#include "model.h"
#include "oracle/oracle.h"
#include "oracle/reals.h"
#include "raster.h"
#include "texture.h"
#include "tgaimage.h"

/* ---- Functions of lessons that others hold against exact answers ---- */

void lesson01_line(struct image *image, struct pixel a, struct pixel b, struct color color);
uint64_t lesson02_line(struct image *image, struct pixel a, struct pixel b, struct color color);
void lesson03_triangle(struct image *image, const struct fixed2 corner[3], struct color color);
void lesson04_triangle(struct image *image, const struct fixed2 corner[3], struct color color);
struct color lesson06_nearest(const struct texture *texture, struct vec2 uv);
struct vec4 lesson06_bilinear(const struct texture *texture, struct vec2 uv, size_t level);
struct vec4 lesson06_trilinear(const struct texture *texture, struct vec2 uv, double level);
struct mat4 lesson08_viewport(size_t width, size_t height);

/* ---- The frame of a camera (cameras.c) ---- */

/* How far the three rows are from unit length and right angles, in ulp of 1; infinite where the
 * third points against the cross product of the others. */
double view_frame_error(const struct mat4 *view);

/* How far they are from the oracle's axes, in ulp of 1, where these are certain. The smaller the
 * angle between up and the line of sight, the less is asked of the first two. */
double view_axes_error(const struct mat4 *view, struct vec3 eye, struct vec3 center,
                       struct vec3 up);

/* Does the center become the origin, as nearly as its products with the axes can be added? */
bool view_moves_center(const struct mat4 *view, struct vec3 center);

void print_camera_options(struct vec3 eye, struct vec3 center, struct vec3 up);

/* ---- Numbers ---- */

/* Is a level 0..255 the one nearest to this value, or one of two that are equally near but for
 * rounding? */
bool level_is_right(uint8_t level, long double exact);

/* The three channels; red, green, blue as x, y, z. */
bool color_is_right(struct color color, struct real3 exact);

/* ---- Pixel arithmetic, which is done in `real` ---- */

/* What rounding a number near 1 costs at most. */
static const long double real_ulp = sizeof(real) == sizeof(float) ? 0x1p-24L : 0x1p-53L;

/* So many roundings of numbers near 1, where they are done in float; in double `if_double`. */
long double real_slack(long double roundings, long double if_double);

/* How many roundings of numbers of the size of the result a bilinear sample costs, of a picture of
 * PICTURE_SIDE texels: mostly those of the coordinates, which texels multiply. */
enum { TEXEL_ROUNDINGS = 32 };

/* And a normal of length 1 from such a picture: the more, the shorter the normal was before. */
long double normal_roundings(const struct texture *texture, size_t level, struct vec2 uv);

/* As color_is_right(), for a colour that was computed in `real` with so many roundings. */
bool color_is_near(struct color color, struct real3 exact, long double roundings);

/* A number for one of the lanes, which lane_of() gives back; the others hold other numbers. */
lanes lanes_holding(double value);
double lane_of(lanes value);

/* What a fragment function makes of a pixel with these varyings, at most 8. */
struct pixel_color {
    struct color color;
    bool drawn;
};

struct pixel_color shade_pixel(lanes_mask (*fragment)(const void *, const lanes *, lanes_texel *),
                               const void *uniforms, const double *varyings, size_t count);

/* ---- Random vectors ---- */

/* A direction of length 1, but for rounding. */
struct vec3 random_direction(struct random *random);

/* A vector of any length, from 2^-reach to 2^reach; now and then zero. */
struct vec3 random_vector(struct random *random, int reach);

/* ---- Triangles over one another on a small screen ---- */

enum { LAYER_COUNT = 4 };

struct layers {
    struct fixed2 corner[LAYER_COUNT][3];
    double depth[LAYER_COUNT][3];
};

/* Hostile triangles in depths that are often close or equal; some are copies of earlier ones. */
void make_layers(struct random *random, uint64_t index, struct layers *layers);

/* The value at a pixel of what is linear on the screen, from those at the corners of a layer. */
long double layer_value(const struct layers *layers, int layer, const double value[3], int x,
                        int y);

/* How far a depth of a layer may be off. */
double layer_tolerance(const struct layers *layers, int layer);

/* May the layer be seen at the pixel, when all were drawn in order? It covers the pixel, none is
 * nearer by more than rounding can hide, and it is not the copy of an earlier one: of equal depths
 * the first stays. */
bool layer_may_show(const struct layers *layers, int layer, int x, int y);

/* How many pixels all layers cover together. */
uint64_t layers_pixel_count(const struct layers *layers);

void print_layers(const struct layers *layers);

/* ---- A model of a few faces, each with corners of its own ---- */

enum { MESH_FACES = 6, MESH_CORNERS = 3 * MESH_FACES };

struct mesh_data {
    struct vec3 position[MESH_CORNERS];
    float uv[MESH_CORNERS][2], normal[MESH_CORNERS][3];
};

struct mesh {
    struct model model;
    struct face faces[MESH_FACES];
};

/* Face i has corners 3 i to 3 i + 2. The model uses `data` and `mesh`: nothing to free. */
void mesh_from(struct mesh *mesh, struct mesh_data *data, size_t face_count);

void mesh_set(float to[3], struct vec3 from);
struct real3 mesh_get(const float from[3]);

/* ---- Textures ---- */

/* A texture of one level; it uses `texels`: nothing to free. */
struct texture texture_from(uint32_t *texels, size_t width, size_t height);

enum { PICTURE_SIDE = 4, PICTURE_LEVELS = 3 };

/* Red, green, blue, alpha of each texel of a small square picture. */
struct picture_data {
    uint8_t level[PICTURE_SIDE * PICTURE_SIDE][4];
};

void make_picture(struct random *random, struct picture_data *picture);

/* A texture with all its mip levels, which the caller frees. */
bool texture_of_picture(const struct picture_data *picture, struct texture *texture);

/* Red, green, blue, alpha. */
struct sample {
    long double channel[4];
};

/* The mean of all texels of a level, each with its weight: a tent around its centre. */
struct sample exact_bilinear(const struct texture_level *level, double u, double v);

/* Red, green and blue of it. */
struct real3 exact_color(const struct texture *texture, size_t level, struct vec2 uv);

/* The direction that this colour stands for in a normal map, of length 1. */
struct real3 exact_normal(const struct texture *texture, size_t level, struct vec2 uv);

#endif
