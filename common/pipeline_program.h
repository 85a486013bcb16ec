/*
 * What every scene that draws with the pipeline does around pipeline_draw().
 *
 * program.h and pipeline.h know nothing of each other; this header knows both, so that the lessons
 * before step 9 carry no pipeline with them, and a pipeline needs no program. Such a program says
 *
 *     .state_size = sizeof(struct pipeline),
 *     .prepare = pipeline_prepare,
 *     .finish = pipeline_finish,
 *
 * and each draw function begins with pipeline_begin() and ends with pipeline_count().
 */
#ifndef COMMON_PIPELINE_PROGRAM_H
#define COMMON_PIPELINE_PROGRAM_H

#include "pipeline.h"
#include "program.h"

/* The drawing's state is its pipeline, kept from frame to frame. */
static inline bool pipeline_prepare(struct drawing *drawing, size_t width, size_t height,
                                    struct error *error) {
    return pipeline_create(drawing->state, width, height, error);
}

static inline void pipeline_finish(struct drawing *drawing) {
    pipeline_free(drawing->state);
}

/* The drawing's pipeline, cleared for a frame. */
static inline struct pipeline *pipeline_begin(struct drawing *drawing) {
    struct pipeline *pipeline = drawing->state;
    pipeline->skip = drawing->skip;
    pipeline_clear(pipeline);
    return pipeline;
}

/* Count what was done and skipped since pipeline_begin(), for --stats. */
static inline void pipeline_count(struct drawing *drawing) {
    const struct pipeline *pipeline = drawing->state;
    for (int i = 0; i < PIPELINE_STATS; i++) {
        drawing_count(drawing, pipeline_stat_name[i], pipeline->stats[i]);
    }
}

/* The drawing's model, seen by its camera: see camera_call(). */
static inline struct draw_call pipeline_call(const struct drawing *drawing,
                                             struct rectangle viewport, double zoom,
                                             enum cull cull) {
    return camera_call(drawing->model, drawing->eye, drawing->center, drawing->up, zoom, viewport,
                       cull);
}

#endif
