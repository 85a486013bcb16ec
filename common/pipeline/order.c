/*
 * Order: which draw calls need no drawing, and when is the turn of the others? See pipeline.h.
 *
 * The eight corners of the box around a model say where it can be on the screen, and how near. A
 * call whose box is beyond one side of the view is dropped. If the others overlap, the nearest ones
 * come first, in rounds of 4, 4, 8, 16, ... calls: before a round begins, what the rounds before it
 * have covered may hide whole calls of it.
 *
 * Boxes are enlarged by more than all rounding errors, so that no call is dropped of which a pixel
 * would be visible.
 */
#include "pipeline.h"

/* How many calls the first round has, and how many a frame must have for a second round. */
enum { FIRST_ROUND = 4, MANY = 16 };

/* ---- Boxes ---- */

/* The box around a model in its own space: its least and its greatest coordinates. */
struct model_box {
    struct vec3 side[2];
};

static struct model_box find_box(const struct model *model) {
    struct vec3 least = model->positions[0], most = least;
    for (size_t i = 1; i < model->position_count; i++) {
        struct vec3 p = model->positions[i];
        least = (struct vec3){p.x < least.x ? p.x : least.x, p.y < least.y ? p.y : least.y,
                              p.z < least.z ? p.z : least.z};
        most = (struct vec3){p.x > most.x ? p.x : most.x, p.y > most.y ? p.y : most.y,
                             p.z > most.z ? p.z : most.z};
    }
    return (struct model_box){{least, most}};
}

/* More than the rounding error of any clip coordinate of a point in the box, which is a few ulp of
 * the sum of its terms. */
static double find_slack(const struct mat4 *to_clip, const struct model_box *box) {
    const struct vec3 *a = &box->side[0], *b = &box->side[1];
    double farthest = fmax(fmax(fmax(-a->x, b->x), fmax(-a->y, b->y)), fmax(-a->z, b->z)), most = 0;
    for (int row = 0; row < 4; row++) {
        const double *m = to_clip->m[row];
        most += fabs(m[3]) + (fabs(m[0]) + fabs(m[1]) + fabs(m[2])) * fabs(farthest);
    }
    return 4e-14 * most;
}

/* The pixels between two NDC coordinates, and one more on either side, cut to the viewport. */
static struct span find_pixels(double least, double most, int first, int size) {
    double begin = first + (least + 1) * (size / 2.0) - 1,
           end = first + (most + 1) * (size / 2.0) + 2;
    double last = first + size;
    begin = begin < first ? first : begin;
    end = end > last ? last : end;
    return (struct span){(int)(begin > last ? last : begin), (int)(end < first ? first : end)};
}

/* The sides of the view that a position is beyond; NaN is beyond all of them. */
static unsigned beyond_sides(struct vec4 p) {
    return (p.x >= -p.w ? 0U : BEYOND_LEFT) | (p.x <= p.w ? 0U : BEYOND_RIGHT) |
           (p.y >= -p.w ? 0U : BEYOND_BOTTOM) | (p.y <= p.w ? 0U : BEYOND_TOP) |
           (p.w >= NEAR_W ? 0U : BEYOND_NEAR);
}

/* Where the box may be on the screen: nowhere if all of it is beyond one side of the view. It is
 * enough to look at its corners: there, x + w and the like are least and greatest, and so are x/w,
 * y/w and z/w in front of the near plane. The slack makes up for rounding errors; of a box that
 * reaches behind the near plane, or much too far, nothing is known but its sides. */
static struct screen_place find_place(const struct draw_call *call, const struct model_box *box) {
    const struct rectangle *v = &call->viewport;
    struct screen_place place = {columns_of(v), rows_of(v), INFINITY};
    double slack = find_slack(&call->to_clip, box), largest = 0, least_w = INFINITY;
    double least[3] = {INFINITY, INFINITY, INFINITY}, most[3] = {-INFINITY, -INFINITY, -INFINITY};
    unsigned beyond = BEYOND_ONE_SIDE;
    for (int i = 0; i < 8; i++) {
        struct vec3 corner = {box->side[i & 1].x, box->side[i >> 1 & 1].y, box->side[i >> 2].z};
        struct vec4 p = mat4_point(&call->to_clip, corner);
        const double at[3] = {p.x / p.w, p.y / p.w, p.z / p.w};
        beyond &= beyond_sides((struct vec4){p.x, p.y, p.z, p.w + slack});
        least_w = fmin(p.w - slack, least_w);
        for (int k = 0; k < 3; k++) {
            least[k] = fmin(at[k], least[k]);
            most[k] = fmax(at[k], most[k]);
            largest = fmax(fabs(at[k]), largest);
        }
    }
    double more = slack * (1 + largest) / least_w;
    if (beyond != 0 && slack < INFINITY) {
        place = (struct screen_place){{v->x, v->x}, {v->y, v->y}, -INFINITY};
    } else if (slack < INFINITY && least_w >= NEAR_W && largest <= 1e9) {
        place.columns = find_pixels(least[0] - more, most[0] + more, v->x, v->width);
        place.rows = find_pixels(least[1] - more, most[1] + more, v->y, v->height);
        place.nearest = most[2] + more;
    }
    return place;
}

/* Is it worth finding the box of the only model? That takes long for a large one, and is of no use
 * unless all of it is beyond one side of the view: so a few positions are asked first. */
static bool may_be_outside(const struct draw_call *call) {
    const struct model *model = call->model;
    unsigned beyond = BEYOND_ONE_SIDE;
    for (size_t i = 0; i < model->position_count; i += model->position_count / 8 + 1) {
        beyond &= beyond_sides(mat4_point(&call->to_clip, model->positions[i]));
    }
    return beyond != 0;
}

/* ---- Their order ---- */

static uint64_t area_of(struct span columns, struct span rows) {
    return (uint64_t)(columns.end - columns.begin) * (uint64_t)(rows.end - rows.begin);
}

/* Do calls overlap on the screen? They must if their places have more pixels in sum than the
 * rectangle around all. Pictures side by side do not, and need no order. */
static bool calls_overlap(const struct frame *frame) {
    struct span columns = {INT_MAX, 0}, rows = columns;
    uint64_t sum = 0;
    for (size_t i = 0; i < frame->order_count; i++) {
        const struct screen_place *place = &frame->order[i]->place;
        if (!place_is_empty(place)) {
            columns = span_around(columns, place->columns);
            rows = span_around(rows, place->rows);
            sum += area_of(place->columns, place->rows);
        }
    }
    return sum > 0 && sum > area_of(columns, rows);
}

/* The nearest first; of equally near ones the first drawn. */
static int compare_calls(const void *left, const void *right) {
    const struct recorded_call *const *a = left, *const *b = right;
    if ((*a)->place.nearest != (*b)->place.nearest) {
        return (*a)->place.nearest > (*b)->place.nearest ? -1 : 1;
    }
    return (*a > *b) - (*a < *b);
}

/* List the calls that may cover pixels, and count the others. */
static void list_calls(struct frame *frame) {
    const struct model *of = NULL; /* whose box it is: calls often draw one model again */
    struct model_box box = {{{0, 0, 0}, {0, 0, 0}}};
    uint64_t *stats = frame->pipeline->stats;
    frame->order_count = 0;
    for (size_t i = 0; i < frame->call_count; i++) {
        struct recorded_call *call = &frame->calls[i];
        const struct model *model = call->call.model;
        if (model->position_count > 0 && (frame->call_count > 1 || may_be_outside(&call->call))) {
            box = model == of ? box : find_box(model);
            of = model;
            call->place = find_place(&call->call, &box);
        }
        if (place_is_empty(&call->place) && frame->pipeline->skip) {
            stats[STAT_CALLS_OUTSIDE]++;
            stats[STAT_FACES_OUTSIDE] += model->face_count;
        } else {
            frame->order[frame->order_count++] = call;
        }
    }
}

bool pipeline_order(struct frame *frame, struct error *error) {
    if (!array_extend(&frame->order, &frame->order_capacity, frame->call_count,
                      sizeof(struct recorded_call *))) {
        return error_out_of_memory(error);
    }
    list_calls(frame);
    /* A shader that discards needs the order of drawing. */
    frame->reordered = frame->pipeline->skip && !frame->discards && calls_overlap(frame);
    if (frame->reordered) {
        qsort(frame->order, frame->order_count, sizeof(struct recorded_call *), compare_calls);
    }
    return true;
}

void pipeline_next_round(struct frame *frame) {
    struct index_range *round = &frame->round;
    round->begin = round->end;
    round->end = round->begin == 0 ? FIRST_ROUND : 2 * round->begin;
    if (!frame->reordered || frame->order_count < MANY || round->end > frame->order_count) {
        round->end = frame->order_count;
    }
}
