/* Tables and JSON: see report.h. */
#include "report.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* ---- What panels may leave out ---- */

const char *report_across(const struct bench_panel *panel) {
    return panel->across != NULL ? panel->across : "error";
}

const char *report_series(const struct bench_panel *panel, size_t i) {
    return panel->series != NULL ? panel->series(panel->versions[i].choice) : NULL;
}

/* ---- The table ---- */

static void print_head(const struct bench_panel *panel, size_t rounds) {
    const char *against = panel->against;
    printf("\n  %s\n  %s: %s%s%s; time: %s, median and quartiles of %zu rounds\n", panel->title,
           report_across(panel), panel->error_label, against != NULL ? ", against " : "",
           against != NULL ? against : "", panel->time_label, rounds);
    printf("    %-32s %12s %12s %12s %12s", "version", report_across(panel), "time", "lower",
           "upper");
    printf("%s%s\n", panel->size != NULL ? "  " : "", panel->size != NULL ? panel->size_label : "");
}

static void print_version(const struct bench_panel *panel, size_t i,
                          const struct bench_result *result) {
    char name[64], size[32];
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
    bench_show_number(result->size, size);
    printf("%s%s\n", panel->size != NULL ? "  " : "", panel->size != NULL ? size : "");
}

void report_print(const struct bench_lesson *lesson, const struct bench_results *results) {
    printf("\n%s (%s)\n", lesson->title, lesson->step);
    for (size_t i = 0; i < lesson->panel_count; i++) {
        print_head(&lesson->panels[i], results->of[i][0].rounds);
        for (size_t j = 0; j < results->count[i]; j++) {
            print_version(&lesson->panels[i], j, &results->of[i][j]);
        }
    }
    printf("\n  * useful: no other version is as good in both, and better in one\n");
    fflush(stdout);
}

/* ---- JSON ---- */

bool report_append(struct bytes *text, struct error *error, const char *format, ...) {
    char piece[1024];
    va_list arguments;
    va_start(arguments, format);
    int length = vsnprintf(piece, sizeof piece, format, arguments);
    va_end(arguments);
    if (length < 0 || length >= (int)sizeof piece) {
        return error_set(error, "a line of the report is too long");
    }
    if (!bytes_append(text, piece, (size_t)length)) {
        return error_set(error, "out of memory for the report");
    }
    return true;
}

/* "name": "value", with what JSON wants escaped. */
static bool append_string(struct bytes *json, struct error *error, const char *name,
                          const char *value) {
    bool done = report_append(json, error, "\"%s\": \"", name);
    for (; done && *value != '\0'; value++) {
        unsigned char c = (unsigned char)*value;
        if (c == '"' || c == '\\') {
            done = report_append(json, error, "\\%c", c);
        } else if (c < 32) {
            done = report_append(json, error, "\\u%04x", (unsigned)c);
        } else {
            done = report_append(json, error, "%c", c);
        }
    }
    return done && report_append(json, error, "\"");
}

/* "name": value; JSON has no infinity, so null stands for what is not finite. */
static bool append_number(struct bytes *json, struct error *error, const char *name, double value) {
    if (!isfinite(value)) {
        return report_append(json, error, "\"%s\": null", name);
    }
    return report_append(json, error, "\"%s\": %.9g", name, value);
}

static bool append_comma(struct bytes *json, struct error *error) {
    return report_append(json, error, ", ");
}

/* The same where there is no value: null. */
static bool append_text(struct bytes *json, struct error *error, const char *name,
                        const char *value) {
    return value != NULL ? append_string(json, error, name, value)
                         : report_append(json, error, "\"%s\": null", name);
}

static bool append_version(struct bytes *json, const struct bench_panel *panel, size_t i,
                           const struct bench_result *result, struct error *error) {
    return report_append(json, error, "        {") &&
           append_text(json, error, "series", report_series(panel, i)) &&
           append_comma(json, error) &&
           append_string(json, error, "name", panel->versions[i].name) &&
           append_comma(json, error) && append_number(json, error, "error", result->error) &&
           append_comma(json, error) && append_number(json, error, "median", result->median) &&
           append_comma(json, error) &&
           append_number(json, error, "lower_quartile", result->lower) &&
           append_comma(json, error) &&
           append_number(json, error, "upper_quartile", result->upper) &&
           append_comma(json, error) &&
           append_number(json, error, "size", panel->size != NULL ? result->size : INFINITY) &&
           report_append(json, error, ", \"rounds\": %zu, \"runs_per_round\": %zu, ",
                         result->rounds, result->calls) &&
           report_append(json, error, "\"useful\": %s}", result->front ? "true" : "false");
}

static bool append_panel(struct bytes *json, const struct bench_panel *panel,
                         const struct bench_result *results, size_t count, struct error *error) {
    bool done =
        report_append(json, error, "      {") &&
        append_string(json, error, "title", panel->title) && append_comma(json, error) &&
        append_string(json, error, "time_unit", panel->time_label) && append_comma(json, error) &&
        append_string(json, error, "error_is", report_across(panel)) && append_comma(json, error) &&
        append_string(json, error, "error_unit", panel->error_label) && append_comma(json, error) &&
        append_text(json, error, "error_against", panel->against) && append_comma(json, error) &&
        append_text(json, error, "size_unit", panel->size_label) &&
        report_append(json, error, ", \"versions\": [\n");
    for (size_t i = 0; done && i < count; i++) {
        done = append_version(json, panel, i, &results[i], error) &&
               report_append(json, error, i + 1 < count ? ",\n" : "\n");
    }
    return done && report_append(json, error, "      ]}");
}

bool report_begin(struct bytes *json, double seconds, struct error *error) {
    char processor[128];
    report_processor(processor);
    return report_append(json, error, "{\n  ") &&
           append_string(json, error, "compiler", report_compiler()) && append_comma(json, error) &&
           append_string(json, error, "processor", processor) && append_comma(json, error) &&
           append_number(json, error, "seconds_a_lesson", seconds) &&
           report_append(json, error, ",\n  \"lessons\": [");
}

bool report_lesson(struct bytes *json, const struct bench_lesson *lesson,
                   const struct bench_results *results, bool first, struct error *error) {
    bool done = report_append(json, error, "%s\n    {", first ? "" : ",") &&
                append_string(json, error, "step", lesson->step) && append_comma(json, error) &&
                append_string(json, error, "title", lesson->title) &&
                report_append(json, error, ", \"panels\": [\n");
    for (size_t i = 0; done && i < lesson->panel_count; i++) {
        done = append_panel(json, &lesson->panels[i], results->of[i], results->count[i], error) &&
               report_append(json, error, i + 1 < lesson->panel_count ? ",\n" : "\n");
    }
    return done && report_append(json, error, "    ]}");
}

bool report_end(struct bytes *json, struct error *error) {
    return report_append(json, error, "\n  ]\n}\n");
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
