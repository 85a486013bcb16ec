/*
 * Which of the lessons' known mistakes a program makes, where no picture tells it: the pictures are
 * right and the work is not, nothing is drawn, or the program ends for a division by 0. Then it is
 * told by what it counts with --stats, and by which pictures of the lesson are right.
 *
 * Both are one text, SCENE:PICTURES:COUNTERS, which is also the sign of a mistake (mistakes.h):
 *
 *     PICTURES    - for all right, where a counter of this scene is wrong; else a letter for each
 *                 scene of the lesson: r right, b blank, d none for a division by 0
 *     COUNTERS    everything the program counts here, as in pixels_tested=5,pixels_written=0; - for
 *                 nothing
 *
 * A wrong diagnosis is worse than none. So a program makes such a mistake only when
 *
 *     it counts exactly the same in this scene, and in all others that are blank;
 *     each picture is as the mistake's is: one that is wrong in another way tells more;
 *     not more than four mistakes are the same.
 *
 * A program that has not come so far draws nothing either. So what is still to do may be as it is
 * (its letter is a ?), but then a blank scene must count something; and where none does, another
 * picture must be right.
 */
#ifndef TESTS_CHECK_COUNTERS_H
#define TESTS_CHECK_COUNTERS_H

#include "mistakes.h"
#include "result.h"

#include <stdbool.h>
#include <stddef.h>

enum { COUNTED_LIMIT = 1024 };

/* What a program shows in a scene. */
struct counted {
    char text[COUNTED_LIMIT];
    bool tells; /* it has come so far: this is a mistake */
};

/* What may be told of an item of the result that fails: of a counter, or of a picture that is blank
 * or missing. False: it tells nothing. `output` is what the program has printed with --stats. */
bool counted_of(struct counted *counted, const struct step_result *result,
                const struct item_result *item, const char *output);

/* Do these tell a mistake from a program that has not come so far? One of them must. */
bool counted_tells(const struct counted *yours, size_t count);

/* Which mistakes show all of this? None where there are too many. */
struct mistake_set counted_find(const struct mistake_list *mistakes, const struct counted *yours,
                                size_t count);

#endif
