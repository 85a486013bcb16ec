/* A check's result as a page for people: see export.h. */
#include "../help/page.h"
#include "../help/pictures.h"
#include "export.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool put_number(struct bytes *page, uint64_t number) {
    char digits[24];
    snprintf(digits, sizeof digits, "%llu", (unsigned long long)number);
    return page_html(page, digits);
}

static bool put_points(struct bytes *page, unsigned points, unsigned most) {
    return put_number(page, points) && page_html(page, "/") && put_number(page, most);
}

/* ---- The table at the top ---- */

/* A step: its name leads to its part of the page. */
static bool put_row(struct bytes *page, const struct step_result *step) {
    bool done = page_html(page, "<tr><td><a href=\"#") && page_text(page, step->name) &&
                page_html(page, "\">") && page_text(page, step->name) &&
                page_html(page, "</a></td><td>") &&
                page_html(page, result_state_name(step->state)) && page_html(page, "</td><td>") &&
                put_points(page, step->points, step->most) && page_html(page, "</td><td>");
    for (size_t i = 0; done && i < step->task_count; i++) {
        const struct task_result *task = &step->tasks[i];
        done = page_html(page, i > 0 ? ", " : "") && page_text(page, task->name.text) &&
               page_html(page, task->perhaps ? " perhaps " : " ") &&
               page_html(page, result_state_name(task->state)) && page_html(page, " ") &&
               put_points(page, task->points, task->most);
    }
    return done && page_html(page, "</td></tr>\n");
}

static bool put_table(struct bytes *page, const struct check_result *result) {
    bool done = page_html(page, "<p>SCORE ") && put_points(page, result->points, result->most) &&
                page_html(page, ", ") && put_number(page, result->passed) &&
                page_html(page, " passed, ") && put_number(page, result->failed) &&
                page_html(page, " failed</p>\n<table><tr><th>step</th><th>state</th>"
                                "<th>points</th><th>tasks</th></tr>\n");
    for (size_t i = 0; done && i < result->step_count; i++) {
        done = put_row(page, &result->steps[i]);
    }
    return done && page_html(page, "</table>\n");
}

/* ---- A step ---- */

/* What a compiler or a program said, as it said it. */
static bool put_messages(struct bytes *page, const struct step_result *step) {
    if (step->messages.size <= 1) {
        return true;
    }
    char *copy = string_format("%s", (const char *)step->messages.data);
    bool done = copy != NULL && page_html(page, "<details><summary>Messages</summary><pre>");
    for (char *line = copy; done && line != NULL;) {
        char *end = strchr(line, '\n');
        if (end != NULL) {
            *end = '\0';
        }
        done = page_text(page, line) && page_html(page, "\n");
        line = end != NULL ? end + 1 : NULL;
    }
    free(copy);
    return done && page_html(page, "</pre></details>\n");
}

/* "FAIL 0/4: 4.4 % of drawn pixels wrong ..." */
static char *note_of(const struct item_result *item) {
    const char *message = item->message.text[0] != '\0' ? item->message.text
                          : item->exact                 ? "exact"
                                                        : "";
    return string_format("%s %u/%u%s%s", result_state_name(item->state), item->points,
                         item->credit->points, message[0] != '\0' ? ": " : "", message);
}

static char *reference_of(const struct step_result *step, const struct item_result *item,
                          const char *references) {
    return item->reference.text[0] != '\0'
               ? string_format("%s", item->reference.text)
               : string_format("%s/%s/%s.png", references, step->name, item->scene);
}

/* What is exact is folded away. */
static bool put_summary(struct bytes *page, bool folded, const char *name, struct error *error) {
    return !folded ||
           (page_html(page, "<details><summary>") && page_text(page, name) &&
            page_html(page, ": exact</summary>\n")) ||
           error_out_of_memory(error);
}

/* An item with its pictures: all three, or where all pixels are equal the reference alone. */
static bool put_item(struct bytes *page, const struct step_result *step,
                     const struct item_result *item, const char *references, struct error *error) {
    struct pictures pictures = {0};
    char *name =
        string_format("%s%s%s", item->scene, item->counter[0] != '\0' ? " " : "", item->counter);
    char *note = note_of(item), *reference = reference_of(step, item, references);
    bool done = name != NULL && note != NULL && reference != NULL;
    if (!done) {
        error_out_of_memory(error);
    } else if (item->counter[0] == '\0') {
        done = pictures_read(&pictures, item->yours.text, reference, item->rule, error);
    }
    bool folded = item->state == RESULT_PASS && item->exact;
    done = done && put_summary(page, folded, name, error) &&
           page_scene(page, name, note, &pictures, error) &&
           (page_html(page, folded ? "</details>\n" : "") || error_out_of_memory(error));
    pictures_free(&pictures);
    free(name);
    free(note);
    free(reference);
    return done;
}

static bool put_step(struct bytes *page, const struct step_result *step, const char *references,
                     struct error *error) {
    bool begun = page_html(page, "<h2 id=\"") && page_text(page, step->name) &&
                 page_html(page, "\">") && page_text(page, step->name) && page_html(page, " ") &&
                 page_html(page, result_state_name(step->state)) && page_html(page, " ") &&
                 put_points(page, step->points, step->most) && page_html(page, "</h2>\n<p>") &&
                 page_text(page, step->reason.text) && page_html(page, "</p>\n") &&
                 put_messages(page, step);
    if (!begun) {
        return error_out_of_memory(error);
    }
    for (size_t i = 0; i < step->item_count; i++) {
        if (!put_item(page, step, &step->items[i], references, error)) {
            return false;
        }
    }
    return true;
}

bool export_html(struct bytes *report, const struct check_result *result, const char *references,
                 struct error *error) {
    if (!page_begin(report, "make check") || !put_table(report, result)) {
        return error_out_of_memory(error);
    }
    for (size_t i = 0; i < result->step_count; i++) {
        if (!put_step(report, &result->steps[i], references, error)) {
            return false;
        }
    }
    return page_end(report) || error_out_of_memory(error);
}
