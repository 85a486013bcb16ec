/*
 * Images in memory, and the TGA files that hold them.
 *
 * Pixel (0,0) is the bottom-left one, rows go up, and there is no padding between rows. A pixel is
 * one byte (grey), three (blue, green, red) or four (blue, green, red, alpha), as TGA stores them.
 * Files are written with the bottom-left origin, so nothing is flipped only to be saved.
 */
#ifndef COMMON_TGAIMAGE_H
#define COMMON_TGAIMAGE_H

#include "base/bytes.h"
#include "base/error.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The value is the number of bytes of a pixel. */
enum image_format { IMAGE_GREY = 1, IMAGE_BGR = 3, IMAGE_BGRA = 4 };

/* All zero is a valid, empty image. */
struct image {
    size_t width, height;     /* pixels; both 0 in an empty image, else both at least 1 */
    enum image_format format; /* bytes of a pixel */
    uint8_t *pixels;          /* height * width * format bytes, owned by the image */
};

/* Channels are levels 0 (dark, or transparent) to 255. */
struct color {
    uint8_t b, g, r, a;
};

/* The largest width and height of an image; TGA's 16-bit fields hold no more. */
enum { IMAGE_SIZE_LIMIT = 65535 };

/* Opaque colours, channels in the order that people say them. */
static inline struct color color_rgb(uint8_t r, uint8_t g, uint8_t b) {
    return (struct color){.b = b, .g = g, .r = r, .a = 255};
}

static inline struct color color_grey(uint8_t level) {
    return color_rgb(level, level, level);
}

/* Allocate a black (all bytes zero) image of 1..IMAGE_SIZE_LIMIT pixels a side. False, with a
 * message and an empty image, for another size or when memory runs out. */
bool image_create(struct image *image, size_t width, size_t height, enum image_format format,
                  struct error *error);

/* Allocate an image and leave its pixels as they are, for a caller that sets every one. */
bool image_create_unset(struct image *image, size_t width, size_t height, enum image_format format,
                        struct error *error);

/* May a file with so many bytes of pixels hold an image of this size? Up to 8192 x 8192 pixels it
 * may; more than that need a byte for every 16, so that no small file takes all memory. False with
 * a message. */
bool image_check_size(size_t width, size_t height, size_t bytes, struct error *error);

/* Free the pixels and leave an empty image. Freeing an empty image is legal. */
void image_free(struct image *image);

/* The pixel's colour; zero (all channels) outside the image. Grey comes as three equal channels;
 * an image without alpha is opaque. */
struct color image_get(const struct image *image, int x, int y);

/* Set a pixel; false, and nothing written, outside the image. A grey image keeps the blue channel
 * (color_grey() makes all channels equal), an image without alpha drops alpha. */
bool image_set(struct image *image, int x, int y, struct color color);

/* The pixels x_begin..x_end - 1 of row y, all of which lie in the image, become `color`. */
void image_fill_row(struct image *image, int y, int x_begin, int x_end, struct color color);

/* Every pixel becomes `color`. */
void image_clear(struct image *image, struct color color);

/* ---- TGA. image_read() of image_file.h reads files; only tga_write() names one. ---- */

/* Can the bytes be a TGA of these types? TGA has no signature: the only sign is that the header
 * names an image type and a colour map type that exist. */
bool tga_is_possible(const void *data, size_t size);

/* TGA types 1, 2, 3, 9, 10, 11; 8-bit grey, colour map of 8 or 16 bits, 16-bit grey with alpha
 * (BGRA), 15/16-bit 5551, 24 and 32 bit; all four origins (the result is always bottom-left). A
 * 16-bit colour's attribute bit becomes alpha 0 or 255 when the header declares one attribute bit.
 * The fourth byte of a 32-bit pixel is always alpha, whatever the header declares, since many
 * writers leave that number at 0. `image` is overwritten, not freed; empty on an error. */
bool tga_decode(struct image *image, const void *data, size_t size, struct error *error);

/* TGA 2.0 with footer: type 11 or 10, run-length coded; no packet crosses a row. Where packets
 * would be larger than the raw pixels (noise), these are written instead, as type 3 or 2. Appends
 * to `out`. */
bool tga_encode(const struct image *image, struct bytes *out, struct error *error);
bool tga_write(const struct image *image, const char *path, struct error *error);

#endif
