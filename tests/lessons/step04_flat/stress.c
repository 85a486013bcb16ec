/* Step 4: its triangle() is lent to triangles.c; here its light and its way to the screen. */
#define LESSON "../step04_flat/main.c"
#include "lesson.h"

#include "upkeep/stress/lessons.h"
#include "upkeep/stress/stress.h"

#include <stdio.h>

void lesson04_triangle(struct image *image, const struct fixed2 corner[3], struct color color) {
    const struct vertex v[3] = {{corner[0]}, {corner[1]}, {corner[2]}};
    triangle(image, v, color);
}

/* ---- Light on a face ---- */

struct face_case {
    struct mesh_data mesh;
    struct vec3 light;
    int width, height;
};

/* Of any size, slivers too; now and then without area. */
static void make_face(struct random *random, uint64_t index, void *made) {
    struct face_case *c = made;
    struct vec3 corner[3];
    for (int i = 0; i < 3; i++) {
        corner[i] = index % 4 == 0 ? random_vector(random, 100) : random_vector(random, 1);
    }
    if (index % 4 == 1) { /* a sliver */
        double part = random_real(random, 0, 1);
        struct vec3 along = vec3_sub(corner[1], corner[0]), off = random_vector(random, 20);
        corner[2] = vec3_add(corner[0], vec3_add(vec3_scale(along, part), off));
    }
    if (index % 16 == 2) {
        corner[1] = corner[random_bits(random) % 2 ? 0 : 2];
    }
    for (int i = 0; i < 3; i++) {
        c->mesh.position[i] = corner[i];
    }
    c->light = random_direction(random);
    c->width = (int)random_between(random, 1, DRAW_LIMIT);
    c->height = (int)random_between(random, 1, DRAW_LIMIT);
}

/* How far the intensity is off, in units of what rounding may do to such a face: its sides' lengths
 * over its height. */
static double intensity_error(const void *tried) {
    struct face_case c = *(const struct face_case *)tried;
    struct mesh mesh;
    mesh_from(&mesh, &c.mesh, 1);
    double got = face_intensity(&mesh.model, 0, c.light);
    struct real3 w0 = real3_from(c.mesh.position[0]);
    struct real3 a = real3_sub(real3_from(c.mesh.position[2]), w0);
    struct real3 b = real3_sub(real3_from(c.mesh.position[1]), w0);
    struct real3 normal = real3_cross(a, b);
    long double area = real3_length(normal), sides = real3_length(a) * real3_length(b);
    if (area == 0) {
        return got == 0 ? 0 : (double)INFINITY;
    }
    long double exact = real3_dot(normal, real3_from(c.light)) / area;
    return (double)(fabsl(exact - (long double)got) / (0x1p-53L * (sides / area + 1)));
}

/* ---- From the model to the screen ---- */

/* Is it the nearest 1/256 pixel? Halfway between two either is right. */
static bool is_snapped(int32_t position, long double world, int size) {
    long double exact = (world + 1) * size / 2 * SUBPIXELS;
    return fabsl(exact - position) <= 0.5L + 1e-15L * fabsl(exact);
}

static bool is_off(struct vec3 position, const struct face_case *c) {
    long double x = ((long double)position.x + 1) * c->width / 2;
    long double y = ((long double)position.y + 1) * c->height / 2;
    return fabsl(x) > SCREEN_LIMIT || fabsl(y) > SCREEN_LIMIT;
}

static bool face_is_placed(const void *tried) {
    struct face_case c = *(const struct face_case *)tried;
    struct mesh mesh;
    struct vertex v[3];
    struct image image = {(size_t)c.width, (size_t)c.height, IMAGE_BGR, NULL};
    mesh_from(&mesh, &c.mesh, 1);
    bool placed = place_face(&mesh.model, 0, &image, v);
    for (int i = 0; i < 3; i++) {
        const struct vec3 p = c.mesh.position[i];
        if (is_off(p, &c)) {
            return !placed;
        }
        if (placed && !(is_snapped(v[i].position.x, p.x, c.width) &&
                        is_snapped(v[i].position.y, p.y, c.height))) {
            return false;
        }
    }
    return placed;
}

static void print_face(const void *failing) {
    const struct face_case *c = failing;
    for (int i = 0; i < 3; i++) {
        const struct vec3 p = c->mesh.position[i];
        printf("    v %.17g %.17g %.17g\n", p.x, p.y, p.z);
    }
    printf("    light %.17g %.17g %.17g, %dx%d pixels\n", c->light.x, c->light.y, c->light.z,
           c->width, c->height);
}

static const struct case_kind face_cases = {sizeof(struct face_case), make_face, print_face, NULL};

const struct property lesson04_properties[] = {
    PROPERTY("lesson04: light on a face", AGAINST_LONG_DOUBLE, 500000, face_cases,
             .error = intensity_error, .limit = 16, .error_unit = "eps * sides / height"),
    PROPERTY("lesson04: from model to screen", AGAINST_LONG_DOUBLE, 300000, face_cases,
             .holds = face_is_placed),
    {.name = NULL},
};
