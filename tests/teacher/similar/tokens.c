/* The tokens of a C program: see tokens.h. */
#include "tokens.h"

#include "base/array.h"

#include <stdlib.h>
#include <string.h>

enum piece_kind { PIECE_END, PIECE_WORD, PIECE_NUMBER, PIECE_STRING, PIECE_CHARACTER, PIECE_SIGN };

/* A piece of the text; a sign is a single byte, so that `->` is two of them. */
struct piece {
    enum piece_kind kind;
    const unsigned char *start;
    size_t size, line;
};

/* A place in the text. */
struct scan {
    const unsigned char *next, *end;
    size_t line;
};

/* ---- Pieces ---- */

static bool is_digit(unsigned char byte) {
    return byte >= '0' && byte <= '9';
}

/* Bytes from 0x80 on may be letters of UTF-8. */
static bool is_of_word(unsigned char byte) {
    return (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') || byte == '_' ||
           is_digit(byte) || byte >= 0x80;
}

/* Does the text go on with these two characters? */
static bool begins(const struct scan *scan, const char *two) {
    return scan->end - scan->next >= 2 && memcmp(scan->next, two, 2) == 0;
}

static void step_over(struct scan *scan) {
    scan->line += *scan->next++ == '\n';
}

/* A byte, and with a backslash the one after it; CR LF counts as one. */
static void step_over_escape(struct scan *scan) {
    bool escape = *scan->next == '\\';
    step_over(scan);
    if (escape && begins(scan, "\r\n")) {
        step_over(scan);
    }
    if (escape && scan->next < scan->end) {
        step_over(scan);
    }
}

static void skip_comment(struct scan *scan) {
    bool to_line_end = scan->next[1] == '/';
    scan->next += 2;
    while (scan->next < scan->end && (to_line_end ? *scan->next != '\n' : !begins(scan, "*/"))) {
        if (to_line_end) {
            step_over_escape(scan); /* the next line may belong to it */
        } else {
            step_over(scan);
        }
    }
    if (!to_line_end && scan->next < scan->end) {
        scan->next += 2;
    }
}

/* White space, control characters, the backslash before a line's end, and comments. */
static void skip_blanks(struct scan *scan) {
    while (scan->next < scan->end) {
        if (begins(scan, "/*") || begins(scan, "//")) {
            skip_comment(scan);
        } else if (*scan->next <= ' ' || *scan->next == 0x7f || *scan->next == '\\') {
            step_over(scan);
        } else {
            return;
        }
    }
}

static void skip_word(struct scan *scan) {
    while (scan->next < scan->end && is_of_word(*scan->next)) {
        scan->next++;
    }
}

/* A preprocessing number: 0x1p-3, 1e+5f, .5 (C17, 6.4.8). */
static void skip_number(struct scan *scan) {
    while (scan->next < scan->end && (is_of_word(*scan->next) || *scan->next == '.')) {
        bool exponent = strchr("eEpP", *scan->next) != NULL;
        scan->next++;
        scan->next += exponent && scan->next < scan->end && strchr("+-", *scan->next) != NULL &&
                      *scan->next != '\0';
    }
}

/* Up to the same quote. One that is never closed ends with its line, as in C. */
static void skip_quoted(struct scan *scan) {
    unsigned char quote = *scan->next++;
    while (scan->next < scan->end && *scan->next != quote && *scan->next != '\n') {
        step_over_escape(scan);
    }
    scan->next += scan->next < scan->end && *scan->next == quote;
}

static struct piece next_piece(struct scan *scan) {
    skip_blanks(scan);
    struct piece piece = {PIECE_END, scan->next, 0, scan->line};
    if (scan->next == scan->end) {
        return piece;
    }
    unsigned char first = *scan->next;
    if (is_digit(first) ||
        (first == '.' && scan->end - scan->next >= 2 && is_digit(scan->next[1]))) {
        piece.kind = PIECE_NUMBER;
        skip_number(scan);
    } else if (is_of_word(first)) {
        piece.kind = PIECE_WORD;
        skip_word(scan);
    } else if (first == '"' || first == '\'') {
        piece.kind = first == '"' ? PIECE_STRING : PIECE_CHARACTER;
        skip_quoted(scan);
    } else {
        piece.kind = PIECE_SIGN;
        scan->next++;
    }
    piece.size = (size_t)(scan->next - piece.start);
    return piece;
}

/* ---- Codes ---- */

/* FNV-1a (Fowler, Noll, Vo), begun with what kind of token it is. */
static uint64_t code_of(enum piece_kind kind, const unsigned char *bytes, size_t size) {
    uint64_t hash = (UINT64_C(14695981039346656037) ^ (uint64_t)kind) * UINT64_C(1099511628211);
    for (size_t i = 0; i < size; i++) {
        hash = (hash ^ bytes[i]) * UINT64_C(1099511628211);
    }
    return hash;
}

static bool is_spelled(const struct piece *piece, const char *text) {
    return piece->size == strlen(text) && memcmp(piece->start, text, piece->size) == 0;
}

static bool is_keyword(const struct piece *word) {
    static const char *const keywords[] = {
        "auto",  "bool",     "break",  "case",   "char",     "const",    "continue", "default",
        "do",    "double",   "else",   "enum",   "extern",   "false",    "float",    "for",
        "goto",  "if",       "inline", "int",    "long",     "register", "restrict", "return",
        "short", "signed",   "sizeof", "static", "struct",   "switch",   "true",     "typedef",
        "union", "unsigned", "void",   "while",  "volatile", "_Bool"};
    for (size_t i = 0; i < sizeof keywords / sizeof keywords[0]; i++) {
        if (is_spelled(word, keywords[i])) {
            return true;
        }
    }
    return false;
}

static uint64_t code_of_piece(const struct piece *piece) {
    bool itself = piece->kind == PIECE_SIGN || (piece->kind == PIECE_WORD && is_keyword(piece));
    return code_of(piece->kind, piece->start, itself ? piece->size : 0);
}

/* ---- All of them ---- */

bool tokens_append(struct tokens *tokens, const unsigned char *text, size_t size, size_t line) {
    if (size == 0) { /* `text` may be NULL, on which nothing may be computed */
        return true;
    }
    struct scan scan = {text, text + size, line};
    for (struct piece piece; (piece = next_piece(&scan)).kind != PIECE_END;) {
        struct token *all =
            array_reserve(tokens->all, &tokens->capacity, tokens->count + 1, sizeof *all);
        if (all == NULL) {
            return false;
        }
        tokens->all = all;
        all[tokens->count++] = (struct token){code_of_piece(&piece), piece.line};
    }
    return true;
}

void tokens_free(struct tokens *tokens) {
    free(tokens->all);
    *tokens = (struct tokens){0};
}
