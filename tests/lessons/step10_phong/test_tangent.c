/* Maps in tangent space: see board.h; and materials whose ambient light has colours of its own. */
#define LESSON "../step10_phong/main.c"
#include "lesson.h"

#include "lessons/board.h"

static const struct shader *const shaders[] = {&mapped,       &full,     &weight_mapped,
                                               &power_mapped, &textured, &plain};

static struct image draw_of(struct drawing drawing, size_t way, struct material material) {
    struct image image = new_image(BOARD_SIZE, BOARD_SIZE, IMAGE_BGR);
    struct pipeline pipeline = {0};
    struct error error;
    const struct cell cell = {shaders[way], material, NULL, NULL};
    drawing.state = &pipeline;
    CHECK(pipeline_create(&pipeline, BOARD_SIZE, BOARD_SIZE, &error) &&
          draw_cells(&drawing, &image, &cell, 1, 1, 1, &error));
    pipeline_free(&pipeline);
    return image;
}

/* The picture of a shader of the lesson, or of the one that replaces it. */
static struct image draw(struct drawing drawing, size_t way) {
    return draw_of(drawing, way, textured_material);
}

/* In ambient light alone what has colours of its own there looks as if it had them in every light;
 * with the same colours nothing changes. What has the lesson's colour keeps it. */
static void test_ambient(void) {
    const struct material alone = {1, 0, 0, 10, {200, 100, 250}},
                          all = {0.5, 0.5, 0.25, 10, {0, 0, 0}};
    struct texture other = noise(4);
    make_textures();
    for (size_t i = 0; i < 4 * (sizeof shaders / sizeof shaders[0]); i++) {
        size_t way = i / 4;
        bool own = shaders[way] != &plain && shaders[way] != &mapped, is_alone = i % 2 == 0;
        struct drawing drawing = board_drawing();
        const struct material material = is_alone || !own ? alone : all;
        drawing.diffuse = is_alone && own ? &other : &diffuse;
        map.tangent_space = i % 4 > 1;
        struct image expected = draw_of(drawing, way, material);
        drawing.diffuse = &diffuse;
        drawing.ambient = is_alone ? &other : &diffuse;
        struct image image = draw_of(drawing, way, material);
        CHECK(nearly_same(&image, &expected));
        image_free(&image);
        image_free(&expected);
    }
    free_textures();
    texture_free(&other);
}

static void test_shaders(void) {
    check_board(draw, sizeof shaders / sizeof shaders[0]);
}

UNIT_MAIN(TEST(test_shaders), TEST(test_ambient))
