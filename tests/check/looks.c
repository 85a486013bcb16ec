#include "looks.h"

#include "files/image_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    LEAST_WRONG = 8,   /* pixels in a wrong colour, below which nothing is sure */
    UNEXPLAINED = 32,  /* for so many pixels in a wrong colour one may be another */
    OTHERWISE = 8,     /* of so many pixels that are wrong, one may be so in another way */
    APART_QUARTERS = 4 /* how exactly the number of pixels apart must be met: one in so many */
};

/* ---- Reading ---- */

struct place looks_place(const struct image *pixels, size_t i) {
    struct color color = image_get(pixels, (int)i, 0);
    unsigned bits = (unsigned)color.b | (unsigned)color.g << 8 | (unsigned)color.r << 16;
    return (struct place){bits & 0xfff, bits >> 12};
}

void looks_set_place(struct image *pixels, size_t i, struct place place) {
    unsigned bits = (unsigned)place.x | (unsigned)place.y << 12;
    image_set(pixels, (int)i, 0,
              color_rgb((uint8_t)(bits >> 16), (uint8_t)(bits >> 8), (uint8_t)bits));
}

/* What the sign says of a picture of that scene: "zbuffer:2:5234". */
static bool read_sign(const char *sign, const char *scene, struct look *look) {
    size_t length = strlen(scene);
    unsigned long long row, apart;
    if (strncmp(sign, scene, length) != 0 || sign[length] != ':' ||
        sscanf(sign + length + 1, "%llu:%llu", &row, &apart) != 2) {
        return false;
    }
    *look = (struct look){(size_t)row, apart};
    return true;
}

/* Find what each mistake makes of the scene. False when a row is not there, or memory runs out. */
static bool find_looks(struct looks *looks, const char *scene) {
    bool done = true;
    looks->list = calloc(looks->mistakes->count + 1, sizeof *looks->list);
    for (size_t i = 0; looks->list != NULL && i < looks->mistakes->count; i++) {
        const struct mistake *mistake = &looks->mistakes->list[i];
        struct look *look = &looks->list[i];
        for (const char *sign = mistake->signs; sign != NULL; sign = mistake_next_sign(sign)) {
            read_sign(sign, scene, look);
        }
        done &=
            look->row == 0 || (look->row >= LOOKS_FIRST_ROW && look->row < looks->pixels.height);
        if (strcmp(mistake->words, MISTAKE_STARTER) == 0) {
            looks->starter = look->row;
            *look = (struct look){.row = 0};
        }
    }
    return looks->list != NULL && done;
}

void looks_read(struct looks *looks, const struct mistake_list *mistakes, const char *directory,
                const char *step, const char *scene) {
    char path[DRAWN_PATH_LIMIT];
    struct error ignored;
    *looks = (struct looks){.mistakes = mistakes};
    snprintf(path, sizeof path, "%s/%s/looks/%s.png", directory, step, scene);
    if (mistakes->count == 0 || !image_read(&looks->pixels, path, &ignored) ||
        looks->pixels.height <= LOOKS_FIRST_ROW || !find_looks(looks, scene)) {
        looks_free(looks);
    }
}

void looks_free(struct looks *looks) {
    image_free(&looks->pixels);
    free(looks->list);
    free(looks->explains);
    *looks = (struct looks){.list = NULL};
}

/* ---- Comparing ---- */

/* At how many of the pixels has the picture not the colours of that row? */
static size_t find_distance(const struct looks *looks, size_t row, const struct image *picture,
                            int levels) {
    size_t distance = 0;
    for (size_t i = 0; i < looks->pixels.width; i++) {
        struct place place = looks_place(&looks->pixels, i);
        distance += color_distance(image_get(&looks->pixels, (int)i, (int)row),
                                   image_get(picture, (int)place.x, (int)place.y)) > levels;
    }
    return distance;
}

/* At how many of the pixels has the picture a colour that is more than so many levels from the
 * reference's? (-1: any colour.) What is black there says little: pictures that lack much look the
 * same. */
static size_t count_colors(const struct looks *looks, const struct image *picture, int levels) {
    size_t count = 0;
    for (size_t i = 0; i < looks->pixels.width; i++) {
        struct place place = looks_place(&looks->pixels, i);
        struct color color = image_get(picture, (int)place.x, (int)place.y);
        struct color right = image_get(&looks->pixels, (int)i, 1);
        count += !color_is_black(color) && color_distance(color, right) > levels;
    }
    return count;
}

/* Was this the reference when the pixels were kept? */
static bool is_up_to_date(const struct looks *looks, const struct image *reference) {
    for (size_t i = 0; i < looks->pixels.width; i++) {
        struct place place = looks_place(&looks->pixels, i);
        if (place.x >= reference->width || place.y >= reference->height) {
            return false;
        }
    }
    return find_distance(looks, 1, reference, 0) == 0;
}

/* What is known of the mistakes that draw the same. */
struct known {
    size_t names;
    uint64_t apart; /* in the picture of the first of them */
};

static struct known known_of(const struct looks *looks, size_t row) {
    struct known known = {.names = 0};
    for (size_t i = 0; i < looks->mistakes->count; i++) {
        const struct look *look = &looks->list[i];
        if (look->row == row && known.names++ == 0) {
            known.apart = look->apart;
        }
    }
    return known;
}

/* Are as many pixels apart as in a picture of the mistake? */
static bool is_as_far(uint64_t apart, uint64_t of_mistake) {
    uint64_t difference = apart > of_mistake ? apart - of_mistake : of_mistake - apart;
    return difference * APART_QUARTERS <= of_mistake;
}

struct likeness looks_find(const struct looks *looks, const struct image *reference,
                           const struct image *yours, uint64_t apart) {
    const struct likeness none = {.row = 0};
    const int levels = apart > 0 ? COMPARE_LEVELS : 0;
    struct likeness best = none;
    size_t second = SIZE_MAX;
    if (looks->list == NULL || !is_up_to_date(looks, reference)) {
        return none;
    }
    for (size_t row = LOOKS_FIRST_ROW; row < looks->pixels.height; row++) {
        const struct known known = known_of(looks, row);
        if (known.names > 0 && (known.apart == 0) != (apart == 0)) {
            continue; /* what has no name may still be the nearest */
        }
        size_t distance = find_distance(looks, row, yours, levels);
        if (best.row == 0 || distance < best.distance) {
            second = best.row == 0 ? SIZE_MAX : best.distance;
            best = (struct likeness){row, distance};
        } else if (distance < second) {
            second = distance;
        }
    }
    size_t wrong = count_colors(looks, yours, levels);
    const struct known known = known_of(looks, best.row);
    bool is_same = best.distance == 0 && apart > 0 && apart == known.apart &&
                   count_colors(looks, yours, -1) > 0;
    bool is_near = wrong >= LEAST_WRONG && best.distance <= wrong / UNEXPLAINED &&
                   is_as_far(apart, known.apart);
    bool is_clear = second > 2 * best.distance;
    bool is_told =
        (is_same || is_near) && is_clear && known.names > 0 && known.names <= LOOKS_NAME_LIMIT;
    return is_told ? best : none;
}

void looks_compare(struct looks *looks, const struct image *yours) {
    if (looks->list == NULL) {
        return;
    }
    size_t wrong = find_distance(looks, 1, yours, COMPARE_LEVELS);
    looks->explains = calloc(looks->pixels.height, sizeof *looks->explains);
    for (size_t row = LOOKS_FIRST_ROW; looks->explains != NULL && row < looks->pixels.height;
         row++) {
        size_t left = find_distance(looks, row, yours, COMPARE_LEVELS);
        looks->explains[row] = left * OTHERWISE <= wrong;
    }
}

struct mistake_set looks_mistakes(const struct looks *looks, size_t row) {
    struct mistake_set set = {.count = 0};
    for (size_t i = 0; row > 0 && i < looks->mistakes->count; i++) {
        if (looks->list[i].row == row) {
            mistake_set_add(&set, &looks->mistakes->list[i]);
        }
    }
    return set;
}
