/* Files that other files name: see find.h. */
#include "files/find.h"

#include "base/file.h"
#include "files/image_file.h"

#include <ctype.h>
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

/* A backslash before a blank parts no directories: it is how shells write the blank. */
static struct word last_part(struct word path) {
    size_t i = path.length;
    while (i > 0 && path.start[i - 1] != '/' &&
           (path.start[i - 1] != '\\' || (i < path.length && path.start[i] == ' '))) {
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

/* The path of a name, with / between directories; or with an ending instead of its own. What is
 * `coded` as in URLs, "%20", or in shells, "\ ", may be decoded. */
static char *make_path(const char *naming, struct word name, const char *ending, bool coded) {
    const char *slash = strrchr(naming, '/');
    const int directory = slash == NULL ? 0 : (int)(slash + 1 - naming);
    const size_t own = ending == NULL ? 0 : name_ending(name).length;
    char *path =
        string_format("%.*s%.*s%s", directory, naming, (int)(name.length - own - (own > 0)),
                      name.start, ending == NULL ? "" : ending);
    char *to = path == NULL ? NULL : path + directory;
    for (const char *from = to; to != NULL && *from != '\0'; from++) {
        if (coded && from[0] == '%' && isxdigit((unsigned char)from[1]) &&
            isxdigit((unsigned char)from[2])) {
            *to++ = (char)strtoul((const char[]){from[1], from[2], '\0'}, NULL, 16);
            from += 2;
        } else if (!coded || from[0] != '\\' || from[1] != ' ') {
            *to++ = (char)(*from == '\\' ? '/' : *from);
        }
    }
    if (to != NULL) {
        *to = '\0';
    }
    return path;
}

char *find_named(struct word name, const char *naming, bool is_picture, bool *found) {
    static const char *const endings[] = {NULL, ".png", ".tga"}; /* at first, or else at last */
    enum { NAMES = 4, FORMS = 3 };
    const struct word whole = without_quotes(name), rid = without_quotes(name_without_rest(name));
    const struct word names[NAMES] = {whole, last_part(whole), rid, last_part(rid)};
    const bool may_be_coded = name.length > 0 && (memchr(name.start, '%', name.length) != NULL ||
                                                  memchr(name.start, '\\', name.length) != NULL);
    char *path = NULL;
    *found = false;
    for (size_t i = 0; i < NAMES * FORMS * (may_be_coded ? 2 : 1) && !*found; i++) {
        const struct word one = names[i / FORMS % NAMES], ending = name_ending(one);
        const bool is_read = ending.length == 0 || image_file_is_readable(ending);
        const bool again = i / FORMS % NAMES > 0 && one.length == whole.length;
        if (again || one.length == 0 || (!is_picture && i % FORMS > 0)) {
            continue;
        }
        free(path);
        path = make_path(naming, one, is_picture ? endings[(i + !is_read) % FORMS] : NULL,
                         i >= NAMES * FORMS);
        if (path == NULL) {
            return NULL;
        }
        *found = file_find(path);
    }
    if (!*found && name.length > 0) {
        free(path);
        path = make_path(naming, rid, NULL, false);
    }
    return path;
}
