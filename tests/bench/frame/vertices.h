/*
 * A model as OpenGL wants it: one index a corner, for all attributes together. As many corners
 * share a vertex as can.
 */
#ifndef TESTS_BENCH_FRAME_VERTICES_H
#define TESTS_BENCH_FRAME_VERTICES_H

#include "scene.h"

#include <stdint.h>

struct vertex {
    float position[3];
    float normal[3];
    float uv[2];
};

struct vertices {
    struct vertex *vertices;
    uint32_t *indices; /* three a face */
    size_t vertex_count, index_count;
};

/* Corners share a vertex where position, texture coordinate and normal are the same. */
void vertices_smooth(struct vertices *vertices, const struct frame_model *head);

/* Corners share a vertex where the position is the same; the normal of a face is that of its last
 * vertex, which is last in no other face. So flat shading costs few vertices more: a closed mesh
 * has twice as many faces as positions, and needs just as many vertices as faces. */
void vertices_flat(struct vertices *vertices, const struct frame_model *head);

void vertices_free(struct vertices *vertices);

#endif
