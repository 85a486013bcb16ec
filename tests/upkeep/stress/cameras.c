/* Cameras and matrices under hostile numbers. */
#include "oracle/shown.h"
#include "pipeline.h"
#include "stress.h"

/* A number of any size and sign, zero and powers of two among them. */
static double any_number(struct random *random, int exponent) {
    switch (random_bits(random) % 8) {
    case 0:
        return 0;
    case 1:
        return ldexp(random_bits(random) % 2 ? 1 : -1,
                     (int)random_between(random, -exponent, exponent));
    case 2:
        return random_real(random, -1, 1);
    default:
        return ldexp(random_real(random, -1, 1), (int)random_between(random, -exponent, exponent));
    }
}

static struct vec3 any_vector(struct random *random, int exponent) {
    if (random_bits(random) % 4 == 0) {
        exponent = 2;
    }
    struct vec3 v;
    v.x = any_number(random, exponent);
    v.y = any_number(random, exponent);
    v.z = any_number(random, exponent);
    return v;
}

/* ---- Cameras ---- */

struct camera_case {
    struct vec3 eye, center, up;
    double zoom;
    struct vec3 corner[4]; /* of a tetrahedron to look at */
};

static void make_camera(struct random *random, uint64_t index, void *made) {
    struct camera_case *c = made;
    static const int exponents[] = {2, 20, 100, 1000};
    int exponent = exponents[index % 4];
    c->eye = any_vector(random, exponent);
    c->center = any_vector(random, exponent);
    c->up = any_vector(random, exponent);
    switch (index / 4 % 8) {
    case 0: /* up along the view direction, or nearly so */
        c->up = vec3_sub(c->eye, c->center);
        c->up.x += ldexp(1, -(int)random_between(random, 10, 70));
        break;
    case 1:
        c->up = vec3_scale(vec3_sub(c->center, c->eye), random_real(random, 0, 3));
        break;
    case 2:
        c->center = c->eye;
        break;
    case 3: /* very near to each other */
        c->center = c->eye;
        c->center.z += ldexp(1, -(int)random_between(random, 20, 60));
        break;
    case 4: /* so far from each other that their difference may be no number */
        c->eye = vec3_scale(any_vector(random, 0), 0x1p1021);
        c->center = vec3_scale(c->eye, -1);
        break;
    default:
        break;
    }
    c->zoom = random_bits(random) % 4 ? random_real(random, 0.1, 2) : any_number(random, 60);
    double places[12];
    for (int i = 0; i < 12; i++) {
        /* Around the center, at the eye, or anywhere. */
        double near_to[3] = {c->center.x, c->center.y, c->center.z};
        double at = index % 3 == 0 ? near_to[i % 3] : index % 3 == 1 ? 0 : any_number(random, 120);
        double place = at + random_real(random, -2, 2);
        place = place > 3e38 ? 3e38 : place < -3e38 ? -3e38 : place; /* as in files */
        places[i] = place;
    }
    for (int i = 0; i < 4; i++) {
        c->corner[i] = (struct vec3){places[3 * i], places[3 * i + 1], places[3 * i + 2]};
    }
}

static struct real3 view_row(const struct mat4 *view, int row) {
    const double *m = view->m[row];
    return (struct real3){m[0], m[1], m[2]};
}

/* The larger one; what is no number counts as infinite. */
static long double worse(long double a, long double b) {
    return isnan(b) ? (long double)INFINITY : fmaxl(a, b);
}

/* How far the three rows are from unit length and right angles, in ulp of 1; infinite where the
 * third points against the cross product of the others. */
static double view_frame_error(const struct mat4 *view) {
    const struct real3 rows[3] = {view_row(view, 0), view_row(view, 1), view_row(view, 2)};
    bool right_handed = real3_dot(real3_cross(rows[0], rows[1]), rows[2]) > 0;
    long double worst = 0;
    for (int i = 0; i < 3; i++) {
        worst = worse(worst, fabsl(real3_dot(rows[i], rows[i]) - 1));
        worst = worse(worst, fabsl(real3_dot(rows[i], rows[(i + 1) % 3])));
    }
    return right_handed ? (double)worst * 0x1p52 : (double)INFINITY;
}

/* How far they are from the oracle's axes, in ulp of 1, where these are certain. The smaller the
 * angle between up and the line of sight, the less is asked of the first two. */
static double view_axes_error(const struct mat4 *view, const struct camera_case *c) {
    struct oracle_frame frame = oracle_frame(c->eye, c->center, c->up);
    const long double certainty[3] = {frame.sine, frame.sine, real3_length(frame.axis[2])};
    long double worst = 0;
    for (int row = 0; row < 3; row++) {
        struct real3 off = real3_sub(view_row(view, row), frame.axis[row]);
        worst = worse(worst, certainty[row] * real3_length(off));
    }
    return (double)worst * 0x1p52;
}

/* Does the center become the origin, as nearly as its products with the axes can be added? */
static bool view_moves_center(const struct mat4 *view, struct vec3 center) {
    for (int row = 0; row < 3; row++) {
        const double *m = view->m[row];
        long double x = (long double)m[0] * (long double)center.x;
        long double y = (long double)m[1] * (long double)center.y;
        long double z = (long double)m[2] * (long double)center.z;
        long double allowed = 0x1p-51L * (fabsl(x) + fabsl(y) + fabsl(z)) + 0x1p-1073L;
        if (!(fabsl(x + y + z + (long double)m[3]) <= allowed)) {
            return false;
        }
    }
    return true;
}

static double frame_error(const void *tried) {
    const struct camera_case *c = tried;
    struct mat4 view = mat4_lookat(c->eye, c->center, c->up);
    return view_frame_error(&view);
}

static double axes_error(const void *tried) {
    const struct camera_case *c = tried;
    struct mat4 view = mat4_lookat(c->eye, c->center, c->up);
    return view_axes_error(&view, c);
}

enum { SIZE = 6 };

static void corner_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct model *model = *(const struct model *const *)uniforms;
    /* In floats there must be room for differences, and for slopes across a sliver. */
    const double room = sizeof(real) == sizeof(float) ? 0x1p-120 : 1;
    struct vec3 p = vec3_scale(model_position(model, face, corner), room);
    varyings[0] = p.x;
    varyings[1] = p.y;
    varyings[2] = p.z;
}

enum { FINITE = 1, NOT_FINITE = 2 }; /* levels */

static lanes_mask finite_fragment(const void *uniforms, const lanes *varyings, lanes_texel *color) {
    (void)uniforms;
    lanes sum = 0 * varyings[0] + 0 * varyings[1] + 0 * varyings[2]; /* 0 of what is finite */
    lanes level = lanes_select(sum == 0, lanes_all(FINITE), lanes_all(NOT_FINITE));
    *color = lanes_rgb(level, level, level);
    return lanes_all_set();
}

SHADER(finite_shader, .varying_count = 3, .vertex = corner_vertex, .fragment = finite_fragment);

static bool camera_draws_finite_pixels(const void *tried) {
    struct camera_case c = *(const struct camera_case *)tried;
    static const uint32_t corners[4][3] = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
    struct face faces[4];
    struct model model = plain_model(c.corner, 4, faces, 4, corners);
    struct error error;
    struct pipeline pipeline;
    uint8_t pixels[SIZE * SIZE * 3] = {0};
    struct image image = {SIZE, SIZE, IMAGE_BGR, pixels};
    const struct model *uniforms = &model;
    struct draw_call call = camera_call(&model, c.eye, c.center, c.up, c.zoom,
                                        (struct rectangle){0, 0, SIZE, SIZE}, CULL_NONE);
    if (!pipeline_create(&pipeline, SIZE, SIZE, &error)) {
        return false;
    }
    pipeline.keep_depth = true;
    bool done =
        pipeline_draw(&pipeline, &call, &finite_shader, &uniforms, sizeof(void *), &error) &&
        pipeline_finish(&pipeline, &image, &error);
    bool all_finite = true;
    for (int i = 0; done && i < SIZE * SIZE; i++) {
        all_finite = all_finite && pixels[3 * i] != NOT_FINITE &&
                     (isfinite(pipeline.depth[i]) || pipeline.depth[i] == -INFINITY);
    }
    pipeline_free(&pipeline);
    return done && all_finite;
}

static bool camera_is_sound(const void *tried) {
    const struct camera_case *c = tried;
    struct mat4 view = mat4_lookat(c->eye, c->center, c->up);
    return view_moves_center(&view, c->center) && camera_draws_finite_pixels(tried);
}

/* ---- Matrices ---- */

/* Small whole numbers, whose determinant is known exactly: singular or not. And rows scaled by
 * powers of two, which change nothing but the columns of the inverse. */
struct matrix_case {
    int64_t whole[4][4];
    int exponent[4];
};

static void make_matrix(struct random *random, uint64_t index, void *made) {
    struct matrix_case *c = made;
    for (int i = 0; i < 16; i++) {
        c->whole[i / 4][i % 4] = random_between(random, -9, 9);
        c->exponent[i / 4] = index % 3 == 0 ? (int)random_between(random, -30, 30) : 0;
    }
    int row = (int)random_between(random, 0, 3);
    for (int column = 0; index % 2 == 0 && column < 4; column++) { /* often singular */
        int64_t p = c->whole[(row + 1) % 4][column], q = c->whole[(row + 2) % 4][column];
        c->whole[row][column] = index % 4 == 0 ? p : 2 * p - 3 * q;
    }
}

static struct mat4 scaled_matrix(const struct matrix_case *c) {
    struct mat4 a;
    for (int i = 0; i < 16; i++) {
        a.m[i / 4][i % 4] = ldexp((double)c->whole[i / 4][i % 4], c->exponent[i / 4]);
    }
    return a;
}

/* The largest sum of a row, without its scale. */
static long double row_norm(const struct mat4 *a, const int exponent[4]) {
    long double norm = 0;
    for (int row = 0; row < 4; row++) {
        long double sum = 0;
        for (int column = 0; column < 4; column++) {
            sum += fabsl((long double)a->m[row][column]);
        }
        norm = fmaxl(norm, ldexpl(sum, -exponent[row]));
    }
    return norm;
}

/* The largest error of an entry against the exact fraction, in units of eps * condition * the
 * largest entry. */
static double inverse_error(const void *tried) {
    static const int unscaled[4] = {0, 0, 0, 0};
    const struct matrix_case *c = tried;
    const struct mat4 a = scaled_matrix(c);
    struct mat4 inverse;
    int128 determinant = oracle_determinant(c->whole);
    if (determinant == 0 || !mat4_inverse(a, &inverse)) {
        return 0;
    }
    long double worst = 0, largest = 0;
    for (int i = 0; i < 16; i++) {
        int128 numerator = oracle_inverse_numerator(c->whole, i / 4, i % 4);
        long double exact = (long double)numerator / (long double)determinant;
        double *entry = &inverse.m[i / 4][i % 4];
        *entry = ldexp(*entry, c->exponent[i % 4]);
        worst = fmaxl(worst, fabsl((long double)*entry - exact));
        largest = fmaxl(largest, fabsl(exact));
    }
    long double condition = row_norm(&a, c->exponent) * row_norm(&inverse, unscaled);
    return (double)(worst / (0x1p-53L * condition * largest));
}

static bool singular_is_reported(const void *tried) {
    const struct matrix_case *c = tried;
    struct mat4 inverse;
    return mat4_inverse(scaled_matrix(c), &inverse) == (oracle_determinant(c->whole) != 0);
}

/* ---- Angles ---- */

static void make_turns(struct random *random, uint64_t index, void *made) {
    double *turns = made;
    *turns = index % 3 ? random_real(random, -2, 2) : ldexp(random_real(random, -1, 1), 40);
}

static double direction_error(const void *tried) {
    double turns = *(const double *)tried;
    struct vec2 d = turn_direction(turns);
    long double part = (long double)turns - floorl((long double)turns);
    long double angle = 2 * acosl(-1) * part;
    return (double)fmaxl(fabsl((long double)d.x - cosl(angle)),
                         fabsl((long double)d.y - sinl(angle))) *
           0x1p52;
}

const struct property camera_properties[] = {
    PROPERTY("camera: orthonormal, finite pixels", AGAINST_BOUNDS, 1000000, struct camera_case,
             make_camera, .error = frame_error, .limit = 4, .error_unit = "ulp of 1",
             .holds = camera_is_sound),
    PROPERTY("camera: axes", AGAINST_LONG_DOUBLE, 300000, struct camera_case, make_camera,
             .error = axes_error, .limit = 4, .error_unit = "ulp of 1"),
    PROPERTY("matrix: inverse", AGAINST_FRACTIONS, 300000, struct matrix_case, make_matrix,
             .error = inverse_error, .limit = 4, .error_unit = "eps * condition * entry"),
    PROPERTY("matrix: singular is reported", AGAINST_INTEGERS, 500000, struct matrix_case,
             make_matrix, .holds = singular_is_reported),
    PROPERTY("camera: direction of a turn", AGAINST_LONG_DOUBLE, 500000, double, make_turns,
             .error = direction_error, .limit = 2, .error_unit = "ulp of 1"),
    {.name = NULL},
};
