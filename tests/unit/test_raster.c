/* Spans and single pixels: two answers to which pixels a triangle covers. */
#include "raster.h"

#include "oracle/oracle.h"
#include "unit/unit.h"

enum { SIDE = 20, REACH = 4 * SIDE };

static void test_spans_and_pixels(void) {
    struct random random = {7};
    size_t covered = 0;
    for (int i = 0; i < 200; i++) {
        struct fixed2 c[3];
        struct edges edges;
        for (int k = 0; k < 3; k++) {
            c[k].x = (int32_t)random_between(&random, -REACH, REACH) * 64; /* centres on edges */
            c[k].y = (int32_t)random_between(&random, -REACH, REACH) * 64;
        }
        if (!edges_setup(&edges, c[0], c[1], c[2], SIDE, SIDE)) {
            continue;
        }
        for (int y = edges.y_begin; y < edges.y_end; y++) {
            struct span span = edges_span(&edges, y);
            for (int x = 0; x < SIDE; x++) {
                bool in_span = x >= span.begin && x < span.end;
                CHECK(edges_cover(&edges, x, y) == in_span);
                covered += in_span;
            }
        }
    }
    CHECK(covered > 1000);
}

UNIT_MAIN(TEST(test_spans_and_pixels))
