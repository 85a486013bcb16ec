/* Fingerprints of a program: see fingerprints.h. */
#include "fingerprints.h"

#include "base/array.h"

#include <stdlib.h>

/* ---- Runs of tokens and their hashes ---- */

static const uint64_t base = UINT64_C(0x9e3779b97f4a7c15); /* odd; 2^64 over the golden ratio */

/* Spread the bits (the finalizer of SplitMix64: Steele, Lea, Flood, "Fast splittable pseudorandom
 * number generators", 2014), so that the least hash is any of them. */
static uint64_t mix(uint64_t hash) {
    hash = (hash ^ hash >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
    hash = (hash ^ hash >> 27) * UINT64_C(0x94d049bb133111eb);
    return hash ^ hash >> 31;
}

/* The hash of the run that begins at each token (Karp and Rabin, 1987: the next one follows from
 * the last). Sets `hashes`, which the caller frees, and how many; false when memory runs out. */
static bool hash_runs(const struct token *tokens, size_t token_count, uint64_t **hashes,
                      size_t *count) {
    *count = token_count >= GRAM_TOKENS ? token_count - GRAM_TOKENS + 1 : 0;
    *hashes = malloc((*count + 1) * sizeof **hashes);
    if (*hashes == NULL) {
        return false;
    }
    uint64_t hash = 0, leaving = 1; /* the factor of the token that leaves the run */
    for (size_t i = 0; i < GRAM_TOKENS; i++) {
        leaving *= base;
    }
    for (size_t i = 0; i < token_count; i++) {
        hash = hash * base + tokens[i].code;
        if (i >= GRAM_TOKENS) {
            hash -= tokens[i - GRAM_TOKENS].code * leaving;
        }
        if (i + 1 >= GRAM_TOKENS) {
            (*hashes)[i + 1 - GRAM_TOKENS] = mix(hash);
        }
    }
    return true;
}

bool fingerprints_give(struct set *given, const struct tokens *tokens) {
    uint64_t *hashes;
    size_t count;
    if (!hash_runs(tokens->all, tokens->count, &hashes, &count)) {
        return false;
    }
    bool done = true;
    for (size_t i = 0; i < count && done; i++) {
        done = set_add(given, hashes[i]);
    }
    free(hashes);
    return done;
}

/* ---- What is chosen ---- */

static bool add(struct fingerprints *chosen, const struct token *run, uint64_t hash) {
    struct fingerprint *all =
        array_reserve(chosen->all, &chosen->capacity, chosen->count + 1, sizeof *all);
    if (all == NULL) {
        return false;
    }
    chosen->all = all;
    all[chosen->count++] = (struct fingerprint){hash, run[0].line, run[GRAM_TOKENS - 1].line};
    return true;
}

/* The place of the least hash in a window, the last of equal ones. */
static size_t least_place(const uint64_t *hashes, size_t begin, size_t end) {
    size_t least = begin;
    for (size_t i = begin + 1; i < end; i++) {
        least = hashes[i] <= hashes[least] ? i : least;
    }
    return least;
}

/* Winnow tokens that belong together. Fewer hashes than a window are one window. */
static bool choose(struct fingerprints *chosen, const struct token *tokens, size_t token_count) {
    uint64_t *hashes;
    size_t count;
    if (!hash_runs(tokens, token_count, &hashes, &count)) {
        return false;
    }
    bool done = true;
    size_t taken = SIZE_MAX;
    size_t last_begin = count > WINDOW_GRAMS ? count - WINDOW_GRAMS : 0;
    for (size_t begin = 0; count > 0 && begin <= last_begin && done; begin++) {
        size_t end = begin + WINDOW_GRAMS < count ? begin + WINDOW_GRAMS : count;
        size_t place = least_place(hashes, begin, end);
        bool kept = taken != SIZE_MAX && taken >= begin && hashes[taken] == hashes[place];
        if (!kept) {
            taken = place;
            done = add(chosen, tokens + place, hashes[place]);
        }
    }
    free(hashes);
    return done;
}

/* Sets `is_given`, which the caller frees: is the token part of a given run? */
static bool find_given(const struct tokens *tokens, const struct set *given, bool **is_given) {
    uint64_t *hashes;
    size_t count, marked = 0; /* up to there tokens are marked */
    *is_given = calloc(tokens->count + 1, sizeof **is_given);
    if (*is_given == NULL || !hash_runs(tokens->all, tokens->count, &hashes, &count)) {
        return false;
    }
    for (size_t i = 0; i < count; i++) {
        if (set_has(given, hashes[i])) {
            for (size_t k = marked > i ? marked : i; k < i + GRAM_TOKENS; k++) {
                (*is_given)[k] = true;
            }
            marked = i + GRAM_TOKENS;
        }
    }
    free(hashes);
    return true;
}

static int compare_prints(const void *a, const void *b) {
    const struct fingerprint *first = a, *second = b;
    if (first->hash != second->hash) {
        return first->hash > second->hash ? 1 : -1;
    }
    return (first->first > second->first) - (first->first < second->first);
}

bool fingerprints_choose(struct fingerprints *chosen, const struct tokens *tokens,
                         const struct set *given) {
    bool *is_given;
    bool done = find_given(tokens, given, &is_given);
    for (size_t begin = 0; begin < tokens->count && done;) {
        size_t end = begin;
        while (end < tokens->count && !is_given[end]) {
            end++;
        }
        done = choose(chosen, tokens->all + begin, end - begin);
        begin = end + 1;
    }
    free(is_given);
    if (done && chosen->count > 0) {
        qsort(chosen->all, chosen->count, sizeof *chosen->all, compare_prints);
    }
    return done;
}

size_t fingerprints_next(const struct fingerprints *fingerprints, size_t at) {
    uint64_t hash = fingerprints->all[at].hash;
    while (at < fingerprints->count && fingerprints->all[at].hash == hash) {
        at++;
    }
    return at;
}

void fingerprints_free(struct fingerprints *fingerprints) {
    free(fingerprints->all);
    *fingerprints = (struct fingerprints){0};
}
