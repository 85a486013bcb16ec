/* The parts of a model: the faces of each of its materials, with their textures. */
#ifndef COMMON_RUN_PARTS_H
#define COMMON_RUN_PARTS_H

#include "base/error.h"
#include "run/scene.h"

#include <stdbool.h>
#include <stddef.h>

/* A picture that materials name, or the colour of one of them. */
struct picture {
    const char *path;   /* belongs to a material; NULL: of a colour */
    bool is_normal_map; /* read as one; the same file may be a colour, too */
    float tint[3];      /* by which red, green and blue are multiplied; or the colour */
    struct texture texture;
};

/* All zero is valid: a model that is one whole. */
struct parts {
    struct drawing_part *part; /* and behind the last one the whole, as its first part looks */
    size_t count;
    struct picture *pictures; /* each file is read once for each tint */
    size_t picture_count;
    bool with_normal_maps; /* set it before parts_make(), which otherwise reads none */
    bool two_sided;        /* likewise: every face is in the model twice */
    size_t level_limit;    /* likewise: of the pictures, as the model's */
    struct texture atlas;  /* of faces that have colours and no picture; or empty */
    struct error note;     /* of the first normal map that was not read, or else was guessed */
    bool is_note_of_guess;
};

/* Sort the model's faces by their materials and make a part of the faces of each; hidden ones get
 * none. A texture that cannot be read is replaced by the material's colour: `missing`, which is
 * empty at first, says so of the first of them. Parts share what the model has, so make them when
 * it changes no more. False when memory runs out. */
bool parts_make(struct parts *parts, struct model *model, struct error *missing,
                struct error *error);

/* How often a picture is repeated across the model, if all of its surface had as many pictures to
 * an area as these faces: 1 for a picture that goes once around. Not a number where there is no
 * surface. */
double parts_repeats(const struct model *faces, const struct model *whole, bool two_sided);

/* Make texture coordinates for materials that scale or move them. Once, before the parts. False
 * when memory runs out. */
bool parts_move_coordinates(struct model *model, struct error *error);

void parts_free(struct parts *parts);

#endif
