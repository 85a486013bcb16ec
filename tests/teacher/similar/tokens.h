/*
 * The tokens of a C program, as far as they tell whether two programs are alike.
 *
 * What is changed first in a copy is gone: comments and white space. Names are all alike, numbers
 * are all alike, and so are strings; keywords and signs are themselves.
 *
 * Any bytes will do. Nothing is ever an error, and the work is linear in the size of the text.
 */
#ifndef TESTS_SIMILAR_TOKENS_H
#define TESTS_SIMILAR_TOKENS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct token {
    uint64_t code; /* equal tokens have equal codes */
    size_t line;   /* from 1 */
};

/* All zero is valid and empty. */
struct tokens {
    struct token *all;
    size_t count, capacity;
};

/* Append the tokens of a text whose first line has the number `line`. False when memory
 * runs out. */
bool tokens_append(struct tokens *tokens, const unsigned char *text, size_t size, size_t line);

void tokens_free(struct tokens *tokens);

#endif
