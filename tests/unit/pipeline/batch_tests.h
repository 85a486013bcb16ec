/*
 * pipeline_batch.c against plain answers: one triangle at a time, one pixel centre at a time, with
 * the oracle's turns and coverage. Included by programs that have chosen REAL and LANES, or not.
 */
#ifndef TESTS_BATCH_TESTS_H
#define TESTS_BATCH_TESTS_H

#include "oracle/oracle.h"
#include "pipeline/parts.h"
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
    bool culled;
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
    if (skip && is_culled(t, call->cull)) {
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
        .culled = is_culled(t, call->cull),
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
        batch->screen[i][at] = t->corner[i];
    }
    batch->beyond_all[at] = t->beyond_all;
    batch->beyond_any[at] = t->beyond_any;
}

/* Of what is not whole only the kind is promised. */
static bool is_answer(const struct batch *batch, size_t at, const struct answer *answer) {
    if (batch->kind[at] != (int32_t)answer->kind || answer->kind != TRIANGLE_WHOLE) {
        return batch->kind[at] == (int32_t)answer->kind;
    }
    return (batch->culled[at] != 0) == answer->culled && batch->first[at] == answer->first &&
           batch->second[at] == answer->second && batch->left[at] == answer->seen.left &&
           batch->right[at] == answer->seen.right && batch->bottom[at] == answer->seen.bottom &&
           batch->top[at] == answer->seen.top;
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
    /* Those with an area that are drawn or have no pixel, by the columns and rows of their box. */
    size_t missed[4][4], hit[4][4];
    size_t lost; /* without a pixel, it is said, but they cover a centre in the viewport */
    size_t kept; /* tiny ones that miss all centres, and are not found with skip */
    bool wrong;
};

static void count_one(struct tally *tally, const struct triangle *t, const struct draw_call *call,
                      bool skip, int32_t kind) {
    const struct fixed2 *c = t->corner;
    struct centers box = centers_of(c);
    if ((kind != TRIANGLE_WITHOUT_PIXEL && kind != TRIANGLE_WHOLE) ||
        oracle_turn(c[0], c[1], c[2]) == 0) {
        return;
    }
    tally->lost +=
        kind == TRIANGLE_WITHOUT_PIXEL && count_covered(c, centers_in(box, &call->viewport)) > 0;
    int columns = box.right - box.left + 1, rows = box.top - box.bottom + 1;
    if (columns < 4 && rows < 4) {
        size_t covered = count_covered(c, box);
        tally->kept += skip && is_tiny(box) && covered == 0 && kind == TRIANGLE_WHOLE;
        tally->missed[columns][rows] += covered == 0;
        tally->hit[columns][rows] += covered > 0;
    }
}

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
        count_one(tally, &triangles[at], call, skip, batch.kind[at]);
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
    for (int i = 0; i < 3; i++) {
        t.corner[i].x = any_place(random, x, columns);
        t.corner[i].y = any_place(random, y, rows);
    }
    struct fixed2 *c = t.corner;
    uint64_t from = random_bits(random) % 3, to = random_bits(random) % 3;
    switch (random_bits(random) % 16) {
    case 0:
    case 1:
        c[to].x = c[from].x;
        break;
    case 2:
    case 3:
        c[to].y = c[from].y;
        break;
    case 4:
        c[0].x = (c[1].x & ~1) + (c[2].x & ~1);
        c[0].y = (c[1].y & ~1) + (c[2].y & ~1);
        c[0] = (struct fixed2){c[0].x / 2, c[0].y / 2};
        c[1] = (struct fixed2){c[1].x & ~1, c[1].y & ~1};
        c[2] = (struct fixed2){c[2].x & ~1, c[2].y & ~1};
        break;
    case 5:
        c[to] = c[from];
        break;
    default:
        break;
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
    CHECK(tally->lost == 0 && tally->kept == 0);
}

/* Of each size of box, from one centre to 3x3, some that miss all centres and some that do not. */
static void test_small(void) {
    struct tally tally = {0};
    check_batches(201, 2000, small_triangle, false, &tally);
    for (int columns = 1; columns <= 3; columns++) {
        for (int rows = 1; rows <= 3; rows++) {
            CHECK(tally.missed[columns][rows] > 50 && tally.hit[columns][rows] > 200);
        }
    }
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

/* Every triangle between points of a grid of half pixels, its first corner moved a little: edges
 * through centres and along rows and columns, in every order of the corners. */
static void test_half_pixels(void) {
    enum { STEPS = 5, POINTS = STEPS * STEPS };
    struct draw_call call = {.viewport = {0, 0, 2, 2}};
    struct triangle triangles[BATCH_SIZE] = {0};
    struct tally tally = {0};
    size_t count = 0;
    for (int i = 0; i < POINTS * POINTS * POINTS && !tally.wrong; i++) {
        int point[3] = {i % POINTS, i / POINTS % POINTS, i / POINTS / POINTS};
        for (int k = 0; k < 3; k++) {
            triangles[count].corner[k] = (struct fixed2){
                point[k] % STEPS * 128, point[k] / STEPS * 128 + (k == 0) * (i % 3)};
        }
        if (++count == BATCH_SIZE || i + 1 == POINTS * POINTS * POINTS) {
            call.cull = (enum cull)(i / BATCH_SIZE % 3);
            check_batch(triangles, count, &call, true, &tally);
            count = 0;
        }
    }
    CHECK(tally.lost == 0 && tally.kept == 0 && tally.hit[2][2] > 1000);
}

/* ---- Meshes ---- */

enum { MESH_SIDE = 10, MESH_TRIANGLES = 2 * MESH_SIDE * MESH_SIDE, VIEW_SIDE = 12 };

/* Triangles that fill a square together. */
struct mesh {
    struct triangle triangles[MESH_TRIANGLES];
    size_t count;
    struct fixed2 least, greatest; /* corners of the square */
};

static void add_triangle(struct mesh *mesh, struct fixed2 a, struct fixed2 b, struct fixed2 c) {
    mesh->triangles[mesh->count++] = (struct triangle){.corner = {a, b, c}};
}

static void place_square(struct random *random, struct mesh *mesh, int32_t side) {
    mesh->count = 0;
    mesh->least.x = (int32_t)random_between(random, -300, 600);
    mesh->least.y = (int32_t)random_between(random, -300, 600);
    mesh->greatest = (struct fixed2){mesh->least.x + side, mesh->least.y + side};
}

/* A grid whose inner points are moved by at most `shift`. */
static void make_grid(struct random *random, struct mesh *mesh, int32_t step, int32_t shift) {
    struct fixed2 p[MESH_SIDE + 1][MESH_SIDE + 1];
    place_square(random, mesh, step * MESH_SIDE);
    for (int y = 0; y <= MESH_SIDE; y++) {
        for (int x = 0; x <= MESH_SIDE; x++) {
            bool inner = x > 0 && y > 0 && x < MESH_SIDE && y < MESH_SIDE;
            int32_t most = inner ? shift : 0;
            p[y][x].x = mesh->least.x + x * step + (int32_t)random_between(random, -most, most);
            p[y][x].y = mesh->least.y + y * step + (int32_t)random_between(random, -most, most);
        }
    }
    for (int y = 0; y < MESH_SIDE; y++) {
        for (int x = 0; x < MESH_SIDE; x++) {
            struct fixed2 a = p[y][x], b = p[y][x + 1], c = p[y + 1][x + 1], d = p[y + 1][x];
            bool rising = random_bits(random) % 2;
            add_triangle(mesh, a, b, rising ? c : d);
            add_triangle(mesh, rising ? a : b, c, d);
        }
    }
}

/* The place so far along the square's sides, counterclockwise, in quarters of the way. */
static struct fixed2 place_on_square(const struct mesh *mesh, double way) {
    int32_t side = mesh->greatest.x - mesh->least.x, part = (int32_t)((way - floor(way)) * side);
    struct fixed2 a = mesh->least, b = mesh->greatest;
    switch ((int)way % 4) {
    case 0:
        return (struct fixed2){a.x + part, a.y};
    case 1:
        return (struct fixed2){b.x, a.y + part};
    case 2:
        return (struct fixed2){b.x - part, b.y};
    default:
        return (struct fixed2){a.x, b.y - part};
    }
}

/* Slivers from a point, which may lie outside, to pieces of the square's sides. */
static void make_fan(struct random *random, struct mesh *mesh, int32_t side, int32_t shift) {
    place_square(random, mesh, side);
    struct fixed2 middle = {mesh->least.x + side / 2, mesh->least.y + side / 2};
    middle.x += (int32_t)random_between(random, -shift, shift);
    middle.y += (int32_t)random_between(random, -shift, shift);
    for (int i = 0; i < MESH_TRIANGLES; i++) {
        add_triangle(mesh, middle, place_on_square(mesh, 4.0 * i / MESH_TRIANGLES),
                     place_on_square(mesh, 4.0 * (i + 1) / MESH_TRIANGLES));
    }
}

/* Classify the mesh and count, at each pixel, the whole triangles that cover it: one that is
 * clockwise, where the mesh is folded, takes away what others cover twice. */
static void cover_mesh(const struct mesh *mesh, const struct draw_call *call, size_t batch_size,
                       int covered[VIEW_SIDE][VIEW_SIDE], size_t *left_out) {
    for (size_t first = 0; first < mesh->count; first += batch_size) {
        struct batch batch = {.count = 0};
        while (batch.count < batch_size && first + batch.count < mesh->count) {
            put(&batch, batch.count, &mesh->triangles[first + batch.count]);
            batch.count++;
        }
        batch_classify(&batch, call, true);
        for (size_t at = 0; at < batch.count; at++) {
            const struct fixed2 *c = mesh->triangles[first + at].corner;
            *left_out += batch.kind[at] == TRIANGLE_WITHOUT_PIXEL;
            for (int y = batch.bottom[at]; y <= batch.top[at]; y++) {
                for (int x = batch.left[at];
                     batch.kind[at] == TRIANGLE_WHOLE && x <= batch.right[at]; x++) {
                    covered[y][x] +=
                        oracle_covers(c[0], c[1], c[2], x, y) * oracle_turn(c[0], c[1], c[2]);
                }
            }
        }
    }
}

/* Each pixel whose centre is in the square, or on its left or upper side, once, and no other. */
static bool covers_once(const struct mesh *mesh, int covered[VIEW_SIDE][VIEW_SIDE]) {
    bool once = true;
    for (int y = 0; y < VIEW_SIDE; y++) {
        for (int x = 0; x < VIEW_SIDE; x++) {
            int center_x = 256 * x + 128, center_y = 256 * y + 128;
            bool inside = center_x >= mesh->least.x && center_x < mesh->greatest.x &&
                          center_y > mesh->least.y && center_y <= mesh->greatest.y;
            once = once && covered[y][x] == inside;
        }
    }
    return once;
}

/* Grids as they are, folded ones, and fans from inside and outside; where all triangles face the
 * viewer, half of the meshes are culled. */
static void test_meshes(void) {
    struct random random = {204};
    size_t left_out = 0, all = 0;
    for (int round = 0; round < 600; round++) {
        static struct mesh mesh;
        int covered[VIEW_SIDE][VIEW_SIDE] = {{0}};
        int32_t step = (int32_t)random_between(&random, 5, 300);
        bool folded = round % 3 == 1;
        struct draw_call call = {.viewport = {0, 0, VIEW_SIDE, VIEW_SIDE},
                                 .cull = folded || round % 2 ? CULL_NONE : CULL_BACK};
        if (round % 3 < 2) {
            make_grid(&random, &mesh, step, folded ? 2 * step : step / 5);
        } else {
            make_fan(&random, &mesh, step * MESH_SIDE, step * MESH_SIDE / 4 * (1 + round % 2 * 3));
        }
        size_t batch_size = (size_t)random_between(&random, 1, BATCH_SIZE);
        cover_mesh(&mesh, &call, batch_size, covered, &left_out);
        CHECK(covers_once(&mesh, covered));
        all += mesh.count;
    }
    CHECK(left_out > all / 4);
}

UNIT_MAIN(TEST(test_small), TEST(test_large), TEST(test_beyond), TEST(test_sides),
          TEST(test_slivers), TEST(test_half_pixels), TEST(test_meshes))

#endif
