/*
 * llvmpipe in a separate process: it reads its number of threads once in the life of a process,
 * so each number needs one. A child draws a frame when it is told to, and sleeps otherwise; so the
 * frames of all sides can take turns.
 *
 * A child is a copy of this process (fork): scenes that point to models which were read before it
 * was started mean the same to it.
 */
#ifndef FRAME_CHILD_H
#define FRAME_CHILD_H

#include "llvmpipe.h"
#include "scene.h"

#include <sys/types.h>

/* All zero is valid, and no child. */
struct child {
    pid_t process;   /* 0: none */
    int to, from;    /* pipes */
    uint8_t *pixels; /* shared with the child; of the last child_read() */
    size_t pixels_size;
    char name[256]; /* of the renderer */
};

/* Start a child that draws with that many threads, images of at most `pixels_most` pixels. */
bool child_start(struct child *child, int threads, size_t pixels_most, struct error *error);
void child_end(struct child *child);

bool child_load(const struct child *child, const struct frame_scene *scene, struct error *error);

/* Draw two frames; the second, for which caches are as warm as in an animation, took so many
 * seconds. */
bool child_draw(const struct child *child, double *seconds, struct error *error);

/* Give the frame that was drawn last: BGRA in `pixels`. */
bool child_read(const struct child *child, struct error *error);

#endif
