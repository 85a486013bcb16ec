/* The system knows which blocks are to be in large pages. */
#include "base/large_pages.h"
#include "unit/unit.h"

#include <stdlib.h>
#include <unistd.h>

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
        bool has_large_pages = access("/sys/kernel/mm/transparent_hugepage/enabled", F_OK) == 0;
        CHECK(!known || !has_large_pages || (asked && end_asked)); /* others refuse */
        CHECK(!small_asked);
    }
    free(block);
    free(small);
}

UNIT_MAIN(TEST(test_large_pages_are_asked_for))
