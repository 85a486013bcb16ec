/* Blocks of bytes and formatted strings: see bytes.h. */
#include "base/bytes.h"

#include "base/array.h"

#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool bytes_reserve(struct bytes *bytes, size_t size) {
    return size <= SIZE_MAX - bytes->size &&
           array_extend(&bytes->data, &bytes->capacity, bytes->size + size, 1);
}

bool bytes_append(struct bytes *bytes, const void *data, size_t size) {
    if (size == 0) {
        return true;
    }
    if (!bytes_reserve(bytes, size)) {
        return false;
    }
    memcpy(bytes->data + bytes->size, data, size);
    bytes->size += size;
    return true;
}

void bytes_free(struct bytes *bytes) {
    free(bytes->data);
    *bytes = (struct bytes){0};
}

/* What vprintf would print, in memory that the caller frees; NULL when memory runs out. */
static char *format_string(const char *format, va_list arguments) {
    va_list again;
    va_copy(again, arguments);
    int length = vsnprintf(NULL, 0, format, arguments);
    char *string = length >= 0 ? malloc((size_t)length + 1) : NULL;
    if (string != NULL) {
        vsnprintf(string, (size_t)length + 1, format, again);
    }
    va_end(again);
    return string;
}

char *string_format(const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    char *string = format_string(format, arguments);
    va_end(arguments);
    return string;
}

void string_append(char *string, size_t size, const char *format, ...) {
    size_t length = strlen(string);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(string + length, size - length, format, arguments);
    va_end(arguments);
}

bool bytes_print(struct bytes *bytes, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    char *text = format_string(format, arguments);
    va_end(arguments);
    bool done = text != NULL && bytes_append(bytes, text, strlen(text));
    free(text);
    return done;
}
