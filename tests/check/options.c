#include "options.h"

#include "drawn.h"

#include <stdlib.h>
#include <string.h>

static const struct options default_options = {
    .root = ".",
    .scenes = "tests/check/scenes.txt",
    .sources = ".",
    .references = "tests/reference",
    .looks = "tests/check/looks",
    .programs = "build",
    .differences = "build/differences",
    .make = "make",
    .first = "models",
    .only = "",
    .shares = "",
    .counted = "",
    .junit = "",
    .json = "",
    .tap = "",
    .html = "",
    .csv = "",
    .note = "",
    .seconds = 10,
    .build_seconds = 60,
};

const char options_help[] =
    "Usage: check [options] [--] [STEP ...]\n"
    "Build the steps, draw their scenes, compare them with the reference images.\n"
    "STEP is 5, 05 or step05_zbuffer; without it all steps are checked.\n"
    "\n"
    "  --root DIR          the course's directory; other paths start there   (.)\n"
    "  --scenes FILE       the table of scenes          (tests/check/scenes.txt)\n"
    "  --sources DIR       DIR/STEP/main.c tells what is still to do         (.)\n"
    "  --references DIR    the reference images         (tests/reference)\n"
    "  --looks DIR         what known mistakes look like (tests/check/looks)\n"
    "  --programs DIR      where make puts the programs (build)\n"
    "  --differences DIR   where difference images go   (build/differences)\n"
    "  --make COMMAND      builds DIR/STEP, the target  (make)\n"
    "  --first TARGET      what make builds before the steps (models)\n"
    "  --only SCENE        draw and compare just this scene of a step\n"
    "  --shares FILE       add a line to it for each picture: step, scene, % wrong, % apart,\n"
    "                      % drawn in one picture only, % near, levels too light on average, "
    "and\n"
    "                      how far it is from the mistake that it looks like\n"
    "  --counted FILE      add what tells a mistake that no picture tells: scene, which pictures\n"
    "                      are right, counters (tests/check/counters.h)\n"
    "  --junit FILE        a report for CI; also --json, --tap, --csv (a line for each task), and\n"
    "                      --html for people\n"
    "  --note TEXT         a line that the reports begin with\n"
    "  --sanitized         make builds the programs so that they say in which line they crash\n"
    "  -h, --help\n"
    "\n"
    "A difference image shows the reference, yours and the difference. Red: this pixel of yours\n"
    "should not be there, or has another colour; blue: missing; dark green: differs, but does not\n"
    "count.\n"
    "\n"
    "CHECK_TIMEOUT in the environment: seconds that a step's program may take (10).\n"
    "CHECK_BUILD_TIMEOUT in the environment: seconds that building it may take (60).\n"
    "CHECK_RUNNER in the environment: a command that runs the programs, shut in.\n"
    "CHECK_EXACT=1 in the environment: every pixel of every scene must be equal.\n"
    "Exit status: 0 all passed, 1 something failed, 2 the check itself cannot work.\n"
    "To see all that a program says, run it by hand: build/step05_zbuffer -o DIRECTORY\n";

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

bool options_read(struct options *options, int argc, char **argv, int *first_step,
                  struct error *error) {
    const struct {
        const char *name;
        const char **value;
    } known[] = {
        {"--root", &options->root},
        {"--scenes", &options->scenes},
        {"--sources", &options->sources},
        {"--references", &options->references},
        {"--looks", &options->looks},
        {"--programs", &options->programs},
        {"--differences", &options->differences},
        {"--make", &options->make},
        {"--first", &options->first},
        {"--only", &options->only},
        {"--shares", &options->shares},
        {"--counted", &options->counted},
        {"--junit", &options->junit},
        {"--json", &options->json},
        {"--tap", &options->tap},
        {"--html", &options->html},
        {"--csv", &options->csv},
        {"--note", &options->note},
    };
    int i = 1;
    *options = default_options;
    while (i < argc && argv[i][0] == '-' && strcmp(argv[i], "--") != 0) {
        size_t k = 0, count = sizeof known / sizeof known[0];
        while (k < count && strcmp(argv[i], known[k].name) != 0) {
            k++;
        }
        if (strcmp(argv[i], "--sanitized") == 0) {
            options->sanitized = true;
            i++;
            continue;
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
    *first_step = i < argc && argv[i][0] == '-' ? i + 1 : i; /* behind "--" */
    return read_seconds("CHECK_TIMEOUT", &options->seconds, error) &&
           read_seconds("CHECK_BUILD_TIMEOUT", &options->build_seconds, error) &&
           read_exact(&options->exact, error);
}
