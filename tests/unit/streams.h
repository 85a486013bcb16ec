/* Standard input, output and error of a test, led elsewhere for a while. */
#ifndef TESTS_UNIT_STREAMS_H
#define TESTS_UNIT_STREAMS_H

#include "unit/unit.h"

#include <unistd.h>

struct streams {
    int kept[3];
};

/* To these files; -1: that stream stays. */
static inline struct streams streams_lead(int in, int out, int error) {
    const int files[3] = {in, out, error};
    struct streams streams;
    fflush(stdout);
    fflush(stderr);
    for (int i = 0; i < 3; i++) {
        streams.kept[i] = dup(i);
        CHECK(streams.kept[i] >= 0 && (files[i] < 0 || dup2(files[i], i) == i));
    }
    return streams;
}

static inline void streams_restore(const struct streams *streams) {
    fflush(stdout);
    fflush(stderr);
    for (int i = 0; i < 3; i++) {
        dup2(streams->kept[i], i);
        close(streams->kept[i]);
    }
}

#endif
