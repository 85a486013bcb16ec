/*
 * Pictures as bytes that a terminal shows: see terminal.h.
 *
 * Sources: K. Goyal, "Terminal graphics protocol", sw.kovidgoyal.net/kitty (kitty); ECMA-48 and ISO
 * 8613-6 (colours).
 */
#define _POSIX_C_SOURCE 200809L
#include "terminal.h"

#include "check/page/base64.h"
#include "files/png.h"

#include <fcntl.h>
#include <limits.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <termios.h>
#include <unistd.h>

/* ---- Blocks ---- */

static const char *variable(const char *name) {
    const char *value = getenv(name);
    return value != NULL ? value : "";
}

/* How many colours, in bits: 24, 8, 4, or 0 for none. Terminals tell by COLORTERM, Windows' own by
 * WT_SESSION; NO_COLOR (no-color.org) asks for none. */
static int color_bits(void) {
    static const char *const of_16[] = {"", "ansi", "linux", "screen", "xterm", "xterm-16color"};
    const char *name = variable("TERM"), *colors = variable("COLORTERM");
    if (variable("NO_COLOR")[0] != '\0' || strcmp(name, "dumb") == 0 ||
        strncmp(name, "vt", 2) == 0) {
        return 0;
    }
    if (strcmp(colors, "truecolor") == 0 || strcmp(colors, "24bit") == 0 ||
        strstr(name, "direct") != NULL || variable("WT_SESSION")[0] != '\0') {
        return 24;
    }
    for (size_t i = 0; i < sizeof of_16 / sizeof of_16[0]; i++) {
        if (strcmp(name, of_16[i]) == 0) {
            return 4;
        }
    }
    return 8;
}

/* The colours that xterm and most others have: 16, a cube of 6x6x6, and greys. */
static struct color palette_color(unsigned index) {
    static const uint8_t first[16][3] = {
        {0, 0, 0},     {205, 0, 0},     {0, 205, 0},     {205, 205, 0},  {0, 0, 238}, {205, 0, 205},
        {0, 205, 205}, {229, 229, 229}, {127, 127, 127}, {255, 0, 0},    {0, 255, 0}, {255, 255, 0},
        {92, 92, 255}, {255, 0, 255},   {0, 255, 255},   {255, 255, 255}};
    static const uint8_t side[6] = {0, 95, 135, 175, 215, 255};
    if (index < 16) {
        return color_rgb(first[index][0], first[index][1], first[index][2]);
    }
    if (index < 232) {
        index -= 16;
        return color_rgb(side[index / 36], side[index / 6 % 6], side[index % 6]);
    }
    uint8_t grey = (uint8_t)(8 + 10 * (index - 232));
    return color_rgb(grey, grey, grey);
}

/* The nearest of the palette's colours from `first` up to, without, `end`. */
static unsigned nearest(struct color color, unsigned first, unsigned end) {
    unsigned best = first;
    int least = INT_MAX;
    for (unsigned i = first; i < end; i++) {
        struct color other = palette_color(i);
        int r = color.r - other.r, g = color.g - other.g, b = color.b - other.b;
        int distance = r * r + g * g + b * b;
        best = distance < least ? i : best;
        least = distance < least ? distance : least;
    }
    return best;
}

/* What sets the colour of a character (`base` 30) or of what is behind it (40). The first 16 of 256
 * colours are the user's own, so that only the others are known. */
static bool put_color_code(struct bytes *out, struct color color, unsigned base, int bits) {
    if (bits == 24) {
        return bytes_print(out, "\033[%u;2;%d;%d;%dm", base + 8, color.r, color.g, color.b);
    }
    if (bits == 8) {
        return bytes_print(out, "\033[%u;5;%um", base + 8, nearest(color, 16, 256));
    }
    unsigned index = nearest(color, 0, 16);
    return bytes_print(out, "\033[%um", index < 8 ? base + index : base + 60 + index - 8);
}

static bool same_color(struct color a, struct color b) {
    return a.r == b.r && a.g == b.g && a.b == b.b;
}

/* The upper half of a character in one colour, the lower one in another. A colour that is set
 * already is not set again. */
static bool put_row_of_blocks(struct bytes *out, const struct image *image, int upper_y, int bits) {
    struct color upper_before = {.r = 0}, lower_before = {.r = 0};
    for (int x = 0; x < (int)image->width; x++) {
        struct color upper = image_get(image, x, upper_y);
        struct color lower = image_get(image, x, upper_y - 1);
        if ((x == 0 || !same_color(upper, upper_before)) && !put_color_code(out, upper, 30, bits)) {
            return false;
        }
        if ((x == 0 || !same_color(lower, lower_before)) && !put_color_code(out, lower, 40, bits)) {
            return false;
        }
        if (!bytes_print(out, "\xe2\x96\x80")) { /* U+2580, upper half block */
            return false;
        }
        upper_before = upper;
        lower_before = lower;
    }
    return bytes_print(out, "\033[0m\n");
}

static int brightness(struct color c) {
    int most = c.r > c.g ? c.r : c.g;
    return most > c.b ? most : c.b;
}

/* Without colours, a character as light as the lighter of its two pixels. */
static bool put_row_of_characters(struct bytes *out, const struct image *image, int upper_y) {
    static const char light[] = " .:-=+*#%@";
    bool done = true;
    for (int x = 0; x < (int)image->width && done; x++) {
        int upper = brightness(image_get(image, x, upper_y));
        int lower = brightness(image_get(image, x, upper_y - 1));
        done = bytes_print(out, "%c", light[(upper > lower ? upper : lower) * 9 / 255]);
    }
    return done && bytes_print(out, "\n");
}

static bool show_blocks(struct bytes *out, const struct image *image) {
    int bits = color_bits();
    bool done = true;
    for (int y = (int)image->height - 1; y >= 0 && done; y -= 2) {
        done = bits == 0 ? put_row_of_characters(out, image, y)
                         : put_row_of_blocks(out, image, y, bits);
    }
    return done;
}

/* ---- Kitty ---- */

/* A PNG file in pieces of at most 4096 characters: a=T shows it, f=100 says PNG, c is its width in
 * characters, m=1 promises more, q=2 wants no answer. */
static bool show_kitty(struct bytes *out, const struct bytes *png, size_t columns) {
    enum { PIECE = 3072 };
    for (size_t at = 0; at < png->size; at += PIECE) {
        size_t size = png->size - at < PIECE ? png->size - at : PIECE;
        int more = at + size < png->size;
        bool begun = at == 0 ? bytes_print(out, "\033_Ga=T,f=100,q=2,c=%zu,m=%d;", columns, more)
                             : bytes_print(out, "\033_Gm=%d;", more);
        if (!begun || !base64_encode(out, png->data + at, size) || !bytes_print(out, "\033\\")) {
            return false;
        }
    }
    return bytes_print(out, "\n");
}

bool terminal_show(struct bytes *out, const struct image *image, enum terminal_kind kind,
                   size_t columns, struct error *error) {
    struct bytes png = {.data = NULL};
    bool done = false;
    switch (kind) {
    case TERMINAL_BLOCKS:
        done = show_blocks(out, image);
        break;
    case TERMINAL_KITTY:
        done = png_encode(image, &png, error) && show_kitty(out, &png, columns);
        bytes_free(&png);
        break;
    }
    return done || error_out_of_memory(error);
}

/* ---- What the terminal can ---- */

/* "Can you show a picture of 1x1 pixels?", which only a terminal answers that knows the protocol,
 * and "what are you?", which all answer. */
static const char question[] = "\033_Gi=31,s=1,v=1,a=q,t=d,f=24;AAAA\033\\"
                               "\033[c";
static const char can_kitty[] = "\033_Gi=31;OK\033\\";
static const char attributes[] = "\033[?"; /* 62 ; 4 ; ... c, which ends the answers */

/* The answers, up to the last letter of the last one. */
static void read_answer(int terminal, char *answer, size_t size) {
    enum { WAIT_MS = 300 };
    size_t length = 0;
    struct pollfd waiting = {.fd = terminal, .events = POLLIN};
    while (length + 1 < size && poll(&waiting, 1, WAIT_MS) == 1 &&
           read(terminal, answer + length, 1) == 1) {
        answer[++length] = '\0';
        if (answer[length - 1] == 'c' && strstr(answer, attributes) != NULL) {
            break;
        }
    }
}

/* Ask with signals held back, so that the terminal is always left as it was. */
static void ask(int terminal, char *answer, size_t size) {
    struct termios before, silent;
    sigset_t all, signals;
    ssize_t length = (ssize_t)strlen(question);
    if (tcgetpgrp(terminal) != getpgrp() || tcgetattr(terminal, &before) != 0) {
        return; /* a program in the background must not touch the terminal */
    }
    sigfillset(&all);
    sigprocmask(SIG_BLOCK, &all, &signals);
    silent = before;
    silent.c_lflag &= ~(tcflag_t)(ICANON | ECHO);
    if (tcsetattr(terminal, TCSANOW, &silent) == 0) {
        if (write(terminal, question, (size_t)length) == length) {
            read_answer(terminal, answer, size);
        }
        tcsetattr(terminal, TCSANOW, &before);
    }
    sigprocmask(SIG_SETMASK, &signals, NULL);
}

static bool begins_with(const char *text, const char *beginning) {
    return strncmp(text, beginning, strlen(beginning)) == 0;
}

/* screen and tmux are between the program and the terminal, and let no picture through; a console
 * may show the question. */
static bool is_known_to_have_none(const char *name) {
    return begins_with(name, "screen") || begins_with(name, "tmux") || strcmp(name, "linux") == 0 ||
           strcmp(name, "dumb") == 0;
}

enum terminal_kind terminal_find_kind(void) {
    const char *name = variable("TERM");
    if (!isatty(STDOUT_FILENO) || is_known_to_have_none(name)) {
        return TERMINAL_BLOCKS;
    }
    if (strstr(name, "kitty") != NULL || getenv("KITTY_WINDOW_ID") != NULL) {
        return TERMINAL_KITTY;
    }
    int terminal = open("/dev/tty", O_RDWR | O_NOCTTY | O_CLOEXEC);
    char answer[256] = "";
    if (terminal >= 0) {
        ask(terminal, answer, sizeof answer);
        close(terminal);
    }
    return strstr(answer, can_kitty) != NULL ? TERMINAL_KITTY : TERMINAL_BLOCKS;
}
