/*
 * PNG files in and out for the images of tgaimage.h, and animated PNG (APNG) out.
 *
 * Formats: W3C, "Portable Network Graphics (PNG) Specification", third edition; deflate: RFC 1951;
 * zlib container: RFC 1950. Both directions are written here, so that the course needs no library.
 */
#ifndef COMMON_FILES_PNG_H
#define COMMON_FILES_PNG_H

#include "base/bytes.h"
#include "base/error.h"
#include "tgaimage.h"

#include <stdbool.h>
#include <stddef.h>

/* Do the bytes begin as a PNG file does? */
bool png_has_signature(const void *data, size_t size);

/* Read grey and palette (BGR) of 1, 2, 4 or 8 bits, grey+alpha (becomes BGRA), RGB and RGBA;
 * channels of 16 bits are rounded to 8; a tRNS chunk gives BGRA; a palette index without a colour
 * is black. An animation gives its first frame. What no pixel needs may be wrong or missing: tRNS
 * and palettes, compressed data behind the last pixel, the end. Every length and Huffman code is
 * checked, and the checksum of every chunk that a picture needs; memory stays within what the
 * file's size can decode to (and
 * image_check_size()). `image` is overwritten, not freed; empty on an error. */
bool png_decode(struct image *image, const void *data, size_t size, struct error *error);

/* Write grey, RGB or RGBA, 8 bits a channel, with a row filter chosen for each row (none for
 * images of flat areas). Appends to out. */
bool png_encode(const struct image *image, struct bytes *out, struct error *error);
bool png_write(const struct image *image, const char *path, struct error *error);

/* An animation of `count` images of one size and format, each shown for `delay_ms` milliseconds
 * (1..65535), forever. A viewer without APNG shows the first. Frames after the first hold only the
 * rectangle that changed. */
bool apng_encode(const struct image *frames, size_t count, unsigned delay_ms, struct bytes *out,
                 struct error *error);
bool apng_write(const struct image *frames, size_t count, unsigned delay_ms, const char *path,
                struct error *error);

#endif
