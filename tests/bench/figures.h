/*
 * What the figures.c of all lessons share. Each draws the pictures of its README that are not
 * references, and prints the numbers of its tables, as a program `figures OUTDIR`:
 *
 *     #include "figures.h"
 *
 *     #define LESSON "../step05_zbuffer/main.c"
 *     #include "lesson.h"
 *
 *     void draw_figures(struct model *bust) {
 *         ...
 *         figure_save(&image, "holes");
 *     }
 *
 * The main() is here: it reads the bust and calls draw_figures(). What fails ends the program, with
 * a message; and what a figure is made of is kept until then.
 */
#ifndef TESTS_BENCH_FIGURES_H
#define TESTS_BENCH_FIGURES_H

#include "base/error.h"
#include "model.h"
#include "tgaimage.h"

#include <stdbool.h>
#include <stddef.h>

/* Written by the lesson: save its figures. `bust` is the course's model; it may be changed. */
void draw_figures(struct model *bust);

/* Whatever fails says why in figure_error: figure_need(model_need_normals(bust, &figure_error)). */
extern struct error figure_error;
_Noreturn void figure_fail(void);

static inline void figure_need(bool done) {
    if (!done) {
        figure_fail();
    }
}

void *figure_memory(size_t count, size_t size);         /* all 0 */
struct image figure_image(size_t width, size_t height); /* IMAGE_BGR, black */

/* ---- Saving ---- */

/* "OUTDIR/NAME.png" */
const char *figure_path(const char *name);

/* Save an image there. */
void figure_save(const struct image *image, const char *name);

/* A part of an image in which every pixel is a block of `zoom` x `zoom`. */
struct detail {
    int x, y, width, height; /* pixels of the image */
    int zoom;                /* 1 or more */
    int grid;                /* grey level of the lines between the blocks; 0: none */
};

/* All of an image, enlarged. */
struct detail detail_of_whole(const struct image *image, int zoom, int grid);

void figure_save_detail(const struct image *image, struct detail detail, const char *name);

/* ---- Panels side by side ---- */

/* A figure of equal panels, filled row by row from the top left. Set the fields up to `format`,
 * then call sheet_create(). */
struct sheet {
    size_t width, height;     /* pixels of a panel */
    size_t columns, rows;     /* panels */
    size_t gap;               /* pixels between two panels, white */
    enum image_format format; /* 0 means IMAGE_BGR */
    struct image panel;       /* draw here, then call sheet_add(): it is black again afterwards */
    struct image image;       /* the figure */
    size_t count;             /* panels so far */
};

void sheet_create(struct sheet *sheet);

/* The next panel: what was drawn into `panel`, or a detail that fills a panel. */
void sheet_add(struct sheet *sheet);
void sheet_add_detail(struct sheet *sheet, const struct image *image, struct detail detail);

/* ---- Two versions of one picture ---- */

/* Pixels in which two images of one size and format differ. */
size_t different_pixels(const struct image *a, const struct image *b);

/* What two versions drew on black, and a picture of what differs. */
struct comparison {
    struct image first, second;           /* grey */
    struct image shown;                   /* black where neither drew */
    size_t both, only_first, only_second; /* pixels */
};

void comparison_create(struct comparison *comparison, size_t width, size_t height);

/* Count and show: orange where only the first version drew, blue where only the second one did. */
void comparison_show(struct comparison *comparison, struct color both);

#endif
