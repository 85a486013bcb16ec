/* OBJ files in one pass: see obj_quick.h. */
#include "files/obj_quick.h"

#include <stdlib.h>
#include <string.h>

/* Exact in double: 10^22 = 2^22 * 5^22, and 5^22 has 52 bits. */
static const double power_of_ten[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                      1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                      1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

enum {
    DIGIT_LIMIT = 18,    /* so many always fit into 64 bits */
    POWER_LIMIT = 22,    /* of ten: see above */
    CORNER_LIMIT = 1000, /* of a face; far fewer than cutting may refuse */
    INDEX_DIGITS = 9,
    PIECE = 65536, /* bytes that are looked through, then read, while they are in the cache */
    AHEAD = 3      /* bytes that may be read behind the end of a line */
};

/* A function that reads takes a place in the file, which ends with a line's end, and returns the
 * place after what it has read; NULL where that is not as usual.
 *
 * What a processor waits for is where the next word begins. It foretells how many digits a number
 * has, since that is as often before, but not signs: so branches for digits, and none for signs. */

static inline bool is_line_end(char c) {
    return c == '\n' || c == '\r';
}

static inline bool is_blank(char c) {
    return c == ' ' || c == '\t';
}

static inline const char *skip_blanks(const char *p) {
    while (is_blank(*p)) {
        p++;
    }
    return p;
}

/* Of all that is not above a blank, the file has only blanks and line's ends. */
static inline bool is_word_end(char c) {
    return (unsigned char)c <= ' ';
}

/* Four bytes as a number, the first one lowest. Compilers know this form as one instruction. */
static inline uint32_t load_u32(const char *p) {
    const unsigned char *bytes = (const unsigned char *)p;
    return bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 | (uint32_t)bytes[3] << 24;
}

/* Digits (none is as usual), with those before them in `value`. Up to 18 fit into 64 bits. */
static inline const char *read_digits(const char *p, uint64_t *value) {
    uint64_t sum = *value;
    uint32_t four = load_u32(p) ^ 0x30303030; /* a byte up to 9 was a digit */
    if (((four | (four + 0x76767676)) & 0x80808080) == 0) {
        four = 10 * four + (four >> 8); /* two digits in byte 0, two in byte 2 */
        four = (four & 0xff00ff) * (100 << 16 | 1);
        sum = 10000 * sum + (four >> 16);
        p += 4;
    }
    for (unsigned digit; (digit = (unsigned char)*p - (unsigned)'0') <= 9; p++) {
        sum = 10 * sum + digit;
    }
    *value = sum;
    return p;
}

/* "e-5", after which the word must end: adds to the power of ten. Only small ones are usual. */
static const char *read_exponent(const char *p, int *power) {
    if (*p != 'e' && *p != 'E') {
        return NULL;
    }
    p++;
    bool negative = *p == '-';
    p += negative || *p == '+';
    uint64_t value = 0;
    const char *end = read_digits(p, &value);
    if (end == p || end - p > 3 || !is_word_end(*end)) {
        return NULL;
    }
    *power += negative ? -(int)value : (int)value;
    return *power < -POWER_LIMIT || *power > POWER_LIMIT ? NULL : end;
}

/* A number whose digits are a whole number below 2^53 and whose power of ten is exact in double:
 * then one multiplication or division, which rounds once, gives the nearest double (Clinger, "How
 * to Read Floating Point Numbers Accurately", 1990). No other is usual. All are within the range of
 * a float, below 2^53 * 10^22. */
static const char *read_number(const char *p, double *value) {
    static const double sign[] = {1, -1}; /* no branch: nobody can foretell it */
    p = skip_blanks(p);
    bool negative = *p == '-';
    p += negative | (*p == '+');
    uint64_t digits = 0;
    const char *point = read_digits(p, &digits), *end = point;
    ptrdiff_t count = point - p;
    int power = 0;
    if (*point == '.') {
        end = read_digits(point + 1, &digits);
        power = (int)(point + 1 - end);
        count -= power;
    }
    if (count < 1 || count > DIGIT_LIMIT || digits > UINT64_C(1) << 53) {
        return NULL;
    }
    end = is_word_end(*end) ? end : read_exponent(end, &power);
    if (end == NULL) {
        return NULL;
    }
    double whole = sign[negative] * (double)(int64_t)digits;
    *value = power <= 0 ? whole / power_of_ten[-power] : whole * power_of_ten[power];
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
    uint64_t value = 0;
    const char *end;
    if (*p == '-') { /* all of a file or none */
        p++;
        end = read_digits(p, &value);
        *index = (uint32_t)(count - value);
    } else {
        end = read_digits(p, &value);
        *index = (uint32_t)(value - 1);
    }
    return value - 1 < count && end - p <= INDEX_DIGITS ? end : NULL; /* 0 - 1 is huge */
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

static enum obj_quick_result result_of(bool has_memory) {
    return has_memory ? OBJ_QUICK_DONE : OBJ_QUICK_OUT_OF_MEMORY;
}

/* The statements: from behind the keyword to the end of the line, where `*place` then is. */

/* The corners behind the first three of a face, which becomes triangles. */
static enum obj_quick_result read_polygon(const char **place, const struct corner first[3],
                                          struct model_reader *reader) {
    struct corner corner;
    const char *p = *place;
    reader->polygon_size = 0;
    bool has_memory = true;
    for (int i = 0; has_memory && i < 3; i++) {
        has_memory = reader_add_corner(reader, first[i]);
    }
    while (has_memory && !is_line_end(*p)) {
        p = reader->polygon_size < CORNER_LIMIT ? read_corner(p, reader, &corner) : NULL;
        if (p == NULL) {
            return OBJ_QUICK_DECLINED;
        }
        has_memory = reader_add_corner(reader, corner);
        p = skip_blanks(p);
    }
    *place = p;
    return result_of(has_memory && reader_add_faces(reader));
}

/* Three corners are written where the model will have them. */
static enum obj_quick_result read_face(const char **place, struct model_reader *reader) {
    struct face *face = reader_next_face(reader);
    if (face == NULL) {
        return OBJ_QUICK_OUT_OF_MEMORY;
    }
    const char *p = skip_blanks(*place);
    for (int i = 0; i < 3; i++) {
        p = read_corner(p, reader, &face->corner[i]);
        if (p == NULL) {
            return OBJ_QUICK_DECLINED;
        }
        p = skip_blanks(p);
    }
    *place = p;
    if (is_line_end(*p)) {
        reader->model->face_count++;
        return OBJ_QUICK_DONE;
    }
    return read_polygon(place, face->corner, reader);
}

static enum obj_quick_result read_position(const char **place, struct model_reader *reader) {
    double position[3];
    const char *p = read_three(*place, position);
    if (p == NULL) {
        return OBJ_QUICK_DECLINED;
    }
    *place = p;
    return result_of(reader_add_position(reader, position));
}

/* A texture coordinate or a normal: counted, and read if it is of use. */
static enum obj_quick_result read_attribute(const char **place, bool is_uv,
                                            struct model_reader *reader) {
    double value[3];
    *(is_uv ? &reader->uv_count : &reader->normal_count) += 1;
    if ((reader->parts & (is_uv ? MODEL_UVS : MODEL_NORMALS)) == 0) {
        return OBJ_QUICK_DONE;
    }
    const char *p = is_uv ? read_uv(*place, value) : read_three(*place, value);
    if (p == NULL) {
        return OBJ_QUICK_DECLINED;
    }
    *place = p;
    return result_of(is_uv ? reader_add_uv(reader, value[0], value[1])
                           : reader_add_normal(reader, value));
}

/* A line up to its end. Those that begin with another keyword are passed over. */
static enum obj_quick_result read_line(const char **place, struct model_reader *reader) {
    const char *word = skip_blanks(*place);
    *place = word + 1;
    if (word[0] != 'v' && word[0] != 'f') {
        *place = word;
        return OBJ_QUICK_DONE;
    }
    if (is_blank(word[1])) {
        return word[0] == 'v' ? read_position(place, reader) : read_face(place, reader);
    }
    if (word[0] == 'v' && (word[1] == 't' || word[1] == 'n') && is_blank(word[2])) {
        *place = word + 2;
        return read_attribute(place, word[1] == 't', reader);
    }
    return OBJ_QUICK_DECLINED; /* "f" alone is wrong, "vp" is rare */
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

/* Lines, of which the last one ends at `end`. */
static enum obj_quick_result read_lines(const char *place, const char *end,
                                        struct model_reader *reader) {
    for (; place < end; place++) {
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

/* The same for the end of the file, from a copy that has room behind it. */
static enum obj_quick_result read_last_lines(const char *data, size_t size,
                                             struct model_reader *reader) {
    char *copy = calloc(size + AHEAD, 1);
    if (copy == NULL) {
        error_out_of_memory(reader->error);
        return OBJ_QUICK_OUT_OF_MEMORY;
    }
    memcpy(copy, data, size);
    enum obj_quick_result result = read_lines(copy, copy + size, reader);
    free(copy);
    return result;
}

/* The size of a piece of what is left of the file: whole lines, behind which nothing is left or at
 * least AHEAD bytes. */
static size_t piece_size(const char *data, size_t left) {
    if (left <= PIECE) {
        return left;
    }
    const char *line_end = memchr(data + PIECE, '\n', left - PIECE);
    size_t size = (size_t)(line_end + 1 - data);
    return left - size < AHEAD ? left : size;
}

enum obj_quick_result obj_quick_read(struct model_reader *reader, const char *data, size_t size) {
    if (size == 0 || data[size - 1] != '\n' || data[0] == '\xEF') { /* a byte-order mark */
        return OBJ_QUICK_DECLINED;
    }
    enum obj_quick_result result = OBJ_QUICK_DONE;
    for (size_t done = 0, piece; result == OBJ_QUICK_DONE && done < size; done += piece) {
        const char *start = data + done;
        piece = piece_size(start, size - done);
        if (has_rare_characters(start, piece)) {
            return OBJ_QUICK_DECLINED;
        }
        result = done + piece == size ? read_last_lines(start, piece, reader)
                                      : read_lines(start, start + piece, reader);
    }
    return result;
}
