/*
 * Meshes of triangles, read from OBJ and OFF files, with the textures that lie beside them.
 *
 * A model is a list of faces of three corners; each corner names a position, a texture coordinate
 * and a normal, each by its own index. Arrays hold the files' floats; the accessors give vectors.
 * Polygons are cut into triangles as they are read, concave ones too. Every index is checked, so
 * every index in a loaded model is valid; every number is finite.
 *
 * OBJ: v (x y z, x y z w: w is not used, x y z r g b: colours are cut to 0..1), vt (u, u v, u v w:
 * w is not used), vn and f; all other keywords are passed over. A face may name what comes further
 * down; a negative index counts back from the face. OFF, COFF, NOFF, STOFF and their mixtures, as
 * text; colours of faces are not used. A concave face has at most 131,072 corners.
 */
#ifndef COMMON_MODEL_H
#define COMMON_MODEL_H

#include "file.h"
#include "geometry.h"
#include "texture.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define MODEL_NONE UINT32_MAX /* a corner without this attribute */

/* A corner of a face: indices from 0. */
struct corner {
    uint32_t position; /* below position_count */
    uint32_t uv;       /* below uv_count, or MODEL_NONE */
    uint32_t normal;   /* below normal_count, or MODEL_NONE until model_need_normals() */
};

struct face {
    struct corner corner[3]; /* counterclockwise as seen from outside */
};

/* The textures that may lie beside NAME.obj, read when first asked for. */
enum model_texture_kind {
    MODEL_DIFFUSE,    /* NAME_diffuse.tga or .png: the colour of the surface */
    MODEL_NORMAL_MAP, /* NAME_nm.tga or .png: object-space normals, level = (coordinate + 1) * 127.5
                       */
    MODEL_SPECULAR,   /* NAME_spec.tga or .png: how the surface shines */
    MODEL_TEXTURE_KINDS
};

/* All zero is a valid, empty model. Everything in it belongs to it. */
struct model {
    size_t position_count, uv_count, normal_count, face_count;
    float (*positions)[3]; /* x y z */
    float (*uvs)[2];       /* u v */
    float (*normals)[3];   /* as in the file, of any length; of length 1 where computed */
    float (*colors)[3];    /* red green blue 0..1, one a position; NULL where the file has none */
    struct face *faces;
    char *path;                                   /* the file, for messages and for its textures */
    struct texture textures[MODEL_TEXTURE_KINDS]; /* empty until first asked for */
};

/* Read an OBJ or OFF file, told apart by the contents ("OFF", "COFF", ... as the first word means
 * OFF). On an error `model` is empty and the message names the file and the line. */
bool model_read(struct model *model, const char *path, struct error *error);

/* The same from memory (for tests and fuzzing); messages do not name the file. */
bool model_decode(struct model *model, const void *data, size_t size, struct error *error);

/* Free everything and leave an empty model. */
void model_free(struct model *model);

/* The attributes of corner 0, 1 or 2 of a face. A corner without a texture coordinate gives (0,0);
 * normals are given as stored: call model_need_normals() first. */
static inline struct vec3 model_position(const struct model *model, size_t face, size_t corner) {
    const float *p = model->positions[model->faces[face].corner[corner].position];
    return (struct vec3){p[0], p[1], p[2]};
}

static inline struct vec2 model_uv(const struct model *model, size_t face, size_t corner) {
    uint32_t index = model->faces[face].corner[corner].uv;
    if (index == MODEL_NONE) {
        return (struct vec2){0, 0};
    }
    return (struct vec2){model->uvs[index][0], model->uvs[index][1]};
}

static inline struct vec3 model_normal(const struct model *model, size_t face, size_t corner) {
    const float *n = model->normals[model->faces[face].corner[corner].normal];
    return (struct vec3){n[0], n[1], n[2]};
}

/* The angle between two vectors in radians, 0..pi, to 1e-15 of pi; 0 where one has no length. The
 * same bits on every machine, unlike acos() of the C library. (From the lengths of the difference
 * and the sum of the unit vectors, which is accurate for all angles: Kahan, "How Futile are
 * Mindless Assessments of Roundoff in Floating-Point Computation?", 2006, section 12.) */
double model_angle(struct vec3 a, struct vec3 b);

/* Give a normal to every corner that has none: the mean of the normals of the faces around its
 * position, weighted by the angle of each face there (Thuermer and Wuethrich, "Computing vertex
 * normals from polygonal facets", 1998), of length 1. Where all of them cancel, (0,0,1). */
bool model_need_normals(struct model *model, struct error *error);

/* Give every position the colour (normal + 1) / 2 of its normal, for models without a texture.
 * Where corners of several normals meet, the first face decides; a position without a face becomes
 * grey. */
bool model_colors_from_normals(struct model *model, struct error *error);

/* A texture of the model, read at the first call. NULL, with a message that names the file that was
 * looked for, when there is none or it cannot be read. The model keeps the texture. */
const struct texture *model_texture(struct model *model, enum model_texture_kind kind,
                                    struct error *error);

#endif
