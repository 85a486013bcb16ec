/* What can be said of a wrong picture that looks like no known mistake. */
#ifndef TESTS_CHECK_SEEN_H
#define TESTS_CHECK_SEEN_H

#include "tgaimage.h"

#include <stdbool.h>

/* A sentence without a full stop, like "upside down"; empty where nothing simple is true. */
struct seen_text {
    char text[120];
};

/* Compare yours with a reference of the same size that isn't blank. What is said is true of all but
 * a twentieth of the drawn pixels; the first that is true counts: nothing is drawn; one colour;
 * mirrored or turned; channels exchanged; moved; larger or smaller; only a part of it is there; too
 * much is; it is too dark, too light, or in other colours; how many pixels are wrong, and how. */
struct seen_text seen_find(const struct image *reference, const struct image *yours);

#endif
