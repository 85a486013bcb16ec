#define _POSIX_C_SOURCE 200809L

#include "todo.h"
#include "base/file.h"

#include <ctype.h>
#include <string.h>
#include <sys/stat.h>

/* Where the part begins in a line of that length; NULL if it is not there. (strstr() would look
 * through the rest of the file for each line.) */
static const char *find_in_line(const char *line, size_t length, const char *part) {
    size_t part_length = strlen(part);
    for (const char *end = line + length; (size_t)(end - line) >= part_length; line++) {
        line = memchr(line, part[0], (size_t)(end - line) - part_length + 1);
        if (line == NULL || memcmp(line, part, part_length) == 0) {
            return line;
        }
    }
    return NULL;
}

static bool line_has(const char *line, size_t length, const char *part) {
    return find_in_line(line, length, part) != NULL;
}

/* Behind a "//" in the line is "to do" with that number, and not a longer one. */
static bool line_has_task(const char *line, size_t length, const char *task) {
    static const char words[] = "to do ";
    const char *end = line + length, *comment = find_in_line(line, length, "//");
    const char *at = comment == NULL ? NULL : find_in_line(comment, (size_t)(end - comment), words);
    for (; at != NULL; at = find_in_line(at, (size_t)(end - at), words)) {
        at += strlen(words);
        const char *after = at + strlen(task);
        if (strncmp(at, task, strlen(task)) == 0 && !isdigit((unsigned char)*after)) {
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
