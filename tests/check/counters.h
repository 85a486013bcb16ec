/*
 * Which of the lessons' known mistakes a program makes, where no picture shows it: the pictures are
 * right and the work is not, nothing is drawn, or the program ends for a division by 0. Then the
 * check compares what the program counts with --stats, or which pictures of the lesson are right.
 *
 * Either is a text, which is also the sign of a mistake (mistakes.h):
 *
 *     SCENE:-:COUNTERS    a counter of the scene is wrong, and no picture: what the program counts
 *                         here, as in pixels_tested=5,pixels_written=0
 *     SCENE:PICTURES:-    the scene is blank or missing: a letter for each scene of the lesson,
 *                         r right, b blank, d none for a division by 0
 *
 * A wrong diagnosis is worse than none. So a program makes such a mistake only when the text is the
 * same, not more than four mistakes have it, no picture is wrong in another way (which would say
 * more), and, where one is blank, nothing is to do.
 */
#ifndef TESTS_CHECK_COUNTERS_H
#define TESTS_CHECK_COUNTERS_H

#include "mistakes.h"
#include "result.h"

#include <stdbool.h>

enum { COUNTED_LIMIT = 1024 };

/* What a program shows in a scene. */
struct counted {
    char text[COUNTED_LIMIT];
};

/* The text of an item that fails: a counter, or a picture that is blank or missing. False: it has
 * none. `output` is what the program has printed with --stats, which only counters need. */
bool counted_of(struct counted *counted, const struct step_result *result,
                const struct item_result *item, const char *output);

/* Which mistakes show this? None where there are too many. */
struct mistake_set counted_find(const struct mistake_list *mistakes, const struct counted *yours);

#endif
