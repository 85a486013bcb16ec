/*
 * Private to the pipeline: a frame, and all else that its stages know of each other. The table in
 * pipeline.h lists the stages in their order. Each file calls only files below it:
 *
 *     pipeline.c                  records draw calls, draws the frame
 *     order.c                     which calls need not be drawn, and the order of the others
 *     assemble.c                  from models to pieces
 *     clip.c, classify.c          what becomes of a face
 *     cover.c                     covers the pixels of a band, and has them shaded
 *     shade.h, planes.h           the loops that SHADER() compiles
 *     frame.h, vectors.h          what all share
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

/* Rows are drawn in bands of this many, whose depths stay in the cache. */
enum { BAND_HEIGHT = 32 };
_Static_assert(BAND_HEIGHT <= 32, "`touched` has a bit for each row");

/* A row is divided into chunks of this many pixels, for however many LANES: what is touched is
 * known by the chunk; and what is farthest, by the tile of some chunks one above the other. */
enum { CHUNK = 16, TILE_HEIGHT = 8 };
_Static_assert(BAND_HEIGHT % TILE_HEIGHT == 0, "no tile lies in two bands");

/* ---- Draw calls and pieces ---- */

/* Elements of an array: begin inclusive, end exclusive. */
struct index_range {
    size_t begin, end;
};

/* Where something may cover pixels, and what no depth of it is above: infinite where it may reach
 * the near plane. */
struct screen_place {
    struct span columns, rows;
    double nearest;
};

struct recorded_call {
    struct draw_call call;
    const struct shader *shader;
    size_t uniforms;                 /* where they are in the frame's `uniforms` */
    uint32_t drawn;                  /* how many calls were drawn before it */
    struct screen_place place;       /* first of the box around it, then of its pieces */
    size_t first_block, block_count; /* none while it is not assembled, or skipped as a whole */
    size_t first_position;           /* in the frame's `positions` */
    double guard_band;               /* where its faces are clipped: see guard_band_of() */
    atomic_uint beyond;              /* the sides that any of its positions is beyond */
};

/* A position on the screen. */
struct screen_position {
    struct fixed2 at;
    double depth; /* z/w, linear on the screen */
};

/* A triangle on the screen: a face of the model, or a part that clipping left of one. One cache
 * line. */
struct piece {
    struct fixed2 corner[3]; /* counterclockwise; the lowest first, of those the leftmost */
    double depth[3];
    uint32_t face, drawn;           /* of the call with that number */
    uint16_t first_band, last_band; /* that it reaches */
    uint8_t first, second; /* which corners of the face, or of the part, its first two are */
    uint8_t part;          /* 0: a whole face; n: triangle n of the fan of a clipped one */
    atomic_bool seen;      /* one of several bands has shown a pixel of it */
};

/* Which corner of the face, or of the part, corner i of a piece is. */
static inline size_t corner_of_face(const struct piece *piece, int i) {
    return i == 0 ? piece->first : i == 1 ? piece->second : 3U - piece->first - piece->second;
}

/* The positions and the faces of a call are shared out among threads in blocks of this many. */
enum { BLOCK_SIZE = 1024 };

/* Those of one block, and the pieces that its faces became. */
struct block {
    struct recorded_call *call;
    size_t begin; /* its first position, and its first face */
    struct piece *pieces;
    /* Where the list of each band begins, and the last one ends; then the lists: of pieces, by
     * their indices. */
    uint32_t *sorted;
    size_t piece_count, piece_capacity, sorted_capacity;
    struct span columns, rows; /* that the pieces may cover */
    uint64_t stats[PIPELINE_STATS];
};

/* ---- Bands ---- */

/* What is visible of a band, so far, in one column of chunks. So what lies above is near in memory,
 * and as many rows as are wanted are read in turn. */
struct column {
    double depth[BAND_HEIGHT * CHUNK]; /* minus infinity: nothing is drawn */
    /* The piece that is seen: see struct scratch; 0 where nothing is drawn. One more is read
     * behind the last (see find_runs()), and the others fill a cache line. */
    uint32_t number[BAND_HEIGHT * CHUNK + CACHE_LINE / sizeof(uint32_t)];
};

_Static_assert(sizeof(struct column) % CACHE_LINE == 0, "each column is aligned");

/* The memory of a thread, for one band after the other. The pieces of a band have numbers from 1
 * on, one draw call's after the other's. */
struct scratch {
    struct piece **pieces; /* number n is pieces[n - 1] */
    /* By number: 0 while nothing of the piece is visible, otherwise 1; and once its draw call is
     * shaded, what was fetched for it: the colour of a flat piece, or where its planes are. */
    uint32_t *fetched;
    uint32_t *visible;     /* the numbers of a draw call's visible pieces */
    real *planes;          /* and their planes: see planes_of() */
    struct column *before; /* where a shader discards: what was visible without its piece */
    size_t piece_capacity, fetched_capacity, visible_capacity, plane_capacity, before_capacity;
};

/* A band that is drawn, one draw call after the other: what a shade_function works on. */
struct call_band {
    const struct frame *frame;
    struct span rows;
    uint32_t *touched;     /* as in the frame, from left to right */
    struct column *chunks; /* of its rows, likewise */
    struct scratch *scratch;
    uint64_t *stats;
    const struct recorded_call *call;
    const void *uniforms;
    struct span numbers;               /* of the call's pieces: begin + 1 to end */
    struct span columns, changed_rows; /* where they are shaded, or were covered */
};

/* ---- A frame ---- */

struct frame {
    struct pipeline *pipeline;
    struct image *image;
    size_t thread_count;     /* for workers_create() */
    struct workers *workers; /* NULL also where there are none */
    bool has_workers;        /* they have been asked for */
    /* Recorded: */
    struct recorded_call *calls;
    size_t call_count, call_capacity;
    char *uniforms; /* of the calls, one behind the other */
    size_t uniforms_end, uniforms_capacity;
    bool discards; /* one of the shaders does */
    /* Ordered: */
    bool reordered;           /* the nearest call comes first */
    struct index_range round; /* of the calls, what comes in this round */
    bool kept;                /* there are several: each band has its own columns */
    /* Transformed: positions, and the sides of the view that they are beyond. */
    struct screen_position *positions;
    double *recip_w; /* 1/w; 0 where they have no place */
    uint8_t *beyonds;
    size_t position_count, position_capacity, recip_w_capacity, beyond_capacity;
    /* Assembled: */
    struct block *blocks;
    size_t block_count, block_capacity;
    size_t blocks_made;    /* that have memory */
    size_t round_block;    /* the first one of the round */
    size_t sorted_count;   /* pieces in the lists of all `sorted` */
    atomic_bool exhausted; /* a thread ran out of memory */
    /* Drawn: */
    struct column *columns; /* a row of them for each thread, or for each band if `kept` */
    size_t column_count;
    struct scratch *scratch; /* one a thread */
    uint64_t (*band_stats)[PIPELINE_STATS];
    size_t scratch_count, scratch_capacity;
    /* For each column of each band, bit i: something may be drawn in row i. And the same of the
     * last frame. */
    uint32_t *touched, *last_touched;
    /* Of each tile of the image, row after row: at most the depth of any pixel. If `reordered`. */
    double *farthest;
    struct image last_image; /* in which that was drawn */
    bool knows_last;         /* this image is that one, and nobody else has written to it */
};

/* Are the pixels of a shader shaded while they are covered? */
static inline bool shades_at_once(const struct frame *frame, const struct shader *shader) {
    return shader->discards || !frame->pipeline->skip;
}

static inline size_t band_count(const struct frame *frame) {
    return (frame->pipeline->height + BAND_HEIGHT - 1) / BAND_HEIGHT;
}

/* A column is a chunk wide. */
static inline size_t chunk_columns(const struct frame *frame) {
    return (frame->pipeline->width + CHUNK - 1) / CHUNK;
}

/* Where a pixel of a band is in its column. */
static inline size_t place_in_column(int row, int x) {
    return (size_t)row * CHUNK + (size_t)x % CHUNK;
}

static inline size_t tile_count(const struct frame *frame) {
    return band_count(frame) * (BAND_HEIGHT / TILE_HEIGHT) * chunk_columns(frame);
}

static inline struct span span_around(struct span a, struct span b) {
    return (struct span){a.begin < b.begin ? a.begin : b.begin, a.end > b.end ? a.end : b.end};
}

static inline bool place_is_empty(const struct screen_place *place) {
    return place->columns.begin >= place->columns.end || place->rows.begin >= place->rows.end;
}

/* At least the depth at every pixel of a piece with those depths at its corners, whatever
 * roundings: these amount to a few ulp of them. */
static inline double nearest_of_depths(const double z[3]) {
    double most = z[0] > z[1] ? z[0] : z[1];
    return (most > z[2] ? most : z[2]) + 1e-14 * (fabs(z[0]) + fabs(z[1]) + fabs(z[2]));
}

/* The columns, or rows, whose pixel centres the box of a triangle reaches, in an image without end.
 * centers_between() of raster.h, with shifts. */
static inline struct span box_centers(int32_t a, int32_t b, int32_t c) {
    return (struct span){(least_of(a, b, c) + SUBPIXELS / 2 - 1) >> 8,
                         ((most_of(a, b, c) - SUBPIXELS / 2) >> 8) + 1};
}

static inline struct span columns_of(const struct rectangle *viewport) {
    return (struct span){viewport->x, viewport->x + viewport->width};
}

static inline struct span rows_of(const struct rectangle *viewport) {
    return (struct span){viewport->y, viewport->y + viewport->height};
}

/* Is everything in a place behind what is shown in every tile that it reaches? */
static inline bool is_behind(const struct frame *frame, const struct screen_place *place) {
    for (int y = place->rows.begin / TILE_HEIGHT; y * TILE_HEIGHT < place->rows.end; y++) {
        const double *farthest = frame->farthest + (size_t)y * chunk_columns(frame);
        for (int x = place->columns.begin / CHUNK; x * CHUNK < place->columns.end; x++) {
            if (!(place->nearest < farthest[x])) {
                return false;
            }
        }
    }
    return true;
}

/* The same, of what the rounds before this one have covered. */
static inline bool is_hidden(const struct frame *frame, const struct screen_place *place) {
    return frame->round.begin > 0 && !place_is_empty(place) && is_behind(frame, place);
}

/* ---- Positions ---- */

/* Nearer than this part of the camera's distance nothing is drawn: 1/w would grow without bound. */
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

/* A convex polygon gains at most one corner at each plane. Where coordinates differ by many
 * orders of magnitude, rounding can make the polygon not convex, and n corners become up to n +
 * n/2 at each of the five planes: 3, 4, 6, 9, 13, 19. */
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

/* What a face is, or a part of a clipped one. */
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
    /* The lowest corner, of those the leftmost; and the next, counterclockwise. */
    int32_t first[BATCH_SIZE], second[BATCH_SIZE];
    /* The pixel centres of its box in the viewport, inclusive. */
    int32_t left[BATCH_SIZE], right[BATCH_SIZE], bottom[BATCH_SIZE], top[BATCH_SIZE];
};

/* Classify the triangles. With `skip` off those that miss the centres in their box are not looked
 * for. */
void batch_classify(struct batch *batch, const struct draw_call *call, bool skip);

/* ---- The stages ---- */

static inline void pipeline_add_stats(struct frame *frame, const uint64_t stats[PIPELINE_STATS]) {
    for (int i = 0; i < PIPELINE_STATS; i++) {
        frame->pipeline->stats[i] += stats[i];
    }
}

/* Make a column what it was, before these of its rows were touched: nothing is drawn in it. */
void pipeline_clear_column(struct column *column, uint32_t touched);

/* Find where calls may cover pixels, and the order in which they are covered. */
void pipeline_order(struct frame *frame);

/* Go on to the next round; from all zero, to the first. */
void pipeline_next_round(struct frame *frame);

/* Transform, clip and cull the models of the round's calls, except of those that are hidden as a
 * whole: adds their blocks. */
bool pipeline_assemble_round(struct frame *frame, struct error *error);

/* Cover the round's pieces in band `index` of a frame, which is kept: see worker_function. */
void pipeline_cover_band(void *frame, size_t index, size_t worker);

/* Draw band `index` of a frame: shade what is visible, and cover first, if it was not kept. */
void pipeline_draw_band(void *frame, size_t index, size_t worker);

#endif
