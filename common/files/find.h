/* Files that other files name. */
#ifndef COMMON_FILES_FIND_H
#define COMMON_FILES_FIND_H

#include "base/text.h"

#include <stdbool.h>

/* The path of a file that the one at `naming` names: next to that or, where it is not there (many
 * files name directories of their maker's machine), by its last part alone; if need be without a
 * comment or options behind it, in other letters (file_find()), and with its blanks written as in
 * URLs or shells. Of a picture, "x.png" or "x.tga" does as well, and better than a kind that is not
 * read. Where none of these is there, `found` is false, and the name is as it is written. The
 * caller frees the path; NULL for an empty name, or when memory runs out. */
char *find_named(struct word name, const char *naming, bool is_picture, bool *found);

/* The name before a comment, or before options where some write them. (Names may hold blanks.) */
struct word name_without_rest(struct word name);

/* What follows the last dot in the last part of a path, which does not begin with it; empty, at the
 * end, where there is none. */
struct word name_ending(struct word path);

/* Is the path's ending this one, in small or capital letters? */
bool name_ends(const char *path, const char *ending);

#endif
