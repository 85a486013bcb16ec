/* For tests of models: read from memory, small pictures next to them. The test defines
 * _XOPEN_SOURCE as 700 (place.h). */
#ifndef TESTS_UNIT_MODELS_H
#define TESTS_UNIT_MODELS_H

#include "files/model_file.h"
#include "files/png.h"
#include "unit/images.h"
#include "unit/place.h"

#define SQUARE "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"

/* Read the text, from memory of just its size. */
static inline bool decode(struct model *model, const char *text, struct error *error) {
    size_t size = strlen(text);
    char *copy = exact_copy(text, size);
    bool done = model_decode(model, copy, size, error);
    free(copy);
    return done;
}

/* Read what is expected to be read; false, with the message, where it is not. */
static inline bool decode_right(struct model *model, const char *text) {
    struct error error = {0};
    bool done = decode(model, text, &error);
    if (!CHECK_ROW(done, text)) {
        fprintf(stderr, "    %s\n", error.message);
    }
    return done;
}

static inline bool same3(const float *a, float x, float y, float z) {
    return a != NULL && a[0] == x && a[1] == y && a[2] == z;
}

/* 2x2 pixels of one colour, as PNG whatever the name says. */
static inline void put_picture(struct place *place, const char *name, struct color color) {
    struct image image = new_image(2, 2, IMAGE_BGR);
    struct error error;
    image_clear(&image, color);
    CHECK(png_write(&image, name_file(place, name), &error));
    image_free(&image);
}

#endif
