/*
 * The submissions of a class, as fingerprints: a set for each submission and lesson. What the
 * course has given is cut out (fingerprints.h).
 */
#ifndef TESTS_SIMILAR_CLASS_H
#define TESTS_SIMILAR_CLASS_H

#include "fingerprints.h"
#include "sources.h"

#include <stdbool.h>
#include <stddef.h>

struct submission {
    const char *name, *path;
    struct fingerprints *lessons; /* one a lesson */
    bool has_files;               /* of any lesson */
};

/* All zero is valid and empty. */
struct class {
    struct names lessons;
    struct submission *submissions;
    size_t submission_count;
    struct set given;   /* of the course */
    struct bytes notes; /* what was not compared and why: lines, printable */
};

/* Read what the course gives: the .c and .h files of the lessons in `starters`, and those of
 * `starters`/common where that is. A directory without a lesson is an error. */
bool class_read_given(struct class *class, const char *starters, struct error *error);

/* Read the submissions whose names and paths are set. What cannot be read gives a note. False
 * when memory runs out. */
bool class_read(struct class *class);

void class_free(struct class *class);

#endif
