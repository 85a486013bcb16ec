/*
 * The lessons' programs as one module of WebAssembly, for web pages. They answer requests as with
 * --live (common/run/live.h), but whenever the page calls, since nothing can wait there; and their
 * files are the page's: two models, and textures, which it loads when one is read first.
 *
 * site.sh compiles it: main() of step05_zbuffer is step05_zbuffer_main() then, LESSONS lists such
 * names. Calls of live_loop(), stage_draw(), file_read() and others of file.h come here (--wrap).
 */
#include "base/file.h"
#include "run/live.h"
#include "run/stage.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

/* ---- Models ---- */

enum { COLUMN_LIMIT = 16 }; /* a face of our models has nine numbers */

/* The number, with what stands behind it. */
static long read_number(const char **next) {
    bool minus = **next == '-';
    long number = 0;
    for (*next += minus; **next >= '0' && **next <= '9'; ++*next) {
        number = 10 * number + (**next - '0');
    }
    ++*next;
    return minus ? -number : number;
}

static char *write_number(char *to, long number) {
    char digits[24];
    int count = 0;
    for (unsigned long rest = (unsigned long)labs(number); rest > 0 || count == 0; rest /= 10) {
        digits[count++] = (char)('0' + rest % 10);
    }
    if (number < 0) {
        *to++ = '-';
    }
    while (count > 0) {
        *to++ = digits[--count];
    }
    return to;
}

struct column {
    const char *next;
    long number;
};

/* A line that looks so, with the next number of each column. */
static char *write_row(char *to, const char *look, struct column *column) {
    for (; *look != '\n'; look++) {
        if (*look != '.' && *look != '0') {
            *to++ = *look;
            continue;
        }
        column->number += read_number(&column->next);
        to = write_number(to, column++->number);
        if (*look == '.') { /* a fraction */
            memcpy(to, "e-6", 3);
            to += 3;
        }
    }
    *to++ = '\n';
    return to;
}

/* Append a model's text, of its columns of differences (model.awk): of lines that look alike, what
 * they look like, how many they are, and a line for each number in them. False when memory runs
 * out. */
static bool unfold(const char *columns, struct bytes *text) {
    while (*columns != '\0') {
        struct column column[COLUMN_LIMIT];
        const char *look = columns, *next = strchr(look, '\n') + 1;
        size_t longest = 32 * (size_t)(next - look), count = 0;
        long rows = read_number(&next);
        for (const char *c = look; *c != '\n'; c++) {
            if (*c == '.' || *c == '0') {
                assert(count < COLUMN_LIMIT);
                column[count++] = (struct column){next, 0};
                next = strchr(next, '\n') + 1;
            }
        }
        for (long row = 0; row < rows; row++) {
            if (!bytes_reserve(text, longest)) {
                return false;
            }
            char *to = (char *)text->data + text->size;
            text->size += (size_t)(write_row(to, look, column) - to);
        }
        columns = next;
    }
    return true;
}

/* ---- Files ---- */

enum { MODEL_COUNT = 2, FILE_COUNT = 5 }; /* the first are models */

static const char *const names[FILE_COUNT] = {"bust.obj", "knot.off", "bust_diffuse.png",
                                              "bust_nm.png", "bust_spec.png"}; /* as in site.sh */

/* How many bytes the file has, 0 where the page has not loaded it yet; and a copy of them. A
 * program that misses textures asks for them all, and ends before it draws. Then the page loads
 * them, begins the program again from the start, and asks again. */
unsigned size_of_file(int file);
void copy_file(int file, unsigned char *to);

/* Leaves all functions that run, as wait_for_calls() does, where a texture was missing. */
void wait_for_textures(void);

bool __real_stage_draw(struct stage *stage, struct image *image, size_t frame, struct error *error);

bool __wrap_stage_draw(struct stage *stage, struct image *image, size_t frame,
                       struct error *error) {
    wait_for_textures();
    return __real_stage_draw(stage, image, frame, error);
}

/* Its place among the files; FILE_COUNT: there is none of that name. */
static int find_file(const char *path) {
    const char *slash = strrchr(path, '/');
    int i = 0;
    while (i < FILE_COUNT && strcmp(names[i], slash != NULL ? slash + 1 : path) != 0) {
        i++;
    }
    return i;
}

bool __wrap_file_exists(const char *path) {
    return find_file(path) < FILE_COUNT;
}

bool __wrap_file_find(char *path) {
    return __wrap_file_exists(path);
}

bool __wrap_file_read(const char *path, struct bytes *bytes, struct error *error) {
    int i = find_file(path);
    *bytes = (struct bytes){0};
    if (i == FILE_COUNT) {
        return error_set(error, "%s: a web page has no such file", path);
    }
    unsigned size = size_of_file(i);
    if (size == 0 || !bytes_reserve(bytes, size)) {
        return error_set(error, "%s: is not there yet", path);
    }
    copy_file(i, bytes->data);
    bytes->size = size;
    if (i >= MODEL_COUNT) {
        return true;
    }
    struct bytes text = {0};
    bool enough = bytes_append(bytes, "", 1) && unfold((const char *)bytes->data, &text);
    bytes_free(bytes);
    *bytes = text;
    return enough || error_out_of_memory(error);
}

/* ---- Answers ---- */

static struct {
    const struct program *program;
    live_answer *answer;
    void *context;
} loop; /* of the program that runs */

/* Leaves all functions that run, by an exception of JavaScript, and so without an end to what they
 * have on the stack: the program's state stays there. */
void wait_for_calls(void);

bool __real_live_loop(const struct program *program, FILE *in, FILE *out, live_answer *answer,
                      void *context, struct error *error);

bool __wrap_live_loop(const struct program *program, FILE *in, FILE *out, live_answer *answer,
                      void *context, struct error *error) {
    (void)in, (void)out, (void)error;
    loop.program = program;
    loop.answer = answer;
    loop.context = context;
    wait_for_calls();
    return true;
}

void start(int lesson);
void answer(void);

#ifndef LESSONS
#define LESSONS(X) X(step01_line)
#endif
#define DECLARE(name) int name##_main(int argc, char **argv);
#define MAIN(name)    name##_main,
LESSONS(DECLARE)

/* Run a lesson's program up to its first request: the how manieth of LESSONS. Standard output gets
 * the description of its scenes, a line. */
void start(int lesson) {
    static int (*const mains[])(int, char **) = {LESSONS(MAIN)};
    static char program[] = "lesson", live[] = "--live";
    static char *arguments[] = {program, live, NULL};
    mains[lesson](2, arguments);
}

/* Answer what standard input has. */
void answer(void) {
    struct error error;
    clearerr(stdin);
    __real_live_loop(loop.program, stdin, stdout, loop.answer, loop.context, &error);
}
