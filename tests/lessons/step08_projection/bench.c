/*
 * Lesson 8: precision on the way to the screen, inverses, clipping.
 *
 * The exact answers are long double for positions, fractions of 128-bit integers for the inverses,
 * and for the clipped picture a ray through every pixel, which needs no clipping and no snapping.
 */
#define LESSON "../step08_projection/main.c"
#include "lesson.h"

#include "../../../step08_projection/attempts.h"

#include "bench/bench.h"
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

/* Points and matrices of float. */
struct vec3_float {
    float x, y, z;
};

struct mat4_float {
    float m[4][4];
};

/* How far model and camera are moved, in all three directions. */
static const double offsets[] = {0, 1e3, 1e6};
enum { OFFSETS = sizeof offsets / sizeof offsets[0] };

/* The corners that a camera sees, prepared for each type of number. */
struct view {
    struct camera camera; /* moved */
    size_t count;
    struct vec3 *corners; /* moved */
    struct vec3_float *corners_float;
    struct mat4 to_clip;
    struct mat4_float to_clip_float;
    struct vec2 *screen; /* what a version finds */
};

enum { CONDITIONS = 5, MATRICES = 32, ENTRY_LIMIT = 1 << 24 /* of the oracle */ };
static const int condition_bits[CONDITIONS] = {4, 12, 24, 36, 48};

/* A matrix of whole numbers. */
struct whole {
    int64_t m[4][4];
};

/* What a ray finds behind the centre of a pixel. */
struct found {
    long double depth;     /* z/w; minus infinity where there is nothing */
    long double tolerance; /* what the depth may be off when corners are moved by 1/128 pixel */
};

static struct {
    struct model model;
    struct drawing drawing;
    double depth[SMALL_SIDE * SMALL_SIDE];
    struct image small;
    struct mat4 to_screen;
    struct mat4_float to_screen_float;
    struct view views[OFFSETS][CAMERAS];
    struct whole whole[CONDITIONS][MATRICES];
    struct mat4 matrices[CONDITIONS][MATRICES], inverses[MATRICES];
    bool inverted[MATRICES];
    struct found found[SMALL_SIDE * SMALL_SIDE]; /* in scene closeup */
    size_t corner_count, matrix_count;           /* of a run */
} work;

/* ---- Corners to the screen ---- */

enum number { IN_FLOAT, IN_DOUBLE };

/* What mat4_point() and place() compute, in either type. */
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

static void run_chain(struct bench_choice choice) {
    for (int k = 0; k < CAMERAS; k++) {
        struct view *v = &work.views[choice.on][k];
        if (choice.way == IN_FLOAT) {
            transform_float(v->count, v->corners_float, &v->to_clip_float, &work.to_screen_float,
                            v->screen);
        } else {
            transform_double(v->count, v->corners, &v->to_clip, &work.to_screen, v->screen);
        }
    }
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

static double error_chain(struct bench_choice choice) {
    long double worst = 0;
    for (int k = 0; k < CAMERAS; k++) {
        const struct view *view = &work.views[choice.on][k];
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

static void make_view(struct view *view, const struct model *model, const struct camera *camera,
                      double by) {
    struct mat4 to_clip = camera_matrix(camera);
    view->camera = moved_camera(*camera, by);
    view->corners = bench_memory(model->position_count, sizeof *view->corners);
    view->corners_float = bench_memory(model->position_count, sizeof *view->corners_float);
    view->screen = bench_memory(model->position_count, sizeof *view->screen);
    view->to_clip = camera_matrix(&view->camera);
    view->to_clip_float = float_matrix(&view->to_clip);
    for (size_t i = 0; i < model->position_count; i++) {
        struct vec3 corner = model->positions[i];
        if (find_beyond(mat4_point(&to_clip, corner)) == 0) {
            struct vec3 p = {corner.x + by, corner.y + by, corner.z + by};
            view->corners[view->count] = p;
            view->corners_float[view->count++] =
                (struct vec3_float){(float)p.x, (float)p.y, (float)p.z};
        }
    }
}

static void make_views(void) {
    work.to_screen = viewport(SIDE, SIDE);
    work.to_screen_float = float_matrix(&work.to_screen);
    for (int i = 0; i < (int)OFFSETS * CAMERAS; i++) {
        make_view(&work.views[i / CAMERAS][i % CAMERAS], &work.model, &cameras[i % CAMERAS],
                  offsets[i / CAMERAS]);
    }
    work.corner_count = work.views[0][0].count + work.views[0][1].count;
}

/* ---- Inverses ---- */

enum inverter { COFACTORS_FLOAT, COFACTORS, HOUSE_INVERSE };

static attempt_inverse *const inverters[] = {
    [COFACTORS_FLOAT] = attempt_12_cofactors_float,
    [COFACTORS] = attempt_11_cofactors,
    [HOUSE_INVERSE] = mat4_inverse,
};

static void run_inverse(struct bench_choice choice) {
    const struct mat4 *matrices = work.matrices[choice.on];
    for (int i = 0; i < MATRICES; i++) {
        work.inverted[i] = inverters[choice.way](matrices[i], &work.inverses[i]);
    }
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

static double error_inverse(struct bench_choice choice) {
    long double worst = 0;
    for (int i = 0; i < MATRICES; i++) {
        if (!work.inverted[i]) {
            return (double)INFINITY;
        }
        worst = fmaxl(worst, inverse_error(&work.whole[choice.on][i], &work.inverses[i]));
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

static void make_matrices(void) {
    struct random random = {8};
    work.matrix_count = MATRICES;
    for (int i = 0; i < CONDITIONS * MATRICES; i++) {
        struct whole *a = &work.whole[i / MATRICES][i % MATRICES];
        make_matrix(a, condition_bits[i / MATRICES], &random);
        for (int k = 0; k < 16; k++) {
            work.matrices[i / MATRICES][i % MATRICES].m[k / 4][k % 4] = (double)a->m[k / 4][k % 4];
        }
    }
}

/* ---- Clipping: scene closeup ---- */

enum clipping { UNCLIPPED, LEFT_OUT, CUT };

static attempt_clipping *const clippings[] = {
    [UNCLIPPED] = attempt_7_unclipped,
    [LEFT_OUT] = attempt_8_left_out,
    [CUT] = clip_face,
};

static void run_clip(struct bench_choice choice) {
    const struct canvas canvas =
        make_canvas(&work.drawing, &work.small, whole_image(&work.small), work.views[0][1].to_clip);
    depth_clear(work.depth, (size_t)SMALL_SIDE * SMALL_SIDE);
    for (size_t face = 0; face < work.model.face_count; face++) {
        struct face_corner corner[3];
        fetch_face(&work.model, face, corner);
        struct polygon polygon = transform_face(&canvas, corner);
        clippings[choice.way](&polygon);
        if (polygon.count > 0) {
            draw_polygon(&canvas, corner, &polygon);
        }
    }
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

/* Keep the face where it is nearest so far. */
static void find_face(const struct ray_face *face, struct found *found) {
    long double right = 0, up = 0; /* what the depth gains */
    for (int i = 0; i < 3; i++) {
        right += face->weight[i][0] * face->z[i];
        up += face->weight[i][1] * face->z[i];
    }
    for (int i = 0; i < SMALL_SIDE * SMALL_SIDE; i++) {
        long double x = (i % SMALL_SIDE + 0.5L) * 2 / SMALL_SIDE - 1;
        long double y = (i / SMALL_SIDE + 0.5L) * 2 / SMALL_SIDE - 1;
        long double sum = 0, depth = 0;
        bool inside = true;
        for (int k = 0; k < 3 && inside; k++) {
            const long double *f = face->weight[k];
            long double weight = f[0] * x + f[1] * y + f[2];
            inside = weight >= 0;
            sum += weight;
            depth += weight * face->z[k];
        }
        if (inside && sum * near_w <= 1 && depth > found[i].depth) {
            found[i] = (struct found){depth, (fabsl(right) + fabsl(up)) * 2 / SMALL_SIDE / 128};
        }
    }
}

static void find_all(void) {
    for (int i = 0; i < SMALL_SIDE * SMALL_SIDE; i++) {
        work.found[i] = (struct found){-(long double)INFINITY, 0};
    }
    for (size_t face = 0; face < work.model.face_count; face++) {
        struct vec4 clip[3];
        struct ray_face ray_face;
        bool in_front = false;
        for (size_t i = 0; i < 3; i++) {
            clip[i] = mat4_point(&work.views[0][1].to_clip, model_position(&work.model, face, i));
            in_front = in_front || clip[i].w >= near_w;
        }
        if (in_front && make_ray_face(clip, &ray_face)) {
            find_face(&ray_face, work.found);
        }
    }
}

/* Pixels whose depth is not that of the exact point, or that show something where nothing is. */
static double error_clip(struct bench_choice choice) {
    size_t wrong = 0;
    (void)choice;
    for (size_t i = 0; i < (size_t)SMALL_SIDE * SMALL_SIDE; i++) {
        long double depth = work.depth[i], exact = work.found[i].depth;
        bool right =
            isinf(exact) ? depth == exact : fabsl(depth - exact) <= work.found[i].tolerance + 1e-9L;
        wrong += !right;
    }
    return (double)wrong;
}

/* ---- Setting up ---- */

static bool setup(struct error *error) {
    struct model *model = &work.model;
    if (!model_read(model, BENCH_MODEL("bust.obj"), error) || !model_need_normals(model, error)) {
        return false;
    }
    work.drawing = (struct drawing){
        .model = model,
        .diffuse = model_texture(model, MODEL_DIFFUSE, error),
        .depth = work.depth,
        .light = {1, 1, 2},
    };
    if (work.drawing.diffuse == NULL ||
        !image_create(&work.small, SMALL_SIDE, SMALL_SIDE, IMAGE_BGR, error)) {
        return false;
    }
    make_views();
    make_matrices();
    find_all();
    return true;
}

/* ---- The panels ---- */

static const struct bench_version chain_versions[] = {
    VERSION_OF("float", "0", IN_FLOAT, 0),
    VERSION_OF("float", "1,000", IN_FLOAT, 1),
    VERSION_OF("float", "10^6", IN_FLOAT, 2),
    HOUSE_VERSION_OF("double", "0", IN_DOUBLE, 0),
    HOUSE_VERSION_OF("double", "1,000", IN_DOUBLE, 1),
    HOUSE_VERSION_OF("double", "10^6", IN_DOUBLE, 2),
};

static const struct bench_version inverse_versions[] = {
    VERSION_OF("cofactors, float", "2^4", COFACTORS_FLOAT, 0),
    VERSION_OF("cofactors, float", "2^12", COFACTORS_FLOAT, 1),
    VERSION_OF("cofactors, float", "2^24", COFACTORS_FLOAT, 2),
    VERSION_OF("cofactors", "2^4", COFACTORS, 0),
    VERSION_OF("cofactors", "2^12", COFACTORS, 1),
    VERSION_OF("cofactors", "2^24", COFACTORS, 2),
    VERSION_OF("cofactors", "2^36", COFACTORS, 3),
    VERSION_OF("cofactors", "2^48", COFACTORS, 4),
    HOUSE_VERSION_OF("mat4_inverse()", "2^4", HOUSE_INVERSE, 0),
    HOUSE_VERSION_OF("mat4_inverse()", "2^12", HOUSE_INVERSE, 1),
    HOUSE_VERSION_OF("mat4_inverse()", "2^24", HOUSE_INVERSE, 2),
    HOUSE_VERSION_OF("mat4_inverse()", "2^36", HOUSE_INVERSE, 3),
    HOUSE_VERSION_OF("mat4_inverse()", "2^48", HOUSE_INVERSE, 4),
};

static const struct bench_version clip_versions[] = {
    VERSION("not clipped", UNCLIPPED),
    VERSION("crossing faces left out", LEFT_OUT),
    HOUSE_VERSION("cut: the lesson", CUT),
};

static const struct bench_panel bench_panels[] = {
    {.title = "Corners to the screen; the world moved by 0 to 10^6",
     .error_label = "1/256 pixel, the largest",
     .time_label = "ns per corner",
     .against = "long double",
     .run = run_chain,
     .error = error_chain,
     .units = &work.corner_count,
     .many_inputs = true,
     BENCH_VERSIONS(chain_versions)},
    {.title = "Inverses of matrices of condition 2^4 to 2^48",
     .error_label = "largest error of an entry, as part of the largest entry",
     .time_label = "ns per inverse",
     .against = "exact fractions",
     .run = run_inverse,
     .error = error_inverse,
     .units = &work.matrix_count,
     .many_inputs = true,
     BENCH_VERSIONS(inverse_versions)},
    {.title = "Close up: faces reach behind the camera, 200x200 pixels",
     .error_label = "pixels wrong of 40,000",
     .time_label = "ms per frame",
     .against = "rays, long double",
     .run = run_clip,
     .error = error_clip,
     BENCH_VERSIONS(clip_versions)},
};

const struct bench_lesson bench_step08 =
    BENCH_LESSON("step08_projection", "Lesson 8: perspective", setup, bench_panels);
