/* A check's result in the formats that other programs read: see export.h. */
#include "export.h"

#include "check/page/escape.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* ---- Text ---- */

/* What the writers share: after a failure nothing more is written, and the end says so. */
struct writer {
    struct bytes *report;
    escape_function *escape; /* what is written for %s */
    bool failed;
};

static void put(struct writer *writer, const char *format, ...) PRINTF_LIKE(2, 3);

static void put(struct writer *writer, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    writer->failed =
        writer->failed || !escape_print(writer->report, writer->escape, format, arguments);
    va_end(arguments);
}

static void put_plain(struct writer *writer, const char *text) {
    writer->failed = writer->failed || !bytes_append(writer->report, text, strlen(text));
}

static bool finish_report(const struct writer *writer, struct error *error) {
    return !writer->failed || error_out_of_memory(error);
}

/* ---- Words ---- */

/* How many of the step's items count as failures, errors and skipped. */
struct outcome {
    unsigned failures, errors, skipped;
};

static struct outcome count_outcome(const struct step_result *step) {
    struct outcome outcome = {0};
    for (size_t i = 0; i < step->item_count; i++) {
        enum result_state state = step->items[i].state;
        outcome.failures += state == RESULT_FAIL;
        outcome.errors += state > RESULT_FAIL;
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

/* "depth", or "depth pixels" for a counter: what is between the two. */
static const char *blank_of(const struct item_result *item) {
    return item->counter[0] != '\0' ? " " : "";
}

/* ---- JUnit XML ---- */

static void junit_item(struct writer *writer, const struct step_result *step,
                       const struct item_result *item) {
    const char *message = message_of(step, item);
    bool remark = item->state == RESULT_PASS && message[0] != '\0';
    put(writer, "    <testcase classname=\"%s\" name=\"%s%s%s\">\n", step->name, item->scene,
        blank_of(item), item->counter);
    if (item->state == RESULT_TODO) {
        put(writer, "      <skipped>%s</skipped>\n", message);
    } else if (item->state != RESULT_PASS) {
        put(writer, "      <%s type=\"%s\" message=\"%s\"/>\n",
            item->state == RESULT_FAIL ? "failure" : "error", result_state_name(item->state),
            message);
    }
    put(writer, "      <system-out>points %u/%u%s%s</system-out>\n    </testcase>\n", item->points,
        item->credit->points, remark ? "; " : "", remark ? message : "");
}

static void junit_step(struct writer *writer, const struct check_result *result,
                       const struct step_result *step) {
    struct outcome outcome = count_outcome(step);
    put(writer,
        "  <testsuite name=\"%s\" tests=\"%u\" failures=\"%u\" errors=\"%u\" skipped=\"%u\">\n",
        step->name, (unsigned)step->item_count, outcome.failures, outcome.errors, outcome.skipped);
    for (size_t k = 0; k < step->item_count; k++) {
        junit_item(writer, step, &step->items[k]);
    }
    if (has_note(result)) {
        put(writer, "    <system-out>%s</system-out>\n", result->note);
    }
    if (step->messages.size > 1) {
        put(writer, "    <system-err>%s</system-err>\n", (const char *)step->messages.data);
    }
    put(writer, "  </testsuite>\n");
}

bool export_junit(struct bytes *report, const struct check_result *result, struct error *error) {
    struct writer writer = {.report = report, .escape = escape_markup};
    struct outcome all = {0};
    unsigned tests = 0;
    for (size_t i = 0; i < result->step_count; i++) {
        struct outcome outcome = count_outcome(&result->steps[i]);
        all.failures += outcome.failures;
        all.errors += outcome.errors;
        tests += (unsigned)result->steps[i].item_count;
    }
    put(&writer, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    put(&writer, "<testsuites name=\"check\" tests=\"%u\" failures=\"%u\" errors=\"%u\">\n", tests,
        all.failures, all.errors);
    for (size_t i = 0; i < result->step_count; i++) {
        junit_step(&writer, result, &result->steps[i]);
    }
    put(&writer, "</testsuites>\n");
    return finish_report(&writer, error);
}

/* ---- JSON ---- */

/* A member of text, where there is something to say; before its name is what separates it. */
static void json_text(struct writer *writer, const char *before, const char *name,
                      const char *text) {
    if (text[0] != '\0') {
        put_plain(writer, before);
        put(writer, "\"%s\": \"%s\"", name, text);
    }
}

/* A share of the drawn pixels. */
static void json_percent(struct writer *writer, const char *name, uint64_t count, uint64_t drawn) {
    char percent[32];
    snprintf(percent, sizeof percent, "%.4f",
             drawn > 0 ? 100.0 * (double)count / (double)drawn : 0.0);
    put(writer, ", \"%s\": %s", name, percent);
}

static void json_count(struct writer *writer, const char *name, uint64_t count) {
    char digits[32];
    snprintf(digits, sizeof digits, "%llu", (unsigned long long)count);
    put(writer, ", \"%s\": %s", name, digits);
}

static void json_picture(struct writer *writer, const struct item_result *item) {
    const struct comparison *shares = &item->shares;
    put(writer, ", \"exact\": %s", item->exact ? "true" : "false");
    if (!item->compared || item->exact) {
        return;
    }
    json_count(writer, "pixels_drawn", shares->drawn);
    json_percent(writer, "wrong_percent", shares->wrong.count, shares->drawn);
    json_percent(writer, "apart_percent", shares->apart.count, shares->drawn);
    json_percent(writer, "coverage_percent", shares->coverage.count, shares->drawn);
    if (item->yours.text[0] != '\0') {
        put(writer, ", \"yours\": \"%s\", \"reference\": \"%s\", \"difference\": \"%s\"",
            item->yours.text, item->reference.text, item->difference.text);
    }
}

static void json_item(struct writer *writer, const struct item_result *item) {
    put(writer, "        {\"scene\": \"%s\", \"state\": \"%s\", \"points\": %u, \"most\": %u",
        item->scene, result_state_name(item->state), item->points, item->credit->points);
    for (size_t i = 0; i < item->credit->task_count; i++) {
        put(writer, i > 0 ? ", " : ", \"tasks\": [");
        put(writer, "\"%s\"", item->credit->tasks[i].text);
    }
    put(writer, "]");
    if (item->kind != ITEM_PICTURE) {
        put(writer, ", \"counter\": \"%s\"", item->counter);
        json_count(writer, "counted", item->counted);
        json_count(writer, "enough", item->most);
    } else {
        json_picture(writer, item);
    }
    json_text(writer, ", ", "message", item->message.text);
    json_text(writer, ", ", item->only_may_be ? "may_be" : "looks_like", item->looks.text);
    json_text(writer, ", ", "seen", item->state == RESULT_FAIL ? item->seen.text : "");
    for (size_t i = 0; i < item->looks_figure_count; i++) {
        put(writer, i > 0 ? ", " : ", \"figures\": [");
        put(writer, "%u%s", item->looks_figures[i], i + 1 < item->looks_figure_count ? "" : "]");
    }
    put(writer, "}");
}

static void json_step(struct writer *writer, const struct step_result *step) {
    put(writer, "    {\n      \"step\": \"%s\",\n      \"state\": \"%s\"", step->name,
        result_state_name(step->state));
    put(writer, ",\n      \"points\": %u,\n      \"most\": %u", step->points, step->most);
    json_text(writer, ",\n      ", "reason", step->reason.text);
    json_text(writer, ",\n      ", "messages",
              step->messages.size > 1 ? (const char *)step->messages.data : "");
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
    struct writer writer = {.report = report, .escape = escape_json};
    put(&writer, "{\n  \"points\": %u,\n  \"most\": %u,\n", result->points, result->most);
    put(&writer, "  \"passed\": %u,\n  \"failed\": %u", (unsigned)result->passed,
        (unsigned)result->failed);
    json_text(&writer, ",\n  ", "note", has_note(result) ? result->note : "");
    put(&writer, ",\n  \"steps\": [\n");
    for (size_t i = 0; i < result->step_count; i++) {
        json_step(&writer, &result->steps[i]);
        put(&writer, i + 1 < result->step_count ? ",\n" : "\n");
    }
    put(&writer, "  ]\n}\n");
    return finish_report(&writer, error);
}
