/* What the readers of OBJ and OFF share; see model_reader.h. */
#include "files/model_reader.h"

#include "base/array.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

/* ---- Lines and numbers ---- */

bool reader_next_line(struct model_reader *reader, struct word *word) {
    while (text_next_line(&reader->text)) {
        reader->line = reader->text.line;
        *word = text_next_word(&reader->text);
        if (word->length > 0) {
            return true;
        }
    }
    return false;
}

bool reader_next_word(struct model_reader *reader, struct word *word) {
    *word = text_next_word(&reader->text);
    return word->length > 0 || reader_next_line(reader, word);
}

bool reader_parse_index(struct word word, int64_t *index) {
    if (word_to_integer(word, index)) {
        return true;
    }
    size_t sign = word.length > 0 && (word.start[0] == '-' || word.start[0] == '+');
    for (size_t i = sign; i < word.length; i++) {
        if (word.start[i] < '0' || word.start[i] > '9') {
            return false;
        }
    }
    *index = word.length > sign && word.start[0] == '-' ? INT64_MIN : INT64_MAX;
    return word.length > sign;
}

static bool check_number(struct model_reader *reader, struct word word, double number) {
    if (fabs(number) <= FLT_MAX) {
        return true;
    }
    return isnan(number)
               ? text_error(reader->error, reader->line, "'%s' is not a number",
                            word_show(word).text)
               : text_error(reader->error, reader->line, "%s is too large", word_show(word).text);
}

bool reader_parse_number(struct model_reader *reader, struct word word, double *number) {
    *number = word_to_double(word, number) ? *number : NAN;
    return check_number(reader, word, *number);
}

bool reader_read_numbers(struct model_reader *reader, struct reader_numbers *numbers) {
    for (numbers->count = 0;; numbers->count++) {
        double number;
        struct word word = text_next_number(&reader->text, &number);
        if (word.length == 0) {
            return true;
        }
        if (!check_number(reader, word, number)) {
            return false;
        }
        if (numbers->count < READER_NUMBER_LIMIT) {
            numbers->value[numbers->count] = number;
        }
    }
}

/* ---- Positions, texture coordinates, normals, colours ---- */

/* As array_extend(), with a message. Elements are numbered below MODEL_NONE. */
static bool extend(struct model_reader *reader, void *pointer, size_t *capacity, size_t count,
                   size_t element_size) {
    return (count < MODEL_NONE && array_extend(pointer, capacity, count, element_size)) ||
           error_out_of_memory(reader->error);
}

bool reader_add_position(struct model_reader *reader, const double position[3]) {
    struct model *model = reader->model;
    if (!extend(reader, &model->positions, &reader->position_capacity, model->position_count + 1,
                sizeof *model->positions)) {
        return false;
    }
    model->positions[model->position_count++] =
        (struct vec3){position[0], position[1], position[2]};
    return true;
}

/* Add three numbers to a list of floats. */
static bool add_three(struct model_reader *reader, float (**list)[3], size_t *count,
                      size_t *capacity, const double numbers[3]) {
    if (!extend(reader, list, capacity, *count + 1, sizeof **list)) {
        return false;
    }
    for (int i = 0; i < 3; i++) {
        (*list)[*count][i] = (float)numbers[i];
    }
    *count += 1;
    return true;
}

bool reader_add_normal(struct model_reader *reader, const double normal[3]) {
    struct model *model = reader->model;
    return add_three(reader, &model->normals, &model->normal_count, &reader->normal_capacity,
                     normal);
}

bool reader_add_uv(struct model_reader *reader, double u, double v) {
    struct model *model = reader->model;
    if (!extend(reader, &model->uvs, &reader->uv_capacity, model->uv_count + 1,
                sizeof *model->uvs)) {
        return false;
    }
    model->uvs[model->uv_count][0] = (float)u;
    model->uvs[model->uv_count++][1] = (float)v;
    return true;
}

static const double white[3] = {1, 1, 1};

/* Add this colour to a list until it holds `count` of them. */
static bool fill_colors(struct model_reader *reader, float (**colors)[3],
                        struct reader_colors *filled, size_t count, const double color[3]) {
    while (filled->count < count) {
        if (!add_three(reader, colors, &filled->count, &filled->capacity, color)) {
            return false;
        }
    }
    return true;
}

/* Elements from `first` up to `count` get the colour, those before that have none are white. */
static bool add_colors(struct model_reader *reader, float (**colors)[3],
                       struct reader_colors *filled, size_t first, size_t count,
                       const double color[3]) {
    return fill_colors(reader, colors, filled, first, white) &&
           fill_colors(reader, colors, filled, count, color);
}

bool reader_color_position(struct model_reader *reader, const double color[3]) {
    size_t count = reader->model->position_count;
    return add_colors(reader, &reader->model->colors, &reader->colors, count - 1, count, color);
}

bool reader_color_faces(struct model_reader *reader, size_t first, const double color[3]) {
    struct model *model = reader->model;
    return add_colors(reader, &model->face_colors, &reader->face_colors, first, model->face_count,
                      color);
}

/* Cut the colours to 0..1, and add white up to `count` of them. */
static bool finish_colors(struct model_reader *reader, float (**colors)[3],
                          struct reader_colors *filled, size_t count) {
    if (*colors == NULL) {
        return true;
    }
    for (size_t i = 0; i < filled->count; i++) {
        for (int channel = 0; channel < 3; channel++) {
            float value = (*colors)[i][channel];
            (*colors)[i][channel] = value > 0 ? (value < 1 ? value : 1) : 0;
        }
    }
    return fill_colors(reader, colors, filled, count, white);
}

bool reader_finish_colors(struct model_reader *reader) {
    struct model *model = reader->model;
    return finish_colors(reader, &model->colors, &reader->colors, model->position_count) &&
           finish_colors(reader, &model->face_colors, &reader->face_colors, model->face_count);
}

/* ---- Faces ---- */

bool reader_grow_polygon(struct model_reader *reader) {
    return extend(reader, &reader->polygon, &reader->polygon_capacity, reader->polygon_size + 1,
                  sizeof *reader->polygon);
}

/* Put the positions of the polygon's corners together. */
static bool gather_places(struct model_reader *reader) {
    if (!extend(reader, &reader->places, &reader->place_capacity, reader->polygon_size,
                sizeof *reader->places)) {
        return false;
    }
    for (size_t i = 0; i < reader->polygon_size; i++) {
        reader->places[i] = reader->model->positions[reader->polygon[i].position];
    }
    return true;
}

static bool cut_polygon(struct model_reader *reader) {
    size_t size = reader->polygon_size;
    switch (polygon_cut(&reader->cutter, reader->places, size)) {
    case POLYGON_CUT:
        return true;
    case POLYGON_TOO_LARGE:
        return text_error(reader->error, reader->line,
                          "face of %zu corners: one that is not convex may have %d", size,
                          POLYGON_CONCAVE_LIMIT);
    default:
        return error_out_of_memory(reader->error);
    }
}

/* Make room for more faces. */
static bool reserve_faces(struct model_reader *reader, size_t count) {
    struct model *model = reader->model;
    return extend(reader, &model->faces, &reader->face_capacity, model->face_count + count,
                  sizeof *model->faces);
}

/* Most faces are triangles already. */
static bool add_triangle(struct model_reader *reader) {
    struct model *model = reader->model;
    if (!reserve_faces(reader, 1)) {
        return false;
    }
    const struct corner *corner = reader->polygon;
    model->faces[model->face_count++] = (struct face){{corner[0], corner[1], corner[2]}};
    return true;
}

bool reader_add_faces(struct model_reader *reader) {
    struct model *model = reader->model;
    if (reader->polygon_size == 3) {
        return add_triangle(reader);
    }
    if (!gather_places(reader) || !cut_polygon(reader)) {
        return false;
    }
    size_t count = reader->cutter.triangle_count;
    if (!reserve_faces(reader, count)) {
        return false;
    }
    for (size_t i = 0; i < count; i++) {
        const uint32_t *corner = reader->cutter.triangles[i];
        const struct corner *polygon = reader->polygon;
        model->faces[model->face_count++] =
            (struct face){{polygon[corner[0]], polygon[corner[1]], polygon[corner[2]]}};
    }
    return true;
}

void model_reader_free(struct model_reader *reader) {
    free(reader->polygon);
    free(reader->places);
    polygon_cutter_free(&reader->cutter);
}
