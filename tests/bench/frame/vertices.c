/* A model as OpenGL wants it: see vertices.h. */
#include "vertices.h"

#include "bench/memory.h"
#include "pairs.h"

#include <string.h>

static void allocate(struct vertices *v, size_t vertices_most, size_t faces) {
    *v = (struct vertices){
        .vertices = bench_memory(vertices_most, sizeof *v->vertices),
        .indices = bench_memory(3 * faces, sizeof *v->indices),
    };
}

void vertices_free(struct vertices *v) {
    free(v->vertices);
    free(v->indices);
    *v = (struct vertices){0};
}

static void set_position(struct vertex *vertex, struct vec3 position) {
    vertex->position[0] = (float)position.x;
    vertex->position[1] = (float)position.y;
    vertex->position[2] = (float)position.z;
}

static struct vertex vertex_at(const struct model *model, size_t face, size_t corner) {
    struct vertex vertex;
    struct vec2 uv = model_uv(model, face, corner);
    set_position(&vertex, model_position(model, face, corner));
    memcpy(vertex.normal, model->normals[model->faces[face].corner[corner].normal],
           sizeof vertex.normal);
    vertex.uv[0] = (float)uv.x;
    vertex.uv[1] = (float)uv.y;
    return vertex;
}

void vertices_smooth(struct vertices *v, const struct frame_model *head) {
    const struct model *model = &head->model;
    size_t corners = 3 * model->face_count;
    struct pairs placed = pairs_create(corners), whole = pairs_create(corners);
    allocate(v, corners, model->face_count);
    for (size_t i = 0; i < corners; i++) {
        const struct corner *corner = &model->faces[i / 3].corner[i % 3];
        uint32_t place = pairs_number(&placed, corner->position, corner->uv);
        uint32_t number = pairs_number(&whole, place, corner->normal);
        if (number == v->vertex_count) {
            v->vertices[v->vertex_count++] = vertex_at(model, i / 3, i % 3);
        }
        v->indices[v->index_count++] = number;
    }
    pairs_free(&placed);
    pairs_free(&whole);
}

/* The corner of a face that is last in no face yet; 2 where there is none. */
static int free_corner(const bool *is_last, const struct face *face) {
    int corner = 2;
    while (corner > 0 && is_last[face->corner[corner].position]) {
        corner--;
    }
    return is_last[face->corner[corner].position] ? 2 : corner;
}

/* Vertices 0 to position_count - 1 are the positions; copies follow. */
static void add_flat_face(struct vertices *v, const struct frame_model *head, size_t face,
                          bool *is_last) {
    const struct corner *corner = head->model.faces[face].corner;
    int last = free_corner(is_last, &head->model.faces[face]);
    uint32_t number = corner[last].position;
    if (is_last[number]) {
        v->vertices[v->vertex_count] = v->vertices[number];
        number = (uint32_t)v->vertex_count++;
    } else {
        is_last[number] = true;
    }
    memcpy(v->vertices[number].normal, head->face_normals[face], sizeof(float[3]));
    v->indices[v->index_count++] = corner[(last + 1) % 3].position;
    v->indices[v->index_count++] = corner[(last + 2) % 3].position;
    v->indices[v->index_count++] = number;
}

void vertices_flat(struct vertices *v, const struct frame_model *head) {
    const struct model *model = &head->model;
    bool *is_last = bench_memory(model->position_count, sizeof *is_last);
    allocate(v, model->position_count + model->face_count, model->face_count);
    for (size_t i = 0; i < model->position_count; i++) {
        set_position(&v->vertices[i], model->positions[i]);
    }
    v->vertex_count = model->position_count;
    for (size_t i = 0; i < model->face_count; i++) {
        add_flat_face(v, head, i, is_last);
    }
    free(is_last);
}
