/* Text scenes; see text_scene.h. */
#include "run/text_scene.h"

#include "base/array.h"
#include "base/text.h"
#include "files/find.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>

enum { NUMBER_LIMIT = 15 }; /* a triangle with three colours: 6 coordinates and 9 levels */

/* What the two kinds of scene draw. */
struct shape_rule {
    const char *keyword;
    size_t corners;
    bool fractions; /* coordinates may have them */
};

static const struct shape_rule shape_rules[] = {
    [TEXT_SCENE_LINES] = {"line", 2, false},
    [TEXT_SCENE_TRIANGLES] = {"triangle", 3, true},
};

/* A scene being read. */
struct reader {
    struct text text;
    const struct shape_rule *rule;
    struct text_scene *scene;
    size_t capacity; /* shapes allocated */
    struct error *error;
};

/* The words after the keyword, all of them counted; the first NUMBER_LIMIT are kept. */
static size_t read_words(struct reader *reader, struct word words[NUMBER_LIMIT]) {
    size_t count = 0;
    for (;;) {
        struct word word = text_next_word(&reader->text);
        if (word.length == 0) {
            return count;
        }
        if (count < NUMBER_LIMIT) {
            words[count] = word;
        }
        count++;
    }
}

/* A whole number in least..greatest. */
static bool read_whole(struct reader *reader, struct word word, const char *what, int64_t least,
                       int64_t greatest, int64_t *value) {
    double number;
    if (word_to_integer(word, value) && *value >= least && *value <= greatest) {
        return true;
    }
    if (word_to_integer(word, value) || (word_to_double(word, &number) && fabs(number) > 9e18)) {
        return text_error(reader->error, reader->text.line,
                          "%s %s lies outside %" PRId64 "..%" PRId64, what, word_show(word).text,
                          least, greatest);
    }
    return text_error(reader->error, reader->text.line, "%s '%s' is not a whole number", what,
                      word_show(word).text);
}

static bool read_coordinate(struct reader *reader, struct word word, double *value) {
    const int limit = TEXT_SCENE_COORDINATE_LIMIT;
    if (!reader->rule->fractions) {
        int64_t whole;
        if (!read_whole(reader, word, "coordinate", -limit, limit, &whole)) {
            return false;
        }
        *value = (double)whole;
        return true;
    }
    if (!word_to_double(word, value)) {
        return text_error(reader->error, reader->text.line, "coordinate '%s' is not a number",
                          word_show(word).text);
    }
    if (!(fabs(*value) <= limit)) {
        return text_error(reader->error, reader->text.line, "coordinate %s lies outside %d..%d",
                          word_show(word).text, -limit, limit);
    }
    return true;
}

static bool read_color(struct reader *reader, const struct word words[3], struct color *color) {
    int64_t level[3];
    for (size_t i = 0; i < 3; i++) {
        if (!read_whole(reader, words[i], "colour level", 0, 255, &level[i])) {
            return false;
        }
    }
    *color = color_rgb((uint8_t)level[0], (uint8_t)level[1], (uint8_t)level[2]);
    return true;
}

static bool read_size(struct reader *reader) {
    struct text_scene *scene = reader->scene;
    struct word words[NUMBER_LIMIT] = {{0}};
    size_t count = read_words(reader, words);
    int64_t width, height;
    if (scene->width != 0) {
        return text_error(reader->error, reader->text.line, "a second 'size'");
    }
    if (scene->shape_count > 0) {
        return text_error(reader->error, reader->text.line, "'size' must come before '%s'",
                          reader->rule->keyword);
    }
    if (count != 2) {
        return text_error(reader->error, reader->text.line, "'size' takes 2 numbers, not %zu",
                          count);
    }
    if (!read_whole(reader, words[0], "width", 1, TEXT_SCENE_SIZE_LIMIT, &width) ||
        !read_whole(reader, words[1], "height", 1, TEXT_SCENE_SIZE_LIMIT, &height)) {
        return false;
    }
    scene->width = (size_t)width;
    scene->height = (size_t)height;
    return true;
}

/* A shape takes at least 19 bytes of text, so memory grows only as the file does. */
static bool add_shape(struct reader *reader, const struct text_scene_shape *shape) {
    struct text_scene *scene = reader->scene;
    if (!array_extend(&scene->shapes, &reader->capacity, scene->shape_count + 1, sizeof *shape)) {
        return error_out_of_memory(reader->error);
    }
    scene->shapes[scene->shape_count++] = *shape;
    return true;
}

static bool read_shape(struct reader *reader) {
    size_t corners = reader->rule->corners;
    size_t one_color = 2 * corners + 3, all_colors = 2 * corners + 3 * corners;
    struct word words[NUMBER_LIMIT] = {{0}};
    size_t count = read_words(reader, words);
    if (count != one_color && count != all_colors) {
        return text_error(reader->error, reader->text.line,
                          "'%s' takes %zu or %zu numbers, not %zu", reader->rule->keyword,
                          one_color, all_colors, count);
    }
    struct text_scene_shape shape = {0};
    for (size_t i = 0; i < corners; i++) {
        const struct word *color = &words[2 * corners + (count == all_colors ? 3 * i : 0)];
        if (!read_coordinate(reader, words[2 * i], &shape.x[i]) ||
            !read_coordinate(reader, words[2 * i + 1], &shape.y[i]) ||
            !read_color(reader, color, &shape.color[i])) {
            return false;
        }
    }
    return add_shape(reader, &shape);
}

static bool read_line(struct reader *reader) {
    struct word keyword = text_next_word(&reader->text);
    if (keyword.length == 0) {
        return true;
    }
    if (word_is(keyword, "size")) {
        return read_size(reader);
    }
    if (word_is(keyword, reader->rule->keyword)) {
        return read_shape(reader);
    }
    return text_error(reader->error, reader->text.line,
                      "'%s' is not known: 'size' or '%s' is allowed", word_show(keyword).text,
                      reader->rule->keyword);
}

bool text_scene_decode(struct text_scene *scene, const void *data, size_t size,
                       enum text_scene_kind kind, struct error *error) {
    struct reader reader = {.rule = &shape_rules[kind], .scene = scene, .error = error};
    *scene = (struct text_scene){0};
    if (!text_begin(&reader.text, data, size, false, error)) {
        return false;
    }
    while (text_next_line(&reader.text)) {
        if (!read_line(&reader)) {
            text_scene_free(scene);
            return false;
        }
    }
    return true;
}

bool text_scene_read(struct text_scene *scene, const char *path, enum text_scene_kind kind,
                     struct error *error) {
    struct bytes bytes;
    *scene = (struct text_scene){0};
    if (!file_read(path, &bytes, error)) {
        return false;
    }
    bool done = text_scene_decode(scene, bytes.data, bytes.size, kind, error);
    if (!done && (name_ends(path, "obj") || name_ends(path, "off"))) {
        error_set(error, "a model, but this lesson draws text scenes; try --help");
        error->line = 0;
    }
    bytes_free(&bytes);
    return done || error_name_input(error, path);
}

void text_scene_free(struct text_scene *scene) {
    free(scene->shapes);
    *scene = (struct text_scene){0};
}
