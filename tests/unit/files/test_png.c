/*
 * Tests of common/files/png.c.
 *
 * PNG files are put together here byte by byte from the specification, with checksums and filters
 * that share nothing with the code under test. Everything is decoded
 * from blocks of exactly its size, so that the address sanitizer sees a read past the end.
 */
#include "files/png.h"

#include "base/file.h"
#include "unit/chunks.h"

#include <math.h>

/* ---- PNG in ---- */

/* Raw rows as one zlib stream, a stored block. */
static struct bytes store(const uint8_t *raw, size_t size) {
    struct bytes stream = {0};
    uint8_t head[7] = {0x78, 0x01, 1, (uint8_t)(size & 255), (uint8_t)(size >> 8)};
    head[5] = (uint8_t)~head[3];
    head[6] = (uint8_t)~head[4];
    CHECK(bytes_append(&stream, head, sizeof head) && bytes_append(&stream, raw, size));
    put_32(&stream, slow_adler(raw, size));
    return stream;
}

static void put_pixels(struct bytes *file, const uint8_t *raw, size_t size) {
    struct bytes stream = store(raw, size);
    put_chunk(file, "IDAT", stream.data, stream.size);
    bytes_free(&stream);
}

/* ---- Pictures of every kind, of any samples ---- */

enum { SIDE = 17, CHANNELS = 4, ROW_LIMIT = SIDE * CHANNELS * 2 };

/* The samples of a file, row by row from the top, and what its other chunks say. */
struct content {
    unsigned type, depth, channels;
    uint32_t width, height;
    bool interlaced;
    unsigned sample[SIDE][SIDE][CHANNELS];
    size_t colors, clear_size; /* of the palette, and of the tRNS chunk; 0 without one */
    uint8_t palette[256][3], clear[256];
};

static void make_content(struct content *c, size_t number, uint32_t *state) {
    static const unsigned kinds[][3] = {{0, 1, 1},  {0, 2, 1}, {0, 4, 1},  {0, 8, 1}, {0, 16, 1},
                                        {2, 8, 3},  {3, 1, 1}, {3, 2, 1},  {3, 4, 1}, {3, 8, 1},
                                        {2, 16, 3}, {4, 8, 2}, {4, 16, 2}, {6, 8, 4}, {6, 16, 4}};
    const unsigned *kind = kinds[number % 15], most = (1u << kind[1]) - 1;
    const bool has_clear = number / 30 % 2 != 0 && kind[0] < 4;
    /* Few values make many ties in the choice of Paeth's filter, and many clear pixels. */
    const unsigned few = next_random(state) % 2 == 0 ? 0x0303 : 0xffff;
    *c = (struct content){.type = kind[0], .depth = kind[1], .channels = kind[2]};
    c->width = number < 60 ? 2 : 1 + next_random(state) % SIDE;
    c->height = number < 60 ? 2 : 1 + next_random(state) % SIDE;
    c->interlaced = number / 15 % 2 != 0;
    for (size_t i = 0; i < SIDE * SIDE; i++) {
        for (size_t k = 0; k < CHANNELS; k++) {
            c->sample[i / SIDE][i % SIDE][k] = next_random(state) & few & most;
        }
    }
    if (c->type == 3) {
        c->colors = 1 + next_random(state) % (most + 1); /* samples may be larger */
        c->clear_size = has_clear ? 1 + next_random(state) % c->colors : 0;
        for (size_t i = 0; i < c->colors; i++) {
            memcpy(c->palette[i], state, 3);
            c->clear[i] = (uint8_t)next_random(state);
        }
    } else if (has_clear) { /* a colour, and bits above the depth that mean nothing */
        c->clear_size = 2 * (size_t)c->channels;
        for (size_t i = 0; i < c->channels; i++) {
            unsigned value = c->sample[0][0][i] | next_random(state) << c->depth;
            c->clear[2 * i] = (uint8_t)(value >> 8);
            c->clear[2 * i + 1] = (uint8_t)value;
        }
    }
}

/* What the samples of a pixel mean. */
static struct color meaning_of(const struct content *c, const unsigned *sample) {
    const unsigned most = (1u << c->depth) - 1, i = sample[0];
    uint8_t level[CHANNELS];
    bool clear = c->clear_size > 0;
    if (c->type == 3) {
        const uint8_t *color = c->palette[i], alpha = i < c->clear_size ? c->clear[i] : 255;
        const struct color known = {.r = color[0], .g = color[1], .b = color[2], .a = alpha};
        return i < c->colors ? known : color_grey(0);
    }
    for (unsigned k = 0; k < c->channels; k++) {
        level[k] = (uint8_t)floor(sample[k] * 255.0 / most + 0.5);
        unsigned value = 256u * c->clear[2 * k] + c->clear[2 * k + 1];
        clear = clear && (value & most) == sample[k];
    }
    return (struct color){.r = level[0],
                          .g = level[c->channels < 3 ? 0 : 1],
                          .b = level[c->channels < 3 ? 0 : 2],
                          .a = c->type >= 4 ? level[c->channels - 1]
                               : clear      ? 0
                                            : 255};
}

static bool shows(const struct image *image, const struct content *c) {
    const bool has_alpha = c->type >= 4 || c->clear_size > 0;
    const unsigned format = has_alpha ? IMAGE_BGRA : c->type == 0 ? IMAGE_GREY : IMAGE_BGR;
    bool same = image->width == c->width && image->height == c->height && image->format == format;
    for (uint32_t i = 0; same && i < c->width * c->height; i++) {
        uint32_t x = i % c->width, y = i / c->width;
        same = same_color(image_get(image, (int)x, (int)(c->height - 1 - y)),
                          meaning_of(c, c->sample[y][x]));
    }
    return same;
}

/* What the decoder's row filters must undo, from the definitions (section 9). */
static uint8_t predict(unsigned filter, int a, int b, int c) {
    int p = a + b - c;
    switch (filter) {
    case 1:
        return (uint8_t)a;
    case 2:
        return (uint8_t)b;
    case 3:
        return (uint8_t)((a + b) / 2);
    case 4:
        return (uint8_t)(abs(p - a) <= abs(p - b) && abs(p - a) <= abs(p - c) ? a
                         : abs(p - b) <= abs(p - c)                           ? b
                                                                              : c);
    default:
        return 0;
    }
}

/* What of a row is in a pass: its bits. Returns how many bytes they take. */
static size_t pack_row(const struct content *c, uint32_t y, int pass, uint8_t row[ROW_LIMIT]) {
    /* By the place in blocks of 8x8 (section 8.2). */
    static const char passes[8][9] = {"16462646", "77777777", "56565656", "77777777",
                                      "36463646", "77777777", "56565656", "77777777"};
    size_t bit = 0;
    memset(row, 0, ROW_LIMIT);
    for (uint32_t x = 0; x < c->width; x++) {
        bool here = (c->interlaced ? passes[y % 8][x % 8] : '1') == pass;
        for (unsigned k = 0; here && k < c->channels * c->depth; k++, bit++) {
            unsigned one = c->sample[y][x][k / c->depth] >> (c->depth - 1 - k % c->depth) & 1;
            row[bit / 8] = (uint8_t)(row[bit / 8] | one << (7 - bit % 8));
        }
    }
    return (bit + 7) / 8;
}

/* Every row has any filter. */
static void put_rows(struct bytes *file, const struct content *c, uint32_t *state) {
    const size_t step = (c->channels * c->depth + 7) / 8;
    struct bytes raw = {0};
    for (int pass = '1'; pass <= '7'; pass++) {
        uint8_t above[ROW_LIMIT] = {0}, row[ROW_LIMIT];
        for (uint32_t y = 0; y < c->height; y++) {
            size_t size = pack_row(c, y, pass, row);
            unsigned filter = next_random(state) % 5;
            for (size_t i = 0; i < size; i++) {
                int left = i >= step ? row[i - step] : 0, corner = i >= step ? above[i - step] : 0;
                if (i == 0) {
                    put(&raw, filter);
                }
                put(&raw, (unsigned)(row[i] - predict(filter, left, above[i], corner)));
            }
            memcpy(above, size > 0 ? row : above, sizeof above);
        }
    }
    put_pixels(file, raw.data, raw.size);
    bytes_free(&raw);
}

/* Returns where the tRNS chunk begins. */
static size_t put_picture(struct bytes *file, const struct content *c, uint32_t *state) {
    put_header(file, c->width, c->height, c->depth, c->type, c->interlaced);
    put_chunk(file, "teXt", "to be skipped", 13);
    if (c->colors > 0) {
        put_chunk(file, "PLTE", c->palette, 3 * c->colors);
    }
    size_t clear_at = file->size;
    if (c->clear_size > 0) {
        put_chunk(file, "tRNS", c->clear, c->clear_size);
    }
    put_rows(file, c, state);
    put_chunk(file, "IEND", NULL, 0);
    return clear_at;
}

/* Cut off before the last pixel, the file is an error. The checksums see every change of a byte; in
 * "teXt" and tRNS, which no picture needs, it is passed over (but not where its length is), and so
 * is the checksum of IEND. */
static void check_damaged(const struct bytes *file, const struct content *c, size_t clear_at) {
    const size_t text_end = 33 + 12 + 13, end = file->size - 12; /* IEND begins there */
    const size_t clear_end = clear_at + (c->clear_size > 0 ? 12 + c->clear_size : 0);
    struct image image;
    struct error error;
    for (size_t size = 0; size < file->size; size++) { /* two checksums may be missing, too */
        bool done = decode_exact(png_decode, &image, file->data, size, &error);
        CHECK(done ? size + 20 >= end && shows(&image, c) : size < end - 8);
        image_free(&image);
    }
    for (size_t at = 0; at < file->size; at++) {
        bool harmless = at >= 33 + 4 && at < text_end, of_alpha = at >= clear_at && at < clear_end;
        bool renamed = of_alpha && at >= clear_at + 4 && at < clear_at + 8;
        bool end_cut = at >= end && at < end + 4; /* its length: all is cut off that follows */
        bool longer = at >= clear_end && at < clear_end + 4; /* IDAT may seem cut off */
        file->data[at] ^= 0x10;
        bool done = decode_exact(png_decode, &image, file->data, file->size, &error);
        CHECK(renamed || longer ||
              done == (harmless || end_cut || (of_alpha && at >= clear_at + 4) ||
                       at + 4 >= file->size));
        CHECK(!(harmless || (longer && done)) || shows(&image, c));
        CHECK(at < 29 || at >= 33 || strstr(error.message, "checksum in chunk IHDR") != NULL);
        image_free(&image);
        file->data[at] ^= 0x10;
    }
}

/* Every colour type and depth, plain and interlaced, with and without a tRNS chunk. */
static void test_every_kind(void) {
    uint32_t state = 2;
    for (size_t i = 0; i < 60 * 60; i++) {
        struct content content;
        struct bytes file = {0};
        struct image image;
        struct error error;
        make_content(&content, i, &state);
        size_t clear_at = put_picture(&file, &content, &state);
        bool right = decode_exact(png_decode, &image, file.data, file.size, &error) &&
                     shows(&image, &content);
        if (!CHECK(right)) {
            fprintf(stderr, "    colour type %u of %u bits\n", content.type, content.depth);
        }
        image_free(&image);
        if (i < 60) {
            check_damaged(&file, &content, clear_at);
        }
        bytes_free(&file);
    }
}

/* A file of one pixel: chunks by letter and number of bytes, all 0. H header (13 are right), P
 * palette, T tRNS, D pixel, S the same in chunks of a byte and of none, I pixels that are none, E
 * end, o optional, X unknown, Z of a length that lies, a to d a name in which one character is no
 * letter, z one of letters at the ends of the alphabet, C that of an iPhone's file. `header`:
 * depth, colour type, compression, filter, interlace; the first byte of the pixel, after 256 times
 * its row's filter; width and height where they are not 1. */
static struct bytes make_file(const uint32_t header[8], const char *chunks) {
    static const char letters[] = "HPTSIEoXZabcdzC";
    static const char *const types[] = {"IHDR", "PLTE", "tRNS", "IDAT", "IDAT",
                                        "IEND", "tEXt", "ABCD", "teXt", "@EXt",
                                        "t[Xt", "tE`t", "tEX{", "zaZA", "CgBI"};
    static const uint8_t zeros[17000];
    const uint32_t filter = header[5] >> 8, one = header[6] == 0 && header[7] == 0;
    struct bytes file = {0}, contents = {0};
    CHECK(bytes_append(&file, signature, sizeof signature));
    put_32(&contents, header[6] + one);
    put_32(&contents, header[7] + one);
    for (int i = 0; i < 6; i++) {
        put(&contents, i < 5 ? header[i] : 0);
    }
    for (const char *c = chunks; *c != '\0';) {
        char letter = *c++, *end;
        size_t size = strtoul(c, &end, 10);
        c = end;
        const uint8_t raw[5] = {(uint8_t)filter, (uint8_t)(header[5] & 255)};
        if (letter == 'D') {
            put_pixels(&file, raw, 1 + size);
        } else if (letter == 'S') {
            struct bytes stream = store(raw, 1 + size);
            for (size_t i = 0; i < 2 * stream.size; i++) {
                put_chunk(&file, "IDAT", stream.data + i / 2, i % 2);
            }
            bytes_free(&stream);
        } else {
            const char *type = types[strchr(letters, letter) - letters];
            put_chunk(&file, type, letter == 'H' ? contents.data : zeros, size);
        }
        if (letter == 'Z') {
            memcpy(file.data + file.size - 12, "\x7f\xff\xff\xff", 4);
        }
    }
    bytes_free(&contents);
    return file;
}

static void test_chunks(void) {
    static const struct {
        const char *name, *chunks, *message; /* NULL: it can be read */
        uint32_t header[8];
    } rows[] = {
        {"RGB", "H13D3E", NULL, {8, 2, 0, 0, 0}},
        {"a palette that only suggests colours", "H13P768D3E", NULL, {8, 2, 0, 0, 0}},
        {"an optional chunk", "H13o5D3o0E", NULL, {8, 2, 0, 0, 0}},
        {"byte by byte", "H13S3E", NULL, {8, 2, 0, 0, 0}},
        {"a name with @", "H13a0D3E", "without a name at byte 33", {8, 2, 0, 0, 0}},
        {"a name with [", "H13b0D3E", "without a name at byte 33", {8, 2, 0, 0, 0}},
        {"a name with `", "H13c0D3E", "without a name at byte 33", {8, 2, 0, 0, 0}},
        {"a name with {", "H13d0D3E", "without a name at byte 33", {8, 2, 0, 0, 0}},
        {"a name of a, z, A and Z", "H13z0D3E", NULL, {8, 2, 0, 0, 0}},
        {"a header of 12 bytes", "H12D3E", "begin with a header", {8, 2, 0, 0, 0}},
        {"a header of 14 bytes", "H14D3E", "begin with a header", {8, 2, 0, 0, 0}},
        {"no header", "o0D3E", "begin with a header", {8, 2, 0, 0, 0}},
        {"compression 1", "H13D3E", "compression or filter method", {8, 2, 1, 0, 0}},
        {"filter method 1", "H13D3E", "compression or filter method", {8, 2, 0, 1, 0}},
        {"colour type 5", "H13D3E", "colour type, 5", {8, 5, 0, 0, 0}},
        {"grey with a palette", "H13P3D1E", NULL, {8, 0, 0, 0, 0}},
        {"grey and alpha with a palette", "H13P3D2E", NULL, {8, 4, 0, 0, 0}},
        {"an empty palette", "H13P0D1E", "palette of 0 bytes", {8, 3, 0, 0, 0}},
        {"257 colours", "H13P771D1E", "palette of 771 bytes", {8, 3, 0, 0, 0}},
        {"257 suggested colours", "H13P771D3E", NULL, {8, 2, 0, 0, 0}},
        {"half a suggested colour", "H13P4D3E", NULL, {8, 2, 0, 0, 0}},
        {"tRNS before a suggestion", "H13T6P3D3E", NULL, {8, 2, 0, 0, 0}},
        {"a palette after the pixels", "H13D3P3E", NULL, {8, 2, 0, 0, 0}},
        {"an end with contents", "H13D3E1", NULL, {8, 2, 0, 0, 0}},
        {"pixels in two parts", "H13D3o1D3E", "between its pixel data", {8, 2, 0, 0, 0}},
        {"an unknown chunk at the end", "H13D3XE", "unknown chunk, ABCD", {8, 2, 0, 0, 0}},
        {"a palette of 1 bit", "H13P6T2D1E", NULL, {1, 3, 0, 0, 0}},
        {"more after the end", "H13P6D1EX", NULL, {1, 3, 0, 0, 0}},
        {"nothing", "", "cut off", {1, 3, 0, 0, 0}},
        {"two headers", "H13H13P6D1E", "a second header", {1, 3, 0, 0, 0}},
        {"two palettes", "H13P3P6D1E", NULL, {1, 3, 0, 0, 0}},
        {"half an entry", "H13P4D1E", "palette of 4 bytes", {1, 3, 0, 0, 0}},
        {"more than the bits allow", "H13P9D1E", NULL, {1, 3, 0, 0, 0}},
        {"no palette", "H13D1E", "without its palette", {8, 3, 0, 0, 0}},
        {"a pixel outside it", "H13P3D1E", NULL, {8, 3, 0, 0, 0, 1}},
        {"no data", "H13P6E", "without pixel data", {1, 3, 0, 0, 0}},
        {"no end", "H13P6D1", NULL, {1, 3, 0, 0, 0}},
        {"cut off behind the pixels", "H13P6D1Z0", NULL, {1, 3, 0, 0, 0}},
        {"cut off before the pixels", "H13P6", "cut off", {1, 3, 0, 0, 0}},
        {"an iPhone's", "C4H13D3E", "an iPhone's PNG (CgBI)", {8, 2, 0, 0, 0}},
        {"lying length", "H13Z0D1E", "2147483647 bytes, but 37 are left", {8, 0, 0, 0, 0}},
        {"interlaced", "H13D1E", NULL, {8, 0, 0, 0, 1}},
        {"another interlace", "H13D1E", "interlace method", {8, 0, 0, 0, 2}},
        {"16 bits", "H13D2E", NULL, {16, 0, 0, 0, 0}},
        {"RGB of 4 bits", "H13D2E", "cannot have 4 bits", {4, 2, 0, 0, 0}},
        {"palette of 16 bits", "H13P6D2E", "cannot have 16 bits", {16, 3, 0, 0, 0}},
        {"no bits", "H13D1E", "cannot have 0 bits", {0, 0, 0, 0, 0}},
        {"3 bits", "H13D1E", "cannot have 3 bits", {3, 0, 0, 0, 0}},
        {"colour type 1", "H13D1E", "unknown colour type, 1", {8, 1, 0, 0, 0}},
        {"colour type 7", "H13D1E", "unknown colour type, 7", {8, 7, 0, 0, 0}},
        {"smaller than the data", "H13D2E", NULL, {8, 0, 0, 0, 0}},
        {"smaller by a row", "H13D3S0E", NULL, {8, 0, 0, 0, 0}},
        {"larger than the data", "H13D2E", "smaller", {8, 2, 0, 0, 0}},
        {"no width", "H13D1E", "0x1 pixels", {8, 0, 0, 0, 0, 0, 0, 1}},
        {"no height", "H13D1E", "1x0 pixels", {8, 0, 0, 0, 0, 0, 1, 0}},
        {"2^31 wide", "H13D1E", "2147483648x1 pixels", {8, 0, 0, 0, 0, 0, 0x80000000u, 1}},
        {"2^32-1 high", "H13D1E", "x4294967295 pixels: a side", {8, 0, 0, 0, 0, 0, 1, UINT32_MAX}},
        {"65536 wide", "H13D1E", "65536x1 pixels: a side", {8, 0, 0, 0, 0, 0, 65536, 1}},
        {"far larger", "H13D1E", "cannot hold", {8, 6, 0, 0, 0, 0, 65535, 65535}},
        {"RGBA", "H13I99E", "99 bytes cannot hold 999x1000 pixels", {8, 6, 0, 0, 0, 0, 999, 1000}},
        {"8192 x 8192", "H13I8200E", "not a zlib stream", {1, 0, 0, 0, 0, 0, 8192, 8192}},
        {"8192 x 8193",
         "H13I8200E",
         "8192x8193 pixels in 8200 bytes",
         {1, 0, 0, 0, 0, 0, 8192, 8193}},
        {"a filter of 5", "H13D2E", "filter, 5", {8, 4, 0, 0, 0, 0x500}},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct image image;
        struct error error;
        struct bytes file = make_file(rows[i].header, rows[i].chunks);
        bool done = decode_exact(png_decode, &image, file.data, file.size, &error);
        CHECK_ROW(done == (rows[i].message == NULL), rows[i].name);
        if (!done && rows[i].message != NULL) {
            CHECK_ROW(strstr(error.message, rows[i].message) != NULL, error.message);
        }
        image_free(&image);
        bytes_free(&file);
    }
}

/* A tRNS chunk that is of no use is passed over: the picture has no alpha but its own. */
static void test_useless_alpha(void) {
    static const struct {
        const char *name, *chunks;
        enum image_format format;
        uint32_t header[8];
    } rows[] = {
        {"useful, of RGB", "H13T6D3E", IMAGE_BGRA, {8, 2, 0, 0, 0}},
        {"useful, of a palette", "H13P6T2D1E", IMAGE_BGRA, {1, 3, 0, 0, 0}},
        {"of grey and alpha", "H13T2D2E", IMAGE_BGRA, {8, 4, 0, 0, 0}},
        {"of RGBA", "H13T6D4E", IMAGE_BGRA, {8, 6, 0, 0, 0}},
        {"of RGBA, with its alpha", "H13T8D4E", IMAGE_BGRA, {8, 6, 0, 0, 0}},
        {"after the pixels", "H13D3T6E", IMAGE_BGR, {8, 2, 0, 0, 0}},
        {"of a palette, empty", "H13P3T0D1E", IMAGE_BGR, {8, 3, 0, 0, 0}},
        {"of RGB, too short", "H13T5D3E", IMAGE_BGR, {8, 2, 0, 0, 0}},
        {"of RGB, too long", "H13T7D3E", IMAGE_BGR, {8, 2, 0, 0, 0}},
        {"of grey, too long", "H13T6D1E", IMAGE_GREY, {8, 0, 0, 0, 0}},
        {"before its palette", "H13T2P6D1E", IMAGE_BGR, {1, 3, 0, 0, 0}},
        {"of a palette, too long", "H13P6T3D1E", IMAGE_BGR, {1, 3, 0, 0, 0}},
        {"twice", "H13T7T6T2D3E", IMAGE_BGRA, {8, 2, 0, 0, 0}},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct image image;
        struct error error;
        struct bytes file = make_file(rows[i].header, rows[i].chunks);
        CHECK_ROW(decode_exact(png_decode, &image, file.data, file.size, &error), rows[i].name);
        CHECK_ROW(image.format == rows[i].format, rows[i].name);
        bool clear = image.format == IMAGE_BGRA; /* all is 0, also what is transparent */
        CHECK_ROW(image.pixels != NULL && image_get(&image, 0, 0).a == (clear ? 0 : 255),
                  rows[i].name);
        image_free(&image);
        bytes_free(&file);
    }
}

/* ---- PNG out ---- */

enum picture { NOISE, SHADES, FLAT, STAIRS, PICTURES };

static struct image make_image(size_t width, size_t height, enum image_format format,
                               enum picture picture, uint32_t *state) {
    struct image image = new_image(width, height, format);
    for (size_t y = 0; y < height; y++) {
        for (size_t x = 0; x < width; x++) {
            uint32_t noise = next_random(state);
            struct color color = {.b = (uint8_t)noise,
                                  .g = (uint8_t)(noise >> 8),
                                  .r = (uint8_t)(noise >> 16),
                                  .a = (uint8_t)(noise >> 4)};
            if (picture == SHADES) {
                color = (struct color){(uint8_t)(2 * x + y), (uint8_t)(x * y / 8 + noise % 2),
                                       (uint8_t)(200 - y), (uint8_t)(255 - x)};
            } else if (picture == FLAT) {
                color = color_rgb((uint8_t)((x / 9 + y / 7) % 3 * 90), 255, y < 20 ? 255 : 0);
            } else if (picture == STAIRS) {
                color = color_grey((uint8_t)(x / 9));
            }
            image_set(&image, (int)x, (int)y, color);
        }
    }
    return image;
}

/* In all just so many bytes: with another choice of filters they are other ones, and so are the
 * lessons' pictures. */
static void test_round_trip(void) {
    static const enum image_format formats[] = {IMAGE_GREY, IMAGE_BGR, IMAGE_BGRA};
    static const uint8_t color_types[] = {0, 2, 6};
    static const size_t sizes[][2] = {{1, 1}, {2, 1}, {1, 3}, {64, 50}, {131, 3}};
    uint32_t state = 4;
    size_t total = 0;
    for (size_t i = 0; i < 3 * PICTURES * 5; i++) {
        struct bytes file = {0};
        struct image again;
        struct error error;
        struct image image = make_image(sizes[i / (3 * PICTURES)][0], sizes[i / (3 * PICTURES)][1],
                                        formats[i % 3], (enum picture)(i / 3 % PICTURES), &state);
        put(&file, 66);
        CHECK(png_encode(&image, &file, &error) && file.data[0] == 66);
        CHECK(file.data[1 + 24] == 8 && file.data[1 + 25] == color_types[i % 3]);
        if (CHECK(decode_exact(png_decode, &again, file.data + 1, file.size - 1, &error))) {
            CHECK(same_image(&image, &again));
        }
        total += file.size;
        image_free(&again);
        image_free(&image);
        bytes_free(&file);
    }
    CHECK(total == 39225);
}

/* ---- Animation ---- */

/* Paste a part over an image; x, y from the top left. */
static void paste(struct image *image, const struct image *part, size_t x, size_t y) {
    for (size_t row = 0; row < part->height; row++) {
        int to = (int)(image->height - y - part->height + row);
        for (size_t column = 0; column < part->width; column++) {
            CHECK(image_set(image, (int)(x + column), to, image_get(part, (int)column, (int)row)));
        }
    }
}

/* Play an animation as a viewer does, each frame as its own PNG, and compare. Returns the sum
 * of the frames' areas. */
static size_t play(const struct bytes *file, const struct image *frames, size_t count,
                   unsigned delay_ms) {
    struct image shown = {0};
    struct error error;
    uint8_t header[13];
    bool told = false; /* how many frames there are */
    size_t done = 0, sequence = 0, area = 0, pending_width = 0, pending_height = 0, x = 0, y = 0;
    memcpy(header, file->data + 16, 13);
    CHECK(image_create(&shown, frames->width, frames->height, frames->format, &error));
    for (size_t at = 33; at < file->size;) {
        size_t size = get_32(file->data + at);
        const uint8_t *type = file->data + at + 4, *data = type + 4;
        CHECK(slow_crc(type, size + 4) == get_32(data + size));
        at += size + 12;
        if (memcmp(type, "acTL", 4) == 0) {
            CHECK(size == 8 && get_32(data) == count && get_32(data + 4) == 0 && done == 0);
            told = true;
        } else if (memcmp(type, "fcTL", 4) == 0) {
            CHECK(size == 26 && get_32(data) == sequence++);
            pending_width = get_32(data + 4);
            pending_height = get_32(data + 8);
            x = get_32(data + 12);
            y = get_32(data + 16);
            area += pending_width * pending_height;
            CHECK(data[20] * 256u + data[21] == delay_ms && data[22] * 256u + data[23] == 1000);
            CHECK(data[24] == 0 && data[25] == 0);
        } else if (memcmp(type, "IDAT", 4) == 0 || memcmp(type, "fdAT", 4) == 0) {
            struct bytes single = {0};
            struct image part;
            bool first = type[0] == 'I';
            CHECK(first == (done == 0));
            CHECK(first || get_32(data) == sequence++);
            put_header(&single, (uint32_t)pending_width, (uint32_t)pending_height, header[8],
                       header[9], 0);
            put_chunk(&single, "IDAT", data + (first ? 0 : 4), size - (first ? 0 : 4));
            put_chunk(&single, "IEND", NULL, 0);
            if (CHECK(decode_exact(png_decode, &part, single.data, single.size, &error))) {
                paste(&shown, &part, x, y);
            }
            CHECK(done < count && same_image(&shown, &frames[done]));
            done++;
            image_free(&part);
            bytes_free(&single);
        } else {
            CHECK(memcmp(type, "IEND", 4) == 0 && at == file->size);
        }
    }
    CHECK(told && done == count);
    image_free(&shown);
    return area;
}

static void test_animation(void) {
    static const enum image_format formats[] = {IMAGE_GREY, IMAGE_BGR, IMAGE_BGRA};
    enum { COUNT = 5, WIDTH = 20, HEIGHT = 30 };
    uint32_t state = 6;
    for (size_t i = 0; i < 3; i++) {
        struct image frames[COUNT], still;
        struct bytes file = {0};
        struct error error;
        frames[0] = make_image(WIDTH, HEIGHT, formats[i], SHADES, &state);
        for (size_t k = 1; k < COUNT; k++) {
            frames[k] = copy_of(&frames[k - 1]);
        }
        /* 1: a rectangle of 3x2; 2: two corners; 3: nothing; 4: as 2, one pixel changed */
        for (size_t k = 1; k < COUNT; k++) {
            image_set(&frames[k], 4, 9, color_grey(77));
            image_set(&frames[k], 6, 8, color_grey(78));
            image_set(&frames[k], 0, 0, color_grey(k > 1 ? 79 : frames[k].pixels[0]));
            image_set(&frames[k], WIDTH - 1, HEIGHT - 1, color_grey(k > 1 ? 80 : 81));
        }
        image_set(&frames[4], 11, 12, color_grey(99));
        for (size_t k = 0; k < 2; k++) { /* the corners of 0 and 1 are equal */
            image_set(&frames[k], 0, 0, color_grey(1));
            image_set(&frames[k], WIDTH - 1, HEIGHT - 1, color_grey(81));
        }
        CHECK(apng_encode(frames, COUNT, 41, &file, &error));
        CHECK(play(&file, frames, COUNT, 41) == 600 + 6 + 600 + 1 + 1);
        /* A viewer without animation shows the first frame. */
        CHECK(decode_exact(png_decode, &still, file.data, file.size, &error) &&
              same_image(&still, &frames[0]));
        image_free(&still);
        for (size_t k = 0; k < COUNT; k++) {
            image_free(&frames[k]);
        }
        bytes_free(&file);
    }
}

/* Frames without a difference: a part of one pixel, also where there is no other. */
static void test_still_animation(void) {
    struct image frames[2] = {new_image(1, 1, IMAGE_GREY), new_image(1, 1, IMAGE_GREY)};
    struct bytes file = {0};
    struct error error;
    CHECK(apng_encode(frames, 2, 40, &file, &error));
    CHECK(play(&file, frames, 2, 40) == 2);
    image_free(&frames[0]);
    image_free(&frames[1]);
    bytes_free(&file);
}

UNIT_MAIN(TEST(test_every_kind), TEST(test_chunks), TEST(test_useless_alpha), TEST(test_round_trip),
          TEST(test_animation), TEST(test_still_animation))
