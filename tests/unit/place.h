/* For tests of files: a separate directory for a test, in which nothing may be left behind. The
 * test defines _XOPEN_SOURCE as 700, for mkdtemp(). */
#ifndef TESTS_UNIT_PLACE_H
#define TESTS_UNIT_PLACE_H

#include "base/file.h"
#include "unit/unit.h"

#include <dirent.h>
#include <stdlib.h>
#include <unistd.h>

struct place {
    char directory[40];
    char path[128]; /* of a file in it, set by name_file() */
};

static inline struct place place_create(void) {
    struct place place = {.directory = "/tmp/test_unit.XXXXXX"};
    if (mkdtemp(place.directory) == NULL) {
        perror("mkdtemp");
        exit(1);
    }
    return place;
}

static inline const char *name_file(struct place *place, const char *name) {
    snprintf(place->path, sizeof place->path, "%s/%s", place->directory, name);
    return place->path;
}

/* How many names there are in the directory. */
static inline size_t place_count(const struct place *place) {
    size_t count = 0;
    DIR *list = opendir(place->directory);
    while (list != NULL && readdir(list) != NULL) {
        count++;
    }
    if (list != NULL) {
        closedir(list);
    }
    return count - 2; /* "." and ".." */
}

/* The directory, and the files that it still holds: names with commas between them, or NULL. */
static inline void place_remove(struct place *place, const char *names) {
    while (names != NULL) {
        char name[64];
        size_t length = strcspn(names, ",");
        snprintf(name, sizeof name, "%.*s", (int)length, names);
        CHECK(unlink(name_file(place, name)) == 0);
        names = names[length] == ',' ? names + length + 1 : NULL;
    }
    CHECK(rmdir(place->directory) == 0);
}

static inline bool put_text(const char *path, const char *text) {
    struct error error;
    return file_write(path, text, strlen(text), &error);
}

static inline bool file_is(const char *path, const char *text) {
    struct bytes bytes;
    struct error error;
    bool same = file_read(path, &bytes, &error) && bytes.size == strlen(text) &&
                (bytes.size == 0 || memcmp(bytes.data, text, bytes.size) == 0);
    bytes_free(&bytes);
    return same;
}

#endif
