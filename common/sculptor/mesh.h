/* A mesh on its way into a file, and the files' text. */
#ifndef COMMON_SCULPTOR_MESH_H
#define COMMON_SCULPTOR_MESH_H

#include "base/error.h"
#include "sculptor/clay.h"
#include "sculptor/simplify.h"
#include "sculptor/surface.h"

#include <stdbool.h>
#include <stddef.h>

struct mesh_corner {
    int place, uv, normal; /* indices from 0 */
};

/* All zero is a valid, empty mesh. */
struct mesh {
    struct vec3 *places;
    double (*uvs)[2];
    struct vec3 *normals;
    struct mesh_corner (*faces)[3]; /* counterclockwise seen from outside */
    int place_count, uv_count, normal_count, face_count;
};

/* Room for that many of each, and none in use; false when memory runs out. */
bool mesh_create(struct mesh *mesh, int places, int uvs, int normals, int faces);
void mesh_free(struct mesh *mesh);

/* Each returns the new index. The room that mesh_create() made must suffice. */
int mesh_add_place(struct mesh *mesh, struct vec3 place);
int mesh_add_uv(struct mesh *mesh, double u, double v);
int mesh_add_normal(struct mesh *mesh, struct vec3 normal);
void mesh_add_face(struct mesh *mesh, struct mesh_corner a, struct mesh_corner b,
                   struct mesh_corner c);

/* Both halves of the bust from the triangles of one half. */
bool mesh_from_surface(struct mesh *mesh, const struct surface *surface,
                       const struct grid_triangle *triangles, size_t count);

/* Write the comment line and the mesh: an OBJ file, or OFF where it has no texture coordinates. */
bool mesh_write(const struct mesh *mesh, const char *comment, const char *path,
                struct error *error);

#endif
