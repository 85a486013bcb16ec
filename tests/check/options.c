#define _POSIX_C_SOURCE 200809L

#include "options.h"

#include "arguments.h"
#include "drawn.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const struct options default_options = {
    .root = ".",
    .scenes = "tests/check/scenes.txt",
    .sources = ".",
    .references = "tests/reference",
    .looks = "tests/lessons",
    .programs = "build/quick",
    .differences = "build/differences",
    .make = "make",
    .only = "",
    .shares = "",
    .counted = "",
    .junit = "",
    .json = "",
    .html = "",
    .note = "",
    .seconds = 10,
    .build_seconds = 60,
};

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

bool options_begin(struct options *options, struct error *error) {
    const char *verbose = getenv("VERBOSE");
    *options = default_options;
    options->person = isatty(STDOUT_FILENO) && (verbose == NULL || verbose[0] == '\0');
    return read_seconds("CHECK_TIMEOUT", &options->seconds, error) &&
           read_seconds("CHECK_BUILD_TIMEOUT", &options->build_seconds, error) &&
           read_exact(&options->exact, error);
}

/* A path, or what becomes part of one. */
static bool read_path(const char *value, void *target) {
    return strlen(value) <= DRAWN_PATH_LIMIT / 2 && argument_text(value, target);
}

static void print_help(const struct argument *known, size_t known_count) {
    puts("Usage: check [options] [--] [STEP ...]\n"
         "Build the steps, draw their scenes, compare them with the reference images.\n"
         "STEP is 5, 05 or step05_zbuffer; without it all steps are checked.\n");
    arguments_print_help(known, known_count);
    puts("\n"
         "A difference image shows the reference, yours and the difference. Red: this pixel of\n"
         "yours should not be there, or has another colour; blue: missing; dark green: differs,\n"
         "but does not count.\n"
         "\n"
         "CHECK_TIMEOUT in the environment: seconds that a step's program may take (10).\n"
         "CHECK_BUILD_TIMEOUT in the environment: seconds that building it may take (60).\n"
         "CHECK_RUNNER in the environment: a command that runs the programs, shut in.\n"
         "CHECK_EXACT=1 in the environment: every pixel of every scene must be equal.\n"
         "VERBOSE=1 in the environment: on a terminal, too, everything a file gets.\n"
         "Exit status: 0 all passed, 1 something failed, 2 the check itself cannot work.\n"
         "On a terminal what is still to do has not failed: status 0.\n"
         "To see everything a program says, run it by hand: build/step05_zbuffer -o DIRECTORY");
}

int options_read(struct options *o, int argc, char **argv, struct error *error) {
    const struct argument known[] = {
        {"--root", "DIR", "the course's directory; other paths start there (.)", read_path,
         &o->root},
        {"--scenes", "FILE", "the table of scenes (tests/check/scenes.txt)", read_path, &o->scenes},
        {"--sources", "DIR", "DIR/STEP/main.c tells what is still to do (.)", read_path,
         &o->sources},
        {"--references", "DIR", "the reference images (tests/reference)", read_path,
         &o->references},
        {"--looks", "DIR", "DIR/STEP/looks: known mistakes    (tests/lessons)", read_path,
         &o->looks},
        {"--programs", "DIR", "where make puts the programs (build/quick)", read_path,
         &o->programs},
        {"--differences", "DIR", "where difference images go (build/differences)", read_path,
         &o->differences},
        {"--make", "COMMAND", "builds DIR/STEP, the target (make)", read_path, &o->make},
        {"--only", "SCENE", "draw and compare just this scene of a step", read_path, &o->only},
        {"--shares", "FILE",
         "add a line to it for each picture: step, scene, % wrong, % apart,\n"
         "% drawn in one picture only, % near, levels too light on average, and\n"
         "how far it is from the mistake that it looks like",
         read_path, &o->shares},
        {"--counted", "FILE",
         "add what tells a mistake that no picture tells: scene, which pictures\n"
         "are right, counters (tests/check/counters.h)",
         read_path, &o->counted},
        {"--junit", "FILE", "a report for CI", read_path, &o->junit},
        {"--json", "FILE", "the same as JSON", read_path, &o->json},
        {"--html", "FILE", "the same for people", read_path, &o->html},
        {"--note", "TEXT", "a line that the reports begin with", read_path, &o->note},
        {"--sanitized", "", "make builds the programs so that they say in which line they crash",
         argument_flag, &o->sanitized},
    };
    const size_t known_count = sizeof known / sizeof known[0];
    if (arguments_want_help(argc, argv)) {
        print_help(known, known_count);
        *o = (struct options){.help = true};
        return 0;
    }
    return options_begin(o, error) ? arguments_read(known, known_count, argc, argv, error) : -1;
}
