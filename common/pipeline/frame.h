/*
 * Private to the pipeline: a frame, and everything else that its stages know of each other. The
 * table in pipeline.h lists the stages in their order, and their files.
 *
 * A draw call is cut into blocks of positions and faces, which threads turn into pieces, triangles
 * on the screen. The image is cut into bands of 32 rows, which threads draw one by one. A band is a
 * row of chunks 16 columns wide; a chunk has a depth and a piece's number for each pixel, and four
 * tiles, each with the farthest depth in it:
 *
 *     row 31  +----------------+----------------+----------------+---
 *             | tile 3         |                |                |
 *         24  |- - - - - - - - |- - - - - - - - |- - - - - - - - |
 *             | tile 2         |                |                |
 *         16  |- - - - - - - - |- - - - - - - - |- - - - - - - - |
 *             | tile 1         |                |                |
 *          8  |- - - - - - - - |- - - - - - - - |- - - - - - - - |
 *             | tile 0         |                |                |
 *      row 0  +----------------+----------------+----------------+---
 *         x = 0     chunk 0    16     chunk 1   32     chunk 2   48
 *
 * The numbers belong to one band: pieces[number - 1] is the piece, and 0 means that nothing is
 * drawn.
 */
#ifndef COMMON_PIPELINE_FRAME_H
#define COMMON_PIPELINE_FRAME_H

#ifndef COMMON_PIPELINE_H
#error "include pipeline.h instead"
#endif

#include "base/array.h"
#include "base/workers.h"
#include "pipeline/vectors.h"

#include <limits.h>
#include <stdatomic.h>
#include <stdlib.h>

/* Rows of a band: so many that its depths stay in the cache. */
enum { BAND_HEIGHT = 32 };
_Static_assert(BAND_HEIGHT <= 32, "`touched` has a bit for each row");
static const uint32_t ALL_ROWS = UINT32_MAX >> (32 - BAND_HEIGHT);

/* Columns of a chunk and rows of a tile. They do not depend on LANES. */
enum { CHUNK_WIDTH = 16, TILE_HEIGHT = 8, BAND_TILES = BAND_HEIGHT / TILE_HEIGHT };
_Static_assert(BAND_HEIGHT % TILE_HEIGHT == 0, "no tile lies in two bands");

/* ---- Draw calls and pieces ---- */

/* Elements of an array: begin inclusive, end exclusive. */
struct index_range {
    size_t begin, end;
};

/* The columns and rows that a call or a piece may cover, and an upper bound on its depth, which is
 * infinite where it may reach the near plane. */
struct screen_place {
    struct span columns, rows;
    double nearest;
};

struct recorded_call {
    struct draw_call call;
    const struct shader *shader;
    size_t uniforms;                 /* their offset in the frame's `uniforms` */
    struct screen_place place;       /* at first of the model's box, later of its pieces */
    size_t first_block, block_count; /* none before assembling, or where the call is hidden */
    size_t first_position;           /* in the frame's `positions` */
    double guard_band;               /* its faces are clipped there: see guard_band_of() */
    atomic_uint beyond;              /* the sides that any of its positions is beyond */
};

/* A position on the screen. */
struct screen_position {
    struct fixed2 at;
    double depth; /* z/w, linear on the screen */
};

/* A triangle on the screen: a whole face, or a triangle of the fan that is left of a clipped one.
 * It fills one cache line. */
struct piece {
    struct fixed2 corner[3]; /* counterclockwise from the lowest, of several the leftmost */
    double depth[3];
    uint32_t face, call;
    uint8_t face_corner[3]; /* which corner of the face, or of the fan's triangle, each is */
    uint8_t fan_triangle;   /* 0: a whole face; n: triangle n of a clipped face's fan */
    bool in_several_bands;
    atomic_bool shown; /* one of these bands shows a pixel of it */
};

/* Threads share out the positions and the faces of a call in blocks of this many. */
enum { BLOCK_SIZE = 1024 };

/* A block, and the pieces that its faces became. */
struct block {
    struct recorded_call *call;
    size_t begin; /* its first position, and its first face */
    struct piece *pieces;
    struct band_span {
        uint16_t first, last;
    } * bands;        /* the bands that each piece reaches */
    uint32_t *sorted; /* indices of pieces, band after band: see `band_starts` of the frame */
    size_t piece_count, piece_capacity, band_capacity, sorted_capacity;
    struct span columns, rows; /* the pixels that the pieces may cover */
    uint64_t *stats;           /* of the thread that assembles the block */
};

/* ---- Bands ---- */

/* What is visible so far in one chunk of a band. (find_runs() reads one number behind the last.) */
struct chunk {
    double depth[BAND_HEIGHT][CHUNK_WIDTH];    /* minus infinity: nothing is drawn */
    uint32_t number[BAND_HEIGHT][CHUNK_WIDTH]; /* of the piece; 0: nothing is drawn */
    double farthest[BAND_TILES];               /* of each tile: no pixel's depth is less */
    uint32_t touched;                          /* bit i: something may be drawn in row i */
    /* The next chunk begins in a cache line of its own. */
    char apart[CACHE_LINE - (BAND_TILES * sizeof(double) + sizeof(uint32_t)) % CACHE_LINE];
};

/* Empty a chunk: nothing is drawn. Only rows that were touched need it. */
static inline void chunk_clear(struct chunk *chunk) {
    for (int row = 0; chunk->touched != 0; row++, chunk->touched >>= 1) {
        if ((chunk->touched & 1) != 0) {
            for (int i = 0; i < CHUNK_WIDTH; i++) {
                chunk->depth[row][i] = -INFINITY;
                chunk->number[row][i] = 0;
            }
        }
    }
    for (int tile = 0; tile < BAND_TILES; tile++) {
        chunk->farthest[tile] = -INFINITY;
    }
}

/* A thread's memory for the band that it draws. The pieces of a band are numbered from 1 on, draw
 * call by draw call. */
struct scratch {
    struct piece **pieces; /* number n is pieces[n - 1] */
    bool *is_visible;      /* [number]: some pixel of the band shows the piece */
    uint32_t *visible;     /* the numbers of a draw call's visible pieces, in their order */
    uint32_t *colors;      /* [number]: of a visible piece whose shader is flat */
    uint32_t *plane_place; /* [number]: of a visible piece of other shaders, in `planes` */
    real *planes;
    struct chunk *before; /* what was visible before the piece of a shader that discards */
    size_t piece_capacity, is_visible_capacity, visible_capacity, color_capacity;
    size_t plane_place_capacity, plane_capacity, before_capacity;
    uint64_t stats[PIPELINE_STATS];
    char apart[2 * CACHE_LINE]; /* two threads that count must not share a cache line */
};

/* A band while it is drawn, and the draw call whose turn it is: what a shade_function works on. */
struct call_band {
    const struct frame *frame;
    struct span rows;
    struct chunk *chunks; /* of the whole band, from left to right */
    struct scratch *scratch;
    uint64_t *stats;
    const struct recorded_call *call;
    const void *uniforms;
    struct span numbers;      /* the call's pieces have the numbers begin + 1 to end */
    struct span columns;      /* where they are shaded, or were covered */
    struct span changed_rows; /* where they were covered */
};

/* ---- A frame ---- */

struct frame {
    struct pipeline *pipeline;
    struct image *image;
    size_t thread_count;     /* for workers_create() */
    struct workers *workers; /* NULL also where there are none */
    /* Recorded: */
    struct recorded_call *calls;
    size_t call_count, call_capacity;
    char *uniforms; /* of the calls, one behind the other */
    size_t uniforms_end, uniforms_capacity;
    bool discards; /* one of the shaders does */
    /* Ordered: */
    struct recorded_call **order; /* the calls that may cover pixels, first to last */
    size_t order_count, order_capacity;
    bool reordered;           /* the nearest first, not the first drawn */
    struct index_range round; /* the part of `order` that is being covered */
    bool kept;                /* several rounds: each band has chunks of its own */
    /* Transformed: positions, and the sides of the view that they are beyond. */
    struct screen_position *positions;
    double *recip_w; /* 1/w; 0 where they have no place */
    uint8_t *beyonds;
    size_t position_count, position_capacity, recip_w_capacity, beyond_capacity;
    /* Assembled: */
    struct block *blocks;
    uint32_t *band_starts; /* of each block, in `sorted`: one for each band, and the end */
    size_t block_count, block_capacity, start_capacity;
    size_t blocks_made;    /* blocks that have memory, also of earlier frames */
    size_t round_block;    /* the first one of the round */
    size_t sorted_count;   /* entries of all `sorted` */
    atomic_bool exhausted; /* a thread ran out of memory */
    /* Drawn: */
    struct chunk *chunks;    /* of one band for each thread or, if `kept`, of all bands */
    struct scratch *scratch; /* one a thread; NULL before the first frame */
    size_t chunk_capacity;
};

/* Are the pixels of a shader shaded while they are covered? */
static inline bool shades_at_once(const struct frame *frame, const struct shader *shader) {
    return shader->discards || !frame->pipeline->skip;
}

static inline size_t band_count(const struct frame *frame) {
    return (frame->pipeline->height + BAND_HEIGHT - 1) / BAND_HEIGHT;
}

static inline size_t chunk_count(const struct frame *frame) {
    return (frame->pipeline->width + CHUNK_WIDTH - 1) / CHUNK_WIDTH;
}

static inline struct span span_around(struct span a, struct span b) {
    return (struct span){a.begin < b.begin ? a.begin : b.begin, a.end > b.end ? a.end : b.end};
}

static inline bool place_is_empty(const struct screen_place *place) {
    return place->columns.begin >= place->columns.end || place->rows.begin >= place->rows.end;
}

/* An upper bound on the depth at the pixels of a piece with these depths at its corners. Rounding
 * errors are a few ulp of the depths, less than what is added. */
static inline double nearest_of_depths(const double z[3]) {
    double most = z[0] > z[1] ? z[0] : z[1];
    return (most > z[2] ? most : z[2]) + 1e-14 * (fabs(z[0]) + fabs(z[1]) + fabs(z[2]));
}

/* The columns, or rows, with a pixel centre in the bounding box of a triangle, in an image without
 * end. */
static inline struct span box_centers(int32_t a, int32_t b, int32_t c) {
    return (struct span){FIRST_CENTER(least_of(a, b, c)), LAST_CENTER(most_of(a, b, c)) + 1};
}

static inline struct span columns_of(const struct rectangle *viewport) {
    return (struct span){viewport->x, viewport->x + viewport->width};
}

static inline struct span rows_of(const struct rectangle *viewport) {
    return (struct span){viewport->y, viewport->y + viewport->height};
}

/* Is everything in a place behind the farthest depth of every tile that it reaches? Row 0 is the
 * lowest row of the first band in `bands`. */
static inline bool is_behind(const struct frame *frame, const struct chunk *bands,
                             const struct screen_place *place) {
    for (int y = place->rows.begin / TILE_HEIGHT; y * TILE_HEIGHT < place->rows.end; y++) {
        const struct chunk *band = bands + (size_t)(y / BAND_TILES) * chunk_count(frame);
        for (int x = place->columns.begin / CHUNK_WIDTH; x * CHUNK_WIDTH < place->columns.end;
             x++) {
            if (!(place->nearest < band[x].farthest[y % BAND_TILES])) {
                return false;
            }
        }
    }
    return true;
}

/* Is everything in a place behind what earlier rounds have covered? */
static inline bool is_hidden(const struct frame *frame, const struct screen_place *place) {
    return frame->round.begin > 0 && !place_is_empty(place) &&
           is_behind(frame, frame->chunks, place);
}

/* ---- Positions ---- */

/* The near plane. Where w is less, nothing is drawn: 1/w would grow without bound. */
#define NEAR_W (1.0 / 128)

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

/* ---- Faces that are clipped: clip.c ---- */

/* A convex polygon gains at most one corner at each plane. But where coordinates differ by many
 * orders of magnitude, rounding can make it concave, and n corners become up to n + n/2 at each of
 * the five planes: 3, 4, 6, 9, 13, 19. */
enum { POLYGON_LIMIT = 19 };

struct polygon {
    struct clip_corner {
        struct vec4 clip;
        struct vec3 weight; /* of the face's corners; sum 1 */
    } corner[POLYGON_LIMIT];
    size_t count;
};

/* The part of a face that can be drawn. Triangle n of its fan has corners 0, n and n + 1. */
struct polygon pipeline_clip_face(const struct recorded_call *call, size_t face);

/* ---- What becomes of a face: classify.c ---- */

/* What becomes of a triangle: a face, or a triangle of a clipped face's fan. */
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
    size_t count; /* elements behind the last triangle may hold any positions on the screen */
    /* Their corners on the screen, in 1/256 pixel (anything, where a corner has no place there),
     * and the sides that all of the corners, and any of them, are beyond. */
    int32_t x[3][BATCH_SIZE], y[3][BATCH_SIZE];
    int32_t beyond_all[BATCH_SIZE], beyond_any[BATCH_SIZE];
    /* Found by batch_classify(), all but `kind` only for triangles that are whole: */
    int32_t kind[BATCH_SIZE]; /* of enum triangle_kind */
    /* The lowest corner, of several the leftmost; and the next one, counterclockwise. */
    int32_t first[BATCH_SIZE], second[BATCH_SIZE];
    /* The pixel centres of its bounding box in the viewport, inclusive. */
    int32_t left[BATCH_SIZE], right[BATCH_SIZE], bottom[BATCH_SIZE], top[BATCH_SIZE];
};

/* Classify the triangles. With `skip` off, small triangles that miss all centres in their box count
 * as whole. */
void batch_classify(struct batch *batch, const struct draw_call *call, bool skip);

/* ---- The stages ---- */

/* Find the calls that may cover pixels, and the order in which they are covered. */
bool pipeline_order(struct frame *frame, struct error *error);

/* Go on to the next round; from all zero, to the first. */
void pipeline_next_round(struct frame *frame);

/* Transform, clip and cull the models of the round's calls, except of those that are hidden as a
 * whole: adds their blocks. */
bool pipeline_assemble_round(struct frame *frame, struct error *error);

/* Cover the round's pieces in band `index` of a frame whose chunks are kept: see
 * worker_function. */
void pipeline_cover_band(void *frame, size_t index, size_t worker);

/* Draw band `index` of a frame: cover what is left to cover, then shade what is visible. */
void pipeline_draw_band(void *frame, size_t index, size_t worker);

#endif
