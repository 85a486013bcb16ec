/* llvmpipe in a process of its own: see child.h. */
#define _DEFAULT_SOURCE /* MAP_ANONYMOUS */
#include "child.h"

#include "bench/timing.h"

#include <signal.h>
#include <stdio.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

/* A child is told when to end: a later child has a copy of an earlier one's socket, so that this
 * does not close while it lives. */
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

/* ---- The socket between both ---- */

/* What is sent is small, and waits there as a whole. */
static bool send_all(int socket, const void *data, size_t size) {
    return send(socket, data, size, 0) == (ssize_t)size;
}

static bool receive_all(int socket, void *data, size_t size) {
    return recv(socket, data, size, MSG_WAITALL) == (ssize_t)size;
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
static void serve(int threads, uint8_t *pixels, int parent) {
    struct request request;
    struct reply reply = {.done = false};
    struct llvmpipe *l = llvmpipe->open(threads, &reply.error);
    if (l != NULL) {
        reply.done = true;
        snprintf(reply.error.message, sizeof reply.error.message, "%s", llvmpipe->name(l));
    }
    while (send_all(parent, &reply, sizeof reply) && l != NULL &&
           receive_all(parent, &request, sizeof request) && request.order != ORDER_END) {
        obey(l, &request, pixels, &reply);
    }
    if (l != NULL) {
        llvmpipe->close(l);
    }
}

/* ---- The parent ---- */

static bool receive(const struct child *child, struct reply *reply, struct error *error) {
    if (!receive_all(child->socket, reply, sizeof *reply)) {
        return error_set(error, "llvmpipe has ended unexpectedly");
    }
    *error = reply->error;
    return reply->done;
}

static bool ask(const struct child *child, struct request request, struct reply *reply,
                struct error *error) {
    *reply = (struct reply){.seconds = 0};
    return (send_all(child->socket, &request, sizeof request) ||
            error_set(error, "llvmpipe has ended unexpectedly")) &&
           receive(child, reply, error);
}

/* The child leaves without what the parent has registered to be done at its end. */
static bool begin(struct child *child, int threads, struct error *error) {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0) {
        return error_set(error, "cannot make a socket");
    }
    signal(SIGPIPE, SIG_IGN); /* a child that has ended is an error, not our end */
    fflush(NULL);             /* what is not written yet would be written twice */
    child->process = fork();
    if (child->process == 0) {
        close(ends[0]);
        serve(threads, child->pixels, ends[1]);
        _exit(0);
    }
    close(ends[1]);
    if (child->process < 0) {
        close(ends[0]);
        child->process = 0;
        return error_set(error, "cannot start a process");
    }
    child->socket = ends[0];
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
        (void)send_all(child->socket, &request, sizeof request);
        close(child->socket);
        waitpid(child->process, NULL, 0);
    }
    if (child->pixels != NULL) {
        munmap(child->pixels, child->pixels_size);
    }
    *child = (struct child){0};
}

bool child_load(const struct child *child, const struct frame_scene *scene, struct error *error) {
    struct reply reply;
    return ask(child, (struct request){ORDER_LOAD, *scene}, &reply, error);
}

bool child_draw(const struct child *child, double *seconds, struct error *error) {
    struct reply reply;
    bool done = ask(child, (struct request){.order = ORDER_DRAW}, &reply, error);
    *seconds = reply.seconds;
    return done;
}

bool child_read(const struct child *child, struct error *error) {
    struct reply reply;
    return ask(child, (struct request){.order = ORDER_READ}, &reply, error);
}
