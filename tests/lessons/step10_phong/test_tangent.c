/* On a board that looks along z, with u along x and v along y, both spaces are one: the shaders for
 * maps in tangent space draw what those of the lesson draw. On a board that was turned they draw
 * what it was before, in a light that was turned with it. */
#define LESSON "../step10_phong/main.c"
#include "lesson.h"

#include "lessons/board.h"

/* The picture of a shader of the lesson, or of the one that stands for it. */
static struct image draw(struct drawing drawing, const struct shader *shader) {
    struct image image = new_image(BOARD_SIZE, BOARD_SIZE, IMAGE_BGR);
    struct pipeline pipeline = {0};
    struct error error;
    const struct cell cell = {shader, textured_material, NULL, NULL};
    drawing.state = &pipeline;
    CHECK(pipeline_create(&pipeline, BOARD_SIZE, BOARD_SIZE, &error) &&
          draw_cells(&drawing, &image, &cell, 1, 1, 1, &error));
    pipeline_free(&pipeline);
    return image;
}

static void test_shaders(void) {
    static const struct shader *const shaders[] = {&mapped,       &full,     &weight_mapped,
                                                   &power_mapped, &textured, &plain};
    static const int turns[][3] = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {1, 2, 3}};
    struct texture diffuse = noise(1), map = noise(2), specular = noise(3);
    for (size_t i = 0; i < 6 * 4; i++) {
        struct drawing drawing = {.model = &board, .skip = true};
        drawing.diffuse = &diffuse;
        drawing.normal_map = &map;
        drawing.specular = &specular;
        drawing.eye = (struct vec3){0.5, 0.25, 2};
        drawing.up = (struct vec3){0, 1, 0};
        drawing.light = (struct vec3){1, 0.5, 0.75};
        map.tangent_space = false;
        lay_board((const int[3]){0, 0, 0});
        struct image expected = draw(drawing, shaders[i / 4]);
        map.tangent_space = true;
        turn_board(&drawing, turns[i % 4]);
        struct image image = draw(drawing, shaders[i / 4]);
        CHECK(nearly_same(&image, &expected));
        image_free(&image);
        image_free(&expected);
    }
    texture_free(&diffuse);
    texture_free(&map);
    texture_free(&specular);
}

UNIT_MAIN(TEST(test_shaders))
