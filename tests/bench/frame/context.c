/* OpenGL without a window: see context.h. */
#define _POSIX_C_SOURCE 200809L /* setenv */
#include "context.h"

#include <EGL/eglext.h>

#include <stdio.h>
#include <stdlib.h>

/* ---- The context ---- */

static void choose_llvmpipe(void) {
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    setenv("GALLIUM_DRIVER", "llvmpipe", 1);
    /* Otherwise the four pixels of a square share one mip level, even for texelFetch(); and a cache
     * might hold shaders that were compiled so. */
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
}

bool gl_context_open(struct gl_context *c, struct error *error) {
    static const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                        4,
                                        EGL_CONTEXT_MINOR_VERSION,
                                        5,
                                        EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                        EGL_NONE};
    choose_llvmpipe();
    *c = (struct gl_context){
        .display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL),
        .context = EGL_NO_CONTEXT,
    };
    if (c->display == EGL_NO_DISPLAY || !eglInitialize(c->display, NULL, NULL)) {
        return error_set(error,
                         "EGL has no display without a window (Mesa's surfaceless platform)");
    }
    if (eglBindAPI(EGL_OPENGL_API)) {
        c->context = eglCreateContext(c->display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    }
    if (c->context == EGL_NO_CONTEXT ||
        !eglMakeCurrent(c->display, EGL_NO_SURFACE, EGL_NO_SURFACE, c->context)) {
        return error_set(error, "EGL cannot make a context of OpenGL 4.5");
    }
    snprintf(c->name, sizeof c->name, "%s, OpenGL %s", (const char *)glGetString(GL_RENDERER),
             (const char *)glGetString(GL_VERSION));
    return true;
}

void gl_context_close(struct gl_context *c) {
    if (c->context != EGL_NO_CONTEXT) {
        eglMakeCurrent(c->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(c->display, c->context);
    }
    if (c->display != EGL_NO_DISPLAY) {
        eglTerminate(c->display);
    }
    *c = (struct gl_context){.display = EGL_NO_DISPLAY, .context = EGL_NO_CONTEXT};
}

/* ---- Shaders ---- */

/* 0, with a message, for a shader that does not compile. */
static GLuint compile(GLenum kind, const char *const *parts, size_t count, struct error *error) {
    GLuint shader = glCreateShader(kind);
    GLint compiled = GL_FALSE;
    glShaderSource(shader, (GLsizei)count, parts, NULL);
    glCompileShader(shader);
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_FALSE) {
        char log[512];
        glGetShaderInfoLog(shader, sizeof log, NULL, log);
        error_set(error, "a shader does not compile: %s", log);
        glDeleteShader(shader);
        return 0;
    }
    return shader;
}

GLuint gl_make_program(const char *const *vertex_parts, const char *const *fragment_parts,
                       size_t count, struct error *error) {
    GLuint vertex = compile(GL_VERTEX_SHADER, vertex_parts, count, error);
    GLuint fragment = vertex != 0 ? compile(GL_FRAGMENT_SHADER, fragment_parts, count, error) : 0;
    GLuint program = glCreateProgram();
    GLint linked = GL_FALSE;
    if (fragment != 0) {
        char log[512];
        glAttachShader(program, vertex);
        glAttachShader(program, fragment);
        glLinkProgram(program);
        glGetProgramiv(program, GL_LINK_STATUS, &linked);
        glGetProgramInfoLog(program, sizeof log, NULL, log);
        error_set(error, "shaders cannot be linked: %s", log);
    }
    glDeleteShader(vertex);
    glDeleteShader(fragment);
    return linked != GL_FALSE ? program : 0;
}

/* ---- Conventions ---- */

void gl_use_conventions(void) {
    /* Mesa gives a pixel centre on a horizontal edge to the triangle above it when the origin is
     * below, and to the one below it, as the top-left rule has it, when the origin is above. So the
     * origin is above and gl_set_matrix() mirrors y: twice mirrored, the picture stays upright. */
    glClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
    glFrontFace(GL_CW);
    glDepthFunc(GL_GREATER);
}

struct mat4 perspective_clip(struct mat4 to_clip) {
    for (int column = 0; column < 4; column++) {
        to_clip.m[2][column] = column == 3 ? NEAR_W : 0;
    }
    return to_clip;
}

void gl_set_vec3(GLuint program, const char *name, struct vec3 v) {
    glUniform3f(glGetUniformLocation(program, name), (float)v.x, (float)v.y, (float)v.z);
}

/* With y mirrored: see gl_use_conventions(). */
void gl_set_matrix(GLuint program, const char *name, const struct mat4 *matrix) {
    float elements[16];
    for (int i = 0; i < 16; i++) {
        float element = (float)matrix->m[i / 4][i % 4];
        elements[i] = i / 4 == 1 ? -element : element;
    }
    glUniformMatrix4fv(glGetUniformLocation(program, name), 1, GL_TRUE, elements);
}
