/*
 * A step's program given something to draw that is not its own: a text scene or a model of
 * inputs.h, with options as a user gives them.
 */
#ifndef TESTS_CHECK_UNSEEN_H
#define TESTS_CHECK_UNSEEN_H

#include "drawn.h"
#include "inputs.h"
#include "run.h"

#include <stdbool.h>

/* A separate directory with two empty ones: where the input lies, and where the program runs and
 * leaves its pictures. */
struct unseen_place {
    struct run_directory whole;
    char input[DRAWN_PATH_LIMIT], pictures[DRAWN_PATH_LIMIT];
};

bool unseen_begin(struct unseen_place *place, struct error *error);

/* Remove it; one that is all zero is none. */
void unseen_end(const struct unseen_place *place);

enum { UNSEEN_OPTION_LIMIT = 24 };

/* Write the input into the place and let the program draw it: `PROGRAM -o PICTURES OPTIONS INPUT`,
 * contained and limited as run.h says; PROGRAM is absolute. `options` ends with NULL;
 * UNSEEN_OPTION_LIMIT at most. The pictures of the last drawing are gone. The caller frees
 * result->messages. */
bool unseen_draw(struct unseen_place *place, const char *program, const char *const *options,
                 enum input_kind kind, uint64_t seed, const struct variant *variant,
                 const struct run_limits *limits, struct run_result *result, struct error *error);

/* Is the step given text scenes and no models? Lessons 1 and 3 are. */
bool unseen_takes_text(const char *step);

#endif
