/*
 * What a student's functions give for the numbers of tests/lessons/STEP/numbers.c: see
 * tests/numbers.h, which says what its program writes.
 */
#ifndef TESTS_CHECK_NUMBERS_H
#define TESTS_CHECK_NUMBERS_H

#include "base/error.h"
#include "options.h"
#include "result.h"
#include "scenes.h"

#include <stdbool.h>

/* Build the program, let it call the functions, and judge the step's items of kind ITEM_NUMBERS:
 * their state and the first call that is wrong. Tasks that are to do in `source`, the text of
 * main.c, are not called. A program that cannot be built fails them all; false, with a message, is
 * for what the check itself cannot do. */
bool numbers_judge(const struct options *options, const struct checked_step *step,
                   const char *source, struct step_result *result, struct error *error);

#endif
