/* Tests of common/files/image_file.c: which decoder reads a file, and the table of formats;
 * and of common/files/ppm.c. */
#define _XOPEN_SOURCE 700 /* POSIX.1-2008 with mkdtemp() */

#include "files/image_file.h"

#include "files/png.h"
#include "files/ppm.h"
#include "unit/images.h"
#include "unit/place.h"

static uint32_t state = 5;

/* ---- Reading ---- */

/* The name tells nothing: each kind of file is read under the name of the other. */
static void test_signature_decides(void) {
    static const struct {
        const char *name;
        bool (*write)(const struct image *image, const char *path, struct error *error);
    } rows[] = {{"a.png", tga_write}, {"a.tga", png_write}, {"a", png_write}};
    struct place place = place_create();
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        name_file(&place, rows[i].name);
        struct image image = random_image(3, 2, IMAGE_BGRA, 256, &state), again;
        struct error error;
        CHECK_ROW(rows[i].write(&image, place.path, &error), rows[i].name);
        if (CHECK_ROW(image_read(&again, place.path, &error), rows[i].name)) {
            CHECK_ROW(same_image(&image, &again), rows[i].name);
        }
        image_free(&again);
        image_free(&image);
    }
    place_remove(&place, "a.png,a.tga,a");
}

#define KINDS   "not a PNG, TGA or PPM file: "
#define CONVERT KINDS "`mogrify -format png %s` makes PNG files, which are drawn then"
#define DAMAGED                                                                                    \
    "a PNG file damaged by a transfer as text, " KINDS "fetch it again, as bytes and not as text"
#define NEITHER "neither a PNG or PPM nor a TGA of a type that is supported"

/* What is neither, and what is one of the two with a fault. */
static void test_wrong_files(void) {
    static const struct {
        const char *name, *bytes;
        size_t size;
        const char *message;
    } rows[] = {
        {"nothing", "", 0, NEITHER},
        {"text", "The quick brown fox jumps over", 30, NEITHER},
        {"too short for a TGA", "\0\0\2\0\0\0\0\0\0\0\0\0\1\0\1\0\30", 17, NEITHER},
        {"JPEG", "\xff\xd8\xff\xe0\0\20JFIF\0\1\1\0\0\1\0\1\0\0", 20, "a JPEG file, " CONVERT},
        {"WebP", "RIFF\x1a\0\0\0WEBPVP8L", 16, "a WebP file, " CONVERT},
        {"RIFF, but no WebP", "RIFF\x1a\0\0\0WAVEfmt ", 16, NEITHER},
        {"GIF", "GIF89a\1\0\1\0", 10, "a GIF file, " CONVERT},
        {"BMP", "BM\x3a\0\0\0\0\0\0\0\x36\0\0\0", 14, "a BMP file, " CONVERT},
        {"TIFF", "II*\0\x8\0\0\0", 8, "a TIFF file, " CONVERT},
        {"Git LFS", "version https://git-lfs.github.com/spec/v1\n", 43,
         "a Git LFS pointer, " KINDS "`git lfs pull` fetches the file itself"},
        {"page", "<!DOCTYPE html>", 15, "an HTML page, " KINDS "download the file itself"},
        {"PNG after a change of line ends", "\x89PNG\n\x1a\n\0\0\0\rIHDR\0\0\0\1", 20, DAMAGED},
        {"the same to those of Windows", "\x89PNG\r\r\n\x1a\r\n\0\0\0\rIHDR", 17, DAMAGED},
        {"PNG through 7 bits", "\tPNG\r\n\x1a\n\0\0\0\rIHDR", 16, DAMAGED},
        {"PNG as UTF-8", "\xEF\xBF\xBDPNG\r\n\x1a\n\0\0\0\rIHDR", 18, DAMAGED},
        {"PBM", "P4\n8 1\n\1", 8, "a bitmap of Netpbm, " CONVERT},
        {"PBM as text", "P1\n1 1\n0", 8, "a bitmap of Netpbm, " CONVERT},
        {"PAM", "P7\nWIDTH 1\n", 11, "a PAM file, " CONVERT},
        {"PFM", "PF\n1 1\n-1\n", 10, "a PFM file, " CONVERT},
        {"TGA of type 0", "\0\0\0\0\0\0\0\0\0\0\0\0\1\0\1\0\10\0\7", 19, NEITHER},
        {"TGA of type 4", "\0\0\4\0\0\0\0\0\0\0\0\0\1\0\1\0\10\0\7", 19, NEITHER},
        {"colour map of type 2", "\0\2\3\0\0\0\0\0\0\0\0\0\1\0\1\0\10\0\7", 19, NEITHER},
        {"PNG cut off", "\x89PNG\r\n\x1a\n", 8, "a PNG cut off before its end"},
        {"TGA with a map, cut off", "\0\1\3\0\0\0\0\0\0\0\0\0\2\0\1\0\10\0", 18,
         "a TGA cut off: 2x1 pixels take at least 2 bytes, but 0 are left"},
    };
    struct place place = place_create();
    name_file(&place, "picture.tga");
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct image image = {.width = 7};
        struct error error = {0};
        char message[200], expected[300];
        snprintf(message, sizeof message, rows[i].message, "FILE");
        CHECK_ROW(!image_decode(&image, rows[i].bytes, rows[i].size, &error), rows[i].name);
        CHECK_ROW(image.pixels == NULL && image.width == 0, rows[i].name);
        CHECK_TEXT(error.message, message);
        CHECK(file_write(place.path, rows[i].bytes, rows[i].size, &error));
        image.width = 7;
        CHECK_ROW(!image_read(&image, place.path, &error), rows[i].name);
        CHECK_ROW(image.pixels == NULL && image.width == 0, rows[i].name);
        snprintf(expected, sizeof expected, "%s: ", place.path);
        snprintf(expected + strlen(expected), 200, rows[i].message, place.path);
        CHECK_TEXT(error.message, expected);
    }
    struct image image = {.width = 7};
    struct error error;
    CHECK(unlink(place.path) == 0 && !image_read(&image, place.path, &error) && image.width == 0);
    place_remove(&place, NULL);
}

/* ---- Formats ---- */

static void test_find(void) {
    for (size_t i = 0; i < image_file_format_count; i++) {
        CHECK(image_file_format_find(image_file_formats[i].name) == &image_file_formats[i]);
        CHECK(strstr(IMAGE_FILE_NAMES, image_file_formats[i].name) != NULL);
    }
    CHECK(image_file_format_count > 0);
    CHECK_TEXT(image_file_formats[0].name, "tga"); /* the default */
    CHECK(image_file_format_find("png") != NULL && image_file_format_find("ppm") != NULL);
    CHECK(image_file_format_find("pn") == NULL && image_file_format_find("pngs") == NULL);
    CHECK(image_file_format_find("PNG") == NULL && image_file_format_find("") == NULL);
    struct image alpha = {.format = IMAGE_BGRA}; /* otherwise: test_program.c */
    CHECK_TEXT(image_file_extension(image_file_format_find("ppm"), &alpha), "ppm");
}

/* What cannot be written leaves no file and a message with the name. */
static void check_not_written(const struct image_file_format *format, const struct image *image,
                              const char *path, const char *reason) {
    struct error error = {0};
    char expected[200];
    snprintf(expected, sizeof expected, "%s: %s", path, reason);
    CHECK_ROW(!format->write(image, path, &error), format->name);
    CHECK_TEXT(error.message, expected);
    if (format->write_frames != NULL && image->pixels != NULL) {
        CHECK_ROW(!format->write_frames(image, 1, 10, path, &error), format->name);
        CHECK_TEXT(error.message, expected);
    }
    CHECK(!file_exists(path));
}

/* How a file of each format begins: a PNG by its signature, a TGA by its type. */
static void test_writers(void) {
    static const struct {
        const char *format, *bytes;
        size_t at, size;
        bool moves;
    } rows[] = {
        {"tga", "TRUEVISION-XFILE.", 44, 17, false},
        {"png", "\x89PNG\r\n\x1a\n", 0, 8, true},
        {"ppm", "P6\n3 2\n255\n", 0, 11, false},
    };
    CHECK(sizeof rows / sizeof rows[0] == image_file_format_count);
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        const struct image_file_format *format = image_file_format_find(rows[i].format);
        struct place place = place_create();
        name_file(&place, "picture");
        struct image image = random_image(3, 2, IMAGE_BGR, 256, &state), empty = {0};
        struct bytes file = {0};
        struct error error;
        char nowhere[80];
        snprintf(nowhere, sizeof nowhere, "%s/none/picture", place.directory);
        check_not_written(format, &empty, place.path, "an empty image cannot be written");
        check_not_written(format, &image, nowhere, "No such file or directory");
        CHECK_ROW(format->write(&image, place.path, &error), rows[i].format);
        CHECK_ROW(file_read(place.path, &file, &error) && file.size >= rows[i].at + rows[i].size &&
                      memcmp(file.data + rows[i].at, rows[i].bytes, rows[i].size) == 0,
                  rows[i].format);
        CHECK_ROW((format->write_frames != NULL) == rows[i].moves, rows[i].format);
        bytes_free(&file);
        image_free(&image);
        unlink(place.path);
        place_remove(&place, NULL);
    }
}

/* Every byte of a PPM or a PGM: the top row first, red first, without alpha. */
static void test_ppm(void) {
    static const struct {
        enum image_format format;
        const char *text;
    } rows[] = {
        {IMAGE_BGR, "P6\n2 2\n255\nihglkjcbafed"},
        {IMAGE_BGRA, "P6\n2 2\n255\nkjionmcbagfe"},
        {IMAGE_GREY, "P5\n2 2\n255\ncdab"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        uint8_t letters[] = "abcdefghijklmnop";
        const struct image image = {2, 2, rows[i].format, letters};
        struct error error;
        struct bytes file = {0};
        CHECK(ppm_encode(&image, &file, &error) && bytes_append(&file, "", 1));
        CHECK_TEXT((const char *)file.data, rows[i].text);
        bytes_free(&file);
    }
}

/* Numbers or bytes, of one byte or two: two pixels, in hexadecimal, or what the message says. */
static void test_ppm_in(void) {
    static const struct {
        const char *file;
        size_t size; /* 0: the string's length */
        const char *pixels, *message;
    } rows[] = {
        {"P6\n2 1\n255\nabcdef", 0, "616263 646566", NULL},
        {"P6 2 1 255 abcdefgh", 0, "616263 646566", NULL},
        {"P5\n# made by hand\n1 2 # size\n255\n\1\2", 0, "020202 010101", NULL},
        {"P5\n2 1\n65535\n\x80\0\xff\xff", 18, "808080 FFFFFF", NULL},
        {"P5\n2 1\n256\n\1\0\0\x80", 16, "FFFFFF 808080", NULL},
        {"P5\n2 1\n15\n\17\20", 0, "FFFFFF FFFFFF", NULL}, /* too large, so the greatest */
        {"P3\n2 1\n255\n1 2 3\n4 5 6", 0, "010203 040506", NULL},
        {"P3\n2 1\n7\n7 0 0 # red\n0 7 0\n", 0, "FF0000 00FF00", NULL},
        {"P2 2 1 1 0 1", 0, "000000 FFFFFF", NULL},
        {"P2\n2# w\n 1#\n7# most\n7# one\n0#", 0, "FFFFFF 000000", NULL},
        {"P6\n2 1# h\n255# most\nabcdef", 0, "616263 646566", NULL},
        {"P6\n2 1\n255\n\rbcdef", 0, "0D6263 646566", NULL}, /* a level, though it looks blank */
        {"P5 2 1 255 \n#", 0, "0A0A0A 232323", NULL},
        {"P5\n2 1\n255#12", 0, NULL, "a PPM without a width"},
        {"P2\r\n2\t1\r\n1\r\n0\r\n1\r\n", 0, "000000 FFFFFF", NULL},
        {"P6\n2 1\n255\nabcde", 0, NULL, "a PPM cut off: 2x1 pixels do not fit"},
        {"P6\n2 1\n255", 0, NULL, "a PPM without a width"},
        {"P6\n2 1\n0\nabcdef", 0, NULL, "a PPM without a width"},
        {"P6\n2 1\n65536\nabcdefabcdef", 0, NULL, "a PPM without a width"},
        {"P6\n-2 1\n255\nabcdef", 0, NULL, "a PPM without a width"},
        {"P6\n99999999999999999999 1\n255\nabc", 0, NULL, "a PPM without a width"},
        {"P6\n65535 65535\n255\nabc", 0, NULL, "a PPM cut off: 65535x65535"},
        {"P6\n0 1\n255\nabc", 0, NULL, "0x1 pixels"},
        {"P2\n2 1\n255\n1 ", 0, NULL, "a PPM cut off"},
        {"P2\n2 1\n255\n10 ", 0, NULL, "samples are no numbers"},
        {"P2\n2 1\n255\n1 x", 0, NULL, "samples are no numbers"},
        {"P2\n2 1\n255\n1 65536", 0, NULL, "samples are no numbers"},
        {"P3#", 0, NULL, "a PPM without a width"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        size_t size = rows[i].size > 0 ? rows[i].size : strlen(rows[i].file);
        struct image image;
        struct error error;
        char pixels[40] = "";
        bool done = decode_exact(image_decode, &image, (const uint8_t *)rows[i].file, size, &error);
        if (!CHECK_ROW(done == (rows[i].message == NULL), rows[i].file) || !done) {
            CHECK_ROW(done || strstr(error.message, rows[i].message) != NULL, error.message);
            image_free(&image);
            continue;
        }
        for (int k = 0; k < 2; k++) {
            struct color c = image_get(&image, image.width > 1 ? k : 0, image.width > 1 ? 0 : k);
            snprintf(pixels + strlen(pixels), 10, "%s%02X%02X%02X", k > 0 ? " " : "", c.r, c.g,
                     c.b);
        }
        CHECK_ROW(CHECK_TEXT(pixels, rows[i].pixels), rows[i].file);
        image_free(&image);
    }
}

UNIT_MAIN(TEST(test_signature_decides), TEST(test_wrong_files), TEST(test_find), TEST(test_writers),
          TEST(test_ppm), TEST(test_ppm_in))
