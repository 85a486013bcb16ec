/*
 * What is common knowledge in a class: everyone writes that loop.
 *
 * A fingerprint is, when more than a COMMON_PART-th of those who did the lesson have it, and more
 * than COMMON_LEAST of them. Near copies of one another count as one there: what many copied does
 * not become common knowledge by that.
 */
#ifndef TESTS_SIMILAR_COMMON_H
#define TESTS_SIMILAR_COMMON_H

#include "class.h"

#include <stdbool.h>

enum {
    COMMON_PART = 4,
    COMMON_LEAST = 4,
    /* Near copies share so many % in all lessons, and so many fingerprints. */
    NEAR_PERCENT = 80,
    NEAR_LEAST = 100
};

/* Take it out of all submissions. To be called once. False when memory runs out. */
bool common_forget(struct class *class);

#endif
