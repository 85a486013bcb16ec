/* PNG by libpng, to compare with: it is compiled in where its header is installed. */
#ifndef TESTS_FILES_LIBPNG_H
#define TESTS_FILES_LIBPNG_H

#include "base/bytes.h"
#include "base/error.h"
#include "tgaimage.h"

#include <stdbool.h>
#include <stddef.h>

/* Its version; NULL where it is not installed, and then the functions always fail. */
extern const char *const libpng_version;

/* As png_encode(), for images without alpha: with libpng's own settings, and with the fastest
 * compression. */
bool libpng_encode(const struct image *image, struct bytes *out, struct error *error);
bool libpng_encode_quickly(const struct image *image, struct bytes *out, struct error *error);

/* As png_decode(), for files without alpha. */
bool libpng_decode(struct image *image, const void *data, size_t size, struct error *error);

#endif
