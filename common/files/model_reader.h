/*
 * What the readers of OBJ and OFF share: numbers, growing arrays, polygons that become faces.
 * Private to obj.c, off.c and model_reader.c; everybody else uses model.h.
 *
 * All functions that can fail return false with a message, and the line where there is one. An
 * element takes some bytes of the file, so the file's size bounds the memory.
 */
#ifndef COMMON_FILES_MODEL_READER_H
#define COMMON_FILES_MODEL_READER_H

#include "base/array.h"
#include "base/error.h"
#include "base/text.h"
#include "files/model_file.h"
#include "files/polygon.h"
#include "model.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* How much of a list is filled, which has an element for each position or face: behind them at
 * times. */
struct reader_list {
    size_t count, capacity;
};

/* A model being read. At first everything but `model` and `error` is zero. */
struct model_reader {
    struct text text;
    size_t line; /* where the current statement began, for messages */
    struct model *model;
    struct error *error;

    struct corner *polygon; /* the corners of the current face */
    size_t polygon_size;

    /* Private to model_reader.c. */
    struct vec3 *places; /* of the polygon's corners */
    struct polygon_cutter cutter;
    struct reader_list colors, face_colors, face_materials, face_groups;
    uint32_t material, group; /* of the faces to come; of the first faces none is known */
    bool has_groups, has_wrong_positions;
    size_t material_capacity, library_capacity;
    size_t wrong_normal_line; /* the line of the first normal without a direction; 0: none */
    size_t position_capacity, uv_capacity, normal_capacity, face_capacity, line_capacity;
    size_t polygon_capacity, place_capacity;
};

/* The most numbers that a line of any format has: x y z w, normal, colour with alpha, uv. */
enum { READER_NUMBER_LIMIT = 13 };

struct reader_numbers {
    double value[READER_NUMBER_LIMIT]; /* the first of them */
    size_t count;                      /* of all, which may be more */
};

/* Go to the next line that is not empty; its first word. False at the end of the text. */
bool reader_next_line(struct model_reader *reader, struct word *word);

/* The next word, of this line or of those that follow. False at the end of the text. */
bool reader_next_word(struct model_reader *reader, struct word *word);

/* The word as a number. Words by which writers say that there is none, as "nan" and "-1.#IND",
 * become NaN. */
bool reader_parse_number(struct model_reader *reader, struct word word, double *number);

/* The numbers up to the end of the line. */
bool reader_read_numbers(struct model_reader *reader, struct reader_numbers *numbers);

/* The point that homogeneous coordinates name; at infinity, the direction to it. */
static inline void reader_divide_by_w(double position[4]) {
    for (int i = 0; position[3] != 0 && i < 3; i++) {
        position[i] /= position[3];
    }
}

/* Add to the model. All but positions is rounded to float. A position that is not finite, or too
 * large for a float, is an error only where a face names it. A texture coordinate that is none
 * becomes 0; when the model is finished, corners lose a normal that has no direction. */
bool reader_add_position(struct model_reader *reader, const double position[3]);
bool reader_add_uv(struct model_reader *reader, double u, double v);
bool reader_add_normal(struct model_reader *reader, const double normal[3]);

/* Give the last position a colour, of any values; earlier ones that have none are white. */
bool reader_color_position(struct model_reader *reader, const double color[3]);

/* Add a corner to the polygon. */
static inline bool reader_add_corner(struct model_reader *reader, struct corner corner) {
    if (!array_extend(&reader->polygon, &reader->polygon_capacity, reader->polygon_size + 1,
                      sizeof *reader->polygon)) {
        return error_out_of_memory(reader->error);
    }
    reader->polygon[reader->polygon_size++] = corner;
    return true;
}

/* Make faces of the polygon (at least 3 corners). Its positions must be known. */
bool reader_add_faces(struct model_reader *reader);

/* Join each corner of the polygon with the next one by a line. */
bool reader_add_lines(struct model_reader *reader);

/* Give all faces from `first` on a colour, of any values; earlier ones that have none are white. */
bool reader_color_faces(struct model_reader *reader, size_t first, const double color[3]);

/* The faces to come have that material; those before it keep theirs. At most 1,024 are known apart;
 * faces of more have none. */
bool reader_use_material(struct model_reader *reader, struct word name);

/* The faces to come are of that smoothing group; 0: of none. */
bool reader_use_group(struct model_reader *reader, uint32_t group);

/* Add the name of a file of materials. */
bool reader_add_library(struct model_reader *reader, struct word name);

/* At the end: bring all colours to 0..1 (positions have levels 0..255 where one is far above 1);
 * where only some positions or faces have a colour, make the others white; take normals without a
 * direction off the corners. */
bool reader_finish(struct model_reader *reader);

/* Free what does not belong to the model. */
void model_reader_free(struct model_reader *reader);

#endif
