/*
 * pipeline/classify.c against plain answers: one triangle at a time, one pixel centre at a time,
 * with the oracle's turns and coverage.
 */
#include "oracle/oracle.h"
#include "pipeline.h"
#include "unit/unit.h"

/* The farthest place on the screen, in 1/256 pixel. */
enum { FARTHEST = SCREEN_LIMIT * SUBPIXELS };

struct triangle {
    struct fixed2 corner[3];
    int32_t beyond_all, beyond_any;
};

/* ---- Plain answers ---- */

/* Pixel centres, inclusive: none where the last lies before the first. */
struct centers {
    int left, right, bottom, top;
};

struct answer {
    enum triangle_kind kind;
    int first, second;
    struct centers seen;
};

static struct centers centers_of(const struct fixed2 corner[3]) {
    struct centers box = {INT_MAX, INT_MIN, INT_MAX, INT_MIN};
    for (int i = 0; i < 3; i++) {
        double x = (corner[i].x - 128) / 256.0, y = (corner[i].y - 128) / 256.0;
        box.left = ceil(x) < box.left ? (int)ceil(x) : box.left;
        box.right = floor(x) > box.right ? (int)floor(x) : box.right;
        box.bottom = ceil(y) < box.bottom ? (int)ceil(y) : box.bottom;
        box.top = floor(y) > box.top ? (int)floor(y) : box.top;
    }
    return box;
}

static struct centers centers_in(struct centers box, const struct rectangle *viewport) {
    int right = viewport->x + viewport->width - 1, top = viewport->y + viewport->height - 1;
    return (struct centers){
        box.left > viewport->x ? box.left : viewport->x, box.right < right ? box.right : right,
        box.bottom > viewport->y ? box.bottom : viewport->y, box.top < top ? box.top : top};
}

static size_t count_covered(const struct fixed2 corner[3], struct centers box) {
    size_t count = 0;
    for (int y = box.bottom; y <= box.top; y++) {
        for (int x = box.left; x <= box.right; x++) {
            count += oracle_covers(corner[0], corner[1], corner[2], x, y);
        }
    }
    return count;
}

static bool is_tiny(struct centers box) {
    return box.right - box.left < 2 && box.top - box.bottom < 2;
}

static bool has_no_pixel(const struct triangle *t, const struct draw_call *call, bool skip) {
    const struct fixed2 *c = t->corner;
    struct centers box = centers_of(c), seen = centers_in(box, &call->viewport);
    return oracle_turn(c[0], c[1], c[2]) == 0 || seen.left > seen.right || seen.bottom > seen.top ||
           (skip && is_tiny(box) && count_covered(c, box) == 0);
}

static bool is_culled(const struct triangle *t, enum cull cull) {
    int turn = oracle_turn(t->corner[0], t->corner[1], t->corner[2]);
    return (cull == CULL_BACK && turn < 0) || (cull == CULL_FRONT && turn > 0);
}

static enum triangle_kind kind_of(const struct triangle *t, const struct draw_call *call,
                                  bool skip) {
    if (t->beyond_all & BEYOND_ONE_SIDE) {
        return TRIANGLE_OUTSIDE;
    }
    if (t->beyond_any & (BEYOND_NEAR | BEYOND_GUARD_BAND)) {
        return TRIANGLE_CLIPPED;
    }
    if (is_culled(t, call->cull)) {
        return TRIANGLE_TURNED_AWAY;
    }
    return has_no_pixel(t, call, skip) ? TRIANGLE_WITHOUT_PIXEL : TRIANGLE_WHOLE;
}

static bool is_lower(struct fixed2 a, struct fixed2 b) {
    return a.y != b.y ? a.y < b.y : a.x < b.x;
}

static struct answer find_answer(const struct triangle *t, const struct draw_call *call,
                                 bool skip) {
    const struct fixed2 *c = t->corner;
    struct answer answer = {
        .kind = kind_of(t, call, skip),
        .seen = centers_in(centers_of(c), &call->viewport),
    };
    for (int i = 0; i < 3; i++) {
        answer.first = is_lower(c[i], c[answer.first]) ? i : answer.first;
    }
    int second = (answer.first + 1) % 3, third = (answer.first + 2) % 3;
    answer.second = oracle_turn(c[answer.first], c[second], c[third]) > 0 ? second : third;
    return answer;
}

/* ---- Batches ---- */

static void put(struct batch *batch, size_t at, const struct triangle *t) {
    for (int i = 0; i < 3; i++) {
        batch->x[i][at] = t->corner[i].x;
        batch->y[i][at] = t->corner[i].y;
    }
    batch->beyond_all[at] = t->beyond_all;
    batch->beyond_any[at] = t->beyond_any;
}

/* Of what is not whole only the kind is promised. */
static bool is_answer(const struct batch *batch, size_t at, const struct answer *answer) {
    if (batch->kind[at] != (int32_t)answer->kind || answer->kind != TRIANGLE_WHOLE) {
        return batch->kind[at] == (int32_t)answer->kind;
    }
    return batch->first[at] == answer->first && batch->second[at] == answer->second &&
           batch->left[at] == answer->seen.left && batch->right[at] == answer->seen.right &&
           batch->bottom[at] == answer->seen.bottom && batch->top[at] == answer->seen.top;
}

static void print_triangle(const struct triangle *t) {
    for (int i = 0; i < 3; i++) {
        fprintf(stderr, "    corner %d: (%" PRId32 ",%" PRId32 ")\n", i, t->corner[i].x,
                t->corner[i].y);
    }
}

/* What the triangles of a test were, so that it cannot pass for want of cases. */
struct tally {
    size_t kinds[TRIANGLE_WHOLE + 1];
    bool wrong;
};

/* Classify `count` triangles, behind which are others, and compare. */
static void check_batch(const struct triangle triangles[BATCH_SIZE], size_t count,
                        const struct draw_call *call, bool skip, struct tally *tally) {
    struct batch batch;
    memset(&batch, 0x55, sizeof batch);
    batch.count = count;
    for (size_t at = 0; at < BATCH_SIZE; at++) {
        put(&batch, at, &triangles[at]);
    }
    batch_classify(&batch, call, skip);
    for (size_t at = 0; at < count && !tally->wrong; at++) {
        struct answer answer = find_answer(&triangles[at], call, skip);
        tally->kinds[answer.kind]++;
        tally->wrong = !CHECK(is_answer(&batch, at, &answer));
        if (tally->wrong) {
            print_triangle(&triangles[at]);
        }
    }
}

/* ---- Triangles ---- */

/* On a centre of the pixels from there on, beside one, or anywhere. */
static int32_t any_place(struct random *random, int pixel, int pixels) {
    int32_t center = 256 * (int32_t)random_between(random, pixel, pixel + pixels - 1) + 128;
    switch (random_bits(random) % 4) {
    case 0:
        return center;
    case 1:
        return center + (int32_t)random_between(random, -1, 1);
    default:
        return (int32_t)random_between(random, 256 * pixel, 256 * (pixel + pixels));
    }
}

/* A triangle of a few pixels; often with an edge along a row or column, or without area. */
static struct triangle small_triangle(struct random *random, const struct rectangle *viewport) {
    struct triangle t = {0};
    int x = (int)random_between(random, viewport->x - 2, viewport->x + viewport->width);
    int y = (int)random_between(random, viewport->y - 2, viewport->y + viewport->height);
    int columns = (int)random_between(random, 1, 3), rows = (int)random_between(random, 1, 3);
    int32_t grid = random_bits(random) % 3 ? 1 : 128;
    for (int i = 0; i < 3; i++) {
        t.corner[i].x = any_place(random, x, columns) / grid * grid;
        t.corner[i].y = any_place(random, y, rows) / grid * grid;
    }
    return t;
}

static int32_t far_place(struct random *random, int pixel, int pixels) {
    switch (random_bits(random) % 3) {
    case 0:
        return random_bits(random) % 2 ? FARTHEST : -FARTHEST;
    case 1:
        return (int32_t)random_between(random, -FARTHEST, FARTHEST);
    default:
        return any_place(random, pixel, pixels);
    }
}

/* One that reaches far out of the viewport, or lies there; often a thin one. */
static struct triangle large_triangle(struct random *random, const struct rectangle *viewport) {
    struct triangle t = small_triangle(random, viewport);
    uint64_t axes = random_bits(random) % 3 + 1;
    for (int i = 0; i < 3; i++) {
        if (axes & 1) {
            t.corner[i].x = far_place(random, viewport->x, viewport->width + 1);
        }
        if (axes & 2) {
            t.corner[i].y = far_place(random, viewport->y, viewport->height + 1);
        }
    }
    return t;
}

/* What its corners are beyond: anything; ~0 is that of a corner that is no number. */
static void set_beyond(struct random *random, struct triangle *t) {
    t->beyond_all = ~0;
    for (int i = 0; i < 3; i++) {
        int32_t beyond = random_bits(random) % 3 ? 1 << random_bits(random) % 6 : 0;
        beyond |= random_bits(random) % 8 == 0 ? 1 << random_bits(random) % 6 : 0;
        beyond = random_bits(random) % 16 == 0 ? ~0 : beyond;
        t->beyond_all &= beyond;
        t->beyond_any |= beyond;
    }
}

typedef struct triangle make_triangle(struct random *random, const struct rectangle *viewport);

/* A draw call into some part of the largest image. */
static struct draw_call any_call(struct random *random) {
    static const int sides[] = {0, 1, 2, 5, 8, 12, 16, 20};
    int width = sides[random_bits(random) % 8];
    int height = sides[random_bits(random) % 8];
    bool at_begin = random_bits(random) % 2;
    struct rectangle viewport = {.width = width, .height = height};
    viewport.x = (int)random_between(random, 0, at_begin ? 2 : DRAW_LIMIT - width);
    viewport.y = (int)random_between(random, 0, at_begin ? 2 : DRAW_LIMIT - height);
    return (struct draw_call){.viewport = viewport, .cull = (enum cull)(random_bits(random) % 3)};
}

static void check_batches(uint64_t seed, int rounds, make_triangle *make, bool beyond,
                          struct tally *tally) {
    struct random random = {seed};
    for (int round = 0; round < rounds && !tally->wrong; round++) {
        struct draw_call call = any_call(&random);
        struct triangle triangles[BATCH_SIZE];
        for (int i = 0; i < BATCH_SIZE; i++) {
            triangles[i] = make(&random, &call.viewport);
            if (beyond) {
                set_beyond(&random, &triangles[i]);
            }
        }
        size_t count = (size_t)(round % BATCH_SIZE) + 1;
        check_batch(triangles, count, &call, true, tally);
        check_batch(triangles, count, &call, false, tally);
    }
}

static void test_small(void) {
    struct tally tally = {0};
    check_batches(201, 2000, small_triangle, false, &tally);
    CHECK(tally.kinds[TRIANGLE_WHOLE] > 5000 && tally.kinds[TRIANGLE_WITHOUT_PIXEL] > 5000 &&
          tally.kinds[TRIANGLE_TURNED_AWAY] > 5000);
}

static void test_large(void) {
    struct tally tally = {0};
    check_batches(202, 1500, large_triangle, false, &tally);
    CHECK(tally.kinds[TRIANGLE_WHOLE] > 2000 && tally.kinds[TRIANGLE_WITHOUT_PIXEL] > 2000 &&
          tally.kinds[TRIANGLE_TURNED_AWAY] > 2000);
}

static void test_beyond(void) {
    struct tally tally = {0};
    check_batches(203, 300, small_triangle, true, &tally);
    for (int kind = 0; kind <= TRIANGLE_WHOLE; kind++) {
        CHECK(tally.kinds[kind] > 100);
    }
}

/* A side along one axis, at the ends of what areas in 32 bits allow. */
static int32_t any_side(struct random *random, int32_t longest) {
    int32_t side =
        random_bits(random) % 2 ? longest : (int32_t)random_between(random, longest / 2, longest);
    return random_bits(random) % 2 ? -side : side;
}

/* Areas are found in 32 bits where all sides of several triangles allow that: here all do, or one
 * side of each does not. */
static void test_sides(void) {
    enum { LONGEST = (1 << 15) - 1 };
    struct draw_call call = {.viewport = {0, 0, 16, 16}};
    struct random random = {204};
    struct tally tally = {0};
    for (int round = 0; round < 900 && !tally.wrong; round++) {
        struct triangle triangles[BATCH_SIZE] = {0};
        for (int i = 0; i < BATCH_SIZE; i++) {
            int32_t side[4]; /* x and y from corner 0 to 1, and to 2 */
            for (int k = 0; k < 4; k++) {
                side[k] = any_side(&random, round % 5 == k ? 2 * LONGEST + 1 : LONGEST);
            }
            triangles[i].corner[1] = (struct fixed2){side[0], side[1]};
            triangles[i].corner[2] = (struct fixed2){side[2], side[3]};
        }
        call.cull = (enum cull)(round % 3);
        check_batch(triangles, BATCH_SIZE, &call, true, &tally);
    }
    CHECK(tally.kinds[TRIANGLE_TURNED_AWAY] > 10000 && tally.kinds[TRIANGLE_WHOLE] > 5000);
}

/* Long ones whose area is as small as can be: doubled, it is 1 or -1. */
static void test_slivers(void) {
    struct draw_call call = {.viewport = {0, 0, 16, 16}, .cull = CULL_BACK};
    struct random random = {205};
    struct tally tally = {0};
    for (int round = 0; round < 30; round++) {
        struct triangle triangles[BATCH_SIZE] = {0};
        for (int i = 0; i < BATCH_SIZE; i++) {
            int32_t y = (int32_t)random_between(&random, 1, FARTHEST / 2 - 1), x = y + 1;
            int first = i % 2 + 1;
            triangles[i].corner[first] = (struct fixed2){x, y};
            triangles[i].corner[3 - first] = (struct fixed2){2 * x - 1, 2 * y - 1};
        }
        check_batch(triangles, BATCH_SIZE, &call, true, &tally);
    }
    CHECK(tally.kinds[TRIANGLE_TURNED_AWAY] == 30 * BATCH_SIZE / 2);
}

UNIT_MAIN(TEST(test_small), TEST(test_large), TEST(test_beyond), TEST(test_sides),
          TEST(test_slivers))
