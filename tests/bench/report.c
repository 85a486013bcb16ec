/* Tables and JSON: see report.h. */
#include "report.h"

#include <stdarg.h>
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

/* ---- Text that grows ---- */

void report_put(struct output *output, const char *format, ...) {
    char piece[1024];
    va_list arguments;
    va_start(arguments, format);
    int length = vsnprintf(piece, sizeof piece, format, arguments);
    va_end(arguments);
    if (output->done && (length < 0 || length >= (int)sizeof piece)) {
        output->done = error_set(output->error, "a line of the report is too long");
    }
    output->done = output->done && (bytes_append(output->text, piece, (size_t)length) ||
                                    error_out_of_memory(output->error));
}

/* ---- JSON ---- */

/* "name": "value", with what JSON wants escaped; null where there is no value. */
static void put_string(struct output *json, const char *name, const char *value) {
    if (value == NULL) {
        report_put(json, "\"%s\": null, ", name);
        return;
    }
    report_put(json, "\"%s\": \"", name);
    for (; *value != '\0'; value++) {
        unsigned char c = (unsigned char)*value;
        if (c < 32) {
            report_put(json, "\\u%04x", (unsigned)c);
        } else {
            report_put(json, c == '"' || c == '\\' ? "\\%c" : "%c", c);
        }
    }
    report_put(json, "\", ");
}

static void put_number(struct output *json, const char *name, double value) {
    report_put(json, "\"%s\": %.9g, ", name, value);
}

static void put_version(struct output *json, const struct bench_panel *panel, size_t i,
                        const struct bench_result *result) {
    report_put(json, "%s        {", i > 0 ? ",\n" : "");
    put_string(json, "series", report_series(panel, i));
    put_string(json, "name", panel->versions[i].name);
    put_number(json, "error", result->error);
    put_number(json, "median", result->median);
    put_number(json, "lower_quartile", result->lower);
    put_number(json, "upper_quartile", result->upper);
    report_put(json, "\"rounds\": %zu, \"runs_per_round\": %zu, \"useful\": %s}", result->rounds,
               result->calls, result->front ? "true" : "false");
}

static void put_panel(struct output *json, const struct bench_panel *panel,
                      const struct bench_result *results) {
    report_put(json, "      {");
    put_string(json, "title", panel->title);
    put_string(json, "time_unit", panel->time_label);
    put_string(json, "error_unit", panel->error_label);
    put_string(json, "error_against", panel->against);
    report_put(json, "\"versions\": [\n");
    for (size_t i = 0; i < panel->version_count; i++) {
        put_version(json, panel, i, &results[i]);
    }
    report_put(json, "\n      ]}");
}

void report_begin(struct output *json, double seconds) {
    char processor[128];
    report_processor(processor);
    report_put(json, "{\n  ");
    put_string(json, "compiler", report_compiler());
    put_string(json, "processor", processor);
    put_number(json, "seconds_a_lesson", seconds);
    report_put(json, "\n  \"lessons\": [");
}

void report_lesson(struct output *json, const struct bench_lesson *lesson,
                   const struct bench_results *results, bool first) {
    report_put(json, "%s\n    {", first ? "" : ",");
    put_string(json, "step", lesson->step);
    put_string(json, "title", lesson->title);
    report_put(json, "\"panels\": [\n");
    for (size_t i = 0; i < lesson->panel_count; i++) {
        put_panel(json, &lesson->panels[i], results->of[i]);
        report_put(json, i + 1 < lesson->panel_count ? ",\n" : "\n");
    }
    report_put(json, "    ]}");
}

void report_end(struct output *json) {
    report_put(json, "\n  ]\n}\n");
}

/* ---- The machine ---- */

const char *report_compiler(void) {
#if defined(__clang__)
    return "clang " __clang_version__;
#elif defined(__GNUC__)
    return "gcc " __VERSION__;
#else
    return "an unknown compiler";
#endif
}

void report_processor(char name[128]) {
    static const char key[] = "model name\t: ";
    char line[256];
    FILE *file = fopen("/proc/cpuinfo", "r");
    name[0] = '\0';
    while (file != NULL && name[0] == '\0' && fgets(line, sizeof line, file) != NULL) {
        if (strncmp(line, key, sizeof key - 1) == 0) {
            line[strcspn(line, "\n")] = '\0';
            snprintf(name, 128, "%.127s", line + sizeof key - 1);
        }
    }
    if (file != NULL) {
        fclose(file);
    }
}
