/* Who has a fingerprint: the way from a hash to the submissions of a lesson. */
#ifndef TESTS_SIMILAR_OWNERS_H
#define TESTS_SIMILAR_OWNERS_H

#include "class.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct owner {
    uint64_t hash;
    size_t submission;
};

/* Sorted by hash, then by submission; each submission stands once with each of its hashes. */
struct owners {
    struct owner *all;
    size_t count;
};

/* The owners of all fingerprints of a lesson; free(owners->all). False when memory runs out. */
bool owners_find(struct owners *owners, const struct class *class, size_t lesson);

/* One past the owners of the same hash as that of number `at`. */
size_t owners_next(const struct owners *owners, size_t at);

#endif
