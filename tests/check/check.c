/*
 * The check behind `make check`: builds every step, draws its scenes, and compares them with the
 * reference images.
 *
 *     check [options] [STEP ...]        STEP is 5, 05 or step05_zbuffer; none means all of them
 *
 * A step's program runs as `PROGRAM -o DIRECTORY` in that empty directory, in its own process group
 * and under limits (run.h says which), and must leave there SCENE.tga for each of its scenes. What
 * "the same picture" means is said in compare.h. One line a step is printed:
 *
 *     step05_zbuffer  PASS 3/3 exact
 *     step05_zbuffer  PASS 3/3 zbuffer: 0.1 % differ (9 pixels), first at (41,30): 9,0,0 for 8,0,0
 *     step05_zbuffer  FAIL 2/3 zbuffer: 4.4 % of drawn pixels wrong (limit 0.25 %), first at ...
 *     step05_zbuffer  FAIL 2/3 zbuffer: 0.7 % of drawn pixels of another colour there (limit ...
 *     step05_zbuffer  TIME 0/3 stopped after 10 s
 *     step05_zbuffer  CRASH SIGSEGV 1/3 depth: missing (no depth.tga was written)
 *     step05_zbuffer  BUILD step05_zbuffer/main.c:12:5: error: ...
 *     step05_zbuffer  ERROR 2/3 depth: no reference: ...        the check itself cannot work
 *
 * then `N passed, N failed` (steps), then where the difference images are. A step passes when all
 * its scenes do and its program ends with status 0. The check never stops early.
 *
 * Exit status: 0 all passed, 1 something failed, 2 the check itself cannot work (wrong usage, the
 * models cannot be made, a reference is missing, unreadable or blank, or nobody gets the score).
 */
#define _POSIX_C_SOURCE 200809L

#include "compare.h"
#include "drawn.h"
#include "image_file.h"
#include "png.h"
#include "run.h"
#include "scenes.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum {
    EXIT_ALL_PASSED = 0,
    EXIT_FAILED = 1,
    EXIT_CANNOT_WORK = 2,
    FILE_MEGABYTES = 64,    /* largest file that a program may write */
    PROCESS_LIMIT = 64,     /* processes of a program at the same time */
    GIVEN_SECONDS = 600,    /* for what is built before the steps */
    COMPILER_GIGABYTES = 2, /* memory of each process that builds a step */
    NOT_FOUND_STATUS = 127  /* of a shell that does not find the command */
};

struct options {
    const char *root, *scenes, *references, *programs, *differences, *make, *first, *only, *shares;
    double seconds;       /* for one step's program */
    double build_seconds; /* for building it */
    bool exact;           /* every pixel of every scene, whatever the table says */
};

static const struct options default_options = {
    .root = ".",
    .scenes = "tests/check/scenes.txt",
    .references = "tests/reference",
    .programs = "build",
    .differences = "build/differences",
    .make = "make",
    .first = "models",
    .only = "",
    .shares = "",
    .seconds = 10,
    .build_seconds = 60,
};

static const char help[] =
    "Usage: check [options] [STEP ...]\n"
    "Build the steps, draw their scenes, compare them with the reference images.\n"
    "STEP is 5, 05 or step05_zbuffer; without it all steps are checked.\n"
    "\n"
    "  --root DIR          the course's directory; other paths start there   (.)\n"
    "  --scenes FILE       the table of scenes          (tests/check/scenes.txt)\n"
    "  --references DIR    the reference images         (tests/reference)\n"
    "  --programs DIR      where make puts the programs (build)\n"
    "  --differences DIR   where difference images go   (build/differences)\n"
    "  --make COMMAND      builds DIR/STEP, the target  (make)\n"
    "  --first TARGET      what make builds before the steps (models)\n"
    "  --only SCENE        draw and compare just this scene of a step\n"
    "  --shares FILE       add a line to it for each picture: step, scene, % wrong, % apart,\n"
    "                      % drawn in one picture only\n"
    "  -h, --help\n"
    "\n"
    "A difference image shows the reference, yours and the difference. Wrong pixels are red where\n"
    "yours has no match in the reference, blue where the reference has none in yours, magenta for\n"
    "both; dark green ones are not equal, but not wrong.\n"
    "\n"
    "CHECK_TIMEOUT in the environment: seconds that a step's program may take (10).\n"
    "CHECK_BUILD_TIMEOUT in the environment: seconds that building it may take (60).\n"
    "CHECK_EXACT=1 in the environment: every pixel of every scene must be equal.\n"
    "Exit status: 0 all passed, 1 something failed, 2 the check itself cannot work.\n"
    "To see all that a program says, run it by hand: build/step05_zbuffer -o DIRECTORY\n";

struct score {
    size_t passed, failed; /* steps */
    bool cannot_work;
    struct bytes differences; /* paths, one a line */
};

/* ---- Text ---- */

static void append(struct bytes *text, const char *format, ...) PRINTF_LIKE(2, 3);

/* Add to a line; when memory runs out the line is just shorter. */
static void append(struct bytes *text, const char *format, ...) {
    char part[DRAWN_PATH_LIMIT + 2];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(part, sizeof part, format, arguments);
    va_end(arguments);
    bytes_append(text, part, strlen(part));
}

static void print_step(const char *step, const struct bytes *line) {
    printf("%s  %.*s\n", step, (int)line->size, line->size > 0 ? (const char *)line->data : "");
    fflush(stdout); /* so that each line is seen as soon as it is known */
}

/* ---- One check at a time ---- */

/* Two checks in one directory would remove each other's programs: the second waits. The lock is the
 * system's, and goes when this process does, however it ends. False, with a message, when the
 * directory cannot be written. */
static bool lock_programs(const struct options *options, struct error *error) {
    struct flock whole = {.l_type = F_WRLCK, .l_whence = SEEK_SET};
    char path[DRAWN_PATH_LIMIT];
    if (!directory_create(options->programs, error)) {
        return false;
    }
    snprintf(path, sizeof path, "%s/check.lock", options->programs);
    int file = open(path, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (file < 0) {
        return error_set(error, "%.900s: %s", path, strerror(errno));
    }
    bool busy = fcntl(file, F_SETLK, &whole) != 0 && (errno == EAGAIN || errno == EACCES);
    if (busy) {
        fprintf(stderr, "check: waiting for another check in %s\n", options->programs);
        fcntl(file, F_SETLKW, &whole); /* or until a signal comes */
    }
    return true; /* also where the file system knows no locks */
}

/* ---- Building ---- */

/* Does the part stand in the line, which may have others after it? */
static bool line_contains(const char *line, const char *part) {
    const char *found = strstr(line, part);
    return found != NULL && found < line + strcspn(line, "\n");
}

/* Where the line begins in which `at` points; `text` is where the first one does. */
static const char *line_start(const char *text, const char *at) {
    while (at > text && at[-1] != '\n') {
        at--;
    }
    return at;
}

/* The line of a compiler's, a linker's or make's output that a student needs first. */
static struct message_line first_error(const char *output) {
    static const char *const marks[] = {"error:", "undefined reference", "multiple definition",
                                        "***"};
    for (size_t i = 0; i < sizeof marks / sizeof marks[0]; i++) {
        const char *mark = output;
        while ((mark = strstr(mark, marks[i])) != NULL) {
            const char *line = line_start(output, mark);
            /* A linker's own "error:" only says that it has failed. So does make's "***" of a
             * command; why, stands before it. */
            if (line_contains(line, "] Error ") && line > output) {
                return drawn_message(line_start(output, line - 1));
            }
            if (!line_contains(line, "collect2:") && !line_contains(line, "linker command")) {
                return drawn_message(line);
            }
            mark += strlen(marks[i]);
        }
    }
    return drawn_message(output);
}

/* Let make build the target in the root. */
static bool call_make(const struct options *options, const char *target,
                      const struct run_limits *limits, struct run_result *result,
                      struct error *error) {
    char script[DRAWN_PATH_LIMIT];
    if ((size_t)snprintf(script, sizeof script, "%s \"$@\"", options->make) >= sizeof script) {
        return error_set(error, "the make command is too long");
    }
    const char *arguments[] = {"sh", "-c", script, "make", "-s", target, NULL};
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

/* Did make build all that it was told to? */
static bool make_succeeded(const struct run_result *result) {
    return result->end == RUN_EXITED && result->number == 0;
}

static struct message_line make_failure(const struct run_result *result, double seconds) {
    struct message_line reason;
    if (result->end == RUN_OUT_OF_TIME) {
        snprintf(reason.text, sizeof reason.text, "stopped after %g s", seconds);
        return reason;
    }
    reason = first_error((const char *)result->messages.data);
    if (reason.text[0] == '\0') {
        snprintf(reason.text, sizeof reason.text, "make failed and does not say why");
    }
    return reason;
}

/* The date of a main.c says nothing of its age (tar and cp -p keep dates), and it may be gone: only
 * a program that was removed is surely built from what is there now. */
static bool remove_old_program(const char *path, struct error *error) {
    return unlink(path) == 0 || errno == ENOENT ||
           error_set(error, "cannot remove %.900s: %s", path, strerror(errno));
}

/* Build what is given: the library, the models. */
static bool build_given(const struct options *options, struct error *error) {
    if (options->first[0] == '\0' || run_caught_signal() != 0) {
        return true;
    }
    const struct run_limits limits = {.seconds = GIVEN_SECONDS};
    struct run_result result = {.end = RUN_EXITED};
    bool done = call_make(options, options->first, &limits, &result, error);
    if (done && run_caught_signal() == 0 && !make_succeeded(&result)) {
        done = error_set(error, "cannot build %.100s: %s", options->first,
                         make_failure(&result, limits.seconds).text);
    }
    bytes_free(&result.messages);
    return done;
}

/* Build the step's program; `reason` says why it could not be built, or is empty. False, with a
 * message, when the check itself cannot do that. */
static bool build_step(const struct options *options, const char *step, struct message_line *reason,
                       struct error *error) {
    char target[DRAWN_PATH_LIMIT];
    snprintf(target, sizeof target, "%s/%s", options->programs, step);
    const struct run_limits limits = {.seconds = options->build_seconds,
                                      .file_bytes = (size_t)FILE_MEGABYTES * 1000 * 1000,
                                      .memory_bytes = (size_t)COMPILER_GIGABYTES << 30};
    struct run_result result = {.end = RUN_EXITED};
    *reason = (struct message_line){""};
    bool done =
        remove_old_program(target, error) && call_make(options, target, &limits, &result, error);
    if (done && !make_succeeded(&result)) {
        *reason = make_failure(&result, limits.seconds);
    } else if (done && access(target, X_OK) != 0) {
        snprintf(reason->text, sizeof reason->text, "make has built no %.150s", target);
    }
    bytes_free(&result.messages);
    return done;
}

/* ---- Comparing ---- */

/* Read a step's references, before its program runs. A bad one stays empty. */
static void read_references(const struct options *options, const struct checked_step *step,
                            struct image *references, struct error *errors) {
    for (size_t i = 0; i < step->scene_count; i++) {
        char path[DRAWN_PATH_LIMIT];
        snprintf(path, sizeof path, "%s/%s/%s.png", options->references, step->name,
                 step->scenes[i].name);
        if (image_read(&references[i], path, &errors[i]) && image_is_blank(&references[i])) {
            error_set(&errors[i], "%.900s: is blank", path);
            image_free(&references[i]);
        }
    }
}

static void write_difference(const char *path, const struct image *reference,
                             const struct image *yours, struct score *score) {
    struct image picture;
    struct error error;
    char directory[DRAWN_PATH_LIMIT];
    snprintf(directory, sizeof directory, "%.*s", (int)(strrchr(path, '/') - path), path);
    bool done = compare_picture(&picture, reference, yours, &error) &&
                directory_create(directory, &error) && png_write(&picture, path, &error);
    image_free(&picture);
    if (done) {
        append(&score->differences, "  %s\n", path);
    } else {
        fprintf(stderr, "check: no difference image: %s\n", error.message);
    }
}

/* What one scene adds to the step's line. */
struct scene_result {
    bool passed, exact, missing, no_reference;
    char text[400]; /* empty when exact */
};

/* 1597 as "1,597". */
struct count_text {
    char text[32];
};

static struct count_text show_count(uint64_t count) {
    struct count_text shown;
    char digits[24];
    int length = snprintf(digits, sizeof digits, "%llu", (unsigned long long)count), size = 0;
    for (int i = 0; i < length; i++) {
        if (i > 0 && (length - i) % 3 == 0) {
            shown.text[size++] = ',';
        }
        shown.text[size++] = digits[i];
    }
    shown.text[size] = '\0';
    return shown;
}

static void add_text(struct scene_result *result, const char *format, ...) PRINTF_LIKE(2, 3);

/* Add to the text, as much of it as there is room for. */
static void add_text(struct scene_result *result, const char *format, ...) {
    size_t length = strlen(result->text);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(result->text + length, sizeof result->text - length, format, arguments);
    va_end(arguments);
}

/* Where the first of these pixels is, your colour there and the right one. */
static void describe_first(struct scene_result *result, const struct tally *tally,
                           const struct image *reference, const struct image *yours) {
    int x = (int)tally->x, y = (int)tally->y;
    struct color got = image_get(yours, x, y), wanted = image_get(reference, x, y);
    struct shift shift = compare_shift(reference, yours);
    if (!result->passed && (shift.x != 0 || shift.y != 0)) {
        add_text(result, ", shifted by (%d,%d)", shift.x, shift.y);
    }
    add_text(result, ", first at (%d,%d): %d,%d,%d for %d,%d,%d", x, y, got.r, got.g, got.b,
             wanted.r, wanted.g, wanted.b);
}

/* Judge a picture that is not exact by its limits. Returns the pixels to be told about. */
static const struct tally *judge_shares(struct scene_result *result,
                                        const struct checked_scene *scene,
                                        const struct comparison *comparison) {
    const struct {
        const struct tally *tally;
        unsigned limit;
        const char *what;
    } limits[] = {
        {&comparison->wrong, scene->wrong_limit, "wrong"},
        {&comparison->coverage, scene->coverage_limit, "missing or too many"},
        {&comparison->apart, scene->apart_limit, "of another colour there"},
    };
    const uint64_t drawn = comparison->drawn, differing = comparison->differing.count;
    if (scene->exact) {
        add_text(result, "%s of %s drawn pixels differ (must be exact)", show_count(differing).text,
                 show_count(drawn).text);
        return &comparison->differing;
    }
    for (size_t i = 0; i < sizeof limits / sizeof limits[0]; i++) {
        if (!share_within(limits[i].tally->count, drawn, limits[i].limit)) {
            add_text(result, "%s of drawn pixels %s (limit %g %%)",
                     share_show(limits[i].tally->count, drawn, limits[i].limit).text,
                     limits[i].what, limits[i].limit / 1000.0);
            return limits[i].tally;
        }
    }
    result->passed = true;
    add_text(result, "%s differ (%s pixel%s)", share_show(differing, drawn, 0).text,
             show_count(differing).text, differing == 1 ? "" : "s");
    return &comparison->differing;
}

/* For who sets the limits. */
static void write_shares(const char *path, const char *step, const char *scene,
                         const struct comparison *comparison) {
    FILE *file = path[0] == '\0' ? NULL : fopen(path, "a");
    double drawn = comparison->drawn > 0 ? (double)comparison->drawn : 1;
    if (file != NULL) {
        fprintf(file, "%s %s %.4f %.4f %.4f\n", step, scene,
                100 * (double)comparison->wrong.count / drawn,
                100 * (double)comparison->apart.count / drawn,
                100 * (double)comparison->coverage.count / drawn);
    }
    if (path[0] != '\0' && (file == NULL || fclose(file) != 0)) {
        fprintf(stderr, "check: %s: %s\n", path, strerror(errno));
    }
}

static void judge_picture(struct scene_result *result, const struct options *options,
                          const char *step, const struct checked_scene *scene,
                          const struct image *reference, const struct image *yours) {
    struct comparison comparison = compare_images(reference, yours);
    write_shares(options->shares, step, scene->name, &comparison);
    result->exact = result->passed = comparison.differing.count == 0;
    if (!result->exact) {
        add_text(result, "%s: ", scene->name);
        describe_first(result, judge_shares(result, scene, &comparison), reference, yours);
    }
}

static struct scene_result check_scene(const struct options *options, const char *step,
                                       const struct checked_scene *scene, const char *directory,
                                       const struct image *reference, const struct error *why,
                                       struct score *score) {
    struct scene_result result = {.passed = false};
    char path[DRAWN_PATH_LIMIT];
    snprintf(path, sizeof path, "%s/%s/%s.png", options->differences, step, scene->name);
    if (reference->pixels == NULL) {
        result.no_reference = true;
        snprintf(result.text, sizeof result.text, "%s: no reference: %s", scene->name,
                 drawn_message(why->message).text);
        return result;
    }
    struct image yours;
    struct error error;
    enum drawn_state state = drawn_read(&yours, directory, scene->name, reference, &error);
    if (state == DRAWN_READ) {
        judge_picture(&result, options, step, scene, reference, &yours);
    } else {
        result.missing = state == DRAWN_MISSING;
        snprintf(result.text, sizeof result.text, "%s: %s", scene->name,
                 drawn_message(error.message).text);
    }
    if (!result.exact) {
        write_difference(path, reference, &yours, score);
    }
    image_free(&yours);
    return result;
}

/* ---- One step ---- */

static void describe_end(struct bytes *line, const struct options *options,
                         const struct run_result *end) {
    struct message_line said = drawn_message((const char *)end->messages.data);
    if (end->end == RUN_OUT_OF_TIME) {
        append(line, " stopped after %g s", options->seconds);
    } else if (end->end == RUN_TOO_MANY) {
        append(line, " stopped at more than %d processes", PROCESS_LIMIT);
    } else if (end->end == RUN_KILLED) {
        if (end->number == SIGXFSZ) {
            append(line, " file larger than %d MB", FILE_MEGABYTES);
        }
        append(line, "%s%s", said.text[0] != '\0' ? " " : "", said.text);
    } else if (end->number != 0) {
        append(line, " exit status %d%s%s", end->number, said.text[0] != '\0' ? ": " : "",
               said.text);
    }
}

/* The verdict, "n/m", how the program ended, and what is wrong with its scenes. */
static bool describe_step(struct bytes *line, const struct options *options,
                          const struct run_result *end, const struct scene_result *scenes,
                          size_t count) {
    size_t passed = 0, exact = 0, no_reference = 0;
    for (size_t i = 0; i < count; i++) {
        passed += scenes[i].passed;
        exact += scenes[i].exact;
        no_reference += scenes[i].no_reference;
    }
    bool ended_well = end->end == RUN_EXITED && end->number == 0;
    bool right = passed == count && ended_well;
    if (no_reference > 0) {
        append(line, "ERROR");
    } else if (end->end == RUN_OUT_OF_TIME) {
        append(line, "TIME");
    } else if (end->end == RUN_KILLED) {
        append(line, "CRASH %s", run_signal_name(end->number).text);
    } else {
        append(line, right ? "PASS" : "FAIL");
    }
    append(line, " %zu/%zu", passed, count);
    if (right && exact == count) {
        append(line, " exact");
    }
    size_t start = line->size;
    describe_end(line, options, end);
    for (size_t i = 0; i < count; i++) {
        /* A program that was stopped is not blamed for each picture that it did not get to; of
         * one that failed, only what failed is shown. */
        bool shown = scenes[i].text[0] != '\0' && (right || !scenes[i].passed) &&
                     (ended_well || !scenes[i].missing);
        if (shown) {
            append(line, "%s %s", line->size > start ? ";" : "", scenes[i].text);
        }
    }
    return right;
}

/* Draw the step's scenes in an empty directory and judge them. False, with a message, when the
 * check itself cannot do that. */
static bool draw_and_judge(const struct options *options, const struct checked_step *step,
                           const struct image *references, const struct error *errors,
                           struct scene_result *results, struct bytes *line, bool *passed,
                           struct score *score, struct error *error) {
    char directory[DRAWN_PATH_LIMIT];
    if (!run_directory_create(directory, sizeof directory, error)) {
        return false;
    }
    struct run_limits limits = {.seconds = options->seconds,
                                .file_bytes = (size_t)FILE_MEGABYTES * 1000 * 1000,
                                .processes = PROCESS_LIMIT};
    struct run_result end;
    bool done =
        drawn_run(options->programs, step->name, directory, options->only, &limits, &end, error);
    if (done && end.end != RUN_INTERRUPTED) {
        for (size_t i = 0; i < step->scene_count; i++) {
            results[i] = check_scene(options, step->name, &step->scenes[i], directory,
                                     &references[i], &errors[i], score);
            score->cannot_work |= results[i].no_reference;
        }
        *passed = describe_step(line, options, &end, results, step->scene_count);
    }
    bytes_free(&end.messages);
    run_directory_remove(directory);
    return done;
}

/* A picture of an earlier check must not be taken for one of this check. */
static void remove_old_differences(const struct options *options, const struct checked_step *step) {
    for (size_t i = 0; i < step->scene_count; i++) {
        char path[DRAWN_PATH_LIMIT];
        snprintf(path, sizeof path, "%s/%s/%s.png", options->differences, step->name,
                 step->scenes[i].name);
        unlink(path);
    }
}

static void check_step(const struct options *options, const struct checked_step *step,
                       struct score *score) {
    struct bytes line = {.data = NULL};
    struct error error = {.message = "out of memory"};
    struct message_line reason;
    bool passed = false;
    size_t count = step->scene_count;
    struct image *references = calloc(count, sizeof *references);
    struct error *errors = calloc(count, sizeof *errors);
    struct scene_result *results = calloc(count, sizeof *results);
    bool done = references != NULL && errors != NULL && results != NULL;
    if (done) {
        remove_old_differences(options, step);
        read_references(options, step, references, errors);
        done = build_step(options, step->name, &reason, &error);
    }
    if (done && reason.text[0] == '\0') {
        done = draw_and_judge(options, step, references, errors, results, &line, &passed, score,
                              &error);
    } else if (done) {
        append(&line, "BUILD %s", reason.text);
        for (size_t i = 0; i < count; i++) {
            if (references[i].pixels == NULL) { /* the line says only what comes first */
                fprintf(stderr, "check: no reference: %s\n", errors[i].message);
                score->cannot_work = true;
            }
        }
    }
    if (!done) {
        line.size = 0;
        append(&line, "ERROR %s", error.message);
        score->cannot_work = true;
    }
    if (run_caught_signal() == 0) {
        print_step(step->name, &line);
        score->passed += passed;
        score->failed += !passed;
    }
    for (size_t i = 0; references != NULL && i < count; i++) {
        image_free(&references[i]);
    }
    free(references);
    free(errors);
    free(results);
    bytes_free(&line);
}

/* ---- All of it ---- */

static int usage_error(const char *message) {
    fprintf(stderr, "check: %s\nTry 'check --help'.\n", message);
    return EXIT_CANNOT_WORK;
}

static bool read_seconds(const char *variable, double *seconds, struct error *error) {
    const char *text = getenv(variable);
    if (text == NULL || text[0] == '\0') {
        return true;
    }
    char *end;
    *seconds = strtod(text, &end);
    if (*end != '\0' || !(*seconds >= 0.1 && *seconds <= 3600)) {
        return error_set(error, "%s is '%.50s', not a number of seconds, 0.1..3600", variable,
                         text);
    }
    return true;
}

static bool read_exact(bool *exact, struct error *error) {
    const char *text = getenv("CHECK_EXACT");
    *exact = text != NULL && strcmp(text, "1") == 0;
    if (text == NULL || text[0] == '\0' || *exact || strcmp(text, "0") == 0) {
        return true;
    }
    return error_set(error, "CHECK_EXACT is '%.50s', neither 0 nor 1", text);
}

/* Read the options in front of the steps; `first_step` becomes the first argument that is none. */
static bool read_options(struct options *options, int argc, char **argv, int *first_step,
                         struct error *error) {
    const struct {
        const char *name;
        const char **value;
    } known[] = {
        {"--root", &options->root},
        {"--scenes", &options->scenes},
        {"--references", &options->references},
        {"--programs", &options->programs},
        {"--differences", &options->differences},
        {"--make", &options->make},
        {"--first", &options->first},
        {"--only", &options->only},
        {"--shares", &options->shares},
    };
    int i = 1;
    while (i < argc && argv[i][0] == '-') {
        size_t k = 0, count = sizeof known / sizeof known[0];
        while (k < count && strcmp(argv[i], known[k].name) != 0) {
            k++;
        }
        if (k == count) {
            return error_set(error, "unknown option '%.100s'", argv[i]);
        }
        if (i + 1 == argc) {
            return error_set(error, "%s needs a value", argv[i]);
        }
        if (strlen(argv[i + 1]) > DRAWN_PATH_LIMIT / 2) {
            return error_set(error, "the value of %s is too long", argv[i]);
        }
        *known[k].value = argv[i + 1];
        i += 2;
    }
    *first_step = i;
    return read_seconds("CHECK_TIMEOUT", &options->seconds, error) &&
           read_seconds("CHECK_BUILD_TIMEOUT", &options->build_seconds, error) &&
           read_exact(&options->exact, error);
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

static int check(const struct options *options, const struct scene_table *table) {
    struct score score = {.passed = 0};
    struct error error;
    if (!lock_programs(options, &error) || !build_given(options, &error)) {
        fprintf(stderr, "check: %s\n", error.message);
        return EXIT_CANNOT_WORK;
    }
    for (size_t i = 0; i < table->step_count && run_caught_signal() == 0; i++) {
        if (table->steps[i].selected) {
            check_step(options, &table->steps[i], &score);
        }
    }
    if (run_caught_signal() == 0) {
        printf("%zu passed, %zu failed\n", score.passed, score.failed);
        if (score.differences.size > 0) {
            printf("Difference images (reference, yours, difference, side by side):\n%.*s",
                   (int)score.differences.size, (const char *)score.differences.data);
        }
        if (fflush(stdout) != 0 || ferror(stdout)) {
            fprintf(stderr, "check: the score could not be written to standard output\n");
            score.cannot_work = true;
        }
    }
    bytes_free(&score.differences);
    return score.cannot_work ? EXIT_CANNOT_WORK
                             : (score.failed > 0 ? EXIT_FAILED : EXIT_ALL_PASSED);
}

int main(int argc, char **argv) {
    struct options options = default_options;
    struct scene_table table;
    struct error error;
    int first_step = argc;
    if (argc == 2 && (strcmp(argv[1], "-h") == 0 || strcmp(argv[1], "--help") == 0)) {
        fputs(help, stdout);
        return EXIT_ALL_PASSED;
    }
    if (!read_options(&options, argc, argv, &first_step, &error)) {
        return usage_error(error.message);
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
    bool selected = select_steps(&table, argv + first_step, &error) &&
                    scene_table_keep(&table, options.only, &error);
    int status = selected ? check(&options, &table) : usage_error(error.message);
    scene_table_free(&table);
    if (run_caught_signal() != 0) {
        run_die_of_signal();
    }
    return status;
}
