/* Where files are that other files name: see find.h. */
#include "files/find.h"

#include "base/file.h"
#include "files/image_file.h"

#include <ctype.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

char *find_first(const char *directory, char *const *names, size_t count, bool *found) {
    size_t first = 0;
    char *path = NULL;
    for (*found = false; first < count && !*found; first += !*found) {
        free(path);
        path = string_format("%s%s", directory, names[first]);
        if (path == NULL) {
            return NULL;
        }
        *found = file_exists(path);
    }
    size_t other = first == 0 ? 0 : directory_find(directory, names, first);
    if (!*found || other < first) {
        free(path);
        *found = other < first;
        path = string_format("%s%s", directory, names[*found ? other : 0]);
    }
    return path;
}

/* Bring the directories of a path, from the character at `from` on, to the letters that they have.
 * Returns the place of the last part, NULL where it is empty or a directory is not there. */
static char *find_directories(char *path, char *from) {
    for (char *slash; (slash = strchr(from, '/')) != NULL; from = slash + 1) {
        *slash = '\0';
        bool there = slash == from || file_exists(path);
        if (!there && from > path) {
            char *const name[] = {from};
            from[-1] = '\0';
            there = directory_find(from - 1 == path ? "/" : path, name, 1) == 0;
            from[-1] = '/';
        } else if (!there) {
            char *const name[] = {from};
            there = directory_find("", name, 1) == 0;
        }
        *slash = '/';
        if (!there) {
            return NULL;
        }
    }
    return *from == '\0' ? NULL : from;
}

enum { PICTURE_NAMES = 3 };

/* The names that a picture may have: as it is written last if its kind is not read. */
static bool name_pictures(const char *name, char *names[PICTURE_NAMES]) {
    const char *dot = strrchr(name, '.');
    const int stem = dot == NULL ? (int)strlen(name) : (int)(dot - name);
    const bool readable = dot == NULL || image_file_is_readable(dot + 1);
    names[readable ? 0 : 2] = string_format("%s", name);
    names[readable ? 1 : 0] = string_format("%.*s.png", stem, name);
    names[readable ? 2 : 1] = string_format("%.*s.tga", stem, name);
    return names[0] != NULL && names[1] != NULL && names[2] != NULL;
}

/* What there is under the path, of which `directory` bytes name a directory that is there; as it
 * is, where there is nothing. Frees the path. NULL when memory runs out. */
static char *find_path(char *path, size_t directory, bool is_picture, bool *found) {
    char *names[PICTURE_NAMES] = {NULL}, *copy = string_format("%s", path), *there = NULL;
    char *last = copy == NULL ? NULL : find_directories(copy, copy + directory);
    char *before = last == NULL ? NULL : string_format("%.*s", (int)(last - copy), copy);
    bool done = copy != NULL && (last == NULL || before != NULL);
    *found = false;
    if (before != NULL) {
        char *const as_written[] = {last};
        done = !is_picture || name_pictures(last, names);
        there = !done ? NULL
                      : find_first(before, is_picture ? names : as_written,
                                   is_picture ? PICTURE_NAMES : 1, found);
        done = there != NULL;
    }
    for (size_t i = 0; i < PICTURE_NAMES; i++) {
        free(names[i]);
    }
    free(before);
    free(copy);
    free(*found || !done ? path : there);
    return *found || !done ? there : path;
}

struct word name_without_rest(struct word name) {
    for (size_t i = 1; i + 1 < name.length; i++) {
        const char *p = name.start + i;
        if (p[-1] == ' ' && (*p == '#' || (*p == '-' && isalpha((unsigned char)p[1])))) {
            for (name.length = i; name.length > 0 && name.start[name.length - 1] == ' ';) {
                name.length--;
            }
        }
    }
    return name;
}

/* The path as it is written, without quotes and with / between directories. */
static char *join(const char *directory, struct word name) {
    bool quoted = name.length > 1 && name.start[0] == '"' && name.start[name.length - 1] == '"';
    char *path = name.length == 0 || name.length > INT_MAX
                     ? NULL
                     : string_format("%s%.*s", directory, (int)name.length - (quoted ? 2 : 0),
                                     name.start + quoted);
    for (char *p = path; p != NULL && *p != '\0'; p++) {
        *p = (char)(*p == '\\' ? '/' : *p);
    }
    return path;
}

char *find_named(struct word name, const char *directory, bool is_picture, bool *found) {
    const struct word forms[] = {name, name_without_rest(name)};
    const size_t above = strlen(directory);
    char *path = NULL;
    *found = false;
    for (size_t i = 0; !*found && i < (forms[1].length < name.length ? 2 : 1); i++) {
        free(path);
        path = join(directory, forms[i]);
        path = path == NULL ? NULL : find_path(path, above, is_picture, found);
        const char *slash = path == NULL || *found ? NULL : strrchr(path + above, '/');
        if (slash != NULL) {
            char *next_to = string_format("%s%s", directory, slash + 1);
            next_to = next_to == NULL ? NULL : find_path(next_to, above, is_picture, found);
            char *other = next_to == NULL || *found ? path : next_to;
            path = next_to == NULL || *found ? next_to : path;
            free(other);
        }
        if (path == NULL) {
            return NULL;
        }
    }
    return path;
}
