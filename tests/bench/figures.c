#include "figures.h"

#include "files/model_file.h"
#include "files/png.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct error figure_error;
static const char *program, *directory;

void figure_fail(void) {
    fprintf(stderr, "%s: %s\n", program, figure_error.message);
    exit(1);
}

void *figure_memory(size_t count, size_t size) {
    void *memory = calloc(count, size);
    figure_need(memory != NULL || error_out_of_memory(&figure_error));
    return memory;
}

static struct image new_image(size_t width, size_t height, enum image_format format) {
    struct image image;
    figure_need(image_create(&image, width, height, format, &figure_error));
    return image;
}

struct image figure_image(size_t width, size_t height) {
    return new_image(width, height, IMAGE_BGR);
}

/* ---- Saving ---- */

const char *figure_path(const char *name) {
    static char path[1024];
    int length = snprintf(path, sizeof path, "%s/%s.png", directory, name);
    figure_need(length < (int)sizeof path ||
                error_set(&figure_error, "%s: the name is too long", directory));
    return path;
}

void figure_save(const struct image *image, const char *name) {
    figure_need(png_write(image, figure_path(name), &figure_error));
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

void figure_save_detail(const struct image *image, struct detail detail, const char *name) {
    size_t width = (size_t)(detail.width * detail.zoom);
    size_t height = (size_t)(detail.height * detail.zoom);
    struct image large = new_image(width, height, image->format);
    copy_detail(&large, 0, 0, image, detail);
    figure_save(&large, name);
}

/* ---- Panels side by side ---- */

void sheet_create(struct sheet *s) {
    size_t width = s->columns * (s->width + s->gap) - s->gap;
    size_t height = s->rows * (s->height + s->gap) - s->gap;
    enum image_format format = s->format != 0 ? s->format : IMAGE_BGR;
    s->panel = new_image(s->width, s->height, format);
    s->image = new_image(width, height, format);
    image_clear(&s->image, color_grey(255));
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

/* ---- Two versions of one picture ---- */

size_t different_pixels(const struct image *a, const struct image *b) {
    size_t different = 0, size = a->format;
    for (size_t i = 0; i < a->width * a->height; i++) {
        different += memcmp(a->pixels + i * size, b->pixels + i * size, size) != 0;
    }
    return different;
}

void comparison_create(struct comparison *comparison, size_t width, size_t height) {
    *comparison = (struct comparison){.first = new_image(width, height, IMAGE_GREY),
                                      .second = new_image(width, height, IMAGE_GREY),
                                      .shown = new_image(width, height, IMAGE_BGR)};
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

int main(int argc, char **argv) {
    struct model bust;
    if (argc != 2) {
        fprintf(stderr, "usage: %s OUTDIR\n", argv[0]);
        return 2;
    }
    program = argv[0];
    directory = argv[1];
    figure_need(model_read(&bust, COURSE_BUILD "/models/bust.obj", &figure_error));
    draw_figures(&bust);
    /* The tables must have reached whoever reads them. */
    figure_need((fflush(stdout) == 0 && ferror(stdout) == 0) ||
                error_set(&figure_error, "cannot write to standard output"));
    return 0;
}
