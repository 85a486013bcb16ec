/*
 * Keeps what the known mistakes look like (looks.h says how): what `make mistakes` calls.
 *
 *     looks_make STEP SCENE REFERENCE.png LIST DIRECTORY LOOKS
 *
 * LIST is a list of mistakes (mistakes.h) with a number instead of signs;
 * DIRECTORY/NUMBER/SCENE.png is what the mistake draws, when it draws something wrong there. Writes
 * LOOKS/STEP/SCENE.png, or removes it where no mistake can be known, and prints NUMBER and sign of
 * each mistake that shows in the scene.
 *
 * Exit status: 0 done, 1 something cannot be read or written, 2 wrong usage.
 */
#define _POSIX_C_SOURCE 200809L

#include "base/file.h"
#include "compare.h"
#include "drawn.h"
#include "files/image_file.h"
#include "files/png.h"
#include "looks.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum {
    FROM_REFERENCE = 24, /* pixels kept of each picture that differ from the reference's */
    FROM_EACH_OTHER = 6, /* at least, of each two pictures */
    ELSEWHERE = 64,      /* pixels kept whatever is there */
    LEAST_NEAR = 20,     /* a picture is near but not equal when one drawn pixel of so many is */
    LARGEST_SIDE = 4096  /* of a picture: a place is kept in 12 bits for x and 12 for y */
};

struct making {
    const char *step, *scene;
    struct image reference;
    struct mistake_list mistakes;
    struct look *looks;  /* what each makes of the scene, */
    struct image *drawn; /* and its picture; empty where it draws nothing wrong */
    size_t *rows;        /* the number of the first mistake with that picture, by row */
    size_t row_count;
    struct place *places; /* room for all pixels */
    size_t place_count;
    unsigned char *is_kept; /* by pixel of the picture */
};

static struct error error;

static _Noreturn void fail(void) {
    fprintf(stderr, "looks_make: %s\n", error.message);
    exit(1);
}

static inline void need(bool done) {
    if (!done) {
        fail();
    }
}

static void *memory(size_t count, size_t size) {
    void *all = calloc(count, size);
    if (all == NULL) {
        error_out_of_memory(&error);
        fail();
    }
    return all;
}

static bool are_apart(const struct image *a, const struct image *b, size_t x, size_t y,
                      int levels) {
    return color_distance(image_get(a, (int)x, (int)y), image_get(b, (int)x, (int)y)) > levels;
}

/* ---- Reading ---- */

/* Read the list, and what each of it has drawn in the size of the reference. */
static void read_mistakes(struct making *making, const char *list, const char *directory) {
    const struct image *reference = &making->reference;
    need(mistakes_read(&making->mistakes, list) ||
         error_set(&error, "%s: no list of mistakes", list));
    size_t count = making->mistakes.count;
    making->looks = memory(count + 1, sizeof *making->looks);
    making->drawn = memory(count + 1, sizeof *making->drawn);
    making->rows = memory(count + 1, sizeof *making->rows);
    for (size_t i = 0; i < count; i++) {
        char path[DRAWN_PATH_LIMIT];
        struct image *image = &making->drawn[i];
        struct error ignored;
        snprintf(path, sizeof path, "%s/%s/%s.png", directory, making->mistakes.list[i].signs,
                 making->scene);
        if (image_read(image, path, &ignored) &&
            (image->width != reference->width || image->height != reference->height)) {
            image_free(image);
        }
    }
}

/* Are they the same picture to looks_find()? It tells those that are near the reference (none of
 * their pixels is apart) only when they are equal. */
static bool are_same(const struct making *making, size_t i, size_t k) {
    const struct image *a = &making->drawn[i], *b = &making->drawn[k];
    const bool is_near = making->looks[i].apart == 0 || making->looks[k].apart == 0;
    const int levels = is_near ? 0 : COMPARE_LEVELS;
    for (size_t y = 0; y < a->height; y++) {
        for (size_t x = 0; x < a->width; x++) {
            if (are_apart(a, b, x, y, levels)) {
                return false;
            }
        }
    }
    return true;
}

/* Give each picture a row, the same picture the same one. */
static void find_rows(struct making *making) {
    for (size_t i = 0; i < making->mistakes.count; i++) {
        const struct image *drawn = &making->drawn[i];
        struct look *look = &making->looks[i];
        if (drawn->pixels == NULL || image_is_blank(drawn)) {
            continue;
        }
        struct comparison found = compare_images(&making->reference, drawn);
        bool is_shown = found.apart.count > 0 || found.near.count * LEAST_NEAR >= found.drawn;
        look->apart = found.apart.count;
        for (size_t k = 0; k < making->row_count && is_shown && look->row == 0; k++) {
            if (are_same(making, making->rows[k], i)) {
                look->row = LOOKS_FIRST_ROW + k;
            }
        }
        if (is_shown && look->row == 0) {
            making->rows[making->row_count] = i;
            look->row = LOOKS_FIRST_ROW + making->row_count++;
        }
    }
}

/* ---- Which pixels are kept ---- */

static void keep(struct making *making, size_t x, size_t y) {
    size_t number = y * making->reference.width + x;
    if (!making->is_kept[number]) {
        making->places[making->place_count++] = (struct place){x, y};
        making->is_kept[number] = 1;
    }
}

/* Of the pixels at which two pictures are apart, keep `wanted` that lie evenly among them; where
 * none is, of those at which they differ. */
static void keep_apart(struct making *making, const struct image *a, const struct image *b,
                       size_t wanted) {
    const struct comparison all = compare_images(a, b);
    const int levels = all.apart.count > 0 ? COMPARE_LEVELS : 0;
    uint64_t apart = levels > 0 ? all.apart.count : all.differing.count, found = 0, kept = 0;
    for (size_t y = 0; y < a->height; y++) {
        for (size_t x = 0; x < a->width; x++) {
            if (are_apart(a, b, x, y, levels) && found++ * wanted >= kept * apart) {
                kept++;
                keep(making, x, y);
            }
        }
    }
}

/* At how many of the kept pixels are two pictures apart? */
static size_t count_kept(const struct making *making, const struct image *a,
                         const struct image *b) {
    size_t count = 0;
    for (size_t i = 0; i < making->place_count; i++) {
        count += are_apart(a, b, making->places[i].x, making->places[i].y, COMPARE_LEVELS);
    }
    return count;
}

static const struct image *picture_of(const struct making *making, size_t row) {
    return &making->drawn[making->rows[row]];
}

static void choose_places(struct making *making) {
    const struct image *reference = &making->reference;
    for (size_t i = 0; i < ELSEWHERE; i++) { /* a diagonal that goes round and round */
        keep(making, i * 37 % ELSEWHERE * reference->width / ELSEWHERE,
             i * reference->height / ELSEWHERE);
    }
    for (size_t i = 0; i < making->row_count; i++) {
        keep_apart(making, reference, picture_of(making, i), FROM_REFERENCE);
    }
    for (size_t i = 0; i < making->row_count; i++) {
        for (size_t k = 0; k < i; k++) {
            const struct image *a = picture_of(making, i), *b = picture_of(making, k);
            if (count_kept(making, a, b) < FROM_EACH_OTHER) {
                keep_apart(making, a, b, FROM_EACH_OTHER);
            }
        }
    }
}

/* ---- Writing ---- */

static void copy_row(const struct making *making, struct image *pixels, size_t row,
                     const struct image *from) {
    for (size_t i = 0; i < making->place_count; i++) {
        struct place place = making->places[i];
        image_set(pixels, (int)i, (int)row, image_get(from, (int)place.x, (int)place.y));
    }
}

static void make_pixels(const struct making *making, struct image *pixels) {
    need(image_create(pixels, making->place_count, LOOKS_FIRST_ROW + making->row_count, IMAGE_BGR,
                      &error));
    for (size_t i = 0; i < making->place_count; i++) {
        looks_set_place(pixels, i, making->places[i]);
    }
    copy_row(making, pixels, 1, &making->reference);
    for (size_t i = 0; i < making->row_count; i++) {
        copy_row(making, pixels, LOOKS_FIRST_ROW + i, picture_of(making, i));
    }
}

static void write_pixels(const struct making *making, const struct image *pixels,
                         const char *directory) {
    char path[DRAWN_PATH_LIMIT + 80];
    snprintf(path, sizeof path, "%s/%s/looks", directory, making->step);
    need(directory_create(path, &error));
    snprintf(path, sizeof path, "%s/%s/looks/%s.png", directory, making->step, making->scene);
    if (making->row_count == 0) {
        unlink(path);
        return;
    }
    need(png_write(pixels, path, &error));
}

/* ---- What a look says ---- */

static void print_sign(const struct making *making, size_t mistake, size_t row, uint64_t apart) {
    if (row > 0 || apart > 0) {
        printf("%s %s:%zu:%llu\n", making->mistakes.list[mistake].signs, making->scene, row,
               (unsigned long long)apart);
    }
}

/* The starter is no mistake: its picture has a row, but no name. */
static void print_starter(struct making *making) {
    for (size_t i = 0; i < making->mistakes.count; i++) {
        if (strcmp(making->mistakes.list[i].words, MISTAKE_STARTER) == 0) {
            print_sign(making, i, making->looks[i].row, making->looks[i].apart);
            making->looks[i] = (struct look){.row = 0};
        }
    }
}

/* What looks_find() itself does not recognise has row 0. */
static void print_signs(const struct making *making, const struct looks *looks) {
    for (size_t i = 0; i < making->mistakes.count; i++) {
        const struct look *look = &making->looks[i];
        bool is_told =
            look->row > 0 &&
            looks_find(looks, &making->reference, &making->drawn[i], look->apart).row == look->row;
        print_sign(making, i, is_told ? look->row : 0, look->apart);
    }
}

/* What is made is kept until the program ends. */
int main(int argc, char **argv) {
    if (argc != 7) {
        fprintf(stderr, "Usage: looks_make STEP SCENE REFERENCE.png LIST DIRECTORY LOOKS\n");
        return 2;
    }
    struct making making = {.step = argv[1], .scene = argv[2]};
    need(image_read(&making.reference, argv[3], &error));
    read_mistakes(&making, argv[4], argv[5]);
    size_t width = making.reference.width, height = making.reference.height;
    need((width <= LARGEST_SIDE && height <= LARGEST_SIDE) ||
         error_set(&error, "%s: larger than %d pixels", argv[3], LARGEST_SIDE));
    making.is_kept = memory(width, height);
    making.places = memory(width * height, sizeof *making.places);
    find_rows(&making);
    choose_places(&making);
    struct looks looks = {.mistakes = &making.mistakes, .list = making.looks};
    make_pixels(&making, &looks.pixels);
    write_pixels(&making, &looks.pixels, argv[6]);
    print_starter(&making);
    print_signs(&making, &looks);
    return 0;
}
