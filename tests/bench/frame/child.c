/* llvmpipe in a process of its own: see child.h. */
#define _DEFAULT_SOURCE /* MAP_ANONYMOUS, SIGPIPE */
#include "child.h"

#include "bench/timing.h"

#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

/* A child is told when to end: a later child has copies of an earlier one's pipes, so that these do
 * not close while it lives. */
enum order { ORDER_LOAD, ORDER_DRAW, ORDER_READ, ORDER_END };

struct request {
    enum order order;
    struct frame_scene scene; /* for ORDER_LOAD */
};

struct reply {
    bool done;
    double seconds;
    struct error error;
};

/* ---- Pipes ---- */

static bool write_all(int file, const void *data, size_t size) {
    const char *next = data;
    while (size > 0) {
        ssize_t written = write(file, next, size);
        if (written <= 0) {
            return false;
        }
        next += written;
        size -= (size_t)written;
    }
    return true;
}

static bool read_all(int file, void *data, size_t size) {
    char *next = data;
    while (size > 0) {
        ssize_t got = read(file, next, size);
        if (got <= 0) {
            return false;
        }
        next += got;
        size -= (size_t)got;
    }
    return true;
}

/* ---- The child ---- */

static void obey(struct llvmpipe *l, const struct request *request, uint8_t *pixels,
                 struct reply *reply) {
    struct stopwatch start;
    *reply = (struct reply){.done = true};
    switch (request->order) {
    case ORDER_LOAD:
        reply->done = llvmpipe->load(l, &request->scene, &reply->error);
        break;
    case ORDER_DRAW:
        llvmpipe->draw(l);
        start = stopwatch_start();
        llvmpipe->draw(l);
        reply->seconds = stopwatch_seconds(start);
        break;
    case ORDER_READ:
        reply->done = llvmpipe->read(l, pixels, &reply->error);
        break;
    case ORDER_END:
        break;
    }
}

/* Do what is asked until nobody asks any more. The first reply says who draws, or why nobody
 * does. */
static void serve(int threads, uint8_t *pixels, int from, int to) {
    struct request request;
    struct reply reply = {.done = false};
    struct llvmpipe *l = llvmpipe->open(threads, &reply.error);
    if (l != NULL) {
        reply.done = true;
        snprintf(reply.error.message, sizeof reply.error.message, "%s", llvmpipe->name(l));
    }
    while (write_all(to, &reply, sizeof reply) && l != NULL &&
           read_all(from, &request, sizeof request) && request.order != ORDER_END) {
        obey(l, &request, pixels, &reply);
    }
    if (l != NULL) {
        llvmpipe->close(l);
    }
}

/* ---- The parent ---- */

static bool receive(const struct child *child, struct reply *reply, struct error *error) {
    if (!read_all(child->from, reply, sizeof *reply)) {
        return error_set(error, "llvmpipe has ended unexpectedly");
    }
    *error = reply->error;
    return reply->done;
}

static bool ask(const struct child *child, const struct request *request, struct reply *reply,
                struct error *error) {
    if (!write_all(child->to, request, sizeof *request)) {
        return error_set(error, "llvmpipe has ended unexpectedly");
    }
    return receive(child, reply, error);
}

/* In the child: leave without what the parent has registered to be done at its end. */
static void live(const struct child *child, int threads, int from, int to) {
    close(child->to);
    close(child->from);
    serve(threads, child->pixels, from, to);
    _exit(0);
}

static bool begin(struct child *child, int threads, struct error *error) {
    int to[2], from[2];
    if (pipe(to) != 0) {
        return error_set(error, "cannot make a pipe");
    }
    if (pipe(from) != 0) {
        close(to[0]);
        close(to[1]);
        return error_set(error, "cannot make a pipe");
    }
    child->to = to[1];
    child->from = from[0];
    signal(SIGPIPE, SIG_IGN); /* a child that has ended is an error, not our end */
    fflush(NULL);             /* what is not written yet would be written twice */
    child->process = fork();
    if (child->process == 0) {
        live(child, threads, to[0], from[1]);
    }
    close(to[0]);
    close(from[1]);
    if (child->process < 0) {
        close(to[1]);
        close(from[0]);
        child->process = 0;
        return error_set(error, "cannot start a process");
    }
    return true;
}

bool child_start(struct child *child, int threads, size_t pixels_most, struct error *error) {
    struct reply reply;
    *child = (struct child){.pixels_size = 4 * pixels_most};
    void *pixels =
        mmap(NULL, child->pixels_size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (pixels == MAP_FAILED) {
        return error_out_of_memory(error);
    }
    child->pixels = pixels;
    if (!begin(child, threads, error) || !receive(child, &reply, error)) {
        child_end(child);
        return false;
    }
    snprintf(child->name, sizeof child->name, "%.255s", reply.error.message);
    return true;
}

void child_end(struct child *child) {
    const struct request request = {.order = ORDER_END};
    if (child->process != 0) {
        (void)write_all(child->to, &request, sizeof request);
        close(child->to);
        close(child->from);
        waitpid(child->process, NULL, 0);
    }
    if (child->pixels != NULL) {
        munmap(child->pixels, child->pixels_size);
    }
    *child = (struct child){0};
}

bool child_load(const struct child *child, const struct frame_scene *scene, struct error *error) {
    struct request request = {.order = ORDER_LOAD, .scene = *scene};
    struct reply reply;
    return ask(child, &request, &reply, error);
}

bool child_draw(const struct child *child, double *seconds, struct error *error) {
    struct request request = {.order = ORDER_DRAW};
    struct reply reply = {.seconds = 0};
    bool done = ask(child, &request, &reply, error);
    *seconds = reply.seconds;
    return done;
}

bool child_read(const struct child *child, struct error *error) {
    struct request request = {.order = ORDER_READ};
    struct reply reply;
    return ask(child, &request, &reply, error);
}
