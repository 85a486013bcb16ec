/* Growing arrays: see array.h. */
#include "base/array.h"

#include "base/large_pages.h"

#include <stdint.h>
#include <stdlib.h>

enum { LEAST_CAPACITY = 16 };

bool array_grow(void *pointer, size_t *capacity, size_t count, size_t element_size) {
    size_t half_more = *capacity < SIZE_MAX / 2 ? *capacity + *capacity / 2 : *capacity;
    size_t wanted = half_more > LEAST_CAPACITY ? half_more : LEAST_CAPACITY;
    wanted = wanted > count ? wanted : count;
    if (wanted > SIZE_MAX / element_size) {
        return false;
    }
    void *array;
    memcpy(&array, pointer, sizeof array);
    void *moved = realloc(array, wanted * element_size);
    if (moved != NULL) {
        memcpy(pointer, &moved, sizeof moved);
        *capacity = wanted;
        ask_for_large_pages(moved, wanted * element_size);
    }
    return moved != NULL;
}
