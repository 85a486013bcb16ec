/* A picture of the colours that a model's faces or positions have, so that scenes which draw
 * textures draw these, too. */
#ifndef COMMON_RUN_ATLAS_H
#define COMMON_RUN_ATLAS_H

#include "base/error.h"
#include "model.h"

#include <stdbool.h>
#include <stdint.h>

/* Make a texture of one level in which each face that is `painted` (NULL: all are) has its own
 * place, and give these faces coordinates there instead of those that they have. Between the
 * corners colours are interpolated; a material that is not grey tints them. The caller frees the
 * texture. False when memory runs out, or when there are too many faces for a texture. */
bool atlas_make(struct texture *atlas, struct model *model, const uint8_t *painted,
                struct error *error);

/* The colour by which a material's own one multiplies others. A grey one does not: exporters write
 * 0.64, 0.8 and even 0 with every picture, and mean nothing by it. */
void find_tint(const float color[3], float tint[3]);

#endif
