/* Where two programs are alike: blocks of lines of the one beside lines of the other. */
#ifndef TESTS_SIMILAR_MATCHES_H
#define TESTS_SIMILAR_MATCHES_H

#include "fingerprints.h"

#include <stdbool.h>
#include <stddef.h>

/* From line to line, both included. */
struct lines {
    size_t first, last;
};

/* Lines of a, and those of b that are like them. */
struct block {
    struct lines a, b;
};

struct matches {
    struct block *blocks; /* in the order of a's lines */
    size_t count, capacity;
    bool *marked_a, *marked_b; /* by number of line: is a fingerprint in it that both have? */
};

/* Find them; lines are numbered up to `lines_a` and `lines_b`, and what stands beyond them (a file
 * may have changed) is left out. False when memory runs out. */
bool matches_find(struct matches *matches, const struct fingerprints *a, size_t lines_a,
                  const struct fingerprints *b, size_t lines_b);

void matches_free(struct matches *matches);

#endif
