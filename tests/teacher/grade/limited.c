/*
 * Runs a command under limits, and leaves nothing of it running: the supervisor of `make grade`,
 * which lives on when what it watches is killed.
 *
 *     limited SECONDS DISK_MB DIRECTORY OUTPUT COMMAND ARGUMENT...
 *
 * The command runs in DIRECTORY, where its files may take DISK_MB together (0: not counted); all
 * that it prints goes to OUTPUT, a new file. It has its own session, no terminal, no input.
 *
 * Exit status: the command's; 124 it was stopped after SECONDS; 125 it was stopped for using too
 * much, or could not be started, and a line says why; 137 it was killed.
 */
#include "check/run.h"

#include <stdio.h>
#include <stdlib.h>

enum { STATUS_TIME = 124, STATUS_STOPPED = 125, STATUS_KILLED = 137, MEGABYTE = 1000 * 1000 };

static int stopped(const char *why) {
    fprintf(stderr, "%s\n", why);
    return STATUS_STOPPED;
}

int main(int argc, char **argv) {
    enum { FIRST = 5 }; /* of the command */
    if (argc <= FIRST) {
        return stopped("usage: limited SECONDS DISK_MB DIRECTORY OUTPUT COMMAND ARGUMENT...");
    }
    /* Standard error goes where standard output does, in the order in which both are written. */
    const char *arguments[64] = {"sh", "-c", "exec \"$@\" 2>&1", "limited"};
    size_t count = 4;
    for (int i = FIRST; i < argc && count < 63; i++) {
        arguments[count++] = argv[i];
    }
    const struct run_command command = {
        .arguments = arguments,
        .directory = argv[3],
        .output = argv[4],
        .contained = true,
        .limits = {.seconds = strtod(argv[1], NULL),
                   .disk_bytes = (size_t)strtoul(argv[2], NULL, 10) * MEGABYTE,
                   .processes = 5000}, /* the check allows far fewer */
    };
    struct run_result result;
    struct error error;
    run_catch_signals();
    bool done = run(&command, &result, &error);
    struct run_text why = run_stopped_by(&result, &command.limits);
    bytes_free(&result.messages);
    if (run_caught_signal() != 0) {
        run_die_of_signal();
    }
    if (!done) {
        return stopped(error.message);
    }
    switch (result.end) {
    case RUN_EXITED:
        return result.number;
    case RUN_KILLED:
        return STATUS_KILLED;
    case RUN_OUT_OF_TIME:
        stopped(why.text);
        return STATUS_TIME;
    default:
        return stopped(why.text);
    }
}
