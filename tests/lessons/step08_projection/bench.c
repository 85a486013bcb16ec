/*
 * Step 8: precision on the way to the screen, inverses, perspective inside a triangle, clipping.
 *
 * The exact answers are long double for positions and for the wall, fractions of 128-bit integers
 * for the inverses, and for the clipped picture a ray through every pixel, which needs no clipping
 * and no snapping.
 */
#define LESSON "../step08_projection/main.c"
#include "lesson.h"

#include "../../../step08_projection/attempts.h"

#include "bench/bench.h"
#include "files/model_file.h"
#include "files/normals.h"
#include "oracle/oracle.h"
#include "oracle/reals.h"

/* Pixels of a side: of most pictures, and of the small one in which the faces count for more. */
enum { SIDE = 800, SMALL_SIDE = 200, CAMERAS = 2 };

struct camera {
    struct vec3 eye, center, up;
};

/* Those of scenes lookat and closeup. */
static const struct camera cameras[CAMERAS] = {
    {{1, 1, 2}, {0, 0, 0}, {0, 1, 0}},
    {{0.03, 0.47, 0.46}, {0.03, -0.3, 0.4}, {0, 0, 1}},
};

/* Points and matrices of float, and of 16.16 whole numbers: 16 bits before and after the point. */
struct vec3_float {
    float x, y, z;
};

struct mat4_float {
    float m[4][4];
};

struct vec3_fixed {
    int32_t x, y, z;
};

struct mat4_fixed {
    int32_t m[4][4];
};

/* How far model and camera are moved, in all three directions. The last one is in the matrix: the
 * corners of the model keep their small numbers. */
static const double offsets[] = {0, 1e3, 1e6, 1e6};
enum { OFFSETS = sizeof offsets / sizeof offsets[0], IN_MATRIX = OFFSETS - 1 };

/* The corners that a camera sees, prepared for each type of number. */
struct view {
    struct camera camera; /* moved */
    size_t count;
    struct vec3 *corners; /* moved */
    struct vec3_float *corners_float;
    struct vec3_fixed *corners_fixed;
    struct mat4 to_clip;
    struct mat4_float to_clip_float;
    struct mat4_fixed to_clip_fixed;
    struct vec2 *screen; /* what a version finds */
};

enum { CONDITIONS = 5, MATRICES = 32, ENTRY_LIMIT = 1 << 24 /* of the oracle */ };
static const int condition_bits[CONDITIONS] = {4, 12, 24, 36, 48};

/* A matrix of whole numbers. */
struct whole {
    int64_t m[4][4];
};

enum { TILES_SIDE = 256, CUTS_MOST = 64 /* of a side of the wall */ };

/* What a ray finds behind the centre of a pixel. */
struct found {
    long double depth;     /* z/w; minus infinity where there is nothing */
    long double tolerance; /* what the depth may be off when corners are moved by 1/128 pixel */
};

struct work {
    struct model model;
    struct state state; /* of the lesson's program */
    struct drawing drawing;
    double *depth;
    struct image image, small;
    struct mat4 to_screen;
    struct mat4_float to_screen_float;
    struct view views[OFFSETS][CAMERAS];
    struct whole whole[CONDITIONS][MATRICES];
    struct mat4 matrices[CONDITIONS][MATRICES], inverses[MATRICES];
    bool inverted[MATRICES];
    struct texture tiles;
    struct vertex wall[(CUTS_MOST + 1) * (CUTS_MOST + 1)];
    struct found *found; /* in scene closeup */
};

/* ---- Corners to the screen ---- */

enum number { IN_FLOAT, IN_DOUBLE, IN_FIXED };

/* A version: type of number and offset. */
#define CHAIN(number, offset) ((int)(number) * (int)OFFSETS + (offset))

/* The same operations for both types: those of mat4_point() and place(). */
#define TRANSFORM(name, real, point, matrix)                                                       \
    static inline real name##_row(const real m[4], real x, real y, real z) {                       \
        return m[0] * x + m[1] * y + m[2] * z + m[3];                                              \
    }                                                                                              \
    static void name(size_t count, const point *p, const matrix *clip, const matrix *screen,       \
                     struct vec2 *result) {                                                        \
        for (size_t i = 0; i < count; i++) {                                                       \
            real recip_w = 1 / name##_row(clip->m[3], p[i].x, p[i].y, p[i].z);                     \
            real x = name##_row(clip->m[0], p[i].x, p[i].y, p[i].z) * recip_w;                     \
            real y = name##_row(clip->m[1], p[i].x, p[i].y, p[i].z) * recip_w;                     \
            real z = name##_row(clip->m[2], p[i].x, p[i].y, p[i].z) * recip_w;                     \
            result[i].x = name##_row(screen->m[0], x, y, z);                                       \
            result[i].y = name##_row(screen->m[1], x, y, z);                                       \
        }                                                                                          \
    }

TRANSFORM(transform_float, float, struct vec3_float, struct mat4_float)
TRANSFORM(transform_double, double, struct vec3, struct mat4)

/* A product has 32 bits after the point, of which 16 are rounded away. */
static inline int64_t fixed_row(const int32_t m[4], struct vec3_fixed p) {
    int64_t sum = (int64_t)m[0] * p.x + (int64_t)m[1] * p.y + (int64_t)m[2] * p.z;
    return ((sum + 0x8000) >> 16) + m[3];
}

static inline double fixed_to_screen(int64_t clip, int64_t w) {
    int64_t ndc = clip * 65536 / w;
    return (double)(ndc * (SIDE / 2) + 65536 * (SIDE / 2)) * 0x1p-16;
}

static void transform_fixed(size_t count, const struct vec3_fixed *p, const struct mat4_fixed *clip,
                            struct vec2 *result) {
    for (size_t i = 0; i < count; i++) {
        int64_t w = fixed_row(clip->m[3], p[i]);
        w = w > 0 ? w : 1; /* far from the origin rounding may leave nothing of it */
        result[i].x = fixed_to_screen(fixed_row(clip->m[0], p[i]), w);
        result[i].y = fixed_to_screen(fixed_row(clip->m[1], p[i]), w);
    }
}

static void run_chain(void *state, int choice) {
    struct work *work = state;
    for (int k = 0; k < CAMERAS; k++) {
        struct view *v = &work->views[choice % (int)OFFSETS][k];
        switch (choice / (int)OFFSETS) {
        case IN_FLOAT:
            transform_float(v->count, v->corners_float, &v->to_clip_float, &work->to_screen_float,
                            v->screen);
            break;
        case IN_DOUBLE:
            transform_double(v->count, v->corners, &v->to_clip, &work->to_screen, v->screen);
            break;
        default:
            transform_fixed(v->count, v->corners_fixed, &v->to_clip_fixed, v->screen);
        }
    }
}

static double units_chain(const void *state, int base) {
    (void)base;
    const struct work *work = state;
    return (double)(work->views[0][0].count + work->views[0][1].count);
}

/* Where a corner is seen, by similar triangles in the camera's own axes, without a matrix. */
static void find_screen(const struct camera *camera, struct vec3 corner, long double screen[2]) {
    struct real3 center = real3_from(camera->center);
    struct real3 back = real3_sub(real3_from(camera->eye), center), z = real3_unit(back);
    struct real3 x = real3_unit(real3_cross(real3_from(camera->up), z)), y = real3_cross(z, x);
    struct real3 p = real3_sub(real3_from(corner), center);
    long double w = 1 - real3_dot(p, z) / real3_length(back);
    screen[0] = (real3_dot(p, x) / w + 1) * SIDE / 2;
    screen[1] = (real3_dot(p, y) / w + 1) * SIDE / 2;
}

static double error_chain(void *state, int choice) {
    const struct work *work = state;
    long double worst = 0;
    for (int k = 0; k < CAMERAS; k++) {
        const struct view *view = &work->views[choice % (int)OFFSETS][k];
        for (size_t i = 0; i < view->count; i++) {
            long double exact[2];
            find_screen(&view->camera, view->corners[i], exact);
            worst = fmaxl(worst, fabsl(view->screen[i].x - exact[0]));
            worst = fmaxl(worst, fabsl(view->screen[i].y - exact[1]));
        }
    }
    return (double)worst * SUBPIXELS;
}

static struct camera moved_camera(struct camera camera, double offset) {
    struct vec3 by = {offset, offset, offset};
    return (struct camera){vec3_add(camera.eye, by), vec3_add(camera.center, by), camera.up};
}

static struct mat4 camera_matrix(const struct camera *c) {
    return mat4_mul(projection(vec3_length(vec3_sub(c->eye, c->center))),
                    lookat(c->eye, c->center, c->up));
}

static struct mat4_float float_matrix(const struct mat4 *a) {
    struct mat4_float result;
    for (int i = 0; i < 16; i++) {
        result.m[i / 4][i % 4] = (float)a->m[i / 4][i % 4];
    }
    return result;
}

/* The nearest 16.16 number; 0 for what is too large for one, which no version then uses. */
static int32_t to_fixed(double value) {
    return fabs(value) < 32767 ? (int32_t)floor(value * 65536 + 0.5) : 0;
}

static void view_set_matrices(struct view *view, int offset) {
    double by = offsets[offset];
    view->to_clip = camera_matrix(&view->camera);
    struct mat4 moved = view->to_clip;
    if (offset == IN_MATRIX) {
        moved = mat4_mul(moved, mat4_translation((struct vec3){by, by, by}));
    }
    view->to_clip_float = float_matrix(&moved);
    for (int i = 0; i < 16; i++) {
        view->to_clip_fixed.m[i / 4][i % 4] = to_fixed(moved.m[i / 4][i % 4]);
    }
}

static void view_add(struct view *view, struct vec3 corner, int offset) {
    double by = offsets[offset], kept = offset == IN_MATRIX ? 0 : by;
    struct vec3 p = {corner.x + kept, corner.y + kept, corner.z + kept};
    view->corners[view->count] = (struct vec3){corner.x + by, corner.y + by, corner.z + by};
    view->corners_float[view->count] = (struct vec3_float){(float)p.x, (float)p.y, (float)p.z};
    view->corners_fixed[view->count] =
        (struct vec3_fixed){to_fixed(p.x), to_fixed(p.y), to_fixed(p.z)};
    view->count++;
}

static bool make_view(struct view *view, const struct model *model, const struct camera *camera,
                      int offset, struct error *error) {
    struct mat4 to_clip = camera_matrix(camera);
    view->camera = moved_camera(*camera, offsets[offset]);
    view->corners = malloc(model->position_count * sizeof *view->corners);
    view->corners_float = malloc(model->position_count * sizeof *view->corners_float);
    view->corners_fixed = malloc(model->position_count * sizeof *view->corners_fixed);
    view->screen = malloc(model->position_count * sizeof *view->screen);
    if (view->corners == NULL || view->corners_float == NULL || view->corners_fixed == NULL ||
        view->screen == NULL) {
        return error_out_of_memory(error);
    }
    view_set_matrices(view, offset);
    for (size_t i = 0; i < model->position_count; i++) {
        struct vec3 corner = model->positions[i];
        if (find_beyond(mat4_point(&to_clip, corner)) == 0) {
            view_add(view, corner, offset);
        }
    }
    return true;
}

static bool make_views(struct work *work, struct error *error) {
    bool done = true;
    work->to_screen = viewport(SIDE, SIDE);
    work->to_screen_float = float_matrix(&work->to_screen);
    for (int i = 0; done && i < (int)OFFSETS * CAMERAS; i++) {
        done = make_view(&work->views[i / CAMERAS][i % CAMERAS], &work->model,
                         &cameras[i % CAMERAS], i / CAMERAS, error);
    }
    return done;
}

static void free_views(struct work *work) {
    for (int i = 0; i < (int)OFFSETS * CAMERAS; i++) {
        struct view *view = &work->views[i / CAMERAS][i % CAMERAS];
        free(view->corners);
        free(view->corners_float);
        free(view->corners_fixed);
        free(view->screen);
    }
}

/* ---- Inverses ---- */

static inline void swap_rows(struct mat4 *a, int i, int k) {
    for (int column = 0; column < 4; column++) {
        double kept = a->m[i][column];
        a->m[i][column] = a->m[k][column];
        a->m[k][column] = kept;
    }
}

static inline int largest_below(const struct mat4 *a, int column) {
    int largest = column;
    for (int row = column + 1; row < 4; row++) {
        largest = fabs(a->m[row][column]) > fabs(a->m[largest][column]) ? row : largest;
    }
    return largest;
}

/* Gauss and Jordan: turn a into the identity column by column, and do the same to the identity. */
static inline bool gauss_jordan(struct mat4 a, struct mat4 *inverse, bool exchanging) {
    struct mat4 b = mat4_identity();
    for (int column = 0; column < 4; column++) {
        int best = exchanging ? largest_below(&a, column) : column;
        if (a.m[best][column] == 0) {
            return false;
        }
        swap_rows(&a, column, best);
        swap_rows(&b, column, best);
        double recip = 1 / a.m[column][column];
        for (int k = 0; k < 4; k++) {
            a.m[column][k] *= recip;
            b.m[column][k] *= recip;
        }
        for (int row = 0; row < 4; row++) {
            double factor = row == column ? 0 : a.m[row][column];
            for (int k = 0; k < 4; k++) {
                a.m[row][k] -= factor * a.m[column][k];
                b.m[row][k] -= factor * b.m[column][k];
            }
        }
    }
    *inverse = b;
    return true;
}

static bool gauss_jordan_as_is(struct mat4 a, struct mat4 *inverse) {
    return gauss_jordan(a, inverse, false);
}

static bool gauss_jordan_pivoting(struct mat4 a, struct mat4 *inverse) {
    return gauss_jordan(a, inverse, true);
}

enum inverter { COFACTORS_FLOAT, COFACTORS, AS_IS, PIVOTING, HOUSE_INVERSE };

static attempt_inverse *const inverters[] = {
    [COFACTORS_FLOAT] = attempt_12_cofactors_float,
    [COFACTORS] = attempt_11_cofactors,
    [AS_IS] = gauss_jordan_as_is,
    [PIVOTING] = gauss_jordan_pivoting,
    [HOUSE_INVERSE] = mat4_inverse,
};

/* A version: how to invert, and which condition the matrices have. */
#define INVERT(inverter, condition) ((int)(inverter)*CONDITIONS + (condition))

static void run_inverse(void *state, int choice) {
    struct work *work = state;
    const struct mat4 *matrices = work->matrices[choice % CONDITIONS];
    for (int i = 0; i < MATRICES; i++) {
        work->inverted[i] = inverters[choice / CONDITIONS](matrices[i], &work->inverses[i]);
    }
}

static double units_inverse(const void *state, int base) {
    (void)state;
    (void)base;
    return MATRICES;
}

static long double exact_inverse(const struct whole *a, int row, int column) {
    return (long double)oracle_inverse_numerator(a->m, row, column) /
           (long double)oracle_determinant(a->m);
}

/* The largest error of an entry as part of the largest entry; infinite without an inverse. */
static long double inverse_error(const struct whole *a, const struct mat4 *inverse) {
    long double worst = 0, largest = 0;
    for (int i = 0; i < 16; i++) {
        long double exact = exact_inverse(a, i / 4, i % 4);
        long double difference = fabsl(inverse->m[i / 4][i % 4] - exact);
        largest = fmaxl(largest, fabsl(exact));
        worst = fmaxl(worst, difference);
        if (!isfinite(inverse->m[i / 4][i % 4])) {
            return (long double)INFINITY;
        }
    }
    return worst / largest;
}

static double error_inverse(void *state, int choice) {
    struct work *work = state;
    long double worst = 0;
    for (int i = 0; i < MATRICES; i++) {
        if (!work->inverted[i]) {
            return (double)INFINITY;
        }
        worst =
            fmaxl(worst, inverse_error(&work->whole[choice % CONDITIONS][i], &work->inverses[i]));
    }
    return (double)worst;
}

/* The condition: the largest sum of a row, after rows are scaled to 1, times the inverse's. */
static long double condition_of(const struct whole *a) {
    long double scale[4], largest = 0;
    for (int row = 0; row < 4; row++) {
        scale[row] = 0;
        for (int column = 0; column < 4; column++) {
            scale[row] += fabsl((long double)a->m[row][column]);
        }
    }
    for (int row = 0; row < 4; row++) {
        long double sum = 0;
        for (int column = 0; column < 4; column++) {
            sum += fabsl(exact_inverse(a, row, column)) * scale[column];
        }
        largest = fmaxl(largest, sum);
    }
    return largest;
}

/* Add a multiple of one row to another: the determinant stays. False when entries are too large. */
static bool mix_rows(struct whole *a, struct random *random) {
    int to = (int)random_between(random, 0, 3);
    int from = (to + (int)random_between(random, 1, 3)) % 4;
    int64_t factor = random_between(random, -3, 3);
    bool fits = true;
    for (int column = 0; column < 4; column++) {
        a->m[to][column] += factor * a->m[from][column];
        fits = fits && a->m[to][column] <= ENTRY_LIMIT && a->m[to][column] >= -ENTRY_LIMIT;
    }
    return fits;
}

/* Entries that leave room for the rows to be mixed, but so large that products of three do not fit
 * into a double. */
static struct whole random_matrix(int bits, struct random *random) {
    struct whole a;
    int64_t most = bits < 40 ? 1 << (22 - bits / 2) : 3;
    for (int i = 0; i < 16; i++) {
        a.m[i / 4][i % 4] = random_between(random, -most, most);
    }
    return a;
}

/* Mix rows until the condition is that wanted, within a factor of 2. */
static void make_matrix(struct whole *a, int bits, struct random *random) {
    for (bool found = false; !found;) {
        *a = random_matrix(bits, random);
        long double ratio = 0;
        do {
            ratio = ldexpl(condition_of(a), -bits);
            found = ratio >= 0.5L && ratio <= 2;
        } while (!found && mix_rows(a, random));
    }
}

static void make_matrices(struct work *work) {
    struct random random = {8};
    for (int i = 0; i < CONDITIONS * MATRICES; i++) {
        struct whole *a = &work->whole[i / MATRICES][i % MATRICES];
        make_matrix(a, condition_bits[i / MATRICES], &random);
        for (int k = 0; k < 16; k++) {
            work->matrices[i / MATRICES][i % MATRICES].m[k / 4][k % 4] = (double)a->m[k / 4][k % 4];
        }
    }
}

/* ---- Perspective inside a triangle: a wall ---- */

/* What is linear along a row: depth, 1/w, and intensity, u and v divided by w. Affine ones take w
 * for 1. */
enum { ROW_DEPTH, ROW_RECIP_W, ROW_INTENSITY, ROW_U, ROW_V, ROW_VALUES };

struct wall_row {
    double begin[ROW_VALUES], step[ROW_VALUES];
};

static inline struct wall_row wall_row_at(const struct edges *edges, const struct vertex v[3],
                                          bool affine, int x, int y) {
    const double scale = 1 / (double)edges->area;
    const struct edge *e = edges->edge;
    struct vec3 weight = edges_weights(edges, x, y);
    struct vec3 step = {(double)e[0].dx * scale, (double)e[1].dx * scale, (double)e[2].dx * scale};
    double corner[ROW_VALUES][3];
    for (int i = 0; i < 3; i++) {
        corner[ROW_DEPTH][i] = v[i].depth;
        double recip_w = affine ? 1 : v[i].recip_w;
        corner[ROW_RECIP_W][i] = recip_w;
        corner[ROW_INTENSITY][i] = v[i].intensity * recip_w;
        corner[ROW_U][i] = v[i].uv.x * recip_w;
        corner[ROW_V][i] = v[i].uv.y * recip_w;
    }
    struct wall_row row;
    for (int i = 0; i < ROW_VALUES; i++) {
        row.begin[i] = interpolate(weight, corner[i][0], corner[i][1], corner[i][2]);
        row.step[i] = interpolate(step, corner[i][0], corner[i][1], corner[i][2]);
    }
    return row;
}

static inline double row_value(const struct wall_row *row, int which, double along) {
    return row->begin[which] + row->step[which] * along;
}

/* Intensity, u and v, with the one division. */
static inline struct vec3 row_attributes(const struct wall_row *row, bool affine, double along) {
    double w = affine ? 1 : 1 / row_value(row, ROW_RECIP_W, along);
    return (struct vec3){row_value(row, ROW_INTENSITY, along) * w, row_value(row, ROW_U, along) * w,
                         row_value(row, ROW_V, along) * w};
}

/* Some pixels of a row whose first is `from`, straight between the two ends. */
static inline void wall_stretch(const struct canvas *canvas, const struct wall_row *row,
                                bool affine, struct span pixels, int from, int y) {
    double *depths = canvas->depth + (size_t)y * canvas->image->width;
    int count = pixels.end - pixels.begin;
    struct vec3 at = row_attributes(row, affine, pixels.begin - from), step = {0, 0, 0};
    if (count > 1) {
        struct vec3 end = row_attributes(row, affine, pixels.end - from);
        step = vec3_scale(vec3_sub(end, at), 1.0 / count);
    }
    for (int i = 0; i < count; i++) {
        int x = pixels.begin + i;
        double depth = row_value(row, ROW_DEPTH, x - from);
        if (depth > depths[x]) {
            struct vec2 uv = {at.y + step.y * i, at.z + step.z * i};
            depths[x] = depth;
            image_set(canvas->image, x, y, shade(canvas->texture, uv, at.x + step.x * i));
        }
    }
}

/* Step 8's triangle() by rows, exact at both ends of every `stretch` pixels. */
static inline void draw_by_rows(int stretch, bool affine, const struct canvas *canvas,
                                const struct edges *edges, const struct vertex v[3]) {
    for (int y = edges->y_begin; y < edges->y_end; y++) {
        struct span span = edges_span(edges, y);
        struct wall_row row = wall_row_at(edges, v, affine, span.begin, y);
        for (int x = span.begin; x < span.end; x += stretch) {
            int end = stretch < span.end - x ? x + stretch : span.end;
            wall_stretch(canvas, &row, affine, (struct span){x, end}, span.begin, y);
        }
    }
}

#define BY_ROWS(name, stretch, affine)                                                             \
    static void name(const struct canvas *canvas, const struct edges *edges,                       \
                     const struct vertex v[3]) {                                                   \
        draw_by_rows(stretch, affine, canvas, edges, v);                                           \
    }

BY_ROWS(affine_by_rows, 1, true)
BY_ROWS(divided_every_1, 1, false)
BY_ROWS(divided_every_16, 16, false)
BY_ROWS(divided_every_64, 64, false)

typedef void draw_triangle(const struct canvas *canvas, const struct edges *edges,
                           const struct vertex v[3]);

enum wall {
    AFFINE_2,
    AFFINE_32,
    AFFINE_512,
    AFFINE_8192,
    EVERY_64,
    EVERY_16,
    EVERY_1,
    SCREEN_WEIGHTS,
    CORRECT_WEIGHTS
};

/* The wall is cut into `cuts` times `cuts` pieces of two triangles. */
static const struct {
    int cuts;
    draw_triangle *draw;
} walls[] = {
    [AFFINE_2] = {1, affine_by_rows},    [AFFINE_32] = {4, affine_by_rows},
    [AFFINE_512] = {16, affine_by_rows}, [AFFINE_8192] = {CUTS_MOST, affine_by_rows},
    [EVERY_64] = {1, divided_every_64},  [EVERY_16] = {1, divided_every_16},
    [EVERY_1] = {1, divided_every_1},    [SCREEN_WEIGHTS] = {1, attempt_15_affine_triangle},
    [CORRECT_WEIGHTS] = {1, triangle},
};

/* Where u = v = 0, and the sides along which u and v grow to 1. */
static const struct vec3 wall_corner = {-0.9, -0.47, 1.07};
static const struct vec3 wall_along_u = {1.83, 0, -2.97}, wall_along_v = {0, 0.9, 0};
enum { WALL_DISTANCE = 2 /* of the camera */ };

static void place_wall(struct work *work, int cuts) {
    struct mat4 to_clip = projection(WALL_DISTANCE);
    for (int i = 0; i < (cuts + 1) * (cuts + 1); i++) {
        struct vec2 uv = {(double)(i % (cuts + 1)) / cuts, (double)(i / (cuts + 1)) / cuts};
        struct vec3 p = vec3_add(vec3_scale(wall_along_u, uv.x), vec3_scale(wall_along_v, uv.y));
        place(mat4_point(&to_clip, vec3_add(wall_corner, p)), &work->to_screen, &work->wall[i]);
        work->wall[i].uv = uv;
        work->wall[i].intensity = 1;
    }
}

static void draw_corners(const struct canvas *canvas, draw_triangle *draw, const struct vertex *a,
                         const struct vertex *b, const struct vertex *c) {
    const struct vertex v[3] = {*a, *b, *c};
    struct edges edges;
    if (edges_setup(&edges, a->position, b->position, c->position, SIDE, SIDE)) {
        draw(canvas, &edges, v);
    }
}

static void run_wall(void *state, int choice) {
    struct work *work = state;
    struct canvas canvas = make_canvas(&work->drawing, &work->image, whole_image(&work->image));
    draw_triangle *draw = walls[choice].draw;
    int cuts = walls[choice].cuts;
    canvas.texture = &work->tiles;
    depth_clear(work->depth, (size_t)SIDE * SIDE);
    place_wall(work, cuts);
    for (int i = 0; i < cuts * cuts; i++) {
        const struct vertex *a = &work->wall[i / cuts * (cuts + 1) + i % cuts];
        const struct vertex *d = a + cuts + 1; /* above */
        draw_corners(&canvas, draw, a, a + 1, d + 1);
        draw_corners(&canvas, draw, a, d + 1, d);
    }
}

/* Where the ray through the centre of a pixel meets the wall: one row of the two equations
 * corner + u along_u + v along_v = ndc w, where w = 1 - z / distance. */
static void wall_equation(double corner, double along_u, double along_v, long double ndc,
                          long double equation[3]) {
    const long double scale = ndc / WALL_DISTANCE;
    equation[0] = along_u + scale * wall_along_u.z;
    equation[1] = along_v + scale * wall_along_v.z;
    equation[2] = ndc - scale * wall_corner.z - corner;
}

static struct vec2 exact_wall_uv(int x, int y) {
    long double a[3], b[3];
    wall_equation(wall_corner.x, wall_along_u.x, wall_along_v.x, (x + 0.5L) * 2 / SIDE - 1, a);
    wall_equation(wall_corner.y, wall_along_u.y, wall_along_v.y, (y + 0.5L) * 2 / SIDE - 1, b);
    long double determinant = a[0] * b[1] - a[1] * b[0];
    return (struct vec2){(double)((a[2] * b[1] - a[1] * b[2]) / determinant),
                         (double)((a[0] * b[2] - a[2] * b[0]) / determinant)};
}

static double error_wall(void *state, int choice) {
    struct work *work = state;
    double sum = 0, pixels = 0;
    (void)choice;
    for (int i = 0; i < SIDE * SIDE; i++) {
        if (!isinf(work->depth[i])) { /* drawn */
            struct vec2 uv = exact_wall_uv(i % SIDE, i / SIDE);
            double difference = image_get(&work->image, i % SIDE, i / SIDE).r -
                                (double)shade(&work->tiles, uv, 1).r;
            sum += difference * difference;
            pixels++;
        }
    }
    return sqrt(sum / pixels);
}

static bool make_wall_tiles(struct work *work, struct error *error) {
    struct image image;
    if (!image_create(&image, TILES_SIDE, TILES_SIDE, IMAGE_BGR, error)) {
        return false;
    }
    for (int y = 0; y < TILES_SIDE; y++) {
        for (int x = 0; x < TILES_SIDE; x++) {
            image_set(&image, x, y, color_grey((x / 32 + y / 32) % 2 == 0 ? 230 : 60));
        }
    }
    bool done = texture_create(&work->tiles, &image, error);
    image_free(&image);
    return done;
}

/* ---- Clipping: scene closeup ---- */

/* The lesson's way with other planes, in its own words: where to cut at the sides, in NDC, a power
 * of two; 0 for not at all. */
static bool is_cut(const struct position *p, double side) {
    double limit = side * p->clip.w;
    return !(p->clip.w >= near_w) ||
           (side > 0 && !(fabs(p->clip.x) <= limit && fabs(p->clip.y) <= limit));
}

/* clip_at_plane() cuts at guard_band: enlarge the polygon so that `side` comes to lie there. */
static void enlarge(struct polygon *polygon, double factor) {
    for (size_t i = 0; i < polygon->count; i++) {
        polygon->corner[i].clip.x *= factor;
        polygon->corner[i].clip.y *= factor;
    }
}

static struct polygon cut_face(struct position *const corner[3], double side) {
    struct polygon polygon = {.count = 3};
    for (int i = 0; i < 3; i++) {
        polygon.corner[i] = (struct clip_corner){corner[i]->clip, whole_face[i]};
    }
    polygon = clip_at_plane(&polygon, 0);
    if (side > 0) {
        enlarge(&polygon, guard_band / side);
        for (int plane = 1; plane < CLIP_PLANES; plane++) {
            polygon = clip_at_plane(&polygon, plane);
        }
        enlarge(&polygon, side / guard_band);
    }
    return polygon;
}

static void draw_cut_at(double side, struct drawing *drawing, struct canvas *canvas,
                        const struct mat4 *to_clip) {
    transform_positions(drawing, to_clip);
    for (size_t i = 0; i < drawing->model->face_count; i++) {
        struct position *corner[3];
        attempt_corners(drawing, i, corner);
        unsigned beyond = corner[0]->beyond & corner[1]->beyond & corner[2]->beyond;
        if ((beyond & ~(unsigned)BEYOND_GUARD_BAND) != 0) {
            continue;
        }
        if (is_cut(corner[0], side) || is_cut(corner[1], side) || is_cut(corner[2], side)) {
            struct polygon polygon = cut_face(corner, side);
            draw_clipped(drawing, canvas, i, &polygon);
        } else {
            draw_whole(drawing, canvas, i, corner);
        }
    }
}

static void draw_cut_near(struct drawing *drawing, struct canvas *canvas,
                          const struct mat4 *to_clip) {
    draw_cut_at(0, drawing, canvas, to_clip);
}

static void draw_cut_at_sides(struct drawing *drawing, struct canvas *canvas,
                              const struct mat4 *to_clip) {
    draw_cut_at(1, drawing, canvas, to_clip);
}

static void draw_without_skipping(struct drawing *drawing, struct canvas *canvas,
                                  const struct mat4 *to_clip) {
    drawing->skip = false;
    draw_model(drawing, canvas, to_clip);
    drawing->skip = true;
}

enum { UNCLIPPED, LEFT_OUT, NEAR_ONLY, CLIPPED, AT_SIDES, NOTHING_SKIPPED };

static attempt_draw *const draws[] = {
    [UNCLIPPED] = attempt_7_unclipped, [LEFT_OUT] = attempt_8_left_out,
    [NEAR_ONLY] = draw_cut_near,       [CLIPPED] = draw_model,
    [AT_SIDES] = draw_cut_at_sides,    [NOTHING_SKIPPED] = draw_without_skipping,
};

static void run_clip(void *state, int choice) {
    struct work *work = state;
    struct canvas canvas = make_canvas(&work->drawing, &work->small, whole_image(&work->small));
    depth_clear(work->depth, (size_t)SMALL_SIDE * SMALL_SIDE);
    work->drawing.counter_count = 0;
    draws[choice](&work->drawing, &canvas, &work->views[0][1].to_clip);
}

/* A face as rays see it: the ray through ndc (x, y) meets its plane at the sum of weight[i] times
 * corner i, where each weight is a linear function of x and y. The point's w is 1 / (sum of the
 * weights), so behind the camera it is negative. (Olano and Greer, "Triangle Scan Conversion using
 * 2D Homogeneous Coordinates", 1997.) */
struct ray_face {
    long double weight[3][3]; /* times x, times y, and what is added */
    long double z[3];
};

/* False where the face is seen from behind, or from the side. */
static bool make_ray_face(const struct vec4 clip[3], struct ray_face *face) {
    long double c[3][3], determinant = 0;
    for (int i = 0; i < 3; i++) {
        c[i][0] = clip[i].x;
        c[i][1] = clip[i].y;
        c[i][2] = clip[i].w;
        face->z[i] = clip[i].z;
    }
    for (int i = 0; i < 3; i++) {
        const long double *a = c[(i + 1) % 3], *b = c[(i + 2) % 3];
        face->weight[i][0] = a[1] * b[2] - a[2] * b[1];
        face->weight[i][1] = a[2] * b[0] - a[0] * b[2];
        face->weight[i][2] = a[0] * b[1] - a[1] * b[0];
    }
    for (int k = 0; k < 3; k++) {
        determinant += c[0][k] * face->weight[0][k];
    }
    for (int i = 0; i < 3 && determinant > 0; i++) {
        for (int k = 0; k < 3; k++) {
            face->weight[i][k] /= determinant;
        }
    }
    return determinant > 0;
}

struct box {
    struct span columns, rows;
};

/* Keep the face where it is nearest so far. */
static void find_face(const struct ray_face *face, struct box box, struct found *found) {
    long double right = 0, up = 0; /* what the depth gains */
    for (int i = 0; i < 3; i++) {
        right += face->weight[i][0] * face->z[i];
        up += face->weight[i][1] * face->z[i];
    }
    for (int y = box.rows.begin; y < box.rows.end; y++) {
        for (int x = box.columns.begin; x < box.columns.end; x++) {
            long double ndc_x = (x + 0.5L) * 2 / SMALL_SIDE - 1,
                        ndc_y = (y + 0.5L) * 2 / SMALL_SIDE - 1;
            long double sum = 0, depth = 0;
            bool inside = true;
            for (int i = 0; i < 3; i++) {
                const long double *f = face->weight[i];
                long double weight = f[0] * ndc_x + f[1] * ndc_y + f[2];
                inside = inside && weight >= 0;
                sum += weight;
                depth += weight * face->z[i];
            }
            struct found *here = &found[y * SMALL_SIDE + x];
            if (inside && sum * near_w <= 1 && depth > here->depth) {
                *here = (struct found){depth, (fabsl(right) + fabsl(up)) * 2 / SMALL_SIDE / 128};
            }
        }
    }
}

/* Let a span of pixels reach this place. */
static void widen(struct span *span, double place) {
    int first = (int)fmin(fmax(place, 0), SMALL_SIDE),
        end = (int)fmin(fmax(place, 0) + 1, SMALL_SIDE);
    span->begin = first < span->begin ? first : span->begin;
    span->end = end > span->end ? end : span->end;
}

/* Where a face may be seen: everywhere when it reaches behind the near plane. */
static struct box face_box(const struct vec4 clip[3]) {
    struct box box = {.columns = {SMALL_SIDE, 0}, .rows = {SMALL_SIDE, 0}};
    for (int i = 0; i < 3; i++) {
        if (clip[i].w < near_w) {
            return (struct box){.columns = {0, SMALL_SIDE}, .rows = {0, SMALL_SIDE}};
        }
        widen(&box.columns, (clip[i].x / clip[i].w + 1) * SMALL_SIDE / 2);
        widen(&box.rows, (clip[i].y / clip[i].w + 1) * SMALL_SIDE / 2);
    }
    return box;
}

static void find_all(struct work *work) {
    for (int i = 0; i < SMALL_SIDE * SMALL_SIDE; i++) {
        work->found[i] = (struct found){-(long double)INFINITY, 0};
    }
    for (size_t face = 0; face < work->model.face_count; face++) {
        struct vec4 clip[3];
        struct ray_face ray_face;
        bool in_front = false;
        for (size_t i = 0; i < 3; i++) {
            clip[i] = mat4_point(&work->views[0][1].to_clip, model_position(&work->model, face, i));
            in_front = in_front || clip[i].w >= near_w;
        }
        if (in_front && make_ray_face(clip, &ray_face)) {
            find_face(&ray_face, face_box(clip), work->found);
        }
    }
}

/* Pixels whose depth is not that of the exact point, or that show something where nothing is. */
static double error_clip(void *state, int choice) {
    struct work *work = state;
    size_t wrong = 0;
    (void)choice;
    for (size_t i = 0; i < (size_t)SMALL_SIDE * SMALL_SIDE; i++) {
        long double depth = work->depth[i], exact = work->found[i].depth;
        bool right = isinf(exact) ? depth == exact
                                  : fabsl(depth - exact) <= work->found[i].tolerance + 1e-9L;
        wrong += !right;
    }
    return (double)wrong;
}

/* ---- Setting up ---- */

static bool make_state(struct work *work, struct error *error) {
    struct model *model = &work->model;
    if (!bench_read_model(model, "bust.obj", error) || !model_need_normals(model, error)) {
        return false;
    }
    work->depth = malloc((size_t)SIDE * SIDE * sizeof *work->depth);
    work->found = malloc((size_t)SMALL_SIDE * SMALL_SIDE * sizeof *work->found);
    if (work->depth == NULL || work->found == NULL) {
        return error_out_of_memory(error);
    }
    work->drawing = (struct drawing){
        .model = model,
        .diffuse = model_texture(model, MODEL_DIFFUSE, error),
        .depth = work->depth,
        .light = {1, 1, 2},
        .skip = true,
        .state = &work->state,
    };
    return work->drawing.diffuse != NULL && prepare(&work->drawing, SIDE, SIDE, error) &&
           image_create(&work->image, SIDE, SIDE, IMAGE_BGR, error) &&
           image_create(&work->small, SMALL_SIDE, SMALL_SIDE, IMAGE_BGR, error);
}

static bool setup(void *state, struct error *error) {
    struct work *work = state;
    if (!make_state(work, error) || !make_views(work, error) || !make_wall_tiles(work, error)) {
        return false;
    }
    make_matrices(work);
    find_all(work);
    return true;
}

static void teardown(void *state) {
    struct work *work = state;
    free(work->state.positions);
    free(work->depth);
    model_free(&work->model);
    image_free(&work->image);
    image_free(&work->small);
    texture_free(&work->tiles);
    free_views(work);
    free(work->found);
}

/* ---- The panels ---- */

static const char *chain_series(int choice) {
    static const char *const names[] = {
        [IN_FLOAT] = "float", [IN_DOUBLE] = "double", [IN_FIXED] = "16.16"};
    return names[choice / (int)OFFSETS];
}

static const struct bench_version chain_versions[] = {
    VERSION("0", CHAIN(IN_FIXED, 0)),
    VERSION("1,000", CHAIN(IN_FIXED, 1)),
    VERSION("0", CHAIN(IN_FLOAT, 0)),
    VERSION("1,000", CHAIN(IN_FLOAT, 1)),
    VERSION("10^6", CHAIN(IN_FLOAT, 2)),
    VERSION("10^6 in the matrix", CHAIN(IN_FLOAT, IN_MATRIX)),
    HOUSE_VERSION("0", CHAIN(IN_DOUBLE, 0)),
    HOUSE_VERSION("1,000", CHAIN(IN_DOUBLE, 1)),
    HOUSE_VERSION("10^6", CHAIN(IN_DOUBLE, 2)),
};

static const char *inverse_series(int choice) {
    static const char *const names[] = {
        [COFACTORS_FLOAT] = "cofactors, float",
        [COFACTORS] = "cofactors",
        [AS_IS] = "no pivoting",
        [PIVOTING] = "Gauss-Jordan",
        [HOUSE_INVERSE] = "mat4_inverse()",
    };
    return names[choice / CONDITIONS];
}

static const struct bench_version inverse_versions[] = {
    VERSION("2^4", INVERT(COFACTORS_FLOAT, 0)),
    VERSION("2^12", INVERT(COFACTORS_FLOAT, 1)),
    VERSION("2^24", INVERT(COFACTORS_FLOAT, 2)),
    VERSION("2^4", INVERT(COFACTORS, 0)),
    VERSION("2^12", INVERT(COFACTORS, 1)),
    VERSION("2^24", INVERT(COFACTORS, 2)),
    VERSION("2^36", INVERT(COFACTORS, 3)),
    VERSION("2^48", INVERT(COFACTORS, 4)),
    VERSION("2^4", INVERT(AS_IS, 0)),
    VERSION("2^12", INVERT(AS_IS, 1)),
    VERSION("2^24", INVERT(AS_IS, 2)),
    VERSION("2^36", INVERT(AS_IS, 3)),
    VERSION("2^48", INVERT(AS_IS, 4)),
    VERSION("2^4", INVERT(PIVOTING, 0)),
    VERSION("2^12", INVERT(PIVOTING, 1)),
    VERSION("2^24", INVERT(PIVOTING, 2)),
    VERSION("2^36", INVERT(PIVOTING, 3)),
    VERSION("2^48", INVERT(PIVOTING, 4)),
    HOUSE_VERSION("2^4", INVERT(HOUSE_INVERSE, 0)),
    HOUSE_VERSION("2^12", INVERT(HOUSE_INVERSE, 1)),
    HOUSE_VERSION("2^24", INVERT(HOUSE_INVERSE, 2)),
    HOUSE_VERSION("2^36", INVERT(HOUSE_INVERSE, 3)),
    HOUSE_VERSION("2^48", INVERT(HOUSE_INVERSE, 4)),
};

static const char *wall_series(int choice) {
    return choice <= AFFINE_8192 ? "affine by rows, triangles"
           : choice <= EVERY_1   ? "divided by rows, every"
                                 : NULL;
}

static const struct bench_version wall_versions[] = {
    VERSION("2", AFFINE_2),
    VERSION("32", AFFINE_32),
    VERSION("512", AFFINE_512),
    VERSION("8,192", AFFINE_8192),
    VERSION("64 pixels", EVERY_64),
    VERSION("16 pixels", EVERY_16),
    VERSION("pixel", EVERY_1),
    VERSION("screen's weights (affine)", SCREEN_WEIGHTS),
    HOUSE_VERSION("correct weights", CORRECT_WEIGHTS),
};

static const struct bench_version clip_versions[] = {
    VERSION("not clipped", UNCLIPPED),
    VERSION("crossing faces left out", LEFT_OUT),
    VERSION("cut at the near plane", NEAR_ONLY),
    HOUSE_VERSION("also at 64: the lesson", CLIPPED),
    VERSION("also at the picture's sides", AT_SIDES),
    VERSION("the lesson, none skipped", NOTHING_SKIPPED),
};

static const struct bench_panel bench_panels[] = {
    {.title = "Corners to the screen; the world moved by 0 to 10^6",
     .error_label = "1/256 pixel, the largest",
     .time_label = "ns per corner",
     .against = "long double",
     .run = run_chain,
     .error = error_chain,
     .units = units_chain,
     BENCH_VERSIONS(chain_versions),
     .series = chain_series},
    {.title = "Inverses of matrices of condition 2^4 to 2^48",
     .error_label = "largest error of an entry, as part of the largest entry",
     .time_label = "ns per inverse",
     .against = "exact fractions",
     .run = run_inverse,
     .error = error_inverse,
     .units = units_inverse,
     BENCH_VERSIONS(inverse_versions),
     .series = inverse_series},
    {.title = "A wall with tiles that goes away from us",
     .error_label = "levels, root mean square",
     .time_label = "ms per frame",
     .against = "long double",
     .run = run_wall,
     .error = error_wall,
     BENCH_VERSIONS(wall_versions),
     .series = wall_series},
    {.title = "Close up: faces reach behind the camera, 200x200 pixels",
     .error_label = "pixels wrong of 40,000",
     .time_label = "ms per frame",
     .against = "rays, long double",
     .run = run_clip,
     .error = error_clip,
     BENCH_VERSIONS(clip_versions)},
};

const struct bench_lesson bench_step08 = {
    .step = "step08_projection",
    .title = "Step 8: perspective",
    .state_size = sizeof(struct work),
    .setup = setup,
    .teardown = teardown,
    .panels = bench_panels,
    .panel_count = sizeof bench_panels / sizeof bench_panels[0],
};
