/*
 * Meshes of triangles, and how their corners are reached. model_file.h reads them.
 *
 * A model is a list of faces of three corners; each corner names a position, a texture coordinate
 * and a normal, each by its own index. Positions are kept in double, so that a model may be far
 * from the origin; all else is rounded to float. The accessors give vectors. Polygons are cut into
 * triangles as they are read, concave ones too (polygon.h). Every index is checked, so every index
 * in a loaded model is valid; every number is finite and within the range of a float, so that
 * products of a few cannot overflow.
 */
#ifndef COMMON_MODEL_H
#define COMMON_MODEL_H

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

/* The textures next to NAME.obj, read when first asked for; also under other usual
 * names, as model_file.c knows them. */
enum model_texture_kind {
    MODEL_DIFFUSE,    /* NAME_diffuse.tga: the colour of the surface */
    MODEL_NORMAL_MAP, /* NAME_nm.tga: level = (coordinate + 1) * 127.5; tangent.h has the spaces */
    MODEL_SPECULAR,   /* NAME_spec.tga: how the surface shines */
    MODEL_TEXTURE_KINDS
};

/* How faces look, as a file of materials says that the model's file names. */
struct model_material {
    char *name;
    float color[3];   /* red green blue 0..1 */
    float ambient[3]; /* the same of its ambient light, where it `has_ambient` */
    bool has_ambient;
    float specular; /* the weight of its shine 0..1 where it has no map; negative: unknown */
    float power;    /* of its shine; 0: unknown */
    bool hidden;    /* altogether transparent */
    bool glassy;    /* transparent in part, though it is drawn opaque */
    size_t line;    /* of the model's file: where it is first */
    char *texture;  /* the path of a picture, whose colours count; NULL: none */
    char *shine;    /* the path of a specular map; NULL: none */
    char *bumps;    /* the path of a normal map; NULL: none */
    float bump;     /* by which its bumps are steeper, 1 at first */
    bool is_norm;   /* the file calls it norm, which is one in tangent space, and not bump */
    bool clamp;     /* the picture, outside 0..1; otherwise it repeats */
    float scale[2], offset[2]; /* of texture coordinates: offset + scale * (u, v) */
    bool known;                /* the file says something of it; otherwise it is white */
};

/* A file of materials, as the model's file names it, and in which of its lines. */
struct model_library {
    char *name;
    size_t line;
};

/* What was wrong with a file that was read all the same; model_warning_text() says it. */
enum model_warning {
    MODEL_SHORT_FACES,
    MODEL_UVS_MISSING,
    MODEL_NORMALS_MISSING,
    MODEL_NORMALS_WRONG,
    MODEL_LIBRARY_MISSING,  /* a file of materials */
    MODEL_MATERIAL_MISSING, /* one that faces name */
    MODEL_GLASSY,
    MODEL_WARNINGS
};

/* All zero is a valid, empty model. Everything in it belongs to it. */
struct model {
    size_t position_count, uv_count, normal_count, face_count, line_count;
    struct vec3 *positions;
    float (*uvs)[2];         /* u v */
    float (*normals)[3];     /* as in the file, of any length; of length 1 where computed */
    float (*colors)[3];      /* red green blue 0..1, one a position; NULL where the file has none */
    float (*face_colors)[3]; /* the same, one a face; model_color() knows which counts */
    bool colors_computed;    /* by model_need_colors(): the file has none */
    struct face *faces;
    struct model_material *materials; /* those that faces name */
    size_t material_count;
    uint32_t *face_groups; /* one a face: of those that share normals; 0: shares none; MODEL_NONE or
                            * NULL: the file does not say */
    bool hard_given;       /* instead of groups: edges sharper than this are hard: normals.h */
    double hard_degrees;
    uint32_t *face_materials; /* one a face, or MODEL_NONE; NULL where the file names none */
    struct model_library *libraries;
    size_t library_count;
    uint32_t (*lines)[2];                /* the positions that they join; only where asked for */
    size_t warning_line[MODEL_WARNINGS]; /* where each is first, from 1; 0: nowhere */
    const char *warning_name[MODEL_WARNINGS]; /* of what is missing; NULL: of nothing */
    char *path;                               /* the file, for messages and for its textures */
    int turns[3]; /* quarter turns around x, y, z since it was read: see fit.h */
    const char *texture_files[MODEL_TEXTURE_KINDS]; /* to read instead; NULL: those next to it */
    struct texture textures[MODEL_TEXTURE_KINDS];   /* empty until first asked for */
    size_t level_limit; /* levels that a diffuse or specular texture gets; 0: all of them */
};

/* Note the line of a warning, and the name of what is missing or NULL, unless the model has that
 * warning already. */
void model_warn(struct model *model, enum model_warning warning, size_t line, const char *name);

/* Free everything and leave an empty model. */
void model_free(struct model *model);

/* The attributes of corner 0, 1 or 2 of a face. A corner without a texture coordinate gives (0,0);
 * one without a normal (0,0,0), but model_need_normals() (normals.h) gives it one; normals are
 * given as stored. */
static inline struct vec3 model_position(const struct model *model, size_t face, size_t corner) {
    return model->positions[model->faces[face].corner[corner].position];
}

static inline struct vec2 model_uv(const struct model *model, size_t face, size_t corner) {
    uint32_t index = model->faces[face].corner[corner].uv;
    if (index == MODEL_NONE) {
        return (struct vec2){0, 0};
    }
    return (struct vec2){model->uvs[index][0], model->uvs[index][1]};
}

static inline struct vec3 model_normal(const struct model *model, size_t face, size_t corner) {
    uint32_t index = model->faces[face].corner[corner].normal;
    if (index == MODEL_NONE) {
        return (struct vec3){0, 0, 0};
    }
    const float *n = model->normals[index];
    return (struct vec3){n[0], n[1], n[2]};
}

/* The colour of a corner, red green blue 0..1: its face's where faces have colours, otherwise its
 * position's where positions have them, otherwise white. */
static inline struct vec3 model_color(const struct model *model, size_t face, size_t corner) {
    const float *color = NULL;
    if (model->face_colors != NULL) {
        color = model->face_colors[face];
    } else if (model->colors != NULL) {
        color = model->colors[model->faces[face].corner[corner].position];
    }
    return color != NULL ? (struct vec3){color[0], color[1], color[2]} : (struct vec3){1, 1, 1};
}

/* Does the file say which colours its faces or positions have? */
static inline bool model_has_colors(const struct model *model) {
    return (model->colors != NULL || model->face_colors != NULL) && !model->colors_computed;
}

#include "given/faces.h"

#endif
