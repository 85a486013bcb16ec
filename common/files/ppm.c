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

static bool append_header(struct bytes *out, const struct image *image) {
    int kind = image->format == IMAGE_GREY ? 5 : 6;
    return bytes_print(out, "P%d\n%zu %zu\n255\n", kind, image->width, image->height);
}

static bool append_row(struct bytes *out, const struct image *image, size_t y) {
    enum { BYTES_LIMIT = 3 }; /* of a pixel */
    size_t step = (size_t)image->format;
    const uint8_t *pixel = image->pixels + y * image->width * step;
    if (!bytes_reserve(out, image->width * BYTES_LIMIT)) {
        return false;
    }
    for (size_t x = 0; x < image->width; x++, pixel += step) {
        out->size += store_rgb(pixel, image->format, out->data + out->size);
    }
    return true;
}

bool ppm_encode(const struct image *image, struct bytes *out, struct error *error) {
    if (image->pixels == NULL) {
        return error_set(error, "an empty image cannot be written");
    }
    size_t start = out->size;
    bool done = append_header(out, image);
    for (size_t y = image->height; done && y-- > 0;) {
        done = append_row(out, image, y);
    }
    if (!done) {
        out->size = start;
        return error_out_of_memory(error);
    }
    return true;
}

bool ppm_write(const struct image *image, const char *path, struct error *error) {
    struct bytes out = {0};
    bool encoded = ppm_encode(image, &out, error);
    return file_write_encoded(path, encoded, &out, error);
}
