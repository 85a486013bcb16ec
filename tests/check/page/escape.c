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

/* What is written for a character that means something there, or NULL. */
typedef const char *entity_function(char character);

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

static const char *json_of(char character) {
    return character == '"'    ? "\\\""
           : character == '\\' ? "\\\\"
           : character == '\n' ? "\\n"
                               : NULL;
}

static bool escape(struct bytes *out, const char *text, entity_function *find) {
    char *printable = printable_lines(text);
    bool done = printable != NULL;
    for (const char *at = printable; done && *at != '\0'; at++) {
        const char *entity = find(*at);
        done =
            entity != NULL ? bytes_append(out, entity, strlen(entity)) : bytes_append(out, at, 1);
    }
    free(printable);
    return done;
}

bool escape_markup(struct bytes *out, const char *text) {
    return escape(out, text, entity_of);
}

bool escape_json(struct bytes *out, const char *text) {
    return escape(out, text, json_of);
}

bool escape_print(struct bytes *out, escape_function *escape_text, const char *format,
                  va_list arguments) {
    bool done = true;
    for (const char *at = format; done && *at != '\0';) {
        size_t plain = strcspn(at, "%");
        done = bytes_append(out, at, plain);
        at += plain;
        if (*at == '%') {
            done = done && (at[1] == 's' ? escape_text(out, va_arg(arguments, const char *))
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
