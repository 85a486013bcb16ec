/*
 * OpenGL without a window, drawn by Mesa's software renderer (llvmpipe), whatever graphics hardware
 * the machine has: for all that compares with the same program. EGL on the surfaceless platform.
 */
#ifndef OPENGL_CONTEXT_H
#define OPENGL_CONTEXT_H

#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <GL/gl.h>
#include <GL/glext.h>

#include "base/error.h"
#include "geometry.h"

#include <stdbool.h>
#include <stddef.h>

struct gl_context {
    EGLDisplay display;
    EGLContext context;
    char name[256]; /* "llvmpipe (...), version" */
};

/* Make a context of OpenGL 4.5 and use it. False, with a message, where there is no EGL or no such
 * OpenGL; gl_context_close() is legal even then. */
bool gl_context_open(struct gl_context *context, struct error *error);
void gl_context_close(struct gl_context *context);

/* Compile and link two shaders, each given as `count` parts of its source text. 0, with a message,
 * where that fails. */
GLuint gl_make_program(const char *const *vertex_parts, const char *const *fragment_parts,
                       size_t count, struct error *error);

/* From now on, with matrices of gl_set_matrix(), pixels on an edge go to the triangle that the
 * top-left rule names; front faces and depth are those of the course. */
void gl_use_conventions(void);

/* In perspective the course's z/w grows with 1/w, so 1/w may stand for it: NEAR_W / w is 0..1 and
 * keeps a float's precision at all distances. Here NEAR_W is where the course cuts. */
#define NEAR_W (1.0 / 128)

/* The course's matrix with that as its depth. */
struct mat4 perspective_clip(struct mat4 to_clip);

/* Set a uniform of the program in use. */
void gl_set_vec3(GLuint program, const char *name, struct vec3 v);
void gl_set_matrix(GLuint program, const char *name, const struct mat4 *matrix);

#endif
