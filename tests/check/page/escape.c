/* Text that others wrote: see escape.h. */
#include "escape.h"

#include <stdlib.h>
#include <string.h>

/* A copy in which what a terminal would obey is '?', but lines stay lines, and a tab is a blank.
 * The caller frees it; NULL when memory runs out. */
static char *printable_lines(const char *text) {
    char *copy = string_format("%s", text);
    for (char *line = copy; line != NULL;) {
        char *end = strchr(line, '\n');
        if (end != NULL) {
            *end = '\0';
        }
        for (char *tab = strchr(line, '\t'); tab != NULL; tab = strchr(tab, '\t')) {
            *tab = ' ';
        }
        text_make_printable(line, '?');
        if (end != NULL) {
            *end++ = '\n';
        }
        line = end;
    }
    return copy;
}

const char *escape_markup(char character) {
    return character == '<'    ? "&lt;"
           : character == '>'  ? "&gt;"
           : character == '&'  ? "&amp;"
           : character == '"'  ? "&quot;"
           : character == '\'' ? "&#39;"
                               : NULL;
}

const char *escape_json(char character) {
    return character == '"'    ? "\\\""
           : character == '\\' ? "\\\\"
           : character == '\n' ? "\\n"
                               : NULL;
}

bool escape_text(struct bytes *out, escape_function *escape, const char *text) {
    char *printable = printable_lines(text);
    bool done = printable != NULL;
    for (const char *at = printable; done && *at != '\0'; at++) {
        const char *entity = escape(*at);
        done =
            entity != NULL ? bytes_append(out, entity, strlen(entity)) : bytes_append(out, at, 1);
    }
    free(printable);
    return done;
}

bool escape_print(struct bytes *out, escape_function *escape, const char *format,
                  va_list arguments) {
    bool done = true;
    for (const char *at = format; done && *at != '\0';) {
        size_t plain = strcspn(at, "%");
        done = bytes_append(out, at, plain);
        at += plain;
        if (*at == '%') {
            done = done && (at[1] == 's' ? escape_text(out, escape, va_arg(arguments, const char *))
                                         : bytes_print(out, "%u", va_arg(arguments, unsigned)));
            at += 2;
        }
    }
    return done;
}

bool markup_print(struct bytes *out, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    bool done = escape_print(out, escape_markup, format, arguments);
    va_end(arguments);
    return done;
}
