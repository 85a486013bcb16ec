/*
 * OFF files, for model_file.c ("OFF Files" in the Geomview manual, Geometry Center, University of
 * Minnesota). What is read of them: see model_file.h.
 *
 * The number of edges may be in the line of the numbers before it, in the next line, or
 * nowhere; colours may follow positions even if the first word does not say so: where it is in
 * doubt, the file is read in the way in which all of it fits. A face ends with its line, since
 * numbers behind its corners are a colour: so of a file that is all one line, only one face can be
 * read, and more are refused.
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
