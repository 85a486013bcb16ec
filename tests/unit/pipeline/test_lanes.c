/* lanes.h against plain C, number by number; texture_lanes.h against texture_bilinear(). */
#include "oracle/oracle.h"
#include "pipeline/texture_lanes.h"
#include "unit/images.h"

enum { ROUNDS = 3000 };

/* What rounding a number near 1 costs at most. */
static const double ulp = sizeof(real) == sizeof(float) ? 0x1p-24 : 0x1p-53;

/* Any number; often a whole one, a half, one that is negative or just below another. */
static real any_number(struct random *random) {
    static const real special[] = {0, 1, -1, 0.5f, -0.5f, 254.5f, 255, 256, -3, 127.5f};
    uint64_t kind = random_bits(random) % 4;
    real number = (real)random_real(random, -300, 300);
    if (kind == 0) {
        number = special[random_bits(random) % (sizeof special / sizeof special[0])];
    } else if (kind == 1) {
        number = (real)floor((double)number);
        number *= random_bits(random) % 2 ? 1 : 1 - (real)ulp * 2;
    }
    return number;
}

static lanes any_numbers(struct random *random) {
    lanes numbers = {0};
    for (int i = 0; i < LANES; i++) {
        numbers[i] = any_number(random);
    }
    return numbers;
}

static bool same(real a, real b) {
    return memcmp(&a, &b, sizeof a) == 0 || (a == 0 && b == 0);
}

static real square_root(real a) {
    return sizeof(real) == sizeof(float) ? (real)sqrtf((float)a) : (real)sqrt((double)a);
}

/* ---- Numbers ---- */

static void test_one_number(void) {
    struct random random = {91};
    bool right = true;
    for (int round = 0; round < ROUNDS; round++) {
        lanes given = any_numbers(&random);
        real number = any_number(&random);
        lanes all = lanes_all(number), root = lanes_sqrt(given * given);
        lanes floors = lanes_floor(given), back = lanes_from_int(lanes_to_int(given));
        lanes_int whole = lanes_to_int(given);
        for (int i = 0; i < LANES; i++) {
            real x = given[i];
            right = right && same(all[i], number) && same(root[i], square_root(x * x)) &&
                    same(floors[i], (real)floor((double)x)) && whole[i] == (int32_t)x &&
                    same(back[i], (real)(int32_t)x);
        }
    }
    CHECK(right);
}

static bool same_bits(real a, real b) {
    return memcmp(&a, &b, sizeof a) == 0;
}

/* Any number, or one that is compared in another way: zeros of both signs, what is no number. */
static real any_special(struct random *random) {
    static const real special[] = {0,      -0.0f,          (real)NAN, (real)-NAN,
                                   1e-38f, (real)INFINITY, -1,        3.5f};
    uint64_t which = random_bits(random) % 16;
    return which < 8 ? special[which] : any_number(random);
}

/* To the last bit: an instruction gives the second of two zeros, and where one is no number. */
static void test_two_numbers(void) {
    struct random random = {92};
    bool right = true;
    for (int round = 0; round < ROUNDS; round++) {
        lanes a = {0}, b = {0};
        int first = round % LANES;
        for (int i = 0; i < LANES; i++) {
            a[i] = any_special(&random);
            b[i] = random_bits(&random) % 4 == 0 ? a[i] : any_special(&random);
        }
        lanes_mask less = a < b;
        lanes most = lanes_max(a, b), least = lanes_min(a, b), other = lanes_select(less, b, a);
        lanes joined = lanes_join(a, first, b);
        lanes_int level = lanes_level(a); /* 0 of what is no number */
        for (int i = 0; i < LANES; i++) {
            real x = a[i], y = b[i], bounded = x > 0 ? (x < 255 ? x : 255) : 0;
            right = right && level[i] == (int32_t)(bounded + 0.5f) &&
                    same_bits(most[i], x > y ? x : y) && same_bits(least[i], x < y ? x : y) &&
                    same_bits(other[i], x < y ? y : x) && same_bits(joined[i], i < first ? x : y) &&
                    lanes_is_set(less, i) == (x < y) && lanes_is_set(lanes_all_set(), i) &&
                    lanes_is_set(less & lanes_all_set(), i) == (x < y);
        }
    }
    CHECK(right);
}

static void test_sequences(void) {
    lanes_int whole = lanes_int_from(-7);
    lanes reals = lanes_from(100000);
    uint64_t sum = 0;
    for (int i = 0; i < LANES; i++) {
        CHECK(whole[i] == -7 + i && same(reals[i], (real)(100000 + i)));
        sum += (uint64_t)i + 3;
    }
    CHECK(lanes_sum(lanes_int_from(3)) == sum);
}

/* The last texels of the largest textures, whose bytes an int32_t cannot count: here only those are
 * in memory. */
static void test_far_texels(void) {
    enum { COUNT = 2 * LANES + 1 };
    uint32_t texels[COUNT], index[LANES];
    const uint32_t first_index = TEXTURE_TEXEL_LIMIT - 2 * LANES;
    uintptr_t begin = (uintptr_t)texels - (uintptr_t)first_index * sizeof *texels;
    lanes_texel indices, first, second;
    for (uint32_t i = 0; i < COUNT; i++) {
        texels[i] = i + 5;
    }
    for (uint32_t i = 0; i < LANES; i++) {
        index[i] = first_index + 2 * i;
    }
    memcpy(&indices, index, sizeof indices);
    lanes_fetch_pairs((const uint32_t *)begin, 4 * indices, &first, &second);
    for (uint32_t i = 0; i < LANES; i++) {
        CHECK(lanes_texel_at(first, (int)i) == 2 * i + 5);
        CHECK(lanes_texel_at(second, (int)i) == 2 * i + 6);
    }
}

/* ---- Colours ---- */

static void test_colors(void) {
    struct random random = {93};
    bool right = true;
    for (int round = 0; round < ROUNDS; round++) {
        lanes r = any_numbers(&random), g = any_numbers(&random), b = any_numbers(&random);
        lanes_texel color = lanes_rgb(r, g, b);
        uint32_t bits = 0; /* one for each lane whose mask is set */
        lanes_int mask = {0};
        for (int i = 0; i < LANES; i++) {
            mask[i] = -(int32_t)(random_bits(&random) % 2);
            bits |= (uint32_t)mask[i] & UINT32_C(1) << i;
        }
        lanes_texel chosen = VECTOR_SELECT(mask, color, lanes_black());
        right = right && lanes_bits(mask) == bits;
        for (int i = 0; i < LANES; i++) {
            uint32_t texel = (uint32_t)lanes_level(b)[i] | (uint32_t)lanes_level(g)[i] << 8 |
                             (uint32_t)lanes_level(r)[i] << 16 | UINT32_C(0xFF000000);
            right = right && lanes_texel_at(color, i) == texel &&
                    lanes_texel_at(chosen, i) == (mask[i] ? texel : UINT32_C(0xFF000000));
        }
    }
    CHECK(right);
}

/* ---- Textures ---- */

enum { LARGEST = 8 }; /* coordinate that has a fraction */

/* Corners, edges, texel centres and borders, outside, far outside, nowhere. */
static real any_coordinate(struct random *random, size_t size) {
    static const double special[] = {0,     1,     -1,     2,   1e9, -1e9,    1e30,
                                     -1e30, 1e-30, -1e-30, 0.5, NAN, INFINITY};
    switch (random_bits(random) % 5) {
    case 0:
        return (real)special[random_bits(random) % (sizeof special / sizeof special[0])];
    case 1:
        return (real)((double)random_between(random, 0, 2 * (int64_t)size) / (2 * (double)size));
    case 4:
        return (real)random_real(random, -LARGEST, LARGEST);
    case 2:
        return (real)random_real(random, -0.1, 1.1);
    default:
        return (real)random_real(random, 0, 1);
    }
}

/* A coordinate is multiplied by the size, a half is taken away, and whole pictures: 4 roundings of
 * a place, as far outside the picture as it is; levels change by up to 255 from texel to texel,
 * along both axes; and a few roundings of levels. */
static double sample_tolerance(size_t width, size_t height) {
    return 255 * ulp * (4 * LARGEST * (double)(width + height) + 16);
}

static bool is_level(real value) {
    return value >= 0 && (double)value <= 255 * (1 + 16 * ulp);
}

static bool sample_is_right(const struct texture *texture, size_t level, struct lanes2 uv) {
    struct lanes3 got = texture_lanes(texture, uv, level);
    struct texel_place place = {0};
    struct texels texels = texture_fetch(texture, uv, level, &place);
    struct texels again = texture_fetch(texture, uv, level, &place);
    size_t last = texture->level_count - 1;
    const struct texture_level *l = &texture->level[level < last ? level : last];
    double tolerance = sample_tolerance(l->width, l->height);
    bool right = memcmp(&texels, &again, sizeof texels) == 0;
    for (int i = 0; i < LANES; i++) {
        double far = fmax(fabs((double)uv.x[i]), fabs((double)uv.y[i]));
        bool nowhere = !isfinite(uv.x[i] + uv.y[i]) || (!texture->clamp && far > 1e6);
        if (nowhere) { /* any place will do */
            right = right && is_level(got.x[i]) && is_level(got.y[i]) && is_level(got.z[i]);
            continue;
        }
        struct vec4 exact =
            texture_bilinear(texture, (struct vec2){(double)uv.x[i], (double)uv.y[i]}, level);
        right = right && fabs((double)got.x[i] - exact.x) <= tolerance &&
                fabs((double)got.y[i] - exact.y) <= tolerance &&
                fabs((double)got.z[i] - exact.z) <= tolerance;
    }
    return right;
}

static uint32_t texture_state = 95;

static void check_texture(size_t width, size_t height, struct random *random) {
    struct texture texture = {0};
    bool right = random_texture(&texture, width, height, IMAGE_BGR, &texture_state);
    for (int round = 0; right && round < 200; round++) {
        struct lanes2 uv = {{0}, {0}};
        for (int i = 0; i < LANES; i++) {
            uv.x[i] = any_coordinate(random, width);
            uv.y[i] = any_coordinate(random, height);
        }
        size_t level = random_bits(random) % (texture.level_count + 1); /* one too many */
        texture_set_clamp(&texture, round % 2 == 0);
        right = sample_is_right(&texture, level, uv);
    }
    CHECK(right);
    texture_free(&texture);
}

static void test_textures(void) {
    static const size_t sizes[][2] = {{1, 1}, {2, 1}, {1, 2}, {2, 2},   {3, 5},
                                      {8, 8}, {1, 9}, {9, 1}, {64, 32}, {300, 7}};
    struct random random = {95};
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        check_texture(sizes[i][0], sizes[i][1], &random);
    }
}

/* A place is found again where the texture has another size, or clamps and the last one did not. */
static void test_places_of_two_sizes(void) {
    static const size_t sizes[][2] = {{4, 8}, {8, 8}, {8, 4}, {8, 8}, {8, 8}, {8, 8}};
    struct lanes2 uv = {lanes_from(0) * 0.05f, 1 - lanes_from(0) * 0.03f};
    struct texel_place place = {0};
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        struct texture texture = {0};
        if (!random_texture(&texture, sizes[i][0], sizes[i][1], IMAGE_BGR, &texture_state)) {
            return;
        }
        texture_set_clamp(&texture, i == 5);
        struct texels texels = texture_fetch(&texture, uv, 0, &place);
        struct lanes3 got = texels_mix(&texels), alone = texture_lanes(&texture, uv, 0);
        CHECK(memcmp(&got, &alone, sizeof got) == 0);
        texture_free(&texture);
    }
}

UNIT_MAIN(TEST(test_one_number), TEST(test_two_numbers), TEST(test_sequences),
          TEST(test_far_texels), TEST(test_colors), TEST(test_textures),
          TEST(test_places_of_two_sizes))
