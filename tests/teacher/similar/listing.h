/* The pairs that were found, as files: a page for a person, and a table for a program. */
#ifndef TESTS_SIMILAR_LISTING_H
#define TESTS_SIMILAR_LISTING_H

#include "class.h"
#include "pairs.h"

/* Both append, and are false when memory runs out. */

/* A page of HTML, one file that works offline: a table of the pairs, and of the first of them the
 * lines that are alike, side by side. The submissions are read again. */
bool listing_html(struct bytes *page, const struct class *class, const struct pairs *pairs,
                  struct limits limits);

/* CSV (RFC 4180), a line a pair and lesson in which they have anything in common. */
bool listing_csv(struct bytes *table, const struct class *class, const struct pairs *pairs);

#endif
