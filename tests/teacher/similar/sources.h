/*
 * The C files of one lesson in a directory that anybody may have written: main.c, then all other
 * plain files whose names end with .c or .h, in the order of their names. Links are not followed,
 * so that no file of somebody else's is shown.
 *
 * Lines are counted through all files of the lesson: those of main.c keep their numbers.
 */
#ifndef TESTS_SIMILAR_SOURCES_H
#define TESTS_SIMILAR_SOURCES_H

#include "base/bytes.h"
#include "base/error.h"

#include <stdbool.h>
#include <stddef.h>

enum {
    LESSON_SIZE_LIMIT = 256 * 1024,     /* bytes that are read of a lesson: 16 long solutions */
    GIVEN_SIZE_LIMIT = 4 * 1024 * 1024, /* of a directory that the course gives */
    SOURCES_FILE_LIMIT = 256
};

struct source {
    char *name;
    struct bytes text;
    size_t first_line, line_count;
};

/* All zero is valid and empty. */
struct sources {
    struct source *files;
    size_t count, capacity;
    size_t size, line_count; /* of all files */
};

/* A directory that is not there has no files. An error where it, or its main.c, is no plain one, or
 * a limit is exceeded: `sources` is then empty, and the message begins with the path. */
bool sources_read(struct sources *sources, const char *directory, size_t size_limit,
                  struct error *error);

void sources_free(struct sources *sources);

/* The names of those directories in this one which are lessons (step and a digit), sorted. They and
 * the array belong to the caller (names_free()). */
struct names {
    char **all;
    size_t count, capacity;
};
bool sources_list_lessons(struct names *names, const char *directory, struct error *error);

void names_free(struct names *names);

#endif
