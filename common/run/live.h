/*
 * Lines of options, answered with frames: the loop of --live. Private to program.c.
 *
 * A request is one line: options as on the command line, with blanks between its words. Where the
 * last word is `text`, the lines of a text scene follow, up to a line `end`. The answer to each is
 *
 *     frame WIDTH HEIGHT MILLISECONDS COUNT
 *     NAME VALUE                                 COUNT lines: counters, as --stats prints them,
 *      TEXT                                      and behind a blank, what --probe gets
 *     then WIDTH * HEIGHT pixels of four bytes: red, green, blue, 255, row by row from the top
 *
 * or a line `error MESSAGE`. Before the first request one line of JSON says which scenes there are,
 * and what can be changed in each (live_describe()).
 */
#ifndef COMMON_LIVE_H
#define COMMON_LIVE_H

#include "run/scene.h"

#include <stdio.h>

/* A request. It is gone when it has been answered. */
struct live_request {
    int argc;
    char **argv;      /* argv[0] is the program's name */
    const char *text; /* the lines of a text scene; NULL: there are none */
    size_t text_size;
};

/* What answers it: writes a frame by live_write_frame(), or returns false with a message. */
typedef bool live_answer(void *context, const struct live_request *request, FILE *out,
                         struct error *error);

/* Write the line of JSON: the program's scenes, with its defaults filled in. */
void live_describe(const struct program *program, FILE *out);

void live_write_frame(const struct image *image, double milliseconds, const struct drawing *drawing,
                      FILE *out);

/* Answer until the input ends. False, with a message, when memory runs out, or nobody reads. */
bool live_loop(const struct program *program, FILE *in, FILE *out, live_answer *answer,
               void *context, struct error *error);

#endif
