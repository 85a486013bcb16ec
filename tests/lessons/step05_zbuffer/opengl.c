/* Lesson 5 by OpenGL: see picture.h. */
#include "bench/opengl/picture.h"

#define LESSON "../step05_zbuffer/main.c"
#include "lesson.h"

static bool build(struct picture *picture) {
    return picture_add_lit_faces(picture, (struct gl_part){.formula = "vec3(255.0 * first.x)"});
}

static const struct compared_scene table[] = {
    {"zbuffer", .build = build},
    {"depth", .build = build, .fills = true, .shows_depth = true},
    {"knot", .build = build},
    {"side", .build = build},
    {"deep", .left_out = "the depths of each half, and four more"},
    {.left_out = "rows, pixels and depths that are not of a model"},
};

const struct lesson lesson_step05 = {&step05_zbuffer, table};
