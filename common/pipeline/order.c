/*
 * Draw calls as a whole: which of them need not be drawn, in which order and in which rounds the
 * others are covered. All of it is decided by the box around a
 * model. See pipeline.h.
 *
 * Where objects overlap the nearest ones are covered first: what lies behind them is then dropped
 * by the tile. Where there are many, they come in rounds. The first has the nearest few, and each
 * one after it as many as all before it, less those that are hidden as a whole: these are never
 * assembled.
 */
#include "pipeline.h"

#include "pipeline/parts.h"

#include <float.h>

/* The draw calls of the first round; and how many there must be for more than one. */
enum { FIRST_ROUND = 4, MANY = 16 };

/* ---- Boxes around models, and around batches of their faces ---- */

/* Of a model that is drawn fewer times no boxes around its batches are found: it would not pay. */
enum { SHARED_BY = 4 };

/* Position i: of the model, or a corner of its faces from there on. */
static struct vec3 position_of(const struct model *model, const struct range *faces, size_t i) {
    return faces == NULL ? model->positions[i] : model_position(model, faces->begin + i / 3, i % 3);
}

/* Around some faces of a model, or (NULL) around all of its positions: number `at` of those. */
static void find_box(const struct model *model, const struct range *faces, struct boxes *boxes,
                     size_t at) {
    size_t count = faces == NULL ? model->position_count : 3 * (faces->end - faces->begin);
    struct vec3 least = position_of(model, faces, 0), most = least;
    for (size_t i = 1; i < count; i++) {
        struct vec3 p = position_of(model, faces, i);
        least = (struct vec3){p.x < least.x ? p.x : least.x, p.y < least.y ? p.y : least.y,
                              p.z < least.z ? p.z : least.z};
        most = (struct vec3){p.x > most.x ? p.x : most.x, p.y > most.y ? p.y : most.y,
                             p.z > most.z ? p.z : most.z};
    }
    const double sides[2][3] = {{least.x, least.y, least.z}, {most.x, most.y, most.z}};
    for (int k = 0; k < 6; k++) {
        boxes->side[k / 3][k % 3][at] = sides[k / 3][k % 3];
    }
}

/* ---- Where boxes are on the screen ---- */

/* What is known of the corners of boxes in clip space, whatever roundings. */
struct corners_seen {
    longs inside;    /* some corner is not beyond this side, for each of BEYOND_ONE_SIDE */
    longs before;    /* all of them lie before the near plane */
    doubles least_w; /* at most */
    doubles least[3], most[3]; /* of x/w, y/w and z/w */
};

/* More than any roundings of a coordinate that a row of the matrix gives for a point of a box:
 * these amount to a few ulp of the sum of its terms. */
LANES_INLINE doubles roundings(const double row[4], const struct boxes *boxes) {
    doubles sum = doubles_all(fabs(row[3]));
    for (int k = 0; k < 3; k++) {
        sum += fabs(row[k]) * doubles_max(doubles_abs(doubles_load(boxes->side[0][k])),
                                          doubles_abs(doubles_load(boxes->side[1][k])));
    }
    return 1e-14 * sum + DBL_MIN;
}

/* Exactly, a side's x + w (or the like), and a quotient before the near plane, are least and
 * greatest at corners of the box. What is computed may be off by roundings. */
LANES_INLINE struct corners_seen see_corners(const double m[4][4], const struct boxes *boxes) {
    const doubles infinite = doubles_all(INFINITY);
    struct corners_seen seen = {{0},
                                ~(longs){0},
                                infinite,
                                {infinite, infinite, infinite},
                                {-infinite, -infinite, -infinite}};
    doubles off[4], largest = {0};
    for (int row = 0; row < 4; row++) {
        off[row] = 2 * roundings(m[row], boxes);
    }
    for (int i = 0; i < 8; i++) {
        doubles x = doubles_load(boxes->side[i & 1][0]),
                y = doubles_load(boxes->side[i >> 1 & 1][1]);
        doubles z = doubles_load(boxes->side[i >> 2][2]), p[4];
        for (int row = 0; row < 4; row++) {
            p[row] = m[row][0] * x + m[row][1] * y + m[row][2] * z + m[row][3];
        }
        struct clip_positions larger = {p[0], p[1], p[2], p[3] + (off[0] + off[1] + off[3])};
        seen.inside |= ~find_beyond_sides(&larger);
        seen.before &= p[3] - off[3] >= near_w;
        seen.least_w = doubles_min(p[3] - off[3], seen.least_w);
        for (int k = 0; k < 3; k++) {
            doubles at = p[k] / p[3];
            seen.least[k] = doubles_min(at, seen.least[k]);
            seen.most[k] = doubles_max(at, seen.most[k]);
            largest = doubles_max(doubles_abs(at), largest);
        }
    }
    for (int k = 0; k < 3; k++) {
        doubles more = (off[k] + largest * off[3]) / seen.least_w + 1e-13 * largest;
        seen.least[k] -= more;
        seen.most[k] += more;
    }
    seen.inside |= ~(off[0] + off[1] + off[3] < infinite);
    seen.before &= largest <= 1e9; /* as numbers of pixels that an int holds */
    return seen;
}

/* The pixels between two places in NDC, and one more on either side, cut to the viewport. */
static struct span find_pixels(double least, double most, int first, int size) {
    double begin = first + (least + 1) * (size / 2.0) - 1,
           end = first + (most + 1) * (size / 2.0) + 2;
    double last = first + size;
    begin = begin < first ? first : begin;
    end = end > last ? last : end;
    return (struct span){(int)(begin > last ? last : begin), (int)(end < first ? first : end)};
}

void pipeline_place(const struct draw_call *call, const struct boxes *boxes,
                    struct screen_place place[TOGETHER]) {
    const struct rectangle *v = &call->viewport;
    struct corners_seen seen = see_corners(call->to_clip.m, boxes);
    for (int i = 0; i < TOGETHER; i++) {
        place[i] =
            (struct screen_place){{v->x, v->x + v->width}, {v->y, v->y + v->height}, INFINITY};
        if ((~seen.inside[i] & BEYOND_ONE_SIDE) != 0) {
            place[i] = (struct screen_place){{v->x, v->x}, {v->y, v->y}, -INFINITY};
        } else if (seen.before[i] != 0) {
            place[i].columns = find_pixels(seen.least[0][i], seen.most[0][i], v->x, v->width);
            place[i].rows = find_pixels(seen.least[1][i], seen.most[1][i], v->y, v->height);
            place[i].nearest = seen.most[2][i];
        }
    }
}

/* Are a few of the positions beyond one side, as all of an object outside must be? The box around
 * one large model takes longer to find than it saves. */
static bool may_be_outside(const struct draw_call *call) {
    const struct model *model = call->model;
    int64_t beyond = BEYOND_ONE_SIDE;
    for (size_t i = 0; i < model->position_count; i += model->position_count / 8 + 1) {
        struct clip_positions clip =
            clip_positions_all(mat4_point(&call->to_clip, model->positions[i]));
        beyond &= find_beyond_sides(&clip)[0];
    }
    return beyond != 0;
}

/* ---- Their order ---- */

static uint64_t area_of(struct span columns, struct span rows) {
    return (uint64_t)(columns.end - columns.begin) * (uint64_t)(rows.end - rows.begin);
}

/* Do the draw calls overlap on the screen, for all that their areas tell? Pictures side by side do
 * not. */
static bool draws_overlap(const struct pipeline *p) {
    const struct draw *draws = p->draws.data;
    const struct draw_order *order = p->order.data;
    struct span columns = {INT_MAX, 0}, rows = columns;
    uint64_t sum = 0;
    for (size_t i = 0; i < p->order_count; i++) {
        const struct draw *draw = &draws[order[i].draw];
        uint64_t area = area_of(draw->place.columns, draw->place.rows);
        columns = area > 0 ? span_around(columns, draw->place.columns) : columns;
        rows = area > 0 ? span_around(rows, draw->place.rows) : rows;
        sum += area;
    }
    return sum > 0 && sum > area_of(columns, rows);
}

/* The nearest first; of equally near ones the first drawn. */
static int compare_draws(const void *left, const void *right) {
    const struct draw_order *a = left, *b = right;
    if (a->nearest != b->nearest) {
        return a->nearest > b->nearest ? -1 : 1;
    }
    return (a->draw > b->draw) - (a->draw < b->draw);
}

/* List the draw calls that may cover pixels, and count the others. */
static void list_draws(struct pipeline *p) {
    struct draw *draws = p->draws.data;
    struct draw_order *order = p->order.data;
    const struct model *of = NULL; /* many draw one model again and again */
    struct boxes box = {0};
    p->order_count = 0;
    for (size_t i = 0; i < p->draw_count; i++) {
        const struct model *model = draws[i].call.model;
        if (model->position_count > 0 && (p->draw_count > 1 || may_be_outside(&draws[i].call))) {
            if (model != of) {
                find_box(model, NULL, &box, 0);
                of = model;
            }
            struct screen_place place[TOGETHER];
            pipeline_place(&draws[i].call, &box, place);
            draws[i].place = place[0];
        }
        if (place_is_empty(&draws[i].place) && takes_shortcut(p, SHORTCUT_OUTSIDE)) {
            p->stats[STAT_OBJECTS_OUTSIDE]++;
            p->stats[STAT_FACES_OUTSIDE] += model->face_count;
        } else {
            order[p->order_count++] = (struct draw_order){draws[i].place.nearest, i};
        }
    }
}

/* Find the boxes around all batches of the models that are drawn several times in turn. */
static bool find_boxes(struct pipeline *p, struct error *error) {
    struct draw *draws = p->draws.data;
    size_t count = 0; /* of batches */
    for (size_t first = 0, end; first < p->draw_count; first = end) {
        const struct model *model = draws[first].call.model;
        for (end = first; end < p->draw_count && draws[end].call.model == model; end++) {
        }
        if (end - first < SHARED_BY) {
            continue;
        }
        size_t batches = (model->face_count + BATCH_SIZE - 1) / BATCH_SIZE;
        batches = (batches + TOGETHER - 1) / TOGETHER * TOGETHER;
        if (!buffer_reserve(&p->boxes, (count + batches) / TOGETHER, sizeof(struct boxes), error)) {
            return false;
        }
        struct boxes *boxes = (struct boxes *)p->boxes.data + count / TOGETHER;
        for (size_t i = 0; i * BATCH_SIZE < model->face_count; i++) {
            struct range batch = batch_range((struct range){0, model->face_count}, i);
            find_box(model, &batch, &boxes[i / TOGETHER], i % TOGETHER);
        }
        for (size_t i = first; i < end; i++) {
            draws[i].has_boxes = true;
            draws[i].first_boxes = count / TOGETHER;
        }
        count += batches;
    }
    return true;
}

void pipeline_reorder(struct pipeline *p) {
    /* A shader that discards needs the order of drawing. */
    p->reordered = takes_shortcut(p, SHORTCUT_VISIBLE) && takes_shortcut(p, SHORTCUT_BEHIND) &&
                   !p->discards && p->order_count > 1 && draws_overlap(p);
    if (p->reordered) {
        qsort(p->order.data, p->order_count, sizeof(struct draw_order), compare_draws);
    }
}

bool pipeline_order(struct pipeline *p, struct error *error) {
    if (!buffer_reserve(&p->order, p->draw_count, sizeof(struct draw_order), error)) {
        return false;
    }
    list_draws(p);
    p->reordered = false;
    if (p->order_count >= MANY) {
        pipeline_reorder(p);
    }
    return !p->reordered || find_boxes(p, error);
}

void pipeline_next_round(struct frame *frame) {
    const struct pipeline *p = frame->pipeline;
    struct range *draws = &frame->draws;
    frame->round = draws->end == 0 ? 0 : frame->round + 1;
    draws->begin = draws->end;
    draws->end = draws->begin == 0 ? FIRST_ROUND : 2 * draws->begin;
    if (!p->reordered || draws->end > p->order_count) {
        draws->end = p->order_count;
    }
}
