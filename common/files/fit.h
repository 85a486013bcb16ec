/* Where a model lies, and moving it to where the lessons look: turned, and into -1..1. */
#ifndef COMMON_FILES_FIT_H
#define COMMON_FILES_FIT_H

#include "geometry.h"
#include "model.h"

/* The smallest box around all corners of the model's faces and lines. */
struct box3 model_box(const struct model *model);

/* Does a part of the box lie outside -1..1 in x, y or z? */
bool box_reaches_out(struct box3 box);

/* Is the longest side of the box less than a fifth of -1..1? */
bool box_is_tiny(struct box3 box);

/* A vector after so many quarter turns around x, then y, then z, each counterclockwise when seen
 * from the end of the axis. Nothing is rounded. */
struct vec3 vec3_quarter_turned(struct vec3 v, const int turns[3]);

/* Turn the model so, with its normals; the model keeps the turns, so that normals which are read
 * from a texture later turn, too. */
void model_turn(struct model *model, const int turns[3]);

/* Move the middle of the model's box to the origin and scale the model, in proportion, so that the
 * longest side of the box nearly fills -1..1: for a parallel view. With `all_around` the model
 * keeps within 7/8 of the origin, so that a camera at a distance of 2 or more sees all of it from
 * everywhere. */
void model_fit(struct model *model, bool all_around);

#endif
