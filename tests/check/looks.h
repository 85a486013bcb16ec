/*
 * Which of the lessons' known mistakes a wrong picture looks like.
 *
 * Each mistake of stepNN_name/mistakes.txt is kept as its colours at some hundred pixels of each
 * scene: pixels at which the mistakes differ from the reference and from each other, and some
 * others. They are made by `make mistakes STEP=NN` after a change of main.c, scenes or mistakes.txt
 * (`make verify` finds those that are out of date), in a file for each scene:
 *
 *     tests/lessons/stepNN_name/looks/scene.png    a column for each pixel; row 0, at the bottom,
 *                                                holds where it is (x in 12 bits, then y, from
 *                                                blue's lowest on), row 1 the reference, then one
 *                                                row for each picture that mistakes draw
 *
 * Which row is whose is in signs.txt next to them (mistakes.h).
 *
 * A wrong diagnosis is worse than none. So a picture looks like a mistake only when
 *
 *     at least 8 of the pixels have a wrong colour, other than black, and for every 32 of these at
 *     most one of all pixels has not the mistake's colour;
 *     as many pixels of it are apart as of the mistake's, within a quarter;
 *     or no difference from the mistake's picture is known at all, and some of it is not black;
 *     no other mistake has nearly as many of these colours, and not more than four are the same.
 *
 * Colours are compared as in compare.h, but where a picture is near the reference everywhere: then
 * it is held only against mistakes that are near it too (0 pixels apart), and the colours must be
 * equal.
 */
#ifndef TESTS_CHECK_LOOKS_H
#define TESTS_CHECK_LOOKS_H

#include "base/error.h"
#include "compare.h"
#include "mistakes.h"
#include "result.h"
#include "tgaimage.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { LOOKS_FIRST_ROW = 2 };

/* What a mistake makes of the scene. All zero: it leaves it right, or draws nothing. */
struct look {
    size_t row;     /* of the pixels; 0: it cannot be recognised */
    uint64_t apart; /* in the whole picture */
};

/* What is known of a scene. All zero: nothing. */
struct looks {
    struct image pixels;
    const struct mistake_list *mistakes;
    struct look *list; /* one for each mistake; NULL: not known */
    size_t starter;    /* the row of what it draws; 0: nothing, or what is not known */
    bool *explains;    /* of each row, whether it explains your picture; NULL: not known */
};

/* The mistake that a picture looks like. */
struct likeness {
    size_t row;      /* 0: none */
    size_t distance; /* pixels with another colour */
};

/* Read the looks of a scene, DIRECTORY/STEP/SCENE.png. What cannot be read is not known. The list
 * of mistakes must outlive them. */
void looks_read(struct looks *looks, const struct mistake_list *mistakes, const char *directory,
                const char *step, const char *scene);
void looks_free(struct looks *looks);

/* Which mistake does a wrong picture look like? `apart` is what the comparison has counted; 0: the
 * picture is wrong because much of it is near, but not equal. None where the looks were made with
 * another reference. */
struct likeness looks_find(const struct looks *looks, const struct image *reference,
                           const struct image *yours, uint64_t apart);

/* Find which rows explain a wrong picture: of eight of its wrong pixels, at least seven have the
 * colours of the row. When memory runs out, that is not known. */
void looks_compare(struct looks *looks, const struct image *yours);

/* The mistakes of that row: at most LOOKS_NAME_LIMIT, which looks_find() sees to. */
struct mistake_set looks_mistakes(const struct looks *looks, size_t row);

/* Column i of row 0 says where this pixel is. */
struct place {
    size_t x, y;
};
struct place looks_place(const struct image *pixels, size_t i);
void looks_set_place(struct image *pixels, size_t i, struct place place);

#endif
