/*
 * Which of the lessons' known mistakes a program makes, where no picture tells it: the pictures are
 * right and the work is not, nothing is drawn, or the program ends for a division by 0. Then it is
 * told by what it counts with --stats, and by which pictures of the lesson are right.
 *
 * What is known is made by `make mistakes STEP=NN`, of the mistakes without a picture that is wrong
 * in another way: tests/check/looks/stepNN_name/counters.list has a line for each scene of theirs
 * that tells them, with blanks between
 *
 *     the scene;
 *     which pictures are right: - for all, where a counter of this scene is wrong; else a letter
 *         for each scene of the lesson: r right, b blank, d none for a division by 0;
 *     all that the program counts in this scene, pixels_tested=5,pixels_written=0; - for nothing;
 *     the task that is at fault, or -;
 *     the figure of the lesson's wrong pictures that shows it, or 0;
 *     what it is, up to the end of the line.
 *
 * A wrong diagnosis is worse than none. So a program makes such a mistake only when
 *
 *     it counts exactly the same in this scene, and in all others that are blank;
 *     each picture is as the mistake's is: one that is wrong in another way tells more;
 *     not more than four mistakes are the same.
 *
 * A program that has not come so far draws nothing either. So what is still to do may be as it is,
 * but then a blank scene must count something; and where none does, another picture must be right.
 */
#ifndef TESTS_CHECK_COUNTERS_H
#define TESTS_CHECK_COUNTERS_H

#include "looks.h"
#include "result.h"

#include <stdbool.h>
#include <stddef.h>

enum { COUNTERS_LIMIT = 1024, COUNTERS_SCENE_LIMIT = 64 };

/* What a program counts in a scene: "pixels_tested=5,pixels_written=0", "-" for nothing. Empty when
 * it cannot be told. */
struct counters {
    char text[COUNTERS_LIMIT];
};

/* A letter for each scene of the lesson: r right, b blank, d none for a division by 0, ? to do,
 * x wrong in another way. */
struct counters_pictures {
    char text[COUNTERS_SCENE_LIMIT];
};

/* What is known of a mistake's scene, or found of a program's. */
struct counted {
    char scene[SCENE_NAME_LIMIT];
    struct counters_pictures pictures; /* "-": all are right */
    struct counters counters;
    struct look look; /* what it is; of a program nothing */
};

/* What is known of a lesson. All zero: nothing. */
struct counted_list {
    struct counted *list;
    size_t count, capacity;
};

/* Read those of a step: DIRECTORY/STEP/counters.list. What cannot be read is not known. */
void counted_read(struct counted_list *list, const char *directory, const char *step);
void counted_free(struct counted_list *list);

/* What a program has printed with --stats, of that scene. */
struct counters counters_of(const char *output, const char *scene);

/* The pictures of a step's result, of which all is judged. */
struct counters_pictures counters_pictures(const struct step_result *result);

/* What may be told of an item of the result that fails: of a counter, or of a picture that is blank
 * or missing. False: it tells nothing. `output` is what the program has printed with --stats. */
bool counted_of(struct counted *counted, const struct step_result *result,
                const struct item_result *item, const char *output);

/* Do these tell a mistake from a program that has not come so far? A counter does; of all pictures
 * that are blank or missing one must. */
bool counted_tells(const struct counted *yours, size_t count);

/* Which mistakes show all of this? At most LOOKS_NAME_LIMIT; where there are more, none. All are of
 * row 1 (looks_tell). Returns how many. */
size_t counted_find(const struct counted_list *list, const struct counted *yours, size_t count,
                    struct look found[LOOKS_NAME_LIMIT]);

#endif
