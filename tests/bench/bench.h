/*
 * Run time against error: what a lesson tells the benchmark about its versions.
 *
 * Each lesson has a tests/lessons/stepNN_name/bench.c that includes the lesson's own code
 *
 *     #define LESSON "../step01_line/main.c"
 *     #include "lesson.h"
 *     #include "../../../step01_line/attempts.h"
 *
 * and defines `const struct bench_lesson bench_stepNN`. A lesson has a few panels; a panel is one
 * piece of work that several versions do, each in its own way, and becomes one chart. Of every
 * version the frame (measure.c) measures two things: how long `run` takes, and what `error` returns
 * about what the last timed run has left behind. The error is computed, against an
 * answer found in another way (tests/oracle, or long double), and never written down in advance.
 * Times are only shown; nothing fails because of them.
 *
 * To be fair, the versions of a panel differ in one thing: they share the data, prepared alike
 * before the clock runs (converted to float for those that compute in float), the loop around them,
 * and the function that writes their pixels. They are compiled in one file with the same flags.
 */
#ifndef TESTS_BENCH_BENCH_H
#define TESTS_BENCH_BENCH_H

#include "base/error.h"
#include "files/model_file.h"
#include "memory.h"
#include "model.h"

#include <float.h>
#include <stdbool.h>
#include <stddef.h>

/* What the functions of a panel get: which way to do the work, and on what. */
struct bench_choice {
    int way, on;
};

/* One way to do the work of a panel. */
struct bench_version {
    const char *name; /* at most 26 characters, so that labels find room in the chart */
    int way;
    bool is_house; /* the lesson's good version, the one in main.c: its name is set in bold */
    /* The series that it belongs to, such as "float", or NULL: the dots of a series have one colour
     * and are joined by a line, in the order of the table; then a short name such as "8" is enough.
     * BENCH_SERIES_LIMIT series at most in a panel. */
    const char *series;
    int on; /* added to the panel's `on` */
};

#define VERSION(label, number)                                                                     \
    { .name = (label), .way = (number) }
#define HOUSE_VERSION(label, number)                                                               \
    { .name = (label), .way = (number), .is_house = true }
#define VERSION_OF(group, label, number, object)                                                   \
    { .name = (label), .way = (number), .series = (group), .on = (object) }
#define HOUSE_VERSION_OF(group, label, number, object)                                             \
    { .name = (label), .way = (number), .series = (group), .on = (object), .is_house = true }

struct bench_panel {
    const char *title;       /* the work: "24,640 lines from the middle of 41x41 pixels" */
    const char *error_label; /* unit and meaning, below the axis: "pixels wrong of 1000" */
    const char *time_label;  /* "ns per pixel", "ms per frame" */
    const char *against;     /* what the error was measured against: "exact integers" */
    const struct bench_version *versions;
    size_t version_count; /* 2..BENCH_VERSION_LIMIT */
    int on;           /* what is worked on: so several panels can share versions and functions */
    bool many_inputs; /* useful or not: only versions with the same `on` are compared */
    /* Do the whole work of the panel once (best 0.1 to 30 ms), memory ready, without printing. It
     * is called many times over; each call must do the same, so what it uses up it first makes
     * again. */
    void (*run)(struct bench_choice choice);
    /* The error of a version in the panel's error unit: 0 only when it is exact, never infinite: a
     * version without an answer is a fault of the benchmark. Called once, right after the last
     * timed `run` of this version: judge what that left behind. (It may do more work.) */
    double (*error)(struct bench_choice choice);
    /* Units of work that one run does: seconds of a run / units * 1e9 is shown in nanoseconds.
     * NULL: milliseconds of one run are shown. */
    const size_t *units;
    double budget; /* share of the lesson's time, relative to its other panels; 0 counts as 1 */
    /* The most that the error of a house version is if it is right, and what it is measured
     * against, too: beyond it the benchmark fails. BENCH_EXACT allows none; 0: nobody asks. */
    double house_within;
};

#define BENCH_EXACT DBL_TRUE_MIN

/* The path of one of the course's models, such as "bust.obj". */
#define BENCH_MODEL(name) COURSE_BUILD "/models/" name

/* A compiler inlines a small function where few call it. Here many versions do, and none of them
 * shall have less of it than main.c has alone. */
#if defined(__GNUC__)
#define INLINED static inline __attribute__((always_inline))
#else
#define INLINED static inline
#endif

/* Set versions and version_count of a panel. */
#define BENCH_VERSIONS(list) .versions = (list), .version_count = sizeof(list) / sizeof(list)[0]

enum { BENCH_VERSION_LIMIT = 32, BENCH_PANEL_LIMIT = 8, BENCH_SERIES_LIMIT = 4 };

struct bench_lesson {
    const char *step;  /* "step01_line": name of the directory, and of the chart's file */
    const char *title; /* heading of the chart: "Lesson 1: a line" */
    /* Fill static variables with what the versions need; it is kept until the program ends. False,
     * with a message, when that fails. */
    bool (*setup)(struct error *error);
    const struct bench_panel *panels;
    size_t panel_count; /* 1..BENCH_PANEL_LIMIT */
};

/* Of the panels in the array `rows`. */
#define BENCH_LESSON(directory, heading, set_up, rows)                                             \
    {                                                                                              \
        .step = (directory), .title = (heading), .setup = (set_up), .panels = (rows),              \
        .panel_count = sizeof(rows) / sizeof(rows)[0],                                             \
    }

/* All of them in order, then NULL. The Makefile writes this list from the names of the files; that
 * of stepNN.c is called bench_stepNN. */
extern const struct bench_lesson *const bench_lessons[];

#endif
