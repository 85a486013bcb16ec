#include "figures.h"

#include "files/model_file.h"
#include "files/png.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifndef COURSE_BUILD
#define COURSE_BUILD "build"
#endif

/* ---- Saving ---- */

char *figure_path(const char *directory, const char *name, struct error *error) {
    size_t size = strlen(directory) + strlen(name) + sizeof "/.png";
    char *path = malloc(size);
    if (path == NULL) {
        error_out_of_memory(error);
        return NULL;
    }
    snprintf(path, size, "%s/%s.png", directory, name);
    return path;
}

bool figure_save(const struct image *image, const char *directory, const char *name,
                 struct error *error) {
    char *path = figure_path(directory, name, error);
    bool done = path != NULL && png_write(image, path, error);
    free(path);
    return done;
}

struct detail detail_of_whole(const struct image *image, int zoom, int grid) {
    return (struct detail){
        .width = (int)image->width, .height = (int)image->height, .zoom = zoom, .grid = grid};
}

/* Copy a detail into an image, with its bottom-left corner at (left, bottom). */
static void copy_detail(struct image *to, int left, int bottom, const struct image *from,
                        struct detail d) {
    for (int y = 0; y < d.height * d.zoom; y++) {
        for (int x = 0; x < d.width * d.zoom; x++) {
            bool line = d.grid > 0 && (x % d.zoom == 0 || y % d.zoom == 0);
            struct color color = line ? color_grey((uint8_t)d.grid)
                                      : image_get(from, d.x + x / d.zoom, d.y + y / d.zoom);
            image_set(to, left + x, bottom + y, color);
        }
    }
}

bool figure_save_detail(const struct image *image, struct detail detail, const char *directory,
                        const char *name, struct error *error) {
    struct image large;
    size_t width = (size_t)(detail.width * detail.zoom);
    size_t height = (size_t)(detail.height * detail.zoom);
    if (!image_create(&large, width, height, image->format, error)) {
        return false;
    }
    copy_detail(&large, 0, 0, image, detail);
    bool done = figure_save(&large, directory, name, error);
    image_free(&large);
    return done;
}

/* ---- Panels side by side ---- */

bool sheet_create(struct sheet *s, struct error *error) {
    size_t width = s->columns * (s->width + s->gap) - s->gap;
    size_t height = s->rows * (s->height + s->gap) - s->gap;
    enum image_format format = s->format != 0 ? s->format : IMAGE_BGR;
    if (!image_create(&s->panel, s->width, s->height, format, error) ||
        !image_create(&s->image, width, height, format, error)) {
        return false;
    }
    image_clear(&s->image, color_grey(255));
    return true;
}

void sheet_free(struct sheet *sheet) {
    image_free(&sheet->panel);
    image_free(&sheet->image);
}

void sheet_add_detail(struct sheet *s, const struct image *image, struct detail detail) {
    size_t column = s->count % s->columns, rows_below = s->rows - 1 - s->count / s->columns;
    copy_detail(&s->image, (int)(column * (s->width + s->gap)),
                (int)(rows_below * (s->height + s->gap)), image, detail);
    s->count++;
}

void sheet_add(struct sheet *sheet) {
    sheet_add_detail(sheet, &sheet->panel, detail_of_whole(&sheet->panel, 1, 0));
    image_clear(&sheet->panel, color_grey(0));
}

bool sheet_end(struct sheet *sheet, bool done, const char *directory, const char *name,
               struct error *error) {
    done = done && figure_save(&sheet->image, directory, name, error);
    sheet_free(sheet);
    return done;
}

/* ---- Two versions of one picture ---- */

size_t different_pixels(const struct image *a, const struct image *b) {
    size_t different = 0, size = a->format;
    for (size_t i = 0; i < a->width * a->height; i++) {
        different += memcmp(a->pixels + i * size, b->pixels + i * size, size) != 0;
    }
    return different;
}

bool comparison_create(struct comparison *comparison, size_t width, size_t height,
                       struct error *error) {
    *comparison = (struct comparison){0};
    return image_create(&comparison->first, width, height, IMAGE_GREY, error) &&
           image_create(&comparison->second, width, height, IMAGE_GREY, error) &&
           image_create(&comparison->shown, width, height, IMAGE_BGR, error);
}

void comparison_free(struct comparison *comparison) {
    image_free(&comparison->first);
    image_free(&comparison->second);
    image_free(&comparison->shown);
}

void comparison_show(struct comparison *c, struct color both) {
    for (int y = 0; y < (int)c->shown.height; y++) {
        for (int x = 0; x < (int)c->shown.width; x++) {
            bool in_first = image_get(&c->first, x, y).g != 0;
            bool in_second = image_get(&c->second, x, y).g != 0;
            if (in_first && in_second) {
                image_set(&c->shown, x, y, both);
                c->both++;
            } else if (in_first) {
                image_set(&c->shown, x, y, color_rgb(255, 150, 0));
                c->only_first++;
            } else if (in_second) {
                image_set(&c->shown, x, y, color_rgb(60, 160, 255));
                c->only_second++;
            }
        }
    }
}

/* ---- The program ---- */

/* The tables must have reached whoever reads them. */
static bool flush_tables(struct error *error) {
    return (fflush(stdout) == 0 && ferror(stdout) == 0) ||
           error_set(error, "cannot write to standard output");
}

int main(int argc, char **argv) {
    struct error error = {0};
    struct model bust = {0};
    if (argc != 2) {
        fprintf(stderr, "usage: %s OUTDIR\n", argv[0]);
        return 2;
    }
    bool done = model_read(&bust, COURSE_BUILD "/models/bust.obj", &error) &&
                draw_figures(argv[1], &bust, &error) && flush_tables(&error);
    model_free(&bust);
    if (!done) {
        fprintf(stderr, "%s: %s\n", argv[0], error.message);
    }
    return done ? 0 : 1;
}
