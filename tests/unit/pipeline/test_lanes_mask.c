/* Masks of pixels, lane by lane against plain C; built with the instructions of this processor. */
#include "pipeline/pixel_mask.h"

#include "oracle/oracle.h"
#include "unit/unit.h"

enum { RUNS = 2000 };

static struct random random_state = {17};

/* Often the same few, so that some are equal; also what is no number. */
static double any_double(void) {
    static const double special[] = {0, -0.0, 1, -1, INFINITY, -INFINITY, 0x1p53, NAN};
    uint64_t which = random_bits(&random_state) % 16;
    return which < 8 ? special[which] : random_real(&random_state, -2, 2);
}

static doubles any_doubles(double lane[TOGETHER]) {
    doubles result;
    for (int i = 0; i < TOGETHER; i++) {
        lane[i] = any_double();
    }
    memcpy(&result, lane, sizeof result);
    return result;
}

static bool same_bits(const void *a, const void *b, size_t size) {
    return memcmp(a, b, size) == 0;
}

static void test_masks(void) {
    double a[TOGETHER], b[TOGETHER];
    for (int run = 0; run < RUNS; run++) {
        doubles x = any_doubles(a), y = any_doubles(b);
        pixel_mask not_below = mask_not_below(x, y), above = mask_and_above(not_below, x, y);
        pixel_mask equal = mask_and_equal(not_below, x, y);
        pixel_mask both = mask_and_not_below(not_below, y, x), every_second = {0};
        bool any = false;
        for (int i = 0; i < TOGETHER; i += 2) {
            every_second = mask_set(every_second, i);
        }
        for (int i = 0; i < TOGETHER; i++) {
            CHECK(mask_is_set(not_below, i) == (a[i] >= b[i]));
            CHECK(mask_is_set(above, i) == (a[i] > b[i]));
            CHECK(mask_is_set(equal, i) == (a[i] == b[i]));
            CHECK(mask_is_set(both, i) == (a[i] == b[i]));
            CHECK(mask_is_set(mask_and_above(every_second, x, y), i) ==
                  (i % 2 == 0 && a[i] > b[i]));
            CHECK(mask_is_set(mask_and_equal(every_second, x, y), i) ==
                  (i % 2 == 0 && a[i] == b[i]));
            CHECK(mask_is_set(mask_and_not_below(every_second, x, y), i) ==
                  (i % 2 == 0 && a[i] >= b[i]));
            CHECK(mask_is_set(above | equal, i) == (a[i] >= b[i]));
            any |= a[i] == b[i];
        }
        CHECK(mask_any(equal) == any);
    }
}

static void test_selected(void) {
    double a[TOGETHER], b[TOGETHER], selected[TOGETHER];
    uint32_t number[TOGETHER];
    for (int run = 0; run < RUNS; run++) {
        doubles x = any_doubles(a), y = any_doubles(b);
        pixel_mask above = mask_and_above(mask_not_below(x, x), x, y);
        doubles most = doubles_select(above, x, y);
        ints numbers = {0};
        for (int i = 0; i < TOGETHER; i++) {
            numbers[i] = (int32_t)random_bits(&random_state);
        }
        ints put = ints_select(above, run - RUNS / 2, numbers);
        memcpy(selected, &most, sizeof selected);
        memcpy(number, &put, sizeof number);
        for (int i = 0; i < TOGETHER; i++) {
            CHECK(same_bits(&selected[i], a[i] > b[i] ? &a[i] : &b[i], sizeof selected[i]));
            CHECK((int32_t)number[i] == (a[i] > b[i] ? run - RUNS / 2 : numbers[i]));
        }
    }
}

static void test_counts(void) {
    pixel_counts counts = {0};
    uint64_t count = 0;
    double a[TOGETHER], b[TOGETHER];
    for (int run = 0; run < RUNS; run++) {
        doubles x = any_doubles(a), y = any_doubles(b);
        counts = counts_add(counts, mask_not_below(x, y));
        for (int i = 0; i < TOGETHER; i++) {
            count += a[i] >= b[i];
        }
    }
    CHECK(count > RUNS / 2 && counts_sum(counts) == count);
}

UNIT_MAIN(TEST(test_masks), TEST(test_selected), TEST(test_counts))
