/* Lesson 1 under the mouse: lines of your own, by line() or an attempt, and what is wrong there. */
#ifndef LESSON
#define LESSON "../step01_line/main.c"
#endif
#include "more_scenes.h"

#include "../../../step01_line/attempts.h"

static const struct scene_value live_text_values[] = {
    {"attempt",
     "0 line(), 1 a hundred steps, 2 ten steps, 3 a step for each column, 4 swapped, "
     "5 division outside, 6 added up, 7 in two parts, 8 by cases, 9 by runs, 10 t += dt, "
     "11 t in whole numbers",
     0, 11, 1, 0},
    {"reversed", "from the second end to the first", 0, 1, 1, 0},
    {"wrong", "red is wrong, blue is missing", 0, 1, 1, 0},
    {"steps", "share of the line that is drawn", 0, 1, 0.01, 1},
    {.name = NULL},
};

static struct pixel live_end(const struct text_scene_shape *shape, int end) {
    return (struct pixel){(int)shape->x[end], (int)shape->y[end]};
}

/* ---- A line, or its first steps ---- */

static bool live_whole(const struct drawing *drawing, struct image *image,
                       const struct text_scene_shape *shape, struct error *error) {
    const int first = (int)drawing_value(drawing, "reversed"), last = 1 - first;
    const struct pixel a = live_end(shape, first), b = live_end(shape, last);
    const int attempt = (int)drawing_value(drawing, "attempt");
    if (attempt == 0) {
        return draw_ends(image, a, b, shape->color[first], shape->color[last], error);
    }
    attempt_at(attempt - 1)(image, a, b, shape->color[0]);
    return true;
}

static bool live_is_drawn(const struct image *image, int x, int y) {
    const struct color color = image_get(image, x, y);
    return color.r + color.g + color.b > 0;
}

/* Copy the pixels of the first steps of a line, from its left or lower end on, into the image. */
static void live_copy_steps(const struct drawing *drawing, struct image *image,
                            const struct image *whole, const struct text_scene_shape *shape) {
    const bool steep = fabs(shape->y[1] - shape->y[0]) > fabs(shape->x[1] - shape->x[0]);
    const double *u = steep ? shape->y : shape->x;
    const double last = fmin(u[0], u[1]) + drawing_value(drawing, "steps") * fabs(u[1] - u[0]);
    for (int i = 0; i < (int)(image->width * image->height); i++) {
        const int x = i % (int)image->width, y = i / (int)image->width;
        if (live_is_drawn(whole, x, y) && (steep ? y : x) <= last) {
            image_set(image, x, y, image_get(whole, x, y));
        }
    }
}

static bool live_steps(const struct drawing *drawing, struct image *image,
                       const struct text_scene_shape *shape, struct error *error) {
    struct image whole;
    if (!image_create(&whole, image->width, image->height, IMAGE_BGR, error)) {
        return false;
    }
    const bool done = live_whole(drawing, &whole, shape, error);
    live_copy_steps(drawing, image, &whole, shape);
    image_free(&whole);
    return done;
}

/* Where the exact line is at the probed pixel's column, or at a steep line's row, and how far the
 * pixel is from it. */
static void live_note_line(struct drawing *drawing, const struct text_scene_shape *shape) {
    struct pixel a = live_end(shape, 0), b = live_end(shape, 1), p = drawing->probe;
    int run = b.x - a.x, rise = b.y - a.y;
    bool steep = abs(rise) > abs(run);
    int step = steep ? p.y - a.y : p.x - a.x, from = steep ? a.x : a.y;
    int length = steep ? rise : run, climb = steep ? run : rise;
    if (length != 0 && step / length == 0 && (step == 0 || (step < 0) == (length < 0))) {
        const double exact = from + (double)step * climb / length;
        drawing_note(drawing, "at %s = %d the line is at %s = %d + %d * %d/%d = %.3f, error %+.3f",
                     steep ? "y" : "x", steep ? p.y : p.x, steep ? "x" : "y", from, step, climb,
                     length, exact, (steep ? p.x : p.y) - exact);
    }
}

/* ---- What is wrong ---- */

/* Those steps of all lines as they should be. By runs, a line has the exact pixels. */
static void live_draw_wanted(const struct drawing *drawing, struct image *wanted,
                             struct image *whole) {
    for (size_t i = 0; i < drawing->text->shape_count; i++) {
        const struct text_scene_shape *shape = &drawing->text->shapes[i];
        image_clear(whole, color_grey(0));
        attempt_by_runs(whole, live_end(shape, 0), live_end(shape, 1), color_grey(255));
        live_copy_steps(drawing, wanted, whole, shape);
    }
}

/* Red: drawn, but on no line. Blue: missing. */
static bool live_mark_wrong(struct drawing *drawing, struct image *image, struct error *error) {
    struct image wanted = {0}, whole = {0};
    uint64_t wrong = 0, missing = 0;
    if (!image_create(&wanted, image->width, image->height, IMAGE_GREY, error) ||
        !image_create(&whole, image->width, image->height, IMAGE_GREY, error)) {
        image_free(&wanted);
        return false;
    }
    live_draw_wanted(drawing, &wanted, &whole);
    for (int i = 0; i < (int)(image->width * image->height); i++) {
        const int x = i % (int)image->width, y = i / (int)image->width;
        const bool is = live_is_drawn(image, x, y), should = live_is_drawn(&wanted, x, y);
        wrong += is && !should;
        missing += !is && should;
        image_set(image, x, y,
                  is == should ? color_grey(is ? 160 : 0)
                               : color_rgb(is ? 255 : 0, is ? 0 : 90, is ? 0 : 255));
    }
    image_free(&whole);
    image_free(&wanted);
    drawing_count(drawing, "pixels_wrong", wrong);
    drawing_count(drawing, "pixels_missing", missing);
    return true;
}

/* ---- The text scene ---- */

static bool live_text(struct drawing *drawing, struct image *image, struct error *error) {
    bool done = true;
    for (size_t i = 0; done && i < drawing->text->shape_count; i++) {
        const struct text_scene_shape *shape = &drawing->text->shapes[i];
        done = drawing_value(drawing, "steps") == 1 ? live_whole(drawing, image, shape, error)
                                                    : live_steps(drawing, image, shape, error);
        if (drawing->probed) {
            live_note_line(drawing, shape);
        }
    }
    return done && (drawing_value(drawing, "wrong") == 0 || live_mark_wrong(drawing, image, error));
}

static int main_with_more(const struct program *program, int argc, char **argv) {
    struct program whole = *program;
    whole.draw_text = live_text;
    whole.text_values = live_text_values;
    return main_with(&whole, NULL, 0, argc, argv);
}
