#define _POSIX_C_SOURCE 200809L

#include "build.h"

#include "base/file.h"
#include "run.h"

#include <ctype.h>
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum {
    COMPILER_GIGABYTES = 2,   /* memory of each process that builds a step */
    COMPILER_ROOM = 64000000, /* bytes on the disk that it may also need */
    NOT_FOUND_STATUS = 127    /* of a shell that does not find the command */
};

bool build_lock(const struct options *options, struct error *error) {
    char path[DRAWN_PATH_LIMIT], busy[DRAWN_PATH_LIMIT];
    snprintf(path, sizeof path, "%s/check.lock", options->programs);
    snprintf(busy, sizeof busy, "check: waiting for another check in %.900s\n", options->programs);
    return directory_create(options->programs, error) && run_lock(path, busy, error);
}

/* Is the part in the line, which may have others after it? */
static bool line_contains(const char *line, const char *part) {
    const char *found = strstr(line, part);
    return found != NULL && found < line + strcspn(line, "\n");
}

/* The compiler's warning about the function that the linker does not find: it says in which line
 * it is called, and what its name may have been meant to be. NULL when there is none. */
static const char *find_undeclared(const char *output) {
    const char *reference = strstr(output, "undefined reference to `");
    if (reference == NULL) {
        return NULL;
    }
    const char *name = strchr(reference, '`') + 1;
    const int length = (int)strcspn(name, "'\n");
    char warning[2][DRAWN_PATH_LIMIT];
    snprintf(warning[0], sizeof warning[0], "declaration of function '%.*s'", length, name);
    snprintf(warning[1], sizeof warning[1], "'%.*s' used but never defined", length, name);
    const char *found = strstr(output, warning[0]);
    return found != NULL ? found : strstr(output, warning[1]);
}

/* The line of a compiler's, a linker's or make's output that a student needs first. */
static struct message_line first_error(const char *output) {
    static const char *const marks[] = {"error:", "undefined reference", "multiple definition",
                                        "***"};
    const char *undeclared = find_undeclared(output);
    if (undeclared != NULL) {
        return drawn_message(message_line_start(output, undeclared));
    }
    for (size_t i = 0; i < sizeof marks / sizeof marks[0]; i++) {
        const char *mark = output;
        while ((mark = strstr(mark, marks[i])) != NULL) {
            const char *line = message_line_start(output, mark);
            /* A linker's own "error:" only says that it has failed. So does make's "***" of a
             * command; why, is said before it. */
            if (line_contains(line, "] Error ") && line > output) {
                return drawn_message(message_line_start(output, line - 1));
            }
            if (!line_contains(line, "collect2:") && !line_contains(line, "linker command")) {
                return drawn_message(line);
            }
            mark += strlen(marks[i]);
        }
    }
    return drawn_message(output);
}

/* Let make build the target in the root, and another one, which may be NULL, at the same time. */
static bool call_make(const struct options *options, const char *target, const char *other,
                      const struct run_limits *limits, struct run_result *result,
                      struct error *error) {
    char script[DRAWN_PATH_LIMIT];
    if ((size_t)snprintf(script, sizeof script, "%s \"$@\"", options->make) >= sizeof script) {
        return error_set(error, "the make command is too long");
    }
    const char *arguments[] = {"sh", "-c", script, "make", "-s", target, other, NULL};
    struct run_command command = {
        .arguments = arguments,
        .locale = "C", /* so that a compiler writes "error:" and not its translation */
        .limits = *limits,
    };
    if (!run(&command, result, error)) {
        return false;
    }
    bool found = result->end != RUN_EXITED || result->number != NOT_FOUND_STATUS;
    return found || error_set(error, "cannot run %.100s: %s", options->make,
                              drawn_message((const char *)result->messages.data).text);
}

/* Did make build everything asked for? */
static bool make_succeeded(const struct run_result *result) {
    return result->end == RUN_EXITED && result->number == 0;
}

/* Not by what is in main.c. */
static bool is_stopped(const struct run_result *result) {
    return result->end == RUN_OUT_OF_TIME || result->end == RUN_KILLED;
}

static struct message_line make_failure(const struct run_result *result, double seconds) {
    struct message_line reason;
    const struct run_limits limits = {.seconds = seconds};
    if (is_stopped(result)) {
        snprintf(reason.text, sizeof reason.text, "the compiler %s%s",
                 result->end == RUN_KILLED ? "ended by " : "was ",
                 run_ended_by(result, &limits).text);
        return reason;
    }
    if (strstr((const char *)result->messages.data, "undefined reference to `main'") != NULL) {
        snprintf(reason.text, sizeof reason.text,
                 "there is no main(): main.c ends with it, after it includes scenes.h");
        return reason;
    }
    reason = first_error((const char *)result->messages.data);
    if (reason.text[0] == '\0') {
        snprintf(reason.text, sizeof reason.text, "make failed and does not say why");
    }
    return reason;
}

/* Has make no rule for the step, because there is no main.c? Then its words are about its rules. */
static bool lacks_source(const struct options *options, const char *step, const char *output,
                         struct message_line *reason) {
    const bool here = strcmp(options->sources, ".") == 0;
    char path[DRAWN_PATH_LIMIT];
    snprintf(path, sizeof path, "%s%s%s/main.c", here ? "" : options->sources, here ? "" : "/",
             step);
    if ((strstr(output, "*** No rule to make target") == NULL &&
         strstr(output, "main.c: No such file") == NULL) ||
        access(path, F_OK) == 0 || errno != ENOENT) {
        return false;
    }
    snprintf(reason->text, sizeof reason->text, "there is no %.180s", path);
    return true;
}

/* Was there no room for what the compiler writes? Its words alone do not prove it: a main.c can
 * make it say anything. */
static bool lacked_room(const struct options *options, const char *output, struct error *error) {
    const char *words = strstr(output, strerror(ENOSPC));
    struct error reason;
    return words != NULL &&
           (!run_has_room(run_temporary(), COMPILER_ROOM, &reason) ||
            !run_has_room(options->programs, COMPILER_ROOM, &reason)) &&
           !error_set(error, "%s", drawn_message(message_line_start(output, words)).text);
}

/* Remove what there is of a step's program where make must build it again: when the compiler had
 * something to say about it, which is then said again. What the compiler writes on the way goes in
 * any case: where it cannot be removed it could not be written either, and that is no fault of
 * main.c. */
static bool remove_old(const char *program, struct error *error) {
    static const char *const endings[] = {".o", ".said", ".d", ""};
    char path[DRAWN_PATH_LIMIT + 5];
    snprintf(path, sizeof path, "%s.said", program);
    const size_t count = file_exists(path) && file_size(path) == 0 ? 1 : 4;
    for (size_t i = 0; i < count; i++) {
        snprintf(path, sizeof path, "%s%s", program, endings[i]);
        if (unlink(path) != 0 && errno != ENOENT) {
            return error_set(error, "cannot remove %.900s: %s", path, strerror(errno));
        }
    }
    return true;
}

/* Those of a compiler, behind a line's or a column's number: make has its own warnings. */
static void find_warnings(struct build_result *result) {
    static const char mark[] = ": warning: ";
    const char *output = (const char *)result->messages.data;
    for (const char *at = output; at != NULL && (at = strstr(at, mark)) != NULL; at++) {
        if (at == output || !isdigit((unsigned char)at[-1])) {
            continue;
        }
        if (result->warning.text[0] == '\0') {
            result->warning = drawn_message(message_line_start(output, at));
        } else {
            result->more_warnings++;
        }
    }
}

bool build_numbers(const struct options *options, const char *name, struct build_result *result,
                   struct error *error) {
    char program[DRAWN_PATH_LIMIT];
    snprintf(program, sizeof program, "%s/%s", options->programs, name);
    *result = (struct build_result){.reason = {""}};
    return access(program, X_OK) == 0 || build_step(options, name, false, result, error);
}

bool build_step(const struct options *options, const char *step, bool has_numbers,
                struct build_result *result, struct error *error) {
    char program[DRAWN_PATH_LIMIT], numbers[DRAWN_PATH_LIMIT], tried[DRAWN_PATH_LIMIT + 8];
    snprintf(program, sizeof program, "%s/%s", options->programs, step);
    snprintf(numbers, sizeof numbers, "%s/numbers/%s", options->programs, step);
    snprintf(tried, sizeof tried, "%s.tried", numbers);
    const struct run_limits limits = {.seconds = options->build_seconds,
                                      .file_bytes = run_program_limits(0).file_bytes,
                                      .memory_bytes = (size_t)COMPILER_GIGABYTES << 30};
    struct run_result end = {.end = RUN_EXITED};
    *result = (struct build_result){.reason = {""}};
    bool done = remove_old(program, error) && (!has_numbers || remove_old(numbers, error)) &&
                call_make(options, program, has_numbers ? tried : NULL, &limits, &end, error);
    if (done && !make_succeeded(&end)) {
        done = !lacked_room(options, (const char *)end.messages.data, error);
        if (!lacks_source(options, step, (const char *)end.messages.data, &result->reason)) {
            result->reason = make_failure(&end, limits.seconds);
            result->stopped = is_stopped(&end);
        }
    } else if (done && access(program, X_OK) != 0) {
        snprintf(result->reason.text, sizeof result->reason.text, "make has built no %.150s",
                 program);
    }
    result->messages = end.messages;
    find_warnings(result);
    return done;
}
