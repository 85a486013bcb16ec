/* What becomes of faces, decided for several at once: most of a fine model's faces are turned away
 * or lie between pixel centres, in no order that a processor could foresee. So there is no branch
 * for a single face, and what is found of it is of use only if it turns out to be needed. */
#include "pipeline.h"

#include "pipeline/parts.h"

/* A whole number for each of as many faces as fit into a register of the processor. */
#if LANES > 4
enum { FACES = LANES };
#else
enum { FACES = 4 };
#endif
typedef int32_t many __attribute__((vector_size(FACES * sizeof(int32_t))));
typedef uint32_t umany __attribute__((vector_size(FACES * sizeof(uint32_t))));
_Static_assert(BATCH_SIZE % FACES == 0, "the last faces of a batch are classified together");

/* A corner of several triangles, on the screen. */
struct corners {
    many x, y;
};

LANES_INLINE many many_all(int32_t value) {
    return value + (many){0};
}

/* Where the mask is set a, elsewhere b; with `+`, as in lanes_select(). */
LANES_INLINE many many_select(many mask, many a, many b) {
    return (mask & a) + (~mask & b);
}

LANES_INLINE many many_min(many a, many b) {
    return many_select(a < b, a, b);
}

LANES_INLINE many many_max(many a, many b) {
    return many_select(a > b, a, b);
}

LANES_INLINE bool many_are_zero(many a) {
    uint64_t words[FACES / 2], any = 0;
    memcpy(words, &a, sizeof words);
    for (int i = 0; i < FACES / 2; i++) {
        any |= words[i];
    }
    return any == 0;
}

/* The pixel centres in the boxes of triangles, inclusive: none where the last lies before the
 * first. As columns_of() and rows_of(). */
struct pixel_boxes {
    many left, right, bottom, top;
};

LANES_INLINE struct pixel_boxes find_boxes(const struct corners *c) {
    return (struct pixel_boxes){
        .left = (many_min(many_min(c[0].x, c[1].x), c[2].x) + (SUBPIXELS / 2 - 1)) >> 8,
        .right = (many_max(many_max(c[0].x, c[1].x), c[2].x) - SUBPIXELS / 2) >> 8,
        .bottom = (many_min(many_min(c[0].y, c[1].y), c[2].y) + (SUBPIXELS / 2 - 1)) >> 8,
        .top = (many_max(many_max(c[0].y, c[1].y), c[2].y) - SUBPIXELS / 2) >> 8,
    };
}

LANES_INLINE struct pixel_boxes cut_boxes(const struct pixel_boxes *b,
                                          const struct rectangle *viewport) {
    return (struct pixel_boxes){
        .left = many_max(b->left, many_all(viewport->x)),
        .right = many_min(b->right, many_all(viewport->x + viewport->width - 1)),
        .bottom = many_max(b->bottom, many_all(viewport->y)),
        .top = many_min(b->top, many_all(viewport->y + viewport->height - 1)),
    };
}

/* ---- Triangles between the centres of their box ---- */

/* An edge function: its value at the first centre of the box, less 1 where 0 is not inside, and its
 * steps to the next ones. The highest bit is set where it is negative. Unsigned, since those of
 * large triangles overflow: they are not looked at. */
struct tiny_edges {
    umany value, right, up;
};

/* `sign` is -1 for the triangles whose corners are clockwise, otherwise 1. */
LANES_INLINE struct tiny_edges tiny_edges(struct corners a, struct corners b, many sign,
                                          const struct pixel_boxes *box) {
    many x_distance = (b.x - a.x) * sign, y_distance = (b.y - a.y) * sign;
    many x = box->left * SUBPIXELS + SUBPIXELS / 2, y = box->bottom * SUBPIXELS + SUBPIXELS / 2;
    many top_left = (y_distance < 0) | ((y_distance == 0) & (x_distance < 0));
    return (struct tiny_edges){
        .value = (umany)x_distance * (umany)(y - a.y) - (umany)y_distance * (umany)(x - a.x) -
                 (umany)(top_left + 1),
        .right = -(umany)y_distance * SUBPIXELS,
        .up = (umany)x_distance * SUBPIXELS,
    };
}

/* Which triangles have a box of at most two columns and two rows, and miss all its centres? Of the
 * very small ones that is half. (Of a narrower box, centres beside it are looked at as well: missed
 * in any case.) */
LANES_INLINE many miss_centers(const struct corners *c, many clockwise,
                               const struct pixel_boxes *box) {
    many wide = box->right - box->left, high = box->top - box->bottom;
    umany missed = (umany)((wide <= 1) & (high <= 1));
    struct tiny_edges edge[3];
    for (int i = 0; i < 3; i++) {
        edge[i] = tiny_edges(c[i], c[(i + 1) % 3], clockwise | 1, box);
    }
    for (int center = 0; center < 4; center++) {
        umany outside = {0};
        for (int i = 0; i < 3; i++) {
            outside |= edge[i].value + (center & 1 ? edge[i].right : (umany){0}) +
                       (center & 2 ? edge[i].up : (umany){0});
        }
        missed &= (umany)((many)outside < 0);
    }
    return (many)missed;
}

/* ---- Classes ---- */

/* Below 0 where the corners are clockwise, 0 where there is no area, otherwise above 0. Where no
 * side is longer than 2^15 (128 pixels), the area is below 2^31: that is asked for all at once,
 * since 64-bit products take several times as long. */
LANES_INLINE many find_windings(const struct corners *c) {
    many x1 = c[1].x - c[0].x, y1 = c[1].y - c[0].y;
    many x2 = c[2].x - c[0].x, y2 = c[2].y - c[0].y;
    many bits = (x1 ^ (x1 < 0)) | (y1 ^ (y1 < 0)) | (x2 ^ (x2 < 0)) | (y2 ^ (y2 < 0));
    if (many_are_zero(bits >> 15)) {
        return x1 * y2 - y1 * x2;
    }
    many windings = {0};
    for (int i = 0; i < FACES; i++) {
        int64_t area = (int64_t)x1[i] * y2[i] - (int64_t)y1[i] * x2[i];
        windings[i] = (area > 0) - (area < 0);
    }
    return windings;
}

/* The triangles with a winding that is culled. */
LANES_INLINE many find_culled(many clockwise, enum cull cull) {
    return cull == CULL_BACK ? clockwise : cull == CULL_FRONT ? ~clockwise : (many){0};
}

LANES_INLINE many find_lowest(const struct corners *c) {
    many lowest = {0}, x = c[0].x, y = c[0].y;
    for (int i = 1; i < 3; i++) {
        many lower = (c[i].y < y) | ((c[i].y == y) & (c[i].x < x));
        lowest = many_select(lower, many_all(i), lowest);
        x = many_select(lower, c[i].x, x);
        y = many_select(lower, c[i].y, y);
    }
    return lowest;
}

/* Before it is known which of the whole ones miss the centres. */
LANES_INLINE many find_kinds(many all, many any, many turned_away) {
    many kind = many_all(TRIANGLE_WHOLE);
    kind = many_select(turned_away, many_all(TRIANGLE_TURNED_AWAY), kind);
    kind = many_select((any & (BEYOND_NEAR | BEYOND_GUARD_BAND)) != 0, many_all(TRIANGLE_CLIPPED),
                       kind);
    return many_select((all & BEYOND_ONE_SIDE) != 0, many_all(TRIANGLE_OUTSIDE), kind);
}

LANES_INLINE many many_load(const int32_t *from) {
    many values;
    memcpy(&values, from, sizeof values);
    return values;
}

LANES_INLINE void many_store(int32_t *to, many values) {
    memcpy(to, &values, sizeof values);
}

/* Corners whose x and y lie side by side in memory. */
LANES_INLINE struct corners corners_load(const struct fixed2 *from) {
#if defined(LANES_SHUFFLE) && LANES <= 16
    many a = many_load(&from[0].x), b = many_load(&from[FACES / 2].x);
#if LANES == 16
    return (struct corners){
        LANES_SHUFFLE(a, b, 0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30),
        LANES_SHUFFLE(a, b, 1, 3, 5, 7, 9, 11, 13, 15, 17, 19, 21, 23, 25, 27, 29, 31)};
#elif LANES == 8
    return (struct corners){LANES_SHUFFLE(a, b, 0, 2, 4, 6, 8, 10, 12, 14),
                            LANES_SHUFFLE(a, b, 1, 3, 5, 7, 9, 11, 13, 15)};
#else
    return (struct corners){LANES_SHUFFLE(a, b, 0, 2, 4, 6), LANES_SHUFFLE(a, b, 1, 3, 5, 7)};
#endif
#else
    struct corners corners;
    for (int i = 0; i < FACES; i++) {
        corners.x[i] = from[i].x;
        corners.y[i] = from[i].y;
    }
    return corners;
#endif
}

/* Classify the triangles from `at` on. */
LANES_INLINE void classify(struct batch *batch, size_t at, const struct draw_call *call,
                           bool skip) {
    struct corners c[3];
    for (int i = 0; i < 3; i++) {
        c[i] = corners_load(&batch->screen[i][at]);
    }
    many winding = find_windings(c), clockwise = winding < 0, no_area = winding == 0;
    many culled = find_culled(clockwise, call->cull), none = {0};
    many kind = find_kinds(many_load(&batch->beyond_all[at]), many_load(&batch->beyond_any[at]),
                           skip ? culled & ~no_area : none);
    many_store(&batch->kind[at], kind);
    if (many_are_zero(kind >= TRIANGLE_CLIPPED)) {
        return; /* often: neighbours in a model face the same way */
    }
    struct pixel_boxes whole = find_boxes(c), box = cut_boxes(&whole, &call->viewport);
    many missed = no_area | (box.left > box.right) | (box.bottom > box.top);
    if (skip) {
        missed |= miss_centers(c, clockwise, &whole);
    }
    missed &= kind == TRIANGLE_WHOLE;
    many_store(&batch->kind[at], many_select(missed, many_all(TRIANGLE_WITHOUT_PIXEL), kind));
    many first = find_lowest(c), second = first + 1 - clockwise;
    many_store(&batch->culled[at], culled);
    many_store(&batch->first[at], first);
    many_store(&batch->second[at], many_select(second > 2, second - 3, second));
    many_store(&batch->left[at], box.left);
    many_store(&batch->right[at], box.right);
    many_store(&batch->bottom[at], box.bottom);
    many_store(&batch->top[at], box.top);
}

void batch_classify(struct batch *batch, const struct draw_call *call, bool skip) {
    for (size_t at = 0; at < batch->count; at += FACES) {
        classify(batch, at, call, skip);
    }
}
