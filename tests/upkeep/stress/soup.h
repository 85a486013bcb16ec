/*
 * Random triangles in perspective, through each other, and what must be seen of them at a pixel.
 *
 * The answer is worked out in another way than the pipeline works: the camera from its geometry;
 * the part of a face that is seen in long double, cut at one plane after the other; coverage by
 * 128-bit integers; depth and attributes by fractions or long double. What it shares with the
 * pipeline are four numbers: positions are rounded to 1/256 pixel, faces end at w = 1/128, and
 * their edges end where they leave NDC -64..64 or are 2^16 pixels from the middle.
 *
 *     soup_make(&soup, seed, SOUP_CAMERA);
 *     ... draw soup.model with soup.to_clip into soup.viewport ...
 *     struct soup_hit hit = soup_look(&soup, face, x, y);
 */
#ifndef TESTS_UPKEEP_STRESS_SOUP_H
#define TESTS_UPKEEP_STRESS_SOUP_H

#include "model.h"
#include "stress.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum soup_kind {
    SOUP_WHOLE,  /* no face is cut, and all numbers are so short that depths are exact fractions */
    SOUP_STEEP,  /* no face is cut; w from 1/64 to 1024 in one face */
    SOUP_CAMERA, /* around a camera anywhere: many faces are cut at the near plane or far outside */
    SOUP_WIDE,   /* an image of 16384 x 12 pixels; corners inside, just outside, at the guard band,
                * at NDC 10000 */
    SOUP_HIGH    /* the same of 12 x 16384 */
};

enum {
    SOUP_FACES = 6,
    SOUP_CORNERS = 3 * SOUP_FACES,
    SOUP_POLYGON_LIMIT = 8, /* a triangle cut at five planes */
    SOUP_REACH = 65536      /* pixels: the pipeline's guard band goes no farther */
};

/* A corner of the part of a face that is seen. */
struct soup_corner {
    struct fixed2 screen;
    long double z, w; /* in clip space */
    double value;
};

struct soup_polygon {
    struct soup_corner corner[SOUP_POLYGON_LIMIT]; /* convex, in order around it */
    size_t count;                                  /* 0: nothing is seen of the face */
    double scale;                                  /* the largest |z/w|, and not below 1 */
};

/* Points into itself: made in place, never copied. */
struct soup {
    struct model model; /* positions and faces alone; face i has the positions 3i to 3i + 2 */
    struct mat4 to_clip;
    struct rectangle viewport;   /* smaller than the image, and hardly ever square */
    size_t width, height;        /* of the image */
    struct vec3 eye, center, up; /* of SOUP_CAMERA, with zoom: camera_call() gives to_clip */
    double zoom;
    double value[SOUP_CORNERS]; /* an attribute of each corner, 0..1 */

    /* Private. */
    enum soup_kind kind;
    long double exact_to_clip[4][4];
    long double guard_band; /* in NDC */
    struct vec3 positions[SOUP_CORNERS];
    struct face faces[SOUP_FACES];
    struct soup_polygon polygons[SOUP_FACES];
};

/* Make the same soup from the same seed. No corner is so near to the border between two steps of
 * 1/256 pixel that it could be rounded either way. */
void soup_make(struct soup *soup, uint64_t seed, enum soup_kind kind);

/* The least and the greatest right answer. They are the same for a whole triangle. Where a face was
 * cut, the polygon that is left may be drawn as any triangles between its corners, and these give
 * somewhat different answers, since rounding has moved the corners. */
struct range {
    long double least, most;
};

struct soup_hit {
    bool covered; /* the pixel's centre, by the face; depth and value only then */
    struct range depth, value;
    double value_terms; /* how much is added up for the value: see oracle_rounding_scale() */
};

struct soup_hit soup_look(const struct soup *soup, size_t face, int x, int y);

/* What is seen of each face at a pixel. */
struct soup_seen {
    struct soup_hit hit[SOUP_FACES];
    long double nearest; /* the depth that some face surely reaches; minus infinity for none */
};

/* Nothing is seen outside the viewport. */
struct soup_seen soup_see(const struct soup *soup, int x, int y);

/* Could the face be the nearest one, as far as doubles can tell? How many faces could? */
bool soup_may_show(const struct soup *soup, const struct soup_seen *seen, size_t face);
unsigned soup_candidates(const struct soup *soup, const struct soup_seen *seen);

/* Is it right that a pixel shows this face (-1: none), at this depth? Counts it; the error is that
 * of the depth, in ulp of the largest depth at a corner. */
bool soup_face_is_right(const struct soup *soup, int x, int y, int face, double depth,
                        struct tally *tally);

/* Is it right that it shows this value of that face? The error is in 1/256 texel of 1024. */
bool soup_value_is_right(const struct soup *soup, int x, int y, int face, double value,
                         struct tally *tally);

/* A soup as a case of a property. */
struct soup_case {
    uint64_t seed;
    uint64_t kind; /* enum soup_kind */
};

#endif
