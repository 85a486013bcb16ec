/* Faces seen from both sides: see sides.h. */
#include "files/sides.h"

#include "base/array.h"
#include "files/normals.h"

#include <stdlib.h>

/* ---- Neighbours wound alike ---- */

/* A side of a face, between two positions. */
struct side {
    uint64_t ends; /* the larger one in the lower half */
    uint32_t face;
    bool falls; /* the face goes from that to the other */
};

static int compare_sides(const void *a, const void *b) {
    const struct side *x = a, *y = b;
    return (x->ends > y->ends) - (x->ends < y->ends);
}

static struct side side_of(const struct model *model, uint32_t face, int i) {
    const struct corner *corner = model->faces[face].corner;
    const uint64_t a = corner[i].position, b = corner[(i + 1) % 3].position;
    return (struct side){a < b ? a << 32 | b : b << 32 | a, face, a >= b};
}

/* Faces that are known to be wound alike are a set. Each face is in two of them: by its number as
 * it is, and turned over by its number and that of all faces. Neighbours go along their common side
 * in opposite directions. Where three faces meet, none says anything of another. */
static void join_neighbours(size_t *lower, size_t faces, const struct side *sides) {
    for (size_t begin = 0, end; begin < 3 * faces; begin = end) {
        const struct side *a = &sides[begin];
        for (end = begin + 1; end < 3 * faces && sides[end].ends == a->ends; end++) {
        }
        if (end == begin + 2) {
            bool alike = a[0].falls != a[1].falls;
            sets_join(lower, a[0].face, alike ? a[1].face : a[1].face + faces);
            sets_join(lower, a[0].face + faces, alike ? a[1].face + faces : a[1].face);
        }
    }
}

/* Wind the faces of each connected part as its first one is. */
static bool wind_alike(struct model *model) {
    size_t faces = model->face_count;
    struct side *sides = malloc((3 * faces + 1) * sizeof *sides);
    size_t *lower = calloc(2 * faces + 1, sizeof *lower);
    bool done = sides != NULL && lower != NULL;
    for (size_t i = 0; done && i < 3 * faces; i++) {
        sides[i] = side_of(model, (uint32_t)(i / 3), (int)(i % 3));
    }
    for (size_t i = 0; done && i < 2 * faces; i++) {
        lower[i] = i;
    }
    if (done) {
        qsort(sides, 3 * faces, sizeof *sides, compare_sides);
        join_neighbours(lower, faces, sides);
    }
    for (size_t i = 0; done && i < faces; i++) {
        struct corner *corner = model->faces[i].corner, second = corner[1];
        if (sets_find(lower, i) > sets_find(lower, i + faces)) {
            corner[1] = corner[2];
            corner[2] = second;
        }
    }
    free(sides);
    free(lower);
    return done;
}

/* ---- The other sides ---- */

/* Room for twice as many faces and normals. */
static bool reserve_sides(struct model *model) {
    size_t faces = model->face_count, colors = faces, materials = faces;
    size_t normals = model->normal_count, twice = 2 * faces;
    return faces < MODEL_NONE / 2 && normals < MODEL_NONE / 2 &&
           array_extend(&model->faces, &faces, twice, sizeof *model->faces) &&
           (model->face_colors == NULL ||
            array_extend(&model->face_colors, &colors, twice, sizeof *model->face_colors)) &&
           (model->face_materials == NULL || array_extend(&model->face_materials, &materials, twice,
                                                          sizeof *model->face_materials)) &&
           array_extend(&model->normals, &normals, 2 * normals, sizeof *model->normals);
}

/* Behind the normals, the same with the other direction. */
static void add_opposite_normals(struct model *model) {
    size_t count = model->normal_count;
    for (size_t i = 0; i < 3 * count; i++) {
        model->normals[count + i / 3][i % 3] = -model->normals[i / 3][i % 3];
    }
    model->normal_count = 2 * count;
}

/* Do the normals of a face lie on its inside? */
static bool looks_inwards(const struct model *model, size_t face) {
    struct vec3 outside = model_face_normal(model, face);
    double sum = 0;
    for (size_t i = 0; i < 3; i++) {
        sum += vec3_dot(vec3_normalized(model_normal(model, face, i)), outside);
    }
    return sum < 0;
}

static void turn_face_normals(struct face *face, uint32_t opposite) {
    for (int i = 0; i < 3; i++) {
        uint32_t *normal = &face->corner[i].normal;
        *normal = *normal == MODEL_NONE ? MODEL_NONE : *normal + opposite;
    }
}

/* From the last face on, so that none is overwritten before it is read. */
static void add_other_faces(struct model *model, uint32_t opposite) {
    for (size_t i = model->face_count; i-- > 0;) {
        struct face face = model->faces[i];
        struct face other = {{face.corner[0], face.corner[2], face.corner[1]}};
        turn_face_normals(looks_inwards(model, i) ? &face : &other, opposite);
        model->faces[2 * i] = face;
        model->faces[2 * i + 1] = other;
        for (size_t k = 2; model->face_materials != NULL && k-- > 0;) {
            model->face_materials[2 * i + k] = model->face_materials[i];
        }
        for (size_t k = 6; model->face_colors != NULL && k-- > 0;) {
            model->face_colors[2 * i + k / 3][k % 3] = model->face_colors[i][k % 3];
        }
    }
    model->face_count *= 2;
}

bool model_add_other_sides(struct model *model, bool need_normals, struct error *error) {
    if (need_normals && !wind_alike(model)) {
        return error_out_of_memory(error);
    }
    if (need_normals && !model_need_normals(model, error)) {
        return false;
    }
    if (!reserve_sides(model)) {
        return error_out_of_memory(error);
    }
    uint32_t opposite = (uint32_t)model->normal_count;
    add_opposite_normals(model);
    add_other_faces(model, opposite);
    return true;
}
