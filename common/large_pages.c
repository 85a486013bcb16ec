/* How a program gets its memory from the system; see large_pages.h. */
#define _DEFAULT_SOURCE /* for madvise() */

#include "large_pages.h"

#include <stdint.h>
#include <stdlib.h>

#if defined(__linux__) && defined(__GLIBC__)
#include <malloc.h>
#include <sys/mman.h>

enum { MEGABYTE = 1 << 20, LARGE_PAGE = 2 * MEGABYTE, HEAP = 30 * MEGABYTE };

/* A block is allocated from the heap and freed again, which stays there, in large pages from then
 * on. Only what is very large still comes from the system one by one: it can grow without being
 * copied. */
void use_large_pages(void) {
    mallopt(M_TRIM_THRESHOLD, 2 * HEAP);
    mallopt(M_MMAP_THRESHOLD, 32 * MEGABYTE); /* the most that glibc allows */
    char *block = malloc(HEAP);
    if (block != NULL) {
        size_t first = LARGE_PAGE - (uintptr_t)block % LARGE_PAGE;
        madvise(block + first, HEAP - LARGE_PAGE, MADV_HUGEPAGE);
        free(block);
    }
    mallopt(M_MMAP_THRESHOLD, 8 * MEGABYTE);
}

#else

void use_large_pages(void) {}

#endif
