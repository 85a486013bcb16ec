/* Small scopes, and every case in them, so that none is missed. Each answer is the definition in
 * its plainest form: the sign of a determinant, or a fraction. */
#include "lessons.h"
#include "stress.h"

#include <stdlib.h>

/* The next of the numbers 0..count-1 that `index` stands for, the last one first. */
static int digit(uint64_t *index, int count) {
    const int value = (int)(*index % (uint64_t)count);
    *index /= (uint64_t)count;
    return value;
}

/* ---- Triangles ---- */

/* Corners on a grid over so many pixels each way, with so many steps a pixel; the image lies around
 * them. */
struct small_triangle {
    struct fixed2 corner[4];
};

static struct fixed2 grid_corner(uint64_t *index, int side, int steps) {
    const int x = digit(index, side * steps), y = digit(index, side * steps);
    return (struct fixed2){x * SUBPIXELS / steps, y * SUBPIXELS / steps};
}

enum { SIDE = 4, STEPS = 4, PLACES = SIDE * STEPS * SIDE * STEPS };
enum {
    PAIR_SIDE = 3,
    PAIR_STEPS = 2,
    PAIR_PLACES = PAIR_SIDE * PAIR_STEPS * PAIR_SIDE * PAIR_STEPS
};

static void make_small(struct random *random, uint64_t index, void *made) {
    (void)random;
    for (int i = 0; i < 3; i++) {
        ((struct small_triangle *)made)->corner[i] = grid_corner(&index, SIDE, STEPS);
    }
}

static void make_pair(struct random *random, uint64_t index, void *made) {
    (void)random;
    for (int i = 0; i < 4; i++) {
        ((struct small_triangle *)made)->corner[i] = grid_corner(&index, PAIR_SIDE, PAIR_STEPS);
    }
}

/* On which side of the line from p to q is c: 1 left, -1 right, 0 on it? */
static int side_of(struct fixed2 p, struct fixed2 q, struct fixed2 c) {
    const int turn = (q.x - p.x) * (c.y - p.y) - (q.y - p.y) * (c.x - p.x);
    return (turn > 0) - (turn < 0);
}

/* The same after c has moved a hair to the right and a hair of a hair down; 0 where p is q. */
static int moved_side_of(struct fixed2 p, struct fixed2 q, struct fixed2 c) {
    const int side = side_of(p, q, c), right = (p.y > q.y) - (p.y < q.y);
    const int down = (p.x > q.x) - (p.x < q.x);
    return side != 0 ? side : right != 0 ? right : down;
}

static struct fixed2 center_of(int x, int y) {
    return (struct fixed2){x * SUBPIXELS + SUBPIXELS / 2, y * SUBPIXELS + SUBPIXELS / 2};
}

static bool plainly_covers(const struct fixed2 c[3], struct fixed2 center) {
    const int turn = side_of(c[0], c[1], c[2]);
    return turn != 0 && moved_side_of(c[0], c[1], center) == turn &&
           moved_side_of(c[1], c[2], center) == turn && moved_side_of(c[2], c[0], center) == turn;
}

/* Bit 8 y + x: is pixel (x,y) in its row's span? */
static uint64_t covered(struct fixed2 a, struct fixed2 b, struct fixed2 c, int side) {
    uint64_t pixels = 0;
    struct edges edges;
    if (edges_setup(&edges, a, b, c, (size_t)side, (size_t)side)) {
        for (int y = edges.y_begin; y < edges.y_end; y++) {
            const struct span span = edges_span(&edges, y);
            for (int x = span.begin; x < span.end; x++) {
                pixels |= UINT64_C(1) << (8 * y + x);
            }
        }
    }
    return pixels;
}

static bool small_is_exact(const void *tried) {
    const struct fixed2 *c = ((const struct small_triangle *)tried)->corner;
    const uint64_t pixels = covered(c[0], c[1], c[2], SIDE);
    bool right = true;
    for (int i = 0; i < SIDE * SIDE; i++) {
        const int x = i % SIDE, y = i / SIDE;
        right = right && (pixels >> (8 * y + x) & 1) == plainly_covers(c, center_of(x, y));
    }
    return right;
}

/* Two triangles on either side of an edge: no centre is in both, and each on the edge, between its
 * ends, is in one. (Where the fourth corner lies on the same side, there is no such pair.) */
static bool pair_is_exact(const void *tried) {
    const struct fixed2 *c = ((const struct small_triangle *)tried)->corner;
    if (side_of(c[0], c[1], c[2]) * side_of(c[0], c[1], c[3]) != -1) {
        return true;
    }
    const uint64_t one = covered(c[0], c[1], c[2], PAIR_SIDE),
                   other = covered(c[1], c[0], c[3], PAIR_SIDE);
    bool right = (one & other) == 0;
    for (int i = 0; i < PAIR_SIDE * PAIR_SIDE; i++) {
        const struct fixed2 center = center_of(i % PAIR_SIDE, i / PAIR_SIDE);
        const bool between =
            side_of(c[0], c[1], center) == 0 &&
            (center.x - c[0].x) * (center.x - c[1].x) + (center.y - c[0].y) * (center.y - c[1].y) <
                0;
        right = right &&
                (!between || ((one | other) >> (8 * (i / PAIR_SIDE) + i % PAIR_SIDE) & 1) != 0);
    }
    return right;
}

/* ---- Lines ---- */

enum { REACH = 24, ENDS = 2 * REACH + 1, WINDOW = 3 };

struct small_line {
    struct pixel a, b;
};

static struct pixel grid_end(uint64_t *index) {
    const int x = digit(index, ENDS), y = digit(index, ENDS);
    return (struct pixel){x - REACH, y - REACH};
}

static void make_line(struct random *random, uint64_t index, void *made) {
    (void)random;
    ((struct small_line *)made)->a = grid_end(&index);
    ((struct small_line *)made)->b = grid_end(&index);
}

/* Pixel k of the line, from its left or lower end: the one nearest to start + k * rise / run, at a
 * tie the one nearer to the start. Found by trying them. */
static struct pixel plain_pixel(const struct small_line *line, int k) {
    struct pixel a = line->a, b = line->b;
    const bool steep = abs(b.y - a.y) > abs(b.x - a.x);
    if (steep ? b.y < a.y : b.x < a.x) {
        a = line->b;
        b = line->a;
    }
    const int run = steep ? b.y - a.y : b.x - a.x, rise = steep ? b.x - a.x : b.y - a.y;
    int moved = 0; /* by which |2 run moved - 2 k rise| is least */
    while (run > 0 && 2 * run * moved + run < 2 * k * abs(rise)) {
        moved++;
    }
    moved *= rise < 0 ? -1 : 1;
    return steep ? (struct pixel){a.x + moved, a.y + k} : (struct pixel){a.x + k, a.y + moved};
}

static int plain_length(const struct small_line *line) {
    const int width = abs(line->b.x - line->a.x), height = abs(line->b.y - line->a.y);
    return (width > height ? width : height) + 1;
}

static bool is_pixel(struct pixel p, int x, int y) {
    return p.x == x && p.y == y;
}

/* Lesson 1's list. */
static bool line_is_exact(const void *tried) {
    const struct small_line *line = tried;
    struct pixel list[2 * REACH + 1];
    const int length = plain_length(line);
    bool right = lesson01_list(line->a, line->b, list) == (size_t)length;
    for (int k = 0; right && k < length; k++) {
        right = is_pixel(plain_pixel(line, k), list[k].x, list[k].y);
    }
    return right;
}

/* The walk in the window 0..2 x 0..2 is what of the whole line is there. */
static bool cut_is_exact(const void *tried) {
    const struct small_line *line = tried;
    struct line_walk walk;
    bool right = true, walks = line_begin(&walk, line->a, line->b, WINDOW, WINDOW);
    for (int k = 0; right && k < plain_length(line); k++) {
        const struct pixel p = plain_pixel(line, k);
        if (p.x >= 0 && p.x < WINDOW && p.y >= 0 && p.y < WINDOW) {
            right = walks && is_pixel(p, walk.x, walk.y);
            walks = walks && line_next(&walk);
        }
    }
    return right && !walks;
}

const struct property small_properties[] = {
    ALL("triangle: all on 4 x 4 pixels", (uint64_t)PLACES *PLACES *PLACES, struct small_triangle,
        make_small, small_is_exact),
    ALL("triangle: all pairs on 3 x 3 pixels",
        (uint64_t)PAIR_PLACES *PAIR_PLACES *PAIR_PLACES *PAIR_PLACES, struct small_triangle,
        make_pair, pair_is_exact),
    ALL("line: all within 24 pixels", (uint64_t)ENDS *ENDS *ENDS *ENDS, struct small_line,
        make_line, line_is_exact),
    ALL("line: all cut to 3 x 3 pixels", (uint64_t)ENDS *ENDS *ENDS *ENDS, struct small_line,
        make_line, cut_is_exact),
    {.name = NULL},
};
