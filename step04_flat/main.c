/*
 * Lesson 4: flat shading.
 *
 * Every face gets one grey: how directly the light falls on it. The face's direction is its
 * normal, a cross product; how directly the light falls is a dot product of two unit vectors.
 */
#include "program.h"

/* ---- From the model to the screen ---- */

/* A corner of a triangle that is to be drawn. Later lessons add what is interpolated. */
struct vertex {
    struct fixed2 position; /* on the screen */
};

/* The corners of a face in the parallel view. False for a face too far off the image to draw. */
static bool place_face(const struct model *model, size_t face, const struct image *image,
                       struct vertex vertices[3]) {
    /* BEGIN SOLUTION 4.1 from the model to the screen */
    for (size_t i = 0; i < 3; i++) {
        struct vec3 world = model_position(model, face, i);
        struct vec2 screen = parallel_view(world, image->width, image->height);
        if (!screen_snap(screen, &vertices[i].position)) {
            return false;
        }
    }
    return true;
    /* STARTER
    (void)model, (void)face, (void)image, (void)vertices;
    return false; // to do 4.1: parallel_view() and screen_snap() for each corner
    END SOLUTION */
}

/* ---- Triangles ---- */

/* The triangle of lesson 3: one span a row. */
static void triangle(struct image *image, const struct vertex v[3], struct color color) {
    /* BEGIN SOLUTION 4.2 a triangle from spans */
    struct edges edges;
    if (!edges_setup(&edges, v[0].position, v[1].position, v[2].position, image->width,
                     image->height)) {
        return;
    }
    for (int y = edges.y_begin; y < edges.y_end; y++) {
        struct span span = edges_span(&edges, y);
        image_fill_row(image, y, span.begin, span.end, color);
    }
    /* STARTER
    (void)image, (void)v, (void)color;
    // to do 4.2: edges_setup(), then edges_span() and image_fill_row() for each row
    END SOLUTION */
}

/* ---- Light ---- */

/* How directly the light falls on a face, n . l: 1 straight, 0 along the face, negative from
 * behind. n is the face's normal; l, here `to_light`, goes from the face to the light. Both have
 * length 1. */
static double face_intensity(const struct model *model, size_t face, struct vec3 to_light) {
    /* BEGIN SOLUTION 4.3 light on a face */
    struct vec3 w0 = model_position(model, face, 0), w1 = model_position(model, face, 1);
    struct vec3 w2 = model_position(model, face, 2);
    struct vec3 normal = vec3_normalized(vec3_cross(vec3_sub(w1, w0), vec3_sub(w2, w0)));
    return vec3_dot(normal, to_light);
    /* STARTER
    (void)model, (void)face, (void)to_light;
    return 1; // to do 4.3: the normal, and its dot product with to_light
    END SOLUTION */
}

#include "scenes.h"

int main(int argc, char **argv) {
    return program_main(&step04_flat, argc, argv);
}
