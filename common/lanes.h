/*
 * Numbers for several pixels at once: a fragment function is written as if for one pixel and run
 * for LANES neighbours of a row, as on a GPU: 16, 8 or 4 of them, as many floats as a register of
 * the processor holds.
 *
 *     lanes intensity = lanes_max(lanes3_dot(normal, light), lanes_all(0));
 *
 * A `lanes` is used like a number: + - * / and comparisons work lane by lane. Three things differ.
 * There is no `if`, since the pixels may disagree: compute both and choose with
 * lanes_select(). Constants are written as floats (127.5f, 2). What is the same for all pixels is
 * made a `lanes` by lanes_all() or by an operator whose other side is one. (Vector extensions of
 * gcc and clang, which make of an operator the instructions that the processor has; "Using the GNU
 * Compiler Collection", section "Vector Extensions".)
 *
 * Results are the same on every machine: + - * / and square roots are rounded once, and nothing
 * else is used. `make LANES=1` builds the same programs with one lane, which a debugger shows as
 * one number; `make REAL=double` with twice the precision.
 */
#ifndef COMMON_LANES_H
#define COMMON_LANES_H

#include "geometry.h"
#include "given/later.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

#if COURSE_LESSON <= 8
#error "lanes.h and pipeline.h are given from lesson 9 on"
#endif

/* The numbers of pixel arithmetic. What decides (coverage, depth) is never one of them. */
#ifndef REAL
#define REAL float
#endif
typedef REAL real;

/* As many floats as a register of the processor holds: the number changes no byte. */
#ifndef LANES
#if defined(__AVX512F__)
#define LANES 16
#elif defined(__AVX__)
#define LANES 8
#else
#define LANES 4
#endif
#endif

#define LANES_INLINE static inline __attribute__((always_inline))

#define LANES_IS_FLOAT (sizeof(real) == sizeof(float))

/* gcc would warn at every function here that older versions passed its arguments differently. */
#pragma GCC diagnostic ignored "-Wpsabi"

typedef real lanes __attribute__((vector_size(LANES * sizeof(real))));
typedef int32_t lanes_int __attribute__((vector_size(LANES * sizeof(int32_t))));
/* Colours as texels have them: blue | green << 8 | red << 16 | alpha << 24. */
typedef uint32_t lanes_texel __attribute__((vector_size(LANES * sizeof(uint32_t))));
/* For each lane all bits or none: what a comparison of two `lanes` gives. */
typedef __typeof__((lanes){0} > (lanes){0}) lanes_mask;

LANES_INLINE lanes lanes_all(real value) {
    return value - (lanes){0};
}

/* The elements of a where the mask is set, those of b elsewhere: for vectors of any type, and a
 * mask as a comparison of vectors gives it. (gcc turns the `+` into one instruction, but an `|`
 * into two or three.) */
#define VECTOR_SELECT(mask, a, b)                                                                  \
    ((__typeof__(a))(((mask) & (__typeof__(mask))(a)) + (~(mask) & (__typeof__(mask))(b))))

/* a where the mask is set, b elsewhere. */
LANES_INLINE lanes lanes_select(lanes_mask mask, lanes a, lanes b) {
    return VECTOR_SELECT(mask, a, b);
}

LANES_INLINE lanes lanes_sqrt(lanes a) {
    lanes root = a;
    for (int i = 0; i < LANES; i++) {
        root[i] = LANES_IS_FLOAT ? (real)sqrtf((float)a[i]) : (real)sqrt((double)a[i]);
    }
    return root;
}

/* Drop the fraction; the numbers must fit an int32_t. */
LANES_INLINE lanes_int lanes_to_int(lanes a) {
    return __builtin_convertvector(a, lanes_int);
}

LANES_INLINE lanes lanes_from_int(lanes_int a) {
    return __builtin_convertvector(a, lanes);
}

/* Is the mask set for lane i? */
LANES_INLINE bool lanes_is_set(lanes_mask mask, int i) {
    return mask[i] != 0;
}

/* The mask that is set everywhere. */
LANES_INLINE lanes_mask lanes_all_set(void) {
    lanes lower = {0}, higher = lower + 1;
    return lower < higher;
}

/* first, first + 1, first + 2, ...: as integers, and as numbers. */
LANES_INLINE lanes_int lanes_int_from(int first) {
    lanes_int from = {0};
    for (int i = 0; i < LANES; i++) {
        from[i] = first + i;
    }
    return from;
}

LANES_INLINE lanes lanes_from(int first) {
    return lanes_from_int(lanes_int_from(first));
}

/* The mask that is set for lane `first` and those behind it. */
LANES_INLINE lanes_mask lanes_not_before(int first) {
    return __builtin_convertvector(lanes_int_from(0) >= first, lanes_mask);
}

/* On x86, the instructions maxps and minps for LANES floats. gcc 12 and clang 14 do not find them
 * by themselves: they compare and choose, which costs a seventh of the time of a textured pixel.
 * More of this kind: pipeline/vectors.h. */
#define LANES_PASTE(a, b)   a##b
#define LANES_OF_TYPE(type) LANES_PASTE(LANES_OF_, type)
#define LANES_OF_float      LANES /* of other types there are none: 0 */
#if LANES_OF_TYPE(REAL) == 16 && defined(__AVX512F__) && defined(__clang__)
#define LANES_NATIVE(which, a, b) __builtin_ia32_##which##ps512(a, b, 4)
#elif LANES_OF_TYPE(REAL) == 16 && defined(__AVX512F__)
#define LANES_NATIVE(which, a, b) __builtin_ia32_##which##ps512_mask(a, b, b, -1, 4)
#elif LANES_OF_TYPE(REAL) == 8 && defined(__AVX__)
#define LANES_NATIVE(which, a, b) __builtin_ia32_##which##ps256(a, b)
#elif LANES_OF_TYPE(REAL) == 4 && defined(__SSE__)
#define LANES_NATIVE(which, a, b) __builtin_ia32_##which##ps(a, b)
#endif

/* `a > b ? a : b`, in every bit, also where one is NaN or both are zero. */
LANES_INLINE lanes lanes_max(lanes a, lanes b) {
#ifdef LANES_NATIVE
    return LANES_NATIVE(max, a, b);
#else
    return lanes_select(a > b, a, b);
#endif
}

/* `a < b ? a : b`, in every bit. */
LANES_INLINE lanes lanes_min(lanes a, lanes b) {
#ifdef LANES_NATIVE
    return LANES_NATIVE(min, a, b);
#else
    return lanes_select(a < b, a, b);
#endif
}

/* The sum of all lanes. */
LANES_INLINE uint64_t lanes_sum(lanes_int counts) {
    int32_t count[LANES];
    uint64_t sum = 0;
    memcpy(count, &counts, sizeof count);
    for (int i = 0; i < LANES; i++) {
        sum += (uint64_t)count[i];
    }
    return sum;
}

LANES_INLINE uint32_t lanes_texel_at(lanes_texel texels, int i) {
    uint32_t texel[LANES];
    memcpy(texel, &texels, sizeof texel);
    return texel[i];
}

/* Round down to a whole number; the numbers must fit an int32_t. */
LANES_INLINE lanes lanes_floor(lanes a) {
    lanes whole = lanes_from_int(lanes_to_int(a));
    return lanes_select(whole > a, whole - 1, whole);
}

/* A level rounded to the nearest of 0..255, halves up; NaN becomes 0. */
LANES_INLINE lanes_int lanes_level(lanes level) {
    return lanes_to_int(lanes_min(lanes_max(level, lanes_all(0)), lanes_all(255)) + 0.5f);
}

/* ---- Vectors: as struct vec2 and vec3 of geometry.h, for LANES pixels ---- */

struct lanes2 {
    lanes x, y;
};

struct lanes3 {
    lanes x, y, z;
};

LANES_INLINE struct lanes3 lanes3_sub(struct lanes3 a, struct lanes3 b) {
    return (struct lanes3){a.x - b.x, a.y - b.y, a.z - b.z};
}

LANES_INLINE struct lanes3 lanes3_scale(struct lanes3 a, lanes factor) {
    return (struct lanes3){a.x * factor, a.y * factor, a.z * factor};
}

LANES_INLINE lanes lanes3_dot(struct lanes3 a, struct lanes3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/* One vector for all pixels. */
LANES_INLINE struct lanes3 lanes3_all(struct vec3 v) {
    return (struct lanes3){lanes_all((real)v.x), lanes_all((real)v.y), lanes_all((real)v.z)};
}

/* The vector of length 1 in the same direction; zero stays zero. */
LANES_INLINE struct lanes3 lanes3_normalized(struct lanes3 a) {
    lanes square = lanes3_dot(a, a);
    lanes length = lanes_sqrt(lanes_select(square > 0, square, lanes_all(1)));
    return lanes3_scale(a, 1 / length);
}

LANES_INLINE lanes_texel lanes_black(void) {
    return (lanes_texel){0} + UINT32_C(0xFF000000);
}

/* Red, green, blue as levels, each rounded to the nearest of 0..255; NaN becomes 0. */
LANES_INLINE lanes_texel lanes_rgb(lanes red, lanes green, lanes blue) {
    lanes_int r = lanes_level(red), g = lanes_level(green), b = lanes_level(blue);
    return (lanes_texel)(b | g << 8 | r << 16) | UINT32_C(0xFF000000);
}

#endif
