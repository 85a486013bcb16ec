/*
 * The little of HTTP/1.1 (RFC 9112) that one page on this machine needs: a request at a time, each
 * on its own connection, on an address that nobody can guess.
 */
#ifndef TESTS_STUDENT_LIVE_HTTP_H
#define TESTS_STUDENT_LIVE_HTTP_H

#include "base/bytes.h"
#include "base/error.h"

#include <stdbool.h>
#include <stddef.h>

enum { HTTP_TOKEN_LENGTH = 32, HTTP_PATH_LIMIT = 256 };

struct http_server {
    int socket;
    unsigned port;                     /* of 127.0.0.1 */
    char token[HTTP_TOKEN_LENGTH + 1]; /* hexadecimal digits */
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
