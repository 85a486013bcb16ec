/* Files that other files name: see find.h. */
#include "files/find.h"

#include "base/file.h"
#include "files/image_file.h"

#include <ctype.h>
#include <limits.h>
#include <stdlib.h>

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

static struct word last_part(struct word path) {
    size_t i = path.length;
    while (i > 0 && path.start[i - 1] != '/' && path.start[i - 1] != '\\') {
        i--;
    }
    return (struct word){path.start + i, path.length - i};
}

struct word name_ending(struct word path) {
    struct word name = last_part(path);
    size_t i = name.length;
    while (i > 0 && name.start[i - 1] != '.') {
        i--;
    }
    i = i <= 1 ? name.length : i;
    return (struct word){name.start + i, name.length - i};
}

bool name_ends(const char *path, const char *ending) {
    return word_matches(name_ending(word_of(path)), ending);
}

static struct word without_quotes(struct word name) {
    bool quoted = name.length > 1 && name.start[0] == '"' && name.start[name.length - 1] == '"';
    return (struct word){name.start + quoted, name.length - (quoted ? 2 : 0)};
}

/* A name as it is written, or with another ending. */
enum form { AS_PNG, AS_TGA, AS_WRITTEN, FORMS };

/* The path of a name, with / between directories. */
static char *make_path(const char *naming, struct word name, enum form form) {
    static const char *const endings[] = {[AS_PNG] = ".png", [AS_TGA] = ".tga", [AS_WRITTEN] = ""};
    const char *slash = strrchr(naming, '/');
    const int directory = slash == NULL ? 0 : (int)(slash + 1 - naming);
    if (name.length > INT_MAX) {
        return NULL;
    }
    if (form != AS_WRITTEN) {
        const struct word ending = name_ending(name);
        name.length -= ending.length + (ending.length > 0);
    }
    char *path =
        string_format("%.*s%.*s%s", directory, naming, (int)name.length, name.start, endings[form]);
    for (char *p = path == NULL ? NULL : path + directory; p != NULL && *p != '\0'; p++) {
        *p = (char)(*p == '\\' ? '/' : *p);
    }
    return path;
}

char *find_named(struct word name, const char *naming, bool is_picture, bool *found) {
    const struct word whole = without_quotes(name), rid = without_quotes(name_without_rest(name));
    const struct word names[] = {whole, last_part(whole), rid, last_part(rid)};
    char *path = NULL;
    *found = false;
    for (size_t i = 0; i < 4 * FORMS && !*found; i++) {
        const struct word one = names[i / FORMS], ending = name_ending(one);
        const bool is_read = ending.length == 0 || image_file_is_readable(ending);
        const size_t first = is_read ? AS_WRITTEN : AS_PNG;
        bool again = i >= FORMS && one.length == whole.length;
        if (again || one.length == 0 || (!is_picture && i % FORMS > 0)) {
            continue;
        }
        free(path);
        path = make_path(naming, one, is_picture ? (enum form)((first + i) % FORMS) : AS_WRITTEN);
        if (path == NULL) {
            return NULL;
        }
        *found = file_find(path);
    }
    if (!*found && name.length > 0) {
        free(path);
        path = make_path(naming, rid, AS_WRITTEN);
    }
    return path;
}
