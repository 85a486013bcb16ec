/*
 * Runs a program that may go wrong in any way: in an empty directory, in its own session (a process
 * group without a terminal), under limits, and with nothing left of its group afterwards.
 *
 * What is limited: elapsed time, CPU time (the same on each core), the size of a file and of all
 * files in its directory, open files, memory, the number of processes, core files (none). When the
 * time is over, the whole group gets SIGTERM and half a second later SIGKILL; after any end,
 * whoever is left in the group gets SIGKILL. On Linux the processes and their memory are counted
 * through /proc, since RLIMIT_NPROC counts all processes of a user and does not bind root. On other
 * systems RLIMIT_NPROC alone stops a program that forks without end.
 *
 * On Windows a job object takes the group's place: at the end all of it is killed at once, and its
 * memory and its number of processes are Windows' to limit. Files, CPU time and open files have no
 * limit there, and CHECK_RUNNER is refused.
 *
 * This isn't a sandbox: a program that wants to can leave its group, use the network, read and
 * write any file of the user. For programs of strangers CHECK_RUNNER in the environment names a
 * command that shuts them in (tests/teacher/grade/contain.sh does); it is called as `RUNNER PROGRAM
 * ARGUMENT...` instead of the program. It must end as a shell would: with the program's status, or
 * 128 and the number of the signal that ended it.
 */
#ifndef TESTS_CHECK_RUN_H
#define TESTS_CHECK_RUN_H

#include "base/bytes.h"
#include "base/error.h"

#include <stdbool.h>
#include <stddef.h>

enum {
    RUN_PATH_LIMIT = 2048,
    RUN_FILE_COUNT = 4096, /* in a program's directory */
    RUN_FILE_DEPTH = 64    /* directories in one another */
};

struct run_limits {
    double seconds;      /* elapsed; on Linux of processor time, while others keep it busy */
    size_t file_bytes;   /* of each file; 0: no limit */
    size_t memory_bytes; /* of each process, as addresses; 0: no limit */
    unsigned processes;  /* at the same time, threads not counted; only where contained */
    size_t group_bytes;  /* memory in use by all its processes together; 0: no limit; as above */
    size_t disk_bytes;   /* of all files in `directory` together; 0: no limit; as above */
};

struct run_command {
    const char *const *arguments; /* program and arguments, then NULL; found through PATH */
    const char *directory;        /* to run in; NULL: where the caller is */
    const char *output;           /* a file for its standard output; NULL: it is thrown away */
    size_t output_bytes;          /* keep only the last so many (but on Windows all); 0: all */
    const char *locale;           /* LC_ALL of the command; NULL: unchanged */
    bool contained;               /* under all limits; otherwise seconds and sizes alone */
    struct run_limits limits;
};

enum run_end {
    RUN_EXITED,      /* `number` is the exit status; 127 when the program could not be started */
    RUN_KILLED,      /* `number` is the signal */
    RUN_OUT_OF_TIME, /* stopped after limits.seconds, or it used up its CPU time */
    RUN_TOO_MANY,    /* stopped for more than limits.processes */
    RUN_TOO_LARGE,   /* stopped for more than limits.group_bytes of memory */
    RUN_DISK_FULL,   /* stopped for more than limits.disk_bytes, or for thousands of files */
    RUN_INTERRUPTED  /* stopped, because this process was asked to end */
};

struct run_result {
    enum run_end end;
    int number;
    /* The first 256 KiB of what it wrote to standard error, NULs made blanks, then a NUL. */
    struct bytes messages;
};

/* Run a command and wait for it. Standard input is empty. False when it could not even be tried.
 * The caller frees result->messages, also on an error. */
bool run(const struct run_command *command, struct run_result *result, struct error *error);

/* What a step's program may use while it draws for so many seconds: what holds in every place where
 * submissions run. */
struct run_limits run_program_limits(double seconds);

/* Seconds since some time, by a clock that nobody sets. */
double run_now(void);

/* What made it end as it did, where that is a limit: "stopped after 10 s"; else "". */
struct run_text {
    char text[112];
};
struct run_text run_stopped_by(const struct run_result *result, const struct run_limits *limits);

/* How it ended: by a limit, a signal's name, or "exit status 1"; "" where it ended well. */
struct run_text run_ended_by(const struct run_result *result, const struct run_limits *limits);

/* The name of a signal, and what a program has done to get it: "SIGFPE, a whole number divided by
 * 0". */
struct run_text run_signal_name(int number);

/* Call this before any file is opened: it would become standard input, output or error of whoever
 * has called us without, and be written into. Output that was closed stays one that nobody can
 * write to. False when that cannot be had. */
bool run_open_standard_files(void);

/* From now on SIGINT, SIGTERM, SIGHUP and SIGPIPE do not end this process but make run() end. */
void run_catch_signals(void);

/* The signal that has come since, or 0. */
int run_caught_signal(void);

/* End this process by that signal, once everything is cleaned up. */
void run_die_of_signal(void);

/* Keep the file for this process, until it ends, however it ends. Where another one has it, print
 * `busy` on standard error once and wait, at most until a signal comes. False, with a message, when
 * the file cannot be written. */
bool run_lock(const char *path, const char *busy, struct error *error);

/* The directory of temporary files: $TMPDIR, or /tmp; that of Windows. */
const char *run_temporary(void);

/* Is there room for so many bytes in new files of the directory? False, with a message, when the
 * system says that there is not. (Of a user's own quota it says nothing.) */
bool run_has_room(const char *directory, size_t bytes, struct error *error);

/* Make an empty directory for a program in run_temporary(); its name is absolute. */
struct run_directory {
    char path[RUN_PATH_LIMIT];
};
bool run_directory_create(struct run_directory *directory, struct error *error);

/* Remove a directory with everything a program left in it. Links are removed, not followed. */
void run_directory_remove(const char *path);

#endif
