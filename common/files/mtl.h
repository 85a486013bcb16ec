/*
 * Files of materials that OBJ files name, for model_file.c (Wavefront Technologies, "Advanced
 * Visualizer Manual", appendix B2 "Materials"). What is read: newmtl, Kd, Ka, map_Kd with -clamp,
 * -s and -o, Ks, Ns, map_Ks or map_Ns, norm or else map_Bump or bump with -bm, and d where it is 0:
 * such faces are not drawn. What is transparent in part (d and Tr, which some write as 1 - d and
 * others as d, between 0 and 1, or map_d) is opaque, with a warning. All else is passed over, and
 * so is what cannot be read.
 */
#ifndef COMMON_FILES_MTL_H
#define COMMON_FILES_MTL_H

#include "base/error.h"
#include "model.h"

#include <stddef.h>

/* Give the model's materials what the text at `path` says of them; the last word counts. Textures
 * are looked for next to it. False when memory runs out. */
bool mtl_decode(struct model *model, const void *data, size_t size, const char *path,
                struct error *error);

#endif
