/*
 * Fingerprints of a program: the hashes of some of its runs of GRAM_TOKENS tokens, chosen so that
 * programs which share a long enough run have one of them in common, wherever it stands.
 *
 * Which are chosen: S. Schleimer, D. S. Wilkerson, A. Aiken, "Winnowing: local algorithms for
 * document fingerprinting", SIGMOD 2003. Of WINDOW_GRAMS hashes in a row the least is taken, and of
 * equal ones the one that was taken before ("robust winnowing"). So every run of
 * GRAM_TOKENS + WINDOW_GRAMS - 1 equal tokens is noticed, and no run of less than GRAM_TOKENS.
 */
#ifndef TESTS_SIMILAR_FINGERPRINTS_H
#define TESTS_SIMILAR_FINGERPRINTS_H

#include "set.h"
#include "tokens.h"

enum { GRAM_TOKENS = 16, WINDOW_GRAMS = 5 };

struct fingerprint {
    uint64_t hash;
    size_t first, last; /* the lines it stands in */
};

/* Sorted by hash, then by line. All zero is valid and empty. */
struct fingerprints {
    struct fingerprint *all;
    size_t count, capacity;
};

/* Add the hashes of all runs of a text that is given, from which nobody can be seen to copy. False
 * when memory runs out. */
bool fingerprints_give(struct set *given, const struct tokens *tokens);

/* Choose fingerprints. Tokens of given runs are cut out before, so that none reaches into them.
 * False when memory runs out. */
bool fingerprints_choose(struct fingerprints *chosen, const struct tokens *tokens,
                         const struct set *given);

/* One past the fingerprints with the same hash as number `at`. */
size_t fingerprints_next(const struct fingerprints *fingerprints, size_t at);

void fingerprints_free(struct fingerprints *fingerprints);

#endif
