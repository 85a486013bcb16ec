/* Growing arrays: see array.h. */
#include "base/array.h"

#include "base/large_pages.h"

#include <stdint.h>
#include <stdlib.h>

enum { LEAST_CAPACITY = 16 };

void *array_grow(void *array, size_t *capacity, size_t count, size_t element_size) {
    size_t half_more = *capacity < SIZE_MAX / 2 ? *capacity + *capacity / 2 : *capacity;
    size_t wanted = half_more > LEAST_CAPACITY ? half_more : LEAST_CAPACITY;
    wanted = wanted > count ? wanted : count;
    if (wanted > SIZE_MAX / element_size) {
        return NULL;
    }
    void *moved = realloc(array, wanted * element_size);
    if (moved != NULL) {
        *capacity = wanted;
        ask_for_large_pages(moved, wanted * element_size);
    }
    return moved;
}
