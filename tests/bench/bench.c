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
#include "report.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SECONDS_DEFAULT = 10 };

struct options {
    double seconds;
    char **steps;
    int step_count;
};

static bool read_seconds(double *seconds, struct error *error) {
    const char *text = getenv("BENCH_SECONDS");
    if (text == NULL || *text == '\0') {
        *seconds = SECONDS_DEFAULT;
        return true;
    }
    char *end;
    *seconds = strtod(text, &end);
    if (*end != '\0' || !(*seconds > 0 && *seconds <= 3600)) {
        return error_set(error, "BENCH_SECONDS=%s is not a number of seconds in 0..3600", text);
    }
    return true;
}

static bool is_wanted(const struct bench_lesson *lesson, const struct options *options) {
    for (int i = 0; i < options->step_count; i++) {
        if (strstr(lesson->step, options->steps[i]) != NULL) {
            return true;
        }
    }
    return options->step_count == 0;
}

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

static bool measure_lesson(const struct bench_lesson *lesson, const struct options *options,
                           FILE *json, struct error *error) {
    struct bench_results results = {0};
    if (!bench_measure(lesson, options->seconds, &results, error) ||
        !check_errors(lesson, &results, error) || !save_chart(lesson, &results, error)) {
        return false;
    }
    report_add_json(lesson, &results, json);
    report_print(lesson, &results);
    return true;
}

static bool measure_lessons(const struct options *options, struct error *error) {
    FILE *json = output_open("all", "json", error);
    bool done = json != NULL, any = false;
    if (!done) {
        return false;
    }
    fputs("[", json);
    for (size_t i = 0; done && bench_lessons[i] != NULL; i++) {
        if (is_wanted(bench_lessons[i], options)) {
            any = true;
            done = measure_lesson(bench_lessons[i], options, json, error);
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
    struct options options = {.steps = argv + 1, .step_count = argc - 1};
    struct error error;
    if (argc > 1 && argv[1][0] == '-') {
        fprintf(stderr, "usage: benchmark [STEP...]\n");
        return 2;
    }
    if (!read_seconds(&options.seconds, &error)) {
        fprintf(stderr, "benchmark: %s\n", error.message);
        return 2;
    }
    if (!measure_lessons(&options, &error)) {
        fprintf(stderr, "benchmark: %s\n", error.message);
        return 1;
    }
    return 0;
}
