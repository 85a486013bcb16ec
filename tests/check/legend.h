/* A difference image for people: three panels enlarged, and words that say what is what. */
#ifndef TESTS_CHECK_LEGEND_H
#define TESTS_CHECK_LEGEND_H

#include "base/error.h"
#include "tgaimage.h"

#include <stdbool.h>
#include <stddef.h>

/* Make `picture` of the panels of compare_picture(), each `width` pixels wide: every pixel becomes
 * a square, so large that a panel is at least 400 pixels wide and high (within 16 times); above
 * each panel stands its name, below all of them what the colours of the third one mean. The caller
 * frees `picture`. */
bool legend_picture(struct image *picture, const struct image *panels, size_t width,
                    struct error *error);

#endif
