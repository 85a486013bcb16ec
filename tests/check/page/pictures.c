/* The pictures of a scene: see pictures.h. */
#include "pictures.h"

#include "base/file.h"
#include "check/compare.h"
#include "check/verdict.h"
#include "files/image_file.h"

#include <stdio.h>

const char *const picture_names[PICTURE_COUNT] = {"yours", "reference", "difference"};

static bool read_if_there(struct image *image, const char *path, struct error *error) {
    return !file_exists(path) || image_read(image, path, error);
}

const struct checked_item *pictures_rule(struct scene_table *table, const char *step,
                                         const char *scene) {
    struct error ignored;
    bool found = scene_table_read(table, "tests/check/scenes.txt", &ignored);
    return found ? scene_table_find(table, step, scene) : NULL;
}

/* Which pixels count as wrong, and which is first? Pictures of different sizes have no shares. */
static enum compare_pixels find_wrong(struct pictures *pictures, const struct checked_item *rule) {
    const struct image *reference = &pictures->image[PICTURE_REFERENCE];
    const struct image *yours = &pictures->image[PICTURE_YOURS];
    static const struct checked_item no_rule = {.near_limit = 100 * 1000};
    struct comparison shares = {.drawn = 0};
    pictures->same_size = reference->width == yours->width && reference->height == yours->height;
    if (pictures->same_size) {
        shares = compare_images(reference, yours);
    }
    pictures->differing = shares.differing.count;
    const struct verdict verdict = verdict_find(&shares, rule != NULL ? rule : &no_rule);
    pictures->fails = !verdict.passes;
    pictures->wrong_x = (int)verdict.tally->x;
    pictures->wrong_y = (int)verdict.tally->y;
    return rule != NULL ? verdict.pixels : COMPARE_UNMATCHED;
}

bool pictures_read(struct pictures *pictures, const char *yours, const char *reference,
                   const struct checked_item *rule, struct error *error) {
    struct image *image = pictures->image;
    *pictures = (struct pictures){.image = {{.pixels = NULL}}};
    bool done = read_if_there(&image[PICTURE_YOURS], yours, error) &&
                read_if_there(&image[PICTURE_REFERENCE], reference, error);
    if (done && image[PICTURE_YOURS].width > 0 && image[PICTURE_REFERENCE].width > 0) {
        enum compare_pixels wrong = find_wrong(pictures, rule);
        done = compare_difference(&image[PICTURE_DIFFERENCE], &image[PICTURE_REFERENCE],
                                  &image[PICTURE_YOURS], wrong, error);
    }
    if (!done) {
        pictures_free(pictures);
    }
    return done;
}

struct picture_words pictures_describe(const struct pictures *pictures) {
    const struct image *yours = &pictures->image[PICTURE_YOURS];
    const struct image *reference = &pictures->image[PICTURE_REFERENCE];
    struct picture_words words = {"exact"};
    const size_t size = sizeof words.text;
    if (yours->width == 0 || reference->width == 0) {
        snprintf(words.text, size, "there is no %s",
                 yours->width == 0 ? "picture of yours" : "reference");
    } else if (!pictures->same_size) {
        snprintf(words.text, size, "%zux%zu pixels, not %zux%zu", yours->width, yours->height,
                 reference->width, reference->height);
    } else if (pictures->differing > 0) {
        int length =
            snprintf(words.text, size, "%llu pixel%s, ", (unsigned long long)pictures->differing,
                     pictures->differing == 1 ? " differs" : "s differ");
        snprintf(words.text + length, size - (size_t)length,
                 pictures->fails ? "the first wrong one at (%d,%d)" : "and it passes",
                 pictures->wrong_x, pictures->wrong_y);
    }
    return words;
}

void pictures_free(struct pictures *pictures) {
    for (int i = 0; i < PICTURE_COUNT; i++) {
        image_free(&pictures->image[i]);
    }
}

bool picture_part(struct image *part, const struct image *image, size_t left, size_t bottom,
                  size_t step, size_t width, size_t height, struct error *error) {
    size_t most_width = (image->width - left) / step, most_height = (image->height - bottom) / step;
    if (!image_create(part, width < most_width ? width : most_width,
                      height < most_height ? height : most_height, image->format, error)) {
        return false;
    }
    for (size_t y = 0; y < part->height; y++) {
        for (size_t x = 0; x < part->width; x++) {
            image_set(part, (int)x, (int)y,
                      image_get(image, (int)(left + x * step), (int)(bottom + y * step)));
        }
    }
    return true;
}

/* Of the pixels from (x,y) up to, without, (right,top), and of (x,y), the brightest. */
static struct color choose_pixel(const struct image *image, size_t x, size_t y, size_t right,
                                 size_t top) {
    const struct color black = color_grey(0);
    struct color chosen = black;
    int most = -1;
    for (size_t j = y; j < top || j == y; j++) {
        for (size_t i = x; i < right || i == x; i++) {
            struct color color = image_get(image, (int)i, (int)j);
            if (color_distance(color, black) > most) {
                most = color_distance(color, black);
                chosen = color;
            }
        }
    }
    return chosen;
}

bool picture_resize(struct image *resized, const struct image *image, size_t width, size_t height,
                    struct error *error) {
    if (!image_create(resized, width, height, IMAGE_BGR, error)) {
        return false;
    }
    for (size_t y = 0; y < height; y++) {
        for (size_t x = 0; x < width; x++) {
            struct color color =
                choose_pixel(image, x * image->width / width, y * image->height / height,
                             (x + 1) * image->width / width, (y + 1) * image->height / height);
            image_set(resized, (int)x, (int)y, color);
        }
    }
    return true;
}
