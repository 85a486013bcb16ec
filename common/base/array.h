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
#ifndef COMMON_BASE_ARRAY_H
#define COMMON_BASE_ARRAY_H

#include <stdbool.h>
#include <stddef.h>
#include <string.h>

/* Bytes in a line of the processor's cache. Memory that is read or written so much at once should
 * not lie in two lines: for aligned_alloc(). */
enum { CACHE_LINE = 64 };
#ifdef _WIN32 /* where free() takes no aligned block; it is only a little slower */
#define aligned_alloc(alignment, size) malloc(size)
#endif

/* The part of array_extend() for an array that must be moved. */
bool array_grow(void *pointer, size_t *capacity, size_t count, size_t element_size);

/* Room for `count` elements in the array whose pointer (NULL at first) is at `pointer`, and which
 * has room for `*capacity` (0 at first). Both are set. False when memory runs out, and the array is
 * unchanged. One that grows gets half as much again at least: many small steps stay linear. */
static inline bool array_extend(void *pointer, size_t *capacity, size_t count,
                                size_t element_size) {
    void *array;
    memcpy(&array, pointer, sizeof array); /* of any type */
    return (count <= *capacity && array != NULL) ||
           array_grow(pointer, capacity, count, element_size);
}

#endif
