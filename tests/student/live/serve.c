/*
 * Serves the page on which a lesson's own program draws under the mouse.
 *
 *     live BUILD MAKE STEP [MODEL]       STEP is step05_zbuffer; in the course's directory
 *
 * Behind the page runs BUILD/moving/STEP --live; MAKE builds it again at every save of the lesson's
 * sources. What compiler, crash or sanitizer say is shown in the page. Nobody but one page on this
 * machine, which knows the address, gets an answer; a minute after the last of its questions, or
 * with Ctrl-C, this program ends.
 *
 * Exit status: 0 ended; 1 it cannot work; 2 wrong usage.
 */
#define _POSIX_C_SOURCE 200809L
#include "child.h"
#include "http.h"

#include "base/file.h"
#include "check/fault.h"
#include "check/page/escape.h"
#include "check/run.h"

#include <dirent.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>

enum {
    LOOK_MS = 200,       /* between two looks at the sources */
    GONE_SECONDS = 60,   /* after the page's last question */
    BUILD_SECONDS = 120, /* for the compiler */
    SANITIZED_SECONDS = 20,
    MESSAGE_LINES = 40 /* of the compiler's are shown */
};

static const double frame_seconds = 2; /* for the student's program */

struct live {
    const char *build, *make, *step, *model;
    struct http_server server;
    struct child child;
    struct bytes description; /* of its scenes; then a NUL */
    struct bytes message;     /* what is wrong, then a NUL; empty: nothing */
    unsigned version;         /* one more with every build */
    unsigned explained;       /* the version of which a crash was explained */
    uint64_t sources;         /* a sum of their names, sizes and times */
};

static struct result_path path_of(const struct live *live, const char *directory) {
    struct result_path path;
    snprintf(path.text, sizeof path.text, "%s/%s%s", live->build, directory, live->step);
    return path;
}

/* ---- Messages ---- */

/* The lines of a text, at most so many. */
static void set_message(struct live *live, const char *text) {
    size_t length = 0;
    for (int lines = 0; lines < MESSAGE_LINES && text[length] != '\0'; lines++) {
        length += strcspn(text + length, "\n");
        length += text[length] == '\n';
    }
    live->message.size = 0;
    if (length > 0) {
        bytes_append(&live->message, text, length);
        bytes_append(&live->message, "", 1);
        fprintf(stderr, "%s\n", (const char *)live->message.data);
    }
}

/* ---- Building ---- */

static bool run_make(const struct live *live, const char *target, struct run_result *result,
                     struct error *error) {
    char script[DRAWN_PATH_LIMIT];
    snprintf(script, sizeof script, "%s \"$@\" >&2", live->make);
    const char *arguments[] = {"sh", "-c", script, "make", target, NULL};
    const struct run_command command = {
        .arguments = arguments, .locale = "C", .limits = {.seconds = BUILD_SECONDS}};
    return run(&command, result, error);
}

static bool is_done(const struct run_result *result) {
    return result->end == RUN_EXITED && result->number == 0;
}

/* Build the program; where that fails the one before goes on. */
static void build(struct live *live) {
    struct run_result result = {.end = RUN_EXITED};
    struct error error;
    bool done = run_make(live, path_of(live, "moving/").text, &result, &error);
    live->version++;
    if (!done) {
        set_message(live, error.message);
    } else if (!is_done(&result)) {
        set_message(live, (const char *)result.messages.data);
    } else {
        child_end(&live->child);
        set_message(live, "");
    }
    bytes_free(&result.messages);
}

/* Changes when a source of the lesson does. */
static uint64_t sum_sources(const struct live *live) {
    uint64_t sum = 0;
    DIR *directory = opendir(live->step);
    for (struct dirent *entry; directory != NULL && (entry = readdir(directory)) != NULL;) {
        char path[DRAWN_PATH_LIMIT];
        struct stat status;
        size_t length = strlen(entry->d_name);
        bool is_source = length > 2 && (strcmp(entry->d_name + length - 2, ".c") == 0 ||
                                        strcmp(entry->d_name + length - 2, ".h") == 0);
        snprintf(path, sizeof path, "%s/%.255s", live->step, entry->d_name);
        if (is_source && stat(path, &status) == 0) {
#ifdef __APPLE__
            struct timespec saved = {status.st_mtime, status.st_mtimensec};
#else
            struct timespec saved = status.st_mtim;
#endif
            sum += (uint64_t)saved.tv_sec * 1000003 + (uint64_t)saved.tv_nsec +
                   (uint64_t)status.st_size * 31;
        }
    }
    if (directory != NULL) {
        closedir(directory);
    }
    return sum;
}

/* ---- Frames ---- */

/* What a program says that is built to tell where it goes wrong, given the same request. */
static void explain(struct live *live, const struct bytes *request) {
    struct result_path program = path_of(live, "sanitized/"),
                       asked = path_of(live, "served/asked.");
    struct run_result result = {.end = RUN_EXITED};
    struct result_text text = {""};
    struct error error;
    if (!file_write(asked.text, request->data, request->size, &error) ||
        !run_make(live, program.text, &result, &error) || !is_done(&result)) {
        bytes_free(&result.messages);
        return;
    }
    bytes_free(&result.messages);
    const char *arguments[] = {
        "sh", "-c", "exec \"$1\" --live <\"$2\" >/dev/null", "sh", program.text, asked.text, NULL};
    const struct run_command command = {.arguments = arguments,
                                        .limits = {.seconds = SANITIZED_SECONDS}};
    if (run(&command, &result, &error) &&
        fault_describe(&text, live->step, (const char *)result.messages.data)) {
        set_message(live, text.text);
    }
    bytes_free(&result.messages);
}

static bool start_child(struct live *live, struct error *error) {
    struct result_path said = path_of(live, "served/said.");
    if (live->child.id > 0) {
        return true;
    }
    live->description.size = 0;
    return child_start(&live->child, path_of(live, "moving/").text, live->model, said.text,
                       &live->description, error) &&
           bytes_append(&live->description, "", 1);
}

/* Let the program draw; `answer` is what it says, or why it does not. */
static void draw(struct live *live, const struct bytes *request, struct bytes *answer) {
    struct error error = {.line = 0};
    struct bytes asked = {request->data, request->size, 0}; /* which ends with one newline */
    asked.data[asked.size - 1] = '\n';
    asked.size -= asked.size > 1 && asked.data[asked.size - 2] == '\n';
    if (start_child(live, &error) &&
        child_ask(&live->child, &asked, frame_seconds, answer, &error)) {
        return;
    }
    char why[1200];
    snprintf(why, sizeof why, "%s %s", live->step, error.message);
    const bool crashed = strstr(error.message, "crashed") != NULL;
    if (crashed && live->explained != live->version) {
        set_message(live, why);
        explain(live, &asked);
        live->explained = live->version;
    }
    answer->size = 0;
    bytes_print(answer, "error %s\n", crashed ? (const char *)live->message.data : why);
}

/* ---- Answers ---- */

static void answer_state(struct live *live, struct http_request *request) {
    struct bytes json = {.data = NULL};
    struct error error;
    if (live->description.size == 0) {
        start_child(live, &error);
    }
    bytes_print(&json, "{\"version\":%u,\"step\":\"%s\",\"message\":\"", live->version, live->step);
    escape_text(&json, escape_json, live->message.size > 0 ? (const char *)live->message.data : "");
    bytes_print(&json, "\",\"program\":%s}",
                live->description.size > 1 ? (const char *)live->description.data : "null");
    http_answer(request, 200, "application/json", json.data, json.size);
    bytes_free(&json);
}

static void answer_frame(struct live *live, struct http_request *request) {
    struct bytes answer = {.data = NULL};
    draw(live, &request->body, &answer);
    http_answer(request, 200, "application/octet-stream", answer.data, answer.size);
    bytes_free(&answer);
}

static void answer_file(struct http_request *request, const char *path, const char *type) {
    struct bytes file = {.data = NULL};
    struct error error;
    bool found = file_read(path, &file, &error);
    http_answer(request, found ? 200 : 404, type, file.data, found ? file.size : 0);
    bytes_free(&file);
}

static void answer(struct live *live, struct http_request *request) {
    static const struct {
        const char *path, *file, *type;
    } files[] = {
        {"", "tests/student/live/page.html", "text/html; charset=utf-8"},
        {"page.css", "tests/student/live/page.css", "text/css"},
        {"page.js", "tests/student/live/page.js", "text/javascript"},
        {"server.js", "tests/student/live/server.js", "text/javascript"},
    };
    for (size_t i = 0; i < sizeof files / sizeof files[0]; i++) {
        if (!request->is_post && strcmp(request->path, files[i].path) == 0) {
            answer_file(request, files[i].file, files[i].type);
            return;
        }
    }
    if (request->is_post && strcmp(request->path, "frame") == 0) {
        answer_frame(live, request);
    } else if (strcmp(request->path, "state") == 0) {
        answer_state(live, request);
    } else if (strncmp(request->path, "reference/", 10) == 0) {
        char path[DRAWN_PATH_LIMIT];
        snprintf(path, sizeof path, "tests/reference/%s/%s", live->step, request->path + 10);
        answer_file(request, path, "image/png");
    } else {
        http_answer(request, 404, "text/plain", "", 0);
    }
}

/* ---- The loop ---- */

static void serve(struct live *live) {
    time_t last = time(NULL);
    while (run_caught_signal() == 0 && time(NULL) - last < GONE_SECONDS) {
        struct http_request request;
        uint64_t sources = sum_sources(live);
        if (sources != live->sources) {
            live->sources = sources;
            build(live);
        }
        if (http_next(&live->server, LOOK_MS, &request)) {
            last = time(NULL);
            answer(live, &request);
        }
        bytes_free(&request.body);
    }
}

int main(int argc, char **argv) {
    struct error error;
    if (argc < 4 || argc > 5) {
        fprintf(stderr, "usage: live BUILD MAKE STEP [MODEL]\n");
        return 2;
    }
    struct live live = {.build = argv[1],
                        .make = argv[2],
                        .step = argv[3],
                        .model = argc > 4 ? argv[4] : "",
                        .version = 1};
    struct result_path place = path_of(&live, "served/");
    *strrchr(place.text, '/') = '\0';
    run_catch_signals();
    signal(SIGPIPE, SIG_IGN); /* a program that was killed is started again */
    setenv("ASAN_OPTIONS", "detect_leaks=0:handle_abort=1",
           1); /* of programs that explain() runs */
    setenv("UBSAN_OPTIONS", "print_stacktrace=1", 1);
    if (!directory_create(place.text, &error) || !http_listen(&live.server, &error)) {
        fprintf(stderr, "live: %s\n", error.message);
        return 1;
    }
    printf("http://127.0.0.1:%u/%s/\n", live.server.port, live.server.token);
    fflush(stdout);
    live.sources = sum_sources(&live);
    serve(&live);
    child_end(&live.child);
    bytes_free(&live.description);
    bytes_free(&live.message);
    return 0;
}
