/* The results of a benchmark as a table on the terminal and as JSON. */
#ifndef TESTS_BENCH_REPORT_H
#define TESTS_BENCH_REPORT_H

#include "measure.h"

/* Print a lesson's table to standard output. */
void report_print(const struct bench_lesson *lesson, const struct bench_results *results);

/* A text to which much is appended: after the first failure, which leaves its message, nothing more
 * is. */
struct output {
    struct bytes *text;
    struct error *error;
    bool done;
};

/* Append as printf does, at most 1023 characters at a time. */
void report_put(struct output *output, const char *format, ...) PRINTF_LIKE(2, 3);

/* The JSON file, piece by piece: begin, each lesson (`first` for the first one), end. */
void report_begin(struct output *json, double seconds);
void report_lesson(struct output *json, const struct bench_lesson *lesson,
                   const struct bench_results *results, bool first);
void report_end(struct output *json);

/* The series of the i-th version; NULL where it has none. */
const char *report_series(const struct bench_panel *panel, size_t i);

/* The compiler that compiled this program, and the processor as the system names it ("" where it
 * does not say). */
const char *report_compiler(void);
void report_processor(char name[128]);

#endif
