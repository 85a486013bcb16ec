/* For tests of files and images: noise, memory, bytes put one after the other, images compared. */
#ifndef TESTS_UNIT_IMAGES_H
#define TESTS_UNIT_IMAGES_H

#include "base/bytes.h"
#include "texture.h"
#include "tgaimage.h"
#include "unit/unit.h"

#include <stdlib.h>

static inline uint32_t next_random(uint32_t *state) {
    *state = *state * 1664525u + 1013904223u;
    return *state >> 8;
}

/* Just so many bytes, all 0, so that the address sanitizer sees what is read or written past them.
 * The caller frees them. */
static inline void *new_memory(size_t size) {
    void *memory = calloc(size + (size == 0), 1);
    if (memory == NULL) {
        perror("calloc");
        exit(1);
    }
    return memory;
}

static inline void *exact_copy(const void *data, size_t size) {
    void *copy = new_memory(size);
    if (size > 0) {
        memcpy(copy, data, size);
    }
    return copy;
}

typedef bool image_decoder(struct image *image, const void *data, size_t size, struct error *error);

/* Decode from memory of just this size. */
static inline bool decode_exact(image_decoder *decode, struct image *image, const uint8_t *data,
                                size_t size, struct error *error) {
    uint8_t *copy = exact_copy(data, size);
    error->message[0] = '\0';
    bool done = decode(image, copy, size, error);
    CHECK(done == (image->pixels != NULL));
    CHECK(done || error->message[0] != '\0');
    free(copy);
    return done;
}

static inline void put(struct bytes *out, unsigned value) {
    uint8_t byte = (uint8_t)(value & 255);
    CHECK(bytes_append(out, &byte, 1));
}

/* The checksum of a zlib stream, by its definition. */
static inline uint32_t slow_adler(const uint8_t *data, size_t size) {
    uint32_t a = 1, b = 0;
    for (size_t i = 0; i < size; i++) {
        a = (a + data[i]) % 65521;
        b = (b + a) % 65521;
    }
    return b * 65536 + a;
}

/* A black image, which the caller frees. */
static inline struct image new_image(size_t width, size_t height, enum image_format format) {
    struct image image;
    struct error error;
    if (!image_create(&image, width, height, format, &error)) {
        fprintf(stderr, "%s\n", error.message);
        exit(1);
    }
    return image;
}

/* An image of so many levels, at least 2, in no order; the caller frees it. */
static inline struct image random_image(size_t width, size_t height, enum image_format format,
                                        uint32_t levels, uint32_t *state) {
    struct image image = new_image(width, height, format);
    for (size_t i = 0; i < width * height * (size_t)format; i++) {
        image.pixels[i] = (uint8_t)(next_random(state) % levels * 255 / (levels - 1));
    }
    return image;
}

/* A texture of such an image; the caller frees it. */
static inline bool random_texture(struct texture *texture, size_t width, size_t height,
                                  enum image_format format, uint32_t *state) {
    struct image image = random_image(width, height, format, 256, state);
    struct error error;
    bool done = CHECK(texture_create(texture, &image, &error));
    image_free(&image);
    return done;
}

/* Of its own, with the same pixels; the caller frees it. */
static inline struct image copy_of(const struct image *image) {
    struct image copy = new_image(image->width, image->height, image->format);
    memcpy(copy.pixels, image->pixels, image->width * image->height * (size_t)image->format);
    return copy;
}

static inline bool same_image(const struct image *a, const struct image *b) {
    return a->width == b->width && a->height == b->height && a->format == b->format &&
           memcmp(a->pixels, b->pixels, a->width * a->height * (size_t)a->format) == 0;
}

static inline bool same_color(struct color a, struct color b) {
    return a.r == b.r && a.g == b.g && a.b == b.b && a.a == b.a;
}

#endif
