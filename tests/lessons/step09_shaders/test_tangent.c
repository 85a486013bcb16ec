/* On a board that looks along z, with u along x and v along y, both spaces are one: the shaders for
 * maps in tangent space draw what those of the lesson draw. On a board that was turned they draw
 * what it was before, in a light that was turned with it. */
#define LESSON "../step09_shaders/main.c"
#include "lesson.h"

#include "lessons/board.h"

/* The picture of the pipeline, or of simple_draw(). */
static struct image draw(struct drawing drawing, bool simple) {
    static const struct simple_cell mapped = {&simple_normal_mapped, CULL_BACK, 1, {0, 0, 0}};
    const struct simple_cell cells[4] = {mapped, mapped, mapped, mapped};
    struct image image = new_image(BOARD_SIZE, BOARD_SIZE, IMAGE_BGR);
    struct pipeline pipeline = {0};
    struct error error;
    double depth[BOARD_SIZE * BOARD_SIZE];
    depth_clear(depth, sizeof depth / sizeof *depth);
    drawing.state = &pipeline;
    drawing.depth = depth;
    CHECK(pipeline_create(&pipeline, BOARD_SIZE, BOARD_SIZE, &error) &&
          (simple ? draw_simple_cells(&drawing, &image, cells)
                  : draw_normal_map(&drawing, &image, &error)));
    pipeline_free(&pipeline);
    return image;
}

static void test_shaders(void) {
    static const int turns[][3] = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {1, 2, 3}};
    struct texture diffuse = noise(1), map = noise(2);
    for (size_t i = 0; i < 2 * 4; i++) {
        struct drawing drawing = {.model = &board, .skip = true};
        drawing.diffuse = &diffuse;
        drawing.normal_map = &map;
        drawing.eye = (struct vec3){0.5, 0.25, 2};
        drawing.up = (struct vec3){0, 1, 0};
        drawing.light = (struct vec3){1, 0.5, 0.75};
        map.tangent_space = false;
        lay_board((const int[3]){0, 0, 0});
        struct image expected = draw(drawing, i < 4);
        map.tangent_space = true;
        turn_board(&drawing, turns[i % 4]);
        struct image image = draw(drawing, i < 4);
        CHECK(nearly_same(&image, &expected));
        image_free(&image);
        image_free(&expected);
    }
    texture_free(&diffuse);
    texture_free(&map);
}

UNIT_MAIN(TEST(test_shaders))
