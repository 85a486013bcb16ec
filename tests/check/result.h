/*
 * What a check has found: filled in once, and read by whoever reports it.
 *
 * A step has items: its pictures, and what else the table of scenes wants: counters of work,
 * relations, numbers. Points belong to items and are shared out evenly to their tasks, so the
 * tasks' points add up to the step's too.
 */
#ifndef TESTS_CHECK_RESULT_H
#define TESTS_CHECK_RESULT_H

#include "base/bytes.h"
#include "base/error.h"
#include "compare.h"
#include "drawn.h"
#include "scenes.h"
#include "seen.h"
#include "tgaimage.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { LOOKS_NAME_LIMIT = 4 }; /* mistakes that a picture can look like at once */

enum result_state {
    RESULT_PASS,
    RESULT_TODO, /* not passed, and main.c still has the starter's line of a task that it needs */
    RESULT_FAIL,
    RESULT_TIME,  /* the program was stopped after its time */
    RESULT_CRASH, /* a signal ended the program, or a sanitizer did */
    RESULT_BUILD, /* the program could not be built */
    RESULT_ERROR  /* the check itself could not judge it */
};

/* A sentence without a full stop; cut when it is too long. */
struct result_text {
    char text[700];
};

struct result_path {
    char text[DRAWN_PATH_LIMIT]; /* from the root; "" when there is no such file */
};

/* A picture, a counter, relations, or the numbers that a task's functions give. */
struct item_result {
    const char *scene; /* its name; "numbers" */
    /* "" for a picture; of relations "drawn again (moved, halved)"; of numbers the task. */
    const char *counter;
    enum item_kind kind;
    /* Of numbers whose calls all end badly, but in functions of another task: that one; or NULL. */
    const char *spoilt_by;
    const struct credit *credit;
    const struct checked_item *rule; /* the table's line: how it is judged */
    enum result_state state;
    unsigned points;            /* all of them when it passes; else those that right tasks keep */
    struct result_text message; /* what is wrong, or not exact; empty when there is nothing */
    struct seen_text seen;      /* what can be said of a wrong picture that looks like none */
    struct result_text looks;   /* "A" or "B", the mistakes that draw or count this; or empty */
    /* It may be such a mistake, and may not: others draw nothing as well, or another scene that
     * shows the mistake is wrong in another way. */
    bool only_may_be;
    /* The tasks that are at fault in these, as far as known. */
    struct task_name looks_tasks[LOOKS_NAME_LIMIT];
    size_t looks_task_count;
    /* The figures of the lesson's wrong pictures that show these. */
    unsigned looks_figures[LOOKS_NAME_LIMIT];
    size_t looks_figure_count;
    size_t looks_row;              /* which row of looks.h its picture looks like; 0: none */
    uint64_t counted, most, least; /* of a counter: the work done, what is enough, what is needed */
    bool unjudged;                 /* a counter or relations, because the picture does not pass */
    bool blamed;                   /* the program ended badly over it; `message` says how */
    bool divided;                  /* and that by SIGFPE: it has divided a whole number by 0 */
    bool exact;                    /* of a picture: equal to the last bit */
    bool compared;                 /* of a picture: it could be; what follows is known */
    bool blank;                    /* nothing is drawn in it */
    struct comparison shares;      /* pixels drawn, and of them wrong, apart, in one picture only */
    size_t x, y;                   /* the first pixel that `message` is about, when not exact */
    struct color got, wanted;      /* its colour, and the right one */
    struct result_path yours, reference, difference; /* pictures, when not exact */
};

/* What is wrong may be the fault of these tasks:
 *
 * - where numbers are wrong of tasks whose faults can show in it: of these, for sure; also where it
 *   ends badly, as calls of theirs do;
 * - where the item looks like known mistakes of such tasks: of these, whatever other items show,
 *   and of no others; for sure when it is one task, which it shows (what only may be a mistake
 *   looks like none);
 * - otherwise, of the tasks that it shows for which least speaks: those whose calls are not right,
 *   else those that no picture shows right alone, else all. For sure when it is one task, nothing
 *   that the item needs has a state other than PASS, and it looks like no mistake of yet another
 *   task.
 *
 * An item that is not judged because of its picture is nobody's fault for sure, and that of no task
 * for which anything speaks; where the picture is the fault of such tasks, it is theirs.
 *
 * A task keeps its points of an item that is wrong where the fault is known to be another task's,
 * and its own calls are right. Calls give points as soon as there is a picture that passes, or none
 * that is wrong for an unknown reason; also calls that end in a function of another task. */
struct task_result {
    struct task_name name;
    enum result_state state; /* the worst of those of the items that may be its fault */
    bool perhaps;            /* FAIL, and of the first such item it is not sure */
    const char *waits_for;   /* TODO, but written: this task or part is to do first; else NULL */
    bool is_marked;          /* right, but main.c still says that it is to do */
    unsigned points, most;
};

struct step_result {
    const char *name;
    enum result_state state;
    struct item_result *items;
    size_t item_count;
    struct task_result *tasks; /* in the order of the lesson */
    size_t task_count;
    size_t passed, pictures_exact; /* items */
    unsigned points, most;
    struct result_text reason;  /* why the step as a whole did not end well; or empty */
    struct result_text warning; /* the compiler's first one of a program that it built; or empty */
    size_t more_warnings;
    bool build_stopped;    /* the compiler was, for its time or memory: main.c may be right */
    bool sanitized;        /* built to say in which line it crashes, or it has said it */
    struct bytes messages; /* what compiler or program wrote to standard error, then a NUL */
};

/* All zero is a valid, empty result. */
struct check_result {
    struct step_result *steps;
    size_t step_count;
    size_t passed, failed; /* steps */
    unsigned points, most;
    bool cannot_work;       /* the check itself */
    const char *note;       /* a line that the reports begin with; NULL or "" for none */
    const char *references; /* the directory of the reference images, for the page */
};

/* The word for it: "PASS", "TODO", ... */
const char *result_state_name(enum result_state state);

/* An item's word for a reader: "NOT JUDGED" where it fails only because its picture does, or calls
 * because another task's do. */
const char *result_item_state(const struct item_result *item);

/* A result for that many steps; false when memory runs out. */
bool check_result_create(struct check_result *result, size_t step_count, struct error *error);
void check_result_free(struct check_result *result);

/* Begin the result of a step, of which the names stay the table's: nothing is judged, nothing has
 * passed. False when memory runs out. */
bool step_result_begin(struct step_result *result, const struct checked_step *step,
                       struct error *error);

/* When all items are judged: points, tasks, and where the step is FAIL so far, its state. TIME,
 * CRASH, BUILD and ERROR stay. */
void step_result_finish(struct step_result *result);

/* The picture of an item's scene: the item itself, or that of a counter or of relations. */
const struct item_result *result_picture_of(const struct step_result *result,
                                            const struct item_result *item);

/* Does a picture that passes show this task alone? (Work that is counted right shows nothing: what
 * it counts may be drawn wrong.) */
bool result_is_right(const struct step_result *result, const char *task);

/* Do the numbers of the task pass? */
bool result_calls_are_right(const struct step_result *result, const char *task);

/* Do wrong numbers lay it to other tasks that the item is wrong? */
bool result_numbers_blame_others(const struct step_result *result, const struct item_result *item,
                                 const char *task);

/* The first numbers that are wrong in the way in which the item ended; NULL for none. */
const struct item_result *result_numbers_of(const struct step_result *result,
                                            const struct item_result *item);

/* The words before `looks`: "looks like", or "may be". */
const char *result_likeness(const struct item_result *item);

/* The first task that may be to blame for an item that is wrong. Where the calls of all pass, the
 * last: that is the one in which most can go wrong that calls do not see. */
const char *result_first_suspect(const struct step_result *result, const struct item_result *item);

/* What to do about what it looks like: ": see step08_projection/WRONG.md, figure 4" where a figure
 * shows it, and "; make hint STEP=08 TASK=8b.2 or TASK=8b.3". */
struct result_text result_advice(const struct step_result *result, const struct item_result *item);

/* Add a finished step to the sums. */
void check_result_add(struct check_result *result, const struct step_result *step);

/* Add to a text, as much as there is room for. */
void result_say(struct result_text *text, const char *format, ...) PRINTF_LIKE(2, 3);

#endif
