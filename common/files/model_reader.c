/* What the readers of OBJ and OFF share; see model_reader.h. */
#include "files/model_reader.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

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

/* Words by which C libraries write what is no number. */
static bool names_no_number(struct word word) {
    size_t sign = word.length > 0 && (word.start[0] == '-' || word.start[0] == '+');
    struct word rest = {word.start + sign, word.length - sign};
    return word_begins(rest, "nan") || word_begins(rest, "inf") || word_begins(rest, "1.#");
}

/* A number, though perhaps not finite. */
static inline bool check_number(struct model_reader *reader, struct word word, double number) {
    return !isnan(number) || names_no_number(word) ||
           text_error(reader->error, reader->line, "'%s' is not a number", word_show(word).text);
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

static bool is_float(double number) {
    return fabs(number) <= FLT_MAX;
}

static bool is_wrong(struct vec3 p) {
    return !is_float(p.x) || !is_float(p.y) || !is_float(p.z);
}

bool reader_add_position(struct model_reader *reader, const double position[3]) {
    struct model *model = reader->model;
    struct vec3 p = {position[0], position[1], position[2]};
    reader->has_wrong_positions |= is_wrong(p);
    if (!extend(reader, &model->positions, &reader->position_capacity, model->position_count + 1,
                sizeof *model->positions)) {
        return false;
    }
    model->positions[model->position_count++] = p;
    return true;
}

/* A normal without a direction is kept as 0 0 0: its number must not be another's. */
bool reader_add_normal(struct model_reader *reader, const double normal[3]) {
    struct model *model = reader->model;
    bool right = is_float(normal[0]) && is_float(normal[1]) && is_float(normal[2]) &&
                 ((float)normal[0] != 0 || (float)normal[1] != 0 || (float)normal[2] != 0);
    if (!right && reader->wrong_normal_line == 0) {
        reader->wrong_normal_line = reader->line;
    }
    if (!extend(reader, &model->normals, &reader->normal_capacity, model->normal_count + 1,
                sizeof *model->normals)) {
        return false;
    }
    for (int i = 0; i < 3; i++) {
        model->normals[model->normal_count][i] = right ? (float)normal[i] : 0;
    }
    model->normal_count++;
    return true;
}

/* Take those without a direction off the corners. */
static void drop_wrong_normals(struct model_reader *reader) {
    struct model *model = reader->model;
    for (size_t i = 0; reader->wrong_normal_line > 0 && i < model->face_count; i++) {
        for (int j = 0; j < 3; j++) {
            uint32_t *index = &model->faces[i].corner[j].normal;
            const float *n = *index == MODEL_NONE ? NULL : model->normals[*index];
            if (n != NULL && n[0] == 0 && n[1] == 0 && n[2] == 0) {
                *index = MODEL_NONE;
                model->warning_line[MODEL_NORMALS_WRONG] = reader->wrong_normal_line;
            }
        }
    }
}

bool reader_add_uv(struct model_reader *reader, double u, double v) {
    struct model *model = reader->model;
    if (!extend(reader, &model->uvs, &reader->uv_capacity, model->uv_count + 1,
                sizeof *model->uvs)) {
        return false;
    }
    model->uvs[model->uv_count][0] = is_float(u) ? (float)u : 0;
    model->uvs[model->uv_count++][1] = is_float(v) ? (float)v : 0;
    return true;
}

/* Add copies of an element to a list of a position or face each, until it holds `count`. */
static bool fill(struct model_reader *reader, void *pointer, struct reader_list *list, size_t count,
                 const void *element, size_t element_size) {
    char *elements;
    if (!extend(reader, pointer, &list->capacity, count, element_size)) {
        return false;
    }
    memcpy(&elements, pointer, sizeof elements); /* of any type */
    for (; list->count < count; list->count++) {
        memcpy(elements + list->count * element_size, element, element_size);
    }
    return true;
}

/* For what has no colour: white in any unit, once it is cut. */
static const float white[3] = {INFINITY, INFINITY, INFINITY};

/* Elements from `first` up to `count` get the colour, those before that have none are white. */
static bool add_colors(struct model_reader *reader, float (**colors)[3], struct reader_list *list,
                       size_t first, size_t count, const double color[3]) {
    float rounded[3];
    for (int i = 0; i < 3; i++) {
        rounded[i] = is_float(color[i]) ? (float)color[i] : INFINITY;
    }
    return fill(reader, colors, list, first, white, sizeof white) &&
           fill(reader, colors, list, count, rounded, sizeof rounded);
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

/* Add white up to `count` colours, and bring all to 0..1. Many writers use levels 0..255: one value
 * tells that is further above 1 than rounding could have brought it. */
static bool finish_colors(struct model_reader *reader, float (**colors)[3],
                          struct reader_list *list, size_t count, bool may_be_levels) {
    float unit = 1;
    if (*colors == NULL) {
        return true;
    }
    if (!fill(reader, colors, list, count, white, sizeof white)) {
        return false;
    }
    for (size_t i = 0; i < 3 * list->count; i++) {
        const float value = (*colors)[i / 3][i % 3];
        unit = may_be_levels && value > 2 && value < INFINITY ? 255 : unit;
    }
    for (size_t i = 0; i < 3 * list->count; i++) {
        const float value = (*colors)[i / 3][i % 3] / unit;
        (*colors)[i / 3][i % 3] = value > 0 ? (value < 1 ? value : 1) : 0;
    }
    return true;
}

/* ---- Materials ---- */

enum { MATERIAL_LIMIT = 1024 }; /* they are looked for one after the other */

/* Faces that have no material or no group yet get the current one, once the file names any. */
static bool fill_faces(struct model_reader *reader) {
    struct model *model = reader->model;
    return (model->material_count == 0 ||
            fill(reader, &model->face_materials, &reader->face_materials, model->face_count,
                 &reader->material, sizeof reader->material)) &&
           (!reader->has_groups || fill(reader, &model->face_groups, &reader->face_groups,
                                        model->face_count, &reader->group, sizeof reader->group));
}

bool reader_use_material(struct model_reader *reader, struct word name) {
    struct model *model = reader->model;
    size_t i = 0;
    if (model->material_count == 0) {
        reader->material = MODEL_NONE; /* of the faces before the first */
    }
    while (i < model->material_count && !word_is(name, model->materials[i].name)) {
        i++;
    }
    if (i == model->material_count && i < MATERIAL_LIMIT) {
        struct model_material material = {.name =
                                              string_format("%.*s", (int)name.length, name.start),
                                          .color = {1, 1, 1},
                                          .specular = -1,
                                          .scale = {1, 1},
                                          .bump = 1,
                                          .line = reader->line};
        if (material.name == NULL || !extend(reader, &model->materials, &reader->material_capacity,
                                             i + 1, sizeof *model->materials)) {
            free(material.name);
            return error_out_of_memory(reader->error);
        }
        model->materials[model->material_count++] = material;
    }
    bool done = fill_faces(reader);
    reader->material = i < MATERIAL_LIMIT ? (uint32_t)i : MODEL_NONE;
    return done;
}

bool reader_use_group(struct model_reader *reader, uint32_t group) {
    reader->group = reader->has_groups ? reader->group : MODEL_NONE;
    reader->has_groups = true;
    bool done = fill_faces(reader);
    reader->group = group;
    return done;
}

bool reader_add_library(struct model_reader *reader, struct word name) {
    struct model *model = reader->model;
    char *copy = string_format("%.*s", (int)name.length, name.start);
    if (copy == NULL || !extend(reader, &model->libraries, &reader->library_capacity,
                                model->library_count + 1, sizeof *model->libraries)) {
        free(copy);
        return error_out_of_memory(reader->error);
    }
    model->libraries[model->library_count++] = (struct model_library){copy, reader->line};
    return true;
}

/* Are the polygon's positions numbers, and not too large? */
static bool check_places(const struct model_reader *reader) {
    for (size_t i = 0; reader->has_wrong_positions && i < reader->polygon_size; i++) {
        const uint32_t position = reader->polygon[i].position;
        if (is_wrong(reader->model->positions[position])) {
            return text_error(reader->error, reader->line,
                              "vertex %zu is not a number, or too large", (size_t)position + 1);
        }
    }
    return true;
}

/* Those that no face and no line names: any number will do. */
static void mend_positions(struct model_reader *reader) {
    for (size_t i = 0; reader->has_wrong_positions && i < reader->model->position_count; i++) {
        struct vec3 *p = &reader->model->positions[i];
        *p = is_wrong(*p) ? (struct vec3){0, 0, 0} : *p;
    }
}

bool reader_finish(struct model_reader *reader) {
    struct model *model = reader->model;
    mend_positions(reader);
    drop_wrong_normals(reader);
    return fill_faces(reader) &&
           finish_colors(reader, &model->colors, &reader->colors, model->position_count, true) &&
           finish_colors(reader, &model->face_colors, &reader->face_colors, model->face_count,
                         false);
}

/* ---- Faces ---- */

static bool cut_polygon(struct model_reader *reader) {
    size_t size = reader->polygon_size;
    switch (polygon_cut(&reader->cutter, reader->places, size)) {
    case POLYGON_CUT:
        return true;
    case POLYGON_TOO_LARGE:
        return text_error(reader->error, reader->line,
                          "face of %zu corners, but %d are the most where it is not convex", size,
                          POLYGON_CORNER_LIMIT);
    default:
        return error_out_of_memory(reader->error);
    }
}

bool reader_add_faces(struct model_reader *reader) {
    struct model *model = reader->model;
    const struct corner *polygon = reader->polygon;
    size_t count = reader->polygon_size - 2;
    if (!check_places(reader) || !extend(reader, &model->faces, &reader->face_capacity,
                                         model->face_count + count, sizeof *model->faces)) {
        return false;
    }
    if (count == 1) { /* as most of them */
        model->faces[model->face_count++] = (struct face){{polygon[0], polygon[1], polygon[2]}};
        return true;
    }
    if (!extend(reader, &reader->places, &reader->place_capacity, reader->polygon_size,
                sizeof *reader->places)) {
        return false;
    }
    for (size_t i = 0; i < reader->polygon_size; i++) {
        reader->places[i] = model->positions[polygon[i].position];
    }
    if (!cut_polygon(reader)) {
        return false;
    }
    for (size_t i = 0; i < count; i++) {
        const uint32_t *corner = reader->cutter.triangles[i];
        model->faces[model->face_count++] =
            (struct face){{polygon[corner[0]], polygon[corner[1]], polygon[corner[2]]}};
    }
    return true;
}

bool reader_add_lines(struct model_reader *reader) {
    struct model *model = reader->model;
    for (size_t i = 1; i < reader->polygon_size; i++) {
        if (!check_places(reader) || !extend(reader, &model->lines, &reader->line_capacity,
                                             model->line_count + 1, sizeof *model->lines)) {
            return false;
        }
        model->lines[model->line_count][0] = reader->polygon[i - 1].position;
        model->lines[model->line_count++][1] = reader->polygon[i].position;
    }
    return true;
}

void model_reader_free(struct model_reader *reader) {
    free(reader->polygon);
    free(reader->places);
    polygon_cutter_free(&reader->cutter);
}
