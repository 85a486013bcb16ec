/* A lesson's program that answers requests with frames (common/run/live.h), started when it is
 * needed, and ended when it takes too long. */
#ifndef TESTS_STUDENT_LIVE_CHILD_H
#define TESTS_STUDENT_LIVE_CHILD_H

#include "base/bytes.h"
#include "base/error.h"

#include <stdbool.h>
#include <sys/types.h>

struct child {
    pid_t id;                  /* 0: not started */
    int input, output, errors; /* ends of pipes: to it, and from it */
    struct bytes pending;      /* read from it, and no answer yet */
    struct bytes said;         /* what it has printed itself, since it was started; then a NUL */
};

/* Start PROGRAM --live [MODEL]. Its first line, the description, is appended to `description`. */
bool child_start(struct child *child, const char *program, const char *model,
                 struct bytes *description, struct error *error);

/* Send a request, and append the whole answer. False, with a message, where the program crashes,
 * ends, takes longer than that (of a processor) or too much memory: then it is ended. */
bool child_ask(struct child *child, const struct bytes *request, double seconds,
               struct bytes *answer, struct error *error);

/* End it, whatever it does. What it has said stays. */
void child_end(struct child *child);

#endif
