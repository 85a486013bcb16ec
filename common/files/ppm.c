/* PPM and PGM in and out; see ppm.h. */
#include "files/ppm.h"

#include "base/file.h"
#include "base/text.h"

#include <stdint.h>
#include <string.h>

/* ---- Reading ---- */

bool ppm_is_possible(const void *data, size_t size) {
    const char *bytes = data;
    return size > 2 && bytes[0] == 'P' && memchr("2356", bytes[1], 4) != NULL &&
           memchr(" \t\r\n#", bytes[2], 5) != NULL;
}

/* The next number, of at most 65535, behind blanks, lines and comments. */
static bool next_number(struct text *text, int64_t *number) {
    struct word word = text_next_word(text);
    while (word.length == 0 && text_next_line(text)) {
        word = text_next_word(text);
    }
    const char *comment = word.length > 0 ? memchr(word.start, '#', word.length) : NULL;
    if (comment != NULL) { /* it needs no blank before it, and ends the line */
        word.length = (size_t)(comment - word.start);
        text->next = comment;
        (void)text_find_word(text);
    }
    return word_to_integer(word, number) && *number >= 0 && *number <= UINT16_MAX;
}

bool ppm_decode(struct image *image, const void *data, size_t size, struct error *error) {
    const char *bytes = data;
    const bool is_text = bytes[1] < '4', is_grey = bytes[1] == '2' || bytes[1] == '5';
    const size_t step = is_grey ? 1 : 3;
    struct text text;
    int64_t width, height, most, sample;
    *image = (struct image){0};
    text_peek(&text, bytes + 2, size - 2);
    if (!next_number(&text, &width) || !next_number(&text, &height) || !next_number(&text, &most) ||
        most == 0 || text.next == text.end) {
        return error_set(error, "a PPM without a width, a height and a greatest value");
    }
    const uint8_t *next = (const uint8_t *)text.next + 1;
    const size_t sample_size = is_text || most > 255 ? 2 : 1; /* a number has a blank behind it */
    const size_t w = (size_t)width, h = (size_t)height, count = w * h * step;
    if (count * sample_size >= (size_t)(text.end - text.next) + is_text) {
        return error_set(error, "a PPM cut off: %zux%zu pixels do not fit in %zu bytes", w, h,
                         size);
    }
    if (!image_create_unset(image, w, h, (enum image_format)step, error)) {
        return false;
    }
    for (size_t i = 0; i < count; i++) {
        sample = 0;
        for (size_t k = 0; !is_text && k < sample_size; k++) {
            sample = sample << 8 | *next++;
        }
        if (is_text && !next_number(&text, &sample)) {
            image_free(image);
            return error_set(error, "a PPM whose samples are no numbers, or too few");
        }
        const size_t row = h - 1 - i / step / w, x = i / step % w; /* the top comes first */
        image->pixels[(row * w + x) * step + (step - 1 - i % step)] =
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
