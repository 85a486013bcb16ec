/*
 * Files of materials that OBJ files name, for model_file.c (Wavefront Technologies, "Advanced
 * Visualizer Manual", appendix B2 "Materials"). What is read: newmtl, Kd and map_Kd, over its
 * options; all else is passed over, and so is what cannot be read.
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
