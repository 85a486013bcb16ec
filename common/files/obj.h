/*
 * OBJ files, for model_file.c (Wavefront Technologies, "Advanced Visualizer Manual", appendix B1
 * "Object Files (.obj)"). What is read of them: see model_file.h.
 */
#ifndef COMMON_FILES_OBJ_H
#define COMMON_FILES_OBJ_H

#include "model.h"

#include <stdbool.h>
#include <stddef.h>

/* Read into an empty model, which is left half-read on an error; messages do not name the file. */
bool obj_decode(struct model *model, const void *data, size_t size, unsigned parts,
                struct error *error);

#endif
