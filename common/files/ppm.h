/*
 * PPM and PGM files for the images of tgaimage.h, out only: the format that every viewer and every
 * script understands.
 *
 * Format: the manual pages ppm(5) and pgm(5) of Netpbm.
 */
#ifndef COMMON_FILES_PPM_H
#define COMMON_FILES_PPM_H

#include "base/bytes.h"
#include "base/error.h"
#include "tgaimage.h"

#include <stdbool.h>

/* PGM/PPM (P5 for grey, else P6 without alpha), top row first. */
bool ppm_encode(const struct image *image, struct bytes *out, struct error *error);
bool ppm_write(const struct image *image, const char *path, struct error *error);

#endif
