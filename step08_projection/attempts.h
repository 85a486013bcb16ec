/*
 * Step 8: the worse and the better versions, for the lesson's figures and the benchmark.
 *
 * Include main.c first: these versions share its cameras, its faces and its triangle().
 */
#ifndef STEP08_ATTEMPTS_H
#define STEP08_ATTEMPTS_H

#include "geometry.h"
#include "model.h"

/* ---- Perspective ---- */

typedef struct vec2 attempt_perspective(struct vec3 view, double distance);

/* Larger when nearer, by a factor that grows evenly. The size is right at z = 0, but straight lines
 * become curves. */
static inline struct vec2 attempt_1_evenly(struct vec3 view, double distance) {
    double factor = 1 + view.z / distance;
    return (struct vec2){view.x * factor, view.y * factor};
}

/* Divided by what is left of the distance. */
static inline struct vec2 attempt_14_divided(struct vec3 view, double distance) {
    double w = 1 - view.z / distance;
    return (struct vec2){view.x / w, view.y / w};
}

/* ---- Drawing the whole model: the same shape as draw_model() ---- */

typedef void attempt_draw(struct drawing *drawing, struct canvas *canvas,
                          const struct mat4 *to_clip);

/* The corners of a face as transform_positions() left them. */
static inline void attempt_corners(const struct drawing *drawing, size_t face,
                                   struct position *corner[3]) {
    const struct state *state = drawing->state;
    for (int i = 0; i < 3; i++) {
        corner[i] = &state->positions[drawing->model->faces[face].corner[i].position];
    }
}

/* Whether the whole face lies in front of the near plane and within the guard band. */
static inline bool attempt_in_front(struct position *const corner[3]) {
    unsigned beyond = corner[0]->beyond | corner[1]->beyond | corner[2]->beyond;
    return (beyond & (BEYOND_NEAR | BEYOND_GUARD_BAND)) == 0;
}

/* A face, its corners placed. False when it must be clipped, or has no place on the screen. */
static inline bool attempt_place(const struct drawing *drawing, struct canvas *canvas, size_t face,
                                 struct position *corner[3], struct vertex v[3]) {
    attempt_corners(drawing, face, corner);
    if (!attempt_in_front(corner) || !place_face(corner, canvas)) {
        return false;
    }
    for (int i = 0; i < 3; i++) {
        v[i] = corner[i]->vertex;
    }
    return true;
}

/* The depth is z and not z/w. It does not run evenly over the screen: planes cross in the wrong
 * place. */
static inline void attempt_2_depth_z(struct drawing *drawing, struct canvas *canvas,
                                     const struct mat4 *to_clip) {
    transform_positions(drawing, to_clip);
    for (size_t i = 0; i < drawing->model->face_count; i++) {
        struct position *corner[3];
        struct vertex v[3];
        if (attempt_place(drawing, canvas, i, corner, v)) {
            for (int k = 0; k < 3; k++) {
                v[k].depth = corner[k]->clip.z;
            }
            draw_part(drawing, canvas, i, v, whole_face);
        }
    }
}

/* Interpolated on the screen as if there were no perspective. With 1/w taken as 1 everywhere the
 * correct weights are those of the screen. Textures swim: they bend along the edges of triangles.
 * (Faces that cross the near plane are left out.) */
static inline void attempt_3_affine(struct drawing *drawing, struct canvas *canvas,
                                    const struct mat4 *to_clip) {
    transform_positions(drawing, to_clip);
    for (size_t i = 0; i < drawing->model->face_count; i++) {
        struct position *corner[3];
        struct vertex v[3];
        if (attempt_place(drawing, canvas, i, corner, v)) {
            v[0].recip_w = v[1].recip_w = v[2].recip_w = 1;
            draw_part(drawing, canvas, i, v, whole_face);
        }
    }
}

/* One triangle with the weights of the screen for everything: triangle() without correct_weights(),
 * which saves a division and a few products a pixel. */
static inline void attempt_15_affine_triangle(const struct canvas *canvas,
                                              const struct edges *edges, const struct vertex v[3]) {
    const struct rectangle area = canvas->area;
    const struct span columns = {area.x, area.x + area.width};
    const struct span rows = span_overlap((struct span){edges->y_begin, edges->y_end},
                                          (struct span){area.y, area.y + area.height});
    for (int y = rows.begin; y < rows.end; y++) {
        struct span span = span_overlap(edges_span(edges, y), columns);
        double *row = canvas->depth + (size_t)y * canvas->image->width;
        for (int x = span.begin; x < span.end; x++) {
            struct vec3 w = edges_weights(edges, x, y);
            double depth = interpolate_depth(w, v[0].depth, v[1].depth, v[2].depth);
            if (depth > row[x]) {
                double intensity = interpolate(w, v[0].intensity, v[1].intensity, v[2].intensity);
                struct vec2 uv = vec2_interpolate(w, v[0].uv, v[1].uv, v[2].uv);
                row[x] = depth;
                image_set(canvas->image, x, y, shade(canvas->texture, uv, intensity));
            }
        }
    }
}

/* Divided by w, whatever w is. A point behind the camera has a negative w: it appears in front,
 * upside down, and a face with one such corner covers the wrong side of the picture. */
static inline void attempt_7_unclipped(struct drawing *drawing, struct canvas *canvas,
                                       const struct mat4 *to_clip) {
    transform_positions(drawing, to_clip);
    for (size_t i = 0; i < drawing->model->face_count; i++) {
        struct position *corner[3];
        struct vertex v[3];
        bool placed = true;
        attempt_corners(drawing, i, corner);
        for (int k = 0; k < 3; k++) {
            placed = placed && place(corner[k]->clip, &canvas->to_screen, &v[k]);
        }
        if (placed) {
            draw_part(drawing, canvas, i, v, whole_face);
        }
    }
}

/* Faces with a corner behind the near plane are left out: holes where large faces pass under the
 * camera. */
static inline void attempt_8_left_out(struct drawing *drawing, struct canvas *canvas,
                                      const struct mat4 *to_clip) {
    transform_positions(drawing, to_clip);
    for (size_t i = 0; i < drawing->model->face_count; i++) {
        struct position *corner[3];
        attempt_corners(drawing, i, corner);
        if (attempt_in_front(corner)) {
            draw_whole(drawing, canvas, i, corner);
        }
    }
}

/* ---- Normals ---- */

typedef struct vec3 attempt_normal(const struct mat4 *map, struct vec3 normal);

/* A normal sent through the same matrix as the points: no longer perpendicular to the surface when
 * the scale is not the same in all directions. */
static inline struct vec3 attempt_4_same_matrix(const struct mat4 *map, struct vec3 normal) {
    return vec3_normalized(mat4_direction(map, normal));
}

/* By the transpose of the inverse. A map without an inverse keeps the normal. */
static inline struct vec3 attempt_13_inverse_transpose(const struct mat4 *map, struct vec3 normal) {
    struct mat4 inverse = mat4_identity();
    mat4_inverse(*map, &inverse);
    struct mat4 transpose = mat4_transpose(inverse);
    return vec3_normalized(mat4_direction(&transpose, normal));
}

/* ---- The camera's frame ---- */

typedef struct mat4 attempt_lookat(struct vec3 eye, struct vec3 center, struct vec3 up);

/* The center is taken away after the rotation instead of before it, so it is not rotated. Right
 * only for a center at the origin; otherwise the model slides out of the picture. */
static inline struct mat4 attempt_5_unrotated(struct vec3 eye, struct vec3 center, struct vec3 up) {
    struct mat4 frame = lookat(eye, center, up);
    frame.m[0][3] = -center.x;
    frame.m[1][3] = -center.y;
    frame.m[2][3] = -center.z;
    return frame;
}

/* No care for `up`. Where it is parallel to the view, the cross product is 0 and dividing by its
 * length gives NaN: nothing is drawn. Where it is nearly parallel, x is mostly rounding error. */
static inline struct mat4 attempt_6_careless(struct vec3 eye, struct vec3 center, struct vec3 up) {
    struct vec3 z = vec3_sub(eye, center);
    z = vec3_scale(z, 1 / vec3_length(z));
    struct vec3 x = vec3_cross(up, z);
    x = vec3_scale(x, 1 / vec3_length(x));
    struct vec3 y = vec3_cross(z, x);
    return (struct mat4){{{x.x, x.y, x.z, -vec3_dot(x, center)},
                          {y.x, y.y, y.z, -vec3_dot(y, center)},
                          {z.x, z.y, z.z, -vec3_dot(z, center)},
                          {0, 0, 0, 1}}};
}

/* ---- From the model to the screen, in three precisions ---- */

/* Where a point of the model lies on the screen, in pixels, not snapped; w must be positive. */
typedef struct vec2 attempt_chain(const struct mat4 *to_clip, const struct mat4 *to_screen,
                                  struct vec3 point);

/* All in float, as on a graphics card. It has 24 bits; the pixel takes 10 of them and its 256
 * parts 8. After a few roundings the 6 others no longer tell on which side of a half a position
 * lies: some corners snap to the neighbouring 1/256 pixel. */
static inline struct vec2 attempt_9_float(const struct mat4 *to_clip, const struct mat4 *to_screen,
                                          struct vec3 point) {
    float p[4] = {(float)point.x, (float)point.y, (float)point.z, 1}, clip[4], screen[2];
    for (int row = 0; row < 4; row++) {
        clip[row] = 0;
        for (int k = 0; k < 4; k++) {
            float product = (float)to_clip->m[row][k] * p[k];
            clip[row] = clip[row] + product;
        }
    }
    float recip_w = 1 / clip[3];
    for (int row = 0; row < 2; row++) {
        float scaled = (float)to_screen->m[row][row] * (clip[row] * recip_w);
        screen[row] = scaled + (float)to_screen->m[row][3];
    }
    return (struct vec2){screen[0], screen[1]};
}

/* The lesson's own, in double. */
static inline struct vec2 attempt_10_double(const struct mat4 *to_clip,
                                            const struct mat4 *to_screen, struct vec3 point) {
    struct vec4 clip = mat4_point(to_clip, point);
    double recip_w = 1 / clip.w;
    struct vec4 screen =
        mat4_point(to_screen, (struct vec3){clip.x * recip_w, clip.y * recip_w, clip.z * recip_w});
    return (struct vec2){screen.x, screen.y};
}

/* In long double: what the other two are measured with, where it has more bits than double. */
static inline void attempt_exact(const struct mat4 *to_clip, const struct mat4 *to_screen,
                                 struct vec3 point, long double screen[2]) {
    const long double p[4] = {point.x, point.y, point.z, 1};
    long double clip[4];
    for (int row = 0; row < 4; row++) {
        clip[row] = 0;
        for (int k = 0; k < 4; k++) {
            clip[row] += to_clip->m[row][k] * p[k];
        }
    }
    for (int row = 0; row < 2; row++) {
        screen[row] = to_screen->m[row][row] * (clip[row] / clip[3]) + to_screen->m[row][3];
    }
}

/* ---- The inverse of a matrix ---- */

typedef bool attempt_inverse(struct mat4 a, struct mat4 *inverse);

/* The determinant of what is left of a without a row and a column. */
static inline double attempt_minor(const struct mat4 *a, int without_row, int without_column) {
    int r[3], c[3];
    for (int i = 0; i < 3; i++) {
        r[i] = i < without_row ? i : i + 1;
        c[i] = i < without_column ? i : i + 1;
    }
    return a->m[r[0]][c[0]] *
               (a->m[r[1]][c[1]] * a->m[r[2]][c[2]] - a->m[r[1]][c[2]] * a->m[r[2]][c[1]]) -
           a->m[r[0]][c[1]] *
               (a->m[r[1]][c[0]] * a->m[r[2]][c[2]] - a->m[r[1]][c[2]] * a->m[r[2]][c[0]]) +
           a->m[r[0]][c[2]] *
               (a->m[r[1]][c[0]] * a->m[r[2]][c[1]] - a->m[r[1]][c[1]] * a->m[r[2]][c[0]]);
}

/* By Cramer's rule: transposed cofactors divided by the determinant, 16 minors. Subtracting nearly
 * equal products loses digits when the matrix is nearly singular, and a determinant of a well
 * behaved matrix may underflow to 0. */
static inline bool attempt_11_cofactors(struct mat4 a, struct mat4 *inverse) {
    struct mat4 result;
    double determinant = 0;
    for (int row = 0; row < 4; row++) {
        for (int column = 0; column < 4; column++) {
            double sign = (row + column) % 2 == 0 ? 1 : -1;
            result.m[column][row] = sign * attempt_minor(&a, row, column);
        }
    }
    for (int column = 0; column < 4; column++) {
        determinant += a.m[0][column] * result.m[column][0];
    }
    if (determinant == 0) {
        return false;
    }
    for (int row = 0; row < 4; row++) {
        for (int column = 0; column < 4; column++) {
            result.m[row][column] /= determinant;
        }
    }
    *inverse = result;
    return true;
}

static inline float attempt_minor_float(const float a[4][4], int without_row, int without_column) {
    float m[3][3];
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            m[i][k] = a[i < without_row ? i : i + 1][k < without_column ? k : k + 1];
        }
    }
    float p = m[1][1] * m[2][2], q = m[1][2] * m[2][1], r = m[1][0] * m[2][2];
    float s = m[1][2] * m[2][0], t = m[1][0] * m[2][1], u = m[1][1] * m[2][0];
    float first = m[0][0] * (p - q), second = m[0][1] * (r - s), third = m[0][2] * (t - u);
    return first - second + third;
}

/* The same in float. */
static inline bool attempt_12_cofactors_float(struct mat4 a, struct mat4 *inverse) {
    float m[4][4], cofactor[4][4], determinant = 0;
    for (int i = 0; i < 16; i++) {
        m[i / 4][i % 4] = (float)a.m[i / 4][i % 4];
    }
    for (int row = 0; row < 4; row++) {
        for (int column = 0; column < 4; column++) {
            float minor = attempt_minor_float((const float(*)[4])m, row, column);
            cofactor[row][column] = (row + column) % 2 == 0 ? minor : -minor;
        }
    }
    for (int column = 0; column < 4; column++) {
        float product = m[0][column] * cofactor[0][column];
        determinant = determinant + product;
    }
    if (determinant == 0) {
        return false;
    }
    for (int row = 0; row < 4; row++) {
        for (int column = 0; column < 4; column++) {
            inverse->m[column][row] = cofactor[row][column] / determinant;
        }
    }
    return true;
}

#endif
