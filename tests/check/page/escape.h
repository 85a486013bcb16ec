/* Text that others wrote (names, messages of compilers and programs) in reports and pages. */
#ifndef TESTS_HELP_ESCAPE_H
#define TESTS_HELP_ESCAPE_H

#include "base/bytes.h"

#include <stdarg.h>
#include <stdbool.h>

/* Appends the text as a format has it; false when memory runs out. What a terminal would obey
 * becomes '?', a tab a blank; lines stay lines. */
typedef bool escape_function(struct bytes *out, const char *text);

/* As text or attribute of HTML or XML; within a string of JSON. */
escape_function escape_markup, escape_json;

/* Append the format, of which each %s is text that is escaped, each %u a number; there is nothing
 * else behind a %. False when memory runs out. */
bool escape_print(struct bytes *out, escape_function *escape, const char *format,
                  va_list arguments);

/* The same with escape_markup(). */
bool markup_print(struct bytes *out, const char *format, ...) PRINTF_LIKE(2, 3);

#endif
