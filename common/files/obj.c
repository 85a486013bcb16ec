/* OBJ files; see obj.h. */
#include "files/obj.h"

#include "files/model_reader.h"
#include "files/obj_quick.h"

/* ---- Positions, texture coordinates and normals ---- */

static bool read_position(struct model_reader *reader) {
    struct reader_numbers numbers;
    if (!reader_read_numbers(reader, &numbers)) {
        return false;
    }
    const double *value = numbers.value;
    size_t count = numbers.count;
    if (count != 3 && count != 4 && count != 6) { /* x y z, x y z w, x y z r g b */
        return text_error(reader->error, reader->line, "'v' takes 3, 4 or 6 numbers, not %zu",
                          count);
    }
    return reader_add_position(reader, value) &&
           (count < 6 || reader_color_position(reader, value + 3));
}

static bool read_uv(struct model_reader *reader) {
    struct reader_numbers numbers;
    if (!reader_read_numbers(reader, &numbers)) {
        return false;
    }
    if (numbers.count < 1 || numbers.count > 3) { /* u, u v, u v w */
        return text_error(reader->error, reader->line, "'vt' takes 1 to 3 numbers, not %zu",
                          numbers.count);
    }
    return reader_add_uv(reader, numbers.value[0], numbers.count > 1 ? numbers.value[1] : 0);
}

static bool read_normal(struct model_reader *reader) {
    struct reader_numbers numbers;
    if (!reader_read_numbers(reader, &numbers)) {
        return false;
    }
    if (numbers.count != 3) {
        return text_error(reader->error, reader->line, "'vn' takes 3 numbers, not %zu",
                          numbers.count);
    }
    return reader_add_normal(reader, numbers.value);
}

/* A line of an attribute that some corner may name. */
static bool read_if_wanted(struct model_reader *reader, enum model_part part, size_t *count,
                           bool read(struct model_reader *)) {
    *count += 1;
    return (reader->parts & part) == 0 || read(reader);
}

/* Everything but the faces. */
static bool read_attributes(struct model_reader *reader) {
    struct word keyword;
    while (reader_next_line(reader, &keyword)) {
        bool done = true;
        if (word_is(keyword, "v")) {
            done = read_position(reader);
        } else if (word_is(keyword, "vt")) {
            done = read_if_wanted(reader, MODEL_UVS, &reader->uv_count, read_uv);
        } else if (word_is(keyword, "vn")) {
            done = read_if_wanted(reader, MODEL_NORMALS, &reader->normal_count, read_normal);
        }
        if (!done) {
            return false;
        }
    }
    return reader_finish_colors(reader);
}

/* ---- Faces ---- */

/* What an index of a face counts. */
struct list {
    const char *name;
    size_t so_far; /* elements above the face: what a negative index counts back from */
    size_t total;  /* elements in the file: a positive index may name one further down */
};

struct lists {
    struct list list[3]; /* positions, texture coordinates, normals */
};

/* The index from 0 of what the field names. */
static bool resolve(struct model_reader *reader, struct word field, const struct list *list,
                    int64_t index, uint32_t *resolved) {
    if (index > 0 && (uint64_t)index <= list->total) {
        *resolved = (uint32_t)(index - 1);
        return true;
    }
    if (index < 0 && index >= -(int64_t)list->so_far) {
        *resolved = (uint32_t)((int64_t)list->so_far + index);
        return true;
    }
    if (index == 0) {
        return text_error(reader->error, reader->line, "face names %s 0: the first is 1",
                          list->name);
    }
    return text_error(reader->error, reader->line, "face names %s %s of %zu", list->name,
                      word_show(field).text, index > 0 ? list->total : list->so_far);
}

/* Take the next field off a corner "v/vt/vn", up to its slash or the end of the word. */
static struct word next_field(struct word *rest) {
    struct word field = {rest->start, 0};
    while (field.length < rest->length && field.start[field.length] != '/') {
        field.length++;
    }
    rest->start += field.length;
    rest->length -= field.length;
    return field;
}

/* "v", "v/vt", "v//vn" or "v/vt/vn". */
static bool read_corner(struct model_reader *reader, struct word word, const struct lists *lists) {
    uint32_t resolved[3] = {MODEL_NONE, MODEL_NONE, MODEL_NONE};
    struct word rest = word;
    bool well_formed = true;
    for (int i = 0; i < 3 && well_formed; i++) {
        struct word field = next_field(&rest);
        bool left_out = i == 1 && field.length == 0 && rest.length > 0;
        int64_t index;
        if (!left_out) {
            well_formed = reader_parse_index(field, &index);
            if (well_formed && !resolve(reader, field, &lists->list[i], index, &resolved[i])) {
                return false;
            }
        }
        if (rest.length == 0) {
            break;
        }
        well_formed = well_formed && i < 2; /* a third slash */
        rest.start++;
        rest.length--;
    }
    if (!well_formed) {
        return text_error(reader->error, reader->line,
                          "face corner '%s' is none of v, v/vt, v//vn, v/vt/vn",
                          word_show(word).text);
    }
    const struct corner corner = {resolved[0], resolved[1], resolved[2]};
    return reader_add_corner(reader, reader_wanted(reader, corner));
}

static bool read_face(struct model_reader *reader, const struct lists *lists) {
    reader->polygon_size = 0;
    for (;;) {
        struct word word = text_next_word(&reader->text);
        if (word.length == 0) {
            break;
        }
        if (!read_corner(reader, word, lists)) {
            return false;
        }
    }
    if (reader->polygon_size < 3) {
        return text_error(reader->error, reader->line, "a face has at least 3 corners, not %zu",
                          reader->polygon_size);
    }
    return reader_add_faces(reader);
}

static bool read_faces(struct model_reader *reader) {
    struct lists lists = {{{"vertex", 0, reader->model->position_count},
                           {"texture coordinate", 0, reader->uv_count},
                           {"normal", 0, reader->normal_count}}};
    struct word keyword;
    while (reader_next_line(reader, &keyword)) {
        if (word_is(keyword, "f")) {
            if (!read_face(reader, &lists)) {
                return false;
            }
        } else if (word_is(keyword, "v")) {
            lists.list[0].so_far++;
        } else if (word_is(keyword, "vt")) {
            lists.list[1].so_far++;
        } else if (word_is(keyword, "vn")) {
            lists.list[2].so_far++;
        }
    }
    return true;
}

/* Read twice: a face may name a vertex further down, and cutting it needs the position. */
static bool read_twice(struct model_reader *reader) {
    struct text start = reader->text;
    if (!read_attributes(reader)) {
        return false;
    }
    reader->text = start;
    return read_faces(reader);
}

bool obj_decode_carefully(struct model *model, const void *data, size_t size, unsigned parts,
                          struct error *error) {
    struct model_reader reader = {.model = model, .error = error, .parts = parts};
    bool done = text_begin(&reader.text, data, size, true, error) && read_twice(&reader);
    model_reader_free(&reader);
    return done;
}

bool obj_decode(struct model *model, const void *data, size_t size, unsigned parts,
                struct error *error) {
    struct model_reader reader = {.model = model, .error = error, .parts = parts};
    enum obj_quick_result result = obj_quick_read(&reader, data, size);
    model_reader_free(&reader);
    if (result != OBJ_QUICK_DECLINED) {
        return result == OBJ_QUICK_DONE;
    }
    model_free(model);
    return obj_decode_carefully(model, data, size, parts, error);
}
