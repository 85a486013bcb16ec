/*
 * Judging one step: its program built, run in an empty directory, and what it drew held against the
 * references.
 */
#ifndef TESTS_CHECK_JUDGE_H
#define TESTS_CHECK_JUDGE_H

#include "options.h"
#include "result.h"
#include "scenes.h"

/* Judge the step: `result` holds what was found, and is finished. When a signal has asked this
 * process to end (run.h), it means nothing. A step that the check cannot judge is ERROR. The names
 * in `result` are the table's. */
void judge_step(const struct options *options, const struct checked_step *step,
                struct step_result *result);

#endif
