/* Faces seen from both sides, for files in which some look outwards and some inwards. */
#ifndef COMMON_FILES_SIDES_H
#define COMMON_FILES_SIDES_H

#include "base/error.h"
#include "model.h"

#include <stdbool.h>

/* Put behind each face another one that looks the other way, so that one of the two is seen from
 * everywhere; its normals do so, too. Corners that have no normal get one first where that is asked
 * for: the faces around them are then taken as if they all looked to the same side. */
bool model_add_other_sides(struct model *model, bool need_normals, struct error *error);

#endif
