/* The samplers of step 6. */
#define main step06_main
int step06_main(int argc, char **argv);
#include "../../step06_texture/main.c"
#undef main

#include "lessons.h"

struct color lesson06_nearest(const struct texture *texture, struct vec2 uv) {
    return sample_nearest(texture, uv);
}

struct vec4 lesson06_bilinear(const struct texture *texture, struct vec2 uv, size_t level) {
    return sample_bilinear(texture, uv, level);
}

struct vec4 lesson06_trilinear(const struct texture *texture, struct vec2 uv, double level) {
    return sample_trilinear(texture, uv, level);
}
