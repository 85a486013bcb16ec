/*
 * How a student's picture is compared with its reference, and the picture that shows the result.
 *
 * The rule. The background is black (0,0,0), to which every scene is cleared. A pixel is drawn when
 * it is not background in either picture. Two colours agree when no channel differs by more than 4
 * levels. A drawn pixel is apart when the two colours there do not agree, and wrong when moreover
 * the reference's colour there agrees with none of your pixels in the 3x3 around it, or your colour
 * there with none of the reference's pixels around it.
 *
 * Why not count the pixels that differ: a correct renderer with another fill rule moves edges by
 * one pixel all over the picture, while a missing depth buffer shows in few places, at the mouth
 * and the ears. By a plain count the wrong program comes out better. A moved edge has its colour
 * next to it; a wrong triangle has not. What is apart is counted too, and has its own limit,
 * because otherwise a picture that is shifted by one pixel would be right. So is what is drawn in
 * one picture only: holes between triangles are thin, and few compared with the moved edges inside
 * a model. And pixels that are near but not equal: other arithmetic gives a few of them, but where
 * values are cut off and not rounded half of them and more are one too small.
 *
 * Last, a whole picture may be a few levels too light or too dark, and every colour in it agree. So
 * the pixels that agree must be as light on average, in each channel. The limit lies between what
 * cuts values off and does not round them (less than 1 level too dark; 0.84 was measured), and 2
 * levels more everywhere.
 *
 * Pictures are compared as red, green and blue: a grey picture equals the same grey in colours, and
 * alpha is not looked at.
 */
#ifndef TESTS_CHECK_COMPARE_H
#define TESTS_CHECK_COMPARE_H

#include "base/error.h"
#include "tgaimage.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

enum {
    COMPARE_LEVELS = 4,    /* channels of colours that agree differ by this at most */
    COMPARE_LIGHTER = 1250 /* and by this on average: thousandths of a level */
};

/* How far two colours are apart: the largest difference of a channel, alpha not looked at. */
static inline int color_distance(struct color a, struct color b) {
    int red = abs(a.r - b.r), green = abs(a.g - b.g), blue = abs(a.b - b.b);
    int most = red > green ? red : green;
    return most > blue ? most : blue;
}

static inline bool colors_agree(struct color a, struct color b) {
    return color_distance(a, b) <= COMPARE_LEVELS;
}

/* Is it (0,0,0)? */
static inline bool color_is_black(struct color color) {
    return color.r == 0 && color.g == 0 && color.b == 0;
}

/* Some pixels of a picture: how many, and the first of them, by rows from the bottom. */
struct tally {
    uint64_t count;
    size_t x, y;
};

struct comparison {
    uint64_t drawn;         /* pixels that are not background in either picture */
    struct tally differing; /* pixels that are not equal; none means exact */
    struct tally apart;     /* drawn pixels whose colours do not agree */
    struct tally near;      /* those that agree, and are not equal */
    struct tally wrong;     /* those that have no match next to them either */
    struct tally coverage;  /* those that are apart, and background in one of the two pictures */
    int64_t lighter[3];     /* by so many levels are those that agree lighter in yours, in all: red,
                             * green, blue; less than 0: darker */
};

/* Compare two pictures of the same size (the caller checks that). When yours is all background and
 * the reference is not, every drawn pixel is wrong. */
struct comparison compare_images(const struct image *reference, const struct image *yours);

/* Are they of one size, and is every pixel equal? Stops at the first that is not. */
bool is_same_picture(const struct image *a, const struct image *b);

/* By how many levels are the drawn pixels that agree lighter in yours, on average? That of the
 * channel which differs most. Less than 0: darker. */
double compare_lighter(const struct comparison *comparison);

/* Is that within COMPARE_LIGHTER (inclusive)? */
bool is_as_light(const struct comparison *comparison);

/* Is the share of the drawn pixels within the limit (thousandths of a percent, inclusive)? */
bool share_within(uint64_t count, uint64_t drawn, unsigned limit);

/* That share as "4.4 %", with as many decimals as it takes to show that it is above the limit, when
 * it is, and that it is not zero. */
struct share_text {
    char text[32];
};
struct share_text share_show(uint64_t count, uint64_t drawn, unsigned limit);

/* The pixels that count as wrong in a picture: those that its broken limit is about. */
enum compare_pixels {
    COMPARE_UNMATCHED, /* `wrong` of a comparison */
    COMPARE_COVERAGE,
    COMPARE_APART,
    COMPARE_DIFFERING
};

/* Is every pixel background? */
bool image_is_blank(const struct image *image);

/* Make the picture of the difference, of the reference's size: the reference at a quarter of its
 * brightness with, on top, red: this pixel should not be there, or has another colour;
 * blue: missing; dark green: differs, but does not count. Yours is laid at the bottom-left corner
 * and cut, and an empty image shows as background. The caller frees `difference`. */
bool compare_difference(struct image *difference, const struct image *reference,
                        const struct image *yours, enum compare_pixels wrong, struct error *error);

#endif
