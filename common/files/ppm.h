/*
 * PPM and PGM files for the images of tgaimage.h: the format that every viewer and every script
 * understands.
 *
 * Format: the manual pages ppm(5) and pgm(5) of Netpbm.
 */
#ifndef COMMON_FILES_PPM_H
#define COMMON_FILES_PPM_H

#include "base/bytes.h"
#include "base/error.h"
#include "tgaimage.h"

#include <stdbool.h>

/* Do the bytes begin as those of P2, P3, P5 or P6? */
bool ppm_is_possible(const void *data, size_t size);

/* Read what ppm_is_possible() accepts: text or bytes of one or two a sample, brought to 0..255.
 * `image` is overwritten, not freed; empty on an error. */
bool ppm_decode(struct image *image, const void *data, size_t size, struct error *error);

/* PGM/PPM (P5 for grey, else P6 without alpha), top row first. */
bool ppm_encode(const struct image *image, struct bytes *out, struct error *error);
bool ppm_write(const struct image *image, const char *path, struct error *error);

#endif
