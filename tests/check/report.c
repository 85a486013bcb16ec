#include "report.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

/* Does an item tell how the program ended? */
static bool is_blamed(const struct step_result *step) {
    bool blamed = false;
    for (size_t i = 0; i < step->item_count; i++) {
        blamed |= step->items[i].blamed;
    }
    return blamed;
}

static bool is_exact(const struct step_result *step) {
    for (size_t i = 0; i < step->item_count; i++) {
        if (step->items[i].message.text[0] != '\0') {
            return false;
        }
    }
    return step->state == RESULT_PASS;
}

/* Does an item before this one look like the same mistake? */
static bool is_told(const struct step_result *step, const struct item_result *item) {
    bool told = false;
    for (const struct item_result *other = step->items; other < item; other++) {
        told |= item->looks.text[0] != '\0' && strcmp(other->looks.text, item->looks.text) == 0;
    }
    return told;
}

/* Is the same to be seen in an item before this one, with the same hint? */
static bool is_seen(const struct step_result *step, const struct item_result *item) {
    const struct result_text advice = result_advice(step, item);
    bool seen = false;
    for (const struct item_result *other = step->items; other < item; other++) {
        seen |= strcmp(other->seen.text, item->seen.text) == 0 && other->looks.text[0] == '\0' &&
                strcmp(result_advice(step, other).text, advice.text) == 0;
    }
    return seen;
}

/* Can only a hint be given, and is it not the one given before? */
static bool wants_hint(const struct step_result *step, const struct item_result *item) {
    bool wants = item->looks.text[0] == '\0' && item->state >= RESULT_FAIL &&
                 item->state <= RESULT_CRASH && !item->unjudged;
    const struct result_text advice = result_advice(step, item);
    for (size_t i = 0; wants && i < step->item_count; i++) {
        const struct item_result *other = &step->items[i];
        bool is_before = (other->kind == ITEM_NUMBERS) == (item->kind == ITEM_NUMBERS)
                             ? other < item
                             : other->kind == ITEM_NUMBERS;
        bool is_wrong = other->state >= RESULT_FAIL && other->state <= RESULT_CRASH;
        wants =
            !is_before || !is_wrong || strcmp(result_advice(step, other).text, advice.text) != 0;
    }
    return wants;
}

static void report_item(const struct step_result *step, const struct item_result *item,
                        bool hints) {
    printf("  %s%s%s %s %u/%u", item->scene, item->counter[0] != '\0' ? " " : "", item->counter,
           result_item_state(item), item->points, item->credit->points);
    if (item->message.text[0] != '\0') {
        printf(": %s", item->message.text);
    }
    printf("\n");
    if (is_told(step, item)) {
        printf("    %s the same\n", result_likeness(item));
    } else if (item->looks.text[0] != '\0') {
        printf("    %s %s%s\n", result_likeness(item), item->looks.text,
               result_advice(step, item).text);
    } else if (item->seen.text[0] != '\0' && item->state == RESULT_FAIL) {
        bool seen = is_seen(step, item);
        printf("    %s%s\n", seen ? "the same" : item->seen.text,
               seen ? "" : result_advice(step, item).text);
    } else if ((hints || item->kind == ITEM_NUMBERS) && wants_hint(step, item)) {
        printf("    %s\n", result_advice(step, item).text + strlen("; "));
    }
}

/* The letter of a lesson's part in "8b.2", 0 for a lesson without parts. */
static char part_of(const struct task_result *task) {
    char letter = task->name.text[strspn(task->name.text, "0123456789")];
    return islower((unsigned char)letter) ? letter : '\0';
}

/* One line for the tasks of a part, with its points. */
static void report_part(const struct step_result *step, char part) {
    unsigned points = 0, most = 0;
    for (size_t i = 0; i < step->task_count; i++) {
        if (part_of(&step->tasks[i]) == part) {
            points += step->tasks[i].points;
            most += step->tasks[i].most;
        }
    }
    if (part != '\0') {
        printf("  part %c %u/%u:", part, points, most);
    } else {
        printf("  tasks:");
    }
    const char *comma = "";
    for (size_t i = 0; i < step->task_count; i++) {
        const struct task_result *task = &step->tasks[i];
        if (part_of(task) == part) {
            const char *state = task->state == RESULT_PASS ? ""
                                : task->waits_for != NULL  ? "waits for "
                                                           : result_state_name(task->state);
            printf("%s %s%s%s%s%s %u/%u", comma, task->name.text, task->perhaps ? " perhaps" : "",
                   state[0] != '\0' ? " " : "", state,
                   task->waits_for != NULL ? task->waits_for : "", task->points, task->most);
            comma = ",";
        }
    }
    printf("\n");
}

/* First those of no part. */
static void report_tasks(const struct step_result *step) {
    static const char parts[] = "\0abcdefghijklmnopqrstuvwxyz";
    for (size_t p = 0; p + 1 < sizeof parts; p++) {
        const char part = parts[p];
        bool found = false;
        for (size_t i = 0; i < step->task_count; i++) {
            found |= part_of(&step->tasks[i]) == part;
        }
        if (found) {
            report_part(step, part);
        }
    }
}

static void report_warnings(const struct step_result *step) {
    if (step->warning.text[0] == '\0') {
        return;
    }
    printf("  the compiler warns: %s", step->warning.text);
    if (step->more_warnings > 0) {
        printf(" (and of %zu more)", step->more_warnings);
    }
    printf("\n");
}

/* Comments of the starter that have stayed. */
static void report_marked(const struct step_result *step) {
    for (size_t i = 0; i < step->task_count; i++) {
        const char *task = step->tasks[i].name.text;
        if (step->tasks[i].is_marked) {
            printf("  task %s is right: its comment `to do %s` in main.c can go\n", task, task);
        }
    }
}

/* What follows the rows of a step. */
static void report_advice(const struct step_result *step) {
    report_warnings(step);
    report_marked(step);
    if (step->state == RESULT_CRASH && !step->sanitized) {
        printf("  make check STEP=%.2s SANITIZE=1 says in which line\n",
               step->name + strlen("step"));
    }
    if (step->state != RESULT_PASS && step->task_count > 1) {
        report_tasks(step);
    }
}

/* Numbers, or the others. */
static void report_items(const struct step_result *step, bool numbers) {
    for (size_t i = 0; i < step->item_count; i++) {
        const struct item_result *item = &step->items[i];
        bool passes = item->state == RESULT_PASS && step->state != RESULT_PASS;
        if ((item->kind == ITEM_NUMBERS) == numbers && (passes || item->message.text[0] != '\0')) {
            report_item(step, item, false);
        }
    }
}

/* ---- What to do next ---- */

/* Do the calls of a task fail, and are its fault? */
static bool has_wrong_numbers(const struct step_result *step, const struct task_result *task) {
    bool wrong = false;
    for (size_t i = 0; i < step->item_count; i++) {
        const struct item_result *item = &step->items[i];
        wrong |= item->kind == ITEM_NUMBERS && item->state >= RESULT_FAIL &&
                 item->state <= RESULT_CRASH && strcmp(item->counter, task->name.text) == 0;
    }
    return wrong && !task->perhaps;
}

/* Of the tasks that only may be at fault, and whose calls pass, the one that the first item which
 * is wrong leads to. */
static const struct task_result *find_last_resort(const struct step_result *step) {
    const char *task = "";
    for (size_t i = step->item_count; i-- > 0;) {
        const struct item_result *item = &step->items[i];
        bool is_wrong = item->state >= RESULT_FAIL && item->state <= RESULT_CRASH;
        task = is_wrong && !item->unjudged ? result_first_suspect(step, item) : task;
    }
    size_t i = 0;
    while (i < step->task_count && strcmp(step->tasks[i].name.text, task) != 0) {
        i++;
    }
    return i < step->task_count ? &step->tasks[i] : NULL;
}

/* The task to go on with: the first whose calls fail, else that is wrong for sure, else that
 * perhaps is, rather one whose calls do not pass; else the first that is to do; or NULL. */
static const struct task_result *find_next(const struct step_result *step) {
    enum { WRONG_CALLS, OTHERS, LAST_RESORT = OTHERS + 3, TO_DO, NOTHING };
    const struct task_result *next = NULL;
    int least = NOTHING;
    for (size_t i = 0; i < step->task_count; i++) {
        const struct task_result *task = &step->tasks[i];
        const bool passes = result_calls_are_right(step, task->name.text);
        const bool is_open = task->state != RESULT_PASS && task->state != RESULT_ERROR;
        int rank = !is_open || task->waits_for != NULL ? NOTHING
                   : task->state == RESULT_TODO        ? TO_DO
                   : has_wrong_numbers(step, task)     ? WRONG_CALLS
                                                       : OTHERS + 2 * passes + task->perhaps;
        next = rank < least ? task : next;
        least = rank < least ? rank : least;
    }
    return least == LAST_RESORT ? find_last_resort(step) : next;
}

void report_step(const struct step_result *step) {
    printf("%s  %s %zu/%zu SCORE %u/%u%s", step->name, result_state_name(step->state), step->passed,
           step->item_count, step->points, step->most, is_exact(step) ? " exact" : "");
    if (step->reason.text[0] != '\0' && !is_blamed(step)) {
        printf(": %s", step->reason.text);
    }
    printf("\n");
    report_items(step, true);
    report_items(step, false);
    report_advice(step);
    const struct task_result *next = find_next(step);
    if (next != NULL && step->state != RESULT_BUILD) {
        printf("  next: task %s\n", next->name.text);
    }
    fflush(stdout); /* so that each step is seen as soon as it is known */
}

/* The difference images: of everything not exact, or only of what does not pass. */
static void report_differences(const struct check_result *result, bool only_failed) {
    bool any = false;
    for (size_t i = 0; i < result->step_count; i++) {
        const struct step_result *step = &result->steps[i];
        for (size_t k = 0; k < step->item_count; k++) {
            const struct item_result *item = &step->items[k];
            if (item->difference.text[0] != '\0' && !(only_failed && item->state == RESULT_PASS)) {
                printf("%s  %s\n",
                       any ? ""
                           : "Difference images (reference, yours, difference, side by side):\n",
                       item->difference.text);
                any = true;
            }
        }
    }
}

static bool report_written(struct error *error) {
    return (fflush(stdout) == 0 && !ferror(stdout)) ||
           error_set(error, "the score could not be written to standard output");
}

bool report_end(const struct check_result *result, struct error *error) {
    printf("SCORE %u/%u\n%zu passed, %zu failed\n", result->points, result->most, result->passed,
           result->failed);
    report_differences(result, false);
    return report_written(error);
}

/* ---- To a person at a terminal ---- */

/* What passes, in one line; what is not exact, though, has a row. */
static void report_right_items(const struct step_result *step) {
    const char *before = "  right: ";
    for (size_t i = 0; i < step->item_count; i++) {
        const struct item_result *item = &step->items[i];
        if (item->state == RESULT_PASS && item->message.text[0] == '\0') {
            printf("%s%s%s%s", before, item->scene, item->counter[0] != '\0' ? " " : "",
                   item->counter);
            before = ", ";
        }
    }
    printf("%s", before[0] == ',' ? "\n" : "");
}

/* Numbers, or the others. Only the first picture that is to do is shown; returns how many items
 * more are to come. */
static size_t report_items_to_person(const struct step_result *step, bool numbers) {
    size_t to_come = 0;
    bool at_hand = numbers;
    for (size_t i = 0; i < step->item_count; i++) {
        const struct item_result *item = &step->items[i];
        bool comes = item->state == RESULT_TODO || item->unjudged;
        if ((item->kind == ITEM_NUMBERS) != numbers) {
            continue;
        }
        if (item->message.text[0] != '\0' && !(comes && at_hand)) {
            report_item(step, item, true);
            at_hand |= comes;
        } else if (comes) {
            to_come++;
        }
    }
    return to_come;
}

void report_step_to_person(const struct step_result *step) {
    printf("%s: %zu of %zu right, %u of %u points", step->name, step->passed, step->item_count,
           step->points, step->most);
    printf("%s%s\n", step->reason.text[0] != '\0' && !is_blamed(step) ? ": " : "",
           is_blamed(step) ? "" : step->reason.text);
    report_right_items(step);
    size_t to_come = report_items_to_person(step, true);
    to_come += report_items_to_person(step, false);
    if (to_come > 0) {
        printf("  %zu more to come; VERBOSE=1 shows all\n", to_come);
    }
    report_advice(step);
    fflush(stdout);
}

bool report_is_unfinished(const struct check_result *result) {
    bool only_to_do = result->failed > 0;
    for (size_t i = 0; i < result->step_count; i++) {
        enum result_state state = result->steps[i].state;
        only_to_do = only_to_do && (state == RESULT_PASS || state == RESULT_TODO);
    }
    return only_to_do;
}

/* What to do now, in the first lesson that is not right. */
static void report_next(const struct check_result *result) {
    for (size_t i = 0; i < result->step_count; i++) {
        const struct step_result *step = &result->steps[i];
        if (step->state == RESULT_BUILD) {
            printf("%s\n",
                   step->build_stopped
                       ? "Nothing is known of it yet: check again when the machine is less busy."
                       : "First let it build.");
            return;
        }
        const struct task_result *task = find_next(step);
        if (task != NULL) {
            printf("%s task %s; `make hint STEP=%.2s TASK=%s` gives a hint.\n",
                   task->state == RESULT_TODO ? "Next:" : "First put right:", task->name.text,
                   step->name + strlen("step"), task->name.text);
            return;
        }
    }
}

bool report_end_to_person(const struct check_result *result, struct error *error) {
    report_differences(result, true);
    if (result->failed == 0) {
        printf("All %u points.", result->points);
        if (result->step_count == 1) {
            printf(" `make show STEP=%.2s` shows your pictures.",
                   result->steps[0].name + strlen("step"));
        }
        printf("\n");
    } else {
        printf("%u of %u points. ", result->points, result->most);
        report_next(result);
    }
    return report_written(error);
}
