/*
 * The table of scenes: which pictures each step draws and how strictly each is compared, what else
 * is judged, and the points. The head of tests/check/scenes.txt says what its lines mean.
 */
#ifndef TESTS_CHECK_SCENES_H
#define TESTS_CHECK_SCENES_H

#include "base/error.h"
#include "relation.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    SCENE_NAME_LIMIT = 64, /* bytes of a step's or a scene's name with its final NUL */
    TASK_NAME_LIMIT = 12,  /* bytes of "10b.12" with its final NUL */
    SCENE_TASK_LIMIT = 16, /* tasks that a scene shows */
    SCENE_POINT_LIMIT = 1000
};

struct task_name {
    char text[TASK_NAME_LIMIT];
};

/* Is a task of that name one of these? */
bool task_is_among(const struct task_name *tasks, size_t count, const char *task);

/* For what points are given. */
struct credit {
    struct task_name tasks[SCENE_TASK_LIMIT]; /* all different */
    size_t task_count;                        /* at least 1 */
    struct task_name needs[SCENE_TASK_LIMIT]; /* other tasks, or "8b": all of a part */
    size_t need_count;
    struct task_name spoilers[SCENE_TASK_LIMIT]; /* later ones: not needed, but they can show */
    size_t spoiler_count;
    unsigned points; /* a multiple of task_count, not 0 */
};

/* Is this task, or the part "8b" of a task 8b.2, among what is needed? */
bool credit_needs(const struct credit *credit, const char *task);

/* Can a fault of this task show: is it shown, needed or a spoiler? */
bool credit_has(const struct credit *credit, const char *task);

/* Can a fault of another task show: is this one needed or a spoiler? */
bool credit_relies_on(const struct credit *credit, const char *task);

/* Does it show and need everything that the other one does? */
bool credit_covers(const struct credit *credit, const struct credit *other);

enum item_kind { ITEM_PICTURE, ITEM_COUNTER, ITEM_RELATIONS, ITEM_NUMBERS, ITEM_KIND_COUNT };

/* What is judged: a scene's picture; of a scene that passes a counter, or relations; of a task, the
 * numbers that its functions give (numbers.h). */
struct checked_item {
    enum item_kind kind;
    char scene[SCENE_NAME_LIMIT]; /* "numbers" of numbers */
    /* "" of a picture, of relations "drawn again (moved, halved)", of numbers "1.3" */
    char counter[SCENE_NAME_LIMIT];
    struct credit credit;
    bool exact; /* a picture of which every pixel must be equal; the limits are then 0 */
    /* How many of the drawn pixels may be wrong, apart, drawn in one picture only, and near
     * (compare.h), in thousandths of a percent, inclusive. */
    unsigned wrong_limit, apart_limit, coverage_limit, near_limit;
    uint64_t most, least; /* of a counter; inclusive */
    bool relations[RELATION_COUNT];
    unsigned limit; /* of relations, as those of a picture */
};

struct checked_step {
    char name[SCENE_NAME_LIMIT]; /* "step05_zbuffer" */
    bool selected;
    struct checked_item *items;
    size_t item_count, item_capacity;
    size_t scene_count; /* the first items: pictures. At least 1, but with only numbers kept */
};

/* All zero is a valid, empty table. */
struct scene_table {
    struct checked_step *steps;
    size_t step_count, step_capacity;
};

/* Read the table; no step is selected. On an error the table is empty, and the message names the
 * file and the line. The caller frees the table. */
bool scene_table_read(struct scene_table *table, const char *path, struct error *error);

/* Select the step that is meant by "05", "5" or "step05_zbuffer"; "" selects nothing. An unknown
 * step is an error that lists the known ones. */
bool scene_table_select(struct scene_table *table, const char *step, struct error *error);

/* Select every step. */
void scene_table_select_all(struct scene_table *table);

/* Keep of the selected steps only the scene of that name, or "numbers"; "" keeps all. A step
 * without it is an error. */
bool scene_table_keep(struct scene_table *table, const char *scene, struct error *error);

/* The scene of that name, NULL where the table has none. */
const struct checked_item *scene_table_find(const struct scene_table *table, const char *step,
                                            const char *scene);

/* Demand of every scene that every pixel is equal. */
void scene_table_make_exact(struct scene_table *table);

/* Free the table and leave it empty. */
void scene_table_free(struct scene_table *table);

#endif
