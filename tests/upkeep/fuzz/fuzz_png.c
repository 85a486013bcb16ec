/*
 * PNG, in four ways that the first byte chooses:
 *
 *   0x89   a PNG file of any bytes; then once more with the checksums of its chunks made right, so
 *          that what comes after them is reached
 *   0x78   a zlib stream, without a PNG around it, for a number of bytes that its last two tell
 *   even   the bytes are pixels: written as PNG and read again they are the same
 *   odd    the bytes are a header and rows before compression: a file with right checksums and
 *          every depth, colour type, palette and row filter
 *
 * What can be read is a valid image and survives being written and read again.
 */
#include "files/deflate.h"
#include "fuzz.h"
#include "image_properties.h"
#include "unit/chunks.h"

/* Deflate makes at most 1032 bytes of one; one such byte may hold 8 pixels of 4 bytes, once as rows
 * and once as an image. */
enum { PNG_GROWTH = 1032 * (1 + 8 * 4) + 8 };
enum { SLOW_SIZE = 1 << 16 }; /* pixels; larger images are only read */

static bool decode(const uint8_t *data, size_t size) {
    struct error error = no_error();
    struct image image;
    memory_begin();
    bool done = png_decode(&image, data, size, &error);
    require_memory(size, PNG_GROWTH);
    if (!done) {
        require_empty_image(&image);
        require_message(&error);
        return false;
    }
    require_valid_image(&image);
    if (image.width * image.height <= SLOW_SIZE) {
        require_png_round_trip(&image);
        require_tga_round_trip(&image);
    }
    image_free(&image);
    return true;
}

static void repair_checksums(uint8_t *file, size_t size) {
    for (size_t at = sizeof signature; size - at >= 12;) {
        uint32_t length = get_32(file + at);
        if (length > size - at - 12) {
            return;
        }
        uint32_t crc = slow_crc(file + at + 4, 4 + (size_t)length);
        for (size_t i = 0; i < 4; i++) {
            file[at + 8 + length + i] = (uint8_t)(crc >> (24 - 8 * i));
        }
        at += 12 + length;
    }
}

static void try_file(const uint8_t *data, size_t size) {
    decode(data, size);
    if (size >= sizeof signature) {
        uint8_t *file = malloc(size);
        REQUIRE(file != NULL);
        memcpy(file, data, size);
        repair_checksums(file, size);
        decode(file, size);
        free(file);
    }
}

/* Byte 1: width, byte 2: format; pixels from byte 3. */
static void try_pixels(const uint8_t *data, size_t size) {
    static const enum image_format formats[] = {IMAGE_GREY, IMAGE_BGR, IMAGE_BGRA};
    struct error error = no_error();
    struct image image;
    if (size < 4) {
        return;
    }
    size_t width = (size_t)data[1] + 1;
    enum image_format format = formats[data[2] % 3];
    size_t height = (size - 3) / (width * (size_t)format);
    if (height == 0) {
        return;
    }
    REQUIRE(image_create(&image, width, height, format, &error));
    memcpy(image.pixels, data + 3, bytes_of_pixels(&image));
    require_png_round_trip(&image);
    require_tga_round_trip(&image);
    image_free(&image);
}

/* Bytes 1, 2: width, height; 3: depth; 4: colour type, and 128 more where it is interlaced;
 * 5: colours of the palette; 6: bytes of the
 * tRNS chunk; then the palette, the tRNS chunk, and rows. */
static void try_rows(const uint8_t *data, size_t size) {
    enum { HEADER = 7 };
    struct error error = no_error();
    if (size < HEADER) {
        return;
    }
    size_t palette_size = 3 * (size_t)data[5], clear_size = data[6];
    if (size - HEADER < palette_size + clear_size) {
        return;
    }
    const uint8_t *palette = data + HEADER, *clear = palette + palette_size;
    const uint8_t *rows = clear + clear_size;
    struct bytes file = {0}, pixels = {0};
    REQUIRE(zlib_compress(rows, (size_t)(data + size - rows), &pixels, &error));
    put_header(&file, data[1], data[2], data[3], data[4] & 127, data[4] >> 7);
    if (palette_size > 0) {
        put_chunk(&file, "PLTE", palette, palette_size);
    }
    if (clear_size > 0) {
        put_chunk(&file, "tRNS", clear, clear_size);
    }
    put_chunk(&file, "IDAT", pixels.data, pixels.size);
    put_chunk(&file, "IEND", NULL, 0);
    decode(file.data, file.size);
    bytes_free(&file);
    bytes_free(&pixels);
}

/* The checksum at the end need not be right: what comes before it is what is tried. The block is
 * just as large as it must be, so that the address sanitizer sees a byte too far. */
static void try_stream(const uint8_t *data, size_t size) {
    struct error error = no_error();
    if (size < 4) {
        return;
    }
    size_t out_size = 1 + (data[size - 2] | (size_t)(data[size - 1] & 15) << 8);
    uint8_t *stream = malloc(size - 2), *out = malloc(out_size);
    REQUIRE(stream != NULL && out != NULL);
    memcpy(stream, data, size - 2);
    if (!zlib_decompress(stream, size - 2, out, out_size, &error)) {
        require_message(&error);
    }
    free(stream);
    free(out);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    if (size == 0 || data[0] == signature[0]) {
        try_file(data, size);
    } else if (data[0] == 0x78) {
        try_stream(data, size);
    } else if (data[0] % 2 == 0) {
        try_pixels(data, size);
    } else {
        try_rows(data, size);
    }
    return 0;
}
