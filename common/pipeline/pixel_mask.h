/*
 * For which of several pixels a comparison of doubles holds. Private to bands.c, where a
 * row of pixels is covered by such masks.
 *
 * With AVX-512 a processor keeps masks in registers of their own, one bit a pixel. gcc 12 makes
 * words of 64 bits of them again for every operator, and clang 14 counts those. So they are told
 * here, as in lanes_native.h, which instructions are meant (vcmppd, vblendmpd, vpblendmd: "Intel 64
 * and IA-32 Architectures Software Developer's Manual", volume 2). A flat frame takes 0.85 of the
 * time by that with gcc, 0.90 with clang. With AVX2 masks are registers of 64 bits a pixel; which
 * instructions choose by those (vblendvpd, vblendvps), and which make them narrow, gcc does not see
 * either: 0.93. The plain C beside it says what each of them does.
 */
#ifndef COMMON_PIXEL_MASK_H
#define COMMON_PIXEL_MASK_H

#include "pipeline.h"

#if LANES == 16 && defined(__AVX512DQ__) && defined(__AVX512VL__)
#define PIXEL_MASK_NATIVE
#include <immintrin.h>

typedef __mmask8 pixel_mask;
typedef int64_t pixel_counts;
#else
#if LANES == 8 && defined(__AVX2__)
#define PIXEL_MASK_BLENDS
#include <immintrin.h>
#endif

typedef longs pixel_mask;   /* all bits or none */
typedef longs pixel_counts; /* of each place in the masks */
#endif

/* a >= b; false where one is not a number, as in all of these. */
LANES_INLINE pixel_mask mask_not_below(doubles a, doubles b) {
#ifdef PIXEL_MASK_NATIVE
    return _mm512_cmp_pd_mask((__m512d)a, (__m512d)b, _CMP_GE_OQ);
#else
    return a >= b;
#endif
}

/* Where the mask is set, and a >= b. */
LANES_INLINE pixel_mask mask_and_not_below(pixel_mask mask, doubles a, doubles b) {
#ifdef PIXEL_MASK_NATIVE
    return _mm512_mask_cmp_pd_mask(mask, (__m512d)a, (__m512d)b, _CMP_GE_OQ);
#else
    return mask & (a >= b);
#endif
}

/* Where the mask is set, and a > b. */
LANES_INLINE pixel_mask mask_and_above(pixel_mask mask, doubles a, doubles b) {
#ifdef PIXEL_MASK_NATIVE
    return _mm512_mask_cmp_pd_mask(mask, (__m512d)a, (__m512d)b, _CMP_GT_OQ);
#else
    return mask & (a > b);
#endif
}

/* Where the mask is set, and a == b. */
LANES_INLINE pixel_mask mask_and_equal(pixel_mask mask, doubles a, doubles b) {
#ifdef PIXEL_MASK_NATIVE
    return _mm512_mask_cmp_pd_mask(mask, (__m512d)a, (__m512d)b, _CMP_EQ_OQ);
#else
    return mask & (a == b);
#endif
}

LANES_INLINE bool mask_is_set(pixel_mask mask, int i) {
#ifdef PIXEL_MASK_NATIVE
    return (mask >> i & 1) != 0;
#else
    return mask[i] != 0;
#endif
}

/* The same mask, and set at place i. */
LANES_INLINE pixel_mask mask_set(pixel_mask mask, int i) {
#ifdef PIXEL_MASK_NATIVE
    return (pixel_mask)(mask | 1U << i);
#else
    mask[i] = -1;
    return mask;
#endif
}

LANES_INLINE bool mask_any(pixel_mask mask) {
#ifdef PIXEL_MASK_NATIVE
    return mask != 0;
#elif LANES > 1
    return lanes_bits((lanes_int)mask) != 0;
#else
    return (mask[0] | mask[1]) != 0;
#endif
}

/* Where the mask is set a, elsewhere b; with `+` as in lanes_select(). */
LANES_INLINE doubles doubles_select(pixel_mask mask, doubles a, doubles b) {
#ifdef PIXEL_MASK_NATIVE
    return (doubles)_mm512_mask_blend_pd(mask, (__m512d)b, (__m512d)a);
#elif defined(PIXEL_MASK_BLENDS)
    return (doubles)_mm256_blendv_pd((__m256d)b, (__m256d)a, (__m256d)mask);
#else
    return (doubles)((mask & (longs)a) + (~mask & (longs)b));
#endif
}

/* The same for numbers; a is one for all. */
LANES_INLINE ints ints_select(pixel_mask mask, int32_t a, ints b) {
#ifdef PIXEL_MASK_NATIVE
    return (ints)_mm256_mask_blend_epi32(mask, (__m256i)b, _mm256_set1_epi32(a));
#elif defined(PIXEL_MASK_BLENDS)
    __m256 wide = (__m256)mask;
    __m128 low = _mm256_castps256_ps128(wide), high = _mm256_extractf128_ps(wide, 1);
    __m128 narrow = _mm_shuffle_ps(low, high, _MM_SHUFFLE(2, 0, 2, 0));
    return (ints)_mm_blendv_ps((__m128)b, (__m128)_mm_set1_epi32(a), narrow);
#else
    ints narrow = __builtin_convertvector(mask, ints);
    return (narrow & a) | (~narrow & b);
#endif
}

/* The counts, and each set place of the mask. */
LANES_INLINE pixel_counts counts_add(pixel_counts counts, pixel_mask mask) {
#ifdef PIXEL_MASK_NATIVE
    return counts + __builtin_popcount(mask);
#else
    return counts - mask;
#endif
}

LANES_INLINE uint64_t counts_sum(pixel_counts counts) {
#ifdef PIXEL_MASK_NATIVE
    return (uint64_t)counts;
#else
    uint64_t sum = 0;
    for (int i = 0; i < TOGETHER; i++) {
        sum += (uint64_t)counts[i];
    }
    return sum;
#endif
}

#endif
