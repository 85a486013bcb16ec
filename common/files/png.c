/*
 * PNG in and out, APNG out; see png.h. The compression is in deflate.c.
 *
 * A PNG file is a signature and chunks: length, type, data, checksum. The pixels, top row first,
 * each row after a byte that names its filter, are compressed into the IDAT chunks.
 */
#include "files/png.h"

#include "base/file.h"
#include "files/deflate.h"

#include <assert.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static const uint8_t png_signature[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

enum {
    CHUNK_OVERHEAD = 12,      /* bytes of a chunk around its data */
    CHUNK_LIMIT = 0x7fffffff, /* bytes of data of a chunk */
    HEADER_SIZE = 13,         /* of IHDR */
    FRAME_NUMBER_SIZE = 4,    /* of fdAT, before its pixels */
    PIXEL_LIMIT = 8,          /* bytes of a pixel */
    PALETTE_LIMIT = 256,
    PASSES = 8
};

/* Row filters, as in the file. */
enum { FILTER_NONE, FILTER_SUB, FILTER_UP, FILTER_AVERAGE, FILTER_PAETH, FILTER_COUNT };

/* As in IHDR. */
enum color_type {
    COLOR_GREY = 0,
    COLOR_RGB = 2,
    COLOR_PALETTE = 3,
    COLOR_GREY_ALPHA = 4,
    COLOR_RGBA = 6
};

/* ---- Checksum ---- */

/* The checksum's register after one byte: linear, so that eight numbers make the table. */
#define CRC(n)                                                                                     \
    (((n)&1 ? 0x77073096u : 0) ^ ((n)&2 ? 0xee0e612cu : 0) ^ ((n)&4 ? 0x076dc419u : 0) ^           \
     ((n)&8 ? 0x0edb8832u : 0) ^ ((n)&16 ? 0x1db71064u : 0) ^ ((n)&32 ? 0x3b6e20c8u : 0) ^         \
     ((n)&64 ? 0x76dc4190u : 0) ^ ((n)&128 ? 0xedb88320u : 0))
#define CRC_4(n)  CRC(n), CRC((n) + 1), CRC((n) + 2), CRC((n) + 3)
#define CRC_16(n) CRC_4(n), CRC_4((n) + 4), CRC_4((n) + 8), CRC_4((n) + 12)
#define CRC_64(n) CRC_16(n), CRC_16((n) + 16), CRC_16((n) + 32), CRC_16((n) + 48)

static const uint32_t crc_table[256] = {CRC_64(0), CRC_64(64), CRC_64(128), CRC_64(192)};

/* The specification's CRC-32 (its annex D), one byte at a time. */
static uint32_t crc32(const uint8_t *data, size_t size) {
    uint32_t crc = 0xffffffffu;
    for (size_t i = 0; i < size; i++) {
        crc = crc_table[(crc ^ data[i]) & 255] ^ crc >> 8;
    }
    return crc ^ 0xffffffffu;
}

/* ---- Numbers, highest byte first ---- */

static uint32_t get_u32(const uint8_t *bytes) {
    return (uint32_t)bytes[0] << 24 | (uint32_t)bytes[1] << 16 | (uint32_t)bytes[2] << 8 | bytes[3];
}

static void put_u32(uint8_t *bytes, size_t value) {
    bytes[0] = (uint8_t)(value >> 24 & 255);
    bytes[1] = (uint8_t)(value >> 16 & 255);
    bytes[2] = (uint8_t)(value >> 8 & 255);
    bytes[3] = (uint8_t)(value & 255);
}

/* ---- Pixels ---- */

/* Red, green, blue of a file become blue, green, red of memory, and the other way round; alpha
 * stays. `step`, the bytes of a pixel, is a constant where this is called. */
static inline void swap_colors(uint8_t *restrict to, const uint8_t *restrict from, size_t count,
                               const size_t step) {
    for (size_t i = 0; i < count * step; i += step) {
        to[i] = from[i + 2];
        to[i + 1] = from[i + 1];
        to[i + 2] = from[i];
        if (step == 4) {
            to[i + 3] = from[i + 3];
        }
    }
}

/* A row of a file becomes one of an image, and the other way round. */
static void swap_row(uint8_t *to, const uint8_t *from, size_t width, size_t channels) {
    if (channels == 1) {
        memcpy(to, from, width);
    } else if (channels == 3) {
        swap_colors(to, from, width, 3);
    } else {
        swap_colors(to, from, width, 4);
    }
}

/* ---- Row filters ----
 *
 * A byte is predicted from those at its left (a), above (b) and above left (c), one pixel away; the
 * file holds the difference. Rows to be written have PIXEL_LIMIT zero bytes before them, so that a
 * and c always exist. */

/* a, b or c, whichever is nearest to a + b - c; in this order when equally near. The higher one of
 * a and b is nearest where c is low, the lower one where c is high, and c in between. No branches:
 * no processor could predict them (Fabian Giesen's form, from stb_image). */
static inline uint8_t paeth(uint8_t a, uint8_t b, uint8_t c) {
    int low = a < b ? a : b, high = a < b ? b : a;
    int place = 3 * c - a - b;
    int low_or_c = place >= high ? low : c;
    return (uint8_t)(place <= low ? high : low_or_c);
}

/* What a filter expects instead of a byte. */
static inline int predict(const unsigned filter, uint8_t a, uint8_t b, uint8_t c) {
    return filter == FILTER_NONE      ? 0
           : filter == FILTER_SUB     ? a
           : filter == FILTER_UP      ? b
           : filter == FILTER_AVERAGE ? (a + b) / 2
                                      : paeth(a, b, c);
}

/* Compilers make a loop for each filter. */
static void filter_row(const unsigned filter, const uint8_t *row, const uint8_t *above, size_t size,
                       size_t step, uint8_t *restrict out) {
    const uint8_t *left = row - step, *corner = above - step;
    for (size_t i = 0; i < size; i++) {
        out[i] = (uint8_t)(row[i] - predict(filter, left[i], above[i], corner[i]));
    }
}

/* Undo a filter, in place. */
static void unfilter_row(const unsigned filter, uint8_t *restrict row,
                         const uint8_t *restrict above, size_t size, const size_t step) {
    for (size_t i = 0; i < step; i++) { /* no row is shorter */
        row[i] = (uint8_t)(row[i] + predict(filter, 0, above[i], 0));
    }
    for (size_t i = step; i < size; i++) {
        row[i] = (uint8_t)(row[i] + predict(filter, row[i - step], above[i], above[i - step]));
    }
}

/* ---- Reading: chunks ---- */

struct chunk {
    const uint8_t *type; /* four letters */
    const uint8_t *data;
    size_t size;
};

/* What the chunks before the pixels say, and the compressed pixels. */
struct png {
    size_t width, height;
    unsigned depth; /* bits of a sample or a palette index */
    unsigned color_type;
    size_t first_pass, end_pass;       /* of `passes` */
    uint8_t palette[PALETTE_LIMIT][4]; /* blue, green, red, alpha */
    size_t palette_size;
    bool has_alpha_chunk; /* a tRNS chunk */
    uint16_t clear[3];    /* the tRNS colour of a file without palette: red, green, blue */
    struct bytes compressed;
    bool seen_data, data_ended, ended;
};

static bool is_type(const struct chunk *chunk, const char *type) {
    return memcmp(chunk->type, type, 4) == 0;
}

/* A chunk that a picture cannot do without has a capital first letter. */
static bool is_needed(const struct chunk *chunk) {
    return (chunk->type[0] & 32) == 0;
}

/* Split off the next chunk; `position` moves behind it. Of pixels that are cut off, what is there
 * may be all that is needed; behind them no chunk is. */
static bool next_chunk(struct png *png, const uint8_t *data, size_t size, size_t *position,
                       struct chunk *chunk, struct error *error) {
    size_t left = size - *position;
    const uint8_t *const end = (const uint8_t *)"IEND";
    *chunk = (struct chunk){.type = end};
    if (left < CHUNK_OVERHEAD) {
        return png->seen_data || error_set(error, "a PNG cut off before its end");
    }
    const uint8_t *start = data + *position;
    uint32_t length = get_u32(start);
    *chunk = (struct chunk){.type = start + 4, .data = start + 8, .size = length};
    for (size_t i = 0; i < 4; i++) {
        unsigned letter = chunk->type[i] | 32u;
        if (letter < 'a' || letter > 'z') {
            return error_set(error, "a PNG chunk without a name at byte %zu", *position);
        }
    }
    if (length > left - CHUNK_OVERHEAD) {
        bool is_data = is_type(chunk, "IDAT");
        chunk->type = is_data ? chunk->type : end;
        chunk->size = left - 8;
        *position = size;
        return png->seen_data || is_data ||
               error_set(error, "a PNG cut off: chunk %.4s claims %lu bytes, but %zu are left",
                         (const char *)start + 4, (unsigned long)length, left - CHUNK_OVERHEAD);
    }
    *position += CHUNK_OVERHEAD + chunk->size;
    if (crc32(chunk->type, 4 + chunk->size) == get_u32(chunk->data + chunk->size) ||
        is_type(chunk, "IEND")) {
        return true;
    }
    if (is_needed(chunk)) {
        return error_set(error, "a PNG with a wrong checksum in chunk %.4s",
                         (const char *)chunk->type);
    }
    chunk->type = (const uint8_t *)"none"; /* so that it is passed over */
    return true;
}

/* Of a pixel, and the depths that they may have. */
static const struct {
    uint8_t count, depths;
} channels_of[] = {[COLOR_GREY] = {1, 1 | 2 | 4 | 8 | 16},
                   [COLOR_RGB] = {3, 8 | 16},
                   [COLOR_PALETTE] = {1, 1 | 2 | 4 | 8},
                   [COLOR_GREY_ALPHA] = {2, 8 | 16},
                   [COLOR_RGBA] = {4, 8 | 16}};

/* 0 for a type that does not exist. */
static size_t channel_count(unsigned color_type) {
    return color_type <= COLOR_RGBA ? channels_of[color_type].count : 0;
}

static bool check_depth(const struct png *png, struct error *error) {
    const unsigned depth = png->depth;
    if (channel_count(png->color_type) == 0) {
        return error_set(error, "a PNG of an unknown colour type, %u", png->color_type);
    }
    return ((depth & (depth - 1)) == 0 && (channels_of[png->color_type].depths & depth) != 0) ||
           error_set(error, "a PNG of colour type %u cannot have %u bits", png->color_type, depth);
}

static bool read_ihdr(struct png *png, const struct chunk *chunk, struct error *error) {
    if (is_type(chunk, "CgBI")) {
        return error_set(error, "an iPhone's PNG (CgBI), which packs its pixels in another way");
    }
    if (!is_type(chunk, "IHDR") || chunk->size != HEADER_SIZE) {
        return error_set(error, "a PNG that does not begin with a header");
    }
    uint32_t width = get_u32(chunk->data), height = get_u32(chunk->data + 4);
    if (width == 0 || height == 0 || width > IMAGE_SIZE_LIMIT || height > IMAGE_SIZE_LIMIT) {
        return error_set(error, "a PNG of %lux%lu pixels: a side has 1 to %d", (unsigned long)width,
                         (unsigned long)height, IMAGE_SIZE_LIMIT);
    }
    png->width = width;
    png->height = height;
    for (size_t i = 0; i < PALETTE_LIMIT; i++) {
        png->palette[i][3] = 255; /* black, where the file has no colour */
    }
    png->depth = chunk->data[8];
    png->color_type = chunk->data[9];
    if (chunk->data[10] != 0 || chunk->data[11] != 0) {
        return error_set(error, "a PNG with an unknown compression or filter method");
    }
    if (chunk->data[12] > 1) {
        return error_set(error, "a PNG with an unknown interlace method");
    }
    png->first_pass = chunk->data[12];
    png->end_pass = chunk->data[12] == 1 ? PASSES : 1;
    return check_depth(png, error);
}

/* The colours of a palette. One that serves no pixels is passed over, as libpng does. */
static bool read_palette(struct png *png, const struct chunk *chunk, struct error *error) {
    const size_t limit = (size_t)1 << png->depth, count = chunk->size / 3;
    if (png->color_type != COLOR_PALETTE || png->palette_size > 0 || png->seen_data) {
        return true;
    }
    if (chunk->size == 0 || chunk->size % 3 != 0 || count > PALETTE_LIMIT) {
        return error_set(error, "a PNG with a palette of %zu bytes", chunk->size);
    }
    png->palette_size = count < limit ? count : limit;
    for (size_t i = 0; i < png->palette_size; i++) {
        const uint8_t *rgb = chunk->data + 3 * i;
        const uint8_t bgra[4] = {rgb[2], rgb[1], rgb[0], 255};
        memcpy(png->palette[i], bgra, sizeof bgra);
    }
    return true;
}

/* tRNS: the alpha of palette entries, or the one colour that is transparent. One of another size or
 * in the wrong place is passed over, as libpng does. */
static void read_transparency(struct png *png, const struct chunk *chunk) {
    bool palette = png->color_type == COLOR_PALETTE;
    size_t samples = channel_count(png->color_type);
    bool own_alpha = samples % 2 == 0;
    bool right_size =
        palette ? chunk->size >= 1 && chunk->size <= png->palette_size : chunk->size == 2 * samples;
    if (own_alpha || png->has_alpha_chunk || png->seen_data || !right_size) {
        return;
    }
    png->has_alpha_chunk = true;
    for (size_t i = 0; palette && i < chunk->size; i++) {
        png->palette[i][3] = chunk->data[i];
    }
    for (size_t i = 0; !palette && i < samples; i++) { /* of 16 bits, the lowest `depth` count */
        unsigned sample = (unsigned)chunk->data[2 * i] << 8 | chunk->data[2 * i + 1];
        png->clear[i] = (uint16_t)(sample & ((1u << png->depth) - 1));
    }
}

static bool read_data(struct png *png, const struct chunk *chunk, struct error *error) {
    if (png->data_ended) {
        return error_set(error, "a PNG with other chunks between its pixel data");
    }
    if (png->color_type == COLOR_PALETTE && png->palette_size == 0) {
        return error_set(error, "a PNG without its palette");
    }
    png->seen_data = true;
    return bytes_append(&png->compressed, chunk->data, chunk->size) || error_out_of_memory(error);
}

/* Any chunk after the header. */
static bool read_chunk(struct png *png, const struct chunk *chunk, struct error *error) {
    if (is_type(chunk, "IDAT")) {
        return read_data(png, chunk, error);
    }
    png->data_ended = png->seen_data;
    if (is_type(chunk, "IHDR")) {
        return error_set(error, "a PNG with a second header");
    }
    if (is_type(chunk, "PLTE")) {
        return read_palette(png, chunk, error);
    }
    if (is_type(chunk, "tRNS")) {
        read_transparency(png, chunk);
        return true;
    }
    if (is_type(chunk, "IEND")) {
        png->ended = true;
        return png->seen_data || error_set(error, "a PNG without pixel data");
    }
    return !is_needed(chunk) ||
           error_set(error, "a PNG with an unknown chunk, %.4s", (const char *)chunk->type);
}

bool png_has_signature(const void *data, size_t size) {
    return size >= sizeof png_signature && memcmp(data, png_signature, sizeof png_signature) == 0;
}

static bool read_chunks(struct png *png, const uint8_t *data, size_t size, struct error *error) {
    size_t position = sizeof png_signature;
    struct chunk chunk;
    if (!png_has_signature(data, size)) {
        return error_set(error, "not a PNG");
    }
    if (!next_chunk(png, data, size, &position, &chunk, error) || !read_ihdr(png, &chunk, error)) {
        return false;
    }
    while (!png->ended) {
        if (!next_chunk(png, data, size, &position, &chunk, error) ||
            !read_chunk(png, &chunk, error)) {
            return false;
        }
    }
    return true;
}

/* ---- Reading: pixels ---- */

static enum image_format png_format(const struct png *png) {
    if (png->has_alpha_chunk || channel_count(png->color_type) % 2 == 0) {
        return IMAGE_BGRA;
    }
    return png->color_type == COLOR_GREY ? IMAGE_GREY : IMAGE_BGR;
}

/* Sample i of a row, of `depth` bits; the first is in the highest bits. */
static unsigned sample_at(const uint8_t *row, size_t i, unsigned depth) {
    if (depth == 16) {
        return (unsigned)row[2 * i] << 8 | row[2 * i + 1];
    }
    size_t bit = i * depth;
    return ((unsigned)row[bit / 8] >> (8 - depth - bit % 8)) & ((1u << depth) - 1);
}

/* The sample as a level, rounded to nearest. */
static uint8_t level_of_sample(unsigned sample, unsigned depth) {
    unsigned greatest = (1u << depth) - 1;
    return (uint8_t)((sample * 255 + greatest / 2) / greatest);
}

/* One pixel as blue, green, red, alpha. */
static void read_pixel(const struct png *png, const uint8_t *row, size_t x, uint8_t bgra[4]) {
    size_t channels = channel_count(png->color_type);
    uint8_t level[4] = {0};
    bool clear = png->has_alpha_chunk;
    if (png->color_type == COLOR_PALETTE) {
        memcpy(bgra, png->palette[sample_at(row, x, png->depth)], 4);
        return;
    }
    for (size_t i = 0; i < channels; i++) {
        unsigned sample = sample_at(row, x * channels + i, png->depth);
        level[i] = level_of_sample(sample, png->depth);
        clear = clear && i < 3 && sample == png->clear[i];
    }
    bool colored = channels >= 3, own_alpha = channels % 2 == 0;
    bgra[0] = level[colored ? 2 : 0];
    bgra[1] = level[colored ? 1 : 0];
    bgra[2] = level[0];
    bgra[3] = own_alpha ? level[channels - 1] : clear ? 0 : 255;
}

/* Rows as they are in most files: eight bits a channel, and no colour that means
 * transparent. */
static bool has_plain_rows(const struct png *png) {
    return png->depth == 8 && !png->has_alpha_chunk &&
           (png->color_type == COLOR_GREY || png->color_type == COLOR_RGB ||
            png->color_type == COLOR_RGBA);
}

/* Which pixels a part of the file holds: every so many, from the first, counted from the top left.
 * An interlaced file has all but the first of these parts (the specification's section 8.2), others
 * the first alone. */
struct pass {
    size_t x, y, x_step, y_step;
};

static const struct pass passes[PASSES] = {{0, 0, 1, 1}, {0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8},
                                           {2, 0, 4, 4}, {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}};

/* Pixels in a row of the pass, and rows. */
static size_t pass_width(const struct png *png, struct pass pass) {
    return (png->width + pass.x_step - 1 - pass.x) / pass.x_step;
}

static size_t pass_height(const struct png *png, struct pass pass) {
    return (png->height + pass.y_step - 1 - pass.y) / pass.y_step;
}

static size_t row_bytes(const struct png *png, size_t width) {
    return (width * channel_count(png->color_type) * png->depth + 7) / 8;
}

/* Bytes of all rows, each after the number of its filter. */
static uint64_t raw_bytes(const struct png *png) {
    uint64_t sum = 0;
    for (size_t i = png->first_pass; i < png->end_pass; i++) {
        struct pass pass = passes[i];
        size_t width = pass_width(png, pass);
        sum += width > 0 ? (uint64_t)pass_height(png, pass) * (1 + row_bytes(png, width)) : 0;
    }
    return sum;
}

/* Undo the filters of a pass, row by row, and fill its pixels of the image; `above` is a row of
 * zeros. Returns the place behind it in `raw`; NULL, with a message, for a wrong filter. */
static uint8_t *unpack_pass(const struct png *png, struct pass pass, uint8_t *raw,
                            const uint8_t *above, struct image *image, struct error *error) {
    size_t bits = channel_count(png->color_type) * png->depth;
    size_t step = (bits + 7) / 8, pixel_size = (size_t)image->format;
    size_t width = pass_width(png, pass), size = row_bytes(png, width);
    bool plain = pass.x_step == 1 && has_plain_rows(png);
    for (size_t y = pass.y; width > 0 && y < png->height; y += pass.y_step) {
        uint8_t *row = raw + 1;
        if (raw[0] >= FILTER_COUNT) {
            error_set(error, "a PNG with an unknown row filter, %u", raw[0]);
            return NULL;
        }
        unfilter_row(raw[0], row, above, size, step);
        uint8_t *pixels = image->pixels + (png->height - 1 - y) * image->width * pixel_size;
        if (plain) {
            swap_row(pixels, row, width, pixel_size);
        }
        for (size_t x = 0; !plain && x < width; x++) {
            uint8_t bgra[4];
            read_pixel(png, row, x, bgra);
            memcpy(pixels + (pass.x + x * pass.x_step) * pixel_size, bgra, pixel_size);
        }
        raw += 1 + size;
        above = row;
    }
    return raw;
}

static bool unpack_rows(const struct png *png, uint8_t *raw, const uint8_t *zeros,
                        struct image *image, struct error *error) {
    for (size_t i = png->first_pass; raw != NULL && i < png->end_pass; i++) {
        raw = unpack_pass(png, passes[i], raw, zeros, image, error);
    }
    return raw != NULL;
}

static bool decode_pixels(const struct png *png, struct image *image, struct error *error) {
    size_t row_size = row_bytes(png, png->width);
    uint64_t raw_size = raw_bytes(png);
    assert(raw_size > 0); /* read_ihdr() lets no empty image pass */
    if (raw_size / DEFLATE_RATIO_LIMIT > png->compressed.size || raw_size > SIZE_MAX / 2) {
        return error_set(error, "a PNG cut off: %zu bytes cannot hold %zux%zu pixels",
                         png->compressed.size, png->width, png->height);
    }
    if (!image_check_size(png->width, png->height, png->compressed.size, error)) {
        return false;
    }
    uint8_t *memory = malloc(row_size + (size_t)raw_size); /* after a row of zeros */
    if (memory == NULL) {
        return error_out_of_memory(error);
    }
    uint8_t *raw = memory + row_size;
    memset(memory, 0, row_size);
    bool done =
        zlib_decompress(png->compressed.data, png->compressed.size, raw, (size_t)raw_size, error) &&
        image_create_unset(image, png->width, png->height, png_format(png), error) &&
        unpack_rows(png, raw, memory, image, error);
    if (!done) {
        image_free(image);
    }
    free(memory);
    return done;
}

bool png_decode(struct image *image, const void *data, size_t size, struct error *error) {
    struct png png = {0};
    *image = (struct image){0};
    bool done = read_chunks(&png, data, size, error) && decode_pixels(&png, image, error);
    bytes_free(&png.compressed);
    return done;
}

/* ---- Writing ---- */

/* A rectangle of an image; y counts rows from the bottom. */
struct part {
    const struct image *image;
    size_t x, y, width, height;
};

/* Append a chunk: `head` (`head_size` bytes) and `data` are its contents, one after the other. */
static bool append_chunk(struct bytes *out, const char *type, const void *head, size_t head_size,
                         const void *data, size_t data_size) {
    size_t size = head_size + data_size;
    if (!bytes_reserve(out, CHUNK_OVERHEAD + size)) {
        return false;
    }
    uint8_t number[4];
    size_t start = out->size + 4;
    put_u32(number, size);
    bytes_append(out, number, 4);
    bytes_append(out, type, 4);
    bytes_append(out, head, head_size);
    bytes_append(out, data, data_size);
    put_u32(number, crc32(out->data + start, 4 + size));
    bytes_append(out, number, 4);
    return true;
}

/* The signature and the first chunk. */
static bool append_header(struct bytes *out, const struct image *image) {
    static const uint8_t types[] = {
        [IMAGE_GREY] = COLOR_GREY, [IMAGE_BGR] = COLOR_RGB, [IMAGE_BGRA] = COLOR_RGBA};
    uint8_t header[HEADER_SIZE] = {0};
    put_u32(header, image->width);
    put_u32(header + 4, image->height);
    header[8] = 8;
    header[9] = types[image->format];
    return bytes_append(out, png_signature, sizeof png_signature) &&
           append_chunk(out, "IHDR", header, sizeof header, NULL, 0);
}

/* How far the bytes of a row are from zero, counted as differences -128..127. */
static uint32_t distance_from_zero(const uint8_t *bytes, size_t size) {
    uint32_t sum = 0; /* at most 4 * IMAGE_SIZE_LIMIT * 128 */
    for (size_t i = 0; i < size; i++) {
        sum += bytes[i] < 128 ? bytes[i] : 256u - bytes[i];
    }
    return sum;
}

/* Filter every row of the part, top row first, into `out`: the filter's number and the bytes. Each
 * row gets the filter whose differences are smallest in sum, as the specification advises (section
 * 12.7). `rows` has room for two rows and their margins, all zero,
 * `trial` for one row. */
static void filter_rows(const struct part *part, uint8_t *rows, uint8_t *trial, uint8_t *out) {
    const struct image *image = part->image;
    size_t step = (size_t)image->format, size = part->width * step;
    const uint8_t *lowest = image->pixels + (part->y * image->width + part->x) * step;
    uint8_t *row = rows + PIXEL_LIMIT, *above = rows + 2 * PIXEL_LIMIT + size;
    for (size_t y = part->height; y-- > 0; out += 1 + size) {
        swap_row(row, lowest + y * image->width * step, part->width, step);
        filter_row(FILTER_NONE, row, above, size, step, out + 1);
        out[0] = FILTER_NONE;
        uint32_t best = distance_from_zero(out + 1, size);
        for (unsigned filter = FILTER_SUB; filter < FILTER_COUNT && best > 0; filter++) {
            filter_row(filter, row, above, size, step, trial);
            uint32_t sum = distance_from_zero(trial, size);
            if (sum < best) {
                best = sum;
                out[0] = (uint8_t)filter;
                memcpy(out + 1, trial, size);
            }
        }
        uint8_t *kept = above;
        above = row;
        row = kept;
    }
}

/* The filtered and compressed pixels of a part, at the end of `out`. */
static bool compress_pixels(const struct part *part, struct bytes *out, struct error *error) {
    size_t size = part->width * (size_t)part->image->format;
    uint8_t *rows = calloc(3, PIXEL_LIMIT + size);
    uint8_t *raw = calloc(part->height, 1 + size);
    bool done = false;
    if (rows == NULL || raw == NULL) {
        error_out_of_memory(error);
        goto end;
    }
    filter_rows(part, rows, rows + 2 * (PIXEL_LIMIT + size), raw);
    done = zlib_compress(raw, part->height * (1 + size), out, error);
    if (done && out->size > CHUNK_LIMIT - FRAME_NUMBER_SIZE) {
        done = error_set(error, "%zu bytes of pixels do not fit into a chunk", out->size);
    }
end:
    free(rows);
    free(raw);
    return done;
}

bool png_encode(const struct image *image, struct bytes *out, struct error *error) {
    if (image->pixels == NULL) {
        return error_set(error, "an empty image cannot be written");
    }
    struct bytes pixels = {0};
    struct part part = {image, 0, 0, image->width, image->height};
    size_t start = out->size;
    bool done = compress_pixels(&part, &pixels, error) &&
                ((append_header(out, image) &&
                  append_chunk(out, "IDAT", NULL, 0, pixels.data, pixels.size) &&
                  append_chunk(out, "IEND", NULL, 0, NULL, 0)) ||
                 error_out_of_memory(error));
    bytes_free(&pixels);
    out->size = done ? out->size : start;
    return done;
}

bool png_write(const struct image *image, const char *path, struct error *error) {
    struct bytes out = {0};
    bool encoded = png_encode(image, &out, error);
    return file_write_encoded(path, encoded, &out, error);
}

/* ---- Animation ----
 *
 * APNG (third edition, section 11.3.4): acTL tells the number of frames; fcTL comes before each
 * frame's pixels, which are in IDAT for the first and in fdAT for the others. fcTL and fdAT count
 * a sequence number on. */

enum { FRAME_CONTROL_SIZE = 26 };

/* The smallest rectangle outside of which two images of one size are equal; a single pixel when
 * they are equal everywhere, since a frame cannot be empty. */
static struct part changed_part(const struct image *before, const struct image *after) {
    size_t step = (size_t)after->format;
    size_t left = after->width, bottom = after->height;
    size_t right = 0, top = 0; /* past it */
    for (size_t i = 0; i < after->width * after->height; i++) {
        if (memcmp(before->pixels + i * step, after->pixels + i * step, step) != 0) {
            const size_t x = i % after->width, y = i / after->width;
            left = x < left ? x : left;
            right = x < right ? right : x + 1;
            bottom = y < bottom ? y : bottom;
            top = y + 1;
        }
    }
    return top == 0 ? (struct part){after, 0, 0, 1, 1}
                    : (struct part){after, left, bottom, right - left, top - bottom};
}

static bool append_frame_control(struct bytes *out, uint32_t sequence, const struct part *part,
                                 unsigned delay_ms) {
    uint8_t control[FRAME_CONTROL_SIZE] = {0}; /* the rectangle replaces what was there and stays */
    put_u32(control, sequence);
    put_u32(control + 4, part->width);
    put_u32(control + 8, part->height);
    put_u32(control + 12, part->x);
    put_u32(control + 16, part->image->height - part->y - part->height);
    put_u32(control + 20, (size_t)delay_ms << 16 | 1000); /* thousandths of a second */
    return append_chunk(out, "fcTL", control, sizeof control, NULL, 0);
}

/* Frame `index` as fcTL and pixels. The chunks before it took the sequence numbers 0, 1, 3, 5... */
static bool append_frame(const struct image *frames, size_t index, unsigned delay_ms,
                         struct bytes *out, struct error *error) {
    const struct image *frame = &frames[index];
    struct part part = {frame, 0, 0, frame->width, frame->height};
    part = index == 0 ? part : changed_part(&frames[index - 1], frame);
    uint32_t sequence = index == 0 ? 0 : (uint32_t)(2 * index - 1);
    struct bytes pixels = {0};
    uint8_t number[FRAME_NUMBER_SIZE];
    put_u32(number, sequence + 1);
    bool done = compress_pixels(&part, &pixels, error) &&
                ((append_frame_control(out, sequence, &part, delay_ms) &&
                  append_chunk(out, index == 0 ? "IDAT" : "fdAT", number,
                               index == 0 ? 0 : sizeof number, pixels.data, pixels.size)) ||
                 error_out_of_memory(error));
    bytes_free(&pixels);
    return done;
}

bool apng_encode(const struct image *frames, size_t count, unsigned delay_ms, struct bytes *out,
                 struct error *error) {
    assert(count >= 1 && count < 1 << 30 && delay_ms >= 1 && delay_ms <= 65535);
    for (size_t i = 0; i < count; i++) {
        assert(frames[i].pixels != NULL && frames[i].width == frames[0].width &&
               frames[i].height == frames[0].height && frames[i].format == frames[0].format);
    }
    size_t start = out->size;
    uint8_t control[8] = {0}; /* number of frames; 0 plays: forever */
    put_u32(control, count);
    bool done = (append_header(out, frames) && append_chunk(out, "acTL", control, 8, NULL, 0)) ||
                error_out_of_memory(error);
    for (size_t i = 0; done && i < count; i++) {
        done = append_frame(frames, i, delay_ms, out, error);
    }
    done = done && (append_chunk(out, "IEND", NULL, 0, NULL, 0) || error_out_of_memory(error));
    out->size = done ? out->size : start;
    return done;
}

bool apng_write(const struct image *frames, size_t count, unsigned delay_ms, const char *path,
                struct error *error) {
    struct bytes out = {0};
    bool encoded = apng_encode(frames, count, delay_ms, &out, error);
    return file_write_encoded(path, encoded, &out, error);
}
