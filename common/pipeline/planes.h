/*
 * Private to the pipeline: numbers of several things at once, and planes, from which varyings are
 * found at any pixel. kernels.h includes it, since each shader gets its own.
 */
#ifndef COMMON_PIPELINE_PLANES_H
#define COMMON_PIPELINE_PLANES_H

#ifndef COMMON_PIPELINE_H
#error "include pipeline.h instead"
#endif

/* ---- Numbers of several things at once, for what must be exact ---- */

/* As many as 64-bit numbers fit into a register of the processor. */
#if LANES > 4
#define TOGETHER (LANES / 2)
#else
#define TOGETHER 2
#endif
typedef int32_t ints __attribute__((vector_size(TOGETHER * sizeof(int32_t))));
typedef int64_t longs __attribute__((vector_size(TOGETHER * sizeof(int64_t))));
typedef double doubles __attribute__((vector_size(TOGETHER * sizeof(double))));

LANES_INLINE doubles doubles_all(double value) {
    return value - (doubles){0};
}

LANES_INLINE doubles doubles_from_ints(ints whole) {
#if TOGETHER == 8
    return lanes_eight_to_doubles(whole);
#elif TOGETHER == 4
    return lanes_four_to_doubles(whole);
#else
    return __builtin_convertvector(whole, doubles);
#endif
}

LANES_INLINE doubles doubles_abs(doubles value) {
    return (doubles)((longs)value & INT64_MAX);
}

LANES_INLINE doubles doubles_least(doubles a, doubles b) {
    longs less = a < b;
    return (doubles)((less & (longs)a) + (~less & (longs)b));
}

LANES_INLINE doubles doubles_most(doubles a, doubles b) {
    longs more = a > b;
    return (doubles)((more & (longs)a) + (~more & (longs)b));
}

/* ---- What is kept of a visible piece ---- */

/* A plane on the screen over a piece, relative to pixel (x0,y0), and with it a number of the
 * piece's corners. */
struct varying_plane {
    real origin, dx, dy, corner;
};

/* Four of them, the numbers of one kind together: so their rows are found at once. */
enum { FOUR = 4 };
typedef real four_reals __attribute__((vector_size(FOUR * sizeof(real))));
struct four_planes {
    real origin[FOUR], dx[FOUR], dy[FOUR], corner[FOUR];
};

/* So many fours hold a shader's planes. */
#define FOURS_OF(varying_count) (((varying_count) + FOUR) / FOUR)

/* From these the varyings are found at any pixel. Plane i of the first varying_count is the
 * numerator of varying i, with what that is at corner 0. The next one is the denominator of all,
 * with the least that it is at any corner: rounding may make it less, even 0. It is there again
 * where a four would have none. */
struct planes {
    real x0, y0;
    struct four_planes four[FOURS_OF(VARYING_LIMIT)];
};

/* Plane i. */
static inline struct varying_plane varying_plane(const struct planes *planes, size_t i) {
    const struct four_planes *four = &planes->four[i / FOUR];
    size_t k = i % FOUR;
    return (struct varying_plane){four->origin[k], four->dx[k], four->dy[k], four->corner[k]};
}

/* Number i of planes that lie one behind the other, without those that the shader does not have:
 * half of the time of small pieces is waiting for memory. */
static inline struct planes *planes_number(struct planes *planes, const struct shader *shader,
                                           size_t i) {
    size_t size = offsetof(struct planes, four) +
                  FOURS_OF(shader->varying_count) * sizeof(struct four_planes);
    return (struct planes *)((char *)planes + i * size);
}

/* ---- Finding them, for TOGETHER pieces at once ---- */

/* Their corners: what is at corner c of piece i is at [c][i]. */
struct corners_together {
    int32_t x[3][TOGETHER], y[3][TOGETHER]; /* in 1/256 pixel */
    double recip_w[3][TOGETHER];
    double varyings[3][VARYING_LIMIT][TOGETHER];
};

/* A plane on the screen for each of them: its value at some pixel, and its steps to the right and
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

/* The edge function from a to b, corners relative to the centre of the pixel where its first value
 * is: there it is their cross product. All are whole numbers that a double holds: see
 * guard_band_of(). */
LANES_INLINE struct planes_together edge_planes(doubles ax, doubles ay, doubles bx, doubles by) {
    return (struct planes_together){ax * by - ay * bx, (ay - by) * SUBPIXELS,
                                    (bx - ax) * SUBPIXELS};
}

/* The weights of the corners times the area: edge function i is that of the side opposite corner i.
 * Relative to the pixel that corner 0 is in, (x0,y0). */
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
        x[c] = doubles_from_ints(at_x - (*x0 * SUBPIXELS + SUBPIXELS / 2));
        y[c] = doubles_from_ints(at_y - (*y0 * SUBPIXELS + SUBPIXELS / 2));
    }
    for (int c = 0; c < 3; c++) {
        int a = (c + 1) % 3, b = (c + 2) % 3;
        edge[c] = edge_planes(x[a], y[a], x[b], y[b]);
    }
}

/* The powers of two that bring positive numbers to 1 or more, below 2. A product with one is
 * exact. */
LANES_INLINE doubles units_of(doubles numbers) {
    longs exponent = (longs)doubles_most(numbers, doubles_all(0x1p-1022)) & INT64_C(0x7FF) << 52;
    return (doubles)((INT64_C(2046) << 52) - exponent);
}

/* A number of each piece. */
typedef real reals __attribute__((vector_size(TOGETHER * sizeof(real))));

/* Four planes of each piece. */
struct planes_of_pieces {
    reals origin[FOUR], dx[FOUR], dy[FOUR], corner[FOUR];
};

/* The numbers of one kind, to where they are in each piece's planes. */
LANES_INLINE void write_fours_plainly(const reals from[FOUR], const struct shader *shader,
                                      struct planes *to, size_t offset) {
    for (size_t i = 0; i < TOGETHER; i++) {
        const real of_piece[FOUR] = {from[0][i], from[1][i], from[2][i], from[3][i]};
        memcpy((char *)planes_number(to, shader, i) + offset, of_piece, sizeof of_piece);
    }
}

/* The same in few instructions: pairs of two planes' numbers, and fours of those. */
#if LANES == 16 && defined(LANES_SHUFFLE)
#define PLANES_LOW_PAIRS  0, 8, 1, 9, 4, 12, 5, 13
#define PLANES_HIGH_PAIRS 2, 10, 3, 11, 6, 14, 7, 15
#define PLANES_LOW_FOURS  0, 1, 8, 9, 4, 5, 12, 13
#define PLANES_HIGH_FOURS 2, 3, 10, 11, 6, 7, 14, 15
#elif LANES == 8 && defined(LANES_SHUFFLE)
#define PLANES_LOW_PAIRS  0, 4, 1, 5
#define PLANES_HIGH_PAIRS 2, 6, 3, 7
#define PLANES_LOW_FOURS  0, 1, 4, 5
#define PLANES_HIGH_FOURS 2, 3, 6, 7
#endif

LANES_INLINE void write_fours(const reals from[FOUR], const struct shader *shader,
                              struct planes *to, size_t offset) {
#ifdef PLANES_LOW_PAIRS
    reals a = LANES_SHUFFLE(from[0], from[1], PLANES_LOW_PAIRS);
    reals b = LANES_SHUFFLE(from[0], from[1], PLANES_HIGH_PAIRS);
    reals c = LANES_SHUFFLE(from[2], from[3], PLANES_LOW_PAIRS);
    reals d = LANES_SHUFFLE(from[2], from[3], PLANES_HIGH_PAIRS);
    const reals of_piece[4] = {
        LANES_SHUFFLE(a, c, PLANES_LOW_FOURS), LANES_SHUFFLE(a, c, PLANES_HIGH_FOURS),
        LANES_SHUFFLE(b, d, PLANES_LOW_FOURS), LANES_SHUFFLE(b, d, PLANES_HIGH_FOURS)};
    for (size_t i = 0; i < TOGETHER; i++) {
        const real *four = (const real *)&of_piece[i % 4] + i / 4 * FOUR;
        memcpy((char *)planes_number(to, shader, i) + offset, four, FOUR * sizeof *four);
    }
#else
    write_fours_plainly(from, shader, to, offset);
#endif
}

/* They become four number i of those that are kept. */
LANES_INLINE void write_planes(const struct planes_of_pieces *from, const struct shader *shader,
                               struct planes *to, size_t i) {
    size_t offset = offsetof(struct planes, four) + i * sizeof(struct four_planes);
    write_fours(from->origin, shader, to, offset + offsetof(struct four_planes, origin));
    write_fours(from->dx, shader, to, offset + offsetof(struct four_planes, dx));
    write_fours(from->dy, shader, to, offset + offsetof(struct four_planes, dy));
    write_fours(from->corner, shader, to, offset + offsetof(struct four_planes, corner));
}

/* Plane k of each piece. */
LANES_INLINE void put_plane(struct planes_of_pieces *fours, size_t k, struct planes_together plane,
                            doubles corner) {
    struct planes_of_pieces *to = &fours[k / FOUR];
    to->origin[k % FOUR] = __builtin_convertvector(plane.origin, reals);
    to->dx[k % FOUR] = __builtin_convertvector(plane.dx, reals);
    to->dy[k % FOUR] = __builtin_convertvector(plane.dy, reals);
    to->corner[k % FOUR] = __builtin_convertvector(corner, reals);
}

LANES_INLINE doubles doubles_load(const double from[TOGETHER]) {
    doubles values;
    memcpy(&values, from, sizeof values);
    return values;
}

/* Perspective: a varying is v0 + (e1 (v1 - v0) / w1 + e2 (v2 - v0) / w2) / (e0 / w0 + e1 / w1 +
 * e2 / w2), where e are the edge functions. Both are planes on the screen. (Blinn, "Hyperbolic
 * Interpolation", IEEE CG&A 12(4), 1992.) Of pieces that are not given, anything is written. */
KERNEL void find_planes(const struct corners_together *of, const struct shader *shader,
                        struct planes *to) {
    size_t n = shader->varying_count;
    ints x0, y0;
    struct planes_together edge[3];
    doubles recip_w[3];
    find_edge_planes(of, &x0, &y0, edge);
    for (int c = 0; c < 3; c++) {
        recip_w[c] = doubles_load(of->recip_w[c]);
    }
    doubles scale = 1 / (edge[0].origin + edge[1].origin + edge[2].origin);
    /* 1/w itself may be too small for a float: so as a part of the largest. */
    doubles unit = units_of(doubles_most(doubles_most(recip_w[0], recip_w[1]), recip_w[2]));
    doubles least = doubles_least(doubles_least(recip_w[0], recip_w[1]), recip_w[2]) * unit;
    least = doubles_most(least, doubles_all(1e-30)); /* above 0 in a float, too */
    for (int c = 0; c < 3; c++) {
        edge[c] = planes_scale(edge[c], recip_w[c] * scale * unit);
    }
    for (size_t i = 0; i < TOGETHER; i++) {
        struct planes *planes = planes_number(to, shader, i);
        planes->x0 = (real)x0[i];
        planes->y0 = (real)y0[i];
    }
    struct planes_of_pieces fours[FOURS_OF(VARYING_LIMIT)];
    for (size_t k = 0; k < n; k++) {
        doubles v0 = doubles_load(of->varyings[0][k]);
        struct planes_together to_1 = planes_scale(edge[1], doubles_load(of->varyings[1][k]) - v0);
        struct planes_together to_2 = planes_scale(edge[2], doubles_load(of->varyings[2][k]) - v0);
        put_plane(fours, k, planes_add(to_1, to_2), v0);
    }
    for (size_t k = n; k < FOURS_OF(n) * FOUR; k++) {
        put_plane(fours, k, planes_add(planes_add(edge[0], edge[1]), edge[2]), least);
    }
    for (size_t i = 0; i < FOURS_OF(n); i++) {
        write_planes(&fours[i], shader, to, i);
    }
}

#endif
