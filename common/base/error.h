/* The error message that every function fills in which can fail for a reason that a user must
 * know. */
#ifndef COMMON_BASE_ERROR_H
#define COMMON_BASE_ERROR_H

#include <stdbool.h>
#include <stddef.h>

/* What went wrong, for the user: one line without a final newline or the program's name. */
struct error {
    char message[1024];
    size_t line; /* of the text that was read, from 1; 0 where no line is meant or it is named */
};

#if defined(__MINGW32__) && !defined(__clang__) /* for which printf is that of Windows */
#define PRINTF_LIKE(string, first) __attribute__((format(gnu_printf, string, first)))
#elif defined(__GNUC__)
#define PRINTF_LIKE(string, first) __attribute__((format(printf, string, first)))
#else
#define PRINTF_LIKE(string, first)
#endif

/* In a text that was written by others, replace each byte of what a terminal would obey and not
 * show (control characters, also those of two bytes, and marks that turn the direction of writing),
 * of what no XML may hold (U+FFFE and U+FFFF), and each byte that is not part of a UTF-8
 * character. */
void text_make_printable(char *text, char instead);

/* Write a message as printf does (cut if too long), made printable with '?'. Always returns false,
 * so that a failing function can end with `return error_set(error, ...)`. */
bool error_set(struct error *error, const char *format, ...) PRINTF_LIKE(2, 3);

/* Write a message about line `line` of a text that was read. Always returns false. */
bool text_error(struct error *error, size_t line, const char *format, ...) PRINTF_LIKE(3, 4);

/* The message of every allocation that failed. Always returns false. */
bool error_out_of_memory(struct error *error);

/* Is it that message, perhaps behind the name of a file? */
bool error_is_out_of_memory(const struct error *error);

/* Put "PATH: " before the message, "PATH:LINE: " where there is a line. Always returns false. */
bool error_name_file(struct error *error, const char *path);

#endif
