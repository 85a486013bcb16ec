/* Which two submissions are alike: see pairs.h. */
#include "pairs.h"

#include "owners.h"

#include <stdlib.h>
#include <string.h>

/* ---- Two submissions in a lesson ---- */

double common_share(struct common common) {
    uint32_t fewer = common.of_a < common.of_b ? common.of_a : common.of_b;
    return common.shared < SHARED_LEAST ? 0 : (double)common.shared / fewer;
}

static uint32_t count_hashes(const struct fingerprints *prints) {
    uint32_t count = 0;
    for (size_t at = 0; at < prints->count; at = fingerprints_next(prints, at)) {
        count++;
    }
    return count;
}

struct common pairs_compare(const struct class *class, size_t lesson, size_t a, size_t b) {
    const struct fingerprints *first = &class->submissions[a].lessons[lesson];
    const struct fingerprints *second = &class->submissions[b].lessons[lesson];
    struct common common = {0, count_hashes(first), count_hashes(second)};
    for (size_t i = 0, k = 0; i < first->count && k < second->count;) {
        uint64_t left = first->all[i].hash, right = second->all[k].hash;
        common.shared += left == right;
        i = left <= right ? fingerprints_next(first, i) : i;
        k = right <= left ? fingerprints_next(second, k) : k;
    }
    return common;
}

/* ---- All pairs ---- */

/* The place of the pair a < b. */
static size_t place_of(size_t a, size_t b) {
    return b * (b - 1) / 2 + a;
}

static bool create(struct pairs *pairs, size_t submission_count) {
    size_t count = place_of(0, submission_count);
    *pairs = (struct pairs){calloc(count + 1, sizeof *pairs->all), count};
    for (size_t b = 1; b < submission_count && pairs->all != NULL; b++) {
        for (size_t a = 0; a < b; a++) {
            pairs->all[place_of(a, b)] = (struct pair){.a = a, .b = b};
        }
    }
    return pairs->all != NULL;
}

/* What is counted of a lesson: for each pair, and for each submission. */
struct counts {
    uint32_t *shared, *has;
};

/* Only owners of the same hash are paired: work is spent only on what is alike. */
static void count_owners(struct counts counts, const struct owners *owners) {
    for (size_t at = 0, next; at < owners->count; at = next) {
        next = owners_next(owners, at);
        for (size_t i = at; i < next; i++) {
            counts.has[owners->all[i].submission]++;
            for (size_t k = at; k < i; k++) {
                counts.shared[place_of(owners->all[k].submission, owners->all[i].submission)]++;
            }
        }
    }
}

static void add_to_pair(struct pair *pair, size_t lesson, struct common here) {
    if (here.of_a == 0 || here.of_b == 0) {
        return; /* one of them did not do it */
    }
    pair->all.shared += here.shared;
    pair->all.of_a += here.of_a;
    pair->all.of_b += here.of_b;
    pair->lesson_count++;
    if (common_share(here) > common_share(pair->most)) {
        pair->most = here;
        pair->most_lesson = lesson;
    }
}

static bool add_lesson(struct pairs *pairs, const struct class *class, size_t lesson) {
    struct owners owners = {0};
    struct counts counts = {calloc(pairs->count + 1, sizeof *counts.shared),
                            calloc(class->submission_count + 1, sizeof *counts.has)};
    bool done = counts.shared != NULL && counts.has != NULL && owners_find(&owners, class, lesson);
    if (done) {
        count_owners(counts, &owners);
    }
    for (size_t i = 0; i < pairs->count && done; i++) {
        struct pair *pair = &pairs->all[i];
        add_to_pair(pair, lesson,
                    (struct common){counts.shared[i], counts.has[pair->a], counts.has[pair->b]});
    }
    free(owners.all);
    free(counts.shared);
    free(counts.has);
    return done;
}

bool pairs_make(struct pairs *pairs, const struct class *class) {
    bool done = create(pairs, class->submission_count);
    for (size_t lesson = 0; lesson < class->lessons.count && done; lesson++) {
        done = add_lesson(pairs, class, lesson);
    }
    return done;
}

/* ---- Those that are listed ---- */

static bool is_alike(const struct pair *pair, struct limits limits) {
    if (pair->most.shared == 0 && pair->all.shared < SHARED_LEAST) {
        return false;
    }
    return common_share(pair->most) >= limits.lesson ||
           (pair->lesson_count > 1 && common_share(pair->all) >= limits.all);
}

/* Of equal shares the one with more in common comes first. */
static int compare_pairs(const void *a, const void *b) {
    const struct pair *first = a, *second = b;
    double left = common_share(first->all), right = common_share(second->all);
    if (left != right) {
        return left < right ? 1 : -1;
    }
    if (first->all.shared != second->all.shared) {
        return first->all.shared < second->all.shared ? 1 : -1;
    }
    size_t place = place_of(first->a, first->b), other = place_of(second->a, second->b);
    return (place > other) - (place < other);
}

bool pairs_find(struct pairs *pairs, const struct class *class, struct limits limits) {
    if (!pairs_make(pairs, class)) {
        return false;
    }
    size_t kept = 0;
    for (size_t i = 0; i < pairs->count; i++) {
        if (is_alike(&pairs->all[i], limits)) {
            pairs->all[kept++] = pairs->all[i];
        }
    }
    pairs->count = kept;
    qsort(pairs->all, pairs->count, sizeof *pairs->all, compare_pairs);
    return true;
}

void pairs_free(struct pairs *pairs) {
    free(pairs->all);
    *pairs = (struct pairs){0};
}
