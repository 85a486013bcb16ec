/* A check's result in the formats that other programs read: see export.h. */
#include "export.h"

#include "check/page/escape.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- Text ---- */

/* What the writers share: after a failure nothing more is written, and the end tells. */
struct writer {
    struct bytes *report;
    bool failed;
};

static void put(struct writer *writer, const char *format, ...) PRINTF_LIKE(2, 3);

static void put(struct writer *writer, const char *format, ...) {
    char text[512]; /* names and numbers have room; texts from a submission go another way */
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    writer->failed = writer->failed || !bytes_append(writer->report, text, strlen(text));
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

/* "depth", or "depth pixels" for a counter: names of the table of scenes, which are plain. */
static void put_name(struct writer *writer, const struct item_result *item) {
    put(writer, "%s%s%s", item->scene, item->counter[0] != '\0' ? " " : "", item->counter);
}

/* ---- Words ---- */

static bool is_error(enum result_state state) {
    return state == RESULT_TIME || state == RESULT_CRASH || state == RESULT_BUILD ||
           state == RESULT_ERROR;
}

/* How many of the step's items count as failures, errors and skipped. */
struct outcome {
    unsigned failures, errors, skipped;
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

static bool has_note(const struct check_result *result) {
    return result->note != NULL && result->note[0] != '\0';
}

/* What is wrong with an item: its own message, else the step's. */
static const char *message_of(const struct step_result *step, const struct item_result *item) {
    return item->message.text[0] != '\0' || item->state == RESULT_PASS ? item->message.text
                                                                       : step->reason.text;
}

/* ---- JUnit XML ---- */

static bool junit_item(struct bytes *report, const struct step_result *step,
                       const struct item_result *item) {
    const char *message = message_of(step, item);
    bool done =
        markup_print(report, "    <testcase classname=\"%s\" name=\"%s%s%s\">\n", step->name,
                     item->scene, item->counter[0] != '\0' ? " " : "", item->counter);
    if (done && item->state == RESULT_TODO) {
        done = markup_print(report, "      <skipped>%s</skipped>\n", message);
    } else if (done && item->state != RESULT_PASS) {
        done = markup_print(report, "      <%s type=\"%s\" message=\"%s\"/>\n",
                            item->state == RESULT_FAIL ? "failure" : "error",
                            result_state_name(item->state), message);
    }
    bool remark = item->state == RESULT_PASS && message[0] != '\0';
    return done &&
           markup_print(
               report, "      <system-out>points %u/%u%s%s</system-out>\n    </testcase>\n",
               item->points, item->credit->points, remark ? "; " : "", remark ? message : "");
}

static bool junit_step(struct bytes *report, const struct check_result *result,
                       const struct step_result *step) {
    struct outcome outcome = count_outcome(step);
    bool done = markup_print(report,
                             "  <testsuite name=\"%s\" tests=\"%u\" failures=\"%u\" errors=\"%u\" "
                             "skipped=\"%u\">\n",
                             step->name, (unsigned)step->item_count, outcome.failures,
                             outcome.errors, outcome.skipped);
    for (size_t k = 0; k < step->item_count && done; k++) {
        done = junit_item(report, step, &step->items[k]);
    }
    if (done && has_note(result)) {
        done = markup_print(report, "    <system-out>%s</system-out>\n", result->note);
    }
    if (done && step->messages.size > 1) {
        done = markup_print(report, "    <system-err>%s</system-err>\n",
                            (const char *)step->messages.data);
    }
    return done && markup_print(report, "  </testsuite>\n");
}

bool export_junit(struct bytes *report, const struct check_result *result, struct error *error) {
    struct outcome all = {0};
    unsigned tests = 0;
    for (size_t i = 0; i < result->step_count; i++) {
        struct outcome outcome = count_outcome(&result->steps[i]);
        all.failures += outcome.failures;
        all.errors += outcome.errors;
        tests += (unsigned)result->steps[i].item_count;
    }
    bool done = markup_print(report,
                             "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                             "<testsuites name=\"check\" tests=\"%u\" failures=\"%u\" "
                             "errors=\"%u\">\n",
                             tests, all.failures, all.errors);
    for (size_t i = 0; i < result->step_count && done; i++) {
        done = junit_step(report, result, &result->steps[i]);
    }
    return (done && markup_print(report, "</testsuites>\n")) || error_out_of_memory(error);
}

/* ---- JSON ---- */

static void escape_json(struct writer *writer, char byte) {
    if (byte == '"' || byte == '\\') {
        put_byte(writer, '\\');
    }
    if (byte == '\n') {
        put(writer, "\\n");
    } else {
        put_byte(writer, byte);
    }
}

/* A member of free text; `before` is its name and what separates it from the one before. */
static void json_text(struct writer *writer, const char *before, const char *text) {
    put(writer, "%s: \"", before);
    put_escaped(writer, text, escape_json);
    put(writer, "\"");
}

/* The same, where there is something to say. */
static void json_message(struct writer *writer, const char *before, const char *text) {
    if (text[0] != '\0') {
        json_text(writer, before, text);
    }
}

static double percent(uint64_t count, uint64_t drawn) {
    return drawn > 0 ? 100.0 * (double)count / (double)drawn : 0.0;
}

static void json_picture(struct writer *writer, const struct item_result *item) {
    const struct comparison *shares = &item->shares;
    put(writer, ", \"exact\": %s", item->exact ? "true" : "false");
    if (!item->compared || item->exact) {
        return;
    }
    put(writer, ", \"pixels_drawn\": %llu", (unsigned long long)shares->drawn);
    put(writer, ", \"wrong_percent\": %.4f", percent(shares->wrong.count, shares->drawn));
    put(writer, ", \"apart_percent\": %.4f", percent(shares->apart.count, shares->drawn));
    put(writer, ", \"coverage_percent\": %.4f", percent(shares->coverage.count, shares->drawn));
    if (item->yours.text[0] != '\0') {
        json_text(writer, ", \"yours\"", item->yours.text);
        json_text(writer, ", \"reference\"", item->reference.text);
        json_text(writer, ", \"difference\"", item->difference.text);
    }
}

static void json_item(struct writer *writer, const struct item_result *item) {
    put(writer, "        {\"scene\": \"%s\", \"state\": \"%s\", \"points\": %u, \"most\": %u",
        item->scene, result_state_name(item->state), item->points, item->credit->points);
    for (size_t i = 0; i < item->credit->task_count; i++) {
        put(writer, "%s\"%s\"", i > 0 ? ", " : ", \"tasks\": [", item->credit->tasks[i].text);
    }
    put(writer, "]");
    if (item->counter[0] != '\0') {
        put(writer, ", \"counter\": \"%s\", \"counted\": %llu, \"enough\": %llu", item->counter,
            (unsigned long long)item->counted, (unsigned long long)item->most);
    } else {
        json_picture(writer, item);
    }
    json_message(writer, ", \"message\"", item->message.text);
    json_message(writer, item->only_may_be ? ", \"may_be\"" : ", \"looks_like\"", item->looks.text);
    json_message(writer, ", \"seen\"", item->state == RESULT_FAIL ? item->seen.text : "");
    for (size_t i = 0; i < item->looks_figure_count; i++) {
        put(writer, "%s%u%s", i > 0 ? ", " : ", \"figures\": [", item->looks_figures[i],
            i + 1 < item->looks_figure_count ? "" : "]");
    }
    put(writer, "}");
}

static void json_step(struct writer *writer, const struct step_result *step) {
    put(writer, "    {\n      \"step\": \"%s\",\n      \"state\": \"%s\"", step->name,
        result_state_name(step->state));
    put(writer, ",\n      \"points\": %u,\n      \"most\": %u", step->points, step->most);
    json_message(writer, ",\n      \"reason\"", step->reason.text);
    if (step->messages.size > 1) {
        json_text(writer, ",\n      \"messages\"", (const char *)step->messages.data);
    }
    put(writer, ",\n      \"tasks\": [\n");
    for (size_t i = 0; i < step->task_count; i++) {
        const struct task_result *task = &step->tasks[i];
        put(writer,
            "        {\"task\": \"%s\", \"state\": \"%s\", \"points\": %u, \"most\": %u}%s\n",
            task->name.text, result_state_name(task->state), task->points, task->most,
            i + 1 < step->task_count ? "," : "");
    }
    put(writer, "      ],\n      \"items\": [\n");
    for (size_t i = 0; i < step->item_count; i++) {
        json_item(writer, &step->items[i]);
        put(writer, i + 1 < step->item_count ? ",\n" : "\n");
    }
    put(writer, "      ]\n    }");
}

bool export_json(struct bytes *report, const struct check_result *result, struct error *error) {
    struct writer writer = {.report = report};
    put(&writer, "{\n  \"points\": %u,\n  \"most\": %u,\n", result->points, result->most);
    put(&writer, "  \"passed\": %zu,\n  \"failed\": %zu", result->passed, result->failed);
    json_message(&writer, ",\n  \"note\"", has_note(result) ? result->note : "");
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
    put_byte(writer, (char)(byte == '#' || byte == '\n' ? ' ' : byte));
}

static void tap_item(struct writer *writer, size_t number, const struct step_result *step,
                     const struct item_result *item) {
    const char *message = message_of(step, item);
    put(writer, "%s %zu - %s ", item->state == RESULT_PASS ? "ok" : "not ok", number, step->name);
    put_name(writer, item);
    if (item->state == RESULT_TODO) {
        put(writer, " # TODO ");
        put_escaped(writer, message, escape_tap);
    }
    put(writer, "\n# %s %u/%u%s", result_state_name(item->state), item->points,
        item->credit->points, message[0] != '\0' ? ": " : "");
    put_escaped(writer, message, escape_tap);
    put(writer, "\n");
}

bool export_tap(struct bytes *report, const struct check_result *result, struct error *error) {
    struct writer writer = {.report = report};
    size_t number = 0;
    for (size_t i = 0; i < result->step_count; i++) {
        number += result->steps[i].item_count;
    }
    put(&writer, "TAP version 13\n1..%zu\n", number);
    if (has_note(result)) {
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

/* ---- CSV ---- */

bool export_csv(struct bytes *report, const struct check_result *result, struct error *error) {
    struct writer writer = {.report = report};
    put(&writer, "step,task,state,points,most\n");
    for (size_t i = 0; i < result->step_count; i++) {
        const struct step_result *step = &result->steps[i];
        for (size_t k = 0; k < step->task_count; k++) {
            const struct task_result *task = &step->tasks[k];
            put(&writer, "%s,%s,%s,%u,%u\n", step->name, task->name.text,
                result_state_name(task->state), task->points, task->most);
        }
    }
    return finish(&writer, error);
}
