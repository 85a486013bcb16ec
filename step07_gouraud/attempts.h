/*
 * Lesson 7: the worse and the better versions, for the lesson's figures and the benchmark.
 *
 * Include main.c first: these versions share its vertices, its light and its depth test. Each
 * attempt draws one triangle under a light of direction `light` (length 1, towards the light).
 */
#ifndef STEP07_ATTEMPTS_H
#define STEP07_ATTEMPTS_H

#include "geometry.h"
#include "model.h"

/* A triangle that faces the viewer, with everything that any version needs. */
struct attempt_face {
    struct edges edges;
    struct vertex vertices[3];
    struct vec3 normals[3];  /* of the corners */
    struct vec3 face_normal; /* of length 1, out of the model */
};

typedef void attempt_function(const struct canvas *canvas, struct attempt_face *face,
                              struct vec3 light);

/* A level for every pixel that passes the depth test. */
static inline void attempt_fill(const struct canvas *canvas, const struct attempt_face *face,
                                struct vec3 light,
                                uint8_t (*level_at)(const struct attempt_face *face,
                                                    struct vec3 weight, struct vec3 light)) {
    const struct vertex *v = face->vertices;
    for (int y = face->edges.y_begin; y < face->edges.y_end; y++) {
        struct span span = edges_span(&face->edges, y);
        for (int x = span.begin; x < span.end; x++) {
            struct vec3 weight = edges_weights(&face->edges, x, y);
            if (depth_test(canvas, v, weight, x, y)) {
                image_set(canvas->image, x, y, color_grey(level_at(face, weight, light)));
            }
        }
    }
}

/* ---- Three ways to shade ---- */

static inline uint8_t attempt_flat_level(const struct attempt_face *face, struct vec3 weight,
                                         struct vec3 light) {
    (void)weight;
    (void)light;
    return level_from(face->vertices[0].intensity * 255);
}

/* One intensity for the whole face: every edge of the mesh shows. */
static inline void attempt_1_flat(const struct canvas *canvas, struct attempt_face *face,
                                  struct vec3 light) {
    face->vertices[0].intensity = corner_intensity(face->face_normal, light);
    attempt_fill(canvas, face, light, attempt_flat_level);
}

/* The lesson's own: an intensity at each corner. */
static inline void attempt_2_gouraud(const struct canvas *canvas, struct attempt_face *face,
                                     struct vec3 light) {
    for (int i = 0; i < 3; i++) {
        face->vertices[i].intensity = corner_intensity(face->normals[i], light);
    }
    triangle(canvas, &face->edges, face->vertices);
}

static inline uint8_t attempt_normal_level(const struct attempt_face *face, struct vec3 weight,
                                           struct vec3 light) {
    const struct vec3 *n = face->normals;
    struct vec3 normal = vec3_normalized(vec3_interpolate(weight, n[0], n[1], n[2]));
    return level_from(corner_intensity(normal, light) * 255);
}

/* The normal itself interpolated and made of length 1 again at every pixel (Phong): the best
 * picture, for a square root and a division per pixel. */
static inline void attempt_3_normal(const struct canvas *canvas, struct attempt_face *face,
                                    struct vec3 light) {
    attempt_fill(canvas, face, light, attempt_normal_level);
}

/* ---- Negative intensities ---- */

static inline void attempt_signed_corners(struct attempt_face *face, struct vec3 light) {
    for (int i = 0; i < 3; i++) {
        face->vertices[i].intensity = vec3_dot(face->normals[i], light);
    }
}

static inline double attempt_signed_value(const struct attempt_face *face, struct vec3 weight) {
    const struct vertex *v = face->vertices;
    return 255 * interpolate(weight, v[0].intensity, v[1].intensity, v[2].intensity);
}

static inline uint8_t attempt_late_level(const struct attempt_face *face, struct vec3 weight,
                                         struct vec3 light) {
    (void)light;
    return level_from(attempt_signed_value(face, weight));
}

/* Clamped after interpolation instead of before: the shadow begins inside the triangles, with a
 * hard edge, where the lesson's version fades to the next corner. */
static inline void attempt_5_late(const struct canvas *canvas, struct attempt_face *face,
                                  struct vec3 light) {
    attempt_signed_corners(face, light);
    attempt_fill(canvas, face, light, attempt_late_level);
}

static inline uint8_t attempt_wrapped_level(const struct attempt_face *face, struct vec3 weight,
                                            struct vec3 light) {
    (void)light;
    return (uint8_t)((int)floor(attempt_signed_value(face, weight)) & 255);
}

/* Wrong: not clamped at all. -1 becomes 255 in a byte: the shadow side shines. */
static inline void attempt_6_wrapped(const struct canvas *canvas, struct attempt_face *face,
                                     struct vec3 light) {
    attempt_signed_corners(face, light);
    attempt_fill(canvas, face, light, attempt_wrapped_level);
}

/* ---- Faces ---- */

/* Place a face, `scale` times as large, and find its edges. False when there is nothing to draw:
 * it is too far off, covers no pixel centre or shows its inside. Its normals stay as they are. */
static inline bool attempt_begin_face(const struct canvas *canvas, struct attempt_face *face,
                                      const struct vec3 corners[3], double scale) {
    struct vertex *v = face->vertices;
    bool placed = true;
    for (int i = 0; i < 3; i++) {
        struct vec2 screen =
            parallel_view(vec3_scale(corners[i], scale), canvas->width, canvas->height);
        v[i] = (struct vertex){.depth = corners[i].z};
        placed = screen_snap(screen, &v[i].position) && placed;
    }
    face->face_normal = vec3_normalized(
        vec3_cross(vec3_sub(corners[1], corners[0]), vec3_sub(corners[2], corners[0])));
    return placed &&
           edges_setup(&face->edges, v[0].position, v[1].position, v[2].position, canvas->width,
                       canvas->height) &&
           !face->edges.clockwise;
}

/* A whole model by any version. */
static inline void attempt_model(const struct canvas *canvas, const struct model *model,
                                 struct vec3 light, attempt_function *attempt) {
    depth_clear(canvas->depth, canvas->width * canvas->height);
    for (size_t i = 0; i < model->face_count; i++) {
        struct attempt_face face = {0};
        struct vec3 corners[3];
        for (size_t j = 0; j < 3; j++) {
            corners[j] = model_position(model, i, j);
            face.normals[j] = vec3_normalized(model_normal(model, i, j));
        }
        if (attempt_begin_face(canvas, &face, corners, 1)) {
            attempt(canvas, &face, light);
        }
    }
}

/* ---- A sphere of 8, 32, 128, 512 ... triangles ---- */

#define ATTEMPT_RADIUS 0.9 /* of half the image */

static inline struct vec3 attempt_middle(struct vec3 a, struct vec3 b) {
    return vec3_normalized(vec3_add(a, b));
}

/* A spherical triangle, cut into four `times` times. */
static inline void attempt_sphere_part(const struct canvas *canvas, struct vec3 a, struct vec3 b,
                                       struct vec3 c, int times, struct vec3 light,
                                       attempt_function *attempt) {
    if (times > 0) {
        struct vec3 ab = attempt_middle(a, b), bc = attempt_middle(b, c), ca = attempt_middle(c, a);
        attempt_sphere_part(canvas, a, ab, ca, times - 1, light, attempt);
        attempt_sphere_part(canvas, ab, b, bc, times - 1, light, attempt);
        attempt_sphere_part(canvas, ca, bc, c, times - 1, light, attempt);
        attempt_sphere_part(canvas, ab, bc, ca, times - 1, light, attempt);
        return;
    }
    struct attempt_face face = {.normals = {a, b, c}};
    if (attempt_begin_face(canvas, &face, face.normals, ATTEMPT_RADIUS)) {
        attempt(canvas, &face, light);
    }
}

/* A sphere that nearly fills the image, made of 8 * 4^times triangles: an octahedron, cut up. */
static inline void attempt_sphere(const struct canvas *canvas, int times, struct vec3 light,
                                  attempt_function *attempt) {
    depth_clear(canvas->depth, canvas->width * canvas->height);
    for (int octant = 0; octant < 8; octant++) {
        struct vec3 x = {octant & 1 ? -1 : 1, 0, 0}, y = {0, octant & 2 ? -1 : 1, 0};
        struct vec3 z = {0, 0, octant & 4 ? -1 : 1};
        bool mirrored = x.x * y.y * z.z < 0;
        attempt_sphere_part(canvas, x, mirrored ? z : y, mirrored ? y : z, times, light, attempt);
    }
}

/* The level of a pixel of the true sphere; false where its centre lies off the sphere. */
static inline bool attempt_exact_sphere(size_t x, size_t y, size_t width, size_t height,
                                        struct vec3 light, double *level) {
    double nx = (2 * ((double)x + 0.5) / (double)width - 1) / ATTEMPT_RADIUS;
    double ny = (2 * ((double)y + 0.5) / (double)height - 1) / ATTEMPT_RADIUS;
    double square = 1 - nx * nx - ny * ny;
    if (square < 0) {
        return false;
    }
    *level = 255 * corner_intensity((struct vec3){nx, ny, sqrt(square)}, light);
    return true;
}

/* Root of the mean squared error, in levels, over the pixels that the sphere and its triangles have
 * in common. */
static inline double attempt_sphere_error(const struct canvas *canvas, struct vec3 light) {
    double sum = 0, pixels = 0;
    for (size_t y = 0; y < canvas->height; y++) {
        for (size_t x = 0; x < canvas->width; x++) {
            double level;
            if (!(canvas->depth[y * canvas->width + x] > -INFINITY) ||
                !attempt_exact_sphere(x, y, canvas->width, canvas->height, light, &level)) {
                continue;
            }
            double error = image_get(canvas->image, (int)x, (int)y).r - level;
            sum += error * error;
            pixels++;
        }
    }
    return pixels > 0 ? sqrt(sum / pixels) : 0;
}

#endif
