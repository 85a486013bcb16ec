/* A check's result as a page for people: see export.h. */
#include "check/page/escape.h"
#include "check/page/page.h"
#include "check/page/pictures.h"
#include "export.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* "FAIL", in its colour, then the points. */
static bool put_state(struct bytes *page, enum result_state state, const char *between,
                      unsigned points, unsigned most) {
    const char *name = result_state_name(state);
    return markup_print(page, "<b class=%s>%s</b> ", name, name) &&
           bytes_append(page, between, strlen(between)) &&
           markup_print(page, "%u/%u", points, most);
}

/* ---- The table at the top ---- */

/* A step: its name leads to its part of the page. Below `perhaps` a task's fault may as well be
 * another one's. */
static bool put_row(struct bytes *page, const struct step_result *step) {
    bool done =
        markup_print(page, "<tr><td><a href=\"#%s\">%s</a></td><td>", step->name, step->name) &&
        put_state(page, step->state, "</td><td>", step->points, step->most) &&
        markup_print(page, "</td><td>");
    for (size_t i = 0; done && i < step->task_count; i++) {
        const struct task_result *task = &step->tasks[i];
        done =
            markup_print(page, "<span>%s%s", task->name.text, task->perhaps ? " perhaps " : " ") &&
            put_state(page, task->state, "", task->points, task->most) &&
            markup_print(page, "</span> ");
    }
    return done && markup_print(page, "</td></tr>\n");
}

static bool put_table(struct bytes *page, const struct check_result *result) {
    bool done = markup_print(page,
                             "<p class=score>SCORE %u/%u</p>\n<p>%u passed, %u failed</p>\n"
                             "<div class=table><table><tr><th>step</th><th>state</th>"
                             "<th>points</th><th>tasks</th></tr>\n",
                             result->points, result->most, (unsigned)result->passed,
                             (unsigned)result->failed);
    for (size_t i = 0; done && i < result->step_count; i++) {
        done = put_row(page, &result->steps[i]);
    }
    return done && markup_print(page, "</table></div>\n") &&
           (result->note == NULL || result->note[0] == '\0' ||
            markup_print(page, "<p>%s</p>\n", result->note));
}

/* ---- A step ---- */

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

/* What is drawn of it, and what it should be. */
static bool read_pictures(struct pictures *pictures, const struct step_result *step,
                          const struct item_result *item, const char *references,
                          struct error *error) {
    char *reference = string_format("%s/%s/%s.png", references, step->name, item->scene);
    bool done = reference != NULL &&
                pictures_read(pictures, item->yours.text, reference, item->rule, error);
    free(reference);
    return done;
}

/* The item's part of the page, with what it looks like and its pictures: all three, or where all
 * pixels are equal the reference alone. */
static bool put_scene(struct bytes *page, const struct step_result *step,
                      const struct item_result *item, struct page_scene scene,
                      struct error *error) {
    bool is_known = item->looks.text[0] != '\0';
    if (!is_known && (item->seen.text[0] == '\0' || item->state != RESULT_FAIL)) {
        return page_scene(page, &scene, error);
    }
    char *looks = string_format("%s%s%s%s", is_known ? result_likeness(item) : "",
                                is_known ? " " : "", is_known ? item->looks.text : item->seen.text,
                                result_advice(step, item).text);
    scene.looks = looks;
    bool done = looks != NULL && page_scene(page, &scene, error);
    free(looks);
    return done;
}

/* What is exact is folded away. */
static bool put_item(struct bytes *page, const struct step_result *step,
                     const struct item_result *item, const char *references, struct error *error) {
    struct pictures pictures = {0};
    bool folded = item->state == RESULT_PASS && item->exact;
    char *name =
        string_format("%s%s%s", item->scene, item->counter[0] != '\0' ? " " : "", item->counter);
    char *note = note_of(item);
    struct page_scene scene = {.name = name, .note = note, .level = 3, .pictures = &pictures};
    bool done =
        name != NULL && note != NULL &&
        (item->kind != ITEM_PICTURE || read_pictures(&pictures, step, item, references, error)) &&
        (!folded || markup_print(page, "<details><summary>%s: exact</summary>\n", name)) &&
        put_scene(page, step, item, scene, error) &&
        (!folded || markup_print(page, "</details>\n"));
    pictures_free(&pictures);
    free(name);
    free(note);
    return done;
}

/* What a compiler or a program said, as it said it; that of a step that does not build is open. */
static bool put_messages(struct bytes *page, const struct step_result *step) {
    return step->messages.size <= 1 ||
           markup_print(
               page, "<details%s><summary>Messages</summary><pre tabindex=0>%s</pre></details>\n",
               step->state == RESULT_BUILD ? " open" : "", (const char *)step->messages.data);
}

static bool put_step(struct bytes *page, const struct step_result *step, const char *references,
                     struct error *error) {
    bool done = markup_print(page, "<h2 id=\"%s\">%s ", step->name, step->name) &&
                put_state(page, step->state, "", step->points, step->most) &&
                markup_print(page, "</h2>\n<p>%s</p>\n", step->reason.text) &&
                put_messages(page, step);
    for (size_t i = 0; i < step->item_count && done; i++) {
        done = put_item(page, step, &step->items[i], references, error);
    }
    return done;
}

bool export_html(struct bytes *report, const struct check_result *result, struct error *error) {
    error_out_of_memory(error); /* unless something else goes wrong */
    bool done = page_begin(report, "make check") && put_table(report, result);
    for (size_t i = 0; i < result->step_count && done; i++) {
        done = put_step(report, &result->steps[i], result->references, error);
    }
    return done && page_end(report);
}
