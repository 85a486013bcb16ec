/*
 * For tests of maps in tangent space: a board that looks along z, with u along x and v along y.
 * There both spaces are one. It can be turned, with the camera and the light of a drawing.
 */
#ifndef TESTS_BOARD_H
#define TESTS_BOARD_H

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
    struct image image = new_image(16, 16, IMAGE_BGR);
    struct texture texture;
    struct error error;
    for (size_t i = 0; i < (size_t)16 * 16 * 3; i++) {
        image.pixels[i] = (uint8_t)next_random(&seed);
    }
    CHECK(texture_create(&texture, &image, &error));
    image_free(&image);
    return texture;
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

#endif
