/*
 * What a check has found, as files for other programs and for people: JUnit XML, JSON, TAP, CSV,
 * HTML.
 *
 * All are written from one result. FAIL is a failure; BUILD, CRASH, TIME and ERROR are errors; TODO
 * is skipped, with 0 points.
 */
#ifndef TESTS_CHECK_EXPORT_H
#define TESTS_CHECK_EXPORT_H

#include "result.h"

/* Append the report; false, with a message, when memory runs out or a picture cannot be read.
 * `references` is the directory of the reference images; only HTML looks there. */
bool export_junit(struct bytes *report, const struct check_result *result, const char *references,
                  struct error *error);
bool export_json(struct bytes *report, const struct check_result *result, const char *references,
                 struct error *error);
bool export_tap(struct bytes *report, const struct check_result *result, const char *references,
                struct error *error);
bool export_html(struct bytes *report, const struct check_result *result, const char *references,
                 struct error *error);

/* A line a task: step,task,state,points,most; and a first line that says so. */
bool export_csv(struct bytes *report, const struct check_result *result, const char *references,
                struct error *error);

#endif
