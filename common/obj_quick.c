/* OBJ files in one pass: see obj_quick.h. */
#include "obj_quick.h"

#include <string.h>

/* Exact in double: 10^22 = 2^22 * 5^22, and 5^22 has 52 bits. */
static const double power_of_ten[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                      1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                      1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

enum {
    DIGIT_LIMIT = 18,    /* so many always fit into 64 bits */
    POWER_LIMIT = 22,    /* of ten: see above */
    CORNER_LIMIT = 1000, /* of a face; far fewer than cutting may refuse */
    INDEX_DIGITS = 9
};

/* A place in the file, which ends with a line's end. */
struct cursor {
    const char *next;
};

static bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

static bool is_line_end(char c) {
    return c == '\n' || c == '\r';
}

static void skip_blanks(struct cursor *cursor) {
    while (*cursor->next == ' ' || *cursor->next == '\t') {
        cursor->next++;
    }
}

static bool at_word_end(const struct cursor *cursor) {
    char c = *cursor->next;
    return c == ' ' || c == '\t' || is_line_end(c);
}

/* Nothing may follow on the line but blanks. */
static bool at_end_of_line(struct cursor *cursor) {
    skip_blanks(cursor);
    return is_line_end(*cursor->next);
}

/* Digits of a number, with those before them in `value`; how many there are. */
static int read_digits(struct cursor *cursor, uint64_t *value) {
    const char *start = cursor->next, *p = start;
    uint64_t digits = *value;
    for (; is_digit(*p) && p - start <= DIGIT_LIMIT; p++) {
        digits = 10 * digits + (uint64_t)(*p - '0');
    }
    *value = digits;
    cursor->next = p;
    return (int)(p - start);
}

/* The power of ten of "e-5"; 0 where there is none. False where it is not a small one. */
static bool read_exponent(struct cursor *cursor, int *exponent) {
    *exponent = 0;
    if (*cursor->next != 'e' && *cursor->next != 'E') {
        return true;
    }
    cursor->next++;
    bool negative = *cursor->next == '-';
    cursor->next += negative || *cursor->next == '+';
    uint64_t value = 0;
    int digits = read_digits(cursor, &value);
    *exponent = negative ? -(int)value : (int)value;
    return digits >= 1 && digits <= 3;
}

/* A number whose digits are a whole number below 2^53 and whose power of ten is exact in double:
 * then one multiplication or division, which rounds once, gives the nearest double (Clinger, "How
 * to Read Floating Point Numbers Accurately", 1990). All others are declined. */
static bool read_number(struct cursor *cursor, double *value) {
    skip_blanks(cursor);
    bool negative = *cursor->next == '-';
    cursor->next += negative || *cursor->next == '+';
    uint64_t digits = 0;
    int before = read_digits(cursor, &digits), after = 0, exponent;
    if (*cursor->next == '.') {
        cursor->next++;
        if (before <= DIGIT_LIMIT) {
            after = read_digits(cursor, &digits);
        }
    }
    if (before + after < 1 || before + after > DIGIT_LIMIT || digits > UINT64_C(1) << 53 ||
        !read_exponent(cursor, &exponent) || !at_word_end(cursor)) {
        return false;
    }
    int power = exponent - after;
    if (power < -POWER_LIMIT || power > POWER_LIMIT) {
        return false;
    }
    double magnitude =
        power < 0 ? (double)digits / power_of_ten[-power] : (double)digits * power_of_ten[power];
    *value = negative ? -magnitude : magnitude;
    return magnitude < 1e38; /* a float holds it */
}

static bool read_three(struct cursor *cursor, double value[3]) {
    return read_number(cursor, &value[0]) && read_number(cursor, &value[1]) &&
           read_number(cursor, &value[2]) && at_end_of_line(cursor);
}

/* u, u v or u v w; w is not used. */
static bool read_uv(struct cursor *cursor, double uvw[3]) {
    uvw[1] = 0;
    for (int count = 0; count < 3; count++) {
        if (!read_number(cursor, &uvw[count])) {
            return false;
        }
        if (at_end_of_line(cursor)) {
            return true;
        }
    }
    return false;
}

/* The index from 0 of an element of which there are `count` so far. */
static bool read_index(struct cursor *cursor, size_t count, uint32_t *index) {
    bool negative = *cursor->next == '-';
    cursor->next += negative;
    uint64_t value = 0;
    int digits = read_digits(cursor, &value);
    if (digits < 1 || digits > INDEX_DIGITS || value < 1 || value > count) {
        return false;
    }
    *index = (uint32_t)(negative ? count - value : value - 1);
    return true;
}

/* "v", "v/vt", "v//vn" or "v/vt/vn". */
static bool read_corner(struct cursor *cursor, const struct model *model, struct corner *corner) {
    *corner = (struct corner){0, MODEL_NONE, MODEL_NONE};
    if (!read_index(cursor, model->position_count, &corner->position)) {
        return false;
    }
    if (*cursor->next == '/') {
        cursor->next++;
        if (*cursor->next != '/' && !read_index(cursor, model->uv_count, &corner->uv)) {
            return false;
        }
        if (*cursor->next == '/') {
            cursor->next++;
            if (!read_index(cursor, model->normal_count, &corner->normal)) {
                return false;
            }
        }
    }
    return at_word_end(cursor);
}

static enum obj_quick_result result_of(bool has_memory) {
    return has_memory ? OBJ_QUICK_DONE : OBJ_QUICK_OUT_OF_MEMORY;
}

static enum obj_quick_result read_face(struct cursor *cursor, struct model_reader *reader) {
    reader->polygon_size = 0;
    while (!at_end_of_line(cursor)) {
        struct corner corner;
        if (reader->polygon_size == CORNER_LIMIT || !read_corner(cursor, reader->model, &corner)) {
            return OBJ_QUICK_DECLINED;
        }
        if (!reader_add_corner(reader, corner)) {
            return OBJ_QUICK_OUT_OF_MEMORY;
        }
    }
    if (reader->polygon_size < 3) {
        return OBJ_QUICK_DECLINED;
    }
    return result_of(reader_add_faces(reader));
}

/* How long the keyword is that stands here: v, vt, vn or f, and then a blank; 0 for another. */
static size_t keyword_length(const char *word) {
    if (word[0] != 'v' && word[0] != 'f') {
        return 0;
    }
    size_t length = word[0] == 'v' && (word[1] == 't' || word[1] == 'n') ? 2 : 1;
    return word[length] == ' ' || word[length] == '\t' ? length : 0;
}

/* A line. Those that begin with another keyword are passed over. */
static enum obj_quick_result read_statement(struct cursor *cursor, struct model_reader *reader) {
    const char *word = cursor->next;
    size_t length = keyword_length(word);
    double value[3];
    if (length == 0) { /* "f" alone is wrong, "vp" is rare */
        return word[0] == 'v' || word[0] == 'f' ? OBJ_QUICK_DECLINED : OBJ_QUICK_DONE;
    }
    cursor->next += length;
    if (word[0] == 'f') {
        return read_face(cursor, reader);
    }
    if (length == 2 && word[1] == 't') {
        return read_uv(cursor, value) ? result_of(reader_add_uv(reader, value[0], value[1]))
                                      : OBJ_QUICK_DECLINED;
    }
    if (!read_three(cursor, value)) {
        return OBJ_QUICK_DECLINED;
    }
    return result_of(length == 2 ? reader_add_normal(reader, value)
                                 : reader_add_position(reader, value));
}

/* Is every carriage return the first half of a line's end? */
static bool has_usual_line_ends(const char *data, const char *end) {
    for (const char *p = data; (p = memchr(p, '\r', (size_t)(end - p))) != NULL; p++) {
        if (p + 1 == end || p[1] != '\n') {
            return false;
        }
    }
    return true;
}

/* Plain text without what needs another look at a line: no backslash, which may join lines, no zero
 * byte, no byte-order mark, no vertical blanks; and it ends with a line's end. */
static bool is_usual(const char *data, size_t size) {
    return size > 0 && data[size - 1] == '\n' && data[0] != '\xEF' &&
           memchr(data, '\\', size) == NULL && memchr(data, '\0', size) == NULL &&
           memchr(data, '\v', size) == NULL && memchr(data, '\f', size) == NULL &&
           has_usual_line_ends(data, data + size);
}

enum obj_quick_result obj_quick_read(struct model_reader *reader, const char *data, size_t size) {
    if (!is_usual(data, size)) {
        return OBJ_QUICK_DECLINED;
    }
    const char *end = data + size;
    struct cursor cursor = {data};
    while (cursor.next < end) {
        skip_blanks(&cursor);
        enum obj_quick_result result = read_statement(&cursor, reader);
        if (result != OBJ_QUICK_DONE) {
            return result;
        }
        const char *line_end = memchr(cursor.next, '\n', (size_t)(end - cursor.next));
        cursor.next = line_end + 1; /* there is one: the last byte */
    }
    return OBJ_QUICK_DONE;
}
