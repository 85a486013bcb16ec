/* The results of a benchmark as a table on the terminal, and as JSON. */
#ifndef TESTS_BENCH_REPORT_H
#define TESTS_BENCH_REPORT_H

#include "measure.h"

/* Print a lesson's table to standard output. */
void report_print(const struct bench_lesson *lesson, const struct bench_results *results);

/* Append a lesson's results to `json`: an object on a line of its own for each version, with what
 * the table shows of it; a comma before it where it is not the first in `json`. */
bool report_add_json(const struct bench_lesson *lesson, const struct bench_results *results,
                     struct bytes *json, struct error *error);

/* The series of the i-th version; NULL where it has none. */
const char *report_series(const struct bench_panel *panel, size_t i);

#endif
