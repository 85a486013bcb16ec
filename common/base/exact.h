/*
 * Sums and products of doubles without an error: the rounded result and what was rounded off.
 *
 * Exact as long as nothing over- or underflows: numbers of 1e-120 to 1e120 in size, and 0.
 */
#ifndef COMMON_EXACT_H
#define COMMON_EXACT_H

/* Stands for rounded + rest. */
struct exact {
    double rounded, rest;
};

/* a + b (Knuth, "The Art of Computer Programming", volume 2, section 4.2.2, theorem B). */
static inline struct exact exact_sum(double a, double b) {
    double sum = a + b;
    double b_part = sum - a, a_part = sum - b_part;
    return (struct exact){sum, (a - a_part) + (b - b_part)};
}

/* A number as a sum of two with half as many bits: their products are exact. */
static inline struct exact exact_split(double number) {
    double scaled = 134217729 * number; /* 2^27 + 1 */
    double high = scaled - (scaled - number);
    return (struct exact){high, number - high};
}

/* a * b (Dekker, "A Floating-Point Technique for Extending the Available Precision", 1971). */
static inline struct exact exact_product(double a, double b) {
    struct exact p = exact_split(a), q = exact_split(b);
    double product = a * b;
    double rest = product - p.rounded * q.rounded;
    rest -= p.rest * q.rounded;
    rest -= p.rounded * q.rest;
    return (struct exact){product, p.rest * q.rest - rest};
}

#endif
