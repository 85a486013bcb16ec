/* Lines, words and exact numbers; see text.h. */
#include "base/text.h"

#include <float.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- Messages ---- */

struct shown_word word_show(struct word word) {
    struct shown_word shown = {{0}};
    size_t room = sizeof shown.text - 1;
    if (word.length <= room) {
        memcpy(shown.text, word.start, word.length);
        return shown;
    }
    size_t length = room - 3;
    /* Do not cut a UTF-8 character in two: its later bytes are 10xxxxxx. */
    while (length > 0 && ((unsigned char)word.start[length] & 0xC0) == 0x80) {
        length--;
    }
    memcpy(shown.text, word.start, length);
    memcpy(shown.text + length, "...", 3);
    return shown;
}

/* ---- UTF-16 ---- */

bool text_is_utf16(const void *data, size_t size) {
    const unsigned char *b = data;
    return size >= 2 && (memcmp(b, "\xFF\xFE", 2) == 0 || memcmp(b, "\xFE\xFF", 2) == 0 ||
                         (size >= 4 && ((b[0] == 0 && b[1] > 0 && b[2] == 0 && b[3] > 0) ||
                                        (b[0] > 0 && b[1] == 0 && b[2] > 0 && b[3] == 0))));
}

bool text_from_utf16(struct bytes *utf8, const void *data, size_t size) {
    const unsigned char *bytes = data;
    size_t high = bytes[0] == 0xFE || bytes[0] == 0 ? 0 : 1; /* the byte that counts 256 times */
    if (size > SIZE_MAX / 2 || !bytes_reserve(utf8, size / 2 * 3)) {
        return false;
    }
    for (size_t i = bytes[0] >= 0xFE ? 2 : 0; i + 1 < size; i += 2) {
        unsigned unit = (unsigned)bytes[i + high] << 8 | bytes[i + 1 - high];
        unsigned char *p = utf8->data + utf8->size;
        size_t length = unit < 0x80 ? 1 : unit < 0x800 ? 2 : 3;
        for (size_t k = length - 1; k > 0; k--, unit >>= 6) {
            p[k] = (unsigned char)(0x80 | (unit & 0x3F));
        }
        p[0] = (unsigned char)(unit | (length == 1 ? 0 : length == 2 ? 0xC0 : 0xE0));
        utf8->size += length;
    }
    return true;
}

/* ---- Lines and words ---- */

static bool is_line_end(char c) {
    return c == '\n' || c == '\r';
}

static bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

/* One past the line's end that is at p (nothing, at the end of the text). */
static const char *over_line_end(const char *p, const char *end) {
    if (p < end && *p == '\r') {
        p++;
        return p < end && *p == '\n' ? p + 1 : p;
    }
    return p < end ? p + 1 : p;
}

void text_peek(struct text *text, const void *data, size_t size) {
    const char *start = data;
    *text = (struct text){.next = NULL};
    if (size > 0) { /* otherwise `data` may be NULL, on which nothing may be computed */
        text->end = start + size;
        text->next = start + (size >= 3 && memcmp(start, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0);
    }
}

bool text_begin(struct text *text, const void *data, size_t size, bool continuation,
                struct error *error) {
    const char *start = data;
    while (size > 0 && start[size - 1] == '\0') {
        size--;
    }
    text_peek(text, data, size);
    text->continuation = continuation;
    const char *nul = size > 0 ? memchr(start, '\0', size) : NULL;
    if (nul != NULL) {
        size_t line = 1;
        for (const char *p = start; p < nul; p++) {
            line += *p == '\n' || (*p == '\r' && p[1] != '\n');
        }
        return text_error(error, line, "not a text file: it holds a zero byte");
    }
    return true;
}

bool text_next_line(struct text *text) {
    if (text->line > 0 && text->next < text->end && *text->next == '\n') {
        text->next++; /* most lines have been read to their ends */
    } else if (text->line > 0) {
        while (text_next_word(text).length > 0) { /* it may be joined with the next */
        }
        text->next = over_line_end(text->next, text->end);
    }
    if (text->next == text->end) {
        return false;
    }
    text->line++;
    return true;
}

/* Where the backslash at p joins this line with the next one: the end of the line; otherwise
 * NULL. */
static const char *joined_at(const struct text *text, const char *p) {
    if (!text->continuation || *p != '\\') {
        return NULL;
    }
    for (p++; p < text->end && is_blank(*p); p++) {
    }
    return p == text->end || is_line_end(*p) ? p : NULL;
}

bool text_is_rare_word_end(const struct text *text, const char *p) {
    return is_blank(*p) || is_line_end(*p) || joined_at(text, p) != NULL;
}

bool text_find_rare_word(struct text *text) {
    const char *p = text->next;
    while (p < text->end) {
        if (is_blank(*p)) {
            p++;
        } else if (joined_at(text, p) != NULL) {
            p = over_line_end(joined_at(text, p), text->end);
            text->line++;
        } else {
            break;
        }
    }
    if (p < text->end && *p == '#') {
        while (p < text->end && !is_line_end(*p)) {
            p++;
        }
    }
    text->next = p;
    return p < text->end && !is_line_end(*p);
}

struct word text_next_word(struct text *text) {
    text_find_word(text);
    const char *start = text->next, *p = start;
    while (!text_is_word_end(text, p)) {
        p++;
    }
    text->next = p;
    return (struct word){start, start == NULL ? 0 : (size_t)(p - start)};
}

struct word text_rest_of_line(struct text *text) {
    text_find_word(text);
    const char *start = text->next, *p = start, *end = start;
    for (; p < text->end && !is_line_end(*p); p++) {
        end = is_blank(*p) ? end : p + 1;
    }
    text->next = p;
    return (struct word){start, start == NULL ? 0 : (size_t)(end - start)};
}

/* ---- Integers ---- */

bool word_to_integer(struct word word, int64_t *value) {
    bool negative = word.length > 0 && word.start[0] == '-';
    size_t first = negative || (word.length > 0 && word.start[0] == '+');
    int64_t result = 0; /* kept negative: there is one more number below zero than above */
    for (size_t i = first; i < word.length; i++) {
        int digit = word.start[i] - '0';
        if (digit < 0 || digit > 9) {
            return false;
        }
        result = result >= (INT64_MIN + digit) / 10 ? result * 10 - digit : INT64_MIN;
    }
    *value = negative ? result : result == INT64_MIN ? INT64_MAX : -result;
    return first < word.length;
}

/* ---- Decimal numbers ---- */

enum {
    EXACT_DIGITS = 19, /* any 19 digits fit into 64 bits */
    EXACT_POWER = 22,  /* 10^22 is the largest power of ten that is exact in a double */
    EXPONENT_LIMIT = 1000000000,
    KEPT_DIGITS = 800 /* more than the 768 that a middle between two doubles can have */
};

/* A decimal number taken apart: [+-] digits [. digits] [e [+-] digits]. */
struct decimal {
    bool negative;
    uint64_t digits;         /* those before and behind the point as one number, if they fit */
    const char *start, *end; /* where the digits and their point are */
    const char *point;       /* `end` where there is none */
    ptrdiff_t whole, part;   /* how many digits are before the point, and behind it */
    int64_t exponent;        /* the one that is written */
};

/* "e-5": returns the place behind it, NULL where there is no such exponent. */
static const char *read_exponent(const char *p, const char *end, int64_t *exponent) {
    p++;
    bool negative = p < end && *p == '-';
    p += negative || (p < end && *p == '+');
    const char *start = p;
    int64_t value = 0;
    for (; p < end && *p >= '0' && *p <= '9'; p++) {
        value = value < EXPONENT_LIMIT ? value * 10 + (*p - '0') : value;
    }
    *exponent = negative ? -value : value;
    return p > start ? p : NULL;
}

/* Returns the place behind the number, NULL where none begins at p. */
static inline const char *read_decimal(const char *p, const char *end, struct decimal *decimal) {
    decimal->negative = p < end && *p == '-';
    p += decimal->negative | (p < end && *p == '+');
    decimal->digits = 0;
    decimal->exponent = 0;
    decimal->start = p;
    decimal->point = p = text_read_digits(p, end, &decimal->digits);
    decimal->whole = p - decimal->start;
    decimal->part = 0;
    if (p < end && *p == '.') {
        p = text_read_digits(p + 1, end, &decimal->digits);
        decimal->part = p - decimal->point - 1;
    }
    decimal->end = p;
    if (decimal->whole + decimal->part == 0) {
        return NULL;
    }
    if (p < end && (*p == 'e' || *p == 'E')) {
        int64_t exponent;
        p = read_exponent(p, end, &exponent);
        decimal->exponent = exponent;
    }
    return p;
}

/* A number whose digits are a whole number up to 2^53 and whose power of ten is exact in double:
 * then one multiplication or division, which rounds once, gives the nearest double (Clinger, "How
 * to Read Floating Point Numbers Accurately", 1990). False for others. */
static inline bool exact_double(const struct decimal *decimal, double *value) {
    static const double power_of_ten[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                          1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                          1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    static const double sign[] = {1, -1}; /* no branch: no processor can predict it */
    int64_t power = decimal->exponent - decimal->part;
    if (FLT_EVAL_METHOD != 0 || decimal->whole + decimal->part > EXACT_DIGITS ||
        decimal->digits > UINT64_C(1) << 53 || power < -EXACT_POWER || power > EXACT_POWER) {
        return false;
    }
    double whole = sign[decimal->negative] * (double)(int64_t)decimal->digits;
    *value = power < 0 ? whole / power_of_ten[-power] : whole * power_of_ten[power];
    return true;
}

/* Any other by strtod(), from a copy "DIGITSeEXPONENT". It has no point, so that the locale does
 * not matter, and no more digits than can: a last 1 says that one behind them is not 0. */
static double any_double(struct decimal decimal) {
    char copy[KEPT_DIGITS + 32];
    size_t kept = 0;
    int64_t exponent = decimal.exponent + decimal.whole;
    bool more = false;
    for (const char *p = decimal.start; p < decimal.end; p++) {
        if (p == decimal.point) {
            continue;
        }
        if (kept == 0 && *p == '0') { /* a leading zero only moves the point */
            exponent--;
        } else if (kept < KEPT_DIGITS) {
            copy[kept++] = *p;
        } else {
            more |= *p != '0';
        }
    }
    copy[kept++] = more ? '1' : '0';
    snprintf(copy + kept, sizeof copy - kept, "e%" PRId64, exponent - (int64_t)kept);
    double magnitude = strtod(copy, NULL);
    return decimal.negative ? -magnitude : magnitude;
}

static inline double decimal_value(const struct decimal *decimal) {
    double value;
    return exact_double(decimal, &value) ? value : any_double(*decimal);
}

bool word_to_double(struct word word, double *value) {
    const char *end = word.start + word.length;
    struct decimal decimal;
    if (word.length == 0 || read_decimal(word.start, end, &decimal) != end) {
        return false;
    }
    *value = decimal_value(&decimal);
    return true;
}

struct word text_next_number(struct text *text, double *number) {
    struct decimal decimal;
    const char *p = text_find_word(text) ? read_decimal(text->next, text->end, &decimal) : NULL;
    const char *start = text->next;
    if (p == NULL || !text_is_word_end(text, p)) {
        *number = NAN;
        return text_next_word(text);
    }
    *number = decimal_value(&decimal);
    text->next = p;
    return (struct word){start, (size_t)(p - start)};
}
