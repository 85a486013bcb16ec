/* Messages: see error.h. */
#include "base/error.h"

#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

enum { SHOWN_PATH_LIMIT = 512 }; /* a longer path is shown without its beginning */

/* The UTF-8 character at the beginning of a text (F. Yergeau, "UTF-8, a transformation format of
 * ISO 10646", RFC 3629, section 4), and how many bytes it takes; 0 where there is none. */
static size_t utf8_decode(const char *text, uint32_t *character) {
    static const uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    unsigned char first = (unsigned char)text[0];
    size_t size = first < 0x80 ? 1 : first < 0xc0 ? 0 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
    *character = size < 2 ? first : first & (0xffu >> (size + 1));
    for (size_t i = 1; i < size; i++) {
        unsigned char byte = (unsigned char)text[i];
        if ((byte & 0xc0) != 0x80) { /* nor is it read past the end of the text */
            return 0;
        }
        *character = *character << 6 | (byte & 0x3fu);
    }
    bool surrogate = *character >= 0xd800 && *character < 0xe000;
    return *character < least[size] || *character > 0x10ffff || surrogate ? 0 : size;
}

/* Control characters, those that end a line or turn the direction of writing (The Unicode Standard,
 * sections 23.1 and 23.2, and annex 9, section 2), and the two that XML allows nowhere (W3C,
 * "Extensible Markup Language (XML) 1.0", section 2.2). */
static bool is_obeyed(uint32_t character) {
    return character < 0x20 || (character >= 0x7f && character < 0xa0) || character == 0x61c ||
           (character >= 0x200e && character <= 0x200f) ||
           (character >= 0x2028 && character <= 0x202e) ||
           (character >= 0x2066 && character <= 0x2069) || character == 0xfffe ||
           character == 0xffff;
}

void text_make_printable(char *text, char instead) {
    while (*text != '\0') {
        uint32_t character;
        size_t size = utf8_decode(text, &character);
        if (size == 0 || is_obeyed(character)) { /* its other bytes, alone, are no character */
            *text = instead;
            size = 1;
        }
        text += size;
    }
}

static void set(struct error *error, size_t line, const char *format, va_list arguments) {
    if (vsnprintf(error->message, sizeof error->message, format, arguments) < 0) {
        error->message[0] = '\0';
    }
    text_make_printable(error->message, '?'); /* a file name may hold any byte */
    error->line = line;
}

bool error_set(struct error *error, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    set(error, 0, format, arguments);
    va_end(arguments);
    return false;
}

bool text_error(struct error *error, size_t line, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    set(error, line, format, arguments);
    va_end(arguments);
    return false;
}

static const char out_of_memory[] = "out of memory";

bool error_out_of_memory(struct error *error) {
    return error_set(error, "%s", out_of_memory);
}

bool error_is_out_of_memory(const struct error *error) {
    size_t length = strlen(error->message), end = sizeof out_of_memory - 1;
    return length >= end && strcmp(error->message + length - end, out_of_memory) == 0;
}

bool error_name_file(struct error *error, const char *path) {
    struct error plain = *error;
    size_t length = strlen(path);
    bool cut = length > SHOWN_PATH_LIMIT;
    char line[24] = "";
    if (plain.line > 0) {
        snprintf(line, sizeof line, ":%zu", plain.line);
    }
    return error_set(error, "%s%s%s: %s", cut ? "..." : "",
                     cut ? path + length - SHOWN_PATH_LIMIT : path, line, plain.message);
}
