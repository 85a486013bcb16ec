/*
 * Whole files in, whole files out, and directories.
 *
 * A file is read into memory as one block of bytes, so that decoders work on memory alone and can
 * check every claim of a file against its true length. A file is written to a temporary name in the
 * same directory and renamed when it is complete: nothing half-written is ever left behind.
 */
#ifndef COMMON_BASE_FILE_H
#define COMMON_BASE_FILE_H

#include "base/bytes.h"
#include "base/error.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* error_name_file() for a file that was read: "-" is called standard input. Always returns
 * false. */
bool error_name_input(struct error *error, const char *path);

/* Read the whole file, or standard input for "-". The caller frees `bytes`. A directory, a missing
 * file, a read error and a file of more than 1 GiB are errors; the message names the file, and
 * nothing stays allocated. */
bool file_read(const char *path, struct bytes *bytes, struct error *error);

/* Write the whole file: complete or, on an error, not at all (an older file of that name stays).
 * What replaces a file keeps its permissions, where the system has any (WASI has none). A symbolic
 * link stays, and leads to what may then be half-written on an error, as a device. */
bool file_write(const char *path, const void *data, size_t size, struct error *error);

/* The end of every writer: file_write() what was encoded, or, when encoding failed (`encoded` is
 * false), put the file's name before the message. Frees `bytes` in any case. */
bool file_write_encoded(const char *path, bool encoded, struct bytes *bytes, struct error *error);

bool file_exists(const char *path);

/* Is there such a file, or just one in other letters, small or capital? The path gets its letters.
 * A directory that is written so comes first; where the file isn't in it, those in other letters
 * are looked through. (None is listed on systems to which letters are the same, or which have
 * none.) */
bool file_find(char *path);

/* Bytes in the file; 0 where there is none. */
uint64_t file_size(const char *path);

/* Make the directory and those above it that do not exist yet. */
bool directory_create(const char *path, struct error *error);

#endif
