/* Private to the pipeline: planes, from which varyings are found at any pixel. shade.h includes it,
 * since each shader gets its own. */
#ifndef COMMON_PIPELINE_PLANES_H
#define COMMON_PIPELINE_PLANES_H

#ifndef COMMON_PIPELINE_H
#error "include pipeline.h instead"
#endif

/* A number at each pixel (x,y) of the screen: origin + (x - x0) dx + (y - y0) dy; and one of the
 * piece's corners. */
struct plane {
    real origin, dx, dy, corner;
};

/* What is kept of a visible piece: relative to the pixel (x0,y0) that corner 0 is in, the
 * numerators of its varyings, with what each is at corner 0; and behind them the denominator of
 * all, with the least that it is at any corner: rounding may make it less, even 0. */
struct planes {
    real x0, y0;
    struct plane plane[]; /* varying_count + 1 */
};

static inline size_t planes_size(const struct shader *shader) {
    return sizeof(struct planes) + (shader->varying_count + 1) * sizeof(struct plane);
}

/* What a corner of a piece hands over. */
struct corner_values {
    double recip_w;
    double varyings[VARYING_LIMIT];
};

/* The edge function from a to b, corners relative to the centre of the pixel where its first value
 * is: there it is their cross product. Then its steps to the right and up. All are whole numbers
 * that a double holds: see guard_band_of(). */
LANES_INLINE double4 edge_plane(const double a[2], const double b[2]) {
    return (double4){a[0] * b[1] - a[1] * b[0], (a[1] - b[1]) * SUBPIXELS,
                     (b[0] - a[0]) * SUBPIXELS, 0};
}

/* The power of two that brings a positive number to 1 or more, below 2. A product with it is
 * exact. */
static inline double unit_of(double number) {
    uint64_t bits;
    number = number > 0x1p-1022 ? number : 0x1p-1022;
    memcpy(&bits, &number, sizeof bits);
    bits = (UINT64_C(2046) << 52) - (bits & UINT64_C(0x7FF) << 52);
    memcpy(&number, &bits, sizeof number);
    return number;
}

LANES_INLINE void write_plane(struct plane *to, double4 plane, double corner) {
    typedef real real4 __attribute__((vector_size(4 * sizeof(real))));
    real4 rounded = __builtin_convertvector(plane, real4);
    memcpy(to, &rounded, sizeof *to);
    to->corner = (real)corner;
}

/* Perspective: a varying is v0 + (e1 (v1 - v0) / w1 + e2 (v2 - v0) / w2) / (e0 / w0 + e1 / w1 +
 * e2 / w2), where e are the edge functions: e0 is that of the side opposite corner 0. (Blinn,
 * "Hyperbolic Interpolation", IEEE CG&A 12(4), 1992.) */
KERNEL void find_planes(const struct fixed2 corner[3], const struct corner_values value[3],
                        const struct shader *shader, struct planes *to) {
    size_t n = shader->varying_count;
    int x0 = corner[0].x >> 8, y0 = corner[0].y >> 8;
    double at[3][2], w0 = value[0].recip_w, w1 = value[1].recip_w, w2 = value[2].recip_w;
    for (int i = 0; i < 3; i++) {
        at[i][0] = corner[i].x - (x0 * SUBPIXELS + SUBPIXELS / 2);
        at[i][1] = corner[i].y - (y0 * SUBPIXELS + SUBPIXELS / 2);
    }
    double4 e0 = edge_plane(at[1], at[2]), e1 = edge_plane(at[2], at[0]);
    double4 e2 = edge_plane(at[0], at[1]);
    /* 1/w itself may be too small for a float: so as a part of the largest. */
    double most = w0 > w1 ? w0 : w1, least = w0 < w1 ? w0 : w1;
    double scale = 1 / (e0[0] + e1[0] + e2[0]), unit = unit_of(most > w2 ? most : w2);
    least = (least < w2 ? least : w2) * unit;
    e0 *= w0 * scale * unit;
    e1 *= w1 * scale * unit;
    e2 *= w2 * scale * unit;
    to->x0 = (real)x0;
    to->y0 = (real)y0;
    for (size_t k = 0; k < n; k++) {
        double v0 = value[0].varyings[k];
        double4 to_1 = e1 * (value[1].varyings[k] - v0), to_2 = e2 * (value[2].varyings[k] - v0);
        write_plane(&to->plane[k], to_1 + to_2, v0);
    }
    /* Above 0 in a float, too. */
    write_plane(&to->plane[n], e0 + e1 + e2, least > 1e-30 ? least : 1e-30);
}

#endif
