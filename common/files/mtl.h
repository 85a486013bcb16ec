/*
 * Files of materials that OBJ files name, for model_file.c (Wavefront Technologies, "Advanced
 * Visualizer Manual", appendix B2 "Materials"). What is read: newmtl, Kd, map_Kd with -clamp, -s
 * and -o, Ks, Ns, map_Ks or map_Ns, norm or else map_Bump or bump, and d where it is 0: such faces
 * are not drawn. Everything else is skipped, also what cannot be read: what is transparent in
 * part is opaque, and Tr, which some write as 1 - d and others as d, does not count.
 */
#ifndef COMMON_MTL_H
#define COMMON_MTL_H

#include "base/error.h"
#include "model.h"

#include <stddef.h>

/* Give the model's materials what the text says of them; the last word counts. `directory` ("" or
 * one that ends with '/') comes before the names of textures. False when memory runs out. */
bool mtl_decode(struct model *model, const void *data, size_t size, const char *directory,
                struct error *error);

#endif
