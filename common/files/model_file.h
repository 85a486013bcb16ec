/*
 * Models read from OBJ and OFF files, and the textures next to them.
 *
 * OBJ: v (x y z, x y z w or x y z r g b), vt (u or u v) and vn, in which more numbers count for
 * nothing, f, s, mtllib, usemtl and, where asked for, l; all other keywords are passed over. A face
 * may name what comes further down; a negative index counts back from the face. A corner may name
 * no texture coordinate and no normal, and what the file does not have counts as none. OFF, COFF,
 * NOFF, STOFF, 4OFF and their mixtures, as text; lines may end between any two numbers, but a face
 * ends with its line, so that two need two lines (off.c). Its colour is in levels 0..255 where its
 * 3 or 4 numbers are whole, otherwise 0..1; one number alone, an index into a table of colours, is
 * not used. Colours of positions are levels where one is above 2. All are cut to 0..1; where some
 * positions or faces have colours, the others are white. UTF-16 is read as UTF-8. Of files of
 * materials: see mtl.h.
 */
#ifndef COMMON_FILES_MODEL_FILE_H
#define COMMON_FILES_MODEL_FILE_H

#include "base/error.h"
#include "model.h"

#include <stdbool.h>
#include <stddef.h>

/* Read an OBJ or OFF file, told apart by the contents ("OFF", "COFF", ... as the first word means
 * OFF). On an error `model` is empty and the message names the file and the line. */
bool model_read(struct model *model, const char *path, struct error *error);

/* What a file may hold other than positions and faces. */
enum model_part {
    MODEL_UVS = 1, /* and what materials say: everything that pictures on faces need */
    MODEL_NORMALS = 2,
    MODEL_MATERIALS = 8, /* what they say, of their colours */
    MODEL_LINES = 4,     /* a model may then consist of lines alone, with no face */
    MODEL_LEVELS = 16,   /* mip levels of its textures above 0 */
    MODEL_ALL_PARTS = MODEL_UVS | MODEL_NORMALS | MODEL_LEVELS /* of faces */
};

/* Read a file, but only the wanted parts of it, joined with |. Unwanted texture coordinates and
 * normals of an OBJ file are counted but not read, and no corner has them. */
bool model_read_parts(struct model *model, const char *path, unsigned parts, struct error *error);

/* What the warning says. */
const char *model_warning_text(enum model_warning warning);

/* model_read() from memory (for tests and fuzzing); the message does not name the file, and the
 * line is in `error` alone. */
bool model_decode(struct model *model, const void *data, size_t size, struct error *error);

/* The file of a texture, and whether it is there: the one that was chosen for this model, or the
 * first usual name under which there is one next to it, or the first of all. The caller frees it;
 * NULL when memory runs out. The model was read from a file. */
char *model_find_texture(const struct model *model, enum model_texture_kind kind, bool *found);

/* How many of the textures there are. */
size_t model_textures_present(const struct model *model);

/* Does a file of materials say how the model looks? Colours alone count less than a texture that
 * is next to the model. */
bool model_has_materials(const struct model *model);

/* A texture of a picture's file, with so many levels, or all where this is 0. The caller frees
 * it. */
bool model_read_texture(struct texture *texture, const char *path, size_t level_limit,
                        struct error *error);

/* A normal map, which says in which space it is. One in object space is turned as the model is. */
bool model_read_normal_map(struct texture *texture, const char *path, const int turns[3],
                           struct error *error);

/* A texture of the model, read at the first call. NULL, with a message that names the file that was
 * looked for, when there is none or it cannot be read. The model keeps the texture. */
const struct texture *model_texture(struct model *model, enum model_texture_kind kind,
                                    struct error *error);

#endif
