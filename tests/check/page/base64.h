/* Base64 (S. Josefsson, "The Base16, Base32, and Base64 Data Encodings", RFC 4648). */
#ifndef TESTS_CHECK_PAGE_BASE64_H
#define TESTS_CHECK_PAGE_BASE64_H

#include "base/bytes.h"

#include <stdbool.h>
#include <stddef.h>

/* Append the text of the bytes, padded with '='; false when memory runs out. */
bool base64_encode(struct bytes *out, const void *data, size_t size);

#endif
