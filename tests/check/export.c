/* A check's result in the formats that other programs read: see export.h. */
#include "export.h"

#include "check/page/escape.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- Text ---- */

/* What the writers share: after a failure nothing more is written, and the end tells. */
struct writer {
    struct bytes *report;
    bool failed;
};

static void put(struct writer *writer, const char *text) {
    writer->failed = writer->failed || !bytes_append(writer->report, text, strlen(text));
}

static void put_number(struct writer *writer, uint64_t number) {
    char digits[24];
    snprintf(digits, sizeof digits, "%llu", (unsigned long long)number);
    put(writer, digits);
}

static bool finish(const struct writer *writer, struct error *error) {
    return !writer->failed || error_out_of_memory(error);
}

static void put_byte(struct writer *writer, char byte) {
    writer->failed = writer->failed || !bytes_append(writer->report, &byte, 1);
}

/* Text from a submission, each byte as `escape` writes it. */
static void put_escaped(struct writer *writer, const char *text,
                        void escape(struct writer *, char)) {
    char *printable = printable_lines(text);
    writer->failed = writer->failed || printable == NULL;
    for (const char *at = printable; !writer->failed && *at != '\0'; at++) {
        escape(writer, *at);
    }
    free(printable);
}

/* ---- Words ---- */

static bool is_error(enum result_state state) {
    return state == RESULT_TIME || state == RESULT_CRASH || state == RESULT_BUILD ||
           state == RESULT_ERROR;
}

/* How many of the step's items count as failures, errors and skipped. */
struct outcome {
    size_t failures, errors, skipped;
};

static struct outcome count_outcome(const struct step_result *step) {
    struct outcome outcome = {0};
    for (size_t i = 0; i < step->item_count; i++) {
        enum result_state state = step->items[i].state;
        outcome.failures += state == RESULT_FAIL;
        outcome.errors += is_error(state);
        outcome.skipped += state == RESULT_TODO;
    }
    return outcome;
}

/* What is wrong with an item: its own message, else the step's. */
static const char *message_of(const struct step_result *step, const struct item_result *item) {
    return item->message.text[0] != '\0' || item->state == RESULT_PASS ? item->message.text
                                                                       : step->reason.text;
}

/* ---- JUnit XML ---- */

static void put_xml(struct writer *writer, const char *text) {
    writer->failed = writer->failed || !escape_markup(writer->report, text);
}

static void put_attribute(struct writer *writer, const char *name, uint64_t number) {
    put(writer, " ");
    put(writer, name);
    put(writer, "=\"");
    put_number(writer, number);
    put(writer, "\"");
}

static void put_outcome(struct writer *writer, size_t tests, struct outcome outcome) {
    put_attribute(writer, "tests", tests);
    put_attribute(writer, "failures", outcome.failures);
    put_attribute(writer, "errors", outcome.errors);
}

static void junit_item(struct writer *writer, const struct step_result *step,
                       const struct item_result *item) {
    const char *message = message_of(step, item);
    put(writer, "    <testcase classname=\"");
    put_xml(writer, step->name);
    put(writer, "\" name=\"");
    put_xml(writer, item->scene);
    if (item->counter[0] != '\0') {
        put(writer, " ");
        put_xml(writer, item->counter);
    }
    put(writer, "\">\n");
    if (item->state == RESULT_TODO) {
        put(writer, "      <skipped>");
        put_xml(writer, message);
        put(writer, "</skipped>\n");
    } else if (item->state != RESULT_PASS) {
        put(writer, item->state == RESULT_FAIL ? "      <failure type=\"" : "      <error type=\"");
        put(writer, result_state_name(item->state));
        put(writer, "\" message=\"");
        put_xml(writer, message);
        put(writer, "\"/>\n");
    }
    put(writer, "      <system-out>points ");
    put_number(writer, item->points);
    put(writer, "/");
    put_number(writer, item->credit->points);
    if (item->state == RESULT_PASS && message[0] != '\0') {
        put(writer, "; ");
        put_xml(writer, message);
    }
    put(writer, "</system-out>\n    </testcase>\n");
}

bool export_junit(struct bytes *report, const struct check_result *result, const char *references,
                  struct error *error) {
    struct writer writer = {.report = report};
    struct outcome all = {0};
    size_t tests = 0;
    (void)references;
    for (size_t i = 0; i < result->step_count; i++) {
        struct outcome outcome = count_outcome(&result->steps[i]);
        all.failures += outcome.failures;
        all.errors += outcome.errors;
        tests += result->steps[i].item_count;
    }
    put(&writer, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"check\"");
    put_outcome(&writer, tests, all);
    put(&writer, ">\n");
    for (size_t i = 0; i < result->step_count; i++) {
        const struct step_result *step = &result->steps[i];
        put(&writer, "  <testsuite name=\"");
        put_xml(&writer, step->name);
        put(&writer, "\"");
        struct outcome outcome = count_outcome(step);
        put_outcome(&writer, step->item_count, outcome);
        put_attribute(&writer, "skipped", outcome.skipped);
        put(&writer, ">\n");
        for (size_t k = 0; k < step->item_count; k++) {
            junit_item(&writer, step, &step->items[k]);
        }
        if (result->note != NULL && result->note[0] != '\0') {
            put(&writer, "    <system-out>");
            put_xml(&writer, result->note);
            put(&writer, "</system-out>\n");
        }
        if (step->messages.size > 1) {
            put(&writer, "    <system-err>");
            put_xml(&writer, (const char *)step->messages.data);
            put(&writer, "</system-err>\n");
        }
        put(&writer, "  </testsuite>\n");
    }
    put(&writer, "</testsuites>\n");
    return finish(&writer, error);
}

/* ---- JSON ---- */

static void escape_json(struct writer *writer, char byte) {
    if (byte == '"' || byte == '\\') {
        put(writer, "\\");
    }
    if (byte == '\n') {
        put(writer, "\\n");
    } else {
        put_byte(writer, byte);
    }
}

static void put_json(struct writer *writer, const char *text) {
    put(writer, "\"");
    put_escaped(writer, text, escape_json);
    put(writer, "\"");
}

/* Each of a member begins with what stands between it and the one before. */
static void json_text(struct writer *writer, const char *name, const char *text) {
    put(writer, name);
    put(writer, ": ");
    put_json(writer, text);
}

static void json_number(struct writer *writer, const char *name, uint64_t number) {
    put(writer, name);
    put(writer, ": ");
    put_number(writer, number);
}

static void json_percent(struct writer *writer, const char *name, uint64_t count, uint64_t drawn) {
    char number[48];
    snprintf(number, sizeof number, "%s: %.4f", name,
             drawn > 0 ? 100.0 * (double)count / (double)drawn : 0.0);
    put(writer, number);
}

static void json_picture(struct writer *writer, const struct item_result *item) {
    const struct comparison *shares = &item->shares;
    put(writer, item->exact ? ", \"exact\": true" : ", \"exact\": false");
    if (!item->compared || item->exact) {
        return;
    }
    json_number(writer, ", \"pixels_drawn\"", shares->drawn);
    json_percent(writer, ", \"wrong_percent\"", shares->wrong.count, shares->drawn);
    json_percent(writer, ", \"apart_percent\"", shares->apart.count, shares->drawn);
    json_percent(writer, ", \"coverage_percent\"", shares->coverage.count, shares->drawn);
    if (item->yours.text[0] != '\0') {
        json_text(writer, ", \"yours\"", item->yours.text);
        json_text(writer, ", \"reference\"", item->reference.text);
        json_text(writer, ", \"difference\"", item->difference.text);
    }
}

/* The figures of the lesson's wrong pictures that show what it looks like. */
static void json_figures(struct writer *writer, const struct item_result *item) {
    for (size_t i = 0; i < item->looks_figure_count; i++) {
        put(writer, i > 0 ? ", " : ", \"figures\": [");
        put_number(writer, item->looks_figures[i]);
    }
    put(writer, item->looks_figure_count > 0 ? "]" : "");
}

static void json_item(struct writer *writer, const struct item_result *item) {
    json_text(writer, "        {\"scene\"", item->scene);
    json_text(writer, ", \"state\"", result_state_name(item->state));
    json_number(writer, ", \"points\"", item->points);
    json_number(writer, ", \"most\"", item->credit->points);
    put(writer, ", \"tasks\": [");
    for (size_t i = 0; i < item->credit->task_count; i++) {
        put(writer, i > 0 ? ", " : "");
        put_json(writer, item->credit->tasks[i].text);
    }
    put(writer, "]");
    if (item->counter[0] != '\0') {
        json_text(writer, ", \"counter\"", item->counter);
        json_number(writer, ", \"counted\"", item->counted);
        json_number(writer, ", \"enough\"", item->most);
    } else {
        json_picture(writer, item);
    }
    if (item->message.text[0] != '\0') {
        json_text(writer, ", \"message\"", item->message.text);
    }
    if (item->looks.text[0] != '\0') {
        json_text(writer, item->only_may_be ? ", \"may_be\"" : ", \"looks_like\"",
                  item->looks.text);
        json_figures(writer, item);
    }
    put(writer, "}");
}

static void json_task(struct writer *writer, const struct task_result *task) {
    json_text(writer, "        {\"task\"", task->name.text);
    json_text(writer, ", \"state\"", result_state_name(task->state));
    json_number(writer, ", \"points\"", task->points);
    json_number(writer, ", \"most\"", task->most);
    put(writer, "}");
}

static void json_step(struct writer *writer, const struct step_result *step) {
    json_text(writer, "    {\n      \"step\"", step->name);
    json_text(writer, ",\n      \"state\"", result_state_name(step->state));
    json_number(writer, ",\n      \"points\"", step->points);
    json_number(writer, ",\n      \"most\"", step->most);
    if (step->reason.text[0] != '\0') {
        json_text(writer, ",\n      \"reason\"", step->reason.text);
    }
    if (step->messages.size > 1) {
        json_text(writer, ",\n      \"messages\"", (const char *)step->messages.data);
    }
    put(writer, ",\n      \"tasks\": [\n");
    for (size_t i = 0; i < step->task_count; i++) {
        json_task(writer, &step->tasks[i]);
        put(writer, i + 1 < step->task_count ? ",\n" : "\n");
    }
    put(writer, "      ],\n      \"items\": [\n");
    for (size_t i = 0; i < step->item_count; i++) {
        json_item(writer, &step->items[i]);
        put(writer, i + 1 < step->item_count ? ",\n" : "\n");
    }
    put(writer, "      ]\n    }");
}

bool export_json(struct bytes *report, const struct check_result *result, const char *references,
                 struct error *error) {
    struct writer writer = {.report = report};
    (void)references;
    json_number(&writer, "{\n  \"points\"", result->points);
    json_number(&writer, ",\n  \"most\"", result->most);
    json_number(&writer, ",\n  \"passed\"", result->passed);
    json_number(&writer, ",\n  \"failed\"", result->failed);
    if (result->note != NULL && result->note[0] != '\0') {
        json_text(&writer, ",\n  \"note\"", result->note);
    }
    put(&writer, ",\n  \"steps\": [\n");
    for (size_t i = 0; i < result->step_count; i++) {
        json_step(&writer, &result->steps[i]);
        put(&writer, i + 1 < result->step_count ? ",\n" : "\n");
    }
    put(&writer, "  ]\n}\n");
    return finish(&writer, error);
}

/* ---- TAP ---- */

/* '#' begins a directive. */
static void escape_tap(struct writer *writer, char byte) {
    if (byte == '#' || byte == '\n') {
        put(writer, " ");
    } else {
        put_byte(writer, byte);
    }
}

static void tap_item(struct writer *writer, size_t number, const struct step_result *step,
                     const struct item_result *item) {
    const char *message = message_of(step, item);
    put(writer, item->state == RESULT_PASS ? "ok " : "not ok ");
    put_number(writer, number);
    put(writer, " - ");
    put_escaped(writer, step->name, escape_tap);
    put(writer, " ");
    put_escaped(writer, item->scene, escape_tap);
    if (item->counter[0] != '\0') {
        put(writer, " ");
        put_escaped(writer, item->counter, escape_tap);
    }
    if (item->state == RESULT_TODO) {
        put(writer, " # TODO ");
        put_escaped(writer, message, escape_tap);
    }
    put(writer, "\n# ");
    put(writer, result_state_name(item->state));
    put(writer, " ");
    put_number(writer, item->points);
    put(writer, "/");
    put_number(writer, item->credit->points);
    if (message[0] != '\0') {
        put(writer, ": ");
        put_escaped(writer, message, escape_tap);
    }
    put(writer, "\n");
}

bool export_tap(struct bytes *report, const struct check_result *result, const char *references,
                struct error *error) {
    struct writer writer = {.report = report};
    size_t number = 0;
    (void)references;
    for (size_t i = 0; i < result->step_count; i++) {
        number += result->steps[i].item_count;
    }
    put(&writer, "TAP version 13\n1..");
    put_number(&writer, number);
    put(&writer, "\n");
    if (result->note != NULL && result->note[0] != '\0') {
        put(&writer, "# ");
        put_escaped(&writer, result->note, escape_tap);
        put(&writer, "\n");
    }
    number = 0;
    for (size_t i = 0; i < result->step_count; i++) {
        const struct step_result *step = &result->steps[i];
        for (size_t k = 0; k < step->item_count; k++) {
            tap_item(&writer, ++number, step, &step->items[k]);
        }
    }
    return finish(&writer, error);
}
