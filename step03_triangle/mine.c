/* For `make LINE=mine`: the triangles of this lesson's main.c draw in lessons 4 to 8. */
#define main step03_main
int step03_main(int argc, char **argv);
#include "main.c"
#undef main

#include "run/mine.h"

bool my_triangle_setup(struct edges *edges, struct fixed2 a, struct fixed2 b, struct fixed2 c,
                       size_t width, size_t height) {
    return triangle_setup(edges, a, b, c, width, height);
}

struct span my_triangle_span(const struct edges *edges, int y) {
    return triangle_span(edges, y);
}
