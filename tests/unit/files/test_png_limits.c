/*
 * What images and PNG files refuse, and the seldom ways through them: one row for each rule of the
 * specification about the order and size of chunks that test_png.c does not hold. Files are put
 * together here, with checksums that share nothing with the code under test.
 */
#include "files/deflate.h"
#include "files/png.h"
#include "unit/unit.h"

#include <stdlib.h>

/* ---- PNG files of one pixel ---- */

static void put(struct bytes *file, const void *data, size_t size) {
    CHECK(bytes_append(file, data, size));
}

static void put_32(struct bytes *file, uint32_t value) {
    const uint8_t bytes[4] = {(uint8_t)(value >> 24), (uint8_t)(value >> 16 & 255),
                              (uint8_t)(value >> 8 & 255), (uint8_t)(value & 255)};
    put(file, bytes, sizeof bytes);
}

/* Bit by bit, as the specification's annex D defines it. */
static uint32_t slow_crc(const uint8_t *data, size_t size) {
    uint32_t crc = 0xffffffffu;
    for (size_t i = 0; i < 8 * size; i++) {
        uint32_t bit = ((uint32_t)data[i / 8] >> i % 8 ^ crc) & 1;
        crc = bit != 0 ? crc >> 1 ^ 0xedb88320u : crc >> 1;
    }
    return ~crc;
}

static void put_chunk(struct bytes *file, const char *type, const void *data, size_t size) {
    put_32(file, (uint32_t)size);
    size_t start = file->size;
    put(file, type, 4);
    put(file, data, size);
    put_32(file, slow_crc(file->data + start, size + 4));
}

/* One row as a stored block: its filter 0 and `size` bytes. */
static void put_pixel(struct bytes *file, const uint8_t *pixel, size_t size) {
    uint8_t stream[32] = {0x78, 0x01, 1, (uint8_t)(size + 1), 0, (uint8_t) ~(size + 1), 255, 0};
    uint32_t a = 1, b = 1; /* Adler-32 after the filter byte: a stays 1 */
    memcpy(stream + 8, pixel, size);
    for (size_t i = 0; i < size; i++) {
        a += pixel[i];
        b += a;
    }
    const uint8_t check[4] = {(uint8_t)(b >> 8), (uint8_t)(b & 255), (uint8_t)(a >> 8),
                              (uint8_t)(a & 255)};
    memcpy(stream + 8 + size, check, sizeof check);
    put_chunk(file, "IDAT", stream, 12 + size);
}

/* Chunks by letter and number of bytes: H header, P palette, T tRNS, D pixel, E end, o optional, X
 * unknown. All bytes are 0 but those of the header and the pixel. */
static struct bytes make_file(const uint8_t header[5], const char *chunks, const uint8_t *pixel) {
    static const uint8_t signature[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    static const uint8_t zeros[800];
    struct bytes file = {0};
    put(&file, signature, sizeof signature);
    for (const char *c = chunks; *c != '\0';) {
        char letter = *c++;
        size_t size = 0;
        for (; *c >= '0' && *c <= '9'; c++) {
            size = size * 10 + (size_t)(*c - '0');
        }
        uint8_t whole[14] = {[3] = 1, [7] = 1}; /* 1x1 */
        memcpy(whole + 8, header, 5);
        switch (letter) {
        case 'H':
            put_chunk(&file, "IHDR", whole, size);
            break;
        case 'P':
            put_chunk(&file, "PLTE", zeros, size);
            break;
        case 'T':
            put_chunk(&file, "tRNS", zeros, size);
            break;
        case 'D':
            put_pixel(&file, pixel, size);
            break;
        case 'o':
            put_chunk(&file, "tEXt", zeros, size);
            break;
        case 'X':
            put_chunk(&file, "ABCD", zeros, size);
            break;
        default:
            put_chunk(&file, "IEND", zeros, size);
            break;
        }
    }
    return file;
}

static void test_chunks(void) {
    static const struct {
        const char *name, *chunks, *message; /* NULL: it can be read */
        uint8_t header[5]; /* depth, colour type, compression, filter, interlace */
    } rows[] = {
        {"RGB", "H13D3E", NULL, {8, 2, 0, 0, 0}},
        {"a palette that only suggests colours", "H13P768D3E", NULL, {8, 2, 0, 0, 0}},
        {"an optional chunk", "H13o5D3o0E", NULL, {8, 2, 0, 0, 0}},
        {"a header of 12 bytes", "H12D3E", "begin with a header", {8, 2, 0, 0, 0}},
        {"a header of 14 bytes", "H14D3E", "begin with a header", {8, 2, 0, 0, 0}},
        {"no header", "o0D3E", "begin with a header", {8, 2, 0, 0, 0}},
        {"compression 1", "H13D3E", "compression or filter method", {8, 2, 1, 0, 0}},
        {"filter method 1", "H13D3E", "compression or filter method", {8, 2, 0, 1, 0}},
        {"colour type 5", "H13D3E", "colour type, 5", {8, 5, 0, 0, 0}},
        {"grey with a palette", "H13P3D1E", "palette in the wrong place", {8, 0, 0, 0, 0}},
        {"grey and alpha with a palette", "H13P3D2E", "palette in the wrong", {8, 4, 0, 0, 0}},
        {"an empty palette", "H13P0D1E", "palette of 0 bytes", {8, 3, 0, 0, 0}},
        {"257 colours", "H13P771D3E", "palette of 771 bytes", {8, 2, 0, 0, 0}},
        {"tRNS before the palette", "H13T6P3D3E", "palette in the wrong", {8, 2, 0, 0, 0}},
        {"a palette after the pixels", "H13D3P3E", "palette in the wrong", {8, 2, 0, 0, 0}},
        {"tRNS of grey and alpha", "H13T2D2E", "tRNS chunk in the wrong", {8, 4, 0, 0, 0}},
        {"tRNS of RGBA", "H13T6D4E", "tRNS chunk in the wrong", {8, 6, 0, 0, 0}},
        {"tRNS twice", "H13T6T6D3E", "tRNS chunk in the wrong", {8, 2, 0, 0, 0}},
        {"tRNS after the pixels", "H13D3T6E", "tRNS chunk in the wrong", {8, 2, 0, 0, 0}},
        {"tRNS of a palette, empty", "H13P3T0D1E", "tRNS chunk of 0 bytes", {8, 3, 0, 0, 0}},
        {"tRNS of RGB, too short", "H13T5D3E", "tRNS chunk of 5 bytes", {8, 2, 0, 0, 0}},
        {"an end with contents", "H13D3E1", "without pixel data", {8, 2, 0, 0, 0}},
        {"pixels in two parts", "H13D3o1D3E", "between its pixel data", {8, 2, 0, 0, 0}},
        {"an unknown chunk at the end", "H13D3XE", "unknown chunk, ABCD", {8, 2, 0, 0, 0}},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        static const uint8_t pixel[4] = {0, 0, 0, 0};
        struct image image;
        struct error error = {0};
        struct bytes file = make_file(rows[i].header, rows[i].chunks, pixel);
        bool done = png_decode(&image, file.data, file.size, &error);
        CHECK_ROW(done == (rows[i].message == NULL), rows[i].name);
        CHECK_ROW(done == (image.pixels != NULL), rows[i].name);
        if (!done && rows[i].message != NULL) {
            CHECK_ROW(strstr(error.message, rows[i].message) != NULL, rows[i].name);
        }
        image_free(&image);
        bytes_free(&file);
    }
}

/* The tRNS colour is black: a pixel is clear only where all three channels are. */
static void test_clear_color(void) {
    static const struct {
        uint8_t pixel[3];
        uint8_t alpha;
    } rows[] = {{{0, 0, 0}, 0}, {{1, 0, 0}, 255}, {{0, 1, 0}, 255}, {{0, 0, 1}, 255}};
    static const uint8_t header[5] = {8, 2, 0, 0, 0};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct image image;
        struct error error;
        struct bytes file = make_file(header, "H13T6D3E", rows[i].pixel);
        if (CHECK(png_decode(&image, file.data, file.size, &error))) {
            struct color color = image_get(&image, 0, 0);
            CHECK(color.r == rows[i].pixel[0] && color.g == rows[i].pixel[1]);
            CHECK(color.b == rows[i].pixel[2] && color.a == rows[i].alpha);
        }
        image_free(&image);
        bytes_free(&file);
    }
}

/* A length with the highest bit set is refused whatever the size of the file. */
static void test_huge_length(void) {
    static const uint8_t header[5] = {8, 2, 0, 0, 0};
    struct bytes file = make_file(header, "H13D3E", header);
    struct image image;
    struct error error;
    file.data[8] = 0x80;
    CHECK(!png_decode(&image, file.data, file.size, &error) && image.pixels == NULL);
    CHECK(strstr(error.message, "claims 2147483661 bytes") != NULL);
    bytes_free(&file);
}

/* A square PNG of 1 bit a pixel; `noise` bytes of it are not black. */
static struct bytes make_square(uint32_t side, size_t noise) {
    static const uint8_t signature[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    uint8_t header[13] = {0, 0, (uint8_t)(side >> 8), (uint8_t)(side & 255),
                          0, 0, (uint8_t)(side >> 8), (uint8_t)(side & 255),
                          1};
    size_t row = 1 + (side + 7) / 8, size = side * row;
    uint8_t *rows = calloc(size, 1);
    struct bytes file = {0}, stream = {0};
    struct error error;
    uint32_t state = 1;
    for (size_t i = 0; CHECK(rows != NULL) && i < noise; i++) {
        state = state * 1664525u + 1013904223u;
        rows[i + 1 + i / (row - 1)] = (uint8_t)(state >> 24); /* never a row's filter */
    }
    CHECK(zlib_compress(rows, size, &stream, &error));
    put(&file, signature, sizeof signature);
    put_chunk(&file, "IHDR", header, sizeof header);
    put_chunk(&file, "IDAT", stream.data, stream.size);
    put_chunk(&file, "IEND", NULL, 0);
    bytes_free(&stream);
    free(rows);
    return file;
}

/* 16 million pixels may stand in any file; more, only where there are as many bytes as could hold
 * them when each had one. */
static void test_limit_of_pixels(void) {
    static const struct {
        uint32_t side;
        size_t noise;
        const char *message;
    } rows[] = {
        {4096, 0, NULL},
        {4097, 0, "a PNG of 4097x4097 pixels in no more than "},
        {4097, 10000, "a PNG of 4097x4097 pixels in no more than "},
        {4097, 17000, NULL}, /* 4097 * 4097 / 1032 = 16265 */
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct bytes file = make_square(rows[i].side, rows[i].noise);
        struct image image;
        struct error error = {0};
        CHECK(png_decode(&image, file.data, file.size, &error) == (rows[i].message == NULL));
        CHECK(rows[i].message == NULL || strstr(error.message, rows[i].message) != NULL);
        image_free(&image);
        bytes_free(&file);
    }
}

/* ---- Images ---- */

static void test_empty_images(void) {
    struct image empty = {0}, copy = {.width = 7};
    struct bytes out = {0};
    struct error error = {0};
    CHECK(image_copy(&copy, &empty, &error));
    CHECK(copy.width == 0 && copy.height == 0 && copy.pixels == NULL);
    CHECK(!png_encode(&empty, &out, &error) && out.size == 0);
    CHECK_TEXT(error.message, "an empty image cannot be written");
}

/* Frames that are not alike, delays that the file cannot hold. */
static void test_animations(void) {
    struct image frames[2], other;
    struct bytes out = {0};
    struct error error = {0};
    CHECK(image_create(&frames[0], 3, 2, IMAGE_BGR, &error));
    CHECK(apng_encode(frames, 1, 1, &out, &error));
    CHECK(apng_encode(frames, 1, 65535, &out, &error));
    bytes_free(&out);
    CHECK(!apng_encode(frames, 1, 0, &out, &error));
    CHECK_TEXT(error.message, "an animation cannot have 1 frames of 0 ms");
    CHECK(!apng_encode(frames, 1, 65536, &out, &error));
    CHECK(!apng_encode(frames, 0, 40, &out, &error));
    static const struct {
        size_t width, height;
        enum image_format format;
    } rows[] = {{4, 2, IMAGE_BGR}, {3, 3, IMAGE_BGR}, {3, 2, IMAGE_BGRA}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        CHECK(image_create(&other, rows[i].width, rows[i].height, rows[i].format, &error));
        frames[1] = other;
        CHECK(!apng_encode(frames, 2, 40, &out, &error));
        CHECK_TEXT(error.message, "frame 1 of an animation is not like the first");
        image_free(&other);
    }
    frames[1] = (struct image){0};
    CHECK(!apng_encode(frames, 2, 40, &out, &error) && out.size == 0);
    image_free(&frames[0]);
}

UNIT_MAIN(TEST(test_chunks), TEST(test_clear_color), TEST(test_huge_length),
          TEST(test_limit_of_pixels), TEST(test_empty_images), TEST(test_animations))
