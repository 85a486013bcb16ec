/* Objects as a whole, and batches of their faces, by the boxes around them: is one outside the
 * view? And if it is not, where on the screen may it be, and how near? See pipeline.h. */
#include "pipeline.h"

#include "pipeline/parts.h"

#include <float.h>

/* ---- Boxes ---- */

/* The box around a box and a position. */
static inline struct box3 box_with(struct box3 box, struct vec3 p) {
    struct vec3 a = box.least, b = box.greatest;
    return (struct box3){
        {p.x < a.x ? p.x : a.x, p.y < a.y ? p.y : a.y, p.z < a.z ? p.z : a.z},
        {p.x > b.x ? p.x : b.x, p.y > b.y ? p.y : b.y, p.z > b.z ? p.z : b.z},
    };
}

static struct box3 box_of_positions(const struct model *model) {
    struct box3 box = {model->positions[0], model->positions[0]};
    for (size_t i = 1; i < model->position_count; i++) {
        box = box_with(box, model->positions[i]);
    }
    return box;
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

/* The sides of struct boxes, to compute with. */
struct sides {
    doubles at[2][3];
};

static struct sides sides_of(const struct boxes *boxes) {
    struct sides sides;
    memcpy(&sides, boxes->side, sizeof sides);
    return sides;
}

/* One box, several times. */
static struct sides sides_all(struct box3 box) {
    struct vec3 a = box.least, b = box.greatest;
    return (struct sides){{{doubles_all(a.x), doubles_all(a.y), doubles_all(a.z)},
                           {doubles_all(b.x), doubles_all(b.y), doubles_all(b.z)}}};
}

/* More than any roundings of a coordinate that a row of the matrix gives for a point of a box:
 * these amount to a few ulp of the sum of its terms. */
LANES_INLINE doubles roundings(const double row[4], const struct sides *sides) {
    doubles sum = doubles_all(fabs(row[3]));
    for (int k = 0; k < 3; k++) {
        sum +=
            fabs(row[k]) * doubles_most(doubles_abs(sides->at[0][k]), doubles_abs(sides->at[1][k]));
    }
    return 1e-14 * sum + DBL_MIN;
}

/* ---- Objects outside the view ---- */

static unsigned beyond_sides(struct vec4 position) {
    struct clip_positions clip = clip_positions_all(position);
    return (unsigned)find_beyond_sides(&clip)[0];
}

/* Are a few of the positions beyond one side, as all of an object outside must be? Most objects in
 * view are found to be so by the first of them. */
static bool may_be_outside(const struct draw_call *call) {
    const struct model *model = call->model;
    unsigned beyond = BEYOND_ONE_SIDE;
    for (size_t i = 0; i < model->position_count && beyond != 0;
         i += model->position_count / 8 + 1) {
        beyond &= beyond_sides(mat4_point(&call->to_clip, model->positions[i]));
    }
    return beyond != 0;
}

/* Is the box beyond one side, so far that no rounding could bring a position in it back? Exactly, a
 * side's x + w (or the like) is least and greatest at corners of the box; for what is computed, w
 * is taken to be larger by all roundings. */
static bool box_is_outside(const struct mat4 *to_clip, struct box3 box) {
    struct sides sides = sides_all(box);
    doubles off = roundings(to_clip->m[0], &sides) + roundings(to_clip->m[1], &sides) +
                  roundings(to_clip->m[3], &sides);
    double more = off[0];
    unsigned beyond = isfinite(more) ? BEYOND_ONE_SIDE : 0;
    for (int i = 0; i < 8; i++) {
        struct vec4 clip = mat4_point(to_clip, box_corner(box, i));
        clip.w += more;
        beyond &= beyond_sides(clip);
    }
    return beyond != 0;
}

bool pipeline_is_outside(struct pipeline *p, const struct draw_call *call) {
    return call->model->position_count > 0 && may_be_outside(call) &&
           box_is_outside(&call->to_clip, find_box(p, call->model));
}

/* ---- Where boxes are on the screen ---- */

/* Where something may cover pixels, and what no depth of it is above: see pipeline_place(). */
struct place {
    struct span columns, rows;
    double nearest;
};

/* At least and at most. */
struct bounds {
    doubles least, greatest;
};

/* Quotients x/w, y/w and z/w in boxes, and the least w; `known`, where all w lie before the near
 * plane. */
struct quotients {
    struct bounds of[3];
    doubles least_w;
    longs known;
};

/* A quotient is greatest, and least, at corners of the box, where all of it lies before the near
 * plane. */
LANES_INLINE struct quotients find_quotients(const double m[4][4], const struct sides *sides,
                                             doubles w_off) {
    struct quotients q = {.least_w = doubles_all(INFINITY), .known = ~(longs){0}};
    for (int k = 0; k < 3; k++) {
        q.of[k] = (struct bounds){doubles_all(INFINITY), doubles_all(-INFINITY)};
    }
    for (int i = 0; i < 8; i++) {
        doubles x = sides->at[i & 1][0], y = sides->at[i >> 1 & 1][1], z = sides->at[i >> 2][2];
        doubles w = m[3][0] * x + m[3][1] * y + m[3][2] * z + m[3][3], recip_w = 1 / w;
        q.known &= w - w_off >= near_w;
        q.least_w = doubles_least(w, q.least_w);
        for (int k = 0; k < 3; k++) {
            doubles at = (m[k][0] * x + m[k][1] * y + m[k][2] * z + m[k][3]) * recip_w;
            q.of[k].least = doubles_least(at, q.of[k].least);
            q.of[k].greatest = doubles_most(at, q.of[k].greatest);
        }
    }
    return q;
}

/* The pixels between two places in NDC, and one more on either side, cut to the viewport: begin
 * inclusive, end exclusive. */
LANES_INLINE void find_pixels(struct bounds ndc, int first, int size, ints *begin, ints *end) {
    double scale = size / 2.0;
    doubles least = doubles_all(first), most = least + size;
    doubles low = first + (ndc.least + 1) * scale - 1;
    doubles high = first + (ndc.greatest + 1) * scale + 2;
    *begin = __builtin_convertvector(doubles_least(doubles_most(low, least), most), ints);
    *end = __builtin_convertvector(doubles_least(doubles_most(high, least), most), ints);
}

/* Where boxes are known to be. Dividends and divisors may be off by roundings. (Computed quotients
 * are off by a few ulp of the largest more.) */
static void place_boxes(const struct draw_call *call, const struct sides *sides,
                        struct place place[TOGETHER]) {
    const struct rectangle *v = &call->viewport;
    doubles off[4], most = {0};
    for (int row = 0; row < 4; row++) {
        off[row] = 2 * roundings(call->to_clip.m[row], sides);
    }
    struct quotients q = find_quotients(call->to_clip.m, sides, off[3]);
    for (int k = 0; k < 3; k++) {
        most = doubles_most(most, doubles_most(-q.of[k].least, q.of[k].greatest));
    }
    for (int k = 0; k < 3; k++) {
        doubles more = (off[k] + most * off[3]) / (q.least_w - off[3]) + 1e-13 * most;
        q.of[k].least -= more;
        q.of[k].greatest += more;
    }
    q.known &= most <= 1e9; /* as numbers of pixels that an int holds */
    ints left, right, bottom, top;
    find_pixels(q.of[0], v->x, v->width, &left, &right);
    find_pixels(q.of[1], v->y, v->height, &bottom, &top);
    for (int i = 0; i < TOGETHER; i++) {
        place[i] = (struct place){{v->x, v->x + v->width}, {v->y, v->y + v->height}, INFINITY};
        if (q.known[i] != 0) {
            place[i] =
                (struct place){{left[i], right[i]}, {bottom[i], top[i]}, q.of[2].greatest[i]};
        }
    }
}

void pipeline_place(struct pipeline *p, struct draw *draw) {
    const struct model *model = draw->call.model;
    struct box3 nowhere = {{NAN, NAN, NAN}, {NAN, NAN, NAN}};
    struct sides sides = sides_all(model->position_count > 0 ? find_box(p, model) : nowhere);
    struct place place[TOGETHER];
    place_boxes(&draw->call, &sides, place);
    draw->columns = place[0].columns;
    draw->rows = place[0].rows;
    draw->nearest = place[0].nearest;
}

/* ---- Batches of faces ---- */

/* Of a model that is drawn fewer times in turn no boxes are found: it would not pay. */
enum { SHARED_BY = 4 };

static size_t count_batches(size_t faces) {
    return (faces + BATCH_SIZE - 1) / BATCH_SIZE;
}

/* How many struct boxes the batches of a model take. */
static size_t count_boxes(const struct model *model) {
    return (count_batches(model->face_count) + TOGETHER - 1) / TOGETHER;
}

static struct box3 box_of_faces(const struct model *model, struct range faces) {
    struct vec3 first = model_position(model, faces.begin, 0);
    struct box3 box = {first, first};
    for (size_t face = faces.begin; face < faces.end; face++) {
        for (size_t corner = 0; corner < 3; corner++) {
            box = box_with(box, model_position(model, face, corner));
        }
    }
    return box;
}

static void put_box(struct boxes *boxes, size_t at, struct box3 box) {
    const double least[3] = {box.least.x, box.least.y, box.least.z};
    const double greatest[3] = {box.greatest.x, box.greatest.y, box.greatest.z};
    for (size_t k = 0; k < 3; k++) {
        boxes->side[0][k][at] = least[k];
        boxes->side[1][k][at] = greatest[k];
    }
}

/* Behind the last batch anything may be: nobody asks for it. */
static void box_batches(const struct model *model, struct boxes *boxes) {
    struct range faces = {0, model->face_count};
    memset(boxes, 0, count_boxes(model) * sizeof *boxes);
    for (size_t i = 0; i < count_batches(model->face_count); i++) {
        put_box(&boxes[i / TOGETHER], i % TOGETHER, box_of_faces(model, batch_range(faces, i)));
    }
}

bool pipeline_box_batches(struct pipeline *p, struct error *error) {
    struct draw *draws = p->draws.data;
    size_t count = 0;
    for (size_t first = 0, end; first < p->draw_count; first = end) {
        const struct model *model = draws[first].call.model;
        end = first;
        while (end < p->draw_count && draws[end].call.model == model) {
            end++;
        }
        if (end - first < SHARED_BY || model->face_count <= BATCH_SIZE) {
            continue;
        }
        size_t more = count_boxes(model);
        if (!buffer_reserve(&p->boxes, count + more, sizeof(struct boxes), error)) {
            return false;
        }
        box_batches(model, (struct boxes *)p->boxes.data + count);
        for (size_t i = first; i < end; i++) {
            draws[i].has_boxes = true;
            draws[i].first_boxes = count;
        }
        count += more;
    }
    return true;
}

/* Is a batch left out? Then its faces are counted. (Before the first round nothing hides.) */
static bool leave_out_batch(const struct pipeline *p, const struct place *place, size_t faces,
                            uint64_t stats[PIPELINE_STATS]) {
    bool outside =
        place->columns.begin >= place->columns.end || place->rows.begin >= place->rows.end;
    bool hidden = pipeline_is_hidden(p, place->nearest, place->columns, place->rows);
    stats[STAT_FACES_OUTSIDE] += outside ? faces : 0;
    stats[STAT_FACES_HIDDEN] += hidden ? faces : 0;
    stats[STAT_FACES_BEHIND] += hidden ? faces : 0;
    stats[STAT_BATCHES_OUTSIDE] += outside;
    stats[STAT_BATCHES_HIDDEN] += hidden;
    return outside || hidden;
}

uint32_t pipeline_leave_out(const struct pipeline *p, const struct draw *draw, struct range faces,
                            uint64_t stats[PIPELINE_STATS]) {
    uint32_t left_out = 0;
    if (!draw->has_boxes) {
        return left_out;
    }
    const struct boxes *boxes = (const struct boxes *)p->boxes.data + draw->first_boxes +
                                faces.begin / BATCH_SIZE / TOGETHER;
    struct place place[TOGETHER];
    for (size_t i = 0; i < count_batches(faces.end - faces.begin); i++) {
        if (i % TOGETHER == 0) {
            struct sides sides = sides_of(&boxes[i / TOGETHER]);
            place_boxes(&draw->call, &sides, place);
        }
        struct range batch = batch_range(faces, i);
        bool left = leave_out_batch(p, &place[i % TOGETHER], batch.end - batch.begin, stats);
        left_out |= (uint32_t)left << i;
    }
    return left_out;
}
