#include "compare.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PANEL_GAP = 8 }; /* grey pixels between two panels */

enum mark { MARK_EQUAL = 0, MARK_NEAR = 1, MARK_MISSING = 2, MARK_EXTRA = 4 };

struct rgb {
    uint8_t r, g, b;
};

static inline struct rgb pixel_at(const struct image *image, size_t x, size_t y) {
    const uint8_t *p = image->pixels + (y * image->width + x) * (size_t)image->format;
    return image->format == IMAGE_GREY ? (struct rgb){p[0], p[0], p[0]}
                                       : (struct rgb){p[2], p[1], p[0]};
}

static inline bool is_background(struct rgb c) {
    return c.r == 0 && c.g == 0 && c.b == 0;
}

static inline bool equal(struct rgb a, struct rgb b) {
    return a.r == b.r && a.g == b.g && a.b == b.b;
}

static inline bool agree(struct rgb a, struct rgb b) {
    return abs(a.r - b.r) <= COMPARE_LEVELS && abs(a.g - b.g) <= COMPARE_LEVELS &&
           abs(a.b - b.b) <= COMPARE_LEVELS;
}

/* Does the colour agree with a pixel of the image in the 3x3 around (x,y)? */
static bool has_match(const struct image *image, size_t x, size_t y, struct rgb color) {
    size_t right = x + 1 < image->width ? x + 1 : x, top = y + 1 < image->height ? y + 1 : y;
    for (size_t j = y > 0 ? y - 1 : 0; j <= top; j++) {
        for (size_t i = x > 0 ? x - 1 : 0; i <= right; i++) {
            if (agree(pixel_at(image, i, j), color)) {
                return true;
            }
        }
    }
    return false;
}

/* A set of marks for the pixel; a pixel that is wrong has MARK_MISSING or MARK_EXTRA. */
static inline unsigned compare_pixel(const struct image *reference, const struct image *yours,
                                     size_t x, size_t y) {
    struct rgb wanted = pixel_at(reference, x, y), got = pixel_at(yours, x, y);
    if (equal(wanted, got)) {
        return MARK_EQUAL;
    }
    unsigned marks = MARK_NEAR;
    if (!agree(wanted, got)) { /* otherwise the pixel itself is the match, for both sides */
        marks |= has_match(yours, x, y, wanted) ? 0u : (unsigned)MARK_MISSING;
        marks |= has_match(reference, x, y, got) ? 0u : (unsigned)MARK_EXTRA;
    }
    return marks;
}

struct comparison compare_images(const struct image *reference, const struct image *yours) {
    struct comparison result = {.drawn = 0};
    bool blank = true; /* yours so far */
    for (size_t y = 0; y < reference->height; y++) {
        for (size_t x = 0; x < reference->width; x++) {
            bool background = is_background(pixel_at(yours, x, y));
            blank &= background;
            result.drawn += !(background && is_background(pixel_at(reference, x, y)));
            unsigned marks = compare_pixel(reference, yours, x, y);
            result.differing += marks != MARK_EQUAL;
            result.wrong += (marks & (MARK_MISSING | MARK_EXTRA)) != 0;
        }
    }
    if (blank) {
        result.wrong = result.drawn;
    }
    return result;
}

bool comparison_within(const struct comparison *comparison, unsigned limit) {
    return comparison->wrong * 100000 <= limit * comparison->drawn;
}

struct share_text comparison_share(const struct comparison *comparison, unsigned limit) {
    struct share_text share = {"0 %"};
    if (comparison->wrong == 0) {
        return share;
    }
    double percent = 100 * (double)comparison->wrong / (double)comparison->drawn;
    double above = comparison_within(comparison, limit) ? 0 : limit / 1000.0;
    for (int decimals = 1; decimals < 16; decimals++) {
        snprintf(share.text, sizeof share.text, "%.*f", decimals, percent);
        if (strtod(share.text, NULL) > above) {
            break;
        }
    }
    strcat(share.text, " %");
    return share;
}

bool image_is_blank(const struct image *image) {
    for (size_t y = 0; y < image->height; y++) {
        for (size_t x = 0; x < image->width; x++) {
            if (!is_background(pixel_at(image, x, y))) {
                return false;
            }
        }
    }
    return true;
}

static void put(struct image *picture, size_t x, size_t y, struct rgb color) {
    uint8_t *p = picture->pixels + (y * picture->width + x) * 3;
    p[0] = color.b;
    p[1] = color.g;
    p[2] = color.r;
}

static struct rgb mark_color(unsigned marks, struct rgb reference) {
    if (marks & (MARK_MISSING | MARK_EXTRA)) {
        return (struct rgb){.r = marks & MARK_EXTRA ? 255 : 0, .b = marks & MARK_MISSING ? 255 : 0};
    }
    if (marks & MARK_NEAR) {
        return (struct rgb){.g = 96};
    }
    return (struct rgb){reference.r / 4, reference.g / 4, reference.b / 4};
}

/* `cut` becomes the part of `image` that a picture of that size shows, with background around. */
static bool cut_to_size(struct image *cut, const struct image *image, size_t width, size_t height,
                        struct error *error) {
    if (!image_create(cut, width, height, IMAGE_BGR, error)) {
        return false;
    }
    for (size_t y = 0; y < height && y < image->height; y++) {
        for (size_t x = 0; x < width && x < image->width; x++) {
            put(cut, x, y, pixel_at(image, x, y));
        }
    }
    return true;
}

bool compare_picture(struct image *picture, const struct image *reference,
                     const struct image *yours, struct error *error) {
    size_t width = reference->width, height = reference->height;
    struct image cut;
    *picture = (struct image){.pixels = NULL};
    if (!cut_to_size(&cut, yours, width, height, error) ||
        !image_create(picture, 3 * width + 2 * PANEL_GAP, height, IMAGE_BGR, error)) {
        image_free(&cut);
        return false;
    }
    image_clear(picture, color_grey(128));
    for (size_t y = 0; y < height; y++) {
        for (size_t x = 0; x < width; x++) {
            struct rgb wanted = pixel_at(reference, x, y);
            unsigned marks = compare_pixel(reference, &cut, x, y);
            put(picture, x, y, wanted);
            put(picture, x + width + PANEL_GAP, y, pixel_at(&cut, x, y));
            put(picture, x + 2 * (width + PANEL_GAP), y, mark_color(marks, wanted));
        }
    }
    image_free(&cut);
    return true;
}
