/*
 * Step 9: what the ways to shade share, whatever their type of number and however many pixels they
 * shade at once. step09_float.c, step09_double.c and step09_single.c each compile step09_loops.h.
 */
#ifndef TESTS_BENCH_STEP09_WAYS_H
#define TESTS_BENCH_STEP09_WAYS_H

#include "model.h"
#include "raster.h"
#include "texture.h"
#include "tgaimage.h"

enum { SIDE = 800 };

/* A face that is seen somewhere; what its corners hand over. */
enum { VALUES = 3 }; /* u, v, intensity */

struct seen {
    struct fixed2 corner[3];
    struct edges edges;
    double depth[3], recip_w[3], value[VALUES][3];
    uint32_t face;
};

/* Pixels of row y in which one face is nearest. */
struct run {
    uint32_t number;
    struct span span;
    int y;
};

/* Where a row of CHUNK pixels has a visible one. */
struct place {
    int x, y;
};

/* What is visible of a model. */
struct visible {
    const struct model *model;
    struct mat4 to_clip;
    const struct texture *diffuse;
    size_t diffuse_level;
    struct vec3 to_light;
    struct seen *faces;
    size_t face_count;
    uint32_t *number; /* SIDE * SIDE, and one: the face that is nearest, from 1; 0 for none */
    uint32_t *same;   /* of each number that number */
    struct run *runs;
    size_t run_count;
    struct place *places;
    size_t place_count;
    size_t pixels;
    struct image image; /* BGRA; where all of them draw */
};

enum look { TEXTURED, WHITE, LOOKS };

/* The planes that all pixels of a face share: as they are; for every second pixel; without
 * perspective. */
enum planes_kind { AS_THEY_ARE, EVERY_SECOND, FLAT_ON_SCREEN, PLANES_KINDS };

/* Draw all visible pixels. */
typedef void shade_way(const struct visible *visible, const void *planes);

struct ways {
    /* The planes of all faces, to be freed with free(). NULL when memory runs out. */
    void *(*make_planes)(const struct visible *visible, enum look look, enum planes_kind kind);
    shade_way *call, *run, *inlined;               /* a call for each pixel, for each run; none */
    shade_way *every_8, *every_16, *affine, *half; /* not called either */
};

/* In the order of enum look. */
extern const struct ways ways_float[LOOKS], ways_double[LOOKS], ways_single[LOOKS];

#endif
