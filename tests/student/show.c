/*
 * Shows the pictures of a scene in the terminal: yours, the reference, and their difference.
 *
 *     show COLUMNS LINES STEP SCENE WHICH KIND YOURS REFERENCE
 *
 * COLUMNS and LINES are the terminal's. STEP and SCENE, which may be empty, are for the title, and
 * say what counts as wrong in the difference: what the check counts. The title says whether yours
 * is exact; then there is no difference to show. WHICH is a list like yours,difference; where it is
 * empty, all are shown that have room side by side, and yours and the difference at least. KIND is
 * blocks or kitty; where it is empty, what the terminal can. The last two are image files;
 * one that does not exist is left out.
 *
 * As many pictures are side by side as have 50 characters each, the others below. A large one is
 * shrunk to fit, and keeps what is drawn, even a single pixel; a small one is enlarged by a whole
 * number, so that its pixels are squares. Where a large one is wrong and WHICH is empty, its part
 * around the first wrong pixel is shown.
 *
 * Exit status: 0 shown, 1 a file cannot be read or nothing is there, 2 wrong usage.
 */
#include "check/page/pictures.h"
#include "terminal.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    STATUS_FAILED = 1,
    STATUS_USAGE = 2,
    ARGUMENTS = 9,      /* with the program's name */
    LEAST_COLUMNS = 50, /* characters of a picture next to others */
    GAP = 2,            /* characters between two pictures */
    KEPT_LINES = 5,     /* of the terminal: title, names, put_hint(), the prompt */
    SIZE_LIMIT = 2000,  /* characters of a line, lines of a terminal */
    CELL_WIDTH = 8,     /* pixels of a character where pictures have pixels of their own */
    CELL_HEIGHT = 16
};

struct options {
    size_t columns, lines; /* of the terminal */
    const char *step, *scene;
    bool is_chosen;             /* by WHICH: */
    bool wanted[PICTURE_COUNT]; /* these */
    enum terminal_kind kind;
    const char *yours, *reference;
};

/* ---- Arguments ---- */

static bool parse_size(const char *text, size_t *size) {
    char *end;
    unsigned long value = strtoul(text, &end, 10);
    *size = (size_t)value;
    return text[0] >= '1' && text[0] <= '9' && *end == '\0' && value <= SIZE_LIMIT;
}

static bool parse_kind(const char *text, enum terminal_kind *kind) {
    static const char *const names[] = {"blocks", "kitty"};
    if (text[0] == '\0') {
        *kind = terminal_find_kind();
        return true;
    }
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        if (strcmp(text, names[i]) == 0) {
            *kind = (enum terminal_kind)i;
            return true;
        }
    }
    return false;
}

/* Names with commas between them. */
static bool parse_which(const char *list, struct options *options) {
    for (const char *at = list; at != NULL; at = strchr(at, ',')) {
        int picture = 0;
        at += *at == ',';
        size_t length = strcspn(at, ",");
        while (picture < PICTURE_COUNT && (strlen(picture_names[picture]) != length ||
                                           strncmp(at, picture_names[picture], length) != 0)) {
            picture++;
        }
        if (picture == PICTURE_COUNT) {
            return false;
        }
        options->wanted[picture] = options->is_chosen = true;
    }
    return true;
}

static bool parse_arguments(int argc, char **argv, struct options *options, struct error *error) {
    if (argc != ARGUMENTS) {
        return error_set(error, "wants COLUMNS LINES STEP SCENE WHICH KIND YOURS REFERENCE");
    }
    *options =
        (struct options){.step = argv[3], .scene = argv[4], .yours = argv[7], .reference = argv[8]};
    if (!parse_size(argv[1], &options->columns) || !parse_size(argv[2], &options->lines)) {
        return error_set(error, "no terminal has %.40s columns and %.40s lines", argv[1], argv[2]);
    }
    if (argv[5][0] != '\0' && !parse_which(argv[5], options)) {
        return error_set(error, "WHICH=%.40s is none of yours,reference,difference", argv[5]);
    }
    return parse_kind(argv[6], &options->kind) ||
           error_set(error, "KIND=%.40s is none of blocks, kitty", argv[6]);
}

/* ---- The size of a picture ---- */

struct room {
    size_t width, height; /* pixels */
};

/* Pixels of a character: half blocks are two, one above the other. */
static struct room cell_of(enum terminal_kind kind) {
    return kind == TERMINAL_BLOCKS ? (struct room){1, 2} : (struct room){CELL_WIDTH, CELL_HEIGHT};
}

static struct room room_for(const struct options *options, size_t beside) {
    struct room cell = cell_of(options->kind);
    size_t columns = options->columns > GAP * (beside - 1) ? options->columns - GAP * (beside - 1)
                                                           : options->columns;
    size_t lines = options->lines > KEPT_LINES ? options->lines - KEPT_LINES : 1;
    size_t width = columns / beside > 0 ? columns / beside : 1;
    return (struct room){width * cell.width, lines * cell.height};
}

static size_t smaller(size_t a, size_t b) {
    return a < b ? a : b;
}

static size_t larger(size_t a, size_t b) {
    return a > b ? a : b;
}

/* `fitted` becomes the image in the size in which it fills the room: enlarged by a whole number. */
static bool fit(struct image *fitted, const struct image *image, struct room room,
                struct error *error) {
    size_t times = smaller(room.width / image->width, room.height / image->height);
    size_t width = image->width * times, height = image->height * times;
    if (times == 0) {
        width = room.width;
        height = image->height * room.width / image->width;
    }
    if (height > room.height) {
        width = image->width * room.height / image->height;
        height = room.height;
    }
    return picture_resize(fitted, image, larger(width, 1), larger(height, 1), error);
}

/* ---- Pictures side by side ---- */

/* Lay the panel on the sheet, from column x on, at its upper edge. */
static void put_panel(struct image *sheet, const struct image *panel, size_t left) {
    for (size_t y = 0; y < panel->height; y++) {
        size_t to = sheet->height - panel->height + y;
        for (size_t x = 0; x < panel->width; x++) {
            image_set(sheet, (int)(left + x), (int)to, image_get(panel, (int)x, (int)y));
        }
    }
}

/* Append the panels' names, each above its panel, then the panels. */
static bool show_sheet(struct bytes *out, const struct image *panels, const char *const *names,
                       size_t count, enum terminal_kind kind, struct error *error) {
    struct room cell = cell_of(kind);
    struct image sheet;
    size_t width = 0, height = 0, column = 0;
    bool done = true;
    for (size_t i = 0; i < count; i++) {
        size_t columns = (panels[i].width + cell.width - 1) / cell.width + GAP;
        int field = i + 1 < count ? (int)columns : 0;
        char name[SIZE_LIMIT + 32];
        int length = snprintf(name, sizeof name, "%-*s", field, names[i]);
        done = done && bytes_append(out, name, (size_t)length);
        width += i + 1 < count ? columns * cell.width : panels[i].width;
        height = larger(height, panels[i].height);
    }
    if (!done || !bytes_append(out, "\n", 1)) {
        return error_out_of_memory(error);
    }
    if (!image_create(&sheet, width, height, IMAGE_BGR, error)) {
        return false;
    }
    for (size_t i = 0; i < count; i++) {
        put_panel(&sheet, &panels[i], column * cell.width);
        column += (panels[i].width + cell.width - 1) / cell.width + GAP;
    }
    done = terminal_show(out, &sheet, kind, (width + cell.width - 1) / cell.width, error);
    image_free(&sheet);
    return done;
}

/* ---- Which pictures, and how many side by side ---- */

static bool is_exact(const struct pictures *pictures) {
    return pictures->same_size && pictures->differing == 0;
}

static size_t fitting(const struct options *options) {
    size_t beside = (options->columns + GAP) / (LEAST_COLUMNS + GAP);
    return beside > 0 ? beside : 1;
}

/* The title says that a picture is exact: there is no difference to draw. Without a choice the
 * reference is left out where three have no room, since the difference has a shade of it. */
static bool is_chosen(const struct options *options, const struct pictures *pictures, int picture) {
    bool differs = pictures->image[PICTURE_DIFFERENCE].width > 0 && !is_exact(pictures);
    if (picture == PICTURE_DIFFERENCE && !differs) {
        return false;
    }
    if (options->is_chosen) {
        return options->wanted[picture];
    }
    return picture != PICTURE_REFERENCE || !differs || fitting(options) >= PICTURE_COUNT;
}

/* ---- A part of them ---- */

/* Where a part of that length begins which has the pixel in its middle, if it lies in the image. */
static int part_begin(int pixel, size_t length, size_t size) {
    int begin = pixel - (int)(length / 2), last = (int)size - (int)length;
    begin = begin < last ? begin : last;
    return begin > 0 ? begin : 0;
}

/* Would all of it be shrunk, and a few wrong pixels with it? (Two sizes are wrong as such.) */
static bool wants_part(const struct pictures *pictures, const struct options *options,
                       struct room room) {
    const struct image *yours = &pictures->image[PICTURE_YOURS];
    return pictures->fails && !options->is_chosen && pictures->same_size &&
           pictures->differing < room.width * room.height &&
           (yours->width > room.width || yours->height > room.height);
}

/* ---- The scene ---- */

/* "step05_zbuffer depth: 214 pixels differ ..."; with one picture alone nothing is said of it. */
static bool put_title(struct bytes *out, const struct pictures *pictures,
                      const struct options *options) {
    bool both = pictures->image[PICTURE_DIFFERENCE].width > 0;
    return bytes_print(out, "%s %s%s%s\n", options->step, options->scene, both ? ": " : "",
                       both ? pictures_describe(pictures).text : "");
}

/* What is not seen of them, and how to see it. */
static bool put_hint(struct bytes *out, const struct pictures *pictures, const struct image *part,
                     int left, int bottom) {
    return (part == NULL ||
            bytes_print(out, "Only x %d to %zu, y %d to %zu: (%d,%d) is the first wrong pixel.\n",
                        left, (size_t)left + part->width - 1, bottom,
                        (size_t)bottom + part->height - 1, pictures->wrong_x, pictures->wrong_y)) &&
           bytes_print(out, "WHICH=yours,reference,difference shows all of them.\n");
}

/* The chosen pictures or, where shrinking would hide a few wrong pixels, their part around them. */
static bool show_chosen(struct bytes *out, const struct pictures *pictures, const int *chosen,
                        size_t count, const struct options *options, struct error *error) {
    struct image panels[PICTURE_COUNT] = {{.pixels = NULL}};
    const char *names[PICTURE_COUNT];
    size_t beside = smaller(count, fitting(options));
    struct room room = room_for(options, beside);
    const struct image *reference = &pictures->image[PICTURE_REFERENCE];
    int left = part_begin(pictures->wrong_x, room.width, reference->width);
    int bottom = part_begin(pictures->wrong_y, room.height, reference->height);
    bool part = wants_part(pictures, options, room), done = true;
    for (size_t i = 0; i < count && done; i++) {
        const struct image *image = &pictures->image[chosen[i]];
        names[i] = picture_names[chosen[i]];
        done = part ? picture_part(&panels[i], image, (size_t)left, (size_t)bottom, 1, room.width,
                                   room.height, error)
                    : fit(&panels[i], image, room, error);
    }
    for (size_t i = 0; i < count && done; i += beside) {
        done = show_sheet(out, panels + i, names + i, smaller(beside, count - i), options->kind,
                          error);
    }
    bool hidden = !options->is_chosen && count < PICTURE_COUNT && reference->width > 0 &&
                  chosen[count - 1] == PICTURE_DIFFERENCE;
    if (done && (part || hidden)) {
        done = put_hint(out, pictures, part ? &panels[0] : NULL, left, bottom) ||
               error_out_of_memory(error);
    }
    for (size_t i = 0; i < PICTURE_COUNT; i++) {
        image_free(&panels[i]);
    }
    return done;
}

static bool show(struct bytes *out, const struct options *options, struct error *error) {
    struct pictures pictures;
    int chosen[PICTURE_COUNT];
    size_t count = 0;
    struct scene_table table;
    const struct checked_item *rule = pictures_rule(&table, options->step, options->scene);
    bool done = pictures_read(&pictures, options->yours, options->reference, rule, error);
    scene_table_free(&table);
    if (!done) {
        return false;
    }
    for (int i = 0; i < PICTURE_COUNT; i++) {
        if (pictures.image[i].width > 0 && is_chosen(options, &pictures, i)) {
            chosen[count++] = i;
        }
    }
    if (count == 0 && !is_exact(&pictures)) {
        done =
            error_set(error, "no such picture: %.400s, %.400s", options->yours, options->reference);
    }
    done = done && (options->step[0] == '\0' || put_title(out, &pictures, options) ||
                    error_out_of_memory(error));
    done = done && (count == 0 || show_chosen(out, &pictures, chosen, count, options, error));
    pictures_free(&pictures);
    return done;
}

int main(int argc, char **argv) {
    struct options options = {.step = "", .scene = ""};
    struct bytes out = {.data = NULL};
    struct error error;
    if (!parse_arguments(argc, argv, &options, &error)) {
        fprintf(stderr, "show: %s\n", error.message);
        return STATUS_USAGE;
    }
    bool done = show(&out, &options, &error);
    if (done && (fwrite(out.data, 1, out.size, stdout) != out.size || fflush(stdout) != 0)) {
        done = error_set(&error, "cannot write to standard output");
    }
    bytes_free(&out);
    if (!done) {
        fprintf(stderr, "show: %s\n", error.message);
        return STATUS_FAILED;
    }
    return EXIT_SUCCESS;
}
