/*
 * Lesson 2's earlier versions: wireframes that do too much, and a cut that moves pixels.
 *
 * To be included after main.c, whose struct side, to_pixel() and line() they use. The wireframes of
 * one model have the same pixels in every version; what differs is the work.
 */
#ifndef STEP02_ATTEMPTS_H
#define STEP02_ATTEMPTS_H

#include "model.h"
#include "tgaimage.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

/* ---- Wireframes ---- */

/* The line of lesson 1 visits all its pixels, and image_set() tests whether each is in the image.
 * That is wasteful: almost nothing is seen of a line that reaches far out. */
static inline void attempt_line_tested(struct image *image, struct pixel a, struct pixel b,
                                       struct color color) {
    struct course course = course_from(a, b);
    int64_t u = course.u, v = course.v, error = -course.run;
    for (int64_t k = 0; k <= course.run; k++) {
        image_set(image, (int)(course.steep ? v : u), (int)(course.steep ? u : v), color);
        u++;
        error += 2 * course.rise;
        if (error > 0) {
            v += course.v_step;
            error -= 2 * course.run;
        }
    }
}

/* One side, cut or tested. */
static inline void attempt_side(struct image *image, const struct model *model, uint32_t p,
                                uint32_t q, bool cut) {
    const struct color white = color_rgb(255, 255, 255);
    struct pixel a, b;
    if (!to_pixel(model->positions[p], image->width, image->height, &a) ||
        !to_pixel(model->positions[q], image->width, image->height, &b)) {
        return;
    }
    if (cut) {
        line(image, a, b, white);
    } else {
        attempt_line_tested(image, a, b, white);
    }
}

/* Three lines for every face. Wasteful: nearly every side belongs to two faces and is drawn
 * twice. */
static inline void attempt_faces(struct image *image, const struct model *model, bool cut) {
    for (size_t i = 0; i < model->face_count; i++) {
        const struct corner *corner = model->faces[i].corner;
        for (size_t j = 0; j < 3; j++) {
            attempt_side(image, model, corner[j].position, corner[(j + 1) % 3].position, cut);
        }
    }
}

static inline void attempt_1_every_side_tested(struct image *image, const struct model *model) {
    attempt_faces(image, model, false);
}

static inline void attempt_2_every_side_cut(struct image *image, const struct model *model) {
    attempt_faces(image, model, true);
}

/* Every side of the list (made as prepare() in scenes.h makes it), tested pixel by pixel. */
static inline void attempt_3_each_once_tested(struct image *image, const struct model *model,
                                              const struct side *sides, size_t side_count) {
    for (size_t i = 0; i < side_count; i++) {
        attempt_side(image, model, sides[i].low, sides[i].high, false);
    }
}

/* A shortcut instead of the list: draw a side only where it goes from the smaller number to the
 * larger. In a closed mesh the other face has it the other way round, so it is drawn once. Wrong
 * for a mesh with a border: half of the border, by chance, is missing. */
static inline void attempt_4_one_direction(struct image *image, const struct model *model) {
    for (size_t i = 0; i < model->face_count; i++) {
        const struct corner *corner = model->faces[i].corner;
        for (size_t j = 0; j < 3; j++) {
            uint32_t p = corner[j].position, q = corner[(j + 1) % 3].position;
            if (p < q) {
                attempt_side(image, model, p, q, true);
            }
        }
    }
}

/* ---- A cut that moves pixels ---- */

/* Shorten the segment p-q to the part whose coordinate `on` one axis is in least..most; `off` is
 * the coordinate on the other axis. False when nothing is left. */
static inline bool attempt_shorten(double *p_on, double *p_off, double *q_on, double *q_off,
                                   double least, double most) {
    if ((*p_on < least && *q_on < least) || (*p_on > most && *q_on > most)) {
        return false;
    }
    double p0 = *p_on, p1 = *p_off, q0 = *q_on, q1 = *q_off;
    if (p0 < least || p0 > most) {
        *p_on = p0 < least ? least : most;
        *p_off = p1 + (*p_on - p0) * (q1 - p1) / (q0 - p0);
    }
    if (q0 < least || q0 > most) {
        *q_on = q0 < least ? least : most;
        *q_off = p1 + (*q_on - p0) * (q1 - p1) / (q0 - p0);
    }
    return true;
}

/* The usual way: compute where the line crosses the borders of the image, round these points to
 * pixels, and draw a line between them. Wrong: the new line has another slope. It lies within one
 * pixel of the right one, and differs from it in many pixels. */
static inline void attempt_line_ends_rounded(struct image *image, struct pixel a, struct pixel b,
                                             struct color color) {
    double ax = a.x, ay = a.y, bx = b.x, by = b.y;
    double right = (double)image->width - 1, top = (double)image->height - 1;
    if (attempt_shorten(&ax, &ay, &bx, &by, 0, right) &&
        attempt_shorten(&ay, &ax, &by, &bx, 0, top)) {
        struct pixel new_a = {(int)floor(ax + 0.5), (int)floor(ay + 0.5)};
        struct pixel new_b = {(int)floor(bx + 0.5), (int)floor(by + 0.5)};
        line(image, new_a, new_b, color);
    }
}

#endif
