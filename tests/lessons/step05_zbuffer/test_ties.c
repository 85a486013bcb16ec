/* Lesson 5: equal depths. */
#define LESSON "../step05_zbuffer/main.c"
#include "lesson.h"

#include "unit/ties.h"

static void draw(struct image *image, const struct level_triangle *triangles, size_t count) {
    double depth[TIES_SIDE * TIES_SIDE];
    struct canvas canvas = {.image = image, .depth = depth};
    image_clear(image, color_grey(0));
    depth_clear(depth, TIES_SIDE * TIES_SIDE);
    for (size_t i = 0; i < count; i++) {
        const struct level_triangle *t = &triangles[i];
        struct vertex v[3];
        for (int k = 0; k < 3; k++) {
            v[k] = (struct vertex){.position = t->corner[k], .depth = t->depth};
        }
        triangle(&canvas, v, color_grey(t->level));
    }
}

static void test_ties(void) {
    check_ties(draw);
}

UNIT_MAIN(TEST(test_ties))
