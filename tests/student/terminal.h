/* Pictures as bytes that a terminal shows. */
#ifndef TESTS_STUDENT_TERMINAL_H
#define TESTS_STUDENT_TERMINAL_H

#include "base/bytes.h"
#include "base/error.h"
#include "tgaimage.h"

#include <stdbool.h>
#include <stddef.h>

enum terminal_kind {
    TERMINAL_BLOCKS, /* two pixels a character, in as many colours as the environment names */
    TERMINAL_KITTY   /* the graphics protocol of kitty, which Ghostty and others know, too */
};

/* What the terminal of this process can show: kitty by TERM, KITTY_WINDOW_ID or the answer of the
 * terminal, which is asked; otherwise blocks, also when it does not answer within 0.3 seconds, or
 * standard output is no terminal. */
enum terminal_kind terminal_find_kind(void);

/* Append the image. `columns` is how many characters of a line it takes; only kitty asks for it.
 * False, with a message, when memory runs out. */
bool terminal_show(struct bytes *out, const struct image *image, enum terminal_kind kind,
                   size_t columns, struct error *error);

#endif
