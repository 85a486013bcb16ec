/*
 * Sums and products of doubles without an error: the rounded result and what was rounded off.
 *
 * Exact as long as nothing over- or underflows: numbers of 1e-120 to 1e120 in size, and 0.
 */
#ifndef COMMON_EXACT_H
#define COMMON_EXACT_H

#include <math.h>

/* The number is rounded + rest. */
struct exact {
    double rounded, rest;
};

/* a + b (Knuth, "The Art of Computer Programming", volume 2, section 4.2.2, theorem B). */
static inline struct exact exact_sum(double a, double b) {
    double sum = a + b;
    double b_part = sum - a, a_part = sum - b_part;
    return (struct exact){sum, (a - a_part) + (b - b_part)};
}

/* a * b: fma() rounds only once, and what is left of the product takes no more bits than a double
 * has. */
static inline struct exact exact_product(double a, double b) {
    double product = a * b;
    return (struct exact){product, fma(a, b, -product)};
}

#endif
