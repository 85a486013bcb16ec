/* Tables and JSON: see report.h. */
#include "report.h"

#include <assert.h>
#include <string.h>

/* ---- The table ---- */

static void print_version(const struct bench_panel *panel, size_t i,
                          const struct bench_result *result) {
    char name[64];
    const char *series = panel->versions[i].series;
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
static void put_string(FILE *json, const char *key, const char *value) {
    assert(value == NULL || strpbrk(value, "\"\\\n") == NULL);
    const char *quote = value != NULL ? "\"" : "";
    fprintf(json, "\"%s\": %s%s%s, ", key, quote, value != NULL ? value : "null", quote);
}

static void put_version(FILE *json, const char *step, const struct bench_panel *panel, size_t i,
                        const struct bench_result *result) {
    fputs(ftell(json) > 1 ? ",\n{" : "{", json);
    put_string(json, "step", step);
    put_string(json, "panel", panel->title);
    put_string(json, "series", panel->versions[i].series);
    put_string(json, "version", panel->versions[i].name);
    put_string(json, "error_unit", panel->error_label);
    put_string(json, "against", panel->against);
    put_string(json, "time_unit", panel->time_label);
    fprintf(json,
            "\"error\": %.9g, \"median\": %.9g, \"lower\": %.9g, \"upper\": %.9g, \"useful\": %s}",
            result->error, result->median, result->lower, result->upper,
            result->front ? "true" : "false");
}

void report_add_json(const struct bench_lesson *lesson, const struct bench_results *results,
                     FILE *json) {
    for (size_t p = 0; p < lesson->panel_count; p++) {
        for (size_t i = 0; i < lesson->panels[p].version_count; i++) {
            put_version(json, lesson->step, &lesson->panels[p], i, &results->of[p][i]);
        }
    }
}
