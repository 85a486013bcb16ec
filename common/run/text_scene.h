/*
 * Text scenes: what lessons 1 and 3 draw, written down by hand.
 *
 *     # a comment
 *     size 100 100
 *     line 13 20 80 40 255 255 255              x0 y0 x1 y1  r g b
 *     line 10 10 90 50 0 255 0  0 0 255         ... and the colour of the second end
 *     triangle 10 70 50 160 70 80 255 0 0       x0 y0 x1 y1 x2 y2  r g b
 *
 * `size` (1..16384 each) comes at most once, before anything that is drawn. A scene of lines
 * has whole-number coordinates; a scene of triangles may have fractions, and takes one colour or
 * three. Coordinates lie in -1,000,000..1,000,000, colours are whole numbers 0..255.
 */
#ifndef COMMON_RUN_TEXT_SCENE_H
#define COMMON_RUN_TEXT_SCENE_H

#include "base/error.h"
#include "tgaimage.h"

#include <stdbool.h>
#include <stddef.h>

enum {
    TEXT_SCENE_SIZE_LIMIT = 16384,        /* pixels of a side */
    TEXT_SCENE_COORDINATE_LIMIT = 1000000 /* pixels, both ways */
};

enum text_scene_kind { TEXT_SCENE_LINES, TEXT_SCENE_TRIANGLES };

/* A line uses the first two corners. Where one colour is given, all are equal. */
struct text_scene_shape {
    double x[3], y[3]; /* in the order of the file */
    struct color color[3];
};

/* All zero is a valid, empty scene. */
struct text_scene {
    size_t width, height; /* both 0 when the file has no `size` */
    struct text_scene_shape *shapes;
    size_t shape_count;
};

/* Read a scene of one kind; "-" is standard input. On an error the scene is empty and the message
 * reads "scene.txt:3: 'line' takes 7 or 10 numbers, not 5". */
bool text_scene_read(struct text_scene *scene, const char *path, enum text_scene_kind kind,
                     struct error *error);

/* Read a scene from memory; the message begins with the line's number. */
bool text_scene_decode(struct text_scene *scene, const void *data, size_t size,
                       enum text_scene_kind kind, struct error *error);

/* Free the shapes and leave an empty scene. */
void text_scene_free(struct text_scene *scene);

#endif
