#include "result.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *result_state_name(enum result_state state) {
    static const char *const names[] = {
        [RESULT_PASS] = "PASS",   [RESULT_TODO] = "TODO",   [RESULT_FAIL] = "FAIL",
        [RESULT_TIME] = "TIME",   [RESULT_CRASH] = "CRASH", [RESULT_BUILD] = "BUILD",
        [RESULT_ERROR] = "ERROR",
    };
    return names[state];
}

const char *result_item_state(const struct item_result *item) {
    return item->unjudged && item->state != RESULT_TODO ? "NOT JUDGED"
                                                        : result_state_name(item->state);
}

void result_say(struct result_text *text, const char *format, ...) {
    size_t length = strlen(text->text);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text->text + length, sizeof text->text - length, format, arguments);
    va_end(arguments);
}

bool check_result_create(struct check_result *result, size_t step_count, struct error *error) {
    *result = (struct check_result){.steps = calloc(step_count + 1, sizeof *result->steps)};
    return result->steps != NULL || error_out_of_memory(error);
}

void check_result_free(struct check_result *result) {
    for (size_t i = 0; i < result->step_count; i++) {
        free(result->steps[i].items);
        free(result->steps[i].tasks);
        bytes_free(&result->steps[i].messages);
    }
    free(result->steps);
    *result = (struct check_result){.steps = NULL};
}

bool step_result_begin(struct step_result *result, const struct checked_step *step,
                       struct error *error) {
    *result = (struct step_result){.name = step->name, .state = RESULT_FAIL};
    result->item_count = step->item_count;
    result->items = calloc(result->item_count, sizeof *result->items);
    result->tasks = calloc(result->item_count * SCENE_TASK_LIMIT, sizeof *result->tasks);
    if (result->items == NULL || result->tasks == NULL) {
        result->item_count = 0;
        return error_out_of_memory(error);
    }
    for (size_t i = 0; i < result->item_count; i++) {
        const struct checked_item *rule = &step->items[i];
        result->items[i] = (struct item_result){.scene = rule->scene,
                                                .counter = rule->counter,
                                                .is_numbers = rule->kind == ITEM_NUMBERS,
                                                .credit = &rule->credit,
                                                .rule = rule,
                                                .state = RESULT_FAIL,
                                                .most = rule->most,
                                                .least = rule->least};
    }
    return true;
}

/* ---- The sums ---- */

static struct task_result *find_task(struct step_result *result, struct task_name name) {
    for (size_t i = 0; i < result->task_count; i++) {
        if (strcmp(result->tasks[i].name.text, name.text) == 0) {
            return &result->tasks[i];
        }
    }
    struct task_result *task = &result->tasks[result->task_count++];
    task->name = name;
    return task;
}

const struct item_result *result_picture_of(const struct step_result *result,
                                            const struct item_result *item) {
    const struct item_result *picture = result->items; /* pictures come first */
    while (strcmp(picture->scene, item->scene) != 0) {
        picture++;
    }
    return picture;
}

bool result_is_right(const struct step_result *result, const char *task) {
    for (size_t i = 0; i < result->item_count; i++) {
        const struct item_result *item = &result->items[i];
        bool is_picture = item->counter[0] == '\0';
        if (item->state == RESULT_PASS && is_picture && item->credit->task_count == 1 &&
            strcmp(item->credit->tasks[0].text, task) == 0) {
            return true;
        }
    }
    return false;
}

/* How many of a failing item's tasks are shown right by no other scene. */
static size_t count_suspects(const struct step_result *result, const struct credit *credit) {
    size_t suspects = 0;
    for (size_t i = 0; i < credit->task_count; i++) {
        suspects += !result_is_right(result, credit->tasks[i].text);
    }
    return suspects;
}

const char *result_likeness(const struct item_result *item) {
    return item->only_may_be ? "may be" : "looks like";
}

static bool are_wrong_numbers(const struct item_result *item) {
    return item->is_numbers && (item->state == RESULT_FAIL || item->state == RESULT_TIME ||
                                item->state == RESULT_CRASH);
}

/* Do these numbers need a task whose own numbers are wrong? Then they say nothing. */
static bool is_need_of_numbers_wrong(const struct step_result *result,
                                     const struct item_result *numbers) {
    bool wrong = false;
    for (size_t i = 0; i < result->item_count; i++) {
        const struct item_result *other = &result->items[i];
        wrong |= are_wrong_numbers(other) && credit_needs(numbers->credit, other->counter);
    }
    return wrong;
}

/* Do wrong numbers say that this task is at fault in the item, which shows or needs it, or ends as
 * badly as the calls did? */
static bool numbers_blame(const struct step_result *result, const struct item_result *item,
                          const char *task) {
    for (size_t i = 0; i < result->item_count; i++) {
        const struct item_result *numbers = &result->items[i];
        if (are_wrong_numbers(numbers) && strcmp(numbers->counter, task) == 0 &&
            !is_need_of_numbers_wrong(result, numbers) &&
            (credit_has(item->credit, task) ||
             (item->state > RESULT_FAIL && item->state == numbers->state))) {
            return true;
        }
    }
    return false;
}

const struct item_result *result_numbers_of(const struct step_result *result,
                                            const struct item_result *item) {
    for (size_t i = 0; i < result->item_count; i++) {
        const struct item_result *numbers = &result->items[i];
        if (are_wrong_numbers(numbers) && numbers->state == item->state &&
            !is_need_of_numbers_wrong(result, numbers)) {
            return numbers;
        }
    }
    return NULL;
}

/* The first task of which that is true for the item: its number, or task_count. */
static size_t first_task(const struct step_result *result, const struct item_result *item,
                         bool is_true(const struct step_result *result,
                                      const struct item_result *item, const char *task)) {
    size_t i = 0;
    while (i < result->task_count && !is_true(result, item, result->tasks[i].name.text)) {
        i++;
    }
    return i;
}

/* The first task that may be to blame for an item that is wrong. */
static const char *first_suspect(const struct step_result *result, const struct item_result *item) {
    const struct credit *credit = item->credit;
    size_t blamed = first_task(result, item, numbers_blame);
    if (blamed < result->task_count) {
        return result->tasks[blamed].name.text;
    }
    if (item->looks_task_count > 0) {
        return item->looks_tasks[0].text;
    }
    for (size_t i = 0; i < credit->task_count; i++) {
        if (!result_is_right(result, credit->tasks[i].text)) {
            return credit->tasks[i].text;
        }
    }
    return credit->tasks[0].text;
}

struct result_text result_advice(const struct step_result *result, const struct item_result *item) {
    struct result_text advice = {""};
    for (size_t i = 0; i < item->looks_figure_count; i++) {
        if (i == 0) {
            result_say(&advice, ": see %s/WRONG.md, figure ", result->name);
        }
        result_say(&advice, "%s%u", i > 0 ? " or " : "", item->looks_figures[i]);
    }
    const char *first = first_suspect(result, item);
    result_say(&advice, "; make hint STEP=%.2s TASK=%s", result->name + strlen("step"), first);
    for (size_t i = 1; i < item->looks_task_count; i++) {
        if (strcmp(item->looks_tasks[i].text, first) != 0) {
            result_say(&advice, " or TASK=%s", item->looks_tasks[i].text);
        }
    }
    return advice;
}

/* Does the item look like a mistake of this task, which it shows or needs? What only may be one
 * names none. */
static bool names(const struct step_result *result, const struct item_result *item,
                  const char *task) {
    (void)result;
    return !item->only_may_be && task_is_among(item->looks_tasks, item->looks_task_count, task) &&
           credit_has(item->credit, task);
}

/* May this task be at fault in the item, which is wrong? */
static bool is_suspect(const struct step_result *result, const struct item_result *item,
                       const char *task) {
    const struct credit *credit = item->credit;
    const struct item_result *told = item->unjudged ? result_picture_of(result, item) : item;
    if (first_task(result, told, numbers_blame) < result->task_count) {
        return numbers_blame(result, told, task);
    }
    if (first_task(result, told, names) < result->task_count) {
        return names(result, told, task);
    }
    bool may_be_right =
        item->state == RESULT_FAIL && (item->unjudged || count_suspects(result, credit) > 0);
    return task_is_among(credit->tasks, credit->task_count, task) &&
           !(may_be_right && result_is_right(result, task));
}

/* May the fault be that of a task that the item needs? */
static bool is_need_wrong(const struct step_result *result, const struct credit *credit) {
    bool wrong = false;
    for (size_t i = 0; i < result->task_count; i++) {
        const struct task_result *task = &result->tasks[i];
        wrong |= task->state != RESULT_PASS && credit_needs(credit, task->name.text);
    }
    return wrong;
}

/* Is it not known whose fault the item is? The states of all tasks are known. */
static bool is_unsure(const struct step_result *result, const struct item_result *item) {
    const struct credit *credit = item->credit;
    if (item->state != RESULT_FAIL ||
        first_task(result, item, numbers_blame) < result->task_count) {
        return false;
    }
    if (item->looks_task_count > 0 && !item->only_may_be) {
        const char *named = item->looks_tasks[0].text;
        return item->looks_task_count > 1 ||
               !task_is_among(credit->tasks, credit->task_count, named);
    }
    bool is_shared = credit->task_count > 1 && count_suspects(result, credit) != 1;
    return item->unjudged || is_shared || is_need_wrong(result, credit);
}

static void add_item(struct step_result *result, struct item_result *item) {
    const struct credit *credit = item->credit;
    item->points = item->state == RESULT_PASS ? credit->points : 0;
    result->points += item->points;
    result->most += credit->points;
    result->passed += item->state == RESULT_PASS;
    result->pictures_exact += item->exact;
    for (size_t i = 0; i < credit->task_count; i++) {
        struct task_result *task = find_task(result, credit->tasks[i]);
        task->points += item->points / (unsigned)credit->task_count;
        task->most += credit->points / (unsigned)credit->task_count;
    }
}

/* The first item of the task's state, of those that may be its fault; NULL for a right task. */
static const struct item_result *find_worst(const struct step_result *result,
                                            const struct task_result *task) {
    const struct item_result *worst = NULL;
    enum result_state state = RESULT_PASS;
    for (size_t i = 0; i < result->item_count; i++) {
        const struct item_result *item = &result->items[i];
        if (item->state > state && is_suspect(result, item, task->name.text)) {
            state = item->state;
            worst = item;
        }
    }
    return worst;
}

/* The first picture that fails decides if a task is to blame for sure: a later one may need what
 * the first one shows as well. */
static void judge_tasks(struct step_result *result) {
    for (size_t i = 0; i < result->task_count; i++) {
        const struct item_result *worst = find_worst(result, &result->tasks[i]);
        result->tasks[i].state = worst != NULL ? worst->state : RESULT_PASS;
    }
    for (size_t i = 0; i < result->task_count; i++) {
        const struct item_result *worst = find_worst(result, &result->tasks[i]);
        result->tasks[i].perhaps = worst != NULL && is_unsure(result, worst);
    }
}

void step_result_finish(struct step_result *result) {
    enum result_state worst = RESULT_PASS;
    for (size_t i = 0; i < result->item_count; i++) {
        add_item(result, &result->items[i]);
        worst = result->items[i].state > worst ? result->items[i].state : worst;
    }
    judge_tasks(result);
    bool is_open = result->state == RESULT_FAIL; /* not said by how the program ended */
    if (is_open && (worst > RESULT_FAIL || result->reason.text[0] == '\0')) {
        result->state = worst;
    }
}

void check_result_add(struct check_result *result, const struct step_result *step) {
    result->passed += step->state == RESULT_PASS;
    result->failed += step->state != RESULT_PASS;
    result->points += step->points;
    result->most += step->most;
    result->cannot_work |= step->state == RESULT_ERROR;
    for (size_t i = 0; i < step->item_count; i++) {
        result->cannot_work |= step->items[i].state == RESULT_ERROR;
    }
}
