/*
 * The pixels of a line, one after the other. You write this in lesson 1, and cut it to the image in
 * lesson 2; it is given from lesson 3 on. line_begin() is in raster.c.
 */
#ifndef COMMON_GIVEN_LINES_H
#define COMMON_GIVEN_LINES_H

#ifndef COMMON_RASTER_H
#error "include raster.h instead"
#endif

#include "given/later.h"

/* ---- Lines (taught in step01_line, cut to the image in step02_wireframe) ---- */

/* The pixels of a line that lie in the image, one after the other, starting at its left end (a
 * steep line: at its lower end), whatever the order of the end points. In every column (a steep
 * line: row) it is the pixel nearest to the ideal line; at a tie the one nearer to where the line
 * starts. */
struct line_walk {
    int x, y;              /* the current pixel */
    bool steep;            /* steps up in y instead of right in x */
    int minor_step;        /* +1 or -1, along the other axis */
    size_t left;           /* pixels after the current one */
    int64_t rise, divisor; /* twice the minor and twice the major length */
    int64_t remainder;     /* of the division for the minor coordinate: 0 <= remainder < divisor */
};

/* Go to the first pixel in the image; false when there is none. Work does not grow with what lies
 * outside. */
bool line_begin(struct line_walk *walk, struct pixel a, struct pixel b, size_t width,
                size_t height);

/* Go to the next pixel in the image; false when there is none. */
static inline bool line_next(struct line_walk *walk) {
    if (walk->left == 0) {
        return false;
    }
    walk->left--;
    walk->remainder += walk->rise;
    int minor = 0;
    if (walk->remainder >= walk->divisor) {
        walk->remainder -= walk->divisor;
        minor = walk->minor_step;
    }
    walk->x += walk->steep ? minor : 1;
    walk->y += walk->steep ? 1 : minor;
    return true;
}

#if COURSE_LESSON <= 2
#define line_begin GIVEN_LATER(line_begin, lessons 1 and 2, 3)
#define line_next  GIVEN_LATER(line_next, lessons 1 and 2, 3)
#endif /* COURSE_LESSON */

#endif
