/* What lesson 5 promises: where two triangles have the same depth at all corners, the one that was
 * drawn first stays, in each pixel that both cover. */
#define LESSON "../step05_zbuffer/main.c"
#include "lesson.h"

#include "oracle/oracle.h"
#include "unit/unit.h"

enum { SIDE = 32, ROUNDS = 400 };

/* A triangle that faces the camera: all of it is at one depth. */
struct level_triangle {
    struct fixed2 corner[3];
    double depth;
    uint8_t level; /* its grey */
};

/* In this order, into a black image. */
static void draw(struct image *image, const struct level_triangle *triangles, size_t count) {
    double depth[SIDE * SIDE];
    struct canvas canvas = {.image = image, .depth = depth};
    image_clear(image, color_grey(0));
    depth_clear(depth, SIDE * SIDE);
    for (size_t i = 0; i < count; i++) {
        const struct level_triangle *t = &triangles[i];
        struct vertex v[3];
        for (int k = 0; k < 3; k++) {
            v[k] = (struct vertex){.position = t->corner[k], .depth = t->depth};
        }
        triangle(&canvas, v, color_grey(t->level));
    }
}

static struct level_triangle random_triangle(struct random *random, double depth, uint8_t level) {
    struct level_triangle triangle = {.depth = depth, .level = level};
    for (int i = 0; i < 3; i++) {
        triangle.corner[i].x = (int32_t)random_between(random, -2000, SIDE * 256 + 2000);
        triangle.corner[i].y = (int32_t)random_between(random, -2000, SIDE * 256 + 2000);
    }
    return triangle;
}

static bool is_black(struct color color) {
    return color.b == 0 && color.g == 0 && color.r == 0;
}

/* How many pixels both cover, and in how many of them the image does not show the first one. */
static void compare_ties(const struct image *image, const struct image *first,
                         const struct image *second, size_t *shared, size_t *wrong) {
    for (int i = 0; i < SIDE * SIDE; i++) {
        int x = i % SIDE, y = i / SIDE;
        struct color color = image_get(first, x, y), seen = image_get(image, x, y);
        if (!is_black(color) && !is_black(image_get(second, x, y))) {
            *shared += 1;
            *wrong += seen.b != color.b || seen.g != color.g || seen.r != color.r;
        }
    }
}

static void test_ties(void) {
    struct random random = {51};
    struct error error;
    struct image image[3] = {{0}}; /* one triangle, the other, both */
    size_t shared = 0, wrong = 0;
    for (int i = 0; i < 3; i++) {
        if (!CHECK(image_create(&image[i], SIDE, SIDE, IMAGE_BGR, &error))) {
            return;
        }
    }
    for (int i = 0; i < ROUNDS; i++) {
        double depth = i == 0 ? 0.25 : random_real(&random, -1, 1);
        struct level_triangle pair[2] = {random_triangle(&random, depth, 100),
                                         random_triangle(&random, depth, 200)};
        struct level_triangle turned[2] = {pair[1], pair[0]};
        draw(&image[0], &pair[0], 1);
        draw(&image[1], &pair[1], 1);
        draw(&image[2], pair, 2);
        compare_ties(&image[2], &image[0], &image[1], &shared, &wrong);
        draw(&image[2], turned, 2);
        compare_ties(&image[2], &image[1], &image[0], &shared, &wrong);
    }
    CHECK(shared > 50 * ROUNDS);
    if (!CHECK(wrong == 0)) {
        fprintf(stderr, "    %zu of %zu pixels show the second one\n", wrong, shared);
    }
    for (int i = 0; i < 3; i++) {
        image_free(&image[i]);
    }
}

UNIT_MAIN(TEST(test_ties))
