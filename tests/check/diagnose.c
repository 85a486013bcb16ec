/* Why a step is not right: see diagnose.h. */
#define _POSIX_C_SOURCE 200809L

#include "diagnose.h"

#include "counters.h"
#include "doubt.h"
#include "todo.h"

#include <string.h>

/* ---- What is still to do ---- */

/* The task, or the part, that is as the starter has it, of those that the item shows or needs; or
 * NULL. */
static const char *find_to_do(const struct judging *judging, const struct credit *credit) {
    const char *source = (const char *)judging->source.data, *found = NULL;
    for (size_t i = 0; i < credit->task_count + credit->need_count && found == NULL; i++) {
        const char *task = i < credit->task_count ? credit->tasks[i].text
                                                  : credit->needs[i - credit->task_count].text;
        found = todo_has_task(source, task) ? task : NULL;
    }
    return found;
}

/* A task of the item that is still to do; if its picture kept it from being judged, a task of
 * that. */
static const char *find_item_to_do(const struct judging *judging, const struct item_result *item) {
    const char *task = find_to_do(judging, item->credit);
    return task == NULL && item->unjudged
               ? find_to_do(judging, result_picture_of(judging->result, item)->credit)
               : task;
}

/* What has failed is to do while such a task is, also where the program crashes for want of it. */
static void set_to_do(struct item_result *item, const char *task) {
    item->state = RESULT_TODO;
    item->blamed = false;
    item->message.text[0] = '\0';
    item->looks_row = 0;
    judging_drop_picture(&item->difference);
    const char *kind = strchr(task, '.') != NULL ? "task" : "part";
    result_say(&item->message, "%s %s is to do", kind, task);
}

void diagnose_to_do(const struct judging *judging) {
    struct step_result *result = judging->result;
    bool was_blamed = false, is_blamed = false;
    for (size_t i = 0; i < result->item_count; i++) {
        struct item_result *item = &result->items[i];
        const char *task = find_item_to_do(judging, item);
        was_blamed |= item->blamed;
        if (item->state >= RESULT_FAIL && item->state <= RESULT_CRASH && task != NULL) {
            set_to_do(item, task);
        }
        is_blamed |= item->blamed;
    }
    if (was_blamed && !is_blamed) { /* that is why the program ended so */
        result->state = RESULT_FAIL;
        result->reason.text[0] = '\0';
    }
}

/* What a task waits for that is written: what the first item needs that shows it and is to do. And
 * which ones are right, though they are to do. */
void diagnose_waiting(const struct judging *judging) {
    struct step_result *result = judging->result;
    const char *source = (const char *)judging->source.data;
    for (size_t i = 0; i < result->task_count; i++) {
        struct task_result *task = &result->tasks[i];
        const bool is_marked = todo_has_task(source, task->name.text);
        bool waits = task->state == RESULT_TODO && !is_marked;
        task->is_marked = is_marked && task->state == RESULT_PASS && task->points == task->most;
        for (size_t k = 0; k < result->item_count && waits && task->waits_for == NULL; k++) {
            const struct item_result *item = &result->items[k];
            if (item->state == RESULT_TODO &&
                task_is_among(item->credit->tasks, item->credit->task_count, task->name.text)) {
                task->waits_for = find_item_to_do(judging, item);
            }
        }
    }
}

/* ---- Which mistake it was ---- */

/* Where the program ended badly over a picture, and a function does so alone: which one it is. */
static void tell_crashing_functions(struct step_result *result) {
    for (size_t i = 0; i < result->item_count && !result->sanitized; i++) {
        struct item_result *item = &result->items[i];
        const struct item_result *numbers =
            item->blamed && item->state > RESULT_FAIL ? result_numbers_of(result, item) : NULL;
        if (numbers != NULL) {
            result_say(&item->message, "; %.*s() %s, see numbers %s",
                       (int)strcspn(numbers->message.text, "("), numbers->message.text,
                       item->state == RESULT_TIME ? "does not return" : "crashes",
                       numbers->counter);
        }
    }
}

/* Say that the item looks like these mistakes, as far as what else is known allows it. */
static void tell_of(const struct judging *judging, struct item_result *item,
                    struct mistake_set set) {
    const struct suspicion suspicion = {.result = judging->result,
                                        .looks = judging->looks,
                                        .scene_count = judging->step->scene_count,
                                        .source = (const char *)judging->source.data,
                                        .item = item};
    for (size_t i = 0; i < set.count; i++) {
        set.doubts[i] = doubt_find(&suspicion, set.list[i]);
    }
    mistakes_tell(item, &set);
}

/* Say what the wrong pictures look like, now that all is known. */
static void tell_likenesses(const struct judging *judging) {
    for (size_t i = 0; i < judging->step->scene_count; i++) {
        struct item_result *item = &judging->result->items[i];
        const struct looks *looks = &judging->looks[i];
        item->only_may_be = item->looks_row > 0 && item->looks_row == looks->starter;
        tell_of(judging, item, looks_mistakes(looks, item->looks_row));
    }
}

/* Does it fail for its work, which no picture shows? */
static bool is_wrong_work(const struct item_result *item) {
    return item->rule->kind == ITEM_COUNTER && item->state == RESULT_FAIL && !item->blamed &&
           !item->unjudged;
}

/* Is it a picture that says nothing, blank or missing for a division by 0? */
static bool is_not_there(const struct item_result *item) {
    return (item->state == RESULT_FAIL && item->blank) ||
           (item->state == RESULT_CRASH && item->divided);
}

/* Say which mistakes show the same as the item, where no picture does. */
static void tell_counted(const struct judging *judging, struct item_result *item,
                         const char *output) {
    struct counted yours;
    if (counted_of(&yours, judging->result, item, output)) {
        item->only_may_be |= item->kind == ITEM_PICTURE;
        tell_of(judging, item, counted_find(&judging->mistakes, &yours));
        judging_append(judging->options->counted, "%s\n", yours.text);
    }
}

/* Count all wrong items once more, with all else, and tell of each. */
static bool count_and_tell(const struct judging *judging, struct error *error) {
    bool done = true;
    for (size_t i = 0; i < judging->result->item_count && done; i++) {
        struct item_result *item = &judging->result->items[i];
        struct bytes output = {.data = NULL};
        struct run_result end = {.end = RUN_EXITED};
        if (is_not_there(item)) {
            tell_counted(judging, item, "");
        } else if (is_wrong_work(item)) {
            done = judging_count(judging, item->scene, &output, &end, error);
            if (done && judging_ended_well(&end)) {
                tell_counted(judging, item, (const char *)output.data);
            }
        }
        bytes_free(&output);
        bytes_free(&end.messages);
    }
    return done;
}

bool diagnose_mistakes(const struct judging *judging, struct error *error) {
    tell_crashing_functions(judging->result);
    tell_likenesses(judging);
    return count_and_tell(judging, error);
}
