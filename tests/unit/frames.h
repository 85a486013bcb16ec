/*
 * For tests of the pipeline: small models made in memory, and a pipeline with the image that it
 * draws. (draw_frame() and pictures of varyings: shown.h.)
 */
#ifndef TESTS_FRAMES_H
#define TESTS_FRAMES_H

#include "oracle/shown.h"
#include "pipeline.h"
#include "unit.h"

static inline void set_corners(struct face *face, uint32_t a, uint32_t b, uint32_t c) {
    *face = (struct face){
        {{a, MODEL_NONE, MODEL_NONE}, {b, MODEL_NONE, MODEL_NONE}, {c, MODEL_NONE, MODEL_NONE}}};
}

/* A model of positions and faces alone. `corners` are the positions of each face; NULL: those of
 * face i are 3 i to 3 i + 2. */
static inline struct model plain_model(struct vec3 *positions, size_t position_count,
                                       struct face *faces, size_t face_count,
                                       const uint32_t (*corners)[3]) {
    for (uint32_t i = 0; i < face_count; i++) {
        if (corners != NULL) {
            set_corners(&faces[i], corners[i][0], corners[i][1], corners[i][2]);
        } else {
            set_corners(&faces[i], 3 * i, 3 * i + 1, 3 * i + 2);
        }
    }
    return (struct model){.positions = positions,
                          .position_count = position_count,
                          .faces = faces,
                          .face_count = face_count};
}

/* A pipeline and an image of its size, black at first. */
struct target {
    struct pipeline pipeline;
    struct image image;
};

static inline bool target_create(struct target *target, size_t width, size_t height,
                                 enum image_format format) {
    struct error error;
    *target = (struct target){.image = {0}};
    return CHECK(image_create(&target->image, width, height, format, &error)) &&
           CHECK(pipeline_create(&target->pipeline, width, height, &error));
}

static inline void target_free(struct target *target) {
    pipeline_free(&target->pipeline);
    image_free(&target->image);
}

#endif
