/*
 * The drawing pipeline: given code from lesson 9 on, where the lesson explains it.
 *
 *     SHADER(toon, .varying_count = 1, .vertex = gouraud_vertex, .fragment = toon_fragment);
 *
 *     pipeline_create(&pipeline, image.width, image.height, &error);
 *     pipeline_draw(&pipeline, &call, &toon, &uniforms, sizeof uniforms, &error);
 *     pipeline_finish(&pipeline, &image, &error);
 *
 * Draw calls are recorded, and the frame is drawn when it is finished. Its stages, and where they
 * are:
 *
 *     record     keep the draw call                               pipeline_draw() in pipeline.c
 *     order      drop calls off screen; nearest first             pipeline/order.c
 *     transform  each position once, to the screen                pipeline/assemble.c
 *     classify   which faces are off screen, turned away, tiny    pipeline/classify.c
 *     clip       cut what leaves the view                         pipeline/clip.c
 *     assemble   faces become pieces, sorted into bands of rows   pipeline/assemble.c
 *     cover      band by band: which piece is nearest?            pipeline/cover.c
 *     fetch      ask the corners of visible pieces, once          pipeline/shade.h
 *     shade      colour each visible pixel, once                  pipeline/shade.h
 *
 * A band's depths and piece numbers stay in the processor's cache from cover to shade. Several
 * neighbours are shaded at once: see lanes.h. (Burns and Hunt, "The Visibility Buffer", JCGT 2(2),
 * 2013.)
 *
 * Where many draw calls overlap, the stages from transform to cover are done in rounds: first the
 * nearest few calls, then in each round as many as in all before. A call whose box is behind what
 * is covered already, in every tile of 16x8 pixels, is skipped as a whole, and so is a piece.
 * (Greene, Kass and Miller, "Hierarchical Z-Buffer Visibility", SIGGRAPH 1993.)
 *
 * The pixels of a shader that may discard are shaded while they are covered, in the order of
 * drawing; with `skip` off all are.
 *
 * Guarantees: every pixel of a mesh is drawn once, also across clipped faces; the image does not
 * depend on the number of threads, on `skip`, or on which corner of a face comes first. Of two
 * equal depths the first one drawn stays; a face with one depth at all corners, not clipped, has
 * just this depth at every pixel (on other planes the last bits depend on the face's corners).
 */
#ifndef COMMON_PIPELINE_H
#define COMMON_PIPELINE_H

#include "geometry.h"
#include "lanes.h"
#include "model.h"
#include "pipeline/texture_lanes.h"
#include "raster.h"
#include "tgaimage.h"

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

/* ---- Shaders: what differs between one look and another ---- */

enum { VARYING_LIMIT = 16 };

struct call_band;

/* The loops over the pixels of a band for one shader: see pipeline/shade.h. */
typedef void shade_function(const struct call_band *band);

/* `uniforms` points to what is the same for all pixels: matrices, the light, the model and its
 * textures. */
struct shader {
    size_t varying_count; /* numbers that a corner hands to the pixels, at most VARYING_LIMIT */
    /* Give the varyings of corner 0..2 of a face. Beyond about 1e10 they may reach a pixel
     * as infinite, or as no number, since `real` is a float. */
    void (*vertex)(const void *uniforms, size_t face, size_t corner, double *varyings);
    /* Give the colour of a pixel from its interpolated varyings (several pixels at once: lanes.h).
     * No lane of the mask that it returns is drawn where it is unset, which only a shader that
     * `discards` may do; others return lanes_all_set(). */
    lanes_mask (*fragment)(const void *uniforms, const lanes *varyings, lanes_texel *color);
    /* Or NULL: change the varyings before the fragment's turn, and add some behind the last one, up
     * to VARYING_LIMIT. It is called for many pixels before the first of them gets its colour. So a
     * processor can look ahead of what takes long, as it is to know where texels are: see
     * texture_locate(). */
    void (*prepare)(const void *uniforms, lanes *varyings);
    bool flat; /* the varyings of corner 0 for the whole face: nothing is interpolated */
    bool discards;
    /* Loops over pixels that SHADER() compiles for this shader alone. NULL: all loops call the
     * functions. */
    shade_function *shade;
};

/* All calls of a function become part of it. */
#define FLATTEN __attribute__((flatten))

/* Define a constant `struct shader name` with the fields that follow the name. Its loops over
 * pixels have them as constants: the functions become part of the loop, and no pixel costs a
 * call. */
#define SHADER(name, ...)                                                                          \
    static FLATTEN void name##_shade(const struct call_band *band) {                               \
        const struct shader constant = {__VA_ARGS__};                                              \
        shade_visible(band, &constant);                                                            \
    }                                                                                              \
    static const struct shader name = {__VA_ARGS__, .shade = name##_shade}

/* ---- The pipeline ---- */

/* What was done and what was skipped since pipeline_clear(), once the frame is finished. What is
 * skipped with its draw call is counted like what is skipped alone: FACES_OUTSIDE, FACES_HIDDEN (of
 * a hidden call all faces, also what is outside or turned away). */
enum pipeline_stat {
    STAT_CALLS,                /* draw calls */
    STAT_CALLS_OUTSIDE,        /* skipped: all of the model is beyond one side of the view */
    STAT_CALLS_HIDDEN,         /* skipped: all of the model is behind nearer ones */
    STAT_VERTICES_TRANSFORMED, /* positions; none of skipped calls */
    STAT_FACES,                /* asked for */
    STAT_FACES_OUTSIDE,        /* skipped: beyond one side of the viewport, or behind the eye */
    STAT_FACES_TURNED_AWAY,    /* skipped: culled */
    STAT_FACES_WITHOUT_PIXEL,  /* skipped: too small, between pixel centres */
    STAT_FACES_CLIPPED,        /* cut at the near plane or the guard band */
    STAT_FACES_HIDDEN,         /* drawn, but behind others: no attribute fetched */
    STAT_FACES_BEHIND, /* of these, so far behind that no pixel was tested: once, or in each band */
    STAT_ATTRIBUTE_SETS, /* fetched: once for each visible face in each band of rows */
    STAT_PIXELS_COVERED, /* depth tests; counted only with `counts_tests` */
    STAT_PIXELS_PASSED,  /* of these, nearer than what was there; likewise */
    STAT_PIXELS_SHADED,
    PIPELINE_STATS
};

/* Their names, as --stats prints them. */
extern const char *const pipeline_stat_name[PIPELINE_STATS];

/* Its memory is kept from frame to frame, so that drawing allocates nothing once there is enough.
 * All zero is a valid, empty pipeline. */
struct pipeline {
    size_t width, height;
    bool skip;         /* false: do all the work, shade at once; the image is the same */
    bool counts_tests; /* count depth tests, in up to 1.4 times the time */
    bool clears_image; /* pixels that nothing covers become 0; false, at first: they stay */
    bool keep_depth;   /* keep what pipeline_finish() found in `depth` */
    double *depth;     /* width * height; minus infinity where nothing is drawn; NULL if not kept */
    uint64_t stats[PIPELINE_STATS];

    struct frame *frame; /* private: pipeline/frame.h */
};

/* Allocate for images of that size, 1..DRAW_LIMIT a side; skip is on, depth is not kept. */
bool pipeline_create(struct pipeline *pipeline, size_t width, size_t height, struct error *error);
void pipeline_free(struct pipeline *pipeline);

/* Draw with that many threads from now on; 0, at first: one for each processor, or as many as the
 * environment variable THREADS says. */
void pipeline_use_threads(struct pipeline *pipeline, size_t thread_count);

/* Begin a frame: nothing is drawn yet, and all counts are zero. */
void pipeline_clear(struct pipeline *pipeline);

/* Record that a model is to be drawn. `uniforms` are copied (`size` bytes); what they point to, and
 * the model, must stay as they are until the frame is finished. False when memory runs out: the
 * frame is then without this model. */
bool pipeline_draw(struct pipeline *pipeline, const struct draw_call *call,
                   const struct shader *shader, const void *uniforms, size_t size,
                   struct error *error);

/* Draw everything recorded into an image of the pipeline's size, format BGR or BGRA. False when
 * memory runs out, with the image as it was. */
bool pipeline_finish(struct pipeline *pipeline, struct image *image, struct error *error);

#include "pipeline/shade.h" /* private: what SHADER() compiles into its loop */

#endif
