/* Vectors, matrices and cameras: see geometry.h. */
#include "geometry.h"

/* ---- Vectors ---- */

static double largest_component(struct vec3 a) {
    return fmax(fabs(a.x), fmax(fabs(a.y), fabs(a.z)));
}

struct vec3 vec3_normalized_slowly(struct vec3 a) {
    double largest = largest_component(a);
    if (largest == 0 || !isfinite(largest)) {
        return (struct vec3){0, 0, 0};
    }
    a = (struct vec3){a.x / largest, a.y / largest, a.z / largest};
    return vec3_scale(a, 1 / vec3_length(a));
}

struct vec3 vec3_perpendicular_axis(struct vec3 direction) {
    struct vec3 d = {fabs(direction.x), fabs(direction.y), fabs(direction.z)};
    if (d.y <= d.x && d.y <= d.z) {
        return (struct vec3){0, 1, 0};
    }
    return d.x <= d.z ? (struct vec3){1, 0, 0} : (struct vec3){0, 0, 1};
}

/* cos and sin for 0 <= angle <= pi/4 by their Taylor series, summed from the smallest term; the
 * next term is below 2^-60. */
static struct vec2 small_angle_direction(double angle) {
    double square = angle * angle;
    double sine = 1, cosine = 1;
    for (int n = 18; n >= 2; n -= 2) {
        sine = 1 - sine * square / (n * (n + 1));
        cosine = 1 - cosine * square / (n * (n - 1));
    }
    return (struct vec2){cosine, sine * angle};
}

struct vec2 turn_direction(double turns) {
    const double two_pi = 6.283185307179586476925;
    turns -= floor(turns);
    int quarter = (int)(turns * 4);
    double rest = turns - quarter * 0.25; /* exact: 0 <= rest < 0.25 */
    struct vec2 d;
    if (rest <= 0.125) {
        d = small_angle_direction(rest * two_pi);
    } else {
        struct vec2 mirrored = small_angle_direction((0.25 - rest) * two_pi);
        d = (struct vec2){mirrored.y, mirrored.x};
    }
    switch (quarter & 3) {
    case 0:
        return d;
    case 1:
        return (struct vec2){-d.y, d.x};
    case 2:
        return (struct vec2){-d.x, -d.y};
    default:
        return (struct vec2){d.y, -d.x};
    }
}

/* ---- Matrices ---- */

struct mat4 mat4_identity(void) {
    return (struct mat4){{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
}

struct mat4 mat4_mul(struct mat4 a, struct mat4 b) {
    struct mat4 product;
    for (int row = 0; row < 4; row++) {
        for (int column = 0; column < 4; column++) {
            double sum = 0;
            for (int k = 0; k < 4; k++) {
                sum += a.m[row][k] * b.m[k][column];
            }
            product.m[row][column] = sum;
        }
    }
    return product;
}

struct mat4 mat4_transpose(struct mat4 a) {
    struct mat4 transpose;
    for (int row = 0; row < 4; row++) {
        for (int column = 0; column < 4; column++) {
            transpose.m[column][row] = a.m[row][column];
        }
    }
    return transpose;
}

/* Largest sum of the magnitudes of a row: the norm that belongs to the largest component. */
static double row_norm(const struct mat4 *a) {
    double norm = 0;
    for (int row = 0; row < 4; row++) {
        double sum = 0;
        for (int column = 0; column < 4; column++) {
            sum += fabs(a->m[row][column]);
        }
        norm = sum > norm || isnan(sum) ? sum : norm;
    }
    return norm;
}

static void swap_rows(struct mat4 *a, int i, int j) {
    for (int column = 0; column < 4; column++) {
        double kept = a->m[i][column];
        a->m[i][column] = a->m[j][column];
        a->m[j][column] = kept;
    }
}

/* The row from `column` down whose entry in this column is largest in magnitude. */
static int find_pivot(const struct mat4 *a, int column) {
    int pivot = column;
    for (int row = column + 1; row < 4; row++) {
        if (fabs(a->m[row][column]) > fabs(a->m[pivot][column])) {
            pivot = row;
        }
    }
    return pivot;
}

/* Divide each row by its largest entry, in both: an equation with large numbers is not better. A
 * division by a power of two rounds nothing. False for a row of zeros or not finite. */
static bool scale_rows(struct mat4 *a, struct mat4 *b) {
    for (int row = 0; row < 4; row++) {
        double largest = 0;
        for (int column = 0; column < 4; column++) {
            if (!isfinite(a->m[row][column])) {
                return false;
            }
            largest = fmax(largest, fabs(a->m[row][column]));
        }
        if (largest == 0) {
            return false;
        }
        int exponent;
        frexp(largest, &exponent);
        for (int column = 0; column < 4; column++) {
            a->m[row][column] = ldexp(a->m[row][column], -exponent);
            b->m[row][column] = ldexp(b->m[row][column], -exponent);
        }
    }
    return true;
}

/* Subtract rows from those below them until a is upper triangular; the same with b. False when a
 * pivot is zero. */
static bool eliminate(struct mat4 *a, struct mat4 *b) {
    for (int column = 0; column < 4; column++) {
        int pivot = find_pivot(a, column);
        if (a->m[pivot][column] == 0) {
            return false;
        }
        swap_rows(a, pivot, column);
        swap_rows(b, pivot, column);
        for (int row = column + 1; row < 4; row++) {
            double factor = a->m[row][column] / a->m[column][column];
            for (int k = 0; k < 4; k++) {
                a->m[row][k] -= factor * a->m[column][k];
                b->m[row][k] -= factor * b->m[column][k];
            }
        }
    }
    return true;
}

/* Solve a * x = b for an upper triangular a, from the last row upwards; x takes the place of b. */
static void substitute_back(const struct mat4 *a, struct mat4 *b) {
    for (int column = 0; column < 4; column++) {
        for (int row = 3; row >= 0; row--) {
            double rest = b->m[row][column];
            for (int k = row + 1; k < 4; k++) {
                rest -= a->m[row][k] * b->m[k][column];
            }
            b->m[row][column] = rest / a->m[row][row];
        }
    }
}

bool mat4_inverse(struct mat4 a, struct mat4 *inverse) {
    struct mat4 result = mat4_identity();
    if (!scale_rows(&a, &result)) {
        return false;
    }
    const struct mat4 scaled = a, scales = result;
    if (!eliminate(&a, &result)) {
        return false;
    }
    substitute_back(&a, &result);
    /* The inverse of the row-scaled matrix is this result without the scales. */
    struct mat4 unscaled;
    for (int row = 0; row < 4; row++) {
        for (int column = 0; column < 4; column++) {
            unscaled.m[row][column] = result.m[row][column] / scales.m[column][column];
        }
    }
    double condition = row_norm(&scaled) * row_norm(&unscaled);
    if (!(condition < 0x1p50)) { /* also where the inverse is not finite */
        return false;
    }
    *inverse = result;
    return true;
}

struct mat4 mat4_translation(struct vec3 offset) {
    return (struct mat4){
        {{1, 0, 0, offset.x}, {0, 1, 0, offset.y}, {0, 0, 1, offset.z}, {0, 0, 0, 1}}};
}

struct mat4 mat4_scaling(struct vec3 factor) {
    return (struct mat4){
        {{factor.x, 0, 0, 0}, {0, factor.y, 0, 0}, {0, 0, factor.z, 0}, {0, 0, 0, 1}}};
}

/* Rodrigues' formula. */
struct mat4 mat4_rotation(struct vec3 axis, double turns) {
    struct vec3 a = vec3_normalized(axis);
    struct vec2 direction = turn_direction(turns);
    double c = direction.x, s = direction.y, k = 1 - c;
    return (struct mat4){{{a.x * a.x * k + c, a.x * a.y * k - a.z * s, a.x * a.z * k + a.y * s, 0},
                          {a.y * a.x * k + a.z * s, a.y * a.y * k + c, a.y * a.z * k - a.x * s, 0},
                          {a.z * a.x * k - a.y * s, a.z * a.y * k + a.x * s, a.z * a.z * k + c, 0},
                          {0, 0, 0, 1}}};
}

/* ---- Cameras (taught in step08_projection) ---- */

struct mat4 mat4_lookat(struct vec3 eye, struct vec3 center, struct vec3 up) {
    struct vec3 z = vec3_renormalized(vec3_normalized(vec3_half_difference(eye, center)));
    if (vec3_dot(z, z) == 0) {
        z = (struct vec3){0, 0, 1};
    }
    struct vec3 x = vec3_cross(vec3_normalized(up), z);
    if (vec3_dot(x, x) < 1e-20) { /* up is parallel to the view direction, as near as it matters */
        x = vec3_cross(vec3_perpendicular_axis(z), z);
    }
    x = vec3_normalized(x);
    /* A short cross product has lost digits: make x perpendicular to z once more. */
    x = vec3_renormalized(vec3_sub(x, vec3_scale(z, vec3_dot(x, z))));
    struct vec3 y = vec3_renormalized(vec3_cross(z, x));
    return (struct mat4){{{x.x, x.y, x.z, -vec3_dot(x, center)},
                          {y.x, y.y, y.z, -vec3_dot(y, center)},
                          {z.x, z.y, z.z, -vec3_dot(z, center)},
                          {0, 0, 0, 1}}};
}

struct mat4 mat4_projection(double distance) {
    struct mat4 projection = mat4_identity();
    projection.m[3][2] = -1 / distance;
    return projection;
}
