/* Does a picture pass, and if not, which of its pixels are wrong? */
#ifndef TESTS_CHECK_VERDICT_H
#define TESTS_CHECK_VERDICT_H

#include "compare.h"
#include "scenes.h"

#include <stdbool.h>

struct verdict {
    bool passes;
    enum compare_pixels pixels; /* that count as wrong */
    const struct tally *tally;  /* of those; where it passes, of everything that differs */
    unsigned limit;             /* that is broken, as in the table of scenes; 0 for an exact one */
    const char *what;           /* "wrong", ...: what broke it; NULL for an exact scene, and for
                                 * one that is too light or too dark as a whole */
};

/* Judge by the scene's limits. The first one that is broken counts. `shares` must outlive it. */
struct verdict verdict_find(const struct comparison *shares, const struct checked_item *scene);

#endif
