/*
 * Keeps what the known mistakes look like (looks.h says how): what `make mistakes` calls.
 *
 *     looks_make STEP SCENE REFERENCE.png LIST DIRECTORY LOOKS
 *
 * LIST is a list of mistakes (mistakes.h) with a number instead of signs;
 * DIRECTORY/NUMBER/SCENE.png is what the mistake draws, when it draws something wrong there. Writes
 * LOOKS/STEP/SCENE.png and .small.png, or removes them where no mistake can be known, and prints
 * NUMBER and sign of each mistake that shows in the scene.
 *
 * Exit status: 0 done, 1 something cannot be read or written, 2 wrong usage.
 */
#define _POSIX_C_SOURCE 200809L

#include "base/array.h"
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
    struct place *places;
    size_t place_count, place_capacity;
    unsigned char *is_kept; /* by pixel of the picture */
};

static bool are_apart(const struct image *a, const struct image *b, size_t x, size_t y,
                      int levels) {
    return color_distance(image_get(a, (int)x, (int)y), image_get(b, (int)x, (int)y)) > levels;
}

/* ---- Reading ---- */

/* Read the list, and what each of it has drawn in the size of the reference. */
static bool read_mistakes(struct making *making, const char *list, const char *directory,
                          struct error *error) {
    const struct image *reference = &making->reference;
    if (!mistakes_read(&making->mistakes, list)) {
        return error_set(error, "%s: no list of mistakes", list);
    }
    size_t count = making->mistakes.count;
    making->looks = calloc(count + 1, sizeof *making->looks);
    making->drawn = calloc(count + 1, sizeof *making->drawn);
    making->rows = calloc(count + 1, sizeof *making->rows);
    if (making->looks == NULL || making->drawn == NULL || making->rows == NULL) {
        return error_out_of_memory(error);
    }
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
    return true;
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

static bool keep(struct making *making, size_t x, size_t y) {
    size_t number = y * making->reference.width + x;
    if (making->is_kept[number]) {
        return true;
    }
    struct place *places = array_reserve(making->places, &making->place_capacity,
                                         making->place_count + 1, sizeof *places);
    if (places == NULL) {
        return false;
    }
    making->places = places;
    places[making->place_count++] = (struct place){x, y};
    making->is_kept[number] = 1;
    return true;
}

/* Of the pixels at which two pictures are apart, keep `wanted` that lie evenly among them; where
 * none is, of those at which they differ. */
static bool keep_apart(struct making *making, const struct image *a, const struct image *b,
                       size_t wanted) {
    const struct comparison all = compare_images(a, b);
    const int levels = all.apart.count > 0 ? COMPARE_LEVELS : 0;
    uint64_t apart = levels > 0 ? all.apart.count : all.differing.count, found = 0, kept = 0;
    bool done = true;
    for (size_t y = 0; y < a->height; y++) {
        for (size_t x = 0; x < a->width && done; x++) {
            if (are_apart(a, b, x, y, levels)) {
                bool is_next = found++ * wanted >= kept * apart;
                kept += is_next;
                done = !is_next || keep(making, x, y);
            }
        }
    }
    return done;
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

static bool choose_places(struct making *making) {
    const struct image *reference = &making->reference;
    bool done = true;
    for (size_t i = 0; i < ELSEWHERE && done; i++) { /* a diagonal that goes round and round */
        done = keep(making, i * 37 % ELSEWHERE * reference->width / ELSEWHERE,
                    i * reference->height / ELSEWHERE);
    }
    for (size_t i = 0; i < making->row_count && done; i++) {
        done = keep_apart(making, reference, picture_of(making, i), FROM_REFERENCE);
    }
    for (size_t i = 0; i < making->row_count; i++) {
        for (size_t k = 0; k < i && done; k++) {
            const struct image *a = picture_of(making, i), *b = picture_of(making, k);
            done = count_kept(making, a, b) >= FROM_EACH_OTHER ||
                   keep_apart(making, a, b, FROM_EACH_OTHER);
        }
    }
    return done;
}

/* ---- Writing ---- */

static void copy_row(const struct making *making, struct image *pixels, size_t row,
                     const struct image *from) {
    for (size_t i = 0; i < making->place_count; i++) {
        struct place place = making->places[i];
        image_set(pixels, (int)i, (int)row, image_get(from, (int)place.x, (int)place.y));
    }
}

static bool make_pixels(const struct making *making, struct image *pixels, struct error *error) {
    if (!image_create(pixels, making->place_count, LOOKS_FIRST_ROW + making->row_count, IMAGE_BGR,
                      error)) {
        return false;
    }
    for (size_t i = 0; i < making->place_count; i++) {
        looks_set_place(pixels, i, making->places[i]);
    }
    copy_row(making, pixels, 1, &making->reference);
    for (size_t i = 0; i < making->row_count; i++) {
        copy_row(making, pixels, LOOKS_FIRST_ROW + i, picture_of(making, i));
    }
    return true;
}

/* The small pictures of all rows, side by side. */
static bool make_small(const struct making *making, struct image *sheet, struct error *error) {
    struct image small;
    bool done = true;
    for (size_t i = 0; i < making->row_count && done; i++) {
        done = looks_shrink(&small, picture_of(making, i), &making->reference, error) &&
               (i > 0 || image_create(sheet, small.width * making->row_count, small.height,
                                      IMAGE_BGR, error));
        for (size_t y = 0; done && y < small.height; y++) {
            for (size_t x = 0; x < small.width; x++) {
                image_set(sheet, (int)(i * small.width + x), (int)y,
                          image_get(&small, (int)x, (int)y));
            }
        }
        image_free(&small);
    }
    return done;
}

static bool write_pictures(const struct making *making, const struct image *pixels,
                           const char *directory, struct error *error) {
    char path[DRAWN_PATH_LIMIT + 80];
    struct result_path small_path = looks_small_path(directory, making->step, making->scene);
    struct image small = {.pixels = NULL};
    snprintf(path, sizeof path, "%s/%s/looks", directory, making->step);
    bool done = directory_create(path, error);
    snprintf(path, sizeof path, "%s/%s/looks/%s.png", directory, making->step, making->scene);
    if (making->row_count == 0) {
        unlink(path);
        unlink(small_path.text);
        return done;
    }
    done = done && png_write(pixels, path, error) && make_small(making, &small, error) &&
           png_write(&small, small_path.text, error);
    image_free(&small);
    return done;
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

static bool make(struct making *making, char **arguments, struct error *error) {
    if (!image_read(&making->reference, arguments[2], error) ||
        !read_mistakes(making, arguments[3], arguments[4], error)) {
        return false;
    }
    size_t width = making->reference.width, height = making->reference.height;
    if (width > LARGEST_SIDE || height > LARGEST_SIDE) {
        return error_set(error, "%s: larger than %d pixels", arguments[2], LARGEST_SIDE);
    }
    making->is_kept = calloc(width, height);
    if (making->is_kept == NULL) {
        return error_out_of_memory(error);
    }
    find_rows(making);
    struct looks looks = {.mistakes = &making->mistakes, .list = making->looks};
    bool done = choose_places(making) || error_out_of_memory(error);
    done = done && make_pixels(making, &looks.pixels, error) &&
           write_pictures(making, &looks.pixels, arguments[5], error);
    if (done) {
        print_starter(making);
        print_signs(making, &looks);
    }
    image_free(&looks.pixels);
    return done;
}

static void making_free(struct making *making) {
    for (size_t i = 0; making->drawn != NULL && i < making->mistakes.count; i++) {
        image_free(&making->drawn[i]);
    }
    image_free(&making->reference);
    mistakes_free(&making->mistakes);
    free(making->looks);
    free(making->drawn);
    free(making->rows);
    free(making->places);
    free(making->is_kept);
}

int main(int argc, char **argv) {
    if (argc != 7) {
        fprintf(stderr, "Usage: looks_make STEP SCENE REFERENCE.png LIST DIRECTORY LOOKS\n");
        return 2;
    }
    char **arguments = argv + 1;
    struct making making = {.step = arguments[0], .scene = arguments[1]};
    struct error error;
    bool done = make(&making, arguments, &error);
    if (!done) {
        fprintf(stderr, "looks_make: %s\n", error.message);
    }
    making_free(&making);
    return done ? 0 : 1;
}
