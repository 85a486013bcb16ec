/* Lesson 6: equal depths. */
#define LESSON "../step06_texture/main.c"
#include "lesson.h"

#include "unit/ties.h"

static void draw(struct image *image, const struct level_triangle *triangles, size_t count) {
    double depth[TIES_SIDE * TIES_SIDE];
    struct canvas canvas = {.image = image, .depth = depth, .skip = true};
    uint32_t white = UINT32_MAX;
    const struct texture texture = {
        .level = {{.width = 1, .height = 1, .pitch = 1, .texels = &white}}, .level_count = 1};
    image_clear(image, color_grey(0));
    depth_clear(depth, TIES_SIDE * TIES_SIDE);
    for (size_t i = 0; i < count; i++) {
        const struct level_triangle *t = &triangles[i];
        struct vertex v[3];
        for (int k = 0; k < 3; k++) {
            v[k] = (struct vertex){.position = t->corner[k], .depth = t->depth};
        }
        triangle(&canvas, v, &texture, t->level / 255.0);
    }
}

static void test_ties(void) {
    check_ties(draw);
}

UNIT_MAIN(TEST(test_ties))
