/* A set of 64-bit numbers: added in any order, sorted once, then asked. */
#ifndef TESTS_SIMILAR_SET_H
#define TESTS_SIMILAR_SET_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* All zero is a valid, empty set. */
struct set {
    uint64_t *values;
    size_t count, capacity;
};

/* False when memory runs out. */
bool set_add(struct set *set, uint64_t value);

/* To be called after the last set_add(), before the first set_has(). */
void set_sort(struct set *set);

bool set_has(const struct set *set, uint64_t value);

void set_free(struct set *set);

#endif
