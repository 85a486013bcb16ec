/* Objects as a whole, by the box around their positions: is one outside the view? And if it is not,
 * where on the screen may it be, and how near? See pipeline.h. */
#include "pipeline.h"

#include "pipeline_parts.h"

#include <float.h>

/* ---- Boxes ---- */

static struct box3 box_of_positions(const struct model *model) {
    struct vec3 a = model->positions[0], b = a;
    for (size_t i = 1; i < model->position_count; i++) {
        struct vec3 p = model->positions[i];
        a = (struct vec3){p.x < a.x ? p.x : a.x, p.y < a.y ? p.y : a.y, p.z < a.z ? p.z : a.z};
        b = (struct vec3){p.x > b.x ? p.x : b.x, p.y > b.y ? p.y : b.y, p.z > b.z ? p.z : b.z};
    }
    return (struct box3){a, b};
}

/* Kept for the next draw call: many draw one model again and again, and it stays as it is until the
 * frame is finished. */
static struct box3 find_box(struct pipeline *p, const struct model *model) {
    if (p->boxed != model) {
        p->box = box_of_positions(model);
        p->boxed = model;
    }
    return p->box;
}

static struct vec3 box_corner(struct box3 box, int i) {
    return (struct vec3){i & 1 ? box.greatest.x : box.least.x, i & 2 ? box.greatest.y : box.least.y,
                         i & 4 ? box.greatest.z : box.least.z};
}

/* The sum of the absolute terms of a row of the matrix, for any point of the box. */
static double sum_of_terms(const double row[4], struct box3 box) {
    return fabs(row[0]) * fmax(fabs(box.least.x), fabs(box.greatest.x)) +
           fabs(row[1]) * fmax(fabs(box.least.y), fabs(box.greatest.y)) +
           fabs(row[2]) * fmax(fabs(box.least.z), fabs(box.greatest.z)) + fabs(row[3]);
}

/* More than any roundings of a coordinate that a row of the matrix gives: these amount to a few ulp
 * of the sum of its terms. */
static double roundings(const double row[4], struct box3 box) {
    return 1e-14 * sum_of_terms(row, box) + DBL_MIN;
}

/* ---- Objects outside the view ---- */

/* Are a few of the positions beyond one side, as all of an object outside must be? Most objects in
 * view are found to be so by the first of them. */
static bool may_be_outside(const struct draw_call *call) {
    const struct model *model = call->model;
    unsigned beyond = BEYOND_ONE_SIDE;
    for (size_t i = 0; i < model->position_count && beyond != 0;
         i += model->position_count / 8 + 1) {
        beyond &= pipeline_beyond_sides(mat4_point(&call->to_clip, model->positions[i]));
    }
    return beyond != 0;
}

/* Is the box beyond one side, so far that no rounding could bring a position in it back? Exactly, a
 * side's x + w (or the like) is least and greatest at corners of the box; for what is computed, w
 * is taken to be larger by all roundings. */
static bool box_is_outside(const struct mat4 *to_clip, struct box3 box) {
    double more = roundings(to_clip->m[0], box) + roundings(to_clip->m[1], box) +
                  roundings(to_clip->m[3], box);
    unsigned beyond = isfinite(more) ? BEYOND_ONE_SIDE : 0;
    for (int i = 0; i < 8; i++) {
        struct vec4 clip = mat4_point(to_clip, box_corner(box, i));
        clip.w += more;
        beyond &= pipeline_beyond_sides(clip);
    }
    return beyond != 0;
}

bool pipeline_is_outside(struct pipeline *p, const struct draw_call *call) {
    return call->model->position_count > 0 && may_be_outside(call) &&
           box_is_outside(&call->to_clip, find_box(p, call->model));
}

/* ---- Objects on the screen ---- */

/* At least and at most. */
struct bounds {
    double least, greatest;
};

/* Of a/w, where w is positive, and a and w may be off by that much. */
static struct bounds bounds_of_quotient(double a, double a_off, double w, double w_off) {
    double low = a - a_off, high = a + a_off;
    return (struct bounds){low / (low > 0 ? w + w_off : w - w_off),
                           high / (high > 0 ? w - w_off : w + w_off)};
}

/* The pixels between two places in NDC, and one more on either side; cut to the viewport. */
static struct span pixels_between(struct bounds ndc, int first, int size) {
    double scale = size / 2.0, end = (double)first + size;
    double low = first + (ndc.least + 1) * scale - 1, high = first + (ndc.greatest + 1) * scale + 1;
    return (struct span){(int)fmin(fmax(low, first), end), (int)ceil(fmin(fmax(high, first), end))};
}

/* A quotient x/w, y/w or z/w is greatest, and least, at corners of the box, where all of it lies
 * before the near plane. (Computed ones are off by a few ulp of the largest more.) */
void pipeline_place(struct pipeline *p, struct draw *draw) {
    const struct draw_call *call = &draw->call;
    const struct rectangle *v = &call->viewport;
    draw->columns = (struct span){v->x, v->x + v->width};
    draw->rows = (struct span){v->y, v->y + v->height};
    draw->nearest = INFINITY;
    if (call->model->position_count == 0) {
        return;
    }
    struct box3 box = find_box(p, call->model);
    double off[4], most = 0;
    struct bounds ndc[3] = {{INFINITY, -INFINITY}, {INFINITY, -INFINITY}, {INFINITY, -INFINITY}};
    for (int row = 0; row < 4; row++) {
        off[row] = 2 * roundings(call->to_clip.m[row], box);
    }
    for (int i = 0; i < 8; i++) {
        struct vec4 clip = mat4_point(&call->to_clip, box_corner(box, i));
        const double coordinate[3] = {clip.x, clip.y, clip.z};
        if (!(clip.w - off[3] >= near_w)) {
            return;
        }
        for (int k = 0; k < 3; k++) {
            struct bounds b = bounds_of_quotient(coordinate[k], off[k], clip.w, off[3]);
            ndc[k] =
                (struct bounds){fmin(ndc[k].least, b.least), fmax(ndc[k].greatest, b.greatest)};
            most = fmax(most, fmax(fabs(b.least), fabs(b.greatest)));
        }
    }
    if (most <= 1e9) { /* as numbers of pixels that an int holds */
        draw->columns = pixels_between(ndc[0], v->x, v->width);
        draw->rows = pixels_between(ndc[1], v->y, v->height);
        draw->nearest = ndc[2].greatest + 1e-13 * most;
    }
}
