/* PPM and PGM out; see ppm.h. */
#include "files/ppm.h"
#include "base/file.h"

#include <stdint.h>
#include <stdio.h>

/* One pixel as text, on a line of its own; returns the number of characters. */
static size_t print_pixel(const uint8_t *pixel, enum image_format format, char *text, size_t room) {
    int count = format == IMAGE_GREY
                    ? snprintf(text, room, "%d\n", pixel[0])
                    : snprintf(text, room, "%d %d %d\n", pixel[2], pixel[1], pixel[0]);
    return (size_t)count;
}

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

static bool append_header(struct bytes *out, const struct image *image, bool plain) {
    char header[32];
    int kind = (image->format == IMAGE_GREY ? 2 : 3) + (plain ? 0 : 3);
    int size =
        snprintf(header, sizeof header, "P%d\n%zu %zu\n255\n", kind, image->width, image->height);
    return bytes_append(out, header, (size_t)size);
}

static bool append_row(struct bytes *out, const struct image *image, size_t y, bool plain) {
    enum { TEXT_LIMIT = 13, BYTES_LIMIT = 3 }; /* of a pixel: "255 255 255\n" and a NUL */
    size_t step = (size_t)image->format;
    const uint8_t *pixel = image->pixels + y * image->width * step;
    if (!bytes_reserve(out, image->width * (plain ? TEXT_LIMIT : BYTES_LIMIT))) {
        return false;
    }
    for (size_t x = 0; x < image->width; x++, pixel += step) {
        uint8_t *next = out->data + out->size;
        out->size += plain ? print_pixel(pixel, image->format, (char *)next, TEXT_LIMIT)
                           : store_rgb(pixel, image->format, next);
    }
    return true;
}

bool ppm_encode(const struct image *image, bool plain, struct bytes *out, struct error *error) {
    if (image->pixels == NULL) {
        return error_set(error, "an empty image cannot be written");
    }
    size_t start = out->size;
    bool done = append_header(out, image, plain);
    for (size_t y = image->height; done && y-- > 0;) {
        done = append_row(out, image, y, plain);
    }
    if (!done) {
        out->size = start;
        return error_out_of_memory(error);
    }
    return true;
}

bool ppm_write(const struct image *image, const char *path, struct error *error) {
    struct bytes out = {0};
    bool encoded = ppm_encode(image, false, &out, error);
    return file_write_encoded(path, encoded, &out, error);
}
