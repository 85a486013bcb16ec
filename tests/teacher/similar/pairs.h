/*
 * Which two submissions are so much alike that a person should look at them.
 *
 * A pair's share is that of the fingerprints which both have, of those of the one who has fewer: so
 * somebody who copied one half and wrote another is found with what was copied.
 */
#ifndef TESTS_SIMILAR_PAIRS_H
#define TESTS_SIMILAR_PAIRS_H

#include "class.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    SHARED_LEAST = 8, /* with fewer fingerprints in common nothing can be said */
    /* A pair is listed when it shares so many % in all lessons, or in one of them. */
    DEFAULT_PERCENT_OF_ALL = 50,
    DEFAULT_PERCENT_OF_LESSON = 80
};

/* How many fingerprints both have, and each of them has. */
struct common {
    uint32_t shared, of_a, of_b;
};

/* Two submissions, a before b. */
struct pair {
    size_t a, b;
    struct common all;  /* of the lessons that both did */
    struct common most; /* of the lesson in which they are most alike */
    size_t lesson_count, most_lesson;
};

struct pairs {
    struct pair *all;
    size_t count;
};

/* What a pair must share at least to be listed, 0..1. */
struct limits {
    double all, lesson;
};

/* Shared fingerprints as a part of the fewer; 0 where there are not enough to tell. */
double common_share(struct common common);

/* What a pair has in common in a lesson. */
struct common pairs_compare(const struct class *class, size_t lesson, size_t a, size_t b);

/* Every two submissions of the class. False when memory runs out; free them in any case. */
bool pairs_make(struct pairs *pairs, const struct class *class);

/* Those that reach one of the limits, the most alike in all lessons first. Where both did but one
 * lesson, the limit for a lesson counts. */
bool pairs_find(struct pairs *pairs, const struct class *class, struct limits limits);

void pairs_free(struct pairs *pairs);

#endif
