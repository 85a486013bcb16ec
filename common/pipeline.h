/*
 * The drawing pipeline: given code from step 9 on, where the lesson explains it.
 *
 *     SHADER(toon, .varying_count = 1, .vertex = gouraud_vertex, .fragment = toon_fragment);
 *
 *     pipeline_create(&pipeline, image.width, image.height, &error);
 *     pipeline_draw(&pipeline, &call, &toon, &uniforms, &image, &error);
 *
 * A draw call turns a model into pixels in two passes.
 *
 *   1. Positions only. Every position is transformed once; every face is clipped, culled and, as
 *      one or more `pieces`, tested against the depth buffer. Each covered pixel keeps the depth
 *      and the number of the piece that is nearest there.
 *   2. Shading. Each row is a sequence of runs of equal piece numbers. The attributes of a face
 *      that is visible somewhere are fetched once, and each visible pixel is shaded exactly once.
 *
 * A hidden face never has an attribute fetched, and what lies behind something else costs one
 * comparison a pixel. (Burns and Hunt, "The Visibility Buffer", JCGT 2(2), 2013.) A shader that may
 * discard pixels cannot wait for pass 2: it is run within pass 1, as everything is with `skip` off.
 *
 * Guarantees: every pixel of a mesh is drawn once, also across clipped faces; the image does not
 * depend on the number of threads, on `skip`, or on which corner of a face comes first. Of two
 * equal depths the first one drawn stays; a face with one depth at all corners, not clipped, has
 * just this depth at every pixel (on other planes the last bits depend on the face's corners).
 */
#ifndef COMMON_PIPELINE_H
#define COMMON_PIPELINE_H

#include "geometry.h"
#include "model.h"
#include "raster.h"
#include "tgaimage.h"
#include "workers.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* ---- What is drawn ---- */

/* Which faces are left out. Front faces have their corners counterclockwise on the screen. */
enum cull { CULL_NONE, CULL_BACK, CULL_FRONT };

struct draw_call {
    const struct model *model;
    struct mat4 to_clip;       /* from the model's own space to clip space */
    struct rectangle viewport; /* where NDC -1..1 goes; in the image; nothing is drawn outside */
    enum cull cull;
};

/* A camera at `eye` that looks at `center`, in perspective. `zoom` is the part of the viewport that
 * -1..1 fills at the center. Draws nothing where the viewport is empty. */
struct draw_call camera_call(const struct model *model, struct vec3 eye, struct vec3 center,
                             struct vec3 up, double zoom, struct rectangle viewport,
                             enum cull cull);

/* The mip level of a texture that is wrapped once around the model at which a texel is about as
 * large as a pixel: half of the texture's width is seen over `pixels` pixels. NULL has level 0. */
size_t wrapped_level(const struct texture *texture, double pixels);

/* ---- Shaders: what differs between one look and another ---- */

enum { VARYING_LIMIT = 16 };

struct pipeline;

/* The work of a band of rows. */
struct pixel_work {
    uint64_t covered; /* depth tests */
    uint64_t shaded;  /* pixels */
};

/* Shade some rows: each visible pixel once or, at once with the depth test, all that is nearest so
 * far. */
typedef struct pixel_work shade_band(const struct pipeline *pipeline, const void *uniforms,
                                     struct image *image, struct span rows, bool at_once);

/* `uniforms` points to what is the same for all pixels: matrices, the light, the model and its
 * textures. */
struct shader {
    size_t varying_count; /* numbers that a corner hands to the pixels, at most VARYING_LIMIT */
    /* Give the varyings of corner 0..2 of a face. */
    void (*vertex)(const void *uniforms, size_t face, size_t corner, double *varyings);
    /* Give the colour of a pixel from its interpolated varyings; false leaves the pixel undrawn,
     * which only a shader that `discards` may do. */
    bool (*fragment)(const void *uniforms, const double *varyings, struct color *color);
    bool discards;
    /* The loop over pixels, compiled by SHADER() for this shader alone. NULL: a loop that calls
     * the functions. */
    shade_band *band;
};

/* Define a constant `struct shader name` with the fields that follow the name. Its loop over pixels
 * has them as constants: the functions become part of the loop, and no pixel costs a call. */
#define SHADER(name, ...)                                                                          \
    static struct pixel_work name##_band(const struct pipeline *pipeline, const void *uniforms,    \
                                         struct image *image, struct span rows, bool at_once) {    \
        const struct shader constant = {__VA_ARGS__};                                              \
        return shade_rows(pipeline, &constant, uniforms, image, rows, at_once);                    \
    }                                                                                              \
    static const struct shader name = {__VA_ARGS__, .band = name##_band}

/* ---- The pipeline ---- */

/* What was done and what was skipped since pipeline_clear(). */
enum pipeline_stat {
    STAT_FACES,               /* asked for */
    STAT_FACES_OUTSIDE,       /* skipped: beyond one side of the viewport, or behind the eye */
    STAT_FACES_TURNED_AWAY,   /* skipped: culled */
    STAT_FACES_WITHOUT_PIXEL, /* skipped: too small, between pixel centres */
    STAT_FACES_CLIPPED,       /* cut at the near plane or the guard band */
    STAT_FACES_HIDDEN,        /* drawn, but behind others: no attribute fetched */
    STAT_PIXELS_COVERED,      /* depth tests */
    STAT_PIXELS_SHADED,
    PIPELINE_STATS
};

/* Their names, as --stats prints them. */
extern const char *const pipeline_stat_name[PIPELINE_STATS];

/* Buffers that are kept from frame to frame, so that drawing allocates nothing once they are large
 * enough. All zero is a valid, empty pipeline. */
struct pipeline {
    size_t width, height;
    bool skip;     /* false: do all the work, shade at once; the image is the same */
    double *depth; /* width * height; minus infinity where nothing is drawn */
    uint64_t stats[PIPELINE_STATS];

    /* From here on private: see pipeline_kernels.h and pipeline.c. */
    size_t thread_count;          /* for workers_create() */
    struct workers *workers;      /* NULL until they are needed, and where there are none */
    bool alone;                   /* there are none */
    struct pixel_work *band_work; /* of the bands of the last loop */
    uint32_t *number; /* width * height; first_number + index of the piece that is nearest */
    struct position *positions;
    size_t position_capacity;
    struct piece *pieces;
    size_t piece_count, piece_capacity;
    struct clipped_corners *clipped;
    size_t clipped_count, clipped_capacity;
    double *attributes; /* varyings of the three corners of each visible piece */
    size_t attribute_capacity;
    uint32_t first_number; /* of the current draw call; numbers of earlier ones are smaller */
    uint32_t next_number;
    struct rectangle viewport;
};

/* Allocate the buffers for images of that size, 1..DRAW_LIMIT a side; skip is on. */
bool pipeline_create(struct pipeline *pipeline, size_t width, size_t height, struct error *error);
void pipeline_free(struct pipeline *pipeline);

/* Draw with that many threads from now on; 0, at first: one for each processor, or as many as the
 * environment variable THREADS says. */
void pipeline_use_threads(struct pipeline *pipeline, size_t thread_count);

/* Begin a frame: nothing is drawn yet, and all counts are zero. */
void pipeline_clear(struct pipeline *pipeline);

/* Draw a model into an image of the pipeline's size, format BGR or BGRA. False when memory runs
 * out; part of the model may then have been drawn. */
bool pipeline_draw(struct pipeline *pipeline, const struct draw_call *call,
                   const struct shader *shader, const void *uniforms, struct image *image,
                   struct error *error);

/* ---- The passes of pipeline_draw(), one by one ---- */

/* Transform, clip and cull; fills `pieces`. */
bool pipeline_assemble(struct pipeline *pipeline, const struct draw_call *call,
                       struct error *error);

/* Pass 1: depth and piece number of every covered pixel. */
void pipeline_cover(struct pipeline *pipeline);

/* Between the passes: fetch the attributes of the pieces that are visible. */
bool pipeline_fetch_visible(struct pipeline *pipeline, const struct shader *shader,
                            const void *uniforms, struct error *error);

#include "pipeline_kernels.h" /* private: what SHADER() compiles into its loop */

#endif
