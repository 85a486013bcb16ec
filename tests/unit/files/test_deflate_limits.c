/*
 * Deflate, where test_png.c does not go: codes of a single symbol or of none, streams cut off at
 * every byte, and data of more than one block. The streams of the first test are put together here
 * bit by bit, from RFC 1951.
 */
#include "files/deflate.h"
#include "unit/unit.h"

#include <stdlib.h>
#include <time.h>

/* ---- Streams by hand ---- */

enum { STREAM_LIMIT = 256 };

struct stream {
    uint8_t bytes[STREAM_LIMIT];
    size_t bits;
};

/* A string of 0 and 1; blanks only please the eye. */
static void put_string(struct stream *stream, const char *digits) {
    for (; *digits != '\0'; digits++) {
        if (*digits != ' ') {
            stream->bytes[stream->bits / 8] |= (uint8_t)((*digits == '1') << stream->bits % 8);
            stream->bits++;
        }
    }
}

/* A zlib header, one block with codes of its own, and the checksum of `plain`. The literal "a" has
 * code 0, the end of the block 10, the length 3 code 11; `distances` tells the distance codes. */
static size_t make_stream(struct stream *stream, const char *distance_count, const char *distances,
                          const char *symbols, const char *plain) {
    uint32_t a = 1, b = 0;
    *stream = (struct stream){{0x78, 0x01}, 16};
    put_string(stream, "1 01 10000"); /* the last block, codes of its own, 258 literal codes */
    put_string(stream, distance_count);
    put_string(stream, "0111"); /* 18 lengths of the code for lengths: 18 -> 0, 1 -> 10, 2 -> 11 */
    put_string(stream, "000 000 100 000 000 000 000 000 000 000 000 000 000 000 000 010 000 010");
    put_string(stream, "0 0110101 10 0 1111111 0 1001000 11 11"); /* 97, 1, 138 + 20, 2, 2 */
    put_string(stream, distances);
    put_string(stream, symbols);
    for (; *plain != '\0'; plain++) {
        a = (a + (unsigned char)*plain) % 65521;
        b = (b + a) % 65521;
    }
    size_t size = (stream->bits + 7) / 8;
    const uint8_t check[4] = {(uint8_t)(b >> 8), (uint8_t)(b & 255), (uint8_t)(a >> 8),
                              (uint8_t)(a & 255)};
    memcpy(stream->bytes + size, check, sizeof check);
    return size + sizeof check;
}

static void test_single_codes(void) {
    static const struct {
        const char *name, *distance_count, *distances, *symbols, *plain, *message;
    } rows[] = {
        {"a single distance of one bit", "00000", "10", "0 11 0 10", "aaaa", NULL},
        {"the other bit", "00000", "10", "0 11 1 10 0000000000000000", "aaaa", "means nothing"},
        {"a single distance of two bits", "00000", "11", "0 11 0 10", "aaaa", "wrong code"},
        {"no distance, none used", "11010", "0 1000000", "0 0 0 10", "aaa", NULL},
        {"no distance, one used", "11010", "0 1000000", "0 11 0 10 0000000000000000", "aaaa",
         "means nothing"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct stream stream;
        struct error error = {0};
        char out[8] = {0};
        size_t plain = strlen(rows[i].plain);
        size_t size = make_stream(&stream, rows[i].distance_count, rows[i].distances,
                                  rows[i].symbols, rows[i].plain);
        bool done = zlib_decompress(stream.bytes, size, out, plain, &error);
        CHECK_ROW(done == (rows[i].message == NULL), rows[i].name);
        CHECK_ROW(!done || memcmp(out, rows[i].plain, plain) == 0, rows[i].name);
        if (!done && rows[i].message != NULL) {
            CHECK_ROW(strstr(error.message, rows[i].message) != NULL, rows[i].name);
        }
    }
}

/* A code with one more of the longest codes, of 15 bits, than there is room for. */
static void test_one_code_too_many(void) {
    struct stream stream = {{0x78, 0x01}, 16};
    struct error error;
    char out[8];
    put_string(&stream, "1 01 00000 00000 1111"); /* 257 literal codes, 1 distance, 19 lengths */
    put_string(&stream, "000 000 000"); /* 16, 17, 18 have none; 0 to 15 themselves, in 4 bits */
    for (int i = 0; i < 16; i++) {
        put_string(&stream, "001");
    }
    for (int i = 0; i < 258; i++) { /* 1, 2, ... 14, 15, 15 are complete; the end has 15 too */
        int length = i < 15 ? i + 1 : i == 15 || i == 256 ? 15 : i == 257 ? 1 : 0;
        for (int bit = 3; bit >= 0; bit--) {
            put_string(&stream, (length >> bit & 1) != 0 ? "1" : "0");
        }
    }
    CHECK(!zlib_decompress(stream.bytes, stream.bits / 8 + 8, out, sizeof out, &error));
    CHECK(strstr(error.message, "wrong code") != NULL);
}

/* The stream ends inside the header of a block, which does not begin on a whole byte there:
 * fixed codes with nothing but their end take 10 bits, a literal from 144 on takes 9. */
static void test_cut_headers(void) {
    static const struct {
        const char *name, *bits;
    } rows[] = {
        {"nothing", ""},
        {"after the kind", "0 10 0000000 0 01 000"},
        {"between last and kind", "0 10 110010000 0000000 0 10 0000000 0 10 0000000 1"},
        {"inside the number of codes", "0 10 0000000 0 10 0000000 0 01 0"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct stream stream = {{0x78, 0x01}, 16};
        struct error error = {0};
        char out[4];
        put_string(&stream, rows[i].bits);
        CHECK_ROW(stream.bits % 8 == 0, rows[i].name); /* no bit more than written here */
        CHECK_ROW(!zlib_decompress(stream.bytes, stream.bits / 8, out, sizeof out, &error),
                  rows[i].name);
        CHECK_ROW(strstr(error.message, "cut off") != NULL, error.message);
    }
}

/* Fixed codes before a block with codes of its own, and after it: "a" in each. */
static void test_changing_codes(void) {
    struct stream stream = {{0x78, 0x01}, 16};
    struct error error;
    char out[4] = "";
    put_string(&stream, "0 10 10010001 0000000");
    put_string(&stream, "0 10 10010001 0000000");
    put_string(&stream, "0 01 10000 00000 0111"); /* as in make_stream() */
    put_string(&stream, "000 000 100 000 000 000 000 000 000 000 000 000 000 000 000 010 000 010");
    put_string(&stream, "0 0110101 10 0 1111111 0 1001000 11 11 10 0 10");
    put_string(&stream, "1 10 10010001 0000000");
    size_t size = (stream.bits + 7) / 8;
    const uint8_t check[4] = {3, 0xce, 1, 0x85}; /* of "aaaa": 1 + 4 * 97 */
    memcpy(stream.bytes + size, check, sizeof check);
    CHECK(zlib_decompress(stream.bytes, size + sizeof check, out, sizeof out, &error));
    CHECK(memcmp(out, "aaaa", sizeof out) == 0);
}

/* A megabyte of empty blocks with fixed codes, of 10 bits each, takes no longer than other data. */
static void test_empty_blocks(void) {
    enum { SIZE = 1 << 20, REPEATED = 5 };
    static const uint8_t four_blocks[REPEATED] = {0x02, 0x08, 0x20, 0x80, 0x00};
    uint8_t *stream = calloc(SIZE, 1), out[1] = {0};
    struct error error;
    CHECK(stream != NULL);
    if (stream == NULL) {
        return;
    }
    stream[0] = 0x78;
    stream[1] = 0x01;
    for (size_t i = 2; i < SIZE; i++) {
        stream[i] = four_blocks[(i - 2) % REPEATED];
    }
    clock_t start = clock();
    CHECK(!zlib_decompress(stream, SIZE, out, sizeof out, &error));
    CHECK(strstr(error.message, "cut off") != NULL);
    CHECK(clock() - start < CLOCKS_PER_SEC); /* and is far below it */
    free(stream);
}

/* ---- Streams that the compressor makes ---- */

static uint32_t next_random(uint32_t *state) {
    *state = *state * 1664525u + 1013904223u;
    return *state >> 8;
}

enum data_kind { NOISE, WORDS, FAR, SAME, DATA_KINDS };

/* Noise; the words of a small language; far repetitions with changes; one byte. */
static void fill_data(uint8_t *data, size_t size, enum data_kind kind, uint32_t *state) {
    size_t i = 0;
    while (i < size) {
        size_t left = size - i, length = 1 + next_random(state) % 40;
        length = length < left ? length : left;
        if (kind == FAR && i > 2000 && next_random(state) % 4 != 0) {
            memmove(data + i, data + i - 1 - next_random(state) % (i < 32768 ? i - 1000 : 31000),
                    length);
            i += length;
        } else if (kind == WORDS) {
            uint32_t word = next_random(state) % 50;
            for (size_t k = 0; k < length && k < 3 + word % 9; k++) {
                data[i++] = (uint8_t)('a' + (word * (k + 3)) % 26);
            }
        } else {
            data[i++] = kind == SAME ? 7 : (uint8_t)next_random(state);
        }
    }
}

/* Every stream gives back its data; cut off at any byte it gives an error. */
static void test_cut_off(void) {
    enum { SIZE = 3000 };
    static uint8_t data[SIZE], out[SIZE];
    uint32_t state = 20;
    for (int i = 0; i < 24; i++) {
        size_t size = 1 + next_random(&state) % (i < 12 ? 60 : SIZE - 1), accepted = 0;
        struct bytes stream = {0};
        struct error error;
        fill_data(data, size, (enum data_kind)(i % DATA_KINDS), &state);
        if (!CHECK(zlib_compress(data, size, &stream, &error))) {
            return;
        }
        CHECK(zlib_decompress(stream.data, stream.size, out, size, &error));
        CHECK(memcmp(out, data, size) == 0);
        for (size_t cut = 0; cut < stream.size; cut++) {
            uint8_t *part = malloc(cut + (cut == 0)); /* so that reading past its end is seen */
            if (part == NULL) {
                break;
            }
            memcpy(part, stream.data, cut);
            error.message[0] = '\0';
            accepted += zlib_decompress(part, cut, out, size, &error);
            accepted += strstr(error.message, "cut off") == NULL;
            free(part);
        }
        CHECK(accepted == 0);
        bytes_free(&stream);
    }
}

/* More tokens than one block has, and more than one window. */
static void test_large(void) {
    enum { SIZE = 300000 };
    uint8_t *data = malloc(SIZE), *out = malloc(SIZE);
    uint32_t state = 21;
    for (int kind = NOISE; kind < DATA_KINDS && CHECK(data != NULL && out != NULL); kind++) {
        struct bytes stream = {0};
        struct error error;
        fill_data(data, SIZE, (enum data_kind)kind, &state);
        memset(out, 1, SIZE);
        CHECK(zlib_compress(data, SIZE, &stream, &error));
        CHECK(stream.size < SIZE + SIZE / 1000 + 100); /* never much larger, not even noise */
        CHECK(zlib_decompress(stream.data, stream.size, out, SIZE, &error));
        CHECK(memcmp(out, data, SIZE) == 0);
        bytes_free(&stream);
    }
    free(data);
    free(out);
}

UNIT_MAIN(TEST(test_single_codes), TEST(test_one_code_too_many), TEST(test_cut_headers),
          TEST(test_changing_codes), TEST(test_empty_blocks), TEST(test_cut_off), TEST(test_large))
