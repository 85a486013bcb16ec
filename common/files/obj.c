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

static const char *const attribute_name[] = {"vertex", "texture coordinate", "normal"};

struct obj {
    struct model_reader reader;
    unsigned parts;            /* of enum model_part: what is wanted */
    size_t so_far[ATTRIBUTES]; /* above the current line: what a negative index counts back from */
    size_t total[ATTRIBUTES];  /* as far as the file is read */
    bool reading_ahead;        /* faces are passed over */
    bool is_read_ahead;        /* all but faces is read */
};

/* ---- Positions, texture coordinates and normals ---- */

static bool read_position(struct model_reader *reader, const struct reader_numbers *numbers) {
    size_t count = numbers->count;
    if (count != 3 && count != 4 && count != 6) { /* x y z, x y z w, x y z r g b */
        return text_error(reader->error, reader->line, "'v' takes 3, 4 or 6 numbers, not %zu",
                          count);
    }
    return reader_add_position(reader, numbers->value) &&
           (count < 6 || reader_color_position(reader, numbers->value + 3));
}

static bool read_uv(struct model_reader *reader, const struct reader_numbers *numbers) {
    if (numbers->count < 1 || numbers->count > 3) { /* u, u v, u v w */
        return text_error(reader->error, reader->line, "'vt' takes 1 to 3 numbers, not %zu",
                          numbers->count);
    }
    return reader_add_uv(reader, numbers->value[0], numbers->count > 1 ? numbers->value[1] : 0);
}

static bool read_normal(struct model_reader *reader, const struct reader_numbers *numbers) {
    if (numbers->count != 3) {
        return text_error(reader->error, reader->line, "'vn' takes 3 numbers, not %zu",
                          numbers->count);
    }
    return reader_add_normal(reader, numbers->value);
}

static bool is_wanted(const struct obj *obj, enum attribute attribute) {
    static const unsigned part[] = {0, MODEL_UVS, MODEL_NORMALS};
    return attribute == POSITION || (obj->parts & part[attribute]) != 0;
}

/* A line of an attribute: counted, and read if it is of use and not read yet. */
static bool read_attribute(struct obj *obj, enum attribute attribute) {
    static bool (*const read[])(struct model_reader *, const struct reader_numbers *) = {
        read_position, read_uv, read_normal};
    struct reader_numbers numbers;
    obj->so_far[attribute]++;
    if (obj->is_read_ahead) {
        return true;
    }
    obj->total[attribute]++;
    return !is_wanted(obj, attribute) ||
           (reader_read_numbers(&obj->reader, &numbers) && read[attribute](&obj->reader, &numbers));
}

/* ---- Faces ---- */

static bool read_lines(struct obj *obj);

/* Read what comes further down, but for faces, and come back. */
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

/* The index from 0 of what the field names. */
static bool resolve(struct obj *obj, enum attribute attribute, int64_t index, struct word field,
                    uint32_t *resolved) {
    const size_t so_far = obj->so_far[attribute], *total = &obj->total[attribute];
    if (index > 0 && (uint64_t)index > *total && !obj->is_read_ahead && !read_ahead(obj)) {
        return false;
    }
    if (index > 0 ? (uint64_t)index <= *total : index < 0 && index >= -(int64_t)so_far) {
        *resolved = (uint32_t)(index > 0 ? index - 1 : (int64_t)so_far + index);
        return true;
    }
    const char *name = attribute_name[attribute];
    if (index == 0) {
        return text_error(obj->reader.error, obj->reader.line, "face names %s 0: the first is 1",
                          name);
    }
    return text_error(obj->reader.error, obj->reader.line, "face names %s %s of %zu", name,
                      word_show(field).text, index > 0 ? *total : so_far);
}

/* Over an index, [+-] digits; NULL where there is none. */
static inline const char *read_index(const char *p, const char *end, int64_t *index) {
    enum { DIGIT_LIMIT = 18 }; /* so many always fit */
    const char *start = p;
    bool negative = p < end && *p == '-';
    p += negative || (p < end && *p == '+');
    const char *digits = p;
    uint64_t value = 0;
    p = text_read_digits(p, end, &value);
    if (p - digits > DIGIT_LIMIT) {
        int64_t nearest;
        reader_parse_index((struct word){start, (size_t)(p - start)}, &nearest);
        *index = nearest;
    } else {
        *index = negative ? -(int64_t)value : (int64_t)value;
    }
    return p > digits ? p : NULL;
}

static bool error_malformed(struct model_reader *reader) {
    struct word word = text_next_word(&reader->text);
    return text_error(reader->error, reader->line,
                      "face corner '%s' is none of v, v/vt, v//vn, v/vt/vn", word_show(word).text);
}

/* "v", "v/vt", "v//vn" or "v/vt/vn", from the beginning of the word to its end. */
static bool read_corner(struct obj *obj) {
    struct model_reader *reader = &obj->reader;
    struct text *text = &reader->text;
    uint32_t resolved[ATTRIBUTES] = {MODEL_NONE, MODEL_NONE, MODEL_NONE};
    const char *p = text->next;
    for (int attribute = POSITION; attribute < ATTRIBUTES; attribute++) {
        const char *field = p;
        int64_t index;
        bool left_out = attribute == UV && p < text->end && *p == '/';
        p = left_out ? p : read_index(p, text->end, &index);
        bool goes_on = p != NULL && p < text->end && *p == '/';
        if (p == NULL || (!goes_on && !text_is_word_end(text, p))) {
            break;
        }
        struct word word = {field, (size_t)(p - field)};
        if (!left_out &&
            !resolve(obj, (enum attribute)attribute, index, word, &resolved[attribute])) {
            return false;
        }
        if (!goes_on) {
            text->next = p;
            return reader_add_corner(
                reader,
                (struct corner){resolved[POSITION], is_wanted(obj, UV) ? resolved[UV] : MODEL_NONE,
                                is_wanted(obj, NORMAL) ? resolved[NORMAL] : MODEL_NONE});
        }
        p++;
    }
    return error_malformed(reader);
}

static bool read_face(struct obj *obj) {
    struct model_reader *reader = &obj->reader;
    reader->polygon_size = 0;
    while (text_find_word(&reader->text)) {
        if (!read_corner(obj)) {
            return false;
        }
    }
    if (reader->polygon_size < 3) {
        return text_error(reader->error, reader->line, "a face has at least 3 corners, not %zu",
                          reader->polygon_size);
    }
    return reader_add_faces(reader);
}

/* ---- All of it ---- */

/* Lines with other keywords are passed over. */
static bool read_lines(struct obj *obj) {
    struct word keyword;
    bool done = true;
    while (done && reader_next_line(&obj->reader, &keyword)) {
        if (word_is(keyword, "v")) {
            done = read_attribute(obj, POSITION);
        } else if (word_is(keyword, "vt")) {
            done = read_attribute(obj, UV);
        } else if (word_is(keyword, "vn")) {
            done = read_attribute(obj, NORMAL);
        } else if (word_is(keyword, "f")) {
            done = obj->reading_ahead || read_face(obj);
        }
    }
    return done;
}

bool obj_decode(struct model *model, const void *data, size_t size, unsigned parts,
                struct error *error) {
    struct obj obj = {.reader = {.model = model, .error = error}, .parts = parts};
    bool done = text_begin(&obj.reader.text, data, size, true, error) && read_lines(&obj) &&
                reader_finish_colors(&obj.reader);
    model_reader_free(&obj.reader);
    return done;
}
