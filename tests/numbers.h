/*
 * A student's functions called with numbers: what tests/lessons/stepNN_name/numbers.c is made of.
 *
 *     #define LESSON "../step01_line/main.c"
 *     #include "numbers.h"
 *
 *     static void numbers(void) {
 *         WHOLE("1.3", line_length(at(3, 4), at(-7, 9)), 11);
 *     }
 *
 * What numbers.c defines itself is called called_something: a student's function may have any name.
 * Each call belongs to a task. The program is called as `NUMBERS FILE FIRST [TASK ...]` and writes
 * a line a call to FILE, without the first FIRST calls, those that need a task that is named, and
 * those of a task that is named with a ! before it:
 *
 *     NUMBER \t TASK \t CALL \t RIGHT \t YOURS \t right|wrong
 *
 * The part before YOURS is there before the function is called: where that never returns, or ends
 * the program, the last line says which one it was. The line `end` is there when all were called.
 *
 * The functions run in the student's own program. What compares them is therefore written out here,
 * nothing is taken from a FILE that is not empty, and nothing runs after the last call. That stops
 * accidents, and a strcmp() or a constructor of her own; who goes further gets no points without a
 * right picture (tests/check/result.h), and is found by hidden scenes.
 */
#ifndef TESTS_NUMBERS_H
#define TESTS_NUMBERS_H

#include "geometry.h"
#include "lesson.h"
#include "tgaimage.h"

#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Names that a student may have used: from here on they are ours. */
#define at           called_at
#define xy           called_xy
#define xyz          called_xyz
#define xyzw         called_xyzw
#define rgb          called_rgb
#define show         called_show
#define is_near      called_is_near
#define show_color   called_show_color
#define same_text    called_same_text
#define says_nothing called_says_nothing

/* The text of a value. */
struct shown {
    char text[200];
};

static inline struct shown show(const char *format, ...) PRINTF_LIKE(1, 2);
static inline struct shown show(const char *format, ...) {
    struct shown shown;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(shown.text, sizeof shown.text, format, arguments);
    va_end(arguments);
    return shown;
}

static inline bool same_text(const char *a, const char *b) {
    while (*a == *b && *a != '\0') {
        a++;
        b++;
    }
    return *a == *b;
}

/* Are all numbers in it 0, as of functions that are still to be written? */
static inline bool says_nothing(const char *text) {
    return text[strcspn(text, "123456789")] == '\0';
}

/* Where lines go, the next call's number, and which calls are wanted. */
static struct {
    FILE *file;
    long next, first;
    char **without;
} number_state;

/* "(3, 4)" for "at(3, 4)": values as a text writes them; and without the "called_" of our names. */
static inline struct shown show_call(const char *call) {
    static const char *const makers[] = {"at(", "xy(", "xyz(", "xyzw(", "rgb("};
    struct shown shown = {""};
    for (size_t length = 0; *call != '\0' && length + 1 < sizeof shown.text; call++) {
        for (size_t i = 0; i < sizeof makers / sizeof makers[0]; i++) {
            size_t name = strlen(makers[i]) - 1;
            bool starts = length == 0 || strchr("( ", shown.text[length - 1]) != NULL;
            call += starts && strncmp(call, makers[i], name + 1) == 0 ? name : 0;
        }
        if (strncmp(call, "called_", 7) == 0) {
            call += 7;
        }
        shown.text[length++] = *call;
    }
    return shown;
}

/* The next call is this one. Is it wanted? Then its line is begun. Behind a `+` are tasks that it
 * needs, too ("10a.2+10b.1"): it is not called without them. */
static inline bool number_begin(const char *task, const char *call, struct shown right) {
    bool wanted = number_state.next >= number_state.first;
    for (char **name = number_state.without; *name != NULL; name++) {
        wanted = wanted && (**name == '!' ? strstr(task, *name + 1)
                                          : strstr(task + strcspn(task, "+"), *name)) == NULL;
    }
    if (wanted) {
        fprintf(number_state.file, "%ld\t%.*s\t%s\t%s\t", number_state.next,
                (int)strcspn(task, "+"), task, show_call(call).text, right.text);
        fflush(number_state.file);
    }
    number_state.next++;
    return wanted;
}

static inline void number_end(struct shown yours, bool is_right) {
    fprintf(number_state.file, "%s\t%s\n", yours.text, is_right ? "right" : "wrong");
    fflush(number_state.file);
}

/* ---- Arguments and values ---- */

static inline struct pixel at(int x, int y) {
    return (struct pixel){x, y};
}

static inline struct vec2 xy(double x, double y) {
    return (struct vec2){x, y};
}

static inline struct vec3 xyz(double x, double y, double z) {
    return (struct vec3){x, y, z};
}

static inline struct vec4 xyzw(double x, double y, double z, double w) {
    return (struct vec4){x, y, z, w};
}

static inline struct color rgb(int r, int g, int b) {
    return color_rgb((uint8_t)r, (uint8_t)g, (uint8_t)b);
}

/* Is it as near as four digits tell? NaN is like nothing, and infinity like itself. */
static inline bool is_near(double yours, double right) {
    return yours == right || fabs(yours - right) <= 1e-4 * fmax(1, fabs(right));
}

static inline bool are_near(const double *yours, const double *right, size_t count) {
    bool near = true;
    for (size_t i = 0; i < count; i++) {
        near = near && is_near(yours[i], right[i]);
    }
    return near;
}

/* "0.5 1 0", with that between two numbers. */
static inline struct shown show_joined(const double *values, size_t count, const char *between) {
    struct shown shown = {""};
    for (size_t i = 0; i < count; i++) {
        size_t length = strlen(shown.text);
        snprintf(shown.text + length, sizeof shown.text - length, "%s%.5g", i > 0 ? between : "",
                 values[i]);
    }
    return shown;
}

/* "(0.5, 1, 0)". */
static inline struct shown show_reals(const double *values, size_t count) {
    return show("(%.190s)", show_joined(values, count, ", ").text);
}

static inline void end_whole(long long yours, long long right) {
    number_end(show("%lld", yours), yours == right);
}

static inline void end_real(double yours, double right) {
    number_end(show("%.5g", yours), is_near(yours, right));
}

static inline void end_reals(const double *yours, const double *right, size_t count) {
    number_end(show_reals(yours, count), are_near(yours, right, count));
}

static inline void end_text(struct shown yours, struct shown right) {
    number_end(yours, same_text(yours.text, right.text));
}

static inline struct shown show_truth(bool is_true) {
    return show(is_true ? "true" : "false");
}

static inline struct shown show_color(struct color color) {
    return show("%d,%d,%d", color.r, color.g, color.b);
}

/* A black image to draw into; show_pixels() frees it. */
static inline struct image black_image(size_t width, size_t height) {
    struct image image;
    struct error error;
    if (!image_create(&image, width, height, IMAGE_BGR, &error)) {
        fprintf(stderr, "numbers: %s\n", error.message);
        exit(1);
    }
    return image;
}

/* "(0,0) (1,0)": the pixels that are not black, row by row from the bottom. */
static inline struct shown show_pixels(struct image *image) {
    struct shown shown = {""};
    for (int i = 0; i < (int)(image->width * image->height) && strlen(shown.text) < 150; i++) {
        int x = i % (int)image->width, y = i / (int)image->width;
        struct color color = image_get(image, x, y);
        if (color.r > 0 || color.g > 0 || color.b > 0) {
            const char *blank = shown.text[0] != '\0' ? " " : "";
            shown = show("%.150s%s(%d,%d)", shown.text, blank, x, y);
        }
    }
    image_free(image);
    return shown.text[0] != '\0' ? shown : show("none");
}

/* ---- Calls ---- */

/* TASK's call must give this whole number. */
#define WHOLE(task, call, right) AS_WHOLE(task, #call, call, right)
/* TASK's call, which the report shows as `text`, must give this whole number. */
#define AS_WHOLE(task, text, call, right)                                                          \
    do {                                                                                           \
        if (number_begin(task, text, show("%lld", (long long)(right)))) {                          \
            end_whole((long long)(call), (long long)(right));                                      \
        }                                                                                          \
    } while (0)

/* This number, to four digits. */
#define REAL(task, call, right)                                                                    \
    do {                                                                                           \
        if (number_begin(task, #call, show("%.5g", (double)(right)))) {                            \
            end_real((double)(call), (double)(right));                                             \
        }                                                                                          \
    } while (0)

/* This vector, to four digits: `type` is vec2, vec3 or vec4. */
#define VECTOR(task, type, call, right) AS_VECTOR(task, #call, type, call, right)
#define AS_VECTOR(task, text, type, call, right)                                                   \
    do {                                                                                           \
        const struct type right_one = right;                                                       \
        const size_t number_count = sizeof right_one / sizeof(double);                             \
        if (number_begin(task, text, show_reals((const double *)&right_one, number_count))) {      \
            const struct type yours = call;                                                        \
            end_reals((const double *)&yours, (const double *)&right_one, number_count);           \
        }                                                                                          \
    } while (0)

/* This text, which `call` makes of what a function gives: a struct shown. */
#define TEXT(task, text, call, right)                                                              \
    do {                                                                                           \
        if (number_begin(task, text, show("%s", right))) {                                         \
            end_text(call, show("%s", right));                                                     \
        }                                                                                          \
    } while (0)

/* This text, of a function that calls those of other tasks. `own` is what it must give with your
 * versions of them, and is right, too, unless it says nothing: a mistake costs its own task
 * only. */
#define TEXT_WITH(task, name, call, right, own)                                                    \
    do {                                                                                           \
        if (number_begin(task, name, show("%s", right))) {                                         \
            const struct shown yours = call;                                                       \
            const struct shown with_yours = own;                                                   \
            number_end(yours,                                                                      \
                       same_text(yours.text, right) ||                                             \
                           (same_text(yours.text, with_yours.text) && !says_nothing(yours.text))); \
        }                                                                                          \
    } while (0)

/* A colour. */
#define COLOR(task, call, right) TEXT(task, #call, show_color(call), show_color(right).text)

/* All calls of the lesson, defined in numbers.c. */
static void numbers(void);

int main(int argc, char **argv) {
    if (argc < 3) {
        fprintf(stderr, "usage: numbers FILE FIRST [TASK ...]\n");
        return 2;
    }
    FILE *earlier = fopen(argv[1], "rb");
    bool is_new = earlier == NULL || (fgetc(earlier) == EOF && fclose(earlier) == 0);
    number_state.file = is_new ? fopen(argv[1], "wb") : NULL;
    number_state.first = strtol(argv[2], NULL, 10);
    number_state.without = argv + 3;
    if (number_state.file == NULL) {
        fprintf(stderr, "numbers: %s cannot be written, or is not empty\n", argv[1]);
        return 1;
    }
    numbers();
    fputs("end\n", number_state.file);
    _Exit(fclose(number_state.file) == 0 ? 0 : 1);
}

#endif
