/*
 * Building what is checked, by make: a program that does not build is a finding, and the reason is
 * the line of the compiler's or make's output that a student needs first.
 */
#ifndef TESTS_CHECK_BUILD_H
#define TESTS_CHECK_BUILD_H

#include "base/bytes.h"
#include "base/error.h"
#include "drawn.h"
#include "options.h"

#include <stdbool.h>

/* Two checks in one directory would remove each other's programs: the second waits here, and says
 * so. The lock is the system's, and goes when this process does, however it ends. False, with a
 * message, when the directory cannot be written. */
bool build_lock(const struct options *options, struct error *error);

/* How a step was built. */
struct build_result {
    struct message_line reason;  /* why it could not be; or empty */
    bool stopped;                /* for its time or memory: main.c may be right */
    struct message_line warning; /* the first line in which the compiler warns; or empty */
    size_t more_warnings;
    struct bytes messages; /* everything make and the compiler said */
};

/* Build the step's program. Only when the program that is there is, byte for byte, what make has
 * built without a warning (its copy in DIR/built), make decides whether it must be built again:
 * every other one is removed first. Where the step `has_numbers`, to call its functions with, make
 * also tries to build the program that does so, numbers/STEP, at the same time and silently. The
 * caller frees result->messages, also on an error. False, with a message, when the check itself
 * cannot do that. */
bool build_step(const struct options *options, const char *step, bool has_numbers,
                struct build_result *result, struct error *error);

/* After that: build the program of that name, numbers/STEP, where make has not; why it could not be
 * is said now. */
bool build_numbers(const struct options *options, const char *name, struct build_result *result,
                   struct error *error);

#endif
