/*
 * What one picture of the course is made of, as triangles that Mesa can draw.
 *
 * A picture is a list of batches: triangles that share a shader, a viewport and a culling mode.
 * Each batch holds its triangles twice, since there are two ways to hand them to OpenGL:
 *
 *   WHOLE    the faces of the mesh and the matrix: OpenGL transforms, clips and snaps them itself;
 *   SNAPPED  the triangles that the course draws, each corner at the 1/256 pixel where the course
 *            has placed it: OpenGL has only to find the pixels and to interpolate.
 *
 * What a corner hands to the pixels (`varyings`) is computed by the lesson's own code in both
 * cases.
 */
#ifndef OPENGL_PICTURE_H
#define OPENGL_PICTURE_H

#include "base/error.h"
#include "geometry.h"
#include "pipeline.h"
#include "program.h"
#include "texture.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The fragment shaders, each with the formula of a lesson. */
enum look {
    LOOK_WHITE,            /* steps 4, 5, 7, 9: intensity */
    LOOK_LIT_ONLY,         /* step 9: intensity; not drawn where it is 0 */
    LOOK_NEAREST,          /* step 6: u, v, intensity */
    LOOK_CHECKER,          /* step 6: u, v */
    LOOK_COLORS,           /* step 7: red, green, blue */
    LOOK_LIT,              /* step 7: diffuse and specular part */
    LOOK_BILINEAR,         /* steps 8 and 9: u, v, intensity */
    LOOK_TOON,             /* step 9: intensity */
    LOOK_NORMAL_MAP,       /* step 9: u, v */
    LOOK_PHONG_PLAIN,      /* step 10: towards the eye, u, v, normal */
    LOOK_PHONG_MAPPED,     /* step 10: towards the eye, u, v */
    LOOK_PHONG_TEXTURED,   /* step 10: towards the eye, u, v, normal */
    LOOK_PHONG_FULL,       /* step 10: towards the eye, u, v */
    LOOK_PHONG_WEIGHT_MAP, /* step 10: towards the eye, u, v */
    LOOK_PHONG_POWER_MAP,  /* step 10: towards the eye, u, v */
    LOOK_COUNT
};

/* What the shader of a batch reads beside the varyings. */
struct look_values {
    const struct texture *diffuse_map, *normal_map, *specular_map; /* NULL where none is read */
    size_t diffuse_level, normal_level, specular_level;            /* mip levels */
    struct vec3 to_light;                                          /* of length 1 */
    double ambient, diffuse, specular;                             /* weights */
    int power;
    struct vec3 color, light_color; /* levels 0..255 */
};

enum { VARYINGS = 8 };

/* SNAPPED positions are given in a viewport of this many pixels a side, as large as Mesa allows,
 * with its centre at the middle of the picture. A power of two: a position in 1/256 pixel
 * becomes a float without rounding. Mesa cuts triangles at twice its size only. */
enum { SNAPPED_VIEWPORT = 16384 };

/* A corner as OpenGL gets it. */
struct gl_corner {
    float position[4]; /* WHOLE: x, y, z, 1 before the matrix; SNAPPED: clip space */
    float varyings[VARYINGS];
    float face; /* number of the face, from 1 */
};

/* A corner on the screen, as the course has placed it. */
struct placed {
    struct fixed2 screen;
    double depth;   /* as in OpenGL's depth buffer: 0..1, larger is nearer */
    double recip_w; /* 1/w */
};

struct batch {
    enum look look;
    struct look_values values;
    bool depth_test; /* otherwise what comes later is seen */
    enum cull cull;
    struct rectangle viewport;  /* NDC -1..1 goes here, and nothing is drawn outside */
    struct vec2 snapped_center; /* pixels; set by picture_add_batch() */
    struct mat4 to_clip;        /* for WHOLE: z/w is 0..1, larger is nearer */
    struct gl_corner *whole;    /* three a triangle */
    size_t whole_count, whole_capacity;
    struct gl_corner *snapped; /* three a triangle */
    struct placed *placed;     /* one for each of `snapped` */
    size_t snapped_count, snapped_capacity;
};

/* All zero is a valid, empty picture. */
struct picture {
    size_t width, height;
    int shift;        /* moves the snapped positions, in 1/256 pixel: to see the comparison fail */
    bool shows_depth; /* the picture is the depth buffer (step 5) and not the colours */
    struct batch *batches;
    size_t batch_count;
};

/* A corner of a face, before it is known how OpenGL gets it. */
struct corner_data {
    struct vec3 position; /* before the batch's matrix */
    struct placed placed;
    double varyings[VARYINGS];
};

/* Start a batch: the settings are copied, the lists of triangles start empty. NULL when memory runs
 * out; otherwise valid until the next call. */
struct batch *picture_add_batch(struct picture *picture, const struct batch *settings,
                                struct error *error);

/* Add a face to WHOLE or a triangle to SNAPPED. `face` counts from 0. */
bool batch_add_whole(struct batch *batch, size_t face, const struct corner_data corners[3],
                     struct error *error);
bool batch_add_snapped(struct batch *batch, size_t face, const struct corner_data corners[3],
                       struct error *error);

/* Both. */
bool batch_add_face(struct batch *batch, size_t face, const struct corner_data corners[3],
                    struct error *error);

void picture_free(struct picture *picture);

/* ---- Depth ---- */

/* In the parallel view depth is z, here -2..2: as (z + 2) / 4 it is 0..1. */
static inline double parallel_depth(double z) {
    return (z + 2) / 4;
}

/* In perspective depth is z/w with w = 1 - z/d, so it is a growing function of 1/w: near_w / w is
 * 0..1 and keeps a float's precision at all distances. Here near_w is where the course clips. */
#define NEAR_W (1.0 / 128)

/* The course's matrix with the row that OpenGL's depth needs. */
struct mat4 parallel_clip(struct mat4 to_clip);
struct mat4 perspective_clip(struct mat4 to_clip);

/* The parallel view of steps 4 to 7: x and y in -1..1 fill the viewport. */
struct batch parallel_batch(enum look look, struct rectangle viewport);

/* ---- Where a position of clip space lands, as the course computes it (perspective) ---- */

bool place_in_viewport(struct vec4 clip, const struct rectangle *viewport, struct placed *placed);

#endif
