/* The command line of bench-frame. */
#ifndef FRAME_OPTIONS_H
#define FRAME_OPTIONS_H

#include "base/error.h"
#include "llvmpipe.h"
#include "scene.h"

#include <stdbool.h>
#include <stddef.h>

enum { LIST_LIMIT = 8, FRAMES_LIMIT = 1000, TRIANGLES_LIMIT = 100000000 };

struct size {
    size_t width, height;
};

struct options {
    const char *model;
    enum frame_look looks[LIST_LIMIT];
    struct size sizes[LIST_LIMIT];
    size_t triangles[LIST_LIMIT]; /* about so many */
    size_t look_count, size_count, triangle_count;
    size_t frames;          /* timed of each, 1..FRAMES_LIMIT */
    bool skipping;          /* measure only what shortcuts are worth */
    enum clearing clearing; /* how the course's side clears the image */
    bool help;              /* nothing but that */
};

/* Read the command line; print the help where that is wanted. False, with a message, where it is
 * wrong. */
bool options_read(struct options *options, int argc, char **argv, struct error *error);

#endif
