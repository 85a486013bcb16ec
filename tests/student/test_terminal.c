/* Pictures as bytes for a terminal, and what a terminal says of itself. */
#define _XOPEN_SOURCE 700
#include "check/page/base64.h"
#include "terminal.h"

#include "files/png.h"
#include "unit/unit.h"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

static struct image make(size_t width, size_t height) {
    struct image image;
    struct error error;
    CHECK(image_create(&image, width, height, IMAGE_BGR, &error));
    return image;
}

/* The bytes as a string; the caller frees them. */
static const char *shown(struct bytes *out, const struct image *image, enum terminal_kind kind) {
    struct error error;
    CHECK(terminal_show(out, image, kind, 2, &error));
    CHECK(bytes_append(out, "", 1));
    return (const char *)out->data;
}

static void test_base64(void) {
    /* The test vectors of RFC 4648. */
    static const struct {
        const char *plain, *text;
    } cases[] = {{"", ""},
                 {"f", "Zg=="},
                 {"fo", "Zm8="},
                 {"foo", "Zm9v"},
                 {"foob", "Zm9vYg=="},
                 {"fooba", "Zm9vYmE="},
                 {"foobar", "Zm9vYmFy"}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct bytes out = {.data = NULL};
        CHECK(base64_encode(&out, cases[i].plain, strlen(cases[i].plain)));
        CHECK(bytes_append(&out, "", 1));
        CHECK_TEXT((const char *)out.data, cases[i].text);
        bytes_free(&out);
    }
    const unsigned char high[] = {0xff, 0xef, 0xbe};
    struct bytes out = {.data = NULL};
    CHECK(base64_encode(&out, high, sizeof high) && bytes_append(&out, "", 1));
    CHECK_TEXT((const char *)out.data, "/+++");
    bytes_free(&out);
}

static void test_blocks(void) {
    struct image image = make(3, 3);
    unsetenv("NO_COLOR");
    setenv("COLORTERM", "truecolor", 1);
    struct bytes out = {.data = NULL};
    image_set(&image, 0, 2, color_rgb(255, 0, 1)); /* the upper row: one, then two equal ones */
    image_set(&image, 1, 2, color_rgb(2, 3, 4));
    image_set(&image, 2, 2, color_rgb(2, 3, 4));
    image_set(&image, 2, 1, color_rgb(9, 9, 9));
    CHECK_TEXT(shown(&out, &image, TERMINAL_BLOCKS),
               "\033[38;2;255;0;1m\033[48;2;0;0;0m\xe2\x96\x80"
               "\033[38;2;2;3;4m\xe2\x96\x80"
               "\033[48;2;9;9;9m\xe2\x96\x80\033[0m\n"
               "\033[38;2;0;0;0m\033[48;2;0;0;0m\xe2\x96\x80\xe2\x96\x80\xe2\x96\x80\033[0m\n");
    bytes_free(&out);
    image_free(&image);
}

/* Some colours of xterm's palettes, and the nearest of them where there are fewer. */
static void test_fewer_colors(void) {
    static const struct {
        const char *term;
        uint8_t r, g, b;
        const char *code;
    } cases[] = {
        {"linux", 0, 0, 0, "30m"},
        {"linux", 200, 10, 10, "31m"},
        {"linux", 230, 230, 230, "37m"},
        {"linux", 120, 120, 130, "90m"},
        {"linux", 255, 255, 255, "97m"},
        {"xterm-256color", 0, 0, 0, "38;5;16m"},
        {"xterm-256color", 255, 255, 255, "38;5;231m"},
        {"xterm-256color", 95, 135, 175, "38;5;67m"},
        {"xterm-256color", 90, 138, 170, "38;5;67m"},
        {"xterm-256color", 9, 8, 8, "38;5;232m"},
        {"xterm-256color", 237, 237, 240, "38;5;255m"},
    };
    unsetenv("COLORTERM");
    unsetenv("WT_SESSION");
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct image image = make(1, 1);
        struct bytes out = {.data = NULL};
        setenv("TERM", cases[i].term, 1);
        image_set(&image, 0, 0, color_rgb(cases[i].r, cases[i].g, cases[i].b));
        const char *text = shown(&out, &image, TERMINAL_BLOCKS);
        CHECK_ROW(strncmp(text + 2, cases[i].code, strlen(cases[i].code)) == 0, cases[i].code);
        bytes_free(&out);
        image_free(&image);
    }
}

static void test_characters(void) {
    struct image image = make(4, 2);
    struct bytes out = {.data = NULL};
    image_set(&image, 1, 1, color_rgb(0, 96, 0));
    image_set(&image, 2, 1, color_rgb(10, 10, 10));
    image_set(&image, 2, 0, color_rgb(0, 0, 255)); /* the lighter one counts */
    image_set(&image, 3, 0, color_rgb(29, 20, 20));
    setenv("TERM", "dumb", 1);
    CHECK_TEXT(shown(&out, &image, TERMINAL_BLOCKS), " -@.\n");
    bytes_free(&out);
    image_free(&image);
}

/* The pieces, put together again, are the PNG file. */
static void test_kitty(void) {
    struct image image = make(90, 60);
    struct bytes out = {.data = NULL}, png = {.data = NULL}, wanted = {.data = NULL},
                 got = {.data = NULL};
    struct error error;
    uint32_t noise = 1;
    for (size_t i = 0; i < 90 * 60 * 3; i++) {
        noise = noise * 1664525 + 1013904223;
        image.pixels[i] = (uint8_t)(noise >> 24);
    }
    const char *text = shown(&out, &image, TERMINAL_KITTY);
    CHECK(strncmp(text, "\033_Ga=T,f=100,q=2,c=2,m=1;", 25) == 0);
    size_t pieces = 0;
    for (const char *at = text; (at = strstr(at, "\033_G")) != NULL; pieces++) {
        const char *begin = strchr(at, ';') + 1, *end = strstr(at, "\033\\");
        bool last = strstr(end, "\033_G") == NULL;
        CHECK(end - begin <= 4096 && begin[-2] == (last ? '0' : '1'));
        CHECK(bytes_append(&got, begin, (size_t)(end - begin)));
        at = end;
    }
    CHECK(pieces == 6);
    CHECK(png_encode(&image, &png, &error) && base64_encode(&wanted, png.data, png.size));
    CHECK(got.size == wanted.size && memcmp(got.data, wanted.data, got.size) == 0);
    bytes_free(&out);
    bytes_free(&png);
    bytes_free(&wanted);
    bytes_free(&got);
    image_free(&image);
}

/* ---- What the terminal says ---- */

/* In its own session, on that terminal: the kind that is found, or 99 where the terminal is
 * not as it was before. */
static void be_asked(const char *path, const char *term) {
    struct termios before, after;
    setsid();
    int terminal = open(path, O_RDWR); /* becomes the session's */
    dup2(terminal, STDOUT_FILENO);
    setenv("TERM", term, 1);
    unsetenv("KITTY_WINDOW_ID");
    tcgetattr(terminal, &before);
    enum terminal_kind kind = terminal_find_kind();
    tcgetattr(terminal, &after);
    _exit(after.c_lflag == before.c_lflag ? (int)kind : 99);
}

/* Read the questions, and write the answers. */
static void answer(int terminal, const char *text) {
    static const char expected[] = "\033_Gi=31,s=1,v=1,a=q,t=d,f=24;AAAA\033\\\033[c";
    char question[sizeof expected] = "";
    for (size_t i = 0; i + 1 < sizeof question && read(terminal, question + i, 1) == 1;) {
        i++;
    }
    CHECK_TEXT(question, expected);
    CHECK(write(terminal, text, strlen(text)) == (ssize_t)strlen(text));
}

/* What is found on a terminal of that name, which gives the answer; NULL: it must not be asked. */
static int kind_found(const char *term, const char *text) {
    int status = 0, terminal = posix_openpt(O_RDWR | O_NOCTTY);
    if (terminal < 0 || grantpt(terminal) != 0 || unlockpt(terminal) != 0) {
        return -1;
    }
    char path[128];
    snprintf(path, sizeof path, "%s", ptsname(terminal));
    pid_t child = fork();
    if (child == 0) {
        be_asked(path, term);
    }
    if (text != NULL) {
        answer(terminal, text);
    }
    waitpid(child, &status, 0);
    close(terminal);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

static void test_kind(void) {
    static const struct {
        const char *term, *answer;
        enum terminal_kind kind;
    } cases[] = {
        {"xterm-256color", "\033[?64;1;2;6;22c", TERMINAL_BLOCKS},
        {"xterm-256color", "\033[?62;14;44c", TERMINAL_BLOCKS},
        {"xterm-256color", "\033_Gi=31;OK\033\\\033[?62;c", TERMINAL_KITTY},
        {"xterm-256color", "\033_Gi=31;OK\033\\\033[?62;4c", TERMINAL_KITTY},
        {"xterm-256color", "\033_Gi=31;EINVAL:cannot?4c\033\\\033[?62;22c", TERMINAL_BLOCKS},
        {"xterm-256color", "", TERMINAL_BLOCKS}, /* no answer: it does not wait for ever */
        {"xterm-256color",
         "qqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqq"
         "qqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqq"
         "qqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqq"
         "qqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqq",
         TERMINAL_BLOCKS},
        {"xterm-kitty", NULL, TERMINAL_KITTY},
        {"linux", NULL, TERMINAL_BLOCKS},
        {"dumb", NULL, TERMINAL_BLOCKS},
        {"tmux-256color", NULL, TERMINAL_BLOCKS},
        {"screen", NULL, TERMINAL_BLOCKS},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        int kind = kind_found(cases[i].term, cases[i].answer);
        CHECK_ROW(kind == (int)cases[i].kind, cases[i].answer ? cases[i].answer : cases[i].term);
    }
}

UNIT_MAIN(TEST(test_base64), TEST(test_blocks), TEST(test_fewer_colors), TEST(test_characters),
          TEST(test_kitty), TEST(test_kind))
