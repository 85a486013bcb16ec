/* The little of HTTP that one page needs: see http.h. */
#define _DEFAULT_SOURCE /* macOS and FreeBSD hide INADDR_LOOPBACK from POSIX alone */
#include "http.h"

#include "check/run.h"

#include <arpa/inet.h>
#include <errno.h>
#include <netinet/in.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

enum {
    HEAD_LIMIT = 16 * 1024,   /* bytes of a request's first line and fields */
    BODY_LIMIT = 1024 * 1024, /* bytes of its body */
    PATIENCE_SECONDS = 2      /* for a request, and for whoever does not take its answer */
};

/* ---- Listening ---- */

static bool make_token(struct http_server *server, struct error *error) {
    unsigned char random[HTTP_TOKEN_LENGTH / 2];
    FILE *file = fopen("/dev/urandom", "rb");
    bool done = file != NULL && fread(random, 1, sizeof random, file) == sizeof random;
    if (file != NULL) {
        fclose(file);
    }
    for (size_t i = 0; i < sizeof random && done; i++) {
        snprintf(server->token + 2 * i, 3, "%02x", random[i]);
    }
    return done || error_set(error, "/dev/urandom gives no random bytes");
}

bool http_listen(struct http_server *server, struct error *error) {
    struct sockaddr_in address = {.sin_family = AF_INET};
    socklen_t size = sizeof address;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    server->socket = socket(AF_INET, SOCK_STREAM, 0);
    if (server->socket < 0 ||
        bind(server->socket, (struct sockaddr *)&address, sizeof address) != 0 ||
        listen(server->socket, 16) != 0 ||
        getsockname(server->socket, (struct sockaddr *)&address, &size) != 0) {
        return error_set(error, "cannot listen on 127.0.0.1: %s", strerror(errno));
    }
    server->port = ntohs(address.sin_port);
    return make_token(server, error);
}

/* ---- Reading ---- */

/* Where the body begins in what was read so far; 0 while it does not. */
static size_t find_body(struct bytes *head) {
    static const char end[] = "\r\n\r\n";
    for (size_t i = 0; i + 4 <= head->size; i++) {
        if (memcmp(head->data + i, end, 4) == 0) {
            return i + 4;
        }
    }
    return 0;
}

/* The value of a field, without blanks before it; NULL where it is not among the fields. */
static const char *find_field(const char *head, const char *name) {
    size_t length = strlen(name);
    for (const char *line = strstr(head, "\r\n"); line != NULL; line = strstr(line + 2, "\r\n")) {
        if (strncasecmp(line + 2, name, length) == 0 && line[2 + length] == ':') {
            const char *value = line + 3 + length;
            return value + strspn(value, " \t");
        }
    }
    return NULL;
}

/* "GET /TOKEN/path HTTP/1.1", for our Host. */
static bool is_for_us(const struct http_server *server, const char *head,
                      struct http_request *request) {
    char host[32], format[64], method[8], token[HTTP_TOKEN_LENGTH + 1];
    const char *field = find_field(head, "Host");
    snprintf(host, sizeof host, "127.0.0.1:%u\r", server->port);
    snprintf(format, sizeof format, "%%7s /%%%d[0-9a-f]/%%%d[A-Za-z0-9_./]", HTTP_TOKEN_LENGTH,
             HTTP_PATH_LIMIT - 1);
    request->path[0] = '\0';
    if (field == NULL || strncmp(field, host, strlen(host)) != 0 ||
        sscanf(head, format, method, token, request->path) < 2) {
        return false;
    }
    request->is_post = strcmp(method, "POST") == 0;
    return (request->is_post || strcmp(method, "GET") == 0) && strcmp(token, server->token) == 0 &&
           strstr(request->path, "..") == NULL;
}

/* What is known of a request of which this has been read. */
enum reading { READING_MORE, READING_DONE, READING_REFUSED };

static enum reading read_request(const struct http_server *server, struct bytes *read,
                                 struct http_request *request) {
    const size_t body = find_body(read);
    if (body == 0) {
        return read->size > HEAD_LIMIT ? READING_REFUSED : READING_MORE;
    }
    const unsigned char kept = read->data[body - 1];
    read->data[body - 1] = '\0'; /* the end of the last field stays */
    const bool for_us = is_for_us(server, (const char *)read->data, request);
    const char *field = find_field((const char *)read->data, "Content-Length");
    const size_t length = field != NULL ? strtoul(field, NULL, 10) : 0;
    read->data[body - 1] = kept;
    if (!for_us || length > BODY_LIMIT) {
        return READING_REFUSED;
    }
    if (read->size < body + length) {
        return READING_MORE;
    }
    return bytes_append(&request->body, read->data + body, length) &&
                   bytes_append(&request->body, "", 1)
               ? READING_DONE
               : READING_REFUSED;
}

/* It is one no more; its connection stays open. */
static void forget_caller(struct http_server *server, size_t i) {
    bytes_free(&server->caller[i].read);
    server->caller_count--;
    memmove(&server->caller[i], &server->caller[i + 1],
            (server->caller_count - i) * sizeof server->caller[0]);
}

static void refuse(struct http_server *server, size_t i) {
    struct http_request request = {.connection = server->caller[i].connection};
    forget_caller(server, i);
    http_answer(&request, 404, "text/plain", "", 0);
}

/* Whoever connects takes the place of the one that waits longest, when there are many. */
static void accept_caller(struct http_server *server) {
    struct timeval patience = {.tv_sec = PATIENCE_SECONDS};
    int connection = accept(server->socket, NULL, NULL);
    if (connection < 0) {
        return;
    }
    if (server->caller_count == HTTP_CONNECTIONS) {
        refuse(server, 0);
    }
    setsockopt(connection, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
    server->caller[server->caller_count++] =
        (struct http_caller){.connection = connection, .since = run_now()};
}

/* Read what has come of a request. True when it is all there; then the caller is forgotten. */
static bool hear_caller(struct http_server *server, size_t i, struct http_request *request) {
    struct http_caller *caller = &server->caller[i];
    char buffer[16384];
    ssize_t length = recv(caller->connection, buffer, sizeof buffer, MSG_DONTWAIT);
    enum reading reading = READING_REFUSED;
    *request = (struct http_request){.connection = caller->connection};
    if (length > 0 && bytes_append(&caller->read, buffer, (size_t)length)) {
        reading = read_request(server, &caller->read, request);
    }
    if (reading == READING_DONE) {
        forget_caller(server, i);
        return true;
    }
    bytes_free(&request->body);
    if (reading == READING_REFUSED) {
        refuse(server, i);
    }
    return false;
}

bool http_next(struct http_server *server, int milliseconds, struct http_request *request) {
    struct pollfd waited[HTTP_CONNECTIONS + 1];
    *request = (struct http_request){.connection = -1};
    while (server->caller_count > 0 && run_now() - server->caller[0].since > PATIENCE_SECONDS) {
        refuse(server, 0);
    }
    const size_t count = server->caller_count;
    for (size_t i = 0; i < count; i++) {
        waited[i] = (struct pollfd){.fd = server->caller[i].connection, .events = POLLIN};
    }
    waited[count] = (struct pollfd){.fd = server->socket, .events = POLLIN};
    if (poll(waited, (nfds_t)(count + 1), milliseconds) <= 0) {
        return false;
    }
    for (size_t i = count; i-- > 0;) { /* who is forgotten moves only those behind */
        if (waited[i].revents != 0 && hear_caller(server, i, request)) {
            return true;
        }
    }
    if (waited[count].revents != 0) {
        accept_caller(server);
    }
    return false;
}

/* ---- Answering ---- */

static bool send_all(int connection, const void *data, size_t size) {
    for (const char *at = data; size > 0;) {
        ssize_t sent = send(connection, at, size, MSG_NOSIGNAL);
        if (sent <= 0) {
            return false;
        }
        at += sent;
        size -= (size_t)sent;
    }
    return true;
}

void http_answer(struct http_request *request, int status, const char *type, const void *data,
                 size_t size) {
    char head[512];
    int length = snprintf(
        head, sizeof head,
        "HTTP/1.1 %d %s\r\nContent-Type: %s\r\nContent-Length: %zu\r\n"
        "Cache-Control: no-store\r\nX-Content-Type-Options: nosniff\r\n"
        "Content-Security-Policy: default-src 'self'; img-src 'self' data:; base-uri 'none'; "
        "frame-ancestors 'self'; form-action 'none'\r\n"
        "Referrer-Policy: no-referrer\r\nConnection: close\r\n\r\n",
        status, status == 200 ? "OK" : "Not Found", type, size);
    if (send_all(request->connection, head, (size_t)length)) {
        send_all(request->connection, data, size);
    }
    close(request->connection);
    bytes_free(&request->body);
    request->connection = -1;
}
