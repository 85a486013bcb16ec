/* What a file is that no reader here reads, for messages. */
#ifndef COMMON_KNOWN_H
#define COMMON_KNOWN_H

#include "base/error.h"

#include <stdbool.h>
#include <stddef.h>

/* Does the file begin like a file of a known kind? Then the message names it, and says what helps;
 * what was wanted is a model or a picture. Otherwise the message stays as it is. */
bool error_known_file(struct error *error, const void *data, size_t size, bool model_wanted);

#endif
