/*
 * What x86 has an instruction for that gcc 12 and clang 14 do not find by themselves: here, in
 * pixel_mask.h and for lanes_max() and lanes_min(), and nowhere else, the compiler is told which
 * one is meant ("Intel 64 and IA-32 Architectures Software Developer's Manual", volume 2). The
 * plain C next to it says what it does. Private to the pipeline and to texture_lanes.h.
 *
 *     lanes_join()                a mask of bits: gcc makes one of lanes, and three instructions of
 *                                 a sum of which some lanes are kept; a twentieth of a Phong pixel
 *     lanes_bits()                vpmovd2m, movmskps: a twentieth of the time of a textured pixel
 *     lanes_split()               vshufps: gcc takes eight instructions more; a twentieth of a
 *                                 textured pixel's time
 *     lanes_fetch(),              vpgatherdd, vpgatherdq, vpermt2d: both load word by word, and put
 *     lanes_fetch_pairs()         the words together one by one; a twentieth of the time of a flat
 *                                 pixel, a tenth of a textured one's. Only for processors with
 *                                 AVX512-FP16: on older ones gathering is slow since 2023 (Intel,
 *                                 "Gather Data Sampling", INTEL-SA-00828)
 *     lanes_four_to_doubles(),    vcvtdq2pd: gcc converts one half after the other, and puts them
 *     lanes_eight_to_doubles()    together; a fortieth of a frame of small triangles
 */
#ifndef COMMON_LANES_NATIVE_H
#define COMMON_LANES_NATIVE_H

#include "lanes.h"

/* Lanes 0 to `first` - 1 of a, the others of b. */
LANES_INLINE lanes lanes_join(lanes a, int first, lanes b) {
#if LANES_OF_TYPE(REAL) == 16 && defined(__AVX512F__) && defined(__clang__)
    return __builtin_ia32_selectps_512((uint16_t)(0xFFFFU << first), b, a);
#elif LANES_OF_TYPE(REAL) == 16 && defined(__AVX512F__)
    return __builtin_ia32_blendmps_512_mask(a, b, (uint16_t)(0xFFFFU << first));
#else
    return lanes_select(lanes_not_before(first), b, a);
#endif
}

/* Bit i of the result is set where lane i of the mask is. */
LANES_INLINE uint32_t lanes_bits(lanes_int mask) {
#if LANES == 16 && defined(__AVX512DQ__)
    typedef int sixteen __attribute__((vector_size(64)));
    return (uint16_t)__builtin_ia32_cvtd2mask512((sixteen)mask);
#elif LANES == 8 && defined(__AVX__)
    typedef float eight __attribute__((vector_size(32)));
    return (uint32_t)__builtin_ia32_movmskps256((eight)mask);
#elif LANES == 4 && defined(__SSE__)
    typedef float four __attribute__((vector_size(16)));
    return (uint32_t)__builtin_ia32_movmskps((four)mask);
#else
    int32_t lane[LANES];
    uint32_t bits = 0;
    memcpy(lane, &mask, sizeof lane);
    for (int i = 0; i < LANES; i++) {
        bits |= (uint32_t)(lane[i] != 0) << i;
    }
    return bits;
#endif
}

#if LANES == 16 && defined(__AVX512FP16__)
#define LANES_GATHERED

/* All bits of a mask, of the type that the compiler wants. */
#ifdef __clang__
static const unsigned char lanes_eight_set = (unsigned char)-1;
static const unsigned short lanes_sixteen_set = (unsigned short)-1;
#else
static const signed char lanes_eight_set = -1;
static const short lanes_sixteen_set = -1;
#endif

/* The pairs of eight lanes: a, b, a, b, ... */
typedef long long lanes_eight_pairs __attribute__((vector_size(64)));
typedef int32_t lanes_eight_indices __attribute__((vector_size(32)));

LANES_INLINE lanes_texel lanes_gather_pairs(const uint32_t *texels, lanes_eight_indices index) {
    return (lanes_texel)__builtin_ia32_gathersiv8di((lanes_eight_pairs){0}, (const void *)texels,
                                                    index, lanes_eight_set, sizeof *texels);
}

#endif

/* texels[index[i]] for each lane i; an index is below 2^31. Where one instruction does not do it,
 * it is worth to ask whether all are the same. */
LANES_INLINE lanes_texel lanes_fetch(const uint32_t *texels, const uint32_t index[LANES]) {
#ifdef LANES_GATHERED
    typedef int32_t sixteen __attribute__((vector_size(64)));
    sixteen at;
    memcpy(&at, index, sizeof at);
    return (lanes_texel)__builtin_ia32_gathersiv16si((sixteen){0}, texels, at, lanes_sixteen_set,
                                                     sizeof *texels);
#else
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
#endif
}

/* Where the two texels of a lane stand while those of all lanes are taken apart: of each four lanes
 * two in one half, and two in the other. So one instruction, vshufps, does it in all quarters of a
 * register, and nothing need be moved across. */
LANES_INLINE int lanes_pair_place(int lane) {
    return LANES < 4 ? lane : lane % 4 / 2 * (LANES / 2) + lane / 4 * 2 + lane % 2;
}

/* The lower and the upper 32 bits of the words of each lane. */
LANES_INLINE void lanes_split_plainly(const uint64_t words[LANES], lanes_texel *lower,
                                      lanes_texel *upper) {
    uint32_t low[LANES], high[LANES];
    for (int i = 0; i < LANES; i++) {
        low[i] = (uint32_t)words[lanes_pair_place(i)];
        high[i] = (uint32_t)(words[lanes_pair_place(i)] >> 32);
    }
    memcpy(lower, low, sizeof low);
    memcpy(upper, high, sizeof high);
}

/* Only where the lower half of a word comes first in memory. */
#if defined(__has_builtin) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
#if __has_builtin(__builtin_shufflevector)
#define LANES_SHUFFLE __builtin_shufflevector
#endif
#endif

/* The same. As if they were floats, of which no bit changes: for whole numbers gcc and clang choose
 * slower instructions. */
LANES_INLINE void lanes_split(const uint64_t words[LANES], lanes_texel *lower, lanes_texel *upper) {
#if LANES > 1 && defined(LANES_SHUFFLE)
    typedef float floats __attribute__((vector_size(LANES * sizeof(float))));
    floats a, b;
    memcpy(&a, words, sizeof a);
    memcpy(&b, words + LANES / 2, sizeof b);
#endif
#if LANES == 16 && defined(LANES_SHUFFLE)
    *lower =
        (lanes_texel)LANES_SHUFFLE(a, b, 0, 2, 16, 18, 4, 6, 20, 22, 8, 10, 24, 26, 12, 14, 28, 30);
    *upper =
        (lanes_texel)LANES_SHUFFLE(a, b, 1, 3, 17, 19, 5, 7, 21, 23, 9, 11, 25, 27, 13, 15, 29, 31);
#elif LANES == 8 && defined(LANES_SHUFFLE)
    *lower = (lanes_texel)LANES_SHUFFLE(a, b, 0, 2, 8, 10, 4, 6, 12, 14);
    *upper = (lanes_texel)LANES_SHUFFLE(a, b, 1, 3, 9, 11, 5, 7, 13, 15);
#elif LANES == 4 && defined(LANES_SHUFFLE)
    *lower = (lanes_texel)LANES_SHUFFLE(a, b, 0, 2, 4, 6);
    *upper = (lanes_texel)LANES_SHUFFLE(a, b, 1, 3, 5, 7);
#else
    lanes_split_plainly(words, lower, upper);
#endif
}

/* The lanes as numbers of their own. gcc takes a register of 16 apart sooner by 64 bits than by 32;
 * clang would gather then. */
LANES_INLINE void lanes_take_apart(lanes_texel from, uint32_t lane[LANES]) {
#if LANES == 16 && !defined(__clang__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
    uint64_t two[LANES / 2];
    memcpy(two, &from, sizeof two);
    for (int i = 0; i < LANES; i++) {
        lane[i] = (uint32_t)(two[i / 2] >> i % 2 * 32);
    }
#else
    memcpy(lane, &from, LANES * sizeof *lane);
#endif
}

/* A texel and the one behind it. */
LANES_INLINE uint64_t lanes_pair(const uint32_t *texel) {
    return texel[0] | (uint64_t)texel[1] << 32;
}

/* texels[index[i]] and the texel behind it, for each lane i; an index is below 2^30. */
LANES_INLINE void lanes_fetch_pairs(const uint32_t *texels, lanes_texel index, lanes_texel *first,
                                    lanes_texel *second) {
#ifdef LANES_GATHERED
    lanes_int at = (lanes_int)index;
    lanes_texel low =
        lanes_gather_pairs(texels, __builtin_shufflevector(at, at, 0, 1, 2, 3, 4, 5, 6, 7));
    lanes_texel high =
        lanes_gather_pairs(texels, __builtin_shufflevector(at, at, 8, 9, 10, 11, 12, 13, 14, 15));
    *first = __builtin_shufflevector(low, high, 0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26,
                                     28, 30);
    *second = __builtin_shufflevector(low, high, 1, 3, 5, 7, 9, 11, 13, 15, 17, 19, 21, 23, 25, 27,
                                      29, 31);
#else
    uint32_t place[LANES];
    uint64_t pair[LANES];
    lanes_take_apart(index * (uint32_t)sizeof *texels, place); /* in bytes: no one need be scaled */
    for (int i = 0; i < LANES; i++) {
        pair[lanes_pair_place(i)] = lanes_pair((const void *)((const char *)texels + place[i]));
    }
    lanes_split(pair, first, second);
#endif
}

/* What is in memory is read again after this. gcc would keep all indices in registers for the next
 * row of texels, has too few of them, and puts most on the stack; clang does well without. */
#ifdef __clang__
#define LANES_READ_AGAIN() (void)0
#else
#define LANES_READ_AGAIN() __asm__ volatile("" ::: "memory")
#endif

/* Keep where texels are in place of a varying: as many bytes behind the first texel. */
LANES_INLINE void lanes_keep_index(lanes *kept, lanes_texel index) {
    index *= (uint32_t)sizeof(uint32_t);
    memcpy(kept, &index, sizeof index);
}

LANES_INLINE const uint32_t *lanes_kept_texel(const uint32_t *texels, const lanes *kept, int i) {
    uint32_t place;
    memcpy(&place, (const char *)kept + (size_t)i * sizeof place, sizeof place);
    return (const void *)((const char *)texels + place);
}

/* lanes_fetch_pairs() where indices were kept long ago: each is a number of its own in memory then,
 * and no register need be taken apart. */
LANES_INLINE void lanes_fetch_kept_pairs(const uint32_t *texels, const lanes *kept,
                                         lanes_texel *first, lanes_texel *second) {
#ifdef LANES_GATHERED
    lanes_texel place;
    memcpy(&place, kept, sizeof place);
    lanes_fetch_pairs(texels, place / (uint32_t)sizeof *texels, first, second);
#else
    uint64_t pair[LANES];
    for (int i = 0; i < LANES; i++) {
        pair[lanes_pair_place(i)] = lanes_pair(lanes_kept_texel(texels, kept, i));
    }
    lanes_split(pair, first, second);
#endif
}

/* Whole numbers as doubles. */
typedef int32_t lanes_four_ints __attribute__((vector_size(4 * sizeof(int32_t))));
typedef double lanes_four_doubles __attribute__((vector_size(4 * sizeof(double))));
typedef int32_t lanes_eight_ints __attribute__((vector_size(8 * sizeof(int32_t))));
typedef double lanes_eight_doubles __attribute__((vector_size(8 * sizeof(double))));

LANES_INLINE lanes_four_doubles lanes_four_to_doubles(lanes_four_ints whole) {
#if defined(__AVX__) && !defined(__clang__)
    return __builtin_ia32_cvtdq2pd256(whole);
#else
    return __builtin_convertvector(whole, lanes_four_doubles);
#endif
}

LANES_INLINE lanes_eight_doubles lanes_eight_to_doubles(lanes_eight_ints whole) {
#if defined(__AVX512F__) && !defined(__clang__)
    return __builtin_ia32_cvtdq2pd512_mask(whole, (lanes_eight_doubles){0}, 255);
#else
    return __builtin_convertvector(whole, lanes_eight_doubles);
#endif
}

#endif
