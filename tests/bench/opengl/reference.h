/*
 * The triangles of a picture drawn with the course's edges, without any shading: which face every
 * pixel shows, its depth, and all faces that cover the pixel. What is not seen in a picture (hidden
 * triangles) is compared through this.
 */
#ifndef OPENGL_REFERENCE_H
#define OPENGL_REFERENCE_H

#include "picture.h"

/* Arrays of width * height, row by row from the bottom, as in struct mesa_result. */
struct reference {
    float *faces;       /* the face that is seen, from 1; 0 where nothing is */
    double *depths;     /* 0..1, larger is nearer; 0 where nothing is */
    float (*layers)[2]; /* how many faces cover the pixel, and the sum of their numbers */
};

bool reference_draw(struct reference *reference, const struct picture *picture,
                    struct error *error);
void reference_free(struct reference *reference);

#endif
