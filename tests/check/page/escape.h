/* Text that others wrote (names, messages of compilers and programs) in reports and pages. */
#ifndef TESTS_HELP_ESCAPE_H
#define TESTS_HELP_ESCAPE_H

#include "base/bytes.h"

#include <stdbool.h>

/* A copy in which what a terminal would obey is '?', but lines stay lines, and a tab is a blank.
 * The caller frees it; NULL when memory runs out. */
char *printable_lines(const char *text);

/* Append the printable lines as text or attribute of HTML or XML; false when memory runs out. */
bool escape_markup(struct bytes *out, const char *text);

/* Append markup of which each %s is text that is escaped, each %u a number; there is nothing else
 * behind a %. False when memory runs out. */
bool markup_print(struct bytes *out, const char *format, ...) PRINTF_LIKE(2, 3);

#endif
