/* Plain solids whose shape is known exactly, for tests and benchmarks. */
#ifndef COMMON_SCULPTOR_SOLIDS_H
#define COMMON_SCULPTOR_SOLIDS_H

#include "sculptor/mesh.h"

/* A sphere of radius 0.9: `rings` bands of `segments` each, triangles at the poles. */
bool solid_sphere(struct mesh *mesh, int segments, int rings);

/* A tube tied into a trefoil knot, standing in the xy plane: positions and faces alone. */
bool solid_knot(struct mesh *mesh, int segments, int rings);

#endif
