/* A program that answers requests: see child.h. */
#define _GNU_SOURCE /* F_SETPIPE_SZ, where there is one */
#include "child.h"

#include "check/run.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

enum {
    START_SECONDS = 10,
    ANSWER_LIMIT = 300 * 1000 * 1000,
    SAID_LIMIT = 16 * 1024, /* bytes of what it prints are kept */
    AT_A_TIME = 64,         /* pieces of it: who prints without end must not keep us */
    LOOK_MS = 100,          /* between two looks at its memory */
    LONGER = 5,             /* times: where others keep the processors busy, or it sleeps */
    MEGABYTE = 1024 * 1024,
    MEMORY_LIMIT = 2000, /* megabytes */
    PIPE_SIZE = MEGABYTE /* where the system lets us: a frame comes in a few parts */
};

/* ---- Starting and ending ---- */

static void execute(const char *program, const char *model, int input, int output, int errors) {
    setsid();
    if (dup2(input, STDIN_FILENO) < 0 || dup2(output, STDOUT_FILENO) < 0 ||
        dup2(errors, STDERR_FILENO) < 0) {
        _exit(127);
    }
    for (int file = STDERR_FILENO + 1; file < 256; file++) {
        close(file);
    }
    const rlim_t bytes = run_program_limits(0).file_bytes;
    const struct rlimit core = {0, 0}, file = {bytes, bytes};
    setrlimit(RLIMIT_CORE, &core);
    setrlimit(RLIMIT_FSIZE, &file); /* fails only where less is allowed */
    execl(program, program, "--live", model[0] != '\0' ? model : (const char *)NULL,
          (const char *)NULL);
    _exit(127);
}

/* Three pipes, or none. */
static bool make_pipes(int pipes[3][2]) {
    int made = 0;
    while (made < 3 && pipe(pipes[made]) == 0) {
        made++;
    }
    for (int i = 0; made < 3 && i < made; i++) {
        close(pipes[i][0]);
        close(pipes[i][1]);
    }
    return made == 3;
}

static void close_pipes(struct child *child) {
    close(child->input);
    close(child->output);
    close(child->errors);
    child->id = 0;
}

bool child_start(struct child *child, const char *program, const char *model,
                 struct bytes *description, struct error *error) {
    enum { TO, FROM, ERRORS };
    int pipes[3][2];
    if (!make_pipes(pipes)) {
        return error_set(error, "cannot start %.900s: %s", program, strerror(errno));
    }
    child->id = fork();
    if (child->id == 0) {
        execute(program, model, pipes[TO][0], pipes[FROM][1], pipes[ERRORS][1]);
    }
    close(pipes[TO][0]);
    close(pipes[FROM][1]);
    close(pipes[ERRORS][1]);
    child->input = pipes[TO][1];
    child->output = pipes[FROM][0];
    child->errors = pipes[ERRORS][0];
    if (child->id < 0) {
        close_pipes(child);
        return error_set(error, "cannot start %.900s: %s", program, strerror(errno));
    }
#ifdef F_SETPIPE_SZ
    fcntl(child->output, F_SETPIPE_SZ, PIPE_SIZE);
#endif
    fcntl(child->errors, F_SETFL, O_NONBLOCK);
    child->pending.size = child->said.size = 0;
    struct bytes nothing = {.data = NULL};
    return child_ask(child, &nothing, START_SECONDS, description, error);
}

/* Read what it has printed; what is more than is kept is thrown away. */
static void hear(struct child *child) {
    char buffer[4096];
    for (int i = 0; i < AT_A_TIME; i++) {
        const ssize_t length = read(child->errors, buffer, sizeof buffer);
        if (length <= 0) {
            return;
        }
        const size_t room = SAID_LIMIT - child->said.size;
        bytes_append(&child->said, buffer, (size_t)length < room ? (size_t)length : room);
    }
}

/* Let it end, and say how it has. */
static int reap(struct child *child) {
    int status = 0;
    kill(-child->id, SIGKILL);
    waitpid(child->id, &status, 0);
    hear(child);
    close_pipes(child);
    return status;
}

void child_end(struct child *child) {
    if (child->id > 0) {
        reap(child);
    }
    bytes_free(&child->pending);
}

/* Its output has ended: say how it has. */
static bool has_ended(struct child *child, struct error *error) {
    int status = reap(child);
    if (WIFSIGNALED(status) && WTERMSIG(status) != SIGKILL) {
        return error_set(error, "crashed: %s", run_signal_name(WTERMSIG(status)).text);
    }
    return error_set(error, "ended with exit status %d", WEXITSTATUS(status));
}

/* A number that the system may have of it in /proc/ID/NAME; otherwise that one. */
static double number_of(const struct child *child, const char *name, const char *format,
                        double otherwise) {
    char path[64];
    double number = otherwise;
    snprintf(path, sizeof path, "/proc/%ld/%s", (long)child->id, name);
    FILE *file = fopen(path, "r");
    if (file != NULL) {
        number = fscanf(file, format, &number) == 1 ? number : otherwise;
        fclose(file);
    }
    return number;
}

/* How many megabytes it has in use, where the system says so; otherwise 0. */
static double memory_in_use(const struct child *child) {
    return number_of(child, "statm", "%*u %lf", 0) * (double)sysconf(_SC_PAGESIZE) / MEGABYTE;
}

/* For how many seconds processors worked for it, where the system says so; otherwise the time. */
static double seconds_at_work(const struct child *child) {
    return number_of(child, "schedstat", "%lf", 1e9 * run_now()) / 1e9;
}

/* ---- Asking ---- */

/* Has its answer taken so many seconds of a processor since then, or LONGER times as long? */
static bool is_too_long(const struct child *child, double begun, double worked, double seconds) {
    const double elapsed = run_now() - begun;
    return elapsed > seconds &&
           (elapsed > LONGER * seconds || seconds_at_work(child) - worked > 0.9 * seconds);
}

/* Read some more. */
static bool read_more(struct child *child, struct error *error) {
    struct pollfd waited[] = {{.fd = child->output, .events = POLLIN},
                              {.fd = child->errors, .events = POLLIN}};
    static char buffer[1 << 16];
    poll(waited, 2, LOOK_MS);
    hear(child);
    if ((waited[0].revents & (POLLIN | POLLHUP)) == 0) {
        const bool is_large = memory_in_use(child) > MEMORY_LIMIT;
        if (is_large) {
            child_end(child);
            error_set(error, "is stopped: it uses more than %d MB of memory", MEMORY_LIMIT);
        }
        return !is_large;
    }
    ssize_t length = read(child->output, buffer, sizeof buffer);
    if (length <= 0) {
        return has_ended(child, error);
    }
    return (child->pending.size < ANSWER_LIMIT &&
            bytes_append(&child->pending, buffer, (size_t)length)) ||
           error_out_of_memory(error);
}

/* The length of the line at that place, with its end; 0 while it is not all there. */
static size_t line_length(const struct bytes *pending, size_t at) {
    const unsigned char *end =
        at < pending->size ? memchr(pending->data + at, '\n', pending->size - at) : NULL;
    return end != NULL ? (size_t)(end - pending->data) + 1 - at : 0;
}

/* How long the answer is that begins with what is there; 0 while that is not known. */
static size_t answer_length(struct bytes *pending) {
    size_t at = line_length(pending, 0), width, height, count;
    char head[80] = "";
    memcpy(head, pending->data, at < sizeof head - 1 ? at : sizeof head - 1);
    if (at == 0 || sscanf(head, "frame %zu %zu %*f %zu", &width, &height, &count) != 3) {
        return at;
    }
    for (size_t i = 0, length; i < count; i++, at += length) {
        length = line_length(pending, at);
        if (length == 0) {
            return 0;
        }
    }
    return width <= 16384 && height <= 16384 ? at + 4 * width * height : at;
}

static bool send_request(struct child *child, const struct bytes *request, struct error *error) {
    for (size_t sent = 0; sent < request->size;) {
        ssize_t length = write(child->input, request->data + sent, request->size - sent);
        if (length <= 0) {
            return has_ended(child, error);
        }
        sent += (size_t)length;
    }
    return true;
}

bool child_ask(struct child *child, const struct bytes *request, double seconds,
               struct bytes *answer, struct error *error) {
    const double begun = run_now(), worked = seconds_at_work(child);
    if (!send_request(child, request, error)) {
        return false;
    }
    size_t length = 0;
    while (length == 0 || child->pending.size < length) {
        if (is_too_long(child, begun, worked, seconds)) {
            child_end(child);
            return error_set(error, "is stopped: it draws for too long; does every loop end?");
        }
        if (!read_more(child, error)) {
            return false;
        }
        length = child->pending.size > 0 ? answer_length(&child->pending) : 0;
    }
    bool done = bytes_append(answer, child->pending.data, length);
    child->pending.size -= length;
    memmove(child->pending.data, child->pending.data + length, child->pending.size);
    return done || error_out_of_memory(error);
}
