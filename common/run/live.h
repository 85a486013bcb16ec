/*
 * Lines of options, answered with frames: the loop of --live. Private to program.c.
 *
 * A request is one line: options as on the command line, 255 words at most, with blanks between
 * them. Where the last word is `text`, the lines of a text scene follow, up to a line `end`. The
 * answer to each is
 *
 *     frame WIDTH HEIGHT MILLISECONDS COUNT
 *     NAME VALUE                                 COUNT lines: counters, as --stats prints them,
 *      TEXT                                      and behind a blank, what --probe gets
 *     then WIDTH * HEIGHT pixels of four bytes: red, green, blue, 255, row by row from the top
 *
 * or a line `error MESSAGE`. Before all of them one line of JSON says which scenes there are, and
 * what can be changed in each (live_describe()).
 */
#ifndef COMMON_RUN_LIVE_H
#define COMMON_RUN_LIVE_H

#include "base/bytes.h"
#include "run/scene.h"

#include <stdio.h>

enum { LIVE_WORD_LIMIT = 256 }; /* of a request, far more than there are options */

/* A request. It is gone when it has been answered. */
struct live_request {
    int argc;
    char *argv[LIVE_WORD_LIMIT]; /* the first is the program's name */
    struct bytes line, text;     /* what the others lie in; the lines of a text scene */
    bool has_text;
};

/* What answers it: writes a frame by live_write_frame(), or returns false with a message. */
typedef bool live_answer(void *context, struct live_request *request, FILE *out,
                         struct error *error);

/* Write the line of JSON: the program's scenes, with its defaults filled in. */
void live_describe(const struct program *program, FILE *out);

void live_write_frame(const struct image *image, double milliseconds, const struct drawing *drawing,
                      FILE *out);

/* Answer until the input ends. False, with a message, when memory runs out, or nobody reads. */
bool live_loop(const struct program *program, FILE *in, FILE *out, live_answer *answer,
               void *context, struct error *error);

#endif
