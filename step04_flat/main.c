/*
 * Step 4: flat shading.
 *
 * Every face gets one grey level: how directly the light falls on it. The face's direction is its
 * normal, a cross product; how directly the light falls is a dot product of two unit vectors.
 *
 * Scene: `flat` draws a model from the front, in the order of the file. Faces on which no light
 * falls are not drawn. With the light in the viewer's direction these are the faces that show their
 * backs; what lies behind something else is still painted over it (see the mouth): that is
 * lesson 5.
 */
#include "program.h"

/* ---- Light ---- */

/* How directly the light falls on a face: 1 straight, 0 along the face, negative from behind.
 * `light` has length 1 and is the direction in which the light travels. The normal is taken so that
 * it points into the model; it agrees with `light` where the light falls on the outside. */
static double face_intensity(const struct model *model, size_t face, struct vec3 light) {
    struct vec3 w0 = model_position(model, face, 0), w1 = model_position(model, face, 1);
    struct vec3 w2 = model_position(model, face, 2);
    struct vec3 normal = vec3_normalized(vec3_cross(vec3_sub(w2, w0), vec3_sub(w1, w0)));
    return vec3_dot(normal, light);
}

/* ---- Triangles ---- */

/* A corner of a triangle that is to be drawn. Later lessons add what is interpolated. */
struct vertex {
    struct fixed2 position; /* on the screen */
};

/* What is drawn on, and the work done on it. */
struct canvas {
    struct image *image; /* IMAGE_BGR */
    uint64_t pixels_written;
};

/* The pixels of a span become `color`. */
static void fill_span(struct image *image, int y, struct span span, struct color color) {
    uint8_t *pixel = image->pixels + ((size_t)y * image->width + (size_t)span.begin) * 3;
    for (int x = span.begin; x < span.end; x++) {
        pixel[0] = color.b;
        pixel[1] = color.g;
        pixel[2] = color.r;
        pixel += 3;
    }
}

/* The triangle of step 3: one span a row. False when no pixel centre can be inside. */
static bool triangle(struct canvas *canvas, const struct vertex v[3], struct color color) {
    struct image *image = canvas->image;
    struct edges edges;
    if (!edges_setup(&edges, v[0].position, v[1].position, v[2].position, image->width,
                     image->height)) {
        return false;
    }
    for (int y = edges.y_begin; y < edges.y_end; y++) {
        struct span span = edges_span(&edges, y);
        fill_span(image, y, span, color);
        canvas->pixels_written += (uint64_t)(span.end - span.begin);
    }
    return true;
}

/* ---- Scene: flat ---- */

/* Parallel view: x and y in -1..1 fill the image, z does not count. False for a corner too far off
 * the image to draw. */
static bool place_corner(const struct model *model, size_t face, size_t corner,
                         const struct image *image, struct vertex *vertex) {
    struct vec3 world = model_position(model, face, corner);
    struct vec2 screen = {(world.x + 1) * (double)image->width / 2,
                          (world.y + 1) * (double)image->height / 2};
    return screen_snap(screen, &vertex->position);
}

static bool place_face(const struct model *model, size_t face, const struct image *image,
                       struct vertex vertices[3]) {
    for (size_t i = 0; i < 3; i++) {
        if (!place_corner(model, face, i, image, &vertices[i])) {
            return false;
        }
    }
    return true;
}

static bool draw_flat(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct model *model = drawing->model;
    const struct vec3 light = vec3_normalized(drawing->light);
    struct canvas canvas = {.image = image};
    uint64_t unlit = 0, placed = 0, off_limits = 0, without_pixel = 0;
    for (size_t face = 0; face < model->face_count; face++) {
        struct vertex vertices[3];
        double intensity = face_intensity(model, face, light);
        bool lit = intensity > 0;
        unlit += !lit;
        if (!lit && drawing->skip) {
            continue; /* it will not be drawn: where it lies does not matter */
        }
        placed++;
        if (!place_face(model, face, image, vertices)) {
            off_limits += lit;
        } else if (lit && !triangle(&canvas, vertices, color_grey(level_from(intensity * 255)))) {
            without_pixel++;
        }
    }
    count(drawing, "faces", model->face_count);
    count(drawing, "faces_unlit", unlit);
    count(drawing, "faces_placed", placed);
    count(drawing, "faces_off_limits", off_limits);
    count(drawing, "faces_without_pixel", without_pixel);
    count(drawing, "pixels_written", canvas.pixels_written);
    return true;
}

/* ---- The program ---- */

int main(int argc, char **argv) {
    static const struct scene scenes[] = {
        {
            .name = "flat",
            .width = 800,
            .height = 800,
            .needs_model = true,
            .light = {0, 0, -1},
            .draw = draw_flat,
        },
    };
    static const struct program program = {
        .name = "step04_flat",
        .summary = "one grey level a face, from its normal and the light",
        .takes_model = true,
        .takes_light = true,
        .scenes = scenes,
        .scene_count = sizeof scenes / sizeof scenes[0],
    };
    return program_main(&program, argc, argv);
}
