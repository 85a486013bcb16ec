/* Where files are that other files name, or that are next to a model. */
#ifndef COMMON_FILES_FIND_H
#define COMMON_FILES_FIND_H

#include "base/text.h"

#include <stdbool.h>
#include <stddef.h>

/* The path of the first of these names that `directory` ("" or one that ends with '/') has: exactly
 * so or, where just one file fits, in other letters, small or capital. Where it has none, `found`
 * is false, and the path is that of the first name. The caller frees it; NULL when memory runs
 * out. May change letters of the names. */
char *find_first(const char *directory, char *const *names, size_t count, bool *found);

/* The path of a file that another one in `directory` names: next to that or, where it is not there
 * (many files name directories of their maker's machine), by its last part alone; if need be
 * without a comment or options behind it, and in other letters. Of a picture, "x.png" or "x.tga"
 * does as well, and better than a kind that is not read. Where none of these is there, `found` is
 * false, and it is the path as it is written. The caller frees it; NULL for an empty name, or when
 * memory runs out. */
char *find_named(struct word name, const char *directory, bool is_picture, bool *found);

/* The name before a comment, or before options where some write them. (Names may hold blanks.) */
struct word name_without_rest(struct word name);

#endif
