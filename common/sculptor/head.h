/*
 * The bust as a solid: where clay is, and which part of the body it is.
 *
 * Only the sitter's left half (x >= 0) is described; the other half is its mirror image.
 */
#ifndef COMMON_SCULPTOR_HEAD_H
#define COMMON_SCULPTOR_HEAD_H

#include "sculptor/clay.h"

/* Where the bust is cut off. */
#define BASE_Y (-0.95)

/* The eyeball, the iris and the pupil. */
#define EYE_CENTER   at(0.157, 0.350, 0.322)
#define EYE_RADIUS   0.066
#define IRIS_RADIUS  0.030
#define PUPIL_RADIUS 0.012

/* About the distance of p to the bust's surface, negative inside; the ears are not yet on it. */
double head_distance(struct vec3 p);

/* Move a point of that surface out to the ear, where one grows there; `height` is how far. */
struct vec3 head_grow_ear(struct vec3 p, double *height);

/* How far p lies from the line of sight, which goes through the middle of the iris. */
double head_from_sight(struct vec3 p);

/* How deep p lies in the opening between the lids, seen from the front; negative on the lids. */
double head_eye_opening(struct vec3 p);

/* The lips: -1..0 on the lower lip, 0..1 on the upper lip (0 on the line where they meet, +-1 on
 * their outer borders); beyond that outside the lips. `along`: 0 in the middle, 1 at the corner. */
double head_lips(struct vec3 p, double *along);

/* How far a point of the head lies above the edge of the hair; negative on bare skin. */
double head_above_hairline(struct vec3 p);

/* The hair, combed from the crown outwards: noise in stripes, about `coarse` of them around the
 * head, plus `share` times noise in `fine` of them. */
double head_strands(struct vec3 p, double coarse, double fine, double share);

#endif
