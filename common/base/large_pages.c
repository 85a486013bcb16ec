/* How a program gets its memory from the system; see large_pages.h. */
#define _DEFAULT_SOURCE 1 /* for madvise() */

#include "base/large_pages.h"

#include <stdint.h>
#include <stdlib.h>

#if defined(__linux__)
#include <sys/mman.h>
#endif

enum { MEGABYTE = 1 << 20, LARGE_PAGE = 2 * MEGABYTE };

void ask_for_large_pages(void *block, size_t size) {
#ifdef MADV_HUGEPAGE
    size_t first = LARGE_PAGE - (uintptr_t)block % LARGE_PAGE;
    if (size >= first + LARGE_PAGE) {
        madvise((char *)block + first, (size - first) / LARGE_PAGE * LARGE_PAGE, MADV_HUGEPAGE);
    }
#else
    (void)block;
    (void)size;
#endif
}

#ifdef __GLIBC__
#include <malloc.h>

/* The heap grows by HEAP around a small block, which is freed again: what it has grown by stays
 * there, in large pages from then on. (A block of that size would do as well, but where
 * MALLOC_PERTURB_ is set, as by the check, all of it would be written.) Only what is very large
 * still comes from the system one by one: it can grow without being copied. */
void keep_freed_memory(void) {
    enum { HEAP = 30 * MEGABYTE, BLOCK = MEGABYTE / 2, USUAL_PAD = 128 * 1024 };
    mallopt(M_TRIM_THRESHOLD, 2 * HEAP);
    mallopt(M_MMAP_THRESHOLD, 8 * MEGABYTE);
    mallopt(M_TOP_PAD, HEAP - BLOCK);
    void *block = malloc(BLOCK);
    if (block != NULL) {
        ask_for_large_pages(block, HEAP);
        free(block);
    }
    mallopt(M_TOP_PAD, USUAL_PAD);
}
#else
void keep_freed_memory(void) {}
#endif
