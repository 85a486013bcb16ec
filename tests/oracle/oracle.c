/* Independent answers: see oracle.h. */
#include "oracle.h"

#include <assert.h>
#include <math.h>

/* ---- Random numbers ---- */

uint64_t random_bits(struct random *random) {
    uint64_t z = (random->state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

int64_t random_between(struct random *random, int64_t least, int64_t most) {
    assert(least <= most);
    uint64_t range = (uint64_t)most - (uint64_t)least + 1;
    uint64_t bits = random_bits(random);
    return (int64_t)((uint64_t)least + (range != 0 ? bits % range : bits));
}

double random_real(struct random *random, double least, double most) {
    return least + (most - least) * ((double)(random_bits(random) >> 11) * 0x1p-53);
}

struct vec3 random_vec3(struct random *random, double reach) {
    double x = random_real(random, -reach, reach), y = random_real(random, -reach, reach);
    return (struct vec3){x, y, random_real(random, -reach, reach)};
}

/* ---- Lines ---- */

static int128 magnitude(int128 a) {
    return a < 0 ? -a : a;
}

bool oracle_line_has(struct pixel a, struct pixel b, struct pixel p) {
    int128 dx = (int128)b.x - a.x, dy = (int128)b.y - a.y;
    bool steep = magnitude(dy) > magnitude(dx);
    /* Let u be the longer axis; start is the end with the smaller u. */
    int128 ua = steep ? a.y : a.x, va = steep ? a.x : a.y;
    int128 ub = steep ? b.y : b.x, vb = steep ? b.x : b.y;
    int128 u = steep ? p.y : p.x, v = steep ? p.x : p.y;
    int128 u_start = ua < ub ? ua : ub, u_end = ua < ub ? ub : ua;
    int128 v_start = ua < ub ? va : vb, v_end = ua < ub ? vb : va;
    if (u < u_start || u > u_end) {
        return false;
    }
    if (u_start == u_end) {
        return v == v_start; /* a point: the steep case excludes all other lines */
    }
    /* How far pixel v is above the ideal line, times twice the length in u. */
    int128 length = u_end - u_start;
    int128 above = 2 * ((v - v_start) * length - (v_end - v_start) * (u - u_start));
    /* At a tie the row nearer to the start. */
    return (-length < above && above < length) || (above == length && v <= v_start) ||
           (above == -length && v >= v_start);
}

/* ---- Triangles ---- */

/* Twice the signed area of p, q and the point (x,y), all in 1/256 pixel. */
static int128 orientation(struct fixed2 p, struct fixed2 q, int128 x, int128 y) {
    return ((int128)q.x - p.x) * (y - p.y) - ((int128)q.y - p.y) * (x - p.x);
}

static int sign_of(int128 a) {
    return (a > 0) - (a < 0);
}

/* The orientation's sign once the point is shifted by (e, -e*e) for an infinitely small e. */
static int shifted_side(struct fixed2 p, struct fixed2 q, int128 x, int128 y) {
    int side = sign_of(orientation(p, q, x, y));
    if (side == 0) {
        side = sign_of(-((int128)q.y - p.y)); /* how the orientation grows with x */
    }
    if (side == 0) {
        side = -sign_of((int128)q.x - p.x); /* and with -y */
    }
    return side;
}

bool oracle_covers(struct fixed2 a, struct fixed2 b, struct fixed2 c, int64_t x, int64_t y) {
    int128 center_x = (int128)x * 256 + 128, center_y = (int128)y * 256 + 128;
    int winding = sign_of(orientation(a, b, c.x, c.y));
    return winding != 0 && shifted_side(a, b, center_x, center_y) == winding &&
           shifted_side(b, c, center_x, center_y) == winding &&
           shifted_side(c, a, center_x, center_y) == winding;
}

/* The pixels of a row or column around these coordinates. */
static struct span pixels_around(int32_t a, int32_t b, int32_t c, int size) {
    int32_t least = a < b ? a : b, most = a > b ? a : b;
    int begin = (least < c ? least : c) / 256 - 1, end = (most > c ? most : c) / 256 + 2;
    return (struct span){begin > 0 ? begin : 0, end < size ? end : size};
}

struct rectangle oracle_box(const struct fixed2 corner[3], int width, int height) {
    struct span columns = pixels_around(corner[0].x, corner[1].x, corner[2].x, width);
    struct span rows = pixels_around(corner[0].y, corner[1].y, corner[2].y, height);
    return (struct rectangle){columns.begin, rows.begin, columns.end - columns.begin,
                              rows.end - rows.begin};
}

int oracle_turn(struct fixed2 a, struct fixed2 b, struct fixed2 c) {
    return sign_of(orientation(a, b, c.x, c.y));
}

/* Depth as a fraction: numerator and (positive) denominator. */
static void exact_depth(const struct fixed2 corner[3], const int64_t z[3], const int64_t w[3],
                        int64_t x, int64_t y, int128 *numerator, int128 *denominator) {
    int128 px = (int128)x * 256 + 128, py = (int128)y * 256 + 128;
    int128 area = orientation(corner[0], corner[1], corner[2].x, corner[2].y);
    int128 sum = orientation(corner[1], corner[2], px, py) * z[0] * w[1] * w[2] +
                 orientation(corner[2], corner[0], px, py) * z[1] * w[2] * w[0] +
                 orientation(corner[0], corner[1], px, py) * z[2] * w[0] * w[1];
    *numerator = area < 0 ? -sum : sum;
    *denominator = (area < 0 ? -area : area) * w[0] * w[1] * w[2];
}

int oracle_compare_depth(const struct fixed2 first[3], const int64_t first_depth[3],
                         const struct fixed2 second[3], const int64_t second_depth[3], int64_t x,
                         int64_t y) {
    static const int64_t parallel[3] = {1, 1, 1};
    int128 n1, d1, n2, d2;
    exact_depth(first, first_depth, parallel, x, y, &n1, &d1);
    exact_depth(second, second_depth, parallel, x, y, &n2, &d2);
    return sign_of(n1 * d2 - n2 * d1);
}

long double oracle_perspective_depth(const struct fixed2 corner[3], const int64_t z[3],
                                     const int64_t w[3], int64_t x, int64_t y) {
    int128 numerator, denominator;
    exact_depth(corner, z, w, x, y, &numerator, &denominator);
    return (long double)numerator / (long double)denominator;
}

/* ---- Interpolation ---- */

long double oracle_interpolate(const struct fixed2 corner[3], const double recip_w[3],
                               const double value[3], int64_t x, int64_t y) {
    /* In space the corners are (X, Y, 1) * w. The point behind the pixel is a*P0 + b*P1 + c*P2 with
     * (x, y, 1) proportional to it: Cramer's rule gives a, b, c up to a common factor. */
    long double px = (long double)x * 256 + 128, py = (long double)y * 256 + 128;
    long double m[3][3];
    for (int i = 0; i < 3; i++) {
        long double w = 1 / (long double)recip_w[i];
        m[0][i] =
            ((long double)corner[i].x - px) * w; /* relative to the pixel: less cancellation */
        m[1][i] = ((long double)corner[i].y - py) * w;
        m[2][i] = w;
    }
    /* Weights solve m * (a b c) = (0 0 1): each is a minor of the first two rows. */
    long double a = m[0][1] * m[1][2] - m[0][2] * m[1][1];
    long double b = m[0][2] * m[1][0] - m[0][0] * m[1][2];
    long double c = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    return (a * (long double)value[0] + b * (long double)value[1] + c * (long double)value[2]) /
           (a + b + c);
}

static long double extent(int32_t a, int32_t b, int32_t c) {
    int32_t least = a < b ? a : b, most = a > b ? a : b;
    least = c < least ? c : least;
    most = c > most ? c : most;
    return (long double)most - (long double)least + 512; /* from the first pixel to the last */
}

long double oracle_rounding_scale(const struct fixed2 corner[3], const double recip_w[3],
                                  const double value[3], int64_t x, int64_t y) {
    const struct fixed2 *c = corner;
    long double px = (long double)x * 256 + 128, py = (long double)y * 256 + 128;
    long double width = extent(c[0].x, c[1].x, c[2].x), height = extent(c[0].y, c[1].y, c[2].y);
    long double terms = 0, sum = 0, least = (long double)value[0], most = least;
    for (int i = 0; i < 3; i++) {
        struct fixed2 a = c[(i + 1) % 3], b = c[(i + 2) % 3];
        long double dx = (long double)b.x - a.x, dy = (long double)b.y - a.y;
        long double w = 1 / (long double)recip_w[i];
        terms += (fabsl(dx) * height + fabsl(dy) * width) / w;
        sum += (dx * (py - a.y) - dy * (px - a.x)) / w;
        least = fminl(least, (long double)value[i]);
        most = fmaxl(most, (long double)value[i]);
    }
    return 2 * (most - least) * terms / fabsl(sum) + fmaxl(fabsl(least), fabsl(most));
}

/* ---- Cameras ---- */

struct oracle_frame oracle_frame(struct vec3 eye, struct vec3 center, struct vec3 up) {
    struct oracle_frame frame = {0};
    frame.axis[2] = real3_unit(real3_sub(real3_from(eye), real3_from(center)));
    struct real3 right = real3_cross(real3_unit(real3_from(up)), frame.axis[2]);
    frame.sine = real3_length(right);
    if (!(frame.sine > 1e-9L)) {
        frame.sine = 0;
        return frame;
    }
    frame.axis[0] = real3_scale(right, 1 / frame.sine);
    frame.axis[1] = real3_cross(frame.axis[2], frame.axis[0]);
    return frame;
}

void oracle_camera(struct vec3 eye, struct vec3 center, struct vec3 up, double zoom,
                   long double to_clip[4][4]) {
    struct oracle_frame frame = oracle_frame(eye, center, up);
    struct real3 from = real3_from(eye), to = real3_from(center);
    long double scale = (long double)zoom, away = -1 / real3_length(real3_sub(from, to));
    const struct real3 rows[4] = {real3_scale(frame.axis[0], scale),
                                  real3_scale(frame.axis[1], scale), frame.axis[2],
                                  real3_scale(frame.axis[2], away)}; /* from the eye forwards */
    for (int i = 0; i < 4; i++) {
        to_clip[i][0] = rows[i].x;
        to_clip[i][1] = rows[i].y;
        to_clip[i][2] = rows[i].z;
        to_clip[i][3] = -real3_dot(rows[i], i < 3 ? to : from);
    }
}

/* ---- Matrices ---- */

/* The determinant of the 3x3 matrix that is left without one row and one column. */
static int128 minor_of(const int64_t m[4][4], int skipped_row, int skipped_column) {
    int rows[3] = {0}, columns[3] = {0}, row_count = 0, column_count = 0;
    for (int i = 0; i < 4; i++) {
        if (i != skipped_row) {
            rows[row_count++] = i;
        }
        if (i != skipped_column) {
            columns[column_count++] = i;
        }
    }
    int128 sum = 0;
    for (int i = 0; i < 3; i++) {
        int128 a = m[rows[0]][columns[i]];
        int p = columns[(i + 1) % 3], q = columns[(i + 2) % 3];
        sum += a * ((int128)m[rows[1]][p] * m[rows[2]][q] - (int128)m[rows[1]][q] * m[rows[2]][p]);
    }
    return sum;
}

int128 oracle_determinant(const int64_t m[4][4]) {
    int128 sum = 0;
    for (int column = 0; column < 4; column++) {
        int128 term = m[0][column] * minor_of(m, 0, column);
        sum += column % 2 == 0 ? term : -term;
    }
    return sum;
}

int128 oracle_inverse_numerator(const int64_t m[4][4], int row, int column) {
    int128 cofactor = minor_of(m, column, row);
    return (row + column) % 2 == 0 ? cofactor : -cofactor;
}
