/*
 * Pixels, positions on the screen, and the edges of triangles. Whole numbers decide which pixels
 * are covered, so every compiler gets the same ones. geometry.h says where pixel (0,0) and its
 * centre are. (What lessons 1 to 3 teach about them is in given/: read these lessons first.)
 */
#ifndef COMMON_RASTER_H
#define COMMON_RASTER_H

#include "geometry.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* ---- Parts of an image ---- */

/* Pixels of a row, or rows: begin inclusive, end exclusive; begin >= end when there are none. */
struct span {
    int begin, end;
};

/* The pixels, or rows, that are in both spans. */
static inline struct span span_overlap(struct span a, struct span b) {
    return (struct span){a.begin > b.begin ? a.begin : b.begin, a.end < b.end ? a.end : b.end};
}

struct pixel {
    int x, y;
};

enum { LINE_LIMIT = 1 << 29 }; /* end points of a line lie in -LINE_LIMIT..LINE_LIMIT */

/* A part of an image, in pixels; (x,y) is its bottom-left pixel. */
struct rectangle {
    int x, y, width, height;
};

/* A cell of a grid over an image of that size, counted row by row from the top left, from 0. The
 * cells share out all of its pixels; an image with fewer pixels than cells gives some of them
 * none. */
struct rectangle grid_cell(size_t width, size_t height, int columns, int rows, int cell);

/* ---- Positions and edges on the screen ---- */

enum {
    SUBPIXEL_BITS = 8,
    SUBPIXELS = 1 << SUBPIXEL_BITS, /* 256 steps of a snapped position in one pixel */
    SCREEN_LIMIT = 1 << 21,         /* pixels: no corner lies farther than this from (0,0) */
    DRAW_LIMIT = 16384              /* pixels: no image to draw on is wider or higher */
};

/* A position on the screen in 1/256 pixel. */
struct fixed2 {
    int32_t x, y;
};

/* Round to the nearest 1/256 pixel (halves up). False, with `snapped` unchanged, where a coordinate
 * is NaN or beyond SCREEN_LIMIT. */
static inline bool screen_snap(struct vec2 screen, struct fixed2 *snapped) {
    if (!(fabs(screen.x) <= SCREEN_LIMIT && fabs(screen.y) <= SCREEN_LIMIT)) {
        return false;
    }
    *snapped = (struct fixed2){(int32_t)floor(screen.x * SUBPIXELS + 0.5),
                               (int32_t)floor(screen.y * SUBPIXELS + 0.5)};
    return true;
}

/* The edge function of one side: origin + dx * x + dy * y is its value at the centre of pixel
 * (x,y), in 1/256 pixel squared; positive on the triangle's side of the edge. */
struct edge {
    int64_t origin, dx, dy;
    int64_t least; /* smallest value that is inside: 0 for a top or left edge, otherwise 1 */
};

/* A triangle ready to be drawn. Edge i lies opposite corner i. */
struct edges {
    struct edge edge[3];
    int64_t area;       /* twice the triangle's area, 1/256 pixel squared; positive */
    bool clockwise;     /* the corners were given clockwise as seen on the screen */
    int y_begin, y_end; /* rows that may be covered: begin inclusive, end exclusive */
    int width;          /* of the image */
};

/* Is pixel (x,y) of the image covered? (Spans find the same, for a whole row.) */
static inline bool edges_cover(const struct edges *edges, int x, int y) {
    for (int i = 0; i < 3; i++) {
        const struct edge *e = &edges->edge[i];
        if (e->origin + e->dx * x + e->dy * y < e->least) {
            return false;
        }
    }
    return true;
}

/* ---- Whole numbers ---- */

/* Division rounded down; C's own division rounds towards zero. */
static inline int64_t floor_divide(int64_t a, int64_t b) {
    int64_t quotient = a / b;
    return quotient - (a % b != 0 && (a < 0) != (b < 0));
}

/* Division rounded up. */
static inline int64_t ceil_divide(int64_t a, int64_t b) {
    return -floor_divide(-a, b);
}

static inline int32_t least_of(int32_t a, int32_t b, int32_t c) {
    int32_t least = a < b ? a : b;
    return least < c ? least : c;
}

static inline int32_t most_of(int32_t a, int32_t b, int32_t c) {
    int32_t most = a > b ? a : b;
    return most > c ? most : c;
}

/* The first pixel of a row whose centre lies at `least` (in 1/256 pixel) or beyond, and the last
 * one whose centre does not lie beyond `most`. The centre of pixel 0 is half a pixel from 0. For
 * whole numbers and, element by element, for vectors of them; >> rounds down, also below 0. */
#define FIRST_CENTER(least) (((least) + (SUBPIXELS / 2 - 1)) >> SUBPIXEL_BITS)
#define LAST_CENTER(most)   (((most)-SUBPIXELS / 2) >> SUBPIXEL_BITS)

/* The pixels of a row or column whose centres lie in least..most (1/256 pixel), cut to 0..size. */
static inline struct span centers_between(int32_t least, int32_t most, size_t size) {
    int64_t begin = FIRST_CENTER((int64_t)least), end = LAST_CENTER((int64_t)most) + 1;
    return (struct span){(int)(begin > 0 ? begin : 0),
                         (int)(end < (int64_t)size ? end : (int64_t)size)};
}

/* ---- Depth ---- */

/* All depths become minus infinity: nothing is drawn yet. */
void depth_clear(double *depth, size_t pixel_count);

#include "given/lines.h"
#include "given/triangles.h"

#endif
