/* Tests of which tasks are to blame for what is wrong: the contract of struct task_result. */
#include "result.h"
#include "unit/unit.h"

#include <stdlib.h>
#include <string.h>

enum { ITEM_LIMIT = 12, LINE_LIMIT = 500 };

struct line {
    char text[LINE_LIMIT];
};

/* Split "3a.2,3a.3"; "-" is none. Returns how many there are. */
static size_t read_tasks(struct task_name *tasks, const char *text) {
    size_t count = 0;
    while (*text != '\0' && *text != '-') {
        size_t length = strcspn(text, ",");
        snprintf(tasks[count++].text, TASK_NAME_LIMIT, "%.*s", (int)length, text);
        text += length + (text[length] == ',');
    }
    return count;
}

/* "KIND TASKS NEEDS STATE LOOKS": what is wrong is FAIL, or CRASH; NEEDS behind a ~ are spoilers;
 * LOOKS are the tasks of the mistakes that it looks like. A `counter` or one that is `unjudged` is
 * about no picture; in one that is `blank` nothing is drawn; `numbers` are those of one task, and
 * `spoilt` ones end in functions of task 1.1. */
static void read_item(struct item_result *item, struct credit *credit, const char *text) {
    char kind[LINE_LIMIT], tasks[LINE_LIMIT], needs[LINE_LIMIT], state[LINE_LIMIT],
        looks[LINE_LIMIT];
    CHECK(sscanf(text, "%499s %499s %499s %499s %499s", kind, tasks, needs, state, looks) == 5);
    credit->task_count = read_tasks(credit->tasks, tasks);
    const bool spoils = needs[0] == '~';
    credit->need_count = spoils ? 0 : read_tasks(credit->needs, needs);
    credit->spoiler_count = spoils ? read_tasks(credit->spoilers, needs + 1) : 0;
    credit->points = (unsigned)credit->task_count;
    item->credit = credit;
    item->scene = "scene";
    item->only_may_be = strcmp(kind, "blank") == 0;
    item->kind = strcmp(kind, "picture") == 0 || item->only_may_be ? ITEM_PICTURE : ITEM_COUNTER;
    item->unjudged = strcmp(kind, "unjudged") == 0;
    item->spoilt_by = strcmp(kind, "spoilt") == 0 ? "1.1" : NULL;
    if (strcmp(kind, "numbers") == 0 || item->spoilt_by != NULL) {
        item->kind = ITEM_NUMBERS;
    }
    item->counter = item->kind == ITEM_NUMBERS   ? credit->tasks[0].text
                    : item->kind == ITEM_COUNTER ? "counted"
                                                 : "";
    item->state = strcmp(state, "PASS") == 0   ? RESULT_PASS
                  : strcmp(state, "FAIL") == 0 ? RESULT_FAIL
                  : strcmp(state, "TODO") == 0 ? RESULT_TODO
                                               : RESULT_CRASH;
    item->looks_task_count = read_tasks(item->looks_tasks, looks);
}

/* A finished step with these items. */
static struct step_result step_of(const char *const *items) {
    static struct checked_item rules[ITEM_LIMIT];
    static struct task_result tasks[ITEM_LIMIT * SCENE_TASK_LIMIT];
    static struct item_result results[ITEM_LIMIT];
    struct checked_step step = {.items = rules};
    struct step_result result;
    struct error error;
    memset(results, 0, sizeof results);
    for (; step.item_count < ITEM_LIMIT && items[step.item_count] != NULL; step.item_count++) {
        read_item(&results[step.item_count], &rules[step.item_count].credit,
                  items[step.item_count]);
    }
    CHECK(step_result_begin(&result, &step, &error));
    memcpy(result.items, results, step.item_count * sizeof *results);
    step_result_finish(&result);
    memcpy(results, result.items, step.item_count * sizeof *results);
    memcpy(tasks, result.tasks, result.task_count * sizeof *tasks);
    free(result.items);
    free(result.tasks);
    result.items = results;
    result.tasks = tasks;
    return result;
}

/* The points of its tasks, "2 0". */
static struct line points_of(const char *const *items) {
    struct line line = {""};
    const struct step_result step = step_of(items);
    for (size_t i = 0; i < step.task_count; i++) {
        size_t used = strlen(line.text);
        snprintf(line.text + used, sizeof line.text - used, "%s%u", i > 0 ? " " : "",
                 step.tasks[i].points);
    }
    return line;
}

/* The tasks of a step with these items, as "5.1, 5.2 FAIL, 5.3 perhaps FAIL". */
static struct line tasks_of(const char *const *items) {
    struct line line = {""};
    const struct step_result step = step_of(items);
    const struct task_result *tasks = step.tasks;
    for (size_t i = 0; i < step.task_count; i++) {
        size_t used = strlen(line.text);
        const char *state = tasks[i].state == RESULT_PASS ? "" : result_state_name(tasks[i].state);
        snprintf(line.text + used, sizeof line.text - used, "%s%s%s%s%s", i > 0 ? ", " : "",
                 tasks[i].name.text, tasks[i].perhaps ? " perhaps" : "",
                 state[0] != '\0' ? " " : "", state);
    }
    return line;
}

struct blame_case {
    const char *items[ITEM_LIMIT];
    const char *tasks;
};

static void check_blame(const struct blame_case *cases, size_t count) {
    for (size_t i = 0; i < count; i++) {
        CHECK_TEXT(tasks_of(cases[i].items).text, cases[i].tasks);
    }
}

/* A picture shows a task right that it shows alone; what is counted does not. */
static void test_pictures_show(void) {
    static const struct blame_case cases[] = {
        {{"picture 1.1,1.2 - FAIL -"}, "1.1 perhaps FAIL, 1.2 perhaps FAIL"},
        {{"picture 1.1,1.2 - FAIL -", "picture 1.1 - PASS -"}, "1.1, 1.2 FAIL"},
        {{"picture 1.1,1.2 - FAIL -", "picture 1.1 - PASS -", "picture 1.2 - PASS -"},
         "1.1 perhaps FAIL, 1.2 perhaps FAIL"},
        {{"picture 1.1,1.2 - FAIL -", "counter 1.1 - PASS -"},
         "1.1 perhaps FAIL, 1.2 perhaps FAIL"},
        {{"picture 1.1,1.2 - FAIL -", "picture 1.1 - PASS -", "unjudged 1.1 - FAIL -",
          "unjudged 1.3 - FAIL -"},
         "1.1, 1.2 FAIL, 1.3 perhaps FAIL"},
        {{"picture 1.1 - PASS -", "counter 1.1 - FAIL -"}, "1.1 FAIL"},
        {{"picture 1.1,1.2 - CRASH -", "picture 1.1 - PASS -"}, "1.1, 1.2 CRASH"},
    };
    check_blame(cases, sizeof cases / sizeof cases[0]);
}

/* The mistake that an item looks like says whose fault it is, also of a task right elsewhere. */
static void test_likenesses_name(void) {
    static const struct blame_case cases[] = {
        {{"picture 1.1,1.2 - FAIL 1.2"}, "1.1, 1.2 FAIL"},
        {{"picture 1.1,1.2,1.3 - FAIL 1.1,1.2"}, "1.1 perhaps FAIL, 1.2 perhaps FAIL, 1.3"},
        {{"picture 1.1,1.2 - FAIL 1.2", "picture 1.2 - PASS -"}, "1.1, 1.2 FAIL"},
        {{"picture 1.1,1.2 - FAIL 1.1", "unjudged 1.2 - FAIL -"}, "1.1 FAIL, 1.2"},
        /* a task that it needs */
        {{"picture 1.1 - PASS -", "picture 1.2,1.3 1.1 FAIL 1.1"}, "1.1 perhaps FAIL, 1.2, 1.3"},
        {{"picture 2b.1 - PASS -", "picture 2c.1 2b FAIL 2b.1"}, "2b.1 perhaps FAIL, 2c.1"},
        {{"picture 2b.1 - PASS -", "picture 2c.1 2b.1 FAIL 2b.1"}, "2b.1 perhaps FAIL, 2c.1"},
        /* one that it has nothing to do with, or that is not judged */
        {{"picture 1.1 - PASS -", "picture 1.2 - FAIL 1.1"}, "1.1, 1.2 perhaps FAIL"},
        {{"picture 1.11 - PASS -", "picture 1.2 1.1 FAIL 1.11"}, "1.11, 1.2 perhaps FAIL"},
        {{"picture 1.2 1.1 FAIL 1.1"}, "1.2 perhaps FAIL"},
        /* nothing drawn: it may be that, and may not */
        {{"blank 1.1,1.2 - FAIL 1.2"}, "1.1 perhaps FAIL, 1.2 perhaps FAIL"},
        {{"blank 1.1,1.2 - FAIL 1.2", "picture 1.2 - PASS -"}, "1.1 FAIL, 1.2"},
    };
    check_blame(cases, sizeof cases / sizeof cases[0]);
}

/* Where a task is needed that is not right, it is not known whose fault it is. */
static void test_needs_excuse(void) {
    static const struct blame_case cases[] = {
        {{"picture 1.1 - PASS -", "picture 1.2 1.1 FAIL -"}, "1.1, 1.2 FAIL"},
        {{"picture 1.1 - FAIL -", "picture 1.2 1.1 FAIL -"}, "1.1 FAIL, 1.2 perhaps FAIL"},
        {{"picture 1.1 - FAIL -", "picture 1.11 - PASS -", "picture 1.2 1.11 FAIL -"},
         "1.1 FAIL, 1.11, 1.2 FAIL"},
        {{"picture 1.2 1.1 FAIL -", "picture 1.1 - CRASH -"}, "1.1 CRASH, 1.2 perhaps FAIL"},
        {{"picture 1.1 - FAIL -", "picture 1.2 1.1 FAIL 1.2"}, "1.1 FAIL, 1.2 FAIL"},
        {{"picture 1.1,1.2 - FAIL -", "picture 1.3 1.1 FAIL -", "picture 1.4 1.3 FAIL -"},
         "1.1 perhaps FAIL, 1.2 perhaps FAIL, 1.3 perhaps FAIL, 1.4 perhaps FAIL"},
        {{"picture 2a.1,2a.2 - FAIL -", "picture 2b.1 2a FAIL -", "picture 2c.1 2d FAIL -"},
         "2a.1 perhaps FAIL, 2a.2 perhaps FAIL, 2b.1 perhaps FAIL, 2c.1 FAIL"},
    };
    check_blame(cases, sizeof cases / sizeof cases[0]);
}

/* Wrong numbers say whose fault the pictures are; but not where they need a task whose own are
 * wrong. */
static void test_numbers_blame(void) {
    static const struct blame_case cases[] = {
        {{"picture 1.1,1.2 - FAIL -", "numbers 1.1 - FAIL -"}, "1.1 FAIL, 1.2"},
        {{"picture 1.1,1.2 - FAIL -", "numbers 1.1 - PASS -", "numbers 1.2 1.1 FAIL -"},
         "1.1, 1.2 FAIL"},
        {{"picture 1.1,1.2 - FAIL -", "numbers 1.1 - FAIL -", "numbers 1.2 1.1 FAIL -"},
         "1.1 FAIL, 1.2"},
        /* of a later task: where its fault can show */
        {{"picture 1.1 - FAIL -", "numbers 1.2 - FAIL -"}, "1.1 FAIL, 1.2 FAIL"},
        {{"picture 1.1 ~1.2 FAIL -", "numbers 1.2 - FAIL -"}, "1.1, 1.2 FAIL"},
        /* other numbers are the task's own; calls that end badly may not be */
        {{"numbers 1.1 ~1.2 FAIL -", "numbers 1.2 - FAIL -"}, "1.1 FAIL, 1.2 FAIL"},
        {{"numbers 1.1 - CRASH -", "spoilt 1.2 ~1.1 CRASH -"}, "1.1 CRASH, 1.2"},
        {{"picture 1.1,1.2 - CRASH -", "numbers 1.1 - CRASH -", "spoilt 1.2 ~1.1 CRASH -"},
         "1.1 CRASH, 1.2"},
        {{"picture 1.1,1.2 - CRASH -", "numbers 1.1 1.2 CRASH -", "spoilt 1.2 ~1.1 CRASH -"},
         "1.1 CRASH, 1.2"},
    };
    check_blame(cases, sizeof cases / sizeof cases[0]);
}

/* A task whose calls are right is blamed only where all are. */
static void test_right_calls_excuse(void) {
    static const struct blame_case cases[] = {
        {{"picture 1.1,1.2 - FAIL -", "numbers 1.1 - PASS -"}, "1.1, 1.2 FAIL"},
        {{"picture 1.1,1.2 - CRASH -", "numbers 1.1 - PASS -"}, "1.1, 1.2 CRASH"},
        {{"picture 1.1,1.2 - FAIL -", "numbers 1.1 - PASS -", "numbers 1.2 - PASS -"},
         "1.1 perhaps FAIL, 1.2 perhaps FAIL"},
        {{"picture 1.1,1.2 - FAIL -", "unjudged 1.1 - FAIL -", "numbers 1.1 - PASS -"},
         "1.1, 1.2 FAIL"},
    };
    check_blame(cases, sizeof cases / sizeof cases[0]);
}

/* The points of each task: one of a picture that passes, one of calls. */
static void test_points(void) {
    static const struct {
        const char *items[ITEM_LIMIT];
        const char *points;
    } cases[] = {
        {{"picture 1.1,1.2 - PASS -", "numbers 1.1 - PASS -", "numbers 1.2 - PASS -"}, "2 2"},
        /* the other one is wrong, by its calls or its looks */
        {{"picture 1.1,1.2 - FAIL -", "numbers 1.1 - PASS -", "numbers 1.2 - FAIL -"}, "2 0"},
        {{"picture 1.1,1.2 - FAIL 1.2", "numbers 1.1 - PASS -", "numbers 1.2 - PASS -"}, "2 1"},
        {{"picture 1.1 ~1.2 FAIL -", "numbers 1.1 - PASS -", "numbers 1.2 - FAIL -"}, "2 0"},
        {{"unjudged 1.1 1.2 FAIL -", "numbers 1.1 - PASS -", "numbers 1.2 - FAIL -"}, "2 0"},
        /* nothing shows that this one is right */
        {{"picture 1.1,1.2 - FAIL -", "numbers 1.2 - FAIL -"}, "0 0"},
        {{"picture 1.1 - FAIL -", "numbers 1.1 - PASS -", "numbers 1.2 - FAIL -"}, "0 0"},
        /* calls that are right, and nothing else that is: they may be made up */
        {{"picture 1.1,1.2 - FAIL -", "numbers 1.1 - PASS -", "numbers 1.2 - PASS -"}, "0 0"},
        {{"picture 1.1,1.2 - FAIL -", "picture 1.2 - PASS -", "numbers 1.1 - PASS -",
          "numbers 1.2 - PASS -"},
         "1 2"},
        {{"picture 1.1,1.2 - TODO -", "numbers 1.1 - PASS -"}, "1 0"},
        /* calls that end in another task's function keep their point, and show nothing */
        {{"picture 1.1,1.2 - CRASH -", "numbers 1.1 - CRASH -", "spoilt 1.2 ~1.1 CRASH -"}, "0 1"},
        {{"picture 1.1,1.2 - TODO -", "numbers 1.1 - CRASH -", "spoilt 1.2 ~1.1 TODO -"}, "0 0"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        CHECK_TEXT(points_of(cases[i].items).text, cases[i].points);
    }
}

/* Where to read about a mistake, and what to ask for: as far as it is known. */
static void test_advice(void) {
    static const struct {
        size_t figures, tasks;
        const char *advice;
    } cases[] = {
        {0, 0, "; make hint STEP=08 TASK=8b.1"},
        {0, 2, "; make hint STEP=08 TASK=8b.2 or TASK=8c.1"},
        {1, 1, ": see step08_a/WRONG.md, figure 4; make hint STEP=08 TASK=8b.2"},
        {2, 0, ": see step08_a/WRONG.md, figure 4 or 12; make hint STEP=08 TASK=8b.1"},
    };
    const struct credit credit = {.tasks = {{"8b.1"}}, .task_count = 1};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct item_result item = {.scene = "scene",
                                   .counter = "",
                                   .credit = &credit,
                                   .looks_tasks = {{"8b.2"}, {"8c.1"}},
                                   .looks_task_count = cases[i].tasks,
                                   .looks_figures = {4, 12},
                                   .looks_figure_count = cases[i].figures};
        const struct step_result step = {.name = "step08_a", .items = &item, .item_count = 1};
        CHECK_TEXT(result_advice(&step, &item).text, cases[i].advice);
    }
    /* Where numbers lay it to one of the likely tasks, that is named once. */
    static const char *const texts[] = {"picture 8b.2,8c.1 - FAIL 8b.2,8c.1",
                                        "numbers 8c.1 - FAIL -"};
    struct step_result step = step_of((const char *const[]){texts[0], texts[1], NULL});
    step.name = "step08_a";
    CHECK_TEXT(result_advice(&step, &step.items[0]).text, "; make hint STEP=08 TASK=8c.1");
}

UNIT_MAIN(TEST(test_advice), TEST(test_pictures_show), TEST(test_likenesses_name),
          TEST(test_needs_excuse), TEST(test_numbers_blame), TEST(test_right_calls_excuse),
          TEST(test_points))
