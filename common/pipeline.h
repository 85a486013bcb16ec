/*
 * The drawing pipeline: given code from step 9 on, where the lesson explains it.
 *
 * A draw call turns a model into pixels in two passes.
 *
 *   1. Positions only. Every position is transformed once; every face is clipped, culled and, as
 * one or more `pieces`, tested against the depth buffer. Each covered pixel keeps the depth and the
 *      number of the piece that is nearest there.
 *   2. Shading. Each row is a sequence of runs of equal piece numbers. The attributes of a face
 * that is visible somewhere are fetched once, and each visible pixel is shaded exactly once.
 *
 * A hidden face never has an attribute fetched, and what lies behind something else costs one
 * comparison a pixel. (Burns and Hunt, "The Visibility Buffer", JCGT 2(2), 2013.) A shader that may
 * discard pixels cannot wait for pass 2: it is run within pass 1, as everything is with `skip` off.
 *
 * Guarantees: every pixel of a mesh is drawn once, also across clipped faces; the image does not
 * depend on the number of threads, on `skip`, or on which corner of a face comes first.
 */
#ifndef COMMON_PIPELINE_H
#define COMMON_PIPELINE_H

#include "geometry.h"
#include "model.h"
#include "raster.h"
#include "tgaimage.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { VARYING_LIMIT = 16 };

struct pipeline;
struct span_of_rows;

/* The work of a band of rows. */
struct pixel_work {
    uint64_t covered; /* depth tests */
    uint64_t shaded;  /* pixels */
};

typedef struct pixel_work shade_band(const struct pipeline *pipeline, const void *uniforms,
                                     struct image *image, struct span_of_rows rows);

/* What differs between one look and another, made by SHADER() below. `uniforms` points to what
 * is the same for all pixels: matrices, the light, the model and its textures. */
struct shader {
    size_t varying_count; /* numbers that a corner hands to the pixels, at most VARYING_LIMIT */
    /* Give the varyings of corner 0..2 of a face. */
    void (*vertex)(const void *uniforms, size_t face, size_t corner, double *varyings);
    /* Give the colour of a pixel from its interpolated varyings; false leaves the pixel undrawn,
     * which only a shader that `discards` may do. */
    bool (*fragment)(const void *uniforms, const double *varyings, struct color *color);
    bool discards;
    /* The loops over pixels, compiled for this shader alone, so that its functions are part of them
     * and no pixel costs a call. NULL: loops that call the functions. */
    shade_band *visible_band, *at_once_band;
};

/* Define a shader: `SHADER(toon, 1, gouraud_vertex, toon_fragment);` defines a constant `toon`
 * with one varying. One that discards pixels is defined by DISCARDING_SHADER(). */
#define SHADER(name, varying_count, vertex, fragment)                                              \
    DEFINE_SHADER(name, varying_count, vertex, fragment, false)
#define DISCARDING_SHADER(name, varying_count, vertex, fragment)                                   \
    DEFINE_SHADER(name, varying_count, vertex, fragment, true)

/* Front faces have their corners counterclockwise on the screen. */
enum cull { CULL_NONE, CULL_BACK, CULL_FRONT };

/* The part of the image that a draw call fills, in pixels; it must lie within the image. */
struct rectangle {
    int x, y, width, height;
};

/* Cell (column, row) of a grid over an image of that size, row 0 at the top. The cells share out
 * all of its pixels; an image with fewer pixels than cells gives some of them none. */
struct rectangle grid_cell(size_t width, size_t height, int columns, int rows, int column, int row);

struct draw_call {
    const struct model *model;
    struct mat4 to_clip;       /* from the model's own space to clip space */
    struct rectangle viewport; /* where NDC -1..1 goes; nothing is drawn outside */
    enum cull cull;
};

/* A camera at `eye` that looks at `center`, in perspective. `zoom` is the part of the viewport that
 * -1..1 fills at the center. Draws nothing where the viewport is empty. */
struct draw_call camera_call(const struct model *model, struct vec3 eye, struct vec3 center,
                             struct vec3 up, double zoom, struct rectangle viewport,
                             enum cull cull);

/* The mip level of a texture that is wrapped once around the model at which a texel is about as
 * large as a pixel: half of the texture's width is seen over `pixels` pixels. */
size_t wrapped_level(const struct texture *texture, double pixels);

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

/* A triangle on the screen: a face of the model, or a part that clipping left of one. */
struct piece {
    struct edges edges;
    double depth[3];   /* z/w at the corners, linear on the screen */
    double recip_w[3]; /* 1/w at the corners */
    uint32_t face;
    uint32_t first_corner; /* of the face: corner i of the piece is (first_corner + i) % 3 */
    uint32_t clipped;    /* which entry of `clipped_corners` it has; NOT_CLIPPED for a whole face */
    uint32_t attributes; /* which entry of `attributes` it has, once it is known to be visible */
    bool dropped;        /* covers pixels but must not be drawn (culled, with skip off) */
};

#define NOT_CLIPPED UINT32_MAX

/* Corners of a clipped piece as weights of its face's corners (counted from first_corner). */
struct clipped_corners {
    struct vec3 weight[3];
};

struct position; /* a transformed position; private to pipeline.c */

/* Buffers that are kept from frame to frame, so that drawing allocates nothing once they are large
 * enough. All zero is a valid, empty pipeline. */
struct pipeline {
    size_t width, height;
    bool skip;        /* false: do all the work, shade at once; the image is the same */
    double *depth;    /* width * height; minus infinity where nothing is drawn */
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
    uint64_t stats[PIPELINE_STATS];
};

/* Allocate the buffers for images of that size, 1..DRAW_LIMIT a side; skip is on. */
bool pipeline_create(struct pipeline *pipeline, size_t width, size_t height, struct error *error);
void pipeline_free(struct pipeline *pipeline);

/* Begin a frame: nothing is drawn yet, and all counts are zero. */
void pipeline_clear(struct pipeline *pipeline);

/* Draw a model into an image of the pipeline's size, format BGR or BGRA. False when memory runs
 * out; part of the model may then have been drawn. */
bool pipeline_draw(struct pipeline *pipeline, const struct draw_call *call,
                   const struct shader *shader, const void *uniforms, struct image *image,
                   struct error *error);

/* ---- From here on: how it works ---- */

/* Transform, clip and cull; fills `pieces`. */
bool pipeline_assemble(struct pipeline *pipeline, const struct draw_call *call,
                       struct error *error);

/* Pass 1: depth and piece number of every covered pixel. */
void pipeline_cover(struct pipeline *pipeline);

/* Between the passes: fetch the attributes of the pieces that are visible. */
bool pipeline_fetch_visible(struct pipeline *pipeline, const struct shader *shader,
                            const void *uniforms, struct error *error);

/* Rows are shared out among threads in bands of this many. */
enum { BAND_HEIGHT = 16 };

/* The kernels below call a shader that is a constant where they are used. Only when they are
 * inlined there can the compiler inline the shader into them in turn. */
#if defined(__GNUC__)
#define KERNEL static inline __attribute__((always_inline))
#else
#define KERNEL static inline
#endif

struct span_of_rows {
    int begin, end;
};

/* The rows of a band that a piece may cover. */
static inline struct span_of_rows rows_in_band(const struct piece *piece, int band_begin,
                                               int band_end) {
    const struct edges *e = &piece->edges;
    return (struct span_of_rows){e->y_begin > band_begin ? e->y_begin : band_begin,
                                 e->y_end < band_end ? e->y_end : band_end};
}

/* The covered pixels of a row that lie in the viewport. */
static inline struct span span_in_viewport(const struct pipeline *pipeline,
                                           const struct piece *piece, int y) {
    struct span span = edges_span(&piece->edges, y);
    int left = pipeline->viewport.x, right = left + pipeline->viewport.width;
    return (struct span){span.begin > left ? span.begin : left,
                         span.end < right ? span.end : right};
}

/* Depth along a row of a piece: begin + step * (x - the span's first pixel). */
struct depth_row {
    double begin, step;
};

static inline struct depth_row depth_along_row(const struct piece *piece, int x, int y) {
    const struct edge *e = piece->edges.edge;
    double scale = 1 / (double)piece->edges.area;
    struct vec3 weight = edges_weights(&piece->edges, x, y);
    struct vec3 step = {(double)e[0].dx * scale, (double)e[1].dx * scale, (double)e[2].dx * scale};
    const double *z = piece->depth;
    return (struct depth_row){interpolate(weight, z[0], z[1], z[2]),
                              interpolate(step, z[0], z[1], z[2])};
}

/* The varyings of the three corners of a piece, those of corner i at varyings[i * varying_count].
 */
KERNEL void fetch_attributes(const struct pipeline *pipeline, const struct piece *piece,
                             const struct shader *shader, const void *uniforms, double *varyings) {
    size_t n = shader->varying_count;
    for (size_t corner = 0; corner < 3; corner++) {
        size_t face_corner = (piece->first_corner + corner) % 3;
        shader->vertex(uniforms, piece->face, face_corner, varyings + corner * n);
    }
    if (piece->clipped == NOT_CLIPPED) {
        return;
    }
    const struct vec3 *weight = pipeline->clipped[piece->clipped].weight;
    for (size_t i = 0; i < n; i++) {
        double a = varyings[i], b = varyings[n + i], c = varyings[2 * n + i];
        for (size_t corner = 0; corner < 3; corner++) {
            varyings[corner * n + i] = interpolate(weight[corner], a, b, c);
        }
    }
}

/* Shade pixels x_begin..x_end - 1 of a row, all of one piece. With `depths` set, only those where
 * the piece is nearer than the depth there, which then becomes its own. Returns how many. */
KERNEL uint64_t shade_run(const struct piece *piece, const double *corners,
                          const struct shader *shader, const void *uniforms, struct image *image,
                          struct span run, int y, double *depths) {
    const struct edge *e = piece->edges.edge;
    size_t n = shader->varying_count;
    struct depth_row depth = depth_along_row(piece, run.begin, y);
    uint8_t *pixel = image->pixels + ((size_t)y * image->width + (size_t)run.begin) * image->format;
    uint64_t shaded = 0;
    for (int x = run.begin; x < run.end; x++, pixel += image->format) {
        double z = depth.begin + depth.step * (x - run.begin);
        if (depths != NULL && !(z > depths[x])) {
            continue;
        }
        /* Exact edge values, each weighted by 1/w; the division makes their sum 1. */
        double a = (double)(e[0].origin + e[0].dx * x + e[0].dy * y) * piece->recip_w[0];
        double b = (double)(e[1].origin + e[1].dx * x + e[1].dy * y) * piece->recip_w[1];
        double c = (double)(e[2].origin + e[2].dx * x + e[2].dy * y) * piece->recip_w[2];
        double scale = 1 / (a + b + c);
        struct vec3 weight = {a * scale, b * scale, c * scale};
        double varyings[VARYING_LIMIT];
        for (size_t i = 0; i < n; i++) {
            varyings[i] = interpolate(weight, corners[i], corners[n + i], corners[2 * n + i]);
        }
        struct color color;
        shaded++;
        if (!shader->fragment(uniforms, varyings, &color)) {
            continue;
        }
        if (depths != NULL) {
            depths[x] = z;
        }
        pixel[0] = color.b;
        pixel[1] = color.g;
        pixel[2] = color.r;
        if (image->format == IMAGE_BGRA) {
            pixel[3] = color.a;
        }
    }
    return shaded;
}

/* Pass 2 for a band of rows: find the runs of equal number and shade those of this draw call. */
KERNEL struct pixel_work shade_visible_band(const struct pipeline *pipeline,
                                            const struct shader *shader, const void *uniforms,
                                            struct image *image, struct span_of_rows rows) {
    int left = pipeline->viewport.x, right = left + pipeline->viewport.width;
    size_t stride = 3 * shader->varying_count;
    struct pixel_work work = {0, 0};
    for (int y = rows.begin; y < rows.end; y++) {
        const uint32_t *number = pipeline->number + (size_t)y * pipeline->width;
        for (struct span run = {left, left}; run.begin < right; run.begin = run.end) {
            while (run.end < right && number[run.end] == number[run.begin]) {
                run.end++;
            }
            if (number[run.begin] >= pipeline->first_number) {
                const struct piece *piece =
                    &pipeline->pieces[number[run.begin] - pipeline->first_number];
                const double *corners = pipeline->attributes + piece->attributes * stride;
                work.shaded += shade_run(piece, corners, shader, uniforms, image, run, y, NULL);
            }
        }
    }
    return work;
}

/* Both passes in one for a band of rows, for shaders that discard and with skip off: shade whatever
 * is nearest so far. */
KERNEL struct pixel_work shade_at_once_band(const struct pipeline *pipeline,
                                            const struct shader *shader, const void *uniforms,
                                            struct image *image, struct span_of_rows band) {
    struct pixel_work work = {0, 0};
    for (size_t i = 0; i < pipeline->piece_count; i++) {
        const struct piece *piece = &pipeline->pieces[i];
        struct span_of_rows rows = rows_in_band(piece, band.begin, band.end);
        if (rows.begin >= rows.end) {
            continue;
        }
        double corners[3 * VARYING_LIMIT];
        fetch_attributes(pipeline, piece, shader, uniforms, corners);
        for (int y = rows.begin; y < rows.end; y++) {
            struct span span = span_in_viewport(pipeline, piece, y);
            if (span.begin < span.end) {
                work.covered += (uint64_t)(span.end - span.begin);
                if (!piece->dropped) {
                    work.shaded += shade_run(piece, corners, shader, uniforms, image, span, y,
                                             pipeline->depth + (size_t)y * pipeline->width);
                }
            }
        }
    }
    return work;
}

/* The shader, and its two loops: each has the shader as a constant of its own. */
#define DEFINE_SHADER(name, varying_count, vertex, fragment, discards)                             \
    static struct pixel_work name##_visible_band(const struct pipeline *pipeline,                  \
                                                 const void *uniforms, struct image *image,        \
                                                 struct span_of_rows rows) {                       \
        const struct shader constant = {varying_count, vertex, fragment, discards, NULL, NULL};    \
        return shade_visible_band(pipeline, &constant, uniforms, image, rows);                     \
    }                                                                                              \
    static struct pixel_work name##_at_once_band(const struct pipeline *pipeline,                  \
                                                 const void *uniforms, struct image *image,        \
                                                 struct span_of_rows rows) {                       \
        const struct shader constant = {varying_count, vertex, fragment, discards, NULL, NULL};    \
        return shade_at_once_band(pipeline, &constant, uniforms, image, rows);                     \
    }                                                                                              \
    static const struct shader name = {                                                            \
        varying_count, vertex, fragment, discards, name##_visible_band, name##_at_once_band}

#endif
