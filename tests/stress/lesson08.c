/* The viewport matrix of step 8. */
#define main step08_main
int step08_main(int argc, char **argv);
#include "../../step08_projection/main.c"
#undef main

#include "lessons.h"

struct mat4 lesson08_viewport(size_t width, size_t height) {
    return viewport(width, height);
}
#include "stress.h"
const struct property lesson08_properties[] = {{.name = NULL}};
