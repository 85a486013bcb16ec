/* Lesson 4: its triangle() is lent to triangles.c; here its light and its way to the screen. */
#define LESSON "../step04_flat/main.c"
#include "lesson.h"

#include "upkeep/stress/lessons.h"
#include "upkeep/stress/stress.h"

void lesson04_triangle(struct image *image, const struct fixed2 corner[3], struct color color) {
    const struct vertex v[3] = {{corner[0]}, {corner[1]}, {corner[2]}};
    triangle(image, v, color);
}

struct face_case {
    struct one_face face;
    struct vec3 light;
    int width, height;
};

static void make_face_case(struct random *random, uint64_t index, void *made) {
    struct face_case *c = made;
    make_face(random, index, &c->face);
    c->light = random_direction(random);
    c->width = (int)random_between(random, 1, DRAW_LIMIT);
    c->height = (int)random_between(random, 1, DRAW_LIMIT);
}

/* How far the intensity is off, in units of what rounding may do to such a face. */
static double intensity_error(const void *tried) {
    struct face_case c = *(const struct face_case *)tried;
    struct model model = model_of(&c.face);
    double got = face_intensity(&model, 0, c.light);
    long double uncertainty;
    struct real3 outwards = real3_unit(face_cross(&c.face, &uncertainty));
    long double exact = real3_dot(outwards, real3_from(c.light));
    return (double)(fabsl(exact - (long double)got) / (0x1p-53L * (uncertainty + 1)));
}

static bool face_is_placed(const void *tried) {
    struct face_case c = *(const struct face_case *)tried;
    struct model model = model_of(&c.face);
    struct vertex v[3];
    struct image image = {(size_t)c.width, (size_t)c.height, IMAGE_BGR, NULL};
    bool placed = place_face(&model, 0, &image, v);
    for (int i = 0; i < 3; i++) {
        long double x = ((long double)c.face.position[i].x + 1) * c.width / 2;
        long double y = ((long double)c.face.position[i].y + 1) * c.height / 2;
        if (fabsl(x) > SCREEN_LIMIT || fabsl(y) > SCREEN_LIMIT) {
            return !placed;
        }
        if (placed && !(is_snapped(v[i].position.x, x) && is_snapped(v[i].position.y, y))) {
            return false;
        }
    }
    return placed;
}

const struct property lesson04_properties[] = {
    PROPERTY("lesson04: light on a face", AGAINST_LONG_DOUBLE, 500000, struct face_case,
             make_face_case, .error = intensity_error, .limit = 16,
             .error_unit = "eps * sides / height"),
    PROPERTY("lesson04: from model to screen", AGAINST_LONG_DOUBLE, 300000, struct face_case,
             make_face_case, .holds = face_is_placed),
    {.name = NULL},
};
