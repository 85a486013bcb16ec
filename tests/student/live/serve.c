/*
 * Serves the page on which a lesson's own program draws under the mouse.
 *
 *     live BUILD MAKE STEP [MODEL [OPEN]]       STEP is step05_zbuffer; in the course's directory
 *
 * Behind the page runs BUILD/moving/STEP --live; MAKE builds it again at every save of the lesson's
 * sources, and then a second time with the sanitizers, which are given the page's last question:
 * they find what does not crash. What compiler, program or sanitizers say is shown in the page.
 * Nobody who does not know the address gets an answer. OPEN is a command that opens the file it is
 * given in a browser: a page that only this user can read, and that leads to the address, which no
 * other user must see among the arguments of processes.
 *
 * It ends with Ctrl-C, with SIGTERM, and when its terminal or whoever started it is gone.
 *
 * Exit status: 0 ended; 1 it cannot work; 2 wrong usage.
 */
#define _POSIX_C_SOURCE 200809L
#include "child.h"
#include "http.h"
#include "job.h"

#include "base/file.h"
#include "check/fault.h"
#include "check/page/escape.h"
#include "check/run.h"
#include "check/todo.h"

#include <dirent.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

enum {
    LOOK_MS = 200,       /* between two looks at the sources */
    BUILD_SECONDS = 120, /* for the compiler */
    SANITIZED_SECONDS = 20,
    STILL_SECONDS = 1, /* after a question, before the sanitized program is given it */
    MESSAGE_LINES = 40 /* of the compiler's are shown */
};

static const double frame_seconds = 2; /* for the student's program */

/* What is done in the background, one after the other. */
enum work { WORK_BUILD, WORK_BUILD_SANITIZED, WORK_TRY_SANITIZED };

struct live {
    const char *build, *make, *step, *model;
    struct http_server server;
    struct child child;
    struct job job;
    enum work work;           /* of the job */
    struct bytes description; /* of its scenes; then a NUL */
    struct bytes message;     /* what is wrong, then a NUL; empty: nothing */
    struct bytes asked;       /* the page's last question */
    unsigned version;         /* one more with every program that is built, or fails to */
    double asked_at;          /* when that was */
    bool is_sanitized;        /* the other program is built, too, of this version, */
    bool is_tried;            /* and has been given the question */
    uint64_t sources;         /* a sum of their names, sizes and times */
};

static struct result_path path_of(const struct live *live, const char *directory) {
    struct result_path path;
    snprintf(path.text, sizeof path.text, "%s/%s%s", live->build, directory, live->step);
    return path;
}

/* ---- Messages ---- */

static bool is_of_make(const char *line) {
    const char *error = strstr(line, "] Error ");
    return strncmp(line, "make", 4) == 0 || (error != NULL && error < line + strcspn(line, "\n"));
}

/* The lines of a text, at most so many, without those that make says of itself. */
static void set_message(struct live *live, const char *text) {
    live->message.size = 0;
    for (int lines = 0; lines < MESSAGE_LINES && *text != '\0';) {
        size_t length = strcspn(text, "\n");
        if (!is_of_make(text)) {
            bytes_print(&live->message, "%.*s\n", (int)length, text);
            lines++;
        }
        text += length + (text[length] == '\n');
    }
    if (live->message.size > 0) {
        bytes_append(&live->message, "", 1);
        fprintf(stderr, "%s", (const char *)live->message.data);
    }
}

/* ---- What is done in the background ---- */

/* Start it; what it says will be in the file BUILD/served/job.STEP. */
static void start_job(struct live *live, enum work work, const char *const *arguments,
                      double seconds) {
    struct error error;
    live->work = work;
    if (!job_start(&live->job, arguments, seconds, path_of(live, "served/job.").text, &error)) {
        set_message(live, error.message);
    }
}

/* Let make build one of the two programs. The second one has time. */
static void start_build(struct live *live, enum work work, const char *room) {
    char script[DRAWN_PATH_LIMIT];
    const struct result_path program = path_of(live, room);
    snprintf(script, sizeof script, "exec %s%s \"$@\" >&2", work == WORK_BUILD ? "" : "nice ",
             live->make);
    const char *arguments[] = {"sh", "-c", script, "make", program.text, NULL};
    live->is_sanitized = false;
    start_job(live, work, arguments, BUILD_SECONDS);
}

/* Give the page's last question to the program that is built to tell where it goes wrong. */
static void try_sanitized(struct live *live) {
    const struct result_path program = path_of(live, "moving/sanitized/"),
                             asked = path_of(live, "served/asked.");
    const char *arguments[] = {"sh", "-c",         "exec nice \"$1\" --live <\"$2\" >/dev/null",
                               "sh", program.text, asked.text,
                               NULL};
    struct error error;
    live->is_tried = true;
    if (live->asked.size > 0 &&
        file_write(asked.text, live->asked.data, live->asked.size, &error)) {
        start_job(live, WORK_TRY_SANITIZED, arguments, SANITIZED_SECONDS);
    }
}

/* What the compiler has said, or nothing but its warnings. Where it fails the program before goes
 * on. */
static void take_program(struct live *live, bool is_built, const char *said) {
    live->version++;
    set_message(live, said);
    if (is_built) {
        child_end(&live->child);
        start_build(live, WORK_BUILD_SANITIZED, "moving/sanitized/");
    }
}

static void look_at_job(struct live *live) {
    struct bytes said = {.data = NULL};
    struct result_text fault = {""};
    const enum job_state state = job_look(&live->job, path_of(live, "served/job.").text, &said);
    const char *text = said.size > 0 ? (const char *)said.data : "";
    if (state != JOB_SUCCEEDED && state != JOB_FAILED) {
        return;
    }
    if (live->work == WORK_BUILD) {
        take_program(live, state == JOB_SUCCEEDED, text);
    } else if (live->work == WORK_BUILD_SANITIZED) {
        live->is_sanitized = state == JOB_SUCCEEDED;
        live->is_tried = false;
    } else if (fault_describe(&fault, live->step, text)) {
        set_message(live, fault.text);
    }
    bytes_free(&said);
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

static bool start_child(struct live *live, struct error *error) {
    if (live->child.id > 0) {
        return true;
    }
    live->description.size = 0;
    return child_start(&live->child, path_of(live, "moving/").text, live->model, &live->description,
                       error) &&
           bytes_append(&live->description, "", 1);
}

/* Is it one question? Two would get two answers: one line or, where its last word is `text`, the
 * lines up to `end`. */
static bool is_one_question(const struct bytes *asked) {
    const char *text = (const char *)asked->data, *end = strchr(text, '\n');
    if (end != NULL && end - text >= 4 && strncmp(end - 4, "text", 4) == 0) {
        end = strstr(end, "\nend\n");
        end += end != NULL ? 4 : 0;
    }
    return end != NULL && end[1] == '\0' && strlen(text) + 1 == asked->size;
}

/* Let the program draw; `answer` is what it says, or why it does not. */
static void draw(struct live *live, const struct bytes *request, struct bytes *answer) {
    struct error error = {.line = 0};
    live->asked.size = 0;
    live->asked_at = run_now();
    live->is_tried = !bytes_append(&live->asked, request->data, request->size - 1);
    if (start_child(live, &error) &&
        child_ask(&live->child, &live->asked, frame_seconds, answer, &error)) {
        return;
    }
    answer->size = 0;
    bytes_print(answer, "error %s %s\n", live->step, error.message);
}

/* ---- Answers ---- */

/* The first task that main.c still has as the starter. */
static struct result_text find_to_do(const struct live *live) {
    struct result_text found = {""};
    char path[DRAWN_PATH_LIMIT], task[16] = "";
    snprintf(path, sizeof path, "%s/main.c", live->step);
    struct bytes source = todo_read(path);
    const char *at = (const char *)source.data;
    while (found.text[0] == '\0' && (at = strstr(at, "to do ")) != NULL) {
        at += strlen("to do ");
        if (sscanf(at, "%15[0-9a-z.]", task) == 1 &&
            todo_has_task((const char *)source.data, task)) {
            result_say(&found, "%s", task);
        }
    }
    bytes_free(&source);
    return found;
}

static void print_string(struct bytes *json, const char *name, const char *text) {
    bytes_print(json, ",\"%s\":\"", name);
    escape_text(json, escape_json, text);
    bytes_print(json, "\"");
}

static const char *text_of(const struct bytes *bytes) {
    return bytes->size > 0 ? (const char *)bytes->data : "";
}

static void answer_state(struct live *live, struct http_request *request) {
    struct bytes json = {.data = NULL}, printed = {.data = NULL};
    struct error error;
    if (live->description.size == 0) {
        start_child(live, &error);
    }
    bytes_append(&printed, live->child.said.data, live->child.said.size);
    bytes_append(&printed, "", 1);
    const bool is_building = live->job.id > 0 && live->work == WORK_BUILD;
    bytes_print(&json, "{\"version\":%u,\"building\":%s", live->version,
                is_building ? "true" : "false");
    print_string(&json, "step", live->step);
    print_string(&json, "message", text_of(&live->message));
    print_string(&json, "printed", text_of(&printed));
    print_string(&json, "todo", find_to_do(live).text);
    bytes_print(&json, ",\"program\":%s}",
                live->description.size > 1 ? (const char *)live->description.data : "null");
    http_answer(request, 200, "application/json", json.data, json.size);
    bytes_free(&printed);
    bytes_free(&json);
}

static void answer_frame(struct live *live, struct http_request *request) {
    struct bytes answer = {.data = NULL};
    if (is_one_question(&request->body)) {
        draw(live, &request->body, &answer);
    } else {
        bytes_print(&answer, "error a question is one line, or a text up to its end\n");
    }
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

/* What a lesson's text shows or names, of any file of the course; NULL for all else. */
static const char *type_of(const char *path) {
    static const char *const types[][2] = {{".md", "text/plain; charset=utf-8"},
                                           {".h", "text/plain; charset=utf-8"},
                                           {".c", "text/plain; charset=utf-8"},
                                           {".png", "image/png"},
                                           {".svg", "image/svg+xml"}};
    const char *end = path[0] != '/' ? strrchr(path, '.') : NULL;
    for (size_t i = 0; end != NULL && i < sizeof types / sizeof types[0]; i++) {
        if (strcmp(end, types[i][0]) == 0) {
            return types[i][1];
        }
    }
    return NULL;
}

static void answer(struct live *live, struct http_request *request) {
    static const struct {
        const char *path, *file, *type;
    } files[] = {
        {"", "tests/student/live/page.html", "text/html; charset=utf-8"},
        {"figures.html", "tests/student/live/figures.html", "text/html; charset=utf-8"},
        {"figures.css", "tests/student/live/figures.css", "text/css"},
        {"figures.js", "tests/student/live/figures.js", "text/javascript"},
        {"figure.css", "tests/student/live/figure.css", "text/css"},
        {"figure.js", "tests/student/live/figure.js", "text/javascript"},
        {"text.js", "tests/student/live/text.js", "text/javascript"},
        {"text.css", "tests/student/live/text.css", "text/css"},
        {"page.css", "tests/student/live/page.css", "text/css"},
        {"page.js", "tests/student/live/page.js", "text/javascript"},
        {"server.js", "tests/student/live/server.js", "text/javascript"},
    };
    char path[DRAWN_PATH_LIMIT];
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
        snprintf(path, sizeof path, "tests/reference/%s/%s", live->step, request->path + 10);
        answer_file(request, path, "image/png");
    } else {
        const char *type = type_of(request->path);
        answer_file(request, type != NULL ? request->path : "", type != NULL ? type : "text/plain");
    }
}

/* ---- The loop ---- */

static void serve(struct live *live) {
    const pid_t parent = getppid();
    while (run_caught_signal() == 0 && getppid() == parent) {
        struct http_request request;
        uint64_t sources = sum_sources(live);
        if (sources != live->sources) {
            live->sources = sources;
            start_build(live, WORK_BUILD, "moving/");
        }
        look_at_job(live);
        if (live->is_sanitized && !live->is_tried && live->job.id == 0 &&
            run_now() - live->asked_at > STILL_SECONDS) {
            try_sanitized(live);
        }
        if (http_next(&live->server, LOOK_MS, &request)) {
            answer(live, &request);
        }
        bytes_free(&request.body);
    }
}

/* Let the command open a page that leads to ours. */
static bool open_browser(const struct live *live, const char *command, struct error *error) {
    struct result_path page = path_of(live, "served/open.");
    struct bytes text = {.data = NULL};
    strncat(page.text, ".html", sizeof page.text - strlen(page.text) - 1);
    bytes_print(&text,
                "<!DOCTYPE html><meta charset=utf-8><title>Live</title>"
                "<meta http-equiv=refresh content=\"0; url=http://127.0.0.1:%u/%s/\">\n",
                live->server.port, live->server.token);
    unlink(page.text);
    const int file = open(page.text, O_WRONLY | O_CREAT | O_EXCL, 0600);
    const bool done = file >= 0 && write(file, text.data, text.size) == (ssize_t)text.size;
    if (file >= 0) {
        close(file);
    }
    bytes_free(&text);
    if (!done) {
        return error_set(error, "cannot write %.900s", page.text);
    }
    if (fork() == 0) {
        execlp("sh", "sh", "-c", "exec $1 \"$2\"", "sh", command, page.text, (const char *)NULL);
        _exit(127);
    }
    return true;
}

int main(int argc, char **argv) {
    struct error error;
    if (argc < 4 || argc > 6) {
        fprintf(stderr, "usage: live BUILD MAKE STEP [MODEL [OPEN]]\n");
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
    setenv("ASAN_OPTIONS", "detect_leaks=0:handle_abort=1", 1); /* of the sanitized program */
    setenv("UBSAN_OPTIONS", "print_stacktrace=1", 1);
    bool ready = directory_create(place.text, &error) && http_listen(&live.server, &error);
    if (ready) {
        printf("http://127.0.0.1:%u/%s/\n", live.server.port, live.server.token);
        fflush(stdout);
        ready = argc < 6 || open_browser(&live, argv[5], &error);
    }
    if (!ready) {
        fprintf(stderr, "live: %s\n", error.message);
        return 1;
    }
    live.sources = sum_sources(&live);
    start_build(&live, WORK_BUILD_SANITIZED, "moving/sanitized/");
    serve(&live);
    job_end(&live.job);
    child_end(&live.child);
    bytes_free(&live.child.said);
    bytes_free(&live.description);
    bytes_free(&live.message);
    bytes_free(&live.asked);
    return 0;
}
