/*
 * What the figures.c of all lessons share. Each draws the pictures of its README that are not
 * references, and prints the numbers of its tables, as a program `figures OUTDIR`:
 *
 *     #include "figures.h"
 *
 *     #define LESSON "../step05_zbuffer/main.c"
 *     #include "lesson.h"
 *
 *     bool draw_figures(const char *directory, struct model *bust, struct error *error) {
 *         ...
 *         return figure_save(&image, directory, "holes", error);
 *     }
 *
 * The main() is here: it reads the bust, calls draw_figures() and says what failed.
 */
#ifndef TESTS_FIGURES_H
#define TESTS_FIGURES_H

#include "base/error.h"
#include "model.h"
#include "tgaimage.h"

#include <stdbool.h>
#include <stddef.h>

/* Written by the lesson: save its figures as DIRECTORY/NAME.png. `bust` is the course's model; it
 * may be changed, and is freed afterwards. */
bool draw_figures(const char *directory, struct model *bust, struct error *error);

/* ---- Saving ---- */

/* "DIRECTORY/NAME.png", to be freed by the caller; NULL when memory runs out. */
char *figure_path(const char *directory, const char *name, struct error *error);

/* Save an image as DIRECTORY/NAME.png. */
bool figure_save(const struct image *image, const char *directory, const char *name,
                 struct error *error);

/* A part of an image in which every pixel is a block of `zoom` x `zoom`. */
struct detail {
    int x, y, width, height; /* pixels of the image */
    int zoom;                /* 1 or more */
    int grid;                /* grey level of the lines between the blocks; 0: none */
};

/* All of an image, enlarged. */
struct detail detail_of_whole(const struct image *image, int zoom, int grid);

bool figure_save_detail(const struct image *image, struct detail detail, const char *directory,
                        const char *name, struct error *error);

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

/* False when memory runs out; sheet_free() must be called even then. */
bool sheet_create(struct sheet *sheet, struct error *error);
void sheet_free(struct sheet *sheet);

/* The next panel: what was drawn into `panel`, or a detail that fills a panel. */
void sheet_add(struct sheet *sheet);
void sheet_add_detail(struct sheet *sheet, const struct image *image, struct detail detail);

/* Save the figure if all panels are `done`, and free it either way. */
bool sheet_end(struct sheet *sheet, bool done, const char *directory, const char *name,
               struct error *error);

/* ---- Two versions of one picture ---- */

/* Pixels in which two images of one size and format differ. */
size_t different_pixels(const struct image *a, const struct image *b);

/* What two versions drew on black, and a picture of what differs. */
struct comparison {
    struct image first, second;           /* grey */
    struct image shown;                   /* black where neither drew */
    size_t both, only_first, only_second; /* pixels */
};

/* False when memory runs out; comparison_free() must be called even then. */
bool comparison_create(struct comparison *comparison, size_t width, size_t height,
                       struct error *error);
void comparison_free(struct comparison *comparison);

/* Count and show: orange where only the first version drew, blue where only the second one did. */
void comparison_show(struct comparison *comparison, struct color both);

#endif
