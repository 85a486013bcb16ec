/* Lesson 8: equal depths. */
#define LESSON "../step08_projection/main.c"
#include "lesson.h"

#include "unit/ties.h"

static void draw(struct image *image, const struct level_triangle *triangles, size_t count) {
    double depth[TIES_SIDE * TIES_SIDE];
    uint32_t white[4] = {UINT32_MAX, UINT32_MAX, UINT32_MAX, UINT32_MAX};
    const struct texture texture = {
        .level = {{.width = 1, .height = 1, .pitch = 2, .texels = white}}, .level_count = 1};
    const struct canvas canvas = {
        .image = image, .depth = depth, .area = {0, 0, TIES_SIDE, TIES_SIDE}, .texture = &texture};
    image_clear(image, color_grey(0));
    depth_clear(depth, TIES_SIDE * TIES_SIDE);
    for (size_t i = 0; i < count; i++) {
        const struct level_triangle *t = &triangles[i];
        struct edges edges;
        struct vertex v[3];
        for (int k = 0; k < 3; k++) {
            v[k] = (struct vertex){.position = t->corner[k],
                                   .depth = t->depth,
                                   .recip_w = 0.5,
                                   .intensity = t->level / 255.0};
        }
        if (edges_setup(&edges, t->corner[0], t->corner[1], t->corner[2], TIES_SIDE, TIES_SIDE)) {
            triangle(&canvas, &edges, v);
        }
    }
}

static void test_ties(void) {
    check_ties(draw);
}

UNIT_MAIN(TEST(test_ties))
