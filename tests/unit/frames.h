/* For tests of the pipeline: a pipeline with the image that it draws. (Small models: shown.h.) */
#ifndef TESTS_UNIT_FRAMES_H
#define TESTS_UNIT_FRAMES_H

#include "oracle/shown.h"
#include "pipeline.h"
#include "unit.h"

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
