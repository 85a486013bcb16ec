/* PPM and PGM out; see ppm.h. */
#include "files/ppm.h"
#include "base/file.h"

#include <stdint.h>

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
