/*
 * Images in memory, TGA in and out; see tgaimage.h.
 *
 * TGA: Truevision, "Truevision TGA File Format Specification", version 2.0, 1991.
 */
#include "tgaimage.h"

#include "base/array.h"
#include "base/file.h"
#include "base/large_pages.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

/* ---- Images ---- */

enum { PIXELS_OF_ANY = 8192 * 8192, PIXELS_OF_A_BYTE = 16 }; /* see image_check_size() */

/* What the pipeline draws on has 16 pixels of a row in one line of the cache: so large images are
 * drawn up to a twenty-fifth faster. */
static void *allocate_lines(size_t height, size_t row) {
    if (height > (SIZE_MAX - CACHE_LINE) / row) {
        return NULL;
    }
    return aligned_alloc(CACHE_LINE, (height * row / CACHE_LINE + 1) * CACHE_LINE);
}

/* Bytes of a row and of the whole image. */
static size_t row_size(const struct image *image) {
    return image->width * (size_t)image->format;
}

static size_t image_size(const struct image *image) {
    return image->height * row_size(image);
}

bool image_create_unset(struct image *image, size_t width, size_t height, enum image_format format,
                        struct error *error) {
    assert(format == IMAGE_GREY || format == IMAGE_BGR || format == IMAGE_BGRA);
    *image = (struct image){0};
    if (width < 1 || height < 1 || width > IMAGE_SIZE_LIMIT || height > IMAGE_SIZE_LIMIT) {
        return error_set(error, "an image cannot be %zux%zu pixels: a side has 1 to %d", width,
                         height, IMAGE_SIZE_LIMIT);
    }
    size_t row = width * (size_t)format;
    uint8_t *pixels = allocate_lines(height, row);
    if (pixels == NULL) {
        return error_set(error, "out of memory for an image of %zux%zu pixels", width, height);
    }
    ask_for_large_pages(pixels, height * row);
    image->width = width;
    image->height = height;
    image->format = format;
    image->pixels = pixels;
    return true;
}

bool image_create(struct image *image, size_t width, size_t height, enum image_format format,
                  struct error *error) {
    if (!image_create_unset(image, width, height, format, error)) {
        return false;
    }
    memset(image->pixels, 0, image_size(image));
    return true;
}

bool image_check_size(size_t width, size_t height, size_t bytes, struct error *error) {
    const uint64_t pixels = (uint64_t)width * height;
    return pixels <= PIXELS_OF_ANY || pixels / PIXELS_OF_A_BYTE <= bytes ||
           error_set(error,
                     "a picture of %zux%zu pixels in %zu bytes: more than 8192x8192 need a byte "
                     "for every %d",
                     width, height, bytes, PIXELS_OF_A_BYTE);
}

void image_free(struct image *image) {
    free(image->pixels);
    *image = (struct image){0};
}

static bool is_inside(const struct image *image, int x, int y) {
    return x >= 0 && y >= 0 && (size_t)x < image->width && (size_t)y < image->height;
}

static size_t pixel_offset(const struct image *image, int x, int y) {
    return ((size_t)y * image->width + (size_t)x) * (size_t)image->format;
}

struct color image_get(const struct image *image, int x, int y) {
    if (!is_inside(image, x, y)) {
        return (struct color){0};
    }
    const uint8_t *pixel = image->pixels + pixel_offset(image, x, y);
    if (image->format == IMAGE_GREY) {
        return color_grey(pixel[0]);
    }
    return (struct color){
        .b = pixel[0],
        .g = pixel[1],
        .r = pixel[2],
        .a = image->format == IMAGE_BGRA ? pixel[3] : 255,
    };
}

static void store_color(uint8_t *pixel, enum image_format format, struct color color) {
    pixel[0] = color.b;
    if (format != IMAGE_GREY) {
        pixel[1] = color.g;
        pixel[2] = color.r;
    }
    if (format == IMAGE_BGRA) {
        pixel[3] = color.a;
    }
}

bool image_set(struct image *image, int x, int y, struct color color) {
    if (!is_inside(image, x, y)) {
        return false;
    }
    store_color(image->pixels + pixel_offset(image, x, y), image->format, color);
    return true;
}

static inline void store_colors(uint8_t *pixel, enum image_format format, struct color color,
                                size_t count) {
    for (size_t i = 0; i < count; i++, pixel += format) {
        store_color(pixel, format, color);
    }
}

/* `count` pixels become `color`: the format is asked once and not for each of them. */
static void fill_pixels(uint8_t *pixel, enum image_format format, struct color color,
                        size_t count) {
    if (format == IMAGE_GREY) {
        store_colors(pixel, IMAGE_GREY, color, count);
    } else if (format == IMAGE_BGR) {
        store_colors(pixel, IMAGE_BGR, color, count);
    } else {
        store_colors(pixel, IMAGE_BGRA, color, count);
    }
}

void image_fill_row(struct image *image, int y, int x_begin, int x_end, struct color color) {
    if (x_begin < x_end) {
        fill_pixels(image->pixels + pixel_offset(image, x_begin, y), image->format, color,
                    (size_t)(x_end - x_begin));
    }
}

void image_clear(struct image *image, struct color color) {
    fill_pixels(image->pixels, image->format, color, image->width * image->height);
}

/* Two stretches of memory change places. */
static void swap_bytes(uint8_t *a, uint8_t *b, size_t size) {
    for (size_t i = 0; i < size; i++) {
        uint8_t kept = a[i];
        a[i] = b[i];
        b[i] = kept;
    }
}

/* The last of `count` pixels or rows of `size` bytes comes first. */
static void reverse(uint8_t *first, size_t count, size_t size) {
    for (size_t i = 0; i < count / 2; i++) {
        swap_bytes(first + i * size, first + (count - 1 - i) * size, size);
    }
}

/* ---- TGA ---- */

enum {
    TGA_HEADER_SIZE = 18,
    TGA_PACKET_LIMIT = 128, /* pixels of one run-length packet */
    TGA_COLOR_MAPPED = 1,   /* image types; the run-length coded ones are 8 more */
    TGA_TRUE_COLOR = 2,
    TGA_GREY = 3,
    TGA_RUN_LENGTH = 8,
    TGA_RIGHT_TO_LEFT = 0x10, /* bits of the image descriptor */
    TGA_TOP_TO_BOTTOM = 0x20,
    TGA_ATTRIBUTE_BITS = 0x0f,
    TGA_RESERVED_BITS = 0xc0
};

/* The last 26 bytes of a version 2.0 file: no extension area, no developer directory. */
static const uint8_t tga_footer[26] = "\0\0\0\0\0\0\0\0TRUEVISION-XFILE.";

/* What the header says, and where what it describes is. */
struct tga {
    unsigned id_size, map_type, type, map_first, map_length, map_depth;
    unsigned width, height, depth, descriptor;
    bool run_length;
    unsigned color_depth;      /* bits of a stored colour: of a pixel, or of a colour map entry */
    size_t stored;             /* bytes of a stored pixel */
    enum image_format format;  /* of the image that comes out */
    const uint8_t *map;        /* map_length colours */
    const uint8_t *next, *end; /* the file's bytes that are not yet read: pixels, at last */
};

static unsigned get_u16(const uint8_t *bytes) {
    return bytes[0] | (unsigned)bytes[1] << 8;
}

static size_t depth_bytes(unsigned bits) {
    return (bits + 7) / 8;
}

static void parse_tga_header(struct tga *tga, const uint8_t *header) {
    tga->id_size = header[0];
    tga->map_type = header[1];
    tga->type = header[2] & ~(unsigned)TGA_RUN_LENGTH;
    tga->run_length = (header[2] & TGA_RUN_LENGTH) != 0;
    tga->map_first = get_u16(header + 3);
    tga->map_length = get_u16(header + 5);
    tga->map_depth = header[7];
    tga->width = get_u16(header + 12);
    tga->height = get_u16(header + 14);
    tga->depth = header[16];
    tga->descriptor = header[17];
}

static bool is_color_depth(unsigned bits) {
    return bits == 15 || bits == 16 || bits == 24 || bits == 32;
}

/* Does the type of the file allow so many bits a pixel? */
static bool check_tga_depth(const struct tga *tga, struct error *error) {
    bool color =
        tga->type == TGA_TRUE_COLOR; /* others: a byte or two, grey with alpha or indices */
    if (color ? !is_color_depth(tga->depth) : tga->depth != 8 && tga->depth != 16) {
        return error_set(error, "a TGA of %s pixels of %u bits is not supported",
                         color                   ? "true-colour"
                         : tga->type == TGA_GREY ? "grey"
                                                 : "colour-mapped",
                         tga->depth);
    }
    if (tga->type == TGA_COLOR_MAPPED && !is_color_depth(tga->map_depth)) {
        return error_set(error, "a TGA colour map of %u bits an entry is not supported",
                         tga->map_depth);
    }
    return true;
}

static bool has_known_type(const struct tga *tga) {
    return tga->type >= TGA_COLOR_MAPPED && tga->type <= TGA_GREY;
}

static bool check_tga_header(const struct tga *tga, struct error *error) {
    if (!has_known_type(tga)) {
        return error_set(error, "TGA image type %u is not supported (1, 2, 3, 9, 10, 11 are)",
                         tga->type + (tga->run_length ? TGA_RUN_LENGTH : 0u));
    }
    if (tga->width == 0 || tga->height == 0) {
        return error_set(error, "a TGA of %ux%u pixels has no picture", tga->width, tga->height);
    }
    if (tga->map_type > 1) {
        return error_set(error, "TGA colour map type %u is not supported", tga->map_type);
    }
    if (tga->type == TGA_COLOR_MAPPED && (tga->map_type == 0 || tga->map_length == 0)) {
        return error_set(error, "a colour-mapped TGA without a colour map");
    }
    if ((tga->descriptor & TGA_RESERVED_BITS) != 0) {
        return error_set(error, "an interleaved TGA is not supported");
    }
    return check_tga_depth(tga, error);
}

/* Step over the image id and the colour map. */
static bool skip_to_pixels(struct tga *tga, struct error *error) {
    size_t map_size = tga->map_type == 1 ? tga->map_length * depth_bytes(tga->map_depth) : 0;
    if (tga->id_size + map_size > (size_t)(tga->end - tga->next)) {
        return error_set(error, "a TGA cut off before its pixels");
    }
    tga->map = tga->next + tga->id_size;
    tga->next = tga->map + map_size;
    return true;
}

/* Do the bytes that are left suffice for the pixels that the header claims? A run-length packet of
 * 1 + stored bytes gives at most 128 pixels. */
static bool check_tga_size(const struct tga *tga, struct error *error) {
    uint64_t pixels = (uint64_t)tga->width * tga->height;
    uint64_t packets = (pixels + TGA_PACKET_LIMIT - 1) / TGA_PACKET_LIMIT;
    uint64_t least = tga->run_length ? packets * (1 + tga->stored) : pixels * tga->stored;
    uint64_t left = (uint64_t)(tga->end - tga->next);
    if (left < least) {
        return error_set(
            error, "a TGA cut off: %ux%u pixels take at least %llu bytes, but %llu are left",
            tga->width, tga->height, (unsigned long long)least, (unsigned long long)left);
    }
    return image_check_size(tga->width, tga->height, (size_t)left, error);
}

static enum image_format tga_format(const struct tga *tga) {
    if (tga->type == TGA_GREY) {
        return tga->depth == 16 ? IMAGE_BGRA : IMAGE_GREY;
    }
    bool one_attribute_bit = (tga->descriptor & TGA_ATTRIBUTE_BITS) == 1;
    bool alpha = tga->color_depth == 32 || (tga->color_depth == 16 && one_attribute_bit);
    return alpha ? IMAGE_BGRA : IMAGE_BGR;
}

/* 5 bits to 8, rounded to nearest. */
static uint8_t level_from_5_bits(unsigned bits) {
    return (uint8_t)(((bits & 31) * 255 + 15) / 31);
}

/* A stored colour of 15 or 16 bits: attribute, red, green, blue from the highest bit down. */
static void unpack_5551(const uint8_t *stored, enum image_format format, uint8_t *pixel) {
    unsigned bits = get_u16(stored);
    struct color color = {
        .b = level_from_5_bits(bits),
        .g = level_from_5_bits(bits >> 5),
        .r = level_from_5_bits(bits >> 10),
        .a = (bits & 0x8000) != 0 ? 255 : 0,
    };
    store_color(pixel, format, color);
}

/* Grey and alpha, a byte each. */
static void unpack_grey_alpha(const uint8_t *stored, size_t count, uint8_t *bgra) {
    for (size_t i = 0; i < count; i++) {
        memset(bgra + 4 * i, stored[2 * i], 3);
        bgra[4 * i + 3] = stored[2 * i + 1];
    }
}

/* `count` stored colours become pixels. */
static void convert_colors(const struct tga *tga, const uint8_t *stored, size_t count,
                           uint8_t *pixels) {
    if (tga->type == TGA_GREY && tga->depth == 16) {
        unpack_grey_alpha(stored, count, pixels);
        return;
    }
    if (tga->color_depth != 15 && tga->color_depth != 16) {
        memcpy(pixels, stored, count * (size_t)tga->format);
        return;
    }
    for (size_t i = 0; i < count; i++) {
        unpack_5551(stored + 2 * i, tga->format, pixels + i * (size_t)tga->format);
    }
}

/* `count` stored pixels become those of the image. Colours that the map does not have are black and
 * opaque, as in PNG. */
static void convert_pixels(const struct tga *tga, const uint8_t *stored, size_t count,
                           uint8_t *pixels) {
    if (tga->type != TGA_COLOR_MAPPED) {
        convert_colors(tga, stored, count, pixels);
        return;
    }
    for (size_t i = 0; i < count; i++, pixels += tga->format) {
        unsigned index = tga->stored == 2 ? get_u16(stored + 2 * i) : stored[i];
        index -= tga->map_first; /* below the map it is large */
        if (index < tga->map_length) {
            convert_colors(tga, tga->map + index * depth_bytes(tga->map_depth), 1, pixels);
        } else {
            store_color(pixels, tga->format, (struct color){.a = 255});
        }
    }
}

enum { BLOCK = 128 }; /* bytes; the longest packets are whole blocks */

/* Copy whole blocks. The last may reach past `size` bytes: a packet is short, and no processor can
 * predict how many steps its copy takes, so the fewer the better. */
static inline void copy_blocks(uint8_t *restrict to, const uint8_t *restrict from, size_t size) {
    for (size_t i = 0; i < size; i += BLOCK) {
        memcpy(to + i, from + i, BLOCK);
    }
}

/* Fill `count` bytes, and less than a block more, with copies of a pixel: sixteen bytes at a time,
 * of which those that begin a pixel too many are overwritten by the next. */
static inline void fill_blocks(uint8_t *restrict to, const uint8_t *restrict pixel, size_t count,
                               const size_t size) {
    const size_t whole = 16 / size * size;
    uint8_t copies[16];
    for (size_t i = 0; i < 16; i++) {
        copies[i] = pixel[i % size];
    }
    for (size_t i = 0; i < count; i += 4 * whole) {
        for (size_t k = 0; k < 4; k++) {
            memcpy(to + i + k * whole, copies, 16);
        }
    }
}

/* Does the next packet lie in the file, and its pixels among those that are left? */
static bool check_packet(const struct tga *tga, const uint8_t *next, size_t left, size_t size,
                         struct error *error) {
    const unsigned head = next < tga->end ? *next : 0;
    const size_t count = (head & 127) + 1, stored = (head & 128) != 0 ? 1 : count;
    if (count > left) {
        return error_set(error, "a TGA packet of %zu pixels, but only %zu are left", count, left);
    }
    return stored * size < (size_t)(tga->end - next) ||
           error_set(error, "a TGA cut off: %zu pixels are missing", left);
}

/* Unpack `left` stored pixels, whose packets may cross rows: in whole blocks as long as a packet of
 * any size lies in the file, and one and a block more in the image. `size`, that of a stored pixel,
 * is a constant where this is called, and the loops are compiled for it. */
static inline bool unpack_packets_of(const struct tga *tga, uint8_t *pixels, size_t left,
                                     const size_t size, struct error *error) {
    const uint8_t *next = tga->next;
    while (left > 0) {
        bool inner =
            left >= TGA_PACKET_LIMIT + BLOCK && (size_t)(tga->end - next) > TGA_PACKET_LIMIT * size;
        if (!inner && !check_packet(tga, next, left, size, error)) {
            return false;
        }
        unsigned head = *next++;
        size_t count = (head & 127) + 1;
        if ((head & 128) == 0 && inner) {
            copy_blocks(pixels, next, count * size);
        } else if (inner) {
            fill_blocks(pixels, next, count * size, size);
        } else {
            for (size_t i = 0; i < count; i++) {
                memcpy(pixels + i * size, next + ((head & 128) == 0 ? i * size : 0), size);
            }
        }
        next += (head & 128) == 0 ? count * size : size;
        pixels += count * size;
        left -= count;
    }
    return true;
}

static bool unpack_packets(const struct tga *tga, uint8_t *pixels, size_t count,
                           struct error *error) {
    return tga->stored == 1   ? unpack_packets_of(tga, pixels, count, 1, error)
           : tga->stored == 2 ? unpack_packets_of(tga, pixels, count, 2, error)
           : tga->stored == 3 ? unpack_packets_of(tga, pixels, count, 3, error)
                              : unpack_packets_of(tga, pixels, count, 4, error);
}

/* Packets are unpacked to the end of the image: a stored pixel is not larger than one of the image,
 * so none is overwritten before it is converted. */
static bool decode_pixels(const struct tga *tga, struct image *image, struct error *error) {
    size_t count = image->width * image->height;
    uint8_t *unpacked = image->pixels + count * ((size_t)tga->format - tga->stored);
    if (tga->run_length && !unpack_packets(tga, unpacked, count, error)) {
        return false;
    }
    if (!tga->run_length || unpacked != image->pixels) {
        convert_pixels(tga, tga->run_length ? unpacked : tga->next, count, image->pixels);
    }
    return true;
}

bool tga_is_possible(const void *data, size_t size) {
    if (size < TGA_HEADER_SIZE) {
        return false;
    }
    struct tga tga = {0};
    parse_tga_header(&tga, data);
    return has_known_type(&tga) && tga.map_type <= 1;
}

bool tga_decode(struct image *image, const void *data, size_t size, struct error *error) {
    *image = (struct image){0};
    const uint8_t *bytes = data;
    if (size < TGA_HEADER_SIZE) {
        return error_set(error, "not a TGA: %zu bytes are too few for a header", size);
    }
    struct tga tga = {.next = bytes + TGA_HEADER_SIZE, .end = bytes + size};
    parse_tga_header(&tga, bytes);
    if (!check_tga_header(&tga, error)) {
        return false;
    }
    tga.stored = depth_bytes(tga.depth);
    tga.color_depth = tga.type == TGA_COLOR_MAPPED ? tga.map_depth : tga.depth;
    tga.format = tga_format(&tga);
    if (!skip_to_pixels(&tga, error) || !check_tga_size(&tga, error) ||
        !image_create_unset(image, tga.width, tga.height, tga.format, error)) {
        return false;
    }
    if (!decode_pixels(&tga, image, error)) {
        image_free(image);
        return false;
    }
    for (size_t y = 0; (tga.descriptor & TGA_RIGHT_TO_LEFT) != 0 && y < image->height; y++) {
        reverse(image->pixels + y * row_size(image), image->width, (size_t)image->format);
    }
    if ((tga.descriptor & TGA_TOP_TO_BOTTOM) != 0) {
        reverse(image->pixels, image->height, row_size(image));
    }
    return true;
}

/* Is pixel x equal to pixel x + 1? For every x of a row but the last, 1 or 0. `size` is a constant
 * where this is called. */
static inline void compare_neighbours(const uint8_t *restrict row, size_t width,
                                      uint8_t *restrict equal, const size_t size) {
    for (size_t x = 0; x + 1 < width; x++) {
        uint8_t different = 0;
        for (size_t c = 0; c < size; c++) {
            different |= row[x * size + c] ^ row[(x + 1) * size + c];
        }
        equal[x] = different == 0;
    }
}

/* How many of the first `count` pixels come before one that differs from the next. */
static size_t equal_pixels(const uint8_t *equal, size_t count) {
    const uint8_t *other = memchr(equal, 0, count);
    return other == NULL ? count : (size_t)(other - equal);
}

/* How many come before a run of `worth` pixels, which is the least that is worth its own packet. */
static size_t pixels_before_run(const uint8_t *equal, size_t count, size_t worth) {
    const uint8_t *run = equal, *end = equal + count;
    while ((run = memchr(run, 1, (size_t)(end - run))) != NULL) {
        if (run[worth - 2] != 0) { /* where two are enough, that is known */
            return (size_t)(run - equal);
        }
        run++;
    }
    return count;
}

/* One row as packets; returns their size. `out` has room for the row and one byte per 128 pixels,
 * which is the worst case. A run packet between two raw ones costs two heads, so two equal grey
 * pixels are not worth one. `equal` has room for a byte a pixel and is zero at the last. */
static inline size_t pack_row(const uint8_t *row, size_t width, uint8_t *equal, uint8_t *out,
                              const size_t size) {
    const size_t worth = size == 1 ? 3 : 2;
    uint8_t *next = out;
    compare_neighbours(row, width, equal, size);
    for (size_t x = 0; x < width;) {
        size_t limit = width - x < TGA_PACKET_LIMIT ? width - x : TGA_PACKET_LIMIT;
        size_t count = 1, stored = 1;
        bool run = equal[x] != 0;
        if (run) {
            count += equal_pixels(equal + x, limit - 1);
        } else { /* up to the next run that is worth it and begins well before the limit */
            size_t look = limit > worth ? limit - worth : 0;
            size_t before = pixels_before_run(equal + x + 1, look, worth);
            stored = count = before < look ? 1 + before : limit;
        }
        *next++ = (uint8_t)((run ? 128 : 0) + count - 1);
        memcpy(next, row + x * size, stored * size);
        next += stored * size;
        x += count;
    }
    return (size_t)(next - out);
}

static void put_u16(uint8_t *bytes, size_t value) {
    bytes[0] = (uint8_t)(value & 255);
    bytes[1] = (uint8_t)(value >> 8);
}

static void put_tga_header(uint8_t *header, const struct image *image, bool run_length) {
    memset(header, 0, TGA_HEADER_SIZE);
    header[2] = (uint8_t)((image->format == IMAGE_GREY ? TGA_GREY : TGA_TRUE_COLOR) +
                          (run_length ? TGA_RUN_LENGTH : 0));
    put_u16(header + 12, image->width);
    put_u16(header + 14, image->height);
    header[16] = (uint8_t)(8 * (unsigned)image->format);
    header[17] = image->format == IMAGE_BGRA ? 8 : 0; /* bits of alpha; origin bottom-left */
}

/* All rows as packets after what is in `out`, which has room for the raw pixels and one row more.
 * False when they come out larger than the raw pixels. */
static bool pack_rows(const struct image *image, uint8_t *equal, struct bytes *out) {
    size_t raw_end = out->size + image_size(image), width = image->width;
    for (size_t y = 0; y < image->height; y++) {
        const uint8_t *row = image->pixels + y * row_size(image);
        uint8_t *end = out->data + out->size;
        out->size += image->format == IMAGE_GREY  ? pack_row(row, width, equal, end, 1)
                     : image->format == IMAGE_BGR ? pack_row(row, width, equal, end, 3)
                                                  : pack_row(row, width, equal, end, 4);
        if (out->size > raw_end) {
            return false;
        }
    }
    return true;
}

bool tga_encode(const struct image *image, struct bytes *out, struct error *error) {
    if (image->pixels == NULL) {
        return error_set(error, "an empty image cannot be written");
    }
    /* A row of packets is at most twice as large as the row: one grey pixel in a packet. */
    size_t room = TGA_HEADER_SIZE + image_size(image) + 2 * row_size(image) + sizeof tga_footer;
    uint8_t *equal = calloc(image->width, 1);
    if (equal == NULL || !bytes_reserve(out, room)) {
        free(equal);
        return error_out_of_memory(error);
    }
    size_t start = out->size;
    out->size += TGA_HEADER_SIZE;
    bool packed = pack_rows(image, equal, out);
    free(equal);
    if (!packed) { /* noise: run-length coding would make it larger */
        out->size = start + TGA_HEADER_SIZE;
        memcpy(out->data + out->size, image->pixels, image_size(image));
        out->size += image_size(image);
    }
    put_tga_header(out->data + start, image, packed);
    memcpy(out->data + out->size, tga_footer, sizeof tga_footer);
    out->size += sizeof tga_footer;
    return true;
}

bool tga_write(const struct image *image, const char *path, struct error *error) {
    struct bytes out = {0};
    bool encoded = tga_encode(image, &out, error);
    return file_write_encoded(path, encoded, &out, error);
}
