/*
 * The little of HTTP/1.1 (RFC 9112) that one page on this machine needs: each request on its own
 * connection, on an address that nobody can guess. Who connects and says nothing, or says it
 * slowly, keeps nobody waiting.
 */
#ifndef TESTS_STUDENT_LIVE_HTTP_H
#define TESTS_STUDENT_LIVE_HTTP_H

#include "base/bytes.h"
#include "base/error.h"

#include <stdbool.h>
#include <stddef.h>

enum { HTTP_TOKEN_LENGTH = 32, HTTP_PATH_LIMIT = 256, HTTP_CONNECTIONS = 32 };

struct http_server {
    int socket;
    unsigned port;                     /* of 127.0.0.1 */
    char token[HTTP_TOKEN_LENGTH + 1]; /* hexadecimal digits */
    /* Whose request isn't all there, the one that waits longest first. */
    struct http_caller {
        int connection;
        double since; /* by the clock of run_now() */
        struct bytes read;
    } caller[HTTP_CONNECTIONS];
    size_t caller_count;
};

struct http_request {
    int connection;
    bool is_post;
    char path[HTTP_PATH_LIMIT]; /* behind "/TOKEN/" */
    struct bytes body;          /* then a NUL */
};

/* Listen on the loopback address, at a port that the system chooses, with a random token. */
bool http_listen(struct http_server *server, struct error *error);

/* Wait at most so long for a request. True when there is one that is meant for us: to our Host, and
 * below our token. All else gets no answer but a status of 404, and is forgotten. */
bool http_next(struct http_server *server, int milliseconds, struct http_request *request);

/* Answer it, and end the connection. */
void http_answer(struct http_request *request, int status, const char *type, const void *data,
                 size_t size);

#endif
