/* Image files of every format; see image_file.h. */
#include "files/image_file.h"

#include "base/file.h"
#include "files/known.h"
#include "files/png.h"
#include "files/ppm.h"

#include <string.h>

/* ---- Reading ---- */

/* The path, which is not read, is for advice. */
static bool decode_image(struct image *image, const char *path, const void *data, size_t size,
                         struct error *error) {
    if (png_has_signature(data, size)) {
        return png_decode(image, data, size, error);
    }
    if (ppm_is_possible(data, size)) {
        return ppm_decode(image, data, size, error);
    }
    if (tga_is_possible(data, size)) {
        return tga_decode(image, data, size, error);
    }
    *image = (struct image){0};
    if (known_recognize(data, size, path, false, error)) {
        return false;
    }
    return error_set(error, "neither a PNG or PPM nor a TGA of a type that is supported");
}

bool image_decode(struct image *image, const void *data, size_t size, struct error *error) {
    return decode_image(image, "FILE", data, size, error);
}

bool image_read(struct image *image, const char *path, struct error *error) {
    struct bytes file;
    *image = (struct image){0};
    if (!file_read(path, &file, error)) {
        return false;
    }
    bool done =
        decode_image(image, path, file.data, file.size, error) || error_name_file(error, path);
    bytes_free(&file);
    return done;
}

bool image_file_is_readable(struct word ending) {
    return word_matches(ending, "png") || word_matches(ending, "tga") ||
           word_matches(ending, "ppm") || word_matches(ending, "pgm") ||
           word_matches(ending, "pnm");
}

/* ---- Writing ---- */

const struct image_file_format image_file_formats[] = {
    {.name = "tga", .write = tga_write},
    {.name = "png", .write = png_write, .write_frames = apng_write},
    {.name = "ppm", .grey_extension = "pgm", .write = ppm_write},
};
const size_t image_file_format_count = sizeof image_file_formats / sizeof image_file_formats[0];

const struct image_file_format *image_file_format_find(const char *name) {
    for (size_t i = 0; i < image_file_format_count; i++) {
        if (strcmp(image_file_formats[i].name, name) == 0) {
            return &image_file_formats[i];
        }
    }
    return NULL;
}

const char *image_file_extension(const struct image_file_format *format,
                                 const struct image *image) {
    bool grey = image->format == IMAGE_GREY && format->grey_extension != NULL;
    return grey ? format->grey_extension : format->name;
}
