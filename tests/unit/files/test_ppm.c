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
        const char *text;
    } rows[] = {
        {"P6", IMAGE_BGR, "P6\n2 2\n255\nihglkjcbafed"},
        {"P6 drops alpha", IMAGE_BGRA, "P6\n2 2\n255\nkjionmcbagfe"},
        {"P5", IMAGE_GREY, "P5\n2 2\n255\ncdab"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct image image = make_letters(rows[i].format);
        struct error error;
        struct bytes file = {0};
        CHECK(bytes_append(&file, "x", 1)); /* what is there stays */
        CHECK_ROW(ppm_encode(&image, &file, &error), rows[i].name);
        CHECK(bytes_append(&file, "", 1));
        CHECK(file.data[0] == 'x');
        CHECK_TEXT((const char *)file.data + 1, rows[i].text);
        bytes_free(&file);
        image_free(&image);
    }
}

UNIT_MAIN(TEST(test_kinds))
