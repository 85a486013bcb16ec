/*
 * The check behind `make check`: builds every step, draws its scenes, and compares them with the
 * reference images.
 *
 *     check [options] [--] [STEP ...]   STEP is 5, 05 or step05_zbuffer; none means all of them
 *
 * A step's program runs as `PROGRAM -o DIRECTORY` in that empty directory, in its own process group
 * and under limits (run.h says which), and must leave there SCENE.tga for each of its scenes. When
 * it ends badly, each scene that is missing is drawn alone once more, so that one crash does not
 * cost the points of the others. What "the same picture" means is said in compare.h, what is
 * printed in report.h.
 *
 * Then come `SCORE 100/126`, `N passed, N failed` (steps), and where the difference images are. A
 * step passes when all its scenes do and its program ends with status 0. The check never stops
 * early.
 *
 * To a person at a terminal it says less, and what to do next; what is only unfinished has not
 * failed then, and the status is 0.
 *
 * Exit status: 0 all passed, 1 something failed, 2 the check itself cannot work (wrong usage, a
 * reference is missing, unreadable or blank, the disk is full, an old file cannot be removed, or
 * nobody gets the score).
 */
#define _POSIX_C_SOURCE 200809L

#include "base/file.h"
#include "build.h"
#include "drawn.h"
#include "export.h"
#include "judge.h"
#include "options.h"
#include "report.h"
#include "result.h"
#include "run.h"
#include "scenes.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { EXIT_ALL_PASSED = 0, EXIT_FAILED = 1, EXIT_CANNOT_WORK = 2 };

static int usage_error(const char *message) {
    fprintf(stderr, "check: %s\nTry 'check --help'.\n", message);
    return EXIT_CANNOT_WORK;
}

static bool select_steps(struct scene_table *table, char **steps, struct error *error) {
    bool any = false;
    for (; *steps != NULL; steps++) {
        any |= (*steps)[0] != '\0';
        if (!scene_table_select(table, *steps, error)) {
            return false;
        }
    }
    if (!any) {
        scene_table_select_all(table);
    }
    return true;
}

static bool check_steps(const struct options *options, const struct scene_table *table,
                        struct check_result *result, struct error *error) {
    if (!build_lock(options, error) || !check_result_create(result, table->step_count, error)) {
        return false;
    }
    for (size_t i = 0; i < table->step_count && run_caught_signal() == 0; i++) {
        if (table->steps[i].selected) {
            struct step_result *step = &result->steps[result->step_count++];
            judge_step(options, &table->steps[i], step);
            if (run_caught_signal() == 0) {
                (options->person ? report_step_to_person : report_step)(step);
                check_result_add(result, step);
            }
        }
    }
    return run_caught_signal() != 0 ||
           (options->person ? report_end_to_person : report_end)(result, error);
}

/* Write the reports that were asked for; one that cannot be written stops none of the others. */
static bool export_all(const struct options *options, const struct check_result *result) {
    const struct {
        const char *path;
        export_function *write;
    } exports[] = {
        {options->junit, export_junit},
        {options->json, export_json},
        {options->html, export_html},
    };
    bool done = true;
    for (size_t i = 0; i < sizeof exports / sizeof exports[0]; i++) {
        struct bytes report = {.data = NULL};
        struct error error;
        if (exports[i].path[0] != '\0' &&
            !(exports[i].write(&report, result, &error) &&
              file_write(exports[i].path, report.data, report.size, &error))) {
            fprintf(stderr, "check: %s\n", error.message);
            done = false;
        }
        bytes_free(&report);
    }
    return done;
}

/* A lesson is done: its picture, what one can do now, and the next one's command. */
static void say_next(const struct options *options, const char *step) {
    char command[2 * DRAWN_PATH_LIMIT];
#ifdef _WIN32
    const char quote = '"';
#else
    const char quote = '\'';
#endif
    snprintf(command, sizeof command, "sh tests/student/next.sh %c%s%c %s", quote,
             options->programs, quote, step);
    fflush(stdout);
    if (file_exists("tests/student/next.sh") && system(command) != 0) {
        fprintf(stderr, "check: nothing to say of what comes next\n");
    }
}

static int check(const struct options *options, const struct scene_table *table) {
    struct check_result result = {.steps = NULL};
    struct error error;
    bool done = check_steps(options, table, &result, &error);
    if (!done) {
        fprintf(stderr, "check: %s\n", error.message);
    }
    result.note = options->note;
    result.references = options->references;
    done = (run_caught_signal() != 0 || export_all(options, &result)) && done;
    /* At a terminal, what is only to do is no failure. */
    bool unfinished = options->person && report_is_unfinished(&result);
    int status = !done || result.cannot_work        ? EXIT_CANNOT_WORK
                 : result.failed > 0 && !unfinished ? EXIT_FAILED
                                                    : EXIT_ALL_PASSED;
    if (options->person && status == EXIT_ALL_PASSED && !unfinished && result.step_count == 1 &&
        options->only[0] == '\0' && !options->sanitized) {
        say_next(options, result.steps[0].name);
    }
    check_result_free(&result);
    return status;
}

int main(int argc, char **argv) {
    struct options options;
    struct scene_table table;
    struct error error;
    if (!run_open_standard_files()) {
        return EXIT_CANNOT_WORK;
    }
    if (options_read(&options, argc, argv, &error) < 0) {
        return usage_error(error.message);
    }
    if (options.help) {
        return EXIT_ALL_PASSED;
    }
    if (chdir(options.root) != 0) {
        fprintf(stderr, "check: %s: %s\n", options.root, strerror(errno));
        return EXIT_CANNOT_WORK;
    }
    run_catch_signals();
    if (!scene_table_read(&table, options.scenes, &error)) {
        fprintf(stderr, "check: %s\n", error.message);
        return EXIT_CANNOT_WORK;
    }
    if (options.exact) {
        scene_table_make_exact(&table);
    }
    bool selected =
        select_steps(&table, argv + 1, &error) && scene_table_keep(&table, options.only, &error);
    int status = selected ? check(&options, &table) : usage_error(error.message);
    scene_table_free(&table);
    if (run_caught_signal() != 0) {
        run_die_of_signal();
    }
    return status;
}
