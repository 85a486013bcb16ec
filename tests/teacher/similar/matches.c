/* Where two programs are alike: see matches.h. */
#include "matches.h"

#include "base/array.h"

#include <stdlib.h>

enum { LINES_BETWEEN = 3 }; /* matches not farther apart than that are one block */

static bool add_block(struct matches *matches, struct block block) {
    struct block *blocks =
        array_reserve(matches->blocks, &matches->capacity, matches->count + 1, sizeof *blocks);
    if (blocks == NULL) {
        return false;
    }
    matches->blocks = blocks;
    blocks[matches->count++] = block;
    return true;
}

static void mark(bool *marked, struct lines lines) {
    for (size_t line = lines.first; line <= lines.last; line++) {
        marked[line] = true;
    }
}

/* Every fingerprint that both have, the first of one with the first of the other, and so on. */
static bool find_shared(struct matches *matches, const struct fingerprints *a, size_t lines_a,
                        const struct fingerprints *b, size_t lines_b) {
    for (size_t i = 0, k = 0; i < a->count && k < b->count;) {
        const struct fingerprint *left = &a->all[i], *right = &b->all[k];
        if (left->hash == right->hash && left->last <= lines_a && right->last <= lines_b) {
            struct block block = {{left->first, left->last}, {right->first, right->last}};
            mark(matches->marked_a, block.a);
            mark(matches->marked_b, block.b);
            if (!add_block(matches, block)) {
                return false;
            }
        }
        i += left->hash <= right->hash;
        k += right->hash <= left->hash;
    }
    return true;
}

static int compare_blocks(const void *a, const void *b) {
    const struct block *first = a, *second = b;
    if (first->a.first != second->a.first) {
        return first->a.first > second->a.first ? 1 : -1;
    }
    return (first->b.first > second->b.first) - (first->b.first < second->b.first);
}

static bool is_near(struct lines lines, struct lines more) {
    return more.first <= lines.last + LINES_BETWEEN + 1 &&
           lines.first <= more.last + LINES_BETWEEN + 1;
}

static struct lines lines_around(struct lines lines, struct lines more) {
    return (struct lines){lines.first < more.first ? lines.first : more.first,
                          lines.last > more.last ? lines.last : more.last};
}

/* Blocks that are near one another in both programs become one. */
static void join_near(struct matches *matches) {
    size_t kept = 0;
    for (size_t i = 0; i < matches->count; i++) {
        struct block *last = &matches->blocks[kept > 0 ? kept - 1 : 0], next = matches->blocks[i];
        if (kept > 0 && is_near(last->a, next.a) && is_near(last->b, next.b)) {
            *last = (struct block){lines_around(last->a, next.a), lines_around(last->b, next.b)};
        } else {
            matches->blocks[kept++] = next;
        }
    }
    matches->count = kept;
}

bool matches_find(struct matches *matches, const struct fingerprints *a, size_t lines_a,
                  const struct fingerprints *b, size_t lines_b) {
    *matches = (struct matches){.marked_a = calloc(lines_a + 1, sizeof(bool)),
                                .marked_b = calloc(lines_b + 1, sizeof(bool))};
    if (matches->marked_a == NULL || matches->marked_b == NULL ||
        !find_shared(matches, a, lines_a, b, lines_b)) {
        return false;
    }
    if (matches->count > 0) {
        qsort(matches->blocks, matches->count, sizeof *matches->blocks, compare_blocks);
    }
    join_near(matches);
    return true;
}

void matches_free(struct matches *matches) {
    free(matches->blocks);
    free(matches->marked_a);
    free(matches->marked_b);
    *matches = (struct matches){0};
}
