/*
 * Deflate. Streams are put together here bit by bit from RFC 1951, with codes and checksums that
 * share nothing with the code under test, and decoded from blocks of exactly their size, so that
 * the address sanitizer sees a read past the end.
 */
#include "files/deflate.h"
#include "unit/images.h"

#include <time.h>

/* ---- Streams by hand ---- */

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

/* Append the bits of a string such as "1 0110 ", where blanks only please the eye. */
static void put_string(struct bits *bits, const char *digits) {
    for (; *digits != '\0'; digits++) {
        if (*digits != ' ') {
            put_bits(bits, *digits == '1', 1);
        }
    }
}

/* A symbol of the fixed code. */
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

/* The beginning of a block with its own codes, and the lengths 0 to 15 with the codes 0000 to
 * 1111. */
static void put_own_header(struct bits *bits, unsigned literals, unsigned distances) {
    put_string(bits, "1 01");
    put_bits(bits, literals - 257, 5);
    put_bits(bits, distances - 1, 5);
    put_bits(bits, 19 - 4, 4);
    put_string(bits, "000 000 000 001 001 001 001 001 001 001 001 001 001 001 001 001 001 001 001");
}

/* The beginning of a stored block; `count` bytes must follow. */
static void put_stored_header(struct bits *bits, bool last, unsigned count) {
    put_bits(bits, last, 3);
    bits->count = 0; /* the rest of the byte is skipped */
    put_bits(bits, count, 16);
    put_bits(bits, ~count & 0xffff, 16);
}

/* A zlib stream around the blocks, which are freed, with the checksum of `plain`. */
static struct bytes wrap_blocks(struct bits *bits, const void *plain, size_t size) {
    struct bytes stream = {0};
    uint32_t check = slow_adler(plain, size);
    put(&stream, 0x78);
    put(&stream, 0x01);
    CHECK(bytes_append(&stream, bits->bytes.data, bits->bytes.size));
    for (unsigned shift = 32; shift > 0; shift -= 8) {
        put(&stream, check >> (shift - 8) & 255);
    }
    bytes_free(&bits->bytes);
    *bits = (struct bits){0};
    return stream;
}

/* Does the stream give just these bytes? Otherwise there is a message. */
static bool gives(const uint8_t *data, size_t size, const void *plain, size_t plain_size,
                  struct error *error) {
    uint8_t *copy = exact_copy(data, size), *out = new_memory(plain_size);
    error->message[0] = '\0';
    bool done = zlib_decompress(copy, size, out, plain_size, error);
    bool same = done && (plain_size == 0 || memcmp(out, plain, plain_size) == 0);
    CHECK(done || error->message[0] != '\0');
    free(copy);
    free(out);
    return same;
}

/* The blocks give `plain`. */
static void check_blocks(struct bits *bits, const void *plain, size_t size) {
    struct error error;
    struct bytes stream = wrap_blocks(bits, plain, size);
    CHECK(gives(stream.data, stream.size, plain, size, &error));
    bytes_free(&stream);
}

/* The blocks are refused, whatever follows them, with this message. */
static void check_refused(struct bits *bits, size_t size, const char *message, const char *row) {
    struct error error;
    uint8_t *plain = new_memory(size);
    put_bits(bits, 0, 32);
    struct bytes stream = wrap_blocks(bits, plain, 0);
    CHECK_ROW(!gives(stream.data, stream.size, plain, size, &error), row);
    CHECK_ROW(strstr(error.message, message) != NULL, error.message);
    free(plain);
    bytes_free(&stream);
}

/* A block with its own codes: 258 literal codes, of which "a" has the code 0, the end of the
 * block 10 and the length 3 code 11. The distances and their number come between and behind. */
#define OWN   "01 10000"
#define ORDER "0111 000 000 100 000 000 000 000 000 000 000 000 000 000 000 000 010 000 010 "
#define LENGTHS                                                                                    \
    ORDER                                                                                          \
    "0 0110101 10 0 1111111 0 1001000 " /* 97 zeros, 1, 138 + 20 zeros */
#define CODES LENGTHS "11 11 "

/* Bytes of a stream without which all that is wanted may be there: of the end of the block, where
 * that has one of its own, and of the checksum, which isn't looked at. */
enum { CHECK_AND_END = 5 };

static void test_right_blocks(void) {
    static const struct {
        const char *bits, *plain;
    } rows[] = {
        {"1 00 00000 0100000000000000 1011111111111111 10000110 01000110", "ab"},
        {"0 00 00000 1000000000000000 0111111111111111 10000110"
         "0 00 00000 0000000000000000 1111111111111111"
         "1 00 00000 1000000000000000 0111111111111111 01000110",
         "ab"},
        {"1 10 10010001 110011010 0000000", "a\x9a"},
        {"1 10 10010001 10010010 0000011 00001 0001001 1 00100 1 0000000", "abababababababababa"},
        {"1 " OWN "00000" CODES "10 0 11 0 10", "aaaa"},      /* a single distance, of one bit */
        {"1 " OWN "11010" CODES "0 1000000 0 0 0 10", "aaa"}, /* no distance */
        {"0 10 10010001 0000000 0 10 10010001 0000000 0 " OWN "00000" CODES "10 0 10"
         "1 10 10010001 0000000",
         "aaaa"}, /* other codes, and back */
        /* 97 zeros, 1, 138 + 10 + 10 zeros, twice 2; 1 */
        {"1 " OWN
         "00000 0111 000 010 010 000 000 000 000 000 000 000 000 000 000 000 000 010 000 010 "
         "11 0110101 00 11 1111111 10 111 10 111 01 01 00 0 11 0 10",
         "aaaa"},
        /* a code length repeated: 97 zeros, 3, six times 3, 152 zeros, 3 and no distance */
        {"1 01 00000 00000 0101 110 000 100 110 000 000 000 000 000 000 000 000 000 010"
         "0 0110101 10 111 11 0 1111111 0 1100000 10 110"
         "110 101 100 011 010 001 000 111",
         "gfedcba"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct bits bits = {0};
        struct error error;
        const char *plain = rows[i].plain;
        size_t size = strlen(plain);
        put_string(&bits, rows[i].bits);
        struct bytes stream = wrap_blocks(&bits, plain, size);
        CHECK_ROW(gives(stream.data, stream.size, plain, size, &error), rows[i].bits);
        CHECK_ROW(!gives(stream.data, stream.size, plain, size + 1, &error), rows[i].bits);
        CHECK_ROW(gives(stream.data, stream.size, plain, size - 1, &error), rows[i].bits);
        for (size_t cut = 0; cut < stream.size; cut++) {
            bool all = gives(stream.data, cut, plain, size, &error);
            CHECK_ROW(all ? cut + CHECK_AND_END >= stream.size
                          : strstr(error.message, "cut off") != NULL,
                      error.message);
            CHECK_ROW(all || cut + 4 < stream.size, rows[i].bits);
        }
        for (size_t at = stream.size - 4; at < stream.size; at++) {
            stream.data[at] ^= 1;
            CHECK_ROW(gives(stream.data, stream.size, plain, size, &error), rows[i].bits);
            stream.data[at] ^= 1;
        }
        bytes_free(&stream);
    }
}

/* Data that no compressor makes, shortly before the end and far from it. */
static void test_wrong_blocks(void) {
    static const struct {
        const char *name, *message, *bits;
    } rows[] = {
        {"block of kind 3", "unknown kind", "1 11"},
        {"stored length and complement differ", "stored length",
         "1 00 00000 1000000000000000 1111111111111111"},
        {"stored length and complement differ in their second byte", "stored length",
         "1 00 00000 0000000010000000 1111111111111111"},
        {"length 286", "length that does not exist", "1 10 01010000 11000110 00000"},
        {"length 287", "length that does not exist", "1 10 01010000 11000111 00000"},
        {"distance 30", "distance that does not exist", "1 10 01010000 0000001 11110"},
        {"distance 31", "distance that does not exist", "1 10 01010000 0000001 11111"},
        {"distance before the start", "from before", "1 10 01010000 0000001 00001"},
        {"match at once", "from before", "1 10 0000001 00000"},
        {"287 literal codes", "too many codes", "1 01 01111 00000 0000"},
        {"31 distance codes", "too many codes", "1 01 00000 01111 0000"},
        {"three codes of one bit", "wrong code", "1 01 00000 00000 0000 100 100 100 000"},
        {"incomplete code for lengths", "wrong code", "1 01 00000 00000 0000 010 010 010 000"},
        {"repeat before the first", "before the first",
         "1 01 00000 00000 0000 100 100 000 000 0 00"},
        /* 18 = 138 zeros has code 1, 0 has code 0: 138 + 138 > 258 */
        {"too many lengths", "too many code lengths",
         "1 01 00000 00000 0000 000 000 100 100 1 1111111 1 1111111"},
        {"a length too many", "too many code lengths",
         "1 01 00000 00000 0000 000 000 100 100 1 1111111 1 0111011"},
        /* all 258 lengths are zero */
        {"no end of block", "wrong code",
         "1 01 00000 00000 0000 000 000 100 100 1 1111111 1 1011011"},
        {"a code too many", "wrong code", "1 " OWN "00000" LENGTHS "10 11 10"},
        {"distances leave room", "wrong code", "1 " OWN "10000" CODES "11 11"},
        {"a single distance of two bits", "wrong code", "1 " OWN "00000" CODES "11"},
        {"the code that a single distance leaves", "means nothing",
         "1 " OWN "00000" CODES "10 0 11 1"},
        {"the code that a single length of a code leaves", "means nothing",
         "1 01 00000 00000 0000 000 000 100 000 1"},
        /* 138 + 118 zeros, then the end of the block and a distance, of one bit each */
        {"the code that the end of the block leaves", "means nothing",
         "1 01 00000 00000 " ORDER "0 1111111 0 1101011 10 10 1"},
        {"a distance where there is none", "means nothing",
         "1 " OWN "11010" CODES "0 1000000 0 11"},
    };
    for (size_t i = 0; i < 2 * sizeof rows / sizeof rows[0]; i++) {
        bool far = i % 2 == 1;
        struct bits bits = {0};
        put_string(&bits, rows[i / 2].bits);
        for (int k = 0; far && k < 20; k++) {
            put_bits(&bits, 0, 8);
        }
        check_refused(&bits, far ? 500 : 16, rows[i / 2].message, rows[i / 2].name);
    }
}

/* What follows the bytes that are wanted is passed over, also in the middle of a match or of a
 * stored block; nothing is written behind them. */
static void test_more_than_wanted(void) {
    static const struct {
        const char *bits, *plain;
    } rows[] = {
        {"1 10 01010000 0001000 0 00000 0001000 0 00000 0000000", "    "},
        {"1 00 00000 1100000000000000 0011111111111111 10000110 01000110 11000110", "ab"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct bits bits = {0};
        struct error error;
        put_string(&bits, rows[i].bits);
        struct bytes stream = wrap_blocks(&bits, "", 0);
        CHECK_ROW(gives(stream.data, stream.size, rows[i].plain, strlen(rows[i].plain), &error),
                  error.message);
        bytes_free(&stream);
    }
}

/* A stored block begins with the byte after those of which bits have been taken, however many the
 * block before it has taken ahead, and after it nothing of them may be left. */
static void test_stored_after_others(void) {
    enum { STORED = 40, LAST = 300, MOST = 2 * 64 + STORED + LAST };
    uint8_t text[MOST];
    for (size_t i = 0; i < MOST; i++) {
        text[i] = (uint8_t)(i % 7 == 0 ? 0xe5 : 'a' + i % 23); /* 9 and 8 bits */
    }
    for (size_t count = 0; count < 2 * 64; count += 2) { /* another bit and another byte */
        struct bits bits = {0};
        put_string(&bits, "0 10");
        for (size_t i = 0; i < count; i++) {
            put_fixed(&bits, text[i]);
        }
        put_fixed(&bits, 256);
        put_stored_header(&bits, false, STORED);
        CHECK(bytes_append(&bits.bytes, text + count, STORED));
        put_string(&bits, "1 10");
        for (size_t i = count + STORED; i < count + STORED + LAST; i++) {
            put_fixed(&bits, text[i]);
        }
        put_fixed(&bits, 256);
        check_blocks(&bits, text, count + STORED + LAST);
    }
}

/* How a distance is written: a symbol and bits. */
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

static void put_distance(struct bits *bits, size_t distance) {
    struct place place = place_of_distance(distance);
    put_code(bits, place.symbol, 5);
    put_bits(bits, place.extra, place.extra_bits);
}

/* The longest match, copied in blocks, some bytes before the end of what comes out: nothing may be
 * written after it, and nothing read after the end of a stream that is cut off. */
static void test_matches_near_end(void) {
    enum { BEGINNING = 300, MATCH = 258, REST = 40 };
    for (size_t rest = 0; rest < REST; rest++) {
        for (size_t distance = 1; distance < 40; distance++) {
            uint8_t plain[BEGINNING + MATCH + REST] = {0};
            size_t size = BEGINNING + MATCH + rest;
            struct bits bits = {0};
            struct error error;
            put_string(&bits, "1 10");
            for (size_t i = 0; i < size; i++) {
                bool copied = i >= BEGINNING && i < BEGINNING + MATCH;
                plain[i] = copied ? plain[i - distance] : (uint8_t)(i % 140);
                if (!copied) {
                    put_fixed(&bits, plain[i]);
                } else if (i == BEGINNING) {
                    put_fixed(&bits, 285);
                    put_distance(&bits, distance);
                }
            }
            put_fixed(&bits, 256);
            struct bytes stream = wrap_blocks(&bits, plain, size);
            CHECK(gives(stream.data, stream.size, plain, size, &error));
            for (size_t cut = stream.size - 320; distance == 1 && cut < stream.size; cut++) {
                bool all = gives(stream.data, cut, plain, size, &error);
                CHECK(all ? cut + CHECK_AND_END >= stream.size : cut + 4 < stream.size);
            }
            bytes_free(&stream);
        }
    }
}

/* Codes of 1 to 15 bits, of literals and of distances: one of 15 bits more is one too many. */
static void test_long_codes(void) {
    struct bits literals = {0};
    put_own_header(&literals, 257, 1);
    for (unsigned i = 0; i < 257 + 1; i++) {
        put_code(&literals, i == 256 ? 1 : i == 0 || i == 255 ? 15 : i < 14 ? i + 1 : 0, 4);
    }
    put_string(&literals, "111111111111110 111111111111111 0"); /* the first literal, the last */
    check_blocks(&literals, "\0\xff", 2);
    for (unsigned more = 0; more < 2; more++) {
        struct bits bits = {0};
        put_own_header(&bits, 257, 16 + more);
        for (int i = 0; i < 257; i++) {
            put_code(&bits, i == 0 || i == 256, 4);
        }
        for (unsigned i = 1; i < 17 + more; i++) {
            put_code(&bits, i < 15 ? i : 15, 4);
        }
        put_string(&bits, "0 1");
        if (more == 0) {
            check_blocks(&bits, "", 1);
        } else {
            check_refused(&bits, 1, "wrong code", "a code of 15 bits too many");
        }
    }
}

static void test_zlib_header(void) {
    static const struct {
        const char *name;
        uint8_t method, flags;
        bool right;
    } rows[] = {
        {"window of 32768", 0x78, 0x01, true},   {"window of 256", 0x08, 0x1d, true},
        {"wrong check", 0x78, 0x02, false},      {"another method", 0x79, 0x18, false},
        {"window too large", 0x88, 0x1c, false}, {"dictionary", 0x78, 0x20, false},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct error error;
        uint8_t stream[] = {rows[i].method, rows[i].flags, 0x4b, 0x04, 0, 0, 0x62, 0, 0x62};
        CHECK_ROW(gives(stream, sizeof stream, "a", 1, &error) == rows[i].right, rows[i].name);
    }
}

/* A megabyte of empty blocks with fixed codes, of 10 bits each, takes no longer than other data. */
static void test_empty_blocks(void) {
    enum { SIZE = 1 << 20, REPEATED = 5 };
    static const uint8_t four_blocks[REPEATED] = {0x02, 0x08, 0x20, 0x80, 0x00};
    uint8_t *stream = new_memory(SIZE), out[1] = {0};
    struct error error;
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

/* One byte; noise; bits; the words of a small language; repetitions with changes, some of them
 * from about as far as the format has distances; each value half as frequent as the one before. */
enum data_kind { SAME, NOISE, BITS, WORDS, FAR, STEEP, DATA_KINDS };

static void fill_data(uint8_t *data, size_t size, enum data_kind kind) {
    static const char *const words[] = {"the ", "pixel ", "of ", "row ", "is ", "a ", "light "};
    uint32_t state = 9;
    for (size_t i = 0; i < size;) {
        uint32_t number = next_random(&state);
        size_t left = size - i, length = 1 + number % 40;
        length = length < left ? length : left;
        if (kind == FAR && i > 2000 && number % 4 != 0) {
            size_t distance = 1 + next_random(&state) % (i < 32768 ? i - 1000 : 31000);
            distance = i > 32800 && number % 8 == 1 ? 32765 + distance % 7 : distance;
            memmove(data + i, data + i - distance, length);
            i += length;
        } else if (kind == WORDS) {
            for (const char *word = words[number % 7]; *word != '\0' && i < size; word++) {
                data[i++] = (uint8_t)*word;
            }
        } else if (kind == STEEP) {
            for (data[i] = 0; (number & 1) != 0 && data[i] < 24; data[i]++) {
                number >>= 1;
            }
            i++;
        } else {
            data[i++] = (uint8_t)(kind == SAME ? 255 : kind == BITS ? number & 1 : number);
        }
    }
}

/* The checksum is that of the definition, also where its sums are as large as they get. */
static bool has_checksum_of(const struct bytes *packed, const uint8_t *plain, size_t size) {
    uint32_t check = 0;
    for (size_t i = packed->size - 4; i < packed->size; i++) {
        check = check << 8 | packed->data[i];
    }
    return check == slow_adler(plain, size);
}

/* Every stream gives back its data, behind what was there before; a short one that is cut off
 * before the end of its block gives an error. Sizes of more tokens than one block has, and of more
 * than one window. */
static void test_compress(void) {
    static const size_t sizes[] = {0,   1,   2,   3,    4,     5,      100,
                                   257, 258, 259, 2900, 32768, 140000, 300000};
    enum { LIMIT = 300000 };
    /* Bytes of the largest stream, not one more than they are. With the best codes they would be
     * 318, 302815, 1472, 47732, 57051 and 17890. */
    static const size_t most[DATA_KINDS] = {
        [SAME] = 319,    [NOISE] = 302815, [BITS] = 1472,
        [WORDS] = 47769, [FAR] = 57113,    [STEEP] = 17894,
    };
    for (int kind = 0; kind < DATA_KINDS; kind++) {
        for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
            size_t size = sizes[i], wrong = 0;
            uint8_t *plain = new_memory(size);
            struct bytes packed = {0};
            struct error error;
            put(&packed, 88);
            fill_data(plain, size, (enum data_kind)kind);
            CHECK(zlib_compress(plain, size, &packed, &error));
            CHECK(packed.data[0] == 88 && packed.data[1] == 0x78);
            CHECK(has_checksum_of(&packed, plain, size));
            CHECK(gives(packed.data + 1, packed.size - 1, plain, size, &error));
            for (size_t cut = 0; size > 0 && size < 3000 && cut < packed.size - 1; cut++) {
                bool all = gives(packed.data + 1, cut, plain, size, &error);
                wrong += all ? cut + 7 < packed.size - 1 : strstr(error.message, "cut off") == NULL;
            }
            CHECK(wrong == 0);
            CHECK(size < LIMIT || packed.size <= most[kind]);
            free(plain);
            bytes_free(&packed);
        }
    }
}

UNIT_MAIN(TEST(test_right_blocks), TEST(test_wrong_blocks), TEST(test_more_than_wanted),
          TEST(test_stored_after_others), TEST(test_matches_near_end), TEST(test_long_codes),
          TEST(test_zlib_header), TEST(test_empty_blocks), TEST(test_compress))
