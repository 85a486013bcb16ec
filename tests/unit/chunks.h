/* For tests of PNG: chunks put together byte by byte from the specification, with checksums that
 * share nothing with the code under test. */
#ifndef TESTS_UNIT_CHUNKS_H
#define TESTS_UNIT_CHUNKS_H

#include "unit/images.h"

static const uint8_t signature[8] = {137, 80, 78, 71, 13, 10, 26, 10};

static inline uint32_t get_32(const uint8_t *bytes) {
    return (uint32_t)bytes[0] << 24 | (uint32_t)bytes[1] << 16 | (uint32_t)bytes[2] << 8 | bytes[3];
}

static inline void put_32(struct bytes *out, uint32_t value) {
    for (unsigned shift = 32; shift > 0; shift -= 8) {
        put(out, value >> (shift - 8) & 255);
    }
}

/* Bit by bit (annex D). */
static inline uint32_t slow_crc(const uint8_t *data, size_t size) {
    uint32_t crc = 0xffffffffu;
    for (size_t i = 0; i < 8 * size; i++) {
        uint32_t bit = ((uint32_t)data[i / 8] >> i % 8 ^ crc) & 1;
        crc = bit != 0 ? crc >> 1 ^ 0xedb88320u : crc >> 1;
    }
    return ~crc;
}

static inline void put_chunk(struct bytes *file, const char *type, const void *data, size_t size) {
    put_32(file, (uint32_t)size);
    size_t start = file->size;
    CHECK(bytes_append(file, type, 4) && bytes_append(file, data, size));
    put_32(file, slow_crc(file->data + start, size + 4));
}

/* Signature and IHDR. */
static inline void put_header(struct bytes *file, uint32_t width, uint32_t height, unsigned depth,
                              unsigned color_type, unsigned interlace) {
    const uint8_t rest[] = {(uint8_t)depth, (uint8_t)color_type, 0, 0, (uint8_t)interlace};
    struct bytes header = {0};
    put_32(&header, width);
    put_32(&header, height);
    CHECK(bytes_append(&header, rest, sizeof rest));
    CHECK(bytes_append(file, signature, sizeof signature));
    put_chunk(file, "IHDR", header.data, header.size);
    bytes_free(&header);
}

#endif
