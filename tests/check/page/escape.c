/* Text that others wrote: see escape.h. */
#include "escape.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

char *printable_lines(const char *text) {
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

/* What stands for a character that means something there, or NULL. */
static const char *entity_of(char character) {
    switch (character) {
    case '<':
        return "&lt;";
    case '>':
        return "&gt;";
    case '&':
        return "&amp;";
    case '"':
        return "&quot;";
    case '\'':
        return "&#39;";
    default:
        return NULL;
    }
}

bool escape_markup(struct bytes *out, const char *text) {
    char *printable = printable_lines(text);
    bool done = printable != NULL;
    for (const char *at = printable; done && *at != '\0'; at++) {
        const char *entity = entity_of(*at);
        done =
            entity != NULL ? bytes_append(out, entity, strlen(entity)) : bytes_append(out, at, 1);
    }
    free(printable);
    return done;
}

bool markup_print(struct bytes *out, const char *format, ...) {
    bool done = true;
    va_list arguments;
    va_start(arguments, format);
    for (const char *at = format; done && *at != '\0';) {
        size_t plain = strcspn(at, "%");
        done = bytes_append(out, at, plain);
        at += plain;
        if (*at == '%') {
            done = done && (at[1] == 's' ? escape_markup(out, va_arg(arguments, const char *))
                                         : bytes_print(out, "%u", va_arg(arguments, unsigned)));
            at += 2;
        }
    }
    va_end(arguments);
    return done;
}
