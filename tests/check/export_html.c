/* A check's result as a page for people: see export.h. */
#include "check/page/page.h"
#include "check/page/pictures.h"
#include "export.h"
#include "looks.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool put_points(struct bytes *page, unsigned points, unsigned most) {
    return bytes_print(page, "%u/%u", points, most);
}

/* "FAIL", in its colour. */
static bool put_state(struct bytes *page, enum result_state state) {
    const char *name = result_state_name(state);
    return bytes_print(page, "<b class=%s>%s</b> ", name, name);
}

/* ---- The table at the top ---- */

/* Below `perhaps` the fault may as well be another task's. */
static bool put_task(struct bytes *page, const struct task_result *task) {
    return page_html(page, "<span>") && page_text(page, task->name.text) &&
           page_html(page, task->perhaps ? " perhaps " : " ") && put_state(page, task->state) &&
           put_points(page, task->points, task->most) && page_html(page, "</span> ");
}

/* A step: its name leads to its part of the page. */
static bool put_row(struct bytes *page, const struct step_result *step) {
    bool done = page_html(page, "<tr><td><a href=\"#") && page_text(page, step->name) &&
                page_html(page, "\">") && page_text(page, step->name) &&
                page_html(page, "</a></td><td>") && put_state(page, step->state) &&
                page_html(page, "</td><td>") && put_points(page, step->points, step->most) &&
                page_html(page, "</td><td>");
    for (size_t i = 0; done && i < step->task_count; i++) {
        done = put_task(page, &step->tasks[i]);
    }
    return done && page_html(page, "</td></tr>\n");
}

static bool put_note(struct bytes *page, const char *note) {
    return note == NULL || note[0] == '\0' ||
           (page_html(page, "<p>") && page_text(page, note) && page_html(page, "</p>\n"));
}

static bool put_table(struct bytes *page, const struct check_result *result) {
    bool done = page_html(page, "<p class=score>SCORE ") &&
                put_points(page, result->points, result->most) &&
                bytes_print(page, "</p>\n<p>%zu passed, %zu failed</p>\n", result->passed,
                            result->failed) &&
                page_html(page, "<div class=table><table><tr><th>step</th><th>state</th>"
                                "<th>points</th><th>tasks</th></tr>\n");
    for (size_t i = 0; done && i < result->step_count; i++) {
        done = put_row(page, &result->steps[i]);
    }
    return done && page_html(page, "</table></div>\n") && put_note(page, result->note);
}

/* ---- A step ---- */

/* What a compiler or a program said, as it said it; that of a step that does not build is open. */
static bool put_messages(struct bytes *page, const struct step_result *step) {
    return step->messages.size <= 1 ||
           (page_html(page, step->state == RESULT_BUILD ? "<details open>" : "<details>") &&
            page_html(page, "<summary>Messages</summary><pre tabindex=0>") &&
            page_text(page, (const char *)step->messages.data) &&
            page_html(page, "</pre></details>\n"));
}

/* "FAIL 0/4: 4.4 % of drawn pixels wrong ..." */
static char *note_of(const struct item_result *item) {
    const char *message = item->message.text[0] != '\0' ? item->message.text
                          : item->exact                 ? "exact"
                                                        : "";
    char counted[80] = "";
    if (item->counted > 0) {
        snprintf(counted, sizeof counted, " (counted %llu, enough %llu)",
                 (unsigned long long)item->counted, (unsigned long long)item->most);
    }
    return string_format("%s %u/%u%s%s%s", result_item_state(item), item->points,
                         item->credit->points, message[0] != '\0' ? ": " : "", message, counted);
}

static char *looks_of(const struct step_result *step, const struct item_result *item) {
    return string_format("%s %s%s", result_likeness(item), item->looks.text,
                         result_advice(step, item).text);
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

/* The mistake's small picture, and yours in the same size. None where that is not kept. */
static bool read_small(const struct item_result *item, const struct pictures *pictures,
                       struct image *mistake, struct image *small, struct error *error) {
    struct error ignored;
    const struct image *yours = &pictures->image[PICTURE_YOURS];
    const struct image *reference = &pictures->image[PICTURE_REFERENCE];
    return yours->width == 0 ||
           !looks_small(mistake, item->looks_path.text, item->looks_row, reference, &ignored) ||
           looks_shrink(small, yours, reference, error);
}

/* The item's part of the page, with its pictures: all three, or where all pixels are equal the
 * reference alone. */
static bool put_pictures(struct bytes *page, const struct step_result *step,
                         const struct item_result *item, struct page_scene scene,
                         struct error *error) {
    if (item->looks.text[0] == '\0') {
        return page_scene(page, &scene, error);
    }
    struct image mistake = {.pixels = NULL}, small = {.pixels = NULL};
    char *looks = looks_of(step, item);
    scene.looks = looks;
    scene.mistake = &mistake;
    scene.small = &small;
    bool done = (looks != NULL || error_out_of_memory(error)) &&
                read_small(item, scene.pictures, &mistake, &small, error) &&
                page_scene(page, &scene, error);
    image_free(&mistake);
    image_free(&small);
    free(looks);
    return done;
}

static bool put_item(struct bytes *page, const struct step_result *step,
                     const struct item_result *item, const char *references, struct error *error) {
    struct pictures pictures = {0};
    char *name =
        string_format("%s%s%s", item->scene, item->counter[0] != '\0' ? " " : "", item->counter);
    char *note = note_of(item), *reference = reference_of(step, item, references);
    struct page_scene scene = {.name = name, .note = note, .level = 3, .pictures = &pictures};
    bool done = name != NULL && note != NULL && reference != NULL;
    if (!done) {
        error_out_of_memory(error);
    } else if (item->counter[0] == '\0') {
        done = pictures_read(&pictures, item->yours.text, reference, item->rule, error);
    }
    bool folded = item->state == RESULT_PASS && item->exact;
    done = done && put_summary(page, folded, name, error) &&
           put_pictures(page, step, item, scene, error) &&
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
                 put_state(page, step->state) && put_points(page, step->points, step->most) &&
                 page_html(page, "</h2>\n<p>") && page_text(page, step->reason.text) &&
                 page_html(page, "</p>\n") && put_messages(page, step);
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
