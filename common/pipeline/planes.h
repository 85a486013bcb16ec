/*
 * Private to the pipeline: perspective-correct interpolation of a piece's varyings. shade.h
 * includes this file, since each shader has code of its own for it.
 *
 * A varying divided by w is linear on the screen, and so is 1/w: each is a plane over the pixels.
 * For a visible piece, these planes are computed once. At a pixel, a varying is then one of them
 * divided by another:
 *
 *     varying = v0 + numerator(x, y) / denominator(x, y)
 *
 * v0 is the varying at the piece's corner 0, where the numerator is 0, so that a varying that is
 * the same at all corners is exactly the same at all pixels. (Blinn, "Hyperbolic Interpolation",
 * IEEE CG&A 12(4), 1992.)
 *
 * The planes of TOGETHER pieces are computed at once, and stay side by side in memory:
 *
 *     x0 of piece 0, x0 of piece 1, ... | y0 of piece 0, y0 of piece 1, ... | plane 0 ...
 */
#ifndef COMMON_PIPELINE_PLANES_H
#define COMMON_PIPELINE_PLANES_H

#ifndef COMMON_PIPELINE_H
#error "include pipeline.h instead"
#endif

/* ---- What is kept of a visible piece ---- */

/* The numbers of a piece, in their order. First the pixel (x0,y0) that its planes are relative to.
 * Then varying_count planes, the numerators of the varyings, and one more, the denominator of them
 * all. A plane is its value at (x0,y0), its steps to the right and up, and a number of the piece's
 * corners: for a numerator the varying at corner 0; for the denominator its least value at any
 * corner, below which rounding might bring it, even to 0. */
enum plane_number { PLANE_ORIGIN, PLANE_DX, PLANE_DY, PLANE_CORNER };
enum { PLANES_X0, PLANES_Y0, PLANES_FIRST, PLANE_NUMBERS = 4 };

/* How many numbers a piece of such a shader has. */
#define PLANES_SIZE(varying_count) (PLANES_FIRST + PLANE_NUMBERS * ((size_t)(varying_count) + 1))

/* The place of the first number of piece i; its next ones follow at distances of TOGETHER. */
static inline size_t planes_place(const struct shader *shader, size_t i) {
    return i / TOGETHER * TOGETHER * PLANES_SIZE(shader->varying_count) + i % TOGETHER;
}

static inline real plane_at(const real *planes, size_t plane, enum plane_number number) {
    return planes[(PLANES_FIRST + PLANE_NUMBERS * plane + (size_t)number) * TOGETHER];
}

/* ---- Computing the planes of TOGETHER pieces at once ---- */

/* The corners of TOGETHER pieces: [c][i] is corner c of piece i. */
struct corners_together {
    int32_t x[3][TOGETHER], y[3][TOGETHER]; /* in 1/256 pixel */
    double recip_w[3][TOGETHER];
    double varyings[3][VARYING_LIMIT][TOGETHER];
};

/* A plane on the screen for each piece: its value at some pixel, and its steps to the right and
 * up. */
struct planes_together {
    doubles origin, dx, dy;
};

LANES_INLINE struct planes_together planes_scale(struct planes_together a, doubles factor) {
    return (struct planes_together){a.origin * factor, a.dx * factor, a.dy * factor};
}

LANES_INLINE struct planes_together planes_add(struct planes_together a, struct planes_together b) {
    return (struct planes_together){a.origin + b.origin, a.dx + b.dx, a.dy + b.dy};
}

/* The edge function from corner a to corner b, both relative to the centre of the pixel at which
 * the value is wanted: there it is their cross product. All are whole numbers that a double holds:
 * see guard_band_of(). */
LANES_INLINE struct planes_together edge_planes(doubles ax, doubles ay, doubles bx, doubles by) {
    return (struct planes_together){ax * by - ay * bx, (ay - by) * SUBPIXELS,
                                    (bx - ax) * SUBPIXELS};
}

/* Find the edge functions, which are the weights of the corners times twice the area: number i
 * belongs to the edge opposite corner i. They are relative to (x0,y0), the pixel that corner 0 is
 * in. */
LANES_INLINE void find_edge_planes(const struct corners_together *of, ints *x0, ints *y0,
                                   struct planes_together edge[3]) {
    doubles x[3], y[3];
    ints at_x, at_y;
    memcpy(x0, of->x[0], sizeof *x0);
    memcpy(y0, of->y[0], sizeof *y0);
    *x0 >>= 8;
    *y0 >>= 8;
    for (int c = 0; c < 3; c++) {
        memcpy(&at_x, of->x[c], sizeof at_x);
        memcpy(&at_y, of->y[c], sizeof at_y);
        x[c] = __builtin_convertvector(at_x - (*x0 * SUBPIXELS + SUBPIXELS / 2), doubles);
        y[c] = __builtin_convertvector(at_y - (*y0 * SUBPIXELS + SUBPIXELS / 2), doubles);
    }
    for (int c = 0; c < 3; c++) {
        int a = (c + 1) % 3, b = (c + 2) % 3;
        edge[c] = edge_planes(x[a], y[a], x[b], y[b]);
    }
}

/* The powers of two that bring positive numbers into the range from 1 to 2. A product with such a
 * power is exact. A double is 2^(E - 1023) times a number from 1 to 2, and has E in bits 52 to 62;
 * with 2046 - E in them, and 0 in the others, it is 2^(1023 - E), the power that is wanted. */
LANES_INLINE doubles units_of(doubles numbers) {
    longs exponent = (longs)doubles_max(numbers, doubles_all(0x1p-1022)) & INT64_C(0x7FF) << 52;
    return (doubles)((INT64_C(2046) << 52) - exponent);
}

/* Write one number of each piece. */
LANES_INLINE void write_number(real *to, size_t number, doubles values) {
    typedef real reals __attribute__((vector_size(TOGETHER * sizeof(real))));
    reals rounded = __builtin_convertvector(values, reals);
    memcpy(to + number * TOGETHER, &rounded, sizeof rounded);
}

/* Write plane k of each piece. */
LANES_INLINE void write_plane(real *to, size_t k, struct planes_together plane, doubles corner) {
    size_t first = PLANES_FIRST + PLANE_NUMBERS * k;
    write_number(to, first + PLANE_ORIGIN, plane.origin);
    write_number(to, first + PLANE_DX, plane.dx);
    write_number(to, first + PLANE_DY, plane.dy);
    write_number(to, first + PLANE_CORNER, corner);
}

/* Find the planes of TOGETHER pieces. With edge functions e, a varying is
 *
 *     v0 + (e1 (v1 - v0) / w1 + e2 (v2 - v0) / w2) / (e0 / w0 + e1 / w1 + e2 / w2).
 *
 * If there are fewer pieces, what is written for the missing ones has no meaning. */
LANES_INLINE void find_planes(const struct corners_together *of, const struct shader *shader,
                              real *to) {
    size_t n = shader->varying_count;
    ints x0, y0;
    struct planes_together edge[3];
    doubles recip_w[3];
    find_edge_planes(of, &x0, &y0, edge);
    for (int c = 0; c < 3; c++) {
        recip_w[c] = doubles_load(of->recip_w[c]);
    }
    doubles scale = 1 / (edge[0].origin + edge[1].origin + edge[2].origin);
    /* 1/w may be too small for a float, so it is scaled: the largest of them to between 1 and 2. */
    doubles unit = units_of(doubles_max(doubles_max(recip_w[0], recip_w[1]), recip_w[2]));
    doubles least = doubles_min(doubles_min(recip_w[0], recip_w[1]), recip_w[2]) * unit;
    least = doubles_max(least, doubles_all(1e-30)); /* above 0 also as a float */
    for (int c = 0; c < 3; c++) {
        edge[c] = planes_scale(edge[c], recip_w[c] * scale * unit);
    }
    write_number(to, PLANES_X0, __builtin_convertvector(x0, doubles));
    write_number(to, PLANES_Y0, __builtin_convertvector(y0, doubles));
    for (size_t k = 0; k < n; k++) {
        doubles v0 = doubles_load(of->varyings[0][k]);
        struct planes_together to_1 = planes_scale(edge[1], doubles_load(of->varyings[1][k]) - v0);
        struct planes_together to_2 = planes_scale(edge[2], doubles_load(of->varyings[2][k]) - v0);
        write_plane(to, k, planes_add(to_1, to_2), v0);
    }
    write_plane(to, n, planes_add(planes_add(edge[0], edge[1]), edge[2]), least);
}

#endif
