/* Growing blocks of bytes, and strings made as printf makes them. */
#ifndef COMMON_BASE_BYTES_H
#define COMMON_BASE_BYTES_H

#include "base/error.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A growing block of bytes. All zero is a valid, empty block; `data` belongs to the block. */
struct bytes {
    unsigned char *data;
    size_t size;     /* bytes in use */
    size_t capacity; /* bytes allocated */
};

/* Add `size` bytes at the end; false when memory runs out (the block is then unchanged). */
bool bytes_append(struct bytes *bytes, const void *data, size_t size);

/* Append what printf would print; false when memory runs out (the block is then unchanged). */
bool bytes_print(struct bytes *bytes, const char *format, ...) PRINTF_LIKE(2, 3);

/* Make room for `size` more bytes without changing the contents; false when memory runs out. */
bool bytes_reserve(struct bytes *bytes, size_t size);

/* Free the block and leave it empty. */
void bytes_free(struct bytes *bytes);

/* Four or eight bytes as a number, the first one lowest. Compilers know this form as one
 * instruction. */
static inline uint32_t load_u32(const void *data) {
    const unsigned char *bytes = data;
    return bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 | (uint32_t)bytes[3] << 24;
}

static inline uint64_t load_u64(const unsigned char *bytes) {
    return load_u32(bytes) | (uint64_t)load_u32(bytes + 4) << 32;
}

/* What printf would print, in memory that the caller frees; NULL when memory runs out. */
char *string_format(const char *format, ...) PRINTF_LIKE(1, 2);

/* Append it to a string in memory of `size` bytes; it is cut where that is full. */
void string_append(char *string, size_t size, const char *format, ...) PRINTF_LIKE(3, 4);

#endif
