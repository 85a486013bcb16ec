/* The command line of bench-frame. */
#ifndef TESTS_BENCH_FRAME_OPTIONS_H
#define TESTS_BENCH_FRAME_OPTIONS_H

#include "base/error.h"
#include "scene.h"

#include <stdbool.h>
#include <stddef.h>

enum { FRAMES_LIMIT = 1000, THREADS_LIMIT = 16 };

struct options {
    const char *model;
    enum frame_look look; /* this one alone; FRAME_LOOKS: all */
    size_t frames;        /* timed of each, 1..FRAMES_LIMIT */
    size_t threads;       /* that draw, on both sides, 1..THREADS_LIMIT */
    bool quick;           /* at the first size, of the model as it is */
    bool skipping;        /* measure only what shortcuts are worth */
    bool help;            /* nothing but that */
};

/* Read the command line; print the help where that is wanted. False, with a message, where it is
 * wrong. */
bool options_read(struct options *options, int argc, char **argv, struct error *error);

#endif
