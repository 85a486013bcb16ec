/*
 * What a check has found, as files for other programs and for people: JUnit XML, JSON, HTML.
 *
 * All are written from one result. FAIL is a failure; BUILD, CRASH, TIME and ERROR are errors; TODO
 * is skipped, with 0 points.
 */
#ifndef TESTS_CHECK_EXPORT_H
#define TESTS_CHECK_EXPORT_H

#include "result.h"

/* Append the report; false, with a message, when memory runs out or a picture cannot be read. */
typedef bool export_function(struct bytes *report, const struct check_result *result,
                             struct error *error);
export_function export_junit, export_json, export_html;

#endif
