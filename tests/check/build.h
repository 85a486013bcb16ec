/*
 * Building what is checked, by make: a program that does not build is a finding, and the reason is
 * the line of the compiler's or make's output that a student needs first.
 */
#ifndef TESTS_CHECK_BUILD_H
#define TESTS_CHECK_BUILD_H

#include "drawn.h"
#include "file.h"
#include "options.h"

#include <stdbool.h>

/* Build what the steps stand on: the library, the models. False, with a message, when that
 * fails. */
bool build_given(const struct options *options, struct error *error);

/* Remove the step's old program and build it. `reason` says why it could not be built, or is empty;
 * `messages` becomes all that make and the compiler said, and the caller frees it, also on an
 * error. False, with a message, when the check itself cannot do that. */
bool build_step(const struct options *options, const char *step, struct message_line *reason,
                struct bytes *messages, struct error *error);

#endif
