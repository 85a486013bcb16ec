/* Noise and curves for the sculptor: see clay.h. */
#include "sculptor/clay.h"

static uint32_t scramble(uint32_t x) {
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    x ^= x >> 16;
    return x;
}

/* A number in 0..1 that looks random, fixed for each (x, y, z, seed). */
static double dice(int32_t x, int32_t y, int32_t z, uint32_t seed) {
    uint32_t h = (uint32_t)x * 0x9e3779b1u + (uint32_t)y * 0x85ebca77u;
    return scramble(h + (uint32_t)z * 0xc2b2ae3du + seed * 0x27d4eb2fu) / 4294967295.0;
}

double noise(struct vec3 p, uint32_t seed) {
    double fx = floor(p.x), fy = floor(p.y), fz = floor(p.z);
    int32_t x = (int32_t)fx, y = (int32_t)fy, z = (int32_t)fz;
    double tx = p.x - fx, ty = p.y - fy, tz = p.z - fz;
    tx = tx * tx * (3 - 2 * tx);
    ty = ty * ty * (3 - 2 * ty);
    tz = tz * tz * (3 - 2 * tz);
    double corner[2][2];
    for (int k = 0; k < 2; k++) {
        for (int j = 0; j < 2; j++) {
            corner[k][j] = mix(dice(x, y + j, z + k, seed), dice(x + 1, y + j, z + k, seed), tx);
        }
    }
    return 2 * mix(mix(corner[0][0], corner[0][1], ty), mix(corner[1][0], corner[1][1], ty), tz) -
           1;
}

/* The slope at an inner knot: the weighted harmonic mean of its neighbours', 0 at a peak. */
static double knot_slope(const double (*knots)[2], int count, int i) {
    if (i == 0 || i == count - 1) {
        int a = i == 0 ? 0 : count - 2;
        return (knots[a + 1][1] - knots[a][1]) / (knots[a + 1][0] - knots[a][0]);
    }
    double h0 = knots[i][0] - knots[i - 1][0], h1 = knots[i + 1][0] - knots[i][0];
    double s0 = (knots[i][1] - knots[i - 1][1]) / h0, s1 = (knots[i + 1][1] - knots[i][1]) / h1;
    if (s0 * s1 <= 0) {
        return 0;
    }
    double w0 = 2 * h1 + h0, w1 = h1 + 2 * h0;
    return (w0 + w1) / (w0 / s0 + w1 / s1);
}

double curve(const double (*knots)[2], int count, double x) {
    if (x <= knots[0][0]) {
        return knots[0][1];
    }
    if (x >= knots[count - 1][0]) {
        return knots[count - 1][1];
    }
    int i = 0;
    while (x > knots[i + 1][0]) {
        i++;
    }
    double h = knots[i + 1][0] - knots[i][0], t = (x - knots[i][0]) / h;
    double m0 = h * knot_slope(knots, count, i), m1 = h * knot_slope(knots, count, i + 1);
    double y0 = knots[i][1], y1 = knots[i + 1][1];
    return y0 + t * (m0 + t * (3 * (y1 - y0) - 2 * m0 - m1 + t * (2 * (y0 - y1) + m0 + m1)));
}
