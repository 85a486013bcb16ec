/*
 * A scene of a lesson as triangles that OpenGL can draw, and the table of the lessons' scenes.
 *
 * A picture is a list of parts, each with a formula for the colour, a matrix and a viewport. Every
 * corner has two positions. With the plain one and the matrix OpenGL places the corner itself. The
 * snapped one names the 1/256 pixel on which the course draws it, so that OpenGL only has to find
 * the pixels and to interpolate.
 *
 * The lessons give matrices and what a corner hands to the pixels. How a face is cut at the near
 * plane, and its corners divided by w and snapped, is written here a second time, so that a mistake
 * in a lesson shows.
 */
#ifndef OPENGL_PICTURE_H
#define OPENGL_PICTURE_H

#include "pipeline.h"
#include "program.h"
#include "texture.h"

enum {
    VARYINGS = 8,
    /* The viewport of snapped positions, in pixels a side: as large as Mesa allows, its centre in
     * the middle of the picture. A power of two: a position in 1/256 pixel is exact as a float. */
    SNAPPED_VIEWPORT = 16384
};

struct gl_corner {
    float plain[4], snapped[4], varyings[VARYINGS];
    float face;           /* its number in the picture, from 1 */
    struct fixed2 screen; /* where the course draws it */
    double depth;         /* 0..1, larger is nearer */
};

enum { MAPS = 3 }; /* diffuse, normal, specular */

/* Triangles that are drawn in the same way. */
struct gl_part {
    const char *formula;              /* of a pixel's colour, in GLSL: see scene.glsl */
    const struct texture *maps[MAPS]; /* and what it reads */
    struct vec3 levels;               /* mip levels of the maps */
    struct vec3 weights;              /* of ambient, diffuse, specular light */
    struct vec3 to_light, color, light_color;
    int power;
    bool no_depth_test; /* what is drawn later is seen */
    bool not_cut;       /* the lesson doesn't cut faces */
    enum cull cull;
    struct rectangle viewport; /* nothing is drawn outside */
    struct mat4 to_clip;       /* z/w is 0..1, larger is nearer */
    size_t first, count;       /* of the picture's corners */
    unsigned program;          /* set when it is loaded: see mesa.h */
};

typedef bool draw_function(struct drawing *drawing, struct image *image, struct error *error);

struct picture {
    size_t width, height;
    /* The lesson's scene, which was drawn once. */
    struct drawing *drawing;
    struct image *image;
    draw_function *draw;
    struct error *error;
    /* From here on zero at first. */
    struct gl_part *parts;
    struct gl_corner *corners; /* three a triangle */
    size_t part_count, part_capacity, corner_count, corner_capacity, face_count;
};

/* What a corner of a face is before it is placed. */
struct corner_data {
    struct vec3 position;
    double varyings[VARYINGS];
};

/* Fill in corner 0..2 of a face, by what picture_add() was given. False: the face isn't drawn. */
typedef bool corner_function(const void *given, size_t face, size_t corner, struct corner_data *to);

/* Add a part with so many faces. False, with the picture's error set, when memory runs out or a
 * face is too far off the picture. */
bool picture_add(struct picture *picture, const struct gl_part *part, size_t face_count,
                 corner_function *corner, const void *given);

void picture_free(struct picture *picture);

/* ---- What several lessons need ---- */

struct rectangle whole_picture(const struct picture *picture);

/* The matrix with the row that OpenGL's depth needs; z is -2..2 in the parallel view. */
struct mat4 parallel_clip(struct mat4 to_clip);

/* Lessons 4 to 6: add the faces of the drawing's model on which light falls, in the parallel view.
 * Varyings: intensity, u, v. */
bool picture_add_lit_faces(struct picture *picture, struct gl_part part);

/* ---- The table of scenes ---- */

struct compared_scene {
    const char *name;
    const char *left_out; /* what is not compared, and why */
    draw_function *rest;  /* draws the scene without that; NULL: the scene's own function does */
    bool (*build)(struct picture *picture); /* adds the parts; NULL: nothing is compared */
    bool fills;       /* what no face covers is drawn too: the depth buffer says where faces are */
    bool shows_depth; /* the picture shows the depth buffer (lesson 5) */
    size_t jumps;     /* pixels of 10,000 that may be on the other side of a jump; 0: one */
};

struct lesson {
    const struct program *program;
    /* The last one has no name, and says why all others are left out, if there are any. */
    const struct compared_scene *scenes;
};

/* All of them in order, then NULL: stepNN_name/opengl.c defines lesson_stepNN. The list is written
 * by make, from the names of the files. */
extern const struct lesson *const lessons[];

#endif
