/* Numbers for pairs of numbers, in the order in which the pairs are first seen. */
#ifndef TESTS_BENCH_FRAME_PAIRS_H
#define TESTS_BENCH_FRAME_PAIRS_H

#include <stddef.h>
#include <stdint.h>

/* An open hash table. All zero is a valid, empty one, with room for nothing. */
struct pairs {
    uint64_t *keys;
    uint32_t *numbers; /* from 1; 0 where no pair is kept */
    size_t capacity;   /* a power of two */
    uint32_t count;
};

/* Room for `most` pairs, fewer than 2^31. */
struct pairs pairs_create(size_t most);
void pairs_free(struct pairs *pairs);

/* The number of the pair, from 0; that of a new pair is the count before the call. The order of a
 * and b counts. */
uint32_t pairs_number(struct pairs *pairs, uint32_t a, uint32_t b);

#endif
