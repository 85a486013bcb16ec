/*
 * What the check was told: its options on the command line, and its variables of the environment,
 * which a `make check` cannot hand over otherwise.
 */
#ifndef TESTS_CHECK_OPTIONS_H
#define TESTS_CHECK_OPTIONS_H

#include "base/error.h"

#include <stdbool.h>

/* Paths begin at the root, where the check runs. None is longer than DRAWN_PATH_LIMIT / 2. */
struct options {
    const char *root, *scenes, *sources, *references, *looks, *programs, *differences, *make,
        *first;
    const char *only;    /* judge just this scene; "" means all */
    const char *shares;  /* a file to add each picture's numbers to, or "" */
    const char *counted; /* one to add to what tells a mistake that no picture tells, or "" */
    const char *junit, *json, *tap, *html, *csv; /* files for reports, or "" */
    const char *note;                            /* a line for the reports, or "" */
    double seconds;                              /* for one step's program */
    double build_seconds;                        /* for building it */
    bool exact;                                  /* every pixel of every scene must be equal */
    bool sanitized;                              /* the programs say in which line they crash */
};

extern const char options_help[];

/* Read the options in front of the steps; `first_step` becomes the first argument that is none. */
bool options_read(struct options *options, int argc, char **argv, int *first_step,
                  struct error *error);

#endif
