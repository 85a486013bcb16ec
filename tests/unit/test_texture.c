/* Levels of textures against the definition of texture.h, computed in long double another way: the
 * mean of a texel's area by overlaps of intervals. `make stress` tries the samples. */
#include "texture.h"

#include "unit/images.h"

#include <math.h>

static uint32_t state = 88;

static unsigned channel_of(const struct texture_level *level, size_t x, size_t y, int channel) {
    return texture_texel(level, x, y) >> 8 * channel & 0xFF;
}

/* Rows lie an odd number of cache lines apart, as near as they can. */
static void test_pitch(void) {
    for (size_t width = 1; width <= IMAGE_SIZE_LIMIT; width++) {
        size_t pitch = texture_pitch(width);
        CHECK(pitch > width && pitch % 32 == 16 && (width < 16 || pitch - width <= 32));
    }
}

/* How much of texel j lies in the i-th of `parts` equal parts of a row of `size` texels. */
static long double overlap(size_t i, size_t parts, size_t j, size_t size) {
    long double step = (long double)size / (long double)parts;
    long double begin = fmaxl((long double)i * step, (long double)j);
    long double end = fminl((long double)(i + 1) * step, (long double)j + 1);
    return end > begin ? end - begin : 0;
}

static long double mean_of_area(const struct texture_level *from, const struct texture_level *to,
                                size_t x, size_t y, int channel) {
    long double sum = 0, area = 0;
    for (size_t v = 0; v < from->height; v++) {
        for (size_t u = 0; u < from->width; u++) {
            long double weight =
                overlap(x, to->width, u, from->width) * overlap(y, to->height, v, from->height);
            sum += weight * channel_of(from, u, v, channel);
            area += weight;
        }
    }
    return sum / area;
}

/* Each has half the size of the one before, down to one texel, and its means. */
static void check_levels(const struct texture *texture) {
    const struct texture_level *last = &texture->level[texture->level_count - 1];
    CHECK(last->width == 1 && last->height == 1);
    for (size_t k = 1; k < texture->level_count; k++) {
        const struct texture_level *from = &texture->level[k - 1], *to = &texture->level[k];
        CHECK(to->width == (from->width > 1 ? from->width / 2 : 1));
        CHECK(to->height == (from->height > 1 ? from->height / 2 : 1));
        for (size_t y = 0; y < to->height; y++) {
            for (size_t x = 0; x < to->width; x++) {
                for (int channel = 0; channel < 4; channel++) {
                    long double mean = mean_of_area(from, to, x, y, channel);
                    long double error = (long double)channel_of(to, x, y, channel) - mean;
                    CHECK(error > -0.5L + 1e-12L - 2e-12L && error <= 0.5L + 1e-12L);
                }
            }
        }
    }
}

static void test_levels(void) {
    for (size_t i = 0; i < 60; i++) {
        struct texture t;
        size_t width = i < 16 ? i % 4 + 1 : next_random(&state) % 24 + 1;
        size_t height = i < 16 ? i / 4 + 1 : next_random(&state) % 24 + 1;
        if (random_texture(&t, width, height, i % 2 == 0 ? IMAGE_BGRA : IMAGE_GREY, &state)) {
            check_levels(&t);
            texture_free(&t);
            CHECK(t.level_count == 0 && t.texels == NULL);
        }
    }
}

/* As many levels as are asked for, of those that there are. */
static void test_level_limit(void) {
    const struct image image = random_image(5, 4, IMAGE_BGR, 256, &state);
    for (size_t limit = 0; limit < 5; limit++) {
        struct texture t;
        struct error error;
        if (CHECK(texture_create_levels(&t, &image, limit, &error))) {
            CHECK(t.level_count == (limit == 0 || limit > 3 ? 3 : limit));
            CHECK(t.level[t.level_count - 1].width == (size_t)5 >> (t.level_count - 1));
            texture_free(&t);
        }
    }
    free(image.pixels);
}

/* A half rounds up; white stays white at odd sizes whose sums pass 32 bits. */
static void test_level_rounding(void) {
    struct texture t;
    struct error error;
    for (int sum = 0; sum <= 4 * 255; sum++) { /* of four texels: every remainder */
        const uint8_t level = (uint8_t)(sum / 4);
        uint8_t four[4] = {level, level, level, level};
        for (int k = 0; k < sum % 4; k++) {
            four[k]++;
        }
        const struct image square = {2, 2, IMAGE_GREY, four};
        CHECK(texture_create(&t, &square, &error));
        CHECK((t.level[1].texels[0] & 0xFF) == (unsigned)(sum + 2) / 4);
        texture_free(&t);
    }
    struct image image = new_image(4105, 4105, IMAGE_GREY);
    image_clear(&image, color_rgb(255, 255, 255));
    CHECK(texture_create(&t, &image, &error));
    bool all_white = true;
    for (size_t k = 0; k < t.level_count; k++) {
        for (size_t i = 0; i < t.level[k].width * t.level[k].height; i++) {
            size_t x = i % t.level[k].width, y = i / t.level[k].width;
            all_white = all_white && texture_texel(&t.level[k], x, y) == UINT32_MAX;
        }
    }
    CHECK(all_white);
    texture_free(&t);
    image_free(&image);
}

/* No image makes the first of these; the sizes come from whoever fills the struct. Of the others no
 * pixel must be read. */
static void test_sizes(void) {
    static const struct {
        size_t width, height;
        const char *why;
    } rows[] = {
        {0, 0, ""},
        {1, 0, ""},
        {0, 1, ""},
        {IMAGE_SIZE_LIMIT + 1, 1, ""},
        {1, IMAGE_SIZE_LIMIT + 1, ""},
        {65535, 65535, ", more than 1073741824 texels"},
        {32767, 32768, ", more than 1073741824 texels"}, /* with what lies between the rows */
        {16384, 65535, ", more than 1073741824 texels"},
        {65535, 16384, ", more than 1073741824 texels"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        uint8_t pixel = 0;
        struct image image = {rows[i].width, rows[i].height, IMAGE_GREY, &pixel};
        struct texture texture;
        struct error error;
        char expected[80];
        CHECK(!texture_create(&texture, &image, &error) && texture.level_count == 0);
        snprintf(expected, sizeof expected, "a texture of %zux%zu pixels%s", rows[i].width,
                 rows[i].height, rows[i].why);
        CHECK_TEXT(error.message, expected);
    }
}

UNIT_MAIN(TEST(test_pitch), TEST(test_levels), TEST(test_level_limit), TEST(test_level_rounding),
          TEST(test_sizes))
