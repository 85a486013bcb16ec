/* Are two models the same, to the last bit? For tests that read a file in two ways. */
#ifndef TESTS_SAME_MODEL_H
#define TESTS_SAME_MODEL_H

#include "model.h"

#include <string.h>

static inline bool same_array(const void *a, const void *b, size_t size) {
    return (a == NULL) == (b == NULL) && (a == NULL || memcmp(a, b, size) == 0);
}

static inline bool same_model(const struct model *a, const struct model *b) {
    return a->position_count == b->position_count && a->uv_count == b->uv_count &&
           a->normal_count == b->normal_count && a->face_count == b->face_count &&
           same_array(a->positions, b->positions, a->position_count * sizeof *a->positions) &&
           same_array(a->uvs, b->uvs, a->uv_count * sizeof *a->uvs) &&
           same_array(a->normals, b->normals, a->normal_count * sizeof *a->normals) &&
           same_array(a->colors, b->colors, a->position_count * sizeof *a->colors) &&
           same_array(a->faces, b->faces, a->face_count * sizeof *a->faces);
}

#endif
