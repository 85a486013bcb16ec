/*
 * Why a step that was judged is not right: what is still to do, what a task waits for, and which of
 * the known mistakes it was. A picture is known by its looks (looks.h), work by its counts
 * (counters.h); what else is known of the program may speak against a mistake (doubt.h). Private to
 * the judge.
 */
#ifndef TESTS_CHECK_DIAGNOSE_H
#define TESTS_CHECK_DIAGNOSE_H

#include "judging.h"

/* What failed for want of a task that main.c has as the starter becomes TODO. */
void diagnose_to_do(const struct judging *judging);

/* Say which mistakes the failed items look like. Draws again where work is counted wrongly. False
 * for what the check itself cannot do. */
bool diagnose_mistakes(const struct judging *judging, struct error *error);

/* When the result is finished: what written tasks wait for, and which right ones are still marked
 * as to do. */
void diagnose_waiting(const struct judging *judging);

#endif
