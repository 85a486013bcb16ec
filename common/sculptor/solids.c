/* Sphere and knot: see solids.h. */
#include "sculptor/solids.h"

/* A quadrilateral as two triangles. */
static void add_quad(struct mesh *mesh, struct mesh_corner a, struct mesh_corner b,
                     struct mesh_corner c, struct mesh_corner d) {
    mesh_add_face(mesh, a, b, c);
    mesh_add_face(mesh, a, c, d);
}

/* The sphere's directions: south pole, rings from south to north, north pole. */
static void add_sphere_points(struct mesh *mesh, double radius, int segments, int rings) {
    mesh_add_normal(mesh, at(0, -1, 0));
    for (int j = 1; j < rings; j++) {
        struct vec2 tilt = turn_direction(0.5 * j / rings - 0.25);
        for (int i = 0; i < segments; i++) {
            struct vec2 turn = turn_direction((double)i / segments - 0.5);
            mesh_add_normal(mesh, at(tilt.x * turn.y, tilt.y, tilt.x * turn.x));
        }
    }
    mesh_add_normal(mesh, at(0, 1, 0));
    for (int i = 0; i < mesh->normal_count; i++) {
        mesh_add_place(mesh, vec3_scale(mesh->normals[i], radius));
    }
}

static void add_sphere_uvs(struct mesh *mesh, int segments, int rings) {
    for (int j = 0; j <= rings; j++) {
        /* A pole has a u for each of its triangles, midway between its partners'. */
        double shift = j == 0 || j == rings ? 0.5 : 0;
        for (int i = 0; i <= segments; i++) {
            mesh_add_uv(mesh, clamp((i + shift) / segments, 0, 1), (double)j / rings);
        }
    }
}

static void add_sphere_faces(struct mesh *mesh, int segments, int rings) {
    int north = 1 + segments * (rings - 1);
    for (int j = 0; j < rings; j++) {
        for (int i = 0; i < segments; i++) {
            int next = (i + 1) % segments, low = 1 + (j - 1) * segments, high = low + segments;
            int uv = j * (segments + 1) + i, uv_high = uv + segments + 1;
            struct mesh_corner a = {low + i, uv, low + i}, b = {low + next, uv + 1, low + next};
            struct mesh_corner c = {high + next, uv_high + 1, high + next};
            struct mesh_corner d = {high + i, uv_high, high + i};
            if (j == 0) {
                mesh_add_face(mesh, (struct mesh_corner){0, uv, 0}, c, d);
            } else if (j == rings - 1) {
                mesh_add_face(mesh, a, b, (struct mesh_corner){north, uv_high, north});
            } else {
                add_quad(mesh, a, b, c, d);
            }
        }
    }
}

bool solid_sphere(struct mesh *mesh, int segments, int rings) {
    int points = segments * (rings - 1) + 2;
    if (!mesh_create(mesh, points, (segments + 1) * (rings + 1), points,
                     2 * segments * (rings - 1))) {
        return false;
    }
    add_sphere_points(mesh, 0.9, segments, rings);
    add_sphere_uvs(mesh, segments, rings);
    add_sphere_faces(mesh, segments, rings);
    return true;
}

/* The trefoil: twice around the middle while going three times up and down. */
static struct vec3 trefoil(double share) {
    struct vec2 around = turn_direction(2 * share), wave = turn_direction(3 * share);
    double reach = 0.5 + 0.21 * wave.x;
    return at(reach * around.x, reach * around.y, 0.26 * wave.y);
}

/* The centre of the tube and two unit vectors across it. */
struct frame {
    struct vec3 center, across, up;
};

static struct frame trefoil_at(double share) {
    struct vec3 center = trefoil(share);
    struct vec3 along = vec3_normalized(vec3_sub(trefoil(share + 1e-3), trefoil(share - 1e-3)));
    /* `across` points away from the middle, which the knot never passes through. */
    struct vec3 out = {center.x, center.y, 0};
    struct vec3 across = vec3_normalized(vec3_sub(out, vec3_scale(along, vec3_dot(out, along))));
    return (struct frame){center, across, vec3_cross(across, along)};
}

bool solid_knot(struct mesh *mesh, int segments, int rings) {
    if (!mesh_create(mesh, segments * rings, 1, 1, 2 * segments * rings)) {
        return false;
    }
    for (int i = 0; i < segments; i++) {
        struct frame frame = trefoil_at((double)i / segments);
        for (int j = 0; j < rings; j++) {
            struct vec2 turn = turn_direction((double)j / rings);
            struct vec3 out =
                vec3_add(vec3_scale(frame.across, turn.x), vec3_scale(frame.up, turn.y));
            mesh_add_place(mesh, vec3_add(frame.center, vec3_scale(out, 0.15)));
        }
    }
    for (int i = 0; i < segments; i++) {
        for (int j = 0; j < rings; j++) {
            int here = i * rings, there = (i + 1) % segments * rings, above = (j + 1) % rings;
            const struct mesh_corner a = {.place = here + j}, b = {.place = there + j};
            const struct mesh_corner c = {.place = there + above}, d = {.place = here + above};
            add_quad(mesh, a, b, c, d);
        }
    }
    return true;
}
