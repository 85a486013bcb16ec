/*
 * Growing arrays: the one place where the course makes an array larger.
 *
 * The owner keeps a pointer, how many elements are in use and how many there is room for:
 *
 *     if (!array_extend(&faces, &capacity, count + 1, sizeof *faces)) {
 *         return error_out_of_memory(error);
 *     }
 *     faces[count++] = face;
 */
#ifndef COMMON_ARRAY_H
#define COMMON_ARRAY_H

#include <stdbool.h>
#include <stddef.h>
#include <string.h>

/* Bytes in a line of the processor's cache. Memory that is read or written so much at once should
 * not lie in two lines: for aligned_alloc(). */
enum { CACHE_LINE = 64 };
#ifdef _WIN32 /* where free() takes no aligned block; it is only a little slower */
#define aligned_alloc(alignment, size) malloc(size)
#endif

/* The part of array_reserve() for an array that must be moved. */
void *array_grow(void *array, size_t *capacity, size_t count, size_t element_size);

/* Room for `count` elements in an array (NULL at first) that has room for `*capacity` (0 at first).
 * Returns the array, moved perhaps, or NULL when memory runs out: the old array is then unchanged.
 * An array that grows gets half as much again at least, so that many small steps stay linear. */
static inline void *array_reserve(void *array, size_t *capacity, size_t count,
                                  size_t element_size) {
    return count <= *capacity && array != NULL ? array
                                               : array_grow(array, capacity, count, element_size);
}

/* The same for the array whose pointer is at `pointer`, and is set. False when memory runs out. */
static inline bool array_extend(void *pointer, size_t *capacity, size_t count,
                                size_t element_size) {
    void *array;
    memcpy(&array, pointer, sizeof array); /* of any type */
    array = array_reserve(array, capacity, count, element_size);
    if (array != NULL) {
        memcpy(pointer, &array, sizeof array);
    }
    return array != NULL;
}

#endif
