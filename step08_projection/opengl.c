/*
 * Scene `lookat` drawn by OpenGL, without a window (EGL), to compare: CAMERA.md, question 5.
 *
 * OpenGL gets your matrices projection() and lookat(), and the light at the corners. It clips,
 * divides, finds the pixels, tests the depth and mixes by itself.
 */
#define main lesson_main
#include "main.c"
#undef main

#include "files/image_file.h"
#include "files/model_file.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <stdio.h>
#include <stdlib.h>

enum { SIDE = 800 };

/* A framebuffer of SIDE x SIDE pixels with a depth buffer, where OpenGL draws from now on. */
static bool open_framebuffer(void) {
    const EGLint wanted[][2] = {
        {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT}, {EGL_RED_SIZE, 8}, {EGL_DEPTH_SIZE, 24}, {EGL_NONE}};
    const EGLint size[] = {EGL_WIDTH, SIDE, EGL_HEIGHT, SIDE, EGL_NONE};
    EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, NULL, NULL);
    EGLConfig config = NULL;
    EGLint count = 0;
    if (!eglInitialize(display, NULL, NULL) || !eglBindAPI(EGL_OPENGL_API) ||
        !eglChooseConfig(display, wanted[0], &config, 1, &count) || count == 0) {
        return false;
    }
    EGLSurface surface = eglCreatePbufferSurface(display, config, size);
    return eglMakeCurrent(display, surface, surface,
                          eglCreateContext(display, config, EGL_NO_CONTEXT, NULL));
}

static void set_texture(const struct texture_level *level) {
    glEnable(GL_TEXTURE_2D);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, (GLint)level->pitch);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, (GLsizei)level->width, (GLsizei)level->height, 0,
                 GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, level->texels);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR); /* bilinear, no mip levels */
}

static void draw_with_opengl(const struct model *model, struct vec3 eye, struct vec3 to_light) {
    const struct vec3 center = {0, 0, 0}, up = {0, 1, 0};
    struct mat4 to_clip = mat4_mul(projection(vec3_length(eye)), lookat(eye, center, up));
    /* In OpenGL smaller depths are nearer, and what is not in -1..1 is cut off. */
    to_clip = mat4_mul(mat4_scaling((struct vec3){1, 1, -0.25}), to_clip);
    to_clip = mat4_transpose(to_clip); /* OpenGL wants it column by column */
    glLoadMatrixd(&to_clip.m[0][0]);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glBegin(GL_TRIANGLES);
    for (size_t i = 0; i < 3 * model->face_count; i++) {
        struct vec3 p = model_position(model, i / 3, i % 3);
        struct vec2 uv = model_uv(model, i / 3, i % 3);
        double intensity = fmax(0, vec3_dot(model_normal(model, i / 3, i % 3), to_light));
        glColor3d(intensity, intensity, intensity); /* times the texture's colour */
        glTexCoord2d(uv.x, uv.y);
        glVertex3d(p.x, p.y, p.z);
    }
    glEnd();
}

/* How many pixels differ by more than 2 of 255? */
static int count_differing(const struct image *a, const struct image *b) {
    int count = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        struct color p = image_get(a, i % SIDE, i / SIDE), q = image_get(b, i % SIDE, i / SIDE);
        count += abs(p.r - q.r) > 2 || abs(p.g - q.g) > 2 || abs(p.b - q.b) > 2;
    }
    return count;
}

int main(void) {
    struct image image, yours;
    struct model model;
    struct error error;
    const struct texture *diffuse = NULL;
    if (!open_framebuffer()) {
        fprintf(stderr, "OpenGL can't draw here: is Mesa installed?\n");
        return 1;
    }
    if (!model_read(&model, "build/models/bust.obj", &error) ||
        (diffuse = model_texture(&model, MODEL_DIFFUSE, &error)) == NULL ||
        !image_read(&yours, "build/out/step08_projection/lookat.tga", &error) ||
        !image_create(&image, SIDE, SIDE, IMAGE_BGR, &error)) {
        fprintf(stderr, "%s\n", error.message);
        return 1;
    }
    set_texture(&diffuse->level[0]);
    draw_with_opengl(&model, (struct vec3){1, 1, 2}, vec3_normalized((struct vec3){1, 1, 2}));
    glReadPixels(0, 0, SIDE, SIDE, GL_BGR, GL_UNSIGNED_BYTE, image.pixels);
    printf("%d of %d pixels differ\n", count_differing(&image, &yours), SIDE * SIDE);
    return tga_write(&image, "build/opengl.tga", &error) ? 0 : 1;
}
