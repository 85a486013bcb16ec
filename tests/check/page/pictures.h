/* The pictures of a scene that a student looks at: yours, the reference, and their difference. */
#ifndef TESTS_CHECK_PAGE_PICTURES_H
#define TESTS_CHECK_PAGE_PICTURES_H

#include "base/error.h"
#include "check/scenes.h"
#include "tgaimage.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { PICTURE_YOURS, PICTURE_REFERENCE, PICTURE_DIFFERENCE, PICTURE_COUNT };

/* "yours", "reference", "difference". */
extern const char *const picture_names[PICTURE_COUNT];

/* All zero is valid and empty: no picture at all. */
struct pictures {
    struct image image[PICTURE_COUNT]; /* an empty image: this picture is not there */
    bool same_size;                    /* both are there: only then does the rest hold */
    uint64_t differing;                /* pixels that are not equal */
    bool fails;                        /* the check would not let yours pass */
    int wrong_x, wrong_y;              /* then the first pixel that is wrong */
};

/* How the check compares that scene; NULL where the table of scenes is not here or lacks it. The
 * caller frees the table. */
const struct checked_item *pictures_rule(struct scene_table *table, const char *step,
                                         const char *scene);

/* Read both files and compare them by the scene's rule; NULL: what has no match is wrong. A file
 * that does not exist is left out, and so is then the difference; one that cannot be read is an
 * error that names it. The caller frees the pictures. */
bool pictures_read(struct pictures *pictures, const char *yours, const char *reference,
                   const struct checked_item *rule, struct error *error);

/* "exact"; "214 pixels differ, the first wrong one at (3,5)", or "and it passes"; "10x10 pixels,
 * not 200x4"; "there is no picture of yours", or no reference. */
struct picture_words {
    char text[100];
};
struct picture_words pictures_describe(const struct pictures *pictures);

/* Free the images and leave them empty. */
void pictures_free(struct pictures *pictures);

/* `part` becomes every `step`th pixel from (left,bottom) on, which lies in the image: at most so
 * many. */
bool picture_part(struct image *part, const struct image *image, size_t left, size_t bottom,
                  size_t step, size_t width, size_t height, struct error *error);

/* `resized` becomes the image in that size. Where that is smaller, of the pixels that become one it
 * keeps the one that differs most from the background, so that no line and no mark is lost. */
bool picture_resize(struct image *resized, const struct image *image, size_t width, size_t height,
                    struct error *error);

#endif
