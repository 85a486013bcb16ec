/*
 * What every scene that draws with the pipeline does around pipeline_draw().
 *
 * program.h and pipeline.h know nothing of each other; this header knows both, so that the lessons
 * before lesson 9 carry no pipeline with them, and a pipeline needs no program. Such a program
 * has PIPELINE_PROGRAM among its fields; each of its draw functions begins with pipeline_begin()
 * and ends with pipeline_end().
 */
#ifndef COMMON_PIPELINE_PROGRAM_H
#define COMMON_PIPELINE_PROGRAM_H

#include "pipeline.h"
#include "program.h"

/* The drawing's state is its pipeline, kept from frame to frame. */
static inline bool pipeline_begin_drawing(struct drawing *drawing, size_t width, size_t height,
                                          struct error *error) {
    return pipeline_create(drawing->state, width, height, error);
}

static inline void pipeline_end_drawing(struct drawing *drawing) {
    pipeline_free(drawing->state);
}

#define PIPELINE_PROGRAM                                                                           \
    .takes_light = true, .takes_camera = true, .skips = true,                                      \
    .state_size = sizeof(struct pipeline), .prepare = pipeline_begin_drawing,                      \
    .finish = pipeline_end_drawing

/* The drawing's pipeline, cleared for a frame. */
static inline struct pipeline *pipeline_begin(struct drawing *drawing) {
    struct pipeline *pipeline = drawing->state;
    pipeline->skip = drawing->skip;
    pipeline->counts_tests = drawing->stats;
    pipeline_clear(pipeline);
    return pipeline;
}

/* Finish the frame, if all of it was `recorded`, and count what was done and skipped since
 * pipeline_begin(), for --stats. */
static inline bool pipeline_end(struct drawing *drawing, bool recorded, struct image *image,
                                struct error *error) {
    struct pipeline *pipeline = drawing->state;
    bool done = recorded && pipeline_finish(pipeline, image, error);
    for (int i = 0; i < PIPELINE_STATS; i++) {
        drawing_count(drawing, pipeline_stat_name[i], pipeline->stats[i]);
    }
    return done;
}

/* The drawing's model, seen by its camera: see camera_call(). */
static inline struct draw_call pipeline_call(const struct drawing *drawing,
                                             struct rectangle viewport, double zoom,
                                             enum cull cull) {
    return camera_call(drawing->model, drawing->eye, drawing->center, drawing->up, zoom, viewport,
                       cull);
}

#endif
