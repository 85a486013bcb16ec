/*
 * Image files of every format: read by what they are, written by the format's name.
 *
 * A new output format is one row of the table in image_file.c, and its writer.
 */
#ifndef COMMON_FILES_IMAGE_FILE_H
#define COMMON_FILES_IMAGE_FILE_H

#include "base/error.h"
#include "base/text.h"
#include "tgaimage.h"

#include <stdbool.h>
#include <stddef.h>

/* ---- Reading ---- */

/* Read a PNG, a PPM or a TGA: the first two begin with a signature, a TGA has none; the file's name
 * does not count. png.h, ppm.h and tgaimage.h say what is read of each. `image` is overwritten, not
 * freed; empty on an error. */
bool image_read(struct image *image, const char *path, struct error *error);

/* Read one of them from memory, as image_read() does from a file; the message names no file. */
bool image_decode(struct image *image, const void *data, size_t size, struct error *error);

/* Does a file whose name ends so hold a picture that is read? In small or capital letters. */
bool image_file_is_readable(struct word ending);

/* ---- Writing ---- */

/* The writers leave no half-written file, and their messages name the file. */
struct image_file_format {
    const char *name;           /* "tga": of the format, and the extension of its files */
    const char *grey_extension; /* of files of grey images, where it is another; else NULL */
    bool (*write)(const struct image *image, const char *path, struct error *error);
    /* Write an animation: `count` images of one size and format, each shown for `delay_ms`
     * milliseconds (1..65535). NULL in a format that cannot move. */
    bool (*write_frames)(const struct image *frames, size_t count, unsigned delay_ms,
                         const char *path, struct error *error);
};

/* All formats; the first is the default. */
extern const struct image_file_format image_file_formats[];
extern const size_t image_file_format_count;

/* The format of that name, or NULL. */
const struct image_file_format *image_file_format_find(const char *name);

/* The extension of the image's file, without the dot. */
const char *image_file_extension(const struct image_file_format *format, const struct image *image);

/* The names of all formats, for help and messages. */
#define IMAGE_FILE_NAMES "tga, png or ppm"

#endif
