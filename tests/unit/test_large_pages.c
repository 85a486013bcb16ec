/* Memory that was freed is there for the next one, without the system having to hand it out again.
 * (That pages are large shows in `make bench-run` alone: not every system has them.) */
#define _DEFAULT_SOURCE /* for getrusage() */

#include "large_pages.h"
#include "unit.h"

#include <stdlib.h>

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

UNIT_MAIN(TEST(test_freed_memory_stays))
