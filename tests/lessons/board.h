/*
 * For tests of maps in tangent space: on a board that looks along z, with u along x and v along y,
 * both spaces are one: the shaders for maps in tangent space draw what those of the lesson draw. On
 * a board that was turned they draw what it was before, in a light that was turned with it.
 */
#ifndef TESTS_LESSONS_BOARD_H
#define TESTS_LESSONS_BOARD_H

#include "files/fit.h"
#include "run/scene.h"
#include "unit/images.h"

enum { BOARD_SIZE = 48 };

static struct vec3 places[4];
static float normals[1][3], uvs[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
static struct face faces[2] = {{{{0, 0, 0}, {1, 1, 0}, {2, 2, 0}}},
                               {{{0, 0, 0}, {2, 2, 0}, {3, 3, 0}}}};
static struct model board = {.positions = places,
                             .position_count = 4,
                             .uvs = uvs,
                             .uv_count = 4,
                             .normals = normals,
                             .normal_count = 1,
                             .faces = faces,
                             .face_count = 2};

static inline void lay_board(const int turns[3]) {
    const struct vec3 corners[4] = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    memcpy(places, corners, sizeof places);
    normals[0][0] = normals[0][1] = 0;
    normals[0][2] = 1;
    model_turn(&board, turns);
}

/* A texture of noise. */
static inline struct texture noise(uint32_t seed) {
    struct texture texture;
    random_texture(&texture, 16, 16, IMAGE_BGR, &seed);
    return texture;
}

/* Noise to draw the board with. */
static struct texture diffuse, map, specular;

static inline void make_textures(void) {
    diffuse = noise(1);
    map = noise(2);
    specular = noise(3);
}

static inline void free_textures(void) {
    texture_free(&diffuse);
    texture_free(&map);
    texture_free(&specular);
}

/* The board as it looks along z, with these textures. */
static inline struct drawing board_drawing(void) {
    lay_board((const int[3]){0, 0, 0});
    return (struct drawing){.model = &board,
                            .diffuse = &diffuse,
                            .normal_map = &map,
                            .specular = &specular,
                            .eye = {0.5, 0.25, 2},
                            .up = {0, 1, 0},
                            .light = {1, 0.5, 0.75},
                            .skip = true};
}

/* Turn the board, and the drawing as it was before. */
static inline void turn_board(struct drawing *drawing, const int turns[3]) {
    lay_board(turns);
    drawing->eye = vec3_quarter_turned(drawing->eye, turns);
    drawing->up = vec3_quarter_turned(drawing->up, turns);
    drawing->light = vec3_quarter_turned(drawing->light, turns);
}

/* Is it the same picture, except for rounding, and one that shows something? */
static inline bool nearly_same(const struct image *a, const struct image *b) {
    size_t wrong = 0, seen = 0;
    for (size_t i = 0; i < (size_t)BOARD_SIZE * BOARD_SIZE * 3; i++) {
        wrong += abs(a->pixels[i] - b->pixels[i]) > 1;
        seen += b->pixels[i] > 20;
    }
    return wrong == 0 && seen > 500;
}

/* The picture of a lesson in one of several ways. */
typedef struct image draw_board(struct drawing drawing, size_t way);

/* Does it draw the same in both spaces, in each way and however the board is turned? */
static inline void check_board(draw_board *draw, size_t ways) {
    static const int turns[][3] = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {1, 2, 3}};
    make_textures();
    for (size_t i = 0; i < ways * 4; i++) {
        struct drawing drawing = board_drawing();
        map.tangent_space = false;
        struct image expected = draw(drawing, i / 4);
        map.tangent_space = true;
        turn_board(&drawing, turns[i % 4]);
        struct image image = draw(drawing, i / 4);
        CHECK(nearly_same(&image, &expected));
        image_free(&image);
        image_free(&expected);
    }
    free_textures();
}

#endif
