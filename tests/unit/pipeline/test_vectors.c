/* Masks and numbers of vectors.h against plain answers, one at a time. */
#include "oracle/oracle.h"
#include "pipeline/vectors.h"
#include "unit/unit.h"

#include <float.h>

enum { RUNS = 2000 };

static struct random random_state = {31};

/* Of few values, so that two are often equal. */
static double any_number(void) {
    static const double special[] = {0,       -0.0,     1,   -1,       DBL_MIN,
                                     DBL_MAX, -DBL_MAX, NAN, INFINITY, -INFINITY};
    return special[random_between(&random_state, 0, 9)];
}

static doubles any_numbers(void) {
    doubles numbers = {0};
    for (int i = 0; i < TOGETHER; i++) {
        numbers[i] = any_number();
    }
    return numbers;
}

/* One that is set where bit i of the number is. */
static doubles_mask mask_of(unsigned bits) {
    doubles set = {0};
    for (int i = 0; i < TOGETHER; i++) {
        set[i] = bits >> i & 1;
    }
    return mask_above(mask_all(), set, doubles_all(0));
}

static unsigned bits_of(doubles_mask mask) {
    unsigned bits = 0;
    for (int i = 0; i < TOGETHER; i++) {
        bits |= (unsigned)mask_is_set(mask, i) << i;
    }
    return bits;
}

static unsigned any_bits(void) {
    return (unsigned)random_between(&random_state, 0, (1 << TOGETHER) - 1);
}

static bool same_double(double a, double b) {
    return memcmp(&a, &b, sizeof a) == 0;
}

static void test_masks(void) {
    for (unsigned bits = 0; bits < 1U << TOGETHER; bits++) {
        doubles_mask mask = mask_of(bits);
        CHECK(bits_of(mask) == bits);
        CHECK(mask_any(mask) == (bits != 0));
        CHECK(mask_count(mask) == (uint64_t)__builtin_popcount(bits));
    }
}

static void test_comparisons(void) {
    for (int run = 0; run < RUNS; run++) {
        doubles a = any_numbers(), b = any_numbers();
        unsigned bits = any_bits(), not_below = 0, above = 0;
        for (int i = 0; i < TOGETHER; i++) {
            not_below |= (unsigned)(a[i] >= b[i]) << i;
            above |= (unsigned)(a[i] > b[i]) << i;
        }
        CHECK(bits_of(mask_not_below(mask_of(bits), a, b)) == (bits & not_below));
        CHECK(bits_of(mask_above(mask_of(bits), a, b)) == (bits & above));
    }
}

static void test_selected(void) {
    for (int run = 0; run < RUNS; run++) {
        unsigned bits = any_bits();
        doubles a = any_numbers(), b = any_numbers(), chosen = doubles_select(mask_of(bits), a, b);
        int32_t number = (int32_t)random_between(&random_state, INT32_MIN, INT32_MAX);
        ints old = {0};
        for (int i = 0; i < TOGETHER; i++) {
            old[i] = (int32_t)random_between(&random_state, INT32_MIN, INT32_MAX);
        }
        ints numbers = ints_select(mask_of(bits), number + (ints){0}, old);
        for (int i = 0; i < TOGETHER; i++) {
            bool set = (bits >> i & 1) != 0;
            CHECK(same_double(chosen[i], set ? a[i] : b[i]));
            CHECK(same_double(doubles_min(a, b)[i], a[i] < b[i] ? a[i] : b[i]));
            CHECK(same_double(doubles_max(a, b)[i], a[i] > b[i] ? a[i] : b[i]));
            CHECK(same_double(doubles_abs(a)[i], fabs(a[i])));
            CHECK(doubles_from_ints(old)[i] == old[i]);
            CHECK(numbers[i] == (set ? number : old[i]));
        }
    }
}

UNIT_MAIN(TEST(test_masks), TEST(test_comparisons), TEST(test_selected))
