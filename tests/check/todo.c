#define _POSIX_C_SOURCE 200809L

#include "todo.h"
#include "base/file.h"

#include <ctype.h>
#include <string.h>
#include <sys/stat.h>

static bool line_has(const char *line, size_t length, const char *part) {
    const char *found = strstr(line, part);
    return found != NULL && found < line + length;
}

/* Behind a "//" in the line stands "to do" with that number, and not a longer one. */
static bool line_has_task(const char *line, size_t length, const char *task) {
    static const char words[] = "to do ";
    const char *comment = strstr(line, "//"), *end = line + length;
    if (comment == NULL || comment >= end) {
        return false;
    }
    for (const char *at = strstr(comment, words); at != NULL && at < end;
         at = strstr(at + 1, words)) {
        const char *number = at + strlen(words), *after = number + strlen(task);
        if (strncmp(number, task, strlen(task)) == 0 && !isdigit((unsigned char)*after)) {
            return true;
        }
    }
    return false;
}

bool todo_has_task(const char *text, const char *task) {
    bool is_marked = false; /* between the marks of a starter */
    for (size_t length; text != NULL && *text != '\0'; text += length + (text[length] == '\n')) {
        length = strcspn(text, "\n");
        if (line_has(text, length, "/* STARTER")) {
            is_marked = true;
        } else if (line_has(text, length, "END SOLUTION */")) {
            is_marked = false;
        } else if (!is_marked && line_has_task(text, length, task)) {
            return true;
        }
    }
    return false;
}

struct bytes todo_read(const char *path) {
    struct bytes text = {.data = NULL};
    struct error ignored;
    struct stat status;
    if (stat(path, &status) == 0 && S_ISREG(status.st_mode)) { /* a pipe may have no end */
        file_read(path, &text, &ignored);
    }
    bytes_append(&text, "", 1);
    return text;
}
