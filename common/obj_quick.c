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

/* A function that reads takes a place in the file, which ends with a line's end, and returns the
 * place after what it has read; NULL where that is not as usual. */

static inline bool is_line_end(char c) {
    return c == '\n' || c == '\r';
}

static inline const char *skip_blanks(const char *p) {
    while (*p == ' ' || *p == '\t') {
        p++;
    }
    return p;
}

/* Of all that is not above a blank, the file has only blanks and line's ends. */
static inline bool is_word_end(char c) {
    return (unsigned char)c <= ' ';
}

/* Digits (none is as usual), with those before them in `value`. Up to 18 fit into 64 bits. */
static inline const char *read_digits(const char *p, uint64_t *value) {
    uint64_t sum = *value;
    for (unsigned digit; (digit = (unsigned char)*p - (unsigned)'0') <= 9; p++) {
        sum = 10 * sum + digit;
    }
    *value = sum;
    return p;
}

/* The power of ten of "e-5"; 0 where there is none. Only small ones are usual. */
static inline const char *read_exponent(const char *p, int *exponent) {
    *exponent = 0;
    if (*p != 'e' && *p != 'E') {
        return p;
    }
    p++;
    bool negative = *p == '-';
    p += negative || *p == '+';
    uint64_t value = 0;
    const char *end = read_digits(p, &value);
    if (end == p || end - p > 3) {
        return NULL;
    }
    *exponent = negative ? -(int)value : (int)value;
    return end;
}

/* A number whose digits are a whole number below 2^53 and whose power of ten is exact in double:
 * then one multiplication or division, which rounds once, gives the nearest double (Clinger, "How
 * to Read Floating Point Numbers Accurately", 1990). No other is usual. All are within the range of
 * a float, below 2^53 * 10^22. */
static const char *read_number(const char *p, double *value) {
    p = skip_blanks(p);
    bool negative = *p == '-';
    p += negative | (*p == '+');
    uint64_t digits = 0;
    const char *point = read_digits(p, &digits), *end = point;
    ptrdiff_t count = point - p, decimals = 0;
    if (*point == '.') {
        end = read_digits(point + 1, &digits);
        decimals = end - point - 1;
        count += decimals;
    }
    int exponent;
    if (count < 1 || count > DIGIT_LIMIT || digits > UINT64_C(1) << 53) {
        return NULL;
    }
    end = read_exponent(end, &exponent);
    if (end == NULL || !is_word_end(*end)) {
        return NULL;
    }
    int power = exponent - (int)decimals;
    if (power < -POWER_LIMIT || power > POWER_LIMIT) {
        return NULL;
    }
    double magnitude =
        power < 0 ? (double)digits / power_of_ten[-power] : (double)digits * power_of_ten[power];
    *value = magnitude * (negative ? -1.0 : 1.0); /* no branch: nobody can foretell a sign */
    return end;
}

/* To the end of the line, before which only blanks may stand. */
static inline const char *read_line_end(const char *p) {
    p = skip_blanks(p);
    return is_line_end(*p) ? p : NULL;
}

/* Three numbers and the end of the line. */
static const char *read_three(const char *p, double value[3]) {
    for (int i = 0; i < 3 && p != NULL; i++) {
        p = read_number(p, &value[i]);
    }
    return p != NULL ? read_line_end(p) : NULL;
}

/* u, u v or u v w, and the end of the line; w is not used. */
static const char *read_uv(const char *p, double uvw[3]) {
    uvw[1] = 0;
    for (int count = 0; count < 3; count++) {
        p = read_number(p, &uvw[count]);
        const char *end = p != NULL ? read_line_end(p) : NULL;
        if (p == NULL || end != NULL) {
            return end;
        }
    }
    return NULL;
}

/* The index from 0 of an element of which there are `count` so far. */
static inline const char *read_index(const char *p, size_t count, uint32_t *index) {
    bool negative = *p == '-';
    p += negative;
    uint64_t value = 0;
    const char *end = read_digits(p, &value);
    if (end == p || end - p > INDEX_DIGITS || value < 1 || value > count) {
        return NULL;
    }
    *index = (uint32_t)(negative ? count - value : value - 1);
    return end;
}

/* "v", "v/vt", "v//vn" or "v/vt/vn". */
static inline const char *read_corner(const char *p, const struct model_reader *reader,
                                      struct corner *result) {
    struct corner corner = {0, MODEL_NONE, MODEL_NONE};
    p = read_index(p, reader->model->position_count, &corner.position);
    if (p != NULL && *p == '/') {
        p++;
        if (*p != '/') {
            p = read_index(p, reader->uv_count, &corner.uv);
        }
        if (p != NULL && *p == '/') {
            p = read_index(p + 1, reader->normal_count, &corner.normal);
        }
    }
    *result = reader_wanted(reader, corner);
    return p != NULL && is_word_end(*p) ? p : NULL;
}

/* The corners of a face, and the end of the line. */
static const char *read_corners(const char *p, const struct model_reader *reader,
                                struct corner corners[CORNER_LIMIT], size_t *count) {
    *count = 0;
    for (p = skip_blanks(p); p != NULL && !is_line_end(*p); *count += 1) {
        p = *count < CORNER_LIMIT ? read_corner(p, reader, &corners[*count]) : NULL;
        p = p != NULL ? skip_blanks(p) : NULL;
    }
    return p;
}

static enum obj_quick_result result_of(bool has_memory) {
    return has_memory ? OBJ_QUICK_DONE : OBJ_QUICK_OUT_OF_MEMORY;
}

static enum obj_quick_result add_polygon(struct model_reader *reader, const struct corner *corners,
                                         size_t count) {
    if (count == 3) {
        return result_of(reader_add_triangle(reader, corners));
    }
    bool has_memory = true;
    reader->polygon_size = 0;
    for (size_t i = 0; has_memory && i < count; i++) {
        has_memory = reader_add_corner(reader, corners[i]);
    }
    return result_of(has_memory && reader_add_faces(reader));
}

/* How long the keyword is that stands here: v, vt, vn or f, and then a blank; 0 for another. */
static size_t keyword_length(const char *word) {
    if (word[0] != 'v' && word[0] != 'f') {
        return 0;
    }
    size_t length = word[0] == 'v' && (word[1] == 't' || word[1] == 'n') ? 2 : 1;
    return word[length] == ' ' || word[length] == '\t' ? length : 0;
}

/* Count a texture coordinate or a normal. Is it of no use? */
static inline bool is_passed_over(struct model_reader *reader, bool is_uv) {
    *(is_uv ? &reader->uv_count : &reader->normal_count) += 1;
    return (reader->parts & (is_uv ? MODEL_UVS : MODEL_NORMALS)) == 0;
}

/* What stands on a line after a keyword of so many letters. */
static enum obj_quick_result read_statement(const char **place, size_t length,
                                            struct model_reader *reader) {
    const char *word = *place, *p = word + length;
    struct corner corners[CORNER_LIMIT];
    double value[3];
    size_t count = 3;
    bool is_face = word[0] == 'f', is_uv = word[1] == 't';
    if (length == 2 && is_passed_over(reader, is_uv)) {
        return OBJ_QUICK_DONE;
    }
    p = is_face ? read_corners(p, reader, corners, &count)
        : is_uv ? read_uv(p, value)
                : read_three(p, value);
    if (p == NULL || count < 3) {
        return OBJ_QUICK_DECLINED;
    }
    *place = p;
    if (is_face) {
        return add_polygon(reader, corners, count);
    }
    return result_of(is_uv         ? reader_add_uv(reader, value[0], value[1])
                     : length == 2 ? reader_add_normal(reader, value)
                                   : reader_add_position(reader, value));
}

/* A line up to its end. Those that begin with another keyword are passed over. */
static enum obj_quick_result read_line(const char **place, struct model_reader *reader) {
    *place = skip_blanks(*place);
    size_t length = keyword_length(*place);
    if (length > 0) {
        return read_statement(place, length, reader);
    }
    bool unusual = **place == 'v' || **place == 'f'; /* "f" alone is wrong, "vp" is rare */
    return unusual ? OBJ_QUICK_DECLINED : OBJ_QUICK_DONE;
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

/* Is there a character that needs another look at a line: a backslash, which may join lines, or a
 * control character? Of these a carriage return may be usual. */
static bool has_rare_characters(const char *data, size_t size) {
    unsigned char rare = 0, returns = 0; /* as narrow as what is read: so more at once */
    for (size_t i = 0; i < size; i++) {
        unsigned char c = (unsigned char)data[i];
        unsigned control = (c < ' ') & (c != '\n') & (c != '\r') & (c != '\t');
        rare = (unsigned char)(rare | (c == '\\') | control);
        returns = (unsigned char)(returns | (c == '\r'));
    }
    return rare != 0 || (returns != 0 && !has_usual_line_ends(data, data + size));
}

/* Plain text without a byte-order mark that ends with a line's end. */
static bool is_usual(const char *data, size_t size) {
    return size > 0 && data[size - 1] == '\n' && data[0] != '\xEF' &&
           !has_rare_characters(data, size);
}

enum obj_quick_result obj_quick_read(struct model_reader *reader, const char *data, size_t size) {
    if (!is_usual(data, size)) {
        return OBJ_QUICK_DECLINED;
    }
    const char *end = data + size;
    for (const char *place = data; place < end; place++) {
        enum obj_quick_result result = read_line(&place, reader);
        if (result != OBJ_QUICK_DONE) {
            return result;
        }
        if (*place != '\n') { /* the last byte is one */
            place = memchr(place, '\n', (size_t)(end - place));
        }
    }
    return OBJ_QUICK_DONE;
}
