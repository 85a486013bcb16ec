/*
 * Text files taken apart: lines, words and exact numbers, whatever the locale.
 *
 * Used by the readers of OBJ, OFF and text scenes. A line ends with LF, CRLF or CR. A backslash
 * before the line's end, or before blanks that end it, joins it with the next line (where the
 * caller asks for that); it also ends a word, and in a comment it means nothing. Nothing is copied:
 * words point into the text that the caller keeps. The work is linear in the size of the text.
 */
#ifndef COMMON_BASE_TEXT_H
#define COMMON_BASE_TEXT_H

#include "base/bytes.h"
#include "base/file.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

/* A place in a text. */
struct text {
    const char *next;  /* the first character that is not yet read */
    const char *end;   /* one past the last character */
    size_t line;       /* number of the current line, from 1; 0 before the first */
    bool continuation; /* a backslash before a line's end joins lines */
};

/* A run of characters without blanks; length 0 where the line has ended. */
struct word {
    const char *start;
    size_t length;
};

/* Is a text UTF-16, which Windows calls Unicode? Its first two bytes say so or, without those, a
 * zero in every other byte of two letters. */
bool text_is_utf16(const void *data, size_t size);

/* Append it to `utf8` as UTF-8, without these two bytes. Each half of a pair becomes three bytes by
 * itself, and an odd byte at the end is left out. False when memory runs out. */
bool text_from_utf16(struct bytes *utf8, const void *data, size_t size);

/* Start before the first line. A UTF-8 byte-order mark is skipped. NUL bytes at the end are left
 * out; one anywhere else means that this is not a text file: an error (with its line). */
bool text_begin(struct text *text, const void *data, size_t size, bool continuation,
                struct error *error);

/* Start before the first line without a search for NUL bytes, where only the first words of a large
 * file may be needed. */
void text_peek(struct text *text, const void *data, size_t size);

/* Go to the next line, over what is left of this one; false at the end of the text. */
bool text_next_line(struct text *text);

/* The next word of the current line; length 0 at its end. A '#' at a word's start begins a comment
 * that reaches to the end of the line. Where lines are joined, `line` counts on. */
struct word text_next_word(struct text *text);

/* What is left of the line, without blanks around it: names may hold blanks. */
struct word text_rest_of_line(struct text *text);

/* The next word, read as a number as by word_to_double(); NaN where it is none. */
struct word text_next_number(struct text *text, double *number);

/* A string as a word. */
static inline struct word word_of(const char *string) {
    return (struct word){string, strlen(string)};
}

/* Are two letters the same one, small or capital, or two other characters the same? */
static inline bool is_same_letter(char a, char b) {
    const char small = (char)(a | 0x20);
    return a == b || (small == (b | 0x20) && small >= 'a' && small <= 'z');
}

/* Does the word begin like this, in small or in capital letters? */
static inline bool word_begins(struct word word, const char *beginning) {
    size_t i = 0;
    while (i < word.length && beginning[i] != '\0' && is_same_letter(word.start[i], beginning[i])) {
        i++;
    }
    return beginning[i] == '\0';
}

/* Is it this string, in small or in capital letters? */
static inline bool word_matches(struct word word, const char *string) {
    return word.length == strlen(string) && word_begins(word, string);
}

/* Is the word exactly this string? */
static inline bool word_is(struct word word, const char *string) {
    size_t length = strlen(string);
    return word.length == length && (length == 0 || memcmp(word.start, string, length) == 0);
}

/* The whole word as a decimal number ([+-] digits [. digits] [e [+-] digits], with ".5" and "5."),
 * rounded once to the nearest double (ties to even). Too large gives infinity, too small zero or a
 * subnormal; the sign of zero is kept. False for anything else ("nan" and "inf" too). */
bool word_to_double(struct word word, double *value);

/* The whole word as a decimal integer, cut to 64 bits; false for anything else. */
bool word_to_integer(struct word word, int64_t *value);

/* ---- For readers that go character by character ---- */

/* The parts for characters that are rare of the two functions below. */
bool text_find_rare_word(struct text *text);
bool text_is_rare_word_end(const struct text *text, const char *p);

/* Go to where the next word begins; false at the end of the line. */
static inline bool text_find_word(struct text *text) {
    const char *p = text->next;
    while (p < text->end && *p == ' ') {
        p++;
    }
    text->next = p;
    if (p == text->end || *p == '\n') {
        return false;
    }
    /* No blank, comment or line's end begins above '#'; a backslash may join lines. */
    return ((unsigned char)*p > '#' && *p != '\\') || text_find_rare_word(text);
}

/* Does a word that goes on to p end there? */
static inline bool text_is_word_end(const struct text *text, const char *p) {
    return p == text->end || *p == ' ' || *p == '\n' ||
           (((unsigned char)*p < ' ' || *p == '\\') && text_is_rare_word_end(text, p));
}

/* Over digits, which are put behind those in `value` (and overflow where they are too many). Four
 * at once, since most numbers of most files have so many behind the point. */
static inline const char *text_read_digits(const char *p, const char *end, uint64_t *value) {
    uint64_t sum = *value;
    if (end - p >= 4) {
        uint32_t four = load_u32(p) ^ 0x30303030; /* a byte up to 9 was a digit */
        if (((four | (four + 0x76767676)) & 0x80808080) == 0) {
            four = 10 * four + (four >> 8); /* two digits in byte 0, two in byte 2 */
            four = (four & 0xff00ff) * (100 << 16 | 1);
            sum = 10000 * sum + (four >> 16);
            p += 4;
        }
    }
    for (unsigned digit; p < end && (digit = (unsigned char)*p - (unsigned)'0') <= 9; p++) {
        sum = 10 * sum + digit;
    }
    *value = sum;
    return p;
}

/* A word ready to be shown with "%s" in a message: a long one is cut and ends with "...". */
struct shown_word {
    char text[40];
};
struct shown_word word_show(struct word word);

#endif
