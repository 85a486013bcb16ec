/* Who has a fingerprint: see owners.h. */
#include "owners.h"

#include <stdlib.h>

static int compare_owners(const void *a, const void *b) {
    const struct owner *first = a, *second = b;
    if (first->hash != second->hash) {
        return first->hash > second->hash ? 1 : -1;
    }
    return (first->submission > second->submission) - (first->submission < second->submission);
}

bool owners_find(struct owners *owners, const struct class *class, size_t lesson) {
    size_t most = 0;
    for (size_t i = 0; i < class->submission_count; i++) {
        most += class->submissions[i].lessons[lesson].count;
    }
    *owners = (struct owners){calloc(most + 1, sizeof *owners->all), 0};
    if (owners->all == NULL) {
        return false;
    }
    for (size_t i = 0; i < class->submission_count; i++) {
        const struct fingerprints *prints = &class->submissions[i].lessons[lesson];
        for (size_t at = 0; at < prints->count; at = fingerprints_next(prints, at)) {
            owners->all[owners->count++] = (struct owner){prints->all[at].hash, i};
        }
    }
    qsort(owners->all, owners->count, sizeof *owners->all, compare_owners);
    return true;
}

size_t owners_next(const struct owners *owners, size_t at) {
    size_t next = at + 1;
    while (next < owners->count && owners->all[next].hash == owners->all[at].hash) {
        next++;
    }
    return next;
}
