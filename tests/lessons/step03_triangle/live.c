/* Lesson 3 under the mouse: a text scene, drawn by all attempts, and the pixels that they draw too
 * often or not at all. */
#ifndef LESSON
#define LESSON "../step03_triangle/main.c"
#endif
#include "more_scenes.h"

#include "../../../step03_triangle/attempts.h"

#if __has_include("told.h")
#include "told.h"
#else
/* Without an answer to task 3b.1 a pixel counts as wanted when the first triangle draws it. */
static bool told_wanted(const struct fixed2 corner[3], int x, int y, bool newly_drawn) {
    (void)corner, (void)x, (void)y;
    return newly_drawn;
}
#endif

enum { LIVE_BORDERS = 8 };

static const struct scene_value live_text_values[] = {
    {"attempt",
     "0 triangle(), 1 sweep in whole numbers, 2 sweep in float, 3 box in float, 4 box in double, "
     "5 open sides, 6 a tolerance, 7 edges in float, 8 three borders, 9 half of that",
     0, 9, 1, 0},
    {"snap", "bits of a corner's fraction", 0, 8, 1, 8},
    {"counted", "orange is drawn too often, magenta is missing", 0, 1, 1, 0},
    {.name = NULL},
};

/* The corners, snapped to so many bits. False for a triangle too far off the image to draw. */
static bool live_place(const struct drawing *drawing, const struct text_scene_shape *shape,
                       struct vec2 screen[3], struct fixed2 corner[3]) {
    const double steps = ldexp(1, (int)drawing_value(drawing, "snap"));
    place_shape(shape, screen);
    for (int i = 0; i < 3; i++) {
        screen[i] = (struct vec2){floor(screen[i].x * steps + 0.5) / steps,
                                  floor(screen[i].y * steps + 0.5) / steps};
    }
    return snap_corners(screen, corner);
}

/* By an attempt, or by what the lesson writes. */
static void live_fill(struct drawing *drawing, struct image *image, const struct vec2 screen[3],
                      const struct fixed2 corner[3], const struct color color[3]) {
    const int attempt = (int)drawing_value(drawing, "attempt");
    if (attempt == 0) {
        fill_shape(drawing, image, corner, color);
    } else if (attempt >= LIVE_BORDERS) {
        attempt_by_columns(image, screen, color, attempt == LIVE_BORDERS ? 2 : 1);
    } else {
        attempt_fill(attempt)(image, screen, color[0]);
    }
}

/* ---- Notes ---- */

/* What the three edges say of the probed pixel: part b's, or before it is written, part a's; and
 * the weights there. */
static void live_note_edges(struct drawing *drawing, const struct image *image,
                            const struct vec2 screen[3], const struct fixed2 corner[3],
                            size_t number) {
    struct edges edges;
    if (!triangle_setup(&edges, corner[0], corner[1], corner[2], image->width, image->height)) {
        const struct vec2 center = {drawing->probe.x + 0.5, drawing->probe.y + 0.5};
        for (int i = 0; i < 3; i++) {
            drawing_note(drawing, "triangle %zu: E%d = %+.4f", number, i,
                         side_of(screen[(i + 1) % 3], screen[(i + 2) % 3], center));
        }
        return;
    }
    for (int i = 0; i < 3; i++) {
        const struct edge *e = &edges.edge[i];
        int64_t value = e->origin + e->dx * drawing->probe.x + e->dy * drawing->probe.y;
        drawing_note(drawing, "triangle %zu: E%d = %+.4f, %s", number, i,
                     (double)value / SUBPIXELS / SUBPIXELS,
                     value == 0          ? e->least == 0 ? "on it, a top or left edge" : "on it"
                     : value >= e->least ? "inside"
                                         : "outside");
    }
    const struct vec3 weight = triangle_weights(&edges, drawing->probe.x, drawing->probe.y);
    drawing_note(drawing, "triangle %zu: weights %.4f, %.4f, %.4f", number, weight.x, weight.y,
                 weight.z);
}

/* ---- Counting ---- */

/* What is known of a pixel. */
struct live_counted {
    uint8_t draws;  /* how many triangles have drawn it; 255 means more, too */
    uint8_t shade;  /* grey of the last of them */
    uint8_t wanted; /* how many must draw it */
};

/* Count the pixels that a triangle has drawn in white, and make them black again. */
static void live_count(struct image *image, const struct fixed2 corner[3], uint8_t shade,
                       struct live_counted *counted) {
    for (size_t i = 0; i < image->width * image->height; i++) {
        const int x = (int)(i % image->width), y = (int)(i / image->width);
        const bool drawn = image->pixels[i * IMAGE_BGR] != 0, first = counted[i].draws == 0;
        counted[i].wanted =
            (uint8_t)(counted[i].wanted + told_wanted(corner, x, y, drawn && first));
        counted[i].draws = (uint8_t)(counted[i].draws + (drawn && counted[i].draws < 255));
        counted[i].shade = drawn ? shade : counted[i].shade;
    }
    image_clear(image, color_grey(0));
}

/* Grey: drawn as often as it must be. Orange: drawn too often. Magenta: not drawn. */
static void live_show_counted(struct drawing *drawing, struct image *image,
                              const struct live_counted *counted) {
    uint64_t too_often = 0, too_few = 0;
    for (size_t i = 0; i < image->width * image->height; i++) {
        const bool more = counted[i].draws > counted[i].wanted;
        const bool fewer = counted[i].draws < counted[i].wanted;
        image_set(image, (int)(i % image->width), (int)(i / image->width),
                  more    ? color_rgb(255, 150, 0)
                  : fewer ? color_rgb(255, 0, 160)
                          : color_grey(counted[i].shade));
        too_often += more;
        too_few += fewer;
    }
    drawing_count(drawing, "pixels_too_often", too_often);
    drawing_count(drawing, "pixels_missing", too_few);
}

/* ---- The text scene ---- */

static bool live_text(struct drawing *drawing, struct image *image, struct error *error) {
    const struct color white[3] = {{WHITE}, {WHITE}, {WHITE}};
    const bool counts = drawing_value(drawing, "counted") != 0;
    struct live_counted *counted = NULL;
    if (counts && (counted = calloc(image->width * image->height, sizeof *counted)) == NULL) {
        return error_out_of_memory(error);
    }
    for (size_t i = 0; i < drawing->text->shape_count; i++) {
        const struct text_scene_shape *shape = &drawing->text->shapes[i];
        struct vec2 screen[3];
        struct fixed2 corner[3];
        if (!live_place(drawing, shape, screen, corner)) {
            continue;
        }
        live_fill(drawing, image, screen, corner, counts ? white : shape->color);
        if (counts) {
            live_count(image, corner, (uint8_t)(90 + 50 * (i % 4)), counted);
        }
        if (drawing->probed) {
            live_note_edges(drawing, image, screen, corner, i + 1);
        }
    }
    if (counts) {
        live_show_counted(drawing, image, counted);
    }
    free(counted);
    return true;
}

static int main_with_more(const struct program *program, int argc, char **argv) {
    struct program live = *program;
    live.draw_text = live_text;
    live.text_values = live_text_values;
    live.text = "size 40 40\n"
                "triangle 4 4 30 10 14 34 255 140 0\n"
                "triangle 30 10 36 36 14 34 80 80 255\n";
    return main_with(&live, NULL, 0, argc, argv);
}
