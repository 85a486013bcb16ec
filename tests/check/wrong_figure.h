/*
 * The small picture of a mistake in a lesson's table of wrong pictures: the reference at the left
 * and what the mistake draws at the right, with a white gap between them.
 */
#ifndef TESTS_CHECK_WRONG_FIGURE_H
#define TESTS_CHECK_WRONG_FIGURE_H

#include "base/error.h"
#include "tgaimage.h"

#include <stdbool.h>
#include <stddef.h>

enum {
    WRONG_FIGURE_SIDE = 160,  /* pixels along the longer side of what was made smaller, at most */
    WRONG_FIGURE_LARGE = 200, /* and of what was enlarged */
    WRONG_FIGURE_GAP = 4
};

/* A part of a picture; all zero: it is to be found. */
struct figure_area {
    size_t x, y, width, height; /* the lower left pixel; pixels */
};

/* "60x40+10+20" is 60 pixels wide, 40 high, and begins at (10,20); "auto" is to be found. */
bool figure_area_read(struct figure_area *area, const char *text, struct error *error);

/* `figure` becomes the picture of a part of both, which the caller frees. A part that is to be
 * found is the one around what is apart (compare.h), or the whole, where that is not much larger.
 * What is larger than WRONG_FIGURE_SIDE is made smaller: n x n pixels become one, with the
 * mean of their light; but what is thin and in one of the two only keeps its colour, where the
 * other is plain. What is small is enlarged: each pixel becomes a square.
 *
 * False, with a message, when the two have not one size, the part is not in them, nothing is apart
 * in it, all of it is black in the wrong picture, or memory runs out. */
bool wrong_figure(struct image *figure, const struct image *reference, const struct image *wrong,
                  struct figure_area area, struct error *error);

#endif
