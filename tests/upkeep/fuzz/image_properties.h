/* What must hold of every image that a reader returns; for the fuzz targets of TGA and PNG. */
#ifndef TESTS_UPKEEP_FUZZ_IMAGE_PROPERTIES_H
#define TESTS_UPKEEP_FUZZ_IMAGE_PROPERTIES_H

#include "files/png.h"
#include "fuzz.h"
#include "texture.h"
#include "tgaimage.h"

static inline size_t bytes_of_pixels(const struct image *image) {
    return image->width * image->height * (size_t)image->format;
}

static inline void require_same_image(const struct image *a, const struct image *b) {
    REQUIRE(a->width == b->width && a->height == b->height && a->format == b->format);
    REQUIRE(memcmp(a->pixels, b->pixels, bytes_of_pixels(a)) == 0);
}

static inline void require_empty_image(const struct image *image) {
    REQUIRE(image->pixels == NULL && image->width == 0 && image->height == 0);
}

static inline void require_valid_image(const struct image *image) {
    REQUIRE(image->width >= 1 && image->width <= IMAGE_SIZE_LIMIT);
    REQUIRE(image->height >= 1 && image->height <= IMAGE_SIZE_LIMIT);
    REQUIRE(image->format == IMAGE_GREY || image->format == IMAGE_BGR ||
            image->format == IMAGE_BGRA);
    REQUIRE(image->pixels != NULL);
}

/* Written and read again, the pixels are the same. */
static inline void require_tga_round_trip(const struct image *image) {
    struct error error = no_error();
    struct bytes file = {0};
    struct image again;
    REQUIRE(tga_encode(image, &file, &error));
    REQUIRE(file.size <= bytes_of_pixels(image) + 18 + 26); /* header, footer, never larger */
    REQUIRE(tga_decode(&again, file.data, file.size, &error));
    require_same_image(image, &again);
    image_free(&again);
    bytes_free(&file);
}

static inline void require_png_round_trip(const struct image *image) {
    struct error error = no_error();
    struct bytes file = {0};
    struct image again;
    REQUIRE(png_encode(image, &file, &error));
    REQUIRE(png_decode(&again, file.data, file.size, &error));
    require_same_image(image, &again);
    image_free(&again);
    bytes_free(&file);
}

static inline void require_level(double level) {
    REQUIRE(level >= 0 && level <= 255);
}

/* A texture of the image can be sampled anywhere, and gives levels 0..255. */
static inline void require_texture(const struct image *image) {
    static const double places[] = {0, 1, 0.5, 0.3, -1e300, 1e300, NAN, INFINITY};
    struct error error = no_error();
    struct texture texture;
    REQUIRE(texture_create(&texture, image, &error));
    for (size_t i = 0; i < 8; i++) {
        struct vec2 uv = {places[i], places[(i * 3 + 1) % 8]};
        struct vec4 color = texture_bilinear(&texture, uv, i);
        require_level(color.x);
        require_level(color.y);
        require_level(color.z);
        require_level(color.w);
    }
    texture_free(&texture);
}

#endif
