/*
 * Tests of common/files/png.c and common/files/deflate.c.
 *
 * PNG files and compressed data are put together here bit by bit from the specifications, with
 * checksums, filters and codes that share nothing with the code under test. Everything is decoded
 * from blocks of exactly its size, so that the address sanitizer sees a read past the end.
 */
#define _XOPEN_SOURCE 700 /* POSIX.1-2008 with mkdtemp() */

#include "files/image_file.h"
#include "files/png.h"

#include "base/file.h"
#include "files/deflate.h"
#include "unit/unit.h"

#include <stdlib.h>
#include <unistd.h>

static uint32_t next_random(uint32_t *state) {
    *state = *state * 1664525u + 1013904223u;
    return *state >> 8;
}

static bool same_image(const struct image *a, const struct image *b) {
    return a->width == b->width && a->height == b->height && a->format == b->format &&
           memcmp(a->pixels, b->pixels, a->width * a->height * (size_t)a->format) == 0;
}

static void put(struct bytes *out, unsigned value) {
    uint8_t byte = (uint8_t)(value & 255);
    CHECK(bytes_append(out, &byte, 1));
}

static void put_32(struct bytes *out, uint32_t value) {
    for (unsigned shift = 32; shift > 0; shift -= 8) {
        put(out, value >> (shift - 8) & 255);
    }
}

static uint32_t slow_adler(const uint8_t *data, size_t size) {
    uint32_t a = 1, b = 0;
    for (size_t i = 0; i < size; i++) {
        a = (a + data[i]) % 65521;
        b = (b + a) % 65521;
    }
    return b * 65536 + a;
}

static uint32_t slow_crc(const uint8_t *data, size_t size) {
    uint32_t crc = 0xffffffffu;
    for (size_t i = 0; i < 8 * size; i++) {
        uint32_t bit = ((uint32_t)data[i / 8] >> i % 8 ^ crc) & 1;
        crc = bit != 0 ? crc >> 1 ^ 0xedb88320u : crc >> 1;
    }
    return ~crc;
}

/* ---- Compressed data, bit by bit ---- */

struct bits {
    struct bytes bytes;
    unsigned count; /* bits in the last byte, 0 when it is full */
};

/* A number: its lowest bit first. */
static void put_bits(struct bits *bits, unsigned value, unsigned count) {
    for (unsigned i = 0; i < count; i++) {
        if (bits->count == 0) {
            put(&bits->bytes, 0);
        }
        unsigned bit = value >> i & 1;
        bits->bytes.data[bits->bytes.size - 1] |= (unsigned char)(bit << bits->count);
        bits->count = (bits->count + 1) % 8;
    }
}

/* A Huffman code: its highest bit first. */
static void put_code(struct bits *bits, unsigned code, unsigned count) {
    while (count-- > 0) {
        put_bits(bits, code >> count, 1);
    }
}

/* The same from a string such as "1 0110 ", where blanks only please the eye. */
static void put_string(struct bits *bits, const char *digits) {
    for (; *digits != '\0'; digits++) {
        if (*digits != ' ') {
            put_bits(bits, *digits == '1', 1);
        }
    }
}

static void put_fixed(struct bits *bits, unsigned symbol) {
    if (symbol < 144) {
        put_code(bits, 48 + symbol, 8);
    } else if (symbol < 256) {
        put_code(bits, 400 + symbol - 144, 9);
    } else if (symbol < 280) {
        put_code(bits, symbol - 256, 7);
    } else {
        put_code(bits, 192 + symbol - 280, 8);
    }
}

/* A zlib stream around blocks, with the checksum of `plain`. */
static struct bytes wrap_blocks(const struct bits *bits, const void *plain, size_t size) {
    struct bytes stream = {0};
    put(&stream, 0x78);
    put(&stream, 0x01);
    CHECK(bytes_append(&stream, bits->bytes.data, bits->bytes.size));
    put_32(&stream, slow_adler(plain, size));
    return stream;
}

static bool decompress_exact(const uint8_t *data, size_t size, uint8_t *out, size_t out_size,
                             struct error *error) {
    uint8_t *copy = malloc(size + (size == 0)), *plain = malloc(out_size + (out_size == 0));
    bool done = false;
    if (CHECK(copy != NULL && plain != NULL)) {
        memcpy(copy, data, size);
        error->message[0] = '\0';
        done = zlib_decompress(copy, size, plain, out_size, error);
        CHECK(done || error->message[0] != '\0');
        memcpy(out, plain, done ? out_size : 0);
    }
    free(copy);
    free(plain);
    return done;
}

/* The stream must give exactly `text`; cut off anywhere, or for another size, it must not. */
static void check_stream(struct bits *bits, const char *text, const char *row) {
    enum { LIMIT = 1024 };
    uint8_t out[LIMIT];
    struct error error;
    size_t size = strlen(text);
    struct bytes stream = wrap_blocks(bits, text, size);
    CHECK_ROW(decompress_exact(stream.data, stream.size, out, size, &error), row);
    CHECK_ROW(memcmp(out, text, size) == 0, row);
    CHECK_ROW(!decompress_exact(stream.data, stream.size, out, size + 1, &error), row);
    CHECK_ROW(!decompress_exact(stream.data, stream.size, out, size - 1, &error), row);
    for (size_t cut = 0; cut < stream.size; cut++) {
        CHECK_ROW(!decompress_exact(stream.data, cut, out, size, &error), row);
    }
    for (size_t at = stream.size - 4; at < stream.size; at++) {
        stream.data[at] ^= 1;
        CHECK_ROW(!decompress_exact(stream.data, stream.size, out, size, &error), row);
        stream.data[at] ^= 1;
    }
    bytes_free(&stream);
    bytes_free(&bits->bytes);
    *bits = (struct bits){0};
}

static void put_stored(struct bits *bits, bool last, const char *text) {
    unsigned size = (unsigned)strlen(text);
    put_bits(bits, last, 1);
    put_bits(bits, 0, 2);
    bits->count = 0; /* the rest of the byte is skipped */
    put_bits(bits, size, 16);
    put_bits(bits, ~size & 0xffff, 16);
    for (; *text != '\0'; text++) {
        put_bits(bits, (unsigned char)*text, 8);
    }
}

/* The header of a block with its own codes: literals 0 to 253 with 8 bits, 254, 255, end of block
 * and length 3 with 9 bits, distances 1 and 2 with 1 bit. The lengths 8, 1, 9 have the codes 0,
 * 10, 11. */
static void put_own_header(struct bits *bits) {
    put_bits(bits, 1, 1);
    put_bits(bits, 2, 2);
    put_bits(bits, 258 - 257, 5);
    put_bits(bits, 2 - 1, 5);
    put_bits(bits, 18 - 4, 4);
    /* order: 16 17 18 0 8 7 9 6 10 5 11 4 12 3 13 2 14 1 */
    static const unsigned lengths[18] = {[4] = 1, [6] = 2, [17] = 2};
    for (size_t i = 0; i < 18; i++) {
        put_bits(bits, lengths[i], 3);
    }
    for (int i = 0; i < 254; i++) {
        put_string(bits, "0");
    }
    put_string(bits, "11 11 11 11");
    put_string(bits, "10 10");
}

static void test_blocks(void) {
    struct bits bits = {0};
    put_stored(&bits, false, "stored ");
    put_stored(&bits, false, "");
    put_stored(&bits, true, "twice");
    check_stream(&bits, "stored twice", "stored");

    put_bits(&bits, 1, 1);
    put_bits(&bits, 1, 2);
    put_fixed(&bits, 'a');
    put_fixed(&bits, 0xe4);
    put_fixed(&bits, 256);
    check_stream(&bits, "a\xe4", "fixed, literals");

    put_bits(&bits, 1, 1);
    put_bits(&bits, 1, 2);
    put_fixed(&bits, 'x');
    put_fixed(&bits, 'y');
    put_fixed(&bits, 257 + 2); /* length 5 */
    put_code(&bits, 1, 5);     /* distance 2: the copy overlaps itself */
    put_fixed(&bits, 265);     /* lengths 11 and 12 */
    put_bits(&bits, 1, 1);
    put_code(&bits, 4, 5); /* distances 5 and 6 */
    put_bits(&bits, 1, 1);
    put_fixed(&bits, 256);
    check_stream(&bits, "xyxyxyxyxyxyxyxyxyx", "fixed, matches");

    put_own_header(&bits);
    put_code(&bits, 'n', 8);
    put_code(&bits, 509, 9); /* 255 */
    put_code(&bits, 511, 9); /* length 3 */
    put_string(&bits, "1");  /* distance 2 */
    put_code(&bits, 511, 9);
    put_string(&bits, "0"); /* distance 1 */
    put_code(&bits, 510, 9);
    check_stream(&bits, "n\xffn\xffnnnn", "own codes");
}

/* A stored block begins with the byte after those of which bits have been taken, however many the
 * block before it has taken ahead, and after it nothing of them may be left. */
static void test_stored_after_others(void) {
    enum { STORED = 40, LAST = 300, MOST = 2 * 64 + STORED + LAST }; /* the fast loop needs room */
    char text[MOST + 1] = {0};
    uint8_t out[MOST];
    for (size_t count = 0; count < 2 * 64; count += 2) { /* another bit and another byte */
        const size_t stored_end = count + STORED, size = stored_end + LAST;
        struct bits bits = {0};
        struct error error;
        for (size_t i = 0; i < size; i++) {
            text[i] = (char)(i % 7 == 0 ? 0xe5 : 'a' + i % 23); /* 9 and 8 bits */
        }
        put_bits(&bits, 0, 1);
        put_bits(&bits, 1, 2);
        for (size_t i = 0; i < count; i++) {
            put_fixed(&bits, (unsigned char)text[i]);
        }
        put_fixed(&bits, 256);
        char next = text[stored_end];
        text[stored_end] = '\0';
        put_stored(&bits, false, text + count);
        text[stored_end] = next;
        put_bits(&bits, 1, 1);
        put_bits(&bits, 1, 2);
        for (size_t i = stored_end; i < size; i++) {
            put_fixed(&bits, (unsigned char)text[i]);
        }
        put_fixed(&bits, 256);
        struct bytes stream = wrap_blocks(&bits, text, size);
        CHECK(decompress_exact(stream.data, stream.size, out, size, &error) &&
              memcmp(out, text, size) == 0);
        bytes_free(&stream);
        bytes_free(&bits.bytes);
    }
}

/* The longest match from the longest distance. */
static void test_far_match(void) {
    enum { SIZE = 32768 + 258 };
    static uint8_t plain[SIZE], out[SIZE];
    struct bits bits = {0};
    struct error error;
    uint32_t state = 1;
    put_bits(&bits, 0, 1);
    put_bits(&bits, 0, 2);
    bits.count = 0;
    put_bits(&bits, 32768, 16);
    put_bits(&bits, 32767, 16);
    for (size_t i = 0; i < SIZE; i++) {
        plain[i] = i < 32768 ? (uint8_t)next_random(&state) : plain[i - 32768];
    }
    CHECK(bytes_append(&bits.bytes, plain, 32768));
    put_bits(&bits, 1, 1);
    put_bits(&bits, 1, 2);
    put_fixed(&bits, 285);
    put_code(&bits, 29, 5);
    put_bits(&bits, 8191, 13);
    put_fixed(&bits, 256);
    struct bytes stream = wrap_blocks(&bits, plain, SIZE);
    CHECK(decompress_exact(stream.data, stream.size, out, SIZE, &error));
    CHECK(memcmp(out, plain, SIZE) == 0);
    bytes_free(&stream);
    bytes_free(&bits.bytes);
}

/* How a distance below 65 is written: a symbol and bits. */
struct place {
    unsigned symbol, extra, extra_bits;
};

static struct place place_of_distance(size_t distance) {
    unsigned first = 1;
    for (unsigned symbol = 0;; symbol++) {
        unsigned bits = symbol < 4 ? 0 : symbol / 2 - 1;
        if (distance < first + (1u << bits)) {
            return (struct place){symbol, (unsigned)distance - first, bits};
        }
        first += 1u << bits;
    }
}

/* The longest match, copied in blocks, some bytes before the end of what comes out: nothing may be
 * written after it, and nothing read after the end of a stream that is cut off. */
static void test_matches_near_end(void) {
    enum { BEGINNING = 300, MATCH = 258, REST = 40 };
    for (size_t rest = 0; rest < REST; rest++) {
        for (size_t distance = 1; distance < 40; distance++) {
            uint8_t plain[BEGINNING + MATCH + REST] = {0}, out[sizeof plain];
            size_t size = BEGINNING + MATCH + rest;
            struct bits bits = {0};
            struct error error;
            put_bits(&bits, 1, 1);
            put_bits(&bits, 1, 2);
            for (size_t i = 0; i < size; i++) {
                bool copied = i >= BEGINNING && i < BEGINNING + MATCH;
                plain[i] = copied ? plain[i - distance] : (uint8_t)(i % 140);
                if (!copied) {
                    put_fixed(&bits, plain[i]);
                } else if (i == BEGINNING) {
                    struct place place = place_of_distance(distance);
                    put_fixed(&bits, 285);
                    put_code(&bits, place.symbol, 5);
                    put_bits(&bits, place.extra, place.extra_bits);
                }
            }
            put_fixed(&bits, 256);
            struct bytes stream = wrap_blocks(&bits, plain, size);
            CHECK(decompress_exact(stream.data, stream.size, out, size, &error));
            CHECK(memcmp(out, plain, size) == 0);
            for (size_t cut = stream.size - 320; distance == 1 && cut < stream.size; cut++) {
                CHECK(!decompress_exact(stream.data, cut, out, size, &error));
            }
            bytes_free(&stream);
            bytes_free(&bits.bytes);
        }
    }
}

/* Data that no compressor makes; each row is a stream's bits and a part of the message. */
static void test_wrong_blocks(void) {
    static const struct {
        const char *name, *message, *bits;
    } rows[] = {
        {"block of kind 3", "unknown kind", "1 11"},
        {"stored length and complement differ", "stored length",
         "1 00 00000 1000000000000000 1111111111111111"},
        {"length 286", "length that does not exist", "1 10 01010000 11000110 00000"},
        {"length 287", "length that does not exist", "1 10 01010000 11000111 00000"},
        {"distance 30", "distance that does not exist", "1 10 01010000 0000001 11110"},
        {"distance 31", "distance that does not exist", "1 10 01010000 0000001 11111"},
        {"distance before the start", "from before", "1 10 01010000 0000001 00001"},
        {"match at once", "from before", "1 10 0000001 00000"},
        {"too long", "larger", "1 10 01010000 0001000 0 00000 0001000 0 00000 0000000"},
        {"287 literal codes", "too many codes", "1 01 01111 00000 0000"},
        {"31 distance codes", "too many codes", "1 01 00000 01111 0000"},
        {"three codes of one bit", "wrong code", "1 01 00000 00000 0000 100 100 100 000"},
        {"incomplete code for lengths", "wrong code", "1 01 00000 00000 0000 010 010 010 000"},
        {"repeat before the first", "before the first",
         "1 01 00000 00000 0000 100 100 000 000 0 00"},
        /* 18 = 138 zeros has code 1, 0 has code 0: 138 + 138 > 258 */
        {"too many lengths", "too many code lengths",
         "1 01 00000 00000 0000 000 000 100 100 1 1111111 1 1111111"},
        /* all 258 lengths are zero */
        {"no end of block", "wrong code",
         "1 01 00000 00000 0000 000 000 100 100 1 1111111 1 1011011"},
    };
    /* Each twice: shortly before the end, and far from it, where the fast loop meets it. */
    for (size_t i = 0; i < 2 * sizeof rows / sizeof rows[0]; i++) {
        uint8_t out[500];
        bool far = i % 2 == 1;
        struct bits bits = {0};
        struct error error;
        put_string(&bits, rows[i / 2].bits);
        for (int k = 0; k < (far ? 20 : 1); k++) {
            put_bits(&bits, 0, 8);
        }
        struct bytes stream = wrap_blocks(&bits, "", 0);
        put_32(&stream, 0);
        bool too_long = strcmp(rows[i / 2].message, "larger") == 0;
        CHECK_ROW(!decompress_exact(stream.data, stream.size, out, far ? sizeof out : 16, &error),
                  rows[i / 2].name);
        CHECK_ROW((far && too_long) || strstr(error.message, rows[i / 2].message) != NULL,
                  error.message);
        bytes_free(&stream);
        bytes_free(&bits.bytes);
    }
}

/* Distances that do not exist would be the longest: far behind the start, too, there are none. */
static void test_wrong_far_distance(void) {
    enum { BEFORE = 50000, SIZE = BEFORE + 1000 };
    static uint8_t out[SIZE];
    for (unsigned symbol = 30; symbol < 32; symbol++) {
        struct bits bits = {0};
        struct error error;
        put_bits(&bits, 0, 3);
        bits.count = 0;
        put_bits(&bits, BEFORE, 16);
        put_bits(&bits, 65535 - BEFORE, 16);
        CHECK(bytes_append(&bits.bytes, out, BEFORE));
        put_bits(&bits, 1, 1);
        put_bits(&bits, 1, 2);
        put_fixed(&bits, 257);
        put_code(&bits, symbol, 5);
        for (int i = 0; i < 20; i++) { /* nor is the end near */
            put_bits(&bits, 0, 8);
        }
        struct bytes stream = wrap_blocks(&bits, out, BEFORE + 3);
        CHECK(!decompress_exact(stream.data, stream.size, out, SIZE, &error));
        CHECK(strstr(error.message, "distance that does not exist") != NULL);
        bytes_free(&stream);
        bytes_free(&bits.bytes);
    }
}

/* A code whose literals leave room, or are too many: the header of put_own_header() changed. */
static void test_wrong_own_codes(void) {
    static const struct {
        const char *name, *last;
    } rows[] = {{"too many literals of 8 bits", "11 11 11 0 10 10"},
                {"one literal of 1 bit", "11 11 10 11 10 10"},
                {"distances leave room", "11 11 11 11 11 11"}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        uint8_t out[4];
        struct bits bits = {0};
        struct error error;
        put_own_header(&bits);
        /* Take the last six codes (12 bits) back, and put others. */
        size_t total = (bits.bytes.size - 1) * 8 + (bits.count == 0 ? 8 : bits.count) - 12;
        bits.bytes.size = (total + 7) / 8;
        bits.count = (unsigned)(total % 8);
        bits.bytes.data[bits.bytes.size - 1] &=
            (unsigned char)((1u << (bits.count ? bits.count : 8)) - 1);
        put_string(&bits, rows[i].last);
        put_bits(&bits, 0, 32);
        struct bytes stream = wrap_blocks(&bits, "", 0);
        CHECK_ROW(!decompress_exact(stream.data, stream.size, out, sizeof out, &error),
                  rows[i].name);
        CHECK_ROW(strstr(error.message, "wrong code") != NULL, error.message);
        bytes_free(&stream);
        bytes_free(&bits.bytes);
    }
}

/* Distance codes of 1 to 15 bits: one of 15 bits more is one too many. */
static void test_long_codes(void) {
    for (unsigned more = 0; more < 2; more++) {
        uint8_t out[1];
        struct bits bits = {0};
        struct error error;
        put_bits(&bits, 1, 1);
        put_bits(&bits, 2, 2);
        put_bits(&bits, 0, 5);
        put_bits(&bits, 15 + more, 5);
        put_bits(&bits, 19 - 4, 4);
        for (int i = 0; i < 19; i++) { /* the lengths 0 to 15 have the codes 0000 to 1111 */
            put_bits(&bits, i < 3 ? 0 : 4, 3);
        }
        for (int i = 0; i < 257; i++) {
            put_code(&bits, i == 0 || i == 256, 4);
        }
        for (unsigned i = 1; i < 17 + more; i++) {
            put_code(&bits, i < 15 ? i : 15, 4);
        }
        put_string(&bits, "0 1");
        struct bytes stream = wrap_blocks(&bits, "", 1);
        CHECK(decompress_exact(stream.data, stream.size, out, 1, &error) == (more == 0));
        bytes_free(&stream);
        bytes_free(&bits.bytes);
    }
}

/* A copy whose distance has a code of any length, in the middle of enough other bytes. */
static void test_long_distance_codes(void) {
    enum { BEGINNING = 300, MATCH = 258, SIZE = 2 * BEGINNING + MATCH, DISTANCES = 16 };
    static const unsigned distances[DISTANCES] = {1,  2,  3,  4,  5,  7,  9,   13,
                                                  17, 25, 33, 49, 65, 97, 129, 193};
    for (unsigned symbol = 0; symbol < DISTANCES; symbol++) {
        uint8_t plain[SIZE] = {0}, out[SIZE];
        uint32_t state = 3;
        struct bits bits = {0};
        struct error error;
        put_bits(&bits, 1, 1);
        put_bits(&bits, 2, 2);
        put_bits(&bits, 286 - 257, 5);
        put_bits(&bits, DISTANCES - 1, 5);
        put_bits(&bits, 19 - 4, 4);
        for (int i = 0; i < 19; i++) { /* the lengths 0 to 15 have the codes 0000 to 1111 */
            put_bits(&bits, i < 3 ? 0 : 4, 3);
        }
        for (int i = 0; i < 286; i++) { /* 00, 01, 10, 11 */
            put_code(&bits, i == 0 || i == 1 || i == 256 || i == 285 ? 2 : 0, 4);
        }
        for (unsigned i = 0; i < DISTANCES; i++) { /* 0, 10, 110 and so on */
            put_code(&bits, i < 15 ? i + 1 : 15, 4);
        }
        for (unsigned i = 0; i < SIZE; i++) {
            bool copied = i >= BEGINNING && i < BEGINNING + MATCH;
            plain[i] = copied ? plain[i - distances[symbol]] : next_random(&state) & 1;
            if (!copied) {
                put_code(&bits, plain[i], 2);
            } else if (i == BEGINNING) {
                put_string(&bits, "11");
                put_bits(&bits, (1u << symbol) - 1, symbol < 15 ? symbol + 1 : 15);
                put_bits(&bits, 0, symbol < 4 ? 0 : symbol / 2 - 1);
            }
        }
        put_string(&bits, "10");
        struct bytes stream = wrap_blocks(&bits, plain, SIZE);
        CHECK(decompress_exact(stream.data, stream.size, out, SIZE, &error) &&
              memcmp(out, plain, SIZE) == 0);
        bytes_free(&stream);
        bytes_free(&bits.bytes);
    }
}

static void test_zlib_header(void) {
    static const struct {
        const char *name;
        uint8_t method, flags;
        bool right;
    } rows[] = {
        {"window of 32768", 0x78, 0x01, true},   {"window of 256", 0x08, 0x1d, true},
        {"wrong check", 0x78, 0x02, false},      {"another method", 0x79, 0x1a, false},
        {"window too large", 0x88, 0x1c, false}, {"dictionary", 0x78, 0x20, false},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        uint8_t out[1];
        struct error error;
        uint8_t stream[] = {rows[i].method, rows[i].flags, 0x4b, 0x04, 0, 0, 0x62, 0, 0x62};
        CHECK_ROW(decompress_exact(stream, sizeof stream, out, 1, &error) == rows[i].right,
                  rows[i].name);
    }
}

/* ---- Compression ---- */

enum data_kind { DATA_ZERO, DATA_NOISE, DATA_BITS, DATA_TEXT, DATA_STEEP, DATA_KINDS };

static void fill_data(uint8_t *data, size_t size, enum data_kind kind) {
    static const char *const words[] = {"the ", "pixel ", "of ", "row ", "is ", "a ", "light "};
    uint32_t state = 9;
    for (size_t i = 0; i < size;) {
        uint32_t number = next_random(&state);
        const char *word = words[number % 7];
        switch (kind) {
        case DATA_ZERO:
            data[i++] = 0;
            break;
        case DATA_NOISE:
            data[i++] = (uint8_t)number;
            break;
        case DATA_BITS:
            data[i++] = number & 1;
            break;
        case DATA_TEXT:
            for (; *word != '\0' && i < size; word++) {
                data[i++] = (uint8_t)*word;
            }
            break;
        default: /* each value half as frequent as the one before: codes get as long as they may */
            data[i] = 0;
            while ((number & 1) != 0 && data[i] < 24) {
                data[i]++;
                number >>= 1;
            }
            i++;
            break;
        }
    }
}

static void test_compress(void) {
    static const size_t sizes[] = {0, 1, 2, 3, 4, 5, 100, 257, 258, 259, 32768, 70000, 140000};
    enum { LIMIT = 140000 };
    static uint8_t plain[LIMIT], out[LIMIT];
    for (int kind = 0; kind < DATA_KINDS; kind++) {
        for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
            size_t size = sizes[i];
            struct bytes packed = {0};
            struct error error;
            put(&packed, 88);
            fill_data(plain, size, (enum data_kind)kind);
            CHECK(zlib_compress(plain, size, &packed, &error));
            CHECK(packed.data[0] == 88 && packed.data[1] == 0x78);
            CHECK(packed.size - 1 <= size + 11 + 5 * (size / 16384)); /* worst case: stored */
            CHECK(decompress_exact(packed.data + 1, packed.size - 1, out, size, &error));
            CHECK(memcmp(out, plain, size) == 0);
            bytes_free(&packed);
        }
    }
}

/* The checksum is that of the definition where its sums are as large as they get. */
static void test_checksum(void) {
    enum { SIZE = 30000 };
    static uint8_t white[SIZE];
    struct bytes packed = {0};
    struct error error;
    memset(white, 255, SIZE);
    CHECK(zlib_compress(white, SIZE, &packed, &error));
    uint32_t check = 0;
    for (size_t i = packed.size - 4; i < packed.size; i++) {
        check = check << 8 | packed.data[i];
    }
    CHECK(check == slow_adler(white, SIZE));
    bytes_free(&packed);
}

/* Copies from just about the longest distance that the format has. */
static void test_compress_far_copies(void) {
    enum { COPY = 100, SIZE = 32768 + 10 + COPY };
    static uint8_t plain[SIZE], out[SIZE];
    for (size_t distance = 32768 - 3; distance <= 32768 + 3; distance++) {
        struct bytes packed = {0};
        struct error error;
        uint32_t state = 7;
        for (size_t i = 0; i < SIZE; i++) {
            plain[i] = i < distance ? (uint8_t)next_random(&state) : plain[i - distance];
        }
        CHECK(zlib_compress(plain, distance + COPY, &packed, &error));
        CHECK(decompress_exact(packed.data, packed.size, out, distance + COPY, &error));
        CHECK(memcmp(out, plain, distance + COPY) == 0);
        bytes_free(&packed);
    }
}

/* Which kind of block is chosen, and how small the result is. */
static void test_choice_of_blocks(void) {
    static const struct {
        const char *name;
        enum data_kind kind;
        size_t size;
        unsigned block;
        size_t most; /* bytes of the stream */
    } rows[] = {
        {"a few zeros: fixed codes", DATA_ZERO, 10, 1, 11},
        {"noise: stored", DATA_NOISE, 50000, 0, 50000 + 40},
        {"text: codes of its own", DATA_TEXT, 50000, 2, 16000},
        {"zeros", DATA_ZERO, 100000, 2, 150},
        {"one bit a byte", DATA_BITS, 80000, 2, 80000 / 8 + 1500},
        /* the entropy of 1/2, 1/4, 1/8... is 2 bits */
        {"steep", DATA_STEEP, 80000, 2, 80000 / 4 + 1000},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct bytes packed = {0};
        struct error error;
        uint8_t *data = malloc(rows[i].size);
        if (!CHECK(data != NULL)) {
            return;
        }
        fill_data(data, rows[i].size, rows[i].kind);
        CHECK(zlib_compress(data, rows[i].size, &packed, &error));
        CHECK_ROW((packed.data[2] >> 1 & 3) == rows[i].block, rows[i].name);
        CHECK_ROW(packed.size <= rows[i].most, rows[i].name);
        free(data);
        bytes_free(&packed);
    }
}

/* ---- PNG in ---- */

static const uint8_t signature[8] = {137, 80, 78, 71, 13, 10, 26, 10};

static void put_chunk(struct bytes *file, const char *type, const void *data, size_t size) {
    put_32(file, (uint32_t)size);
    size_t start = file->size;
    CHECK(bytes_append(file, type, 4) && bytes_append(file, data, size));
    put_32(file, slow_crc(file->data + start, size + 4));
}

static void put_header(struct bytes *file, uint32_t width, uint32_t height, unsigned depth,
                       unsigned color_type, unsigned interlace) {
    struct bytes header = {0};
    CHECK(bytes_append(file, signature, sizeof signature));
    put_32(&header, width);
    put_32(&header, height);
    put(&header, depth);
    put(&header, color_type);
    put(&header, 0);
    put(&header, 0);
    put(&header, interlace);
    put_chunk(file, "IHDR", header.data, header.size);
    bytes_free(&header);
}

/* Raw rows as one zlib stream of stored blocks. */
static struct bytes store(const uint8_t *raw, size_t size) {
    struct bits bits = {0};
    put_bits(&bits, 1, 8);
    put_bits(&bits, (unsigned)size, 16);
    put_bits(&bits, ~(unsigned)size & 0xffff, 16);
    CHECK(bytes_append(&bits.bytes, raw, size));
    struct bytes stream = wrap_blocks(&bits, raw, size);
    bytes_free(&bits.bytes);
    return stream;
}

static void put_pixels(struct bytes *file, const uint8_t *raw, size_t size) {
    struct bytes stream = store(raw, size);
    put_chunk(file, "IDAT", stream.data, stream.size);
    bytes_free(&stream);
}

static bool decode_exact(struct image *image, const uint8_t *data, size_t size,
                         struct error *error) {
    uint8_t *copy = malloc(size + (size == 0));
    CHECK(copy != NULL);
    if (copy == NULL) {
        return false;
    }
    memcpy(copy, data, size);
    error->message[0] = '\0';
    bool done = png_decode(image, copy, size, error);
    CHECK(done == (image->pixels != NULL));
    CHECK(done || error->message[0] != '\0');
    free(copy);
    return done;
}

/* Bytes written as a string. */
struct text {
    const char *bytes;
    size_t size;
};
#define TEXT(string)                                                                               \
    { (string), sizeof(string) - 1 }

/* Every colour type: two pixels a row, two rows; `palette` and `alpha` are chunks, left out when
 * empty, `pixels` are those of the image, bottom row first. */
static void test_color_types(void) {
    static const struct {
        const char *name;
        unsigned depth, type;
        struct text palette, alpha, raw;
        enum image_format format;
        const char *pixels;
    } rows[] = {
        {"grey", 8, 0, TEXT(""), TEXT(""), TEXT("\0\x01\x02\0\x03\x04"), IMAGE_GREY,
         "\x03\x04\x01\x02"},
        {"grey, 1 bit", 1, 0, TEXT(""), TEXT(""), TEXT("\0\x40\0\x80"), IMAGE_GREY, "\xff\0\0\xff"},
        {"grey, 2 bits", 2, 0, TEXT(""), TEXT(""), TEXT("\0\x10\0\xb0"), IMAGE_GREY,
         "\xaa\xff\0\x55"},
        {"grey, 4 bits", 4, 0, TEXT(""), TEXT(""), TEXT("\0\x1f\0\x20"), IMAGE_GREY,
         "\x22\0\x11\xff"},
        {"grey with a clear level", 8, 0, TEXT(""), TEXT("\0\x02"), TEXT("\0\x01\x02\0\x03\x04"),
         IMAGE_BGRA, "\x03\x03\x03\xff\x04\x04\x04\xff\x01\x01\x01\xff\x02\x02\x02\0"},
        {"grey with a clear level, in 16 bits", 8, 0, TEXT(""), TEXT("\xff\x02"),
         TEXT("\0\x01\x02\0\x03\x04"), IMAGE_BGRA,
         "\x03\x03\x03\xff\x04\x04\x04\xff\x01\x01\x01\xff\x02\x02\x02\0"},
        {"grey, 2 bits, a clear level in more", 2, 0, TEXT(""), TEXT("\0\xfd"),
         TEXT("\0\x10\0\xb0"), IMAGE_BGRA,
         "\xaa\xaa\xaa\xff\xff\xff\xff\xff\0\0\0\xff\x55\x55\x55\0"},
        {"grey and alpha", 8, 4, TEXT(""), TEXT(""), TEXT("\0\x01\x02\x03\x04\0\x05\x06\x07\x08"),
         IMAGE_BGRA, "\x05\x05\x05\x06\x07\x07\x07\x08\x01\x01\x01\x02\x03\x03\x03\x04"},
        {"RGB", 8, 2, TEXT(""), TEXT(""),
         TEXT("\0\x01\x02\x03\x04\x05\x06\0\x07\x08\x09\x0a\x0b\x0c"), IMAGE_BGR,
         "\x09\x08\x07\x0c\x0b\x0a\x03\x02\x01\x06\x05\x04"},
        {"RGB with a clear colour", 8, 2, TEXT(""), TEXT("\0\x04\0\x05\0\x06"),
         TEXT("\0\x01\x02\x03\x04\x05\x06\0\x07\x08\x09\x0a\x0b\x0c"), IMAGE_BGRA,
         "\x09\x08\x07\xff\x0c\x0b\x0a\xff\x03\x02\x01\xff\x06\x05\x04\0"},
        {"RGBA", 8, 6, TEXT(""), TEXT(""),
         TEXT("\0\x01\x02\x03\x04\x05\x06\x07\x08\0\x09\x0a\x0b\x0c\x0d\x0e\x0f\x10"), IMAGE_BGRA,
         "\x0b\x0a\x09\x0c\x0f\x0e\x0d\x10\x03\x02\x01\x04\x07\x06\x05\x08"},
        {"palette", 8, 3, TEXT("abcdef"), TEXT(""), TEXT("\0\x01\0\0\0\x01"), IMAGE_BGR,
         "cbafedfedcba"},
        {"palette, 1 bit", 1, 3, TEXT("abcdef"), TEXT(""), TEXT("\0\x80\0\x40"), IMAGE_BGR,
         "cbafedfedcba"},
        {"palette, 2 bits", 2, 3, TEXT("abcdefghi"), TEXT(""), TEXT("\0\x90\0\x10"), IMAGE_BGR,
         "cbafedihgfed"},
        {"palette, two with alpha", 8, 3, TEXT("abcdef"), TEXT("\x05\x06"),
         TEXT("\0\x01\0\0\0\x01"), IMAGE_BGRA,
         "cba\x05"
         "fed\x06"
         "fed\x06"
         "cba\x05"},
        {"palette, 4 bits, alpha", 4, 3, TEXT("abcdef"), TEXT("\x05"), TEXT("\0\x10\0\x01"),
         IMAGE_BGRA,
         "cba\x05"
         "fed\xff"
         "fed\xff"
         "cba\x05"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct bytes file = {0};
        struct image image;
        struct error error;
        put_header(&file, 2, 2, rows[i].depth, rows[i].type, 0);
        put_chunk(&file, "teXt", "to be skipped", 13);
        if (rows[i].palette.size > 0) {
            put_chunk(&file, "PLTE", rows[i].palette.bytes, rows[i].palette.size);
        }
        if (rows[i].alpha.size > 0) {
            put_chunk(&file, "tRNS", rows[i].alpha.bytes, rows[i].alpha.size);
        }
        put_pixels(&file, (const uint8_t *)rows[i].raw.bytes, rows[i].raw.size);
        size_t whole = file.size + 12;
        put_chunk(&file, "IEND", NULL, 0);
        if (CHECK_ROW(decode_exact(&image, file.data, file.size, &error), rows[i].name)) {
            CHECK_ROW(image.width == 2 && image.height == 2, rows[i].name);
            CHECK_ROW(image.format == rows[i].format, rows[i].name);
            CHECK_ROW(memcmp(image.pixels, rows[i].pixels, 4 * (size_t)image.format) == 0,
                      rows[i].name);
        }
        image_free(&image);
        for (size_t size = 0; size < whole; size++) {
            CHECK_ROW(!decode_exact(&image, file.data, size, &error), rows[i].name);
        }
        /* The checksums see every change of a byte. */
        for (size_t at = 0; at < file.size; at++) {
            file.data[at] ^= 0x10;
            CHECK_ROW(!decode_exact(&image, file.data, file.size, &error), rows[i].name);
            file.data[at] ^= 0x10;
        }
        bytes_free(&file);
    }
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

static void test_filters(void) {
    static const struct {
        unsigned type;
        size_t step;
    } kinds[] = {{0, 1}, {4, 2}, {2, 3}, {6, 4}};
    enum { WIDTH = 7, HEIGHT = 51 };
    uint32_t state = 2;
    for (size_t k = 0; k < 4; k++) {
        size_t step = kinds[k].step, size = WIDTH * step;
        uint8_t plain[HEIGHT][WIDTH * 4], raw[HEIGHT * (1 + WIDTH * 4)], *next = raw;
        struct bytes file = {0};
        struct image image;
        struct error error;
        for (size_t y = 0; y < HEIGHT; y++) {
            unsigned filter = (unsigned)(y + k) % 5; /* also in the first row */
            *next++ = (uint8_t)filter;
            for (size_t i = 0; i < size; i++) {
                /* small values make many ties in the choice of Paeth's filter */
                plain[y][i] = (uint8_t)(next_random(&state) % (k < 2 ? 256 : 8));
                int a = i >= step ? plain[y][i - step] : 0, b = y > 0 ? plain[y - 1][i] : 0;
                int c = i >= step && y > 0 ? plain[y - 1][i - step] : 0;
                *next++ = (uint8_t)(plain[y][i] - predict(filter, a, b, c));
            }
        }
        put_header(&file, WIDTH, HEIGHT, 8, kinds[k].type, 0);
        put_pixels(&file, raw, HEIGHT * (1 + size));
        put_chunk(&file, "IEND", NULL, 0);
        if (CHECK(decode_exact(&image, file.data, file.size, &error))) {
            for (int i = 0; i < WIDTH * HEIGHT; i++) {
                int x = i % WIDTH, y = i / WIDTH;
                const uint8_t *samples = &plain[HEIGHT - 1 - y][(size_t)x * step];
                struct color color = image_get(&image, x, y);
                CHECK(color.r == samples[0] && color.g == samples[step < 3 ? 0 : 1]);
                CHECK(color.b == samples[step < 3 ? 0 : 2]);
                CHECK(color.a == (step % 2 == 0 ? samples[step - 1] : 255));
            }
        }
        image_free(&image);
        bytes_free(&file);
    }
}

/* Pixel data in chunks of one byte each, some empty; other chunks may not come between. */
static void test_split_data(void) {
    static const uint8_t raw[] = {0, 7, 8, 9};
    for (int between = 0; between < 2; between++) {
        struct bytes file = {0}, stream = store(raw, sizeof raw);
        struct image image;
        struct error error;
        put_header(&file, 3, 1, 8, 0, 0);
        for (size_t i = 0; i < stream.size; i++) {
            put_chunk(&file, "IDAT", stream.data + i, 1);
            bool other = between && i == 3;
            put_chunk(&file, other ? "tIME" : "IDAT", "1234567", other ? 7 : 0);
        }
        put_chunk(&file, "IEND", NULL, 0);
        bool done = decode_exact(&image, file.data, file.size, &error);
        CHECK(done == !between);
        CHECK(done || strstr(error.message, "between its pixel data") != NULL);
        CHECK(!done || memcmp(image.pixels, raw + 1, 3) == 0);
        image_free(&image);
        bytes_free(&stream);
        bytes_free(&file);
    }
}

/* Headers that cannot be, or that the pixels do not go with. */
static void test_wrong_headers(void) {
    static const struct {
        const char *name, *message;
        uint32_t width, height;
        unsigned depth, type, interlace;
    } rows[] = {
        {"no width", "0x1 pixels", 0, 1, 8, 0, 0},
        {"no height", "1x0 pixels", 1, 0, 8, 0, 0},
        {"2^31 wide", "2147483648x1 pixels", 0x80000000u, 1, 8, 0, 0},
        {"2^32-1 high", "1x4294967295 pixels", 1, 0xffffffffu, 8, 0, 0},
        {"65536 wide", "65536x1 pixels", 65536, 1, 8, 0, 0},
        {"larger than the data can be", "cannot hold", 65535, 65535, 8, 6, 0},
        {"larger than the data", "smaller", 2, 2, 8, 0, 0},
        {"smaller than the data", "larger", 1, 1, 8, 0, 0},
        {"interlaced", "interlaced", 2, 1, 8, 0, 1},
        {"another interlace", "interlace method", 2, 1, 8, 0, 2},
        {"16 bits", "16 bits a channel", 1, 1, 16, 0, 0},
        {"RGB of 4 bits", "cannot have 4 bits", 1, 1, 4, 2, 0},
        {"palette of 16 bits", "cannot have 16 bits", 1, 1, 16, 3, 0},
        {"no bits", "cannot have 0 bits", 1, 1, 0, 0, 0},
        {"colour type 1", "unknown colour type, 1", 1, 1, 8, 1, 0},
        {"colour type 7", "unknown colour type, 7", 1, 1, 8, 7, 0},
        {"no palette", "without its palette", 2, 1, 8, 3, 0},
        {"a filter of 9", "filter, 9", 1, 1, 8, 4, 0},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct bytes file = {0};
        struct image image;
        struct error error;
        put_header(&file, rows[i].width, rows[i].height, rows[i].depth, rows[i].type,
                   rows[i].interlace);
        put_pixels(&file, (const uint8_t *)"\x09\0\0", 3);
        put_chunk(&file, "IEND", NULL, 0);
        CHECK_ROW(!decode_exact(&image, file.data, file.size, &error), rows[i].name);
        CHECK_ROW(strstr(error.message, rows[i].message) != NULL, error.message);
        bytes_free(&file);
    }
}

/* Chunks in the wrong place or of the wrong size; H header, P palette of 2, p of no whole number of
 * entries, q of 3, T tRNS, t too long, N no name, D data, X unknown but needed, Z
 * broken length, E end. */
static void test_wrong_chunks(void) {
    static const struct {
        const char *name, *chunks, *message;
    } rows[] = {
        {"right", "HPTDE", NULL},
        {"more after the end", "HPDEX", NULL},
        {"nothing", "", "cut off"},
        {"no header", "PDE", "begin with a header"},
        {"two headers", "HHPDE", "a second header"},
        {"two palettes", "HPPDE", "palette in the wrong place"},
        {"palette after the data", "HPDPE", "palette in the wrong place"},
        {"half an entry", "HpDE", "palette of 4 bytes"},
        {"more than the bits allow", "HqDE", "palette of 9 bytes"},
        {"tRNS first", "HTPDE", "tRNS chunk in the wrong place"},
        {"two tRNS", "HPTTDE", "tRNS chunk in the wrong place"},
        {"tRNS too long", "HPtDE", "tRNS chunk of 3 bytes"},
        {"no data", "HPE", "without pixel data"},
        {"no end", "HPD", "cut off"},
        {"unknown", "HPXDE", "unknown chunk, ABCD"},
        {"lying length", "HPZDE", "claims 2147483647 bytes"},
        {"a brace in a name", "HPNDE", "chunk without a name at byte 51"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct bytes file = {0};
        struct image image;
        struct error error;
        put_header(&file, 1, 1, 1, 3, 0);
        size_t header_size = file.size;
        file.size = sizeof signature;
        for (const char *c = rows[i].chunks; *c != '\0'; c++) {
            switch (*c) {
            case 'H': {
                struct bytes header = {0};
                put_header(&header, 1, 1, 1, 3, 0);
                CHECK(bytes_append(&file, header.data + 8, header_size - 8));
                bytes_free(&header);
                break;
            }
            case 'P':
                put_chunk(&file, "PLTE", "abcdef", 6);
                break;
            case 'p':
                put_chunk(&file, "PLTE", "abcd", 4);
                break;
            case 'q':
                put_chunk(&file, "PLTE", "abcdefghi", 9);
                break;
            case 'T':
                put_chunk(&file, "tRNS", "ab", 2);
                break;
            case 't':
                put_chunk(&file, "tRNS", "abc", 3);
                break;
            case 'D':
                put_pixels(&file, (const uint8_t *)"\0\x80", 2);
                break;
            case 'X':
                put_chunk(&file, "ABCD", "x", 1);
                break;
            case 'N':
                put_chunk(&file, "ab{d", "x", 1);
                break;
            case 'Z':
                put_32(&file, 0x7fffffff);
                CHECK(bytes_append(&file, "teXt", 4));
                break;
            default:
                put_chunk(&file, "IEND", NULL, 0);
                break;
            }
        }
        bool done = decode_exact(&image, file.data, file.size, &error);
        CHECK_ROW(done == (rows[i].message == NULL), rows[i].name);
        CHECK_ROW(done || strstr(error.message, rows[i].message) != NULL, error.message);
        image_free(&image);
        bytes_free(&file);
    }
}

static void test_pixel_outside_palette(void) {
    struct bytes file = {0};
    struct image image;
    struct error error;
    put_header(&file, 1, 1, 8, 3, 0);
    put_chunk(&file, "PLTE", "abc", 3);
    put_pixels(&file, (const uint8_t *)"\0\x01", 2);
    put_chunk(&file, "IEND", NULL, 0);
    CHECK(!decode_exact(&image, file.data, file.size, &error));
    CHECK(strstr(error.message, "outside its palette") != NULL);
    bytes_free(&file);
}

/* ---- PNG out ---- */

enum picture { NOISE, SHADES, FLAT, PICTURES };

static struct image make_image(size_t width, size_t height, enum image_format format,
                               enum picture picture, uint32_t *state) {
    struct image image;
    struct error error;
    CHECK(image_create(&image, width, height, format, &error));
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
            }
            image_set(&image, (int)x, (int)y, color);
        }
    }
    return image;
}

static void test_round_trip(void) {
    static const enum image_format formats[] = {IMAGE_GREY, IMAGE_BGR, IMAGE_BGRA};
    static const uint8_t color_types[] = {0, 2, 6};
    static const size_t sizes[][2] = {{1, 1}, {2, 1}, {1, 3}, {64, 50}, {131, 3}};
    uint32_t state = 4;
    for (size_t i = 0; i < 3 * PICTURES * 5; i++) {
        struct bytes file = {0};
        struct image again;
        struct error error;
        struct image image = make_image(sizes[i / 9][0], sizes[i / 9][1], formats[i % 3],
                                        (enum picture)(i / 3 % PICTURES), &state);
        put(&file, 66);
        CHECK(png_encode(&image, &file, &error) && file.data[0] == 66);
        CHECK(file.data[1 + 24] == 8 && file.data[1 + 25] == color_types[i % 3]);
        if (CHECK(decode_exact(&again, file.data + 1, file.size - 1, &error))) {
            CHECK(same_image(&image, &again));
        }
        image_free(&again);
        image_free(&image);
        bytes_free(&file);
    }
    struct image empty = {0};
    struct bytes file = {0};
    struct error error;
    CHECK(!png_encode(&empty, &file, &error) && file.data == NULL);
}

/* The filters that the encoder chose, as a set of bits. The file has one IDAT chunk after IHDR. */
static unsigned filters_of(const struct image *image) {
    struct bytes file = {0};
    struct error error;
    unsigned set = 0;
    size_t row = 1 + image->width * (size_t)image->format;
    uint8_t *raw = malloc(image->height * row);
    CHECK(png_encode(image, &file, &error));
    size_t size = (size_t)file.data[33] << 24 | (size_t)file.data[34] << 16 |
                  (size_t)file.data[35] << 8 | file.data[36];
    CHECK(memcmp(file.data + 37, "IDAT", 4) == 0);
    CHECK(zlib_decompress(file.data + 41, size, raw, image->height * row, &error));
    for (size_t y = 0; y < image->height; y++) {
        set |= 1u << raw[y * row];
    }
    free(raw);
    bytes_free(&file);
    return set;
}

static void test_choice_of_filters(void) {
    uint32_t state = 5;
    struct image image = make_image(90, 90, IMAGE_BGR, FLAT, &state);
    CHECK(filters_of(&image) == 1); /* areas of one colour: none */
    image_free(&image);
    image = make_image(90, 90, IMAGE_BGR, SHADES, &state);
    CHECK((filters_of(&image) & ~1u) != 0 && (filters_of(&image) & 1) == 0);
    image_free(&image);
}

/* Small and large steps to the right, and the same step upwards everywhere: Paeth's filter foresees
 * the larger of two steps, which no other one does. */
static void test_choice_of_paeth(void) {
    static const uint8_t across[4] = {0, 3, 43, 46};
    enum { WIDTH = 32, HEIGHT = 16 };
    struct image image;
    struct error error;
    if (!CHECK(image_create(&image, WIDTH, HEIGHT, IMAGE_GREY, &error))) {
        return;
    }
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        int x = i % WIDTH, y = i / WIDTH;
        image.pixels[i] = (uint8_t)(6 * (x / 4) + across[x % 4] + 10 * y);
    }
    CHECK((filters_of(&image) & 1u << 4) != 0);
    image_free(&image);
}

/* ---- Animation ---- */

static uint32_t get_32(const uint8_t *bytes) {
    return (uint32_t)bytes[0] << 24 | (uint32_t)bytes[1] << 16 | (uint32_t)bytes[2] << 8 | bytes[3];
}

/* Paste a part over an image; x, y from the top left. */
static void paste(struct image *image, const struct image *part, size_t x, size_t y) {
    for (size_t row = 0; row < part->height; row++) {
        int to = (int)(image->height - y - part->height + row);
        for (size_t column = 0; column < part->width; column++) {
            CHECK(image_set(image, (int)(x + column), to, image_get(part, (int)column, (int)row)));
        }
    }
}

/* Play an animation as a viewer does, each frame as a PNG of its own, and compare. Returns the sum
 * of the frames' areas. */
static size_t play(const struct bytes *file, const struct image *frames, size_t count,
                   unsigned delay_ms) {
    struct image shown = {0};
    struct error error;
    uint8_t header[13];
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
            if (CHECK(decode_exact(&part, single.data, single.size, &error))) {
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
    CHECK(done == count);
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
            CHECK(image_copy(&frames[k], &frames[k - 1], &error));
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
        CHECK(apng_encode(frames, COUNT, 40, &file, &error));
        CHECK(play(&file, frames, COUNT, 40) == 600 + 6 + 600 + 1 + 1);
        /* A viewer without animation shows the first frame. */
        CHECK(decode_exact(&still, file.data, file.size, &error) && same_image(&still, &frames[0]));
        image_free(&still);

        size_t size = file.size;
        CHECK(!apng_encode(frames, 0, 40, &file, &error));
        CHECK(!apng_encode(frames, COUNT, 0, &file, &error));
        CHECK(!apng_encode(frames, COUNT, 65536, &file, &error));
        CHECK(image_scale(&frames[2], 10, HEIGHT, &error));
        CHECK(!apng_encode(frames, COUNT, 40, &file, &error) && file.size == size);
        CHECK(strstr(error.message, "frame 2") != NULL);
        for (size_t k = 0; k < COUNT; k++) {
            image_free(&frames[k]);
        }
        bytes_free(&file);
    }
}

/* ---- Files ---- */

static void test_files(void) {
    char directory[] = "/tmp/test_png.XXXXXX";
    char path[64];
    struct error error;
    uint32_t state = 8;
    if (!CHECK(mkdtemp(directory) != NULL)) {
        return;
    }
    snprintf(path, sizeof path, "%s/a.png", directory);
    struct image image = make_image(20, 10, IMAGE_BGR, SHADES, &state), again;
    CHECK(png_write(&image, path, &error));
    CHECK(image_read(&again, path, &error) && same_image(&image, &again));
    image_free(&again);
    CHECK(apng_write(&image, 1, 10, path, &error));
    CHECK(image_read(&again, path, &error) && same_image(&image, &again));
    image_free(&again);
    CHECK(file_write(path, "short", 5, &error));
    CHECK(!image_read(&again, path, &error) && again.pixels == NULL);
    CHECK(strncmp(error.message, path, strlen(path)) == 0);
    CHECK(strstr(error.message, "neither a PNG nor a TGA") != NULL);
    unlink(path);
    CHECK(!image_read(&again, path, &error) && again.pixels == NULL);
    snprintf(path, sizeof path, "%s/none/a.png", directory);
    CHECK(!png_write(&image, path, &error));
    CHECK(strncmp(error.message, path, strlen(path)) == 0);
    CHECK(!apng_write(&image, 1, 10, path, &error));
    image_free(&image);
    CHECK(!png_write(&image, path, &error));
    CHECK(strncmp(error.message, path, strlen(path)) == 0);
    rmdir(directory);
}

UNIT_MAIN(TEST(test_blocks), TEST(test_stored_after_others), TEST(test_far_match),
          TEST(test_matches_near_end), TEST(test_wrong_blocks), TEST(test_wrong_far_distance),
          TEST(test_wrong_own_codes), TEST(test_long_codes), TEST(test_long_distance_codes),
          TEST(test_zlib_header), TEST(test_compress), TEST(test_checksum),
          TEST(test_compress_far_copies), TEST(test_choice_of_blocks), TEST(test_color_types),
          TEST(test_filters), TEST(test_split_data), TEST(test_wrong_headers),
          TEST(test_wrong_chunks), TEST(test_pixel_outside_palette), TEST(test_round_trip),
          TEST(test_choice_of_filters), TEST(test_choice_of_paeth), TEST(test_animation),
          TEST(test_files))
