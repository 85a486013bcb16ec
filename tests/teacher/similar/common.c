/* What is common knowledge in a class: see common.h. */
#include "common.h"

#include "owners.h"
#include "pairs.h"

#include <stdlib.h>

/* ---- Near copies have one voice ---- */

static void join_voices(size_t *voices, size_t count, size_t a, size_t b) {
    size_t kept = voices[a], gone = voices[b];
    for (size_t i = 0; i < count && kept != gone; i++) {
        voices[i] = voices[i] == gone ? kept : voices[i];
    }
}

static bool is_near(const struct pair *pair) {
    return pair->all.shared >= NEAR_LEAST && common_share(pair->all) * 100 >= NEAR_PERCENT;
}

/* For each submission the number of its voice, 0 up to the number of submissions; the caller frees
 * them. NULL when memory runs out. */
static size_t *find_voices(const struct class *class) {
    size_t count = class->submission_count;
    struct pairs pairs;
    bool done = pairs_make(&pairs, class);
    size_t *voices = done ? calloc(count + 1, sizeof *voices) : NULL;
    for (size_t i = 0; i < count && voices != NULL; i++) {
        voices[i] = i;
    }
    for (size_t i = 0; i < pairs.count && voices != NULL; i++) {
        if (is_near(&pairs.all[i])) {
            join_voices(voices, count, pairs.all[i].a, pairs.all[i].b);
        }
    }
    pairs_free(&pairs);
    return voices;
}

/* ---- Who knows what ---- */

/* Voices are counted once in each round. */
struct count {
    const size_t *voices;
    size_t *heard; /* the last round in which a voice was counted */
    size_t round;
};

static void begin_round(struct count *count) {
    count->round++;
}

/* 1 for a voice that was not counted in this round. */
static size_t hear(struct count *count, size_t submission) {
    size_t *heard = &count->heard[count->voices[submission]];
    bool first = *heard != count->round;
    *heard = count->round;
    return first;
}

/* Of those who did the lesson. */
static size_t count_done(struct count *count, const struct class *class, size_t lesson) {
    size_t done = 0;
    begin_round(count);
    for (size_t i = 0; i < class->submission_count; i++) {
        done += class->submissions[i].lessons[lesson].count > 0 ? hear(count, i) : 0;
    }
    return done;
}

/* Of those who have the hash of the owners from `at` up to `next`. */
static size_t count_owners(struct count *count, const struct owners *owners, size_t at,
                           size_t next) {
    size_t have = 0;
    begin_round(count);
    for (size_t i = at; i < next; i++) {
        have += hear(count, owners->all[i].submission);
    }
    return have;
}

/* Add to `common`, in rising order, what is common knowledge in the lesson. */
static bool find_common(struct set *common, const struct class *class, size_t lesson,
                        struct count *count) {
    struct owners owners;
    if (!owners_find(&owners, class, lesson)) {
        return false;
    }
    size_t part = count_done(count, class, lesson) / COMMON_PART;
    size_t limit = part > COMMON_LEAST ? part : COMMON_LEAST;
    bool done = true;
    for (size_t at = 0, next; at < owners.count && done; at = next) {
        next = owners_next(&owners, at);
        done =
            count_owners(count, &owners, at, next) <= limit || set_add(common, owners.all[at].hash);
    }
    free(owners.all);
    return done;
}

/* ---- What is taken out ---- */

static void forget(struct fingerprints *prints, const struct set *common) {
    size_t kept = 0;
    for (size_t i = 0; i < prints->count; i++) {
        if (!set_has(common, prints->all[i].hash)) {
            prints->all[kept++] = prints->all[i];
        }
    }
    prints->count = kept;
}

static bool forget_lesson(struct class *class, size_t lesson, struct count *count) {
    struct set common = {0};
    bool done = find_common(&common, class, lesson, count);
    for (size_t i = 0; i < class->submission_count && done; i++) {
        forget(&class->submissions[i].lessons[lesson], &common);
    }
    set_free(&common);
    return done;
}

bool common_forget(struct class *class) {
    size_t *voices = find_voices(class);
    size_t *heard = calloc(class->submission_count + 1, sizeof *heard);
    struct count count = {voices, heard, 0};
    bool done = voices != NULL && heard != NULL;
    for (size_t lesson = 0; lesson < class->lessons.count && done; lesson++) {
        done = forget_lesson(class, lesson, &count);
    }
    free(voices);
    free(heard);
    return done;
}
