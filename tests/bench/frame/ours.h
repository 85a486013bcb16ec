/* The course's side of `make bench-frame`: the pipeline of lessons 9 and 10. */
#ifndef TESTS_BENCH_FRAME_OURS_H
#define TESTS_BENCH_FRAME_OURS_H

#include "scene.h"

/* All zero is valid, and draws nothing yet. */
struct ours {
    struct pipeline pipeline;
    struct image image; /* BGRA; alpha 0 where nothing was drawn */
    struct frame_scene scene;
};

/* Make ready to draw a scene, which must stay, with that many threads. */
bool ours_load(struct ours *ours, const struct frame_scene *scene, size_t threads,
               struct error *error);

/* A frame: clear, draw; all of it is in `image` on return. */
bool ours_draw(struct ours *ours, struct error *error);

void ours_free(struct ours *ours);

#endif
