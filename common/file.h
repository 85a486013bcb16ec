/*
 * Whole files in, whole files out, directories, and the error message that every reader and writer
 * fills in.
 *
 * A file is read into memory as one block of bytes, so that decoders work on memory alone and can
 * check every claim of a file against its true length. A file is written to a temporary name in the
 * same directory and renamed when it is complete: nothing half-written is ever left behind.
 */
#ifndef COMMON_FILE_H
#define COMMON_FILE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* What went wrong, for the user: one line without a final newline or the program's name. */
struct error {
    char message[1024];
    size_t line; /* of the text that was read, from 1; 0 where no line is meant or it is named */
};

#if defined(__GNUC__)
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

/* The message of every allocation that failed. Always returns false. */
bool error_out_of_memory(struct error *error);

/* Put "PATH: " before the message, "PATH:LINE: " where there is a line. Always returns false. */
bool error_name_file(struct error *error, const char *path);

/* The same for a file that was read: "-" is called standard input. Always returns false. */
bool error_name_input(struct error *error, const char *path);

/* A growing block of bytes. All zero is a valid, empty block; `data` belongs to the block. */
struct bytes {
    unsigned char *data;
    size_t size;     /* bytes in use */
    size_t capacity; /* bytes allocated */
};

/* Add `size` bytes at the end; false when memory runs out (the block is then unchanged). */
bool bytes_append(struct bytes *bytes, const void *data, size_t size);

/* Append what printf would print; false when memory runs out (the block is then unchanged). */
bool bytes_print(struct bytes *bytes, const char *format, ...) PRINTF_LIKE(2, 3);

/* Make room for `size` more bytes without changing the contents; false when memory runs out. */
bool bytes_reserve(struct bytes *bytes, size_t size);

/* Free the block and leave it empty. */
void bytes_free(struct bytes *bytes);

/* Read the whole file, or standard input for "-". The caller frees `bytes`. A directory, a missing
 * file, a read error and a file of more than 1 GiB are errors; the message names the file, and
 * nothing stays allocated. A file that tells its size is read into a block of that size (or of 16
 * bytes). */
bool file_read(const char *path, struct bytes *bytes, struct error *error);

/* Write the whole file: complete or, on an error, not at all (an older file of that name stays).
 * What replaces a file keeps its permissions, where the system has any (WASI has none), and a
 * symbolic link to it stays. */
bool file_write(const char *path, const void *data, size_t size, struct error *error);

/* The end of every writer: file_write() what was encoded, or, when encoding failed (`encoded` is
 * false), put the file's name before the message. Frees `bytes` in any case. */
bool file_write_encoded(const char *path, bool encoded, struct bytes *bytes, struct error *error);

bool file_exists(const char *path);

/* Do both names lead to the same file? */
bool file_is_same(const char *a, const char *b);

/* Bytes in the file; 0 where there is none. */
uint64_t file_size(const char *path);

/* Make the directory and those above it that do not exist yet. */
bool directory_create(const char *path, struct error *error);

/* What printf would print, in memory that the caller frees; NULL when memory runs out. */
char *string_format(const char *format, ...) PRINTF_LIKE(1, 2);

#endif
