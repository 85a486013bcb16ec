/*
 * The known mistakes of a lesson, and the signs by which the check knows them.
 *
 * `make mistakes STEP=NN` draws each mistake of stepNN_name/mistakes.txt and writes
 * tests/lessons/stepNN_name/looks/signs.txt, a line for each, with blanks between
 *
 *     the task that is at fault, or -;
 *     the figure of the lesson's wrong pictures that shows it, or 0;
 *     its signs, with semicolons between, or -;
 *     what it is, up to the end of the line.
 *
 * A sign is what a scene shows. Where the picture is wrong, SCENE:ROW:APART: the row of its colours
 * in SCENE.png (looks.h; 0: they say nothing), and how many pixels are apart
 * (compare.h). Where only the work is wrong, or nothing is drawn, SCENE:PICTURES:COUNTERS
 * (counters.h). A scene that it leaves right has none. One line is for what is there when
 * nothing is drawn, MISTAKE_STARTER.
 */
#ifndef TESTS_CHECK_MISTAKES_H
#define TESTS_CHECK_MISTAKES_H

#include "base/bytes.h"
#include "result.h"

#include <stdbool.h>
#include <stddef.h>

/* What the starter of the lesson draws is no mistake's for sure: much draws nothing. */
#define MISTAKE_STARTER "(the starter)"

struct mistake {
    struct task_name task; /* "" when it is none's */
    unsigned figure;       /* from 1; 0: none shows it */
    const char *signs, *words;
};

/* All zero: nothing is known. */
struct mistake_list {
    struct mistake *list;
    size_t count, capacity;
    struct bytes text; /* what the names and signs point to */
};

/* Read a list. False, and nothing is known, when it cannot be read or a line of it is wrong. */
bool mistakes_read(struct mistake_list *mistakes, const char *path);
void mistakes_free(struct mistake_list *mistakes);

/* The sign behind this one, or NULL. */
const char *mistake_next_sign(const char *sign);

/* What else is known of a program, and speaks against a mistake. */
enum mistake_doubt {
    MISTAKE_LIKELY,
    MISTAKE_UNLIKELY,  /* its task is right elsewhere */
    MISTAKE_DOUBTFUL,  /* another scene is wrong in another way */
    MISTAKE_IMPOSSIBLE /* never to be named */
};

/* Mistakes that show the same. */
struct mistake_set {
    const struct mistake *list[LOOKS_NAME_LIMIT];
    enum mistake_doubt doubts[LOOKS_NAME_LIMIT];
    size_t count;
};

/* Add it, a likely one. Where there are more than LOOKS_NAME_LIMIT, false. */
bool mistake_set_add(struct mistake_set *set, const struct mistake *mistake);

/* Say of an item that it looks like "A" or "B", those of the set with the least doubt, which tasks
 * are at fault in these, and which figures show them; where they are doubtful, that it only may be
 * one of them. */
void mistakes_tell(struct item_result *item, const struct mistake_set *set);

#endif
