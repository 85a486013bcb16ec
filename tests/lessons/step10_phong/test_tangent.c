/* Maps in tangent space: see board.h. */
#define LESSON "../step10_phong/main.c"
#include "lesson.h"

#include "lessons/board.h"

static const struct shader *const shaders[] = {&mapped,       &full,     &weight_mapped,
                                               &power_mapped, &textured, &plain};

/* The picture of a shader of the lesson, or of the one that replaces it. */
static struct image draw(struct drawing drawing, size_t way) {
    struct image image = new_image(BOARD_SIZE, BOARD_SIZE, IMAGE_BGR);
    struct pipeline pipeline = {0};
    struct error error;
    const struct cell cell = {shaders[way], textured_material, NULL, NULL};
    drawing.state = &pipeline;
    CHECK(pipeline_create(&pipeline, BOARD_SIZE, BOARD_SIZE, &error) &&
          draw_cells(&drawing, &image, &cell, 1, 1, 1, &error));
    pipeline_free(&pipeline);
    return image;
}

static void test_shaders(void) {
    check_board(draw, sizeof shaders / sizeof shaders[0]);
}

UNIT_MAIN(TEST(test_shaders))
