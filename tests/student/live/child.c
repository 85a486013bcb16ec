/* A program that answers requests: see child.h. */
#define _POSIX_C_SOURCE 200809L
#include "child.h"

#include "check/run.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum { START_SECONDS = 10, ANSWER_LIMIT = 300 * 1000 * 1000 };

/* ---- Starting and ending ---- */

static void execute(const char *program, const char *model, const char *said, int input,
                    int output) {
    int errors = open(said, O_WRONLY | O_CREAT | O_TRUNC, 0600);
    setsid();
    if (dup2(input, STDIN_FILENO) < 0 || dup2(output, STDOUT_FILENO) < 0 || errors < 0 ||
        dup2(errors, STDERR_FILENO) < 0) {
        _exit(127);
    }
    for (int file = STDERR_FILENO + 1; file < 256; file++) {
        close(file);
    }
    execl(program, program, "--live", model[0] != '\0' ? model : (const char *)NULL,
          (const char *)NULL);
    _exit(127);
}

bool child_start(struct child *child, const char *program, const char *model, const char *said,
                 struct bytes *description, struct error *error) {
    int to[2] = {-1, -1}, from[2] = {-1, -1};
    if (pipe(to) != 0 || pipe(from) != 0 || (child->id = fork()) < 0) {
        child->id = 0;
        for (int i = 0; i < 2; i++) {
            close(to[i]);
            close(from[i]);
        }
        return error_set(error, "cannot start %.900s: %s", program, strerror(errno));
    }
    if (child->id == 0) {
        execute(program, model, said, to[0], from[1]);
    }
    close(to[0]);
    close(from[1]);
    child->input = to[1];
    child->output = from[0];
    child->pending.size = 0;
    struct bytes nothing = {.data = NULL};
    return child_ask(child, &nothing, START_SECONDS, description, error);
}

void child_end(struct child *child) {
    if (child->id > 0) {
        kill(-child->id, SIGKILL);
        waitpid(child->id, NULL, 0);
        close(child->input);
        close(child->output);
        child->id = 0;
    }
    bytes_free(&child->pending);
}

/* Say how it has ended, and forget it. */
static bool has_ended(struct child *child, struct error *error) {
    int status = 0;
    kill(-child->id, SIGKILL);
    waitpid(child->id, &status, 0);
    close(child->input);
    close(child->output);
    child->id = 0;
    if (WIFSIGNALED(status) && WTERMSIG(status) != SIGKILL) {
        return error_set(error, "crashed: %s", run_signal_name(WTERMSIG(status)).text);
    }
    return error_set(error, "ended");
}

/* ---- Asking ---- */

/* Read some more until then. */
static bool read_more(struct child *child, double end, struct error *error) {
    struct pollfd waited = {.fd = child->output, .events = POLLIN};
    static char buffer[1 << 16];
    double left = end - run_now();
    if (left <= 0 || poll(&waited, 1, (int)(1000 * left) + 1) <= 0) {
        child_end(child);
        return error_set(error, "is stopped: it draws for too long; does every loop end?");
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
    const double end = run_now() + seconds;
    if (!send_request(child, request, error)) {
        return false;
    }
    size_t length = 0;
    while (length == 0 || child->pending.size < length) {
        if (!read_more(child, end, error)) {
            return false;
        }
        length = answer_length(&child->pending);
    }
    bool done = bytes_append(answer, child->pending.data, length);
    child->pending.size -= length;
    memmove(child->pending.data, child->pending.data + length, child->pending.size);
    return done || error_out_of_memory(error);
}
