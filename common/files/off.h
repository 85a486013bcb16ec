/*
 * OFF files, for model_file.c ("OFF Files" in the Geomview manual, Geometry Center, University of
 * Minnesota). What is read of them: see model_file.h. What a file may leave open: see off.c; where
 * it is in doubt, the file is read in the way in which all of it fits.
 */
#ifndef COMMON_FILES_OFF_H
#define COMMON_FILES_OFF_H

#include "model.h"

#include <stdbool.h>
#include <stddef.h>

/* Is this an OFF file? Its first word says so, or is a whole number: some leave the word out. */
bool off_recognize(const void *data, size_t size);

/* Read what off_recognize() accepts into an empty model, which stays empty on an error; of the
 * parts only MODEL_LINES counts. Messages do not name the file. */
bool off_decode(struct model *model, const void *data, size_t size, unsigned parts,
                struct error *error);

#endif
