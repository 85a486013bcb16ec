/*
 * The drawing pipeline: given code from lesson 9 on, where the lesson explains it.
 *
 *     SHADER(toon, .varying_count = 1, .vertex = gouraud_vertex, .fragment = toon_fragment);
 *
 *     pipeline_create(&pipeline, image.width, image.height, &error);
 *     pipeline_draw(&pipeline, &call, &toon, &uniforms, sizeof uniforms, &error);
 *     pipeline_finish(&pipeline, &image, &error);
 *
 * pipeline_draw() only records a draw call; pipeline_finish() draws the frame. First it finds which
 * triangle is nearest at each pixel and writes its number there: a visibility buffer. Then it
 * shades each visible pixel once. So a hidden triangle never has an attribute fetched, and a pixel
 * that several triangles cover costs one shading. (Burns and Hunt, "The Visibility Buffer", JCGT
 * 2(2), 2013.) The stages, and where they are:
 *
 *     record     keep the draw call                               pipeline_draw() in pipeline.c
 *     order      drop calls off screen; nearest first             pipeline/order.c
 *     transform  each position once, to the screen                pipeline/assemble.c
 *     classify   which faces are off screen, culled, tiny         pipeline/classify.c
 *     clip       cut faces that leave the view                    pipeline/clip.c
 *     assemble   faces become pieces, sorted into bands of rows   pipeline/assemble.c
 *     cover      band by band: which piece is nearest?            pipeline/cover.c
 *     fetch      ask for the varyings of each visible piece       pipeline/shade.h
 *     shade      colour each visible pixel, once                  pipeline/shade.h
 *
 * Threads draw bands of rows. A band's depths and piece numbers stay in the processor's cache from
 * cover to shade. Several neighbours are shaded at once: see lanes.h.
 *
 * Where many draw calls overlap, they are covered in rounds, the nearest first, and each round has
 * as many calls as all before it. Every tile of 16x8 pixels knows its farthest depth. A call, or a
 * piece, that is behind this depth in all tiles of its bounding box is skipped as a whole. (Greene,
 * Kass and Miller, "Hierarchical Z-Buffer Visibility", SIGGRAPH 1993.)
 *
 * A shader that may discard pixels has a say in what is visible, so its pixels are shaded as soon
 * as they are covered, in the order of drawing. With `skip` off, those of all shaders are.
 *
 * Guarantees: every pixel of a mesh is drawn once, also across clipped faces; the image does not
 * depend on the number of threads, on `skip`, or on which corner of a face comes first. Of two
 * equal depths the first one drawn stays. A face that is not clipped and has the same depth at all
 * corners has exactly this depth at every pixel (in others the last bits depend on the corners).
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

/* A camera at `eye` that looks at `center`, in perspective. At the distance of `center`, -1..1
 * fills the share `zoom` of the viewport. An empty viewport draws nothing. */
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
    /* Give the varyings of corner 0..2 of a face. One beyond about 1e10 may reach a pixel as
     * infinity or NaN, since `real` is a float. */
    void (*vertex)(const void *uniforms, size_t face, size_t corner, double *varyings);
    /* Give the colour of a pixel from its interpolated varyings (several pixels at once: lanes.h).
     * Lanes that are unset in the returned mask are discarded: only a shader that `discards` may do
     * that, others return lanes_all_set(). */
    lanes_mask (*fragment)(const void *uniforms, const lanes *varyings, lanes_texel *color);
    bool flat; /* the whole face has the varyings of corner 0: nothing is interpolated */
    bool discards;
    /* The loops over pixels that SHADER() compiles for this shader alone. NULL: loops that call the
     * functions above. */
    shade_function *shade;
};

/* Inline every call in the function. */
#define FLATTEN __attribute__((flatten))

/* Define a constant `struct shader name` with the fields that follow the name. Its loops over
 * pixels are compiled with these constants: the functions become part of the loop, and no pixel
 * costs a call. */
#define SHADER(name, ...)                                                                          \
    static FLATTEN void name##_shade(const struct call_band *band) {                               \
        const struct shader constant = {__VA_ARGS__};                                              \
        shade_visible(band, &constant);                                                            \
    }                                                                                              \
    static const struct shader name = {__VA_ARGS__, .shade = name##_shade}

/* ---- The pipeline ---- */

/* What was done and what was skipped since pipeline_clear(), once the frame is finished. The faces
 * of a skipped draw call count as FACES_OUTSIDE or FACES_HIDDEN, too (all faces of a hidden call,
 * also those that are outside or turned away). */
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
    STAT_PIXELS_PASSED,  /* those that the new piece won; counted only with `counts_tests` */
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
    bool keep_depth;   /* pipeline_finish() fills `depth` */
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
