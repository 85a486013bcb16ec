/* The tables that bench-frame prints: times and errors. */
#ifndef TESTS_BENCH_FRAME_TABLE_H
#define TESTS_BENCH_FRAME_TABLE_H

#include "exact.h"

/* Those who draw, in the order of the tables. */
enum side { OURS, MESA, SIDES };

struct summary {
    double median; /* milliseconds */
    double range;  /* from the first quartile to the third */
};

/* What was measured of one scene. */
struct cell {
    enum frame_look look;
    size_t width, height, faces;
    size_t visible; /* pixels that show a face */
    struct summary sides[SIDES];
    struct deviation deviations[SIDES];
};

enum { CELLS_LIMIT = 27 };

struct table {
    struct cell cells[CELLS_LIMIT];
    size_t count;
    bool has_mesa;
};

void table_print_time_head(size_t threads, size_t frames);
void table_print_times(const struct table *table, const struct cell *cell);
void table_print_errors(const struct table *table);

/* How many times as fast as llvmpipe where it is the least. */
void table_print_least(const struct table *table);

#endif
