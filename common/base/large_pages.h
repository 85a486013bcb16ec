/*
 * How a program gets its memory from the system, which hands out pages of 4096 bytes one by one,
 * and sets them to zero, unless it is asked for larger ones. A program that runs for a few
 * hundredths of a second spends more than half of its time on that. Large pages also make it faster
 * to read memory here and there: a processor remembers where some thousand pages are.
 */
#ifndef COMMON_BASE_LARGE_PAGES_H
#define COMMON_BASE_LARGE_PAGES_H

#include <stddef.h>

/* Let a block that was just allocated be in large pages, as far as it fills some, where the system
 * has them (Linux; elsewhere nothing happens). */
void ask_for_large_pages(void *block, size_t size);

/* Called once, when a program begins: malloc() keeps what is freed for what is allocated next, in
 * large pages, where the C library can do that (glibc; elsewhere nothing happens). */
void keep_freed_memory(void);

#endif
