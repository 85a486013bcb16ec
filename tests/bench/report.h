/* The results of a benchmark as a table on the terminal and as JSON. */
#ifndef TESTS_BENCH_REPORT_H
#define TESTS_BENCH_REPORT_H

#include "measure.h"

/* Print a lesson's table to standard output. */
void report_print(const struct bench_lesson *lesson, const struct bench_results *results);

/* The JSON file, piece by piece: begin, each lesson (`first` for the first one), end. False when
 * memory runs out. */
bool report_begin(struct bytes *json, double seconds, struct error *error);
bool report_lesson(struct bytes *json, const struct bench_lesson *lesson,
                   const struct bench_results *results, bool first, struct error *error);
bool report_end(struct bytes *json, struct error *error);

/* Append to a text as printf does (at most 1023 characters at a time). False, with a message, when
 * memory runs out. */
bool report_append(struct bytes *text, struct error *error, const char *format, ...)
    PRINTF_LIKE(3, 4);

/* A text to which much is appended: after the first failure, which leaves its message, nothing more
 * is. */
struct output {
    struct bytes *text;
    struct error *error;
    bool done;
};

void report_put(struct output *output, const char *format, ...) PRINTF_LIKE(2, 3);

/* The series of the i-th version; NULL where it has none. */
const char *report_series(const struct bench_panel *panel, size_t i);

/* The compiler that compiled this program, and the processor as the system names it ("" where it
 * does not say). */
const char *report_compiler(void);
void report_processor(char name[128]);

#endif
