/* What is said of a program's end, on every system: see run.h. */
#define _DEFAULT_SOURCE 1 /* SIGXFSZ and others */
#include "run.h"

#include <signal.h>
#include <stdio.h>
#include <time.h>

enum { MEGABYTE = 1000 * 1000 };

double run_now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + (double)t.tv_nsec / 1e9;
}

/* ---- Being asked to end ---- */

/* The only changing global: a signal handler has no other way to tell. */
static volatile sig_atomic_t caught_signal;

static void catch_signal(int number) {
    caught_signal = number;
}

void run_catch_signals(void) {
#ifdef _WIN32
    signal(SIGINT, catch_signal);
    signal(SIGTERM, catch_signal);
#else
    static const int caught[] = {SIGINT, SIGTERM, SIGHUP, SIGPIPE};
    for (size_t i = 0; i < sizeof caught / sizeof caught[0]; i++) {
        struct sigaction action;
        if (sigaction(caught[i], NULL, &action) == 0 && action.sa_handler != SIG_IGN) {
            action = (struct sigaction){.sa_handler = catch_signal};
            sigaction(caught[i], &action, NULL);
        }
    }
#endif
}

int run_caught_signal(void) {
    return caught_signal;
}

void run_die_of_signal(void) {
    signal(caught_signal, SIG_DFL);
    raise(caught_signal);
}

/* ---- How a program ended ---- */

struct run_text run_signal_name(int number) {
    static const struct {
        int number;
        const char *name;
    } known[] = {
        {SIGSEGV, "SIGSEGV, outside of an array, or a pointer to nothing"},
        {SIGABRT, "SIGABRT, ended by abort() or a failed assert()"},
        {SIGFPE, "SIGFPE, a whole number divided by 0"},
        {SIGILL, "SIGILL"},
        {SIGTERM, "SIGTERM"},
        {SIGINT, "SIGINT"},
#ifndef _WIN32
        {SIGBUS, "SIGBUS, outside of an array, or a pointer to nothing"},
        {SIGTRAP, "SIGTRAP"},
        {SIGSYS, "SIGSYS"},
        {SIGPIPE, "SIGPIPE"},
        {SIGKILL, "SIGKILL"},
        {SIGXFSZ, "SIGXFSZ"},
        {SIGXCPU, "SIGXCPU"},
        {SIGQUIT, "SIGQUIT"},
        {SIGHUP, "SIGHUP"},
        {SIGALRM, "SIGALRM"},
#endif
    };
    struct run_text name;
    snprintf(name.text, sizeof name.text, "signal %d", number);
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
        if (known[i].number == number) {
            snprintf(name.text, sizeof name.text, "%s", known[i].name);
        }
    }
    return name;
}

struct run_limits run_program_limits(double seconds) {
    return (struct run_limits){.seconds = seconds,
                               .file_bytes = (size_t)64 * MEGABYTE,
                               .disk_bytes = (size_t)256 * MEGABYTE,
                               .group_bytes = (size_t)2000 * MEGABYTE,
                               .processes = 64};
}

struct run_text run_stopped_by(const struct run_result *result, const struct run_limits *limits) {
    struct run_text text = {""};
    if (result->end == RUN_OUT_OF_TIME) {
        snprintf(text.text, sizeof text.text, "stopped after %g s", limits->seconds);
    } else if (result->end == RUN_TOO_MANY) {
        snprintf(text.text, sizeof text.text, "stopped at more than %u processes",
                 limits->processes);
    } else if (result->end == RUN_TOO_LARGE) {
        snprintf(text.text, sizeof text.text, "stopped at more than %zu MB of memory",
                 limits->group_bytes / MEGABYTE);
    } else if (result->end == RUN_DISK_FULL) {
        snprintf(text.text, sizeof text.text,
                 "stopped at more than %zu MB of files, %d of them, or %d levels deep",
                 limits->disk_bytes / MEGABYTE, RUN_FILE_COUNT, RUN_FILE_DEPTH);
    }
#ifdef SIGXFSZ
    if (result->end == RUN_KILLED && result->number == SIGXFSZ) {
        snprintf(text.text, sizeof text.text, "SIGXFSZ, file larger than %zu MB",
                 limits->file_bytes / MEGABYTE);
    }
#endif
    return text;
}

struct run_text run_ended_by(const struct run_result *result, const struct run_limits *limits) {
    struct run_text text = run_stopped_by(result, limits);
    if (text.text[0] == '\0' && result->end == RUN_KILLED) {
        return run_signal_name(result->number);
    }
    if (text.text[0] == '\0' && result->number != 0) {
        snprintf(text.text, sizeof text.text, "exit status %d", result->number);
    }
    return text;
}
