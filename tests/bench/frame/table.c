/* The tables: see table.h. */
#include "table.h"

#include <math.h>
#include <stdio.h>

static void print_scene(const struct cell *cell) {
    char size[32];
    snprintf(size, sizeof size, "%zux%zu", cell->width, cell->height);
    printf("%-7s %-9s %9zu |", frame_look_name[cell->look], size, cell->faces);
}

/* How many times as fast as llvmpipe; 0 without it. */
static double ratio(const struct table *table, const struct cell *cell, enum side ours) {
    enum side mesa = ours == OURS_1 ? MESA_1 : MESA_2;
    return table->has_mesa ? cell->sides[mesa].typical / cell->sides[ours].typical : 0;
}

static double gain(const struct cell *cell, enum side one) {
    return cell->sides[one].typical / cell->sides[one + 1].typical;
}

/* ---- Times ---- */

void table_print_time_head(const struct options *options) {
    printf("\nBefore a frame this course clears %s; llvmpipe clears all.\n",
           options->clearing == CLEAR_ALL ? "all" : "what its last frame has drawn");
    printf("\nMilliseconds a frame, the %s of %zu (and how far apart the quartiles are); how many\n"
           "times as fast as llvmpipe; how many times as fast with two threads as with one\n\n",
           options->least ? "least" : "median", options->frames);
    printf("%27s | %-40s | %-40s | %-12s |\n", "", "one thread", "two threads", "two to one");
    printf("%-7s %-9s %9s |", "look", "size", "triangles");
    for (int i = 0; i < 2; i++) {
        printf(" %-16s  %-16s %5s |", "ours", "llvmpipe", "times");
    }
    printf(" %5s %6s | %6s\n", "ours", "llvmp.", "memset");
}

static void print_summary(struct summary summary) {
    char range[16];
    snprintf(range, sizeof range, "(%.2f)", summary.range);
    printf(" %7.2f %8s ", summary.typical, range);
}

static void print_pair(const struct table *table, const struct cell *cell, enum side ours) {
    print_summary(cell->sides[ours]);
    if (table->has_mesa) {
        print_summary(cell->sides[ours == OURS_1 ? MESA_1 : MESA_2]);
        printf("%5.2f |", ratio(table, cell, ours));
    } else {
        printf(" %16s %6s |", "-", "-");
    }
}

void table_print_times(const struct table *table, const struct cell *cell) {
    print_scene(cell);
    print_pair(table, cell, OURS_1);
    print_pair(table, cell, OURS_2);
    printf(" %5.2f ", gain(cell, OURS_1));
    if (table->has_mesa) {
        printf("%6.2f", gain(cell, MESA_1));
    } else {
        printf("%6s", "-");
    }
    printf(" | %6.2f\n", cell->fill.typical);
    fflush(stdout);
}

/* ---- Errors ---- */

static void print_error_head(void) {
    printf(
        "\nAgainst the exact answer, in long double. `outline`: pixels drawn that should not be, "
        "or the\nother way round. Of the other pixels, `of 1000`: with a level that is not the "
        "nearest; `beyond`:\nthe largest distance of a level, less the 0.5 of rounding; `mean`: "
        "distance from the nearest level\n\n");
    printf("%27s | %8s | %-33s | %-33s |\n", "", "visible", "ours", "llvmpipe");
    printf("%-7s %-9s %9s | %8s |", "look", "size", "triangles", "pixels");
    for (int i = 0; i < 2; i++) {
        printf(" %7s %9s %7s %7s |", "outline", "of 1000", "beyond", "mean");
    }
    printf("\n");
}

/* Pixels of 1,000. */
static double rounded_share(const struct deviation *d) {
    return 1e3 * (double)d->rounded / fmax((double)d->compared, 1);
}

static void print_deviation(const struct deviation *d) {
    printf(" %7zu %9.3f %7.3f %7.4f |", d->outline, rounded_share(d), d->beyond, d->mean);
}

static void print_cell_errors(const struct table *table, const struct cell *cell) {
    print_scene(cell);
    printf(" %8zu |", cell->visible);
    print_deviation(&cell->deviations[OURS_1]);
    if (table->has_mesa) {
        print_deviation(&cell->deviations[MESA_1]);
    }
    printf("%s%s\n", cell->same[0] ? "" : " OURS DIFFERS WITH TWO THREADS",
           cell->same[1] ? "" : " llvmpipe differs with two threads");
}

void table_print_errors(const struct table *table) {
    print_error_head();
    for (size_t i = 0; i < table->count; i++) {
        print_cell_errors(table, &table->cells[i]);
    }
}

/* ---- Goals ---- */

static void print_ratios(const struct table *table, enum side ours, const char *threads) {
    size_t three = 0, two = 0;
    double least = INFINITY;
    for (size_t i = 0; i < table->count; i++) {
        double times = ratio(table, &table->cells[i], ours);
        three += times >= 3;
        two += times >= 2;
        least = fmin(least, times);
    }
    printf("  3 times as fast as llvmpipe, %s: %zu of %zu; 2 times: %zu; least %.2f\n", threads,
           three, table->count, two, least);
}

static void print_gains(const struct table *table) {
    size_t met = 0;
    double least = INFINITY;
    for (size_t i = 0; i < table->count; i++) {
        met += gain(&table->cells[i], OURS_1) >= 1.7;
        least = fmin(least, gain(&table->cells[i], OURS_1));
    }
    printf("  two threads 1.7 times as fast as one: %zu of %zu; least %.2f\n", met, table->count,
           least);
}

static void print_fills(const struct table *table) {
    size_t met = 0, flat = 0;
    double most = 0;
    for (size_t i = 0; i < table->count; i++) {
        const struct cell *cell = &table->cells[i];
        double fills = cell->sides[OURS_1].typical / cell->fill.typical;
        if (cell->look == FRAME_FLAT) {
            flat++;
            met += fills <= 3;
            most = fmax(most, fills);
        }
    }
    printf("  flat within 3 times the memset, one thread: %zu of %zu; most %.1f\n", met, flat,
           most);
}

static void print_accuracy(const struct table *table) {
    size_t met = 0;
    double rounded = 0, beyond = 0;
    for (size_t i = 0; i < table->count; i++) {
        const struct deviation *d = &table->cells[i].deviations[OURS_1];
        met += d->outline == 0 && rounded_share(d) <= 1 && d->beyond <= 0.05;
        rounded = fmax(rounded, rounded_share(d));
        beyond = fmax(beyond, d->beyond);
    }
    printf("  outline exact, 1 pixel of 1000 rounded otherwise, 0.05 level: %zu of %zu; most "
           "%.3f and %.3f\n",
           met, table->count, rounded, beyond);
}

void table_print_goals(const struct table *table) {
    printf("\nGoals, in how many scenes they are met\n");
    if (table->has_mesa) {
        print_ratios(table, OURS_1, "one thread");
        print_ratios(table, OURS_2, "two threads");
    }
    print_gains(table);
    print_fills(table);
    print_accuracy(table);
}
