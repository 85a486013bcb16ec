/*
 * Classify: is a triangle off screen, culled, without a pixel centre, to be clipped, or whole?
 *
 * Most faces of a fine model are culled or lie between pixel centres, in no order that a processor
 * could predict, and a branch that is predicted wrongly costs more than the answer. So LANES
 * triangles are classified at once without a branch for any of them: all questions are answered for
 * all triangles, and masks choose among the answers.
 *
 *     .         .         .         .
 *
 *        +---+         +-------/       Neither triangle covers a pixel centre (.). The left one's
 *        | /\|         |     / |       bounding box holds none. In the right one's box is one,
 *     .  |/__|  .      |  ./   |   .   which the triangle misses.
 *                      | /     |
 *                      /-------+
 *     .         .         .         .
 *
 * All of it is done with whole numbers, 1/256 pixel, so no triangle is dropped that covers a pixel.
 *
 * Masks are used as numbers, too: a comparison gives -1 where it holds and 0 elsewhere. So
 * `a - mask` adds 1 where it holds, `mask | 1` is -1 or 1, and `a ^ (a < 0)` is a, or -a - 1 where
 * a is negative.
 */
#include "pipeline.h"

_Static_assert(BATCH_SIZE % LANES == 0, "the last faces of a batch are classified together");

/* One corner of each of LANES triangles, on the screen. */
struct corners {
    lanes_int x, y;
};

/* The pixel centres in the triangles' bounding boxes, from the first to the last, inclusive: none
 * where the last one comes before the first. */
struct pixel_boxes {
    lanes_int left, right, bottom, top;
};

LANES_INLINE struct pixel_boxes find_boxes(const struct corners *c) {
    return (struct pixel_boxes){
        .left = FIRST_CENTER(lanes_int_min(lanes_int_min(c[0].x, c[1].x), c[2].x)),
        .right = LAST_CENTER(lanes_int_max(lanes_int_max(c[0].x, c[1].x), c[2].x)),
        .bottom = FIRST_CENTER(lanes_int_min(lanes_int_min(c[0].y, c[1].y), c[2].y)),
        .top = LAST_CENTER(lanes_int_max(lanes_int_max(c[0].y, c[1].y), c[2].y)),
    };
}

LANES_INLINE struct pixel_boxes cut_boxes(const struct pixel_boxes *b,
                                          const struct rectangle *viewport) {
    return (struct pixel_boxes){
        .left = lanes_int_max(b->left, lanes_int_all(viewport->x)),
        .right = lanes_int_min(b->right, lanes_int_all(viewport->x + viewport->width - 1)),
        .bottom = lanes_int_max(b->bottom, lanes_int_all(viewport->y)),
        .top = lanes_int_min(b->top, lanes_int_all(viewport->y + viewport->height - 1)),
    };
}

/* ---- Small triangles that miss all centres in their box ---- */

/* An edge function in the box: its value at the first centre, and its steps to the next centre to
 * the right and up. For an edge that is neither top nor left, 0 is outside, so 1 is subtracted: a
 * centre is outside where the value is negative, that is, where its highest bit is set. The numbers
 * are unsigned because those of large triangles overflow; miss_centers() ignores them. */
struct tiny_edges {
    lanes_texel value, right, up;
};

/* `sign` is -1 for the triangles whose corners are clockwise, otherwise 1. */
LANES_INLINE struct tiny_edges tiny_edges(struct corners a, struct corners b, lanes_int sign,
                                          const struct pixel_boxes *box) {
    lanes_int x_distance = (b.x - a.x) * sign, y_distance = (b.y - a.y) * sign;
    lanes_int x = box->left * SUBPIXELS + SUBPIXELS / 2,
              y = box->bottom * SUBPIXELS + SUBPIXELS / 2;
    lanes_int top_left = IS_TOP_LEFT(x_distance, y_distance); /* a mask: top_left + 1 is 0 or 1 */
    return (struct tiny_edges){
        .value = (lanes_texel)x_distance * (lanes_texel)(y - a.y) -
                 (lanes_texel)y_distance * (lanes_texel)(x - a.x) - (lanes_texel)(top_left + 1),
        .right = -(lanes_texel)y_distance * SUBPIXELS,
        .up = (lanes_texel)x_distance * SUBPIXELS,
    };
}

/* Which triangles have a box of at most two columns and two rows, and miss all centres in it? Half
 * of the very small ones do. (If a box has fewer centres, those next to it are tested instead,
 * which the triangle misses anyway.) */
LANES_INLINE lanes_int miss_centers(const struct corners *c, lanes_int clockwise,
                                    const struct pixel_boxes *box) {
    lanes_int wide = box->right - box->left, high = box->top - box->bottom;
    lanes_texel missed = (lanes_texel)((wide <= 1) & (high <= 1));
    struct tiny_edges edge[3];
    for (int i = 0; i < 3; i++) {
        edge[i] = tiny_edges(c[i], c[(i + 1) % 3], clockwise | 1, box);
    }
    for (int center = 0; center < 4; center++) {
        lanes_texel outside = {0};
        for (int i = 0; i < 3; i++) {
            outside |= edge[i].value + (center & 1 ? edge[i].right : (lanes_texel){0}) +
                       (center & 2 ? edge[i].up : (lanes_texel){0});
        }
        missed &= (lanes_texel)((lanes_int)outside < 0);
    }
    return (lanes_int)missed;
}

/* ---- Classes ---- */

/* The winding order: below 0 where the corners are clockwise, above 0 where they are
 * counterclockwise, 0 where there is no area. If no side is longer than 2^15 (128 pixels), 32 bits
 * hold twice the area; only otherwise are 64-bit products computed, which take several times as
 * long. */
LANES_INLINE lanes_int find_windings(const struct corners *c) {
    lanes_int x1 = c[1].x - c[0].x, y1 = c[1].y - c[0].y;
    lanes_int x2 = c[2].x - c[0].x, y2 = c[2].y - c[0].y;
    lanes_int bits = (x1 ^ (x1 < 0)) | (y1 ^ (y1 < 0)) | (x2 ^ (x2 < 0)) | (y2 ^ (y2 < 0));
    if (lanes_bits(bits >> 15 != 0) == 0) {
        return x1 * y2 - y1 * x2;
    }
    lanes_int windings = {0};
    for (int i = 0; i < LANES; i++) {
        int64_t area = (int64_t)x1[i] * y2[i] - (int64_t)y1[i] * x2[i];
        windings[i] = (area > 0) - (area < 0);
    }
    return windings;
}

/* The triangles whose winding order is culled. */
LANES_INLINE lanes_int find_culled(lanes_int clockwise, enum cull cull) {
    return cull == CULL_BACK ? clockwise : cull == CULL_FRONT ? ~clockwise : (lanes_int){0};
}

/* Which corner is the lowest, and of several the leftmost? */
LANES_INLINE lanes_int find_lowest(const struct corners *c) {
    lanes_int lowest = {0}, x = c[0].x, y = c[0].y;
    for (int i = 1; i < 3; i++) {
        lanes_int lower = (c[i].y < y) | ((c[i].y == y) & (c[i].x < x));
        lowest = VECTOR_SELECT(lower, lanes_int_all(i), lowest);
        x = VECTOR_SELECT(lower, c[i].x, x);
        y = VECTOR_SELECT(lower, c[i].y, y);
    }
    return lowest;
}

/* The kinds of triangles, before it is known which of the whole ones cover no pixel centre. */
LANES_INLINE lanes_int find_kinds(lanes_int all, lanes_int any, lanes_int turned_away) {
    lanes_int kind = lanes_int_all(TRIANGLE_WHOLE);
    kind = VECTOR_SELECT(turned_away, lanes_int_all(TRIANGLE_TURNED_AWAY), kind);
    kind = VECTOR_SELECT((any & (BEYOND_NEAR | BEYOND_GUARD_BAND)) != 0,
                         lanes_int_all(TRIANGLE_CLIPPED), kind);
    return VECTOR_SELECT((all & BEYOND_ONE_SIDE) != 0, lanes_int_all(TRIANGLE_OUTSIDE), kind);
}

LANES_INLINE void store(int32_t *to, lanes_int values) {
    memcpy(to, &values, sizeof values);
}

/* Classify the triangles from `at` on. */
LANES_INLINE void classify(struct batch *batch, size_t at, const struct draw_call *call,
                           bool skip) {
    struct corners c[3];
    for (int i = 0; i < 3; i++) {
        c[i] = (struct corners){lanes_int_load(&batch->x[i][at]), lanes_int_load(&batch->y[i][at])};
    }
    lanes_int winding = find_windings(c), clockwise = winding < 0, no_area = winding == 0;
    lanes_int kind =
        find_kinds(lanes_int_load(&batch->beyond_all[at]), lanes_int_load(&batch->beyond_any[at]),
                   find_culled(clockwise, call->cull) & ~no_area);
    store(&batch->kind[at], kind);
    if (lanes_bits(kind >= TRIANGLE_CLIPPED) == 0) {
        return; /* often: neighbours in a model face the same way */
    }
    struct pixel_boxes whole = find_boxes(c), box = cut_boxes(&whole, &call->viewport);
    lanes_int missed = no_area | (box.left > box.right) | (box.bottom > box.top);
    if (skip) {
        missed |= miss_centers(c, clockwise, &whole);
    }
    missed &= kind == TRIANGLE_WHOLE;
    store(&batch->kind[at], VECTOR_SELECT(missed, lanes_int_all(TRIANGLE_WITHOUT_PIXEL), kind));
    lanes_int first = find_lowest(c), second = first + 1 - clockwise;
    store(&batch->first[at], first);
    store(&batch->second[at], VECTOR_SELECT(second > 2, second - 3, second));
    store(&batch->left[at], box.left);
    store(&batch->right[at], box.right);
    store(&batch->bottom[at], box.bottom);
    store(&batch->top[at], box.top);
}

void batch_classify(struct batch *batch, const struct draw_call *call, bool skip) {
    for (size_t at = 0; at < batch->count; at += LANES) {
        classify(batch, at, call, skip);
    }
}
