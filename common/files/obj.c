/*
 * OBJ files; see obj.h.
 *
 * The file is read once, line by line. Only when a face names what comes further down, the rest of
 * the file is read ahead for everything but faces, and from that face on for faces alone.
 */
#include "files/obj.h"

#include "files/model_reader.h"

#include <string.h>

/* Positions, texture coordinates, normals: what a corner "v/vt/vn" names, in this order. */
enum attribute { POSITION, UV, NORMAL, ATTRIBUTES };

struct obj {
    struct model_reader reader;
    unsigned parts;              /* of enum model_part: what is wanted */
    uint32_t unused[ATTRIBUTES]; /* MODEL_NONE where an attribute is not wanted, otherwise 0 */
    size_t so_far[ATTRIBUTES]; /* above the current line: what a negative index counts back from */
    size_t total[ATTRIBUTES];  /* as far as the file is read */
    bool reading_ahead;        /* all but attributes is passed over */
    bool is_read_ahead;        /* all but faces is read */
};

/* ---- Positions, texture coordinates and normals ---- */

/* A line of an attribute: counted, and read if it is of use and not read yet. It is x y z, x y z w
 * or x y z r g b; u, u v or u v w; x y z. What else follows counts for nothing. */
static bool read_attribute(struct obj *obj, enum attribute attribute) {
    static const char *const keywords[] = {"v", "vt", "vn"};
    struct model_reader *reader = &obj->reader;
    const size_t least = attribute == UV ? 1 : 3;
    struct reader_numbers numbers;
    double *value = numbers.value;
    obj->so_far[attribute]++;
    obj->total[attribute] += !obj->is_read_ahead;
    if (obj->is_read_ahead || obj->unused[attribute] != 0) {
        return true;
    }
    if (!reader_read_numbers(reader, &numbers)) {
        return false;
    }
    if (numbers.count < least) {
        return text_error(reader->error, reader->line, "'%s' takes %zu or more numbers, not %zu",
                          keywords[attribute], least, numbers.count);
    }
    if (attribute == UV) {
        return reader_add_uv(reader, value[0], numbers.count > 1 ? value[1] : 0);
    }
    if (attribute == NORMAL) {
        return reader_add_normal(reader, value);
    }
    if (numbers.count == 4) {
        reader_divide_by_w(value);
    }
    return reader_add_position(reader, value) &&
           (numbers.count < 6 || reader_color_position(reader, value + 3));
}

/* ---- Faces ---- */

static bool read_lines(struct obj *obj);

/* Read what comes further down, except faces, and come back. */
static bool read_ahead(struct obj *obj) {
    struct obj here = *obj;
    obj->reading_ahead = true;
    if (!read_lines(obj)) {
        return false;
    }
    obj->reading_ahead = false;
    obj->is_read_ahead = true;
    obj->reader.text = here.reader.text;
    obj->reader.line = here.reader.line;
    memcpy(obj->so_far, here.so_far, sizeof obj->so_far);
    return true;
}

static bool error_malformed(struct model_reader *reader) {
    struct word word = text_next_word(&reader->text);
    return text_error(reader->error, reader->line,
                      "face corner '%s' is none of v, v/vt, v//vn, v/vt/vn", word_show(word).text);
}

/* The index that a field up to a slash or the end of its word names, from 0. A position must exist;
 * a texture coordinate or normal that does not is none, as where the field is empty or 0. */
static bool resolve(struct obj *obj, enum attribute attribute, struct word field,
                    uint32_t *resolved) {
    struct model_reader *reader = &obj->reader;
    const size_t so_far = obj->so_far[attribute], *total = &obj->total[attribute];
    int64_t index;
    *resolved = MODEL_NONE;
    if (field.length == 0 && attribute != POSITION) {
        return true;
    }
    if (!word_to_integer(field, &index)) {
        return error_malformed(reader);
    }
    if (obj->unused[attribute] != 0 || (index == 0 && attribute != POSITION)) {
        return true;
    }
    if (index > 0 && (uint64_t)index > *total && !obj->is_read_ahead && !read_ahead(obj)) {
        return false;
    }
    if (index > 0 ? (uint64_t)index <= *total : index < 0 && index >= -(int64_t)so_far) {
        *resolved = (uint32_t)(index > 0 ? index - 1 : (int64_t)so_far + index);
        return true;
    }
    if (attribute != POSITION) {
        model_warn(reader->model, attribute == UV ? MODEL_UVS_MISSING : MODEL_NORMALS_MISSING,
                   reader->line, NULL);
        return true;
    }
    if (index == 0) {
        return text_error(reader->error, reader->line, "face names vertex 0: the first is 1");
    }
    return text_error(reader->error, reader->line, "face names vertex %s of %zu",
                      word_show(field).text, index > 0 ? *total : so_far);
}

/* Over a field of a corner, and what it names; NULL, with a message, where it is wrong. Nearly all
 * count from the beginning and name what is known already. */
static inline const char *read_field(struct obj *obj, enum attribute attribute, const char *p,
                                     uint32_t *resolved) {
    enum { DIGIT_LIMIT = 18 }; /* so many always fit */
    struct text *text = &obj->reader.text;
    uint64_t value = 0;
    const char *end = text_read_digits(p, text->end, &value);
    if (value - 1 < obj->total[attribute] && end - p <= DIGIT_LIMIT) { /* 0 - 1 is huge */
        *resolved = (uint32_t)(value - 1) | obj->unused[attribute];
        return end;
    }
    while (end < text->end && *end != '/' && !text_is_word_end(text, end)) {
        end++;
    }
    return resolve(obj, attribute, (struct word){p, (size_t)(end - p)}, resolved) ? end : NULL;
}

/* "v", "v/vt", "v//vn" or "v/vt/vn", from the beginning of the word to its end. */
static bool read_corner(struct obj *obj) {
    struct text *text = &obj->reader.text;
    struct corner corner = {MODEL_NONE, MODEL_NONE, MODEL_NONE};
    const char *p = read_field(obj, POSITION, text->next, &corner.position);
    if (p != NULL && p < text->end && *p == '/') {
        p = read_field(obj, UV, p + 1, &corner.uv);
        if (p != NULL && p < text->end && *p == '/') {
            p = read_field(obj, NORMAL, p + 1, &corner.normal);
        }
    }
    if (p == NULL) {
        return false;
    }
    if (!text_is_word_end(text, p)) {
        return error_malformed(&obj->reader);
    }
    text->next = p;
    return reader_add_corner(&obj->reader, corner);
}

/* The corners of a face or of a line. */
static bool read_corners(struct obj *obj) {
    obj->reader.polygon_size = 0;
    while (text_find_word(&obj->reader.text)) {
        if (!read_corner(obj)) {
            return false;
        }
    }
    return true;
}

static bool read_face(struct obj *obj) {
    if (!read_corners(obj)) {
        return false;
    }
    if (obj->reader.polygon_size < 3) {
        model_warn(obj->reader.model, MODEL_SHORT_FACES, obj->reader.line, NULL);
        return true;
    }
    return reader_add_faces(&obj->reader);
}

/* "l v1 v2 v3 ...": from each to the next. */
static bool read_line(struct obj *obj) {
    return (obj->parts & MODEL_LINES) == 0 || (read_corners(obj) && reader_add_lines(&obj->reader));
}

/* "s 2": the smoothing group of the faces to come; "s off" and "s 0": none. */
static bool read_group(struct obj *obj) {
    struct word word = text_next_word(&obj->reader.text);
    int64_t number = word_matches(word, "off") ? 0 : 1;
    (void)word_to_integer(word, &number);
    return obj->unused[NORMAL] != 0 ||
           reader_use_group(&obj->reader, (uint32_t)(number & 0x7fffffff));
}

/* ---- All of it ---- */

/* Keywords may be in capital letters, as a few writers have them; others are passed over. */
static bool read_lines(struct obj *obj) {
    struct word keyword;
    bool done = true;
    while (done && reader_next_line(&obj->reader, &keyword)) {
        if (word_matches(keyword, "v")) {
            done = read_attribute(obj, POSITION);
        } else if (word_matches(keyword, "vt")) {
            done = read_attribute(obj, UV);
        } else if (word_matches(keyword, "vn")) {
            done = read_attribute(obj, NORMAL);
        } else if (obj->reading_ahead) {
            continue; /* it is come to again */
        } else if (word_matches(keyword, "f") || word_matches(keyword, "fo")) {
            done = read_face(obj);
        } else if (word_matches(keyword, "l")) {
            done = read_line(obj);
        } else if (word_matches(keyword, "s")) {
            done = read_group(obj);
        } else if (word_matches(keyword, "usemtl")) {
            done = reader_use_material(&obj->reader, text_rest_of_line(&obj->reader.text));
        } else if (word_matches(keyword, "mtllib")) {
            done = reader_add_library(&obj->reader, text_rest_of_line(&obj->reader.text));
        }
    }
    return done;
}

bool obj_decode(struct model *model, const void *data, size_t size, unsigned parts,
                struct error *error) {
    struct obj obj = {
        .reader = {.model = model, .error = error},
        .parts = parts,
        .unused = {0, (parts & MODEL_UVS) != 0 ? 0 : MODEL_NONE,
                   (parts & MODEL_NORMALS) != 0 ? 0 : MODEL_NONE},
    };
    bool done = text_begin(&obj.reader.text, data, size, true, error) && read_lines(&obj) &&
                reader_finish(&obj.reader);
    model_reader_free(&obj.reader);
    return done;
}
