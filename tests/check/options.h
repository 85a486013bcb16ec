/*
 * The options of the check: on its command line, and as variables of the environment, because
 * `make check` has no other way to hand them over.
 */
#ifndef TESTS_CHECK_OPTIONS_H
#define TESTS_CHECK_OPTIONS_H

#include "base/error.h"

#include <stdbool.h>

/* Paths begin at the root, where the check runs. None is longer than DRAWN_PATH_LIMIT / 2. */
struct options {
    const char *root, *scenes, *sources, *references, *looks, *programs, *differences, *make;
    const char *only;    /* judge just this scene; "" means all */
    const char *shares;  /* a file to add each picture's numbers to, or "" */
    const char *counted; /* one to add to what shows a mistake that no picture shows, or "" */
    const char *junit, *json, *html; /* files for reports, or "" */
    const char *note;                /* a line for the reports, or "" */
    double seconds;                  /* for one step's program */
    double build_seconds;            /* for building it */
    bool help;                       /* was printed; the rest is not known */
    bool exact;                      /* every pixel of every scene must be equal */
    bool sanitized;                  /* the programs say in which line they crash */
    bool person; /* standard output is a terminal, and VERBOSE is not in the environment */
};

/* The defaults, and what the environment says. False, with a message, where that is wrong. */
bool options_begin(struct options *options, struct error *error);

/* Begin, then read the command line: argv[1] and on become the steps. Returns how many there are;
 * -1, with a message, where something is wrong. --help is printed at once. */
int options_read(struct options *options, int argc, char **argv, struct error *error);

#endif
