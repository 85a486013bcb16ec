/*
 * The other side of `make bench-frame`: Mesa's llvmpipe, the renderer without graphics hardware
 * that most Linux machines have. From llvmpipe.c where Mesa is installed, otherwise from
 * without_llvmpipe.c.
 */
#ifndef TESTS_BENCH_FRAME_LLVMPIPE_H
#define TESTS_BENCH_FRAME_LLVMPIPE_H

#include "scene.h"

#include <stdint.h>

struct llvmpipe;

struct llvmpipe_functions {
    /* So many threads draw; only the first call of a process decides. NULL, with a message, where
     * it cannot draw. */
    struct llvmpipe *(*open)(int threads, struct error *error);
    void (*close)(struct llvmpipe *llvmpipe);
    const char *(*name)(const struct llvmpipe *llvmpipe); /* "llvmpipe (...), version" */
    /* Make ready to draw a scene: mesh, textures and buffers are handed over here. */
    bool (*load)(struct llvmpipe *llvmpipe, const struct frame_scene *scene, struct error *error);
    /* A frame: clear, draw, finish. */
    void (*draw)(struct llvmpipe *llvmpipe);
    /* What was drawn: BGRA, row by row from the bottom, alpha 0 where nothing was. */
    bool (*read)(struct llvmpipe *llvmpipe, uint8_t *pixels, struct error *error);
};

extern const struct llvmpipe_functions *const llvmpipe; /* NULL without Mesa */

#endif
