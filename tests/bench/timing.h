/* Time and its statistics, for everything that is measured. Needs clock_gettime() of POSIX. */
#ifndef TESTS_BENCH_TIMING_H
#define TESTS_BENCH_TIMING_H

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <time.h>

static inline double clock_seconds(clockid_t clock) {
    struct timespec t;
    clock_gettime(clock, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* The clock on the wall. */
static inline double now(void) {
    return clock_seconds(CLOCK_MONOTONIC);
}

/* For work that takes turns with other programs. */
struct stopwatch {
    double wall, processor;
};

static inline struct stopwatch stopwatch_start(void) {
    return (struct stopwatch){now(), clock_seconds(CLOCK_PROCESS_CPUTIME_ID)};
}

/* Seconds since the start. While another program has the processor, the clock on the wall goes on
 * and the processor time does not; while several threads run, processor time goes faster. The
 * smaller of the two is the time that the work took. */
static inline double stopwatch_seconds(struct stopwatch start) {
    double processor = clock_seconds(CLOCK_PROCESS_CPUTIME_ID) - start.processor;
    return fmin(now() - start.wall, processor);
}

static inline int compare_doubles(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static inline void sort_doubles(double *values, size_t count) {
    qsort(values, count, sizeof *values, compare_doubles);
}

/* The value below which `share` of the sorted samples lie, linear between neighbours. */
static inline double quantile(const double *sorted, size_t count, double share) {
    double place = share * (double)(count - 1);
    size_t i = (size_t)place;
    double next = sorted[i + 1 < count ? i + 1 : i];
    return sorted[i] + (next - sorted[i]) * (place - (double)i);
}

#endif
