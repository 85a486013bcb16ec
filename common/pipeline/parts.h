/*
 * Private to the pipeline: what pipeline.c and the files of this room know of each other.
 *
 * Each file calls only files below it, and includes only headers below it:
 *
 *     pipeline.c                records draw calls, draws the frame
 *     order.c                   which draw calls need not be drawn, and the order of the others
 *     assemble.c, batch.c       from models to pieces; what becomes of a face
 *     bins.c                    pieces sorted into bands of rows
 *     bands.c                   covers and shades pixels
 *     parts.h                   what these files share
 *     pipeline.h                with its second half, the loops over pixels: kernels.h, planes.h
 *     texture_lanes.h
 *     vectors.h
 *     lanes.h
 */
#ifndef COMMON_PIPELINE_PARTS_H
#define COMMON_PIPELINE_PARTS_H

#include "base/array.h"
#include "pipeline.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

/* ---- What the parts share ---- */

/* Elements of an array: begin inclusive, end exclusive. */
struct range {
    size_t begin, end;
};

/* The bands that a piece reaches, inclusive. They lie apart from the pieces, which need not be read
 * to be sorted into bands: of fine models these are most of what a frame reads. */
struct band_span {
    uint16_t first, last;
};

/* The faces that one thread assembles, and the pieces that they became. */
struct block {
    size_t first_piece, piece_count;
    size_t first_clipped, clipped_count;
    struct span columns, rows; /* that the pieces may cover */
    uint64_t stats[PIPELINE_STATS];
};

/* Room for that many elements. False, with the buffer as it was, when memory runs out. */
static inline bool buffer_reserve(struct buffer *buffer, size_t count, size_t element_size,
                                  struct error *error) {
    void *data = array_reserve(buffer->data, &buffer->capacity, count, element_size);
    buffer->data = data != NULL ? data : buffer->data;
    return data != NULL || error_out_of_memory(error);
}

/* Start the threads, unless that was done before. */
static inline void pipeline_start_workers(struct pipeline *p) {
    if (p->workers == NULL && !p->alone) {
        p->workers = workers_create(p->thread_count);
        p->alone = p->workers == NULL;
    }
}

/* Share out a loop among the threads, which are started when there is more than one part for the
 * first time. */
static inline void pipeline_run(struct pipeline *p, size_t count, worker_function *work,
                                void *context) {
    if (count > 1) {
        pipeline_start_workers(p);
    }
    workers_run(p->workers, count, work, context);
}

/* ---- Positions ---- */

/* Nearer than this part of the camera's distance nothing is drawn: 1/w would grow without bound. */
static const double near_w = 1.0 / 128;

/* Sides of the view that a position is beyond. */
enum {
    BEYOND_LEFT = 1,
    BEYOND_RIGHT = 2,
    BEYOND_BOTTOM = 4,
    BEYOND_TOP = 8,
    BEYOND_NEAR = 16,
    BEYOND_ONE_SIDE = 31, /* any of these */
    BEYOND_GUARD_BAND = 32,
    BEYOND_ALL = 63
};

/* TOGETHER positions in clip space. */
struct clip_positions {
    doubles x, y, z, w;
};

/* One position, several times. */
LANES_INLINE struct clip_positions clip_positions_all(struct vec4 p) {
    return (struct clip_positions){doubles_all(p.x), doubles_all(p.y), doubles_all(p.z),
                                   doubles_all(p.w)};
}

/* The sides that each is beyond, of BEYOND_ONE_SIDE. Written so that what is not a number is beyond
 * everything. */
LANES_INLINE longs find_beyond_sides(const struct clip_positions *p) {
    return (~(p->x >= -p->w) & BEYOND_LEFT) | (~(p->x <= p->w) & BEYOND_RIGHT) |
           (~(p->y >= -p->w) & BEYOND_BOTTOM) | (~(p->y <= p->w) & BEYOND_TOP) |
           (~(p->w >= near_w) & BEYOND_NEAR);
}

/* ---- Triangles: batch.c ---- */

/* What becomes of a face, or of a part of a clipped one. */
enum triangle_kind {
    TRIANGLE_OUTSIDE,       /* beyond one side of the view */
    TRIANGLE_TURNED_AWAY,   /* culled */
    TRIANGLE_WITHOUT_PIXEL, /* it covers no pixel centre */
    TRIANGLE_CLIPPED,       /* must be cut before it can be drawn */
    TRIANGLE_WHOLE          /* to be drawn */
};

/* Triangles that are classified together. */
enum { BATCH_SIZE = 64 };

struct batch {
    size_t count; /* behind them may be anything that fits the screen */
    /* Their corners on the screen, in 1/256 pixel (anything, where a corner has no place there),
     * and the sides that all of the corners, and any of them, are beyond. */
    int32_t x[3][BATCH_SIZE], y[3][BATCH_SIZE];
    int32_t beyond_all[BATCH_SIZE], beyond_any[BATCH_SIZE];
    /* Found by batch_classify(); all but the first only of what is whole: */
    int32_t kind[BATCH_SIZE]; /* of enum triangle_kind */
    int32_t culled[BATCH_SIZE];
    /* The lowest corner, of those the leftmost; and the next, counterclockwise. */
    int32_t first[BATCH_SIZE], second[BATCH_SIZE];
    /* The pixel centres of its box in the viewport, inclusive. */
    int32_t left[BATCH_SIZE], right[BATCH_SIZE], bottom[BATCH_SIZE], top[BATCH_SIZE];
};

/* Classify the triangles. With `skip` off none is turned away, and those that miss the centres in
 * their box are not looked for. */
void batch_classify(struct batch *batch, const struct draw_call *call, bool skip);

/* ---- Draw calls and batches as a whole: order.c ---- */

/* Boxes in a model's own space, as many as are looked at together: their two sides across each
 * axis, least and greatest. */
struct boxes {
    double side[2][3][TOGETHER];
};

/* Where all that is in the boxes may be on the screen: nowhere if it is outside the view. */
void pipeline_place(const struct draw_call *call, const struct boxes *boxes,
                    struct screen_place place[TOGETHER]);

static inline bool place_is_empty(const struct screen_place *place) {
    return place->columns.begin >= place->columns.end || place->rows.begin >= place->rows.end;
}

/* The faces of one batch of a block. */
static inline struct range batch_range(struct range faces, size_t batch) {
    size_t begin = faces.begin + batch * BATCH_SIZE;
    return (struct range){begin, faces.end - begin < BATCH_SIZE ? faces.end : begin + BATCH_SIZE};
}

/* ---- A frame and its rounds: order.c, bins.c ---- */

/* What the threads that draw a frame share. */
struct frame {
    struct pipeline *pipeline;
    struct image *image;
    size_t round;       /* this one */
    struct range draws; /* that come in it, of the pipeline's `order` */
    bool kept;          /* what is visible is kept from round to round, for each band */
    bool knows_last;    /* the image is that of the last frame, of which is known what it touched */
};

/* A draw call's place in the order of covering. */
struct draw_order {
    double nearest;
    size_t draw;
};

/* Find the draw calls that may cover pixels, and the order in which they are covered: that of
 * drawing or, where there are many and they overlap, the nearest first. */
bool pipeline_order(struct pipeline *pipeline, struct error *error);

/* The nearest first, where draw calls overlap: of many decided by their boxes; of few once they are
 * assembled, since what they cover is less. */
void pipeline_reorder(struct pipeline *pipeline);

/* Go on to the next round; from all zero, to the first. */
void pipeline_next_round(struct frame *frame);

/* Sort the round's pieces, in the blocks from `first_block` on, into bands. */
bool pipeline_sort_round(const struct frame *frame, size_t first_block, struct error *error);

/* ---- Faces: assemble.c; pixels: bands.c ---- */

/* Transform, clip and cull the models of the round's draw calls, except of those that are hidden as
 * a whole: fills their blocks, which begin where the last ones ended. */
bool pipeline_assemble_round(const struct frame *frame, struct error *error);

/* Is all that is in a place behind what the rounds before this one have covered? Only where that is
 * kept. */
bool pipeline_is_hidden(const struct pipeline *pipeline, const struct screen_place *place);

/* Cover the round's pieces in band `index` of a frame (context: struct frame, which is kept): see
 * worker_function. */
void pipeline_cover_band(void *context, size_t index, size_t worker);

/* Draw band `index` of a frame: shade what is visible, and cover first, if it was not kept. */
void pipeline_draw_band(void *context, size_t index, size_t worker);

static inline struct span span_around(struct span a, struct span b) {
    return (struct span){a.begin < b.begin ? a.begin : b.begin, a.end > b.end ? a.end : b.end};
}

static inline size_t band_count(const struct pipeline *pipeline) {
    return (pipeline->height + BAND_HEIGHT - 1) / BAND_HEIGHT;
}

/* At least the depth at every pixel of a piece with those depths at its corners, whatever
 * roundings: these amount to a few ulp of them. */
static inline double nearest_of_depths(const double z[3]) {
    double most = z[0] > z[1] ? z[0] : z[1];
    return (most > z[2] ? most : z[2]) + 1e-14 * (fabs(z[0]) + fabs(z[1]) + fabs(z[2]));
}

/* The columns whose pixel centres the box of a triangle reaches, in an image without end; and the
 * rows. centers_between() of raster.h, with shifts, and not cut. */
static inline struct span columns_of(const struct fixed2 *c) {
    return (struct span){(least_of(c[0].x, c[1].x, c[2].x) + SUBPIXELS / 2 - 1) >> 8,
                         ((most_of(c[0].x, c[1].x, c[2].x) - SUBPIXELS / 2) >> 8) + 1};
}

static inline struct span rows_of(const struct fixed2 *c) {
    return (struct span){(least_of(c[0].y, c[1].y, c[2].y) + SUBPIXELS / 2 - 1) >> 8,
                         ((most_of(c[0].y, c[1].y, c[2].y) - SUBPIXELS / 2) >> 8) + 1};
}

static inline struct span columns_in(struct span columns, const struct rectangle *viewport) {
    return span_overlap(columns, (struct span){viewport->x, viewport->x + viewport->width});
}

static inline struct span rows_in(struct span rows, const struct rectangle *viewport) {
    return span_overlap(rows, (struct span){viewport->y, viewport->y + viewport->height});
}

#endif
