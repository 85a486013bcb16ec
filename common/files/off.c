/*
 * OFF files; see off.h. A line may end between any two words of them. It counts in four places: the
 * colour of a face ends with its line, so that two faces need two lines; where a line has one
 * number more than a vertex with a colour, that is alpha; the number of edges may be in the line of
 * the numbers before it, in the next one or nowhere; and only where each vertex has a line may it
 * have a colour of which the first word says nothing.
 */
#include "files/off.h"

#include "files/model_reader.h"

#include <assert.h>
#include <string.h>

/* ---- The first lines ---- */

/* What the file does not say clearly, and how it is taken. */
struct off_guess {
    bool edges;   /* whether the number of edges is there, where the line ends before it: otherwise
                   * than it looks */
    bool colored; /* vertices have colours, though the first word names none */
};

/* The first word: ST, C, N, 4 and n in any order, then OFF, says what a vertex has. Where it is
 * missing, the file begins with its numbers. */
struct off_kind {
    bool uv, color, normal;
    bool four, dimension; /* 4OFF: x y z w; nOFF: the number of dimensions follows */
    bool only_drawn;      /* faces with fewer than 3 corners tell that the file is read amiss */
    bool own_lines;       /* each vertex has a line */
    bool lines;           /* faces of 2 corners are wanted */
    struct word rest;     /* what follows OFF in the same word: some writers leave out the blank */
};

static bool over_prefix(const char **p, const char *end, const char *prefix) {
    bool begins = word_begins((struct word){*p, (size_t)(end - *p)}, prefix);
    *p += begins ? strlen(prefix) : 0;
    return begins;
}

static bool parse_keyword(struct word word, struct off_kind *kind) {
    int64_t number;
    *kind = (struct off_kind){.rest = word};
    if (word_to_integer(word, &number)) {
        return true;
    }
    const char *p = word.start, *end = word.start + word.length, *before;
    do {
        before = p;
        if (end - p == 4 && memcmp(p, "nOFF", 4) == 0) {
            kind->dimension = over_prefix(&p, end, "N");
        }
        kind->uv |= over_prefix(&p, end, "ST");
        kind->color |= over_prefix(&p, end, "C");
        kind->normal |= over_prefix(&p, end, "N");
        kind->four |= over_prefix(&p, end, "4");
    } while (p > before);
    if (!over_prefix(&p, end, "OFF")) {
        return false;
    }
    kind->rest = (struct word){p, (size_t)(end - p)};
    return p == end || (*p >= '0' && *p <= '9');
}

/* Does a file, which may be large, begin as OFF does? The word behind its first one. */
static bool peek_keyword(const void *data, size_t size, struct word *next) {
    struct text text;
    struct off_kind kind;
    struct word word = {0};
    text_peek(&text, data, size);
    while (word.length == 0 && text_next_line(&text)) {
        word = text_next_word(&text);
    }
    *next = text_next_word(&text);
    return word.length > 0 && parse_keyword(word, &kind);
}

bool off_recognize(const void *data, size_t size) {
    struct word next;
    return peek_keyword(data, size, &next);
}

static bool read_count(struct model_reader *reader, struct word word, const char *what,
                       size_t *count) {
    int64_t value;
    if (!word_to_integer(word, &value) || value < 0 || (uint64_t)value >= MODEL_NONE) {
        return text_error(reader->error, reader->line, "'%s' is not a number of %s",
                          word_show(word).text, what);
    }
    *count = (size_t)value;
    return true;
}

/* Is there just one word more on this line? */
static bool one_word_is_left(struct text text) {
    struct word first = text_next_word(&text), second = text_next_word(&text);
    return first.length > 0 && second.length == 0;
}

/* Does the next line that is not empty have one word? */
static bool one_word_follows(struct text text) {
    while (text_next_line(&text)) {
        struct text line = text;
        if (text_next_word(&text).length > 0) {
            return one_word_is_left(line);
        }
    }
    return false;
}

/* Read over the number of edges, which nobody needs. Behind numbers that end their line it looks
 * like one where it has its own line. */
static bool skip_edges(struct model_reader *reader, struct off_guess guess, bool *in_doubt) {
    struct word word = text_next_word(&reader->text);
    int64_t ignored;
    *in_doubt = word.length == 0;
    if (*in_doubt && one_word_follows(reader->text) == guess.edges) {
        return true;
    }
    if (word.length == 0 && !reader_next_word(reader, &word)) {
        return true;
    }
    return word_to_integer(word, &ignored) ||
           text_error(reader->error, reader->line, "'%s' is not a number of edges",
                      word_show(word).text);
}

struct off_counts {
    size_t vertices, faces;
    bool in_doubt; /* whether the number of edges follows */
};

/* The numbers of vertices, faces and edges, from `word` on, unless it is empty. A vertex takes at
 * least 6 bytes ("0 0 0" and a blank), a face at least 2. */
static bool read_counts(struct model_reader *reader, struct word word, struct off_guess guess,
                        struct off_counts *counts) {
    if (word.length == 0 && !reader_next_word(reader, &word)) {
        return text_error(reader->error, reader->line,
                          "the numbers of vertices and faces are missing");
    }
    if (!read_count(reader, word, "vertices", &counts->vertices)) {
        return false;
    }
    if (!reader_next_word(reader, &word)) {
        return text_error(reader->error, reader->line, "the number of faces is missing");
    }
    if (!read_count(reader, word, "faces", &counts->faces) ||
        !skip_edges(reader, guess, &counts->in_doubt)) {
        return false;
    }
    uint64_t left = (uint64_t)(reader->text.end - reader->text.next);
    return (counts->vertices <= left / 6 && counts->faces <= left / 2) ||
           text_error(reader->error, reader->line,
                      "%zu vertices and %zu faces are more than the file can hold",
                      counts->vertices, counts->faces);
}

/* "OFF" and the numbers, with what is guessed. */
static bool read_header(struct model_reader *reader, struct off_guess guess, struct off_kind *kind,
                        struct off_counts *counts) {
    struct word word;
    bool is_off = reader_next_line(reader, &word) && parse_keyword(word, kind);
    assert(is_off); /* or off_recognize() was not asked */
    (void)is_off;
    kind->only_drawn = guess.edges;
    kind->own_lines = guess.colored;
    kind->color |= guess.colored;
    word = kind->rest;
    if (kind->dimension) {
        if (word.length == 0 && !reader_next_word(reader, &word)) {
            return text_error(reader->error, reader->line, "the number of dimensions is missing");
        }
        if (!word_is(word, "3")) {
            return text_error(reader->error, reader->line, "a space of %s dimensions, not 3",
                              word_show(word).text);
        }
        word.length = 0;
    }
    return read_counts(reader, word, guess, counts);
}

/* ---- Vertices ---- */

/* The next number of vertex `number` of `total`. */
static bool read_number(struct model_reader *reader, size_t number, size_t total, double *value) {
    struct word word;
    if (!reader_next_word(reader, &word)) {
        return text_error(reader->error, reader->line, "the file ends after %zu of %zu vertices",
                          number, total);
    }
    return reader_parse_number(reader, word, value);
}

/* Is the next line "n i1 ... in", as of a face, with indices below `total`? Returns its number, or
 * 0. */
static size_t find_face(struct text text, size_t total) {
    int64_t corners, index;
    struct word word = text_next_word(&text);
    size_t count = 0;
    while (word.length == 0 && text_next_line(&text)) {
        word = text_next_word(&text);
    }
    bool whole = word_to_integer(word, &corners) && corners >= 3;
    for (word = text_next_word(&text); whole && word.length > 0; word = text_next_word(&text)) {
        whole = word_to_integer(word, &index) && index >= 0 && (uint64_t)index < total;
        count++;
    }
    return whole && count == (size_t)corners ? text.line : 0;
}

static bool read_vertex(struct model_reader *reader, const struct off_kind *kind, size_t number,
                        size_t total) {
    double value[READER_NUMBER_LIMIT];
    size_t normal_at = kind->four ? 4 : 3, color_at = normal_at + (kind->normal ? 3 : 0);
    size_t least = color_at + (kind->color ? 3 : 0) + (kind->uv ? 2 : 0), count = 0, line = 0;
    while (count < least || (count == least && kind->color && one_word_is_left(reader->text))) {
        if (!read_number(reader, number, total, &value[count++])) {
            return false;
        }
        line = count == 1 ? reader->line : line;
    }
    if (kind->own_lines && (line != reader->line || text_next_word(&reader->text).length > 0)) {
        return false; /* it was but a guess, and its message is ignored */
    }
    if (kind->four) {
        reader_divide_by_w(value);
    }
    return reader_add_position(reader, value) &&
           (!kind->color || reader_color_position(reader, value + color_at)) &&
           (!kind->normal || reader_add_normal(reader, value + normal_at)) &&
           (!kind->uv || reader_add_uv(reader, value[count - 2], value[count - 1]));
}

/* ---- Faces ---- */

/* One number is that of a position, texture coordinate and normal. */
static bool read_polygon(struct model_reader *reader, const struct off_kind *kind, size_t size) {
    const size_t vertices = reader->model->position_count;
    reader->polygon_size = 0;
    for (size_t i = 0; i < size; i++) {
        struct word word;
        int64_t index;
        if (!reader_next_word(reader, &word)) {
            return text_error(reader->error, reader->line, "face has %zu corners, not %zu", i,
                              size);
        }
        if (!word_to_integer(word, &index)) {
            return text_error(reader->error, reader->line, "'%s' is not the number of a vertex",
                              word_show(word).text);
        }
        if (index < 0 || (uint64_t)index >= vertices) {
            return text_error(reader->error, reader->line, "face names vertex %s of %zu (from 0)",
                              word_show(word).text, vertices);
        }
        const uint32_t all = (uint32_t)index, none = MODEL_NONE;
        if (!reader_add_corner(
                reader, (struct corner){all, kind->uv ? all : none, kind->normal ? all : none})) {
            return false;
        }
    }
    return true;
}

/* Are all words to the end of the line whole numbers? */
static bool are_whole(struct text text) {
    struct word word;
    int64_t ignored;
    do {
        word = text_next_word(&text);
    } while (word_to_integer(word, &ignored));
    return word.length == 0;
}

/* What follows the corners: nothing, an index into a table of colours (not used), or a colour,
 * perhaps with alpha: levels 0..255 where all are whole numbers, otherwise 0..1. */
static bool read_face_color(struct model_reader *reader, double color[3], bool *colored) {
    struct reader_numbers numbers;
    double scale = are_whole(reader->text) ? 255 : 1;
    if (!reader_read_numbers(reader, &numbers)) {
        return false;
    }
    if (numbers.count == 2 || numbers.count > 4) {
        return text_error(reader->error, reader->line,
                          "the colour of a face has 3 or 4 numbers, not %zu", numbers.count);
    }
    *colored = numbers.count >= 3;
    for (int channel = 0; *colored && channel < 3; channel++) {
        color[channel] = numbers.value[channel] / scale;
    }
    return true;
}

/* "n i1 ... in", then perhaps a colour. */
static bool read_off_face(struct model_reader *reader, const struct off_kind *kind, size_t number,
                          size_t total) {
    struct word word;
    size_t size = 0, first = reader->model->face_count;
    double color[3];
    bool colored = false;
    if (!reader_next_word(reader, &word)) {
        return text_error(reader->error, reader->line, "the file ends after %zu of %zu faces",
                          number, total);
    }
    if (!read_count(reader, word, "corners", &size) || !read_polygon(reader, kind, size) ||
        !read_face_color(reader, color, &colored)) {
        return false;
    }
    if (size < 3) { /* points are not drawn, and lines in lesson 2 alone */
        return (!kind->only_drawn ||
                text_error(reader->error, reader->line, "face has %zu corners", size)) &&
               (!kind->lines || reader_add_lines(reader));
    }
    return reader_add_faces(reader) && (!colored || reader_color_faces(reader, first, color));
}

/* Anything left over was read wrongly, or would be lost. */
static bool read_end(struct model_reader *reader, size_t faces) {
    struct word word;
    return !reader_next_word(reader, &word) ||
           text_error(reader->error, reader->line, "the file goes on after %zu faces%s", faces,
                      reader->model->face_count == 0 ? ", none with 3 corners" : "");
}

/* ---- All of it ---- */

static bool read_all(struct model_reader *reader, unsigned parts, struct off_guess guess,
                     bool *in_doubt) {
    struct off_kind kind;
    struct off_counts counts = {0};
    bool done = read_header(reader, guess, &kind, &counts);
    *in_doubt = counts.in_doubt;
    kind.lines = (parts & MODEL_LINES) != 0;
    struct text last = {.next = NULL}; /* at the last vertex */
    for (size_t i = 0; done && i < counts.vertices; i++) {
        last = i + 1 == counts.vertices ? reader->text : last;
        done = read_vertex(reader, &kind, i, counts.vertices);
    }
    for (size_t i = 0; done && i < counts.faces; i++) {
        done = read_off_face(reader, &kind, i, counts.faces);
    }
    done = done && read_end(reader, counts.faces);
    size_t face_line = done || reader->error->line == 0 ? 0 : find_face(last, counts.vertices);
    if (face_line > 0) {
        return text_error(reader->error, face_line, "a face where vertex %zu of %zu is expected",
                          counts.vertices, counts.vertices);
    }
    return done && reader_finish(reader);
}

static bool decode_off(struct model *model, const void *data, size_t size, unsigned parts,
                       struct off_guess guess, bool *in_doubt, struct error *error) {
    struct model_reader reader = {.model = model, .error = error};
    bool done = text_begin(&reader.text, data, size, false, error) &&
                read_all(&reader, parts, guess, in_doubt);
    model_reader_free(&reader);
    if (!done) {
        model_free(model);
    }
    return done;
}

/* Where what looks right does not fit, another guess may; not with points and lines, which it
 * finds in many a file that is wrong elsewhere. Nor where memory ran out, an error that
 * names no line: a guess that needs less memory might fit, and be wrong. */
bool off_decode(struct model *model, const void *data, size_t size, unsigned parts,
                struct error *error) {
    struct error again = {.line = 1};
    struct word next;
    bool in_doubt = false;
    if (peek_keyword(data, size, &next) && word_begins(next, "BINARY")) { /* bytes follow */
        return text_error(error, 1, "a binary OFF file: only text can be read");
    }
    return decode_off(model, data, size, parts, (struct off_guess){0}, &in_doubt, error) ||
           (error->line > 0 && in_doubt &&
            decode_off(model, data, size, parts, (struct off_guess){.edges = true}, &in_doubt,
                       &again)) ||
           (error->line > 0 && again.line > 0 &&
            decode_off(model, data, size, parts, (struct off_guess){.colored = true}, &in_doubt,
                       &again));
}
