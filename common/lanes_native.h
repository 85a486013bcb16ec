/*
 * The greater and the lesser of two numbers, lane by lane: `a > b ? a : b` and `a < b ? a : b`, in
 * every bit, also where one is not a number or both are zero. Private to lanes.h.
 *
 * x86 has an instruction for just that (maxps, "Intel 64 and IA-32 Architectures Software
 * Developer's Manual", volume 2). gcc 12 does not make it of a comparison and a choice, which take
 * two instructions and a register for masks: a seventh of the time of a textured pixel. So here,
 * and nowhere else, the compiler is told which instruction is meant.
 */
#ifndef COMMON_LANES_NATIVE_H
#define COMMON_LANES_NATIVE_H

#ifndef COMMON_LANES_H
#error "include lanes.h instead"
#endif

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

LANES_INLINE lanes lanes_max(lanes a, lanes b) {
#ifdef LANES_NATIVE
    return LANES_NATIVE(max, a, b);
#else
    return lanes_select(a > b, a, b);
#endif
}

LANES_INLINE lanes lanes_min(lanes a, lanes b) {
#ifdef LANES_NATIVE
    return LANES_NATIVE(min, a, b);
#else
    return lanes_select(a < b, a, b);
#endif
}

#endif
