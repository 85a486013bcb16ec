/* Memory that was freed is there for the next one, without the system having to hand it out again;
 * and the system knows which blocks are to be in large pages. */
#define _DEFAULT_SOURCE /* for getrusage() */

#include "base/large_pages.h"
#include "unit/unit.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Sanitizers have a malloc() of their own. */
#if defined(__SANITIZE_ADDRESS__)
#define IS_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define IS_SANITIZED
#endif
#endif

#if defined(__linux__) && defined(__GLIBC__) && !defined(IS_SANITIZED)
#include <sys/resource.h>

enum { BLOCK = 6 << 20, PAGE = 4096 };

/* How often the system is asked for a page while a block is allocated and written. */
static long faults_of_block(void) {
    struct rusage before, after;
    CHECK(getrusage(RUSAGE_SELF, &before) == 0);
    volatile char *block = malloc(BLOCK); /* or the compiler would leave out what nobody reads */
    for (size_t i = 0; CHECK(block != NULL) && i < BLOCK; i += PAGE) {
        block[i] = 1;
    }
    CHECK(getrusage(RUSAGE_SELF, &after) == 0);
    free((void *)block);
    return after.ru_minflt - before.ru_minflt;
}

static void test_freed_memory_stays(void) {
    keep_freed_memory();
    keep_freed_memory(); /* as often as a program is begun */
    faults_of_block();
    CHECK(faults_of_block() < BLOCK / PAGE / 10);
}
#else
static void test_freed_memory_stays(void) {
    keep_freed_memory();
    CHECK(true);
}
#endif

/* Has the system been asked for large pages where that is? ("Documentation/filesystems/proc.rst" of
 * Linux: the flag hg.) */
static bool is_asked_for(const char *at, bool *known) {
    FILE *map = fopen("/proc/self/smaps", "r");
    unsigned long long begin = 0, end = 0, place = (uintptr_t)at;
    char line[4096];
    bool asked = false;
    *known = false;
    while (map != NULL && fgets(line, sizeof line, map) != NULL) {
        unsigned long long first, behind;
        if (sscanf(line, "%llx-%llx ", &first, &behind) == 2) {
            begin = first;
            end = behind;
        } else if (strncmp(line, "VmFlags:", 8) == 0 && place >= begin && place < end) {
            *known = true;
            asked = strstr(line, " hg") != NULL;
        }
    }
    if (map != NULL) {
        fclose(map);
    }
    return asked;
}

/* A system without large pages refuses. */
static bool has_large_pages(void) {
    FILE *file = fopen("/sys/kernel/mm/transparent_hugepage/enabled", "r");
    if (file != NULL) {
        fclose(file);
    }
    return file != NULL;
}

static void test_large_pages_are_asked_for(void) {
    enum { MEGABYTE = 1 << 20, SIZE = 64 * MEGABYTE };
    char *block = malloc(SIZE), *small = malloc(SIZE);
    bool known = false, small_known = false;
    if (CHECK(block != NULL && small != NULL)) {
        ask_for_large_pages(block, SIZE);
        ask_for_large_pages(small, 2 * MEGABYTE - 1);
        bool asked = is_asked_for(block + SIZE / 2, &known);
        bool end_asked = is_asked_for(block + SIZE - 2 * MEGABYTE, &known);
        bool small_asked = is_asked_for(small + SIZE / 2, &small_known);
        CHECK(!known || !has_large_pages() || (asked && end_asked));
        CHECK(!small_asked);
    }
    free(block);
    free(small);
}

UNIT_MAIN(TEST(test_freed_memory_stays), TEST(test_large_pages_are_asked_for))
