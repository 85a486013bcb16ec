#define _POSIX_C_SOURCE 200809L

#include "numbers.h"

#include "base/file.h"
#include "build.h"
#include "fault.h"
#include "run.h"
#include "todo.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    PROGRAM_NAME_LIMIT = SCENE_NAME_LIMIT + 8,
    ARGUMENT_COUNT = 4, /* program, file, first call, and the NULL at the end */
    NUMBER_COLUMNS = 6, /* of a line that is whole */
    COLUMN_WIDTH = 150  /* of them are shown */
};

/* Calls that are wrong, and the first of them. */
struct wrong_calls {
    size_t count;
    long first; /* its number */
    enum result_state state;
    struct result_text message;
};

/* A task of which functions are called. */
struct called_task {
    struct item_result *item;
    size_t called;                    /* calls */
    struct wrong_calls values, ended; /* with another value; that never came back */
    char marked[TASK_NAME_LIMIT + 1];
};

/* What is known while the functions of a step are called. */
struct calling {
    const struct options *options;
    const struct checked_step *step;
    char name[PROGRAM_NAME_LIMIT]; /* of the program */
    struct called_task *tasks;
    size_t count;
    const char **arguments; /* of the program: the last are tasks that are not called */
    size_t argument_count;
    long first; /* the call to begin with */
    /* Why the program has ended without its last line, outside of any call; or empty. */
    struct result_text broken;
    bool begun; /* it has called something */
};

static struct called_task *find_called_task(const struct calling *calling, const char *name) {
    for (size_t i = 0; i < calling->count; i++) {
        if (strcmp(calling->tasks[i].item->counter, name) == 0) {
            return &calling->tasks[i];
        }
    }
    return NULL;
}

/* Call nothing that needs the task, or that is the one behind a !. */
static void leave_out(struct calling *calling, const char *task) {
    calling->arguments[calling->argument_count++] = task;
}

/* Call nothing of a task that does not return: its name with a !. */
static void leave_out_own(struct calling *calling, struct called_task *task) {
    snprintf(task->marked, sizeof task->marked, "!%s", task->item->counter);
    leave_out(calling, task->marked);
    leave_out(calling, task->item->counter);
}

/* ---- Lines ---- */

/* Cut a line at its tabs; returns how many columns it has. */
static size_t split(char *line, char *columns[NUMBER_COLUMNS]) {
    size_t count = 0;
    char *tab = NULL;
    do {
        columns[count++] = line;
        tab = strchr(line, '\t');
        if (tab != NULL) {
            *tab = '\0';
            line = tab + 1;
        }
    } while (tab != NULL && count < NUMBER_COLUMNS);
    return count;
}

/* The call, what is right, and what yours does; only of the first that is wrong. */
static void set_wrong(struct called_task *task, char *columns[NUMBER_COLUMNS],
                      enum result_state state, const char *what) {
    struct wrong_calls *calls = state == RESULT_FAIL ? &task->values : &task->ended;
    calls->count++;
    if (calls->count == 1) {
        calls->first = strtol(columns[0], NULL, 10);
        calls->state = state;
        result_say(&calls->message, "%.*s must be %.*s: %s%.*s", COLUMN_WIDTH, columns[2],
                   COLUMN_WIDTH, columns[3], state == RESULT_FAIL ? "yours " : "", COLUMN_WIDTH,
                   what);
        text_make_printable(calls->message.text, ' ');
    }
}

/* What a call did that has not come back. */
static void set_ended(struct calling *calling, struct called_task *task,
                      char *columns[NUMBER_COLUMNS], const struct run_result *end) {
    struct result_text fault = {""};
    if (end->end == RUN_OUT_OF_TIME) {
        set_wrong(task, columns, RESULT_TIME, "yours does not return");
        leave_out_own(calling, task);
    } else if (fault_describe(&fault, calling->step->name, (const char *)end->messages.data)) {
        set_wrong(task, columns, RESULT_CRASH, fault.text);
    } else if (end->end == RUN_KILLED) {
        set_wrong(task, columns, RESULT_CRASH, run_signal_name(end->number).text);
    } else {
        set_wrong(task, columns, RESULT_CRASH, "yours ends the program");
    }
}

/* Returns true where the line's call has not come back. */
static bool judge_line(struct calling *calling, char *line, const struct run_result *end) {
    char *columns[NUMBER_COLUMNS];
    size_t count = split(line, columns);
    struct called_task *task = count > 3 ? find_called_task(calling, columns[1]) : NULL;
    if (task == NULL) {
        return false;
    }
    bool is_whole = count == NUMBER_COLUMNS;
    calling->begun = true;
    task->called++;
    calling->first = strtol(columns[0], NULL, 10) + 1;
    if (!is_whole) {
        set_ended(calling, task, columns, end);
    } else if (strcmp(columns[5], "right") != 0) {
        set_wrong(task, columns, RESULT_FAIL, columns[4]);
    }
    return !is_whole;
}

/* ---- The program ---- */

/* The program has ended without its last line, and not in a call. */
static void set_broken(struct calling *calling, const struct run_result *end,
                       const struct run_limits *limits) {
    const struct run_text ended = run_ended_by(end, limits);
    result_say(&calling->broken, "yours ends the program %s: %s",
               calling->begun ? "between two calls" : "before main()",
               ended.text[0] != '\0' ? ended.text : "exit status 0");
}

/* Call the functions until all are called, or one does not come back: then `*more`. */
static bool call_some(struct calling *calling, const char *directory, bool *more,
                      struct error *error) {
    char first[24], path[RUN_PATH_LIMIT + 16];
    struct bytes lines = {.data = NULL};
    struct run_result end;
    struct error ignored;
    snprintf(first, sizeof first, "%ld", calling->first);
    snprintf(path, sizeof path, "%s/numbers%ld", directory, calling->first);
    calling->arguments[1] = path;
    calling->arguments[2] = first;
    calling->arguments[calling->argument_count] = NULL;
    const struct run_command command = {
        .arguments = calling->arguments,
        .directory = directory,
        .contained = true,
        .limits = run_program_limits(calling->options->seconds / 4),
    };
    bool done = run(&command, &end, error), at_end = false;
    *more = false;
    if (done && end.end != RUN_INTERRUPTED && file_read(path, &lines, &ignored) &&
        bytes_append(&lines, "", 1)) {
        for (char *line = (char *)lines.data, *next; *line != '\0'; line = next) {
            next = line + strcspn(line, "\n");
            next += *next == '\n' ? (*next = '\0', 1) : 0;
            *more |= judge_line(calling, line, &end);
            at_end |= strcmp(line, "end") == 0;
        }
    }
    if (done && !*more && !at_end && end.end != RUN_INTERRUPTED) {
        set_broken(calling, &end, &command.limits);
    }
    bytes_free(&lines);
    bytes_free(&end.messages);
    return done;
}

static bool call_all(struct calling *calling, struct error *error) {
    struct run_directory directory;
    struct drawn_path program;
    if (!drawn_program(&program, calling->options->programs, calling->name, error) ||
        !run_directory_create(&directory, error)) {
        return false;
    }
    calling->arguments[0] = program.text;
    bool done = true, more = true;
    while (done && more) {
        done = call_some(calling, directory.path, &more, error);
    }
    run_directory_remove(directory.path);
    return done;
}

/* ---- All of it ---- */

static void set_not_called(const struct calling *calling, const char *reason) {
    for (size_t i = 0; i < calling->count; i++) {
        result_say(&calling->tasks[i].item->message,
                   "functions are not as the starter has them: %s", reason);
    }
}

/* Can a call of this task end in a function of that other one, whose calls are wrong? Where each
 * may call the other, as in two parts of one function, the later one is at fault: what was right
 * before it came stays right. */
static bool can_end_in(const struct called_task *task, const struct called_task *other) {
    return other != task && other->values.count + other->ended.count > 0 &&
           credit_relies_on(task->item->credit, other->item->counter) &&
           (other > task || !credit_relies_on(other->item->credit, task->item->counter));
}

/* The first of those; NULL for none. */
static const struct called_task *find_ending(const struct calling *calling,
                                             const struct called_task *task) {
    for (size_t i = 0; i < calling->count; i++) {
        if (can_end_in(task, &calling->tasks[i])) {
            return &calling->tasks[i];
        }
    }
    return NULL;
}

/* The task in whose functions the calls of this one end: it calls them, or what it calls does.
 * NULL: they end in its own. */
static const struct called_task *find_culprit(const struct calling *calling,
                                              const struct called_task *task) {
    const struct called_task *culprit = find_ending(calling, task), *next = culprit;
    for (size_t i = 0; next != NULL && next->values.count == 0 && i < calling->count; i++) {
        culprit = next;
        next = find_ending(calling, culprit);
    }
    return next != NULL ? next : culprit;
}

/* Calls that have ended in another task's function say nothing about this one. */
static void judge_task(const struct calling *calling, const struct called_task *task,
                       const char *source) {
    struct item_result *item = task->item;
    const struct wrong_calls *values = &task->values, *ended = &task->ended;
    const bool left_out = task->called == 0 && !todo_has_task(source, item->counter);
    const struct called_task *culprit =
        ended->count > 0 || left_out ? find_culprit(calling, task) : NULL;
    const size_t own_ends = culprit == NULL ? ended->count : 0, wrong = values->count + own_ends;
    const bool ends_first = own_ends > 0 && (values->count == 0 || ended->first < values->first);
    const struct wrong_calls *first = ends_first ? ended : values;
    if (calling->broken.text[0] != '\0' && wrong == 0) {
        result_say(&item->message, "%s", calling->broken.text);
    } else if (wrong > 0) {
        item->state = first->state;
        result_say(&item->message, "%s", first->message.text);
        if (wrong > 1) {
            result_say(&item->message, " (and %zu more call%s)", wrong - 1, wrong == 2 ? "" : "s");
        }
    } else if (task->called > ended->count) {
        item->state = RESULT_PASS;
    } else if (culprit != NULL) {
        item->state = culprit->ended.count > 0 ? culprit->ended.state : RESULT_FAIL;
        item->spoilt_by = culprit->item->counter;
        result_say(&item->message, "judged when task %s, whose code it runs, is right",
                   item->spoilt_by);
    } else if (left_out) {
        result_say(&item->message, "not called: what it needs does not return");
    }
}

static void finish(const struct calling *calling, const char *source) {
    for (size_t i = 0; i < calling->count; i++) {
        judge_task(calling, &calling->tasks[i], source);
    }
}

static bool build_and_call(struct calling *calling, const char *source, struct error *error) {
    struct build_result built;
    bool done = build_numbers(calling->options, calling->name, &built, error);
    if (done && built.reason.text[0] != '\0') {
        set_not_called(calling, built.reason.text);
    } else if (done && run_caught_signal() == 0) {
        done = call_all(calling, error);
        finish(calling, source);
    }
    bytes_free(&built.messages);
    return done;
}

static void begin(struct calling *calling, const char *source, struct step_result *result) {
    calling->argument_count = ARGUMENT_COUNT - 1;
    for (size_t i = 0; i < result->item_count; i++) {
        struct item_result *item = &result->items[i];
        if (item->kind == ITEM_NUMBERS) {
            calling->tasks[calling->count++].item = item;
            if (todo_has_task(source, item->counter)) {
                leave_out(calling, item->counter);
            }
        }
    }
}

bool numbers_judge(const struct options *options, const struct checked_step *step,
                   const char *source, struct step_result *result, struct error *error) {
    struct calling calling = {.options = options, .step = step};
    snprintf(calling.name, sizeof calling.name, "numbers/%s", step->name);
    calling.tasks = calloc(step->item_count + 1, sizeof *calling.tasks);
    calling.arguments = calloc(3 * step->item_count + ARGUMENT_COUNT, sizeof *calling.arguments);
    bool done = false;
    if (calling.tasks == NULL || calling.arguments == NULL) {
        error_out_of_memory(error);
    } else {
        begin(&calling, source, result);
        done = calling.count == 0 || build_and_call(&calling, source, error);
    }
    free(calling.tasks);
    free(calling.arguments);
    return done;
}
