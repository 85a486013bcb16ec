/* PNG by libpng: see libpng.h. Its header is named by its version, since common has a png.h too. */
#include "libpng.h"

#if __has_include(<libpng16/png.h>)
#include <libpng16/png.h>

#include <setjmp.h>

const char *const libpng_version = PNG_LIBPNG_VER_STRING;

static void append(png_structp png, png_bytep data, size_t size) {
    if (!bytes_append(png_get_io_ptr(png), data, size)) {
        png_error(png, "out of memory");
    }
}

static void flush(png_structp png) {
    (void)png;
}

static void write_rows(png_structp png, const struct image *image) {
    size_t row_size = image->width * (size_t)image->format;
    for (size_t y = image->height; y-- > 0;) {
        png_write_row(png, image->pixels + y * row_size);
    }
}

static bool encode(const struct image *image, int level, struct bytes *out, struct error *error) {
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png != NULL ? png_create_info_struct(png) : NULL;
    bool done = false;
    if (info != NULL && setjmp(png_jmpbuf(png)) == 0) {
        int type = image->format == IMAGE_GREY ? PNG_COLOR_TYPE_GRAY : PNG_COLOR_TYPE_RGB;
        png_set_write_fn(png, out, append, flush);
        png_set_compression_level(png, level);
        png_set_IHDR(png, info, (png_uint_32)image->width, (png_uint_32)image->height, 8, type,
                     PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        png_write_info(png, info);
        png_set_bgr(png);
        write_rows(png, image);
        png_write_end(png, NULL);
        done = true;
    }
    png_destroy_write_struct(&png, &info);
    return done || error_set(error, "libpng cannot write");
}

bool libpng_encode(const struct image *image, struct bytes *out, struct error *error) {
    return encode(image, 6, out, error);
}

bool libpng_encode_quickly(const struct image *image, struct bytes *out, struct error *error) {
    return encode(image, 1, out, error);
}

static bool decode(struct image *image, png_image *file, const void *data, size_t size,
                   struct error *error) {
    if (!png_image_begin_read_from_memory(file, data, size)) {
        return error_set(error, "libpng cannot read");
    }
    bool grey = (file->format & PNG_FORMAT_FLAG_COLOR) == 0;
    file->format = grey ? PNG_FORMAT_GRAY : PNG_FORMAT_BGR;
    if (!image_create(image, file->width, file->height, grey ? IMAGE_GREY : IMAGE_BGR, error)) {
        return false;
    }
    int stride = -(int)(image->width * (size_t)image->format); /* negative: lowest row first */
    return png_image_finish_read(file, NULL, image->pixels, stride, NULL) ||
           error_set(error, "libpng cannot read");
}

bool libpng_decode(struct image *image, const void *data, size_t size, struct error *error) {
    png_image file = {.version = PNG_IMAGE_VERSION};
    *image = (struct image){0};
    bool done = decode(image, &file, data, size, error);
    png_image_free(&file);
    if (!done) {
        image_free(image);
    }
    return done;
}

#else

const char *const libpng_version = NULL;

bool libpng_encode(const struct image *image, struct bytes *out, struct error *error) {
    (void)image, (void)out;
    return error_set(error, "libpng is not installed");
}

bool libpng_encode_quickly(const struct image *image, struct bytes *out, struct error *error) {
    return libpng_encode(image, out, error);
}

bool libpng_decode(struct image *image, const void *data, size_t size, struct error *error) {
    (void)image, (void)data, (void)size;
    return error_set(error, "libpng is not installed");
}

#endif
