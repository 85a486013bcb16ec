/*
 * Deflate in both directions; see deflate.h. RFC 1951 explains every term that is used here.
 *
 * Compression: (1) find earlier copies of the bytes to come (LZ77) through chains of positions with
 * equal hashes, and wait one byte when the next position has a longer copy; (2) collect literals
 * and matches into blocks; (3) write each block stored, with the fixed codes, or with Huffman codes
 * of its own, whichever is smallest.
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
    ORDER_COUNT = 19,     /* symbols that describe code lengths */
    CODE_LIMIT = 15,      /* bits of the longest code */
    ORDER_CODE_LIMIT = 7, /* of the longest code for code lengths */
    SYMBOL_LIMIT = 288,   /* the fixed code gives a code to two symbols that never appear */
    STORED_LIMIT = 65535  /* bytes of a stored block */
};

/* The order in which a block's header gives the lengths of the codes for code lengths. */
static const uint8_t length_order[ORDER_COUNT] = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                  11, 4,  12, 3, 13, 2, 14, 1, 15};

/* The sum of all bytes, and the sum of all these sums: each byte stands in as many of them as bytes
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
    unsigned symbol;     /* from 0 */
    unsigned extra_bits; /* how many bits follow the symbol */
};

static unsigned highest_bit(unsigned value) { /* 0 for 0; values below 65536 */
    unsigned bit = 0;
    for (unsigned step = 8; step > 0; step /= 2) {
        if (value >> step != 0) {
            bit += step;
            value >>= step;
        }
    }
    return bit;
}

static struct split split_value(unsigned value, unsigned kept) {
    unsigned high = highest_bit(value);
    if (high <= kept) {
        return (struct split){value, 0};
    }
    unsigned extra = high - kept;
    return (struct split){((extra + 1) << kept) + ((value >> extra) & ((1u << kept) - 1)), extra};
}

static struct split split_length(unsigned length) {
    return length == MATCH_MAX ? (struct split){28, 0} : split_value(length - MATCH_MIN, 2);
}

static struct split split_distance(unsigned distance) {
    return split_value(distance - 1, 1);
}

/* The smallest value that has the symbol, and the number of its extra bits. */
static unsigned join_value(unsigned symbol, unsigned kept, unsigned *extra_bits) {
    unsigned group = symbol >> kept;
    if (group <= 1) {
        *extra_bits = 0;
        return symbol;
    }
    *extra_bits = group - 1;
    return ((1u << kept) + (symbol & ((1u << kept) - 1))) << (group - 1);
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
        unsigned code = lengths[i] == 0 ? 0 : next[lengths[i]]++;
        unsigned reversed = 0;
        for (unsigned bit = 0; bit < lengths[i]; bit++) {
            reversed = reversed << 1 | (code >> bit & 1);
        }
        codes[i] = (uint16_t)reversed;
    }
}

/* The fixed code of literals and lengths (RFC 1951, section 3.2.6); all fixed distance codes have 5
 * bits. */
static void fixed_lengths(uint8_t *literal_lengths, uint8_t *distance_lengths) {
    for (unsigned i = 0; i < SYMBOL_LIMIT; i++) {
        literal_lengths[i] = i < 144 ? 8 : i < 256 ? 9 : i < 280 ? 7 : 8;
    }
    memset(distance_lengths, 5, DISTANCE_COUNT);
}

/* ---- Compression ---- */

enum {
    HASH_BITS = 15,
    HASH_BYTES = 4,        /* positions are found by so many bytes */
    MATCH_WORTH = 5,       /* a shorter copy costs as much as literals */
    BLOCK_TOKENS = 1 << 14 /* literals and matches of a block */
};

/* A literal byte (distance 0) or a copy of earlier bytes. */
struct token {
    uint16_t distance;
    uint16_t value; /* the byte, or the length of the copy */
};

struct match {
    unsigned length;
    unsigned distance; /* 0: nothing found */
};

/* Where the search for a match gives up, or is content. */
struct search {
    unsigned chain; /* earlier positions to try */
    unsigned good;  /* with a match of this length in hand, try a quarter of them */
    unsigned lazy;  /* do not look for a longer match one byte on */
    unsigned nice;  /* stop searching */
};

/* Where bits are written. */
struct bit_writer {
    uint8_t *next;
    uint64_t bits;  /* not yet written, the next one lowest */
    unsigned count; /* of them: below 32 */
};

struct compressor {
    const uint8_t *data;
    size_t size;
    struct search search;

    /* One more than the newest position with a hash, modulo 2^32 (a wrong one does no harm: the
     * bytes there are compared); and how far before each position of the window another one has the
     * same hash, 0 where none has. */
    uint32_t newest[1 << HASH_BITS];
    uint16_t back[WINDOW_SIZE];
    size_t hashed; /* positions entered so far */

    struct token tokens[BLOCK_TOKENS]; /* the block that is being collected */
    size_t token_count;
    size_t block_start;
    uint32_t literal_counts[LITERAL_COUNT];
    uint32_t distance_counts[DISTANCE_COUNT];

    struct bytes *out;
    struct bit_writer writer;
};

/* Room for what is written must have been reserved. */
static inline void put_bits(struct bit_writer *writer, unsigned value, unsigned count) {
    writer->bits |= (uint64_t)value << writer->count;
    writer->count += count;
    if (writer->count >= 32) {
        for (unsigned i = 0; i < 4; i++) {
            writer->next[i] = (uint8_t)(writer->bits >> 8 * i & 255);
        }
        writer->next += 4;
        writer->bits >>= 32;
        writer->count -= 32;
    }
}

/* Fill the last byte with zeros, and let no bit wait. */
static void put_waiting_bits(struct bit_writer *writer) {
    for (; writer->count > 0; writer->count -= writer->count < 8 ? writer->count : 8) {
        *writer->next++ = (uint8_t)(writer->bits & 255);
        writer->bits >>= 8;
    }
}

/* A symbol that occurs, and how often. */
struct leaf {
    uint32_t count;
    uint32_t symbol;
};

/* The order of rising counts; equal ones by symbol, so that every qsort() gives the same. */
static int compare_leaves(const void *a, const void *b) {
    const struct leaf *x = a, *y = b;
    if (x->count != y->count) {
        return x->count < y->count ? -1 : 1;
    }
    return x->symbol < y->symbol ? -1 : 1;
}

/* The lengths of the best prefix code with no code longer than `limit` bits, by package-merge
 * (L. L. Larmore, D. S. Hirschberg, "A fast algorithm for optimal length-limited Huffman codes",
 * Journal of the ACM 37, 1990). A list is made `limit` times of the leaves merged with the pairs of
 * the list before; how often a leaf occurs in the first 2n-2 entries of the last list is its
 * length. At least two symbols get a code, since a code of one symbol is not complete. */
static void choose_lengths(const uint32_t *counts, size_t symbol_count, unsigned limit,
                           uint8_t *lengths) {
    struct leaf leaves[LITERAL_COUNT];
    size_t n = 0;
    memset(lengths, 0, symbol_count);
    for (uint32_t i = 0; i < symbol_count; i++) {
        if (counts[i] > 0) {
            leaves[n++] = (struct leaf){counts[i], i};
        }
    }
    for (uint32_t i = 0; n < 2; i++) {
        if (counts[i] == 0) {
            leaves[n++] = (struct leaf){0, i};
        }
    }
    qsort(leaves, n, sizeof *leaves, compare_leaves);

    uint32_t list[2 * LITERAL_COUNT], pairs[LITERAL_COUNT] = {0};
    bool is_leaf[CODE_LIMIT][2 * LITERAL_COUNT];
    size_t pair_count = 0;
    for (unsigned level = 0; level < limit; level++) {
        size_t leaf = 0, pair = 0, size = n + pair_count;
        for (size_t i = 0; i < size; i++) {
            bool take_leaf = leaf < n && (pair == pair_count || leaves[leaf].count <= pairs[pair]);
            is_leaf[level][i] = take_leaf;
            list[i] = take_leaf ? leaves[leaf++].count : pairs[pair++];
        }
        pair_count = size / 2;
        for (size_t i = 0; i < pair_count; i++) {
            pairs[i] = list[2 * i] + list[2 * i + 1];
        }
    }
    size_t taken = 2 * n - 2;
    for (unsigned level = limit; level-- > 0;) {
        size_t leaf = 0;
        for (size_t i = 0; i < taken; i++) {
            if (is_leaf[level][i]) {
                lengths[leaves[leaf++].symbol]++;
            }
        }
        taken = 2 * (taken - leaf);
    }
}

/* The code lengths of a block, themselves coded: runs of equal lengths as symbols 16 (the length
 * before, 3 to 6 times), 17 and 18 (zero, 3 to 10 and 11 to 138 times). */
struct length_list {
    struct {
        uint8_t symbol, extra, extra_bits;
    } entry[LITERAL_COUNT + DISTANCE_COUNT];
    size_t count;
    uint32_t symbol_counts[ORDER_COUNT];
};

static void add_length(struct length_list *list, unsigned symbol, unsigned extra,
                       unsigned extra_bits) {
    list->entry[list->count].symbol = (uint8_t)symbol;
    list->entry[list->count].extra = (uint8_t)extra;
    list->entry[list->count].extra_bits = (uint8_t)extra_bits;
    list->count++;
    list->symbol_counts[symbol]++;
}

static void list_lengths(struct length_list *list, const uint8_t *lengths, size_t count) {
    for (size_t i = 0; i < count;) {
        unsigned length = lengths[i];
        unsigned run = 1;
        while (i + run < count && lengths[i + run] == length) {
            run++;
        }
        i += run;
        if (length != 0) {
            add_length(list, length, 0, 0);
            run--;
        }
        while (run >= 3) {
            unsigned limit = length != 0 ? 6 : 138;
            unsigned part = run < limit ? run : limit;
            if (length != 0) {
                add_length(list, 16, part - 3, 2);
            } else if (part <= 10) {
                add_length(list, 17, part - 3, 3);
            } else {
                add_length(list, 18, part - 11, 7);
            }
            run -= part;
        }
        for (; run > 0; run--) {
            add_length(list, length, 0, 0);
        }
    }
}

/* The codes of a block with codes of its own, and how the header tells them. */
struct block_codes {
    uint8_t literal_lengths[SYMBOL_LIMIT];
    uint8_t distance_lengths[DISTANCE_COUNT];
    size_t literal_count, distance_count; /* up to the last symbol that has a code */
    struct length_list list;
    uint8_t order_lengths[ORDER_COUNT];
    size_t order_count;
};

static size_t used_count(const uint8_t *lengths, size_t count, size_t least) {
    while (count > least && lengths[count - 1] == 0) {
        count--;
    }
    return count;
}

static void make_codes(struct block_codes *codes, const uint32_t *literal_counts,
                       const uint32_t *distance_counts) {
    *codes = (struct block_codes){0};
    choose_lengths(literal_counts, LITERAL_COUNT, CODE_LIMIT, codes->literal_lengths);
    choose_lengths(distance_counts, DISTANCE_COUNT, CODE_LIMIT, codes->distance_lengths);
    codes->literal_count = used_count(codes->literal_lengths, LITERAL_COUNT, FIRST_LENGTH);
    codes->distance_count = used_count(codes->distance_lengths, DISTANCE_COUNT, 1);

    uint8_t lengths[LITERAL_COUNT + DISTANCE_COUNT];
    memcpy(lengths, codes->literal_lengths, codes->literal_count);
    memcpy(lengths + codes->literal_count, codes->distance_lengths, codes->distance_count);
    list_lengths(&codes->list, lengths, codes->literal_count + codes->distance_count);

    choose_lengths(codes->list.symbol_counts, ORDER_COUNT, ORDER_CODE_LIMIT, codes->order_lengths);
    codes->order_count = ORDER_COUNT;
    while (codes->order_count > 4 &&
           codes->order_lengths[length_order[codes->order_count - 1]] == 0) {
        codes->order_count--;
    }
}

/* Bits of a block's header that tell its codes. */
static uint64_t header_cost(const struct block_codes *codes) {
    uint64_t cost = 5 + 5 + 4 + 3 * codes->order_count;
    for (size_t i = 0; i < codes->list.count; i++) {
        cost += codes->order_lengths[codes->list.entry[i].symbol];
        cost += codes->list.entry[i].extra_bits;
    }
    return cost;
}

/* Bits of a block's tokens with these code lengths. */
static uint64_t token_cost(const struct compressor *c, const uint8_t *literal_lengths,
                           const uint8_t *distance_lengths) {
    uint64_t cost = 0;
    unsigned extra_bits;
    for (unsigned i = 0; i < LITERAL_COUNT; i++) {
        extra_bits = 0;
        if (i >= FIRST_LENGTH && i < LITERAL_COUNT - 1) {
            join_value(i - FIRST_LENGTH, 2, &extra_bits);
        }
        cost += (uint64_t)c->literal_counts[i] * (literal_lengths[i] + extra_bits);
    }
    for (unsigned i = 0; i < DISTANCE_COUNT; i++) {
        join_value(i, 1, &extra_bits);
        cost += (uint64_t)c->distance_counts[i] * (distance_lengths[i] + extra_bits);
    }
    return cost;
}

static void write_header(struct bit_writer *writer, const struct block_codes *codes) {
    uint16_t order_codes[ORDER_COUNT];
    assign_codes(codes->order_lengths, ORDER_COUNT, order_codes);
    put_bits(writer, (unsigned)codes->literal_count - FIRST_LENGTH, 5);
    put_bits(writer, (unsigned)codes->distance_count - 1, 5);
    put_bits(writer, (unsigned)codes->order_count - 4, 4);
    for (size_t i = 0; i < codes->order_count; i++) {
        put_bits(writer, codes->order_lengths[length_order[i]], 3);
    }
    for (size_t i = 0; i < codes->list.count; i++) {
        unsigned symbol = codes->list.entry[i].symbol;
        put_bits(writer, order_codes[symbol], codes->order_lengths[symbol]);
        put_bits(writer, codes->list.entry[i].extra, codes->list.entry[i].extra_bits);
    }
}

static void write_tokens(struct compressor *c, const uint8_t *literal_lengths,
                         const uint8_t *distance_lengths) {
    struct bit_writer writer = c->writer; /* of its own, so that it stays in registers */
    uint16_t literal_codes[SYMBOL_LIMIT], distance_codes[DISTANCE_COUNT];
    assign_codes(literal_lengths, SYMBOL_LIMIT, literal_codes);
    assign_codes(distance_lengths, DISTANCE_COUNT, distance_codes);
    for (size_t i = 0; i < c->token_count; i++) {
        struct token token = c->tokens[i];
        if (token.distance == 0) {
            put_bits(&writer, literal_codes[token.value], literal_lengths[token.value]);
            continue;
        }
        struct split length = split_length(token.value);
        unsigned symbol = FIRST_LENGTH + length.symbol;
        put_bits(&writer, literal_codes[symbol], literal_lengths[symbol]);
        put_bits(&writer, (token.value - MATCH_MIN) & ((1u << length.extra_bits) - 1),
                 length.extra_bits);
        struct split distance = split_distance(token.distance);
        put_bits(&writer, distance_codes[distance.symbol], distance_lengths[distance.symbol]);
        put_bits(&writer, (token.distance - 1u) & ((1u << distance.extra_bits) - 1),
                 distance.extra_bits);
    }
    put_bits(&writer, literal_codes[END_OF_BLOCK], literal_lengths[END_OF_BLOCK]);
    c->writer = writer;
}

static void write_stored(struct bit_writer *writer, const uint8_t *data, size_t size, bool last) {
    do {
        unsigned part = size < STORED_LIMIT ? (unsigned)size : STORED_LIMIT;
        size -= part;
        put_bits(writer, last && size == 0, 1);
        put_bits(writer, 0, 2);
        put_waiting_bits(writer);
        put_bits(writer, part, 16);
        put_bits(writer, part ^ 0xffff, 16);
        memcpy(writer->next, data, part);
        writer->next += part;
        data += part;
    } while (size > 0);
}

/* Write the collected tokens, which stand for the data up to `end`, in the smallest of the three
 * kinds of block. False when memory runs out. */
static bool write_block(struct compressor *c, size_t end, bool last) {
    struct block_codes codes;
    uint8_t literal_lengths[SYMBOL_LIMIT], distance_lengths[DISTANCE_COUNT];
    c->literal_counts[END_OF_BLOCK] = 1;
    make_codes(&codes, c->literal_counts, c->distance_counts);
    fixed_lengths(literal_lengths, distance_lengths);
    size_t size = end - c->block_start;
    uint64_t stored_cost = (uint64_t)size * 8 + (size / STORED_LIMIT + 1) * (7 + 32);
    uint64_t fixed_cost = token_cost(c, literal_lengths, distance_lengths);
    uint64_t own_cost =
        header_cost(&codes) + token_cost(c, codes.literal_lengths, codes.distance_lengths);

    uint64_t cost = own_cost < fixed_cost ? own_cost : fixed_cost;
    cost = stored_cost < cost ? stored_cost : cost;
    if (cost / 8 > SIZE_MAX / 2 || !bytes_reserve(c->out, (size_t)(cost / 8) + 16)) {
        return false;
    }
    struct bit_writer *writer = &c->writer;
    writer->next = c->out->data + c->out->size; /* the block may have moved */
    if (cost == stored_cost) {
        write_stored(writer, c->data + c->block_start, size, last);
    } else if (cost == fixed_cost) {
        put_bits(writer, last, 1);
        put_bits(writer, 1, 2);
        write_tokens(c, literal_lengths, distance_lengths);
    } else {
        put_bits(writer, last, 1);
        put_bits(writer, 2, 2);
        write_header(writer, &codes);
        write_tokens(c, codes.literal_lengths, codes.distance_lengths);
    }
    if (last) {
        put_waiting_bits(writer);
    }
    c->out->size = (size_t)(writer->next - c->out->data);
    c->block_start = end;
    c->token_count = 0;
    memset(c->literal_counts, 0, sizeof c->literal_counts);
    memset(c->distance_counts, 0, sizeof c->distance_counts);
    return true;
}

/* The four bytes as a number, the same on every machine, so that every machine finds the same. */
static uint32_t hash_at(const uint8_t *bytes) {
    uint32_t word =
        bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 | (uint32_t)bytes[3] << 24;
    return (uint32_t)(word * 2654435761u) >> (32 - HASH_BITS);
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

/* Enter the positions of a match, of a long one only those at its ends. Within a run of one colour
 * all others are alike: they would take long to search, and hide what lies further back. */
static void enter_match(struct compressor *c, size_t at, size_t length) {
    enum { END = 8 };
    if (length > 2 * END) {
        enter_positions(c, at + END);
        c->hashed = at + length - END;
    }
    enter_positions(c, at + length);
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

/* Enter position `at` and find the longest earlier copy of what stands there, if it is longer than
 * `length` bytes (at least HASH_BYTES - 1), among the `chain` newest positions of its hash. */
static struct match find_match(struct compressor *c, size_t at, unsigned length, unsigned chain) {
    struct match best = {length, 0};
    size_t left = c->size - at;
    unsigned limit = left < MATCH_MAX ? (unsigned)left : MATCH_MAX;
    if (limit < HASH_BYTES || limit <= length) {
        return best;
    }
    enter_positions(c, at + 1);
    const uint8_t *here = c->data + at;
    size_t distance = 0;
    for (; chain > 0; chain--) {
        unsigned back = c->back[(at - distance) % WINDOW_SIZE];
        distance += back;
        if (back == 0 || distance > WINDOW_SIZE) {
            break;
        }
        const uint8_t *there = here - distance;
        const unsigned tail = best.length + 1 - HASH_BYTES; /* a longer match has these bytes too */
        if (memcmp(there + tail, here + tail, HASH_BYTES) == 0) {
            unsigned equal = count_equal(there, here, limit);
            if (equal > best.length) {
                best = (struct match){equal, (unsigned)distance};
                if (equal >= c->search.nice || equal == limit) {
                    break;
                }
            }
        }
    }
    return best;
}

/* Add a token that ends before `end`; false when memory runs out. */
static bool add_token(struct compressor *c, struct token token, size_t end) {
    c->tokens[c->token_count++] = token;
    if (token.distance == 0) {
        c->literal_counts[token.value]++;
    } else {
        c->literal_counts[FIRST_LENGTH + split_length(token.value).symbol]++;
        c->distance_counts[split_distance(token.distance).symbol]++;
    }
    return c->token_count < BLOCK_TOKENS || write_block(c, end, false);
}

/* Turn the data into tokens and blocks; false when memory runs out. */
static bool compress_data(struct compressor *c) {
    for (size_t at = 0; at < c->size;) {
        struct match match = find_match(c, at, MATCH_WORTH - 1, c->search.chain);
        while (match.distance > 0 && match.length < c->search.lazy) {
            unsigned chain = c->search.chain / (match.length >= c->search.good ? 4 : 1);
            struct match next = find_match(c, at + 1, match.length, chain);
            if (next.distance == 0) {
                break;
            }
            if (!add_token(c, (struct token){0, c->data[at]}, at + 1)) {
                return false;
            }
            at++;
            match = next;
        }
        struct token token = {0, c->data[at]};
        if (match.distance > 0) {
            token = (struct token){(uint16_t)match.distance, (uint16_t)match.length};
            enter_match(c, at, match.length);
        }
        at += match.distance > 0 ? match.length : 1;
        if (!add_token(c, token, at)) {
            return false;
        }
    }
    return write_block(c, c->size, true);
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
    c->search = (struct search){.chain = 32, .good = 4, .lazy = 32, .nice = 128};
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

enum { FAST_BITS = 12 }; /* codes up to this length are found in a table */

/* A prefix code. `fast` gives for the next FAST_BITS bits symbol * 16 + length of a code that they
 * begin with, or 0. Longer codes are found by counting (RFC 1951, section 3.2.2). */
struct decoder {
    uint16_t fast[1 << FAST_BITS];
    uint16_t with_length[CODE_LIMIT + 1]; /* number of codes of each length */
    uint16_t symbols[SYMBOL_LIMIT];       /* by rising code */
};

struct decompressor {
    const uint8_t *next, *end; /* bytes that are not yet taken */
    uint64_t bits;             /* taken, not yet used; the next one lowest */
    unsigned bit_count;
    uint8_t *out;
    size_t out_size, out_limit;
    struct decoder literals, distances;
    bool fixed;          /* they are those of the fixed codes */
    const char *problem; /* what is wrong with the stream */
};

static bool fail_with(struct decompressor *d, const char *problem) {
    d->problem = problem;
    return false;
}

/* Take bytes until there are at least 48 bits, or the stream ends. */
static void refill(struct decompressor *d) {
    while (d->bit_count <= 56 && d->next < d->end) {
        d->bits |= (uint64_t)*d->next++ << d->bit_count;
        d->bit_count += 8;
    }
}

/* The next `count` bits (16 at most), the first one lowest. */
static bool get_bits(struct decompressor *d, unsigned count, unsigned *value) {
    if (d->bit_count < count) {
        refill(d);
        if (d->bit_count < count) {
            return fail_with(d, "compressed data cut off");
        }
    }
    *value = (unsigned)(d->bits & ((1u << count) - 1));
    d->bits >>= count;
    d->bit_count -= count;
    return true;
}

/* Build a decoder. A code must be complete: every bit string must mean something. Only a code of a
 * single symbol, of one bit, may be incomplete, or a code of none at all. */
static bool build_decoder(struct decoder *decoder, const uint8_t *lengths, size_t count) {
    uint16_t codes[SYMBOL_LIMIT];
    uint16_t position[CODE_LIMIT + 2] = {0};
    *decoder = (struct decoder){0};
    for (size_t i = 0; i < count; i++) {
        decoder->with_length[lengths[i]]++;
    }
    size_t used = count - decoder->with_length[0];
    decoder->with_length[0] = 0;
    int free_codes = 1;
    for (unsigned bits = 1; bits <= CODE_LIMIT; bits++) {
        free_codes = 2 * free_codes - decoder->with_length[bits];
        if (free_codes < 0) {
            return false;
        }
        position[bits + 1] = (uint16_t)(position[bits] + decoder->with_length[bits]);
    }
    bool single = used == 1 && decoder->with_length[1] == 1;
    if (free_codes > 0 && used > 0 && !single) {
        return false;
    }
    assign_codes(lengths, count, codes);
    for (unsigned i = 0; i < count; i++) {
        unsigned length = lengths[i];
        if (length == 0) {
            continue;
        }
        decoder->symbols[position[length]++] = (uint16_t)i;
        for (unsigned k = codes[i]; length <= FAST_BITS && k < 1 << FAST_BITS; k += 1u << length) {
            decoder->fast[k] = (uint16_t)(i << 4 | length);
        }
    }
    return true;
}

/* A symbol whose code is longer than FAST_BITS, or cut off, or does not exist. */
static bool get_long_symbol(struct decompressor *d, const struct decoder *decoder,
                            unsigned *symbol) {
    unsigned code = 0, first = 0, index = 0; /* first code of a length, and its place in symbols */
    for (unsigned length = 1; length <= CODE_LIMIT; length++) {
        unsigned bit;
        if (!get_bits(d, 1, &bit)) {
            return false;
        }
        code |= bit;
        unsigned count = decoder->with_length[length];
        if (code - first < count) {
            *symbol = decoder->symbols[index + (code - first)];
            return true;
        }
        index += count;
        first = (first + count) << 1;
        code <<= 1;
    }
    return fail_with(d, "compressed data with a code that means nothing");
}

static inline bool get_symbol(struct decompressor *d, const struct decoder *decoder,
                              unsigned *symbol) {
    if (d->bit_count < CODE_LIMIT) {
        refill(d);
    }
    unsigned entry = decoder->fast[d->bits & ((1u << FAST_BITS) - 1)];
    unsigned length = entry & 15;
    if (length == 0 || length > d->bit_count) {
        return get_long_symbol(d, decoder, symbol);
    }
    d->bits >>= length;
    d->bit_count -= length;
    *symbol = entry >> 4;
    return true;
}

static bool copy_stored(struct decompressor *d) {
    unsigned size, complement, skipped;
    if (!get_bits(d, d->bit_count % 8, &skipped) || !get_bits(d, 16, &size) ||
        !get_bits(d, 16, &complement)) {
        return false;
    }
    if ((size ^ complement) != 0xffff) {
        return fail_with(d, "compressed data with a wrong stored length");
    }
    if (size > d->out_limit - d->out_size) {
        return fail_with(d, "compressed data larger than the picture");
    }
    /* Whole bytes that were taken already come first. */
    for (; size > 0 && d->bit_count > 0; size--) {
        d->out[d->out_size++] = (uint8_t)(d->bits & 255);
        d->bits >>= 8;
        d->bit_count -= 8;
    }
    if (size > (size_t)(d->end - d->next)) {
        return fail_with(d, "compressed data cut off");
    }
    if (size > 0) {
        memcpy(d->out + d->out_size, d->next, size);
    }
    d->out_size += size;
    d->next += size;
    return true;
}

/* Read `count` code lengths, coded as length_list describes. */
static bool read_lengths(struct decompressor *d, const struct decoder *order, uint8_t *lengths,
                         size_t count) {
    size_t done = 0;
    while (done < count) {
        unsigned symbol, repeat;
        if (!get_symbol(d, order, &symbol)) {
            return false;
        }
        if (symbol < 16) {
            lengths[done++] = (uint8_t)symbol;
            continue;
        }
        if (symbol == 16 && done == 0) {
            return fail_with(d, "compressed data that repeats a code length before the first");
        }
        uint8_t length = symbol == 16 ? lengths[done - 1] : 0;
        unsigned bits = symbol == 16 ? 2 : symbol == 17 ? 3 : 7;
        if (!get_bits(d, bits, &repeat)) {
            return false;
        }
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
    unsigned literal_count, distance_count, order_count;
    uint8_t lengths[SYMBOL_LIMIT + 32] = {0};
    uint8_t order_lengths[ORDER_COUNT] = {0};
    if (!get_bits(d, 5, &literal_count) || !get_bits(d, 5, &distance_count) ||
        !get_bits(d, 4, &order_count)) {
        return false;
    }
    literal_count += FIRST_LENGTH;
    distance_count += 1;
    order_count += 4;
    if (literal_count > LITERAL_COUNT || distance_count > DISTANCE_COUNT) {
        return fail_with(d, "compressed data with too many codes");
    }
    for (unsigned i = 0; i < order_count; i++) {
        unsigned length;
        if (!get_bits(d, 3, &length)) {
            return false;
        }
        order_lengths[length_order[i]] = (uint8_t)length;
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

/* Made once for blocks that follow each other: an empty one has only 10 bits. */
static void set_fixed_codes(struct decompressor *d) {
    if (d->fixed) {
        return;
    }
    d->fixed = true;
    uint8_t literal_lengths[SYMBOL_LIMIT];
    uint8_t distance_lengths[32]; /* two of them never appear, but make the code complete */
    fixed_lengths(literal_lengths, distance_lengths);
    memset(distance_lengths, 5, sizeof distance_lengths);
    build_decoder(&d->literals, literal_lengths, SYMBOL_LIMIT);
    build_decoder(&d->distances, distance_lengths, sizeof distance_lengths);
}

/* Read the rest of a match whose length symbol is known, and copy. */
static bool copy_match(struct decompressor *d, unsigned length_symbol) {
    unsigned extra_bits, extra, distance_symbol;
    if (length_symbol > 28) {
        return fail_with(d, "compressed data with a length that does not exist");
    }
    unsigned length = MATCH_MAX;
    if (length_symbol < 28) {
        length = MATCH_MIN + join_value(length_symbol, 2, &extra_bits);
        if (!get_bits(d, extra_bits, &extra)) {
            return false;
        }
        length += extra;
    }
    if (!get_symbol(d, &d->distances, &distance_symbol)) {
        return false;
    }
    if (distance_symbol >= DISTANCE_COUNT) {
        return fail_with(d, "compressed data with a distance that does not exist");
    }
    size_t distance = 1 + (size_t)join_value(distance_symbol, 1, &extra_bits);
    if (!get_bits(d, extra_bits, &extra)) {
        return false;
    }
    distance += extra;
    if (distance > d->out_size) {
        return fail_with(d, "compressed data that copies from before its start");
    }
    if (length > d->out_limit - d->out_size) {
        return fail_with(d, "compressed data larger than the picture");
    }
    uint8_t *to = d->out + d->out_size;
    const uint8_t *from = to - distance;
    for (unsigned i = 0; i < length; i++) { /* the two may overlap: byte by byte */
        to[i] = from[i];
    }
    d->out_size += length;
    return true;
}

/* Eight bytes as a number, the first one lowest. */
static inline uint64_t load_u64(const uint8_t *bytes) {
    uint64_t value = 0;
    for (int i = 7; i >= 0; i--) {
        value = value << 8 | bytes[i];
    }
    return value;
}

/* What is taken from the stream, in the loop below kept apart from the rest. Above the `count` bits
 * there may be some of the byte that comes next. */
struct bit_buffer {
    uint64_t bits;
    unsigned count;
};

static inline unsigned take_bits(struct bit_buffer *buffer, unsigned count) {
    unsigned value = (unsigned)(buffer->bits & ((1u << count) - 1));
    buffer->bits >>= count;
    buffer->count -= count;
    return value;
}

/* What the table has for the code that comes next; 0 where it is long or wrong. */
static inline unsigned next_entry(const struct decoder *decoder, const struct bit_buffer *buffer) {
    return decoder->fast[buffer->bits & ((1u << FAST_BITS) - 1)];
}

static inline bool is_literal(unsigned entry) {
    return (entry & 15) != 0 && entry >> 4 < END_OF_BLOCK;
}

static inline uint8_t take_literal(struct bit_buffer *buffer, unsigned entry) {
    take_bits(buffer, entry & 15);
    return (uint8_t)(entry >> 4);
}

enum { COPY_BLOCK = 16, INNER_INPUT = 8, INNER_OUTPUT = 1 + MATCH_MAX + COPY_BLOCK };

/* Copy a match in blocks that may reach past its end. A block must not overlap its source: where
 * that is too near, the bytes repeat, and are the same some repetitions before. */
static inline void copy_blocks(uint8_t *to, size_t distance, size_t length) {
    size_t done = 0, far = distance;
    if (distance < COPY_BLOCK) {
        far = distance * ((COPY_BLOCK - 1) / distance + 1);
        for (; done < far - distance; done++) {
            to[done] = (to - distance)[done];
        }
    }
    for (; done < length; done += COPY_BLOCK) {
        memcpy(to + done, to + done - far, COPY_BLOCK);
    }
}

/* A match whose length symbol is known: its length, and its distance or 0 where it takes the
 * careful loop to say what is there (no length, for one). At most 5 + FAST_BITS + 13 bits. */
static inline size_t inner_match(const struct decompressor *d, unsigned length_symbol,
                                 struct bit_buffer *buffer, size_t *distance) {
    unsigned extra_bits;
    size_t length = MATCH_MAX;
    *distance = 0;
    if (length_symbol < 28) {
        length = MATCH_MIN + (size_t)join_value(length_symbol, 2, &extra_bits);
        length += take_bits(buffer, extra_bits);
    }
    unsigned entry = next_entry(&d->distances, buffer);
    if (length_symbol <= 28 && (entry & 15) != 0 && entry >> 4 < DISTANCE_COUNT) {
        take_bits(buffer, entry & 15);
        *distance = 1 + (size_t)join_value(entry >> 4, 1, &extra_bits);
        *distance += take_bits(buffer, extra_bits);
    }
    return length;
}

/* Symbols of a block as long as input and output have room for any symbol, so that nothing need be
 * checked. Stops before a symbol that is rare or wrong: the careful loop below knows what to do. */
static void read_inner_symbols(struct decompressor *d) {
    struct bit_buffer buffer = {d->bits, d->bit_count};
    const uint8_t *next = d->next;
    uint8_t *out = d->out + d->out_size, *const limit = d->out + d->out_limit;
    while (d->end - next >= INNER_INPUT && limit - out >= INNER_OUTPUT) {
        buffer.bits |= load_u64(next) << buffer.count; /* whole bytes up to 56 bits or more */
        next += (63 - buffer.count) >> 3;
        buffer.count |= 56;
        unsigned entry = next_entry(&d->literals, &buffer);
        if (is_literal(entry)) { /* then there are bits for another one, or for a match */
            *out++ = take_literal(&buffer, entry);
            entry = next_entry(&d->literals, &buffer);
            if (is_literal(entry)) {
                *out++ = take_literal(&buffer, entry);
                continue;
            }
        }
        struct bit_buffer after = buffer;
        size_t distance;
        take_bits(&after, entry & 15);
        size_t length = inner_match(d, (entry >> 4) - FIRST_LENGTH, &after, &distance);
        if (distance == 0 || distance > (size_t)(out - d->out)) {
            break;
        }
        copy_blocks(out, distance, length);
        out += length;
        buffer = after;
    }
    d->bits = buffer.bits & ((UINT64_C(1) << buffer.count) - 1);
    d->bit_count = buffer.count;
    d->next = next;
    d->out_size = (size_t)(out - d->out);
}

/* The symbols of a block, up to its end. */
static bool read_symbols(struct decompressor *d) {
    for (;;) {
        unsigned symbol;
        read_inner_symbols(d);
        if (!get_symbol(d, &d->literals, &symbol)) {
            return false;
        }
        if (symbol < END_OF_BLOCK) {
            if (d->out_size == d->out_limit) {
                return fail_with(d, "compressed data larger than the picture");
            }
            d->out[d->out_size++] = (uint8_t)symbol;
        } else if (symbol == END_OF_BLOCK) {
            return true;
        } else if (!copy_match(d, symbol - FIRST_LENGTH)) {
            return false;
        }
    }
}

static bool read_blocks(struct decompressor *d) {
    unsigned last = 0, kind;
    while (!last) {
        if (!get_bits(d, 1, &last) || !get_bits(d, 2, &kind)) {
            return false;
        }
        if (kind == 0) {
            if (!copy_stored(d)) {
                return false;
            }
            continue;
        }
        if (kind == 3) {
            return fail_with(d, "compressed data with an unknown kind of block");
        }
        if (kind == 1) {
            set_fixed_codes(d);
        } else if (!read_own_codes(d)) {
            return false;
        }
        if (!read_symbols(d)) {
            return false;
        }
    }
    return true;
}

/* The header, the blocks and the checksum. */
static bool read_stream(struct decompressor *d) {
    unsigned method, flags, skipped;
    if (!get_bits(d, 8, &method) || !get_bits(d, 8, &flags)) {
        return false;
    }
    if ((method & 15) != 8 || method >> 4 > 7 || (method << 8 | flags) % 31 != 0 ||
        (flags & 32) != 0) {
        return fail_with(d, "not a zlib stream");
    }
    if (!read_blocks(d)) {
        return false;
    }
    if (d->out_size < d->out_limit) {
        return fail_with(d, "compressed data smaller than the picture");
    }
    uint32_t check = 0;
    get_bits(d, d->bit_count % 8, &skipped);
    for (unsigned i = 0; i < 4; i++) {
        unsigned byte;
        if (!get_bits(d, 8, &byte)) {
            return false;
        }
        check = check << 8 | byte;
    }
    return check == adler32(d->out, d->out_size) ||
           fail_with(d, "compressed data with a wrong checksum");
}

bool zlib_decompress(const void *data, size_t size, void *out, size_t out_size,
                     struct error *error) {
    const uint8_t *bytes = data;
    struct decompressor *d = calloc(1, sizeof *d);
    if (d == NULL) {
        return error_out_of_memory(error);
    }
    d->next = bytes;
    d->end = size > 0 ? bytes + size : bytes; /* without a byte, `data` may be NULL */
    d->out = out;
    d->out_limit = out_size;
    bool done = read_stream(d);
    if (!done) {
        error_set(error, "%s", d->problem);
    }
    free(d);
    return done;
}
