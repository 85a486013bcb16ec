/* Text that others wrote (names, messages of compilers and programs) in reports and pages. */
#ifndef TESTS_CHECK_PAGE_ESCAPE_H
#define TESTS_CHECK_PAGE_ESCAPE_H

#include "base/bytes.h"

#include <stdarg.h>
#include <stdbool.h>

/* What is written for a character that means something in a format; NULL for any other. */
typedef const char *escape_function(char character);

/* As text or attribute of HTML or XML; within a string of JSON. */
escape_function escape_markup, escape_json;

/* Append the text as the format has it; false when memory runs out. What a terminal would obey
 * becomes '?', a tab a blank; lines stay lines. */
bool escape_text(struct bytes *out, escape_function *escape, const char *text);

/* Append the format, of which each %s is text that is escaped, each %u a number; there is nothing
 * else behind a %. False when memory runs out. */
bool escape_print(struct bytes *out, escape_function *escape, const char *format,
                  va_list arguments);

/* escape_print() with escape_markup(). */
bool markup_print(struct bytes *out, const char *format, ...) PRINTF_LIKE(2, 3);

#endif
