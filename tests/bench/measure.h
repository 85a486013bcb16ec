/*
 * Measuring: every version of a panel takes its turn, round after round, so that whatever disturbs
 * the machine disturbs all of them alike; then medians and quartiles of the rounds.
 */
#ifndef TESTS_BENCH_MEASURE_H
#define TESTS_BENCH_MEASURE_H

#include "bench.h"

struct bench_result {
    double error;         /* in the panel's unit; 0 is exact */
    double median;        /* time in the panel's unit */
    double lower, upper;  /* quartiles */
    size_t rounds, calls; /* samples taken, and runs in each of them */
    bool front;           /* useful: no other version is as good in both and better in one */
};

/* All of one lesson. */
struct bench_results {
    struct bench_result of[BENCH_PANEL_LIMIT][BENCH_VERSION_LIMIT];
};

/* Set up a lesson and measure all its panels in about `seconds` (a little more where the errors are
 * slow to compute). */
bool bench_measure(const struct bench_lesson *lesson, double seconds, struct bench_results *results,
                   struct error *error);

/* "16" for milliseconds or nanoseconds: three significant digits, no exponent; `text` has room for
 * 32 characters. */
void bench_show_number(double value, char text[32]);

#endif
