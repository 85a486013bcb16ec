/*
 * Sculpts the course's own model: sculpt DIR [COARSER]
 *
 * Writes into DIR: bust.obj with bust_diffuse.tga, bust_nm.tga and bust_spec.tga, and two plain
 * solids, sphere.obj and knot.off. All are closed, face outwards and lie within -1..1. COARSER, 1
 * to 8, divides the columns, rows, faces and texels of the bust, where a processor is emulated.
 *
 *   head.c      the bust as a solid of clay: where clay is and where not
 *   surface.c   rays from inside find its surface, as a fine grid over the texture
 *   simplify.c  the grid becomes few triangles, small where the shape is fine
 *   mesh.c      both halves put together, and the files' text
 *   skin.c      pores, hair and colours, one texel at a time
 *   solids.c    the plain solids
 *   clay.h      round solids, bumps and noise for all of these
 */
#include "sculptor/mesh.h"
#include "sculptor/simplify.h"
#include "sculptor/skin.h"
#include "sculptor/solids.h"
#include "sculptor/surface.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    TEXTURE_SIZE = 1024,
    FINE_COLUMNS = 224, /* of half the surface */
    FINE_ROWS = 448,
    HALF_FACES = 2490 /* of the bust */
};

/* "DIR/name" */
struct path {
    char text[4096];
};

static struct path path_in(const char *directory, const char *name) {
    struct path path;
    snprintf(path.text, sizeof path.text, "%s/%s", directory, name);
    return path;
}

static bool write_mesh_of_bust(const struct surface *surface, int coarser, const char *directory,
                               struct error *error) {
    struct grid_triangle *triangles = NULL;
    size_t count;
    struct mesh mesh = {0};
    bool done = (simplify(surface, (size_t)(HALF_FACES / coarser), &triangles, &count) &&
                 mesh_from_surface(&mesh, surface, triangles, count)) ||
                error_set(error, "out of memory for the bust");
    done = done && mesh_write(&mesh, "A bust, sculpted by common/sculptor/sculpt.c",
                              path_in(directory, "bust.obj").text, error);
    mesh_free(&mesh);
    free(triangles);
    return done;
}

static bool write_bust(int coarser, const char *directory, struct error *error) {
    struct surface surface;
    if (!surface_create(&surface, FINE_COLUMNS / coarser, FINE_ROWS / coarser)) {
        return error_set(error, "out of memory for the bust");
    }
    struct skin skin = {0};
    bool done = write_mesh_of_bust(&surface, coarser, directory, error) &&
                skin_create(&skin, &surface, (size_t)(TEXTURE_SIZE / coarser), error) &&
                tga_write(&skin.diffuse, path_in(directory, "bust_diffuse.tga").text, error) &&
                tga_write(&skin.normals, path_in(directory, "bust_nm.tga").text, error) &&
                tga_write(&skin.specular, path_in(directory, "bust_spec.tga").text, error);
    skin_free(&skin);
    surface_free(&surface);
    return done;
}

static bool write_solids(const char *directory, struct error *error) {
    struct mesh mesh;
    bool done = solid_sphere(&mesh, 48, 24) || error_set(error, "out of memory for the sphere");
    done = done && mesh_write(&mesh, "A sphere of radius 0.9",
                              path_in(directory, "sphere.obj").text, error);
    mesh_free(&mesh);
    done = done && (solid_knot(&mesh, 96, 12) || error_set(error, "out of memory for the knot"));
    done = done && mesh_write(&mesh, "A trefoil knot", path_in(directory, "knot.off").text, error);
    mesh_free(&mesh);
    return done;
}

int main(int argc, char **argv) {
    int coarser = argc == 3 ? atoi(argv[2]) : 1;
    size_t length = argc > 1 ? strlen(argv[1]) : 0;
    if (argc > 3 || length < 1 || length > 4000 || coarser < 1 || coarser > 8) {
        fprintf(stderr, "usage: sculpt DIR [COARSER]\n");
        return 2;
    }
    struct error error;
    if (!write_solids(argv[1], &error) || !write_bust(coarser, argv[1], &error)) {
        fprintf(stderr, "sculpt: %s\n", error.message);
        return 1;
    }
    return 0;
}
