/*
 * Mesa, without a window: draws pictures off the screen and gives back what it has drawn.
 *
 * Uses EGL on the surfaceless platform and Mesa's software renderer (llvmpipe), whatever graphics
 * hardware the machine has, so that all machines compare with the same program.
 */
#ifndef OPENGL_MESA_H
#define OPENGL_MESA_H

#include "base/error.h"
#include "picture.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct mesa;

enum positions { POSITIONS_WHOLE, POSITIONS_SNAPPED };

/* What Mesa has drawn; arrays of width * height, row by row from the bottom. */
struct mesa_result {
    uint8_t *pixels;    /* red, green, blue, alpha: see looks.c */
    float *faces;       /* the face that is seen, from 1; 0 where nothing is */
    float *depths;      /* 0..1, larger is nearer; 0 where nothing is */
    float (*layers)[2]; /* how many faces cover the pixel, and the sum of their numbers */
};

/* NULL, with a message, where there is no EGL or no OpenGL 4.5. */
struct mesa *mesa_open(struct error *error);
void mesa_close(struct mesa *mesa);

/* "llvmpipe (...), version". Belongs to `mesa`. */
const char *mesa_name(const struct mesa *mesa);

/* Hand over the triangles and textures of a picture. One picture at a time. */
bool mesa_load(struct mesa *mesa, const struct picture *picture, struct error *error);
void mesa_unload(struct mesa *mesa);

/* Draw the picture that is loaded and wait until it is done. */
void mesa_draw(struct mesa *mesa, const struct picture *picture, enum positions positions);

/* Read back the depth of what was drawn last. */
void mesa_read_depths(struct mesa *mesa, const struct picture *picture, float *depths);

/* Draw the picture, and its layers, and read back everything. */
bool mesa_draw_and_read(struct mesa *mesa, const struct picture *picture, enum positions positions,
                        struct mesa_result *result, struct error *error);

void mesa_result_free(struct mesa_result *result);

#endif
