/* Tables: see report.h. */
#include "report.h"

#include <stdio.h>
#include <string.h>

const char *report_series(const struct bench_panel *panel, size_t i) {
    return panel->series != NULL ? panel->series(bench_choice(panel, i)) : NULL;
}

/* ---- The table ---- */

static void print_version(const struct bench_panel *panel, size_t i,
                          const struct bench_result *result) {
    char name[64];
    const char *series = report_series(panel, i);
    const double numbers[] = {result->error, result->median, result->lower, result->upper};
    snprintf(name, sizeof name, "%s%s%s", series != NULL ? series : "", series != NULL ? ", " : "",
             panel->versions[i].name);
    printf("  %c %-32s", result->front ? '*' : ' ', name);
    for (size_t k = 0; k < sizeof numbers / sizeof numbers[0]; k++) {
        char text[32];
        bench_show_number(numbers[k], text);
        printf(" %12s", text);
    }
    printf("\n");
}

static void print_panel(const struct bench_panel *panel, const struct bench_result *results) {
    printf("\n  %s\n  error: %s, against %s; time: %s, median and quartiles of %zu rounds\n",
           panel->title, panel->error_label, panel->against, panel->time_label, results[0].rounds);
    printf("    %-32s %12s %12s %12s %12s\n", "version", "error", "time", "lower", "upper");
    for (size_t i = 0; i < panel->version_count; i++) {
        print_version(panel, i, &results[i]);
    }
}

void report_print(const struct bench_lesson *lesson, const struct bench_results *results) {
    printf("\n%s (%s)\n", lesson->title, lesson->step);
    for (size_t i = 0; i < lesson->panel_count; i++) {
        print_panel(&lesson->panels[i], results->of[i]);
    }
    printf("\n  * useful: no other version is as good in both, and better in one\n");
    fflush(stdout);
}
