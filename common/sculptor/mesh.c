/* Meshes put together and written: see mesh.h. */
#include "sculptor/mesh.h"

#include "base/bytes.h"
#include "base/file.h"

#include <stdlib.h>
#include <string.h>

bool mesh_create(struct mesh *mesh, int places, int uvs, int normals, int faces) {
    memset(mesh, 0, sizeof *mesh);
    mesh->places = calloc((size_t)places, sizeof *mesh->places);
    mesh->uvs = calloc((size_t)uvs, sizeof *mesh->uvs);
    mesh->normals = calloc((size_t)normals, sizeof *mesh->normals);
    mesh->faces = calloc((size_t)faces, sizeof *mesh->faces);
    if (mesh->places == NULL || mesh->uvs == NULL || mesh->normals == NULL || mesh->faces == NULL) {
        mesh_free(mesh);
        return false;
    }
    return true;
}

void mesh_free(struct mesh *mesh) {
    free(mesh->places);
    free(mesh->uvs);
    free(mesh->normals);
    free(mesh->faces);
    memset(mesh, 0, sizeof *mesh);
}

int mesh_add_place(struct mesh *mesh, struct vec3 place) {
    mesh->places[mesh->place_count] = place;
    return mesh->place_count++;
}

int mesh_add_uv(struct mesh *mesh, double u, double v) {
    mesh->uvs[mesh->uv_count][0] = u;
    mesh->uvs[mesh->uv_count][1] = v;
    return mesh->uv_count++;
}

int mesh_add_normal(struct mesh *mesh, struct vec3 normal) {
    mesh->normals[mesh->normal_count] = normal;
    return mesh->normal_count++;
}

void mesh_add_face(struct mesh *mesh, struct mesh_corner a, struct mesh_corner b,
                   struct mesh_corner c) {
    struct mesh_corner *face = mesh->faces[mesh->face_count++];
    face[0] = a;
    face[1] = b;
    face[2] = c;
}

/* ---- Both halves of the bust ---- */

enum { LEFT, RIGHT, NOT_YET = -1, BASE_NORMAL = 0 };

/* What a grid point has become in the mesh on either side. Where both sides share it, that on the
 * left counts; NOT_YET until it is needed. Normal i + 1 is that of place i. */
struct grid_corner {
    int place[2], uv[2];
};

static struct mesh_corner add_grid_corner(struct mesh *mesh, const struct surface *surface,
                                          int vertex, int side, struct grid_corner *made) {
    int column = surface_column(surface, vertex), row = surface_row(surface, vertex);
    int *place = &made->place[surface_is_in_mirror(surface, vertex) ? LEFT : side];
    int *uv = &made->uv[column == 0 ? LEFT : side];
    if (*place == NOT_YET) {
        struct vec3 p = surface->points[vertex].place;
        p.x = side == LEFT ? p.x : -p.x;
        *place = mesh_add_place(mesh, p);
        mesh_add_normal(mesh, (struct vec3){0, 0, 0});
    }
    if (*uv == NOT_YET && !surface_is_pole(surface, vertex)) {
        double u = 0.5 * column / surface->columns;
        *uv = mesh_add_uv(mesh, side == LEFT ? 0.5 + u : 0.5 - u, (double)row / surface->rows);
    }
    return (struct mesh_corner){.place = *place, .uv = *uv, .normal = *place + 1};
}

static void add_grid_triangle(struct mesh *mesh, const struct surface *surface,
                              const struct grid_triangle *triangle, int side,
                              struct grid_corner *corners) {
    struct mesh_corner made[3];
    bool flat_base = true;
    for (int k = 0; k < 3; k++) {
        int vertex = triangle->corner[k];
        made[k] = add_grid_corner(mesh, surface, vertex, side, &corners[vertex]);
        flat_base &= surface_row(surface, vertex) <= SURFACE_BASE_ROWS;
    }
    for (int k = 0; k < 3; k++) {
        if (surface_is_pole(surface, triangle->corner[k])) {
            /* A pole has no u: it takes the middle of its partners'. */
            const double *a = mesh->uvs[made[(k + 1) % 3].uv], *b = mesh->uvs[made[(k + 2) % 3].uv];
            made[k].uv = mesh_add_uv(mesh, (a[0] + b[0]) / 2, triangle->corner[k] == 0 ? 0 : 1);
        }
        if (flat_base) {
            made[k].normal = BASE_NORMAL;
        }
    }
    mesh_add_face(mesh, made[0], side == LEFT ? made[1] : made[2],
                  side == LEFT ? made[2] : made[1]);
}

/* Each normal becomes the weighted mean of those of the faces that name it (Nelson Max, "Weights
 * for computing vertex normals from facet normals", 1999: exact on a sphere; needs no angle). */
static void average_normals(struct mesh *mesh) {
    for (int i = 0; i < mesh->face_count; i++) {
        const struct mesh_corner *face = mesh->faces[i];
        for (int k = 0; k < 3; k++) {
            struct vec3 place = mesh->places[face[k].place];
            struct vec3 a = vec3_sub(mesh->places[face[(k + 1) % 3].place], place);
            struct vec3 b = vec3_sub(mesh->places[face[(k + 2) % 3].place], place);
            struct vec3 *sum = &mesh->normals[face[k].normal];
            if (face[k].normal != BASE_NORMAL) {
                double weight = 1 / (vec3_dot(a, a) * vec3_dot(b, b));
                *sum = vec3_add(*sum, vec3_scale(vec3_cross(a, b), weight));
            }
        }
    }
    for (int i = 0; i < mesh->normal_count; i++) {
        mesh->normals[i] = vec3_normalized(mesh->normals[i]);
    }
}

/* In a sharp fold the mean of the faces may look away from one of them: turn it until it agrees. */
static void turn_normals_to_faces(struct mesh *mesh) {
    for (int round = 0; round < 40; round++) {
        for (int i = 0; i < mesh->face_count; i++) {
            const struct mesh_corner *face = mesh->faces[i];
            struct vec3 a = mesh->places[face[0].place];
            struct vec3 out = vec3_normalized(vec3_cross(vec3_sub(mesh->places[face[1].place], a),
                                                         vec3_sub(mesh->places[face[2].place], a)));
            for (int k = 0; k < 3; k++) {
                struct vec3 *normal = &mesh->normals[face[k].normal];
                double agreement = vec3_dot(out, *normal);
                if (agreement < 0.05 && face[k].normal != BASE_NORMAL) {
                    *normal = vec3_add(*normal, vec3_scale(out, 0.06 - agreement));
                    *normal = vec3_normalized(*normal);
                }
            }
        }
    }
}

bool mesh_from_surface(struct mesh *mesh, const struct surface *surface,
                       const struct grid_triangle *triangles, size_t count) {
    size_t grid = ((size_t)surface->columns + 1) * ((size_t)surface->rows + 1);
    struct grid_corner *corners = malloc(grid * sizeof *corners);
    int faces = 2 * (int)count, room = 3 * faces + 1;
    if (corners == NULL || !mesh_create(mesh, room, room, room, faces)) {
        free(corners);
        return false;
    }
    for (size_t i = 0; i < grid; i++) {
        corners[i] = (struct grid_corner){{NOT_YET, NOT_YET}, {NOT_YET, NOT_YET}};
    }
    mesh_add_normal(mesh, (struct vec3){0, -1, 0}); /* BASE_NORMAL */
    for (int side = LEFT; side <= RIGHT; side++) {
        for (size_t i = 0; i < count; i++) {
            add_grid_triangle(mesh, surface, &triangles[i], side, corners);
        }
    }
    free(corners);
    average_normals(mesh);
    turn_normals_to_faces(mesh);
    return true;
}

/* ---- Files ---- */

/* Rounded to six decimals here, so that every C library prints the same digits. */
static double millionths(double value) {
    return floor(value * 1e6 + 0.5) / 1e6;
}

/* A line, which begins with `start`. */
static bool append_point(struct bytes *out, const char *start, struct vec3 p) {
    return bytes_print(out, "%s%.6f %.6f %.6f\n", start, millionths(p.x), millionths(p.y),
                       millionths(p.z));
}

static bool append_obj(struct bytes *out, const struct mesh *mesh, const char *comment) {
    bool done = bytes_print(out, "# %s\n", comment);
    for (int i = 0; done && i < mesh->place_count; i++) {
        done = append_point(out, "v ", mesh->places[i]);
    }
    for (int i = 0; done && i < mesh->uv_count; i++) {
        const double *uv = mesh->uvs[i];
        done = bytes_print(out, "vt %.6f %.6f\n", millionths(uv[0]), millionths(uv[1]));
    }
    for (int i = 0; done && i < mesh->normal_count; i++) {
        done = append_point(out, "vn ", mesh->normals[i]);
    }
    for (int i = 0; done && i < mesh->face_count; i++) {
        const struct mesh_corner *f = mesh->faces[i];
        done = bytes_print(out, "f %d/%d/%d %d/%d/%d %d/%d/%d\n", f[0].place + 1, f[0].uv + 1,
                           f[0].normal + 1, f[1].place + 1, f[1].uv + 1, f[1].normal + 1,
                           f[2].place + 1, f[2].uv + 1, f[2].normal + 1);
    }
    return done;
}

static bool append_off(struct bytes *out, const struct mesh *mesh, const char *comment) {
    bool done =
        bytes_print(out, "OFF\n# %s\n%d %d 0\n", comment, mesh->place_count, mesh->face_count);
    for (int i = 0; done && i < mesh->place_count; i++) {
        done = append_point(out, "", mesh->places[i]);
    }
    for (int i = 0; done && i < mesh->face_count; i++) {
        const struct mesh_corner *f = mesh->faces[i];
        done = bytes_print(out, "3 %d %d %d\n", f[0].place, f[1].place, f[2].place);
    }
    return done;
}

bool mesh_write(const struct mesh *mesh, const char *comment, const char *path,
                struct error *error) {
    struct bytes text = {0};
    bool done =
        mesh->uv_count > 0 ? append_obj(&text, mesh, comment) : append_off(&text, mesh, comment);
    if (!done) {
        error_out_of_memory(error);
    }
    return file_write_encoded(path, done, &text, error);
}
