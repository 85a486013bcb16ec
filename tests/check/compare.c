#include "compare.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum mark { MARK_EQUAL = 0, MARK_NEAR = 1, MARK_APART = 2, MARK_COVERAGE = 4, MARK_WRONG = 8 };

static inline struct color pixel_at(const struct image *image, size_t x, size_t y) {
    const uint8_t *p = image->pixels + (y * image->width + x) * (size_t)image->format;
    return image->format == IMAGE_GREY ? color_grey(p[0]) : color_rgb(p[2], p[1], p[0]);
}

/* ---- The rule ---- */

/* Does a pixel of the 3x3 around (x,y) agree with the colour? */
static bool is_around(const struct image *image, size_t x, size_t y, struct color color) {
    for (size_t j = y > 0 ? y - 1 : 0; j <= y + 1 && j < image->height; j++) {
        for (size_t i = x > 0 ? x - 1 : 0; i <= x + 1 && i < image->width; i++) {
            if (colors_agree(pixel_at(image, i, j), color)) {
                return true;
            }
        }
    }
    return false;
}

/* The marks of a pixel; all but MARK_EQUAL have MARK_NEAR. */
static unsigned mark_pixel(const struct image *reference, const struct image *yours, size_t x,
                           size_t y) {
    struct color wanted = pixel_at(reference, x, y), got = pixel_at(yours, x, y);
    if (color_distance(wanted, got) == 0) {
        return MARK_EQUAL;
    }
    if (colors_agree(wanted, got)) {
        return MARK_NEAR;
    }
    bool is_matched = is_around(yours, x, y, wanted) && is_around(reference, x, y, got);
    return MARK_NEAR | MARK_APART | (is_matched ? 0 : MARK_WRONG) |
           (color_is_black(wanted) != color_is_black(got) ? MARK_COVERAGE : 0);
}

static void add(struct tally *tally, bool counts, size_t x, size_t y) {
    if (counts && tally->count++ == 0) {
        tally->x = x;
        tally->y = y;
    }
}

static void add_pixel(struct comparison *result, const struct image *reference,
                      const struct image *yours, size_t x, size_t y) {
    struct color wanted = pixel_at(reference, x, y), got = pixel_at(yours, x, y);
    unsigned marks = mark_pixel(reference, yours, x, y);
    result->drawn += !color_is_black(wanted) || !color_is_black(got);
    add(&result->differing, marks != MARK_EQUAL, x, y);
    add(&result->apart, (marks & MARK_APART) != 0, x, y);
    add(&result->near, marks == MARK_NEAR, x, y);
    add(&result->coverage, (marks & MARK_COVERAGE) != 0, x, y);
    add(&result->wrong, (marks & MARK_WRONG) != 0, x, y);
    if ((marks & MARK_APART) == 0) {
        result->lighter[0] += got.r - wanted.r;
        result->lighter[1] += got.g - wanted.g;
        result->lighter[2] += got.b - wanted.b;
    }
}

static bool is_same_row(const struct image *a, const struct image *b, size_t y) {
    size_t size = a->width * (size_t)a->format;
    return a->format == b->format && memcmp(a->pixels + y * size, b->pixels + y * size, size) == 0;
}

static size_t count_drawn(const struct image *image, size_t y) {
    size_t drawn = 0;
    for (size_t x = 0; x < image->width; x++) {
        drawn += !color_is_black(pixel_at(image, x, y));
    }
    return drawn;
}

bool is_same_picture(const struct image *a, const struct image *b) {
    if (a->width != b->width || a->height != b->height) {
        return false;
    }
    for (size_t y = 0; y < a->height; y++) {
        const size_t width = is_same_row(a, b, y) ? 0 : a->width; /* to look at */
        for (size_t x = 0; x < width; x++) {
            if (color_distance(pixel_at(a, x, y), pixel_at(b, x, y)) != 0) {
                return false;
            }
        }
    }
    return true;
}

struct comparison compare_images(const struct image *reference, const struct image *yours) {
    struct comparison result = {.drawn = 0};
    for (size_t y = 0; y < reference->height; y++) {
        bool is_same = is_same_row(reference, yours, y); /* as most are */
        result.drawn += is_same ? count_drawn(reference, y) : 0;
        for (size_t x = 0; x < reference->width && !is_same; x++) {
            add_pixel(&result, reference, yours, x, y);
        }
    }
    if (image_is_blank(yours)) {
        result.wrong = result.differing; /* also where the reference is nearly background */
    }
    return result;
}

double compare_lighter(const struct comparison *comparison) {
    const uint64_t agreeing = comparison->drawn - comparison->apart.count;
    int64_t most = 0;
    for (size_t i = 0; i < 3; i++) {
        int64_t levels = comparison->lighter[i];
        most = llabs(levels) > llabs(most) ? levels : most;
    }
    return most == 0 ? 0 : (double)most / (double)agreeing;
}

bool is_as_light(const struct comparison *comparison) {
    return fabs(compare_lighter(comparison)) <= COMPARE_LIGHTER / 1000.0;
}

bool share_within(uint64_t count, uint64_t drawn, unsigned limit) {
    return count * 100000 <= limit * drawn;
}

struct share_text share_show(uint64_t count, uint64_t drawn, unsigned limit) {
    struct share_text share = {"0 %"};
    if (count == 0) {
        return share;
    }
    double percent = 100 * (double)count / (double)drawn;
    double above = share_within(count, drawn, limit) ? 0 : limit / 1000.0;
    for (int decimals = 1; decimals < 16; decimals++) {
        snprintf(share.text, sizeof share.text, "%.*f", decimals, percent);
        if (strtod(share.text, NULL) > above) {
            break;
        }
    }
    strcat(share.text, " %");
    return share;
}

/* ---- The picture of a difference ---- */

bool image_is_blank(const struct image *image) {
    for (size_t y = 0; y < image->height; y++) {
        for (size_t x = 0; x < image->width; x++) {
            if (!color_is_black(pixel_at(image, x, y))) {
                return false;
            }
        }
    }
    return true;
}

/* What must be among its marks for a pixel to count as wrong. */
static unsigned marks_of(enum compare_pixels wrong) {
    static const unsigned marks[] = {
        [COMPARE_UNMATCHED] = MARK_WRONG,
        [COMPARE_COVERAGE] = MARK_COVERAGE,
        [COMPARE_APART] = MARK_APART,
        [COMPARE_DIFFERING] = MARK_NEAR,
    };
    return marks[wrong];
}

static struct color mark_color(unsigned marks, enum compare_pixels wrong, struct color reference,
                               struct color yours) {
    if (marks & marks_of(wrong)) {
        return color_is_black(yours) ? color_rgb(0, 0, 255)
                                     : color_rgb(255, 0, 0); /* blue: missing */
    }
    if (marks != MARK_EQUAL) {
        return color_rgb(0, 96, 0);
    }
    return color_rgb(reference.r / 4, reference.g / 4, reference.b / 4);
}

/* `cut` becomes the part of `image` that a picture of that size shows, with background around. */
static bool cut_to_size(struct image *cut, const struct image *image, size_t width, size_t height,
                        struct error *error) {
    if (!image_create(cut, width, height, IMAGE_BGR, error)) {
        return false;
    }
    for (size_t y = 0; y < height && y < image->height; y++) {
        for (size_t x = 0; x < width && x < image->width; x++) {
            image_set(cut, (int)x, (int)y, pixel_at(image, x, y));
        }
    }
    return true;
}

bool compare_difference(struct image *difference, const struct image *reference,
                        const struct image *yours, enum compare_pixels wrong, struct error *error) {
    size_t width = reference->width, height = reference->height;
    struct image cut;
    *difference = (struct image){.pixels = NULL};
    if (!cut_to_size(&cut, yours, width, height, error) ||
        !image_create(difference, width, height, IMAGE_BGR, error)) {
        image_free(&cut);
        return false;
    }
    for (size_t y = 0; y < height; y++) {
        for (size_t x = 0; x < width; x++) {
            image_set(difference, (int)x, (int)y,
                      mark_color(mark_pixel(reference, &cut, x, y), wrong,
                                 pixel_at(reference, x, y), pixel_at(&cut, x, y)));
        }
    }
    image_free(&cut);
    return true;
}
