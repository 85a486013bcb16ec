#include "seen.h"

#include "compare.h"

#include <stdio.h>
#include <stdlib.h>

enum { TRUE_SHARE = 20 }; /* of the drawn pixels one in so many may contradict */

/* Where a pixel of the reference is to be found in yours, and in which colours. */
struct seen_map {
    double from_x, from_y;                 /* pixel (0,0) of the reference is this one of yours */
    double x_by_x, x_by_y, y_by_x, y_by_y; /* and one to the right, one up, are so far from it */
    int channels[3];                       /* red, green, blue are which of yours */
};

static const struct seen_map same_place = {.x_by_x = 1, .y_by_y = 1, .channels = {0, 1, 2}};

static struct color mapped_color(const struct image *yours, const struct seen_map *map, int x,
                                 int y) {
    double at_x = map->from_x + map->x_by_x * x + map->x_by_y * y;
    double at_y = map->from_y + map->y_by_x * x + map->y_by_y * y;
    struct color c = {0};
    if (at_x > -0.5 && at_y > -0.5 && at_x < (double)yours->width - 0.5 &&
        at_y < (double)yours->height - 0.5) {
        c = image_get(yours, (int)(at_x + 0.5), (int)(at_y + 0.5));
    }
    const uint8_t levels[] = {c.r, c.g, c.b};
    return color_rgb(levels[map->channels[0]], levels[map->channels[1]], levels[map->channels[2]]);
}

/* How many pixels do not agree, yours mapped, and how many are drawn in either: of all pixels, or
 * of the first rows, where more than `most` have been found there. Up to `near` pixels away a
 * colour is as good. */
struct seen_count {
    size_t apart, drawn;
};

static struct seen_count count_apart(const struct image *reference, const struct image *yours,
                                     const struct seen_map *map, int near, size_t most) {
    struct seen_count count = {0, 0};
    for (int y = 0; y < (int)reference->height && count.apart <= most; y++) {
        for (int x = 0; x < (int)reference->width; x++) {
            struct color right = image_get(reference, x, y), is = mapped_color(yours, map, x, y);
            bool found = colors_agree(right, is);
            for (int i = 0; i < 9 && !found && near > 0; i++) {
                found = colors_agree(right, mapped_color(yours, map, x + i % 3 - 1, y + i / 3 - 1));
            }
            count.drawn += !color_is_black(right) || !color_is_black(is);
            count.apart += !found;
        }
    }
    return count;
}

/* Does this map explain nearly all, and most of what is apart without it? */
static bool is_map(const struct image *reference, const struct image *yours,
                   const struct seen_map *map, int near) {
    const size_t size = reference->width * reference->height;
    struct seen_count mapped = count_apart(reference, yours, map, near, size / TRUE_SHARE);
    return TRUE_SHARE * mapped.apart <= mapped.drawn &&
           4 * mapped.apart < count_apart(reference, yours, &same_place, near, size).apart;
}

/* ---- What it may be ---- */

/* Has everything drawn one colour, and in the reference not? */
static bool is_one_color(const struct image *image, struct color *color) {
    bool any = false;
    for (int y = 0; y < (int)image->height; y++) {
        for (int x = 0; x < (int)image->width; x++) {
            struct color c = image_get(image, x, y);
            if (!color_is_black(c) && !any) {
                *color = c;
                any = true;
            } else if (!color_is_black(c) && color_distance(c, *color) > 0) {
                return false;
            }
        }
    }
    return any;
}

/* Turned, mirrored, or with channels exchanged. */
static const char *find_turn(const struct image *reference, const struct image *yours) {
    const double right = (double)reference->width - 1, top = (double)reference->height - 1;
    const bool is_square = reference->width == reference->height;
    const struct {
        const char *text;
        struct seen_map map;
    } turns[] = {
        {"mirrored: left and right are exchanged", {right, 0, -1, 0, 0, 1, {0, 1, 2}}},
        {"upside down", {0, top, 1, 0, 0, -1, {0, 1, 2}}},
        {"turned by half a turn", {right, top, -1, 0, 0, -1, {0, 1, 2}}},
        {"x and y are exchanged", {0, 0, 0, 1, 1, 0, {0, 1, 2}}},
        {"turned by a quarter to the left", {right, 0, 0, -1, 1, 0, {0, 1, 2}}},
        {"turned by a quarter to the right", {0, top, 0, 1, -1, 0, {0, 1, 2}}},
        {"red and blue are exchanged", {0, 0, 1, 0, 0, 1, {2, 1, 0}}},
        {"red and green are exchanged", {0, 0, 1, 0, 0, 1, {1, 0, 2}}},
        {"green and blue are exchanged", {0, 0, 1, 0, 0, 1, {0, 2, 1}}},
    };
    enum { IN_PLACE = 6, FOR_SQUARES = 3 }; /* where the last kinds begin */
    for (size_t i = 0; i < sizeof turns / sizeof turns[0]; i++) {
        bool fits = is_square || i < FOR_SQUARES || i >= IN_PLACE;
        if (fits && is_map(reference, yours, &turns[i].map, i < IN_PLACE)) {
            return turns[i].text;
        }
    }
    return NULL;
}

/* The box around what is drawn; there is something. */
struct box {
    int left, bottom, right, top; /* inclusive */
};

static struct box find_box(const struct image *image) {
    struct box box = {(int)image->width, (int)image->height, -1, -1};
    for (int y = 0; y < (int)image->height; y++) {
        for (int x = 0; x < (int)image->width; x++) {
            if (!color_is_black(image_get(image, x, y))) {
                box.left = x < box.left ? x : box.left;
                box.right = x > box.right ? x : box.right;
                box.bottom = y < box.bottom ? y : box.bottom;
                box.top = y > box.top ? y : box.top;
            }
        }
    }
    return box;
}

/* Moved, or larger and smaller, as the boxes say. */
static struct seen_text find_place(const struct image *reference, const struct image *yours) {
    const struct box right = find_box(reference), box = find_box(yours);
    struct seen_text seen = {""};
    struct seen_map map = same_place;
    /* A side may have been cut off at the border: then the other one tells. */
    map.from_x = right.left > 0 && box.left > 0 ? box.left - right.left : box.right - right.right;
    map.from_y =
        right.bottom > 0 && box.bottom > 0 ? box.bottom - right.bottom : box.top - right.top;
    if ((map.from_x != 0 || map.from_y != 0) && is_map(reference, yours, &map, 0)) {
        snprintf(seen.text, sizeof seen.text, "moved by (%g,%g)", map.from_x, map.from_y);
        return seen;
    }
    if (right.right == right.left || right.top == right.bottom) {
        return seen;
    }
    map.x_by_x = (double)(box.right - box.left) / (right.right - right.left);
    map.y_by_y = (double)(box.top - box.bottom) / (right.top - right.bottom);
    map.from_x = box.left - map.x_by_x * right.left;
    map.from_y = box.bottom - map.y_by_y * right.bottom;
    bool is_scaled =
        map.x_by_x < 0.95 || map.x_by_x > 1.05 || map.y_by_y < 0.95 || map.y_by_y > 1.05;
    if (is_scaled && is_map(reference, yours, &map, 1)) {
        snprintf(seen.text, sizeof seen.text, "%.2g times as wide and %.2g times as high",
                 map.x_by_x, map.y_by_y);
    }
    return seen;
}

/* The background: the colour that most pixels of the reference have, but not all; or black. (A
 * panel's may be grey. Boyer and Moore, "MJRTY, a fast majority vote algorithm", 1981.) */
static struct color find_background(const struct image *reference) {
    const size_t size = reference->width * reference->height;
    const struct color black = {0};
    struct color most = black;
    size_t votes = 0, count = 0;
    for (int pass = 0; pass < 2; pass++) {
        for (size_t i = 0; i < size; i++) {
            const struct color c =
                image_get(reference, (int)(i % reference->width), (int)(i / reference->width));
            const bool same = color_distance(c, most) == 0;
            if (pass == 1) {
                count += same;
            } else if (votes == 0) {
                most = c;
                votes = 1;
            } else {
                votes += same ? 1 : (size_t)-1;
            }
        }
    }
    return 2 * count > size && count < size ? most : black;
}

/* Pixels drawn in the reference, in it alone, in yours alone; and of those in both how many have
 * other colours, how many of these are nowhere too light or nowhere too dark, and by how much. */
struct parts {
    size_t drawn, missing, extra, other, dark, light;
    double levels;
};

static void add_color(struct parts *parts, struct color right, struct color is) {
    int r = is.r - right.r, g = is.g - right.g, b = is.b - right.b;
    parts->other++;
    parts->dark += r <= 0 && g <= 0 && b <= 0;
    parts->light += r >= 0 && g >= 0 && b >= 0;
    parts->levels += abs(r + g + b) / 3.0;
}

static bool is_background(struct color c, struct color background) {
    return color_is_black(c) || color_distance(c, background) == 0;
}

static struct parts find_parts(const struct image *reference, const struct image *yours) {
    struct parts parts = {.drawn = 0};
    const struct color background = find_background(reference);
    for (int y = 0; y < (int)reference->height; y++) {
        for (int x = 0; x < (int)reference->width; x++) {
            struct color right = image_get(reference, x, y), is = image_get(yours, x, y);
            const bool wanted = !is_background(right, background);
            const bool drawn = !is_background(is, background);
            parts.drawn += wanted;
            parts.missing += wanted && !drawn;
            parts.extra += drawn && !wanted;
            if (drawn && wanted && !colors_agree(right, is)) {
                add_color(&parts, right, is);
            }
        }
    }
    return parts;
}

/* All is drawn where it should be: are its colours too dark, or too light? */
static struct seen_text describe_colors(const struct parts *parts) {
    const size_t most = parts->other - parts->other / TRUE_SHARE;
    struct seen_text seen = {"the right pixels are drawn, in other colours"};
    if (parts->dark >= most || parts->light >= most) {
        snprintf(seen.text, sizeof seen.text,
                 "the right pixels are drawn, but too %s: where they differ, by %.0f on average",
                 parts->dark >= most ? "dark" : "light", parts->levels / (double)parts->other);
    }
    return seen;
}

/* What is said of the rest, of which few pixels may be wrong. */
static const char *of_the_rest(size_t wrong) {
    return wrong == 0 ? "the rest is right" : "nearly all the rest is right";
}

/* What is missing, where the rest is right; what is too much; which colours are wrong; or how many
 * pixels are each of these. */
static struct seen_text find_part(const struct image *reference, const struct image *yours) {
    const struct parts parts = find_parts(reference, yours);
    const size_t kept = parts.drawn - parts.missing, wrong = parts.extra + parts.other;
    struct seen_text seen = {""};
    if (TRUE_SHARE * parts.missing > parts.drawn && TRUE_SHARE * wrong <= kept) {
        snprintf(seen.text, sizeof seen.text, "%zu %% of the picture is missing, %s",
                 parts.missing * 100 / parts.drawn, of_the_rest(wrong));
    } else if (TRUE_SHARE * parts.extra > parts.drawn &&
               TRUE_SHARE * (parts.missing + parts.other) <= parts.drawn) {
        snprintf(seen.text, sizeof seen.text, "%zu %% of what you draw should not be there, %s",
                 parts.extra * 100 / (kept + parts.extra),
                 of_the_rest(parts.missing + parts.other));
    } else if (parts.other > 0 && TRUE_SHARE * (parts.missing + parts.extra) <= parts.other) {
        seen = describe_colors(&parts);
    } else if (parts.missing + wrong > 0) {
        snprintf(seen.text, sizeof seen.text,
                 "%zu pixels are missing, %zu are too many, %zu have other colours", parts.missing,
                 parts.extra, parts.other);
    }
    return seen;
}

struct seen_text seen_find(const struct image *reference, const struct image *yours) {
    struct seen_text seen = {""};
    struct color one = {0}, other = {0};
    if (image_is_blank(yours)) {
        return (struct seen_text){"nothing is drawn"};
    }
    if (is_one_color(yours, &one) && !is_one_color(reference, &other)) {
        snprintf(seen.text, sizeof seen.text, "all that is drawn has one colour, %d,%d,%d", one.r,
                 one.g, one.b);
        return seen;
    }
    const char *turn = find_turn(reference, yours);
    if (turn != NULL) {
        snprintf(seen.text, sizeof seen.text, "%s", turn);
    } else {
        seen = find_place(reference, yours);
    }
    return seen.text[0] != '\0' ? seen : find_part(reference, yours);
}
