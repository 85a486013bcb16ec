/*
 * Deflate, the compression inside PNG files, in both directions.
 *
 * Formats: L. P. Deutsch, "DEFLATE Compressed Data Format Specification version 1.3" (RFC 1951) and
 * L. P. Deutsch, J.-L. Gailly, "ZLIB Compressed Data Format Specification version 3.3" (RFC 1950).
 */
#ifndef COMMON_FILES_DEFLATE_H
#define COMMON_FILES_DEFLATE_H

#include "base/bytes.h"
#include "base/error.h"

#include <stdbool.h>
#include <stddef.h>

/* Deflate makes at most 258 bytes of 2 bits: no stream grows more than this many times. */
enum { DEFLATE_RATIO_LIMIT = 1032 };

/* Compress `size` bytes to a zlib stream at the end of `out`: of noise, one that is larger, by some
 * 30 bytes and 160 for every 16384. On an error (memory) `out` keeps what it held before. */
bool zlib_compress(const void *data, size_t size, struct bytes *out, struct error *error);

/* Decompress a zlib stream that must give `out_size` bytes. Every code, distance and length up to
 * there is checked; all that follows is ignored, even its checksum (a PNG's chunks have their own).
 * On an error `out` is half-filled. */
bool zlib_decompress(const void *data, size_t size, void *out, size_t out_size,
                     struct error *error);

#endif
