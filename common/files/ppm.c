/* PPM and PGM in and out; see ppm.h. */
#include "files/ppm.h"
#include "base/file.h"

#include <stdint.h>
#include <string.h>

/* ---- Reading ---- */

bool ppm_is_possible(const void *data, size_t size) {
    const char *bytes = data;
    return size > 2 && bytes[0] == 'P' && memchr("2356", bytes[1], 4) != NULL &&
           memchr(" \t\r\n#", bytes[2], 5) != NULL;
}

/* The bytes that are not yet read. */
struct source {
    const uint8_t *next, *end;
};

/* A number behind blanks and comments, of at most 65535. */
static bool next_number(struct source *source, unsigned *number) {
    bool comment = false, any = false;
    const uint8_t *p = source->next;
    for (; p < source->end && (comment || *p == '#' || memchr(" \t\r\n", *p, 4) != NULL); p++) {
        comment = (comment || *p == '#') && *p != '\n';
    }
    *number = 0;
    for (; p < source->end && *p >= '0' && *p <= '9' && *number <= UINT16_MAX; p++, any = true) {
        *number = 10 * *number + (*p - (unsigned)'0');
    }
    source->next = p;
    return any && *number <= UINT16_MAX;
}

bool ppm_decode(struct image *image, const void *data, size_t size, struct error *error) {
    const uint8_t *bytes = data;
    struct source source = {bytes + 2, bytes + size};
    const bool is_text = bytes[1] < '4', is_grey = bytes[1] == '2' || bytes[1] == '5';
    const size_t step = is_grey ? 1 : 3;
    unsigned width, height, most;
    *image = (struct image){0};
    if (!next_number(&source, &width) || !next_number(&source, &height) ||
        !next_number(&source, &most) || most == 0 || source.next == source.end) {
        return error_set(error, "a PPM without a width, a height and a greatest value");
    }
    const unsigned sample_size = is_text || most > 255 ? 2 : 1; /* a number has a blank behind it */
    const uint64_t count = (uint64_t)width * height * step,
                   left = (uint64_t)(source.end - source.next);
    if (count * sample_size >= left + is_text) {
        return error_set(error, "a PPM cut off: %ux%u pixels do not fit in %zu bytes", width,
                         height, size);
    }
    if (!image_create_unset(image, width, height, (enum image_format)step, error)) {
        return false;
    }
    source.next++;
    for (size_t i = 0; i < count; i++) {
        unsigned sample = 0;
        for (unsigned k = 0; !is_text && k < sample_size; k++) {
            sample = sample << 8 | *source.next++;
        }
        if (is_text && !next_number(&source, &sample)) {
            image_free(image);
            return error_set(error, "a PPM whose samples are no numbers, or too few");
        }
        const size_t pixel = i / step, row = height - 1 - pixel / width; /* the top comes first */
        image->pixels[(row * width + pixel % width) * step + (step - 1 - i % step)] =
            (uint8_t)(((sample < most ? sample : most) * 255 + most / 2) / most);
    }
    return true;
}

/* ---- Writing ---- */

bool ppm_encode(const struct image *image, struct bytes *out, struct error *error) {
    const size_t step = (size_t)image->format, samples = image->format == IMAGE_GREY ? 1 : 3;
    const size_t start = out->size, row = image->width * step;
    if (image->pixels == NULL) {
        return error_set(error, "an empty image cannot be written");
    }
    if (!bytes_print(out, "P%d\n%zu %zu\n255\n", samples == 1 ? 5 : 6, image->width,
                     image->height) ||
        !bytes_reserve(out, image->width * image->height * samples)) {
        out->size = start;
        return error_out_of_memory(error);
    }
    for (size_t y = image->height; y-- > 0;) {
        for (size_t x = 0; x < row; x += step) {
            for (size_t i = samples; i-- > 0;) { /* red first */
                out->data[out->size++] = image->pixels[y * row + x + i];
            }
        }
    }
    return true;
}

bool ppm_write(const struct image *image, const char *path, struct error *error) {
    struct bytes out = {0};
    bool encoded = ppm_encode(image, &out, error);
    return file_write_encoded(path, encoded, &out, error);
}
