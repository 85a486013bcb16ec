/*
 * Tests of common/tgaimage.c: images and TGA.
 *
 * TGA files are put together here byte by byte from the specification, by a writer that shares
 * nothing with the one under test. Every file is decoded from a block of exactly its size, so that
 * the address sanitizer sees a read past its end.
 */
#include "tgaimage.h"

#include "base/file.h"
#include "unit/images.h"

#include <math.h>

/* ---- Images ---- */

static void test_create(void) {
    struct image image = {0};
    struct error error;
    image_free(&image);
    CHECK(!image_create(&image, 0, 1, IMAGE_BGR, &error) && image.pixels == NULL);
    CHECK(!image_create(&image, 1, 0, IMAGE_BGR, &error) && image.pixels == NULL);
    CHECK(strstr(error.message, "1x0 pixels: a side has 1 to 65535") != NULL);
    image.width = 1;
    CHECK(!image_create(&image, 65536, 1, IMAGE_GREY, &error) && image.pixels == NULL);
    CHECK(image.width == 0 && image.height == 0);
    CHECK(!image_create(&image, 1, SIZE_MAX, IMAGE_GREY, &error) && image.pixels == NULL);
    CHECK(image_create(&image, 65535, 1, IMAGE_GREY, &error) && image.width == 65535);
    image_free(&image);
    CHECK(image.pixels == NULL && image.width == 0);
    CHECK(image_create(&image, 1, 65535, IMAGE_GREY, &error) && image.height == 65535);
    image_free(&image);
}

static void test_get_and_set(void) {
    static const struct {
        const char *name;
        enum image_format format;
        struct color got; /* after setting {1, 2, 3, 4} */
        uint8_t bytes[4];
    } rows[] = {
        {"grey", IMAGE_GREY, {1, 1, 1, 255}, {1}},
        {"BGR", IMAGE_BGR, {1, 2, 3, 255}, {1, 2, 3}},
        {"BGRA", IMAGE_BGRA, {1, 2, 3, 4}, {1, 2, 3, 4}},
    };
    static const int outside[][2] = {
        {-1, 0}, {0, -1}, {3, 0}, {0, 2}, {INT32_MAX, 0}, {0, INT32_MAX}, {INT32_MIN, INT32_MIN}};
    const struct color color = {.b = 1, .g = 2, .r = 3, .a = 4};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct image image, before;
        struct error error;
        size_t step = (size_t)rows[i].format;
        CHECK(image_create(&image, 3, 2, rows[i].format, &error));
        CHECK_ROW(image_set(&image, 2, 1, color), rows[i].name);
        CHECK_ROW(same_color(image_get(&image, 2, 1), rows[i].got), rows[i].name);
        CHECK_ROW(memcmp(image.pixels + 5 * step, rows[i].bytes, step) == 0, rows[i].name);
        CHECK_ROW(image.pixels[4 * step] == 0, rows[i].name);
        before = copy_of(&image);
        for (size_t k = 0; k < sizeof outside / sizeof outside[0]; k++) {
            int x = outside[k][0], y = outside[k][1];
            CHECK_ROW(!image_set(&image, x, y, color), rows[i].name);
            CHECK_ROW(same_color(image_get(&image, x, y), (struct color){0}), rows[i].name);
        }
        CHECK_ROW(same_image(&before, &image), rows[i].name);
        image_clear(&image, (struct color){0});
        image_fill_row(&image, 1, 1, 3, color);
        image_fill_row(&image, 0, 1, 2, color);
        image_fill_row(&image, 0, 2, 2, color);
        image_fill_row(&image, 0, 3, 1, color);
        for (int k = 0; k < 6; k++) {
            bool filled = k == 1 || k == 4 || k == 5;
            CHECK_ROW((memcmp(image.pixels + (size_t)k * step, rows[i].bytes, step) == 0) == filled,
                      rows[i].name);
        }
        image_clear(&image, color);
        for (int k = 0; k < 6; k++) {
            CHECK_ROW(same_color(image_get(&image, k % 3, k / 3), rows[i].got), rows[i].name);
        }
        image_free(&before);
        image_free(&image);
    }
}

/* ---- TGA in ---- */

enum { WIDTH = 31, HEIGHT = 11, PIXELS = WIDTH * HEIGHT, MAP_FIRST = 100, MAP_LENGTH = 7 };

/* One kind of file, and what must come out. */
struct kind {
    const char *name;
    uint8_t type, depth, map_depth, attribute_bits;
    enum image_format format;
};

static const struct kind kinds[] = {
    {"colour map of 15 bits", 1, 8, 15, 0, IMAGE_BGR},
    {"colour map of 16 bits", 1, 8, 16, 0, IMAGE_BGR},
    {"colour map of 16 bits with alpha", 1, 8, 16, 1, IMAGE_BGRA},
    {"colour map of 24 bits", 1, 8, 24, 0, IMAGE_BGR},
    {"colour map of 32 bits", 1, 8, 32, 8, IMAGE_BGRA},
    {"15 bits", 2, 15, 0, 0, IMAGE_BGR},
    {"16 bits", 2, 16, 0, 0, IMAGE_BGR},
    {"16 bits with alpha", 2, 16, 0, 1, IMAGE_BGRA},
    {"24 bits", 2, 24, 0, 0, IMAGE_BGR},
    {"24 bits that claim one of attributes", 2, 24, 0, 1, IMAGE_BGR},
    {"24 bits with a colour map to skip", 2, 24, 9, 0, IMAGE_BGR},
    {"map of 24 bits, indices of 16", 1, 16, 24, 0, IMAGE_BGR},
    {"map of 32 bits, indices of 16", 1, 16, 32, 8, IMAGE_BGRA},
    {"map of 15 bits, indices of 16", 1, 16, 15, 0, IMAGE_BGR},
    {"32 bits", 2, 32, 0, 8, IMAGE_BGRA},
    {"grey", 3, 8, 0, 0, IMAGE_GREY},
    {"grey with a colour map to skip", 3, 8, 24, 0, IMAGE_GREY},
    {"grey and alpha", 3, 16, 0, 8, IMAGE_BGRA},
    {"grey and alpha, of which the header says nothing", 3, 16, 0, 0, IMAGE_BGRA},
};
enum { KIND_COUNT = sizeof kinds / sizeof kinds[0] };

static void put_16(struct bytes *file, unsigned value) {
    put(file, value & 255);
    put(file, value >> 8);
}

/* A stored colour of `depth` bits made from a number, and the color that it must become. */
static struct color put_color(struct bytes *file, unsigned depth, bool has_attribute,
                              uint32_t number) {
    unsigned b = number & 255, g = number >> 8 & 255, r = number >> 16 & 255;
    unsigned a = (number >> 5 & 255) ^ 0x5a;
    if (depth == 8) {
        put(file, b);
        return color_grey((uint8_t)b);
    }
    if (depth <= 16) {
        b &= 31;
        g &= 31;
        r &= 31;
        put_16(file, (a & 1) << 15 | r << 10 | g << 5 | b);
        return (struct color){.b = (uint8_t)floor(b * 255 / 31.0 + 0.5),
                              .g = (uint8_t)floor(g * 255 / 31.0 + 0.5),
                              .r = (uint8_t)floor(r * 255 / 31.0 + 0.5),
                              .a = !has_attribute || (a & 1) != 0 ? 255 : 0};
    }
    put(file, b);
    put(file, g);
    put(file, r);
    if (depth == 32) {
        put(file, a);
    }
    return (struct color){
        .b = (uint8_t)b, .g = (uint8_t)g, .r = (uint8_t)r, .a = depth == 32 ? (uint8_t)a : 255};
}

/* How many pixels a file has, and the most in a packet. */
struct layout {
    unsigned width, height, longest;
};

/* An image of three bytes a pixel ends a byte before a line of the cache does. */
static const struct layout small = {WIDTH, HEIGHT, 128};

/* A whole file; `expected` becomes its pixels in the order of the file. */
static void put_tga(struct bytes *file, const struct kind *kind, struct layout layout,
                    unsigned origin, bool run_length, unsigned id_size, struct color *expected,
                    uint32_t *state) {
    const size_t pixels = (size_t)layout.width * layout.height;
    const bool mapped = kind->type == 1, attribute = kind->attribute_bits == 1;
    struct color map[MAP_LENGTH];
    put(file, id_size);
    put(file, kind->map_depth != 0);
    put(file, kind->type + (run_length ? 8u : 0u));
    put_16(file, MAP_FIRST);
    put_16(file, MAP_LENGTH); /* of a map that there may not be */
    put(file, kind->map_depth != 0 ? kind->map_depth : 24u);
    put_16(file, 1000); /* the place on a screen: of no interest */
    put_16(file, 2000);
    put_16(file, layout.width);
    put_16(file, layout.height);
    put(file, kind->depth);
    put(file, origin << 4 | kind->attribute_bits);
    for (unsigned i = 0; i < id_size; i++) {
        put(file, 0xee);
    }
    for (unsigned i = 0; i < MAP_LENGTH && kind->map_depth != 0; i++) {
        map[i] = put_color(file, kind->map_depth, attribute, next_random(state));
    }
    for (size_t done = 0; done < pixels;) {
        size_t count = pixels - done;
        bool run = false;
        if (run_length) { /* packets of random lengths, most of them across the end of a row */
            size_t wanted = 1 + next_random(state) % layout.longest;
            count = wanted < count ? wanted : count;
            run = next_random(state) % 2 == 0;
            put(file, (unsigned)(count - 1) | (run ? 128u : 0u));
        }
        for (size_t i = 0; i < count; i++) {
            uint32_t number = next_random(state);
            if (run && i > 0) {
                expected[done + i] = expected[done];
            } else if (mapped) {
                put(file, MAP_FIRST + number % MAP_LENGTH);
                if (kind->depth == 16) {
                    put(file, 0);
                }
                expected[done + i] = map[number % MAP_LENGTH];
            } else if (kind->type == 3 && kind->depth == 16) {
                put_16(file, number & 0xffff);
                expected[done + i] = color_grey((uint8_t)number);
                expected[done + i].a = (uint8_t)(number >> 8);
            } else {
                expected[done + i] = put_color(file, kind->depth, attribute, number);
            }
        }
        done += count;
    }
}

/* Packets of all lengths, in images of which most can be read in large pieces: up to the last byte
 * of the file and the last pixel. */
static void test_every_kind_of_tga(void) {
    enum { ACROSS = 124, ROWS = 6, ALL = ACROSS * ROWS };
    static const struct layout large = {ACROSS, ROWS, 128};
    uint32_t state = 3;
    for (size_t i = 0; i < KIND_COUNT * 4 * 2 * 2; i++) {
        const struct kind *kind = &kinds[i % KIND_COUNT];
        unsigned origin = (unsigned)(i / KIND_COUNT % 4); /* 1: right to left, 2: top to bottom */
        bool run_length = i / KIND_COUNT / 4 % 2 != 0;
        unsigned id_size = i / KIND_COUNT / 8 != 0 ? 255 : 0;
        struct bytes file = {0};
        struct color expected[ALL];
        struct image image;
        struct error error;
        put_tga(&file, kind, large, origin, run_length, id_size, expected, &state);
        for (unsigned k = 0; k < id_size; k++) { /* or nothing of the file is near its end */
            put(&file, 99);
        }
        if (CHECK_ROW(decode_exact(tga_decode, &image, file.data, file.size, &error), kind->name)) {
            CHECK_ROW(image.width == ACROSS && image.height == ROWS, kind->name);
            CHECK_ROW(image.format == kind->format, kind->name);
            for (int k = 0; k < ALL; k++) {
                int x = k % ACROSS, y = k / ACROSS;
                x = (origin & 1) != 0 ? ACROSS - 1 - x : x;
                y = (origin & 2) != 0 ? ROWS - 1 - y : y;
                CHECK_ROW(same_color(image_get(&image, x, y), expected[k]), kind->name);
            }
        }
        image_free(&image);
        bytes_free(&file);
    }
}

/* Cut off anywhere, a file is an error and leaves nothing; with bytes after its end it is none. */
static void test_cut_off_tga(void) {
    uint32_t state = 4;
    for (size_t i = 0; i < KIND_COUNT * 2; i++) {
        const struct kind *kind = &kinds[i % KIND_COUNT];
        struct bytes file = {0};
        struct color expected[PIXELS];
        struct image image;
        struct error error;
        put_tga(&file, kind, small, 0, i >= KIND_COUNT, 3, expected, &state);
        for (size_t size = 0; size < file.size; size++) {
            CHECK_ROW(!decode_exact(tga_decode, &image, file.data, size, &error), kind->name);
        }
        put(&file, 99);
        CHECK_ROW(decode_exact(tga_decode, &image, file.data, file.size, &error), kind->name);
        image_free(&image);
        bytes_free(&file);
    }
}

/* Files that lie: the header, what follows it, and a part of the message. */
static void test_lying_tga(void) {
    static const struct {
        const char *name, *message, *bytes;
        size_t size;
    } rows[] = {
        {"26000x26000 in 18 bytes", "at least 2028000000 bytes",
         "\0\0\2\0\0\0\0\0\0\0\0\0\220\145\220\145\30\0", 18},
        {"the same in packets", "at least 21125000 bytes",
         "\0\0\12\0\0\0\0\0\0\0\0\0\220\145\220\145\30\0", 18},
        {"129x1 in a packet", "129x1 pixels take at least 8 bytes, but 4",
         "\0\0\12\0\0\0\0\0\0\0\0\0\201\0\1\0\30\0\377\1\2\3", 22},
        {"65535x65535", "at least 17179344900 bytes",
         "\0\0\2\0\0\0\0\0\0\0\0\0\377\377\377\377\40\0", 18},
        {"no width", "of 0x1 pixels has no picture", "\0\0\3\0\0\0\0\0\0\0\0\0\0\0\1\0\10\0\11",
         19},
        {"no height", "has no picture", "\0\0\3\0\0\0\0\0\0\0\0\0\1\0\0\0\10\0\11", 19},
        {"no image", "type 0", "\0\0\0\0\0\0\0\0\0\0\0\0\1\0\1\0\10\0\11", 19},
        {"type 32", "type 32", "\0\0\40\0\0\0\0\0\0\0\0\0\1\0\1\0\10\0\11", 19},
        {"type 12", "type 12", "\0\0\14\0\0\0\0\0\0\0\0\0\1\0\1\0\10\0\11", 19},
        {"grey of 24 bits", "grey pixels of 24 bits",
         "\0\0\3\0\0\0\0\0\0\0\0\0\1\0\1\0\30\0\11\11\11", 21},
        {"indexes of 24 bits", "colour-mapped pixels of 24 bits",
         "\0\1\1\0\0\1\0\30\0\0\0\0\1\0\1\0\30\0\1\2\3\0\0\0", 24},
        {"colour of 8 bits", "true-colour pixels of 8 bits",
         "\0\0\2\0\0\0\0\0\0\0\0\0\1\0\1\0\10\0\11", 19},
        {"mapped without a map", "without a colour map", "\0\0\1\0\0\0\0\30\0\0\0\0\1\0\1\0\10\0\0",
         19},
        {"mapped with an empty map", "without a colour map",
         "\0\1\1\0\0\0\0\30\0\0\0\0\1\0\1\0\10\0\0", 19},
        {"map of 8 bits", "colour map of 8 bits", "\0\1\1\0\0\1\0\10\0\0\0\0\1\0\1\0\10\0\11\0",
         20},
        {"map cut off", "before its pixels", "\0\1\2\0\0\377\377\40\0\0\0\0\1\0\1\0\30\0\1\2\3",
         21},
        {"id cut off", "before its pixels", "\11\0\3\0\0\0\0\0\0\0\0\0\1\0\1\0\10\0\11", 19},
        {"run past the last pixel", "packet of 3 pixels, but only 2",
         "\0\0\13\0\0\0\0\0\0\0\0\0\2\0\1\0\10\0\202\7", 20},
        {"raw packet past the last pixel", "packet of 3 pixels, but only 2",
         "\0\0\13\0\0\0\0\0\0\0\0\0\2\0\1\0\10\0\2\7\10\11", 22},
        {"a packet too few", "cut off: 1 pixels are missing",
         "\0\0\13\0\0\0\0\0\0\0\0\0\2\0\1\0\10\0\0\7", 20},
        {"interleaved", "interleaved", "\0\0\3\0\0\0\0\0\0\0\0\0\1\0\1\0\10\100\11", 19},
        {"unknown map", "map type 2", "\0\2\3\0\0\0\0\0\0\0\0\0\1\0\1\0\10\0\11", 19},
        {"nothing", "too few for a header", "", 0},
        {"a header without its last byte", "too few for a header",
         "\0\0\3\0\0\0\0\0\0\0\0\0\1\0\1\0\10", 17},
        {"a header alone", "at least 1 bytes", "\0\0\3\0\0\0\0\0\0\0\0\0\1\0\1\0\10\0", 18},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct image image = {.width = 1};
        struct error error;
        CHECK_ROW(
            !decode_exact(tga_decode, &image, (const uint8_t *)rows[i].bytes, rows[i].size, &error),
            rows[i].name);
        CHECK_ROW(image.width == 0 && image.pixels == NULL, rows[i].name);
        CHECK_ROW(strstr(error.message, rows[i].message) != NULL, error.message);
    }
}

/* Colours below and above those of the map, which begins with 5, are black and opaque. */
static void test_colors_without_map(void) {
    static const uint8_t head[] = {0, 1, 1, 5, 0, 1, 0, 0, 0, 0, 0, 0, 3, 0, 1, 0, 8, 0};
    for (size_t depth = 24; depth <= 32; depth += 8) {
        uint8_t file[18 + 4 + 3] = {0}, *map = file + 18;
        struct image image;
        struct error error;
        memcpy(file, head, sizeof head);
        file[7] = (uint8_t)depth;
        memcpy(map, "\1\2\3\4", depth / 8);
        memcpy(map + depth / 8, "\4\5\6", 3);
        if (CHECK(decode_exact(tga_decode, &image, file, 18 + depth / 8 + 3, &error))) {
            const struct color black = {.a = 255};
            const struct color known = {1, 2, 3, depth == 32 ? 4 : 255};
            CHECK(same_color(image_get(&image, 0, 0), black));
            CHECK(same_color(image_get(&image, 1, 0), known));
            CHECK(same_color(image_get(&image, 2, 0), black));
        }
        image_free(&image);
    }
}

/* The high byte of an index of 16 bits counts. */
static void test_many_colors(void) {
    enum { COLORS = 1000 };
    struct bytes file = {0};
    struct image image;
    struct error error;
    CHECK(bytes_append(&file, "\0\1\1\0\0\350\3\30\0\0\0\0\350\3\1\0\20\0", 18));
    for (unsigned i = 0; i < COLORS; i++) {
        put_16(&file, i);
        put(&file, 7);
    }
    for (unsigned i = 0; i < COLORS; i++) {
        put_16(&file, COLORS - 1 - i);
    }
    if (CHECK(decode_exact(tga_decode, &image, file.data, file.size, &error))) {
        for (unsigned i = 0; i < COLORS; i++) {
            struct color c = image_get(&image, (int)i, 0);
            CHECK(c.b + 256u * c.g == COLORS - 1 - i && c.r == 7);
        }
    }
    image_free(&image);
    bytes_free(&file);
}

/* Up to 8192 x 8192 pixels any file may have; more need a byte for every 16. */
static void test_check_size(void) {
    static const struct {
        size_t width, height, bytes;
        bool right;
    } rows[] = {
        {1, 1, 0, true},
        {8192, 8192, 0, true},
        {8192, 8193, 4194815, false},
        {8192, 8193, 4194816, true},
        {30000, 30000, 875000, false},
        {65535, 65535, 268427263, false},
        {65535, 65535, 268427264, true},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct error error;
        CHECK(image_check_size(rows[i].width, rows[i].height, rows[i].bytes, &error) ==
              rows[i].right);
        CHECK(rows[i].right || strstr(error.message, "need a byte for every 16") != NULL);
    }
    /* 16384 x 16384 pixels in the fewest packets: a byte for 64. */
    struct bytes file = {0};
    struct image image;
    struct error error;
    CHECK(bytes_append(&file, "\0\0\13\0\0\0\0\0\0\0\0\0\0\100\0\100\10\0", 18));
    for (int i = 0; i < 16384 * 128; i++) {
        put(&file, 255);
        put(&file, 9);
    }
    CHECK(!tga_decode(&image, file.data, file.size, &error) && image.pixels == NULL);
    CHECK(strstr(error.message, "16384x16384 pixels in 4194304 bytes") != NULL);
    bytes_free(&file);
}

/* ---- TGA out ---- */

/* Bytes of the smallest packets of a row, found from its end on. */
static size_t least_packets(const uint8_t *row, size_t width, size_t step) {
    size_t least[301] = {0}; /* from each pixel on */
    for (size_t x = width; x-- > 0;) {
        bool run = true;
        least[x] = SIZE_MAX;
        for (size_t count = 1; count <= 128 && x + count <= width; count++) {
            run = run && memcmp(row + x * step, row + (x + count - 1) * step, step) == 0;
            size_t size = 1 + (run ? 1 : count) * step + least[x + count];
            least[x] = size < least[x] ? size : least[x];
        }
    }
    return least[0];
}

/* The file is no larger than it need be. (A longer row may come out a byte longer, where a run
 * begins shortly before the end of a packet.) */
static void check_tga_round_trip(const struct image *image) {
    static const char footer[26] = "\0\0\0\0\0\0\0\0TRUEVISION-XFILE.";
    struct bytes file = {0};
    struct image again;
    struct error error;
    size_t step = (size_t)image->format;
    size_t raw = image->width * image->height * step, least = 0;
    struct image exact = *image; /* without the room behind its pixels */
    exact.pixels = exact_copy(image->pixels, raw);
    put(&file, 77); /* what comes before is kept */
    CHECK(tga_encode(&exact, &file, &error));
    free(exact.pixels);
    CHECK(file.data[0] == 77);
    const uint8_t *tga = file.data + 1;
    size_t size = file.size - 1;
    if (CHECK(decode_exact(tga_decode, &again, tga, size, &error))) {
        CHECK(same_image(image, &again));
    }
    size_t body = size - 18 - sizeof footer;
    CHECK(memcmp(tga + size - sizeof footer, footer, sizeof footer) == 0);
    bool packed = tga[2] >= 8;
    CHECK(tga[2] == (step == 1 ? 3 : 2) + (packed ? 8 : 0));
    CHECK(tga[16] == 8 * step && tga[17] == (step == 4 ? 8 : 0)); /* origin at the bottom left */
    for (size_t y = 0; y < image->height; y++) {
        least += least_packets(image->pixels + y * image->width * step, image->width, step);
    }
    CHECK(packed == (least <= raw) && body == (packed ? least : raw));
    image_free(&again);
    bytes_free(&file);
}

static void test_tga_round_trip(void) {
    static const enum image_format formats[] = {IMAGE_GREY, IMAGE_BGR, IMAGE_BGRA};
    static const uint32_t levels[] = {2, 3, 256, 9}; /* some runs, few, none; some up to a row */
    static const size_t widths[] = {1, 2, 127, 128, 129, 300};
    uint32_t state = 7;
    for (size_t i = 0; i < 3 * 4 * 6; i++) {
        const size_t kind = i / 3 % 4, step = (size_t)formats[i % 3];
        struct image image =
            random_image(widths[i / 12], 1 + i % 5, formats[i % 3], levels[kind], &state);
        for (size_t k = step; kind == 3 && k < image.width * image.height * step; k += step) {
            if (next_random(&state) % 64 != 0) {
                memcpy(image.pixels + k, image.pixels + k - step, step);
            }
        }
        check_tga_round_trip(&image);
        image_free(&image);
    }
    /* Packets that become larger than the pixels, far from the end of these. */
    struct image image = random_image(1, 1000, IMAGE_GREY, 256, &state);
    check_tga_round_trip(&image);
    image_free(&image);
}

static void test_tga_packs(void) {
    struct image image = {0};
    struct error error;
    struct bytes file = {0};
    CHECK(!tga_encode(&image, &file, &error) && file.size == 0);
    /* 128 rows of packets take just what the raw pixels do, and one more is written behind them. */
    image = new_image(4096, 129, IMAGE_GREY);
    for (size_t i = 0; i < 4096 * 129; i++) {
        image.pixels[i] = (uint8_t)(i & 255);
    }
    CHECK(tga_encode(&image, &file, &error) && file.size == 18 + 4096 * 129 + 26);
    image_free(&image);
    bytes_free(&file);
}

UNIT_MAIN(TEST(test_create), TEST(test_get_and_set), TEST(test_every_kind_of_tga),
          TEST(test_cut_off_tga), TEST(test_lying_tga), TEST(test_colors_without_map),
          TEST(test_many_colors), TEST(test_check_size), TEST(test_tga_round_trip),
          TEST(test_tga_packs))
