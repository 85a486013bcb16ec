/* Tables and JSON: see report.h. */
#include "report.h"

#include <assert.h>
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

/* ---- JSON ---- */

/* "key": "value", with nothing in the value that JSON would want escaped. */
static void show_string(const char *key, const char *value, char text[256]) {
    assert(value == NULL || strpbrk(value, "\"\\\n") == NULL);
    snprintf(text, 256, value != NULL ? "\"%s\": \"%s\"" : "\"%s\": null", key, value);
}

static bool add_version(const char *step, const struct bench_panel *panel, size_t i,
                        const struct bench_result *result, struct bytes *json) {
    enum { KEYS = 7 };
    static const char *const keys[KEYS] = {"step",       "panel",   "series",   "version",
                                           "error_unit", "against", "time_unit"};
    const char *values[KEYS] = {step,
                                panel->title,
                                report_series(panel, i),
                                panel->versions[i].name,
                                panel->error_label,
                                panel->against,
                                panel->time_label};
    char text[KEYS * 256 + 256];
    size_t length = 0;
    for (int k = 0; k < KEYS; k++) {
        char pair[256];
        show_string(keys[k], values[k], pair);
        const char *before = k > 0 ? ", " : json->size > 0 ? ",\n{" : "{";
        length += (size_t)snprintf(text + length, sizeof text - length, "%s%s", before, pair);
    }
    length += (size_t)snprintf(text + length, sizeof text - length,
                               ", \"error\": %.9g, \"median\": %.9g, \"lower\": %.9g, "
                               "\"upper\": %.9g, \"useful\": %s}",
                               result->error, result->median, result->lower, result->upper,
                               result->front ? "true" : "false");
    return bytes_append(json, text, length);
}

bool report_add_json(const struct bench_lesson *lesson, const struct bench_results *results,
                     struct bytes *json, struct error *error) {
    for (size_t p = 0; p < lesson->panel_count; p++) {
        for (size_t i = 0; i < lesson->panels[p].version_count; i++) {
            if (!add_version(lesson->step, &lesson->panels[p], i, &results->of[p][i], json)) {
                return error_out_of_memory(error);
            }
        }
    }
    return true;
}
