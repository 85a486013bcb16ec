/*
 * The exact picture of a scene, and how far another one is from it.
 *
 * Corners are placed at the nearest 1/256 pixel, as every renderer here does; coverage and depth
 * are decided with whole numbers and long double (tests/oracle), and the formula of the look is
 * computed in long double from the model's own numbers. Nothing of the pipeline is called.
 */
#ifndef TESTS_BENCH_FRAME_EXACT_H
#define TESTS_BENCH_FRAME_EXACT_H

#include "scene.h"

#include <stdint.h>

struct exact {
    const struct frame_scene *scene;
    struct fixed2 *screen; /* one a position */
    double *recip_w;
    uint32_t *faces; /* one a pixel: the face that is seen, from 1; 0 where none is */
    double *depths;  /* its 1/w */
    size_t visible;  /* pixels that show a face */
};

/* How far a picture is from the exact one. */
struct deviation {
    size_t outline;  /* pixels drawn where none should be, or the other way round */
    size_t compared; /* pixels drawn in both */
    size_t rounded;  /* of these: a channel is not the level nearest to the exact value */
    double beyond;   /* the largest distance between level and exact value beyond rounding's 0.5 */
    double mean;     /* mean distance of a channel from the level nearest to the exact value */
};

/* Find what is seen. False where a face reaches the eye: such are not drawn here. The scene must
 * stay; exact_end() must be called in any case. */
bool exact_begin(struct exact *exact, const struct frame_scene *scene, struct error *error);
void exact_end(struct exact *exact);

/* Compare pictures (BGRA, row by row from the bottom, alpha 0 where nothing is drawn) with the
 * exact one, which is computed once for all of them. */
void exact_compare(const struct exact *exact, const uint8_t *const *pictures, size_t count,
                   struct deviation *deviations);

#endif
