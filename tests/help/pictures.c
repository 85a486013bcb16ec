/* The pictures of a scene: see pictures.h. */
#include "pictures.h"

#include "../check/compare.h"
#include "image_file.h"

const char *const picture_names[PICTURE_COUNT] = {"yours", "reference", "difference"};

static bool read_if_there(struct image *image, const char *path, struct error *error) {
    return !file_exists(path) || image_read(image, path, error);
}

bool pictures_read(struct pictures *pictures, const char *yours, const char *reference,
                   struct error *error) {
    struct image *image = pictures->image;
    *pictures = (struct pictures){.image = {{.pixels = NULL}}};
    bool done = read_if_there(&image[PICTURE_YOURS], yours, error) &&
                read_if_there(&image[PICTURE_REFERENCE], reference, error);
    if (done && image[PICTURE_YOURS].width > 0 && image[PICTURE_REFERENCE].width > 0) {
        done = compare_difference(&image[PICTURE_DIFFERENCE], &image[PICTURE_REFERENCE],
                                  &image[PICTURE_YOURS], error);
    }
    if (!done) {
        pictures_free(pictures);
    }
    return done;
}

void pictures_free(struct pictures *pictures) {
    for (int i = 0; i < PICTURE_COUNT; i++) {
        image_free(&pictures->image[i]);
    }
}

bool picture_enlarge(struct image *enlarged, const struct image *image, size_t times,
                     struct error *error) {
    if (!image_create(enlarged, image->width * times, image->height * times, image->format,
                      error)) {
        return false;
    }
    for (size_t y = 0; y < enlarged->height; y++) {
        for (size_t x = 0; x < enlarged->width; x++) {
            image_set(enlarged, (int)x, (int)y,
                      image_get(image, (int)(x / times), (int)(y / times)));
        }
    }
    return true;
}

size_t picture_times(size_t size, size_t room) {
    return size > 0 && size < room ? room / size : 1;
}
