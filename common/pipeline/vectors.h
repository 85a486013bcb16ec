/*
 * Private to the pipeline: vectors, several numbers in one register of the processor.
 *
 *     lanes, lanes_int, lanes_texel    of LANES pixels or faces; lanes.h has them and what shaders
 *                                      need, here is what only the pipeline does with them
 *     doubles, longs, ints             of TOGETHER pixels, positions or pieces, half as many as
 *                                      LANES, since 64-bit numbers take twice the room: for what
 *                                      must be exact
 *     doubles_mask                     where a comparison of doubles holds
 *     double4, long4, int4             of the three corners or edges of one triangle
 *
 * Each function is plain C. Where x86 has an instruction for it that gcc 12 and clang 14 do not
 * find by themselves, an intrinsic names the instruction, and the plain C next to it says what it
 * does. ("Intel 64 and IA-32 Architectures Software Developer's Manual", volume 2.)
 */
#ifndef COMMON_PIPELINE_VECTORS_H
#define COMMON_PIPELINE_VECTORS_H

#include "lanes.h"

#if LANES >= 8 && defined(__AVX2__)
#include <immintrin.h>
#endif

/* ---- LANES numbers ---- */

/* Lanes 0 to `first` - 1 of a, the others of b. */
LANES_INLINE lanes lanes_join(lanes a, int first, lanes b) {
    return lanes_select(lanes_not_before(first), b, a);
}

/* Bit i of the result is set where lane i of the mask is. (0.75 of the time of a flat frame.) */
LANES_INLINE uint32_t lanes_bits(lanes_int mask) {
#if LANES == 16 && defined(__AVX512DQ__)
    return _mm512_movepi32_mask((__m512i)mask);
#elif LANES == 8 && defined(__AVX2__)
    return (uint32_t)_mm256_movemask_ps((__m256)mask);
#else
    uint32_t bits = 0;
    for (int i = 0; i < LANES; i++) {
        bits |= (uint32_t)(mask[i] != 0) << i;
    }
    return bits;
#endif
}

/* Round down to a whole number. A number beyond 2^22 may become any other one. */
LANES_INLINE lanes lanes_floor_any(lanes a) {
    const real whole = LANES_IS_FLOAT ? 0x1.8p23f : (real)0x1.8p52; /* so large: no fraction */
    lanes nearest = (a + whole) - whole;
    return lanes_select(nearest > a, nearest - 1, nearest);
}

LANES_INLINE lanes_int lanes_int_all(int32_t value) {
    return value + (lanes_int){0};
}

LANES_INLINE lanes_int lanes_int_min(lanes_int a, lanes_int b) {
    return VECTOR_SELECT(a < b, a, b);
}

LANES_INLINE lanes_int lanes_int_max(lanes_int a, lanes_int b) {
    return VECTOR_SELECT(a > b, a, b);
}

LANES_INLINE lanes_int lanes_int_load(const int32_t from[LANES]) {
    lanes_int values;
    memcpy(&values, from, sizeof values);
    return values;
}

/* Lane i of the result is texels[index[i]]. Mostly all indices are the same, which is faster. */
LANES_INLINE lanes_texel lanes_fetch(const uint32_t *texels, const uint32_t index[LANES]) {
    lanes_texel all;
    memcpy(&all, index, sizeof all);
    if (lanes_bits((lanes_int)(all != index[0])) == 0) {
        return (lanes_texel){0} + texels[index[0]];
    }
    uint32_t fetched[LANES];
    for (int i = 0; i < LANES; i++) {
        fetched[i] = texels[index[i]];
    }
    memcpy(&all, fetched, sizeof all);
    return all;
}

/* For each lane, fetch the texel that is so many bytes behind the first one, and the texel behind
 * it. Both are read at once, as a pair. */
LANES_INLINE void lanes_fetch_pairs(const uint32_t *texels, lanes_texel bytes, lanes_texel *first,
                                    lanes_texel *second) {
    uint32_t at[LANES], lower[LANES], upper[LANES];
    uint64_t pair[LANES];
    memcpy(at, &bytes, sizeof at);
    for (int i = 0; i < LANES; i++) {
        const uint32_t *texel = (const void *)((const char *)texels + at[i]);
        pair[i] = texel[0] | (uint64_t)texel[1] << 32;
    }
    for (int i = 0; i < LANES; i++) {
        lower[i] = (uint32_t)pair[i];
        upper[i] = (uint32_t)(pair[i] >> 32);
    }
    memcpy(first, lower, sizeof *first);
    memcpy(second, upper, sizeof *second);
}

/* ---- TOGETHER numbers of 64 bits, for what must be exact ---- */

#define TOGETHER ((LANES + 1) / 2)
typedef int32_t ints __attribute__((vector_size(TOGETHER * sizeof(int32_t))));
typedef int64_t longs __attribute__((vector_size(TOGETHER * sizeof(int64_t))));
typedef double doubles __attribute__((vector_size(TOGETHER * sizeof(double))));

/* A number for each corner or edge of a triangle, and a fourth one that nobody looks at. */
typedef int32_t int4 __attribute__((vector_size(4 * sizeof(int32_t))));
typedef int64_t long4 __attribute__((vector_size(4 * sizeof(int64_t))));
typedef double double4 __attribute__((vector_size(4 * sizeof(double))));

LANES_INLINE doubles doubles_all(double value) {
    return value - (doubles){0};
}

/* 0, 1, 2, ... */
LANES_INLINE doubles doubles_count(void) {
    doubles count = {0};
    for (int i = 0; i < TOGETHER; i++) {
        count[i] = i;
    }
    return count;
}

LANES_INLINE doubles doubles_load(const double from[TOGETHER]) {
    doubles values;
    memcpy(&values, from, sizeof values);
    return values;
}

LANES_INLINE doubles doubles_abs(doubles value) {
    return (doubles)((longs)value & INT64_MAX);
}

/* ---- Masks of TOGETHER doubles ---- */

#if LANES == 16 && defined(__AVX512DQ__) && defined(__AVX512VL__)

/* A mask register has one bit for each number; gcc 12 would use vectors of 64-bit words instead. */
typedef __mmask8 doubles_mask;

LANES_INLINE doubles_mask mask_all(void) {
    return 255;
}

/* Where the mask is set and a >= b, or a > b; unset where one of them is NaN. */
LANES_INLINE doubles_mask mask_not_below(doubles_mask m, doubles a, doubles b) {
    return _mm512_mask_cmp_pd_mask(m, (__m512d)a, (__m512d)b, _CMP_GE_OQ);
}

LANES_INLINE doubles_mask mask_above(doubles_mask m, doubles a, doubles b) {
    return _mm512_mask_cmp_pd_mask(m, (__m512d)a, (__m512d)b, _CMP_GT_OQ);
}

/* VECTOR_SELECT() for masks of this type, by one instruction where there is one. */
LANES_INLINE doubles doubles_select(doubles_mask m, doubles a, doubles b) {
    return (doubles)_mm512_mask_blend_pd(m, (__m512d)b, (__m512d)a);
}

LANES_INLINE ints ints_select(doubles_mask m, ints a, ints b) {
    return (ints)_mm256_mask_blend_epi32(m, (__m256i)b, (__m256i)a);
}

LANES_INLINE bool mask_is_set(doubles_mask m, int i) {
    return (m >> i & 1) != 0;
}

LANES_INLINE bool mask_any(doubles_mask m) {
    return m != 0;
}

#else

typedef longs doubles_mask; /* all bits or none */

LANES_INLINE doubles_mask mask_all(void) {
    return ~(longs){0};
}

LANES_INLINE doubles_mask mask_not_below(doubles_mask m, doubles a, doubles b) {
    return m & (a >= b);
}

LANES_INLINE doubles_mask mask_above(doubles_mask m, doubles a, doubles b) {
    return m & (a > b);
}

LANES_INLINE doubles doubles_select(doubles_mask m, doubles a, doubles b) {
#if LANES == 8 && defined(__AVX2__)
    return (doubles)_mm256_blendv_pd((__m256d)b, (__m256d)a, (__m256d)m);
#else
    return VECTOR_SELECT(m, a, b);
#endif
}

LANES_INLINE ints ints_select(doubles_mask m, ints a, ints b) {
#if LANES == 8 && defined(__AVX2__)
    __m128 low = _mm256_castps256_ps128((__m256)m), high = _mm256_extractf128_ps((__m256)m, 1);
    __m128 narrow = _mm_shuffle_ps(low, high, _MM_SHUFFLE(2, 0, 2, 0));
    return (ints)_mm_blendv_ps((__m128)b, (__m128)a, narrow);
#else
    ints narrow = __builtin_convertvector(m, ints);
    return VECTOR_SELECT(narrow, a, b);
#endif
}

LANES_INLINE bool mask_is_set(doubles_mask m, int i) {
    return m[i] != 0;
}

LANES_INLINE bool mask_any(doubles_mask m) {
    int64_t any = 0;
    for (int i = 0; i < TOGETHER; i++) {
        any |= m[i];
    }
    return any != 0;
}

#endif

LANES_INLINE doubles doubles_min(doubles a, doubles b) {
    return doubles_select(mask_above(mask_all(), b, a), a, b);
}

LANES_INLINE doubles doubles_max(doubles a, doubles b) {
    return doubles_select(mask_above(mask_all(), a, b), a, b);
}

LANES_INLINE uint64_t mask_count(doubles_mask m) {
    uint64_t count = 0;
    for (int i = 0; i < TOGETHER; i++) {
        count += mask_is_set(m, i);
    }
    return count;
}

#endif
