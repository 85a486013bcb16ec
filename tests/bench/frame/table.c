/* The tables: see table.h. */
#include "table.h"

#include <math.h>
#include <stdio.h>

static void print_scene(const struct cell *cell) {
    char size[32];
    snprintf(size, sizeof size, "%zux%zu", cell->width, cell->height);
    printf("%-7s %-9s %9zu |", frame_look_name[cell->look], size, cell->faces);
}

/* How many times as fast as llvmpipe. */
static double ratio(const struct cell *cell) {
    return cell->sides[MESA].median / cell->sides[OURS].median;
}

/* ---- Times ---- */

void table_print_time_head(size_t threads, size_t frames) {
    printf(
        "\nBoth sides clear the whole image before each frame.\n"
        "\nMilliseconds a frame, %zu thread%s, the median of %zu (and how far apart the quartiles "
        "are);\nhow many times as fast as llvmpipe\n\n",
        threads, threads == 1 ? "" : "s", frames);
    printf("%-7s %-9s %9s | %-16s  %-16s %5s |\n", "look", "size", "triangles", "ours", "llvmpipe",
           "times");
}

static void print_summary(struct summary summary) {
    char range[16];
    snprintf(range, sizeof range, "(%.2f)", summary.range);
    printf(" %7.2f %8s ", summary.median, range);
}

void table_print_times(const struct table *table, const struct cell *cell) {
    print_scene(cell);
    print_summary(cell->sides[OURS]);
    if (table->has_mesa) {
        print_summary(cell->sides[MESA]);
        printf("%5.2f |\n", ratio(cell));
    } else {
        printf(" %16s %6s |\n", "-", "-");
    }
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
    print_deviation(&cell->deviations[OURS]);
    if (table->has_mesa) {
        print_deviation(&cell->deviations[MESA]);
    }
    printf("\n");
}

void table_print_errors(const struct table *table) {
    print_error_head();
    for (size_t i = 0; i < table->count; i++) {
        print_cell_errors(table, &table->cells[i]);
    }
}

/* ---- The least ---- */

void table_print_least(const struct table *table) {
    double least = INFINITY;
    for (size_t i = 0; i < table->count; i++) {
        least = fmin(least, ratio(&table->cells[i]));
    }
    if (table->has_mesa) {
        printf("\nat least %.2f times as fast as llvmpipe\n", least);
    }
}
