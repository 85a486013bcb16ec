/* PPM and PGM out; see ppm.h. */
#include "files/ppm.h"
#include "base/file.h"

#include <stdint.h>

/* One pixel as bytes, red first. */
static size_t store_rgb(const uint8_t *pixel, enum image_format format, uint8_t *out) {
    if (format == IMAGE_GREY) {
        out[0] = pixel[0];
        return 1;
    }
    out[0] = pixel[2];
    out[1] = pixel[1];
    out[2] = pixel[0];
    return 3;
}

bool ppm_encode(const struct image *image, struct bytes *out, struct error *error) {
    const bool grey = image->format == IMAGE_GREY;
    const size_t start = out->size, row = image->width * (size_t)image->format;
    if (image->pixels == NULL) {
        return error_set(error, "an empty image cannot be written");
    }
    if (!bytes_print(out, "P%d\n%zu %zu\n255\n", grey ? 5 : 6, image->width, image->height) ||
        !bytes_reserve(out, image->width * image->height * (grey ? 1 : 3))) {
        out->size = start;
        return error_out_of_memory(error);
    }
    for (size_t y = image->height; y-- > 0;) {
        for (size_t x = 0; x < row; x += (size_t)image->format) {
            const uint8_t *pixel = image->pixels + y * row + x;
            out->size += store_rgb(pixel, image->format, out->data + out->size);
        }
    }
    return true;
}

bool ppm_write(const struct image *image, const char *path, struct error *error) {
    struct bytes out = {0};
    bool encoded = ppm_encode(image, &out, error);
    return file_write_encoded(path, encoded, &out, error);
}
