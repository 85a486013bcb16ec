/*
 * Makes the picture of a mistake for its lesson's table of wrong pictures: at the left the
 * reference, at the right what the mistake draws, with a white gap between them. `make mistakes`
 * calls it, and `make verify`, to see if a picture is out of date.
 *
 *     figure_make REFERENCE.png WRONG.png PART FIGURE.png
 *
 * PART is as 60x40+10+20: 60 pixels wide, 40 high, from (10,20) on; or auto: the part around what
 * is apart (compare.h), or the whole, where that is not much larger. What is large is made smaller:
 * n x n pixels become one, with the mean of their light; but what is thin and in one of the two
 * only keeps its colour, where the other is plain. What is small is enlarged: each pixel becomes a
 * square.
 *
 * Exit status: 0 done; 1 something cannot be read or written, or nothing can be shown: the two have
 * not one size, the part is not in them, nothing is apart in it, or all of it is black in the wrong
 * picture; 2 wrong usage.
 */
#include "compare.h"
#include "files/image_file.h"
#include "files/png.h"

#include <stdio.h>
#include <string.h>

enum {
    LONGEST_SMALL = 160, /* pixels along the longer side of what was made smaller, at most */
    LONGEST_LARGE = 200, /* and of what was enlarged */
    GAP = 4,
    LEAST_SIDE = 40,     /* pixels of a part that is found: with less nobody knows where it is */
    LEAST_MARGIN = 6,    /* pixels around what is apart, */
    MARGIN_SHARE = 4,    /* or this share of them: one in so many */
    WHOLE_NUMERATOR = 2, /* a part that is longer than two thirds of the picture is not cut out */
    WHOLE_DENOMINATOR = 3
};

/* ---- Which part ---- */

/* A part of a picture; all zero: it is to be found. */
struct figure_area {
    size_t x, y, width, height; /* the lower left pixel; pixels */
};

static bool read_area(struct figure_area *area, const char *text, struct error *error) {
    int end = 0;
    *area = (struct figure_area){.width = 0};
    if (strcmp(text, "auto") == 0) {
        return true;
    }
    bool is_read = strspn(text, "0123456789x+") == strlen(text) &&
                   sscanf(text, "%5zux%5zu+%5zu+%5zu%n", &area->width, &area->height, &area->x,
                          &area->y, &end) == 4;
    return (is_read && text[end] == '\0' && area->width > 0 && area->height > 0) ||
           error_set(error, "not a part of a picture, as 60x40+10+20: %.100s", text);
}

/* The smallest part with all pixels of `area` that are apart; of width 0 when none is. */
static struct figure_area find_apart(const struct image *reference, const struct image *wrong,
                                     struct figure_area area) {
    size_t left = SIZE_MAX, bottom = SIZE_MAX, right = 0, top = 0;
    for (size_t y = area.y; y < area.y + area.height; y++) {
        for (size_t x = area.x; x < area.x + area.width; x++) {
            if (!colors_agree(image_get(reference, (int)x, (int)y),
                              image_get(wrong, (int)x, (int)y))) {
                left = x < left ? x : left;
                right = x + 1 > right ? x + 1 : right;
                bottom = y < bottom ? y : bottom;
                top = y + 1;
            }
        }
    }
    if (right == 0) {
        return (struct figure_area){.width = 0};
    }
    return (struct figure_area){left, bottom, right - left, top - bottom};
}

static size_t larger(size_t a, size_t b) {
    return a > b ? a : b;
}

/* Make *length at least `wanted`, around its middle, within 0..limit. */
static void widen(size_t *begin, size_t *length, size_t wanted, size_t limit) {
    size_t now = wanted < *length ? *length : wanted > limit ? limit : wanted;
    size_t before = (now - *length) / 2;
    *begin = *begin < before ? 0 : *begin - before;
    *begin = *begin + now > limit ? limit - now : *begin;
    *length = now;
}

/* Somewhat more than the part, and not too narrow; or all where that is nearly all. */
static struct figure_area widen_area(struct figure_area part, const struct image *picture) {
    size_t longer = larger(part.width, part.height);
    size_t side = larger(longer + 2 * larger(longer / MARGIN_SHARE, LEAST_MARGIN), LEAST_SIDE);
    if (side * WHOLE_DENOMINATOR > larger(picture->width, picture->height) * WHOLE_NUMERATOR) {
        return (struct figure_area){0, 0, picture->width, picture->height};
    }
    widen(&part.x, &part.width, side, picture->width);
    widen(&part.y, &part.height, side, picture->height);
    return part;
}

static bool is_within(struct figure_area area, const struct image *picture) {
    return area.x < picture->width && area.width <= picture->width - area.x &&
           area.y < picture->height && area.height <= picture->height - area.y;
}

static bool is_black(const struct image *picture, struct figure_area area) {
    for (size_t y = area.y; y < area.y + area.height; y++) {
        for (size_t x = area.x; x < area.x + area.width; x++) {
            if (!colors_agree(image_get(picture, (int)x, (int)y), color_grey(0))) {
                return false;
            }
        }
    }
    return true;
}

/* Find the part, or say why there is none to be shown. */
static bool choose_area(struct figure_area *area, const struct image *reference,
                        const struct image *wrong, struct error *error) {
    if (reference->width != wrong->width || reference->height != wrong->height) {
        return error_set(error, "%zux%zu pixels, and the reference has %zux%zu", wrong->width,
                         wrong->height, reference->width, reference->height);
    }
    bool is_found = area->width == 0;
    if (is_found) {
        *area = (struct figure_area){0, 0, wrong->width, wrong->height};
    } else if (!is_within(*area, wrong)) {
        return error_set(error, "the part is not in a picture of %zux%zu pixels", wrong->width,
                         wrong->height);
    }
    struct figure_area apart = find_apart(reference, wrong, *area);
    if (apart.width == 0) {
        return error_set(error, "nothing wrong can be seen");
    }
    if (is_found) {
        *area = widen_area(apart, wrong);
    }
    return !is_black(wrong, *area) || error_set(error, "all of it is black");
}

/* ---- Smaller or larger ---- */

/* How the pixels of a part become those of the figure. */
struct scaling {
    struct figure_area area;
    size_t pixels;        /* so many become one along each axis, */
    size_t times;         /* or one becomes so many: one of the two is 1 */
    size_t width, height; /* what they become */
};

static struct scaling find_scaling(struct figure_area area) {
    size_t longer = larger(area.width, area.height);
    struct scaling s = {.area = area, .pixels = 1, .times = 1};
    if (longer > LONGEST_SMALL) {
        s.pixels = (longer + LONGEST_SMALL - 1) / LONGEST_SMALL;
    } else if (longer > 0 && longer <= LONGEST_LARGE / 2) {
        s.times = LONGEST_LARGE / longer;
    }
    s.width = (area.width * s.times + s.pixels - 1) / s.pixels;
    s.height = (area.height * s.times + s.pixels - 1) / s.pixels;
    return s;
}

/* What is known of the pixels that become one. */
struct block {
    unsigned long long red, green, blue, count; /* sums of squares */
    struct color first, farthest;               /* the latter from the other picture */
    int contrast, distance;                     /* the largest, to `first` and to the other one */
};

static void add_pixel(struct block *block, struct color color, struct color other) {
    int far = color_distance(color, other);
    block->red += (unsigned)color.r * color.r;
    block->green += (unsigned)color.g * color.g;
    block->blue += (unsigned)color.b * color.b;
    if (block->count++ == 0) {
        *block = (struct block){block->red, block->green, block->blue, 1, color, color, 0, far};
    }
    int contrast = color_distance(color, block->first);
    block->contrast = contrast > block->contrast ? contrast : block->contrast;
    if (far > block->distance) {
        block->distance = far;
        block->farthest = color;
    }
}

static struct block block_of(const struct image *picture, const struct image *other,
                             const struct scaling *s, size_t x, size_t y) {
    struct block block = {.count = 0};
    for (size_t j = y * s->pixels; j < (y + 1) * s->pixels && j < s->area.height; j++) {
        for (size_t i = x * s->pixels; i < (x + 1) * s->pixels && i < s->area.width; i++) {
            int column = (int)(s->area.x + i), row = (int)(s->area.y + j);
            add_pixel(&block, image_get(picture, column, row), image_get(other, column, row));
        }
    }
    return block;
}

/* The root of the mean, in whole numbers; of several pixels rounded to few levels, for files that
 * are half as large: it is at most 4 off, so that the colours agree (compare.h). */
static uint8_t level_of(unsigned long long squares, unsigned long long count) {
    enum { MOST = 255, LEVELS = 31 };
    unsigned level = 0;
    while (level < MOST && (level + 1ULL) * (level + 1) * count <= squares) {
        level++;
    }
    return (uint8_t)(count == 1 ? level : (level * LEVELS + MOST / 2) / MOST * MOST / LEVELS);
}

/* The mean of the light: levels are about the roots of it. */
static struct color mean_of(const struct block *block) {
    return color_rgb(level_of(block->red, block->count), level_of(block->green, block->count),
                     level_of(block->blue, block->count));
}

/* A pixel of one of the pictures in the figure. What only this one has is not lost where the other
 * is plain. */
static struct color find_color(const struct image *picture, const struct image *other,
                               const struct scaling *s, size_t x, size_t y) {
    struct block block = block_of(picture, other, s, x, y);
    struct block there = block_of(other, picture, s, x, y);
    struct color color = mean_of(&block);
    bool is_lost = color_distance(color, mean_of(&there)) * 2 < block.distance;
    bool is_plain = there.contrast * 2 < block.distance;
    return is_lost && is_plain ? block.farthest : color;
}

/* One of the two pictures, with its left side at `left` in the figure. */
static void add_panel(struct image *figure, size_t left, const struct image *picture,
                      const struct image *other, const struct scaling *s) {
    for (size_t y = 0; y < s->height; y++) {
        for (size_t x = 0; x < s->width; x++) {
            image_set(figure, (int)(left + x), (int)y,
                      find_color(picture, other, s, x / s->times, y / s->times));
        }
    }
}

static bool is_grey(const struct image *picture) {
    for (size_t y = 0; y < picture->height; y++) {
        for (size_t x = 0; x < picture->width; x++) {
            struct color color = image_get(picture, (int)x, (int)y);
            if (color.r != color.g || color.g != color.b) {
                return false;
            }
        }
    }
    return true;
}

static bool draw_figure(struct image *figure, const struct image *reference,
                        const struct image *wrong, struct figure_area area, struct error *error) {
    *figure = (struct image){.pixels = NULL};
    if (!choose_area(&area, reference, wrong, error)) {
        return false;
    }
    struct scaling scaling = find_scaling(area);
    size_t right = scaling.width + GAP;
    bool grey = is_grey(reference) && is_grey(wrong);
    enum image_format format = grey ? IMAGE_GREY : IMAGE_BGR;
    if (!image_create(figure, right + scaling.width, scaling.height, format, error)) {
        return false;
    }
    image_clear(figure, color_grey(255));
    add_panel(figure, 0, reference, wrong, &scaling);
    add_panel(figure, right, wrong, reference, &scaling);
    return true;
}

static bool make_figure(char **arguments, struct error *error) {
    struct image reference = {.pixels = NULL}, wrong = {.pixels = NULL}, figure = {.pixels = NULL};
    struct figure_area area;
    bool done = read_area(&area, arguments[2], error) &&
                image_read(&reference, arguments[0], error) &&
                image_read(&wrong, arguments[1], error) &&
                draw_figure(&figure, &reference, &wrong, area, error) &&
                png_write(&figure, arguments[3], error);
    image_free(&reference);
    image_free(&wrong);
    image_free(&figure);
    return done;
}

int main(int argc, char **argv) {
    struct error error;
    if (argc != 5) {
        fprintf(stderr, "Usage: figure_make REFERENCE.png WRONG.png PART FIGURE.png\n");
        return 2;
    }
    if (!make_figure(argv + 1, &error)) {
        fprintf(stderr, "figure_make: %s\n", error.message);
        return 1;
    }
    return 0;
}
