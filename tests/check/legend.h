/* A difference image for people: three panels enlarged, and words that say what is what. */
#ifndef TESTS_CHECK_LEGEND_H
#define TESTS_CHECK_LEGEND_H

#include "base/error.h"
#include "compare.h"
#include "tgaimage.h"

#include <stdbool.h>

/* Make `picture` of three panels: reference, yours, difference (compare_difference()), each of the
 * reference's size; every pixel becomes a square, so large that a panel is at least 400 pixels wide
 * and high (within 16 times). Above each panel is its name, below all of them what the colours
 * of the third one mean. Yours may be empty. The caller frees `picture`. */
bool legend_picture(struct image *picture, const struct image *reference, const struct image *yours,
                    enum compare_pixels wrong, struct error *error);

#endif
