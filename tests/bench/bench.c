/*
 * Run time against error, for all lessons: `make bench`, or
 *
 *     benchmark [STEP...]
 *
 * measures the lessons whose names contain one of the STEPs (all without one), prints a table, and
 * writes build/bench/all.json and a chart for each lesson, build/bench/stepNN_name.svg. Each lesson
 * takes about 10 seconds; the environment variable BENCH_SECONDS gives another number.
 */
#include "bench.h"

#include "chart.h"
#include "measure.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
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

static void print_table(const struct bench_lesson *lesson, const struct bench_results *results) {
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

/* A line for each version, with what the table shows of it. */
static void add_json(const struct bench_lesson *lesson, const struct bench_results *results,
                     FILE *json) {
    for (size_t p = 0; p < lesson->panel_count; p++) {
        for (size_t i = 0; i < lesson->panels[p].version_count; i++) {
            put_version(json, lesson->step, &lesson->panels[p], i, &results->of[p][i]);
        }
    }
}

/* ---- Files ---- */

/* Open bench/NAME.ENDING, which output_close() closes. NULL, with a message, if that fails. */
static FILE *output_open(const char *name, const char *ending, struct error *error) {
    char path[1024];
    FILE *file = NULL;
    int length = snprintf(path, sizeof path, "%s/bench/%s.%s", COURSE_BUILD, name, ending);
    if (length >= (int)sizeof path || (file = fopen(path, "w")) == NULL) {
        error_set(error, "cannot open %s/bench/%s.%s for writing", COURSE_BUILD, name, ending);
    }
    return file;
}

static bool output_close(FILE *file, struct error *error) {
    bool written = ferror(file) == 0;
    written = fclose(file) == 0 && written;
    return written || error_set(error, "cannot write a chart or all.json");
}

static bool save_chart(const struct bench_lesson *lesson, const struct bench_results *results,
                       struct error *error) {
    FILE *svg = output_open(lesson->step, "svg", error);
    if (svg != NULL) {
        chart_draw(lesson, results, svg);
    }
    return svg != NULL && output_close(svg, error);
}

/* ---- Lessons ---- */

/* Beside a wrong picture each time would look right. */
static bool check_errors(const struct bench_lesson *lesson, const struct bench_results *results,
                         struct error *error) {
    for (size_t p = 0; p < lesson->panel_count; p++) {
        const struct bench_panel *panel = &lesson->panels[p];
        for (size_t i = 0; i < panel->version_count; i++) {
            const struct bench_version *version = &panel->versions[i];
            double found = results->of[p][i].error, within = DBL_MAX;
            if (version->is_house && panel->house_within > 0) {
                within = panel->house_within;
            }
            if (!(found <= within)) {
                return error_set(error, "%s: \"%s\" has an error of %g, and may have %g",
                                 lesson->title, version->name, found, within);
            }
        }
    }
    return true;
}

static bool measure_lesson(const struct bench_lesson *lesson, double seconds, FILE *json,
                           struct error *error) {
    struct bench_results results = {0};
    if (!bench_measure(lesson, seconds, &results, error) ||
        !check_errors(lesson, &results, error) || !save_chart(lesson, &results, error)) {
        return false;
    }
    add_json(lesson, &results, json);
    print_table(lesson, &results);
    return true;
}

/* Is it one of the steps, which end with NULL? All are where there are none. */
static bool is_wanted(const struct bench_lesson *lesson, char *const *steps) {
    bool wanted = *steps == NULL;
    for (; *steps != NULL; steps++) {
        wanted = wanted || strstr(lesson->step, *steps) != NULL;
    }
    return wanted;
}

static bool measure_lessons(char *const *steps, double seconds, struct error *error) {
    FILE *json = output_open("all", "json", error);
    bool done = json != NULL, any = false;
    if (!done) {
        return false;
    }
    fputs("[", json);
    for (size_t i = 0; done && bench_lessons[i] != NULL; i++) {
        if (is_wanted(bench_lessons[i], steps)) {
            any = true;
            done = measure_lesson(bench_lessons[i], seconds, json, error);
        }
    }
    fputs("]\n", json);
    done = done && (any || error_set(error, "no tests/lessons/stepNN_name/bench.c measures a step "
                                            "of that name"));
    bool saved = output_close(json, error) && done;
    if (!saved) {
        remove(COURSE_BUILD "/bench/all.json");
    }
    return saved;
}

int main(int argc, char **argv) {
    const char *text = getenv("BENCH_SECONDS");
    double seconds = text != NULL && *text != '\0' ? strtod(text, NULL) : 10;
    struct error error;
    if ((argc > 1 && argv[1][0] == '-') || !(seconds > 0 && seconds <= 3600)) {
        fprintf(stderr, "usage: [BENCH_SECONDS=10] benchmark [STEP...]\n");
        return 2;
    }
    if (!measure_lessons(argv + 1, seconds, &error)) {
        fprintf(stderr, "benchmark: %s\n", error.message);
        return 1;
    }
    return 0;
}
