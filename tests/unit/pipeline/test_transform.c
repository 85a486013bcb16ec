/*
 * The positions of a model, transformed several at once by the pipeline, against the same one by
 * one: mat4_point(), find_beyond() of lesson 8 with the guard band of the viewport, and
 * screen_snap().
 */
#include "../../../common/pipeline/assemble.c"

#include "oracle/oracle.h"
#include "unit/unit.h"

#include <float.h>

enum { COUNT = BLOCK_SIZE + 3 * TOGETHER + 1, ROUNDED = COUNT + TOGETHER, RUNS = 60 };

static struct random random_state = {9};

/* What one position becomes. */
struct expected {
    struct fixed2 screen;
    double depth, recip_w;
    unsigned beyond;
};

/* Section 8e of lesson 8; of viewports larger than 2048 pixels, 2^16 pixels from the middle. */
static unsigned beyond_of(struct vec4 p, const struct rectangle *v) {
    int side = v->width > v->height ? v->width : v->height;
    double guard = (side <= 2048 ? 64 : 2 * 65536.0 / side) * p.w;
    unsigned beyond = 0;
    beyond |= p.x >= -p.w ? 0 : BEYOND_LEFT;
    beyond |= p.x <= p.w ? 0 : BEYOND_RIGHT;
    beyond |= p.y >= -p.w ? 0 : BEYOND_BOTTOM;
    beyond |= p.y <= p.w ? 0 : BEYOND_TOP;
    beyond |= p.w >= 1.0 / 128 ? 0 : BEYOND_NEAR;
    beyond |= fabs(p.x) <= guard && fabs(p.y) <= guard ? 0 : BEYOND_GUARD_BAND;
    return beyond;
}

static struct expected expect(const struct draw_call *call, struct vec3 position) {
    const struct rectangle *v = &call->viewport;
    struct vec4 clip = mat4_point(&call->to_clip, position);
    struct expected e = {.beyond = beyond_of(clip, v)};
    double recip_w = 1 / clip.w, depth = clip.z * recip_w;
    struct vec2 screen = {v->x + (clip.x * recip_w + 1) * (v->width / 2.0),
                          v->y + (clip.y * recip_w + 1) * (v->height / 2.0)};
    if ((e.beyond & (BEYOND_NEAR | BEYOND_GUARD_BAND)) != 0) {
        return e;
    }
    if (fabs(depth) <= 1e280 && screen_snap(screen, &e.screen)) {
        e.depth = depth;
        e.recip_w = recip_w;
    } else {
        e.beyond = BEYOND_ALL;
    }
    return e;
}

static bool same_double(double a, double b) {
    return memcmp(&a, &b, sizeof a) == 0;
}

/* A number for a place: most lie in view, some on a border, some are no place at all. */
static double hostile(void) {
    static const double special[] = {0,     -0.0,   1,       -1,  64,      -64,
                                     1e300, -1e300, DBL_MIN, NAN, INFINITY};
    int kind = (int)random_between(&random_state, 0, 9);
    return kind > 1    ? random_real(&random_state, -1.5, 1.5)
           : kind == 1 ? ldexp(random_real(&random_state, -1, 1),
                               (int)random_between(&random_state, -30, 30))
                       : special[random_between(&random_state, 0, 10)];
}

/* As it is, in perspective, or anything. */
static struct mat4 random_matrix(int run) {
    struct mat4 m = mat4_identity();
    if (run % 3 == 1) {
        m.m[3][2] = -0.4;
    }
    for (int i = 0; run % 3 == 2 && i < 16; i++) {
        m.m[i / 4][i % 4] = hostile();
    }
    return m;
}

/* Of that many positions. Returns how many differ. */
static size_t count_wrong(size_t count, const struct draw_call *call) {
    static struct fixed2 screen[ROUNDED];
    static double depth[ROUNDED], recip_w[ROUNDED];
    static uint8_t beyond[ROUNDED];
    struct recorded_call recorded = {.call = *call, .guard_band = guard_band_of(&call->viewport)};
    struct block blocks[COUNT / BLOCK_SIZE + 1];
    struct frame frame = {
        .screen = screen, .depth = depth, .recip_w = recip_w, .beyonds = beyond, .blocks = blocks};
    unsigned any = 0;
    size_t wrong = 0;
    memset(screen, 1, sizeof screen);
    memset(depth, 1, sizeof depth);
    for (size_t block = 0; block * BLOCK_SIZE < count; block++) {
        blocks[block] = (struct block){.call = &recorded, .begin = block * BLOCK_SIZE};
        transform_block(&frame, block, 0);
    }
    for (size_t i = 0; i < count; i++) {
        struct expected e = expect(call, call->model->positions[i]);
        bool same = screen[i].x == e.screen.x && screen[i].y == e.screen.y &&
                    same_double(depth[i], e.depth) && same_double(recip_w[i], e.recip_w) &&
                    beyond[i] == e.beyond;
        wrong += !same;
        any |= e.beyond;
    }
    return wrong + (recorded.beyond != any);
}

static void test_positions(void) {
    static struct vec3 positions[COUNT];
    static const size_t counts[] = {COUNT, BLOCK_SIZE, 1, TOGETHER - 1, TOGETHER, TOGETHER + 1};
    static const struct rectangle viewports[] = {
        {3, 4, 640, 480}, {1, 0, 2048, 2047}, {0, 2, 480, 3001}, {0, 0, 16384, 16384}};
    struct model model = {.positions = positions};
    size_t placed = 0;
    for (int run = 0; run < RUNS; run++) {
        struct draw_call call = {
            .model = &model, .to_clip = random_matrix(run), .viewport = viewports[run % 4]};
        for (size_t i = 0; i < COUNT; i++) {
            positions[i] = (struct vec3){hostile(), hostile(), hostile()};
            placed += expect(&call, positions[i]).beyond != BEYOND_ALL;
        }
        for (size_t i = 0; i < sizeof counts / sizeof counts[0]; i++) {
            model.position_count = counts[i];
            CHECK(count_wrong(counts[i], &call) == 0);
        }
    }
    CHECK(placed > (size_t)RUNS * COUNT / 4 && placed < (size_t)RUNS * COUNT);
}

/* 2^16 pixels to each side, but for roundings: no side between two positions is longer than 2^25
 * steps, and edge functions are exact in double. */
static void test_guard_band(void) {
    bool right = true;
    for (int side = 1; side <= DRAW_LIMIT; side++) {
        double wide = guard_band_of(&(struct rectangle){0, 0, side, 1});
        double high = guard_band_of(&(struct rectangle){5, 7, side / 2, side});
        double expected = side < 2048 ? 64 : 65536 / (side / 2.0);
        right = right && fabs(wide - expected) < 1e-12 && high == wide;
    }
    CHECK(right);
    CHECK(guard_band_of(&(struct rectangle){0, 0, 0, 0}) == 64);
}

/* Halves of 1/256 pixel, below 0 and above, are rounded up. */
static void test_snapped(void) {
    for (int i = -2000; i <= 2000; i++) {
        double place = i / 2048.0;
        struct fixed2 one = {0, 0};
        CHECK(screen_snap((struct vec2){place, 0}, &one));
        CHECK(snap(doubles_all(place))[TOGETHER - 1] == one.x);
    }
}

UNIT_MAIN(TEST(test_positions), TEST(test_guard_band), TEST(test_snapped))
