/*
 * What a sanitizer says of a fault, in one plain sentence.
 *
 * A program built with -fsanitize=address,undefined ends at its first fault with a page of text.
 * What a student needs of it is the line of main.c, and what it does there.
 */
#ifndef TESTS_CHECK_FAULT_H
#define TESTS_CHECK_FAULT_H

#include "result.h"

#include <stdbool.h>

/* Add to `text` what these messages (with a NUL at their end, or NULL) say of a fault in the
 * step's program, like `step02_wireframe/main.c:120: line() reads beyond the end of an array`.
 * False, with nothing added, when they name none. */
bool fault_describe(struct result_text *text, const char *step, const char *messages);

#endif
