/* Tests of common/files/ppm.c: every kind of file, byte by byte. */
#include "files/ppm.h"

#include "unit/images.h"

/* Two rows of two pixels, whose bytes are the letters from a on. */
static struct image make_letters(enum image_format format) {
    struct image image = new_image(2, 2, format);
    for (size_t i = 0; i < 4 * (size_t)format; i++) {
        image.pixels[i] = (uint8_t)(97 + i);
    }
    return image;
}

static void test_kinds(void) {
    static const struct {
        const char *name;
        enum image_format format;
        bool plain;
        const char *text;
    } rows[] = {
        {"P6", IMAGE_BGR, false, "P6\n2 2\n255\nihglkjcbafed"},
        {"P6 drops alpha", IMAGE_BGRA, false, "P6\n2 2\n255\nkjionmcbagfe"},
        {"P5", IMAGE_GREY, false, "P5\n2 2\n255\ncdab"},
        {"P3", IMAGE_BGR, true, "P3\n2 2\n255\n105 104 103\n108 107 106\n99 98 97\n102 101 100\n"},
        {"P3 drops alpha", IMAGE_BGRA, true,
         "P3\n2 2\n255\n107 106 105\n111 110 109\n99 98 97\n103 102 101\n"},
        {"P2", IMAGE_GREY, true, "P2\n2 2\n255\n99\n100\n97\n98\n"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct image image = make_letters(rows[i].format);
        struct error error;
        struct bytes file = {0};
        CHECK(bytes_append(&file, "x", 1)); /* what is there stays */
        CHECK_ROW(ppm_encode(&image, rows[i].plain, &file, &error), rows[i].name);
        CHECK(bytes_append(&file, "", 1));
        CHECK(file.data[0] == 'x');
        CHECK_TEXT((const char *)file.data + 1, rows[i].text);
        bytes_free(&file);
        image_free(&image);
    }
}

/* The largest number takes the most room, and a wide row must find it. */
static void test_white_row(void) {
    enum { WIDTH = 1000 };
    struct image image = new_image(WIDTH, 1, IMAGE_BGR);
    struct error error;
    struct bytes file = {0};
    image_clear(&image, color_grey(255));
    CHECK(ppm_encode(&image, true, &file, &error));
    CHECK(file.size == strlen("P3\n1000 1\n255\n") + WIDTH * strlen("255 255 255\n"));
    CHECK(memcmp(file.data + file.size - 12, "255 255 255\n", 12) == 0);
    bytes_free(&file);
    image_free(&image);
}

static void test_empty_image(void) {
    struct image empty = {0};
    struct bytes out = {0};
    struct error error = {0};
    CHECK(!ppm_encode(&empty, false, &out, &error));
    CHECK_TEXT(error.message, "an empty image cannot be written");
    CHECK(!ppm_encode(&empty, true, &out, &error) && out.size == 0);
}

UNIT_MAIN(TEST(test_kinds), TEST(test_white_row), TEST(test_empty_image))
