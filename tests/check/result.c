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
    const bool is_open = item->unjudged || item->spoilt_by != NULL;
    return is_open && item->state != RESULT_TODO ? "NOT JUDGED" : result_state_name(item->state);
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

/* By their parts and numbers: "8a.2" is before "8b.1". */
static int compare_tasks(const void *a, const void *b) {
    const struct task_result *p = a, *q = b;
    const char *left = p->name.text + strspn(p->name.text, "0123456789");
    const char *right = q->name.text + strspn(q->name.text, "0123456789");
    return strcmp(left, right);
}

/* All tasks, in the order of the lesson. */
static void list_tasks(struct step_result *result) {
    for (size_t i = 0; i < result->item_count; i++) {
        const struct credit *credit = result->items[i].credit;
        for (size_t k = 0; k < credit->task_count; k++) {
            find_task(result, credit->tasks[k]);
        }
    }
    qsort(result->tasks, result->task_count, sizeof *result->tasks, compare_tasks);
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
                                                .kind = rule->kind,
                                                .credit = &rule->credit,
                                                .rule = rule,
                                                .state = RESULT_FAIL,
                                                .most = rule->most,
                                                .least = rule->least};
    }
    list_tasks(result);
    return true;
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
        bool is_picture = item->kind == ITEM_PICTURE;
        if (item->state == RESULT_PASS && is_picture && item->credit->task_count == 1 &&
            strcmp(item->credit->tasks[0].text, task) == 0) {
            return true;
        }
    }
    return false;
}

/* ---- Who may be at fault ---- */

/* Failed, and not just unfinished or beyond the check. */
static bool is_wrong(const struct item_result *item) {
    return item->state == RESULT_FAIL || item->state == RESULT_TIME || item->state == RESULT_CRASH;
}

/* Do these numbers need a task whose own numbers are wrong? Then they say nothing. */
static bool say_nothing(const struct step_result *result, const struct item_result *numbers) {
    bool nothing = numbers->spoilt_by != NULL;
    for (size_t i = 0; i < result->item_count; i++) {
        const struct item_result *other = &result->items[i];
        nothing |= other->kind == ITEM_NUMBERS && is_wrong(other) && other->spoilt_by == NULL &&
                   credit_needs(numbers->credit, other->counter);
    }
    return nothing;
}

/* The numbers that show the task wrong; NULL where none do. */
static const struct item_result *find_wrong_numbers(const struct step_result *result,
                                                    const char *task) {
    for (size_t i = 0; i < result->item_count; i++) {
        const struct item_result *item = &result->items[i];
        if (item->kind == ITEM_NUMBERS && is_wrong(item) && strcmp(item->counter, task) == 0 &&
            !say_nothing(result, item)) {
            return item;
        }
    }
    return NULL;
}

bool result_calls_are_right(const struct step_result *result, const char *task) {
    bool right = false;
    for (size_t i = 0; i < result->item_count; i++) {
        const struct item_result *item = &result->items[i];
        right |= item->kind == ITEM_NUMBERS && item->state == RESULT_PASS &&
                 strcmp(item->counter, task) == 0;
    }
    return right;
}

/* Do wrong numbers say that this task is at fault in the item, where its faults can show, or which
 * ends as badly as the calls did? */
static bool numbers_blame(const struct step_result *result, const struct item_result *item,
                          const char *task) {
    const struct item_result *numbers = find_wrong_numbers(result, task);
    return numbers != NULL && (credit_has(item->credit, task) ||
                               (item->state > RESULT_FAIL && item->state == numbers->state));
}

const struct item_result *result_numbers_of(const struct step_result *result,
                                            const struct item_result *item) {
    for (size_t i = 0; i < result->item_count; i++) {
        const struct item_result *numbers = &result->items[i];
        if (numbers->kind == ITEM_NUMBERS && numbers->state == item->state &&
            find_wrong_numbers(result, numbers->counter) == numbers) {
            return numbers;
        }
    }
    return NULL;
}

/* Does the item look like a mistake of this task, whose faults can show in it? What only may be one
 * names none. */
static bool names(const struct step_result *result, const struct item_result *item,
                  const char *task) {
    (void)result;
    return !item->only_may_be && task_is_among(item->looks_tasks, item->looks_task_count, task) &&
           credit_has(item->credit, task);
}

/* The first task of which that is true for the item; NULL for none. */
static const char *first_task(const struct step_result *result, const struct item_result *item,
                              bool is_true(const struct step_result *result,
                                           const struct item_result *item, const char *task)) {
    for (size_t i = 0; i < result->task_count; i++) {
        if (is_true(result, item, result->tasks[i].name.text)) {
            return result->tasks[i].name.text;
        }
    }
    return NULL;
}

bool result_numbers_blame_others(const struct step_result *result, const struct item_result *item,
                                 const char *task) {
    return first_task(result, item, numbers_blame) != NULL && !numbers_blame(result, item, task);
}

/* What is known of whose fault an item is that is wrong. */
struct culprits {
    /* The item that shows it: the item itself, or its picture where that is why it fails. */
    const struct item_result *shown_by;
    /* Says of each task whether it is at fault; NULL where nothing names one. */
    bool (*blames)(const struct step_result *result, const struct item_result *item,
                   const char *task);
};

static struct culprits find_culprits(const struct step_result *result,
                                     const struct item_result *item) {
    struct culprits culprits = {.shown_by =
                                    item->unjudged ? result_picture_of(result, item) : item};
    if (first_task(result, culprits.shown_by, numbers_blame) != NULL) {
        culprits.blames = numbers_blame;
    } else if (first_task(result, culprits.shown_by, names) != NULL) {
        culprits.blames = names;
    }
    return culprits;
}

/* What speaks for a task that an item shows: the more, the less it may be at fault. */
enum evidence { EVIDENCE_NONE, EVIDENCE_CALLS, EVIDENCE_PICTURE };

static enum evidence find_evidence(const struct step_result *result, const char *task) {
    return result_is_right(result, task)          ? EVIDENCE_PICTURE
           : result_calls_are_right(result, task) ? EVIDENCE_CALLS
                                                  : EVIDENCE_NONE;
}

/* The least that speaks for one of the tasks that the item shows: those may be at fault. */
static enum evidence find_least_evidence(const struct step_result *result,
                                         const struct credit *credit) {
    enum evidence least = EVIDENCE_PICTURE;
    for (size_t i = 0; i < credit->task_count; i++) {
        enum evidence found = find_evidence(result, credit->tasks[i].text);
        least = found < least ? found : least;
    }
    return least;
}

/* Of the tasks that the item shows, as many may be at fault. */
static size_t count_suspects(const struct step_result *result, const struct credit *credit) {
    size_t suspects = 0;
    for (size_t i = 0; i < credit->task_count; i++) {
        suspects +=
            find_evidence(result, credit->tasks[i].text) == find_least_evidence(result, credit);
    }
    return suspects;
}

const char *result_likeness(const struct item_result *item) {
    return item->only_may_be ? "may be" : "looks like";
}

const char *result_first_suspect(const struct step_result *result, const struct item_result *item) {
    const struct credit *credit = item->credit;
    const struct culprits culprits = find_culprits(result, item);
    if (culprits.blames != NULL) {
        return first_task(result, culprits.shown_by, culprits.blames);
    }
    if (item->looks_task_count > 0) {
        return item->looks_tasks[0].text;
    }
    const enum evidence least = find_least_evidence(result, credit);
    const char *suspect = NULL;
    for (size_t i = 0; i < credit->task_count; i++) {
        const char *task = credit->tasks[i].text;
        if (find_evidence(result, task) == least && (suspect == NULL || least > EVIDENCE_NONE)) {
            suspect = task;
        }
    }
    return suspect;
}

struct result_text result_advice(const struct step_result *result, const struct item_result *item) {
    struct result_text advice = {""};
    for (size_t i = 0; i < item->looks_figure_count; i++) {
        if (i == 0) {
            result_say(&advice, ": see %s/WRONG.md, figure ", result->name);
        }
        result_say(&advice, "%s%u", i > 0 ? " or " : "", item->looks_figures[i]);
    }
    const char *first = result_first_suspect(result, item);
    result_say(&advice, "; make hint STEP=%.2s TASK=%s", result->name + strlen("step"), first);
    for (size_t i = 0; i < item->looks_task_count; i++) {
        const char *other = item->looks_tasks[i].text;
        if (strcmp(other, first) != 0 && !result_numbers_blame_others(result, item, other)) {
            result_say(&advice, " or TASK=%s", other);
        }
    }
    return advice;
}

/* May this task be at fault in the item, which is wrong? */
static bool is_suspect(const struct step_result *result, const struct item_result *item,
                       const char *task) {
    const struct credit *credit = item->credit;
    const struct culprits culprits = find_culprits(result, item);
    if (culprits.blames != NULL) {
        return culprits.blames(result, culprits.shown_by, task);
    }
    const enum evidence most = item->unjudged ? EVIDENCE_NONE : find_least_evidence(result, credit);
    return task_is_among(credit->tasks, credit->task_count, task) &&
           find_evidence(result, task) <= most;
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
    if (item->state != RESULT_FAIL || first_task(result, item, numbers_blame) != NULL) {
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

/* ---- Points ---- */

/* Does something that is not drawn by calls show what the step's functions are worth? A picture or
 * a count that passes; or there is none that is wrong, but by tasks that are known. (Calls are made
 * in the student's program, which can tamper with them.) */
static bool has_evidence(const struct step_result *result) {
    bool any_wrong = false;
    for (size_t i = 0; i < result->item_count; i++) {
        const struct item_result *item = &result->items[i];
        if (item->kind != ITEM_NUMBERS && item->state == RESULT_PASS) {
            return true;
        }
        any_wrong |= item->kind != ITEM_NUMBERS && is_wrong(item) &&
                     find_culprits(result, item).blames == NULL;
    }
    return !any_wrong;
}

/* Does the task get its share of the item's points? It keeps that where an item is wrong by another
 * task, and its own calls are right. */
static bool earns_share(const struct step_result *result, const struct item_result *item,
                        const char *task) {
    if (item->kind == ITEM_NUMBERS) {
        const bool is_spoilt = item->spoilt_by != NULL && is_wrong(item);
        return (item->state == RESULT_PASS || is_spoilt) && has_evidence(result);
    }
    const struct culprits culprits = find_culprits(result, item);
    return item->state == RESULT_PASS ||
           (is_wrong(item) && result_calls_are_right(result, task) && culprits.blames != NULL &&
            !culprits.blames(result, culprits.shown_by, task));
}

static void add_item(struct step_result *result, struct item_result *item) {
    const struct credit *credit = item->credit;
    const unsigned share = credit->points / (unsigned)credit->task_count;
    item->points = 0;
    for (size_t i = 0; i < credit->task_count; i++) {
        struct task_result *task = find_task(result, credit->tasks[i]);
        const unsigned points = earns_share(result, item, credit->tasks[i].text) ? share : 0;
        item->points += points;
        task->points += points;
        task->most += share;
    }
    if (item->kind == ITEM_NUMBERS && item->state == RESULT_PASS && item->points == 0) {
        result_say(&item->message, "right, and counts as soon as a picture is right, too");
    }
    result->points += item->points;
    result->most += credit->points;
    result->passed += item->state == RESULT_PASS;
    result->pictures_exact += item->exact;
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
    list_tasks(result);
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
