/*
 * What a check has found, as text: for each step a line, and below it one for each item of it that
 * is not right to the last bit; while the step does not pass, for what passes, too.
 *
 *     step05_zbuffer  PASS 4/4 SCORE 10/10 exact
 *     step05_zbuffer  PASS 4/4 SCORE 10/10
 *       zbuffer PASS 4/4: 0.1 % differ (9 pixels), first at (41,30): yours 9,0,0, right 8,0,0
 *     step05_zbuffer  FAIL 2/4 SCORE 4/10
 *       zbuffer FAIL 0/4: 4.4 % of drawn pixels wrong (limit 0.25 %), first at ...
 *         looks like "depth cleared to 0": see step05_zbuffer/WRONG.md, figure 4; make hint ...
 *       zbuffer drawn again (halved) NOT JUDGED 0/1: its picture must pass before ...
 *       knot TODO 0/2: task 5.2 is to do
 *       tasks: 5.1 2/2, 5.2 FAIL 0/6, 5.3 2/2
 *     step05_zbuffer  CRASH 1/4 SCORE 2/10
 *       zbuffer CRASH 0/4: SIGSEGV, outside of an array, or a pointer to nothing
 *     step05_zbuffer  BUILD 0/4 SCORE 0/10: step05_zbuffer/main.c:12:5: error: ...
 *     step05_zbuffer  ERROR 3/4 SCORE 8/10
 *       depth ERROR 0/2: no reference: ...
 *
 * The figure is the row of the lesson's wrong pictures that the known mistake belongs to, where it
 * belongs to one. The hint's task is that of the known mistake, or else the first that may be to
 * blame. A task is not FAIL over a scene that it shares when another picture shows it right alone,
 * or when the scene looks like a mistake of another task that it shows or needs; and `perhaps FAIL`
 * where it is not known which of several is to blame, a task that the scene needs is not right
 * either, or the scene looks like a mistake of a task that it neither shows nor needs (result.h).
 *
 * A task that is written `waits for` another, which is to do and needed by all that shows it.
 *
 * The fraction in a step's line counts its pictures and counters; all others are points.
 */
#ifndef TESTS_CHECK_REPORT_H
#define TESTS_CHECK_REPORT_H

#include "result.h"

/* Print a step that is finished. */
void report_step(const struct step_result *step);

/* Print the end: the score, how many steps passed and failed, the difference images. False, with a
 * message, when something did not reach standard output. */
bool report_end(const struct check_result *result, struct error *error);

/* For a person at a terminal, print what is right in one line, the first task that is to do, and
 * how much is to come; at the end, what to do next. */
void report_step_to_person(const struct step_result *step);
bool report_end_to_person(const struct check_result *result, struct error *error);

/* Does nothing fail but what is still to do? */
bool report_is_unfinished(const struct check_result *result);

#endif
