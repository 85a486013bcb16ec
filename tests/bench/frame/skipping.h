/* What each of the pipeline's shortcuts is worth where there is much that nobody sees. */
#ifndef TESTS_BENCH_FRAME_SKIPPING_H
#define TESTS_BENCH_FRAME_SKIPPING_H

#include "base/error.h"

#include <stdbool.h>
#include <stddef.h>

enum { FRAMES_LIMIT = 1000 };

/* Draw a head and 64 spheres, one in the other, each `frames` times (at most FRAMES_LIMIT) in each
 * way, with one thread, in turn; print the median times. The head is the model of that path. Then
 * print what a frame of it does with ever more faces, and how much memory that takes. */
bool skipping_measure(const char *model, size_t frames, struct error *error);

#endif
