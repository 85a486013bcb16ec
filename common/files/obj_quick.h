/*
 * OBJ files as nearly all are, in one pass over their bytes; private to obj.c.
 *
 * What is rare (continued lines, colours, a face that names what comes further down) and whatever
 * is wrong is declined: obj.c then reads the file again from its beginning in the careful way,
 * which knows all of the format and every message. A model read here is the same to the last bit.
 */
#ifndef COMMON_OBJ_QUICK_H
#define COMMON_OBJ_QUICK_H

#include "files/model_reader.h"

#include <stddef.h>

enum obj_quick_result {
    OBJ_QUICK_DONE,
    OBJ_QUICK_DECLINED,     /* the model may be half-read */
    OBJ_QUICK_OUT_OF_MEMORY /* with the message */
};

enum obj_quick_result obj_quick_read(struct model_reader *reader, const char *data, size_t size);

#endif
