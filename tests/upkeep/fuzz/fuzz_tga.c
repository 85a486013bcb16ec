/*
 * TGA and PPM files of any bytes. What can be read is a valid image; written again, as TGA and as
 * PNG, it has the same pixels; it can become a texture. What cannot be read leaves an empty image
 * and a message. Either way memory stays within what the file's size justifies.
 */
#include "files/image_file.h"
#include "fuzz.h"
#include "image_properties.h"

/* A packet of two bytes gives at most 128 pixels of 4 bytes (a colour map with alpha). */
enum { TGA_GROWTH = 256 };
enum { SLOW_SIZE = 1 << 16 }; /* pixels; larger images are only read */

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    struct error error = no_error();
    struct image image;
    if (png_has_signature(data, size)) {
        return 0; /* fuzz_png.c has these */
    }
    memory_begin();
    bool done = image_decode(&image, data, size, &error);
    require_memory(size, TGA_GROWTH);
    if (!done) {
        require_empty_image(&image);
        require_message(&error);
        return 0;
    }
    require_valid_image(&image);
    if (image.width * image.height <= SLOW_SIZE) {
        require_tga_round_trip(&image);
        require_png_round_trip(&image);
        require_texture(&image);
    }
    image_free(&image);
    return 0;
}
