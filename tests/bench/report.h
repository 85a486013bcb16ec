/* The results of a benchmark as a table on the terminal. */
#ifndef TESTS_BENCH_REPORT_H
#define TESTS_BENCH_REPORT_H

#include "measure.h"

/* Print a lesson's table to standard output. */
void report_print(const struct bench_lesson *lesson, const struct bench_results *results);

/* The series of the i-th version; NULL where it has none. */
const char *report_series(const struct bench_panel *panel, size_t i);

#endif
