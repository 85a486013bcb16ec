/*
 * tests/numbers.h for the lessons whose functions work on several pixels at once (common/lanes.h):
 * each lane in turn gets the numbers, and the others get different ones.
 */
#ifndef TESTS_LANE_NUMBERS_H
#define TESTS_LANE_NUMBERS_H

/* No loops of their own for the shaders, which draw nothing here: those take long to compile. */
#include "pipeline_program.h"
#undef SHADER
#define SHADER(name, ...) static const struct shader name = {__VA_ARGS__}
#undef REAL /* which lanes.h needs no more; numbers.h has a macro of that name */

#include "numbers.h"

static inline lanes in_one_lane(int lane, double value, double others) {
    lanes all = lanes_all((real)others);
    all[lane] = (real)value;
    return all;
}

/* The vector in one lane, and other vectors in the other lanes. */
static inline struct lanes3 vector_in_one_lane(int lane, struct vec3 v) {
    return (struct lanes3){in_one_lane(lane, v.x, 0.25), in_one_lane(lane, v.y, 0.5),
                           in_one_lane(lane, v.z, 0.75)};
}

static inline struct shown show_lane(lanes values, int lane) {
    return show("%.4g", (double)values[lane] + 0); /* -0 + 0 is 0 */
}

static inline struct shown show_vector_lane(struct lanes3 v, int lane) {
    const double values[3] = {(double)v.x[lane] + 0, (double)v.y[lane] + 0, (double)v.z[lane] + 0};
    return show_reals(values, 3);
}

static inline struct color texel_lane(lanes_texel texels, int lane) {
    return color_from_texel(lanes_texel_at(texels, lane));
}

/* What a function gives for these numbers in that lane. */
typedef struct shown lane_function(int lane, const double *numbers);

/* That of the first lane, or of the first that gives something else. */
static inline struct shown in_each_lane(lane_function *function, const double *numbers) {
    const struct shown first = function(0, numbers);
    for (int lane = 1; lane < LANES; lane++) {
        const struct shown shown = function(lane, numbers);
        if (!same_text(first.text, shown.text)) {
            return show("%.80s, in lane %d %.80s", first.text, lane, shown.text);
        }
    }
    return first;
}

#define IN_LANES(function, ...) in_each_lane(function, (double[]){__VA_ARGS__})

/* A texture of one row. */
static inline bool called_make_texture(struct texture *texture, const struct color *row,
                                       size_t width) {
    struct image image;
    struct error error;
    if (!image_create(&image, width, 1, IMAGE_BGR, &error)) {
        return false;
    }
    for (size_t i = 0; i < width; i++) {
        image_set(&image, (int)i, 0, row[i]);
    }
    bool done = texture_create(texture, &image, &error);
    image_free(&image);
    return done;
}

/* A texture of so many mip levels, at most 4, with a colour for each. */
static inline bool called_make_levels(struct texture *texture, const struct color *colors,
                                      size_t count) {
    const struct color black[8] = {{0}};
    if (!called_make_texture(texture, black, (size_t)1 << (count - 1))) {
        return false;
    }
    for (size_t i = 0; i < count; i++) {
        const struct texture_level *level = &texture->level[i];
        for (size_t k = 0; k < 2 * level->pitch; k++) {
            level->texels[k] =
                255u << 24 | (uint32_t)colors[i].r << 16 | (uint32_t)colors[i].g << 8 | colors[i].b;
        }
    }
    return true;
}

#endif
