/*
 * Keeps what the known mistakes look like (looks.h says how): what `make mistakes` calls.
 *
 *     looks_make [-m] STEP SCENE REFERENCE.png LIST DIRECTORY LOOKS
 *
 * LIST has a line for each mistake: its number, its task or -, its figure or 0, what it is, with
 * tabs between; and one for the starter (LOOKS_STARTER).
 * DIRECTORY/NUMBER/SCENE.png is what it draws, when it draws something wrong there. Writes
 * LOOKS/STEP/SCENE.png, .txt and .small.png, or removes them where no mistake can be told. With -m
 * it also prints, for each mistake of its own picture, what it would look like if it were not
 * known: a wrong diagnosis.
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

struct mistake {
    char task[TASK_NAME_LIMIT], words[LOOKS_WORDS_LIMIT];
    unsigned figure; /* 0: none */
    size_t row;      /* 0: nothing can be told */
    uint64_t apart;  /* from the reference */
    struct image image;
};

struct making {
    const char *step, *scene;
    struct image reference;
    struct mistake *mistakes;
    size_t count, capacity;
    size_t *rows; /* the number of the first mistake with that picture, by row */
    size_t row_count;
    struct place *places;
    size_t place_count, place_capacity;
    unsigned char *is_kept; /* by pixel of the picture */
};

static bool is_starter(const struct mistake *mistake) {
    return strcmp(mistake->words, LOOKS_STARTER) == 0;
}

static bool are_apart(const struct image *a, const struct image *b, size_t x, size_t y,
                      int levels) {
    struct color p = image_get(a, (int)x, (int)y), q = image_get(b, (int)x, (int)y);
    return abs(p.r - q.r) > levels || abs(p.g - q.g) > levels || abs(p.b - q.b) > levels;
}

/* ---- Reading ---- */

static bool add_mistake(struct making *making, const char *directory, const char *line,
                        struct error *error) {
    char place[DRAWN_PATH_LIMIT], task[TASK_NAME_LIMIT], words[LOOKS_WORDS_LIMIT];
    unsigned long number;
    unsigned figure;
    struct error ignored;
    if (sscanf(line, "%lu\t%11s\t%4u\t%159[^\n]", &number, task, &figure, words) != 4) {
        return error_set(error, "not the line of a mistake: %.200s", line);
    }
    struct mistake *mistakes =
        array_reserve(making->mistakes, &making->capacity, making->count + 1, sizeof *mistakes);
    if (mistakes == NULL) {
        return error_out_of_memory(error);
    }
    making->mistakes = mistakes;
    struct mistake *mistake = &mistakes[making->count++];
    *mistake = (struct mistake){.figure = figure};
    memcpy(mistake->task, task, sizeof task);
    memcpy(mistake->words, words, sizeof words);
    snprintf(place, sizeof place, "%s/%lu/%s.png", directory, number, making->scene);
    bool is_drawn = image_read(&mistake->image, place, &ignored);
    if (is_drawn && (mistake->image.width != making->reference.width ||
                     mistake->image.height != making->reference.height)) {
        image_free(&mistake->image);
    }
    return true;
}

static bool read_mistakes(struct making *making, const char *list, const char *directory,
                          struct error *error) {
    FILE *file = fopen(list, "r");
    char line[1024];
    bool done = file != NULL || error_set(error, "%s: cannot be read", list);
    while (done && fgets(line, sizeof line, file) != NULL) {
        done = add_mistake(making, directory, line, error);
    }
    if (file != NULL) {
        fclose(file);
    }
    return done;
}

/* Are they the same picture to looks_find()? It tells those that are near the reference (none of
 * their pixels is apart) only when they are equal. */
static bool are_same(const struct mistake *a, const struct mistake *b) {
    struct comparison found = compare_images(&a->image, &b->image);
    return a->apart > 0 && b->apart > 0 ? found.apart.count == 0 : found.differing.count == 0;
}

/* Give each picture a row, the same picture the same one. */
static void find_rows(struct making *making) {
    for (size_t i = 0; i < making->count; i++) {
        struct mistake *mistake = &making->mistakes[i];
        if (mistake->image.pixels == NULL || image_is_blank(&mistake->image)) {
            continue;
        }
        struct comparison found = compare_images(&making->reference, &mistake->image);
        bool is_shown = found.apart.count > 0 || found.near.count * LEAST_NEAR >= found.drawn;
        mistake->apart = found.apart.count;
        for (size_t k = 0; k < making->row_count && is_shown && mistake->row == 0; k++) {
            if (are_same(&making->mistakes[making->rows[k]], mistake)) {
                mistake->row = LOOKS_FIRST_ROW + k;
            }
        }
        if (is_shown && mistake->row == 0) {
            making->rows[making->row_count] = i;
            mistake->row = LOOKS_FIRST_ROW + making->row_count++;
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
    return &making->mistakes[making->rows[row]].image;
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

static bool write_list(const struct making *making, const char *path, struct error *error) {
    char line[LOOKS_WORDS_LIMIT + 64];
    struct bytes text = {.data = NULL};
    snprintf(line, sizeof line, "# Made by `make mistakes`: see tests/check/looks.h.\n");
    bool done = bytes_append(&text, line, strlen(line));
    for (size_t i = 0; i < making->count && done; i++) {
        const struct mistake *mistake = &making->mistakes[i];
        snprintf(line, sizeof line, "%zu %llu %s %u %s\n", mistake->row,
                 (unsigned long long)mistake->apart, mistake->task, mistake->figure,
                 mistake->words);
        done = bytes_append(&text, line, strlen(line));
    }
    return file_write_encoded(path, done, &text, error);
}

struct paths {
    char directory[DRAWN_PATH_LIMIT];
    char pixels[DRAWN_PATH_LIMIT + 80], list[DRAWN_PATH_LIMIT + 80];
    struct result_path small;
};

static struct paths find_paths(const struct making *making, const char *looks) {
    struct paths paths;
    snprintf(paths.directory, sizeof paths.directory, "%s/%s", looks, making->step);
    snprintf(paths.pixels, sizeof paths.pixels, "%s/%s.png", paths.directory, making->scene);
    snprintf(paths.list, sizeof paths.list, "%s/%s.txt", paths.directory, making->scene);
    paths.small = looks_small_path(looks, making->step, making->scene);
    return paths;
}

/* What cannot be told by looks_find() itself has no row in the list. */
static void forget_untold(struct making *making, const char *directory) {
    struct looks looks;
    looks_read(&looks, directory, making->step, making->scene);
    for (size_t i = 0; i < making->count; i++) {
        struct mistake *mistake = &making->mistakes[i];
        if (mistake->row > 0 && !is_starter(mistake) &&
            looks_find(&looks, &making->reference, &mistake->image, mistake->apart, 0).row !=
                mistake->row) {
            mistake->row = 0;
        }
    }
    looks_free(&looks);
}

static bool write_looks(struct making *making, const char *directory, struct error *error) {
    struct paths paths = find_paths(making, directory);
    struct image pixels = {.pixels = NULL}, small = {.pixels = NULL};
    if (making->row_count == 0) {
        unlink(paths.pixels);
        unlink(paths.list);
        unlink(paths.small.text);
        return true;
    }
    bool done = directory_create(paths.directory, error) && make_pixels(making, &pixels, error) &&
                png_write(&pixels, paths.pixels, error) && write_list(making, paths.list, error) &&
                make_small(making, &small, error) && png_write(&small, paths.small.text, error);
    image_free(&pixels);
    image_free(&small);
    if (done) {
        forget_untold(making, directory);
        done = write_list(making, paths.list, error);
    }
    return done;
}

/* ---- Wrong diagnoses ---- */

/* Say what each mistake would look like if it were not known. */
static void measure(const struct making *making, const char *directory) {
    struct looks looks;
    looks_read(&looks, directory, making->step, making->scene);
    for (size_t i = 0; i < making->row_count; i++) {
        const struct mistake *mistake = &making->mistakes[making->rows[i]];
        struct likeness other = looks_find(&looks, &making->reference, &mistake->image,
                                           mistake->apart, LOOKS_FIRST_ROW + i);
        struct item_result item = {.scene = making->scene};
        looks_tell(&item, &looks, other.row, NULL, NULL);
        printf("%s %s: %s: %s%s%s\n", making->step, making->scene, mistake->words,
               mistake->row > 0 ? "itself" : "not told",
               other.row == 0 ? "" : "; held out: ", item.looks.text);
    }
    looks_free(&looks);
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
    making->rows = calloc(making->count + 1, sizeof *making->rows);
    if (making->is_kept == NULL || making->rows == NULL) {
        return error_out_of_memory(error);
    }
    find_rows(making);
    return choose_places(making) ? write_looks(making, arguments[5], error)
                                 : error_out_of_memory(error);
}

int main(int argc, char **argv) {
    bool is_measured = argc > 1 && strcmp(argv[1], "-m") == 0;
    char **arguments = argv + (is_measured ? 2 : 1);
    if (argc != (is_measured ? 8 : 7)) {
        fprintf(stderr, "Usage: looks_make [-m] STEP SCENE REFERENCE.png LIST DIRECTORY LOOKS\n");
        return 2;
    }
    struct making making = {.step = arguments[0], .scene = arguments[1]};
    struct error error;
    bool done = make(&making, arguments, &error);
    if (!done) {
        fprintf(stderr, "looks_make: %s\n", error.message);
    } else if (is_measured) {
        measure(&making, arguments[5]);
    }
    for (size_t i = 0; i < making.count; i++) {
        image_free(&making.mistakes[i].image);
    }
    image_free(&making.reference);
    free(making.mistakes);
    free(making.rows);
    free(making.places);
    free(making.is_kept);
    return done ? 0 : 1;
}
