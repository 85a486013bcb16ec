/*
 * Makes the picture of a mistake for its lesson's table of wrong pictures (wrong_figure.h): what
 * `make mistakes` calls, and `make verify` to see if it is out of date.
 *
 *     figure_make REFERENCE.png WRONG.png PART FIGURE.png
 *
 * PART is as 60x40+10+20, or auto.
 *
 * Exit status: 0 done, 1 something cannot be read, shown or written, 2 wrong usage.
 */
#include "files/image_file.h"
#include "files/png.h"
#include "wrong_figure.h"

#include <stdio.h>

static bool make_figure(char **arguments, struct error *error) {
    struct image reference = {.pixels = NULL}, wrong = {.pixels = NULL}, figure = {.pixels = NULL};
    struct figure_area area;
    bool done = figure_area_read(&area, arguments[2], error) &&
                image_read(&reference, arguments[0], error) &&
                image_read(&wrong, arguments[1], error) &&
                wrong_figure(&figure, &reference, &wrong, area, error) &&
                png_write(&figure, arguments[3], error);
    image_free(&reference);
    image_free(&wrong);
    image_free(&figure);
    return done;
}

int main(int argc, char **argv) {
    struct error error;
    if (argc != 5) {
        fprintf(stderr, "Usage: figure_make REFERENCE.png WRONG.png PART FIGURE.png\n");
        return 2;
    }
    if (!make_figure(argv + 1, &error)) {
        fprintf(stderr, "figure_make: %s\n", error.message);
        return 1;
    }
    return 0;
}
