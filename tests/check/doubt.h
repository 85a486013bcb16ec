/*
 * What else is known of a program, and speaks against a mistake that one of its pictures, or its
 * work, looks like.
 *
 *     MISTAKE_IMPOSSIBLE  a scene is exact that the mistake would make wrong, or it passes with
 *                         less than a tenth of the pixels apart that the mistake makes so; or wrong
 *                         calls lay the item to other tasks; or it would be DOUBTFUL, and the calls
 *                         of its task are right;
 *     MISTAKE_DOUBTFUL    another scene fails that shows and needs nothing but what this one does
 *                         (so no other task can have made it wrong), and it is not so that the
 *                         mistake makes it, or the mistake would leave it right. Two mistakes in
 *                         one task do that, and a third one that is not known;
 *     MISTAKE_UNLIKELY    another picture shows the mistake's task right, or it is to do.
 */
#ifndef TESTS_CHECK_DOUBT_H
#define TESTS_CHECK_DOUBT_H

#include "looks.h"
#include "result.h"

#include <stddef.h>

/* An item of a step that is judged, except for what it looks like. */
struct suspicion {
    const struct step_result *result; /* its pictures come first, as many as there are scenes */
    const struct looks *looks;        /* what is known of each scene */
    size_t scene_count;
    const char *source; /* main.c */
    const struct item_result *item;
};

enum mistake_doubt doubt_find(const struct suspicion *suspicion, const struct mistake *mistake);

#endif
