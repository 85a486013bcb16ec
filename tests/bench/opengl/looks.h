/* The lessons' shading formulas in GLSL, in float: see looks.c. */
#ifndef OPENGL_LOOKS_H
#define OPENGL_LOOKS_H

#include "picture.h"

enum { LOOK_PARTS = 5 };

/* The parts of the source text of a look's shaders, in order. */
void look_vertex_shader(enum look look, const char *parts[LOOK_PARTS]);
void look_fragment_shader(enum look look, const char *parts[LOOK_PARTS]);

/* The same for a shader that adds 1 and the face's number at every pixel, seen or hidden. */
void layer_fragment_shader(const char *parts[LOOK_PARTS]);

#endif
