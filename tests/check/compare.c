#include "compare.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PANEL_GAP = 8 }; /* grey pixels between two panels */

enum mark { MARK_EQUAL = 0, MARK_NEAR = 1, MARK_APART = 2, MARK_COVERAGE = 4, MARK_WRONG = 8 };
enum { SHIFT_LIMIT = 2, SHIFT_BETTER = 8 }; /* pixels; so many times fewer are apart */

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

/* ---- The rule, for a block of a row at a time ---- */

enum { BLOCK = 256 }; /* pixels; no more, since the levels of a block are added up in 16 bits */

/* A block's pixels and those beside it by channel: pixel i of the block is number i + 1. */
struct channels {
    uint8_t blue[BLOCK + 2], green[BLOCK + 2], red[BLOCK + 2];
};

/* A block, and the rows below and above it. */
struct patch {
    struct channels row[3];
};

/* Pixels of `step` bytes, a constant where this is called, become channels from number `at` on. */
static inline void split_pixels(struct channels *channels, size_t at, const uint8_t *pixels,
                                size_t count, const size_t step) {
    const size_t green = step > 1 ? 1 : 0, red = step > 1 ? 2 : 0;
    for (size_t i = 0; i < count; i++) {
        channels->blue[at + i] = pixels[i * step];
        channels->green[at + i] = pixels[i * step + green];
        channels->red[at + i] = pixels[i * step + red];
    }
}

static void load_pixels(struct channels *channels, size_t at, const struct image *image, size_t x,
                        size_t y, size_t count) {
    const uint8_t *pixels = image->pixels + (y * image->width + x) * (size_t)image->format;
    switch (image->format) {
    case IMAGE_GREY:
        split_pixels(channels, at, pixels, count, 1);
        break;
    case IMAGE_BGR:
        split_pixels(channels, at, pixels, count, 3);
        break;
    case IMAGE_BGRA:
        split_pixels(channels, at, pixels, count, 4);
        break;
    }
}

/* Outside of the image its nearest pixel is repeated. That is among the neighbours anyway. */
static void load_row(struct channels *row, const struct image *image, size_t x, size_t y,
                     size_t count) {
    const size_t left = x > 0 ? x - 1 : 0;
    const size_t right = x + count < image->width ? x + count : x + count - 1;
    load_pixels(row, 0, image, left, y, 1);
    load_pixels(row, 1, image, x, y, count);
    load_pixels(row, count + 1, image, right, y, 1);
}

static void load_patch(struct patch *patch, const struct image *image, size_t x, size_t y,
                       size_t count) {
    load_row(&patch->row[0], image, x, y > 0 ? y - 1 : 0, count);
    load_row(&patch->row[1], image, x, y, count);
    load_row(&patch->row[2], image, x, y + 1 < image->height ? y + 1 : y, count);
}

/* What was that of the row below becomes that of row y. */
static void move_patch_up(struct patch *patch, const struct image *image, size_t x, size_t y,
                          size_t count) {
    memmove(&patch->row[0], &patch->row[1], 2 * sizeof patch->row[0]);
    load_row(&patch->row[2], image, x, y + 1 < image->height ? y + 1 : y, count);
}

static inline uint8_t difference(uint8_t a, uint8_t b) {
    return (uint8_t)(a > b ? a - b : b - a);
}

static inline uint8_t larger(uint8_t a, uint8_t b) {
    return a > b ? a : b;
}

/* How far each pixel of `colors` is from the nearest of the 3x3 around it in `patch`: two colours
 * are as far apart as their channel that differs most. */
static void find_nearest(uint8_t *restrict nearest, const struct channels *restrict colors,
                         const struct patch *restrict patch, size_t count) {
    memset(nearest, 255, count);
    for (size_t k = 0; k < 9; k++) {
        const struct channels *row = &patch->row[k / 3];
        const size_t shift = k % 3;
        for (size_t i = 0; i < count; i++) {
            uint8_t blue = difference(colors->blue[i + 1], row->blue[i + shift]);
            uint8_t green = difference(colors->green[i + 1], row->green[i + shift]);
            uint8_t red = difference(colors->red[i + 1], row->red[i + shift]);
            uint8_t far = larger(larger(blue, green), red);
            nearest[i] = far < nearest[i] ? far : nearest[i];
        }
    }
}

/* Is pixel i of the block not background? */
static inline bool is_drawn(const struct channels *row, size_t i) {
    return (row->blue[i + 1] | row->green[i + 1] | row->red[i + 1]) != 0;
}

/* The marks of a block; all but MARK_EQUAL have MARK_NEAR. */
static void mark_block(uint8_t *marks, const struct patch *reference, const struct patch *yours,
                       size_t count) {
    const struct channels *wanted = &reference->row[1], *got = &yours->row[1];
    uint8_t to_wanted[BLOCK], to_got[BLOCK];
    find_nearest(to_wanted, wanted, yours, count);
    find_nearest(to_got, got, reference, count);
    for (size_t i = 0; i < count; i++) {
        uint8_t blue = difference(wanted->blue[i + 1], got->blue[i + 1]);
        uint8_t green = difference(wanted->green[i + 1], got->green[i + 1]);
        uint8_t red = difference(wanted->red[i + 1], got->red[i + 1]);
        uint8_t far = larger(larger(blue, green), red);
        unsigned apart = far > COMPARE_LEVELS ? MARK_APART : 0;
        unsigned coverage = is_drawn(wanted, i) != is_drawn(got, i) && apart ? MARK_COVERAGE : 0;
        uint8_t farthest = larger(to_wanted[i], to_got[i]); /* missing, or too much */
        unsigned wrong = farthest > COMPARE_LEVELS ? MARK_WRONG : 0;
        marks[i] = (uint8_t)(far == 0 ? MARK_EQUAL : MARK_NEAR | apart | coverage | wrong);
    }
}

/* By how many levels the pixels of the block that agree are lighter, in all. */
static int64_t count_lighter(const uint8_t *wanted, const uint8_t *got, const uint8_t *marks,
                             size_t count) {
    uint16_t sum_wanted = 0, sum_got = 0;
    for (size_t i = 0; i < count; i++) {
        uint8_t agrees = (marks[i] & MARK_APART) != 0 ? 0 : 255;
        sum_wanted = (uint16_t)(sum_wanted + (wanted[i + 1] & agrees));
        sum_got = (uint16_t)(sum_got + (got[i + 1] & agrees));
    }
    return (int64_t)sum_got - sum_wanted;
}

/* How many pixels are not background in at least one of the two. */
static size_t count_drawn(const struct channels *a, const struct channels *b, size_t count) {
    uint16_t drawn = 0;
    for (size_t i = 0; i < count; i++) {
        drawn = (uint16_t)(drawn + ((int)is_drawn(a, i) | (int)is_drawn(b, i)));
    }
    return drawn;
}

/* Is the block the same bytes in both? */
static bool is_same_block(const struct image *a, const struct image *b, size_t x, size_t y,
                          size_t count) {
    size_t start = (y * a->width + x) * (size_t)a->format;
    return a->format == b->format &&
           memcmp(a->pixels + start, b->pixels + start, count * (size_t)a->format) == 0;
}

static void add_same_block(struct comparison *result, const struct image *image, size_t x, size_t y,
                           size_t count) {
    struct channels row;
    load_pixels(&row, 1, image, x, y, count);
    result->drawn += count_drawn(&row, &row, count);
}

/* A block of a row, from (x,y) on. */
struct marked_block {
    size_t x, y, count;
    uint8_t marks[BLOCK];
};

/* Add the pixels whose marks, of those in `mask`, are `wanted`. */
static void add_marked(struct tally *tally, const struct marked_block *block, unsigned mask,
                       unsigned wanted) {
    uint16_t count = 0;
    for (size_t i = 0; i < block->count; i++) {
        count = (uint16_t)(count + ((block->marks[i] & mask) == wanted));
    }
    if (count > 0 && (tally->count == 0 || block->y < tally->y)) {
        size_t first = 0;
        while ((block->marks[first] & mask) != wanted) {
            first++;
        }
        tally->x = block->x + first;
        tally->y = block->y;
    }
    tally->count += count;
}

static void add_block(struct comparison *result, const struct patch *wanted,
                      const struct patch *got, size_t x, size_t y, size_t count) {
    struct marked_block block = {.x = x, .y = y, .count = count};
    const struct channels *right = &wanted->row[1], *yours = &got->row[1];
    mark_block(block.marks, wanted, got, count);
    result->drawn += count_drawn(right, yours, count);
    result->lighter[0] += count_lighter(right->red, yours->red, block.marks, count);
    result->lighter[1] += count_lighter(right->green, yours->green, block.marks, count);
    result->lighter[2] += count_lighter(right->blue, yours->blue, block.marks, count);
    add_marked(&result->differing, &block, MARK_NEAR, MARK_NEAR);
    add_marked(&result->apart, &block, MARK_APART, MARK_APART);
    add_marked(&result->near, &block, MARK_NEAR | MARK_APART, MARK_NEAR);
    add_marked(&result->coverage, &block, MARK_COVERAGE, MARK_COVERAGE);
    add_marked(&result->wrong, &block, MARK_WRONG, MARK_WRONG);
}

static size_t block_size(const struct image *image, size_t x) {
    return image->width - x < BLOCK ? image->width - x : BLOCK;
}

/* The blocks that begin in column x, upwards: each row is loaded once. */
static void add_blocks(struct comparison *result, const struct image *reference,
                       const struct image *yours, size_t x) {
    const size_t count = block_size(reference, x);
    struct patch wanted, got;
    bool is_loaded = false; /* for the row below */
    for (size_t y = 0; y < reference->height; y++) {
        if (is_same_block(reference, yours, x, y, count)) {
            add_same_block(result, reference, x, y, count);
            is_loaded = false;
            continue;
        }
        if (is_loaded) {
            move_patch_up(&wanted, reference, x, y, count);
            move_patch_up(&got, yours, x, y, count);
        } else {
            load_patch(&wanted, reference, x, y, count);
            load_patch(&got, yours, x, y, count);
        }
        is_loaded = true;
        add_block(result, &wanted, &got, x, y, count);
    }
}

struct comparison compare_images(const struct image *reference, const struct image *yours) {
    struct comparison result = {.drawn = 0};
    for (size_t x = 0; x < reference->width; x += BLOCK) {
        add_blocks(&result, reference, yours, x);
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

/* ---- Moved pictures ---- */

static bool is_apart(struct rgb a, struct rgb b) {
    return difference(a.r, b.r) > COMPARE_LEVELS || difference(a.g, b.g) > COMPARE_LEVELS ||
           difference(a.b, b.b) > COMPARE_LEVELS;
}

/* How many pixels are apart when yours is moved back by (right, up)? What is moved out of the
 * picture, and what has come in, does not count. No more than `most` are counted. */
static uint64_t count_apart(const struct image *reference, const struct image *yours, int right,
                            int up, uint64_t most) {
    uint64_t count = 0;
    int width = (int)reference->width, height = (int)reference->height;
    for (int y = up < 0 ? -up : 0; y < height && y + up < height && count < most; y++) {
        for (int x = right < 0 ? -right : 0; x < width && x + right < width; x++) {
            count += is_apart(pixel_at(reference, (size_t)x, (size_t)y),
                              pixel_at(yours, (size_t)(x + right), (size_t)(y + up)));
        }
    }
    return count;
}

struct shift compare_shift(const struct image *reference, const struct image *yours) {
    struct shift best = {0, 0};
    uint64_t apart = count_apart(reference, yours, 0, 0, UINT64_MAX);
    uint64_t least = apart / SHIFT_BETTER + 1;
    if (apart == 0 || image_is_blank(yours)) {
        return best;
    }
    for (int y = -SHIFT_LIMIT; y <= SHIFT_LIMIT; y++) {
        for (int x = -SHIFT_LIMIT; x <= SHIFT_LIMIT; x++) {
            uint64_t count = count_apart(reference, yours, x, y, least);
            if (count < least && (x != 0 || y != 0)) {
                least = count;
                best = (struct shift){x, y};
            }
        }
    }
    return best;
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

static struct rgb mark_color(unsigned marks, enum compare_pixels wrong, struct rgb reference,
                             struct rgb yours) {
    if (marks & marks_of(wrong)) {
        struct rgb red = {.r = 255}, blue = {.b = 255}; /* missing: blue */
        return is_background(yours) ? blue : red;
    }
    if (marks != MARK_EQUAL) {
        return (struct rgb){.g = 96};
    }
    return (struct rgb){reference.r / 4, reference.g / 4, reference.b / 4};
}

/* A block of the difference. */
static void put_block(struct image *difference, const struct image *reference,
                      const struct image *yours, enum compare_pixels wrong, size_t x, size_t y) {
    const size_t count = block_size(reference, x);
    struct patch wanted, got;
    uint8_t marks[BLOCK];
    load_patch(&wanted, reference, x, y, count);
    load_patch(&got, yours, x, y, count);
    mark_block(marks, &wanted, &got, count);
    for (size_t i = 0; i < count; i++) {
        put(difference, x + i, y,
            mark_color(marks[i], wrong, pixel_at(reference, x + i, y), pixel_at(yours, x + i, y)));
    }
}

/* Lay the part of `panel` that has room there on the picture, from column x on. */
static void put_panel(struct image *picture, const struct image *panel, size_t x) {
    for (size_t y = 0; y < picture->height && y < panel->height; y++) {
        for (size_t i = 0; x + i < picture->width && i < panel->width; i++) {
            put(picture, x + i, y, pixel_at(panel, i, y));
        }
    }
}

/* `cut` becomes the part of `image` that a picture of that size shows, with background around. */
static bool cut_to_size(struct image *cut, const struct image *image, size_t width, size_t height,
                        struct error *error) {
    if (!image_create(cut, width, height, IMAGE_BGR, error)) {
        return false;
    }
    put_panel(cut, image, 0);
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
        for (size_t x = 0; x < width; x += BLOCK) {
            put_block(difference, reference, &cut, wrong, x, y);
        }
    }
    image_free(&cut);
    return true;
}

bool compare_picture(struct image *picture, const struct image *reference,
                     const struct image *yours, enum compare_pixels wrong, struct error *error) {
    size_t width = reference->width, height = reference->height;
    struct image cut = {.pixels = NULL}, difference = {.pixels = NULL};
    *picture = (struct image){.pixels = NULL};
    bool done = cut_to_size(&cut, yours, width, height, error) &&
                compare_difference(&difference, reference, yours, wrong, error) &&
                image_create(picture, 3 * width + 2 * PANEL_GAP, height, IMAGE_BGR, error);
    if (done) {
        image_clear(picture, color_grey(128));
        put_panel(picture, reference, 0);
        put_panel(picture, &cut, width + PANEL_GAP);
        put_panel(picture, &difference, 2 * (width + PANEL_GAP));
    }
    image_free(&cut);
    image_free(&difference);
    return done;
}
