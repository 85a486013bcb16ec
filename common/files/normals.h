/* Normals computed from the faces of a model, for files that bring none; colours from normals. */
#ifndef COMMON_FILES_NORMALS_H
#define COMMON_FILES_NORMALS_H

#include "base/error.h"
#include "geometry.h"
#include "model.h"

#include <stdbool.h>

/* The angle between two vectors in radians, 0..pi, to 1e-15 of pi; 0 where one has no length. The
 * same bits on every machine, unlike acos() of the C library. (From the lengths of the difference
 * and the sum of the unit vectors, which is accurate for all angles: Kahan, "Computing
 * Cross-Products and Rotations in 2- and 3-Dimensional Euclidean Spaces", section 13.) */
double model_angle(struct vec3 a, struct vec3 b);

/* Sets of numbers: each leads to a smaller one of its set, the least to itself, as all do at first.
 * The least of a number's set; put two sets together. */
size_t sets_find(size_t *lower, size_t number);
void sets_join(size_t *lower, size_t a, size_t b);

/* Give a normal to every corner that has none: the mean of the normals of the faces around its
 * position, weighted by the angle of each face there (Thuermer and Wuethrich, "Computing vertex
 * normals from polygonal facets", 1998), of length 1. Only faces count which one reaches from the
 * corner's without crossing a hard edge: one between smoothing groups or, where the file names none
 * or the model has its own `hard_degrees`, one at which the normals of the faces differ by more
 * than that, or else by more than 60 degrees. From 180 on no edge is hard. Where all cancel,
 * (0,0,1). */
bool model_need_normals(struct model *model, struct error *error);

/* Give a model that has colours neither of faces nor of positions those of its materials, where one
 * of them is not grey, and otherwise the colour (normal + 1) / 2 at each position. Where corners of
 * several normals meet, the first face decides; a position without a face becomes grey. Corners
 * without a normal get one first. */
bool model_need_colors(struct model *model, struct error *error);

#endif
