/* What a file is that no reader here reads, for messages. */
#ifndef COMMON_FILES_KNOWN_H
#define COMMON_FILES_KNOWN_H

#include "base/error.h"

#include <stdbool.h>
#include <stddef.h>

/* Does the file at `path` begin like a file of a known kind? If so, the message names that kind and
 * says what helps, where a model or else a picture was wanted; otherwise the message stays as it
 * is. */
bool known_recognize(const void *data, size_t size, const char *path, bool model_wanted,
                     struct error *error);

#endif
