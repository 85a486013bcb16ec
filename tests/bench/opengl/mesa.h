/* Mesa draws a picture off the screen, by the formulas of scene.glsl. */
#ifndef OPENGL_MESA_H
#define OPENGL_MESA_H

#include "base/bytes.h"
#include "context.h"
#include "picture.h"

enum { PROGRAM_LIMIT = 24, TEXTURE_LIMIT = 4, SIDE_LIMIT = 2048 /* pixels of a picture */ };

struct mesa {
    struct gl_context context;
    struct bytes shaders;                /* scene.glsl */
    const char *formulas[PROGRAM_LIMIT]; /* a program each, made when it is first needed */
    GLuint programs[PROGRAM_LIMIT];
    size_t program_count;
    struct picture *picture; /* that is loaded; what follows is its own */
    const struct texture *textures[TEXTURE_LIMIT];
    GLuint names[TEXTURE_LIMIT]; /* by which OpenGL knows them */
    size_t texture_count;
};

/* Alpha is 0 where nothing is drawn, and see scene.glsl. */
struct rgba {
    uint8_t r, g, b, a;
};

/* What a picture shows; arrays of width * height, row by row from the bottom. */
struct seen {
    struct rgba *pixels;
    float *faces;       /* the face that is seen, from 1; 0 where nothing is */
    float (*layers)[2]; /* how many faces cover the pixel, and the sum of their numbers */
    double *depths;     /* 0..1, larger is nearer; 0 where nothing is */
};

/* All arrays zero; seen_free() is legal even after an error. */
bool seen_create(struct seen *seen, size_t pixel_count, struct error *error);
void seen_free(struct seen *seen);

/* False, with a message, where there is no OpenGL 4.5; mesa_close() is legal even then. */
bool mesa_open(struct mesa *mesa, struct error *error);
void mesa_close(struct mesa *mesa);

/* Hand over the corners, textures and formulas of a picture, which must stay as it is while it is
 * drawn. It takes the place of the last one. */
bool mesa_load(struct mesa *mesa, struct picture *picture);

/* Draw the colours of the picture, at plain or snapped positions, and wait until it is done. */
void mesa_draw(struct mesa *mesa, bool snapped);

/* Read back the depths of what was drawn last. Spoils `faces`. */
void mesa_read_depths(const struct mesa *mesa, struct seen *seen);

/* Draw the picture, and its layers, and read back everything. */
bool mesa_draw_all(struct mesa *mesa, bool snapped, struct seen *seen);

#endif
