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
    return table->has_mesa ? cell->sides[mesa].median / cell->sides[ours].median : 0;
}

static double gain(const struct cell *cell, enum side one) {
    return cell->sides[one].median / cell->sides[one + 1].median;
}

/* ---- Times ---- */

void table_print_time_head(const struct options *options) {
    printf("\nBefore a frame this course clears %s; llvmpipe clears all.\n",
           options->clearing == CLEAR_ALL ? "all" : "what its last frame has drawn");
    printf("\nMilliseconds a frame, the median of %zu (and how far apart the quartiles are); how "
           "many\n"
           "times as fast as llvmpipe; how many times as fast with two threads as with one\n\n",
           options->frames);
    printf("%27s | %-40s | %-40s | %-12s |\n", "", "one thread", "two threads", "two to one");
    printf("%-7s %-9s %9s |", "look", "size", "triangles");
    for (int i = 0; i < 2; i++) {
        printf(" %-16s  %-16s %5s |", "ours", "llvmpipe", "times");
    }
    printf(" %5s %6s |\n", "ours", "llvmp.");
}

static void print_summary(struct summary summary) {
    char range[16];
    snprintf(range, sizeof range, "(%.2f)", summary.range);
    printf(" %7.2f %8s ", summary.median, range);
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
    printf(" |\n");
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

/* ---- The least ---- */

static void print_least(const struct table *table, enum side ours, const char *threads) {
    double least = INFINITY;
    for (size_t i = 0; i < table->count; i++) {
        least = fmin(least, ratio(table, &table->cells[i], ours));
    }
    printf("%s: at least %.2f times as fast as llvmpipe\n", threads, least);
}

void table_print_least(const struct table *table) {
    if (table->has_mesa) {
        printf("\n");
        print_least(table, OURS_1, "one thread");
        print_least(table, OURS_2, "two threads");
    }
}
