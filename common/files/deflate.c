/*
 * Deflate in both directions; see deflate.h. RFC 1951 explains every term that is used here.
 *
 * Compression: (1) find earlier copies of the bytes to come (LZ77) through chains of positions with
 * equal hashes; (2) collect literals and matches into blocks; (3) write each block with prefix
 * codes of its own. (Pictures need none of the other two kinds of block, which a decoder must
 * know.)
 */
#include "files/deflate.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum {
    WINDOW_SIZE = 32768, /* largest distance of a match */
    MATCH_MIN = 3,       /* shortest and longest match of the format */
    MATCH_MAX = 258,
    END_OF_BLOCK = 256,
    FIRST_LENGTH = 257,
    LITERAL_COUNT = 286, /* literals, end of block, lengths */
    DISTANCE_COUNT = 30,
    SYMBOL_COUNT = LITERAL_COUNT + DISTANCE_COUNT, /* of a block: its distances come last */
    ORDER_COUNT = 19,                              /* symbols that describe code lengths */
    CODE_LIMIT = 15,                               /* bits of the longest code */
    SYMBOL_LIMIT = 288 /* the fixed code gives a code to two symbols that never appear */
};

/* The order in which a block's header gives the lengths of the codes for code lengths. */
static const uint8_t length_order[ORDER_COUNT] = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                  11, 4,  12, 3, 13, 2, 14, 1, 15};

/* The sum of all bytes, and the sum of all these sums: each byte is in as many of them as bytes
 * are left from it on. */
static uint32_t adler32(const uint8_t *data, size_t size) {
    enum { MODULUS = 65521, SAFE = 5552 }; /* SAFE additions stay inside 32 bits */
    uint32_t a = 1, b = 0;
    while (size > 0) {
        uint32_t count = size < SAFE ? (uint32_t)size : SAFE, sum = 0, sum_of_sums = 0;
        for (uint32_t i = 0; i < count; i++) {
            sum += data[i];
            sum_of_sums += (count - i) * data[i];
        }
        b = (b + count * a + sum_of_sums) % MODULUS;
        a = (a + sum) % MODULUS;
        data += count;
        size -= count;
    }
    return b << 16 | a;
}

/* ---- Lengths and distances ----
 *
 * Both are written like small floating-point numbers: a symbol holds the position of the highest
 * bit and the next `kept` bits; the bits below follow as they are. */

struct split {
    unsigned symbol;     /* of the block */
    unsigned extra_bits; /* how many bits follow the symbol */
};

static struct split split_value(unsigned value, unsigned kept, unsigned first_symbol) {
    unsigned extra = 0;
    while (value >> extra >= 2u << kept) {
        extra++;
    }
    return (struct split){first_symbol + (extra << kept) + (value >> extra), extra};
}

static struct split split_length(unsigned length) {
    return length == MATCH_MAX ? (struct split){LITERAL_COUNT - 1, 0}
                               : split_value(length - MATCH_MIN, 2, FIRST_LENGTH);
}

static struct split split_distance(unsigned distance) {
    return split_value(distance - 1, 1, LITERAL_COUNT);
}

/* The smallest value that has the symbol, and the number of its extra bits. */
static inline unsigned join_value(unsigned symbol, unsigned kept, unsigned *extra_bits) {
    unsigned extra = symbol >> kept > 1 ? (symbol >> kept) - 1 : 0;
    *extra_bits = extra;
    return (symbol - (extra << kept)) << extra;
}

/* ---- Huffman codes ---- */

/* Codes from their lengths (RFC 1951, section 3.2.2), with the first bit of a code lowest, as it is
 * written. */
static void assign_codes(const uint8_t *lengths, size_t count, uint16_t *codes) {
    unsigned with_length[CODE_LIMIT + 1] = {0};
    unsigned next[CODE_LIMIT + 1] = {0};
    for (size_t i = 0; i < count; i++) {
        with_length[lengths[i]]++;
    }
    with_length[0] = 0;
    for (unsigned bits = 1; bits <= CODE_LIMIT; bits++) {
        next[bits] = (next[bits - 1] + with_length[bits - 1]) << 1;
    }
    for (size_t i = 0; i < count; i++) {
        unsigned code = next[lengths[i]]++, reversed = 0;
        for (unsigned bit = 0; bit < lengths[i]; bit++) {
            reversed = reversed << 1 | (code >> bit & 1);
        }
        codes[i] = (uint16_t)reversed;
    }
}

/* ---- Compression ---- */

enum {
    HASH_BITS = 15,
    HASH_BYTES = 4,         /* positions are found by so many bytes */
    MATCH_WORTH = 5,        /* a shorter copy costs as much as literals */
    MATCH_ENOUGH = 128,     /* stop searching */
    CHAIN_LIMIT = 32,       /* earlier positions to try */
    BLOCK_TOKENS = 1 << 14, /* literals and matches of a block */
    TOKEN_BYTES = 6,        /* at most, of a token with its codes and extra bits */
    HEADER_BYTES = 1024     /* a block's header has less */
};

/* A literal byte (distance 0) or a copy of earlier bytes. */
struct token {
    uint16_t distance;
    uint16_t value; /* the byte, or the length of the copy */
};

/* Where bits are written. */
struct bit_writer {
    uint8_t *next;
    uint64_t bits;  /* not yet written, the next one lowest */
    unsigned count; /* of them: below 8 */
};

struct compressor {
    const uint8_t *data;
    size_t size;

    /* One more than the newest position with a hash, modulo 2^32 (a wrong one does no harm: the
     * bytes there are compared); and how far before each position of the window another one has the
     * same hash, 0 where none has. */
    uint32_t newest[1 << HASH_BITS];
    uint16_t back[WINDOW_SIZE];
    size_t hashed; /* positions entered so far */

    struct token tokens[BLOCK_TOKENS]; /* the block that is being collected */
    size_t token_count;
    uint32_t counts[SYMBOL_COUNT]; /* how often it has each symbol */

    struct bytes *out;
    struct bit_writer writer;
};

/* Room for what is written must have been reserved. */
static inline void put_bits(struct bit_writer *writer, unsigned value, unsigned count) {
    writer->bits |= (uint64_t)value << writer->count;
    writer->count += count;
    for (; writer->count >= 8; writer->count -= 8) {
        *writer->next++ = (uint8_t)(writer->bits & 255);
        writer->bits >>= 8;
    }
}

/* Complete codes that are nearly the shortest. First a symbol's share of all bit strings is no more
 * than its share of what is counted (C. E. Shannon, "A Mathematical Theory of Communication", 1948,
 * section 9); strings that are left then go to the symbol that needs them most, which gets twice as
 * many. At least two symbols occur, and no more than 1 << CODE_LIMIT are counted in all. */
static void choose_lengths(const uint32_t *counts, size_t symbol_count, uint8_t *lengths) {
    uint32_t total = 0, left = 1u << CODE_LIMIT;
    for (size_t i = 0; i < symbol_count; i++) {
        total += counts[i];
    }
    for (size_t i = 0; i < symbol_count; i++) {
        lengths[i] = counts[i] > 0;
        while (lengths[i] > 0 && counts[i] << lengths[i] < total) {
            lengths[i]++;
        }
        left -= lengths[i] > 0 ? 1u << (CODE_LIMIT - lengths[i]) : 0;
    }
    while (left > 0) {
        size_t best = 0;
        uint32_t need = 0;
        for (size_t i = 0; i < symbol_count; i++) {
            bool fits = lengths[i] > 1 && 1u << (CODE_LIMIT - lengths[i]) <= left;
            if (fits && counts[i] << lengths[i] > need) {
                need = counts[i] << lengths[i];
                best = i;
            }
        }
        left -= 1u << (CODE_LIMIT - lengths[best]);
        lengths[best]--;
    }
}

/* The codes of a block, for all symbols, whether they occur or not. */
struct block_codes {
    uint8_t lengths[SYMBOL_COUNT];
    uint16_t codes[SYMBOL_COUNT];
};

/* The code lengths, themselves coded, with the same code for every block: a length as it is, and
 * with symbol 18 from 11 to 138 zeros. */
static void write_header(struct bit_writer *writer, const struct block_codes *codes) {
    enum { ZEROS = 18, ZEROS_MIN = 11, ZEROS_MAX = 138 };
    static const uint8_t order_lengths[ORDER_COUNT] = {4, 4, 4, 4, 4, 4, 4, 4, 4, 4,
                                                       4, 4, 4, 4, 5, 5, 0, 0, 4};
    uint16_t order_codes[ORDER_COUNT];
    assign_codes(order_lengths, ORDER_COUNT, order_codes);
    put_bits(writer, LITERAL_COUNT - FIRST_LENGTH, 5);
    put_bits(writer, DISTANCE_COUNT - 1, 5);
    put_bits(writer, ORDER_COUNT - 4, 4);
    for (size_t i = 0; i < ORDER_COUNT; i++) {
        put_bits(writer, order_lengths[length_order[i]], 3);
    }
    for (size_t i = 0; i < SYMBOL_COUNT;) {
        unsigned length = codes->lengths[i], zeros = 0;
        while (zeros < ZEROS_MAX && i + zeros < SYMBOL_COUNT && codes->lengths[i + zeros] == 0) {
            zeros++;
        }
        unsigned symbol = zeros >= ZEROS_MIN ? ZEROS : length;
        put_bits(writer, order_codes[symbol], order_lengths[symbol]);
        if (symbol == ZEROS) {
            put_bits(writer, zeros - ZEROS_MIN, 7);
        }
        i += symbol == ZEROS ? zeros : 1;
    }
}

/* A symbol, and the lowest `extra_bits` of a number. */
static inline void put_symbol(struct bit_writer *writer, const struct block_codes *codes,
                              unsigned symbol, unsigned number, unsigned extra_bits) {
    put_bits(writer, codes->codes[symbol], codes->lengths[symbol]);
    put_bits(writer, number & ((1u << extra_bits) - 1), extra_bits);
}

static void write_tokens(const struct compressor *c, struct bit_writer *writer,
                         const struct block_codes *codes) {
    for (size_t i = 0; i < c->token_count; i++) {
        struct token token = c->tokens[i];
        if (token.distance == 0) {
            put_symbol(writer, codes, token.value, 0, 0);
            continue;
        }
        struct split length = split_length(token.value), distance = split_distance(token.distance);
        put_symbol(writer, codes, length.symbol, token.value - MATCH_MIN, length.extra_bits);
        put_symbol(writer, codes, distance.symbol, token.distance - 1u, distance.extra_bits);
    }
    put_symbol(writer, codes, END_OF_BLOCK, 0, 0);
}

/* Write the collected tokens as a block. False when memory runs out. */
static bool write_block(struct compressor *c, bool last) {
    struct block_codes codes = {0};
    if (!bytes_reserve(c->out, c->token_count * TOKEN_BYTES + HEADER_BYTES)) {
        return false;
    }
    c->counts[END_OF_BLOCK] = 1;
    c->counts[0]++; /* one symbol alone is no complete code */
    c->counts[LITERAL_COUNT]++;
    c->counts[LITERAL_COUNT + 1]++;
    choose_lengths(c->counts, LITERAL_COUNT, codes.lengths);
    choose_lengths(c->counts + LITERAL_COUNT, DISTANCE_COUNT, codes.lengths + LITERAL_COUNT);
    assign_codes(codes.lengths, LITERAL_COUNT, codes.codes);
    assign_codes(codes.lengths + LITERAL_COUNT, DISTANCE_COUNT, codes.codes + LITERAL_COUNT);

    struct bit_writer writer = c->writer; /* a copy, so that it stays in registers */
    writer.next = c->out->data + c->out->size;
    put_bits(&writer, last, 1);
    put_bits(&writer, 2, 2);
    write_header(&writer, &codes);
    write_tokens(c, &writer, &codes);
    if (last) {
        put_bits(&writer, 0, (8 - writer.count) % 8);
    }
    c->writer = writer;
    c->out->size = (size_t)(writer.next - c->out->data);
    c->token_count = 0;
    memset(c->counts, 0, sizeof c->counts);
    return true;
}

/* The four bytes as a number, the same on every machine, so that every machine finds the same. */
static uint32_t hash_at(const uint8_t *bytes) {
    return (uint32_t)(load_u32(bytes) * 2654435761u) >> (32 - HASH_BITS);
}

/* Enter all positions before `end` into the chains. */
static void enter_positions(struct compressor *c, size_t end) {
    size_t limit = c->size < HASH_BYTES ? 0 : c->size - HASH_BYTES + 1;
    end = end < limit ? end : limit;
    for (size_t i = c->hashed; i < end; i++) {
        uint32_t hash = hash_at(c->data + i);
        uint32_t position = (uint32_t)i + 1, back = position - c->newest[hash];
        c->back[i % WINDOW_SIZE] = (uint16_t)(back <= WINDOW_SIZE && back <= i ? back : 0);
        c->newest[hash] = position;
    }
    c->hashed = end > c->hashed ? end : c->hashed;
}

/* The positions of a match are entered with the one behind it, of a long match only those at its
 * ends. Within a run of one colour all others are alike: they would take long to search, and hide
 * what lies further back. */
static void enter_match(struct compressor *c, size_t at, size_t length) {
    enum { END = 8 };
    if (length > 2 * END) {
        enter_positions(c, at + END);
        c->hashed = at + length - END;
    }
}

static unsigned count_equal(const uint8_t *a, const uint8_t *b, unsigned limit) {
    unsigned count = 0;
    while (count + 8 <= limit && memcmp(a + count, b + count, 8) == 0) {
        count += 8;
    }
    while (count < limit && a[count] == b[count]) {
        count++;
    }
    return count;
}

/* Enter position `at` and find the longest earlier copy of what is there, among the newest
 * positions of its hash; the byte alone, if none is worth it. */
static struct token find_token(struct compressor *c, size_t at) {
    const uint8_t *here = c->data + at;
    struct token token = {0, *here};
    size_t left = c->size - at, distance = 0;
    unsigned limit = left < MATCH_MAX ? (unsigned)left : MATCH_MAX, longest = MATCH_WORTH - 1;
    enter_positions(c, at + 1);
    for (int i = 0; i < CHAIN_LIMIT && longest < MATCH_ENOUGH && longest < limit; i++) {
        unsigned back = c->back[(at - distance) % WINDOW_SIZE];
        distance += back;
        if (back == 0 || distance > WINDOW_SIZE) {
            break;
        }
        const uint8_t *there = here - distance;
        const unsigned tail = longest + 1 - HASH_BYTES; /* a longer match has these bytes too */
        if (memcmp(there + tail, here + tail, HASH_BYTES) == 0) {
            unsigned equal = count_equal(there, here, limit);
            if (equal > longest) {
                longest = equal;
                token = (struct token){(uint16_t)distance, (uint16_t)equal};
            }
        }
    }
    return token;
}

/* False when memory runs out. */
static bool add_token(struct compressor *c, struct token token) {
    c->tokens[c->token_count++] = token;
    if (token.distance == 0) {
        c->counts[token.value]++;
    } else {
        c->counts[split_length(token.value).symbol]++;
        c->counts[split_distance(token.distance).symbol]++;
    }
    return c->token_count < BLOCK_TOKENS || write_block(c, false);
}

/* Turn the data into tokens and blocks; false when memory runs out. */
static bool compress_data(struct compressor *c) {
    bool done = true;
    for (size_t at = 0; done && at < c->size;) {
        struct token token = find_token(c, at);
        done = add_token(c, token);
        if (token.distance > 0) {
            enter_match(c, at, token.value);
        }
        at += token.distance > 0 ? token.value : 1;
    }
    return done && write_block(c, true);
}

bool zlib_compress(const void *data, size_t size, struct bytes *out, struct error *error) {
    static const uint8_t head[2] = {0x78, 0x9c}; /* deflate, window of 32768, check bits */
    size_t start = out->size;
    struct compressor *c = calloc(1, sizeof *c);
    if (c == NULL || !bytes_append(out, head, sizeof head)) {
        goto fail;
    }
    c->data = data;
    c->size = size;
    c->out = out;
    uint32_t sum = adler32(data, size);
    const uint8_t check[4] = {(uint8_t)(sum >> 24), (uint8_t)(sum >> 16 & 255),
                              (uint8_t)(sum >> 8 & 255), (uint8_t)(sum & 255)};
    if (!compress_data(c) || !bytes_append(out, check, sizeof check)) {
        goto fail;
    }
    free(c);
    return true;
fail:
    free(c);
    out->size = start;
    return error_out_of_memory(error);
}

/* ---- Decompression ---- */

enum {
    FAST_BITS = 12, /* codes up to this length are found in a table */
    COPY_BLOCK = 16
};

static const char data_cut_off[] = "compressed data cut off";

/* Bits of a stream. Zeros follow behind its end; a reader finds out later that it took some. Above
 * the `count` bits there may be some of the byte that comes next. */
struct bit_reader {
    const uint8_t *next, *end; /* bytes that are not yet taken */
    uint64_t bits;             /* taken, not yet used; the next one lowest */
    unsigned count;
    unsigned missing; /* bytes among them that follow the end */
};

/* A prefix code. An entry is symbol * 16 + length of a code; `fast` gives that which the next
 * FAST_BITS bits begin with, or 0. Longer codes are searched for: each takes so many bits of the
 * stream that this is no hostile stream's chance. */
struct decoder {
    uint16_t fast[1 << FAST_BITS];
    uint16_t codes[SYMBOL_LIMIT];
    uint8_t lengths[SYMBOL_LIMIT];
    size_t count;
};

struct decompressor {
    struct bit_reader in;
    uint8_t *out;
    size_t out_size, out_limit;
    struct decoder literals, distances;
    bool fixed;          /* they are those of the fixed codes */
    const char *problem; /* what is wrong with the stream */
};

/* Has more been taken than there is? */
static bool is_cut_off(const struct bit_reader *in) {
    return in->count < 8 * in->missing;
}

static bool fail_with(struct decompressor *d, const char *problem) {
    d->problem = is_cut_off(&d->in) ? data_cut_off : problem;
    return false;
}

/* Take whole bytes up to 56 bits or more: enough for a length, a distance and their extra bits. */
static inline void refill(struct bit_reader *in) {
    if (in->end - in->next >= 8) {
        in->bits |= load_u64(in->next) << in->count;
        in->next += (63 - in->count) >> 3;
        in->count |= 56;
        return;
    }
    for (; in->count < 56; in->count += 8) {
        if (in->next < in->end) {
            in->bits |= (uint64_t)*in->next++ << in->count;
        } else {
            in->missing++;
        }
    }
}

/* The next `count` bits (16 at most), the first one lowest, of those that were refilled. */
static inline unsigned take_bits(struct bit_reader *in, unsigned count) {
    unsigned value = (unsigned)(in->bits & ((1u << count) - 1));
    in->bits >>= count;
    in->count -= count;
    return value;
}

static unsigned get_bits(struct decompressor *d, unsigned count) {
    refill(&d->in);
    return take_bits(&d->in, count);
}

/* The entry of the long code that the bits begin with; 0 where there is none. */
static unsigned long_entry(const struct decoder *decoder, uint64_t bits) {
    for (unsigned i = 0; i < decoder->count; i++) {
        unsigned length = decoder->lengths[i];
        if (length > FAST_BITS && (bits & ((1u << length) - 1)) == decoder->codes[i]) {
            return i << 4 | length;
        }
    }
    return 0;
}

static inline unsigned next_entry(const struct decoder *decoder, const struct bit_reader *in) {
    unsigned entry = decoder->fast[in->bits & ((1u << FAST_BITS) - 1)];
    return entry != 0 ? entry : long_entry(decoder, in->bits);
}

/* Build a decoder. A code must be complete: every bit string must mean something. Only a code of a
 * single symbol, of one bit, may be incomplete, or a code of none at all. */
static bool build_decoder(struct decoder *decoder, const uint8_t *lengths, size_t count) {
    enum { ALL = 1 << CODE_LIMIT }; /* bit strings of the longest code */
    int left = ALL, used = 0;
    *decoder = (struct decoder){.count = count};
    for (size_t i = 0; i < count; i++) {
        left -= lengths[i] > 0 ? ALL >> lengths[i] : 0;
        used += lengths[i] > 0;
    }
    bool single = used == 1 && left == ALL / 2;
    if (left != 0 && used != 0 && !single) {
        return false;
    }
    memcpy(decoder->lengths, lengths, count);
    assign_codes(lengths, count, decoder->codes);
    for (unsigned i = 0; i < count; i++) {
        unsigned length = lengths[i];
        for (unsigned k = decoder->codes[i]; length > 0 && k < 1 << FAST_BITS; k += 1u << length) {
            decoder->fast[k] = (uint16_t)(length <= FAST_BITS ? i << 4 | length : 0);
        }
    }
    return true;
}

/* Copy a stored block, which begins with the next whole byte. */
static bool copy_stored(struct decompressor *d) {
    struct bit_reader *in = &d->in;
    ptrdiff_t left = in->end - in->next + (ptrdiff_t)(in->count / 8) - (ptrdiff_t)in->missing;
    if (left < 4) {
        return fail_with(d, data_cut_off);
    }
    const uint8_t *from = in->end - left; /* what was taken, but not used, is there again */
    size_t size = from[0] | (size_t)from[1] << 8;
    if ((from[0] ^ from[2]) != 255 || (from[1] ^ from[3]) != 255) {
        return fail_with(d, "compressed data with a wrong stored length");
    }
    size_t room = d->out_limit - d->out_size, count = size < room ? size : room;
    if (count > (size_t)left - 4) {
        return fail_with(d, data_cut_off);
    }
    if (count > 0) {
        memcpy(d->out + d->out_size, from + 4, count);
    }
    d->out_size += count;
    *in = (struct bit_reader){.next = from + 4 + count, .end = in->end};
    return true;
}

/* Read `count` code lengths, coded with runs: RFC 1951, section 3.2.7. */
static bool read_lengths(struct decompressor *d, const struct decoder *order, uint8_t *lengths,
                         size_t count) {
    size_t done = 0;
    while (done < count) {
        refill(&d->in);
        unsigned entry = next_entry(order, &d->in), symbol = entry >> 4;
        if (entry == 0) {
            return fail_with(d, "compressed data with a code that means nothing");
        }
        take_bits(&d->in, entry & 15);
        if (symbol < 16) {
            lengths[done++] = (uint8_t)symbol;
            continue;
        }
        if (symbol == 16 && done == 0) {
            return fail_with(d, "compressed data that repeats a code length before the first");
        }
        uint8_t length = symbol == 16 ? lengths[done - 1] : 0;
        size_t repeat = take_bits(&d->in, symbol == 16 ? 2 : symbol == 17 ? 3 : 7);
        repeat += symbol == 18 ? 11 : 3;
        if (repeat > count - done) {
            return fail_with(d, "compressed data with too many code lengths");
        }
        memset(lengths + done, length, repeat);
        done += repeat;
    }
    return true;
}

static bool read_own_codes(struct decompressor *d) {
    uint8_t lengths[SYMBOL_LIMIT + 32] = {0};
    uint8_t order_lengths[ORDER_COUNT] = {0};
    unsigned literal_count = FIRST_LENGTH + get_bits(d, 5);
    unsigned distance_count = 1 + get_bits(d, 5);
    unsigned order_count = 4 + get_bits(d, 4);
    if (literal_count > LITERAL_COUNT || distance_count > DISTANCE_COUNT) {
        return fail_with(d, "compressed data with too many codes");
    }
    for (unsigned i = 0; i < order_count; i++) {
        order_lengths[length_order[i]] = (uint8_t)get_bits(d, 3);
    }
    d->fixed = false;
    /* The decoder of literals serves for the code lengths first. */
    if (!build_decoder(&d->literals, order_lengths, ORDER_COUNT)) {
        return fail_with(d, "compressed data with a wrong code");
    }
    if (!read_lengths(d, &d->literals, lengths, literal_count + distance_count)) {
        return false;
    }
    if (lengths[END_OF_BLOCK] == 0 || !build_decoder(&d->literals, lengths, literal_count) ||
        !build_decoder(&d->distances, lengths + literal_count, distance_count)) {
        return fail_with(d, "compressed data with a wrong code");
    }
    return true;
}

/* The fixed codes (RFC 1951, section 3.2.6), which have symbols that never appear. Made once for
 * blocks that follow each other: an empty one has only 10 bits. */
static void set_fixed_codes(struct decompressor *d) {
    uint8_t lengths[SYMBOL_LIMIT];
    if (d->fixed) {
        return;
    }
    d->fixed = true;
    for (unsigned i = 0; i < SYMBOL_LIMIT; i++) {
        lengths[i] = i < 144 ? 8 : i < 256 ? 9 : i < 280 ? 7 : 8;
    }
    build_decoder(&d->literals, lengths, SYMBOL_LIMIT);
    memset(lengths, 5, 32);
    build_decoder(&d->distances, lengths, 32);
}

/* The rest of a match whose length symbol is known. Returns what is wrong, or NULL. */
static inline const char *read_match(const struct decoder *distances, unsigned length_symbol,
                                     struct bit_reader *in, size_t *length, size_t *distance) {
    unsigned extra_bits;
    if (length_symbol > 28) {
        return "compressed data with a length that does not exist";
    }
    *length = MATCH_MAX;
    if (length_symbol < 28) {
        *length = MATCH_MIN + (size_t)join_value(length_symbol, 2, &extra_bits);
        *length += take_bits(in, extra_bits);
    }
    unsigned entry = next_entry(distances, in);
    if (entry == 0) {
        return "compressed data with a code that means nothing";
    }
    if (entry >> 4 >= DISTANCE_COUNT) {
        return "compressed data with a distance that does not exist";
    }
    take_bits(in, entry & 15);
    *distance = 1 + (size_t)join_value(entry >> 4, 1, &extra_bits);
    *distance += take_bits(in, extra_bits);
    return NULL;
}

/* Copy `length` bytes from before `out`, behind which there is room for `room` bytes: in blocks, if
 * they may reach past the end. A block must not overlap its source: where that is too near, the
 * bytes repeat, and are the same some repetitions before. */
static inline void copy_match(uint8_t *out, size_t distance, size_t length, size_t room) {
    size_t done = 0, far = distance, single = length;
    if (room - length >= COPY_BLOCK) {
        while (far < COPY_BLOCK) {
            far += distance;
        }
        single = far - distance;
    }
    for (; done < single; done++) {
        out[done] = (out - distance)[done];
    }
    for (; done < length; done += COPY_BLOCK) {
        memcpy(out + done, out + done - far, COPY_BLOCK);
    }
}

/* Is it a literal, and not 0? */
static inline bool is_literal(unsigned entry) {
    return entry - 1 < END_OF_BLOCK * 16 - 1;
}

/* The symbols of a block, up to its end or to all that is wanted. */
static bool read_symbols(struct decompressor *d) {
    struct bit_reader in = d->in; /* a copy, so that it stays in registers */
    uint8_t *out = d->out + d->out_size, *const limit = d->out + d->out_limit;
    const char *problem = NULL;
    while (out < limit) {
        refill(&in);
        unsigned entry = next_entry(&d->literals, &in);
        if (is_literal(entry)) {
            take_bits(&in, entry & 15);
            *out++ = (uint8_t)(entry >> 4);
            continue;
        }
        if (entry == 0) {
            problem = "compressed data with a code that means nothing";
            break;
        }
        take_bits(&in, entry & 15);
        if (entry >> 4 == END_OF_BLOCK) {
            break;
        }
        size_t length, distance;
        problem = read_match(&d->distances, (entry >> 4) - FIRST_LENGTH, &in, &length, &distance);
        if (problem != NULL) {
            break;
        }
        if (distance > (size_t)(out - d->out)) {
            problem = "compressed data that copies from before its start";
            break;
        }
        const size_t room = (size_t)(limit - out);
        length = length < room ? length : room;
        copy_match(out, distance, length, room);
        out += length;
    }
    d->in = in;
    d->out_size = (size_t)(out - d->out);
    return problem == NULL || fail_with(d, problem);
}

static bool read_block(struct decompressor *d, unsigned kind) {
    switch (kind) {
    case 0:
        return copy_stored(d);
    case 1:
        set_fixed_codes(d);
        return read_symbols(d);
    case 2:
        return read_own_codes(d) && read_symbols(d);
    default:
        return fail_with(d, "compressed data with an unknown kind of block");
    }
}

/* The header, and blocks as long as something is wanted. */
static bool read_stream(struct decompressor *d) {
    unsigned method = get_bits(d, 8), flags = get_bits(d, 8), last = 0;
    if ((method & 15) != 8 || method >> 4 > 7 || (method << 8 | flags) % 31 != 0 ||
        (flags & 32) != 0) {
        return fail_with(d, "not a zlib stream");
    }
    while (!last && d->out_size < d->out_limit) {
        last = get_bits(d, 1);
        if (!read_block(d, get_bits(d, 2))) {
            return false;
        }
        if (is_cut_off(&d->in)) {
            return fail_with(d, data_cut_off);
        }
    }
    return d->out_size == d->out_limit || fail_with(d, "compressed data smaller than the picture");
}

bool zlib_decompress(const void *data, size_t size, void *out, size_t out_size,
                     struct error *error) {
    const uint8_t *bytes = data;
    struct decompressor *d = calloc(1, sizeof *d);
    if (d == NULL) {
        return error_out_of_memory(error);
    }
    d->in.next = bytes;
    d->in.end = size > 0 ? bytes + size : bytes; /* without a byte, `data` may be NULL */
    d->out = out;
    d->out_limit = out_size;
    bool done = read_stream(d);
    if (!done) {
        error_set(error, "%s", d->problem);
    }
    free(d);
    return done;
}
