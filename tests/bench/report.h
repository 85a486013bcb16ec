/* The results of a benchmark as a table on the terminal, and as JSON. */
#ifndef TESTS_BENCH_REPORT_H
#define TESTS_BENCH_REPORT_H

#include "measure.h"

#include <stdio.h>

/* Print a lesson's table to standard output. */
void report_print(const struct bench_lesson *lesson, const struct bench_results *results);

/* Write a lesson's results to `json`: an object on a line of its own for each version, with what
 * the table shows of it; a comma before it where it is not the first of the file. */
void report_add_json(const struct bench_lesson *lesson, const struct bench_results *results,
                     FILE *json);

#endif
