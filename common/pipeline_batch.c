/* What becomes of faces, decided for several at once: most of a fine model's faces are turned away
 * or lie between pixel centres, in no order that a processor could foresee. So there is no branch
 * here, and what is found of a face is of use only if the face turns out to need it. */
#include "pipeline.h"

#include "pipeline_parts.h"

/* A corner of several triangles, on the screen. */
struct corners {
    ints x, y;
};

LANES_INLINE ints ints_min(ints a, ints b) {
    return ints_select(a < b, a, b);
}

LANES_INLINE ints ints_max(ints a, ints b) {
    return ints_select(a > b, a, b);
}

LANES_INLINE longs longs_product(ints a, ints b) {
    return __builtin_convertvector(a, longs) * __builtin_convertvector(b, longs);
}

/* The pixel centres in the boxes of triangles, inclusive: none where the last lies before the
 * first. As columns_of() and rows_of(). */
struct boxes {
    ints left, right, bottom, top;
};

LANES_INLINE struct boxes find_boxes(const struct corners *c) {
    return (struct boxes){
        .left = (ints_min(ints_min(c[0].x, c[1].x), c[2].x) + (SUBPIXELS / 2 - 1)) >> 8,
        .right = (ints_max(ints_max(c[0].x, c[1].x), c[2].x) - SUBPIXELS / 2) >> 8,
        .bottom = (ints_min(ints_min(c[0].y, c[1].y), c[2].y) + (SUBPIXELS / 2 - 1)) >> 8,
        .top = (ints_max(ints_max(c[0].y, c[1].y), c[2].y) - SUBPIXELS / 2) >> 8,
    };
}

LANES_INLINE struct boxes cut_boxes(const struct boxes *b, const struct rectangle *viewport) {
    return (struct boxes){
        .left = ints_max(b->left, ints_all(viewport->x)),
        .right = ints_min(b->right, ints_all(viewport->x + viewport->width - 1)),
        .bottom = ints_max(b->bottom, ints_all(viewport->y)),
        .top = ints_min(b->top, ints_all(viewport->y + viewport->height - 1)),
    };
}

/* ---- Triangles between the centres of their box ---- */

/* An edge function: its value at the first centre of the box, less 1 where 0 is not inside, and its
 * steps to the next ones. The highest bit is set where it is negative. Unsigned, since those of
 * large triangles overflow: they are not looked at. */
struct tiny_edges {
    uints value, right, up;
};

/* `sign` is -1 for the triangles whose corners are clockwise, otherwise 1. */
LANES_INLINE struct tiny_edges tiny_edges(struct corners a, struct corners b, ints sign,
                                          const struct boxes *box) {
    ints x_distance = (b.x - a.x) * sign, y_distance = (b.y - a.y) * sign;
    ints x = box->left * SUBPIXELS + SUBPIXELS / 2, y = box->bottom * SUBPIXELS + SUBPIXELS / 2;
    ints top_left = (y_distance < 0) | ((y_distance == 0) & (x_distance < 0));
    return (struct tiny_edges){
        .value = (uints)x_distance * (uints)(y - a.y) - (uints)y_distance * (uints)(x - a.x) -
                 (uints)(top_left + 1),
        .right = -(uints)y_distance * SUBPIXELS,
        .up = (uints)x_distance * SUBPIXELS,
    };
}

/* Which triangles have a box of at most two columns and two rows, and miss all its centres? Of the
 * very small ones that is half. (Of a narrower box, centres beside it are looked at as well: missed
 * in any case.) */
LANES_INLINE ints miss_centers(const struct corners *c, ints clockwise, const struct boxes *box) {
    ints wide = box->right - box->left, high = box->top - box->bottom;
    uints missed = (uints)((wide <= 1) & (high <= 1));
    struct tiny_edges edge[3];
    for (int i = 0; i < 3; i++) {
        edge[i] = tiny_edges(c[i], c[(i + 1) % 3], clockwise | 1, box);
    }
    for (int center = 0; center < 4; center++) {
        uints outside = {0};
        for (int i = 0; i < 3; i++) {
            outside |= edge[i].value + (center & 1 ? edge[i].right : (uints){0}) +
                       (center & 2 ? edge[i].up : (uints){0});
        }
        missed &= (uints)((ints)outside < 0);
    }
    return (ints)missed;
}

/* ---- Classes ---- */

/* Twice the signed areas, in 1/256 pixel squared; positive when counterclockwise. */
LANES_INLINE longs signed_areas(const struct corners *c) {
    return longs_product(c[1].x - c[0].x, c[2].y - c[0].y) -
           longs_product(c[1].y - c[0].y, c[2].x - c[0].x);
}

/* The triangles with a winding that is culled. */
LANES_INLINE ints find_culled(ints clockwise, enum cull cull) {
    return cull == CULL_BACK ? clockwise : cull == CULL_FRONT ? ~clockwise : (ints){0};
}

LANES_INLINE ints find_lowest(const struct corners *c) {
    ints lowest = {0}, x = c[0].x, y = c[0].y;
    for (int i = 1; i < 3; i++) {
        ints lower = (c[i].y < y) | ((c[i].y == y) & (c[i].x < x));
        lowest = ints_select(lower, ints_all(i), lowest);
        x = ints_select(lower, c[i].x, x);
        y = ints_select(lower, c[i].y, y);
    }
    return lowest;
}

LANES_INLINE ints find_kinds(ints all, ints any, ints turned_away, ints without_pixel) {
    ints kind = ints_all(TRIANGLE_WHOLE);
    kind = ints_select(without_pixel, ints_all(TRIANGLE_WITHOUT_PIXEL), kind);
    kind = ints_select(turned_away, ints_all(TRIANGLE_TURNED_AWAY), kind);
    kind = ints_select((any & (BEYOND_NEAR | BEYOND_GUARD_BAND)) != 0, ints_all(TRIANGLE_CLIPPED),
                       kind);
    return ints_select((all & BEYOND_ONE_SIDE) != 0, ints_all(TRIANGLE_OUTSIDE), kind);
}

LANES_INLINE ints ints_load(const int32_t *from) {
    ints values;
    memcpy(&values, from, sizeof values);
    return values;
}

LANES_INLINE void ints_store(int32_t *to, ints values) {
    memcpy(to, &values, sizeof values);
}

/* Classify the triangles from `at` on. */
LANES_INLINE void classify(struct batch *batch, size_t at, const struct draw_call *call,
                           bool skip) {
    struct corners c[3];
    for (int i = 0; i < 3; i++) {
        c[i] = (struct corners){ints_load(&batch->x[i][at]), ints_load(&batch->y[i][at])};
    }
    longs area = signed_areas(c);
    ints clockwise = __builtin_convertvector(area < 0, ints);
    ints no_area = __builtin_convertvector(area == 0, ints);
    ints culled = find_culled(clockwise, call->cull), turned_away = {0}, missed = {0};
    struct boxes whole = find_boxes(c), box = cut_boxes(&whole, &call->viewport);
    if (skip) {
        turned_away = culled & ~no_area;
        missed = miss_centers(c, clockwise, &whole);
    }
    missed |= no_area | (box.left > box.right) | (box.bottom > box.top);
    ints first = find_lowest(c), second = first + 1 - clockwise;
    ints_store(&batch->kind[at],
               find_kinds(ints_load(&batch->beyond_all[at]), ints_load(&batch->beyond_any[at]),
                          turned_away, missed));
    ints_store(&batch->culled[at], culled);
    ints_store(&batch->first[at], first);
    ints_store(&batch->second[at], ints_select(second > 2, second - 3, second));
    ints_store(&batch->left[at], box.left);
    ints_store(&batch->right[at], box.right);
    ints_store(&batch->bottom[at], box.bottom);
    ints_store(&batch->top[at], box.top);
}

void batch_classify(struct batch *batch, const struct draw_call *call, bool skip) {
    for (size_t at = 0; at < batch->count; at += TOGETHER) {
        classify(batch, at, call, skip);
    }
}
