/*
 * Lesson 2's earlier versions: a list that lacks sides, and a cut that moves pixels.
 *
 * To be included after main.c, whose struct side and line() they use.
 */
#ifndef STEP02_ATTEMPTS_H
#define STEP02_ATTEMPTS_H

#include "model.h"
#include "tgaimage.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

/* ---- Lists of sides ---- */

/* A shortcut instead of sorting: list a side only where it goes from the smaller number to the
 * larger. In a closed mesh the other face has it the other way round, so it is listed once. Wrong
 * for a mesh with a border: half of the border, by chance, is missing. Returns how many there are;
 * `sides` has room for 3 a face. */
static inline size_t attempt_one_direction(const struct model *model, struct side *sides) {
    size_t count = 0;
    for (size_t i = 0; i < model->face_count; i++) {
        const struct corner *corner = model->faces[i].corner;
        for (size_t j = 0; j < 3; j++) {
            uint32_t p = corner[j].position, q = corner[(j + 1) % 3].position;
            if (p < q) {
                sides[count++] = (struct side){p, q};
            }
        }
    }
    return count;
}

/* ---- Lines ---- */

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
 * pixel of the right one, and differs from it in many pixels. Returns how many it walked over. */
static inline uint64_t attempt_line_ends_rounded(struct image *image, struct pixel a,
                                                 struct pixel b, struct color color) {
    double ax = a.x, ay = a.y, bx = b.x, by = b.y;
    double right = (double)image->width - 1, top = (double)image->height - 1;
    if (!attempt_shorten(&ax, &ay, &bx, &by, 0, right) ||
        !attempt_shorten(&ay, &ax, &by, &bx, 0, top)) {
        return 0;
    }
    struct pixel new_a = {(int)floor(ax + 0.5), (int)floor(ay + 0.5)};
    struct pixel new_b = {(int)floor(bx + 0.5), (int)floor(by + 0.5)};
    return line(image, new_a, new_b, color);
}

#endif
