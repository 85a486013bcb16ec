/*
 * Relations between two pictures of the same program, which need no reference: what is drawn stays
 * the same when faces come in another order, when the corners of each are turned, when all is moved
 * by whole pixels. (T. Y. Chen, S. C. Cheung, S. M. Yiu, "Metamorphic testing", 1998.)
 *
 * The program is given models or text scenes of inputs.h. Which relation a lesson promises, and how
 * many pixels may break it, is in the table of scenes.
 */
#ifndef TESTS_CHECK_RELATION_H
#define TESTS_CHECK_RELATION_H

#include "run.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum relation {
    RELATION_SHUFFLED, /* shapes in another order */
    RELATION_TURNED,   /* the corners of each face turned: 2, 3, 1 instead of 1, 2, 3 */
    RELATION_REVERSED, /* the ends of each line exchanged */
    RELATION_MOVED,    /* moved by whole pixels: equal except for the shift */
    RELATION_HALVED,   /* drawn twice as large, and halved */
    RELATION_COUNT
};

struct relation_result {
    bool drawn; /* both pictures are there; otherwise `text` says why not */
    uint64_t differing, drawn_pixels;
    char text[256]; /* "moved by (3,2): 214 pixels differ, first at (12,30)" */
};

/* Try the relation on a scene of the step's program. False, with a message, when the check itself
 * cannot do that. */
bool relation_try(const char *programs, const char *step, const char *scene, enum relation relation,
                  const struct run_limits *limits, struct relation_result *result,
                  struct error *error);

#endif
