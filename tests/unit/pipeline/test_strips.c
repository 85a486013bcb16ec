/*
 * In which rows of a strip of columns some pixel may be inside all edges: rows_of_strips() of the
 * pipeline, against each row in turn.
 */
#include "../../../common/pipeline/cover.c"

#include "oracle/oracle.h"
#include "unit/unit.h"

enum { RUNS = 4000, ROWS = 32 };

static struct random random_state = {17};

static int any_int(int least, int most) {
    return (int)random_between(&random_state, least, most);
}

/* Three corners, counterclockwise, near a box of ROWS rows or very far from it. */
static void any_corners(struct fixed2 corner[3]) {
    int reach = any_int(0, 3) > 0 ? 40 * SUBPIXELS : 1 << 23;
    int grid = any_int(0, 1) ? 1 : SUBPIXELS / 2;
    do {
        for (int i = 0; i < 3; i++) {
            corner[i] = (struct fixed2){any_int(-reach, reach) / grid * grid,
                                        any_int(-reach, reach) / grid * grid};
        }
    } while (oracle_turn(corner[0], corner[1], corner[2]) <= 0);
}

/* An edge function at the centre of a pixel, less what it must be at least: below 0 is outside. */
static int64_t inside_by(struct fixed2 a, struct fixed2 b, int x, int y) {
    int64_t along_x = (int64_t)b.x - a.x, along_y = (int64_t)b.y - a.y;
    int64_t right = (int64_t)x * SUBPIXELS + SUBPIXELS / 2 - a.x;
    int64_t up = (int64_t)y * SUBPIXELS + SUBPIXELS / 2 - a.y;
    bool top_left = along_y < 0 || (along_y == 0 && along_x < 0);
    return along_x * up - along_y * right - !top_left;
}

/* Some pixel of the strip is inside each of the edges that are not level. (Another pixel, perhaps,
 * of each.) */
static bool may_be_inside(const struct fixed2 corner[3], int x, int y) {
    bool may = true;
    for (int i = 0; i < 3; i++) {
        struct fixed2 a = corner[(i + 1) % 3], b = corner[(i + 2) % 3];
        may = may && (a.x == b.x || inside_by(a, b, x, y) >= 0 ||
                      inside_by(a, b, x + TOGETHER - 1, y) >= 0);
    }
    return may;
}

static void test_strips(void) {
    size_t empty = 0, whole = 0, part = 0;
    for (int run = 0; run < RUNS; run++) {
        struct fixed2 corner[3];
        int left = any_int(-40, 40), bottom = any_int(-40, 40), count = any_int(1, ROWS);
        any_corners(corner);
        struct box_edges edges = find_box_edges(corner, left, bottom);
        struct strip_rows rows = rows_of_strips(&edges, count);
        for (int i = 0; i < TOGETHER; i++) {
            int found = 0;
            bool same = true;
            for (int row = 0; row < count; row++) {
                bool may = may_be_inside(corner, left + i * TOGETHER, bottom + row);
                same = same && may == (row >= rows.begin[i] && row < rows.end[i]);
                found += may;
            }
            CHECK(same);
            CHECK(rows.begin[i] >= 0 && rows.begin[i] <= count);
            CHECK(rows.end[i] >= 0 && rows.end[i] <= count);
            empty += found == 0;
            whole += found == count;
            part += found > 0 && found < count;
        }
    }
    CHECK(empty > RUNS / 10 && whole > RUNS / 10 && part > RUNS / 10);
}

UNIT_MAIN(TEST(test_strips))
