/* Maps in tangent space: see board.h. */
#define LESSON "../step09_shaders/main.c"
#include "lesson.h"

#include "lessons/board.h"

/* The picture of the pipeline, or of simple_draw(). */
static struct image draw(struct drawing drawing, size_t simple) {
    const struct simple_cell mapped = {&simple_normal_mapped, CULL_BACK, 1, drawing.eye};
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
    check_board(draw, 2);
}

UNIT_MAIN(TEST(test_shaders))
