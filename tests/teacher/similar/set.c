/* A set of 64-bit numbers: see set.h. */
#include "set.h"

#include "base/array.h"

#include <stdlib.h>

bool set_add(struct set *set, uint64_t value) {
    uint64_t *values = array_reserve(set->values, &set->capacity, set->count + 1, sizeof *values);
    if (values == NULL) {
        return false;
    }
    set->values = values;
    set->values[set->count++] = value;
    return true;
}

static int compare_values(const void *a, const void *b) {
    uint64_t first = *(const uint64_t *)a, second = *(const uint64_t *)b;
    return (first > second) - (first < second);
}

void set_sort(struct set *set) {
    if (set->count > 0) {
        qsort(set->values, set->count, sizeof *set->values, compare_values);
    }
}

bool set_has(const struct set *set, uint64_t value) {
    return set->count > 0 &&
           bsearch(&value, set->values, set->count, sizeof *set->values, compare_values) != NULL;
}

void set_free(struct set *set) {
    free(set->values);
    *set = (struct set){0};
}
